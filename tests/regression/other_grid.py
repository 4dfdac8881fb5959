"""A run that starts from the last state of another one: on the same grid, a finer, a coarser, with gas."""
import numpy as np
from scree_program import Checks, Program

program, checks = Program(), Checks("initial fields from another run")
RHO_S, DEPTH = 2500.0, 0.01
FIELDS = ["solids_fraction", "velocity_x_face", "velocity_y_face", "granular_temperature", "frictional_pressure_ratio"]
GRIDS = {"finer": "16, 50", "coarser": "4, 10", "other": "7, 33"}


def halved(a, axis):
    """Sums of two neighbours along an axis."""
    return np.add.reduceat(a, np.arange(0, a.shape[axis], 2), axis=axis)


def mass(fields):
    return RHO_S * DEPTH * (np.outer(np.diff(fields["y_faces"]), np.diff(fields["x_faces"])) * fields["solids_fraction"]).sum()


settled = program.run("other_grid.yaml", "settled")
source = settled.fields
start = lambda name, options=None, **more: program.run(
    "other_grid_start.yaml", name, {"initial_settled_run": settled.directory, **(options or {})}, **more)

same = start("same").fields
for name in FIELDS:
    scale = np.abs(source[name]).max()
    checks.below(f"same grid: {name}, greatest difference, relative", np.abs(same[name] - source[name]).max() / scale, 1e-14)

for name, cells in GRIDS.items():
    fields = start(name, {"grid_cells": cells}).fields
    checks.close(f"{name} grid: mass [kg]", mass(fields), mass(source), relative=1e-14)
    nu = fields["solids_fraction"]
    checks.below(f"{name} grid: greatest nu, over that before", nu.max() / source["solids_fraction"].max(), 1 + 1e-14)
    checks.above(f"{name} grid: least nu, less that before, or than none", nu.min() - min(0, source["solids_fraction"].min()), 0)
    checks.below(f"{name} grid: greatest speed, over that before",
                 np.abs(fields["velocity_y_face"]).max() / np.abs(source["velocity_y_face"]).max(), 1 + 1e-14)
    checks.equal(f"{name} grid: walls at rest", float(np.abs(fields["velocity_x_face"][:, [0, -1]]).max()), 0.0)

twice = start("twice", {"grid_cells": "16, 40"}).fields
four = lambda a: halved(halved(a, 0), 1)
checks.below("cells halved: four of nu against the one they come from", np.abs(four(twice["solids_fraction"]) / 4 - source["solids_fraction"]).max(), 1e-15)

# Cells of the coarse grid are four of the fine one: nu is their mean, T that by particles, and v on a face that by those
# about the two faces in it.
coarse, nu = start("means", {"grid_cells": "4, 10"}).fields, source["solids_fraction"]
expected = four(nu) / 4
checks.below("coarser grid: nu of a cell against the mean of four", np.abs(coarse["solids_fraction"] - expected).max(), 1e-15)
T = source["granular_temperature"]
full = expected > 1e-3
error = np.abs(coarse["granular_temperature"][full] / (four(nu * T)[full] / four(nu)[full]) - 1)
checks.below("coarser grid: T of a cell against the mean over the particles, relative", error.max(), 1e-6)
weight = np.add(np.pad(nu, ((1, 0), (0, 0))), np.pad(nu, ((0, 1), (0, 0))))[::2]
v = source["velocity_y_face"][::2]
mean = halved(weight * v, 1) / np.maximum(halved(weight, 1), 1e-30)
inner = (halved(weight, 1) > 1e-3)[1:-1]
checks.below("coarser grid: v of a face against the mean over the particles [m/s]",
             np.abs(coarse["velocity_y_face"] - mean)[1:-1][inner].max(), 1e-9)

# With gas: what the other run has not starts as usual, and the run goes on.
gas = start("gas", {"gas": "incompressible", "grid_cells": "16, 40", "end_time": 0.002})
checks.true("with gas: the log names what is missing", "has no gas_velocity_x, gas_velocity_y, gas_pressure" in gas.log, gas.log)
checks.close("with gas: mass at the start [kg]", mass(gas.first_fields), mass(source), relative=1e-14)
checks.below("with gas: mass error", np.abs(gas.monitor["mass_error"]).max(), 1e-12)
checks.below("with gas: gas volume error", np.abs(gas.monitor["gas_volume_error"]).max(), 1e-12)

# Whatever the ranks of either run.
three = start("three", {"grid_cells": "7, 33"}, ranks=3).fields
one = start("one", {"grid_cells": "7, 33"}, ranks=1).fields
for name in FIELDS:
    checks.equal(f"3 ranks against 1: {name}, bit for bit", bool(np.array_equal(three[name], one[name])), True)

# A part of the box, and what the region says itself.
part = start("part", {"initial_settled_box": "0, 2 cm, 0, 5 cm", "initial_settled_velocity": "0, 0"}).fields
checks.below("part: nu in it", np.abs(part["solids_fraction"][:10, :4] - nu[:10, :4]).max(), 1e-15)
checks.equal("part: nu beyond it", float(part["solids_fraction"][10:].max() + part["solids_fraction"][:, 4:].max()), 0.0)
checks.equal("part: a velocity that is given", float(np.abs(part["velocity_y_face"]).max()), 0.0)

for name, options, expected in [
    ("no run", {"initial_settled_run": program.work}, "the output directory of a run of Scree; no checkpoint"),
    ("wider box", {"extent": "5 cm, 10 cm"}, "a run whose box holds the region, which has x from 0 to 0.05 m; that one has x from 0 to 0.04 m"),
    ("dimension", {"dimension": 1, "extent": "4 cm", "grid_cells": 8, "gravity": 0}, None),
    ("packing", {"solids_fraction_max": 0.53, "friction_solids_fraction_min": 0.5}, "a run with solids fractions below solids_fraction_max = 0.53"),
    ("off the grid", {"initial_settled_box": "0, 2.1 cm, 0, 5 cm"}, None),
]:
    for more in ({}, {"check": None}):
        if name == "packing" and more:
            continue  # -check looks at the grid alone
        run = start("wrong", {**options, **more}, must_work=False)
        lines = [line for line in run.errors.split("\n") if line.startswith("scree: ")]
        line = lines[0] if len(lines) == 1 else run.errors
        checks.equal(f"{name} {more}: exit code", run.code, 1)
        if expected:
            checks.true(f"{name} {more}: the error names the key", "initial_settled_run" in line and expected in line, line)
checks.verdict()
