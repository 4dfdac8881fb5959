"""What killed runs leave on a machine, outside their directories, does not hold up the next run: Open MPI's OMPIO guards
files by semaphores that are named after the last part of the file's name alone, and a run killed while it holds one
leaves it locked. Here they lie locked for the files of the whole run, fields and checkpoints.

And what a run that ends removes does not end one that begins: runs without mpirun share directories of Open MPI."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from robust import checkpoints, same_bits, vectors
from scree_program import Checks, Program

SHARED_MEMORY = Path("/dev/shm")
LOCKED = bytes(32)  # a semaphore of glibc whose value is 0
# Numbers of files that other tests do not have: what lies there could hold up theirs, should the program be at fault.
OPTIONS = {"time_step_adaptive": "no", "time_step_initial": 1.25e-5, "end_time": 233 * 1.25e-5, "output_interval": 1}
FILES = ["00000233.h5", "00000233.h5.part", "00000241.h5.part"]


def run(name, more):
    return program.run("bed.yaml", name, {**OPTIONS, **more}, timeout=240)


program, checks = Program(), Checks("what killed runs leave on the machine", "R1")
if not SHARED_MEMORY.is_dir():
    sys.exit(f"{SHARED_MEMORY} is missing: this test is for Linux")
longer = {"end_time": 241 * 1.25e-5}
first = run("first", {})
undisturbed = run("undisturbed", {**longer, "restart": first.directory})
semaphores = [SHARED_MEMORY / f"sem.OMPIO_{name}" for name in FILES]
try:
    for path in semaphores:
        path.write_bytes(LOCKED)
    again = run("again", {})
    restarted = run("restarted", {**longer, "restart": again.directory})
finally:
    for path in semaphores:
        path.unlink(missing_ok=True)
checks.equal("checkpoint written", [p.name for p in checkpoints(again.directory)], [p.name for p in checkpoints(first.directory)])
checks.true("and the same", same_bits(vectors(checkpoints(again.directory)[-1]), vectors(checkpoints(first.directory)[-1])))
checks.equal("run goes on from it", checkpoints(restarted.directory)[-1].name, FILES[-1][:-5])
checks.true("to the same end", same_bits(restarted.fields, undisturbed.fields))

with tempfile.TemporaryDirectory() as place:
    subprocess.run([program.scree, "-schema"], env={**os.environ, "TMPDIR": place}, stdout=subprocess.DEVNULL, check=True)
    left = sorted(str(path.relative_to(place)) for path in Path(place).glob("ompi.*/**/kept"))
    checks.equal("directories of Open MPI that stay", [path.split("/", 1)[1] for path in left], ["jf.0/1/kept"])
checks.verdict()
