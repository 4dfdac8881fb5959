"""T15, compaction shock: solids fraction behind it and its speed. The step counts, not the grid: the balance of momentum
is advective in time (nu dv/dt at the new nu), so that a shock loses momentum in proportion to the share of a cell that it
passes in a step. The errors here are of first order in that Courant number."""
import numpy as np
from scree_program import COLUMN, EXACT, Checks, Program, centres

CASES = [(1.0, 0.5, .612006, 4.4640), (1.0, 0.3, .600686, .9977), (5.0, 0.5, .628447, 19.463)]  # V, nu1, nu2, U_s [m/s]
LENGTH, CELLS = 0.12, 60


def front(fields, middle):
    """Where nu falls through `middle`."""
    x, nu = centres(fields["x_faces"]), fields["solids_fraction"]
    last = np.flatnonzero(nu > middle)[-1]
    return x[last] + (nu[last] - middle) / (nu[last] - nu[last + 1]) * (x[last + 1] - x[last])


def shock(program, V, nu1, nu2, U, cells, courant):
    """{nu behind the shock, its speed, greatest nu ever, mass error}"""
    end = 0.08 / U
    options = {**EXACT, **COLUMN, "snes_atol": 1e-9, "grid_cells": cells, "time_step_initial": courant * LENGTH / cells / U,
               "end_time": end, "output_interval": end / 4, "boundary_inlet_velocity": -V,
               "boundary_inlet_solids_fraction": nu1, "initial_everywhere_solids_fraction": nu1,
               "initial_everywhere_velocity": -V}
    run = program.run("compaction_shock.yaml", f"V{V}_nu{nu1}_{cells}_{courant}", options)
    states = run.all_fields()[1:]
    places = [front(state, 0.5 * (nu1 + nu2)) for state in states]
    x = centres(states[-1]["x_faces"])
    behind = (x > 0.02) & (x < places[-1] - 0.02)
    speed = np.polyfit([state["time"] for state in states[1:]], places[1:], 1)[0]
    monitor = run.monitor
    return (states[-1]["solids_fraction"][behind].mean(), speed, monitor["solids_fraction_max"].max(),
            np.abs(monitor["mass_error"]).max())


program, checks = Program(), Checks("compaction shock against a wall", "T15")
for V, nu1, nu2, U in CASES:
    name = f"V {100 * V:g} cm/s, nu1 {nu1}"
    p_c = 0.5 * (nu2 - 0.5) ** 2 / (0.65 - nu2) ** 5
    checks.close(f"{name}: reference p_c(nu2) [dyn/cm2]", p_c, 2.9 * nu1 * (100 * V) ** 2 * nu2 / (nu2 - nu1), relative=2e-4)
    errors = []
    for courant in (0.5, 0.25):
        found, speed, greatest, mass_error = shock(program, V, nu1, nu2, U, CELLS, courant)
        errors.append(found - nu2)
        checks.below(f"{name}, Courant {courant}: greatest nu ever, below nu_max = 0.65", greatest, 0.645)
        checks.below(f"{name}, Courant {courant}: mass error", mass_error, 1e-12)
    checks.order(f"{name}: excess of nu2 at Courant 0.5, 0.25", errors, 1, 6e-4, slack=0.3)
    checks.close(f"{name}: nu2 extrapolated to Courant 0", found - (errors[0] - errors[1]), nu2, absolute=1e-4)
    checks.close(f"{name}: U_s [m/s]", speed, U, relative=2e-3)
    finer = shock(program, V, nu1, nu2, U, 2 * CELLS, 0.25)
    checks.close(f"{name}: nu2 on the doubled grid at the same Courant number", finer[0], found, absolute=5e-5)
checks.verdict()
