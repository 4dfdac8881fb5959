#!/usr/bin/env python3
"""Finding (a): the bin from the paper's uniform start at nu = .60 against one in equilibrium with gravity and wall
friction (Janssen). Rate and depth against time; the uniform fill is a compressed spring and bounces before
the plateau."""
import matplotlib.pyplot as plt
import numpy as np

import paper_figures

RUNS = {"bin": "uniform, ν = 0.60", "bin_equilibrium": "equilibrium"}
SHOWN = 2.0  # [s]
BOUNCING = (0.2, 1.0)  # [s], of the swings of the rate
PLATEAU = (1.0, 2.0)  # [s]


def swing(run, window=BOUNCING):
    """Root mean square of the rate about its mean over the window [g/s]."""
    t = np.linspace(*window, 2001)
    return float(np.std(np.interp(t, run.monitor_time, run.rate)))


def same_from(runs, within=0.01):
    """The time from which both rates stay as near to each other as `within` of the first [s]; NaN: not within the
    runs."""
    first, second = runs
    t = np.linspace(0, min(run.monitor_time[-1] for run in runs), 4001)
    far = np.flatnonzero(np.abs(1 - np.interp(t, second.monitor_time, second.rate)
                                / np.maximum(np.interp(t, first.monitor_time, first.rate), 1e-9)) > within)
    return float("nan") if len(far) and far[-1] == len(t) - 1 else float(t[far[-1] + 1]) if len(far) else 0.0


def draw(given, directories):
    runs = dict(zip(RUNS.values(), paper_figures.discharges(directories.values(), PLATEAU)))
    end = min(SHOWN, *(run.monitor_time[-1] for run in runs.values()))
    figure, (rates, depths) = plt.subplots(2, 1, sharex=True, figsize=(6.4, 6.4))
    rows = []
    for (label, run), line in zip(runs.items(), paper_figures.LINES):
        shown = run.monitor_time <= end * (1 + 1e-9)
        t, rate, depth = run.monitor_time[shown], run.rate[shown], run.depth[shown]
        rates.plot(t, rate, label=label, **line)
        depths.plot(t, depth, **line)
        rows += paper_figures.rows_of(label, t, rate, depth)
    rates.set(ylabel="discharge rate (g/s)", ylim=(0, None))
    rates.legend(loc="lower right")
    depths.set(xlabel="time (s)", ylabel="depth of material (cm)", xlim=(0, end))
    print(f"  rates within 1 % of each other from {same_from(list(runs.values())):.2f} s on")
    for label, run in runs.items():
        begin, until = run.window
        print(f"  {label}: mean rate of {begin:.2g} to {until:.2g} s {run.mean_rate():.1f} g/s"
              + (f", swing from .2 to 1 s {swing(run):.2f} g/s" if run.reaches(BOUNCING[1]) else ""))
    return figure, ["start", "time [s]", "rate [g/s]", "depth [cm]"], rows


if __name__ == "__main__":
    paper_figures.produce("starts", __doc__, draw, RUNS)
