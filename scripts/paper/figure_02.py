#!/usr/bin/env python3
"""Figure 2: the yield locus scaled by p_c, onto which the loci of all solids fractions fall, from (14), (15)."""
import matplotlib.pyplot as plt

import paper_figures
import yield_locus

LINE = {"dilation": "--", "compaction": "-"}


def draw(given, directories):
    figure, axes = plt.subplots(figsize=(5.2, 5.2))
    rows = []
    for name, (chi, first, second) in yield_locus.branches().items():
        axes.plot(first, second, "k" + LINE[name], linewidth=1.5, label=f"{name} branch")
        axes.plot(second, first, "k" + LINE[name], linewidth=1.5)
        rows += paper_figures.rows_of(name, chi, first, second)
    critical = yield_locus.principal_stresses(1.0, yield_locus.N_COMPACTION)
    top = yield_locus.apex()
    for label, point, shift in (("O", (0, 0), (6, 6)), ("$C_1$", critical, (6, -8)), ("$C_2$", critical[::-1], (-4, 8)),
                                ("P", (top, top), (5, 3))):
        axes.plot(*point, "ko", markersize=4)
        axes.annotate(label, point, xytext=shift, textcoords="offset points")
    axes.set(xlabel=r"$\sigma_1/p_c$", ylabel=r"$\sigma_2/p_c$", xlim=(0, 1.6), ylim=(0, 1.6), aspect="equal")
    axes.legend(loc="upper right", fontsize=10)
    return figure, ["branch", "chi", "sigma_1/p_c", "sigma_2/p_c"], rows


if __name__ == "__main__":
    paper_figures.produce("figure_02", __doc__, draw)
