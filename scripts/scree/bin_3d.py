"""Draws a quarter of a bin in three dimensions and prints its numbers.

Into the first OUT_DIR: plots/discharge_rate.png, of all runs. Into each: plots/slices.png, the solids fraction on the
plane of symmetry y = 0 with the velocity of the particles, and how fast they sink at a height of 1 cm.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from scree import output, plots
from scree.bin_discharge_fine import draw_discharge_rate

CM = 100.0
G_PER_KG = 1000.0
ARROWS = 12  # along half of the width
HEIGHT = 1.0  # of the horizontal slice [cm]
DENSE = 0.585  # solids fraction of a bed at rest
QUARTERS = 4


class Run:
    """The monitor and the last fields of a run, lengths in cm."""

    def __init__(self, directory):
        self.directory = Path(directory)
        self.label = self.directory.name
        monitor = output.monitor(directory)
        self.monitor_time, self.rate = np.asarray(monitor["time"]), QUARTERS * G_PER_KG * np.asarray(monitor["flux_orifice"])
        fields = output.last_fields(directory)
        self.faces = [CM * fields[f"{axis}_faces"] for axis in "xyz"]
        self.centres = [0.5 * (faces[1:] + faces[:-1]) for faces in self.faces]
        self.nu, self.velocity = fields["solids_fraction"], fields["velocity"]

    def mean_rate(self, start, end):
        """Mean rate of the whole bin between two times [g/s]."""
        inside = (self.monitor_time > start) & (self.monitor_time < end)
        times = np.concatenate(([start], self.monitor_time[inside], [end]))
        return np.trapz(np.interp(times, self.monitor_time, self.rate), times) / (end - start)

    def sinking(self):
        """Downward speed at HEIGHT [cm/s]; [y, x]."""
        at = np.argmin(np.abs(self.centres[2] - HEIGHT))
        return -CM * self.velocity[at, :, :, 2]

    def depth(self):
        """Depth of the bed over x and y, as if it were dense [cm]; [y, x]."""
        return np.tensordot(np.diff(self.faces[2]), self.nu, axes=1) / DENSE


def both_sides(values):
    """A plane of symmetry at the lower end of the last axis: with its mirror image."""
    return np.concatenate((values[..., ::-1], values), axis=-1)


def draw_slices(run):
    figure, (section, above) = plt.subplots(1, 2, figsize=(7.6, 5.2), width_ratios=(1, 1.1), layout="constrained")
    x = np.concatenate((-run.faces[0][:0:-1], run.faces[0]))
    colours = section.pcolormesh(x, run.faces[2], both_sides(run.nu[:, 0]), cmap="YlOrBr", vmin=0, vmax=0.65)
    figure.colorbar(colours, ax=section, label=r"solids fraction $\nu$ (–)", location="left")
    step = max(1, len(run.centres[0]) // ARROWS)
    moving = run.nu[::step, 0, ::step] > 0.05
    v = np.where(moving[..., None], run.velocity[::step, 0, ::step], np.nan)
    section.quiver(run.centres[0][::step], run.centres[2][::step], v[..., 0], v[..., 2], width=4e-3, color="0.15")
    section.set(xlabel="x (cm), y = 0", ylabel="z (cm)", aspect="equal")
    speed = both_sides(run.sinking())
    speed = np.concatenate((speed[::-1], speed))
    y = np.concatenate((-run.faces[1][:0:-1], run.faces[1]))
    speeds = above.pcolormesh(x, y, speed, cmap="viridis", vmin=0)
    figure.colorbar(speeds, ax=above, label=f"sinking (cm/s), z = {HEIGHT:g} cm", location="bottom")
    above.set(xlabel="x (cm)", ylabel="y (cm)", aspect="equal")
    return figure


def report(run):
    end = run.monitor_time[-1]
    print(f"{run.directory}: {' x '.join(str(len(c)) for c in run.centres)} cells, to {end:.3g} s")
    print(f"  rate of the whole bin, mean over the last 0.2 s {run.mean_rate(max(0, end - 0.2), end):8.1f} g/s")
    depth, sinking = run.depth(), run.sinking()
    print(f"  depth on the axis {depth[0, 0]:.1f} cm, in the corner {depth[-1, -1]:.1f} cm")
    print(f"  downward speed {HEIGHT:g} cm over the floor: on the axis {sinking[0, 0]:.1f}, in the corner {sinking[-1, -1]:.3f} cm/s")


def main():
    arguments = plots.arguments(__doc__)
    runs = [Run(directory) for directory in arguments.directories]
    plots.save(draw_discharge_rate(runs), runs[0].directory, "discharge_rate.png")
    for run in runs:
        plots.save(draw_slices(run), run.directory, "slices.png")
        report(run)
