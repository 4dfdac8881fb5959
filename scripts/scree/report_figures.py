"""The pictures of a run's report: curves and axes as SVG that takes the page's colours, frames of fields as PNG."""
import base64
import io
import re
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm, Normalize
from PIL import Image

from scree import case_file, plots

INK = "#010203"  # stands for the colour of the page's text
LINES = ("#2a7fb8", "#d9822b", "#3a9a5b", "#b0486a", "#7d6bb5", "#8c7853")  # readable on light and on dark
STYLE = {**plots.STYLE, "font.size": 10, "axes.labelsize": 10.5, "lines.linewidth": 1.4, "savefig.bbox": "standard",
         "text.color": INK, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK, "axes.edgecolor": INK,
         "figure.facecolor": "none", "axes.facecolor": "none", "savefig.facecolor": "none", "svg.fonttype": "none", "font.sans-serif": ["DejaVu Sans"],
         "figure.constrained_layout.use": False}  # which takes as long as the drawing
MARGINS = dict(left=0.18, right=0.98, bottom=0.17, top=0.96)  # of curves

FRAMES = 40  # at most, of each field
FIELDS = 6  # at most
PIXELS = 560  # of the longer side of a frame
SLIMMEST = 3.0  # longer over shorter side; slimmer domains are stretched
SAMPLED = 8  # times that the colour scale looks at
LOGARITHMIC = 50.0  # a field whose greatest values are so many times its median gets a logarithmic scale
DECADES = 4  # of that scale
NO_PARTICLES = 1e-3  # solids fraction, below which the fields of the particles mean nothing
OF_PARTICLES = ("velocity", "granular_temperature", "frictional_pressure_ratio")


# ---- SVG ----


def svg(figure, name):
    """The figure as an inline SVG element with ids of its own; closes the figure."""
    stream = io.StringIO()
    with plt.rc_context({"svg.hashsalt": name}):
        figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    text = stream.getvalue()
    text = re.sub(r"<metadata>.*?</metadata>", "", text[text.index("<svg"):], flags=re.DOTALL)
    text = re.sub(r' id="[a-zA-Z]+[0-9A-Za-z]*_[0-9]+"', "", text)  # figure_1 and its like: alike in all figures
    text = re.sub(r'<svg (.*?)width="([\d.]+)pt" height="[\d.]+pt"', r'<svg \1style="width: \2pt"', text, count=1,
                  flags=re.DOTALL)
    return text.replace(INK, "currentColor")


# ---- curves ----


def curves(table, columns, name, label, logarithmic=False):
    """Columns of the monitor against time as SVG; columns: name -> words. label: of the vertical axis."""
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(5.6, 2.9), gridspec_kw=MARGINS)
        for (column, words), colour in zip(columns.items(), LINES):
            axes.plot(table.time, table[column], color=colour, label=words)
        axes.set(xlabel="time (s)", ylabel=label)
        if logarithmic and all((table[column] > 0).any() for column in columns):
            axes.set_yscale("log")
        if len(columns) > 1:
            axes.legend(fontsize=9)
        return svg(figure, name)


def profiles(run, field, name):
    """A field of one dimension at some of its times, as SVG."""
    at = {time: plots.size_of(run.at(time, [field])[field]) for time in some(run.times, len(LINES))}
    unit = run.attributes[field].get("unit", "1")
    return profile_curves({time: (values.x, values) for time, values in at.items()}, "x (m)",
                          plots.label_of(field, unit), name)


def line_profiles(table, column, unit, name):
    """A field along a sampled line at some of its times, as SVG. table: see Run.lines."""
    at = {time: table[table.time == time] for time in some(table.time.unique(), len(LINES))}
    axes = [axis for axis in "xyz" if axis in table]
    distance = lambda part: np.sqrt(sum((part[axis] - part[axis].iloc[0]) ** 2 for axis in axes))
    return profile_curves({time: (distance(part), part[column]) for time, part in at.items()},
                          "distance along the line (m)", plots.label_of(column, unit), name)


def some(items, count):
    """At most `count` of the items at even distances, with the first and the last."""
    return [items[k] for k in np.unique(np.linspace(0, len(items) - 1, min(len(items), count)).round().astype(int))]


def profile_curves(at, across, label, name):
    """Curves at some times as SVG. at: time -> (places, values)."""
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(5.6, 3.4), gridspec_kw=MARGINS)
        for (time, (places, values)), colour in zip(at.items(), LINES):
            axes.plot(places, values, color=colour, label=f"{time:.3g} s")
        axes.set(xlabel=across, ylabel=label)
        axes.legend(fontsize=9)
        return svg(figure, name)


# ---- animations ----


@dataclass
class Animation:
    """A field in time. axes: SVG of the axes and the colour bar; place: left, top, width, height of the frames in it
    [%]; frames: PNG as data URIs, one a time; stretch: of the scale along the shorter side."""

    field: str
    axes: str
    place: tuple
    frames: list
    stretch: float


def fields_to_show(run):
    """The names of the fields at cell centres, the solids fraction first."""
    names = [name for name in run.attributes if not name.endswith(("_face", "_faces"))]
    return sorted(names, key=lambda name: (name != "solids_fraction", name != "velocity"))[:FIELDS]


def shown_times(run):
    """Times of the frames: all, or FRAMES of them at even distances, with the first and the last [s]."""
    return some(run.times, FRAMES)


def plane(run, field, time):
    """The values of a field in a plane as an array [down, across], and NaN where they mean nothing."""
    names = [field, "solids_fraction"] if field in OF_PARTICLES else [field]
    data = run.at(time, names)
    values = plots.middle_slice(plots.size_of(data[field])).values.astype(float)
    if field in OF_PARTICLES:
        values[plots.middle_slice(data["solids_fraction"]).values < NO_PARTICLES] = np.nan
    return values


