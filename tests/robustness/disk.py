"""A disk that fills up during a run, and output directories that cannot be written: one line that names the directory,
exit code 1, whatever was written before stays whole, and with room again the run goes on to the same end, bit for bit.

The disk is a tmpfs where this machine allows to mount one (root), of --sizes N sizes (default: 4), and one that another
file fills while the run is under way, so that different files do not fit.
Elsewhere a limit on the size of files stands for it."""
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from collections import Counter

import h5py
import numpy as np
from robust import checkpoints, one_line, option, same_bits, vectors
from scree_program import Checks, Program, Run

CASE = "bed.yaml"
WITH_FIELDS = {"checkpoint_interval": 0.002, "output_interval": 0.004, "end_time": 0.03}
FREQUENT = {"checkpoint_interval": 0.002, "end_time": 0.03}
RARE = {"checkpoint_interval": 0.012, "end_time": 0.03}  # so that monitor.csv is the next file that grows
SMALLEST = 40  # kB: too small for the first fields


class Disk:
    """A small file system below the work directory."""

    def __init__(self, path):
        self.path = path
        path.mkdir()

    def mount(self, size):
        words = ["mount", "-t", "tmpfs", "-o", f"size={size}k,mode=777", "tmpfs", self.path]
        return subprocess.run(words, capture_output=True).returncode == 0

    def remount(self, *options):
        subprocess.run(["mount", "-o", "remount," + ",".join(options), self.path], check=True)

    def unmount(self):
        subprocess.run(["umount", self.path], check=True)


def enter_own_mounts():
    """Starts this script again with mounts of its own, which end with it, where that is allowed."""
    words = ["unshare", "--mount"]
    if "SCREE_OWN_MOUNTS" in os.environ or not shutil.which(words[0]):
        return
    if subprocess.run([*words, "true"], capture_output=True).returncode:
        return
    os.environ["SCREE_OWN_MOUNTS"] = "yes"
    os.execvp(words[0], [*words, sys.executable, *sys.argv])


def start(directory, options, prefix=(), **more):
    words = [*prefix, *program.command(CASE, {"output_dir": directory, **options})]
    process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=480, **more)
    return Run(directory, process)


def start_and_fill(directory, options, fill):
    """A run in which `fill(process id)` leaves no room for more after the first checkpoint."""
    words = program.command(CASE, {"output_dir": directory, **options})
    process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
    while process.poll() is None and not checkpoints(directory):
        time.sleep(0.001)
    fill(process.pid)
    out, errors = process.communicate(timeout=480)
    return Run(directory, subprocess.CompletedProcess(words, process.returncode, out, errors))


def fill_disk(_):
    """All that is left of the disk goes into one file."""
    try:
        with open(disk.path / "filler", "wb", buffering=0) as file:
            while True:
                file.write(b"x" * 4096)
    except OSError:
        pass


def limit_files(process):
    """From now on no file of that process may grow beyond 100 bytes."""
    resource.prlimit(process, resource.RLIMIT_FSIZE, (100, resource.RLIM_INFINITY))


def damaged(directory):
    """Files of a failed run that are not whole: HDF5 that cannot be read or holds NaN, temporary files."""
    found = [p.name for p in directory.rglob("*") if p.name.endswith(".part") or p.name == ".scree_write_test"]
    for path in [*checkpoints(directory), *sorted((directory / "fields").glob("*.h5"))]:
        try:
            with h5py.File(path, "r") as file:
                values = [item[()] for item in [*file.values(), *file.get("vectors", {}).values()]
                          if isinstance(item, h5py.Dataset) and item.dtype.kind == "f"]
            found += [] if values and all(np.isfinite(v).all() for v in values) else [f"{path.name}: NaN"]
        except OSError as error:
            found.append(f"{path.name}: {error}")
    return found


