"""The pictures of speed_against_error.py: error against CPU seconds, what simpler models save and cost, presets and ranks.

Readable in grey: advection schemes differ in lightness and line, time schemes in the marker."""
import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from scree import plots, work_precision

COLOURS = {"upwind": "#16324f", "van_albada": "#e08214"}
LINES = {"upwind": "-", "van_albada": "--"}
MARKERS = {"beuler": "o", "bdf": "s", "arkimex": "^"}
PHASES = {"residual": "#0b2239", "jacobian": "#37618a", "setup": "#e08214", "krylov": "#f6c98b", "other": "#dddddd"}
PHASE_NAMES = {"jacobian": "Jacobian", "setup": "preconditioner set-up", "krylov": "Krylov"}
MARKS = ("o", "s", "^", "D", "v")
SMALLEST = 1e-3  # [%], for logarithmic axes: less is drawn there


def draw_all(rows, references, usual, case, out):
    """Into out/plots, what the runs allow."""
    plots.draw_to_files(**{"savefig.dpi": 120, "font.size": 10.5, "axes.labelsize": 11})
    draw_if(any(references.values()), lambda: draw_total(rows, references, usual, case), out, "error_total.png")
    draw_if(any(row.errors["time"] for row in rows), lambda: draw_time(rows, usual, case), out, "error_time.png")
    draw_if(work_precision.model_variants(rows), lambda: draw_models(rows, usual, case), out, "models.png")
    solvers = [row for row in rows if row.setting == usual.but(grid=row.setting.grid, solver=row.setting.solver,
                                                               ranks=row.setting.ranks)]
    varied = {row.setting.grid for row in solvers if row.setting.solver or row.setting.ranks > 1}
    solvers = [row for row in solvers if row.setting.grid in varied]
    draw_if(solvers, lambda: draw_solvers(solvers, case), out, "solvers.png")


def draw_if(condition, draw, out, name):
    """A picture, or none of an earlier state where there is nothing to draw."""
    if condition:
        plots.save(draw(), out, name)
    else:
        (out / "plots" / name).unlink(missing_ok=True)


# ---- error against cost ----


def panels(names, case, x_label, y_label):
    count = max(len(names), 1)
    columns = 2 if count > 1 else 1
    lines = math.ceil(count / columns)
    figure, grid = plt.subplots(lines, columns, figsize=(5.4 * columns, 3.9 * lines + 0.8), squeeze=False)
    for axes in grid.flat[count:]:
        axes.set_visible(False)
    for axes, name in zip(grid.flat, names):
        axes.set_title(name, loc="left", fontsize=11)
        axes.set(xscale="log", yscale="log", xlabel=x_label, ylabel=y_label)
    figure.suptitle(case, x=0.01, ha="left", fontsize=12)
    return figure, list(grid.flat[:count])


def per_cent(error):
    return max(100 * error, SMALLEST)


