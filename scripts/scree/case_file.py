"""Case files: their options as flat names with texts, as the program knows them."""
import re
from pathlib import Path

import yaml

LENGTHS = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3}


def flatten(text):
    """The options of a case: name -> text. Nested keys are joined with `_`, lists with `, `; values stay as written."""
    options = {}

    def store(name, value):
        if isinstance(value, dict):
            for key, inner in value.items():
                store(f"{name}_{key}" if name else key, inner)
        else:
            options[name] = ", ".join(value) if isinstance(value, list) else value

    store("", yaml.load(text, yaml.BaseLoader) or {})
    return options


def read(path):
    """The options of a case file and of the file that it is based on."""
    path = Path(path)
    own = flatten(path.read_text())
    base = own.pop("based_on", None)
    return {**(read(path.parent / base) if base else {}), **own}


def find(case):
    """The case file that a path means: a file, or a directory with a case.yaml."""
    path = Path(case)
    file = path / "case.yaml" if path.is_dir() else path
    if not file.is_file():
        raise FileNotFoundError(f"no such case: {file}")
    return file


def lengths(text):
    """The lengths in a list such as `0, 0.007` or `-0.7 cm, 0.7 cm` [m]."""
    found = re.findall(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z]*)", text)
    return [float(value) * LENGTHS[unit] for value, unit in found]
