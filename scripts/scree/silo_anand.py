"""Draws the discharge of the bin of Anand et al. (2008) beside discrete elements, and prints the numbers to compare.

    scripts/plot_silo_anand.py OUT_DIR ...          plots into the first OUT_DIR/plots
    scripts/plot_silo_anand.py --page [--work out/silo_anand_page] [--jobs N]

--page runs all models and grids of the page that are not there yet, and writes models.csv, the figures and the tables of
cases/silo_anand. The reference data lie in cases/silo_anand/reference; scripts/reference made them."""
import argparse
import csv
import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from matplotlib.colors import LogNorm

from scree import output, plots, program, slot_flow, sweeps
from scree.case_file import lengths
from scree.plots import plt

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "cases" / "silo_anand"
REFERENCE = PAGE / "reference"
WIDTH, ORIFICE, DEPTH, DIAMETER, DENSITY = 12.544, 2.5088, 0.56, 0.224, 2.5  # [cm], [g/cm3]
WINDOW = (0.15, 0.45)  # of the fields [s]
RATE_WINDOW = (0.07, 0.72)  # of the rate [s]: the slope of the mass there

UNIFORM = {"grid_finest": "2 mm", "grid_coarsest": "2.1 mm"}  # that a whole number fits into the slot
FINER = {"grid_finest": "0.25 mm"}


@dataclass(frozen=True)
class Model:
    """A run of the page: what it says of it, the case file, options against it."""

    name: str
    words: str
    case: str = "case.yaml"
    options: dict = field(default_factory=dict)


MODELS = (
    Model("recommended", "recommended model"),
    Model("recommended_2mm", "the same, cells of 2 mm", options=UNIFORM),
    Model("rolling", "grains that resist rolling", "rolling.yaml"),
    Model("rolling_2mm", "the same, cells of 2 mm", "rolling.yaml", UNIFORM),
    Model("paper", "paper's model", "paper.yaml"),
    Model("paper_2mm", "the same, cells of 2 mm", "paper.yaml", UNIFORM),
    Model("fluidity", "nonlocal friction", "fluidity.yaml"),
    Model("fluidity_2mm", "the same, cells of 2 mm", "fluidity.yaml", UNIFORM),
)
#: One parameter of the recommended model changed at a time.
CHANGES = (
    Model("finer", "cells of 0.25 mm at the lip", options=FINER),
    Model("smooth", "smooth floor", options={"plate_floor_kind": "wall_johnson_jackson"}),
    Model("angle", "angle of friction of 20.9 degrees, of grains of friction 0.3", options={"friction_angle": "20.9 deg"}),
    Model("collisions", "collisions without friction", options={"particle_friction": 0}),
    Model("cidr", "M(I), well-posed", options={"friction_coefficient": "cidr"}),
)


def point(model, work):
    found = sweeps.Point(PAGE / model.case, program.default_program(), 1, work, {}, model.options)
    found.name, found.directory = model.name, work / model.name
    return found


# ---- what is compared ----


def read_csv(path):
    """The columns of a file of reference data: name -> list of texts."""
    with open(path) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: [row[name] for row in rows] for name in rows[0]}


def reference_mass(name):
    """Time [s] and mass discharged [g] of a file of reference data."""
    columns = read_csv(REFERENCE / f"{name}.csv")
    return np.array(columns["time [s]"], float), np.array(columns["discharged [g]"], float)


def reference_flow(name="anand"):
    """The fields of discrete elements."""
    columns = {key: np.array(values, float) for key, values in read_csv(REFERENCE / f"fields_{name}.csv").items()}
    x, y = np.unique(columns["x [cm]"]), np.unique(columns["y [cm]"])
    fields = [columns[key].reshape(len(y), len(x)) for key in ("nu", "vx [cm/s]", "vy [cm/s]", "T [cm2/s2]")]
    return slot_flow.Flow(faces_of(x), faces_of(y), *fields)


def faces_of(middles):
    """Faces of equal cells from their centres, a multiple of the size."""
    size = (middles[-1] - middles[0]) / (len(middles) - 1)
    return size * np.arange(round(middles[0] / size - 0.5), round(middles[-1] / size + 0.5) + 1)


