#!/usr/bin/env python3
"""Figure 1: yield loci in the plane of principal stresses for different solids fractions, from (14), (15), (18)."""
import matplotlib.pyplot as plt
import numpy as np

import paper_figures
import yield_locus

FRACTIONS = (0.595, 0.600)
LINE = {"dilation": "--", "compaction": "-"}


def draw(given, directories):
    figure, axes = plt.subplots(figsize=(5.4, 5.4))
    rows = []
    for number, nu in enumerate(FRACTIONS, 1):
        p_c = yield_locus.critical_pressure(nu) / 1e3
        for name, (chi, first, second) in yield_locus.branches().items():
            label = f"{name} branch" if number == 1 else None
            axes.plot(p_c * first, p_c * second, "k" + LINE[name], linewidth=1.5, label=label)
            axes.plot(p_c * second, p_c * first, "k" + LINE[name], linewidth=1.5)
            rows += [(f"{nu:g}", name, *values) for values in zip(chi, 1e3 * p_c * first, 1e3 * p_c * second)]
        critical = p_c * np.array(yield_locus.principal_stresses(1.0, yield_locus.N_COMPACTION))
        axes.plot(*critical, "ko", markersize=4)
        axes.annotate(f"$C_{number}$", critical, xytext=(5, -11), textcoords="offset points")
        top = p_c * yield_locus.apex()
        label = rf"$V_{number}$, $\nu_{number}$ = {nu:.3f}"
        axes.annotate(label, (top, top), xytext=(5, 2), textcoords="offset points")
    reach = 1.45 * p_c * yield_locus.apex()
    slope = (1 - yield_locus.SIN_PHI) / (1 + yield_locus.SIN_PHI)
    axes.plot([0, reach], [0, slope * reach], "k:", linewidth=1.2, label="critical states")
    axes.plot([0, slope * reach], [0, reach], "k:", linewidth=1.2)
    axes.annotate("O", (0, 0), xytext=(6, 6), textcoords="offset points")
    axes.set(xlabel=r"$\sigma_1$ (10$^3$ dyn/cm$^2$)", ylabel=r"$\sigma_2$ (10$^3$ dyn/cm$^2$)", xlim=(0, reach),
             ylim=(0, reach), aspect="equal")
    axes.legend(loc="upper right", fontsize=10)
    return figure, ["solids_fraction", "branch", "chi", "sigma_1 [dyn/cm2]", "sigma_2 [dyn/cm2]"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_01", __doc__, draw)
