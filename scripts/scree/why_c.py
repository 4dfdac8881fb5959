"""Why the paper's bin flows 1.6 times as fast as experiments: the model changed step by step.

    scripts/why_c.py [--work out/why_c] [--jobs N] [--only NAME,...] [--dry-run]
    scripts/why_c.py --slice        # beside discrete elements, see scree/paper_slice.py

Runs the 1 mm bin with each model of `STEPS` on three grids, with orifices of several widths, and with other diameters
in one term at a time. What is there already is not run again. Writes into cases/why_c: rates.csv, a row a run, the
figures, and the tables of README.md. --budget leaves out the finest grid, which takes four fifths of the time."""
import argparse
import csv
import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from scree import output, page_tables, paper_slice, plots, program, sweeps, work_precision
from scree.bin_discharge import Run
from scree.page_tables import markdown
from scree.plots import plt

ROOT = Path(__file__).resolve().parents[2]
BIN = ROOT / "cases" / "bin_discharge"
PAGE = ROOT / "cases" / "why_c"
WINDOW = (0.3, 0.5)  # [s], over which rates are means: after the start-up, while the finest grid can be afforded
GRAVITY, DENSITY, PACKING = 981.0, 2.9, 0.60  # [cm/s2], [g/cm3], solids fraction of the fill
SHOULDER = 0.1  # of the plug's speed: what moves more slowly belongs to the shoulder
PLUG_HEIGHT = 50.0  # above the floor [cm], where the bed moves as one

ROUGH = {"plate_floor_kind": "wall_no_slip"}
USUAL_WIDTH = 1.4  # of the orifice [cm]


def floor(rate):
    """The options of friction without T/d^2, with a floor under the strain rate [1/s]."""
    return {"friction_fluctuation": 0, "friction_strain_rate_floor": rate}


@dataclass(frozen=True)
class Step:
    """One model: its name in rates.csv, what the page says of it, its options, and the case that they are changes of."""

    name: str
    words: str
    options: dict = field(default_factory=dict)
    case: str = "case.yaml"


STEPS = (
    Step("paper", "the paper's model"),
    Step("upwind", "first-order advection", {"advection": "upwind"}),
    Step("dissipation", "friction in collisions, 0.3", {"particle_friction": 0.3}),
    Step("rough", "paper's model, rough floor", ROUGH),
    Step("floor_50", "a floor of 50 1/s for T/d^2", floor(50)),
    Step("floor_10", "a floor of 10 1/s", floor(10)),
    Step("floor_1", "a floor of 1 1/s", floor(1)),
    Step("floor_0.01", "a floor of 0.01 1/s", floor(0.01)),
    Step("best", "best.yaml: 0.01 1/s, rough floor", case="best.yaml"),
    Step("best_rough_walls", "rough walls as well", {"boundary_wall_kind": "wall_no_slip"}, case="best.yaml"),
    Step("best_dissipation", "friction in collisions as well", {"particle_friction": 0.3}, case="best.yaml"),
    Step("best_mu_i", "M(I), well-posed", {"friction_coefficient": "cidr"}, case="best.yaml"),
    Step("fluidity", "nonlocal friction, rough floor", {"friction_coefficient": "fluidity", **ROUGH}),
)

#: Grids by name: cells against case.yaml, and the options. The coarse one has each pair of cells of case.yaml as one.
GRIDS = {
    "half": {"grid_x_cells": "5, 7", "grid_x_ratio": "0.0572, 70.2", "grid_y_cells": "8, 20, 25",
             "grid_y_ratio": "0.0379, 23.0, 3.89"},
    "case": {},
    "double": {"grid_refine": 2},
}
WIDTHS = (1.0, 1.4, 1.8, 2.4)  # of the orifice [cm]
WIDTH_MODELS = ("paper", "best")
#: 0.1 mm particles: T/d^2 of friction has the d of the particles, that of 1 mm particles, or is left out.
DIAMETER = 0.1  # [mm]
DIAMETERS = {
    "fine": ("0.1 mm in all terms", {}),
    "fine_friction_1mm": ("0.1 mm, but 1 mm in the T/d^2 of friction", {"friction_fluctuation": DIAMETER**2}),
    "fine_floor": ("0.1 mm, friction without T/d^2, floor of 1 1/s", floor(1)),
}


