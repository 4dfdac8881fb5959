"""What scripts/speed_against_error.py makes of runs: on rows made up with a known value, order and cost."""
import csv
import math
import tempfile
from pathlib import Path

import numpy as np
from scree_program import Checks  # finds scripts/ too
from scree import work_precision, work_precision_tables
import speed_against_error
from scree.work_precision import Row, Setting

EXACT, PROFILE = 100.0, 0.6 - 0.1 * np.exp(-np.linspace(0, 3, 31))
SIZES = {"4 mm": 0.4, "2 mm": 0.2, "1 mm": 0.1}
ORDERS = {"upwind": 0.8, "van_albada": 1.5}
AT_2_MM = {"upwind": 0.16, "van_albada": 0.05}  # relative errors


def row(grid, advection="upwind", accuracy=1e-1, time_error=0.0, cpu_s=None, **more):
    """A run with an error of its grid, and one of time that does not depend on it."""
    error = AT_2_MM[advection] * (SIZES[grid] / 0.2) ** ORDERS[advection] + time_error
    values = {"rate": np.array([EXACT * (1 + error)]), "profile": PROFILE * (1 + error)}
    return Row(Setting(grid, advection, accuracy=accuracy, **more), SIZES[grid],
               {"cpu_s": cpu_s or 0.8 / SIZES[grid] ** 2 * (1.5 if advection == "van_albada" else 1)}, values)


checks = Checks("analysis of speed against error, made-up runs")
usual = Setting("2 mm")

# Extrapolation.
rows = [row(grid, advection) for advection in ORDERS for grid in SIZES]
references = work_precision.add_errors(rows, usual)
for name, exact in (("rate", np.array([EXACT])), ("profile", PROFILE)):
    checks.close(f"{name}: order of the better scheme", references[name].order, 1.5, absolute=1e-6)
    checks.below(f"{name}: extrapolated value", work_precision.relative(references[name].value, exact), 1e-9)
found = {(r.setting.grid, r.setting.advection): r.error("total", "rate") for r in rows}
checks.close("error of upwind, 2 mm", found["2 mm", "upwind"], 0.16, absolute=1e-9)
checks.close("error of van_albada, 1 mm", found["1 mm", "van_albada"], 0.05 / 2**1.5, absolute=1e-9)
correction = 0.05 / 2**1.5
checks.close("uncertainty: part of the correction", references["rate"].doubt, work_precision.CORRECTION_DOUBT * correction,
             relative=1e-6)
sizes = [0.1, 0.17, 0.4]  # no common factor
order, regular = work_precision.observed_order(sizes, [np.array([1 + h**1.2]) for h in sizes])
checks.close("order on sizes without a common factor", order, 1.2, absolute=1e-6)
checks.true("it is regular", regular)
checks.equal("order 3 is clipped", work_precision.observed_order(sizes, [np.array([h**3]) for h in sizes]), (2.0, True))
swing = [np.array([value]) for value in (1.0, 2.0, 1.0)]
checks.equal("a value that swings has no order", work_precision.observed_order(sizes, swing)[1], False)

# Two families of grids: the one with the smallest cells is extrapolated, alone, unless a family of three grids contradicts.
def graded_rows(exact, sizes, slope):
    return [Row(Setting(f"{size} graded"), size, {"cpu_s": 1.0},
                {"rate": np.array([exact * (1 + slope * size)]), "profile": PROFILE}, "graded") for size in sizes]


uniform = [row(grid) for grid in SIZES]  # upwind alone: its correction leaves it uncertain
alone = work_precision.add_errors(uniform, usual)["rate"]
reference = work_precision.add_errors(uniform + graded_rows(99, (0.08, 0.04, 0.02), 0.3), usual)["rate"]
checks.close("families: that of the smallest cells", float(reference.value[0]), 99, relative=1e-6)
reference = work_precision.add_errors(uniform + graded_rows(99, (0.04, 0.02), 0.3), usual)["rate"]
checks.close("families: two grids stand back behind three", float(reference.value[0]), EXACT, relative=1e-6)
reference = work_precision.add_errors(uniform + graded_rows(60, (0.08, 0.04, 0.02), 0.003), usual)["rate"]
checks.close("families: one whose cells are all larger contradicts none", float(reference.value[0]), 60, relative=1e-6)
reference = work_precision.add_errors(uniform + graded_rows(60, (0.16, 0.08, 0.04), 0.003), usual)["rate"]
checks.close("families that contradict each other: their mean", float(reference.value[0]), 80, relative=1e-6)
checks.close("families that contradict each other: half the distance and the doubt of the worse",
             reference.doubt * float(reference.value[0]), 20 + alone.doubt * float(alone.value[0]), relative=1e-6)

