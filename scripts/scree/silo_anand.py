"""Draws the discharge of the bin of Anand et al. (2008) beside discrete elements, and prints the numbers to compare.

    scripts/plot_silo_anand.py OUT_DIR ...          plots into the first OUT_DIR/plots
    scripts/plot_silo_anand.py --page [--work out/silo_anand_page] [--jobs N]

--page runs all models and grids of the page that are not there yet, and writes models.csv, the figures and the tables of
cases/silo_anand. The reference data lie in cases/silo_anand/reference; scripts/reference made them."""
import argparse
import csv
from pathlib import Path

import numpy as np
from matplotlib.colors import LogNorm

from scree import beside_grains, page_tables, plots, program, slot_flow
from scree.beside_grains import Model, Run, tidy
from scree.discrete_elements import ANAND, REFERENCES
from scree.page_tables import markdown
from scree.plots import plt

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "cases" / "silo_anand"
REFERENCE = REFERENCES[ANAND.name]

UNIFORM = {"grid_finest": "2 mm", "grid_coarsest": "2.1 mm"}  # that a whole number fits into the slot
FINER = {"grid_finest": "0.25 mm"}

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


# ---- what is compared ----


def reference_mass(name):
    """Time [s] and mass discharged [g] of a file of reference data."""
    columns = beside_grains.read_csv(REFERENCE / f"{name}.csv")
    return np.array(columns["time [s]"], float), np.array(columns["discharged [g]"], float)


def reference_flow(name="anand"):
    """The fields of discrete elements."""
    return beside_grains.flow(REFERENCE / f"fields_{name}.csv")


def reference_numbers(name="anand"):
    """The row of a run of discrete elements."""
    return beside_grains.numbers(REFERENCE / "anand.csv", name)


def run_of(directory):
    """An output directory beside the grains of Anand et al."""
    return Run(directory, ANAND, reference_flow())


SHOWN = ("rate [g/s]", "C", "corner / plug", "shoulder angle [deg]", "shoulder at 2 cm [cm]",
         "shoulder height at the wall [cm]", "nu over the orifice", "T over the orifice [cm2/s2]", "cpu [s]")


def discrete_row(name="anand"):
    """The same numbers of discrete elements."""
    found = reference_numbers(name)
    return {key: found[key] for key in SHOWN}


def anand_rate():
    return slot_flow.slope(*reference_mass("anand_2008"), ANAND.rate_window)


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
        axes.plot([ANAND.orifice / 2, ANAND.width / 2], [0, 0], color="black", linewidth=3)
        axes.set(xlabel="x (cm)", xlim=(0, ANAND.width / 2), ylim=(-1, 10), aspect="equal")
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
    axes.set(xlabel="x (cm)", ylabel="height above the floor (cm)", xlim=(0, ANAND.width / 2), ylim=(0, 8), aspect="equal")
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


def models_table(rows):
    """Anand's rate, discrete elements, and the models."""
    C = slot_flow.coefficient(anand_rate() / ANAND.depth, ANAND.density, float(reference_numbers()["fill nu"]), ANAND.orifice)
    lines = [["Anand et al. (2008)", f"{anand_rate():.1f}", f"{C:.3f}", *[""] * (len(SHOWN) - 2)]]
    names = {"anand": "discrete elements", "anand_soft": "the same, softer by 4",
             "anand_soft_rolling": "the same, softer by 4, rolling friction"}
    lines += [[words, *(tidy(key, discrete_row(name)[key]) for key in SHOWN)] for name, words in names.items()]
    lines += [[words, *(tidy(key, rows[name][key]) for key in SHOWN)] for name, words in
              ((m.name, m.words) for m in MODELS) if name in rows]
    return markdown(["model", *SHOWN], lines)


def changes_table(rows):
    shown = SHOWN[:-1]
    lines = [[m.words, *(rows[m.name][key] for key in shown)] for m in (MODELS[0], *CHANGES) if m.name in rows]
    return markdown(["change of one parameter", *shown], lines)


def discrete_table():
    columns = beside_grains.read_csv(REFERENCE / "anand.csv")
    shown = ("run", "stiffness [dyn/cm]", "rolling", "rate [g/s]", "corner / plug", "shoulder angle [deg]",
             "wedge angle [deg]", "remaining [g]", "greatest overlap / d", "mean greatest overlap / d")
    return markdown(list(shown), [list(line) for line in zip(*(columns[key] for key in shown))])


def make_page(work, jobs):
    """Runs what is missing; writes models.csv, figures and tables."""
    program.check_program(program.default_program())
    points = [(model, model.point(PAGE, work)) for model in (*MODELS, *CHANGES)]
    beside_grains.run_missing([p for _, p in points], jobs)
    runs = [(model, run_of(p.directory)) for model, p in points if p.state() == "done"]
    rows = {model.name: run.row() for model, run in runs}
    with open(PAGE / "models.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["run", *SHOWN])
        table.writerows([name, *(row[key] for key in SHOWN)] for name, row in rows.items())
    page_tables.put(PAGE / "README.md",
                    {"models": models_table(rows), "changes": changes_table(rows), "discrete": discrete_table()})
    shown = {model.words: run for model, run in runs if model in MODELS and not model.options}
    for name, figure in figures(shown).items():
        figure.savefig(PAGE / f"{name}.png")


def report(run):
    print(f"{run.directory}:  (discrete elements in brackets, Anand et al. {anand_rate():.1f} g/s)")
    own, other = run.row(), discrete_row()
    for name in SHOWN:
        print(f"  {name:34s} {own[name]:>8s}   ({tidy(name, other[name])})")


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
    runs = {Path(directory).name: run_of(directory) for directory in given.directories}
    for name, figure in figures(runs).items():
        plots.save(figure, Path(given.directories[0]), f"{name}.png")
    for run in runs.values():
        report(run)


if __name__ == "__main__":
    main()
