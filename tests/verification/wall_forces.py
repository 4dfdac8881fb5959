"""Stresses of the particles on walls: their sum is the weight, their profile Janssen's, their mean that of the steps."""
import numpy as np
from scree_program import Checks, Program

program, checks = Program(), Checks("stresses on walls")
G, DEPTH, TAN, W = 9.81, 0.01, np.tan(np.radians(12.3)), 0.04


def wall(run, name, index):
    return np.genfromtxt(run.directory / "walls" / f"{name}_{index:06d}.csv", delimiter=",", names=True)


run = program.run("wall_forces.yaml", "bed")
monitor = run.monitor
weight = monitor["mass"][-1] * G
force = {(name, axis): monitor[f"force_boundary_{name}_{axis}"][-1] for name in ("left", "right", "floor") for axis in "xy"}

# Momentum of the bed: what the forces leave of the weight makes it move.
fields, dt = run.fields, monitor["dt"][-1]
momentum = lambda f: 2900 * DEPTH * (np.outer(np.diff(f["y_faces"]), np.diff(f["x_faces"])) * f["solids_fraction"]
                                     * 0.5 * (f["velocity_y_face"][1:] + f["velocity_y_face"][:-1])).sum()
vertical = sum(force[name, "y"] for name in ("left", "right", "floor"))
checks.close("floor and shear of the walls against the weight [N]", -vertical, weight, relative=1e-4)
checks.close("walls against each other [N]", force["left", "x"], -force["right", "x"], relative=1e-6)
length = W / (2 * TAN)  # of Janssen; p is as large along the walls as across them
checks.close("share of the weight that the walls carry, Janssen", -(force["left", "y"] + force["right", "y"]) / weight,
             1 - length / 0.15 * (1 - np.exp(-0.15 / length)), absolute=0.05)

last = len(run.all_fields()) - 1
for name in ("left", "right", "floor"):
    rows = wall(run, f"boundary_{name}", last)
    across = "x" if name != "floor" else "y"
    along = "y" if name != "floor" else "x"
    normal = (rows["normal_stress"] * rows["area"] * rows[f"normal_{across}"]).sum() * DEPTH
    shear = (rows[f"shear_stress_{along}"] * rows["area"]).sum() * DEPTH
    checks.close(f"{name}: sum of the normal stress against the force [N]", -normal, force[name, across], relative=1e-7)
    checks.close(f"{name}: sum of the shear stress against the force [N]", shear, force[name, along], relative=1e-7, absolute=1e-12)

# Janssen, walls that slip upwards at 10 cm/s: tau = tan(delta) sigma_n, and the bed is pushed up.
rows = wall(run, "boundary_left", last)
inside = (rows["y"] > 0.01) & (rows["y"] < 0.14)
slip = rows["shear_stress_y"][inside] / rows["normal_stress"][inside]
checks.true("left wall: lines go up along it", bool(np.all(np.diff(rows["y"]) > 0)))
checks.below("left wall: greatest error of tau/sigma_n against tan(delta), relative", np.abs(np.abs(slip) / TAN - 1).max(), 0.02)

# Means over time: each step's stresses weighted by its length.
weight_of = np.clip(monitor["time"] - 0.1, 0, monitor["dt"])
floor = wall(run, "boundary_floor", last)
mean = (floor["mean_normal_stress"] * floor["area"]).sum() * DEPTH
checks.close("floor: mean normal force against the rows of monitor.csv [N]", mean,
             -(weight_of * monitor["force_boundary_floor_y"]).sum() / weight_of.sum(), relative=1e-7)
checks.true("no means before they begin", "mean_normal_stress" not in wall(run, "boundary_floor", 0).dtype.names)

# A plate that carries the bed has it above and nothing below.
plate = {"plate_shelf_axis": "y", "plate_shelf_position": "2 cm", "plate_shelf_kind": "wall_no_slip", "initial_fill_box": "0, 4 cm, 2 cm, 15 cm", "end_time": 0.15}
run = program.run("wall_forces.yaml", "shelf", plate)
last = len(run.all_fields()) - 1
rows = wall(run, "plate_shelf", last)
checks.equal("shelf: two lines for each face", len(rows), 16)
checks.below("shelf: greatest stress from below [Pa]", np.abs(rows["normal_stress"][rows["normal_y"] < 0]).max(), 1e-9)
monitor = run.monitor
vertical = sum(monitor[f"force_{name}_y"][-1] for name in ("boundary_left", "boundary_right", "boundary_floor", "plate_shelf"))
checks.close("shelf and walls against the weight [N]", -vertical, monitor["mass"][-1] * G, relative=1e-3)

# Averages go on after a restart.
options = {"end_time": 0.15, "checkpoint_interval": 0.12}
whole = program.run("wall_forces.yaml", "whole", options)
half = program.run("wall_forces.yaml", "half", {**options, "end_time": 0.12})
rest = program.run("wall_forces.yaml", "rest", {**options, "restart": half.directory})
name = "boundary_right"
a, b = wall(whole, name, len(whole.all_fields()) - 1), wall(rest, name, len(rest.all_fields()) - 1)
checks.equal("restart: mean normal stress, bit for bit", bool(np.array_equal(a["mean_normal_stress"], b["mean_normal_stress"])), True)
checks.verdict()
