"""The report of a run: one HTML file that holds all that it shows, for a browser without a network.

    scree-report OUT_DIR                   # writes OUT_DIR/report.html
    python3 -m scree.report OUT_DIR -o FILE

What happened, the fields as an animation, curves in time, quantities, what the solver did and took, the program's
remarks, the case as it was understood. A run that has not ended has a report of what is there."""
import argparse
import json
import re
import sys
from html import escape
from pathlib import Path

import numpy as np

from scree import report_figures as figures
from scree.output import mean_over, phase_seconds, unit_of
from scree.plots import draw_to_files, unit_text
from scree.program import clock
from scree.results import Run

#: Groups of curves: title -> (columns of the monitor, label of the axis). Columns that a run does not have are left out.
CURVES = {
    "Rate of discharge": (r"discharge_rate|flux_\w+", "kg/s"),
    "Flow of gas": (r"gas_flux_\w+", "m³/s"),
    "Mass in the domain": (r"mass", "kg"),
    "Height of the bed": (r"bed_height", "m"),
    "Greatest speeds": (r"speed_max|gas_speed_max", "m/s"),
    "Solids fraction, least and greatest": (r"solids_fraction_(min|max)", "part of the volume"),
    "Frictional pressure ratio, least and greatest": (r"frictional_pressure_ratio_(min|max)", "ratio"),
    "Granular temperature, least and greatest": (r"granular_temperature_(min|max)", "m²/s²"),
    "Gas pressure, least and greatest": (r"gas_pressure_(min|max)", "Pa"),
}
SOLVER_CURVES = {
    "Time step": (r"dt", "s"),
    "Local error of a step": (r"local_error", "norm"),
    "Newton and Krylov iterations of a step": (r"(newton|krylov)_iterations", "iterations"),
    "Processor time so far": (r"cpu_seconds", "s"),
}
LOGARITHMIC = ("Time step", "Granular temperature, least and greatest", "Newton and Krylov iterations of a step")
MEANINGS = {
    "discharge_rate": "particles that leave the domain, per second",
    "mass": "particles in the domain",
    "bed_height": "height of the bed's surface, mean over the width",
    "speed_max": "greatest speed of the particles",
    "gas_speed_max": "greatest speed of the gas",
    "mass_error": "particles that the solution lost or made, over those at the start",
    "gas_volume_error": "gas that the solution lost or made, over that at the start",
}
PHASES = {"residual": "residual of the equations", "jacobian": "Jacobian matrix",
          "preconditioner_setup": "set-up of the preconditioner", "krylov": "solution of the linear systems"}
#: Rows of the table about the solver: words -> key of summary.json.
FIGURES = {
    "cells": "cells", "unknowns of a cell": "unknowns_per_cell", "MPI ranks": "ranks", "time steps": "steps",
    "longest time step [s]": "dt_max", "Newton iterations": "newton_iterations",
    "Krylov iterations": "krylov_iterations",
    "steps rejected: local error above the accuracy": "rejected_error",
    "steps rejected: the solver did not converge": "rejected_solver",
    "unknowns kept in bounds by the step limits": "unknowns_limited",
}
PROGRESS = re.compile(r"time \S+ s\s+dt \S+ s\s+step \d+")
MORE_THAN_ENOUGH = 200  # lines of remarks
WORST_TIMES = 8  # rows of the table of rejected steps


# ---- pieces of HTML ----


def table(rows, head=()):
    """A table. Cells are texts; a cell that is a number is set to the right."""

    def cell(tag, content):
        number = isinstance(content, (int, float))
        text = figure(content) if number else content if isinstance(content, Raw) else escape(str(content))
        return f"<{tag} class=number>{text}</{tag}>" if number else f"<{tag}>{text}</{tag}>"

    lines = ["<tr>" + "".join(cell("th", name) for name in head) + "</tr>"] if head else []
    lines += ["<tr>" + "".join(cell("td", content) for content in row) + "</tr>" for row in rows]
    return "<div class=scroll><table>" + "\n".join(lines) + "</table></div>"


class Raw(str):
    """Text that is HTML already."""


def figure(value):
    """A number with four digits."""
    if isinstance(value, float) and not np.isfinite(value):
        return "–"
    whole = float(value).is_integer() and abs(value) < 1e9
    return f"{int(value):,}".replace(",", " ") if whole else f"{value:.4g}"


