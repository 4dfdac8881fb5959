"""H7: shear starts at nu = .64. With the velocity linear from the start sqrt(T) grows as a hyperbolic tangent to T2,
without overshoot. With the particles at rest and the walls moving, shear spreads from the walls: T stays positive, and the
end is the same."""
import numpy as np
from scree_program import EXACT, Checks, Program

NU, NU_MAX, D, E_P, ALPHA, GDOT, T_START = 0.64, 0.65, 1e-3, 0.91, 1.6, 10.0, 1e-6


def factors(nu):
    """fmu of mu_s = fmu rho_s d sqrt(T), (1.1); fJ of J_coll = fJ rho_s T^1.5/d, (1.4)."""
    eta, g0 = (1 + E_P) / 2, 1 / (1 - (nu / NU_MAX) ** (1 / 3))
    mu = 5 * np.sqrt(np.pi) / 96
    mu_b = 256 * mu * nu**2 * g0 / (5 * np.pi)
    braces = 2 * mu / (g0 * eta * (2 - eta)) * (1 + 8 / 5 * eta * nu * g0) * (1 + 8 / 5 * eta * (3 * eta - 2) * nu * g0)
    return ((2 + ALPHA) / 3 * (braces + 6 / 5 * eta * mu_b) / 2,
            48 / np.sqrt(np.pi) * eta * (1 - eta) * nu**2 * g0)


program, checks = Program(), Checks("shear starts at nu = 0.64", "H7")
fmu, fJ = factors(0.6)
checks.close("reference fmu at .6, tests/VERIFICATION.md section 1", fmu, 17.4033844, relative=1e-8)
checks.close("reference fJ at .6", fJ, 15.9134731, relative=1e-8)
fmu, fJ = factors(NU)
T2 = fmu / fJ * (D * GDOT) ** 2
TIME = 3 * NU / (np.sqrt(fmu * fJ) * GDOT)  # 3 nu ds/dt = fmu d gdot^2 - fJ s^2/d for s = sqrt(T) [s]
FIXED = {**EXACT, "time_step_adaptive": "no", "end_time": 10 * TIME}


def exact(t):
    start = np.arctanh(np.sqrt(T_START / T2))
    return T2 * np.tanh(t / TIME + start) ** 2


# From T2/100, where these steps resolve the growth.
errors = []
for share in (20, 40, 80):
    run = program.run("shear_start.yaml", f"uniform_{share}", {**FIXED, "time_step_initial": TIME / share})
    monitor = run.monitor
    T, t = monitor["granular_temperature_max"], monitor["time"]
    name = f"dt {TIME / share:.1e} s"
    errors.append(np.abs(T - exact(t)).max() / T2)
    checks.above(f"{name}: least T ever [m2/s2]", monitor["granular_temperature_min"].min(), T_START * (1 - 1e-9))
    checks.below(f"{name}: overshoot of T, relative", T.max() / T2 - 1, 1e-6)
    checks.below(f"{name}: greatest fall of T in a step, relative", -np.diff(T).min() / T2, 1e-6)
    checks.close(f"{name}: T at the end [m2/s2]", T[-1], T2, relative=1e-6)
    checks.below(f"{name}: spread of T across, relative", np.ptp(run.fields["granular_temperature"]) / T2, 1e-6)
checks.order("T(t) against the hyperbolic tangent, greatest error over T2", errors, 1, 1e-2)

# From next to nothing the growth, T' ~ sqrt(T), starts within 1e-7 s; a step beyond it has two roots, of which T = 0 is the
# wrong one: there nothing is produced, although particles are sheared.
for start in (1e-8, 1e-11, 1e-14):
    name = f"T from {start:g} m2/s2, adaptive"
    run = program.run("shear_start.yaml", f"adaptive_{start:g}",
                      {"solver": "direct", "initial_everywhere_granular_temperature": start})
    monitor, T = run.monitor, run.fields["granular_temperature"].mean()
    least, overshoot = monitor["granular_temperature_min"].min(), monitor["granular_temperature_max"].max() / T2 - 1
    checks.above(f"{name}: least T ever [m2/s2]", least, start * (1 - 1e-9))
    checks.below(f"{name}: overshoot of T, relative", overshoot, 1e-2)
    checks.close(f"{name}: T at the end [m2/s2]", T, T2, relative=1e-4)
    checks.hard_case("H7", f"shear start-up at nu 0.64 from T {start:g} m2/s2", run,
                     measured=f"T at the end {T / T2:.6f} T2, overshoot {max(overshoot, 0):.1e}, least T ever {least:.1e} m2/s2",
                     bound="T > 0, T2, overshoot < 1 %")

rest = {"initial_everywhere_granular_temperature": 1e-8, "initial_everywhere_velocity": "0, 0",
        "initial_everywhere_velocity_gradient": "0, 0, 0, 0", "end_time": 2}
walls = program.run("shear_start.yaml", "from_rest", {**EXACT, **rest})
monitor, last = walls.monitor, walls.fields
checks.above("from rest: least T ever [m2/s2]", monitor["granular_temperature_min"].min(), 0)
checks.below("from rest: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), NU_MAX - 1e-6)
checks.close("from rest: T at the end [m2/s2]", last["granular_temperature"].mean(), T2, relative=1e-3)
y = 0.5 * (last["y_faces"][1:] + last["y_faces"][:-1])
checks.below("from rest: velocity against the linear profile, over U",
             np.abs(last["velocity_x_face"] - (GDOT * y - 0.1)[:, None]).max() / 0.1, 1e-3)
checks.below("from rest: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.hard_case("H7", "the same from rest, by the walls", walls,
                 measured=f"T to T2 (1 {last['granular_temperature'].mean() / T2 - 1:+.1e}), least T ever "
                          f"{monitor['granular_temperature_min'].min():.1e} m2/s2",
                 bound="T > 0, T2")
checks.verdict()
