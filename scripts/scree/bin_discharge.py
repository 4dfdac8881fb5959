"""Draws the bin discharge and prints the numbers to compare with the paper (Figs 4, 5, 7, 8; section 4.1).

Into OUT_DIR/plots: discharge_rate.png, centreline.png (all runs, in the first OUT_DIR) and bottom_map.png (each run).
"""
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap, PowerNorm

from scree import output, plots
from scree.case_file import lengths

PAPER_RATE = 144.0  # [g/s], Figs 4 and 9
START_UP = 0.3  # [s], left out of the plateau
DEPTH_TIMES = {1.5: 85.0, 4.5: 53.9}  # [s]: [cm], section 4.1
ABOVE, BELOW = 20.0, 5.0  # what bottom_map and centreline show around the floor [cm]


class Run:
    """One output directory, in the units of the paper (cgs), heights measured from the floor of the bin."""

    def __init__(self, directory, fields=None):
        """fields: those of a time that is not the last."""
        self.directory = Path(directory)
        self.label = self.directory.name
        case = output.case(directory)
        self.floor = lengths(case.get("plate_floor_position", "0.05"))[0]
        openings = lengths(case.get("plate_floor_openings", "0, 0.007"))
        self.orifice = 100 * max(map(abs, openings))  # half width [cm]

        monitor = output.monitor(directory)
        self.monitor_time = output.time_of(monitor)
        self.rate = 1e3 * monitor["flux_orifice" if "flux_orifice" in monitor else "discharge_rate"]
        self.depth = 100 * (monitor["bed_height"] - self.floor) if "bed_height" in monitor else None

        fields = fields or output.last_fields(directory)
        self.time = fields["time"]
        self.x_faces = 100 * fields["x_faces"]
        self.y_faces = 100 * (fields["y_faces"] - self.floor)
        self.x, self.y = output.centres(self.x_faces), output.centres(self.y_faces)
        self.nu = fields["solids_fraction"]
        self.chi = fields.get("frictional_pressure_ratio")
        self.velocity = 100 * fields["velocity"]

    def plateau(self):
        """Mean rate [g/s] over the last half of the time after the start-up, and that interval."""
        end = self.monitor_time[-1]
        begin = (max(START_UP, self.monitor_time[0]) + end) / 2 if end > START_UP else end / 2
        return self.mean_rate((begin, end)), begin, end

    def mean_rate(self, window):
        """Mean rate over a window of time [g/s]."""
        return output.mean_over(window, self.monitor_time, self.rate)

    def centreline(self, field):
        """The column of cells next to the axis x = 0; the mean of both where the domain is the full bin."""
        nearest = np.flatnonzero(np.isclose(np.abs(self.x), np.abs(self.x).min()))
        return field[:, nearest].mean(axis=1)

    def in_orifice_plane(self, field):
        return np.interp(0.0, self.y, self.centreline(field))

    def full_width(self):
        """Faces, cells, nu, vx, vy of the whole bin; a half is mirrored."""
        nu, vx, vy = self.nu, self.velocity[..., 0], self.velocity[..., 1]
        if not output.is_half(self.x_faces):
            return self.x_faces, self.x, nu, vx, vy
        faces = output.mirrored_faces(self.x_faces)
        return faces, output.centres(faces), output.mirrored(nu), output.mirrored(vx, -1), output.mirrored(vy)


def widths(runs):
    """Line widths that leave coinciding curves visible."""
    return np.linspace(1.8 if len(runs) == 1 else 3.4, 1.8 if len(runs) == 1 else 1.4, len(runs))


def draw_discharge_rate(runs):
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    for run, linewidth in zip(runs, widths(runs)):
        axes.plot(run.monitor_time, run.rate, label=run.label, linewidth=linewidth)
    axes.axhline(PAPER_RATE, color="0.35", linestyle="--", linewidth=1.3, label=f"paper, {PAPER_RATE:.0f} g/s")
    axes.set(xlabel="time (s)", ylabel="discharge rate (g/s)", xlim=(0, max(r.monitor_time[-1] for r in runs)))
    shown = max(PAPER_RATE, *(np.nanmax(r.rate[r.monitor_time > min(0.1, r.monitor_time[-1] / 2)]) for r in runs))
    axes.set_ylim(0, 1.15 * shown)  # the start may overshoot
    axes.legend(loc="lower right")
    return figure


