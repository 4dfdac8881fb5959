"""Starts the program: where it is, on how many ranks, with which options, and what it says when it fails."""
import contextlib
import functools
import os
import shutil
import signal
import subprocess
from pathlib import Path

from scree import case_file

STOP_SECONDS = 600  # that a run may take to end its step and write its checkpoint when it is stopped


class RunError(RuntimeError):
    """A run that failed: what the program said, in one line."""


class Interrupted(Exception):
    """Somebody asked to stop, by SIGTERM."""


def interrupt(*_):
    """A handler of signals."""
    raise Interrupted


# ---- the command ----


def checkout():
    """The directory of the source, or None where the package is installed elsewhere."""
    root = Path(__file__).resolve().parents[2]
    return root if (root / "scripts" / "build.sh").exists() else None


def build_directory():
    """Where the program was built: SCREE_BUILD_DIR, else build/ of the checkout, else build/ of this directory."""
    return Path(os.environ.get("SCREE_BUILD_DIR") or (checkout() or Path()) / "build")


def default_program():
    """The program that was built; where none was, the one on the PATH."""
    built = build_directory() / "bin" / "scree"
    found = None if built.exists() else shutil.which("scree")
    return Path(found) if found else built


def check_program(program):
    if not os.access(program, os.X_OK):
        raise RunError(f"no program {program}: scripts/build.sh builds it; SCREE_BUILD_DIR names another build")


def cores():
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0))


def launcher(ranks):
    """The words before the program on more than one rank."""
    if ranks == 1:
        return []
    return ["mpirun", "-n", str(ranks), *open_mpi_options()]


@functools.lru_cache(maxsize=None)
def open_mpi_options():
    """What Open MPI's mpirun wants told: ranks may share cores, and root may start them. Others have no such options."""
    said = subprocess.run(["mpirun", "--version"], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if "Open MPI" not in said.stdout + said.stderr:
        return []
    return ["--bind-to", "none", "--oversubscribe", *(["--allow-run-as-root"] if os.geteuid() == 0 else [])]


def environment():
    """The ranks are the parallelism; they may share cores."""
    return {**os.environ, "OMP_NUM_THREADS": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}


def option_text(value):
    """The value of an option as the program reads it: lists by commas, true and false."""
    if isinstance(value, (list, tuple)):
        return ", ".join(map(option_text, value))
    return str(value).lower() if isinstance(value, bool) else str(value)


def command(program, case, options, ranks=1):
    """The words that run a case."""
    words = [*launcher(ranks), str(program), str(case)]
    for name, value in options.items():
        words += [f"-{name}", option_text(value)]
    return words


# ---- running ----


def start(words, log, **more):
    """Starts the program with its output at the end of the file `log`, in a process group of its own."""
    with open(log, "a") as stream:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT,
                                start_new_session=True, env=environment(), **more)


def stop(process):
    """Ends a run after the step under way, with a checkpoint: mpirun passes SIGUSR1 on to its ranks. Another interrupt
    meanwhile ends it at once."""
    with contextlib.suppress(ProcessLookupError):
        process.send_signal(signal.SIGUSR1)
    try:
        process.wait(timeout=STOP_SECONDS)
    except (subprocess.TimeoutExpired, KeyboardInterrupt, Interrupted):
        end_group(process)


def end_group(process):
    """Ends the program with all its ranks, at once."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, number)
            process.wait(timeout=5)
            return
        except ProcessLookupError:
            return
        except subprocess.TimeoutExpired:
            pass


class KeptLog:
    """The log of a run in its output directory: `log.part` while it runs, then `log`. A run that goes on from a
    checkpoint there appends to it; one that the program refuses leaves the directory as it was."""

    def __init__(self, directory, goes_on):
        self.directory, self.goes_on = Path(directory), goes_on
        self.directory.mkdir(parents=True, exist_ok=True)
        self.part, self.log = self.directory / "log.part", self.directory / "log"
        self.part.unlink(missing_ok=True)
        self.case_before = self.case_written()

    def case_written(self):
        """When the effective case was written, with which a run begins."""
        file = self.directory / "case.yaml"
        return file.stat().st_mtime_ns if file.exists() else None

    def settle(self):
        """At the end of the run."""
        if self.case_written() == self.case_before:
            self.part.unlink()
            if not any(self.directory.iterdir()):
                self.directory.rmdir()
        elif self.goes_on and self.log.exists():
            with open(self.log, "ab") as log:
                log.write(self.part.read_bytes())
            self.part.unlink()
        else:
            self.part.replace(self.log)


def failure(log, code):
    """In one line why a run failed: the last line of the program in its log."""
    lines = [line.strip() for line in Path(log).read_text(errors="replace").splitlines() if line.strip()]
    said = [line.removeprefix("scree: ") for line in lines if line.startswith("scree: ")]
    last = said or lines
    how = f"signal {-code}" if code < 0 else f"exit code {code}"
    return last[-1] if said else f"{how}: {last[-1] if last else 'it said nothing'}"


def new_directory(case):
    """out/NAME for a case, or the first of out/NAME.2, out/NAME.3 ... that holds nothing."""
    file = case_file.find(case)
    stem = file.stem
    name = file.resolve().parent.name + ("" if stem == "case" else f"_{stem}")
    number, directory = 1, Path("out") / name
    while directory.exists() and any(directory.iterdir()):
        number += 1
        directory = Path("out") / f"{name}.{number}"
    return directory


def run(case, ranks=2, program=None, **options):
    """Runs a case to its end and opens what it left.

    case: a case file, or a directory that holds a case.yaml. ranks: MPI processes. options: those of the program
    without the dash, such as end_time=0.1 or friction_tau="1e-2 s"; numbers are SI. Without output_dir the run goes to
    a new directory below out/. What the program says goes to the file `log` in the output directory.

    Raises RunError with the program's error, FileNotFoundError where there is no such case. When interrupted the run
    writes a checkpoint first; when interrupted again it ends at once."""
    program = Path(program or default_program())
    check_program(program)
    file = case_file.find(case)
    directory = Path(options.pop("output_dir", None) or new_directory(case))
    log = KeptLog(directory, "restart" in options)
    process = start(command(program, file, {**options, "output_dir": directory}, ranks), log.part)
    try:
        process.wait()
    except BaseException:
        stop(process)
        log.settle()
        raise
    reason = failure(log.part, process.returncode) if process.returncode else ""
    log.settle()
    if reason:
        raise RunError(reason)
    from scree.results import Run  # brings pandas and xarray, see __init__.py

    return Run(directory)


def check(case, program=None, **options):
    """The options of a case as the program understands them, in SI: name -> text. Raises RunError."""
    program = Path(program or default_program())
    check_program(program)
    words = [*command(program, case_file.find(case), options), "-check"]
    process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=environment())
    if process.returncode:
        said = process.stderr.strip().splitlines() or [f"exit code {process.returncode}"]
        raise RunError(f"{case}: {said[-1].removeprefix('scree: ')}")
    return case_file.flatten(process.stdout)


def clock(seconds):
    """A duration in words: 3 s, 5 min, 1 h 20 min."""
    minutes = round(seconds / 60)
    if minutes < 2:
        return f"{seconds:.0f} s"
    return f"{minutes // 60} h {minutes % 60:02d} min" if minutes >= 60 else f"{minutes} min"
