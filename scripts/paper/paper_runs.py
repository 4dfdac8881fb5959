#!/usr/bin/env python3
"""The runs behind the paper's figures: what they are, whether they are there, and running what is missing.

    scripts/paper/paper_runs.py            # lists the runs of the page, what they are thought to take, what is left
    scripts/paper/paper_runs.py --left     # only the last line of that

A run is kept in OUT/runs/NAME_GRID: run.json (its options, how far it got, what it took), log, out/ (what scree
leaves). It is reused as long as its options and those of its case are the same, whatever the ranks; one that got less
far than is asked for goes on from its last checkpoint."""
import argparse
import contextlib
import fcntl
import json
import os
import shutil
import signal
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import numpy as np

from scree import case_file, output, program
from scree.program import Interrupted, clock

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"
#: From coarse to fine; the last two are the paper's with -grid_refine.
GRIDS = ("coarse", "paper", "half", "quarter")
REFINE = {"half": 2, "quarter": 4}
#: CPU seconds on a grid over those on the paper's.
GRID_COST = {"coarse": 0.18, "paper": 1.0, "half": 7.0, "quarter": 60.0}
#: Options that change nothing but how much is computed and written.
BESIDE_THE_POINT = ("end_time", "output_dir", "checkpoint_interval", "based_on")
CHECKPOINTS = 20  # a run


@dataclass(frozen=True)
class Entry:
    """A run: case files on the coarse and on the paper's grid, options on top (an option that depends on the grid is a
    dict), simulated time by grid, and the window of time [s] of its means."""

    name: str
    coarse: str
    paper: str
    options: dict = field(hash=False, default_factory=dict)
    end: dict = field(hash=False, default_factory=dict)  # by grid, "" for the others [s]
    window: tuple = ()
    interval: float = 0.0  # between fields [s]
    cpu: tuple = ((0.0, 0.0),)  # of the paper's grid on 2 ranks: (t, CPU seconds up to t), beyond by the last slope
    page: tuple = ("coarse", "paper")  # grids on which the page needs it

    def case(self, grid):
        return CASES / (self.coarse if grid == "coarse" else self.paper)

    def end_time(self, grid):
        return self.end.get(grid, self.end[""])

    def given(self, grid):
        """The options beside those of the case file."""
        base = "coarse" if grid == "coarse" else "paper"
        options = {name: value[base] if isinstance(value, dict) else value for name, value in self.options.items()}
        options = {name: str(value) for name, value in options.items() if value is not None}
        if grid in REFINE:
            options["grid_refine"] = str(REFINE[grid])
        return {**options, "output_interval": f"{self.interval:g}"}

    def key(self, grid):
        """What makes a run the same: all options that were given, by case file or on top."""
        options = {**case_file.read(self.case(grid)), **self.given(grid)}
        return {name: value for name, value in sorted(options.items()) if name not in BESIDE_THE_POINT}

    def cpu_seconds(self, grid, begin, end):
        """What is expected between two times [s]."""
        return GRID_COST[grid] * (extended(self.cpu, end) - extended(self.cpu, begin))


def extended(points, t):
    """Linear interpolation of (t, value), beyond the last point by the last slope."""
    times, values = zip(*points)
    if t <= times[-1] or len(times) < 2:
        return float(np.interp(t, times, values))
    return values[-1] + (t - times[-1]) * (values[-1] - values[-2]) / (times[-1] - times[-2])


# ---- the table ----

STEADY = (1.5, 4.5)  # [s], between which the paper measures the depth
WIDTHS = {"1.4": "bin", "1.6": "width_1.6", "1.8": "width_1.8", "2.0": "width_2.0"}  # of the orifice [cm]
WIDTH_CELLS = {"1.6": {"coarse": "4, 16", "paper": "8, 32"}, "1.8": {"coarse": "5, 15", "paper": "9, 31"},
               "2.0": {"coarse": "5, 15", "paper": "10, 30"}}
BIN = dict(coarse="bin_discharge/coarse.yaml", paper="bin_discharge/paper.yaml", interval=0.1)
BUBBLE = dict(interval=0.02, end={"": 0.5}, window=(0.5, 0.5), page=("coarse", "paper", "half"))
SIX_MM = {"grid_x_cells": {"coarse": "2, 10", "paper": None}, "grid_y_cells": {"coarse": "67, 50", "paper": None}}
EQUILIBRIUM = {"initial_fill_profile": "equilibrium", "initial_fill_surface": "105 cm",
               "initial_fill_janssen_width": "8 cm"}
