"""H18: columns of aspect ratio 1, 3, 7. Run-out and final height over the width go as a and 1 for low columns and as
a^(2/3) and a^(2/5) for tall ones (Lube et al. 2005, Phys. Rev. E 72, 041301; Lajeunesse et al. 2005, Phys. Fluids 17,
103302 has a^(1/3) for the height); Balmforth & Kerswell (2005), J. Fluid Mech. 538, have run-outs as a^(0.9 +- 0.1) in
wide channels, with constants that the material decides. A quarter of an hour."""
import numpy as np
from piles import depth, front, standing
from scree_program import Checks, Program

WIDTH, G, D = 0.05, 9.81, 1e-3
COLUMNS = ((1, 0.30, 0.8), (3, 0.45, 1.2), (7, 0.75, 1.6))  # aspect ratio, length of the floor [m], end time [s]

program, checks = Program(), Checks("column collapse over aspect ratios", "H18")
run_out, height = [], []
for a, length, end in COLUMNS:
    top = WIDTH * a + 0.02
    run = program.run("collapse.yaml", f"ratio_{a}", {
        "extent": f"{length}, {top}", "grid_cells": f"{round(length / 5e-3)}, {round(top / 5e-3)}",
        "initial_column_box": f"0, {WIDTH}, 0, {WIDTH * a}", "end_time": end, "output_interval": 0.1}, timeout=None)
    last = run.fields
    run_out.append(front(last, 2 * D) / WIDTH - 1)
    height.append(depth(last)[1][0] / WIDTH)
    print(f"  a = {a}: run-out {run_out[-1]:.2f}, height {height[-1]:.2f}", flush=True)
    checks.below(f"a = {a}: greatest speed over the last 0.1 s over sqrt(g h)", standing(run, end - 0.1) / np.sqrt(G * WIDTH * a), 0.05)
    checks.hard_case("H18", f"column of aspect ratio {a}", run, measured=f"run-out {run_out[-1]:.2f}, height {height[-1]:.2f}",
                     bound=f"{1.2 * a if a < 1.8 else 1.9 * a ** (2 / 3):.2f}, {a if a < 1.15 else 0.65 * a ** 0.4:.2f}")
ratios = np.log([column[0] for column in COLUMNS])
checks.close("exponent of the run-out between a = 1 and 3", (np.diff(np.log(run_out)) / np.diff(ratios))[0], 0.9, absolute=0.1)
checks.close("exponent of the run-out between a = 3 and 7", (np.diff(np.log(run_out)) / np.diff(ratios))[1], 2 / 3, absolute=0.15)
checks.close("exponent of the height between a = 3 and 7", (np.diff(np.log(height)) / np.diff(ratios))[1], 0.37, absolute=0.1)
checks.verdict()
