"""T13: slip w' = -beta w (1/(rho_s nu) + 1/(rho_g (1-nu))): its order in time, momentum, and steps far beyond its time."""
import numpy as np
from gas_relations import RHO_G, RHO_S, check_balances, drag
from scipy.integrate import solve_ivp
from scree_program import EXACT, Checks, Program

D = 4e-4


def rate(nu, w, mu):
    """-w'/w [1/s]."""
    return drag(nu, w, D, mu) * (1 / (RHO_S * nu) + 1 / (RHO_G * (1 - nu)))


def slip(fields):
    return float(np.mean(fields["gas_velocity_x_face"] - fields["velocity_x_face"]))


def momentum(fields, nu):
    return RHO_S * nu * np.mean(fields["velocity_x_face"]) + RHO_G * (1 - nu) * np.mean(fields["gas_velocity_x_face"])


program, checks = Program(), Checks("drag in a periodic box", "T13")

# Order in time; in air Re is up to 30, in a gas a thousand times as viscous the decay is exponential.
for nu, mu, end, bound in ((.01, 1.8e-5, 0.05, {"beuler": 2e-2, "bdf": 2e-3, "arkimex": 2e-4}),
                           (.3, 1.8e-2, 1e-6, {"beuler": 3e-2, "bdf": 1e-3, "arkimex": 1e-4})):
    for scheme, order in (("beuler", 1), ("bdf", 2), ("arkimex", 2)):
        name = f"{scheme}, nu {nu}, viscosity {mu} Pa s"
        errors = []
        for steps in (20, 40, 80):
            options = {**EXACT, "gas_viscosity": mu, "initial_everywhere_solids_fraction": nu, "time_scheme": scheme,
                       "end_time": end, "time_step_initial": end / steps}
            run = program.run("drag_relaxation.yaml", f"{scheme}_{nu}_{steps}", options)
            first, last = run.first_fields, run.fields
            start = slip(first)
            exact = solve_ivp(lambda t, w: -rate(nu, w, mu) * w, (0, end), [start], rtol=1e-11, atol=1e-13).y[0, -1]
            if mu > 1e-2:
                checks.close(f"{name}, {steps} steps: reference against exponential decay", exact,
                             start * np.exp(-rate(nu, 0, mu) * end), relative=5e-2)
            errors.append(abs(slip(last) / exact - 1))
            checks.close(f"{name}, {steps} steps: momentum against its start", momentum(last, nu) / momentum(first, nu), 1,
                         absolute=1e-12)
            check_balances(checks, f"{name}, {steps} steps", run)
        checks.order(f"{name}: relative error of the slip after 20, 40, 80 steps", errors, order, bound[scheme])

# Steps far beyond the response time.
for nu, d in ((.3, 2e-5), (.01, 4e-4)):
    name = f"nu {nu}, d {d} m"
    options = {**EXACT, "initial_everywhere_solids_fraction": nu, "particle_diameter": d,
               "time_step_initial": 1, "end_time": 10, "output_interval": 1}
    run = program.run("drag_relaxation.yaml", f"stiff_{nu}", options)
    slips = [slip(state) for state in run.all_fields()]
    checks.close(f"{name}: slip at the start [m/s]", slips[0], 1, absolute=1e-12)
    checks.below(f"{name}: slip after 10 steps of 1 s over the first", abs(slips[-1]) / slips[0], 1e-9)
    checks.above(f"{name}: least slip over the first: no oscillation", min(slips) / slips[0], -1e-9)
    checks.close(f"{name}: momentum against its start", momentum(run.fields, nu) / momentum(run.first_fields, nu), 1,
                 absolute=1e-12)
    check_balances(checks, name, run)
checks.verdict()
