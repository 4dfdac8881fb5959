"""The guide: its blocks of YAML are the files of cases/guide, all of them run, and its tables name what runs leave."""
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

from scree_program import Checks, Program

program = Program()
checks = Checks("cases/GUIDE.md")
ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"
GUIDE = (CASES / "GUIDE.md").read_text()

# ---- the blocks of YAML ----


def blocks(text):
    """(file, text) of the blocks that a page shows from a file."""
    return re.findall(r"<!-- file: (\S+) -->\n```yaml\n(.*?\n)```", text, re.S)


shown = {f"cases/{name}": block for name, block in blocks(GUIDE)}
steps = sorted((CASES / "guide").glob("*.yaml"))
checks.equal("files of cases/guide on the page", sorted(shown), [str(path.relative_to(ROOT)) for path in steps])
readme = blocks((ROOT / "README.md").read_text())
checks.equal("blocks of YAML in README.md", len(readme), 1)
for name, block in [*shown.items(), *readme]:
    checks.true(f"block of {name} is the file", (ROOT / name).read_text() == block, "another text")
checks.equal("blocks of YAML without a file", GUIDE.count("```yaml"), len(shown))

# ---- the runs ----

runs = {path.stem: program.run(path, path.stem) for path in steps}
for name, run in runs.items():
    checks.equal(f"{name}: end", run.summary["end"], "end_time")
    checks.equal(f"{name}: keys that are not used", re.findall(r"\S+ is not used", run.log), [])
    checks.below(f"{name}: mass error", abs(run.summary["quantities"]["mass_error"]), 1e-12)
    checks.below(f"{name}: greatest solids fraction", run.summary["quantities"]["solids_fraction_max"], 0.65)


def column(name, what):
    return runs[name].monitor[what]


fall = column("step1", "bed_height")[0] - column("step1", "bed_height")[-1]
checks.close("step1: the grains have come down by 2 cm at the least [m]", fall, 0.022, absolute=0.004)
for name in ("step3", "step4"):
    time, mass = column(name, "time"), column(name, "mass")
    flow = column(name, "discharge_rate" if name == "step3" else "flux_orifice")
    checks.true(f"{name}: grains flow out", np.all(flow[time > 0.1] > 0))
    checks.true(f"{name}: the mass falls", mass[-1] < mass[0])
for name in ("step3", "step4"):  # 25 cm x 8 cm x 1 cm at 0.6 of 2500 kg/m3
    checks.close(f"{name}: mass at the start [kg]", column(name, "mass")[0], 0.3, relative=1e-9)
checks.true("step5: air above the orifice is thinned or squeezed", np.ptp(column("step5", "above_gas_pressure")) > 1)
checks.true("step6: the bed rises", column("step6", "bed_height")[-1] > column("step6", "bed_height")[0])

# ---- the plots ----

PLOT = ROOT / "scripts" / "plot_guide.py"
for name, more in (("step1", []), ("step5", ["--field", "gas_pressure"])):
    drawn = subprocess.run([sys.executable, PLOT, runs[name].directory, *more], capture_output=True, text=True)
    checks.equal(f"{name}: exit code of plot_guide.py", drawn.returncode, 0)
    picture = runs[name].directory / "plots" / "fields.png"
    checks.true(f"{name}: its picture", picture.exists() and picture.stat().st_size > 10000, drawn.stderr)

# ---- the tables ----


def named(table):
    """The names in the first column of a table of the guide."""
    body = re.search(rf"<!-- checked: {table} -->\n(.*?)<!-- end -->", GUIDE, re.S)[1]
    first = [row.split("|")[1] for row in body.splitlines() if row.startswith("| `")]
    return [name for cell in first for name in re.findall(r"`([^`]+)`", cell)]


def compare(what, names, found):
    """Each thing found has its name in the table, each name stands for something found."""
    patterns = {name: re.compile(name.replace("PROBE_FIELD", "above_FIELD").replace("FIELD", r"[a-z_]+")
                                 .replace("NAME", "orifice").replace("WALL", r"(boundary|plate)_[a-z_]+")) for name in names}
    unnamed = sorted(thing for thing in found if not any(p.fullmatch(thing) for p in patterns.values()))
    absent = [name for name, pattern in patterns.items() if not any(map(pattern.fullmatch, found))]
    checks.equal(f"{what}: not in the table", unnamed, [])
    checks.equal(f"{what}: in the table alone", absent, [])


# What the further scenes leave, by two short runs.
walls = program.run(CASES / "guide" / "step3.yaml", "walls", {"output_wall_stress": "yes", "output_average_from": 0, "end_time": 0.01})
driven = program.run(ROOT / "tests" / "verification" / "driven_bed.yaml", "driven", {"end_time": 0.01})
columns = set().union(*(run.monitor for run in [*runs.values(), walls, driven]))
compare("monitor.csv", [name for name in named("monitor") if not name.endswith("_z")], columns)
of_wall = set(np.genfromtxt(walls.directory / "walls" / "plate_floor_000001.csv", delimiter=",", names=True).dtype.names)
compare("walls", [name for name in named("walls") if not re.search("_z$|^z$", name)], of_wall)
datasets = set().union(*(run.fields for run in runs.values())) - {"time"}
plane = [name for name in named("datasets") if not re.search(r"\bz_|_z_", name)]  # no step has three dimensions
compare("fields", plane, datasets)
compare("summary.json", named("summary"), set().union(*(run.summary for run in runs.values())))
checks.verdict()
