#!/usr/bin/env python3
"""Runs a case in many settings and says what each costs and how far it is off.

    scripts/speed_against_error.py cases/bin_discharge --dry-run
    scripts/speed_against_error.py cases/bin_discharge --budget 60          # again: goes on where it stopped

Into --out: runs/LABEL (output directories of the finished runs, reused while their setting is the same), runs.csv, choice.md
and plots/. Runs go one after the other, cheapest first. An interrupted run is thrown away, a failed one is remembered:
remove its directory to try it again. With --budget 0 nothing is run, and what is there is evaluated."""
import argparse
import itertools
import json
import math
import os
import shutil
import signal
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path

from scree import case_file, output, program, quantities, work_precision, work_precision_tables
from scree.program import clock
from scree.work_precision import Setting

ROOT = Path(__file__).resolve().parents[1]

# ---- what is run ----

ADVECTION = ("upwind", "van_albada")
SCHEMES = ("beuler", "bdf", "arkimex")
ACCURACIES = (3e-1, 1e-1, 3e-2)
TIGHT = 1e-2  # on the usual grid, for the error in time; the number of steps of order 1 grows as it falls
SCHEME_ACCURACIES = (1e-1, 3e-2)  # scheme_race.py has more of them
PRESETS = ("", "condensed", "ilu", "multigrid", "fieldsplit", "direct")  # "": the program's choice
PATIENCE = 600  # [s] beside twenty times the estimate, after which a run counts as failed: others may use the machine
STRAIN_RATE_FLOOR = 10  # [1/s], which algebraic T needs


@dataclass(frozen=True)
class Grid:
    """Cells of the blocks of half the domain along x and y, what -grid_refine multiplies them with, the ratios of last
    to first cell of the blocks, where they are not all of one size, and the lengths of the blocks along y [cm], where
    they are not those of the scene. Grids of one family refine one another."""

    x: tuple
    y: tuple
    refine: int = 1
    x_ratio: tuple = ()
    y_ratio: tuple = ()
    y_blocks: tuple = ()
    family: str = "uniform"

    def smallest_cell(self, blocks):
        """Root of the area of the smallest cell; blocks: lengths of the scene's blocks along x and y."""
        lengths = blocks[0], self.y_blocks or blocks[1]
        smallest = [min(itertools.starmap(first_or_last, zip(length, cells, ratios or (1,) * len(cells))))
                    for length, cells, ratios in zip(lengths, self.all_cells, (self.x_ratio, self.y_ratio))]
        return math.prod(smallest) ** 0.5

    def y_edges(self, blocks):
        """Edges of the blocks along y, as an option of the program."""
        return ", ".join(f"{edge:g} cm" for edge in itertools.accumulate(self.y_blocks or blocks[1], initial=0))

    @property
    def all_cells(self):
        return [[self.refine * count for count in cells] for cells in (self.x, self.y)]

    @property
    def cells(self):
        return sum(self.x) * sum(self.y) * self.refine**2


def first_or_last(length, count, ratio):
    """The smaller of the first and the last of `count` cells in geometric progression, last over first being `ratio`."""
    if ratio == 1 or count == 1:
        return length / count
    growth = ratio ** (1 / (count - 1))
    first = length * (growth - 1) / (growth**count - 1)
    return min(first, ratio * first)


@dataclass(frozen=True)
class Scene:
    """A case and its runs. Grids are named by their cells along x, from coarse to fine."""

    grids: dict
    usual_grid: str
    product_grids: tuple  # of the product grid x accuracy x advection ...
    costly_grids: tuple  # ... and those where only `costly_accuracies` are run
    costly_accuracies: tuple
    solver_grids: tuple
    preset: str  # the program's choice there
    models: tuple  # one dict of settings a variant
    gas: str  # of the case
    blocks: tuple  # of cells in half the domain: lengths along x and y [cm]
    full_width: dict  # options, beside the cells along x
    read: object
    window: tuple  # [s] of the means; runs end with it
    field_interval: float  # [s]
    cpu_seconds: float  # of the usual setting, for the estimates ...
    cost_exponent: float  # ... which go with cells to this
    time_scheme: str = "beuler"  # that of the case

    @property
    def usual(self):
        return Setting(self.usual_grid, gas=self.gas, time_scheme=self.time_scheme)


SIMPLER_MODELS = ({"friction_model": "critical_state"}, {"granular_temperature": "algebraic"},
                  {"friction_model": "critical_state", "granular_temperature": "algebraic"}, {"width": "full"})

