"""H12: a restart at half time. On the ranks of the first half it ends bit for bit as the uninterrupted run; on other ranks
within what the solver's tolerance leaves, for which steps are given and Newton converges."""
import shutil

import numpy as np
from scree_program import Checks, Program

RANKS = (1, 2, 4, 8)
# The tolerances of Newton and of the linear solver, and with them what two ways to the same solution may differ by.
TIGHT = {"time_step_adaptive": "no", "time_step_initial": 2e-4, "snes_rtol": 1e-9, "snes_atol": 1e-7, "ksp_rtol": 1e-8}


def differing(a, b):
    """The datasets that are not the same bit for bit."""
    return sorted(name for name in {*a, *b} if name not in a or name not in b or not np.array_equal(a[name], b[name]))


def difference(a, b):
    """Greatest difference of nu, v (where there are particles), T and p_g, each relative to its greatest value."""
    there = a["solids_fraction"] > 1e-3
    names = ("solids_fraction", "velocity", "granular_temperature", "gas_pressure")
    return max(np.abs((a[name] - b[name])[there]).max() / np.abs(a[name]).max() for name in names)


def from_half_time(program, whole, name, options, ranks):
    """Goes on from the checkpoint at half time of a copy of `whole`."""
    shutil.copytree(whole.directory, program.work / name)
    checkpoints = sorted((program.work / name / "checkpoints").glob("*.h5"))
    assert len(checkpoints) == 2, checkpoints
    checkpoints[-1].unlink()
    return program.run("restarts.yaml", name, {**options, "restart": program.work / name}, ranks=ranks)


program, checks = Program(), Checks("restart at half time on 1, 2, 4 and 8 ranks, bed with a gas jet", "H12")
for ranks in RANKS:
    name = f"{ranks} ranks, adaptive steps"
    whole = program.run("restarts.yaml", f"{ranks}", ranks=ranks)
    again = from_half_time(program, whole, f"{ranks}_again", {}, ranks)
    checks.equal(f"{name}: datasets of the last fields that differ by a bit", differing(whole.fields, again.fields), [])
    checks.true(f"{name}: times of the steps", np.array_equal(whole.monitor["time"], again.monitor["time"]))

one = program.run("restarts.yaml", "given_steps", TIGHT, ranks=1)
greatest = 0
for ranks in RANKS[1:]:
    again = from_half_time(program, one, f"from_1_on_{ranks}", TIGHT, ranks)
    found = difference(one.fields, again.fields)
    checks.below(f"from 1 rank on {ranks}: greatest difference, relative", found, 1e-8)
    greatest = max(greatest, found)
checks.hard_case("H12", "restart at half time on 1, 2, 4, 8 ranks, bed with a gas jet", again,
                 measured=f"same ranks: all bits; other ranks: {greatest:.1e}",
                 bound="same ranks: bit-identical; other ranks: solver's tolerance, 1e-8")
checks.verdict()
