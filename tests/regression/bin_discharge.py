"""cases/bin_discharge, coarse and short: stored numbers, and the balance of mass. --update writes bin_discharge.json anew.

The tolerances leave room for another path of Newton and of the steps to the same solution (accuracy 1e-2 a step), not for
another model or scheme: the rate of a coarse grid changes by 10 % from one to the next."""
import json

import numpy as np
from scree_program import Checks, Program

# 6 mm x 1 cm cells, a fill of 20 cm
COARSE = {"grid_x_cells": "2, 6", "grid_y_edges": "0, 5 cm, 35 cm", "grid_y_cells": "5, 30", "boundary_wall_patch": "5 cm, 35 cm",
          "initial_fill_box": "0, 4 cm, 5 cm, 25 cm", "end_time": 0.2}
TOLERANCES = {"flux_orifice": 0.01, "mass": 1e-3, "bed_height": 2e-3, "solids_fraction_max": 2e-3,
              "frictional_pressure_ratio_min": 0.02}

program, checks = Program(), Checks("cases/bin_discharge, coarse, 0.2 s")
run = program.run("../../cases/bin_discharge/coarse.yaml", "coarse", COARSE)
found, monitor = run.summary["quantities"], run.monitor
file = program.here / "bin_discharge.json"
if program.update:
    file.write_text(json.dumps({name: float(f"{found[name]:.6g}") for name in TOLERANCES}, indent=2) + "\n")
stored = json.loads(file.read_text())
for name, tolerance in TOLERANCES.items():
    checks.close(f"{name} at the end", found[name], stored[name], relative=tolerance)
checks.below("mass error, greatest ever", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.below("mass lost against the flux through the orifice, trapezoidal",
             abs(1 - monitor["mass"][-1] / (monitor["mass"][0] - np.trapz(monitor["discharge_rate"], monitor["time"]))), 5e-3)
checks.above("least nu ever", monitor["solids_fraction_min"].min(), -1e-9)
checks.equal("end", run.summary["end"], "end_time")
checks.verdict()
