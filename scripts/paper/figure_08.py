#!/usr/bin/env python3
"""Figure 8: chi = p_f/p_c along the centreline near the orifice, means over the plateau; 1 mm particles, gas off."""
import paper_figures

SHOWN = (-1.0, 6.0)  # [cm]


def draw(given, directories):
    run = paper_figures.Discharge(directories["bin"], paper_figures.window_of("bin"))
    chi = run.mean_centreline("frictional_pressure_ratio")
    figure, axes, rows = paper_figures.draw_centrelines({"relaxed": (run.y, chi)}, r"$p_f/p_c$", SHOWN)
    axes.set_xlim(0.7, 1.05)
    return figure, ["run", "y [cm]", "chi"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_08", __doc__, draw, ["bin"])
