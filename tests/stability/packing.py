"""A bed without friction that falls together: the limit T -> 0, nu -> nu_max, where every grain is locked by its neighbours
and Newton's method loses its way, is kept off by T_rest; the bed still packs to nu_max and rests."""
import numpy as np
from scree_program import Checks, Program

FLOOR, DENSITY, NU_MAX, T_REST = 0.04 * 0.01, 2900, 0.65, 1e-6  # SI; the floor 1 cm deep

program, checks = Program(), Checks("bed held up by collisions alone", "H6")
run = program.run("packing.yaml", "packing", {})
monitor = run.monitor
checks.above("time reached [s]", monitor["time"][-1], 0.3 * (1 - 1e-9))
checks.below("steps lost to the solver", monitor["rejected_solver"].sum(), 40)
checks.below("mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.true("nu stays below nu_max", monitor["solids_fraction_max"].max() < NU_MAX)
packed = monitor["mass"][-1] / (DENSITY * NU_MAX * FLOOR)
checks.close("height of the bed [m]: all of it at nu_max", monitor["bed_height"][-1], packed, relative=1e-3)
# the gas drags on it: J_vis takes a little of what T_rest leaves
checks.close("least T at the end [m2/s2]: T_rest", monitor["granular_temperature_min"][-1], T_REST, relative=0.1)
checks.hard_case("H6", "bed without friction falls together, 400 um in air", run, measured="packs to nu_max and rests",
                 bound="reaches its end; height at nu_max to 1e-3")
checks.verdict()