@dataclass(frozen=True)
class Job:
    """A run: the model, the grid, the width of the orifice [cm], the diameter [mm], the case and options against it."""

    model: str
    grid: str
    width: float
    diameter: float
    options: dict
    case: str = "case.yaml"

    @property
    def label(self):
        return f"{self.model}_{self.grid}_{self.width:g}cm"

    def point(self, work):
        options = {"end_time": WINDOW[1], "output_interval": 0.1, **self.options}
        found = sweeps.Point(BIN / self.case, program.default_program(), 1, work, {}, options)
        found.name, found.directory = self.label, work / self.label
        return found


def jobs():
    """All runs, the cheap ones first."""
    found = [Job(step.name, grid, USUAL_WIDTH, 1.0, {**step.options, **options}, step.case)
             for grid, options in GRIDS.items() for step in STEPS]
    found += [Job(step.name, "case", width, 1.0, {**step.options, "orifice_width": f"{width} cm"}, step.case)
              for step in STEPS if step.name in WIDTH_MODELS for width in WIDTHS if width != USUAL_WIDTH]
    found += [Job(name, "case", USUAL_WIDTH, DIAMETER, {**options, "particle_diameter": f"{DIAMETER} mm"})
              for name, (_, options) in DIAMETERS.items()]
    return sorted(found, key=lambda job: job.grid == "double")


# ---- what is measured ----


def slot_law(width, diameter=0.1, k=1.4):
    """Rate of a slot 1 cm long [g/s], width and diameter in cm: Nedderman (1992), 1.03 rho_b sqrt(g) (D - k d)^1.5."""
    return 1.03 * DENSITY * PACKING * math.sqrt(GRAVITY) * (width - k * diameter) ** 1.5


def coefficient(rate, width):
    """C of (28) for a slot 1 cm long: rate = C rho_s nu sqrt(g) D^1.5."""
    return rate / (DENSITY * PACKING * math.sqrt(GRAVITY) * width**1.5)


class Measured:
    """The numbers of one run, all lengths in cm."""

    def __init__(self, directory):
        run = Run(directory)
        self.run = run
        self.rate = run.mean_rate(WINDOW)
        self.nu = run.in_orifice_plane(run.nu)
        self.speed = np.hypot(run.velocity[..., 0], run.velocity[..., 1])
        self.plug = self.speed[np.argmin(abs(run.y - PLUG_HEIGHT))].mean()
        self.corner = self.at(run.x.max(), 0.0) / self.plug
        self.summary = output.summary(directory)

    def at(self, x, y):
        """Speed in the cell nearest to x in the first row above y."""
        row = int(np.argmax(self.run.y > y))
        return self.speed[row, np.argmin(abs(self.run.x - x))]

    def shoulder_height(self):
        """Height at the wall below which the particles are slower than SHOULDER times the plug."""
        above = self.run.y > 0
        wall = self.speed[above, -1] / self.plug
        moving = np.flatnonzero(wall > SHOULDER)
        return float(self.run.y_faces[:-1][above][moving[0]]) if moving.size else float("nan")

    def shoulder_line(self):
        """x, y of the points where the speed passes SHOULDER times the plug's, along the rows above the floor."""
        points = []
        for y, row in zip(self.run.y, self.speed / self.plug):
            slow = np.flatnonzero(row < SHOULDER)
            if 0 < y < 20 and slow.size and slow[0] > 0:
                pair = slice(slow[0] - 1, slow[0] + 1)  # between the centres of these cells, by interpolation
                points.append((np.interp(-SHOULDER, -row[pair], self.run.x[pair]), y))
        return np.array(points)

    def shoulder_angle(self):
        """Of that line against the floor, from its lowest point to its highest [deg]."""
        line = self.shoulder_line()
        if len(line) < 2 or line[-1, 0] == line[0, 0]:
            return float("nan")
        return math.degrees(math.atan2(line[-1, 1] - line[0, 1], line[-1, 0] - line[0, 0]))


def row(job, point):
    state = point.state()
    found = {"model": job.model, "grid": job.grid, "orifice [cm]": job.width, "d [mm]": job.diameter, "status": state}
    if state != "done":
        return {**found, "reason": point.record()["reason"] if point.record() else ""}
    measured = Measured(point.directory)
    return {
        **found,
        "rate [g/s]": f"{measured.rate:.2f}",
        "C": f"{coefficient(measured.rate, job.width):.3f}",
        "rate / slot law": f"{measured.rate / slot_law(job.width, job.diameter / 10):.3f}",
        "nu in the orifice": f"{measured.nu:.3f}",
        "corner / plug": f"{measured.corner:.2e}",
        "shoulder height [cm]": f"{measured.shoulder_height():.2f}",
        "shoulder angle [deg]": f"{measured.shoulder_angle():.0f}",
        "newton": int(measured.summary["newton_iterations"]),
        "steps": int(measured.summary["steps"]),
        "cpu [s]": f"{measured.summary['cpu_seconds']['total']:.0f}",
    }