BIN_GRIDS = {"4 mm": Grid((2, 8), (7, 125)), "2 mm": Grid((4, 16), (13, 250)), "1 mm": Grid((4, 16), (13, 250), 2)}


def graded(refine):
    """Fine at the lip of the orifice, where the errors of the rate come from; named by the width of its cells."""
    return Grid((3, 5), (7, 80), refine, (1 / 6, 25), (0.08, 30), family="graded")


def steep(refine):
    """Finer still at the lip, by steeper grading, with coarser cells in the bed; the case's own at 2."""
    return Grid((5, 7), (8, 20, 25), refine, (0.04, 100), (0.03, 25, 4), (5, 8, 92), "steep")


def over_bed(x, y, refine=1):
    """Cells that grow upwards over the bed, the case's own at 3 mm."""
    return Grid(x, y, refine, y_ratio=(1, 10), family="graded")


GRADED_GRIDS = {"0.8 mm graded": graded(1), "0.4 mm graded": graded(2), "0.2 mm graded": graded(4),
                "0.2 mm steep": steep(1), "0.1 mm steep": steep(2), "0.05 mm steep": steep(4)}
FINER_GRIDS = {"0.07 mm steep": steep(3), "0.025 mm steep": steep(8), "0.1 mm graded": graded(8)}
BIN = dict(
    usual_grid="2 mm", blocks=((0.7, 3.3), (5, 100)), read=quantities.bin_quantities,
    full_width={
        "grid_x_edges": "-4 cm, -0.7 cm, 0.7 cm, 4 cm", "boundary_centreline_kind": "wall_johnson_jackson",
        "boundary_centreline_patch": "5 cm, 105 cm", "boundary_left_side": "x_lower", "boundary_left_kind": "open",
        "boundary_left_patch": "0, 5 cm", "plate_floor_openings": "-0.7 cm, 0.7 cm",
        "flux_orifice_patch": "-0.7 cm, 0.7 cm", "initial_fill_box": "-4 cm, 4 cm, 5 cm, 105 cm", "output_mirror": "1",
    },
)
SCENES = {
    "bin_discharge": Scene(
        **BIN, grids={**BIN_GRIDS, **GRADED_GRIDS, **FINER_GRIDS},
        product_grids=("4 mm", "2 mm", "0.8 mm graded", "0.4 mm graded"),
        costly_grids=("1 mm", "0.2 mm graded", "0.1 mm graded"), costly_accuracies=(0.1,),
        solver_grids=("2 mm",), preset="ilu", models=(*SIMPLER_MODELS, {"gas": "darcy"}, {"gas": "incompressible"}), gas="none",
        window=(0.3, 0.5), field_interval=0.02, cpu_seconds=18, cost_exponent=1.15,
    ),
    "bin_discharge_fine": Scene(
        **BIN, grids={**BIN_GRIDS, **GRADED_GRIDS},
        product_grids=("4 mm", "2 mm", "0.8 mm graded", "0.4 mm graded"),
        costly_grids=("1 mm", "0.2 mm graded"), costly_accuracies=(0.1,),
        solver_grids=("2 mm",), preset="fieldsplit", models=(*SIMPLER_MODELS, {"gas": "none"}, {"gas": "darcy"}), gas="incompressible",
        window=(0.6, 0.8), field_interval=0.02, cpu_seconds=100, cost_exponent=1.5,
    ),
    "bubble_rise": Scene(
        grids={"6 mm": Grid((2, 10), (67, 50)), "3 mm": Grid((3, 20), (133, 100)),
               "1.5 mm": Grid((3, 20), (133, 100), 2), "6 mm graded": over_bed((2, 10), (67, 15)),
               "3 mm graded": over_bed((3, 20), (133, 30)), "1.5 mm graded": over_bed((3, 20), (133, 30), 2)},
        usual_grid="3 mm", product_grids=("6 mm", "3 mm"), costly_grids=("1.5 mm",), costly_accuracies=(0.1,),
        solver_grids=("3 mm",), preset="fieldsplit", models=(*SIMPLER_MODELS, {"gas": "darcy"}),
        gas="incompressible", blocks=((1, 6), (40, 30)), read=quantities.bubble_quantities,
        full_width={"grid_x_edges": "-7 cm, -1 cm, 1 cm, 7 cm", "boundary_centreline_kind": "wall_free_slip",
                    "boundary_slit_patch": "-1 cm, 1 cm", "initial_bed_box": "-7 cm, 7 cm, 0, 40 cm", "output_mirror": "1"},
        window=(0.4, 0.5), field_interval=0.0, cpu_seconds=80, cost_exponent=1.4,
        time_scheme="arkimex",
    ),
}


