"""scripts/paper: Figures 1 and 2 against values worked out by hand, Figures 4, 5 and 13 on coarse grids and short times
against stored numbers; --update writes paper_figures.json anew. And what the scripts do beside drawing: reuse, going
on, errors.

Tolerances of the stored numbers as in bin_discharge.py: room for another path of steps to the same solution, not for
another model or scheme. The void of the bubble is that of its first 0.1 s; without friction it is larger by 2.7 %."""
import csv
import json
import subprocess
import sys

import numpy as np
from closures import N_COMPACTION, N_DILATION, chi_star, critical_pressure
from scree_program import Checks, Program

program, checks = Program(), Checks("figures of the paper")
SCRIPTS = program.here.parents[1] / "scripts" / "paper"
OUT = program.work / "paper"
sys.path.insert(0, str(SCRIPTS))
import page_numbers  # noqa: E402
import paper_quantities  # noqa: E402
import paper_runs  # noqa: E402
import yield_locus  # noqa: E402

PICTURE_BYTES = 300_000
SIN_PHI = 0.4771587603  # sin 28.5 deg
APEX = 1.1119147187  # exp(.03 ln(1.03/.03))
TOLERANCE = 0.01


def script(name, *options, code=0):
    """Runs a script of scripts/paper; what it says."""
    words = [sys.executable, str(SCRIPTS / f"{name}.py"), "--out", str(OUT), "--program", program.scree, *options]
    process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=1200)
    checks.equal(f"{name} {' '.join(map(str, options))}: exit code", process.returncode, code)
    if process.returncode != code:
        print(process.stdout, process.stderr)
        checks.verdict()
    return process.stdout + process.stderr


def table(name):
    """The columns of a figure's data; text stays text."""
    rows = list(csv.DictReader((OUT / f"{name}.csv").open()))

    def column(values):
        try:
            return np.array(values, dtype=float)
        except ValueError:
            return np.array(values)

    return {key: column([row[key] for row in rows]) for key in rows[0]}