def reference_numbers(name="anand"):
    """The row of a run of discrete elements."""
    columns = read_csv(REFERENCE / "anand.csv")
    row = columns["run"].index(name)
    return {key: values[row] for key, values in columns.items()}


class Run:
    """An output directory, in cgs units, heights from the floor."""

    def __init__(self, directory):
        self.directory = Path(directory)
        case = output.case(directory)
        floor = 100 * lengths(case["plate_floor_position"])[0]
        monitor = output.monitor(directory)
        self.time = output.time_of(monitor)
        # Backward Euler: the rate of a row is that of the step that ends there.
        self.mass = np.cumsum(1e3 * monitor["flux_orifice"] * np.diff(self.time, prepend=self.time[0]))
        self.rate = self.rate_in(RATE_WINDOW)
        self.fill_nu = float(case["initial_fill_solids_fraction"])
        at = output.fields_near(directory, WINDOW[1])
        mean = "mean_" if "mean_velocity" in at else ""
        velocity = 100 * at[f"{mean}velocity"]
        self.flow = slot_flow.Flow(100 * at["x_faces"], 100 * at["y_faces"] - floor, at[f"{mean}solids_fraction"],
                                   velocity[..., 0], velocity[..., 1], 1e4 * at[f"{mean}granular_temperature"])
        self.plug = self.rate / (DENSITY * self.fill_nu * WIDTH * DEPTH)
        self.summary = output.summary(directory)

    def rate_in(self, window):
        """Slope of the mass within a window of time [g/s]."""
        return slot_flow.slope(self.time, self.mass, window)

    def on_reference(self):
        """The fields as means over the cells of the discrete elements."""
        reference = reference_flow()
        return self.flow.on(reference.x_faces, reference.y_faces)

    def row(self):
        """The numbers of the table, from fields on the cells of the discrete elements."""
        flow = self.on_reference()
        return {
            "rate [g/s]": f"{self.rate:.1f}",
            "C": f"{slot_flow.coefficient(self.rate / DEPTH, DENSITY, self.fill_nu, ORIFICE):.3f}",
            "corner / plug": f"{flow.corner() / self.plug:.1e}",
            "shoulder angle [deg]": f"{flow.line_angle(self.plug):.0f}",
            "shoulder at 2 cm [cm]": f"{flow.line_at(self.plug, 2.0):.2f}",
            "shoulder height at the wall [cm]": f"{flow.height_at_wall(self.plug):.1f}",
            "nu over the orifice": f"{flow.above_orifice(flow.nu):.3f}",
            "T over the orifice [cm2/s2]": f"{flow.above_orifice(flow.temperature):.0f}",
            "cpu [s]": f"{self.summary['cpu_seconds']['total']:.0f}",
        }


SHOWN = ("rate [g/s]", "C", "corner / plug", "shoulder angle [deg]", "shoulder at 2 cm [cm]",
         "shoulder height at the wall [cm]", "nu over the orifice", "T over the orifice [cm2/s2]", "cpu [s]")


def discrete_row(name="anand"):
    """The same numbers of discrete elements."""
    found = reference_numbers(name)
    return {key: found[key] for key in SHOWN}


def anand_rate():
    return slot_flow.slope(*reference_mass("anand_2008"), RATE_WINDOW)


# ---- figures ----


def draw_mass(runs):
    """Mass discharged against time. runs: label -> Run."""
    figure, axes = plt.subplots(figsize=(6.4, 4.6))
    axes.plot(*reference_mass("anand_2008"), "o", color="black", label="Anand et al. (2008)", zorder=4)
    axes.plot(*reference_mass("mass_anand"), color="0.4", linewidth=3, label="discrete elements")
    axes.plot(*reference_mass("mass_anand_soft_rolling"), color="0.4", linewidth=1.5, linestyle="--",
              label="the same with rolling friction")
    for label, run in runs.items():
        axes.plot(run.time, run.mass, label=label)
    axes.set(xlabel="time (s)", ylabel="discharged mass (g)", xlim=(0, 1.6), ylim=(0, 100))
    axes.legend(loc="lower right", fontsize=9)
    return figure


