"""scree.why_c on made-up rows: the laws against their closed forms, the tables, and the runs that it names."""
import math
import unittest

import numpy as np

from scree import beside_grains, case_file, paper_slice, why_c


def made_up(model, width, rate, grid="case"):
    return {"model": model, "grid": grid, "orifice [cm]": width, "status": "done",
            **dict.fromkeys(why_c.SHOWN, "1"), "rate [g/s]": f"{rate:.9f}"}


class Laws(unittest.TestCase):
    def test_slot_law_is_beverloos_with_a_width_less_by_k_d(self):
        expected = 1.03 * 2.9 * 0.60 * math.sqrt(981) * 1.26**1.5  # g/s for 1.4 cm and 1 mm
        self.assertAlmostEqual(why_c.slot_law(1.4), expected, places=9)
        self.assertAlmostEqual(why_c.slot_law(0.14), 0)

    def test_coefficient_is_that_of_28(self):
        self.assertAlmostEqual(why_c.coefficient(1.6 * 2.9 * 0.60 * math.sqrt(981) * 1.4**1.5, 1.4), 1.6, places=12)

    def test_width_law_finds_exponent_and_k(self):
        power = [made_up("paper", width, 50 * width**1.43) for width in why_c.WIDTHS]
        self.assertAlmostEqual(why_c.width_law(power, "paper")[0], 1.43, places=6)
        slots = [made_up("best", width, why_c.slot_law(width, k=2.3)) for width in reversed(why_c.WIDTHS)]
        self.assertAlmostEqual(why_c.width_law(slots, "best")[1], 2.3, places=5)
        for few in ([], slots[:1]):
            self.assertTrue(all(math.isnan(number) for number in why_c.width_law(few, "best")))


class Tables(unittest.TestCase):
    def test_rates_stand_under_their_grid_and_width(self):
        rows = [made_up("best", 1.4, 70, "half"), made_up("best", 1.4, 71), made_up("best", 1.8, 99)]
        line = next(line for line in why_c.steps_table(rows).splitlines() if "best.yaml" in line)
        self.assertEqual([word.strip() for word in line.split("|")[2:5]], ["70.000000000", "71.000000000", ""])
        self.assertIn("| 1.8 |  | 99.00 |", why_c.widths_table(rows))

    def test_rates_are_extrapolated_where_three_grids_have_an_order(self):
        self.assertEqual(why_c.rate_without_cells(["104", "102", "101"]), "100.0")
        for irregular in (["104", "102", "103"], ["104", "103", "102"], ["104", "102", ""]):
            self.assertEqual(why_c.rate_without_cells(irregular), "")

    def test_a_failed_run_is_in_no_table(self):
        failed = {"model": "paper", "grid": "case", "orifice [cm]": 1.4, "status": "failed", "reason": "lost"}
        self.assertEqual(len(why_c.steps_table([failed]).splitlines()), 2)


class Runs(unittest.TestCase):
    def test_every_model_runs_on_the_grid_of_the_case_and_best_is_best_yaml(self):
        jobs = why_c.jobs()
        labels = [job.label + f"_{job.diameter}" for job in jobs]
        self.assertEqual(len(labels), len(set(labels)))
        self.assertEqual({job.model for job in jobs if job.grid == "case" and job.diameter == 1},
                         {step.name for step in why_c.STEPS})
        for job in jobs:
            self.assertTrue((why_c.BIN / job.case).is_file(), job.label)
        best = next(job for job in jobs if job.model == "best")
        self.assertEqual((best.case, best.options), ("best.yaml", why_c.GRIDS["half"]))
        self.assertEqual(case_file.read(why_c.BIN / best.case)["friction_fluctuation"], "0")


class Slice(unittest.TestCase):
    def test_cells_of_the_reference_fill_the_bin_from_its_middle_and_have_the_floor_as_a_face(self):
        flow = paper_slice.reference_flow()
        x, y = flow.x_faces, flow.y_faces
        self.assertAlmostEqual(x[0], 0)
        self.assertAlmostEqual(x[-1], 4)
        self.assertLess(np.abs(y).min(), 1e-9)

    def test_spheres_have_the_angle_of_friction_of_the_case(self):
        cell = beside_grains.read_csv(paper_slice.REFERENCE / "shear_cell.csv")
        slow = [float(ratio) for ratio, rolling, I in zip(cell["tau/p"], cell["rolling"], cell["inertial number"])
                if float(rolling) == paper_slice.PAPER.rolling and float(I) < 0.01]
        self.assertGreater(len(slow), 2)
        self.assertAlmostEqual(np.mean(slow), math.sin(math.radians(28.5)), delta=0.02)

    def test_a_number_that_there_is_not_is_left_out(self):
        row = dict.fromkeys(paper_slice.SHOWN, "1")
        self.assertIn("| a |  | 1 |", paper_slice.table({"a": {**row, paper_slice.SHOWN[0]: "nan"}}))


if __name__ == "__main__":
    unittest.main()
