#!/usr/bin/env python3
"""Figure 6: nu across the jet at three distances below the orifice, means over the plateau; 1 mm particles."""
import matplotlib.pyplot as plt
import numpy as np

import paper_figures

BELOW = (0.3, 1.5, 4.0)  # [cm]; the paper says "just below" and lower
SHOWN = 2.5  # half width [cm]


def profiles(run):
    """distance below the orifice -> nu across the half."""
    nu = run.mean("solids_fraction")
    return {distance: np.array([np.interp(-distance, run.y, column) for column in nu.T]) for distance in BELOW}


def draw(given, directories):
    run = paper_figures.Discharge(directories["bin"], paper_figures.window_of("bin"))
    figure, axes = plt.subplots(figsize=(6.0, 4.4))
    rows = []
    x = np.concatenate([-run.x[::-1], run.x])
    for (distance, nu), line in zip(profiles(run).items(), paper_figures.LINES):
        nu = np.concatenate([nu[::-1], nu])
        axes.plot(x, nu, label=f"{distance:g} cm below", **line)
        rows += paper_figures.rows_of(f"{distance:g}", x, nu)
    for side in (-1, 1):
        axes.axvline(side * run.orifice, **paper_figures.ORIFICE)
    axes.set(xlabel="x (cm)", ylabel=r"solids fraction $\nu$", xlim=(-SHOWN, SHOWN), ylim=(0, 0.6))
    axes.legend(loc="upper right", fontsize=10)
    return figure, ["below the orifice [cm]", "x [cm]", "nu"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_06", __doc__, draw, ["bin"])