def fills_up(name, whole, first, again):
    """A run that fails in `first()` and goes on with `again(options)`, to the end of `whole`. Returns the file that did
    not fit."""
    failed = first()
    complaint = one_line(failed, str(failed.directory))
    checks.true(f"{name}: one line that names the directory", complaint is None, complaint)
    checks.equal(f"{name}: files that are not whole", damaged(failed.directory), [])
    restart = bool(checkpoints(failed.directory))
    finished = again({"restart": failed.directory} if restart else {"output_overwrite": None})
    checks.true(f"{name}: with room again ({'restart' if restart else 'from the start'}) the same end, bit by bit",
                finished.code == 0 and same_bits(whole.fields, finished.fields)
                and same_bits(vectors(checkpoints(whole.directory)[-1]), vectors(checkpoints(finished.directory)[-1]))
                and np.array_equal(finished.monitor["time"], whole.monitor["time"]),
                f"exit {finished.code} {finished.errors}")
    file = re.search(r"'([^']*)'", failed.errors)
    return re.sub(r"\d{6,}", "N", file[1].replace(str(failed.directory), "").strip("/")) if file else "?"


enter_own_mounts()
sizes = option("--sizes", 4)
program, checks = Program(), Checks("full disks and directories that cannot be written", "R2")
runs = {name: program.run(CASE, name, options)
        for name, options in (("with_fields", WITH_FIELDS), ("frequent", FREQUENT), ("rare", RARE))}

disk = Disk(program.work / "disk")
out = disk.path / "out"
if "SCREE_OWN_MOUNTS" in os.environ and disk.mount(64):
    disk.unmount()
    stopped_at = Counter()
    # kB: all but the run at its end, which needs some in addition while it writes
    largest = sum((p.stat().st_size + 4095) // 4096 * 4 for p in runs["with_fields"].directory.rglob("*"))
    for size in np.linspace(SMALLEST, largest, sizes).astype(int) // 4 * 4:
        disk.mount(size)
        try:
            def with_room(more):
                disk.remount("size=16m")
                return start(out, {**WITH_FIELDS, **more})

            file = fills_up(f"disk of {size} kB", runs["with_fields"], lambda: start(out, WITH_FIELDS), with_room)
            stopped_at[file] += 1
        finally:
            disk.unmount()
    disk.mount(1024)
    try:
        for name, options in (("frequent", FREQUENT), ("rare", RARE)):
            def without_filler(more):
                (disk.path / "filler").unlink()
                return start(out, {**options, **more})

            stopped_at[fills_up(f"disk that another file fills, checkpoints {name}", runs[name],
                                lambda: start_and_fill(out, options, fill_disk), without_filler)] += 1
            shutil.rmtree(out)
        print(f"  files that did not fit: {dict(stopped_at)}")
        checks.above("different files at which a disk was full", len(stopped_at), 2)
        disk.remount("ro")
        complaint = one_line(start(out, {}), str(out), "Read-only file system")
        checks.true("read-only file system", complaint is None, complaint)
    finally:
        disk.unmount()
else:
    print("  no file system can be mounted here: limits on the size of files instead, no read-only directory")
    for name, options in (("frequent", FREQUENT), ("rare", RARE)):
        directory = program.work / f"limit_{name}"
        fills_up(f"small files, checkpoints {name}", runs[name],
                 lambda: start_and_fill(directory, options, limit_files),
                 lambda more: start(directory, {**options, **more}))

closed = program.work / "closed"
closed.mkdir()
closed.chmod(0o555)
as_nobody = []
if os.getuid() == 0:  # root may write anywhere
    as_nobody = ["setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups", "--"]
    reach = [*as_nobody, "test", "-r", program.here / CASE, "-a", "-x", program.scree]
    if not shutil.which("setpriv") or subprocess.run(reach, capture_output=True).returncode or program.ranks > 1:
        as_nobody = None
        print("  not tried here: a directory without permission (root may write anywhere)")
if as_nobody is not None:
    for name, directory in (("directory without permission", closed), ("directory below one", closed / "out")):
        run = start(directory, {}, as_nobody, env={**os.environ, "HOME": "/tmp"})
        complaint = one_line(run, str(directory), "Permission denied")
        checks.true(name, complaint is None, complaint)
checks.verdict()
