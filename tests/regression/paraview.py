"""ParaView reads our fields as they stand in the HDF5 files: grid, times, scalars and vectors, in one, two and three
dimensions, graded cells included. Skipped where there is no pvpython."""
import json
import shutil
import subprocess
import sys

import h5py
import numpy as np
from scree_program import Checks, Program

#: Runs inside of ParaView, which takes long to start: what each reader makes of each fields.xdmf at its last time.
READ = """
import json, sys
from paraview import simple as pv
from vtk.util.numpy_support import vtk_to_numpy
def read(kind, file):
    reader = getattr(pv, kind)(FileName=[file])
    times = list(reader.TimestepValues)
    reader.UpdatePipeline(times[-1])
    data = reader.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    cells = data.GetCellData()
    return {"times": times,
            "faces": [vtk_to_numpy(getattr(data, f"Get{axis}Coordinates")()).tolist() for axis in "XYZ"],
            "cells": {cells.GetArrayName(k): vtk_to_numpy(cells.GetArray(k)).tolist() for k in range(cells.GetNumberOfArrays())}}
found = [[read(kind, file) for kind in json.loads(sys.argv[1])] for file in json.loads(sys.argv[2])]
open(sys.argv[3], "w").write(json.dumps(found))
"""
READERS = "Xdmf3ReaderS", "Xdmf3ReaderT"
SCENE = {"end_time": 0.004, "output_interval": 0.002, "time_step_max": 1e-3, "gas": "incompressible"}
SIDES = {f"boundary_{axis}{side}_{key}": value for axis in "xyz" for side in ("lower", "upper")
         for key, value in (("side", f"{axis}_{side}"), ("kind", "wall_free_slip"))}


def scene(dimension):
    """Options of a box that differs along each axis, with a lump that moves askew."""
    options = {"dimension": dimension, "gravity": ", ".join(["1", "-9.81", "3"][:dimension]), **SCENE}
    for axis, cells, edge in list(zip("xyz", (5, 7, 4), (3, 8, 2)))[:dimension]:
        options |= {f"grid_{axis}_edges": f"-1 cm, {edge} cm", f"grid_{axis}_cells": cells, f"grid_{axis}_ratio": 3}
    options |= {key: value for key, value in SIDES.items() if key[len("boundary_")] in "xyz"[:dimension]}
    last = "xyz"[dimension - 1]
    options[f"boundary_{last}upper_kind"] = "open"
    options["initial_lump_solids_fraction"] = 0.3
    options["initial_lump_velocity"] = ", ".join(["0.1", "-0.2", "0.3"][:dimension])
    return options


program, checks = Program(), Checks("ParaView reads the fields as they are")
pvpython = shutil.which("pvpython")
if not pvpython:
    print("skipped: pvpython is not installed")
    sys.exit(0)
script = program.work / "read.py"
script.write_text(READ)
runs = []
for dimension in (1, 2, 3):
    case_file = program.work / f"{dimension}d.yaml"
    case_file.write_text(json.dumps(scene(dimension)))  # which is YAML
    runs.append(program.run(case_file, f"{dimension}d"))
found = program.work / "found.json"
files = [str(run.directory / "fields.xdmf") for run in runs]
subprocess.run([pvpython, str(script), json.dumps(READERS), json.dumps(files), str(found)], check=True,
               stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
for dimension, run, by_reader in zip((1, 2, 3), runs, json.loads(found.read_text())):
    last = sorted((run.directory / "fields").glob("*.h5"))[-1]
    with h5py.File(last) as file:
        faces = [np.asarray(file[f"{axis}_faces"]) for axis in "xyz"[:dimension]]
        shape = tuple(len(axis) - 1 for axis in faces[::-1])
        ours = {name: np.asarray(data) for name, data in file.items() if data.shape in (shape, (*shape, 3))}
        end = file.attrs["time"]
    for reader, theirs in zip(READERS, by_reader):
        case = f"{dimension}-D, {reader}"
        checks.equal(f"{case}: number of times", len(theirs["times"]), 3)
        checks.close(f"{case}: last time", theirs["times"][-1], end)
        for axis, expected in enumerate(faces):
            checks.true(f"{case}: faces along {'xyz'[axis]}", np.array_equal(theirs["faces"][axis], expected))
        checks.equal(f"{case}: arrays", sorted(theirs["cells"]), sorted(ours))
        for name, values in ours.items():
            same = np.array_equal(np.reshape(theirs["cells"].get(name, []), (-1,)), values.ravel())
            checks.true(f"{case}: {name}", same)
    checks.above(f"{dimension}-D: the velocity is none that is zero", np.abs(ours["velocity"]).max(), 0.01)
checks.verdict()
