"""The preset condensed in each layout, on one rank and on two: few Krylov iterations, the solution of a direct solver, and
a restart that ends bit for bit as the uninterrupted run; and a linear system that the first preset does not solve goes
to it before a step is cut."""
import shutil

import numpy as np
from scree_program import DIRECT, Checks, Program

BUBBLE = "../../cases/bubble_rise/paper.yaml"
COARSE_BUBBLE = {"grid_x_cells": "1, 6", "grid_y_edges": "0, 12 cm, 20 cm", "grid_y_cells": "12, 8",
                 "initial_bed_box": "0, 7 cm, 0, 12 cm"}
COARSE_BOX = {"grid_x_cells": "2, 4", "grid_y_cells": "2, 4", "grid_z_edges": "0, 2 cm, 12 cm", "grid_z_cells": "4, 8",
              "initial_fill_box": "0, 4 cm, 0, 4 cm, 2 cm, 9 cm",
              "boundary_wall_x_patch": "0, 4 cm, 2 cm, 12 cm", "boundary_wall_y_patch": "0, 4 cm, 2 cm, 12 cm"}
BED = "../../cases/bed_3d/case.yaml"
COARSE_BED = {"grid_x_cells": "1, 3", "grid_y_cells": "1, 3", "grid_z_edges": "0, 6 cm, 10 cm", "grid_z_cells": "6, 4",
              "grid_z_ratio": "1, 1", "initial_bed_box": "0, 4 cm, 0, 4 cm, 0, 5 cm"}
SEVERAL_GRIDS = {"condensed_core_pc_staggered_coarse_eq_limit": 200}  # so small a grid would be the coarsest
# Layout: case, options, end of a run with free steps [s], Krylov iterations a linear system there, at most.
LAYOUTS = {
    "plane, none": ("small_bin.yaml", {}, 0.006, 8),
    "plane, none, fluidity": ("small_bin.yaml", {"friction_coefficient": "fluidity"}, 0.006, 8),
    "plane, darcy": (BUBBLE, {**COARSE_BUBBLE, "gas": "darcy"}, 0.006, 8),
    "plane, incompressible": (BUBBLE, COARSE_BUBBLE, 0.006, 8),
    "space, none": ("../benchmark/bin_3d.yaml", {**COARSE_BOX, **SEVERAL_GRIDS}, 0.003, 8),
    "space, incompressible": (BED, {**COARSE_BED, **SEVERAL_GRIDS}, 0.003, 8),
}
TIGHT = {"time_step_adaptive": "no", "time_step_initial": 2e-5, "end_time": 1e-4, "snes_rtol": 1e-9, "snes_atol": 1e-8,
         "snes_stol": 1e-12, "ksp_rtol": 1e-8}
CONDENSED = {"solver": "condensed"}


def difference(a, b):
    """Greatest difference of the unknowns where there are particles, each relative to its greatest value."""
    there = a["solids_fraction"] > 1e-3
    names = [name for name in ("solids_fraction", "velocity", "granular_temperature", "gas_pressure", "fluidity")
             if name in a]
    return max(np.abs((a[name] - b[name])[there]).max() / np.abs(a[name]).max() for name in names)


def go_on(layout, name, case, free, whole, ranks):
    """The run `whole` from its checkpoint at half time."""
    shutil.copytree(whole.directory, program.work / f"{name}_again")
    sorted((program.work / f"{name}_again" / "checkpoints").glob("*.h5"))[-1].unlink()
    again = program.run(case, f"{name}_again", {**free, "restart": program.work / f"{name}_again"}, ranks=ranks)
    checks.true(f"{layout}, ranks {ranks}: restart, bits of the last fields",
                all(np.array_equal(whole.fields[field], again.fields[field]) for field in whole.fields),
                f"differ by {difference(whole.fields, again.fields):.1e}")


program, checks = Program(), Checks("the preset condensed, on one rank and on two")
for layout, (case, options, end, most) in LAYOUTS.items():
    name = layout.replace(", ", "_")
    direct = program.run(case, f"{name}_direct", {**options, **TIGHT, **DIRECT})
    for ranks in (1, 2):
        free = {**options, **CONDENSED, "end_time": end, "checkpoint_interval": end / 2}
        whole = program.run(case, f"{name}_{ranks}", free, ranks=ranks)
        mean = whole.summary["krylov_iterations"] / whole.summary["newton_iterations"]
        checks.below(f"{layout}, ranks {ranks}: Krylov iterations a linear system", mean, most)
        checks.below(f"{layout}, ranks {ranks}: steps cut by the solver", whole.summary["rejected_solver"], 1)
        go_on(layout, f"{name}_{ranks}", case, free, whole, ranks)
        tight = program.run(case, f"{name}_tight_{ranks}", {**options, **TIGHT, **CONDENSED}, ranks=ranks)
        checks.below(f"{layout}, ranks {ranks}: against direct", difference(direct.fields, tight.fields), 1e-6)

# Another multigrid for the core, named by the user.
program.run("../benchmark/bin_3d.yaml", "gamg", {**COARSE_BOX, **CONDENSED, "end_time": 2e-4, "condensed_core_pc_type": "gamg"})

# ILU on the graded cells of the bin, rigid friction: its nodes by rows take 18 iterations a linear system. Newton's method
# wanders before it converges; given up too early, 7 steps are lost.
GRADED = {"grid_x_cells": "5, 7", "grid_y_cells": "8, 20, 25", "friction_fluctuation": 0, "end_time": 0.02}
graded = program.run("../../cases/bin_discharge/case.yaml", "graded", {**GRADED, "solver": "ilu"}).summary
checks.below("ilu, graded cells, c = 0: Krylov iterations a linear system",
             graded["krylov_iterations"] / graded["newton_iterations"], 13)
checks.below("graded cells, c = 0: steps lost to the solver", graded["rejected_solver"], 3.5)

# Jacobi in the place of ILU, and few iterations: the run goes over to condensed, and no step is cut.
weak = program.run("small_bin.yaml", "weak", {"end_time": 0.01, "ksp_max_it": 6, "sub_pc_type": "jacobi"})
checks.true("a system that is not solved: goes to condensed", "a linear system is not solved; solver condensed" in weak.log, weak.log)
strong = program.run("small_bin.yaml", "strong", {"end_time": 0.01})
checks.below("a system that is not solved: steps cut by the solver, beyond those with the default",
             weak.summary["rejected_solver"] - strong.summary["rejected_solver"], 1)
checks.verdict()
