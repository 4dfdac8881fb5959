"""The picture of H8: growth rates against wave number, factor per step against dt, short waves in the bin, the column.

    plot.py WORK_DIRECTORY [FILE]      what flutter.py left in its --work directory; usual FILE: flutter.png beside this
"""
import csv
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "support"), str(HERE.parents[2] / "scripts")]
from scree import output  # noqa: E402
from scree.plots import draw_to_files, plt  # noqa: E402
from waves import RATIO, divergence, lagged_factor  # noqa: E402


def table(path):
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def rates(axes, rows):
    for friction, tau, label in (("none", 1e-3, "none"), ("critical_state", 1e-3, "critical_state"),
                                 ("instantaneous", 1e-3, "instantaneous"), ("relaxed", 1e-3, "relaxed, 1 ms"),
                                 ("relaxed", 1e-1, "relaxed, 100 ms")):
        line = [(float(row["kh"]), float(row["rate"])) for row in rows
                if row["base"] == "plug dilating" and float(row["cell"]) == 1e-3 and row["friction"] == friction
                and float(row["tau"]) == tau and row["advection"] == "upwind"]
        axes.plot(*zip(*line), label=label)
    axes.axhline(0, color="0.6", linewidth=1)
    axes.set(xlabel="$kh$", ylabel="growth rate [1/s]", title="continuous in time, coupled")
    axes.legend(fontsize=9)


def factors(axes, rows):
    dense = np.geomspace(1e-7, 1e-2, 120)
    labels = {0: "0 (instantaneous)", 1e-4: "0.1 ms", 1e-3: "1 ms", 1e-2: "10 ms"}
    for number, (tau, label) in enumerate(labels.items()):
        line = [(float(row["dt"]), float(row["factor"])) for row in rows
                if row["base"] == "plug dilating" and float(row["tau"]) == tau and row["advection"] == "upwind"]
        axes.semilogx(*zip(*line), "o", color=f"C{number}", markersize=4, label=label)
        axes.semilogx(dense, [lagged_factor(0.6, 1e-6, (1e-3, 2e-3), tau, dt) for dt in dense], color=f"C{number}",
                      linewidth=1)
    axes.axhline(1, color="0.6", linewidth=1)
    axes.axhline(RATIO, color="0.6", linewidth=1, linestyle=":")
    axes.text(1.2e-7, RATIO - 0.03, r"$3(n-1)/(4n\,\sin^2\phi)$", fontsize=9, va="top")
    axes.set(xlabel="$\\Delta t$ [s]", ylabel="factor per step", title="chi lagged by a step", ylim=(0.7, 1.55))
    axes.legend(title="tau; lines: theory", fontsize=9, title_fontsize=9, loc="lower left")


def bin_runs(axes, rows):
    for number, name in enumerate(dict.fromkeys(row["run"] for row in rows)):
        line = np.array([(float(row["time"]), float(row["div_across"])) for row in rows if row["run"] == name])
        axes.semilogy(1e3 * line[:, 0], line[:, 1], "--" if number == 2 else "-", label=name)
    dilation = next(float(row["dilation"]) for row in rows[::-1] if row["run"] == "instantaneous, coupled")
    axes.semilogy([0, 8], [dilation] * 2, ":", color="0.4", linewidth=1)
    axes.set(xlabel="time [ms]", ylabel="div v between neighbours [1/s]", title="plug of the bin, $\\Delta t$ = 0.1 ms")
    axes.legend(fontsize=8, loc="center right")
    axes.text(0.1, 1.15 * dilation, "dilation", fontsize=9)


def column(axes, work):
    fields = output.last_fields(work / "lagged")
    x, y = 1e3 * fields["x_faces"], 1e3 * fields["y_faces"]
    last = np.searchsorted(y, 60)
    div = divergence(fields)[:last]
    image = axes.pcolormesh(x, y[:last + 1], div, cmap="RdBu_r", vmin=-abs(div).max(), vmax=abs(div).max())
    axes.set(xlabel="x [mm]", ylabel="y [mm]", title="lagged: div v", aspect="equal")
    plt.colorbar(image, ax=axes, label="1/s", shrink=0.7)


def main():
    work = Path(sys.argv[1])
    target = Path(sys.argv[2]) if len(sys.argv) > 2 else HERE / "flutter.png"
    draw_to_files(**{"font.size": 10, "axes.labelsize": 11, "axes.titlesize": 11, "savefig.dpi": 110})
    figure, axes = plt.subplots(1, 4, figsize=(15, 4), gridspec_kw={"width_ratios": [1, 1, 1, 0.55]})
    rates(axes[0], table(work / "rates.csv"))
    factors(axes[1], table(work / "steps.csv"))
    bin_runs(axes[2], table(HERE / "bin.csv"))
    column(axes[3], work)
    figure.savefig(target)


main()
