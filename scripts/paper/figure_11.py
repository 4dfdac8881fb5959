#!/usr/bin/env python3
"""Figure 11: nu along the centreline, means over the plateau; 100 um particles with and without air."""
import figure_10
import paper_figures
from scree.bin_discharge import ABOVE, BELOW


def draw(given, directories):
    runs = paper_figures.discharges(directories.values(), paper_figures.window_of("fine_air"))
    labels = figure_10.RUNS.values()
    curves = {label: (run.y, run.mean_centreline("solids_fraction")) for label, run in zip(labels, runs)}
    figure, axes, rows = paper_figures.draw_centrelines(curves, r"solids fraction $\nu$", (-BELOW, ABOVE))
    axes.set_xlim(0.4, 0.65)
    return figure, ["run", "y [cm]", "nu"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_11", __doc__, draw, figure_10.RUNS)
