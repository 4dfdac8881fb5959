"""More ranks than the grid has room for: one line on stderr that says how many work, and an end on all ranks. A part of
the grid that is narrower than the stencil is found out by some ranks only; the others would wait for them.
And programs on one rank that start and end side by side, as sweeps and tests do: MPI lets each begin."""
import os
import subprocess
import tempfile
from pathlib import Path

from robust import one_line
from scree_program import Checks, Program

program, checks = Program(), Checks("too many ranks for the grid", "R1")
everywhere = {"boundary_jet_patch": "0, 4 cm"}  # bed.yaml's lies between the faces of these grids
for cells, ranks, most in [("10,10", 7, 6), ("2,2", 2, 1), ("4,8", 5, 4)]:
    run = program.run("bed.yaml", f"{ranks}_ranks", {**everywhere, "grid_cells": cells, "end_time": 1e-4}, ranks=ranks, must_work=False,
                      timeout=240)
    checks.equal(f"{cells} cells on {ranks} ranks: what is wrong with the error", one_line(run, f"on {ranks} ranks", f"at most {most},"), None)
    run = program.run("bed.yaml", f"{most}_ranks", {**everywhere, "grid_cells": cells, "end_time": 1e-4}, ranks=most, must_work=False,
                      timeout=240)
    checks.equal(f"{cells} cells on {most}: exit code", run.code, 0)

with tempfile.TemporaryDirectory(prefix="scree") as apart:  # that no other program keeps MPI's directory in there alive
    command = [program.scree, Path(__file__).with_name("bed.yaml"), "-check", "-output_dir", Path(apart) / "run"]
    codes = []
    for _ in range(40):
        started = [subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                    env={**os.environ, "TMPDIR": apart}) for _ in range(3)]
        codes += [process.wait() for process in started]
    checks.equal("three programs side by side, 40 times: that failed", sum(code != 0 for code in codes), 0)
checks.verdict()
