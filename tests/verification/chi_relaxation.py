"""T3, relaxation of chi: at rest (chi* = 1), in dilation and in compaction; the orders in time; pure shear."""
import numpy as np
from scree_program import EXACT, Checks, Program

TAU, T, D, SIN_PHI, CHI0, END = 1e-2, 1e-4, 1e-3, np.sin(np.radians(28.5)), 0.8, 0.02
SCHEMES = {"beuler": (1, 3e-3), "bdf": (2, 6e-5), "arkimex": (2, 3e-6)}


def chi_star(E):
    n = np.sqrt(3) / (2 * SIN_PHI) if E >= 0 else 1.03
    return (1 - E * D / (n * np.sqrt(2 * T) * SIN_PHI)) ** (n - 1)


program, checks = Program(), Checks("relaxation of chi from 0.8, tau 10 ms, T 1 cm2/s2, d 0.1 cm", "T3")
for E in (0.0, 8.0, -30.0):  # 1/s
    gradient = f"{E / 3}, 0, 0, 0, {E / 3}, 0, 0, 0, {E / 3}"
    exact = chi_star(E) + (CHI0 - chi_star(E)) * np.exp(-END / TAU)
    for scheme, (order, bound) in SCHEMES.items():
        errors = []
        for steps in (10, 20, 40):
            options = {**EXACT, "time_scheme": scheme, "time_step_initial": END / steps,
                       "initial_everywhere_velocity_gradient": gradient}
            chi = program.run("chi_relaxation.yaml", f"E{E}_{scheme}_{steps}", options).fields["frictional_pressure_ratio"]
            errors.append(np.abs(chi - exact).max())
        checks.order(f"div v {E} 1/s (chi* {chi_star(E):.6f}), {scheme}: error of chi after 10, 20, 40 steps", errors,
                     order, bound)
    options = {**EXACT, "time_step_initial": 0.1, "end_time": 3, "initial_everywhere_velocity_gradient": gradient}
    chi = program.run("chi_relaxation.yaml", f"E{E}_steady", options).fields["frictional_pressure_ratio"]
    checks.close(f"div v {E} 1/s: chi after 300 tau", float(chi.mean()), chi_star(E), relative=1e-9)

# Steps of 5 tau towards a chi* near zero: exact stages of order 2 would lie below zero.
E = 12.0
gradient = f"{E / 3}, 0, 0, 0, {E / 3}, 0, 0, 0, {E / 3}"
for scheme in ("bdf", "arkimex"):
    run = program.run("chi_relaxation.yaml", f"long_steps_{scheme}",
                      {**EXACT, "time_scheme": scheme, "time_step_initial": 5 * TAU, "end_time": 50 * TAU,
                       "initial_everywhere_velocity_gradient": gradient})
    chi = run.fields["frictional_pressure_ratio"]
    checks.below(f"{scheme}, steps of 5 tau: steps lost to the solver", run.summary["rejected_solver"], 0.5)
    checks.above(f"{scheme}, steps of 5 tau: least chi", chi.min(), 0)
    checks.close(f"{scheme}, steps of 5 tau: chi at the end over chi*", float(chi.mean()) / chi_star(E), 1, absolute=0.05)
checks.verdict()