FINE = dict(interval=0.05, end={"": 1.2}, window=(0.6, 1.2))


def scaled(factor, points):
    return tuple((t, factor * seconds) for t, seconds in points)


BIN_CPU = ((0.0, 0.0), (0.1, 30.0), (0.3, 65.0), (1.3, 115.0))
AIR_CPU = ((0.0, 0.0), (0.1, 210.0), (1.1, 630.0))  # 100 um
BUBBLE_CPU = ((0.0, 0.0), (0.5, 60.0))


@dataclass(frozen=True)
class Parameter:
    """A parameter of the model: its option, its value (in the option's unit), the step of the differences, and what
    sets it."""

    symbol: str
    option: str
    value: float
    step: float
    unit: str = ""

    def entry(self, steps):
        value = f"{self.value + steps * self.step:.6g} {self.unit}".strip()
        return parameter_entry(f"parameters/{self.option}_{steps:+d}", {self.option: value})


# Steps are as large as the curvature allows, so that the differences stand out of what steps in time do to the rate.
PARAMETERS = (
    Parameter("φ", "friction_angle", 28.5, 1.5, "deg"),
    Parameter("δ", "wall_friction_angle", 12.3, 1.5, "deg"),
    Parameter("φ′", "wall_specularity", 0.25, 0.05),
    Parameter("e_p", "particle_restitution", 0.91, 0.02),
    Parameter("F", "friction_pressure_constant", 0.5, 0.1, "dyn/cm^2"),
    Parameter("ν_min", "friction_solids_fraction_min", 0.5, 0.01),
    Parameter("d", "particle_diameter", 1.0, 0.1, "mm"),
    Parameter("D_o", "orifice_width", 1.4, 0.1, "cm"),
)
DIFFERENCES = (-2, -1, 1, 2)  # in steps


def parameter_entry(name, options):
    return Entry(name, **{**BIN, "interval": 0.0}, options=options, end={"": 0.7}, window=(0.4, 0.7), cpu=BIN_CPU,
                 page=("coarse",))


def table():
    """All runs by name."""
    entries = [
        Entry("bin", **BIN, end={"": 6.0, "half": 4.5, "quarter": 0.1}, window=STEADY, cpu=BIN_CPU, page=GRIDS),
        Entry("bin_tau_1e-2", **BIN, options={"friction_tau": "1e-2 s"}, end={"": 6.0}, window=STEADY, cpu=BIN_CPU),
        Entry("bin_tau_1e-1", **BIN, options={"friction_tau": "1e-1 s"}, end={"": 6.0}, window=STEADY, cpu=BIN_CPU),
        Entry("bin_critical_state", **BIN, options={"friction_model": "critical_state"}, end={"": 4.5}, window=STEADY,
              cpu=BIN_CPU),
        Entry("bin_air", **BIN, options={"gas": "incompressible"}, end={"": 2.0}, window=(1.0, 2.0),
              cpu=scaled(2.8, BIN_CPU)),
        Entry("bin_instantaneous", **BIN, options={"friction_model": "instantaneous"}, end={"": 1.0}, window=(0.5, 1.0),
              cpu=scaled(1.3, BIN_CPU)),
        Entry("bin_equilibrium", **BIN, options=EQUILIBRIUM, end={"": 2.0}, window=(1.0, 2.0), cpu=BIN_CPU),
        *(Entry(WIDTHS[width], **BIN, options={"orifice_width": f"{width} cm", "grid_x_cells": cells}, end={"": 2.0},
                window=(1.0, 2.0), cpu=scaled(1.1, BIN_CPU)) for width, cells in WIDTH_CELLS.items()),
        Entry("fine_air", "bin_discharge_fine/case.yaml", "bin_discharge_fine/paper.yaml", **FINE, cpu=AIR_CPU),
        Entry("fine_vacuum", "bin_discharge_fine/case.yaml", "bin_discharge_fine/paper.yaml",
              options={"gas": "none"}, **FINE, cpu=scaled(0.35, AIR_CPU)),
        *(Entry(f"bubble_{model}", f"bubble_rise/{file}.yaml", f"bubble_rise/{file}.yaml", options=SIX_MM, **BUBBLE,
                cpu=scaled(factor, BUBBLE_CPU))
          for model, file, factor in (("relaxed", "paper", 1.0), ("critical_state", "critical_state", 1.0),
                                      ("no_friction", "no_friction", 2.0))),
        parameter_entry("parameters/base", {}),
        parameter_entry("parameters/accuracy", {"accuracy": "3e-2"}),
        *(parameter.entry(steps) for parameter in PARAMETERS for steps in DIFFERENCES),
    ]
    return {entry.name: entry for entry in entries}


