"""T18: gas alone: Couette and Poiseuille flow. The cavity is in gas_cavity.py."""
import numpy as np
from gas_relations import check_balances
from scree_program import EXACT, Checks, Program, centres

program, checks = Program(), Checks("gas alone in a channel", "T18")

HEIGHT, LENGTH, MU = 0.02, 0.04, 1.8e-3
run = program.run("gas_couette.yaml", "couette", EXACT)
y = centres(run.fields["y_faces"])
checks.below("Couette: greatest error over the speed of the wall",
             np.abs(run.fields["gas_velocity_x_face"] - (y / HEIGHT)[:, None]).max(), 1e-8)
check_balances(checks, "Couette", run)

# Of second order; the balances of a uniform channel have the parabola lifted by dy^2/8 as their solution.
drop = 0.36
errors = []
for cells in (8, 16, 32):
    run = program.run("gas_channel.yaml", f"poiseuille_{cells}",
                      {**EXACT, "boundary_left_gas_pressure": drop, "grid_cells": f"8, {cells}"})
    y, u = centres(run.fields["y_faces"]), run.fields["gas_velocity_x_face"]
    scale = drop / LENGTH / (2 * MU)
    parabola = scale * y * (HEIGHT - y)
    errors.append(np.abs(u - parabola[:, None]).max() / parabola.max())
    lifted = parabola + scale * (HEIGHT / cells) ** 2 / 4
    checks.below(f"Poiseuille, {cells} cells: greatest error of u of the balances' own solution, relative",
                 np.abs(u / lifted[:, None] - 1).max(), 1e-6)
    x = centres(run.fields["x_faces"])
    checks.below(f"Poiseuille, {cells} cells: greatest error of p_g, over its drop",
                 np.abs(run.fields["gas_pressure"] / drop - (1 - x / LENGTH)).max(), 1e-6)
    check_balances(checks, f"Poiseuille, {cells} cells", run)
checks.order("Poiseuille: greatest error on 8, 16, 32 cells across, over the greatest speed", errors, 2, 2e-3)

# Bernoulli: from rest outside through a channel without friction, u = sqrt(2 p/rho_g), and no pressure drop inside.
run = program.run("gas_channel.yaml", "entry", {**EXACT, "gas_viscous_stress": "no", "boundary_left_gas_entry": "at_rest",
                                                "boundary_left_gas_pressure": 0.65})
checks.below("entry from rest: greatest error of u, relative", np.abs(run.fields["gas_velocity_x_face"] - 1).max(), 1e-6)
checks.below("entry from rest: greatest p_g inside, over that outside", np.abs(run.fields["gas_pressure"] / 0.65).max(), 1e-6)
checks.verdict()
