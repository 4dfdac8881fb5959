#!/usr/bin/env python3
"""Section 2.3: grid-scale flutter of the instantaneous model. The part of v_y that alternates from cell to cell along
the height, over the mean of v_y, against that of the relaxed model; the greatest of the fields from 0.2 to 1 s."""
import matplotlib.pyplot as plt
import numpy as np

import paper_figures
from scree import output

RUNS = {"bin": "relaxed", "bin_instantaneous": "instantaneous"}
WINDOW = (0.2, 1.0)  # [s], in which the plug dilates and compacts by turns
HEIGHTS = (3.0, 40.0)  # over the orifice [cm]
PLUG = 10.0  # above it smooth fields have next to no alternating part [cm]


def alternating(directory):
    """Heights [cm], and the root mean square over the width of what alternates, over the mean speed [-]: its greatest
    over the fields of the window, or the last where a run ends before it.

    The fourth difference over 16: 1 for a wave of two cells, small with the fourth power of the cell for smooth
    fields."""
    end = paper_figures.Discharge(directory).monitor_time[-1]
    times = [output.time_of_file(path) for path in output.field_files(directory)]
    parts = []
    for time in [t for t in times if WINDOW[0] <= t <= WINDOW[1] + 0.02] or [end]:
        run = paper_figures.Discharge(directory, at=time)
        v = run.velocity[..., 1]
        inside = (run.y > HEIGHTS[0]) & (run.y < HEIGHTS[1])
        found = np.full(v.shape, np.nan)
        found[2:-2] = np.diff(v, 4, axis=0) / 16
        parts.append(np.sqrt(np.mean(found[inside] ** 2, axis=1)) / np.abs(v[inside].mean()))
    return run.y[inside], np.max(parts, axis=0)


def short_waves(directory):
    """Root mean square of the same over the heights of the plug [-]."""
    y, part = alternating(directory)
    return float(np.sqrt(np.mean(part[y > PLUG] ** 2)))


def draw(given, directories):
    figure, axes = plt.subplots(figsize=(6.0, 4.2))
    rows = []
    for (name, label), line in zip(RUNS.items(), paper_figures.LINES):
        y, part = alternating(directories[name])
        axes.semilogy(y, part, label=label, **line)
        rows += paper_figures.rows_of(label, y, part)
    axes.set(xlabel="height over the orifice plane (cm)", ylabel="alternating part of $v_y$ over its mean",
             xlim=HEIGHTS)
    axes.legend(loc="upper right")
    return figure, ["run", "y [cm]", "alternating part of v_y over its mean"], rows


if __name__ == "__main__":
    paper_figures.produce("flutter", __doc__, draw, RUNS)
