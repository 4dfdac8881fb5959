#!/usr/bin/env python3
"""Figure 5: velocity of the particles at an instant of the plateau over a greyscale map of nu, bottom of the bin."""
import numpy as np

import paper_figures
from scree import bin_discharge

INSTANT = 3.0  # [s]


def draw(given, directories):
    run = paper_figures.Discharge(directories["bin"], at=INSTANT)
    figure = bin_discharge.draw_bottom_map(run, paper_figures.GREYS)
    shown = run.y < bin_discharge.ABOVE
    x, y = np.meshgrid(run.x, run.y[shown])
    columns = [array.ravel() for array in (x, y, run.nu[shown], run.velocity[shown, :, 0], run.velocity[shown, :, 1])]
    return figure, ["x [cm]", "y [cm]", "nu", "v_x [cm/s]", "v_y [cm/s]"], list(zip(*columns))


if __name__ == "__main__":
    paper_figures.produce("figure_05", __doc__, draw, ["bin"])
