"""Reads the output directory of a run: monitor.csv, the HDF5 fields, the effective case. Arrays of NumPy, SI units."""
import csv
import json
from pathlib import Path

import h5py
import numpy as np

from scree import case_file

#: Units of the columns of monitor.csv that are no fields [SI]; those of fields stand in the field files.
UNITS = {"time": "s", "dt": "s", "mass": "kg", "bed_height": "m", "discharge_rate": "kg/s", "speed_max": "m/s",
         "gas_speed_max": "m/s"}
STARTS = {"cpu_": "s", "flux_": "kg/s", "gas_flux_": "m3/s"}


def monitor(directory):
    """The columns of monitor.csv: name -> array. An unfinished last row is left out, text becomes NaN."""

    def number(text):
        try:
            return float(text)
        except ValueError:
            return np.nan

    with open(Path(directory) / "monitor.csv", newline="") as file:
        header, *rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    rows = [[number(text) for text in row] for row in rows if len(row) == len(header)]
    columns = np.array(rows).reshape(len(rows), len(header)).T
    return {name.strip(): column for name, column in zip(header, columns)}


def unit_of(column, fields):
    """The unit of a column of monitor.csv. fields: name of a field -> unit."""
    if column in UNITS:
        return UNITS[column]
    for start, unit in STARTS.items():
        if column.startswith(start):
            return unit
    bare = column.removesuffix("_min").removesuffix("_max")
    # Probes: NAME_FIELD; the longest field that fits, for gas_velocity_x ends like velocity_x.
    fitting = [name for name in fields if bare == name or column.endswith(f"_{name}")]
    return fields[max(fitting, key=len)] if fitting else "1"


def time_of(columns):
    """The time column of a monitor [s]."""
    return columns["time"] if "time" in columns else columns["t"]


def field_files(directory):
    """The field files of a run, in the order of time."""
    return sorted((Path(directory) / "fields").glob("*.h5"))


def fields(path, names=None):
    """All datasets of a field file, or the named ones as far as they exist, and `time`: name -> array, SI units.

    Cell fields have the shape ([z,] y, x), vectors at cell centres one axis of components more, NAME_face one value
    more along the axis of the component."""
    with h5py.File(path, "r") as file:
        result = {name: file[name][()] for name in (names or file) if isinstance(file.get(name), h5py.Dataset)}
        result["time"] = float(np.ravel(file.attrs["time"])[0])
    return result


def last_fields(directory):
    """All datasets of the last field file."""
    files = field_files(directory)
    if not files:
        raise FileNotFoundError(f"no field files in {directory}/fields")
    return fields(files[-1])


def time_of_file(path):
    """The time of a field file [s]."""
    with h5py.File(path, "r") as file:
        return float(np.ravel(file.attrs["time"])[0])


def file_near(directory, time):
    """The field file nearest to a time [s]."""
    return min(field_files(directory), key=lambda path: abs(time_of_file(path) - time))


def fields_near(directory, time):
    """All datasets of the field file nearest to a time [s]."""
    return fields(file_near(directory, time))


def files_between(directory, begin, end):
    """The field files of a window of time [s], its ends included."""
    return [path for path in field_files(directory) if begin - 1e-9 <= time_of_file(path) <= end + 1e-9]


def attributes(path):
    """What a field file says of its datasets: name -> {unit, text, symbol}."""

    def text(value):
        value = np.ravel(value)[0]
        return value.decode() if isinstance(value, bytes) else str(value)

    with h5py.File(path, "r") as file:
        return {name: {key: text(value) for key, value in file[name].attrs.items()} for name in file
                if isinstance(file[name], h5py.Dataset)}


def summary(directory):
    """summary.json, which a run writes at its end."""
    return json.loads((Path(directory) / "summary.json").read_text())


def phase_seconds(summary):
    """CPU seconds of the phases of a run, of all ranks: phase -> seconds.

    The program clocks its phases by the wall; they are scaled by the part of it in which the processors were ours, so
    that they add up on a busy machine too. Set-up outside of a solve is taken off Krylov by the program, which then may
    be negative: it counts as none here."""
    seconds = summary["cpu_seconds"]
    wall = summary["wall_seconds"] * summary["ranks"]
    ours = min(1.0, seconds["total"] / wall) if wall > 0 else 1.0
    return {name: ours * max(0.0, value) for name, value in seconds.items() if name != "total"}


def case(directory, name="case.yaml"):
    """The effective case as option -> text, nested keys joined with `_` and lists with `, `."""
    path = Path(directory) / name
    return case_file.flatten(path.read_text()) if path.exists() else {}


def mean_over(window, times, values):
    """Mean over a window of time of what the monitor has at its steps, which differ in length."""
    t = np.linspace(*window, 2001)
    return float(np.mean(np.interp(t, times, values)))


# ---- plane flow ----


def centres(faces):
    """Cell centres between faces."""
    return (faces[1:] + faces[:-1]) / 2


def is_half(x_faces):
    """Whether the domain ends at x = 0: half of a symmetric one."""
    return abs(x_faces[0]) < 1e-9


def mirrored(field, sign=1):
    """A field [y, x] of the half x > 0 with its mirror image; sign -1 for velocities along x."""
    return np.hstack([sign * field[:, ::-1], field])


def mirrored_faces(x_faces):
    """Faces of the half x > 0 with their mirror image."""
    return np.concatenate([-x_faces[:0:-1], x_faces])
