"""Draws the rising bubble and prints its size and place (Fig 13 of the paper).

Into OUT_DIR/plots: bubble.png (all runs side by side at the last time) and bubble_in_time.png, both in the first OUT_DIR,
and bubble.csv (each run). The bubble is the largest region with nu < 0.3 that is not the freeboard.
"""
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from scipy import ndimage

from scree import output, plots

LEVEL = 0.3
FINER = 8  # points a cell in each direction, for the contour


def full_width(fields):
    """Cell centres x, y [cm] and nu of the whole bed; a half is mirrored."""
    x_faces, y_faces = 100 * fields["x_faces"], 100 * fields["y_faces"]
    nu = fields["solids_fraction"]
    if output.is_half(x_faces):
        x_faces, nu = output.mirrored_faces(x_faces), output.mirrored(nu)
    return output.centres(x_faces), output.centres(y_faces), nu


def finer(x, y, nu):
    """Bilinear interpolation to a uniform fine grid."""
    fine_x = np.linspace(x[0], x[-1], FINER * len(x))
    fine_y = np.linspace(y[0], y[-1], FINER * len(y))
    rows = np.array([np.interp(fine_x, x, row) for row in nu])
    above = np.clip(np.searchsorted(y, fine_y), 1, len(y) - 1)
    share = ((fine_y - y[above - 1]) / (y[above] - y[above - 1]))[:, None]
    return fine_x, fine_y, (1 - share) * rows[above - 1] + share * rows[above]


def regions(mask):
    """The connected parts of a mask, as masks."""
    labels, count = ndimage.label(mask)
    return [labels == number for number in range(1, count + 1)]


def bubble(fields):
    """bottom, top, width [cm], area [cm2] of the bubble; zeros if there is none."""
    x, y, nu = finer(*full_width(fields))
    inside = [region for region in regions(nu < LEVEL) if not region[-1].any()]  # the freeboard reaches the top
    if not inside:
        return dict(bottom=0.0, top=0.0, width=0.0, area=0.0)
    best = max(inside, key=np.sum)
    rows, columns = np.flatnonzero(best.any(axis=1)), np.flatnonzero(best.any(axis=0))
    dx, dy = x[1] - x[0], y[1] - y[0]
    return dict(
        bottom=y[rows[0]] - dy / 2, top=y[rows[-1]] + dy / 2, width=(columns[-1] - columns[0] + 1) * dx,
        area=best.sum() * dx * dy,
    )


class Run:
    def __init__(self, directory, rows=True):
        """rows: with the bubble at the time of each field file, which takes a second each."""
        self.directory = Path(directory)
        self.label = self.directory.name
        self.last = output.last_fields(directory)
        self.rows = []
        monitor = output.monitor(directory)
        for path in output.field_files(directory) if rows else ():
            fields = output.fields(path, ["x_faces", "y_faces", "solids_fraction"])
            height = 100 * np.interp(fields["time"], output.time_of(monitor), monitor["bed_height"])
            self.rows.append(dict(time=fields["time"], **bubble(fields), bed_height=height))

    def column(self, name):
        return np.array([row[name] for row in self.rows])


def draw_bubbles(runs, colour_map="YlOrBr"):
    figure, panels = plt.subplots(1, len(runs), figsize=(3.1 * len(runs), 7.6), sharey=True, squeeze=False)
    for run, axes in zip(runs, panels[0]):
        x, y, nu = full_width(run.last)
        image = axes.pcolormesh(x, y, nu, cmap=colour_map, vmin=0, vmax=0.65, shading="nearest")
        axes.contour(x, y, nu, [LEVEL], colors="#16324f", linewidths=1.4)
        axes.set(xlabel="x (cm)", ylim=(0, 55), aspect="equal")
        axes.set_title(f"{run.label}\nt = {run.last['time']:.3g} s", loc="left", fontsize=11)
    panels[0][0].set_ylabel("height (cm)")
    figure.colorbar(image, ax=panels[0], shrink=0.5, label=r"solids fraction $\nu$ (–)")
    return figure


def draw_in_time(runs):
    figure, (places, areas) = plt.subplots(2, 1, sharex=True, figsize=(6.4, 6.4))
    for run in runs:
        (line,) = places.plot(run.column("time"), run.column("top"), label=run.label)
        places.plot(run.column("time"), run.column("bottom"), linestyle="--", color=line.get_color())
        areas.plot(run.column("time"), run.column("area"), color=line.get_color())
    places.set(ylabel="top, bottom (cm)")
    places.legend(loc="upper left")
    areas.set(xlabel="time (s)", ylabel="area (cm²)")
    return figure


def report(run):
    print(f"{run.directory}")
    print("  time s   bottom cm  top cm  width cm  area cm2  bed height cm")
    for row in run.rows:
        if row["time"] > 0.05 and abs(10 * row["time"] - round(10 * row["time"])) < 0.05:
            print("  {time:6.3f}  {bottom:9.2f} {top:8.2f} {width:8.2f} {area:9.1f} {bed_height:10.1f}".format(**row))


def write_table(run):
    (run.directory / "plots").mkdir(exist_ok=True)
    table = "\n".join(",".join(f"{value:.6g}" for value in row.values()) for row in run.rows)
    (run.directory / "plots" / "bubble.csv").write_text(f"{','.join(run.rows[0])}\n{table}\n")


def main():
    runs = [Run(directory) for directory in plots.arguments(__doc__).directories]
    for run in runs:
        write_table(run)
        report(run)
    plots.save(draw_bubbles(runs), runs[0].directory, "bubble.png")
    plots.save(draw_in_time(runs), runs[0].directory, "bubble_in_time.png")

