"""scree.accuracy on made-up values: errors of the first order are found again, and the runs that it names exist."""
import unittest

import numpy as np

from scree import accuracy, scheme_race


class Accuracy(unittest.TestCase):
    def test_errors_of_order_one_are_found(self):
        values = {a: {"number": 2 * (1 + a), "profile": np.array([4.0, -1]) + a * np.array([0, 3.0])}
                  for a in (1e-1, 1e-2, 1e-3, 3e-4)}
        found = accuracy.errors(values)
        for a in values:
            self.assertAlmostEqual(found["number"][a], a, places=12)
            self.assertAlmostEqual(found["profile"][a], 3 * a / 4, places=12)

    def test_table_leaves_out_what_has_not_been_run(self):
        lines = accuracy.table({"a scene": {"rate": {1e-1: 0.05, 1e-2: 0.005}}}).splitlines()
        self.assertIn("| a scene | rate | 5.0e-02 |  | 5.0e-03 |", lines[2])

    def test_cases_are_there(self):
        for scene in accuracy.SCENES:
            self.assertTrue((accuracy.ROOT / "cases" / scene.case).is_file(), scene.case)

    def test_the_race_tells_a_failed_run_from_a_finished_one(self):
        rows = [{"scene": "a", "scheme": "bdf", "accuracy": "0.1", "end": "negative nu"},
                {"scene": "a", "scheme": "beuler", "accuracy": "0.1", "end": "end_time", "steps": "12", "newton_iterations": "30",
                 "cpu [s]": "2.0", "greatest error": "0.05", "of": "rate"}]
        lines = scheme_race.table(rows).splitlines()
        self.assertEqual(lines[2], "| a | bdf | 0.1 | negative nu |  |  |  |  |  |")
        self.assertEqual(lines[3], "| a | beuler | 0.1 | end_time | 12 | 30 | 2.0 | 0.05 | rate |")
        self.assertEqual(len(scheme_race.draw(rows).axes[0].lines[1].get_xdata()), 0)

    def test_a_scheme_has_its_own_run(self):
        scene = accuracy.SCENES[0]
        default, bdf = (scene.point(0.1, accuracy.PAGE, *scheme) for scheme in ((), ("bdf",)))
        self.assertNotEqual(default.directory, bdf.directory)
        self.assertEqual(bdf.options["time_scheme"], "bdf")


if __name__ == "__main__":
    unittest.main()
