#!/usr/bin/env python3
"""Pictures of a run by ParaView, without a window: by a script what the guide does by hand.

    pvbatch scripts/paraview_pictures.py out/bin_discharge --mirror x --window "-0.04, 0.04, 0, 0.25"
    pvbatch scripts/paraview_pictures.py out/bin_3d --mirror x y

Without a screen, before each: xvfb-run -a -s "-noreset -screen 0 1280x1024x24".

Writes to OUT_DIR/plots: in two dimensions paraview_000000.png ... and paraview.png, some of them side by side; in three
paraview_slice.png and paraview_isosurface.png of the last time. Needs ParaView 5.11 or later with its Python (Debian:
paraview python3-paraview python3-pil, and xvfb xauth libgl1-mesa-dri for no screen). Nothing else of Scree does."""
import argparse
import sys
from pathlib import Path

from paraview import simple as pv
from PIL import Image

PANELS = 3
HEIGHT, BAR = 480, 110  # pixels of a picture, and of the strip with time and colours at its right
ARROWS = 24  # along the longest side
NU_LIMITS = 0, 0.65
GRAINS = 0.05  # solids fraction below which the velocity says nothing
INK, PAPER = (0.1, 0.1, 0.1), (1, 1, 1)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", metavar="OUT_DIR", type=Path, help="output directory of a run")
    parser.add_argument("--mirror", nargs="+", choices=("x", "y", "z"), default=[],
                        help="axes with a plane of symmetry at the lower side: the other half is shown too")
    parser.add_argument("--window", help="x0, x1, y0, y1 [m] of what is shown in two dimensions; default all")
    parser.add_argument("--isosurface", type=float, default=0.2, help="solids fraction on the isosurface; default 0.2")
    given = parser.parse_args()
    if not (given.directory / "fields.xdmf").exists():
        parser.error(f"{given.directory} holds no fields.xdmf of a run")
    if given.window is not None:
        try:
            given.window = [float(part) for part in given.window.split(",")]
        except ValueError:
            given.window = []
        if len(given.window) != 4 or not (given.window[0] < given.window[1] and given.window[2] < given.window[3]):
            parser.error("--window: expected four numbers x0, x1, y0, y1 with x0 < x1 and y0 < y1")
    return given


def opened(path):
    """The reader of a fields.xdmf, and the time of ParaView at its last output."""
    reader = pv.Xdmf3ReaderS(FileName=[str(path)])
    pv.GetTimeKeeper().Time = reader.TimestepValues[-1]
    return reader


def mirrored(source, axes):
    """A source with its other halves; Reflect turns the vectors over too. Plane cells become polygons first: ParaView
    5.11 mirrors the pixels of a plane grid with their corners crossed, which leaves holes."""
    low, high = bounds_of(source)
    if axes and low[2] == high[2]:
        source = pv.ExtractSurface(Input=source)
    for axis in axes:
        source = pv.Reflect(Input=source, Plane=f"{axis.upper()} Min", CopyInput=1)
    return source


def bounds_of(source):
    """((x0, y0, z0), (x1, y1, z1)) of a source."""
    source.UpdatePipeline(pv.GetTimeKeeper().Time)
    bounds = source.GetDataInformation().GetBounds()
    return bounds[0::2], bounds[1::2]


def new_view(width, height):
    view = pv.CreateView("RenderView")
    view.ViewSize = [width, height]
    view.Background = PAPER
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    return view


def coloured(source, view, array, limits, title, place="CELLS"):
    """Shows a source with the colours of an array; a vector by its magnitude."""
    display = pv.Show(source, view)
    display.Representation = "Surface"
    display.Ambient, display.Diffuse = (0, 1) if place == "POINTS" else (1, 0)  # flat things keep their colours
    pv.ColorBy(display, (place, array, "Magnitude") if array == "velocity" else (place, array))
    colours = pv.GetColorTransferFunction(array)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(*limits)
    bar = pv.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize = bar.LabelFontSize = 14
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.4, 10
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-#.2g", "%-#.2g"
    display.SetScalarBarVisibility(view, True)


def greatest(source, array):
    """The greatest magnitude of a vector at the points."""
    source.UpdatePipeline(pv.GetTimeKeeper().Time)
    found = source.PointData[array]
    return max(found.GetRange(-1)[1], 1e-30) if found else 1.0


def raster(source, low, high):
    """The points of an even raster in a box that lie among grains; of cells alone, arrows would crowd where they are small."""
    size = [b - a for a, b in zip(low, high)]
    spacing = max(size) / ARROWS
    counts = [max(1, round(length / spacing)) for length in size]
    inset = [0.5 * length / count for length, count in zip(size, counts)]
    image = pv.ResampleToImage(Input=source, UseInputBounds=0, SamplingDimensions=counts)
    image.SamplingBounds = [x for a, b, d in zip(low, high, inset) for x in (a + d, b - d)]
    return pv.Threshold(Input=image, Scalars=["POINTS", "solids_fraction"], UpperThreshold=GRAINS,
                        ThresholdMethod="Above Upper Threshold")


