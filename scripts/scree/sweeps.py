"""Sweeps: a case with all combinations of some options, on the cores of a machine, into one table.

    scree-sweep cases/bin_discharge -friction_tau 1e-3,1e-2 -accuracy 1e-2,3e-3 -end_time 0.5 -o sweep.csv

An option with several values, separated by commas, is swept; where the values hold commas, separate them by semicolons:
-grid_x_cells '4, 16; 8, 32'. An option with one value holds for all runs. The runs go to directories below that of
--work; what is done already is not run again, what failed is a row with its reason. Start the command again to go on."""
import argparse
import itertools
import json
import re
import shutil
import signal
import sys
import threading
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import pandas

from scree import case_file, output, program

#: What the table says of a run beside its options and quantities: column -> key of summary.json.
COSTS = {"time [s]": "time", "steps": "steps", "newton_iterations": "newton_iterations",
         "krylov_iterations": "krylov_iterations", "wall_seconds": "wall_seconds"}


def sweep(case, values, jobs=None, ranks=1, work=None, csv=None, retry=False, executable=None, say=None, **options):
    """Runs a case with all combinations of the values and returns the table, a row a run, as a pandas.DataFrame.

    values: option -> list of values. options: those that all runs share. jobs: runs at a time; as many as the cores
    hold. work: directory of the runs, out/sweep_CASE without. csv: file for the table, written after each run.
    retry: run anew what failed. executable: the program. say: called with a line about each run.

    Columns: the swept options, status (done, failed), reason, directory, cost, and the quantities of summary.json [SI].
    Runs with the same options and case that are there already are not run again."""
    file = case_file.find(case)
    executable = Path(executable or program.default_program())
    program.check_program(executable)
    work = Path(work or Path("out") / f"sweep_{file.resolve().parent.name}")
    points = [Point(file, executable, ranks, work, dict(zip(values, combination)), options)
              for combination in itertools.product(*values.values())]
    missing = [point for point in points if point.state() == "missing" or (retry and point.state() == "failed")]
    jobs = jobs or max(1, program.cores() // ranks)
    for number, point in enumerate(run_all(missing, jobs), 1):
        write(csv, points)
        if say:
            say(f"[{number}/{len(missing)}] {point.name}: {point.record()['reason'] or 'done'}")
    write(csv, points)
    return table(points)


class Point:
    """One combination of the swept options, and its run."""

    def __init__(self, case, executable, ranks, work, swept, shared):
        self.case, self.executable, self.ranks, self.swept = case, executable, ranks, swept
        self.options = {name: program.option_text(value) for name, value in {**shared, **swept}.items()}
        self.name = "_".join(f"{name}={plain(self.options[name])}" for name in swept) or "run"
        self.directory = work / self.name

    def key(self):
        """What makes a run the same: the case and the options."""
        return {"case": case_file.read(self.case), "options": self.options}

    def record(self):
        """How the run of these options ended: {key, reason}; None: it has not been run."""
        kept = self.directory / "sweep.json"
        stored = json.loads(kept.read_text()) if kept.exists() else None
        return stored if stored and stored["key"] == self.key() else None

    def state(self):
        """done, failed, or missing."""
        record = self.record()
        return "missing" if record is None else "failed" if record["reason"] else "done"

    def run(self, processes):
        """Runs to the end. processes: where the process is while it runs, for those who have to end it."""
        shutil.rmtree(self.directory, ignore_errors=True)
        self.directory.mkdir(parents=True)
        log = self.directory / "log"
        options = {**self.options, "output_dir": self.directory}
        process = processes.start(program.command(self.executable, self.case, options, self.ranks), log)
        if process is None:
            return
        process.wait()
        if processes.stopped:
            shutil.rmtree(self.directory, ignore_errors=True)
            return
        record = {"key": self.key(), "reason": self.reason(process.returncode, log)}
        new = self.directory / "sweep.json.new"  # others read the table's rows meanwhile: all of it or nothing
        new.write_text(json.dumps(record, indent=1))
        new.rename(self.directory / "sweep.json")

    def reason(self, code, log):
        """Why the run failed, empty where it reached its end."""
        if code:
            return program.failure(log, code)
        end = output.summary(self.directory)["end"]
        return "" if end == "end_time" else f"ended early: {end}"

    def row(self):
        """The row of the table; of a failed run without its numbers."""
        row = {**self.swept, "status": self.state(), "reason": self.record()["reason"], "directory": str(self.directory)}
        if row["status"] != "done":
            return row
        summary = output.summary(self.directory)
        row.update({column: summary[key] for column, key in COSTS.items()}, cpu_seconds=summary["cpu_seconds"]["total"])
        return {**row, **summary["quantities"]}


def plain(text):
    """A value as a part of a file name."""
    return re.sub(r"[^\w.+-]+", "-", text)


class Processes:
    """The programs that run; all are ended when the sweep is interrupted."""

    def __init__(self):
        self.running, self.stopped, self.lock = [], False, threading.Lock()

    def start(self, words, log):
        """A new process, or None once the sweep has been interrupted."""
        with self.lock:
            if self.stopped:
                return None
            process = program.start(words, log)
            self.running.append(process)
        return process

    def stop(self):
        with self.lock:
            self.stopped = True
        for process in self.running:
            if process.poll() is None:
                program.end_group(process)


def run_all(points, jobs):
    """Runs points, `jobs` at a time, and yields each when it has ended."""
    processes = Processes()
    with ThreadPoolExecutor(jobs) as pool:
        futures = {pool.submit(point.run, processes): point for point in points}
        try:
            for future in as_completed(futures):
                future.result()
                yield futures[future]
        except BaseException:
            processes.stop()
            raise


def table(points):
    """A row for each point that has been run."""
    return pandas.DataFrame([point.row() for point in points if point.state() != "missing"])


def write(csv, points):
    """The table as a file, at once or not at all."""
    if csv:
        csv = Path(csv)
        csv.parent.mkdir(parents=True, exist_ok=True)
        new = csv.with_name(csv.name + ".new")
        table(points).to_csv(new, index=False)
        new.rename(csv)


# ---- from the command line ----


def options_of(words):
    """The program's options of a command line: name -> list of values. Raises ValueError."""
    options = {}
    while words:
        name, *words = words
        if not re.match(r"-[a-zA-Z]\w*$", name):
            raise ValueError(f"{name}: expected an option of the program, such as -end_time 0.5")
        if not words:
            raise ValueError(f"{name}: expected a value")
        text, *words = words
        separator = ";" if ";" in text else ","
        options[name[1:]] = [value.strip() for value in text.split(separator) if value.strip()]
        if not options[name[1:]]:
            raise ValueError(f"{name}: '{text}' holds no value")
    return options


def arguments():
    parser = argparse.ArgumentParser(prog="scree-sweep", description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter,
                                     usage="scree-sweep CASE -OPTION V1,V2,... [-OPTION V] [-o FILE] [--jobs N] [...]")
    parser.add_argument("case", help="a case file, or a directory with a case.yaml")
    parser.add_argument("-o", "--output", type=Path, default=Path("sweep.csv"), help="the table; default sweep.csv")
    parser.add_argument("--work", type=Path, help="directory of the runs; default out/sweep_CASE")
    parser.add_argument("--jobs", type=int, help="runs at a time; default: as many as the cores hold")
    parser.add_argument("--ranks", type=int, default=1, help="of each run; default 1")
    parser.add_argument("--retry", action="store_true", help="run anew what failed")
    parser.add_argument("--program", type=Path, help="default: that of scripts/build.sh")
    # argparse takes -output_dir for -o with the value utput_dir: the program's options are taken out before.
    own, words = divided(sys.argv[1:])
    given = parser.parse_args(own)
    try:
        options = options_of(words)
        swept = {name: values for name, values in options.items() if len(values) > 1}
        if not swept:
            raise ValueError("no option has several values: -friction_tau 1e-3,1e-2")
        for name in ("output_dir", "restart"):
            if name in options:
                raise ValueError(f"-{name}: the runs go below the directory of --work")
    except ValueError as error:
        parser.error(str(error))
    return given, swept, {name: values[0] for name, values in options.items() if len(values) == 1}


def divided(words):
    """The words of this command and those of the program: options of one dash and more than one letter, with values."""
    own, others = [], []
    words = iter(words)
    for word in words:
        if re.match(r"-[a-zA-Z]\w+$", word):
            others += [word, *itertools.islice(words, 1)]
        else:
            own.append(word)
    return own, others


def main():
    given, swept, options = arguments()
    sys.stdout.reconfigure(line_buffering=True)
    signal.signal(signal.SIGTERM, program.interrupt)
    try:
        found = sweep(given.case, swept, given.jobs, given.ranks, given.work, given.output, given.retry, given.program,
                      print, **options)
    except (KeyboardInterrupt, program.Interrupted):
        print("scree-sweep: stopped; start again to go on", file=sys.stderr)
        sys.exit(130)
    except (program.RunError, OSError) as error:
        print(f"scree-sweep: {error}", file=sys.stderr)
        sys.exit(1)
    failed = int((found.status == "failed").sum())
    print(f"{len(found)} runs in {given.output}" + (f", {failed} of them failed" if failed else ""))
    sys.exit(1 if failed == len(found) else 0)


if __name__ == "__main__":
    main()