def plain_numbers(axis):
    """1, 3, 10 ... without powers, so that an axis of less than a decade has labels too."""
    low, high = axis.get_view_interval()
    decades = math.log10(high / low)
    axis.set_major_locator(LogLocator(subs=(1,) if decades > 3 else (1, 3) if decades > 1 else (1, 1.5, 2, 3, 4, 5, 7)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def point(axes, row, error, doubt, marker_size):
    """A marker, hollow where the error is less than its uncertainty."""
    colour = COLOURS[row.setting.advection]
    hollow = not error >= doubt
    axes.plot(row.cost["cpu_s"], per_cent(error), MARKERS[row.setting.time_scheme], color=colour, markersize=marker_size,
              markerfacecolor="white" if hollow else colour, markeredgewidth=1.2, zorder=3, clip_on=False)


def band(axes, doubt):
    """The errors that cannot be told from zero, in grey, and axes with room around the points."""
    low, high = axes.get_ylim()
    low, high = min(low, 50 * doubt if doubt > 0 else low), max(high, 200 * doubt)
    axes.set_ylim(low, 1.2 * high)  # labels above the highest point
    if doubt > 0:
        axes.axhspan(low, 100 * doubt, color="0.88", zorder=0)
    for axis in (axes.xaxis, axes.yaxis):
        plain_numbers(axis)


def by_curve(rows, *names):
    """Rows by these names of their settings and by the family of their grids."""
    groups = {}
    for row in rows:
        groups.setdefault((*(getattr(row.setting, name) for name in names), row.family), []).append(row)
    return groups


def curve(axes, group, kind, name, doubt, text, below=False):
    """Points of a group joined by its line in their order, each with what `text` says of it."""
    group = [row for row in group if math.isfinite(row.error(kind, name))]
    if not group:
        return
    setting = group[0].setting
    axes.plot([row.cost["cpu_s"] for row in group], [per_cent(row.error(kind, name)) for row in group],
              LINES[setting.advection], color=COLOURS[setting.advection], zorder=2,
              linewidth=1.3 if group[0].family == "uniform" else 2.6)
    place, align = (5, 5 if setting.advection == "upwind" else -12), "left"
    if below:
        place, align = (-6, -12), "right"
    for row in group:
        error = row.error(kind, name)
        point(axes, row, error, doubt, 6.5)
        axes.annotate(text(row), (row.cost["cpu_s"], per_cent(error)), xytext=place, ha=align, textcoords="offset points",
                      fontsize=8.5, color=COLOURS[setting.advection])


def draw_total(rows, references, usual, case):
    """Error against the extrapolated value: a curve over grids for each pair of schemes and family of grids; small points
    are the runs of other accuracies."""
    names = [name for name, reference in references.items() if reference]
    figure, all_axes = panels(names, case, "CPU seconds", "error against extrapolated value (%)")
    same = [row for row in rows if row.setting.model == usual.model and not row.setting.solver and row.setting.ranks == 1]
    on_curve = [row for row in same if row.setting.accuracy == usual.accuracy]
    finest = min(on_curve, key=lambda row: row.cell_size).family
    lowest = finest if finest != "uniform" else None  # graded cells lie below uniform ones
    for axes, name in zip(all_axes, names):
        doubt = references[name].doubt
        for row in same:
            if row not in on_curve and math.isfinite(row.error("total", name)):
                point(axes, row, row.error("total", name), doubt, 3)
        labelled = set()
        axes.margins(x=0.2)
        # upwind and beuler first: these are labelled
        for _, group in sorted(by_curve(on_curve, "advection", "time_scheme").items(),
                               key=lambda item: (item[0][0], list(MARKERS).index(item[0][1]))):
            group = sorted(group, key=lambda row: -row.cell_size)
            curve(axes, group, "total", name, doubt, lambda row: grid_label(row, labelled), group[0].family == lowest)
        band(axes, doubt)
    legend(figure, rows, f"small: accuracy other than {usual.accuracy:g}")
    return figure


def grid_label(row, labelled):
    """The grid, once: the schemes lie close together."""
    if row.setting.grid in labelled:
        return ""
    labelled.add(row.setting.grid)
    return row.setting.grid


def draw_time(rows, usual, case):
    """Error against the tightest accuracy on the usual grid: a curve over accuracies for each pair of schemes."""
    same = [row for row in rows if row.setting.model == usual.model and row.setting.grid == usual.grid
            and not row.setting.solver and row.setting.ranks == 1]
    names = [name for name in work_precision.quantities(rows)
             if any(math.isfinite(row.error("time", name)) for row in same)]
    figure, all_axes = panels(names, f"{case}, {usual.grid}", "CPU seconds", "error against tightest accuracy (%)")
    for axes, name in zip(all_axes, names):
        doubt = max(row.doubt("time", name) for row in same if math.isfinite(row.doubt("time", name)))
        for group in by_curve(same, "advection", "time_scheme").values():
            group = sorted(group, key=lambda row: -row.setting.accuracy)
            curve(axes, group, "time", name, doubt, lambda row: f"{row.setting.accuracy:g}"
                  if (row.setting.advection, row.setting.time_scheme) == (usual.advection, usual.time_scheme) else "")
        band(axes, doubt)
    legend(figure, same, f"numbers: accuracy, of {usual.advection} with {usual.time_scheme}")
    return figure


def legend(figure, rows, remark):
    used = lambda name, table: [key for key in table if any(getattr(row.setting, name) == key for row in rows)]
    handles = [Line2D([], [], color=COLOURS[key], linestyle=LINES[key], label=key) for key in used("advection", COLOURS)]
    handles += [Line2D([], [], color="0.3", marker=MARKERS[key], linestyle="", label=key)
                for key in used("time_scheme", MARKERS)]
    handles += [plt.Rectangle((0, 0), 1, 1, color="0.88", label="uncertainty (hollow: within it)")]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), fontsize=9.5, title=remark,
                  title_fontsize=9.5, ncol=3 if len(handles) > 4 else len(handles))


# ---- models, presets ----


