#!/usr/bin/env python3
"""Finding (b): which parameters move the plateau rate. d ln W/d ln p by central differences about Table 2, one
parameter at a time, on the coarse grid, as a bar chart. The mark on a bar is its uncertainty: how far the differences
of one and of two steps are apart, and what steps in time with a third of the local error change, over the step."""
import matplotlib.pyplot as plt
import numpy as np

import paper_figures
import paper_runs
from paper_runs import DIFFERENCES, PARAMETERS

BASE, TIGHT = "parameters/base", "parameters/accuracy"


def names():
    return [BASE, TIGHT, *(parameter.entry(steps).name for parameter in PARAMETERS for steps in DIFFERENCES)]


def log_rate(directory):
    return np.log(paper_figures.Discharge(directory, paper_runs.TABLE[BASE].window).mean_rate())


def slope(parameter, rates, steps):
    """d ln W/d ln p by the central difference over `steps`."""
    value, step = parameter.value, steps * parameter.step
    return (rates[steps] - rates[-steps]) / np.log((value + step) / (value - step))


def derivative(parameter, rates, noise):
    """Slope, its uncertainty, and the second difference d2 ln W/d(ln p)2. rates: steps -> ln W, 0 among them."""
    inner, outer = slope(parameter, rates, 1), slope(parameter, rates, 2)
    step = parameter.step / parameter.value
    curvature = (rates[1] - 2 * rates[0] + rates[-1]) / step**2
    return inner, abs(inner - outer) + noise / step, curvature


def derivatives_of(parameter, directories):
    """The same from the directories of its runs, by name."""
    base = log_rate(directories[BASE])
    rates = {steps: log_rate(directories[parameter.entry(steps).name]) for steps in DIFFERENCES}
    return derivative(parameter, {**rates, 0: base}, abs(log_rate(directories[TIGHT]) - base))


def draw(given, directories):
    found = {parameter: derivatives_of(parameter, directories) for parameter in PARAMETERS}
    order = sorted(found, key=lambda parameter: abs(found[parameter][0]))
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    slopes, doubts = ([found[parameter][k] for parameter in order] for k in (0, 1))
    axes.barh(range(len(order)), slopes, xerr=doubts, color="0.7", edgecolor="black", linewidth=0.8, capsize=3)
    axes.axvline(0, color="black", linewidth=0.8)
    axes.set_yticks(range(len(order)), [parameter.symbol for parameter in order])
    for row, (value, doubt) in enumerate(zip(slopes, doubts)):
        axes.annotate(f"{value:+.2f}", (value + np.sign(value) * doubt, row), xytext=(5 * np.sign(value), 0),
                      textcoords="offset points", ha="left" if value >= 0 else "right", va="center", fontsize=10)
    axes.margins(x=0.15)
    axes.set(xlabel=r"$d\,\ln W/d\,\ln p$")
    rows = [(parameter.symbol, parameter.option, f"{parameter.value:g} {parameter.unit}".strip(), parameter.step,
             *found[parameter]) for parameter in reversed(order)]
    return figure, ["parameter", "option", "value", "step", "d ln W/d ln p", "uncertainty", "d2 ln W/d(ln p)2"], rows


if __name__ == "__main__":
    paper_figures.produce("parameters", __doc__, draw, names(), grid="coarse")
