#!/usr/bin/env python3
"""Figure 12: gas pressure over that of the atmosphere along the centreline, mean over the plateau; 100 um particles in
air."""
import numpy as np

import paper_figures
from scree.bin_discharge import BELOW

ATMOSPHERE = 101325.0  # [Pa]; p_g of the program is over that of still gas
SHOWN = 40.0  # [cm] above the orifice


def draw(given, directories):
    run = paper_figures.Discharge(directories["fine_air"], paper_figures.window_of("fine_air"))
    pressure = 1 + run.mean_centreline("gas_pressure") / ATMOSPHERE
    curves, label = {"with air": (run.y, pressure)}, "gas pressure / atmospheric pressure"
    figure, axes, rows = paper_figures.draw_centrelines(curves, label, (-BELOW, SHOWN))
    seen = pressure[(run.y > -BELOW) & (run.y < SHOWN)]
    axes.set_xlim(seen.min() - 0.1 * np.ptp(seen), seen.max() + 0.1 * np.ptp(seen))
    axes.ticklabel_format(axis="x", useOffset=False)
    axes.tick_params(axis="x", labelsize=9)
    rows = [(name, y, ratio, (ratio - 1) * ATMOSPHERE * 10) for name, y, ratio in rows]
    return figure, ["run", "y [cm]", "p_g/p_atm", "p_g - p_atm [dyn/cm2]"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_12", __doc__, draw, ["fine_air"])
