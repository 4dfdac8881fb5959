"""The start of the bin on the paper's grid: where the bed falls away from the open top, cells of nu 1e-4 are left with all
the velocity differences that Newton's method leaves them. Too much of it made T, lost its way back, and no step worked."""
import numpy as np
from scree_program import Checks, Program

END = 0.07  # s
# Filled 30 cm high, not 100 cm: what happens at the top is the same, for a third of the time.
LOW = {"grid_y_edges": "0, 5 cm, 35 cm", "grid_y_cells": "25, 150", "initial_fill_box": "0, 4 cm, 5 cm, 35 cm",
       "boundary_wall_patch": "5 cm, 35 cm"}
program, checks = Program(), Checks("bin of the paper on its grid, first 0.07 s", "paper start")
run = program.run("../../cases/bin_discharge/paper.yaml", "paper", {**LOW, "end_time": END})
monitor = run.monitor
checks.above("time reached [s]", monitor["time"][-1], END * (1 - 1e-9))
checks.below("steps lost to the solver", monitor["rejected_solver"].sum(), 3.5)
checks.below("Newton iterations a step", monitor["newton_iterations"].sum() / len(monitor["time"]), 4)
checks.below("mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.verdict()
