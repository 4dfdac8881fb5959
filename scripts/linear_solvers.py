#!/usr/bin/env python3
"""Iterations, seconds, messages and memory of the linear solvers against grid, time step and ranks.

    scripts/linear_solvers.py [--build build] [--work out/linear_solvers] [--csv FILE] [--limit SECONDS]

Makes the states by running scree on the cases, forms and solves the systems by linear_solvers, and writes a line each to
the CSV file and a table, Markdown, beside it. What the file holds already is not done again. `asm` is `ilu` with an
overlap of one node between ranks; `natural` is `ilu` with the nodes in the order of the rows, not by columns; `filled` is
`fieldsplit` with ILU(1), which a run takes where ILU(0) takes many iterations; in space `ilu1` is `ilu` with ILU(1), and
`condensed_gamg` has aggregation multigrid for the core. A second table compares factors of the core of `condensed`:
`mumps_amf`, `umfpack` (with AMD), `umfpack_metis` and `petsc_metis` against its own, MUMPS with PORD. A third has as many
cells a rank on each line."""
import argparse
import csv
import itertools
import subprocess
from pathlib import Path
from typing import NamedTuple

import scree
from scree import program

ROOT = Path(__file__).resolve().parents[1]
PRESETS = ("direct", "ilu", "multigrid", "fieldsplit", "condensed")
#: Changes of presets.
VARIANTS = {
    "asm": ("ilu", "-pc_type", "asm", "-pc_asm_overlap", "1"),
    "natural": ("ilu", "-sub_pc_factor_mat_ordering_type", "natural"),
    "filled": ("fieldsplit", "-fieldsplit_0_sub_pc_factor_levels", "1"),
    "ilu1": ("ilu", "-sub_pc_factor_levels", "1"),
    "condensed_gamg": ("condensed", "-condensed_core_pc_type", "gamg", "-condensed_core_pc_gamg_type", "agg",
                       "-condensed_core_pc_gamg_agg_nsmooths", "0", "-condensed_core_pc_gamg_coarse_eq_limit", "5000",
                       "-condensed_core_mg_levels_ksp_type", "gmres", "-condensed_core_mg_levels_ksp_max_it", "2",
                       "-condensed_core_mg_levels_pc_type", "bjacobi", "-condensed_core_mg_levels_sub_pc_type", "ilu"),
}
#: Factors of the core of `condensed`. CHOLMOD's are for symmetric matrices, which the core is not.
CORES = {
    "mumps_amf": ("condensed", "-condensed_core_mat_mumps_icntl_7", "2"),
    "umfpack": ("condensed", "-condensed_core_pc_factor_mat_solver_type", "umfpack", "-condensed_core_mat_umfpack_ordering", "AMD"),
    "umfpack_metis": ("condensed", "-condensed_core_pc_factor_mat_solver_type", "umfpack",
                      "-condensed_core_mat_umfpack_ordering", "METIS"),
    "petsc_metis": ("condensed", "-condensed_core_pc_factor_mat_solver_type", "petsc",
                    "-condensed_core_pc_factor_mat_ordering_type", "metis"),
}
STEPS = (1e-3, 1e-2)
RANKS = (2, 4, 8, 16)


class State(NamedTuple):
    """What a run has reached. A state on a finer grid starts from the one that it names, and runs on for a while."""

    case: str
    time: float  # of the run [s]
    options: dict = {}
    start: str = ""  # the state that it starts from