TABLE = table()


def page_runs(grid=None):
    """(entry, grid) of all that the page shows, or of what all.sh --grid runs."""
    if not grid:
        return [(entry, one) for entry in TABLE.values() for one in entry.page]
    finest = GRIDS.index(grid)
    chosen = {entry: [grid, *(one for one in GRIDS[:finest] if one in entry.page)] for entry in TABLE.values()}
    return [(entry, one) for entry, grids in chosen.items()
            for one in (entry.page if entry.name.startswith("parameters/") else grids)]


# ---- running ----


class Problem(Exception):
    """What goes wrong with runs, in one line."""


def ranks_of(grid):
    return 1 if grid == "coarse" else 2


class Runs:
    """The runs below a directory: tells which are there, runs what is missing."""

    def __init__(self, out, program=None, ranks=None, end_time=float("inf"), only_draw=False):
        self.directory, self.program, self.ranks = Path(out) / "runs", program, ranks
        self.end_limit, self.only_draw = end_time, only_draw

    def place(self, entry, grid):
        return self.directory / f"{entry.name}_{grid}"

    def end_time(self, entry, grid):
        return min(entry.end_time(grid), self.end_limit)

    def record(self, entry, grid):
        """What is kept of the run: reached [s], sessions; of one with other options or none: nothing."""
        kept = self.place(entry, grid) / "run.json"
        if kept.exists():
            stored = json.loads(kept.read_text())
            if stored["key"] == entry.key(grid):
                return stored
        return {"key": entry.key(grid), "reached": 0.0, "sessions": []}

    def find(self, entry, grid):
        """The output directory of a run that was ended, however short, or None."""
        if not self.record(entry, grid)["reached"]:
            return None
        out = self.place(entry, grid) / "out"
        return out if (out / "summary.json").exists() else None

    def done(self, entry, grid):
        return self.record(entry, grid)["reached"] >= self.end_time(entry, grid) * (1 - 1e-9)

    def cost(self, entry, grid):
        """CPU and wall seconds of all sessions, and their ranks."""
        sessions = self.record(entry, grid)["sessions"]
        return {"cpu": sum(one["cpu"] for one in sessions), "wall": sum(one["wall"] for one in sessions),
                "ranks": max((one["ranks"] for one in sessions), default=0)}

    def left(self, entry, grid):
        """CPU seconds that the run is still thought to take."""
        reached, end = self.record(entry, grid)["reached"], self.end_time(entry, grid)
        return entry.cpu_seconds(grid, reached, end) if reached < end * (1 - 1e-9) else 0.0

    def wall_per_cpu_estimate(self):
        """Wall seconds for an estimated CPU second, by the runs that are there."""
        wall = estimated = 0.0
        for entry, grid in page_runs():
            record = self.record(entry, grid)
            wall += sum(one["wall"] * min(one["ranks"], 2) / 2 for one in record["sessions"])
            estimated += entry.cpu_seconds(grid, 0.0, record["reached"])
        return wall / estimated if estimated > 20 else 0.6

    def wall_left(self, entry, grid):
        return self.left(entry, grid) * self.wall_per_cpu_estimate() * 2 / min(2, self.ranks or ranks_of(grid))

    def get(self, name, grid):
        """The output directory of a run, run as far as it has not been."""
        entry = TABLE[name]
        if self.only_draw:
            found = self.find(entry, grid)
            if not found:
                raise Problem(f"no run {entry.name} on the grid '{grid}' in {self.directory}: leave out --only-draw")
            return found
        if not self.done(entry, grid):
            with self.alone(entry, grid):
                if not self.done(entry, grid):
                    self.run(entry, grid)
        return self.place(entry, grid) / "out"

    @contextlib.contextmanager
    def alone(self, entry, grid):
        """Holds the lock of a run; the program inherits it, so that one whose script was killed is waited for."""
        place = self.place(entry, grid)
        place.parent.mkdir(parents=True, exist_ok=True)
        with open(place.with_name(place.name + ".lock"), "w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                print(f"  {place.name}: another process runs it, waiting", flush=True)
                fcntl.flock(lock, fcntl.LOCK_EX)
            self.lock = lock.fileno()
            yield

    def check_program(self):
        if not self.program or not os.access(self.program, os.X_OK):
            raise Problem(f"no program {self.program}: scripts/build.sh builds it, --program names another")

    def run(self, entry, grid):
        """Runs to the end, from the last checkpoint if there is one of the same run."""
        self.check_program()
        place, record = self.place(entry, grid), self.record(entry, grid)
        on_the_way = place / "out" / "checkpoints"
        goes_on = any(on_the_way.glob("*.h5")) and (place / "run.json").exists() and same_run(place, record)
        if not goes_on:
            shutil.rmtree(place, ignore_errors=True)
            place.mkdir(parents=True)
            record.update(reached=0.0, sessions=[])
            write_record(place, record)
        else:
            count_lost_session(place, record)
        end = self.end_time(entry, grid)
        ranks = self.ranks or ranks_of(grid)
        options = {**entry.given(grid), "output_dir": place / "out", "end_time": f"{end:.9g}",
                   "checkpoint_interval": f"{end / CHECKPOINTS:.3g}", **({"restart": place / "out"} if goes_on else {})}
        words = program.command(self.program, entry.case(grid), options, ranks)
        begins = f"goes on from t = {reached_so_far(place / 'out'):.3g} s" if goes_on else "from t = 0"
        expected = f"about {clock(self.wall_left(entry, grid))} on {ranks} rank{'s' * (ranks > 1)}"
        print(f"  {place.name}: {begins} to {end:g} s, {expected}", flush=True)
        record["open"] = ranks
        write_record(place, record)
        begun, code = time.monotonic(), None
        try:
            code = self.watch(words, place, entry, grid, end)
        finally:
            close_session(place, record, ranks, time.monotonic() - begun, code)
        if record["end"] != "end_time":
            raise Problem(f"{place.name}: {record['end']}; see {place / 'log'}")
        print(f"  {place.name}: done, {clock(record['sessions'][-1]['wall'])}, "
              f"{record['sessions'][-1]['cpu']:.0f} CPU s", flush=True)

    def watch(self, words, place, entry, grid, end):
        """Waits for the program, saying how far it is, and returns its exit code; when stopped, lets it write a
        checkpoint."""
        process = program.start(words, place / "log", pass_fds=[self.lock])
        line = Progress(place, entry, grid, end)
        previous = signal.signal(signal.SIGTERM, program.interrupt)
        try:
            while process.poll() is None:
                time.sleep(0.2)
                line.show()
        except BaseException:
            line.end()
            program.stop(process)
            raise
        finally:
            signal.signal(signal.SIGTERM, previous)
        line.end()
        return process.returncode


def write_record(place, record):
    """At once or not at all."""
    new = place / "run.json.new"
    new.write_text(json.dumps(record, indent=1))
    new.rename(place / "run.json")


def same_run(place, record):
    return json.loads((place / "run.json").read_text())["key"] == record["key"]


def last_row(out, *names):
    """The named columns of the last row of monitor.csv; zeros where there is none."""
    try:
        columns = output.monitor(out)
        return [float(columns[name][-1]) for name in names]
    except (OSError, ValueError, IndexError, KeyError):
        return [0.0] * len(names)


def reached_so_far(out):
    return last_row(out, "time")[0]


def count_lost_session(place, record):
    """A session that was killed with its script left its seconds in monitor.csv only."""
    ranks = record.pop("open", None)
    if ranks:
        cpu = last_row(place / "out", "cpu_seconds")[0]
        record["sessions"].append({"cpu": cpu, "wall": cpu / ranks, "ranks": ranks})


def close_session(place, record, ranks, wall, code):
    """Notes how far the run got and what it took. code: the exit code of the program, None: it was stopped."""
    summary_file = place / "out" / "summary.json"
    summary = json.loads(summary_file.read_text()) if summary_file.exists() else None
    reached, cpu = last_row(place / "out", "time", "cpu_seconds")
    if not code and summary and abs(summary["time"] - reached) <= 1e-9 * reached:
        record["reached"], record["end"], cpu = summary["time"], summary["end"], summary["cpu_seconds"]["total"]
    else:
        text = (place / "log").read_text().strip().splitlines()
        record["end"] = "failed: " + (text[-1] if text else "it said nothing")
    record["sessions"].append({"cpu": cpu, "wall": wall, "ranks": ranks})
    record.pop("open", None)
    write_record(place, record)


class Progress:
    """A line about the run under way: on a terminal every second, else every minute."""

    def __init__(self, place, entry, grid, end):
        self.place, self.entry, self.grid, self.end_time = place, entry, grid, end
        self.terminal = sys.stdout.isatty()
        self.began, self.reached_at_start = time.monotonic(), reached_so_far(place / "out")
        self.shown = self.began

    def show(self):
        now = time.monotonic()
        if now - self.shown < (1 if self.terminal else 60):
            return
        self.shown = now
        t = reached_so_far(self.place / "out")
        past = self.entry.cpu_seconds(self.grid, self.reached_at_start, t)
        left = self.entry.cpu_seconds(self.grid, t, self.end_time) * (now - self.began) / past if past else float("nan")
        text = f"  {self.place.name}: t = {t:.4g} of {self.end_time:g} s" + (f", {clock(left)} left" if past else "")
        print(f"\r{text:<90}" if self.terminal else text, end="" if self.terminal else "\n", flush=True)

    def end(self):
        if self.terminal:
            print("\r" + " " * 92 + "\r", end="", flush=True)


# ---- from the command line ----


def positive(kind):
    def parse(text):
        value = kind(text)
        if not value > 0:
            raise ValueError
        return value

    parse.__name__ = f"positive {'number' if kind is float else 'whole number'}"
    return parse


class Parser(argparse.ArgumentParser):
    """What is wrong is one line."""

    def error(self, message):
        self.exit(2, f"{self.prog}: {message}\n")


def arguments(text, grid="paper", more=()):
    """Parses the options that all scripts here have, and `more`, pairs (name, keywords of add_argument)."""
    parser = Parser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grid", choices=GRIDS, default=grid,
                        help=f"default {grid or 'those of the page'}; half and quarter: of the paper's cells")
    parser.add_argument("--end-time", type=positive(float), default=float("inf"), metavar="S",
                        help="no run goes beyond this time [s]")
    parser.add_argument("--program", type=Path, default=program.default_program(), help="default: that of scripts/build.sh")
    parser.add_argument("--ranks", type=positive(int), help="default 2, on the coarse grid 1")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "paper", help="default out/paper")
    parser.add_argument("--only-draw", action="store_true", help="run nothing, draw what is there")
    parser.add_argument("--skip-done", action="store_true", help="keep pictures newer than their runs and script")
    for name, keywords in more:
        parser.add_argument(name, **keywords)
    given = parser.parse_args()
    given.out = given.out.absolute()
    given.runs = Runs(given.out, given.program.absolute(), given.ranks, given.end_time, given.only_draw)
    return given