def axes(scene, ranks):
    """The matrix: axis -> rows of settings to combine; what a row does not name is as usual."""
    presets = [preset for preset in PRESETS if preset != scene.preset]
    solvers = [dict(grid=[grid], solver=presets, ranks=ranks) for grid in scene.solver_grids]
    return {
        "grid": [dict(grid=scene.grids, advection=ADVECTION)],
        "advection": [dict(advection=ADVECTION)],
        "accuracy": [dict(accuracy=(*ACCURACIES, TIGHT))],
        "product": [dict(grid=scene.product_grids, accuracy=ACCURACIES, advection=ADVECTION),
                    dict(grid=scene.costly_grids, accuracy=scene.costly_accuracies, advection=ADVECTION)],
        "time_scheme": [dict(time_scheme=SCHEMES, accuracy=SCHEME_ACCURACIES)],
        "model": [{name: [value] for name, value in {"grid": scene.usual_grid, **model}.items()}
                  for model in ({}, *scene.models)],
        "solver": solvers,
    }


AXES = ("grid", "advection", "accuracy", "product", "time_scheme", "model", "solver")

#: What settings cost against the usual one: for the estimates, before measured runs correct them.
COST_FACTORS = {
    "advection": {"van_albada": 1.3}, "time_scheme": {"arkimex": 1.5}, "friction_model": {"critical_state": 0.85},
    "granular_temperature": {"algebraic": 0.75}, "gas": {"darcy": 2.0, "incompressible": 2.7}, "width": {"full": 2.2},
    "solver": {"": 1, "fieldsplit": 2, "direct": 2.5, "multigrid": 1.3, "ilu": 1.2},
}


def matrix(scene, only, ranks, grids):
    """All settings of the chosen axes, each once."""
    found = {}
    table = axes(scene, ranks)
    for axis in only:
        for row in table[axis]:
            for values in itertools.product(*row.values()):
                setting = scene.usual.but(**dict(zip(row, values)))
                if setting.grid in grids:
                    found.setdefault(setting)
    return list(found)


def estimate(scene, setting):
    """CPU seconds [s], roughly."""
    seconds = scene.cpu_seconds
    seconds *= (scene.grids[setting.grid].cells / scene.grids[scene.usual_grid].cells) ** scene.cost_exponent
    tightness = scene.usual.accuracy / setting.accuracy
    steps = 0.9 if setting.time_scheme == "beuler" else 0.45
    seconds *= tightness ** (steps if tightness > 1 else 0.3)  # loose steps take more iterations
    for name, factors in COST_FACTORS.items():
        seconds *= factors.get(getattr(setting, name), 1) / factors.get(getattr(scene.usual, name), 1)
    return seconds * (1 + 0.1 * (setting.ranks - 1))


def options(scene, setting, end_time):
    """The program's options of a run."""
    grid = scene.grids[setting.grid]
    full = setting.width == "full"
    x = (*grid.x[:0:-1], 2 * grid.x[0], *grid.x[1:]) if full else grid.x
    result = {
        "grid_x_cells": ", ".join(map(str, x)), "grid_y_cells": ", ".join(map(str, grid.y)), "grid_refine": grid.refine,
        "grid_y_edges": grid.y_edges(scene.blocks),
        "advection": setting.advection, "time_scheme": setting.time_scheme, "accuracy": setting.accuracy,
        "friction_model": setting.friction_model,
        "granular_temperature": setting.granular_temperature, "gas": setting.gas,
        "end_time": end_time, "output_interval": scene.field_interval, "checkpoint_interval": 0,
    }
    ratios = grid.x_ratio or (1,) * len(x), grid.y_ratio or (1,) * len(grid.y)
    result["grid_x_ratio"], result["grid_y_ratio"] = (", ".join(f"{one:.4g}" for one in ratio) for ratio in ratios)
    if setting.granular_temperature == "algebraic":
        result["friction_strain_rate_floor"] = STRAIN_RATE_FLOOR
    if setting.solver:
        result["solver"] = setting.solver
    return {**result, **(scene.full_width if full else {})}


# ---- running ----