def draw_maps(runs):
    """Speed over the plug's, and the line where it is a tenth. runs: label -> Run."""
    numbers = reference_numbers()
    panels = {"discrete elements": (reference_flow(), float(numbers["plug [cm/s]"])),
              **{label: (run.flow, run.plug) for label, run in runs.items()}}
    figure, row = plt.subplots(1, len(panels), figsize=(3.3 * len(panels) + 0.8, 5.2), sharey=True, squeeze=False)
    for axes, (label, (flow, plug)) in zip(row[0], panels.items()):
        speed = np.ma.masked_where(flow.nu < 0.1, flow.speed / plug)
        image = axes.pcolormesh(flow.x_faces, flow.y_faces, speed, norm=LogNorm(1e-3, 10),
                                cmap="viridis")
        line = flow.line(plug)
        axes.plot(*line.T, color="white", linewidth=2)
        axes.plot([ORIFICE / 2, WIDTH / 2], [0, 0], color="black", linewidth=3)
        axes.set(xlabel="x (cm)", xlim=(0, WIDTH / 2), ylim=(-1, 10), aspect="equal")
        axes.set_title(label, loc="left", fontsize=11)
    row[0][0].set_ylabel("height above the floor (cm)")
    figure.colorbar(image, ax=row[0].tolist(), label="speed over the plug's (–)", shrink=0.8)
    return figure


def draw_lines(runs):
    """The lines where the speed is a tenth of the plug's, on the cells of the discrete elements."""
    figure, axes = plt.subplots(figsize=(5.2, 4.4))
    for name, label, look in (("anand", "discrete elements", dict(linewidth=3)),
                              ("anand_soft_rolling", "the same with rolling friction", dict(linewidth=1.5, linestyle="--"))):
        axes.plot(*reference_flow(name).line(float(reference_numbers(name)["plug [cm/s]"])).T, color="0.4", label=label, **look)
    for label, run in runs.items():
        axes.plot(*run.on_reference().line(run.plug).T, ".-", label=label)
    axes.set(xlabel="x (cm)", ylabel="height above the floor (cm)", xlim=(0, WIDTH / 2), ylim=(0, 8), aspect="equal")
    axes.legend(loc="upper left", fontsize=9)
    return figure


def draw_profiles(runs):
    """Solids fraction and granular temperature along the middle of the bin."""
    figure, panels = plt.subplots(2, sharex=True, figsize=(6.0, 6.0))
    reference = reference_flow()
    curves = {"discrete elements": reference, **{label: run.on_reference() for label, run in runs.items()}}
    for label, flow in curves.items():
        look = dict(color="0.4", linewidth=3) if flow is reference else {}
        for axes, values in zip(panels, (flow.nu, flow.temperature)):
            axes.plot(flow.y, values[:, 0], label=label, **look)
    panels[0].set(ylabel="solids fraction (–)", ylim=(0, 0.7))
    panels[1].set(xlabel="height above the floor (cm)", ylabel="granular temperature (cm²/s²)", yscale="log", xlim=(-1, 7))
    panels[0].legend(loc="lower center", fontsize=9)
    return figure


def figures(runs):
    return {"mass": draw_mass(runs), "speed": draw_maps(runs), "shoulders": draw_lines(runs), "axis": draw_profiles(runs)}


# ---- the page ----


def markdown(head, lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in (head, ["---"] * len(head), *lines))


def models_table(rows):
    """Anand's rate, discrete elements, and the models."""
    C = slot_flow.coefficient(anand_rate() / DEPTH, DENSITY, float(reference_numbers()["fill nu"]), ORIFICE)
    lines = [["Anand et al. (2008)", f"{anand_rate():.1f}", f"{C:.3f}", *[""] * (len(SHOWN) - 2)]]
    names = {"anand": "discrete elements", "anand_soft": "the same, softer by 4",
             "anand_soft_rolling": "the same, softer by 4, rolling friction"}
    lines += [[words, *(tidy(key, discrete_row(name)[key]) for key in SHOWN)] for name, words in names.items()]
    lines += [[words, *(tidy(key, rows[name][key]) for key in SHOWN)] for name, words in
              ((m.name, m.words) for m in MODELS) if name in rows]
    return markdown(["model", *SHOWN], lines)


