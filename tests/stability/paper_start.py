"""The start of the bin on the paper's grid: where the bed falls away from the open top, cells of nu 1e-4 are left with all
the velocity differences that Newton's method leaves them. Too much of it made T, lost its way back, and no step worked."""
import numpy as np
from scree_program import Checks, Program

END = 0.07  # s; Newton's method has most to do from 0.06 s on
program, checks = Program(), Checks("bin of the paper on its grid, first 0.07 s", "paper start")
run = program.run("../../cases/bin_discharge/paper.yaml", "paper", {"end_time": END})
monitor = run.monitor
checks.above("time reached [s]", monitor["time"][-1], END * (1 - 1e-9))
checks.below("steps lost to the solver", monitor["rejected_solver"].sum(), 3.5)
checks.below("Newton iterations a step", monitor["newton_iterations"].sum() / len(monitor["time"]), 4)
checks.below("mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.verdict()