class Runs:
    """The runs of a case below a directory: starts them, keeps what is whole, reads what is there."""

    def __init__(self, scene, case_path, executable, directory, window):
        self.scene, self.case_path, self.program, self.window = scene, case_path, executable, window
        self.directory = directory
        self.case = case_file.read(case_path)

    def key(self, setting):
        """What makes a run the same: its options, ranks, and the text of the case."""
        given = {name: str(value) for name, value in options(self.scene, setting, self.window[1]).items()}
        return {"case": self.case, "options": given, "ranks": setting.ranks}

    def state(self, setting):
        """done, failed, or missing."""
        kept = self.directory / setting.label(self.scene.usual) / "setting.json"
        if not kept.exists():
            return "missing"
        stored = json.loads(kept.read_text())
        if stored["key"] != self.key(setting):
            return "missing"
        return "done" if stored["end"] == "end_time" else "failed"

    def run(self, setting, seconds, patience):
        """Runs a setting for at most `seconds`. Only a run that ended by itself, or took longer than `patience`, leaves
        its directory. Returns how it ended; "stopped" for want of time."""
        final = self.directory / setting.label(self.scene.usual)
        unfinished = final.with_name(final.name + ".unfinished")
        shutil.rmtree(unfinished, ignore_errors=True)
        unfinished.mkdir(parents=True)
        try:
            end = self.ended(setting, unfinished, min(seconds, patience))
        except BaseException:
            shutil.rmtree(unfinished, ignore_errors=True)
            raise
        if end == "budget" and seconds < patience:
            shutil.rmtree(unfinished, ignore_errors=True)
            return "stopped"
        (unfinished / "setting.json").write_text(json.dumps({"key": self.key(setting), "end": end}, indent=1))
        shutil.rmtree(final, ignore_errors=True)
        unfinished.rename(final)
        return end

    def ended(self, setting, directory, seconds):
        """Runs the program to its end; "end_time", or in a few words why not."""
        given = {**options(self.scene, setting, self.window[1]), "output_dir": directory / "out",
                 "wall_clock_budget": f"{seconds:.0f}"}
        log = directory / "log"
        process = program.start(program.command(self.program, self.case_path, given, setting.ranks), log)
        try:
            process.wait()
        except BaseException:
            program.end_group(process)
            raise
        if process.returncode:
            return program.failure(log, process.returncode)
        end = output.summary(directory / "out")["end"]
        # The checkpoint is of no use here, and as large as all fields together.
        shutil.rmtree(directory / "out" / "checkpoints", ignore_errors=True)
        return end if end == "end_time" else "budget"

    def rows(self, settings):
        """What the finished runs cost and gave."""
        found = []
        for setting in settings:
            if self.state(setting) == "done":
                directory = self.directory / setting.label(self.scene.usual) / "out"
                grid = self.scene.grids[setting.grid]
                found.append(work_precision.Row(
                    setting, grid.smallest_cell(self.scene.blocks),
                    quantities.cost(directory, self.window),
                    quantities.quantities(self.scene.read, directory, self.window), grid.family))
        return found


class Estimates:
    """Wall seconds of runs, corrected by those measured so far."""

    def __init__(self, scene, stretch):
        self.scene, self.stretch = scene, stretch
        self.guessed = self.measured = 0.0

    def learn(self, setting, wall):
        self.guessed += self.raw(setting)
        self.measured += wall

    def raw(self, setting):
        ranks_at_once = min(setting.ranks, program.cores())
        return self.stretch * estimate(self.scene, setting) / ranks_at_once

    def __call__(self, setting):
        return self.raw(setting) * (self.measured / self.guessed if self.guessed else 1)


def run_all(runs, settings, estimates, budget):
    """Runs what is missing, cheapest first, as far as the budget [s] goes."""
    missing = [setting for setting in settings if runs.state(setting) == "missing"]
    print(f"{len(settings)} runs, {len(settings) - len(missing)} of them there already")
    started = time.monotonic()
    for number, setting in enumerate(missing, 1):
        left = budget - (time.monotonic() - started)
        expected = estimates(setting)
        rest = sum(map(estimates, missing[number - 1:]))
        label = setting.label(runs.scene.usual)
        if expected > left:
            print(f"the budget ends before {label} and what comes after it: {clock(rest)} more")
            return
        print(f"[{number}/{len(missing)}] {label}: about {clock(expected)}, with the rest {clock(rest)}", end="", flush=True)
        begun = time.monotonic()
        end = runs.run(setting, left, PATIENCE + 20 * expected)
        took = time.monotonic() - begun
        if end == "end_time":
            estimates.learn(setting, took)
        print(f"; took {took:.1f} s" + ("" if end == "end_time" else f", {end}"), flush=True)


# ---- from the command line ----


