"""T6, plug in a vertical channel: velocity profile, its order in space, and the deceleration by the walls."""
import numpy as np
from scree_program import EXACT, Checks, Program, centres, norm

T, D, W, G, NU, RHO = 1e-10, 1e-3, 0.08, 9.81, 0.6, 2900.0
SIN, TAN = np.sin(np.radians(28.5)), np.tan(np.radians(12.3))
A = 2 * TAN / (W * SIN)


def drop(x):
    return np.sqrt(2 * T) / D / A * (1 - np.sqrt(1 - (A * x) ** 2))


program, checks = Program(), Checks("plug in a channel, W 8 cm, nu 0.6, d 0.1 cm", "T6")
checks.close("reference v(0) - v(wall) at T = 1 cm2/s2 [cm/s]", drop(W / 2) * np.sqrt(1e-4 / T) * 100, 13.6802, relative=1e-5)
errors = []
for cells in (8, 16, 32):
    run = program.run("plug_in_channel.yaml", f"cells_{cells}", {**EXACT, "grid_cells": f"{cells}, 2"})
    last = run.fields
    x, v = centres(last["x_faces"]), last["velocity_y_face"][0]
    # v falls: the middle is the fastest; the constant is taken off by the mean over the two middle cells
    middle = slice(cells // 2 - 1, cells // 2 + 1)
    found = v - v[middle].mean()
    errors.append(norm(found - (drop(x) - drop(x[middle]).mean())) / drop(W / 2))
    checks.below(f"{cells} cells: left against right, relative", np.abs(v - v[::-1]).max() / drop(W / 2), 1e-7)
    checks.below(f"{cells} cells: spread of nu", np.ptp(last["solids_fraction"]), 1e-10)
checks.order("L2 error of the profile on 8, 16, 32 cells, relative to the whole drop", errors, 2, 1e-3)
p_c = 0.05 * (NU - 0.5) ** 2 / (0.65 - NU) ** 5
acceleration = -G + 2 * p_c * TAN / (W * RHO * NU)
checks.close("v after 0.02 s [m/s]", v.mean(), -1 + acceleration * 0.02, absolute=1e-6)
checks.verdict()
