"""scree.open: fields, monitor, case, lines and plots of made-up runs whose numbers are known."""
import tempfile
import unittest
from pathlib import Path

import made_up
import numpy as np

import scree
from scree import case_file, output, plots

CELLS = np.array([0.005, 0.02, 0.045])  # centres along x [m]


class MadeUpRun(unittest.TestCase):
    dimension = 2

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.directory = made_up.write_run(Path(place.name) / "made_up", self.dimension)
        self.run_ = scree.open(self.directory)


class Fields(MadeUpRun):
    def test_cell_fields_have_time_and_axes_with_coordinates_at_centres(self):
        nu = self.run_.fields.solids_fraction
        self.assertEqual(nu.dims, ("time", "y", "x"))
        np.testing.assert_allclose(nu.x, CELLS)
        np.testing.assert_allclose(nu.y, [0.05, 0.15, 0.25, 0.35, 0.45])
        np.testing.assert_allclose(nu.time, [0, 0.2, 0.4])
        np.testing.assert_allclose(nu.sel(time=0.2).isel(y=1), made_up.solids_fraction(CELLS, 0.2))
        self.assertEqual((nu.attrs["units"], nu.x.attrs["units"], nu.time.attrs["units"]), ("1", "m", "s"))

    def test_velocities_are_at_centres_and_at_faces(self):
        data = self.run_.fields
        self.assertEqual(data.velocity.dims, ("time", "y", "x", "component"))
        np.testing.assert_allclose(data.velocity.sel(component="x").isel(time=0, y=0), CELLS)
        self.assertEqual(data.velocity_x_face.dims, ("time", "y", "x_face"))
        np.testing.assert_allclose(data.velocity_x_face.isel(time=0, y=0), data.x_face)

    def test_parts_are_read_by_name_and_nearest_time(self):
        data = self.run_.dataset(["solids_fraction"], [0.19])
        self.assertEqual((list(data), list(data.time.values)), (["solids_fraction"], [0.2]))
        self.assertEqual(float(self.run_.at(None).time), 0.4)

    def test_an_unknown_field_is_named_with_those_that_there_are(self):
        with self.assertRaisesRegex(KeyError, "no field nu .*granular_temperature, solids_fraction"):
            self.run_.at(0.2, ["nu"])

    def test_a_directory_without_a_run_is_refused(self):
        with self.assertRaisesRegex(FileNotFoundError, "holds no run"):
            scree.open(self.directory / "fields")


class OtherDimensions(unittest.TestCase):
    def dims(self, dimension):
        with tempfile.TemporaryDirectory() as place:
            run = scree.open(made_up.write_run(Path(place) / "run", dimension))
            figure = run.plot("velocity")
            self.assertTrue(figure.axes)
            plots.plt.close(figure)
            return run.fields.velocity.dims, run.fields.velocity_x_face.dims

    def test_one_dimension(self):
        self.assertEqual(self.dims(1), (("time", "x", "component"), ("time", "x_face")))

    def test_three_dimensions(self):
        self.assertEqual(self.dims(3), (("time", "z", "y", "x", "component"), ("time", "z", "y", "x_face")))


