#!/usr/bin/env python3
"""Figure 9: plateau rate against the width of the orifice, its exponent, and C of W = C rho_i sqrt(g) D_o^1.5 H,
(28)."""
import matplotlib.pyplot as plt
import numpy as np

import paper_figures
import paper_runs
from scree.bin_discharge import PAPER_RATE

WIDTHS = paper_runs.WIDTHS
WINDOW = (1.0, 2.0)  # [s], the same for all
DENSITY = 0.60 * 2.9  # rho_i [g/cm3]
GRAVITY = 981.0  # [cm/s2]
PAPER_EXPONENT = 1.4


def rates(directories):
    """Orifice width [cm] -> mean rate [g/s]; directories in the order of WIDTHS."""
    return {float(width): run.mean_rate() for width, run in zip(WIDTHS, paper_figures.discharges(directories, WINDOW))}


def fit(rates):
    """Exponent of W ~ D_o^m by least squares of the logarithms, and the rate at 1 cm [g/s]."""
    width, rate = np.log(list(rates)), np.log(list(rates.values()))
    exponent, intercept = np.polyfit(width, rate, 1)
    return exponent, np.exp(intercept)


def beverloo(width, rate):
    """C of (28), H = 1 cm."""
    return rate / (DENSITY * np.sqrt(GRAVITY) * width**1.5)


def draw(given, directories):
    found = rates(directories.values())
    exponent, factor = fit(found)
    mean_c = np.mean([beverloo(width, rate) for width, rate in found.items()])
    figure, axes = plt.subplots(figsize=(5.6, 4.4))
    width = np.linspace(1.3, 2.1, 50)
    axes.plot(list(found), list(found.values()), "ko", label="plateau rate")
    axes.plot(width, factor * width**exponent, "k-", linewidth=1.4, label=rf"$W \sim D_o^{{{exponent:.2f}}}$")
    correlation = mean_c * DENSITY * np.sqrt(GRAVITY) * width**1.5
    axes.plot(width, correlation, "k:", linewidth=1.4, label=f"(28), C = {mean_c:.2f}")
    axes.plot(1.4, PAPER_RATE, "kx", label="paper, 1.4 cm, about 144 g/s")
    axes.set(xlabel="orifice width $D_o$ (cm)", ylabel="discharge rate (g/s)", xlim=(1.3, 2.1), ylim=(0, None))
    axes.legend(loc="lower right", fontsize=10)
    rows = [(w, rate, beverloo(w, rate), factor * w**exponent) for w, rate in found.items()]
    return figure, ["D_o [cm]", "rate [g/s]", "C", f"fit D_o^{exponent:.3f} [g/s]"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_09", __doc__, draw, WIDTHS.values())