def words_of(name):
    return name.replace("_", " ")


def identifier(title):
    return re.sub(r"\W+", "_", title).lower().strip("_")


# ---- sections ----


def what_happened(run):
    """How the run ended, in sentences."""
    summary, monitor = run.summary, run.monitor
    reached = summary.get("time", monitor.time.iloc[-1] if len(monitor) else 0.0)
    end = summary.get("end")
    wanted = run.case.get("end_time")
    if end == "end_time":
        verdict = "<span class=good>The run reached its end time.</span>"
    elif end:
        verdict = f"<span class=bad>The run ended early: {escape(end)}.</span>"
    else:
        verdict = "<span class=bad>The run has not ended: there is no summary.json.</span>"
    lines = [f"<p>{verdict} It simulated {reached:.4g} s" + (f" of {escape(wanted)} s" if wanted else "") + "."]
    if summary:
        lines.append(f"That took {clock(summary['wall_seconds'])} on {summary['ranks']} "
                     f"rank{'s' * (summary['ranks'] > 1)}, {summary['cpu_seconds']['total']:.3g} CPU seconds in all.")
    return " ".join(lines) + "</p>" + table(list(main_numbers(run)))


def main_numbers(run):
    """The few numbers that one wants first."""
    monitor = run.monitor
    if "discharge_rate" in monitor and monitor.discharge_rate.abs().max() > 0 and len(monitor) > 1:
        begin, end = late(run)
        rate = mean_over((begin, end), monitor.time, monitor.discharge_rate)
        yield f"rate of discharge, mean from {begin:.3g} s to {end:.3g} s", f"{rate:.4g} kg/s"
    if "mass" in monitor and len(monitor):
        yield "particles in the domain", f"{monitor.mass.iloc[0]:.4g} kg at first, {monitor.mass.iloc[-1]:.4g} kg at last"
    if "mass_error" in monitor and len(monitor):
        yield "particles lost or made by the solution", f"{monitor.mass_error.iloc[-1]:.1e} of those at the start"
    if run.summary:
        yield "cells", figure(run.summary["cells"])
        yield "time steps", figure(run.summary["steps"])


def late(run):
    """The last half of the run [s]."""
    time = run.monitor.time
    return (time.iloc[0] + time.iloc[-1]) / 2, time.iloc[-1]


def fields_in_time(run):
    """The animation; in one dimension, curves."""
    if not run.times:
        return "<p>The run has left no fields.</p>"
    names = figures.fields_to_show(run)
    if "y_faces" not in run.attributes:
        return "<div class=curves>" + "".join(figures.profiles(run, name, f"profile_{name}") for name in names) + "</div>"
    times = figures.shown_times(run)
    shown = [figures.animation(run, name, times) for name in names]
    return "\n".join([f"<p class=quiet>{' '.join(notes(run, times, shown[0]))}</p>", controls(times),
                      "<div class=animations>", *map(animation, shown), "</div>"])


def notes(run, times, shown):
    """What one has to know to read the frames."""
    yield "A colour means the same at all times. Fields of the particles have no colour where there are none."
    if len(times) < len(run.times):
        yield f"{len(times)} of the {len(run.times)} output times are shown."
    if shown.stretch > 1.01:
        yield f"The domain is slim: the scale along its shorter side is stretched by {shown.stretch:.3g}."
    if "z_faces" in run.attributes:
        yield "The plane shown is half way along z."


def controls(times):
    last = len(times) - 1
    return (f"<div class=controls><button id=play type=button>Play</button>"
            f"<input id=time type=range min=0 max={last} value={last} aria-label='output time' "
            f"data-times='{' '.join(f'{time:.4g}' for time in times)}'>"
            f"<output id=shown_time>t = {times[-1]:.4g} s</output></div>")


def animation(one):
    """The frames of a field on top of each other, below their axes; without scripts the last is shown."""
    last = len(one.frames) - 1
    images = "".join(f"<img alt='{words_of(one.field)}' src='{frame}'{' class=shown' * (k == last)}>"
                     for k, frame in enumerate(one.frames))
    left, top, width, height = one.place
    place = f"left:{left:.3f}%;top:{top:.3f}%;width:{width:.3f}%;height:{height:.3f}%"
    return (f"<figure class=animation>"
            f"<div class=frames style='{place}'>{images}</div>{one.axes}</figure>")