class Tables(MadeUpRun):
    def test_monitor_is_a_table_with_units(self):
        monitor = self.run_.monitor
        np.testing.assert_allclose(monitor.mass, 5 - monitor.time)
        expected = {"time": "s", "mass": "kg", "discharge_rate": "kg/s", "flux_orifice": "kg/s", "cpu_seconds": "s",
                    "solids_fraction_min": "1", "tip_velocity_x": "m/s", "newton_iterations": "1"}
        self.assertEqual({name: monitor.attrs["units"][name] for name in expected}, expected)

    def test_a_row_that_was_cut_off_does_not_count(self):
        with tempfile.TemporaryDirectory() as place:
            run = scree.open(made_up.write_run(Path(place) / "killed", ended=False))
            self.assertEqual((len(run.monitor), run.summary), (5, {}))

    def test_summary_case_and_log(self):
        self.assertEqual(self.run_.summary["steps"], 4)
        self.assertEqual(self.run_.case["plate_floor_openings"], "0, 0.02")
        self.assertIn("multigrid from here on", self.run_.log)

    def test_lines_have_the_rows_of_all_times(self):
        line = self.run_.lines["axis_of_bin"]
        self.assertEqual((list(line), list(line.time)), (["time", "x", "solids_fraction"], [0, 0.2, 0.4]))

    def test_means_count_time_and_not_steps(self):
        times, values = np.array([0, 0.9, 0.99, 1.0]), np.array([0, 0.9, 0.99, 1.0])
        self.assertAlmostEqual(output.mean_over((0, 1), times, values), 0.5, places=9)

    def test_a_half_is_mirrored(self):
        np.testing.assert_allclose(output.mirrored_faces(np.array([0, 1, 3.0])), [-3, -1, 0, 1, 3])
        np.testing.assert_allclose(output.mirrored(np.array([[1, 2.0]]), -1), [[-2, -1, 1, 2]])


class Plots(MadeUpRun):
    def tearDown(self):
        plots.plt.close("all")

    def test_a_map_shows_the_field_of_its_time_on_the_cells(self):
        figure = self.run_.plot("solids_fraction", time=0.2, arrows="velocity")
        shown = figure.axes[0].collections[0].get_array().reshape(5, 3)
        np.testing.assert_allclose(shown[0], made_up.solids_fraction(CELLS, 0.2))
        self.assertEqual(figure.axes[0].get_title(loc="left"), "t = 0.2 s")
        self.assertEqual(figure.axes[1].get_ylabel(), "solids fraction (–)")

    def test_a_map_of_a_vector_shows_its_size(self):
        figure = self.run_.plot("velocity")
        np.testing.assert_allclose(figure.axes[0].collections[0].get_array().reshape(5, 3)[0], CELLS)
        self.assertEqual(figure.axes[1].get_ylabel(), "velocity (m/s)")

    def test_the_monitor_is_drawn_with_its_unit(self):
        axes = self.run_.plot_monitor(["discharge_rate", "flux_orifice"]).axes[0]
        np.testing.assert_allclose(axes.lines[0].get_ydata(), self.run_.monitor.discharge_rate)
        self.assertEqual((axes.get_ylabel(), len(axes.get_legend().get_texts())), ("kg/s", 2))


class CaseFiles(unittest.TestCase):
    def test_nested_keys_lists_and_comments(self):
        text = """\
grid:   # of the box
  x_edges: "0, 4 cm"
  y_cells: [1, 2]
boundary:
  wall: {side: x_upper, patch: "5 cm, 105 cm"}
probe:
- a
- b
gas: none
"""
        self.assertEqual(case_file.flatten(text), {
            "grid_x_edges": "0, 4 cm", "grid_y_cells": "1, 2", "boundary_wall_side": "x_upper",
            "boundary_wall_patch": "5 cm, 105 cm", "probe": "a, b", "gas": "none"})

    def test_a_case_has_the_options_of_the_one_it_is_based_on(self):
        with tempfile.TemporaryDirectory() as place:
            place = Path(place)
            (place / "case.yaml").write_text("gas: none\nend_time: 1\n")
            (place / "long.yaml").write_text("based_on: case.yaml\nend_time: 2\n")
            self.assertEqual(case_file.read(place / "long.yaml"), {"gas": "none", "end_time": "2"})
            self.assertEqual(case_file.find(place), place / "case.yaml")

    def test_lengths(self):
        np.testing.assert_allclose(case_file.lengths("-0.7 cm, 2 mm, .5, 1e-3 m"), [-0.007, 0.002, 0.5, 0.001])


if __name__ == "__main__":
    unittest.main()