def picture(name):
    path = OUT / f"{name}.png"
    checks.true(f"{name}.png is a picture", path.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n")
    checks.below(f"{name}.png, bytes", path.stat().st_size, PICTURE_BYTES)


# ---- Figures 1 and 2 ----

script("figure_02")
picture("figure_02")
locus = table("figure_02")
chi, first, second = locus["chi"], locus["sigma_1/p_c"], locus["sigma_2/p_c"]
for branch, end in (("dilation", -1), ("compaction", 0)):
    here = locus["branch"] == branch
    checks.close(f"{branch}: sigma_1/p_c at the critical state", first[here][end], 1 + SIN_PHI, absolute=5e-6)
    checks.close(f"{branch}: sigma_2/p_c at the critical state", second[here][end], 1 - SIN_PHI, absolute=5e-6)
dilation, compaction = locus["branch"] == "dilation", locus["branch"] == "compaction"
checks.close("apex: chi", chi.max(), APEX, absolute=5e-6)
checks.close("apex: sigma_1/p_c", first[compaction][-1], APEX, absolute=5e-6)
checks.close("apex: sigma_2/p_c", second[compaction][-1], APEX, absolute=5e-6)
checks.above("nowhere tensile: least sigma_2/p_c", second.min(), 0)
# n sin(phi) = sqrt(3)/2 there
first_0, second_0 = yield_locus.principal_stresses(1e-12, N_DILATION)
checks.close("slope at the origin: 7 - 4 sqrt 3", second_0 / first_0, 7 - 4 * np.sqrt(3), relative=1e-9)
shear = (first - second) / 2
checks.close("greatest shear is that of the critical state", shear.max(), SIN_PHI, absolute=5e-6)
for n in (N_DILATION, N_COMPACTION):
    half_way = 0.5 ** (n - 1)  # chi^(1/(n-1)) = 1/2: the braces of (14) are (n+1)/2
    checks.close(f"n = {n:.3f}: shear where chi^(1/(n-1)) is 1/2", yield_locus.shear(half_way, n),
                 half_way * SIN_PHI * (n + 1) / 2, relative=1e-8)
# Normality, (13): d(shear)/d(chi) = div v/(sqrt2 strain rate), for the div v that has this chi* by (21).
for chi_there, n in ((0.3, N_DILATION), (0.8, N_DILATION), (1.05, N_COMPACTION), (1.1, N_COMPACTION)):
    h = 1e-6
    slope = (yield_locus.shear(chi_there + h, n) - yield_locus.shear(chi_there - h, n)) / (2 * h)
    checks.close(f"normal to the locus at chi = {chi_there}: chi* of that flow",
                 float(chi_star(np.sqrt(2) * slope, 1.0)), chi_there, absolute=1e-8)

script("figure_01")
picture("figure_01")
loci = table("figure_01")
for nu, p_c in ((0.6, 16000.0), (0.595, 8966.1)):
    cut = (loci["solids_fraction"] == nu) & (loci["chi"] == 1)
    checks.close(f"chi = 1, nu = {nu}: sigma_1 [dyn/cm2]", loci["sigma_1 [dyn/cm2]"][cut].max(), p_c * (1 + SIN_PHI),
                 relative=1e-5)
    checks.close(f"chi = 1, nu = {nu}: sigma_2 [dyn/cm2]", loci["sigma_2 [dyn/cm2]"][cut].min(), p_c * (1 - SIN_PHI),
                 relative=1e-5)
    checks.close(f"nu = {nu}: p_c as in the closures [dyn/cm2]", yield_locus.critical_pressure(nu),
                 10 * critical_pressure(nu), relative=1e-12)

# ---- Figures 4, 5 and 13, coarse and short ----

SHORT = ["--grid", "coarse", "--ranks", str(program.ranks)]
script("figure_04", *SHORT, "--end-time", "0.01")
said = script("figure_04", *SHORT, "--end-time", "0.02")
checks.equal("figure_04 with a later end: runs that go on", said.count("goes on from t = 0.01 s"), 3)
picture("figure_04")
said = script("figure_04", *SHORT, "--end-time", "0.02")
checks.true("figure_04 again: nothing is run", "CPU s" not in said and " to 0.02 s" not in said)
said = script("figure_04", *SHORT, "--end-time", "0.02", "--skip-done")
checks.true("figure_04 --skip-done: nothing is drawn", "is there" in said, said)
found = {}
rates = table("figure_04")
for label in dict.fromkeys(rates["run"]):
    run = rates["run"] == label
    rate = np.interp(0.02, rates["time [s]"][run], rates["rate [g/s]"][run])
    found[f"figure_04: rate at 0.02 s, {label} [g/s]"] = float(rate)

said = script("figure_05", *SHORT, "--end-time", "0.05")  # of the same run: it goes on, alone
checks.equal("figure_05 after figure_04: runs that go on", said.count("goes on from t = 0.02 s"), 1)
picture("figure_05")
found["figure_05: rate at 0.05 s [g/s]"] = paper_quantities.rate_at(0.05)(OUT / "runs" / "bin_coarse" / "out")

script("figure_13", *SHORT, "--end-time", "0.1")
picture("figure_13")
bubble = table("figure_13")
x, y = np.unique(bubble["x [cm]"]), np.unique(bubble["y [cm]"])
area = np.outer(np.gradient(y), np.gradient(x)).ravel() * 2  # of both halves
below = bubble["y [cm]"] < 30
for model in ("relaxed", "critical_state", "no_friction"):
    void = np.sum((area * np.maximum(0.58 - bubble[f"nu {model}"], 0))[below]) / 0.58
    found[f"figure_13: void at 0.1 s, {model} [cm2]"] = float(void)

file = program.here / "paper_figures.json"
if program.update:
    stored = {name: float(f"{value:.6g}") for name, value in found.items()}
    file.write_text(json.dumps(stored, indent=2, ensure_ascii=False) + "\n")
stored = json.loads(file.read_text())
checks.equal("stored numbers", sorted(stored), sorted(found))
for name, value in found.items():
    checks.close(name, value, stored[name], relative=TOLERANCE)

# ---- the page ----

numbers = page_numbers.Numbers(paper_quantities.Values(paper_runs.Runs(OUT), OUT), "coarse")
page, missing = page_numbers.filled(numbers, page_numbers.PAGE.read_text())
checks.true("cases/paper/README.md: a number for every place", "{{" not in page)
checks.true("what has not run is told", missing > 0)
checks.close("its rate at 0.05 s [g/s]", float(numbers.named("convergence.rate_at_0.05")),
             found["figure_05: rate at 0.05 s [g/s]"], absolute=0.051)
for path in sorted(page_numbers.PICTURES.glob("*.png")):
    checks.below(f"cases/paper/{path.name}, bytes", path.stat().st_size, PICTURE_BYTES)

# ---- errors ----

said = script("figure_05", "--grid", "coarse", "--only-draw", "--out", str(program.work / "empty"), code=1)
checks.equal("--only-draw without runs: one line", (said.count("\n"), "--only-draw" in said), (1, True))
said = script("figure_05", "--program", "/no/such/program", "--out", str(program.work / "empty"), code=1)
checks.equal("no program: one line", (said.count("\n"), "/no/such/program" in said), (1, True))
for options in (("--grid", "fine"), ("--end-time", "-1"), ("--ranks", "two")):
    said = script("figure_05", *options, code=2)
    checks.equal(f"{' '.join(options)}: one line", (said.count("\n"), options[1] in said), (1, True))
checks.verdict()