def curves(run, groups):
    """Pictures of the groups of columns that the run has."""
    parts = []
    for title, (pattern, unit) in groups.items():
        columns = [name for name in run.monitor if re.fullmatch(pattern, name) and run.monitor[name].notna().any()]
        if columns and len(run.monitor) > 1:
            picture = figures.curves(run.monitor, {name: words_of(name) for name in columns}, identifier(title), unit,
                                     title in LOGARITHMIC)
            parts.append(f"<figure><h3>{title}</h3>{picture}</figure>")
    return "<div class=curves>" + "\n".join(parts) + "</div>" if parts else "<p>There are fewer than two steps.</p>"


def lines(run):
    """The fields along the sampled lines of the case."""
    if not run.lines:
        return "<p>The case samples no lines. <code>line: {axis: {from: ..., to: ...}}</code> in a case samples one.</p>"
    parts = []
    for line, rows in run.lines.items():
        for column in [name for name in rows if name not in ("time", "x", "y", "z")]:
            unit = unit_of(column, run.units)
            picture = figures.line_profiles(rows, column, unit, f"line_{line}_{column}")
            parts.append(f"<figure><h3>{escape(words_of(line))}: {words_of(column)}</h3>{picture}</figure>")
    return "<div class=curves>" + "\n".join(parts) + "</div>"


def quantities(run):
    """The quantities of the monitor: at the end, their range, their mean over the last half."""
    monitor = run.monitor
    if not len(monitor):
        return "<p>The run has made no step.</p>"
    technical = {"time", "dt", "newton_iterations", "krylov_iterations", "rejected_error", "rejected_solver", "limited",
                 "local_error", *(name for name in monitor if name.startswith("cpu_"))}
    rows = []
    for name in monitor:
        if name in technical:
            continue
        values = monitor[name]
        mean = mean_over(late(run), monitor.time, values) if len(monitor) > 1 else float("nan")
        rows.append((words_of(name), unit_text(monitor.attrs["units"][name]), float(values.iloc[-1]), float(values.min()),
                     float(values.max()), mean, MEANINGS.get(name, "")))
    return table(rows, ("quantity", "unit", "at the end", "least", "greatest", "mean of the last half", "meaning"))


def solver(run):
    """What the solver did: counts, rejected steps, where the time went."""
    summary = run.summary
    parts = []
    if summary:
        rows = [(words, summary[key]) for words, key in FIGURES.items() if key in summary]
        steps, newton = summary.get("steps", 0), summary.get("newton_iterations", 0)
        if steps and newton:
            rows += [("Newton iterations of a step, mean", newton / steps),
                     ("Krylov iterations of a Newton iteration, mean", summary.get("krylov_iterations", 0) / newton)]
        memory = summary.get("peak_memory_per_rank_bytes")
        rows += [("memory of a rank at most [MB]", memory / 1e6)] if memory else []
        rows += [("version of " + name, text) for name, text in summary.get("versions", {}).items()]
        parts += [table(rows), "<h3>Where the processor time went</h3>", phases(summary)]
    parts += ["<h3>Rejected steps</h3>", rejected(run.monitor), curves(run, SOLVER_CURVES)]
    return "\n".join(parts)


def phases(summary):
    """A bar for each phase of the processor time."""
    total = summary["cpu_seconds"]["total"]
    parts = {PHASES.get(name, words_of(name)): value for name, value in phase_seconds(summary).items()}
    parts["everything else"] = max(0.0, total - sum(parts.values()))
    bar = lambda value: Raw(f"<span class=bar style='width:{18 * value / total if total else 0:.2f}rem'></span>")
    return table([(name, float(value), f"{100 * value / total:.0f} %" if total else "–", bar(value))
                  for name, value in parts.items()], ("phase", "CPU seconds", "part", ""))


