#!/usr/bin/env python3
"""Figure 3: the geometries of the bin discharge and of the rising bubble, drawn from the case files as scree reads
them."""
import matplotlib.pyplot as plt
from matplotlib.patches import Rectangle

import paper_figures
import paper_runs
import scree
from scree import case_file

EDGE = dict(color="black", linewidth=2.5, solid_capstyle="butt")


def understood(given, path):
    """The options of a case as scree prints them, in SI."""
    return scree.check(path, given.runs.program)


def lengths(case, option):
    """The lengths of an option [cm]."""
    return [100 * value for value in case_file.lengths(case[option])]


def dimension(axes, begin, end, text, **place):
    """An arrow between two points, with the distance beside it."""
    axes.annotate("", begin, end, arrowprops=dict(arrowstyle="<->", color="0.3", linewidth=1))
    axes.annotate(text, [(a + b) / 2 for a, b in zip(begin, end)], color="0.2", fontsize=10,
                  textcoords="offset points", **place)


def fraction(axes, value, height):
    axes.annotate(rf"$\nu$ = {float(value):.2f}", (0, height), color="0.2", xytext=(4, 0), textcoords="offset points")


def across(axes, half_width, height):
    dimension(axes, (-half_width, height), (half_width, height), f"{2 * half_width:g} cm", xytext=(0, 4), ha="left")


def particles(axes, half_width, bottom, top):
    axes.add_patch(Rectangle((-half_width, bottom), 2 * half_width, top - bottom, facecolor="0.85", edgecolor="none"))


def finish(axes, half_width, height, title):
    axes.plot([0, 0], [0, height], color="0.3", linewidth=0.9, linestyle="-.")
    axes.set(xlim=(-2.4 * half_width, 2.4 * half_width), ylim=(-0.16 * height, 1.05 * height))
    axes.set_title(title, loc="left", fontsize=12)
    axes.axis("off")


def draw_bin(axes, case):
    half_width, height = lengths(case, "grid_x_edges")[-1], lengths(case, "grid_y_edges")[-1]
    floor, orifice = lengths(case, "plate_floor_position")[0], lengths(case, "plate_floor_openings")[-1]
    _, _, bottom, top = lengths(case, "initial_fill_box")
    particles(axes, half_width, bottom, top)
    for side in (-1, 1):
        axes.plot([side * half_width] * 2, [floor, height], **EDGE)
        axes.plot([side * orifice, side * half_width], [floor] * 2, **EDGE)
        axes.plot([side * half_width] * 2, [0, floor], color="0.5", linewidth=1, linestyle=":")
    axes.plot([-half_width, half_width], [0, 0], color="0.5", linewidth=1, linestyle=":")
    across(axes, half_width, 0.55 * height)
    right = 1.3 * half_width
    dimension(axes, (right, floor), (right, height), f"{height - floor:g} cm", xytext=(6, 0), va="center")
    dimension(axes, (right, 0), (right, floor), f"{floor:g} cm", xytext=(6, 0), va="center")
    axes.annotate(f"orifice {2 * orifice:g} cm", (0, floor), (-2.2 * half_width, -0.07 * height), color="0.2",
                  fontsize=10, arrowprops=dict(arrowstyle="-", color="0.4"))
    fraction(axes, case["initial_fill_solids_fraction"], 0.7 * height)
    finish(axes, half_width, height, "(a) bin discharge")
    return [("bin", "width", 2 * half_width), ("bin", "height", height - floor), ("bin", "below the floor", floor),
            ("bin", "orifice", 2 * orifice), ("bin", "fill", top - bottom)]


def draw_bubble(axes, case):
    half_width, height = lengths(case, "grid_x_edges")[-1], lengths(case, "grid_y_edges")[-1]
    slit, surface = lengths(case, "boundary_slit_patch")[-1], lengths(case, "initial_bed_box")[-1]
    particles(axes, half_width, 0, surface)
    for side in (-1, 1):
        axes.plot([side * half_width] * 2, [0, height], **EDGE)
    for k in range(-6, 7):
        x = k * half_width / 6.5
        length = (0.1 if abs(x) < slit else 0.05) * height
        axes.annotate("", (x, 0), (x, -length), arrowprops=dict(arrowstyle="->", color="0.3"))
    speed = {name: 100 * float(case[f"boundary_{name}_gas_velocity"]) for name in ("floor", "slit")}
    until = float(case["boundary_slit_until"])
    axes.annotate(f"{speed['floor']:g} cm/s", (-half_width, -0.07 * height), ha="right", color="0.2", fontsize=10)
    text = f"slit {2 * slit:g} cm,\n{speed['slit']:g} cm/s\nuntil {until:g} s"
    axes.annotate(text, (0.55 * half_width, -0.16 * height), color="0.2", fontsize=10)
    across(axes, half_width, 0.65 * height)
    right = 1.25 * half_width
    dimension(axes, (right, 0), (right, height), f"{height:g} cm", xytext=(6, 0), va="center")
    dimension(axes, (-right, 0), (-right, surface), f"{surface:g} cm", xytext=(-6, 0), va="center", ha="right")
    fraction(axes, case["initial_bed_solids_fraction"], 0.3 * height)
    finish(axes, half_width, height, "(b) rising bubble")
    return [("bubble", "width", 2 * half_width), ("bubble", "height", height), ("bubble", "bed", surface),
            ("bubble", "slit", 2 * slit), ("bubble", "air through the floor [cm/s]", speed["floor"]),
            ("bubble", "air through the slit [cm/s]", speed["slit"]), ("bubble", "until [s]", until)]


def draw(given, directories):
    figure, panels = plt.subplots(1, 2, figsize=(8.2, 6.4))
    rows = draw_bin(panels[0], understood(given, paper_runs.CASES / "bin_discharge" / "paper.yaml"))
    rows += draw_bubble(panels[1], understood(given, paper_runs.CASES / "bubble_rise" / "paper.yaml"))
    return figure, ["case", "what [cm]", "value"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_03", __doc__, draw)
