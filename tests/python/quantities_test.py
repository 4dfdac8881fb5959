"""The size of a bubble whose shape is known, with a freeboard and a smaller bubble beside it."""
import math
import unittest

import numpy as np

from scree import bed_3d, bubble_rise, output, quantities

RADIUS, HEIGHT = 0.05, 0.2  # of the bubble in the middle [m]
SURFACE = 0.4


def fields(half):
    """A bed with a void of radius RADIUS, 0.3 on its edge, and one of half that size higher up."""
    x_faces, y_faces = np.linspace(0 if half else -0.15, 0.15, 76 if half else 151), np.linspace(0, 0.5, 251)
    x, y = np.meshgrid(output.centres(x_faces), output.centres(y_faces))

    def void(height, radius):
        return 1 / (1 + (np.hypot(x, y - height) / radius) ** 12)  # 1/2 on the edge

    nu = 0.6 * (1 - void(HEIGHT, RADIUS)) * (1 - void(0.32, RADIUS / 2)) * (y < SURFACE)
    return dict(x_faces=x_faces, y_faces=y_faces, solids_fraction=nu)


class Bubble(unittest.TestCase):
    def test_it_is_the_largest_void_below_the_surface(self):
        for half in (True, False):
            found = bubble_rise.bubble(fields(half))
            self.assertAlmostEqual(found["bottom"], 15, delta=0.1)  # cm; cells of 0.2 cm
            self.assertAlmostEqual(found["top"], 25, delta=0.1)
            self.assertAlmostEqual(found["width"], 10, delta=0.1)
            self.assertAlmostEqual(found["area"], math.pi * 25, delta=0.3)

    def test_a_bed_without_a_void_has_none(self):
        bed = fields(True)
        bed["solids_fraction"] = np.where(output.centres(bed["y_faces"])[:, None] < SURFACE, 0.6, 0.0) + np.zeros(75)
        self.assertEqual(set(bubble_rise.bubble(bed).values()), {0.0})

    def test_the_contour_is_closed_and_as_wide(self):
        loops = quantities.closed_contours(*bubble_rise.full_width(fields(True)))
        widths = sorted(np.ptp(loop[:, 0]) for loop in loops)
        np.testing.assert_allclose(widths, [5, 10], atol=0.03)


class BubbleInSpace(unittest.TestCase):
    """A quarter of a bed with a round void on its axis, under a freeboard."""

    def fields(self, radius, height):
        faces = {"x": np.linspace(0, 0.04, 41), "y": np.linspace(0, 0.04, 41), "z": np.linspace(0, 0.24, 121)}
        x, y, z = (output.centres(faces[axis]) for axis in "xyz")
        distance = np.sqrt(x**2 + y[:, None] ** 2 + (z[:, None, None] - height) ** 2)
        nu = np.where((distance < radius) | (z[:, None, None] > 0.12), 0.01, 0.58)
        return {"solids_fraction": nu, **{f"{axis}_faces": places for axis, places in faces.items()}}

    def test_its_place_and_the_volume_of_all_four_quarters(self):
        ((bottom, top, volume),) = bed_3d.bubbles(self.fields(0.02, 0.06))
        self.assertAlmostEqual(bottom, 4, delta=0.21)  # cm; cells of 0.2 cm along z
        self.assertAlmostEqual(top, 8, delta=0.21)
        self.assertAlmostEqual(volume, 4 / 3 * math.pi * 8, delta=0.5)
        self.assertAlmostEqual(bed_3d.diameter(volume), 4, delta=0.03)

    def test_what_has_broken_through_the_surface_is_none(self):
        self.assertEqual(bed_3d.bubbles(self.fields(0.02, 0.11)), [])


if __name__ == "__main__":
    unittest.main()
