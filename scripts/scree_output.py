"""Reads the output directory of a Scree run: monitor.csv, the HDF5 fields, the effective case."""
import csv
import re
from pathlib import Path

import h5py
import numpy as np


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


def time_of(columns):
    """The time column of a monitor [s]."""
    return columns["time"] if "time" in columns else columns["t"]


def field_files(directory):
    """The field files of a run, in the order of time."""
    return sorted((Path(directory) / "fields").glob("*.h5"))


def fields(path, names=None):
    """All datasets of a field file, or the named ones as far as they exist, and `time`: name -> array, SI units."""
    with h5py.File(path, "r") as file:
        result = {name: file[name][()] for name in (names or file) if isinstance(file.get(name), h5py.Dataset)}
        result["time"] = float(np.ravel(file.attrs["time"])[0])
    return result


def last_fields(directory):
    files = field_files(directory)
    if not files:
        raise FileNotFoundError(f"no field files in {directory}/fields")
    return fields(files[-1])


def case(directory, name="case.yaml"):
    """The effective case as option -> text, nested keys joined with `_` and lists with `, `, as PETSc reads them."""
    path = Path(directory) / name
    return flatten(path.read_text()) if path.exists() else {}


def flatten(text):
    """The part of YAML that case files use: nested keys, one-line lists and maps, dashed lists of values, comments."""
    options = {}
    parents = []  # (indentation, full key)

    def join(key):
        return "_".join([*(name for _, name in parents[-1:]), key])

    def store(key, value):
        value = value.strip()
        if value.startswith("{"):
            for item in split(value[1:-1]):
                inner, _, rest = item.partition(":")
                store(f"{key}_{unquote(inner)}", rest)
        elif value.startswith("["):
            options[key] = ", ".join(unquote(item) for item in split(value[1:-1]))
        else:
            options[key] = unquote(value)

    for line in text.splitlines():
        line = re.sub(r"(^|\s)#.*", "", line).rstrip()
        entry = line.strip()
        if not entry or entry in ("---", "..."):
            continue
        indentation = len(line) - len(line.lstrip())
        if entry.startswith("- "):
            key = parents[-1][1]
            options[key] = ", ".join(filter(None, [options.get(key), unquote(entry[2:])]))
            continue
        while parents and parents[-1][0] >= indentation:
            parents.pop()
        key, _, value = entry.partition(":")
        key = join(unquote(key))
        if value.strip():
            store(key, value)
        else:
            parents.append((indentation, key))
    return options


def unquote(text):
    return text.strip().strip("'\"").strip()


def split(text):
    """Splits at the commas outside of brackets and quotes."""
    parts, depth, quote = [""], 0, ""
    for letter in text:
        if quote or letter in "'\"":
            quote = "" if letter == quote else quote or letter
        else:
            depth += (letter in "[{") - (letter in "]}")
        if letter == "," and depth == 0 and not quote:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


LENGTHS = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3}


def lengths(text):
    """The lengths in a list such as `0, 0.007` or `-0.7 cm, 0.7 cm` [m]."""
    found = re.findall(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z]*)", text)
    return [float(value) * LENGTHS[unit] for value, unit in found]