# Irregular orders: the mean of the schemes.
swinging = [row(grid, advection) for advection in ORDERS for grid in SIZES]
for one, value in zip(swinging, (100, 104, 101, 102, 97, 99)):
    one.values = {"rate": np.array([float(value)])}
reference = work_precision.add_errors(swinging, usual)["rate"]
checks.close("irregular: mean of the extrapolations 98 and 101", float(reference.value[0]), 99.5, absolute=1e-9)
checks.close("irregular: half of their distance", reference.doubt * 99.5, 1.5, absolute=1e-9)

# Order 3, clipped to 2: doubtful by the distance to order 1.
cubic = [row(grid) for grid in SIZES]
for one, value in zip(cubic, (100 + 64, 100 + 8, 100 + 1)):
    one.values = {"rate": np.array([float(value)])}
reference = work_precision.add_errors(cubic, usual)["rate"]
checks.close("clipped order: value", float(reference.value[0]), 101 - 7 / 3, absolute=1e-9)
checks.close("clipped order: uncertainty", reference.doubt * float(reference.value[0]), 7 - 7 / 3, absolute=1e-9)

# Smallest cells.
checks.close("smallest cell: equal ones", speed_against_error.first_or_last(6, 3, 1), 2, absolute=1e-12)
checks.close("smallest cell: 1, 2, 4", speed_against_error.first_or_last(7, 3, 4), 1, absolute=1e-12)
checks.close("smallest cell: 4, 2, 1", speed_against_error.first_or_last(7, 3, 0.25), 1, absolute=1e-12)

# Time, models.
rows += [row("2 mm", accuracy=3e-1, time_error=0.03), row("2 mm", accuracy=1e-2, time_error=-0.001, cpu_s=90.0),
         row("2 mm", accuracy=1e-2, time_error=-0.002, cpu_s=80.0, time_scheme="bdf")]
simple = row("2 mm", friction_model="critical_state", time_error=0.02, cpu_s=10.0)
with_gas = row("2 mm", gas="incompressible", time_error=0.01, cpu_s=60.0)
work_precision.add_errors(rows + [simple, with_gas], usual)
loose = next(r for r in rows if r.setting.accuracy == 3e-1)
checks.close("error of time against the scheme of higher order", loose.error("time", "rate"), 0.032 / 1.158, relative=1e-9)
checks.close("its uncertainty: distance of the schemes", loose.doubt("time", "rate"), 0.001 / 1.158, relative=1e-9)
checks.close("error of the simpler model", simple.error("model", "rate"), 0.02 / 1.16, relative=1e-9)
checks.true("a simpler model has no error of grid", math.isnan(simple.error("total", "rate")))
plain = next(r for r in rows if r.setting == usual)
checks.close("without gas against with gas", plain.error("model", "rate"), 0.01 / 1.17, relative=1e-9)

# Choice.
names = ["rate", "profile"]
ten, three, one, least = work_precision_tables.choices(rows, names)
checks.equal("10 %: cheapest", (ten.row.setting.grid, ten.row.setting.advection), ("2 mm", "van_albada"))
checks.equal("3 %: cheapest", (three.row.setting.grid, three.row.setting.advection), ("1 mm", "van_albada"))
checks.true("3 % is reached", three.reached)
checks.true("1 % is not reached: the nearest", not one.reached and one.row is three.row)
checks.true("neither is 0.3 %", not least.reached and least.row is three.row)

# Files.
page = work_precision_tables.choice_text("made up", rows + [simple, with_gas], references, usual)
checks.true("choice.md names the simpler model", "critical_state" in page)
with tempfile.TemporaryDirectory() as directory:
    path = Path(directory) / "runs.csv"
    work_precision_tables.write_csv(path, "made up", rows, {"rate": "g/s"}, usual)
    table = list(csv.DictReader(path.open()))
checks.equal("runs.csv: rows", len(table), len(rows))
checks.close("runs.csv: error of the usual run [%]", float(table[0]["error_total rate [%]"]),
             100 * rows[0].error("total", "rate"), relative=1e-4)
checks.verdict()
