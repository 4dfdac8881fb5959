#!/usr/bin/env python3
"""Figure 4: rate of discharge of 1 mm particles against time, for three relaxation times tau; gas off."""
import paper_figures
from scree.bin_discharge import PAPER_RATE

RUNS = {"bin": "τ = 10⁻³ s", "bin_tau_1e-2": "τ = 10⁻² s", "bin_tau_1e-1": "τ = 10⁻¹ s"}


def draw(given, directories):
    curves = {label: paper_figures.Discharge(directories[name]) for name, label in RUNS.items()}
    return paper_figures.draw_rates(curves, PAPER_RATE)


if __name__ == "__main__":
    paper_figures.produce("figure_04", __doc__, draw, RUNS)
