"""A surface at rest stays at rest: a partly filled row of cells on a floor along each axis, up and down, open to the top,
with gas, with T; a row in mid-air falls as all others do, and what falls onto a bed arrives."""
import numpy as np
from closures import dissipation_factor
from scree_program import Checks, Program, centres

G, D = 9.81, 1e-3
SINKING = 1e-4 * np.sqrt(G * D)  # v_c of surface_stress.hpp [m/s]


def along(axis, down):
    """Options that lay the row on the lower (down -1) or upper side of an axis."""
    side = "xy"[axis]
    floor, lid = (f"{side}_lower", f"{side}_upper") if down < 0 else (f"{side}_upper", f"{side}_lower")
    row = "0, 0.5 cm" if down < 0 else "4.5 cm, 5 cm"
    gravity = ["0", "0"]
    gravity[axis] = str(down * G)
    options = {"boundary_floor_side": floor, "boundary_lid_side": lid}
    if axis == 0:
        return {**options, "gravity": gravity[0], "initial_bed_box": row}
    return {**options, "dimension": 2, "extent": "1.5 cm, 5 cm", "grid_cells": "3, 10", "periodic": "x",
            "gravity": ", ".join(gravity), "initial_bed_box": f"0, 1.5 cm, {row}"}


program, checks = Program(), Checks("surface at rest")
CASES = {"x, down": along(0, -1), "x, up": along(0, 1), "y, down": along(1, -1), "y, up": along(1, 1),
         "x, open top": {"boundary_lid_kind": "open"},
         "x, full to the brim of an open box": {"boundary_lid_kind": "open", "extent": "0.5 cm", "grid_cells": 1},
         "x, unequal cells": {"grid_cells": "", "grid_x_edges": "0, 0.5 cm, 5 cm", "grid_x_cells": "1, 5",
                              "grid_x_ratio": "1, 2"},
         "x, air": {"gas": "incompressible"}, "x, darcy": {"gas": "darcy"}}
for name, options in CASES.items():
    options = {key: value for key, value in options.items() if value != ""}
    run = program.run("surface_at_rest.yaml", name.replace(", ", "_").replace(" ", "_"), options)
    checks.below(f"{name}: greatest speed at 3 s over the speed at which a surface may sink",
                 run.monitor["speed_max"][-1] / SINKING, 1.01)
    drift = np.abs(run.fields["solids_fraction"] - run.first_fields["solids_fraction"]).max()
    checks.below(f"{name}: drift of nu in 3 s", drift, 1e-9)
    checks.below(f"{name}: mass error", np.abs(run.monitor["mass_error"]).max() / run.monitor["mass"][0], 1e-13)

# T of a row of nu .1: it spreads at first, as a gas does; then it cools, not slower than by collisions at its nu.
T0 = 1e-4
run = program.run("surface_at_rest.yaml", "cooling", {
    "granular_temperature": "transport", "initial_bed_solids_fraction": 0.1,
    "initial_bed_granular_temperature": T0, "end_time": 10, "accuracy": 1e-2, "scale_velocity": 1e-3})
haff = T0 / (1 + dissipation_factor(0.1) / (0.1 * D) * np.sqrt(T0) * 10 / 3) ** 2
checks.below("row of nu 0.1, T transported: T at 10 s over that of Haff's law",
             run.monitor["granular_temperature_max"][-1] / haff, 1.1)

# A row of cells in mid-air falls with its whole weight.
run = program.run("surface_at_rest.yaml", "mid_air", {
    "extent": "20 cm", "grid_cells": 40, "initial_bed_box": "15 cm, 15.5 cm", "end_time": 0.12, "time_step_max": 1e-3})
first, last = run.first_fields, run.fields
x = centres(last["x_faces"])
place = [np.sum(x * f["solids_fraction"]) / np.sum(f["solids_fraction"]) for f in (first, last)]
checks.close("row in mid-air: fall of its centre in 0.12 s [m]", place[0] - place[1], G * 0.12**2 / 2, relative=5e-2)
checks.verdict()
