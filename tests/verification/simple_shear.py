"""T2, steady simple shear: granular temperature without and with friction; velocity linear, solids fraction uniform."""
import numpy as np
from closures import critical_pressure
from scree_program import EXACT, Checks, Program

GDOT, D = 10.0, 1e-3
# nu: T/(d gdot)^2, see tests/support/closures.py
RATIO = {0.1: 4.39810, 0.3: 1.34206, 0.49: 1.13459, 0.55: 1.10921, 0.6: 1.09363}

program, checks = Program(), Checks("steady simple shear at 10 1/s, d 0.1 cm", "T2")
for nu, ratio in RATIO.items():
    # with friction chi starts at 1: elsewhere (14) jumps where div v changes its sign, and here it is zero but for rounding
    options = {**EXACT, "initial_everywhere_solids_fraction": nu,
               "initial_everywhere_frictional_pressure_ratio": 0.9 if nu < 0.5 else 1}
    run = program.run("simple_shear.yaml", f"nu_{nu}", options)
    last = run.fields
    expected = ratio * (D * GDOT) ** 2
    T = last["granular_temperature"]
    checks.close(f"nu {nu}: mean T [m2/s2]", T.mean(), expected, relative=1e-5)
    checks.below(f"nu {nu}: spread of T, relative", np.ptp(T) / expected, 1e-8)
    checks.below(f"nu {nu}: spread of nu", np.ptp(last["solids_fraction"]), 1e-8)
    y = 0.5 * (last["y_faces"][1:] + last["y_faces"][:-1])
    deviation = last["velocity_x_face"] - (GDOT * y - 0.1)[:, None]
    checks.below(f"nu {nu}: velocity against the linear profile [m/s]", np.abs(deviation).max(), 1e-8)
    checks.close(f"nu {nu}: chi", last["frictional_pressure_ratio"].mean(), 1.0, absolute=1e-9)
    checks.close(f"nu {nu}: frictional pressure [Pa]", last["frictional_pressure"].mean(), critical_pressure(nu), relative=1e-6)

# Friction between particles and chains of them change the dissipation alone, by (1 - e_eff^2)/(1 - e_p^2) and d/L.
for name, nu, options, factor in (
        ("chialvo_sundaresan", 0.55, {"particle_friction": 0.3}, 1 / 2.74233581),
        ("jenkins_zhang", 0.55, {"particle_friction": 0.3, "effective_restitution": "jenkins_zhang"}, 1 / 2.97638141),
        ("berzi_vescovi", 0.6, {"correlation_length": "berzi_vescovi"}, 1.49129179),
        ("jenkins", 0.6, {"correlation_length": "jenkins", "correlation_length_constant": 1, "particle_friction": 0.3},
         1.71441288 / 2.74233581)):
    run = program.run("simple_shear.yaml", name, {**EXACT, **options, "initial_everywhere_solids_fraction": nu,
                                                  "initial_everywhere_frictional_pressure_ratio": 1})
    checks.close(f"{name}, nu {nu}: mean T [m2/s2]", run.fields["granular_temperature"].mean(),
                 factor * RATIO[nu] * (D * GDOT) ** 2, relative=1e-5)

# T that is no unknown is written too.
nu = 0.3
run = program.run("simple_shear.yaml", "algebraic", {
    **EXACT, "granular_temperature": "algebraic", "initial_everywhere_solids_fraction": nu,
    "initial_everywhere_frictional_pressure_ratio": 0.9, "end_time": 1})
expected, T = RATIO[nu] * (D * GDOT) ** 2, run.fields["granular_temperature"]
checks.close("algebraic: mean T [m2/s2]", T.mean(), expected, relative=1e-5)
checks.below("algebraic: spread of T, relative", np.ptp(T) / expected, 1e-8)
checks.close("algebraic: greatest T in monitor.csv", run.monitor["granular_temperature_max"][-1], T.max(), relative=1e-9)
checks.verdict()
