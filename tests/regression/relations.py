"""Relations between runs that need no stored number: mass, mirror, presets, each of them on one rank and on two."""
import numpy as np
from scree_program import DIRECT, Checks, Program

# Steps given and short enough to need no cuts, Newton converged: then only rounding and its growth tell two ways to the
# same solution apart.
TIGHT = {"time_step_adaptive": "no", "time_step_initial": 2e-5, "snes_rtol": 1e-9, "snes_atol": 1e-8, "snes_stol": 1e-12,
         "end_time": 5e-4}
UNKNOWNS = ("solids_fraction", "velocity_x_face", "velocity_y_face", "granular_temperature", "frictional_pressure_ratio")


def difference(a, b):
    """Greatest difference of the states, each unknown relative to its greatest value."""
    names = [name for name in UNKNOWNS if name in a]
    return max(np.abs(a[n] - b[n]).max() / max(np.abs(a[n]).max(), 1e-12) for n in names)


def mass(fields):
    return float(np.einsum("yx,y,x->", fields["solids_fraction"], np.diff(fields["y_faces"]), np.diff(fields["x_faces"])))


program, checks = Program(), Checks("relations between runs")

# A closed box: the orifice and the sides shut. The sum over the cells, not the program's own account.
closed = {"boundary_bottom_kind": "wall_free_slip", "boundary_below_kind": "wall_free_slip",
          "boundary_top_kind": "wall_free_slip", "end_time": 0.04}
run = program.run("small_bin.yaml", "closed", closed)
checks.close("closed box: mass at the end against the start", mass(run.fields) / mass(run.first_fields), 1, absolute=1e-12)
checks.below("closed box: mass error by the program's account", np.abs(run.monitor["mass_error"]).max(), 1e-12)

one = program.run("small_bin.yaml", "one_rank", {**TIGHT, **DIRECT}, ranks=1)
checks.below("bin: mass error", np.abs(one.monitor["mass_error"]).max(), 1e-12)
for ranks in (1, 2):  # direct on two: jet.py
    for preset in ("ilu", "multigrid", "fieldsplit", "condensed"):
        name = f"preset {preset}, ranks {ranks}"
        other = program.run("small_bin.yaml", f"preset_{preset}_{ranks}", {**TIGHT, "solver": preset}, ranks=ranks)
        cut = int(other.summary["rejected_solver"])  # a step that the linear solver cuts leaves another path of steps
        checks.below(f"{name}: steps cut by the solver", cut, 2)
        checks.below(f"{name} against direct, {cut} steps cut, relative", difference(one.fields, other.fields),
                     3e-3 if cut else 1e-6)

full = {"grid_x_edges": "-4 cm, -1 cm, 1 cm, 4 cm", "grid_x_cells": "9, 6, 9", "boundary_centreline_kind": "wall_johnson_jackson",
        "boundary_centreline_patch": "1 cm, 9 cm", "boundary_left_side": "x_lower", "boundary_left_kind": "open",
        "boundary_left_patch": "0, 1 cm", "plate_floor_openings": "-1 cm, 1 cm", "flux_orifice_patch": "-1 cm, 1 cm",
        "initial_fill_box": "-4 cm, 4 cm, 1 cm, 7 cm", "output_mirror": 1}
whole = program.run("small_bin.yaml", "full_width", {**TIGHT, **DIRECT, **full}).fields
left_right = {name: whole[name][:, ::-1] * (-1 if name == "velocity_x_face" else 1) for name in whole
              if name in UNKNOWNS}
checks.below("full width: mirrored against itself, relative", difference(left_right, whole), 1e-7)
right = {name: value[:, value.shape[1] // 2:] for name, value in whole.items() if name in left_right}
checks.below("full width: right half against the half domain, relative", difference(right, one.fields), 1e-6)
checks.verdict()