def rejected(monitor):
    """When steps were tried again with a shorter time step, and why."""
    causes = {"rejected_error": "local error above the accuracy", "rejected_solver": "the solver did not converge"}
    rows = [(f"{time:.4g}", int(count), cause) for column, cause in causes.items() if column in monitor
            for time, count in zip(monitor.time, monitor[column]) if count > 0]
    if not rows:
        return "<p>None.</p>"
    rows.sort(key=lambda row: -row[1])
    shown = sorted(rows[:WORST_TIMES], key=lambda row: float(row[0]))
    more = f"<p class=quiet>{len(rows) - len(shown)} more times had as many or fewer.</p>" if len(rows) > len(shown) else ""
    return table(shown, ("time [s]", "attempts", "reason")) + more


def remarks(run):
    """What the program said beside its progress."""
    if run.log is None:
        return "<p>The directory holds no log. scripts/run.sh and scree.run keep one.</p>"
    lines = [line.split("\r")[-1].rstrip() for line in run.log.splitlines()]
    lines = [line for line in lines if line and not PROGRESS.search(line)]
    if not lines:
        return "<p>The program made no remarks.</p>"
    more = [f"... and {len(lines) - MORE_THAN_ENOUGH} lines more"] if len(lines) > MORE_THAN_ENOUGH else []
    return "<pre>" + escape("\n".join(lines[:MORE_THAN_ENOUGH] + more)) + "</pre>"


def case_of(run):
    """The effective case as it stands in the directory."""
    file = run.directory / "case.yaml"
    if not file.exists():
        return "<p>The directory holds no case.yaml.</p>"
    words = ("All options with their values in SI units, defaults included but for what the program chooses itself. "
             "<code>scree case.yaml</code> runs the same case again.")
    return f"<p>{words}</p><details open><summary>case.yaml</summary><pre>{escape(file.read_text())}</pre></details>"


def files_of(run):
    """What the directory holds and what reads it."""
    meanings = {"monitor.csv": "quantities at each step; a table for any program",
                "fields.xdmf": "the fields at all times: open it with ParaView, Xdmf3 reader",
                "summary.json": "how the run ended and what it took", "case.yaml": "the case as understood",
                "log": "what the program said", "lines": "fields along the sampled lines of the case",
                "checkpoints": "to go on: scree -restart with this directory"}
    rows = [(name, text) for name, text in meanings.items() if (run.directory / name).exists()]
    return table(rows) + "<p>In Python: <code>scree.open(directory)</code>, see scripts/scree.</p>"


SECTIONS = {
    "What happened": what_happened,
    "The fields in time": fields_in_time,
    "Curves in time": lambda run: curves(run, CURVES),
    "Along the lines of the case": lines,
    "Quantities": quantities,
    "How the solver worked": solver,
    "Remarks and warnings": remarks,
    "The case as the program understood it": case_of,
    "Files of the run": files_of,
}


# ---- the page ----


def page(run):
    """The report as text."""
    here = Path(__file__).parent
    title = f"{run.directory.resolve().name} – report of a run of Scree"
    links = "".join(f"<a href='#{identifier(name)}'>{name}</a>" for name in SECTIONS)
    body = "\n".join(f"<section id={identifier(name)}><h2>{name}</h2>{make(run)}</section>"
                     for name, make in SECTIONS.items())
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{escape(title)}</title>
<style>
{(here / "report.css").read_text()}</style>
</head>
<body>
<h1>{escape(run.directory.resolve().name)}</h1>
<nav>{links}</nav>
{body}
<script>
{(here / "report.js").read_text()}</script>
</body>
</html>
"""


def write(directory, file=None):
    """Writes the report of a run, at once or not at all, and returns its path; without `file` it is report.html in the
    directory. Raises FileNotFoundError where there is no run."""
    run = Run(directory)
    file = Path(file or run.directory / "report.html")
    new = file.with_name(file.name + ".new")
    new.write_text(page(run), encoding="utf-8")
    new.rename(file)
    return file


def main():
    parser = argparse.ArgumentParser(prog="scree-report", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", metavar="OUT_DIR", help="output directory of a run")
    parser.add_argument("-o", "--output", type=Path, help="default: OUT_DIR/report.html")
    given = parser.parse_args()
    draw_to_files()
    try:
        print(f"Report: {write(given.directory, given.output)}")
    except (OSError, ValueError, KeyError, json.JSONDecodeError) as error:
        print(f"scree-report: {error}", file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
