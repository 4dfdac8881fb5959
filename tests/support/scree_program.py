"""The program under test: runs scree on a case file, reads what it leaves, and checks with a line for each number.

A test script makes a Program from its command line (which CTest gives), runs cases, feeds a Checks, and exits with its
verdict. Paths of case files are relative to the script."""
import argparse
import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from scree import output  # noqa: E402


class Run:
    """A finished run and its output directory."""

    def __init__(self, directory, process):
        self.directory = Path(directory)
        self.code = process.returncode
        self.log = process.stdout
        self.errors = process.stderr

    @property
    def monitor(self):
        return output.monitor(self.directory)

    @property
    def summary(self):
        return json.loads((self.directory / "summary.json").read_text())

    @property
    def fields(self):
        """The last fields, SI units."""
        return output.last_fields(self.directory)

    @property
    def first_fields(self):
        return output.fields(output.field_files(self.directory)[0])

    def all_fields(self):
        return [output.fields(path) for path in output.field_files(self.directory)]


class Program:
    def __init__(self):
        parser = argparse.ArgumentParser()
        parser.add_argument("--scree", required=True, help="the executable")
        parser.add_argument("--ranks", type=int, default=1)
        parser.add_argument("--work", required=True, help="directory for the output of the runs")
        parser.add_argument("--update", action="store_true", help="write the stored numbers anew")
        parser.add_argument("launcher", nargs="*", help="mpirun and its options, without -n")
        given = parser.parse_args()
        self.scree, self.launcher, self.ranks, self.update = given.scree, given.launcher, given.ranks, given.update
        self.work = Path(given.work)
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        Checks.directory = self.work
        self.here = Path(sys.argv[0]).resolve().parent

    def command(self, case, options=None, ranks=None):
        """The command line. Option values are texts or numbers; a list gives the option several times."""
        ranks = ranks or self.ranks
        words = [*self.launcher, "-n", str(ranks)] if ranks > 1 else []
        words.append(self.scree)
        if case:
            words.append(str(self.here / case))
        for key, value in (options or {}).items():
            for item in value if isinstance(value, list) else [value]:
                words += ["-" + key] + ([] if item is None else [str(item)])
        return words

    def run(self, case, name, options=None, ranks=None, must_work=True, timeout=1200):
        """Runs a case into the directory `name`; anything but success is the end of the test unless must_work is off."""
        directory = self.work / name
        options = {"output_dir": directory, **(options or {})}
        words = self.command(case, options, ranks)
        process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=timeout)
        if must_work and process.returncode != 0:
            sys.exit(f"FAILED to run: {' '.join(words)}\nexit code {process.returncode}\n{process.stdout}{process.stderr}")
        return Run(directory, process)


class Checks:
    """Counts what failed; each check prints its case, what was measured, what was expected, and the tolerance.

    `ids` are those of the exact solutions (T1 ...) and hard cases (H1 ...) that the script tests. The verdict leaves
    checks.json in the work directory of the Program, from which scripts/test_report.py makes tests/results/."""

    directory = None  # where checks.json goes; set by Program

    def __init__(self, title, *ids):
        self.failed = 0
        self.record = {"title": title, "ids": list(ids), "checks": [], "hard_cases": []}
        print(title)

    def _say(self, good, case, measured, expected):
        self.failed += not good
        self.record["checks"].append({"good": bool(good), "case": case, "measured": measured, "expected": expected})
        print(f"  {'ok  ' if good else 'FAIL'}  {case}: measured {measured}, expected {expected}")
        sys.stdout.flush()

    def hard_case(self, identity, title, run, **more):
        """A line of the table of hard cases: what `run` took and kept, see hard_case_figures. `more`: measured (text),
        bound (text), without (what the figure would be without the remedy, text), mirror_error (number)."""
        line = {"id": identity, "title": title, **(hard_case_figures(run) if run else {}), **more}
        self.record["hard_cases"].append(line)
        print(f"  {identity} {title}: " + ", ".join(f"{key} {value}" for key, value in line.items() if key not in ("id", "title")))

    def close(self, case, measured, expected, relative=0.0, absolute=0.0):
        tolerance = absolute + relative * abs(expected)
        good = abs(measured - expected) <= tolerance
        self._say(good, case, f"{measured:.9g}", f"{expected:.9g} +- {tolerance:.2g} (off by {measured - expected:.2e})")

    def below(self, case, measured, bound):
        self._say(measured <= bound, case, f"{measured:.3e}", f"<= {bound:.3g}")

    def above(self, case, measured, bound):
        self._say(measured >= bound, case, f"{measured:.9g}", f">= {bound:.9g}")

    def equal(self, case, measured, expected):
        self._say(measured == expected, case, repr(measured), repr(expected))

    def true(self, case, condition, otherwise="not so"):
        self._say(bool(condition), case, "so" if condition else otherwise, "so")

    def order(self, case, errors, expected, bound, slack=0.15):
        """Order of convergence from errors whose steps are halved each time, and a bound on the last error."""
        orders = [np.log2(a / b) for a, b in zip(errors, errors[1:])]
        good = abs(orders[-1] - expected) <= slack and errors[-1] <= bound
        self._say(good, case, "errors " + ", ".join(f"{e:.3e}" for e in errors) + "; orders "
                  + ", ".join(f"{p:.3f}" for p in orders),
                  f"last order {expected} +- {slack}, last error <= {bound:.2g}")

    def verdict(self):
        if self.directory:
            (self.directory / "checks.json").write_text(json.dumps(self.record, indent=1))
        print("all checks hold" if not self.failed else f"{self.failed} checks FAILED")
        sys.exit(1 if self.failed else 0)


def hard_case_figures(run):
    """What a run took and kept: steps, largest step [s], Newton iterations a step, rejected steps, extremes of nu and T
    over the run, error of mass. As far as the run has them."""
    summary, monitor = run.summary, run.monitor
    figures = {
        "steps": int(summary["steps"]),
        "dt_max": float(summary["dt_max"]),
        "newton": summary["newton_iterations"] / max(summary["steps"], 1),
        "rejected": int(summary["rejected_error"] + summary["rejected_solver"]),
        "nu_min": float(np.min(monitor["solids_fraction_min"])),
        "nu_max": float(np.max(monitor["solids_fraction_max"])),
        "mass_error": float(abs(summary["quantities"]["mass_error"])),
    }
    if "granular_temperature_min" in monitor:
        figures["T_min"] = float(np.min(monitor["granular_temperature_min"]))
        figures["T_max"] = float(np.max(monitor["granular_temperature_max"]))
    return figures


def mirror_error(values):
    """Greatest difference between an array over cells [..., x] and its mirror image in x."""
    return float(np.abs(values - values[..., ::-1]).max())


def norm(values):
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def centres(faces):
    return 0.5 * (faces[1:] + faces[:-1])


#: A new factorisation for each Newton iteration: the ageing of preconditioners does not reach it.
DIRECT = {"solver": "direct", "ksp_type": "preonly"}
#: In a column of cells, on one rank, PETSc's own factorisation costs a fraction of that of MUMPS.
COLUMN = {"pc_factor_mat_solver_type": "petsc"}
#: Newton far below the discretisation errors that tests look at. Rounding is about 1e-12 in the scaled residuals.
EXACT = {**DIRECT, "snes_rtol": 1e-10, "snes_atol": 1e-10, "snes_stol": 1e-13}
