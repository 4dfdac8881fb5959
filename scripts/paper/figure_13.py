#!/usr/bin/env python3
"""Figure 13: greyscale maps of nu of a rising bubble at the end (0.5 s): full model, critical state, no friction."""
import numpy as np

import paper_figures
from scree import bubble_rise

RUNS = {"bubble_relaxed": "(a) relaxed", "bubble_critical_state": "(b) critical state",
        "bubble_no_friction": "(c) no friction"}


def draw(given, directories):
    runs = [bubble_rise.Run(directories[name], rows=False) for name in RUNS]
    for run, label in zip(runs, RUNS.values()):
        run.label = label
    figure = bubble_rise.draw_bubbles(runs, paper_figures.GREYS)
    faces = [100 * runs[0].last[name] for name in ("x_faces", "y_faces")]
    x, y = np.meshgrid(*((face[1:] + face[:-1]) / 2 for face in faces))
    columns = [array.ravel() for array in (x, y, *(run.last["solids_fraction"] for run in runs))]
    return figure, ["x [cm]", "y [cm]", *(f"nu {name.removeprefix('bubble_')}" for name in RUNS)], list(zip(*columns))


if __name__ == "__main__":
    paper_figures.produce("figure_13", __doc__, draw, RUNS)
