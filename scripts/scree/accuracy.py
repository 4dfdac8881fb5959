"""Errors in time against the accuracy that was asked for: three scenes on small grids, each against its own solution with
steps that go to nothing.

    scripts/accuracy.py [--work out/accuracy] [--jobs N]

Runs what is not there yet, draws cases/guide/accuracy.png, writes cases/guide/accuracy.csv and prints the table."""
import argparse
import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from scree import bin_discharge, output, plots, program, quantities, sweeps
from scree.plots import plt

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "cases" / "guide"
ACCURACIES = (1e-1, 3e-2, 1e-2, 3e-3, 1e-3)  # a tenth of that takes hours
SMALL_BIN = {"grid_x_cells": "2, 8", "grid_y_cells": "7, 125"}


def bin_values(directory):
    """What has left [g], rate [g/s] and energy of motion at the end of a run, nu along the centreline."""
    run = bin_discharge.Run(directory)
    monitor = output.monitor(directory)
    return {"mass that has left": monitor["mass"][0] - monitor["mass"][-1], "rate": monitor["flux_orifice"][-1],
            "kinetic energy": monitor["kinetic_energy"][-1],
            "nu on the centreline": run.centreline(run.nu)}


def bubble_values(directory):
    return quantities.bubble_quantities(directory, None)


@dataclass(frozen=True)
class Scene:
    name: str
    case: str
    options: dict
    values: object  # of a finished run: name -> number or profile

    def point(self, accuracy, work, scheme=None):
        """A run; scheme: of time, backward Euler without, and then also without its name."""
        options = {**self.options, "accuracy": accuracy, "time_scheme": scheme or "beuler"}
        found = sweeps.Point(ROOT / "cases" / self.case, program.default_program(), 1, work, {}, options)
        found.name = "_".join([self.case.split("/")[0], f"{accuracy:g}", *([scheme] if scheme else [])])
        found.directory = work / found.name
        return found


SCENES = (
    Scene("1 mm bin", "bin_discharge/coarse.yaml", {**SMALL_BIN, "end_time": 0.15, "output_interval": 0.15}, bin_values),
    Scene("100 um bin with air", "bin_discharge_fine/case.yaml", {**SMALL_BIN, "end_time": 0.1, "output_interval": 0.1},
          bin_values),
    Scene("bubble", "bubble_rise/case.yaml",
          {"grid_x_cells": "2, 10", "grid_y_cells": "67, 15", "end_time": 0.15, "output_interval": 0.15}, bubble_values),
)


def extrapolated(coarse, fine, ratio):
    """What values of order 1 tend to, from two of them whose steps are `ratio` to one."""
    return fine + (fine - coarse) / (ratio - 1)


def references(values):
    """values: accuracy -> {quantity: number or profile}. What the two least accuracies lead to, by quantity."""
    finest, next_finer = sorted(values)[:2]
    return {name: extrapolated(np.asarray(values[next_finer][name]), np.asarray(values[finest][name]), next_finer / finest)
            for name in values[finest]}


def error(value, reference):
    """In the maximum norm, relative to the greatest value."""
    return float(np.max(np.abs(value - reference)) / np.max(np.abs(reference)))


def errors(values):
    """values as those of references(). Gives {quantity: {accuracy: relative error}}."""
    return {name: {accuracy: error(of[name], reference) for accuracy, of in values.items()}
            for name, reference in references(values).items()}


def rows(scene, values, summaries):
    return [{"scene": scene.name, "quantity": name, "accuracy": f"{accuracy:g}", "error": f"{error:.3g}",
             "steps": summaries[accuracy]["steps"], "cpu [s]": f"{summaries[accuracy]['cpu_seconds']['total']:.0f}"}
            for name, of in errors(values).items() for accuracy, error in sorted(of.items(), reverse=True)]


def table(found):
    """found: scene name -> errors."""
    head = ["scene", "quantity", *(f"{a:g}" for a in ACCURACIES)]
    lines = [[scene, name, *(f"{of[a]:.1e}" if a in of else "" for a in ACCURACIES)]
             for scene, quantity in found.items() for name, of in quantity.items()]
    return "\n".join("| " + " | ".join(line) + " |" for line in (head, ["---"] * len(head), *lines))


def draw(found):
    figure, panels = plt.subplots(1, len(found), figsize=(4.6 * len(found), 4.6), sharey=True, squeeze=False)
    asked = np.array([min(ACCURACIES), max(ACCURACIES)])
    for axes, (scene, quantity) in zip(panels[0], found.items()):
        axes.fill_between(asked, asked / 1e5, 3 * asked, color="0.93")
        axes.plot(asked, asked, color="0.6", linewidth=1)
        for name, of in quantity.items():
            accuracies = sorted(of)[1:]  # the last one is a part of the reference
            axes.plot(accuracies, [of[a] for a in accuracies], "o-", label=name)
        axes.set(xscale="log", yscale="log", title=scene, xlabel="accuracy asked for (–)", ylim=(1e-6, 0.3))
        axes.legend(fontsize=9, loc="lower right")
    panels[0][0].set_ylabel("relative error in time (–)")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, default=Path("out/accuracy"), help="directory of the runs")
    parser.add_argument("--jobs", type=int, default=program.cores(), help="runs at a time")
    given = parser.parse_args()
    program.check_program(program.default_program())
    points = {(scene.name, a): scene.point(a, given.work) for a in ACCURACIES for scene in SCENES}
    missing = [p for p in points.values() if p.state() == "missing"]
    for number, p in enumerate(sweeps.run_all(missing, given.jobs), 1):
        print(f"[{number}/{len(missing)}] {p.name}: {p.record()['reason'] or 'done'}", flush=True)
    found, lines = {}, []
    for scene in SCENES:
        done = {a: points[scene.name, a] for a in ACCURACIES if points[scene.name, a].state() == "done"}
        values = {a: scene.values(p.directory) for a, p in done.items()}
        found[scene.name] = errors(values)
        lines += rows(scene, values, {a: output.summary(p.directory) for a, p in done.items()})
    with open(PAGE / "accuracy.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, list(lines[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)
    plots.draw_to_files()
    draw(found).savefig(PAGE / "accuracy.png")
    print(table(found))


if __name__ == "__main__":
    main()