def guarded(main):
    """Runs main; what goes wrong is one line and an exit code."""
    name = Path(sys.argv[0]).name
    sys.stdout.reconfigure(line_buffering=True)
    try:
        main()
    except (Interrupted, KeyboardInterrupt):
        print(f"{name}: stopped; start again to go on", file=sys.stderr)
        sys.exit(130)
    except (Problem, program.RunError, OSError) as problem:
        print(f"{name}: {problem}", file=sys.stderr)
        sys.exit(1)


def main():
    only = ("--left", dict(action="store_true", help="only what is left of the page's runs"))
    given = arguments(__doc__, grid=None, more=[only])
    total = cpu = 0.0
    for entry, grid in page_runs(given.grid):
        runs = given.runs
        total, cpu = total + runs.wall_left(entry, grid), cpu + runs.left(entry, grid)
        if not given.left:
            state = "done" if runs.done(entry, grid) else f"{runs.record(entry, grid)['reached']:.3g} s"
            print(f"{entry.name + '_' + grid:40} to {runs.end_time(entry, grid):4g} s  {state:8} "
                  f"{runs.cost(entry, grid)['cpu']:7.0f} CPU s taken, about {runs.left(entry, grid):6.0f} left")
    print(f"about {cpu:.0f} CPU s, {clock(total)} of runs left" if cpu else "no runs left")


if __name__ == "__main__":
    guarded(main)