def arrows(source, view, shape, low, high):
    """Arrows of the velocity on a raster; the longest in the last state spans three of its points."""
    points = raster(source, low, high)
    longest = 3 * max(b - a for a, b in zip(low, high)) / ARROWS
    glyph = pv.Glyph(Input=points, GlyphType=shape, GlyphMode="All Points", OrientationArray=["POINTS", "velocity"],
                     ScaleArray=["POINTS", "velocity"], ScaleFactor=longest / greatest(points, "velocity"))
    display = pv.Show(glyph, view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = PAPER
    display.LineWidth = 2


def time_text(reader, view):
    text = pv.Show(pv.AnnotateTimeFilter(Input=reader, Format="{time:0.3f} s"), view)
    text.Color, text.FontSize, text.WindowLocation = INK, 14, "Upper Right Corner"


def look_at_plane(view, low, high):
    """Looks along z at a window of the plane, with the strip at its right. Only then: the first Render moves the camera."""
    pv.Render(view)
    scale = (high[1] - low[1]) / HEIGHT
    centre = [0.5 * (low[0] + high[0] + scale * BAR), 0.5 * (low[1] + high[1])]
    view.InteractionMode = "2D"
    view.CameraParallelProjection, view.CameraParallelScale = 1, 0.5 * scale * HEIGHT
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [*centre, 0], [*centre, 1], [0, 1, 0]


def look_at_box(view, low, high, above):
    """Looks at a box from the side and above, or below, with z upwards."""
    pv.Render(view)
    size = max(b - a for a, b in zip(low, high))
    centre = [0.5 * (a + b) for a, b in zip(low, high)]
    view.CameraFocalPoint, view.CameraViewUp = centre, [0, 0, 1]
    view.CameraPosition = [c + size * far for c, far in zip(centre, (1.0, -2.0, 0.6 if above else -0.6))]
    pv.ResetCamera(view)


def frames(given, reader, data):
    """A picture of each output time of a plane run: solids fraction, arrows of the velocity."""
    low, high = bounds_of(data)
    if given.window:
        low, high = given.window[0::2], given.window[1::2]
    view = new_view(round(HEIGHT * (high[0] - low[0]) / (high[1] - low[1])) + BAR, HEIGHT)
    coloured(data, view, "solids_fraction", NU_LIMITS, "solids fraction")
    time_text(reader, view)
    arrows(data, view, "2D Glyph", (*low[:2], 0), (*high[:2], 0))
    look_at_plane(view, low, high)
    written = []
    for index, time in enumerate(reader.TimestepValues):
        view.ViewTime = time
        pv.Render(view)
        written.append(given.directory / "plots" / f"paraview_{index:06d}.png")
        pv.SaveScreenshot(str(written[-1]), view)
    return written


def side_by_side(paths, target):
    """Some pictures in one file, first and last among them; the colours are explained once."""
    count = min(PANELS, len(paths))
    parts = [Image.open(paths[round(k * (len(paths) - 1) / max(count - 1, 1))]).convert("RGB") for k in range(count)]
    step = parts[0].width
    whole = Image.new("RGB", (count * step, HEIGHT), "white")
    for index, part in enumerate(parts):
        whole.paste(part, (index * step, 0))
        if index < count - 1:
            whole.paste("white", (index * step + step - BAR + 4, HEIGHT // 4, (index + 1) * step, HEIGHT))
    save(whole, target)


def save(picture, path):
    """A small file: 128 colours are enough for these."""
    picture.quantize(128).save(path, optimize=True)


def section(given, reader, data, isosurface):
    """A slice of a run in three dimensions through the middle of y, or its isosurface of the solids fraction."""
    low, high = bounds_of(data)
    view = new_view(HEIGHT * 4 // 5, HEIGHT)
    if isosurface:
        at_points = pv.CellDatatoPointData(Input=data, ProcessAllArrays=1)
        shown = pv.Contour(Input=at_points, ContourBy=["POINTS", "solids_fraction"], Isosurfaces=[given.isosurface])
        coloured(shown, view, "velocity", (0, greatest(shown, "velocity")), "speed [m/s]", "POINTS")
    else:
        # Off the middle by a little: there is a plane of the grid there, where two cells would compete.
        place = [0.5 * (a + b) + 1e-3 * (b - a) for a, b in zip(low, high)]
        shown = pv.Slice(Input=data)
        shown.SliceType.Origin, shown.SliceType.Normal = place, [0, 1, 0]
        coloured(shown, view, "solids_fraction", NU_LIMITS, "solids fraction")
        arrows(data, view, "Arrow", (low[0], place[1], low[2]), (high[0], place[1], high[2]))
    outline = pv.Show(pv.Outline(Input=data), view)
    outline.AmbientColor = outline.DiffuseColor = INK
    time_text(reader, view)
    look_at_box(view, low, high, above=not isosurface)
    pv.Render(view)
    target = given.directory / "plots" / ("paraview_isosurface.png" if isosurface else "paraview_slice.png")
    pv.SaveScreenshot(str(target), view)
    save(Image.open(target).convert("RGB"), target)


def main():
    given = arguments()
    (given.directory / "plots").mkdir(exist_ok=True)
    reader = opened(given.directory / "fields.xdmf")
    data = mirrored(reader, given.mirror)
    low, high = bounds_of(reader)
    if high[2] > low[2]:
        section(given, reader, data, isosurface=False)
        section(given, reader, data, isosurface=True)
    else:
        side_by_side(frames(given, reader, data), given.directory / "plots" / "paraview.png")
    print(f"Pictures: {given.directory / 'plots'}", flush=True)
    for view in pv.GetRenderViews():
        pv.Delete(view)


if __name__ == "__main__":
    sys.exit(main())
