#!/usr/bin/env python3
"""Figure 7: nu along the centreline, means over the plateau; 1 mm particles, critical state and air against the full
model."""
import paper_figures
from scree.bin_discharge import ABOVE, BELOW

RUNS = {"bin": "relaxed", "bin_critical_state": "critical state", "bin_air": "relaxed, with air"}


def draw(given, directories):
    runs = paper_figures.discharges(directories.values(), paper_figures.window_of("bin_air"))
    curves = {label: (run.y, run.mean_centreline("solids_fraction")) for label, run in zip(RUNS.values(), runs)}
    figure, axes, rows = paper_figures.draw_centrelines(curves, r"solids fraction $\nu$", (-BELOW, ABOVE))
    axes.set_xlim(0, 0.65)
    return figure, ["run", "y [cm]", "nu"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_07", __doc__, draw, RUNS)
