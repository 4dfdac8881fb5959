"""T18: gas alone: Couette and Poiseuille flow, and the lid-driven cavity against Ghia, Ghia and Shin (1982)
and Botella and Peyret (1998)."""
import numpy as np
from gas_relations import check_balances
from scree_program import DIRECT, EXACT, Checks, Program, centres

# Re 100: u on the vertical centreline (Ghia); least u, greatest and least v on the centrelines (Botella)
GHIA = {.0547: -.03717, .0625: -.04192, .0703: -.04775, .1016: -.06434, .1719: -.10150, .2813: -.15662, .4531: -.21090,
        .5: -.20581, .6172: -.13641, .7344: .00332, .8516: .23151, .9531: .68717}
EXTREMA = (-.2140424, .1795728, -.2538030)



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


program, checks = Program(), Checks("gas alone", "T18")

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

errors = []
for cells in (12, 24, 48):
    name = f"cavity, {cells} x {cells} cells"
    run = program.run("gas_cavity.yaml", f"cavity_{cells}", {**DIRECT, "grid_cells": f"{cells}, {cells}"})
    y = np.concatenate([[0], centres(run.fields["y_faces"]), [1]])
    u = interpolation(y, np.concatenate([[0], run.fields["gas_velocity_x_face"][:, cells // 2], [1]]))
    v = interpolation(y, np.concatenate([[0], run.fields["gas_velocity_y_face"][cells // 2], [0]]))
    fine = np.linspace(0, 1, 10001)
    errors.append([abs(found - exact) for found, exact in zip((u(fine).min(), v(fine).max(), v(fine).min()), EXTREMA)])
    check_balances(checks, name, run)
for name, (coarse, middle, fine) in zip(("least u", "greatest v", "least v"), zip(*errors)):
    checks.below(f"{name}: error on 48 x 48 cells", fine, 3e-3)
    checks.below(f"{name}: error on 48 over that on 24 cells, second order", fine / middle, 0.28)
checks.below("48 x 48 cells: greatest difference of u to Ghia", max(abs(u(at) - exact) for at, exact in GHIA.items()), 5e-3)
checks.verdict()
