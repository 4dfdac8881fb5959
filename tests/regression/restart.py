"""A run that goes on from a checkpoint ends as the uninterrupted one: bit for bit from a checkpoint that both have, on the
same ranks; within the accuracy of the linear solver on other ranks, and after a stop by a signal, whose checkpoint renews
the preconditioner at a step where the uninterrupted run keeps it."""
import shutil
import signal
import subprocess
import time

import numpy as np
from scree_program import Checks, Program, Run

END = 0.03
RUN = {"solver": "ilu", "snes_atol": 1e-4, "end_time": END, "checkpoint_interval": 0.01}


def same_bits(a, b):
    return all(np.array_equal(a[name], b[name]) for name in a)


def greatest_difference(a, b):
    """Of nu, and of the velocity where there are particles [m/s]."""
    there = a["solids_fraction"] > 1e-3
    return max(np.abs((a[name] - b[name])[there]).max() for name in ("solids_fraction", "velocity"))


def stop_midway(program, name, options, number, after):
    """Starts a run, sends the signal once monitor.csv has `after` rows, returns the finished run."""
    directory = program.work / name
    words = program.command("small_bin.yaml", {"output_dir": directory, **options})
    process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    rows = directory / "monitor.csv"
    for _ in range(6000):
        if process.poll() is not None or (rows.exists() and rows.read_text().count("\n") > after):
            break
        time.sleep(0.01)
    process.send_signal(number)
    out, errors = process.communicate(timeout=480)
    return Run(directory, subprocess.CompletedProcess(words, process.returncode, out, errors))


def restart_alone(program, directory):
    """Goes on with a run from its directory, without its case file."""
    words = program.command(None, {"restart": directory})
    process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=1200)
    checks.equal(f"{directory.name}: exit code", process.returncode, 0)
    return Run(directory, process)


program, checks = Program(), Checks("restart on the same and on another number of ranks, and after a signal")
whole = program.run("small_bin.yaml", "whole", RUN)
steps = whole.monitor["time"]

# From the checkpoint before the last one of the uninterrupted run.
for name, ranks in (("same_ranks", program.ranks), ("other_ranks", 3 - program.ranks)):
    shutil.copytree(whole.directory, program.work / name)
    checkpoints = sorted((program.work / name / "checkpoints").glob("*.h5"))
    checks.equal(f"{name}: checkpoints kept", len(checkpoints), 2)
    checkpoints[-1].unlink()
    again = program.run("small_bin.yaml", name, {**RUN, "restart": program.work / name}, ranks=ranks)
    if ranks == program.ranks:
        checks.true("same ranks: bits of the last fields", same_bits(whole.fields, again.fields),
                    f"differ by {greatest_difference(whole.fields, again.fields):.1e}")
        checks.true("same ranks: times of the steps", np.array_equal(steps, again.monitor["time"]))
    else:
        checks.below("other ranks: greatest difference of nu and v", greatest_difference(whole.fields, again.fields), 2e-3)

# After the program has gone over to another preset. With Jacobi in the place of its ILU that is soon.
CHANGING = {**{name: value for name, value in RUN.items() if name != "solver"}, "sub_pc_type": "jacobi", "ksp_rtol": 1e-10,
            "ksp_max_it": 2000}
changed = program.run("small_bin.yaml", "changed", CHANGING)
checks.true("changed preset: condensed in the end", "solver condensed from here on" in changed.log, changed.log)
shutil.copytree(changed.directory, program.work / "changed_again")
sorted((program.work / "changed_again" / "checkpoints").glob("*.h5"))[-1].unlink()
shutil.copytree(program.work / "changed_again", program.work / "changed_alone")
again = program.run("small_bin.yaml", "changed_again", {**CHANGING, "restart": program.work / "changed_again"})
alone = restart_alone(program, program.work / "changed_alone")  # with the options that its case.yaml tells
for name, run in (("", again), (", by -restart alone", alone)):
    checks.true(f"changed preset{name}: bits of the last fields", same_bits(changed.fields, run.fields),
                f"differ by {greatest_difference(changed.fields, run.fields):.1e}")

# A signal to the process (one rank) or to mpirun, which passes on SIGUSR1 alone.
numbers = (signal.SIGTERM, signal.SIGUSR1) if program.ranks == 1 else (signal.SIGUSR1,)
for number in numbers:
    name = f"stopped_{number.name}"
    stopped = stop_midway(program, name, RUN, number, after=20)
    checks.equal(f"{number.name}: exit code", stopped.code, 0)
    checks.equal(f"{number.name}: reason in summary.json", stopped.summary["end"], number.name)
    checks.true(f"{number.name}: before the end", stopped.summary["time"] < END * 0.999, "the run was over before the signal")
    checks.true(f"{number.name}: a checkpoint", list((stopped.directory / "checkpoints").glob("*.h5")), "none")
    finished = program.run("small_bin.yaml", name, {**RUN, "restart": stopped.directory})
    checks.equal(f"{number.name}: time at the end", finished.summary["time"], whole.summary["time"])
    checks.below(f"{number.name}: greatest difference of nu and v [m/s] to the uninterrupted run",
                 greatest_difference(whole.fields, finished.fields), 2e-3)
checks.verdict()
