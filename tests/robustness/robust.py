"""What the robustness tests share: options of their own, the state of a run in full, runs that fail with one line."""
import sys

import h5py
import numpy as np


def option(name, default):
    """Takes a number `name N` out of the command line, which CTest gives without."""
    if name not in sys.argv:
        return default
    place = sys.argv.index(name)
    value = type(default)(sys.argv[place + 1])
    del sys.argv[place:place + 2]
    return value


def checkpoints(directory):
    return sorted((directory / "checkpoints").glob("*.h5"))


def vectors(path):
    """The vectors of a checkpoint."""
    with h5py.File(path, "r") as file:
        return {name: file["vectors"][name][()] for name in file["vectors"]}


def same_bits(a, b):
    return a.keys() == b.keys() and all(np.array_equal(a[name], b[name]) for name in a)


def one_line(run, *words):
    """Whether a run has failed as it should: one line of its own on stderr that has the words, exit code 1, no trace of
    a signal or of PETSc. Under mpirun its remarks on the exit code come in addition. Returns what is wrong, or None."""
    ours = [line[line.index("scree: "):] for line in run.errors.splitlines() if "scree: " in line]
    noise = [line for line in run.errors.splitlines()
             if "PETSC ERROR" in line or "terminate called" in line or "ignal:" in line]
    if len(ours) != 1 or noise or not 0 < run.code < 128:
        return f"exit {run.code}, lines {ours[:3]}, noise {noise[:3]}"
    missing = [word for word in words if word not in ours[0]]
    return f"'{missing}' is not in '{ours[0]}'" if missing else None