def draw_models(rows, usual, case):
    """What a simpler model costs of the full one, and how far it is off on the same grid."""
    pairs = sorted(work_precision.model_variants(rows), key=lambda pair: pair[0].cost["cpu_s"] / pair[1].cost["cpu_s"])
    names = work_precision.quantities(rows)
    places = np.arange(len(pairs))
    figure, (costs, errors) = plt.subplots(1, 2, sharey=True, figsize=(10.5, 1.9 + 0.5 * len(pairs)))
    ratios = [row.cost["cpu_s"] / full.cost["cpu_s"] for row, full in pairs]
    costs.barh(places, ratios, height=0.55, color="#37618a")
    for place, ratio in zip(places, ratios):
        costs.annotate(f"{ratio:.2f}", (ratio, place), xytext=(4, 0), textcoords="offset points", va="center", fontsize=9.5,
                       bbox=dict(facecolor="white", edgecolor="none", pad=1))
    costs.axvline(1, color="0.5", linewidth=1, zorder=0)
    costs.set(xlabel="CPU seconds, of those of the full model", xlim=(0, 1.15 * max(1, *ratios)))
    costs.set_yticks(places, [variant_label(row, full, usual) for row, full in pairs])
    shades = plt.get_cmap("cividis")(np.linspace(0, 0.85, len(names)))
    for name, mark, shade in zip(names, MARKS, shades):
        found = [(per_cent(row.error("model", name)), place) for (row, _), place in zip(pairs, places)
                 if math.isfinite(row.error("model", name))]
        if found:
            errors.plot(*zip(*found), mark, color=shade, label=name, markersize=7, clip_on=False)
    errors.set(xscale="log", xlabel="difference from the full model (%)")
    errors.set_xlim(left=min(errors.get_xlim()[0], 0.1))
    plain_numbers(errors.xaxis)
    errors.grid(axis="y", color="0.9")
    errors.tick_params(axis="y", length=0)
    figure.legend(loc="upper center", bbox_to_anchor=(0.5, 0), ncol=len(names), fontsize=9.5)
    figure.suptitle(f"{case}: simpler models", x=0.01, ha="left", fontsize=12)
    return figure


def variant_label(row, full, usual):
    """What differs from the full model, and the grid if it is not the usual one."""
    mine, its = row.setting, full.setting
    parts = [mine.friction_model] if mine.friction_model != its.friction_model else []
    parts += [f"{mine.granular_temperature} T"] if mine.granular_temperature != its.granular_temperature else []
    parts += [f"gas {mine.gas} (full: {its.gas})"] if mine.gas != its.gas else []
    parts += [f"{mine.width} width"] if mine.width != its.width else []
    return ", ".join(parts) + (f", {mine.grid}" if mine.grid != usual.grid else "")


def draw_solvers(rows, case):
    """CPU seconds of all ranks by phase for presets and numbers of ranks; the wall seconds beside them."""
    order = {grid: number for number, grid in enumerate(dict.fromkeys(
        row.setting.grid for row in sorted(rows, key=lambda row: -row.cell_size)))}
    grids = by_curve(sorted(rows, key=lambda row: order[row.setting.grid]), "grid")
    heights = [len(group) for group in grids.values()]
    figure, all_axes = plt.subplots(len(grids), 1, squeeze=False, gridspec_kw={"height_ratios": heights},
                                    figsize=(8.2, 1.6 + 0.36 * sum(heights) + 0.5 * len(grids)))
    for axes, ((grid, _), group) in zip(all_axes[:, 0], grids.items()):
        draw_phases(axes, sorted(group, key=lambda row: -row.cost["cpu_s"]))
        axes.set_title(grid, loc="left", fontsize=11)
    all_axes[-1, 0].set_xlabel("CPU seconds of all ranks")
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour, label=PHASE_NAMES.get(phase, phase))
               for phase, colour in PHASES.items()]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=5, fontsize=9.5)
    figure.suptitle(f"{case}: presets and ranks", x=0.01, ha="left", fontsize=12)
    return figure


def draw_phases(axes, rows):
    for place, row in enumerate(rows):
        phases = {name: row.cost[f"cpu_{name}_s"] for name in PHASES if name != "other"}
        phases["other"] = max(0.0, row.cost["cpu_s"] - sum(phases.values()))
        left = 0.0
        for name, seconds in phases.items():
            axes.barh(place, seconds, left=left, height=0.62, color=PHASES[name])
            left += seconds
        axes.annotate(f"wall {row.cost['wall_s']:.3g} s", (left, place), xytext=(4, 0), textcoords="offset points",
                      va="center", fontsize=9)
    axes.set_yticks(range(len(rows)), [f"{row.setting.preset}, {row.setting.ranks} rank{'s' * (row.setting.ranks > 1)}"
                                       for row in rows])
    axes.margins(x=0.14)
    axes.set_xlim(left=0)
