#!/usr/bin/env python3
"""What the grid does to the numbers of the paper: rates, nu and chi in the orifice plane, and the bubble on up to four
grids, with the observed order and the value extrapolated to fine cells. --grid is the finest that is run; of what a run
is too short for, the coarser grids are shown alone."""
import matplotlib.pyplot as plt

import paper_figures
import paper_runs
import paper_quantities
from scree import plots

NAME = "convergence"
PANELS = {"rate of discharge": "convergence.rate",
          "ν and χ in the orifice plane": ("convergence.nu", "convergence.chi"),
          "bubble, relaxed": "convergence.relaxed", "bubble, no friction": "convergence.no_friction"}


def runs_needed(finest):
    """(name, grid) of the runs that the page needs of the quantities, up to a grid."""
    grids = paper_runs.GRIDS[:paper_runs.GRIDS.index(finest) + 1]
    names = dict.fromkeys(name for quantity in paper_quantities.SECTIONS["convergence"] for name in quantity.runs)
    return [(name, grid) for grid in grids for name in names if grid in paper_runs.TABLE[name].page]


def draw(values):
    """Values over the extrapolated one against the cell size; quantities with two grids at least."""
    figure, panels = plt.subplots(2, 2, figsize=(10, 7.6))
    for axes, (title, keys) in zip(panels.flat, PANELS.items()):
        shown = [quantity for quantity in paper_quantities.SECTIONS["convergence"] if quantity.key.startswith(keys)]
        for quantity in shown:
            limit, on_grids = values.limit(quantity), values.on_grids(quantity)
            if limit and limit.value:
                sizes = [10 * values.cell_size(quantity, grid) for grid in on_grids]
                ratios = [value / limit.value for value in on_grids.values()]
                axes.plot([*sizes, 0], [*ratios, 1], "o-", linewidth=1.2, markersize=4,
                          label=f"{quantity.what.removeprefix('bubble, ')}: {limit.how}")
        axes.axhline(1, color="0.6", linewidth=0.8)
        axes.set(xlabel="root of the mean cell area (mm)", ylabel="value over extrapolated", xlim=(0, None))
        axes.set_title(title, loc="left", fontsize=12)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(loc="best", fontsize=8)
    return figure


def table(values):
    """Header and rows."""
    header = ["quantity", "unit", *paper_runs.GRIDS, "order", "order seen", "extrapolated", "uncertainty"]
    rows = []
    for quantity in paper_quantities.SECTIONS["convergence"]:
        on_grids, limit = values.on_grids(quantity), values.limit(quantity)
        ends = (limit.order, "yes" if limit.regular else "no", limit.value, limit.doubt) if limit else ("", "", "", "")
        rows.append((quantity.what, quantity.unit, *(on_grids.get(grid, "") for grid in paper_runs.GRIDS), *ends))
    return header, rows


def main():
    given = paper_runs.arguments(__doc__, grid="quarter")
    if not given.only_draw:
        for name, grid in runs_needed(given.grid):
            given.runs.get(name, grid)
    values = paper_quantities.Values(given.runs, given.out)
    plots.draw_to_files()
    figure = draw(values)
    values.keep()
    paper_figures.save(figure, given.out, NAME, *table(values))


if __name__ == "__main__":
    paper_runs.guarded(main)
