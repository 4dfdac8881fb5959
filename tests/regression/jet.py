"""cases/bubble_rise, coarse and short: a restart in the middle of the jet, volumes of both phases, presets, ranks, half and
full width, darcy, and stored numbers. --update writes jet.json anew."""
import json
import shutil

import numpy as np
from scree_program import Checks, Program

# Cells of 1 cm, a bed of 12 cm, the jet until .04 s.
COARSE = {"grid_x_cells": "1, 6", "grid_y_edges": "0, 12 cm, 20 cm", "grid_y_cells": "12, 8",
          "initial_bed_box": "0, 7 cm, 0, 12 cm", "boundary_slit_until": 0.04, "end_time": 0.06, "checkpoint_interval": 0.03}
TOLERANCES = {"bed_height": 2e-3, "solids_fraction_max": 2e-3, "gas_pressure_max": 0.01,
              "speed_max": 0.02}
CASE = "../../cases/bubble_rise/paper.yaml"
GIVEN_STEPS = {"time_step_adaptive": "no", "time_step_initial": 5e-5, "end_time": 1e-3, "snes_rtol": 1e-9, "snes_atol": 1e-7,
               "ksp_rtol": 1e-8}


def difference(a, b):
    """Greatest difference of nu, v (where there are particles) and p_g, each relative to its greatest value."""
    there = a["solids_fraction"] > 1e-3
    names = ("solids_fraction", "velocity", "gas_pressure")
    return max(np.abs((a[name] - b[name])[there]).max() / np.abs(a[name]).max() for name in names)


program, checks = Program(), Checks("cases/bubble_rise, coarse, 0.06 s")
whole = program.run(CASE, "whole", COARSE)
found, monitor = whole.summary["quantities"], whole.monitor
file = program.here / "jet.json"
if program.update:
    file.write_text(json.dumps({name: float(f"{found[name]:.6g}") for name in TOLERANCES}, indent=2) + "\n")
for name, stored in json.loads(file.read_text()).items():
    checks.close(f"{name} at the end", found[name], stored, relative=TOLERANCES[name])
checks.below("solids volume: greatest error ever", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.below("gas volume: greatest error ever", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
checks.above("least nu ever", monitor["solids_fraction_min"].min(), -1e-9)

# From the checkpoint in the middle of the jet.
for name, ranks in (("same_ranks", 1), ("other_ranks", 2)):
    shutil.copytree(whole.directory, program.work / name)
    checkpoints = sorted((program.work / name / "checkpoints").glob("*.h5"))
    checks.equal(f"{name}: checkpoints", len(checkpoints), 2)
    checkpoints[-1].unlink()
    again = program.run(CASE, name, {**COARSE, "restart": program.work / name}, ranks=ranks)
    if ranks == 1:
        checks.true("same ranks: bits of the last fields",
                    all(np.array_equal(whole.fields[n], again.fields[n]) for n in whole.fields),
                    f"differ by {difference(whole.fields, again.fields):.1e}")
    else:
        checks.below("other ranks: greatest difference", difference(whole.fields, again.fields), 5e-3)

one = program.run(CASE, "given_steps", {**COARSE, **GIVEN_STEPS})
for ranks in (1, 2):
    for preset in ("ilu", "multigrid", "condensed", "direct", *(["fieldsplit"] if ranks > 1 else [])):
        name = f"preset {preset}, ranks {ranks}"
        other = program.run(CASE, f"preset_{preset}_{ranks}", {**COARSE, **GIVEN_STEPS, "solver": preset}, ranks=ranks)
        checks.equal(f"{name}: steps cut", other.summary["rejected_solver"], 0)
        checks.below(f"{name} against fieldsplit on 1", difference(one.fields, other.fields), 1e-6)

full = program.run("../../cases/bubble_rise/full_width.yaml", "full_width",
                   {**COARSE, **GIVEN_STEPS, "grid_x_cells": "6, 2, 6", "initial_bed_box": "-7 cm, 7 cm, 0, 12 cm"}).fields
right = {name: value[:, value.shape[1] // 2:] for name, value in full.items() if name in ("solids_fraction", "velocity", "gas_pressure")}
checks.below("full width: right half against the half domain", difference(one.fields, right), 1e-6)
left = full["solids_fraction"][:, ::-1]
checks.below("full width: nu mirrored against itself", np.abs(left - full["solids_fraction"]).max(), 1e-9)

darcy = program.run(CASE, "darcy", {**COARSE, "gas": "darcy"})
checks.close("darcy: bed height against incompressible", darcy.summary["quantities"]["bed_height"], found["bed_height"],
             relative=0.01)
checks.verdict()
