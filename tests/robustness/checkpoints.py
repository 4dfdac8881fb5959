"""Damaged and foreign checkpoints: cut off, with wrong bytes, empty, no HDF5, of another grid, of other unknowns. A
run goes on from the one before, with a remark, and ends as it would have, bit for bit; or, where there is none, it ends
with one line. Never a signal, and never numbers that nobody has computed.

--count N (default: 12) damages at random bytes on top of 10 places of truncation, --seed S. More of them in one
process: Checkpoint.DamageIsNeverBelieved of unit.output."""
import random
import shutil

import h5py
from robust import checkpoints, one_line, option, same_bits, vectors
from scree_program import Checks, Program

CASE = "bed.yaml"
OPTIONS = {"checkpoint_interval": 0.004, "end_time": 0.012}


def damaged_copy(name, damage):
    """A copy of the uninterrupted run without its last checkpoint, whose now last one is damaged by `damage(bytes)`."""
    directory = program.work / "damaged"
    shutil.rmtree(directory, ignore_errors=True)
    shutil.copytree(two.directory, directory)
    newest = checkpoints(directory)[-1]
    newest.write_bytes(damage(newest.read_bytes()))
    return directory, newest


def goes_on(name, damage):
    """What is wrong with the restart from a damaged checkpoint beside a sound one, or None. Counts where it went on."""
    directory, newest = damaged_copy(name, damage)
    run = program.run(CASE, "damaged", {**OPTIONS, "restart": directory}, must_work=False, timeout=240)
    if run.code != 0 or run.errors and program.ranks == 1:
        return f"{name}: exit {run.code} {run.errors[:300]}"
    last = vectors(checkpoints(directory)[-1])
    if not same_bits(run.fields, whole.fields) or not same_bits(last, vectors(checkpoints(whole.directory)[-1])):
        return f"{name}: ends otherwise"
    believed = f"going on from {newest}" in run.log
    words = ("cannot be used", newest.name, checkpoints(two.directory)[0].name)
    remarks = [line for line in run.log.splitlines() if all(word in line for word in words)]
    taken["harmless, the newest" if believed else "the one before"] += 1
    return None if believed or len(remarks) == 1 else f"{name}: no remark: {run.log[:300]}"


def flipped(places):
    def damage(data):
        changed = bytearray(data)
        for place, bits in places:
            changed[place % len(data)] ^= bits
        return bytes(changed)
    return damage


count, seed = option("--count", 12), option("--seed", 1)
program, checks = Program(), Checks("damaged and foreign checkpoints", "R4")
pick = random.Random(seed)
taken = {"harmless, the newest": 0, "the one before": 0}
whole = program.run(CASE, "whole", OPTIONS)
two = program.run(CASE, "two", {**OPTIONS, "end_time": 0.011})  # keeps a regular checkpoint, and that of the end
checkpoints(two.directory)[-1].unlink()
first = checkpoints(two.directory)[-1]
extra = program.run(CASE, "first", {**OPTIONS, "end_time": 0.007})  # holds the regular one before
shutil.copy(checkpoints(extra.directory)[0], two.directory / "checkpoints")
checks.equal("checkpoints to go on from", [p.name for p in checkpoints(two.directory)],
             sorted([checkpoints(extra.directory)[0].name, first.name]))
size = first.stat().st_size

wrong = [goes_on(f"cut off at {k}/10", lambda data, k=k: data[:size * k // 10]) for k in range(10)]
wrong.append(goes_on("one byte short", lambda data: data[:-1]))
wrong.append(goes_on("text", lambda data: b"not at all\n" * 100))
wrong.append(goes_on("zeros", lambda data: bytes(len(data))))
wrong.append(goes_on("a page of zeros", lambda data: data[:size // 2] + bytes(4096) + data[size // 2 + 4096:]))
checks.equal("cut off or foreign: wrong restarts", [w for w in wrong if w], [])
checks.equal("all of them go on from the one before", taken, {"harmless, the newest": 0, "the one before": 14})

with h5py.File(first, "r") as file:  # the frame: all but the numbers, whose damage one checksum finds like another
    numbers = [(item.id.get_offset(), item.id.get_storage_size()) for item in file["vectors"].values()]
frame = [place for place in range(size) if not any(begin <= place < begin + length for begin, length in numbers)]
wrong = []
for index in range(count):
    places = [(pick.choice(frame) if pick.random() < 0.8 else pick.randrange(size), pick.randrange(1, 256))
              for _ in range(pick.choice([1, 1, 2, 20, 200]))]
    wrong.append(goes_on(f"damage {index} of seed {seed}", flipped(places)))
checks.equal(f"{count} damages at random: wrong restarts", [w for w in wrong if w], [])
print(f"  went on from {taken}")

# No sound one left: one line. Another grid, other unknowns, other physics behind the same unknowns.
for path in checkpoints(two.directory):
    path.write_bytes(path.read_bytes()[:size // 3])
run = program.run(CASE, "none", {**OPTIONS, "restart": two.directory}, must_work=False)
complaint = one_line(run, first.name, "cannot be used")
checks.true("both cut off: one line", complaint is None, complaint)
for name, options, words in (
        ("another grid", {"grid_cells": "8, 15"}, ["is of another case", "cells along y"]),
        ("another box", {"extent": "4 cm, 8.1 cm"}, ["is of another case", "lie elsewhere"]),
        ("without gas", {"gas": "none"}, ["boundary_floor_kind"]),
        ("gas without inertia", {"gas": "darcy"}, ["is of another case", "fields"]),
        ("without chi", {"friction_model": "critical_state"}, ["is of another case", "fields"]),
        ("other scale", {"scale_velocity": "1 m/s"}, ["is of another case", "scale"])):
    given = {**OPTIONS, "end_time": 0.02, "restart": whole.directory, **options}
    run = program.run(CASE, "foreign", given, must_work=False)
    complaint = one_line(run, *words)
    checks.true(f"{name}: one line", complaint is None, complaint)
checks.verdict()
