"""T15, compaction shock: solids fraction behind it and its speed. The balance of momentum keeps momentum whatever share of a
cell the shock passes in a step, so that the Courant number of the shock does not matter."""
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
    for courant, cells in ((0.5, CELLS), (1, CELLS), (5, 2 * CELLS)):
        found, speed, greatest, mass_error = shock(program, V, nu1, nu2, U, cells, courant)
        checks.below(f"{name}, Courant {courant}: greatest nu ever, below nu_max = 0.65", greatest, 0.645)
        checks.below(f"{name}, Courant {courant}: mass error", mass_error, 1e-12)
        checks.close(f"{name}, Courant {courant}: nu2", found, nu2, absolute=5e-5 if courant <= 1 else 2e-4)
        checks.close(f"{name}, Courant {courant}: U_s [m/s]", speed, U, relative=2e-3)
checks.verdict()
