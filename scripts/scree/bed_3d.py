"""Draws a quarter of a fluidised bed in three dimensions and prints the size and place of its bubbles.

Into OUT_DIR/plots: bubbles.png, the solids fraction on the plane of symmetry y = 0 at some times, and bubbles.csv. A
bubble is a connected region with nu < 0.3 below the freeboard.
"""
import csv
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from scipy import ndimage

from scree import output, plots

CM = 100.0
LEVEL = 0.3  # solids fraction at the boundary of a bubble
PICTURES = 6
QUARTERS = 4
COLUMNS = ("time [s]", "bottom [cm]", "top [cm]", "volume [cm3]", "diameter [cm]")


def bubbles(fields):
    """(bottom, top [cm], volume of the whole bubble [cm3]) of each bubble, the lowest first."""
    faces = [CM * fields[f"{axis}_faces"] for axis in "xyz"]
    widths = [np.diff(f) for f in faces]
    volume = widths[2][:, None, None] * widths[1][None, :, None] * widths[0][None, None, :]
    labels, count = ndimage.label(fields["solids_fraction"] < LEVEL)
    found = []
    for number in range(1, count + 1):
        inside = labels == number
        rows = np.flatnonzero(inside.any(axis=(1, 2)))
        if rows[-1] < len(widths[2]) - 1:  # the freeboard reaches the top
            found.append((faces[2][rows[0]], faces[2][rows[-1] + 1], QUARTERS * volume[inside].sum()))
    return sorted(found)


def diameter(volume):
    """Of the sphere of that volume."""
    return (6 * volume / math.pi) ** (1 / 3)


def rows(directory):
    """A row of COLUMNS for each bubble at each time."""
    found = []
    for path in output.field_files(directory):
        for bottom, top, volume in bubbles(output.fields(path)):
            found.append((output.time_of_file(path), bottom, top, volume, diameter(volume)))
    return found


def draw(directory):
    files = output.field_files(directory)
    chosen = [files[k] for k in np.unique(np.linspace(0, len(files) - 1, PICTURES + 1).round().astype(int))[1:]]
    figure, all_axes = plt.subplots(1, len(chosen), figsize=(1.5 * len(chosen) + 1, 4), sharey=True, layout="constrained")
    for path, axes in zip(chosen, np.atleast_1d(all_axes)):
        fields = output.fields(path)
        x, z = CM * output.mirrored_faces(fields["x_faces"]), CM * fields["z_faces"]
        colours = axes.pcolormesh(x, z, output.mirrored(fields["solids_fraction"][:, 0]), cmap="YlOrBr", vmin=0, vmax=0.65)
        half = math.floor(x[-1] / 2)
        axes.set(title=f"{output.time_of_file(path):.2g} s", xlabel="x (cm)", aspect="equal", xticks=(-half, 0, half))
    np.atleast_1d(all_axes)[0].set_ylabel("z (cm)")
    figure.colorbar(colours, ax=all_axes, label=r"solids fraction $\nu$ (–), y = 0")
    return figure


def main():
    for directory in map(Path, plots.arguments(__doc__).directories):
        plots.save(draw(directory), directory, "bubbles.png")
        table = rows(directory)
        with open(directory / "plots" / "bubbles.csv", "w", newline="") as stream:
            writer = csv.writer(stream, lineterminator="\n")
            writer.writerows([COLUMNS, *([f"{number:.4g}" for number in row] for row in table)])
        for time, bottom, top, volume, size in table:
            print(f"{directory} {time:6.3f} s: bubble from {bottom:.1f} to {top:.1f} cm, {volume:.2f} cm3, as a sphere of {size:.2f} cm")
