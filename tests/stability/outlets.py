"""Open parts of a side let dense particles out: an orifice in the floor of the box gives the rate of the same orifice with
5 cm of the box below it; slits in a floor and in a side wall drain, with gas too; nothing is sucked in."""
import numpy as np
from scree_program import Checks, Program

#: The same bin with 5 cm below its floor, which is a plate then.
WITH_ROOM = {"grid_y_edges": "-5 cm, 0, 30 cm", "grid_y_cells": "13, 75", "grid_y_ratio": "1, 1",
             "boundary_wall_patch": "0, 30 cm", "boundary_below_side": "x_upper", "boundary_below_kind": "open",
             "boundary_below_patch": "-5 cm, 0", "boundary_floor_kind": "open", "plate_floor_axis": "y",
             "plate_floor_position": 0, "plate_floor_openings": "0, 0.7 cm"}
#: A box of 8 cm x 8 cm, filled to 6 cm, on cells of 5 mm: few, for a look at what leaves.
SMALL = {"grid_x_edges": "0, 2 cm, 8 cm", "grid_x_cells": "4, 12", "grid_y_edges": "0, 8 cm", "grid_y_cells": 16,
         "initial_fill_box": "0, 8 cm, 0, 6 cm", "boundary_orifice_patch": "0, 2 cm", "flux_orifice_patch": "0, 2 cm",
         "end_time": 0.3, "time_step_initial": 1e-4}
IN_THE_WALL = {"boundary_orifice_side": "x_upper", "boundary_orifice_patch": "1 cm, 3 cm", "flux_orifice_axis": "x",
               "flux_orifice_position": "8 cm", "flux_orifice_patch": "1 cm, 3 cm", "flux_orifice_direction": "positive"}

program, checks = Program(), Checks("open parts of sides")
rates = {}
for name, options in (("on the side", {}), ("with 5 cm below", WITH_ROOM)):
    monitor = program.run("outlets.yaml", name.replace(" ", "_"), options).monitor
    late = monitor["time"] > 0.15
    rates[name] = np.trapz(monitor["flux_orifice"][late], monitor["time"][late]) / np.ptp(monitor["time"][late])
checks.close("rate of the orifice on a side over that with 5 cm below", rates["on the side"] / rates["with 5 cm below"], 1,
             absolute=1e-2)

for name, options in (("floor", {}), ("wall", IN_THE_WALL), ("floor, incompressible", {"gas": "incompressible"}),
                      ("floor, darcy", {"gas": "darcy"})):
    run = program.run("outlets.yaml", "small_" + name.replace(", ", "_"), {**SMALL, **options})
    monitor = run.monitor
    checks.below(f"slit of 2 cm in the {name}: what is left of the mass after 0.3 s", monitor["mass"][-1] / monitor["mass"][0],
                 0.8)
    checks.above(f"slit of 2 cm in the {name}: least rate ever [kg/s]", monitor["flux_orifice"].min(), -1e-12)
    checks.below(f"slit of 2 cm in the {name}: mass error", np.abs(monitor["mass_error"]).max() / monitor["mass"][0], 1e-12)
checks.verdict()