FINER = {"grid_refine": 2, "initial_before_order": 9}
STATES = {
    "bin_start": State("cases/bin_discharge/case.yaml", 0.02),
    "bin": State("cases/bin_discharge/case.yaml", 0.4),
    "bin_twice": State("cases/bin_discharge/case.yaml", 0.03, FINER, "bin"),
    "bin_four": State("cases/bin_discharge/case.yaml", 0.003, {"grid_refine": 4, "initial_before_order": 9}, "bin_twice"),
    "bin_paper_grid": State("cases/bin_discharge/paper.yaml", 0.03, {"initial_before_order": 9}, "bin"),
    "bin_rigid": State("cases/bin_discharge/best.yaml", 0.3),
    "fine_bin_air": State("cases/bin_discharge_fine/case.yaml", 0.3),
    "bubble": State("cases/bubble_rise/paper.yaml", 0.1),
    "bin_3d": State("cases/bin_3d/case.yaml", 0.3),
    "bin_3d_twice": State("cases/bin_3d/case.yaml", 0.03, FINER, "bin_3d"),
}
IN_SPACE = ("bin_3d", "bin_3d_twice")
RANK_STATES = ("bin_twice", "bin_paper_grid", "bin_3d_twice")
#: As many cells a rank: state and ranks.
WEAK = (("bin", 1), ("bin_twice", 4), ("bin_four", 16), ("bin_3d", 1), ("bin_3d_twice", 8))
WEAK_PRESETS = ("ilu", "multigrid", "condensed")
GAS_STATES = ("fine_bin_air", "bubble")
KEY = ("state", "dt", "ranks", "preset")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build")
    parser.add_argument("--work", type=Path, default=ROOT / "out" / "linear_solvers", help="for the states")
    parser.add_argument("--csv", type=Path, default=ROOT / "tests" / "benchmark" / "linear_solvers.csv")
    parser.add_argument("--limit", type=float, default=120, help="seconds after which a system is given up")
    return parser.parse_args()


def solvers(state, ranks):
    """Presets, and their variants where they differ: an overlap between ranks, fill with gas, the core in space, the order
    of nodes."""
    return [*PRESETS, *["asm"] * (ranks > 1), *["filled"] * (state in GAS_STATES),
            *["natural"] * (state not in GAS_STATES), *["ilu1", "condensed_gamg"] * (state in IN_SPACE)]


def systems():
    """Keys of all systems."""
    return list(dict.fromkeys(main_systems() + weak_systems()))


def main_systems():
    """State x step x solver on one rank, some states on several, factors of the core in the plane."""
    on_one = [state for state in STATES if state != "bin_four"]
    keys = [(state, dt, 1, solver) for state in on_one for dt in STEPS for solver in solvers(state, 1)]
    keys += [(state, 1e-2, 1, core) for state in on_one for core in CORES if state not in IN_SPACE]
    return keys + [(state, 1e-2, ranks, solver) for state in RANK_STATES for ranks in RANKS
                   for solver in solvers(state, ranks)]


def weak_systems():
    """Grids with as many cells a rank x step x preset."""
    return [(state, dt, ranks, preset) for state, ranks in WEAK for dt in STEPS for preset in WEAK_PRESETS]


def key_of(row):
    return row["state"], float(row["dt"]), int(row["ranks"]), row["preset"]


def rows_of(path):
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def make_state(given, name):
    """Output directory of the run up to a state; the run is made if it is not there."""
    state, directory = STATES[name], given.work / name
    if not (directory / "summary.json").exists():
        options = dict(state.options)
        if state.start:
            options["initial_before_run"] = make_state(given, state.start)
        scree.run(ROOT / state.case, 1, given.build / "bin" / "scree", end_time=state.time, output_dir=directory,
                  output_overwrite=True, **options)
    return directory


def solve(given, key):
    """The row of a system; its reason is `limit` or `failed` where no line came."""
    state, dt, ranks, preset = key
    row = dict(zip(KEY, key))
    solver, *more = {**VARIANTS, **CORES}.get(preset, (preset,))
    command = [*program.launcher(ranks), given.build / "bin" / "linear_solvers", make_state(given, state),
               "-dt", str(dt), "-solver", solver, "-scene", state, "-header", *more]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=given.limit,
                              env=program.environment())
    except subprocess.TimeoutExpired:
        return {**row, "reason": "limit"}
    lines = done.stdout.strip().splitlines()
    if done.returncode or len(lines) < 2:
        return {**row, "reason": "failed"}
    return {**next(csv.DictReader(lines[-2:])), **row}


