"""Plots of runs: the look that all have, maps of fields, the monitor; what the commands that draw share."""
import argparse
import re

import matplotlib.pyplot as plt
import numpy as np

from scree import output

STYLE = {
    "font.size": 12,
    "axes.labelsize": 13,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "figure.dpi": 100,
    "savefig.dpi": 180,
    "savefig.bbox": "tight",
    "figure.constrained_layout.use": True,
}
SAND = "YlOrBr"  # colours of solids fractions
ARROWS = 24  # along the longer side of a map


def draw_to_files(**style):
    """For commands: no windows, and the look that all have with changes of its style."""
    plt.switch_backend("Agg")
    plt.rcParams.update({**STYLE, **style})


def arguments(text, *more):
    """Parses OUT_DIR ... and the options `more`, pairs (name, keywords of add_argument); what is drawn then goes to files."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directories", nargs="+", metavar="OUT_DIR", help="output directory of a run")
    for name, keywords in more:
        parser.add_argument(name, **keywords)
    found = parser.parse_args()
    for directory in found.directories:
        if not output.field_files(directory):
            parser.error(f"{directory} holds no fields of a run")
    draw_to_files()
    return found


def save(figure, directory, name):
    """Writes directory/plots/name."""
    (directory / "plots").mkdir(exist_ok=True)
    figure.savefig(directory / "plots" / name)
    plt.close(figure)


def unit_text(unit):
    """A unit as people write it: m2/s2 as m²/s², none as a dash."""
    return "–" if unit in ("", "1", "-") else re.sub(r"(?<=[a-zA-Z])[23]", lambda power: "²³"[int(power[0]) - 2], unit)


def label_of(name, unit):
    """The label of an axis: the words of a name and the unit."""
    return f"{name.replace('_', ' ')} ({unit_text(unit)})"


def size_of(field):
    """The magnitude of a vector; any other field as it is."""
    if "component" not in field.dims:
        return field
    size = np.sqrt((field**2).sum("component"))
    return size.rename(field.name).assign_attrs(field.attrs)


def middle_slice(field):
    """A plane of a field: in three dimensions the one half way along z."""
    for axis in ("z", "z_face"):
        if axis in field.dims:
            field = field.isel({axis: field.sizes[axis] // 2})
    return field


def draw_field(run, name, time=None, axes=None, arrows=None):
    """See Run.plot."""
    data = run.at(time, [name, *([arrows] if arrows else [])])
    field = middle_slice(size_of(data[name]))
    with plt.rc_context(STYLE):
        figure = axes.figure if axes else plt.figure()
        axes = axes or figure.subplots()
        if field.ndim == 1:
            axes.plot(field[field.dims[0]], field)
            axes.set(xlabel=f"{field.dims[0][0]} (m)", ylabel=label_of(field.name, field.attrs["units"]))
        else:
            draw_map(axes, field, data)
            if arrows:
                draw_arrows(axes, middle_slice(data[arrows]))
        axes.set_title(f"t = {float(data.time):.4g} s", loc="left", fontsize=12)
    return figure


def draw_map(axes, field, data):
    """Colours of a plane field with a colour bar, both axes in the same scale. data: the dataset with the faces."""
    down, across = field.dims
    colours = SAND if field.name == "solids_fraction" else "viridis"
    at_cells = {down, across} <= set("xyz")
    places = [data[f"{axis}_face"] if at_cells else field[axis] for axis in (across, down)]
    image = axes.pcolormesh(*places, field, shading="flat" if at_cells else "nearest", cmap=colours)
    axes.figure.colorbar(image, ax=axes, label=label_of(field.name, field.attrs["units"]))
    axes.set(xlabel=f"{across[0]} (m)", ylabel=f"{down[0]} (m)", aspect="equal")


def draw_arrows(axes, vector):
    """Arrows of a plane vector field on an even lattice of points."""
    x, y = vector.x.values, vector.y.values
    spacing = max(np.ptp(x), np.ptp(y)) / ARROWS
    lattice = vector.sel(x=even(x, spacing), y=even(y, spacing), method="nearest")
    axes.quiver(lattice.x, lattice.y, lattice.sel(component="x"), lattice.sel(component="y"), color="#16324f",
                angles="xy")


def even(places, spacing):
    """Points at even distances between the ends of `places`."""
    count = max(2, round(np.ptp(places) / spacing))
    return np.linspace(places[0], places[-1], count)


def draw_monitor(run, columns, axes=None):
    """See Run.plot_monitor."""
    table = run.monitor
    units = {table.attrs["units"][name] for name in columns}
    with plt.rc_context(STYLE):
        figure = axes.figure if axes else plt.figure(figsize=(6.4, 4.2))
        axes = axes or figure.subplots()
        for name in columns:
            axes.plot(table.time, table[name], label=name)
        label = label_of(columns[0], *units) if len(columns) == 1 else ", ".join(map(unit_text, sorted(units)))
        axes.set(xlabel="time (s)", ylabel=label)
        if len(columns) > 1:
            axes.legend()
    return figure
