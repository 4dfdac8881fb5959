"""scree.sweep and its command, on a bin of a few hundred cells. SCREE_BUILD_DIR names the build."""
import csv
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import scree
from scree import sweeps

CASE = Path(__file__).resolve().parents[1] / "regression" / "small_bin.yaml"
COMMAND = [sys.executable, str(Path(__file__).resolve().parents[2] / "scripts" / "scree-sweep")]
TAUS = ["1e-3 s", "1e-2 s"]


class Place(unittest.TestCase):
    def rows(self):
        with self.csv.open(newline="") as file:
            return list(csv.DictReader(file))

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.work, self.csv = self.place / "work", self.place / "sweep.csv"


class Sweep(Place):
    def sweep(self, values, **more):
        self.said = []
        return scree.sweep(CASE, values, work=self.work, csv=self.csv, say=self.said.append, **more)

    def test_all_combinations_are_rows_with_the_quantities_of_their_runs(self):
        table = self.sweep({"friction_tau": TAUS, "advection": ["upwind", "van_albada"]}, end_time=5e-4)
        self.assertEqual(list(zip(table.friction_tau, table.advection)),
                         [(tau, scheme) for tau in TAUS for scheme in ("upwind", "van_albada")])
        self.assertEqual(set(table.status), {"done"})
        for _, row in table.iterrows():
            run = scree.open(row.directory)
            self.assertEqual(float(run.case["friction_tau"]), float(row.friction_tau.split()[0]))
            self.assertEqual(run.case["advection"], row.advection)
            self.assertEqual((row.mass, row["time [s]"]), (run.summary["quantities"]["mass"], 5e-4))
        self.assertEqual([row["friction_tau"] for row in self.rows()], list(table.friction_tau))

    def test_what_failed_is_a_row_with_the_reason(self):
        table = self.sweep({"friction_tau": ["1e-3 s", "-1 s"]}, end_time=5e-4)
        self.assertEqual(list(table.status), ["done", "failed"])
        self.assertRegex(table.reason[1], "^friction_tau = '-1 s': expected")
        self.assertNotEqual(table.mass[1], table.mass[1])  # NaN

    def test_what_is_there_is_not_run_again(self):
        self.sweep({"friction_tau": [*TAUS[:1], "-1 s"]}, end_time=5e-4)
        self.assertEqual(len(self.said), 2)
        table = self.sweep({"friction_tau": [*TAUS, "-1 s"]}, end_time=5e-4)
        self.assertEqual(self.said, ["[1/1] friction_tau=1e-2-s: done"])
        self.assertEqual(list(table.status), ["done", "done", "failed"])
        self.sweep({"friction_tau": TAUS}, end_time=6e-4)  # other options: other runs
        self.assertEqual(len(self.said), 2)
        self.sweep({"friction_tau": [TAUS[0], "-1 s"]}, end_time=6e-4, retry=True)
        self.assertEqual(len(self.said), 1)


class Command(Place):
    def run_command(self, *words):
        return subprocess.run([*COMMAND, *map(str, words)], capture_output=True, text=True)

    def test_lists_are_swept_and_single_values_hold_for_all(self):
        process = self.run_command(CASE, "-friction_tau", "1e-3,1e-2", "-end_time", "5e-4", "-o", self.csv, "--work",
                                   self.work, "--jobs", "1")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertEqual([(row["friction_tau"], float(row["time [s]"])) for row in self.rows()],
                         [("1e-3", 5e-4), ("1e-2", 5e-4)])
        self.assertEqual(process.stdout.splitlines()[-1], f"2 runs in {self.csv}")

    def test_semicolons_separate_values_with_commas(self):
        self.assertEqual(sweeps.options_of(["-grid_x_cells", "4, 16; 8, 32", "-accuracy", "1e-2,1e-3"]),
                         {"grid_x_cells": ["4, 16", "8, 32"], "accuracy": ["1e-2", "1e-3"]})

    def test_what_is_wrong_is_told_in_its_last_line(self):
        for words, expected in (((CASE, "-end_time", "1"), "no option has several values"),
                                ((CASE, "-accuracy", "1,2", "-output_dir", "x"), "-output_dir: the runs go below"),
                                ((CASE, "-accuracy"), "-accuracy: expected a value"),
                                ((self.place / "none.yaml", "-accuracy", "1,2"), "no such case"),
                                ((CASE, "-accuracy", "1,2", "--program", "/no/such"), "no program /no/such")):
            process = self.run_command(*words)
            self.assertNotEqual(process.returncode, 0)
            self.assertIn(expected, process.stderr.splitlines()[-1])

    def test_interrupted_it_ends_its_runs_and_goes_on_later(self):
        words = [*COMMAND, str(CASE), "-friction_tau", "1e-3,1e-2", "-end_time", "20", "-o", str(self.csv), "--work",
                 str(self.work), "--jobs", "2"]
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while len(list(self.work.glob("*/monitor.csv"))) < 2:
            self.assertIsNone(process.poll())
            time.sleep(0.1)
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=400)
        self.assertEqual((process.returncode, errors), (130, "scree-sweep: stopped; start again to go on\n"))
        self.assertEqual(list(self.work.glob("*/sweep.json")), [])
        table = scree.sweep(CASE, {"friction_tau": ["1e-3", "1e-2"]}, work=self.work, end_time=5e-4)
        self.assertEqual(list(table.status), ["done", "done"])


if __name__ == "__main__":
    unittest.main()
