"""What the paper's figures share: their look, the reading of runs in cgs units, and writing a picture with its data."""
import csv
import inspect
import os
from pathlib import Path

import paper_runs

import matplotlib.pyplot as plt
import numpy as np

from scree import bin_discharge, output, plots

#: Curves of a figure as the paper has them: solid, broken, dotted; widths leave coinciding ones visible.
LINES = [dict(color="0.65", linestyle="-", linewidth=3.4), dict(color="black", linestyle="--", linewidth=1.6),
         dict(color="black", linestyle=":", linewidth=1.8), dict(color="black", linestyle="-.", linewidth=1.4)]
ONE_LINE = dict(color="black", linewidth=1.6)
GREYS = "Greys"
RATE_AXES = dict(xlabel="time (s)", ylabel="discharge rate (g/s)")
ORIFICE = dict(color="0.4", linestyle="--", linewidth=1)


class Discharge(bin_discharge.Run):
    """A run of the bin with its means over a window of time, in cgs units; heights are over the orifice plane."""

    def __init__(self, directory, window=(), at=None):
        """window: of the means [s]; of a run that ends before it, its last half is taken. at: time of the fields
        [s]."""
        super().__init__(directory, output.fields_near(directory, at) if at is not None else None)
        last_half = self.monitor_time[-1] / 2, self.monitor_time[-1]
        self.window = window if window and self.reaches(window[1]) else last_half

    def reaches(self, time):
        return self.monitor_time[-1] >= time * (1 - 1e-9)

    def mean_rate(self, window=None):
        """Mean rate of discharge over the window [g/s]."""
        return super().mean_rate(window or self.window)

    def rate_at(self, time):
        return float(np.interp(time, self.monitor_time, self.rate))

    def depth_at(self, time):
        """Depth of material [cm]."""
        return float(np.interp(time, self.monitor_time, self.depth))

    def mean(self, name, window=None):
        """Mean of a field over the files of the window, at least the nearest to its middle."""
        begin, end = window or self.window
        inside = output.files_between(self.directory, begin, end)
        inside = inside or [output.file_near(self.directory, (begin + end) / 2)]
        fields = [output.fields(path, [name]) for path in inside]
        return np.mean([one[name] for one in fields], axis=0) if name in fields[0] else None

    def mean_centreline(self, name, window=None):
        field = self.mean(name, window)
        return None if field is None else self.centreline(field)

    def mean_in_orifice_plane(self, name, window=None):
        """On the centreline; NaN where the model has no such field."""
        profile = self.mean_centreline(name, window)
        return float("nan") if profile is None else float(np.interp(0.0, self.y, profile))


def discharges(directories, window):
    """Runs with the same window of their means: the last half of the shortest where that ends before it."""
    runs = [Discharge(directory, window) for directory in directories]
    shortest = min(runs, key=lambda run: run.monitor_time[-1])
    for run in runs:
        run.window = shortest.window
    return runs


def rows_of(name, *columns):
    """Rows of a table that begin with a name, such as that of a run."""
    return [(name, *values) for values in zip(*columns)]


def write_csv(path, header, rows):
    """Numbers with six digits; at once or not at all."""
    new = path.with_suffix(".csv.new")
    with open(new, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for row in rows:
            writer.writerow([value if isinstance(value, str) else f"{value:.6g}" for value in row])
    new.rename(path)


def save(figure, out, name, header, rows):
    """Writes out/name.png and out/name.csv."""
    out.mkdir(parents=True, exist_ok=True)
    new = out / f"{name}.new.png"
    figure.savefig(new, dpi=120)
    plt.close(figure)
    write_csv(out / f"{name}.csv", header, rows)
    new.rename(out / f"{name}.png")
    print(f"  {out / name}.png, .csv")


def up_to_date(out, name, script, records):
    """Whether the picture and its data are newer than the script and its runs."""
    made = [out / f"{name}.png", out / f"{name}.csv"]
    if not all(path.exists() for path in made):
        return False
    return min(os.path.getmtime(path) for path in made) > max(os.path.getmtime(path) for path in (script, *records))


def produce(name, text, draw, needs=(), grid="paper"):
    """The main function of a figure's script: gets its runs, draws, writes. draw(given, directories of the runs) gives
    the figure, the header and the rows of its data."""
    script = Path(inspect.getfile(draw))

    def main():
        given = paper_runs.arguments(text, grid)
        directories = {run: given.runs.get(run, given.grid) for run in needs}
        records = [directory.parent / "run.json" for directory in directories.values()]
        if given.skip_done and up_to_date(given.out, name, script, records):
            print(f"  {given.out / name}.png is there")
            return
        plots.draw_to_files()
        figure, header, rows = draw(given, directories)
        save(figure, given.out, name, header, rows)

    paper_runs.guarded(main)


def window_of(name):
    return paper_runs.TABLE[name].window


def mark_orifice(axes):
    """The dashed line of the orifice plane, where the height is the vertical axis."""
    axes.axhline(0, **ORIFICE)
    axes.annotate("orifice", (0.01, 0), xycoords=("axes fraction", "data"), xytext=(0, 3), textcoords="offset points",
                  color="0.4", fontsize=10)


def draw_rates(curves, paper=None):
    """The rate of discharge in time; curves: label -> Discharge. Returns figure, header, rows."""
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    for (label, run), line in zip(curves.items(), LINES):
        axes.plot(run.monitor_time, run.rate, label=label, **line)
    if paper:
        axes.axhline(paper, color="0.5", linewidth=0.9, label=f"paper, about {paper:.0f} g/s")
    end = max(run.monitor_time[-1] for run in curves.values())
    axes.set(**RATE_AXES, xlim=(0, end), ylim=(0, 1.15 * max(run.rate.max() for run in curves.values())))
    axes.legend(loc="lower right")
    rows = [row for label, run in curves.items() for row in rows_of(label, run.monitor_time, run.rate)]
    return figure, ["run", "time [s]", "rate [g/s]"], rows


def draw_centrelines(curves, xlabel, y_range):
    """Profiles along the centreline with the height as vertical axis; curves: label -> (y, values). Returns the figure,
    its axes and the rows of its data."""
    figure, axes = plt.subplots(figsize=(5.4, 5.2))
    lines = LINES if len(curves) > 1 else [ONE_LINE]
    for (label, (y, values)), line in zip(curves.items(), lines):
        axes.plot(values, y, label=label, **line)
    mark_orifice(axes)
    axes.set(xlabel=xlabel, ylabel="height over the orifice plane (cm)", ylim=y_range)
    if len(curves) > 1:
        axes.legend(loc="upper left")
    return figure, axes, [row for label, (y, values) in curves.items() for row in rows_of(label, y, values)]
