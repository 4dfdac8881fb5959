#!/usr/bin/env python3
"""Iterations, seconds, messages and memory of the linear solvers against grid, time step and ranks.

    scripts/linear_solvers.py [--build build] [--work out/linear_solvers] [--csv FILE] [--limit SECONDS]

Makes the states by running scree on the cases, forms and solves the systems by linear_solvers, and writes a line each to
the CSV file and a table, Markdown, beside it. What the file holds already is not done again. `asm` is `ilu` with an
overlap of one node between ranks; `filled` is `fieldsplit` with ILU(1), which a run takes where ILU(0) takes many
iterations."""
import argparse
import csv
import subprocess
from pathlib import Path

import scree
from scree import program

ROOT = Path(__file__).resolve().parents[1]
PRESETS = ("direct", "ilu", "multigrid", "fieldsplit")
#: Changes of presets.
VARIANTS = {
    "asm": ("ilu", "-pc_type", "asm", "-pc_asm_overlap", "1"),
    "filled": ("fieldsplit", "-fieldsplit_0_sub_pc_factor_levels", "1"),
}
STEPS = (1e-3, 1e-2)
RANKS = (2, 4, 8, 16)
# Scene: case file, time of the state [s], refinements.
SCENES = {
    "bin_plateau": ("cases/bin_discharge/coarse.yaml", 0.45, (1, 2, 4, 8)),
    "bin_start": ("cases/bin_discharge/coarse.yaml", 0.02, (1, 2)),
    "fine_bin_air": ("cases/bin_discharge_fine/case.yaml", 0.6, (1, 2)),
    "bubble": ("cases/bubble_rise/paper.yaml", 0.3, (1, 2)),
    "bin_3d": ("tests/benchmark/bin_3d.yaml", 0.15, (1, 2)),
}
RANK_SCENES = ("bin_plateau", "fine_bin_air")
GAS_SCENES = ("fine_bin_air", "bubble")
KEY = ("scene", "refine", "dt", "ranks", "preset")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build")
    parser.add_argument("--work", type=Path, default=ROOT / "out" / "linear_solvers", help="for the states")
    parser.add_argument("--csv", type=Path, default=ROOT / "tests" / "benchmark" / "linear_solvers.csv")
    parser.add_argument("--limit", type=float, default=120, help="seconds after which a system is given up")
    return parser.parse_args()


def solvers(scene, ranks):
    """Presets, and their variants where they differ: an overlap between ranks, fill with gas."""
    return [*PRESETS, *["asm"] * (ranks > 1), *["filled"] * (scene in GAS_SCENES)]


def systems():
    """Keys of all systems, small ones first: grid x step x solver on one rank, ranks at refinement 2."""
    keys = [(scene, refine, dt, 1, solver)
            for scene, (_, _, refinements) in SCENES.items() for refine in refinements
            for dt in STEPS for solver in solvers(scene, 1)]
    keys += [(scene, 2, 1e-2, ranks, solver) for scene in RANK_SCENES for ranks in RANKS for solver in solvers(scene, ranks)]
    return sorted(keys, key=lambda key: (key[1], key[3]))


def key_of(row):
    return row["scene"], int(row["refine"]), float(row["dt"]), int(row["ranks"]), row["preset"]


def rows_of(path):
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def make_state(given, scene):
    """Output directory of the run up to the state of a scene; the run is made if it is not there."""
    case, time, _ = SCENES[scene]
    directory = given.work / scene
    if not (directory / "summary.json").exists():
        scree.run(ROOT / case, 1, given.build / "bin" / "scree", end_time=time, output_dir=directory,
                  output_overwrite=True)
    return directory


def solve(given, key):
    """The row of a system; its reason is `limit` or `failed` where no line came."""
    scene, refine, dt, ranks, preset = key
    row = dict(zip(KEY, (scene, refine, dt, ranks, preset)))
    solver, *more = VARIANTS.get(preset, (preset,))
    command = [*program.launcher(ranks), given.build / "bin" / "linear_solvers", make_state(given, scene), "-refine", str(refine),
               "-dt", str(dt), "-solver", solver, "-scene", scene, "-header", *more]
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


def table(rows):
    """Markdown: a line a scene, grid, step and number of ranks; a column a preset."""
    found = {key_of(row): row for row in rows}
    columns = (*PRESETS, *VARIANTS)
    lines = ["iterations to the preset's tolerance (to 1e-5) / CPU seconds of set-up on a known pattern + solution", "",
             "| scene | grid | dt | ranks | " + " | ".join(columns) + " |", "|---" * (4 + len(columns)) + "|"]
    for start in sorted({key[:4] for key in found}):
        of_line = [found.get((*start, preset)) for preset in columns]
        grid = next((row["grid"] for row in of_line if row and row.get("grid")), f"x{start[1]}")
        entries = [entry(row) if row else "" for row in of_line]
        lines.append("| " + " | ".join([start[0], grid, f"{start[2]:g}", str(start[3]), *entries]) + " |")
    return "\n".join(lines) + "\n"


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
    given.csv.with_suffix(".md").write_text(table(rows))


if __name__ == "__main__":
    main()
