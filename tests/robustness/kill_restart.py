"""A run killed (SIGKILL) at any time goes on from its last checkpoint and ends as if nothing had happened: the same
bits in all fields, in the last checkpoint and in monitor.csv, without gaps, doubles or temporary files that stay.

Killed at random times from start-up to the end, and on purpose while a checkpoint is being written and while the run
finishes. Where there is no checkpoint yet, the run starts anew with -output_overwrite. On several ranks one rank is
killed, and mpirun has to end the others. --count K kills (default: 8; 4 on several ranks), --seed S."""
import os
import random
import re
import shutil
import signal
import subprocess
import time

import numpy as np
from robust import checkpoints, option, same_bits, vectors
from scree_program import Checks, Program, Run

CASE = "bed.yaml"
OPTIONS = {"checkpoint_interval": 0.004, "output_interval": 0.02}
COSTS = ("cpu_seconds", "cpu_residual", "cpu_jacobian", "cpu_setup", "cpu_solve")  # of this process, so not the same
PATIENCE = 240  # seconds in which mpirun has to end the other ranks


def ranks_of(process):
    """Process ids of the ranks below mpirun; the process itself without mpirun."""
    if program.ranks == 1:
        return [process.pid]
    found = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(process.pid)], capture_output=True, text=True)
    return [int(line.split()[0]) for line in found.stdout.splitlines() if line.split()[1] == name_of_program]


def being_written(directory):
    try:
        return any(name.endswith(".part") for name in os.listdir(directory / "checkpoints"))
    except OSError:
        return False


def finishing(directory):
    """Whether the last step is done: from there on the run writes its last fields, checkpoint and summary."""
    try:
        return (directory / "monitor.csv").read_text().splitlines()[-1].startswith("0.1,")
    except (OSError, IndexError):
        return False


def live(directory, options, phase):
    """One life: starts the run, kills it in the given phase (None: lets it end). Returns (killed, Run, seconds that it
    took to end after that)."""
    words = program.command(CASE, {"output_dir": directory, **options})
    began = time.monotonic()
    process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
    after = pick.uniform(0, 0.5 * start_up) if phase == "start" else pick.uniform(0.3 * start_up, seconds)
    seen = pick.uniform(0, 0.002)  # after the event of the other phases
    count = pick.randrange(8)  # of checkpoints that it may write first
    written = False
    while process.poll() is None:
        now = being_written(directory) if phase == "checkpoint" else False
        count -= now and not written
        written = now
        if (phase in ("start", "run") and time.monotonic() - began > after) or (now and count < 0) \
                or (phase == "finish" and finishing(directory)):
            time.sleep(seen if phase == "finish" else 0)
            try:
                os.kill(pick.choice(ranks_of(process) or [process.pid]), signal.SIGKILL)
            except ProcessLookupError:
                pass  # it was faster
            break
        time.sleep(0.02 if phase is None else 0.0002)
    killed_at = time.monotonic()
    out, errors = process.communicate(timeout=PATIENCE)
    run = Run(directory, subprocess.CompletedProcess(words, process.returncode, out, errors))
    return process.returncode != 0, run, time.monotonic() - killed_at


def comparable(monitor):
    return {name: column for name, column in monitor.items() if name not in COSTS}


def differences(directory):
    """What is not as in the uninterrupted run."""
    found = []
    run = Run(directory, subprocess.CompletedProcess([], 0, "", ""))
    if not same_bits(comparable(whole.monitor), comparable(run.monitor)):
        found.append("monitor.csv")
    mine, theirs = run.all_fields(), whole.all_fields()
    if len(mine) != len(theirs) or not all(same_bits(a, b) for a, b in zip(mine, theirs)):
        found.append("fields")
    if checkpoints(directory)[-1].name != checkpoints(whole.directory)[-1].name or \
            not same_bits(vectors(checkpoints(directory)[-1]), vectors(checkpoints(whole.directory)[-1])):
        found.append("last checkpoint")
    for name in sorted(p.name for p in (whole.directory / "lines").glob("*.csv")):
        if (directory / "lines" / name).read_text() != (whole.directory / "lines" / name).read_text():
            found.append(f"lines/{name}")
    summary, other = run.summary, whole.summary
    keys = ("end", "time", "steps", "newton_iterations", "krylov_iterations", "quantities")
    found += [f"{key} of summary.json" for key in keys if summary[key] != other[key]]
    files = {str(p.relative_to(directory)) for p in directory.rglob("*") if p.is_file()}
    expected = {str(p.relative_to(whole.directory)) for p in whole.directory.rglob("*") if p.is_file()}
    return found + sorted(files ^ expected)


