"""scree.run and the log that run.sh keeps, on a bin of a few hundred cells. SCREE_BUILD_DIR names the build."""
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import scree
from scree import program

CASE = Path(__file__).resolve().parents[1] / "regression" / "small_bin.yaml"
SHORT = {"end_time": 1e-3, "output_interval": 5e-4}


class Place(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.out = self.place / "out"


class Running(Place):
    def test_a_run_ends_where_it_was_told_and_is_open(self):
        run = scree.run(CASE, ranks=2, output_dir=self.out, **SHORT)
        self.assertAlmostEqual(run.monitor.time.iloc[-1], 1e-3, places=12)
        self.assertEqual((run.summary["ranks"], run.summary["end"]), (2, "end_time"))
        self.assertEqual(run.fields.solids_fraction.dims, ("time", "y", "x"))
        self.assertEqual(run.monitor.attrs["units"]["flux_orifice"], "kg/s")
        self.assertIn("step", run.log)
        self.assertFalse((self.out / "log.part").exists())

    def test_a_wrong_value_is_the_programs_error_and_leaves_nothing(self):
        with self.assertRaisesRegex(scree.RunError, r"^end_time = '-1': expected [^\n]*$"):
            scree.run(CASE, ranks=2, output_dir=self.out, end_time=-1)
        self.assertFalse(self.out.exists())

    def test_a_directory_that_holds_a_run_stays_as_it_is(self):
        scree.run(CASE, ranks=1, output_dir=self.out, **SHORT)
        before = (self.out / "log").read_bytes()
        with self.assertRaisesRegex(scree.RunError, "already holds a run"):
            scree.run(CASE, ranks=1, output_dir=self.out, **SHORT)
        self.assertEqual((self.out / "log").read_bytes(), before)
        self.assertFalse((self.out / "log.part").exists())

    def test_a_run_that_goes_on_adds_to_the_log(self):
        scree.run(CASE, ranks=1, output_dir=self.out, **SHORT)
        before = (self.out / "log").read_text()
        run = scree.run(CASE, ranks=1, output_dir=self.out, restart=self.out, **{**SHORT, "end_time": 2e-3})
        self.assertTrue(run.log.startswith(before))
        self.assertIn("going on from", run.log[len(before):])

    def test_without_a_directory_it_goes_to_the_first_that_is_free(self):
        here = os.getcwd()
        os.chdir(self.place)
        self.addCleanup(os.chdir, here)
        names = [scree.run(CASE, ranks=1, **SHORT).directory for _ in range(2)]
        self.assertEqual([str(name) for name in names], ["out/regression_small_bin", "out/regression_small_bin.2"])

    def test_no_case_and_no_program(self):
        with self.assertRaisesRegex(FileNotFoundError, "no such case"):
            scree.run(self.place)
        with self.assertRaisesRegex(scree.RunError, "no program /no/such: scripts/build.sh"):
            scree.run(CASE, program="/no/such")

    def test_check_gives_the_options_in_si(self):
        options = scree.check(CASE, end_time="3 ms")
        self.assertEqual((float(options["end_time"]), options["grid_x_cells"].replace(" ", "")), (0.003, "3,9"))
        with self.assertRaisesRegex(scree.RunError, "gas = 'helium'"):
            scree.check(CASE, gas="helium")

    def test_options_are_written_as_the_program_reads_them(self):
        words = program.command("scree", "case.yaml", {"grid_x_cells": [4, 16], "output_overwrite": True, "a": 1e-3})
        self.assertEqual(words, ["scree", "case.yaml", "-grid_x_cells", "4, 16", "-output_overwrite", "true", "-a", "0.001"])


class Logged(Place):
    """python3 -m scree.logged."""

    def start(self, command, **more):
        words = [sys.executable, "-m", "scree.logged", str(self.out), *command]
        return subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)

    def test_it_passes_on_both_streams_and_keeps_them(self):
        script = f"echo one; echo two >&2; echo case > {self.out}/case.yaml; exit 3"
        process = self.start(["sh", "-c", script])
        said, errors = process.communicate()
        self.assertEqual((said, errors, process.returncode), ("one\n", "two\n", 3))
        self.assertEqual(sorted((self.out / "log").read_text().split()), ["one", "two"])

    def test_a_command_that_begins_no_run_leaves_no_log(self):
        process = self.start(["sh", "-c", "echo refused >&2; exit 1"])
        self.assertEqual((process.communicate()[1], process.returncode), ("refused\n", 1))
        self.assertFalse(self.out.exists())

    def test_a_line_that_is_written_over_is_kept_as_it_was_last(self):
        script = f"echo case > {self.out}/case.yaml; printf '\\rtime 1\\033[K\\rtime 2\\033[K\\n'; echo remark"
        self.start(["sh", "-c", script]).communicate()
        self.assertEqual((self.out / "log").read_text(), "time 2\nremark\n")

    def test_on_a_terminal_the_command_has_one(self):
        words = f"{sys.executable} -m scree.logged {self.out} sh -c 'echo c > {self.out}/case.yaml; test -t 1 && echo yes'"
        subprocess.run(["script", "-qec", words, "/dev/null"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                       check=True)
        self.assertEqual((self.out / "log").read_text(), "yes\n")

    def test_the_signal_that_ends_a_run_reaches_it(self):
        command = program.command(program.default_program(), CASE, {"end_time": 10, "output_dir": self.out}, 2)
        process = self.start(command, env=program.environment())
        while not (self.out / "monitor.csv").exists():
            self.assertIsNone(process.poll())
            time.sleep(0.1)
        process.send_signal(signal.SIGUSR1)
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.assertLess(scree.open(self.out).summary["time"], 10)
        self.assertTrue(list((self.out / "checkpoints").glob("*.h5")))


class Stopping(Place):
    def start(self, on_signal):
        """A program that answers SIGUSR1 with on_signal(), and takes a minute by itself."""
        ready = self.place / "ready"
        text = (f"import pathlib, signal, sys, time; signal.signal(signal.SIGUSR1, lambda *_: {on_signal}); "
                f"pathlib.Path({str(ready)!r}).touch(); deadline = time.monotonic() + 60\n"
                "while time.monotonic() < deadline: time.sleep(0.1)")
        process = program.start([sys.executable, "-c", text], self.place / "log")
        self.addCleanup(program.end_group, process)
        while not ready.exists():
            time.sleep(0.02)
        return process

    def test_a_program_that_ends_by_itself_is_waited_for(self):
        process = self.start("(time.sleep(2), sys.exit(3))")
        program.stop(process)
        self.assertEqual(process.returncode, 3)

    def test_a_second_interrupt_ends_it_at_once(self):
        process = self.start("None")
        begun = time.monotonic()
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        program.stop(process)
        self.assertEqual(process.returncode, -signal.SIGTERM)
        self.assertLess(time.monotonic() - begun, 20)


if __name__ == "__main__":
    unittest.main()