def write(points, file):
    rows = [row(job, point) for job, point in points if point.state() != "missing"]
    columns = list(dict.fromkeys(name for r in rows for name in r))
    with open(file, "w", newline="") as stream:
        table = csv.DictWriter(stream, columns, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    return rows


def done(rows, **where):
    """The rows of the runs that reached their end and have these columns."""
    return [r for r in rows if r["status"] == "done" and all(r[name] == value for name, value in where.items())]


def usual(rows, grid):
    """Model -> its row on a grid, with the orifice of case.yaml."""
    return {r["model"]: r for r in done(rows, grid=grid) if r["orifice [cm]"] == USUAL_WIDTH}


def rates_by_width(rows, model):
    """Width [cm], rate [g/s] of a model on the grid of case.yaml: n x 2, by width."""
    return np.array(sorted((r["orifice [cm]"], float(r["rate [g/s]"])) for r in done(rows, model=model, grid="case")))


def width_law(rows, model):
    """p of rate ~ D^p, and the k of rate ~ (D - k d)^1.5, by least squares; k in diameters of 1 mm."""
    found = rates_by_width(rows, model)
    if len(found) < 2:
        return math.nan, math.nan
    width, rate = found.T
    exponent = np.polyfit(np.log(width), np.log(rate), 1)[0]
    slope, intercept = np.polyfit(width, rate ** (2 / 3), 1)
    return exponent, -intercept / slope / 0.1


# ---- the tables of the page ----

SHOWN = ("rate [g/s]", "C", "rate / slot law", "nu in the orifice", "corner / plug", "shoulder height [cm]", "newton", "cpu [s]")


def rate_without_cells(rates):
    """Richardson's rate at cells of no size, from those on the three grids, texts; empty where their differences are not
    regular."""
    if "" in rates:
        return ""
    values, sizes = [np.array(float(rate)) for rate in reversed(rates)], (1, 2, 4)
    order, regular = work_precision.observed_order(sizes, values)
    return f"{work_precision.extrapolated(sizes, values, order):.1f}" if regular else ""


def steps_table(rows):
    """A line a model on the grid of case.yaml, with its rates on the other grids and what they tend to."""
    by_grid = {grid: usual(rows, grid) for grid in GRIDS}
    lines = []
    for step in STEPS:
        if step.name in by_grid["case"]:
            rates = [found[step.name]["rate [g/s]"] if step.name in found else "" for found in by_grid.values()]
            lines.append([step.words, *rates, rate_without_cells(rates),
                          *(str(by_grid["case"][step.name][name]) for name in SHOWN[1:])])
    grids = ("half the cells", "`case.yaml`", "twice the cells", "extrapolated")
    head = ["model", *(f"rate [g/s], {cells}" for cells in grids), *SHOWN[1:]]
    return markdown(head, lines)


def widths_table(rows):
    head = ["width [cm]", *(f"{model}: rate [g/s]" for model in WIDTH_MODELS), "slot law [g/s]"]
    found = {model: dict(rates_by_width(rows, model)) for model in WIDTH_MODELS}
    lines = [[f"{width:g}", *(f"{found[model][width]:.2f}" if width in found[model] else "" for model in WIDTH_MODELS),
              f"{slot_law(width):.1f}"] for width in WIDTHS]
    laws = [width_law(rows, model) for model in WIDTH_MODELS]
    lines.append(["exponent of the width", *(f"{exponent:.2f}" for exponent, _ in laws), ""])
    lines.append(["k of (D - k d)^1.5", *(f"{k:.1f}" for _, k in laws), "1.4"])
    return markdown(head, lines)


def diameters_table(rows):
    lines = [[words, *(str(r[name]) for name in SHOWN[:2])] for name, (words, _) in DIAMETERS.items()
             for r in done(rows, model=name)]
    one = usual(rows, "case")
    for name, words in (("paper", "1 mm in all terms"), ("floor_1", "1 mm, friction without T/d^2, floor of 1 1/s")):
        if name in one:
            lines.append([words, *(str(one[name][column]) for column in SHOWN[:2])])
    return markdown(["diameter", *SHOWN[:2]], lines)


# ---- figures ----


def draw_rates(rows):
    """Rate of each step on each grid, with the slot law."""
    figure, axes = plt.subplots(figsize=(7.2, 4.6))
    names = [step.name for step in STEPS]
    for number, grid in enumerate(GRIDS):
        found = {name: float(r["rate [g/s]"]) for name, r in usual(rows, grid).items()}
        shown = [n for n, name in enumerate(names) if name in found]
        axes.barh([n + 0.27 * (number - 1) for n in shown], [found[names[n]] for n in shown], 0.25, color=f"C{number}",
                  label={"half": "half the cells", "case": "graded grid", "double": "twice the cells"}[grid])
    axes.axvline(slot_law(USUAL_WIDTH), color="0.3", linestyle="--", linewidth=1.3, label="slot law")
    axes.set_yticks(range(len(names)), [step.words for step in STEPS])
    axes.invert_yaxis()
    axes.set_xlabel("discharge rate (g/s)")
    axes.legend(loc="lower right")
    return figure


def draw_widths(rows):
    """Rate against the width of the orifice, with the slot law."""
    figure, axes = plt.subplots(figsize=(5.6, 4.2))
    width = np.linspace(0.8, 2.6, 100)
    axes.plot(width, [slot_law(w) for w in width], color="0.3", linestyle="--", label="slot law")
    for model, words in (("paper", "paper's model"), ("best", "best.yaml")):
        found = rates_by_width(rows, model)
        if len(found):
            axes.plot(*found.T, "o-", label=words)
    axes.set(xlabel="width of the orifice (cm)", ylabel="discharge rate (g/s)", xscale="log", yscale="log")
    axes.set_xticks([1, 1.5, 2, 2.5], ["1", "1.5", "2", "2.5"])
    axes.set_xticks([], minor=True)
    axes.legend()
    return figure


def draw_shoulders(points):
    """Where the speed is SHOULDER times the plug's, for some models."""
    figure, axes = plt.subplots(figsize=(4.6, 4.8))
    words = {step.name: step.words for step in STEPS}
    for job, point in points:
        if job.grid == "case" and job.width == USUAL_WIDTH and point.state() == "done" and job.model in (
                "paper", "dissipation", "floor_0.01", "best", "best_rough_walls"):
            line = Measured(point.directory).shoulder_line()
            if len(line):
                axes.plot(*line.T, ".-", label=words[job.model], markersize=4)
    axes.set(xlabel="x (cm)", ylabel="height above the floor (cm)", xlim=(0, 4), ylim=(0, 4), aspect="equal")
    axes.legend(fontsize=8, loc="upper left")
    return figure


# ---- from the command line ----


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, default=Path("out/why_c"), help="directory of the runs")
    parser.add_argument("--jobs", type=int, default=program.cores(), help="runs at a time")
    parser.add_argument("--only", help="models to run, separated by commas")
    parser.add_argument("--budget", action="store_true", help="leave out the finest grid")
    parser.add_argument("--slice", action="store_true", help="the bin filled 10 cm high, beside discrete elements, alone")
    parser.add_argument("--dry-run", action="store_true", help="show the runs")
    given = parser.parse_args()
    program.check_program(program.default_program())
    if given.slice:
        paper_slice.main(given.work, given.jobs)
        return
    points = [(job, job.point(given.work)) for job in jobs() if not (given.budget and job.grid == "double")]
    only = given.only.split(",") if given.only else None
    missing = [point for job, point in points if point.state() == "missing" and (not only or job.model in only)]
    if given.dry_run:
        print("\n".join(point.name for point in missing))
        return
    PAGE.mkdir(parents=True, exist_ok=True)
    for number, point in enumerate(sweeps.run_all(missing, given.jobs), 1):
        print(f"[{number}/{len(missing)}] {point.name}: {point.record()['reason'] or 'done'}", flush=True)
    rows = write(points, PAGE / "rates.csv")
    plots.draw_to_files()
    for name, figure in (("rates", draw_rates(rows)), ("widths", draw_widths(rows)), ("shoulders", draw_shoulders(points))):
        figure.savefig(PAGE / f"{name}.png")
    page_tables.put(PAGE / "README.md",
                    {"steps": steps_table(rows), "widths": widths_table(rows), "diameters": diameters_table(rows)})


if __name__ == "__main__":
    main()