def draw_centreline(runs):
    with_chi = any(run.chi is not None for run in runs)
    figure, panels = plt.subplots(
        2 if with_chi else 1, sharex=True, figsize=(6.4, 6.4 if with_chi else 3.6), squeeze=False
    )
    panels = panels[:, 0]
    for run, linewidth in zip(runs, widths(runs)):
        (line,) = panels[0].plot(
            run.y, run.centreline(run.nu), label=f"{run.label}, t = {run.time:.3g} s", linewidth=linewidth
        )
        if run.chi is not None:
            panels[1].plot(run.y, run.centreline(run.chi), color=line.get_color(), linewidth=linewidth)
    panels[0].set(ylabel=r"solids fraction $\nu$ (–)", ylim=(0, 0.68))
    panels[0].legend(loc="lower right")
    if with_chi:
        panels[1].set(ylabel=r"frictional pressure ratio $\chi$ (–)", ylim=(0, 1.15))
    for axes in panels:
        axes.axvline(0, color="0.6", linewidth=1, zorder=0)
    panels[-1].annotate(
        "orifice", (0, 0.04), xycoords=("data", "axes fraction"), xytext=(4, 0), textcoords="offset points", color="0.4"
    )
    panels[-1].set(xlabel="height above the orifice plane (cm)", xlim=(-BELOW, ABOVE))
    return figure


def arrow_cells(run, cells, nu):
    """Where bottom_map draws arrows: a symmetric grid of 0.8 cm by 1 cm in the bin, one row below it."""
    half = np.arange(0.45, cells.max(), 0.8)
    columns = [np.argmin(np.abs(cells - x)) for x in half] + [np.argmin(np.abs(cells + x)) for x in half]
    rows = [np.argmin(np.abs(run.y - y)) for y in (-0.7, *np.arange(0.7, ABOVE, 1.0))]
    chosen = np.zeros(nu.shape, bool)
    chosen[np.ix_(rows, columns)] = True
    return chosen & (nu > 0.02)


def draw_bottom_map(run, colour_map="YlOrBr"):
    faces, cells, nu, vx, vy = run.full_width()
    width = faces[-1]
    sand = ListedColormap(plt.get_cmap(colour_map)(np.linspace(0, 0.72, 256)))
    figure, axes = plt.subplots(figsize=(4.6, 8.4))
    colours = axes.pcolormesh(faces, run.y_faces, np.ma.masked_less(nu, 0.005), cmap=sand, norm=PowerNorm(2, 0, 0.65))
    bar = figure.colorbar(colours, ax=axes, shrink=0.6, aspect=28, ticks=[0, 0.2, 0.3, 0.4, 0.5, 0.6])
    bar.set_label(r"solids fraction $\nu$ (–)")
    bar.outline.set_visible(False)

    x, y, vx, vy = (a[arrow_cells(run, cells, nu)] for a in (*np.meshgrid(cells, run.y), vx, vy))
    speed = np.hypot(vx, vy)
    typical = max(np.median(speed[y > 0]) if np.any(y > 0) else 0.0, 1e-3)
    length = min(0.45, 4 * typical / max(speed.max(initial=0.0), typical))  # of a typical arrow in the bin [cm]
    key = float(f"{2 * typical:.0e}")
    arrows = axes.quiver(
        x, y, vx, vy, angles="xy", scale_units="xy", scale=typical / length, width=0.007, color="#16324f"
    )
    axes.quiverkey(arrows, 0.74, 1.025, key, f"{key:g} cm/s", labelpos="E", labelsep=0.08)

    for side in (-1, 1):
        axes.plot([side * run.orifice, side * width], [0, 0], color="black", linewidth=3.5, solid_capstyle="butt")
    axes.set(
        xlabel="x (cm)", ylabel="height above the orifice plane (cm)",
        xlim=(-width, width), ylim=(max(-BELOW, run.y_faces[0]), ABOVE), aspect="equal",
    )
    axes.set_title(f"t = {run.time:.3g} s", loc="left", fontsize=12)
    for spine in axes.spines.values():
        spine.set_visible(True)
    return figure


def report(run):
    rate, begin, end = run.plateau()
    print(f"{run.directory}: orifice {2 * run.orifice:.3g} cm, last fields at {run.time:.4g} s")
    print(f"  plateau rate, mean of {begin:.2f}-{end:.2f} s  {rate:8.1f} g/s   (paper {PAPER_RATE:.0f} for 1.4 cm)")
    print(f"  nu on the axis in the orifice plane   {run.in_orifice_plane(run.nu):8.3f}       (paper 0.52)")
    if run.chi is not None:
        print(f"  chi on the axis in the orifice plane  {run.in_orifice_plane(run.chi):8.3f}       (paper about 0.9)")
    for time, paper in DEPTH_TIMES.items():
        if run.depth is not None and run.monitor_time[-1] >= time - 1e-9:
            depth = np.interp(time, run.monitor_time, run.depth)
            print(f"  depth of material at {time} s            {depth:8.1f} cm    (paper {paper})")


def main():
    runs = [Run(directory) for directory in plots.arguments(__doc__).directories]
    plots.save(draw_discharge_rate(runs), runs[0].directory, "discharge_rate.png")
    plots.save(draw_centreline(runs), runs[0].directory, "centreline.png")
    for run in runs:
        plots.save(draw_bottom_map(run), run.directory, "bottom_map.png")
        report(run)

