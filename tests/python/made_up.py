"""Output directories as the program leaves them, with fields that are known formulas: tests need no run for them."""
import json

import h5py
import numpy as np

UNITS = {"solids_fraction": "1", "granular_temperature": "m2/s2", "velocity": "m/s"}
CASE = """\
dimension: 2
end_time: 0.4
solids_fraction_max: 0.63
plate_floor_axis: y
plate_floor_position: 0.1
plate_floor_openings: "0, 0.02"
"""


def faces(dimension):
    """Faces of a grid with cells of two sizes along x."""
    return {"x": np.array([0, 0.01, 0.03, 0.06]), "y": np.linspace(0, 0.5, 6), "z": np.linspace(0, 0.2, 3)
            } if dimension == 3 else {"x": np.array([0, 0.01, 0.03, 0.06]), "y": np.linspace(0, 0.5, 6)
                                      } if dimension == 2 else {"x": np.array([0, 0.01, 0.03, 0.06])}


def solids_fraction(x, time):
    return 0.6 - 2 * x - 0.1 * time


def write_fields(path, dimension, time):
    """nu as in solids_fraction(), v_x = x at its faces, T = time + 1e-4."""
    grid = faces(dimension)
    shape = tuple(len(grid[axis]) - 1 for axis in reversed(grid))
    x = (grid["x"][1:] + grid["x"][:-1]) / 2
    with h5py.File(path, "w") as file:
        file.attrs["time"] = time

        def add(name, values, unit):
            file[name] = values
            file[name].attrs.update(unit=unit, text=f"the {name}", symbol=name[0])

        for axis, places in grid.items():
            add(f"{axis}_faces", places, "m")
        add("solids_fraction", np.broadcast_to(solids_fraction(x, time), shape), "1")
        add("granular_temperature", np.full(shape, time + 1e-4), "m2/s2")
        add("velocity_x_face", np.broadcast_to(grid["x"], (*shape[:-1], shape[-1] + 1)), "m/s")
        velocity = np.zeros((*shape, 3))
        velocity[..., 0] = x
        add("velocity", velocity, "m/s")


def write_run(directory, dimension=2, times=(0.0, 0.2, 0.4), ended=True):
    """A whole output directory; without `ended` that of a run that was killed."""
    (directory / "fields").mkdir(parents=True)
    for number, time in enumerate(times):
        write_fields(directory / "fields" / f"{number:06d}.h5", dimension, time)
    (directory / "case.yaml").write_text(CASE)
    rows = ["time,dt,newton_iterations,rejected_error,rejected_solver,mass,discharge_rate,flux_orifice,"
            "solids_fraction_min,tip_velocity_x,cpu_seconds"]
    rows += [f"{time},{0.1},{3},{k == 2:d},0,{5 - time},{2 * time},{time},0.1,0.5,{time}"
             for k, time in enumerate(np.linspace(0, 0.4, 5))]
    (directory / "monitor.csv").write_text("\n".join(rows) + "\n" + ("" if ended else "0.5,0.1"))
    if ended:
        (directory / "summary.json").write_text(json.dumps(SUMMARY))
    (directory / "log").write_text(LOG)
    (directory / "lines").mkdir()
    for number, time in enumerate(times):
        (directory / "lines" / f"axis_of_bin_{number:06d}.csv").write_text(f"time,x,solids_fraction\n{time},0,0.6\n")
    return directory


SUMMARY = {"end": "end_time", "time": 0.4, "cells": 15, "unknowns_per_cell": 4, "ranks": 1, "steps": 4,
           "newton_iterations": 12, "krylov_iterations": 48, "rejected_error": 1, "rejected_solver": 0, "dt_max": 0.1,
           "wall_seconds": 2.0, "cpu_seconds": {"total": 1.9, "residual": 0.4, "jacobian": 0.5,
                                                "preconditioner_setup": 0.3, "krylov": -0.01},
           "peak_memory_per_rank_bytes": 5e7, "quantities": {"mass": 4.6}, "versions": {"scree": "0.1.0"}}
LOG = """\
friction_tau has no effect with friction_model <none>
time 0.1 s  dt 1.00e-01 s  step 1   25.0 %
time 0.1 s: 70 Krylov iterations a linear system; solver multigrid from here on
time 0.4 s  dt 1.00e-01 s  step 4  100.0 %  rate 0.2 s/s  left 0:00:00
"""