kills, seed = option("--count", 0), option("--seed", 1)
program = Program()
kills = kills or (8 if program.ranks == 1 else 4)
name_of_program = os.path.basename(program.scree)
pick = random.Random(seed)
checks = Checks(f"{kills} kills on {program.ranks} rank(s), seed {seed}", "R1")
start_up, seconds = 1.0, 1.0
began = time.monotonic()
whole = program.run(CASE, "whole", OPTIONS)
seconds = time.monotonic() - began
start_up = seconds - whole.summary["wall_seconds"]
print(f"  uninterrupted: {seconds:.2f} s, of which start-up {start_up:.2f} s; {int(whole.summary['steps'])} steps")

PHASES = ["start", "run", "checkpoint", "run", "finish", "checkpoint", "run", "checkpoint"]
done, chains, restarts, anew = 0, 0, 0, 0
lost, hangs, unequal, wrong = [], [], [], []
most_temporary = 0
tally = {}


def phase_of_next_kill():
    """None when there were enough; late ones go on until one of them has left a checkpoint to go on from."""
    if done < kills:
        return PHASES[done % len(PHASES)]
    return "finish" if restarts == 0 and done < 4 * kills else None


while done < kills:
    directory = program.work / "killed"
    shutil.rmtree(directory, ignore_errors=True)
    chains += 1
    options, finished = OPTIONS, False
    while not finished:
        phase = phase_of_next_kill()
        before = checkpoints(directory)
        killed, run, after = live(directory, options, phase)
        finished = not killed
        if killed:
            done += 1
            tally[phase] = tally.get(phase, 0) + 1
            hangs += [after] if after > 30 else []
        if "restart" in options:  # it must have taken the newest checkpoint that there was
            restarts += 1
            said = re.search(r"going on from (\S+) at", run.log)
            other = said and not said[1].endswith(before[-1].name)
            if other or (finished and not said) or "cannot be used" in run.log:
                wrong.append(run.log[:300] + run.errors[:300])
        if "scree:" in run.errors or (phase is None and run.code != 0):  # Open MPI's daemon has its say on a kill
            wrong.append(run.errors[:300])
        temporary = [p for p in directory.rglob("*") if p.name.endswith(".part") or p.name == ".scree_write_test"]
        most_temporary = max(most_temporary, len(temporary))
        saved = checkpoints(directory)
        if saved:
            rows = run.monitor["time"] if (directory / "monitor.csv").exists() else np.array([0.0])
            with_time = float(re.search(r'"time":([^,}]*)', saved[-1].read_bytes().decode("latin-1"))[1])
            longest = float(whole.summary["dt_max"])
            if rows.size and rows[-1] - with_time > OPTIONS["checkpoint_interval"] + longest * 1.001:
                lost.append(rows[-1] - with_time)
            options = {**OPTIONS, "restart": directory}
        else:
            anew += killed
            options = {**OPTIONS, "output_overwrite": None} if (directory / "monitor.csv").exists() else OPTIONS
    unequal += differences(directory)
print(f"  {done} kills ({tally}) in {chains} chains; {restarts} restarts, {anew} starts anew")
checks.above("kills", done, kills)
checks.above("restarts from a checkpoint", restarts, 1)
checks.equal("restarts that fail, complain or do not take the newest checkpoint", wrong, [])
checks.equal("kills that lose more than one checkpoint interval", lost, [])
checks.equal("what differs from the uninterrupted run, bit by bit", unequal, [])
checks.below("temporary files at any time", most_temporary, 2)
if program.ranks > 1:
    checks.equal("kills of one rank after which mpirun takes more than 30 s", hangs, [])
checks.verdict()
