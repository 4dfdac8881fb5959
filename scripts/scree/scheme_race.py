"""The race of the time schemes: error in time against CPU seconds, on the scenes and small grids of scree/accuracy.py.

    scripts/accuracy.py      # once: its finest runs make the references
    scripts/scheme_race.py [--work out/accuracy]

Runs what is not there yet, one run after the other, the schemes in turns, so that a machine that others use slows all of
them alike. Draws cases/guide/schemes.png, writes cases/guide/schemes.csv and prints the table."""
import argparse
import csv
import sys
from pathlib import Path

from scree import accuracy, output, plots, program, sweeps
from scree.plots import plt

SCHEMES = ("beuler", "bdf", "arkimex")
ACCURACIES = (3e-1, 1e-1, 3e-2, 1e-2)


def reference(scene, work):
    """Of the finest runs of backward Euler that are there."""
    done = {a: p for a in accuracy.ACCURACIES if (p := scene.point(a, work)).state() == "done"}
    if len(done) < 2:
        sys.exit(f"scheme_race.py: {scene.name}: no two runs in {work} to refer to; scripts/accuracy.py makes them")
    return accuracy.references({a: scene.values(p.directory) for a, p in done.items()})


def result(scene, scheme, of, point, refer):
    """A row: what a run cost, and the greatest of its errors; without numbers where it failed."""
    row = {"scene": scene.name, "scheme": scheme, "accuracy": f"{of:g}", "end": point.record()["reason"] or "end_time"}
    if point.state() != "done":
        return row
    summary, values = output.summary(point.directory), scene.values(point.directory)
    errors = {name: accuracy.error(values[name], exact) for name, exact in refer.items()}
    worst = max(errors, key=errors.get)
    return {**row, "steps": f"{summary['steps']:.0f}", "newton_iterations": f"{summary['newton_iterations']:.0f}",
            "cpu [s]": f"{summary['cpu_seconds']['total']:.1f}", "greatest error": f"{errors[worst]:.2g}", "of": worst}


COLUMNS = ("scene", "scheme", "accuracy", "end", "steps", "newton_iterations", "cpu [s]", "greatest error", "of")


def draw(rows):
    names = list(dict.fromkeys(row["scene"] for row in rows))
    figure, panels = plt.subplots(1, len(names), figsize=(4.6 * len(names), 4.2), sharey=True, squeeze=False)
    for axes, name in zip(panels[0], names):
        for scheme in SCHEMES:
            done = [row for row in rows if (row["scene"], row["scheme"]) == (name, scheme) and row["end"] == "end_time"]
            axes.plot([float(row["cpu [s]"]) for row in done], [float(row["greatest error"]) for row in done], "o-",
                      label=scheme)
        axes.set(xscale="log", yscale="log", title=name, xlabel="CPU seconds")
        axes.legend()
    panels[0][0].set_ylabel("greatest relative error in time (–)")
    return figure


def table(rows):
    lines = [COLUMNS, ["---"] * len(COLUMNS), *([row.get(name, "") for name in COLUMNS] for row in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, default=Path("out/accuracy"), help="directory of the runs")
    given = parser.parse_args()
    program.check_program(program.default_program())
    referred = {scene.name: reference(scene, given.work) for scene in accuracy.SCENES}
    points = [(scene, scheme, a, scene.point(a, given.work, scheme))
              for a in ACCURACIES for scene in accuracy.SCENES for scheme in SCHEMES]
    missing = [point for *_, point in points if point.state() == "missing"]
    for number, point in enumerate(sweeps.run_all(missing, 1), 1):
        print(f"[{number}/{len(missing)}] {point.name}: {point.record()['reason'] or 'done'}", flush=True)
    rows = sorted((result(scene, scheme, a, point, referred[scene.name]) for scene, scheme, a, point in points),
                  key=lambda row: (row["scene"], SCHEMES.index(row["scheme"])))
    with open(accuracy.PAGE / "schemes.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    plots.draw_to_files()
    draw(rows).savefig(accuracy.PAGE / "schemes.png")
    print(table(rows))


if __name__ == "__main__":
    main()