def columns():
    names = ("grid,cells,iterations,reason,residual,setup_s,setup_again_s,solve_s,iterations_tight,reason_tight,"
             "residual_tight,solve_tight_s,messages,bytes,reductions,start_MB,peak_MB")
    return [*KEY, *names.split(",")]


def entry(row):
    """iterations (to 1e-5) / set-up + solution."""
    if not row.get("grid"):
        return row["reason"]
    loose, tight = (row["iterations"] if int(row[reason]) > 0 else "-"
                    for row, reason in ((row, "reason"), ({**row, "iterations": row["iterations_tight"]}, "reason_tight")))
    return f"{loose} ({tight}) / {float(row['setup_again_s']):.2g} + {float(row['solve_s']):.2g}"


def table(rows, columns=(*PRESETS, *VARIANTS)):
    """Markdown: a line a scene, grid, step and number of ranks; a column a preset or variant."""
    found = {key_of(row): row for row in rows if row["preset"] in columns}
    lines = ["Iterations to the preset's tolerance, in brackets to 1e-5. Then CPU seconds of a set-up on a known pattern, and of",
             "the solution.", "",
             "| state | grid | dt | ranks | " + " | ".join(columns) + " |", "|---" * (4 + len(columns)) + "|"]
    order = list(STATES)
    for start in sorted({key[:3] for key in found}, key=lambda start: (start[2], order.index(start[0]), start[1])):
        of_line = [found.get((*start, preset)) for preset in columns]
        grid = next((row["grid"] for row in of_line if row and row.get("grid")), "")
        entries = [entry(row) if row else "" for row in of_line]
        lines.append("| " + " | ".join([start[0], grid, f"{start[1]:g}", str(start[2]), *entries]) + " |")
    return "\n".join(lines) + "\n"


def weak_table(rows):
    """Markdown: a line a state and number of ranks. Messages and bytes are those of a rank and an iteration."""
    found = {key_of(row): row for row in rows}
    lines = ["As many cells a rank in the plane, and in space. Iterations to the preset's tolerance, in brackets to 1e-5. Then messages",
             "and kilobytes of a rank and an iteration, and the memory of a rank [MB].", "",
             "| state | dt | cells | ranks | " + " | ".join(WEAK_PRESETS) + " |", "|---" * (4 + len(WEAK_PRESETS)) + "|"]
    for dt, (state, ranks) in itertools.product(STEPS, WEAK):
        of_line = [found.get((state, dt, ranks, preset)) for preset in WEAK_PRESETS]
        cells = next((row["cells"] for row in of_line if row and row.get("cells")), "")
        lines.append("| " + " | ".join([state, f"{dt:g}", cells, str(ranks), *[weak_entry(row, ranks) for row in of_line]])
                     + " |")
    return "\n".join(lines) + "\n"


def weak_entry(row, ranks):
    """iterations (to 1e-5), messages and kB / memory."""
    if not row or not row.get("grid"):
        return row["reason"] if row else ""
    return (f"{entry(row).split(' /')[0]}, {float(row['messages']):.0f} and {float(row['bytes']) / 1e3:.0f}"
            f" / {float(row['peak_MB']) / ranks:.0f}")


def main():
    given = arguments()
    rows = rows_of(given.csv)
    done = {key_of(row) for row in rows}
    given.csv.parent.mkdir(parents=True, exist_ok=True)
    for key in systems():
        if key in done:
            continue
        rows.append(solve(given, key))
        print(*key, rows[-1].get("iterations", rows[-1]["reason"]), flush=True)
        with given.csv.open("w", newline="") as file:
            writer = csv.DictWriter(file, columns(), extrasaction="ignore", lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    in_first = set(main_systems())
    plane = [row for row in rows if key_of(row)[1:3] == (1e-2, 1) and row["state"] not in IN_SPACE]
    cores = table(plane, ("condensed", *CORES))
    given.csv.with_suffix(".md").write_text(f"{table([row for row in rows if key_of(row) in in_first])}\n"
                                            f"Factors of the core of `condensed`. {cores}\n{weak_table(rows)}")


if __name__ == "__main__":
    main()