def tidy(key, text):
    """The text of a number with the digits that the page shows."""
    digits = {"rate [g/s]": "{:.1f}", "shoulder angle [deg]": "{:.0f}", "shoulder height at the wall [cm]": "{:.1f}",
              "shoulder at 2 cm [cm]": "{:.1f}", "T over the orifice [cm2/s2]": "{:.0f}", "corner / plug": "{:.1e}"}
    return digits[key].format(float(text)) if key in digits and text else text


def changes_table(rows):
    shown = SHOWN[:-1]
    lines = [[m.words, *(rows[m.name][key] for key in shown)] for m in (MODELS[0], *CHANGES) if m.name in rows]
    return markdown(["change of one parameter", *shown], lines)


def discrete_table():
    columns = read_csv(REFERENCE / "anand.csv")
    shown = ("run", "stiffness [dyn/cm]", "rolling", "rate [g/s]", "corner / plug", "shoulder angle [deg]",
             "wedge angle [deg]", "remaining [g]", "greatest overlap / d", "mean greatest overlap / d")
    return markdown(list(shown), [list(line) for line in zip(*(columns[key] for key in shown))])


def fill_page(rows):
    """Puts the tables between their marks on the page."""
    text = (PAGE / "README.md").read_text()
    for name, table in (("models", models_table(rows)), ("changes", changes_table(rows)), ("discrete", discrete_table())):
        text = re.sub(rf"(<!-- generated: {name} -->\n).*?(<!-- end -->)", lambda match: f"{match[1]}{table}\n{match[2]}",
                      text, flags=re.S)
    (PAGE / "README.md").write_text(text)


def make_page(work, jobs):
    """Runs what is missing; writes models.csv, figures and tables."""
    program.check_program(program.default_program())
    points = [(model, point(model, work)) for model in (*MODELS, *CHANGES)]
    missing = [p for _, p in points if p.state() == "missing"]
    for number, p in enumerate(sweeps.run_all(missing, jobs), 1):
        print(f"[{number}/{len(missing)}] {p.name}: {p.record()['reason'] or 'done'}", flush=True)
    runs = [(model, Run(p.directory)) for model, p in points if p.state() == "done"]
    rows = {model.name: run.row() for model, run in runs}
    with open(PAGE / "models.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["run", *SHOWN])
        table.writerows([name, *row.values()] for name, row in rows.items())
    fill_page(rows)
    shown = {model.words: run for model, run in runs if model in MODELS and not model.options}
    for name, figure in figures(shown).items():
        figure.savefig(PAGE / f"{name}.png")


def report(run):
    print(f"{run.directory}:  (discrete elements in brackets, Anand et al. {anand_rate():.1f} g/s)")
    other = discrete_row()
    for name, value in run.row().items():
        print(f"  {name:34s} {value:>8s}   ({tidy(name, other[name])})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directories", nargs="*", metavar="OUT_DIR", help="output directory of a run")
    parser.add_argument("--page", action="store_true", help="all runs, figures and tables of the page")
    parser.add_argument("--work", type=Path, default=Path("out/silo_anand_page"), help="directory of the runs of --page")
    parser.add_argument("--jobs", type=int, default=program.cores(), help="runs at a time")
    given = parser.parse_args()
    if given.page == bool(given.directories):
        parser.error("expected either OUT_DIR ... or --page")
    plots.draw_to_files()
    if given.page:
        make_page(given.work, given.jobs)
        return
    runs = {Path(directory).name: Run(directory) for directory in given.directories}
    for name, figure in figures(runs).items():
        plots.save(figure, Path(given.directories[0]), f"{name}.png")
    for run in runs.values():
        report(run)


if __name__ == "__main__":
    main()
