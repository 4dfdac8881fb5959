"""valgrind's memcheck on a few steps of a small bed with everything on: gas, friction, walls, lines, probes, checkpoints
and a restart. No error in our code and none that it causes in the libraries; what the libraries do on their own is
listed in memcheck.supp. Skipped, and said so, where valgrind does not know the instructions of this build
(-DSCREE_NATIVE=ON on a processor with AVX-512)."""
import os
import re
import subprocess

from scree_program import Checks, Program, Run

CASE = "bed.yaml"
TINY = {"grid_cells": "4, 4", "boundary_left_kind": "wall_johnson_jackson", "boundary_jet_patch": "1 cm, 3 cm",
        "boundary_jet_from": 1.5e-4, "checkpoint_interval": 1e-4}
MEMCHECK = ["valgrind", "--error-exitcode=9", "--num-callers=40", "--leak-check=full", "--show-leak-kinds=definite",
            "--errors-for-leak-kinds=definite", "--gen-suppressions=all"]


def under_memcheck(name, options):
    words = [*MEMCHECK, f"--suppressions={program.here / 'memcheck.supp'}",
             *program.command(CASE, {"output_dir": program.work / "out", **TINY, **options})]
    process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=1200,
                             env={**os.environ, "OMPI_MCA_btl_vader_single_copy_mechanism": "none"})
    (program.work / f"{name}.log").write_text(process.stderr)
    return Run(program.work / "out", process)


program, checks = Program(), Checks("memcheck on a few steps", "R7")
for name, options in (("start", {"end_time": 2e-4}), ("restart", {"end_time": 3e-4, "restart": program.work / "out"})):
    run = under_memcheck(name, options)
    if "SIGILL" in run.errors or "unhandled instruction bytes" in run.errors:
        print("skipped: valgrind does not know the instructions of this build, give -DSCREE_NATIVE=OFF")
        break
    errors = int(re.search(r"ERROR SUMMARY: (\d+) errors", run.errors)[1])
    ours = [block for block in re.split(r"\n==\d+== \n", run.errors) if "scree::" in block and " at 0x" in block]
    checks.equal(f"{name}: exit code", run.code, 0)
    checks.equal(f"{name}: errors that memcheck.supp does not name", errors, 0)
    checks.equal(f"{name}: of these with our code in the stack", len(ours), 0)
    if errors:
        print(run.errors[:6000])
checks.verdict()
