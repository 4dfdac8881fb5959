"""What discrete elements and Scree are compared by, on made-up flows and grains whose numbers are known."""
import dataclasses
import math
import tempfile
import unittest
from pathlib import Path

import numpy as np

from scree import slot_flow
from scree.discrete_elements import ANAND, PAPER, Fields, filling, frames, grains, lammps_input, sphere_points

ANGLE = 40.0  # of the made-up shoulder [deg]


def flow(cells=20):
    """Speed 1 but beyond a line from the lip at x = 1, where it falls by 1/10 each 1 cm; nu = 0.6."""
    x_faces, y_faces = np.linspace(0, 6, cells + 1), np.linspace(-1.5, 6, 5 * cells // 4 + 1)
    x, y = np.meshgrid(slot_flow.centres(x_faces), slot_flow.centres(y_faces))
    beyond = x - 2 - y / math.tan(math.radians(ANGLE))
    speed = 0.1 * np.exp(-np.clip(beyond, -50, 50))
    return slot_flow.Flow(x_faces, y_faces, np.full_like(x, 0.6), np.zeros_like(x), -speed, 4 * x)


class SlotFlow(unittest.TestCase):
    def test_the_line_has_the_angle_it_was_made_with(self):
        found = flow(60)
        self.assertAlmostEqual(found.line_angle(1.0), ANGLE, delta=0.3)
        x, y = found.line(1.0).T
        np.testing.assert_allclose(x, 2 + y / math.tan(math.radians(ANGLE)), atol=0.01)
        self.assertAlmostEqual(found.line_at(1.0, 1.5), 2 + 1.5 / math.tan(math.radians(ANGLE)), delta=0.01)
        self.assertTrue(math.isnan(found.line_at(1.0, 5.0)))
        self.assertAlmostEqual(found.height_at_wall(1.0), (5.95 - 2) * math.tan(math.radians(ANGLE)), delta=0.03)

    def test_a_flow_that_moves_as_one_has_no_line(self):
        one = flow()
        one.speed = np.ones_like(one.speed)
        self.assertEqual(len(one.line(1.0)), 0)
        self.assertTrue(math.isnan(one.line_angle(1.0)))
        self.assertEqual(one.height_at_wall(1.0), 0.0)

    def test_other_cells_keep_mass_and_momentum(self):
        fine = flow(20)
        fine.nu[:] = 0.1 + 0.02 * fine.x + 0.01 * fine.y[:, None]
        x_faces, y_faces = np.array([0, 0.7, 2.9, 6]), np.array([-1.5, 0, 2.2, 6])
        coarse = fine.on(x_faces, y_faces)
        for values in (lambda f: f.nu, lambda f: f.nu * f.vy, lambda f: f.nu * f.temperature):
            sums = [np.sum(values(f) * np.outer(np.diff(f.y_faces), np.diff(f.x_faces))) for f in (fine, coarse)]
            self.assertAlmostEqual(sums[0], sums[1], places=10)
        self.assertEqual(coarse.floor, 1)

    def test_slope_within_a_window(self):
        time = np.linspace(0, 1, 101)
        mass = np.where(time < 0.2, 0, 80 * (time - 0.2))
        self.assertAlmostEqual(slot_flow.slope(time, mass, (0.25, 0.7)), 80)

    def test_coefficient_is_that_of_its_law(self):
        self.assertAlmostEqual(slot_flow.coefficient(2.0 * 2.5 * 0.6 * math.sqrt(981) * 1.4**1.5, 2.5, 0.6, 1.4), 2.0)

    def test_a_wedge_has_the_angle_of_its_surface(self):
        x = np.linspace(0.5, 6, 12)
        height = np.clip((x - 2) * math.tan(math.radians(22)), 0, None)
        height[-1] = 9  # the cell at the wall does not count
        self.assertAlmostEqual(slot_flow.wedge_angle(x, height, 0.1), 22, places=6)
        self.assertTrue(math.isnan(slot_flow.wedge_angle(x, 0 * x, 0.1)))


class Grains(unittest.TestCase):
    def test_the_lattice_has_room_for_all(self):
        places = grains(ANAND)
        self.assertEqual(places.shape, (ANAND.count, 3))
        self.assertLess(np.abs(places[:, 0]).max(), ANAND.width / 2 - ANAND.diameter / 2)
        near = places[:300, None] - places[None, :300]
        near[..., 2] -= ANAND.depth * np.round(near[..., 2] / ANAND.depth)
        distance = np.sqrt((near**2).sum(-1)) + 9 * np.eye(300)
        self.assertGreater(distance.min(), ANAND.diameter)

    def test_dashpot_gives_the_restitution(self):
        mass, gamma = ANAND.mass / 2, ANAND.damping(ANAND.restitution, ANAND.mass / 2)
        overlap, speed, step = 0.0, 1.0, ANAND.collision_time() / 20000
        while overlap >= 0:  # a collision by leapfrog
            speed -= step * (ANAND.stiffness / mass * overlap + gamma * speed)
            overlap += step * speed
        self.assertAlmostEqual(-speed, ANAND.restitution, delta=1e-3)

    def test_parts_of_a_sphere_have_its_second_moment(self):
        points = sphere_points(shells=40)
        np.testing.assert_allclose((points**2).mean(axis=0), [0.2, 0.2], rtol=0.01)

    def test_input_says_what_the_bin_is(self):
        text = lammps_input(ANAND)
        self.assertIn("xplane -6.272 6.272", text)
        self.assertIn("region left block -12.544 -1.2544", text)
        self.assertNotIn("rolling", text)
        self.assertIn("rolling sds", lammps_input(dataclasses.replace(ANAND, rolling=0.1)))

    def test_sides_may_have_a_friction_of_their_own(self):
        lines = lammps_input(PAPER).splitlines()
        friction = {line.split()[1]: float(line.split(" linear_history ")[1].split()[2])
                    for line in lines if line.startswith("fix") and "linear_history" in line}
        self.assertAlmostEqual(friction.pop("sides"), math.tan(math.radians(12.3)), places=5)
        self.assertEqual(friction, {"floor": 0.5, "left": 0.5, "right": 0.5})

    def test_fields_of_grains_that_move_alike(self):
        random = np.random.default_rng(3)
        silo = dataclasses.replace(ANAND, count=20000)
        fields = Fields(silo, 8.0)
        x, y = random.uniform(-6.272, 6.272, 20000), random.uniform(-1, 8, 20000)
        noise = random.normal(0, 3.0, (20000, 3))
        frame = np.column_stack([x, y, 0.5 * np.sign(x) + noise[:, 0], -20 + noise[:, 1], noise[:, 2]])
        nu, vx, vy, temperature = fields.mean([frame])
        inner = (slice(3, 15), slice(1, -1))
        expected = 20000 * silo.mass / silo.density / (9 * silo.width * silo.depth)
        self.assertAlmostEqual(nu[inner].mean(), expected, delta=0.02 * expected)
        self.assertAlmostEqual(vx[inner].mean(), 0.5, delta=0.1)
        self.assertAlmostEqual(vy[inner].mean(), -20, delta=0.1)
        self.assertAlmostEqual(temperature[inner].mean(), 9, delta=0.4)

    def test_uniform_shear_is_no_temperature(self):
        random = np.random.default_rng(4)
        fields = Fields(ANAND, 8.0)
        x, y = random.uniform(-6.272, 6.272, 40000), random.uniform(-1, 8, 40000)
        frame = np.column_stack([x, y, 0 * x, 10 * y, 0 * x])  # 4.5 cm/s over a cell
        *_, temperature = fields.mean([frame])
        self.assertLess(temperature[3:15, 1:-1].mean(), 0.05)

    def test_filling_is_that_of_a_uniform_bed(self):
        random = np.random.default_rng(5)
        height = 9.0
        settled = np.column_stack([random.uniform(-6, 6, ANAND.count), random.uniform(0, height, ANAND.count)])
        nu, found = filling(ANAND, settled)
        expected = ANAND.count * ANAND.mass / ANAND.density / (height * ANAND.width * ANAND.depth)
        self.assertAlmostEqual(nu, expected, delta=0.02 * expected)
        self.assertAlmostEqual(found, height, delta=0.2)

    def test_frames_of_a_dump(self):
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "a.dump"
            head = "ITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff pp\n0 1\n0 1\n0 1\nITEM: ATOMS x y \n"
            two, one = head.format(2) + "1 2\n3 4\n", head.format(1) + "5 6\n"
            path.write_text(f"ITEM: TIMESTEP\n7\n{two}ITEM: TIMESTEP\n9\n{one}")
            (first, a), (second, b) = frames(path)
            self.assertEqual((first, second), (7, 9))
            np.testing.assert_array_equal(a, [[1, 2], [3, 4]])
            np.testing.assert_array_equal(b, [[5, 6]])


if __name__ == "__main__":
    unittest.main()
