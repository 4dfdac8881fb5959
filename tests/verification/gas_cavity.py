"""T18: gas alone in a square cavity whose lid moves, Re 100, 400 and 1000, against Ghia, Ghia and Shin (1982) and
Botella and Peyret (1998)."""
import numpy as np
from gas_relations import check_balances
from scree_program import Checks, Program, centres

# u on the vertical centreline by y (Ghia)
PLACES = (.0547, .0625, .0703, .1016, .1719, .2813, .4531, .5, .6172, .7344, .8516, .9531)
GHIA = {100: (-.03717, -.04192, -.04775, -.06434, -.10150, -.15662, -.21090, -.20581, -.13641, .00332, .23151, .68717),
        400: (-.08186, -.09266, -.10338, -.14612, -.24299, -.32726, -.17119, -.11477, .02135, .16256, .29093, .55892),
        1000: (-.18109, -.20196, -.22220, -.29730, -.38289, -.27805, -.10648, -.06080, .05702, .18719, .33304, .46604)}
# least u, greatest and least v on the centrelines: Botella and Peyret, at Re 400 Ghia
EXTREMA = {100: (-.2140424, .1795728, -.2538030), 400: (-.32726, .30203, -.44993),
           1000: (-.3885698, .3769447, -.5270771)}
# Re: cells of the grids, largest over smallest cell, end [s], bounds of the errors on the finest: to EXTREMA, to Ghia
CAVITIES = {100: ((24, 48), 1, 40, 3e-3, 5e-3), 400: ((24, 48), 4, 60, 1e-2, 1e-2),
            1000: ((24, 48), 4, 120, 3e-2, 3e-2)}


def interpolation(x, y):
    """Cubic through the four nearest points (Lagrange), as a function."""

    def value(at):
        first = np.clip(np.searchsorted(x, at) - 2, 0, len(x) - 4)
        result = np.zeros(np.shape(at))
        for i in range(4):
            weight = np.ones(np.shape(at))
            for j in range(4):
                if i != j:
                    weight = weight * (at - x[first + j]) / (x[first + i] - x[first + j])
            result = result + weight * y[first + i]
        return result

    return value


def graded(cells, ratio):
    """Options of a grid whose cells shrink towards the walls."""
    if ratio == 1:
        return {"grid_cells": f"{cells}, {cells}"}
    blocks = {"edges": "0, 0.5, 1", "cells": f"{cells // 2}, {cells // 2}", "ratio": f"{ratio}, {1 / ratio}"}
    return {f"grid_{axis}_{key}": value for axis in "xy" for key, value in blocks.items()}


program, checks = Program(), Checks("gas alone in a cavity with a moving lid", "T18")
for Re, (grids, ratio, end, bound, ghia_bound) in CAVITIES.items():
    errors = []
    for cells in grids:
        name = f"Re {Re}, {cells} x {cells} cells"
        options = {**graded(cells, ratio), "gas_viscosity": 1 / Re, "end_time": end}
        if Re > 100:  # towards the steady state only
            options.update({"time_step_max": 10, "accuracy": 0.3})
        run = program.run("gas_cavity.yaml", f"Re_{Re}_{cells}", options)
        y = np.concatenate([[0], centres(run.fields["y_faces"]), [1]])
        u = interpolation(y, np.concatenate([[0], run.fields["gas_velocity_x_face"][:, cells // 2], [1]]))
        v = interpolation(y, np.concatenate([[0], run.fields["gas_velocity_y_face"][cells // 2], [0]]))
        fine = np.linspace(0, 1, 10001)
        extrema = u(fine).min(), v(fine).max(), v(fine).min()
        errors.append([abs(found - exact) for found, exact in zip(extrema, EXTREMA[Re])])
        check_balances(checks, name, run)
    for what, found in zip(("least u", "greatest v", "least v"), zip(*errors)):
        checks.below(f"Re {Re}, {what}: error on {grids[-1]} x {grids[-1]} cells", found[-1], bound)
        checks.below(f"Re {Re}, {what}: error on {grids[-1]} over that on {grids[-2]} cells, second order",
                     found[-1] / found[-2], 0.28)
    checks.below(f"Re {Re}, {grids[-1]} x {grids[-1]} cells: greatest difference of u to Ghia",
                 np.abs(u(np.array(PLACES)) - GHIA[Re]).max(), ghia_bound)
checks.verdict()