def scale_of(run, field, times):
    """The colour scale that all frames of a field share."""
    if field == "solids_fraction":
        return Normalize(0, float(run.case.get("solids_fraction_max", 0.65)))
    values = np.concatenate([plane(run, field, time).ravel() for time in some(times, SAMPLED)])
    values = values[np.isfinite(values)]
    if not len(values):
        return Normalize(0, 1)
    low, middle, high = np.percentile(values, [0.5, 50, 99.5])
    if low >= 0 and high > LOGARITHMIC * max(middle, 1e-300):
        return LogNorm(max(low, 10.0**-DECADES * high), high)
    return Normalize(low, high if high > low else low + 1)


def animation(run, field, times):
    """The Animation of a field of two or three dimensions."""
    norm = scale_of(run, field, times)
    colours = plt.get_cmap(plots.SAND if field == "solids_fraction" else "viridis")
    x_faces, y_faces = (run.at(times[0], [field])[f"{axis}_face"].values for axis in "xy")
    columns, rows = pixels_of(x_faces, y_faces)
    at_x, at_y = cells_of(x_faces, columns), cells_of(y_faces, rows)[::-1]
    frames = [png(plane(run, field, time)[np.ix_(at_y, at_x)], norm, colours) for time in times]
    axes, place = frame_axes(run, field, (x_faces, y_faces), (columns, rows), ScalarMappable(norm, colours))
    return Animation(field, axes, place, frames, stretch_of(x_faces, y_faces))


def pixels_of(x_faces, y_faces):
    """Columns and rows of a frame."""
    across, down = np.ptp(x_faces), np.ptp(y_faces)
    ratio = np.clip(across / down, 1 / SLIMMEST, SLIMMEST)
    return (PIXELS, round(PIXELS / ratio)) if ratio > 1 else (round(PIXELS * ratio), PIXELS)


def stretch_of(x_faces, y_faces):
    """By how much slim domains are drawn wider than they are."""
    ratio = np.ptp(x_faces) / np.ptp(y_faces)
    return max(ratio, 1 / ratio, SLIMMEST) / SLIMMEST


def cells_of(faces, count):
    """The cells in which `count` even points lie."""
    points = faces[0] + (np.arange(count) + 0.5) / count * np.ptp(faces)
    return np.clip(np.searchsorted(faces, points) - 1, 0, len(faces) - 2)


def png(values, norm, colours):
    """An array of values as a PNG of 255 colours; the last of the palette is transparent, for NaN."""
    shades = np.clip(np.ma.filled(norm(np.ma.masked_invalid(values)), np.nan), 0, 1)
    shades = np.where(np.isnan(shades) & np.isfinite(values), 0, shades)  # zeros on a logarithmic scale
    indices = np.where(np.isnan(values), 255, np.round(254 * np.nan_to_num(shades))).astype(np.uint8)
    palette = (255 * colours(np.linspace(0, 1, 255))[:, :3]).round().astype(np.uint8)
    image = Image.fromarray(indices, "P")
    image.putpalette(palette.ravel().tolist() + [0, 0, 0])
    stream = io.BytesIO()
    image.save(stream, "PNG", transparency=255, optimize=True)
    return "data:image/png;base64," + base64.b64encode(stream.getvalue()).decode()


def frame_axes(run, field, faces, pixels, colours):
    """The axes around the frames with plates and colour bar, as SVG, and the place of the frames in it [%]."""
    width, height = pixels[0] / 100, pixels[1] / 100
    left, right, bottom, top = 0.75, 1.1, 0.6, 0.15
    total = left + width + right, bottom + height + top
    place = left / total[0], bottom / total[1], width / total[0], height / total[1]
    with plt.rc_context({**STYLE, "axes.spines.top": True, "axes.spines.right": True}):
        figure = plt.figure(figsize=total)
        axes = figure.add_axes(place)
        axes.set(xlim=(100 * faces[0][0], 100 * faces[0][-1]), ylim=(100 * faces[1][0], 100 * faces[1][-1]),
                 xlabel="x (cm)", ylabel="y (cm)")
        axes.locator_params(axis="x", nbins=max(2, int(width * 1.6)))
        draw_plates(axes, run.case, faces)
        beside = figure.add_axes([(left + width + 0.15) / total[0], place[1], 0.14 / total[0], place[3]])
        bar = figure.colorbar(colours, cax=beside, label=plots.label_of(field, run.attributes[field].get("unit", "1")))
        bar.outline.set_visible(False)
        bar.solids.set_rasterized(True)
        picture = svg(figure, f"axes_{field}")
    return picture, tuple(100 * part for part in (place[0], 1 - place[1] - place[3], place[2], place[3]))


def draw_plates(axes, case, faces):
    """The plates of a case as black lines with their openings; only those across a plane case are understood."""
    for key in [key for key in case if key.startswith("plate_") and key.endswith("_position")]:
        name = key.removesuffix("_position")
        along = 0 if case.get(f"{name}_axis") == "y" else 1
        position = 100 * case_file.lengths(case[key])[0]
        openings = [100 * edge for edge in case_file.lengths(case.get(f"{name}_openings", ""))]
        edges = [100 * faces[along][0], *openings, 100 * faces[along][-1]]
        for begin, end in zip(edges[::2], edges[1::2]):
            line = ([begin, end], [position] * 2)
            axes.plot(*(line if along == 0 else line[::-1]), color=INK, linewidth=2.2, solid_capstyle="butt")