def evaluate(runs, settings, name, out):
    """Writes the table, the choice and the pictures of what is there."""
    rows = runs.rows(settings)
    failed = [setting.label(runs.scene.usual) for setting in settings if runs.state(setting) == "failed"]
    if failed:
        print("failed: " + ", ".join(failed))
    if not rows:
        print("no finished runs to evaluate")
        return
    from scree import work_precision_plots as plots  # takes a second to load, which a dry run need not wait for

    references = work_precision.add_errors(rows, runs.scene.usual)
    work_precision_tables.write_csv(out / "runs.csv", name, rows, quantities.UNITS, runs.scene.usual)
    text = work_precision_tables.choice_text(name, rows, references, runs.scene.usual)
    (out / "choice.md").write_text(text)
    plots.draw_all(rows, references, runs.scene.usual, name, out)
    print(f"\n{text}\n{len(rows)} runs in {out / 'runs.csv'}, pictures in {out / 'plots'}")


def list_runs(runs, settings, estimates):
    for setting in settings:
        seconds = estimates.stretch * estimate(runs.scene, setting)
        print(f"{seconds:9.0f} CPU s  {runs.state(setting):8} {setting.label(runs.scene.usual)}")
    total = estimates.stretch * sum(estimate(runs.scene, setting) for setting in settings)
    left = sum(estimates(setting) for setting in settings if runs.state(setting) == "missing")
    print(f"{len(settings)} runs, {total:.0f} CPU s estimated; {clock(left)} of what is missing")


def pair(text):
    begin, end = map(float, text.split(","))
    return begin, end


def words(allowed):
    def parse(text):
        found = [word.strip() for word in text.split(",")]
        unknown = [word for word in found if word not in allowed]
        if unknown:
            raise argparse.ArgumentTypeError(f"{', '.join(unknown)}: choose from {', '.join(allowed)}")
        return found

    return parse


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", type=Path, metavar="CASE", help=", ".join(f"cases/{name}" for name in SCENES))
    parser.add_argument("--program", type=Path, default=program.default_program(), help="default: that of scripts/build.sh")
    parser.add_argument("--ranks", type=lambda text: [int(word) for word in text.split(",")], default=[1, 2],
                        help="of the axis solver; all others run on 1. Default 1,2")
    parser.add_argument("--only", type=words(AXES), default=list(AXES), help=f"axes, of {', '.join(AXES)}")
    parser.add_argument("--grids", default="", help="grids, such as '4 mm,2 mm'; default: all of the case")
    parser.add_argument("--window", type=pair, help="BEGIN,END [s] of the means; the runs end with it")
    parser.add_argument("--out", type=Path, help="default: out/speed_against_error/<case>")
    parser.add_argument("--budget", type=float, default=float("inf"), help="wall-clock minutes; default: no limit")
    parser.add_argument("--dry-run", action="store_true", help="list the runs and what they are thought to cost")
    given = parser.parse_args()
    name = given.case.resolve().name
    if name not in SCENES or not (given.case / "case.yaml").exists():
        parser.error(f"{given.case}: the case is one of {', '.join(f'cases/{scene}' for scene in SCENES)}")
    scene = SCENES[name]
    try:
        given.grids = words(scene.grids)(given.grids) if given.grids else list(scene.grids)
    except argparse.ArgumentTypeError as error:
        parser.error(f"--grids {error}")
    if not given.dry_run and given.budget > 0 and not os.access(given.program, os.X_OK):
        parser.error(f"no {given.program}: scripts/build.sh builds it, --program names another")
    given.out = (given.out or ROOT / "out" / "speed_against_error" / name).absolute()
    given.window = given.window or scene.window
    return given, name, scene


def main():
    sys.stdout.reconfigure(line_buffering=True)  # progress is for logs too
    given, name, scene = arguments()
    if scene.usual_grid not in given.grids:  # the other axes go around the finest grid that is left
        grid = given.grids[-1]
        seconds = estimate(scene, scene.usual.but(grid=grid))
        scene = replace(scene, usual_grid=grid, solver_grids=(grid,), cpu_seconds=seconds)
    estimates = Estimates(scene, given.window[1] / scene.window[1])
    settings = sorted(matrix(scene, given.only, given.ranks, given.grids), key=estimates.raw)
    runs = Runs(scene, given.case / "case.yaml", given.program, given.out / "runs", given.window)
    if given.dry_run:
        list_runs(runs, settings, estimates)
        return
    given.out.mkdir(parents=True, exist_ok=True)
    signal.signal(signal.SIGTERM, program.interrupt)
    stopped = False
    try:
        run_all(runs, settings, estimates, 60 * given.budget)
    except (program.Interrupted, KeyboardInterrupt):
        stopped = True
        print("\ninterrupted: the run under way is thrown away; start again to go on")
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    evaluate(runs, settings, name, given.out)
    sys.exit(130 if stopped else 0)


if __name__ == "__main__":
    main()
