"""Quantities of interest and cost of a finished run of the bins and of the bubble, in cgs units."""
import json
from pathlib import Path

import numpy as np
from contourpy import contour_generator

from scree import bin_discharge, bubble_rise, output

HEIGHTS = np.linspace(0, bin_discharge.ABOVE, 201)  # of the profiles above the orifice plane [cm]
UNITS = {"rate": "g/s", "bottom": "cm", "top": "cm", "width": "cm", "area": "cm2"}
SAME_BUBBLE = 0.05  # difference, as a part of the width, up to which a contour is that of the bubble found
FIRST = 0.1  # [s], the start whose cost is told apart


def bin_quantities(directory, window):
    """Mean rate [g/s] over the window of time, and the profiles of nu and chi along the centreline, means over the field
    files of the window."""
    run = bin_discharge.Run(directory)
    nu, chi = [], []
    for path in output.files_between(directory, *window):
        fields = output.fields(path, ["solids_fraction", "frictional_pressure_ratio"])
        nu.append(profile(run, fields["solids_fraction"]))
        chi.append(profile(run, fields["frictional_pressure_ratio"]) if run.chi is not None else without_chi(directory))
    return {"rate": np.array([run.mean_rate(window)]), "nu on the centreline": np.mean(nu, axis=0),
            "chi on the centreline": np.mean(chi, axis=0)}


def profile(run, field):
    return np.interp(HEIGHTS, run.y, run.centreline(field))


def without_chi(directory):
    """critical_state is chi = 1; other models without the unknown do not write it."""
    model = output.case(directory).get("friction_model")
    return np.full(len(HEIGHTS), 1.0 if model == "critical_state" else np.nan)


def bubble_quantities(directory, window):
    """bottom, top, width [cm] and area [cm2] of the bubble at the end, which steps hit exactly.

    The region of bubble_rise counts parts of cells, 2 % of the width on a coarse grid: its ends are taken from the
    contour instead. A bubble that still stands on the floor has no closed one, and keeps what was counted."""
    fields = output.last_fields(directory)
    found = bubble_rise.bubble(fields)
    for loop in closed_contours(*bubble_rise.full_width(fields)):
        (left, bottom), (right, top) = loop.min(axis=0), loop.max(axis=0)
        ends = dict(bottom=bottom, top=top, width=right - left)
        if all(abs(ends[name] - found[name]) < SAME_BUBBLE * found["width"] for name in ends):
            found.update(ends)
            break
    return {name: np.array([value]) for name, value in found.items()}


def closed_contours(x, y, nu):
    """The closed lines on which nu has the level of the bubble: arrays of points [cm]."""
    segments = contour_generator(x, y, nu).lines(bubble_rise.LEVEL)
    return [segment for segment in segments if len(segment) > 3 and np.allclose(segment[0], segment[-1])]


def quantities(read, directory, window):
    """What `read` (bin_quantities or bubble_quantities) finds, kept in quantities.json: contours take seconds."""
    kept = Path(directory) / "quantities.json"
    key = {"read": read.__name__, "window": list(window)}
    if kept.exists():
        stored = json.loads(kept.read_text())
        if stored["of"] == key:
            return {name: np.array(value) for name, value in stored["values"].items()}
    values = read(directory, window)
    kept.write_text(json.dumps({"of": key, "values": {name: value.tolist() for name, value in values.items()}}))
    return values


def cost(directory, window):
    """Cost of a run, names as in work_precision_tables.COST_NAMES."""
    summary = output.summary(directory)
    phases = output.phase_seconds(summary)
    monitor = output.monitor(directory)
    time, spent = output.time_of(monitor), monitor["cpu_seconds"]
    at = lambda t: np.interp(t, time, spent)
    begin, end = min(window[0], time[-1]), min(window[1], time[-1])
    return {
        "steps": summary["steps"], "newton": summary["newton_iterations"], "krylov": summary["krylov_iterations"],
        "cpu_s": summary["cpu_seconds"]["total"], "wall_s": summary["wall_seconds"],
        "cpu_residual_s": phases["residual"], "cpu_jacobian_s": phases["jacobian"],
        "cpu_setup_s": phases["preconditioner_setup"], "cpu_krylov_s": phases["krylov"],
        "memory_per_rank_MB": summary["peak_memory_per_rank_bytes"] / 1e6,
        "cpu_s_first_0.1_s": at(FIRST) - spent[0] if time[-1] >= FIRST else np.nan,
        "cpu_s_per_s_late": (at(end) - at(begin)) / (end - begin) if end > begin else np.nan,
    }
