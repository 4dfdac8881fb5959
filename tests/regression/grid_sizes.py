"""A grid given by the sizes of its cells: faces on all edges, the finest at the lips, neighbours within the growth, in two and
three dimensions and round periodic axes; the effective case and the checkpoints of a run hold the same faces to the last bit."""
import numpy as np
from scree_program import EXACT, Checks, Program, mirror_error

program, checks = Program(), Checks("grids given by the sizes of their cells")
FINEST, COARSEST, GROWTH = 1e-3, 8e-3, 1.25
SIZES = {"grid_finest": FINEST, "grid_coarsest": COARSEST, "grid_growth": GROWTH}
FULL_WIDTH = """based_on: BASE
grid:
  x_edges: "-4 cm, 4 cm"
boundary:
  centreline: {kind: wall_johnson_jackson, patch: "1 cm, 9 cm"}
  left_below: {side: x_lower, kind: open, patch: "0, 1 cm"}
plate: {floor: {openings: "-1 cm, 1 cm"}}
flux: {orifice: {patch: "-1 cm, 1 cm"}}
initial: {fill: {box: "-4 cm, 4 cm, 1 cm, 7 cm"}}
output: {mirror: 1}
"""
PERIODIC = """dimension: 2
extent: "6 cm, 10 cm"
periodic: x
grid: {finest: 1 mm, coarsest: 8 mm, growth: 1.25}
gravity: "0, -9.81"
boundary:
  floor: {side: y_lower, kind: wall_johnson_jackson}
  hole: {side: y_lower, kind: open, patch: "5 cm, 6 cm", order: 1}
  top: {side: y_upper, kind: open}
initial: {bed: {box: "0, 6 cm, 0, 5 cm", solids_fraction: 0.58}}
end_time: 0.01 s
"""


def check_faces(name, faces, planes, lips, periodic=False):
    """One axis. `lips` are planes too; each is a pair of a place and the cells beside it that are in the box."""
    sizes = np.diff(faces)
    rows = np.append(sizes, sizes[0]) if periodic else sizes
    growth = np.maximum(rows[1:] / rows[:-1], rows[:-1] / rows[1:]).max()
    checks.below(f"{name}: greatest ratio of neighbours", growth, GROWTH * (1 + 1e-9))
    checks.below(f"{name}: greatest cell [m]", sizes.max(), COARSEST * (1 + 1e-9))
    checks.above(f"{name}: least cell [m]", sizes.min(), 0.95 * FINEST * (1 - 1e-9))
    for at in planes + lips:
        checks.below(f"{name}: distance of the nearest face from {at} [m]", np.abs(faces - at).min(), 1e-15)
    for at in lips:
        i = np.abs(faces - at).argmin()
        for size in (sizes[i - 1:i] if i else sizes[:0]), sizes[i:i + 1]:
            if size.size:
                checks.close(f"{name}: cell beside {at} [m]", size[0], FINEST, relative=1e-9)


# ---- half of a bin
half = program.run("small_bin.yaml", "half", {**SIZES, "grid_x_edges": "0, 4 cm", "grid_y_edges": "0, 9 cm"})
fields = half.fields
check_faces("half, x", fields["x_faces"], [0, 0.04], [0.01])
check_faces("half, y", fields["y_faces"], [0, 0.07, 0.09], [0.01])
checks.close("half: mass at the start [kg]", half.monitor["mass"][0], 2 * 0.04 * 0.06 * 0.01 * 0.6 * 2900, relative=1e-12)
checks.below("half: mass error", np.abs(half.monitor["mass_error"]).max(), 1e-12)
cells = [fields[f"{axis}_faces"].size - 1 for axis in "xy"]
checks.below("half: cells along each axis, of those that are all finest", max(cells[0] / 40, cells[1] / 90), 0.45)

# ---- what a run leaves makes the same grid
again = program.run(half.directory / "case.yaml", "again").fields
checks.equal("effective case: the same fields, bit for bit", all(np.array_equal(again[name], fields[name]) for name in fields), True)
on = program.run(half.directory / "case.yaml", "on", {"restart": half.directory, "end_time": 0.05})
checks.close("restart: goes on to [s]", on.summary["time"], 0.05, relative=1e-12)
checks.equal("restart: the same faces", bool(np.array_equal(on.fields["x_faces"], fields["x_faces"])), True)
moved = program.run(half.directory / "case.yaml", "moved", {"restart": half.directory, "end_time": 0.05, "grid_growth": 1.2},
                    must_work=False)
checks.equal("restart on another growth: exit code", moved.code, 1)

# ---- the whole width, symmetric to the last bit
path = program.work / "full_width.yaml"
path.write_text(FULL_WIDTH.replace("BASE", str(program.here / "small_bin.yaml")))
full = program.run(path, "full", {**SIZES, **EXACT, "grid_y_edges": "0, 9 cm", "end_time": 0.01}).fields
faces = full["x_faces"]
checks.equal("full width: faces mirrored, bit for bit", bool(np.array_equal(faces, -faces[::-1])), True)
check_faces("full width, x", faces, [-0.04, 0.04], [-0.01, 0.01])
checks.below("full width: nu against its mirror image", mirror_error(full["solids_fraction"]), 1e-10)

# ---- round a periodic axis
path = program.work / "periodic.yaml"
path.write_text(PERIODIC)
round_ = program.run(path, "periodic")
check_faces("periodic, x", round_.fields["x_faces"], [], [0, 0.05, 0.06], periodic=True)
check_faces("periodic, y", round_.fields["y_faces"], [0.05], [0])
checks.below("periodic: mass error", np.abs(round_.monitor["mass_error"]).max(), 1e-12)

# ---- three dimensions
bin_3d = program.here.parent / "benchmark" / "bin_3d.yaml"
FINEST, COARSEST, GROWTH = 4e-3, 3e-2, 1.5
solid = program.run(bin_3d, "solid", {"grid_finest": FINEST, "grid_coarsest": COARSEST, "grid_growth": GROWTH, "end_time": 2e-3,
                                      "output_dir": program.work / "solid"})
for axis, planes, lips in (("x", [0, 0.04], [0.008]), ("y", [0, 0.04], [0.008]), ("z", [0, 0.24], [0.02])):
    check_faces(f"3-D, {axis}", solid.fields[f"{axis}_faces"], planes, lips)
checks.below("3-D: mass error", np.abs(solid.monitor["mass_error"]).max(), 1e-12)

# ---- what -check says
said = program.run("small_bin.yaml", "said", {**SIZES, "check": None}).log.splitlines()
count = [line for line in said if line.startswith("# grid: ")]
checks.true("-check: cells", len(count) == 1 and count[0].endswith(" cells"), said[:8])
for axis in "xy":
    line = next((line for line in said if line.startswith(f"# grid along {axis}: ")), "")
    checks.true(f"-check: sizes along {axis}", "cells of 0.001 m to" in line and "neighbours within a factor of 1.25" in line, line)
checks.verdict()
