"""Draws the solids fraction at up to five times of a run, with the velocity as arrows. Writes plots/fields.png.

    scripts/plot_guide.py out/step1
    scripts/plot_guide.py out/step5 --field gas_pressure"""
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from scree import output, plots

PANELS = 5
ARROWS = 4, 14  # along x and y


def chosen(files):
    """Up to PANELS files, first and last among them."""
    return [files[k] for k in sorted({round(k) for k in np.linspace(0, len(files) - 1, min(PANELS, len(files)))})]


def nearest(centres, faces, count):
    """The cells nearest to `count` places spread evenly over an axis."""
    places = faces[0] + np.ptp(faces) * (np.arange(count) + 0.5) / count
    return np.unique(np.abs(centres[:, None] - places).argmin(axis=0))


def draw(axes, fields, name, limits):
    x, y = 100 * fields["x_faces"], 100 * fields["y_faces"]
    mesh = axes.pcolormesh(x, y, fields[name], cmap="viridis" if name == "solids_fraction" else "RdBu_r",
                           vmin=limits[0], vmax=limits[1], rasterized=True)
    centre_x, centre_y = output.centres(x), output.centres(y)
    at_x, at_y = nearest(centre_x, x, ARROWS[0]), nearest(centre_y, y, ARROWS[1])
    velocity = np.where(fields["solids_fraction"][..., None] > 0.05, fields["velocity"], np.nan)[np.ix_(at_y, at_x)]
    if np.nanmax(np.abs(velocity), initial=0) > 0:
        axes.quiver(centre_x[at_x], centre_y[at_y], velocity[..., 0], velocity[..., 1], color="white", width=0.012)
    axes.set_aspect("equal")
    axes.set_title(f"{1000 * fields['time']:.0f} ms")
    axes.set_xlabel("x [cm]")
    axes.xaxis.set_major_locator(MaxNLocator(2, integer=True))
    return mesh


def main():
    given = plots.arguments(__doc__, ("--field", dict(default="solids_fraction", help="dataset at cells")))
    for directory in given.directories:
        frames = [output.fields(path) for path in chosen(output.field_files(directory))]
        name = given.field
        most = max(float(np.abs(frame[name]).max()) for frame in frames)
        limits = (0, 0.65) if name == "solids_fraction" else (-most, most)
        width, height = (np.ptp(frames[0][f"{axis}_faces"]) for axis in "xy")
        figure, axes = plt.subplots(1, len(frames), sharey=True, squeeze=False,
                                    figsize=(len(frames) * max(1.5, 4.2 * width / height) + 1.6, 4.8))
        for panel, frame in zip(axes[0], frames):
            mesh = draw(panel, frame, name, limits)
        axes[0][0].set_ylabel("y [cm]")
        figure.colorbar(mesh, ax=axes, shrink=0.8, label=name.replace("_", " "))
        plots.save(figure, Path(directory), "fields.png")

