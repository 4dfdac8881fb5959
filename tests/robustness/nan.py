"""NaN from anywhere is refused: in a checkpoint (with the old checksum, or with one made to fit), in a table of initial
solids fractions; and where the residual of a step overflows, the step is rejected, never accepted. NaN in the case file
is among the mutants of mutate_cases.py."""
import json
import shutil

import h5py
import numpy as np
from robust import checkpoints, one_line, same_bits, vectors
from scree_program import Checks, Program

CASE = "bed.yaml"
OPTIONS = {"checkpoint_interval": 0.004, "end_time": 0.008}


def spread(x):
    """As in checksum.hpp: one step of splitmix64."""
    with np.errstate(over="ignore"):
        x = np.uint64(0x9E3779B97F4A7C15) + x
        x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        return x ^ (x >> np.uint64(31))


def sum_of_vector(values):
    places = spread(np.arange(values.size, dtype=np.uint64))
    with np.errstate(over="ignore"):
        return f"{int(np.sum(spread(values.reshape(-1).view(np.uint64) ^ places))):016x}"


def sum_of_bytes(data, total=np.uint64(0)):
    for byte in data:
        total = spread(total ^ np.uint64(byte))
    return f"{int(total):016x}"


def seal_anew(path):
    """Puts the checksum of the seal right again."""
    data = path.read_bytes()
    text, numbers = data.split(b"\n")[0].rsplit(b" ", 1)[0] + b" ", []
    for pair in text.split(b"numbers at ")[1].rstrip(b"; ").split():
        numbers.append([int(part) for part in pair.split(b"+")])
    frame, at = text, 2048
    for begin, length in numbers:
        frame, at = frame + data[at:begin], begin + length
    seal = text + sum_of_bytes(frame + data[at:]).encode() + b"\n"
    path.write_bytes(seal + data[len(seal):])


def poison(path, vector, value, with_checksums):
    """Writes `value` into the middle of a vector."""
    with h5py.File(path, "r+") as file:
        data = file["vectors"][vector][()]
        data.reshape(-1)[data.size // 2] = value
        file["vectors"][vector][...] = data
        header, old = bytes(file["header"][()]), bytes(file.attrs["header_checksum"])
    if with_checksums:
        wrong = json.loads(header)["vectors"][vector].encode()
        fitting = header.replace(wrong, sum_of_vector(data).encode())
        path.write_bytes(path.read_bytes().replace(header, fitting).replace(old, sum_of_bytes(fitting).encode()))
    seal_anew(path)


program, checks = Program(), Checks("NaN from anywhere", "R3")
whole = program.run(CASE, "whole", OPTIONS)
kept = checkpoints(whole.directory)
checks.equal("checkpoints of the run", len(kept), 2)
for value in (np.nan, np.inf):
    for with_checksums, words in ((False, "checksum of vector"), (True, "holds a NaN or an infinity")):
        for vector in ("state", "past_0"):
            directory = program.work / "poisoned"
            shutil.rmtree(directory, ignore_errors=True)
            shutil.copytree(whole.directory, directory)
            poison(checkpoints(directory)[-1], vector, value, with_checksums)
            run = program.run(CASE, "poisoned", {**OPTIONS, "restart": directory}, must_work=False)
            name = f"{value} in {vector}{', checksums made to fit' if with_checksums else ''}"
            remark = [line for line in run.log.splitlines()
                      if words in line and kept[-1].name in line and kept[0].name in line]
            checks.true(f"{name}: from the checkpoint before, with a remark",
                        run.code == 0 and len(remark) == 1 and same_bits(run.fields, whole.fields),
                        f"exit {run.code} {run.log[:300]} {run.errors[:300]}")
            shutil.rmtree(directory)
            directory.mkdir()
            shutil.copy(kept[-1], directory)
            poison(directory / kept[-1].name, vector, value, with_checksums)
            complaint = one_line(program.run(CASE, "alone", {**OPTIONS, "restart": directory}, must_work=False), words)
            checks.true(f"{name}, no other checkpoint: one line", complaint is None, complaint)

for name, text, words in (("nan", "0 0.5\n0.02 nan\n", "finite"), ("inf", "0 0.5\n0.02 inf\n", "finite"),
                          ("1e999", "0 0.5\n0.02 1e999\n", "finite"), ("nan as a coordinate", "nan 0.5\n", "finite"),
                          ("above nu_max", "0 0.5\n0.02 0.7\n", "0.65"), ("negative", "0 -0.1\n", "0.65"),
                          ("a word", "0 0.5\n0.02 much\n", "much"), ("three numbers", "0 0.5 1\n", "two"),
                          ("descending", "0 0.5\n-1 0.5\n", "ascending"), ("nothing", "# empty\n", "one")):
    table = program.work / "table.txt"
    table.write_text(text)
    given = {**OPTIONS, "initial_bed_table": table, "initial_bed_table_axis": "y"}
    complaint = one_line(program.run(CASE, "table", given, must_work=False), "initial_bed_table", words)
    checks.true(f"table with {name}: one line", complaint is None, complaint)
    checks.true(f"table with {name}: nothing written", not (program.work / "table").exists())

# The gas of the floor grows beyond what the squares of numbers can hold: the residual is not finite from some time on.
huge = {**OPTIONS, "boundary_floor_gas_history_at": "0, 0.004, 0.005",
        "boundary_floor_gas_history_factor": "1, 1, 1e300"}
for scheme in ("beuler", "bdf", "arkimex"):
    run = program.run(CASE, f"overflow_{scheme}", {**huge, "time_scheme": scheme, "solver": "ilu"}, must_work=False)
    complaint = one_line(run, "no step of at least")
    checks.true(f"{scheme}, overflow in the residual: the run ends with one line", complaint is None, complaint)
    if complaint:
        continue
    checks.above(f"{scheme}: steps rejected by the solver", run.summary["rejected_solver"], 1)
    state = [v for path in checkpoints(run.directory) for v in vectors(path).values()]
    checks.true(f"{scheme}: all kept states are finite", all(np.isfinite(v).all() for v in state))
    checks.true(f"{scheme}: all rows of monitor.csv are finite",
                all(np.isfinite(column).all() for column in run.monitor.values()))
    checks.above(f"{scheme}: time reached [s]", run.summary["time"], 0.004 * (1 - 1e-9))
checks.verdict()
