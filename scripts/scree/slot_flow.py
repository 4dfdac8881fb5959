"""Flow from a bin through a slot, on cells: what discrete elements and Scree are compared by. Units cgs.

Fields hold half of the bin, x from its middle and y from its floor, and are arrays (y, x)."""
import math

import numpy as np

GRAVITY = 981.0  # [cm/s2]
SHOULDER = 0.1  # of the plug's speed: what moves more slowly belongs to the shoulder


def centres(faces):
    return (faces[1:] + faces[:-1]) / 2


def slope(time, values, window):
    """Slope of the line through values within a window of time, by least squares."""
    inside = (time >= window[0]) & (time <= window[1])
    return float(np.polyfit(time[inside], values[inside], 1)[0])


def coefficient(rate, density, nu, orifice):
    """C of (28): rate [g/s] of a slot 1 cm long = C rho_s nu sqrt(g) D^1.5."""
    return rate / (density * nu * math.sqrt(GRAVITY) * orifice**1.5)


def wedge_angle(x, height, least):
    """Angle of the surface of what remains against the floor [deg]: a line through the cells higher than `least`, without
    the cell at the wall. NaN with fewer than three."""
    good = np.flatnonzero(height[:-1] > least)
    return math.degrees(math.atan(np.polyfit(x[good], height[good], 1)[0])) if good.size > 2 else float("nan")


class Flow:
    """Means of the steady part. Cells lie between faces; the floor y = 0 is a face."""

    def __init__(self, x_faces, y_faces, nu, vx, vy, temperature):
        self.x_faces, self.y_faces = x_faces, y_faces
        self.x, self.y = centres(x_faces), centres(y_faces)
        self.nu, self.vx, self.vy, self.temperature = nu, vx, vy, temperature
        self.speed = np.hypot(vx, vy)
        self.floor = int(np.argmin(np.abs(y_faces)))  # first row above it

    def on(self, x_faces, y_faces):
        """The same flow on other cells: nu by volume, velocities and T by mass."""
        mass = averaged(self.nu, self.x_faces, self.y_faces, x_faces, y_faces)
        others = [averaged(self.nu * field, self.x_faces, self.y_faces, x_faces, y_faces) / np.maximum(mass, 1e-12)
                  for field in (self.vx, self.vy, self.temperature)]
        return Flow(x_faces, y_faces, mass, *others)

    def corner(self):
        """Speed in the cell between floor and wall."""
        return float(self.speed[self.floor, -1])

    def above_orifice(self, field):
        """In the cell above the floor in the middle."""
        return float(field[self.floor, 0])

    def in_orifice(self, field):
        """In the plane of the floor in the middle: mean of the cells above and below."""
        return float(field[self.floor - 1:self.floor + 1, 0].mean())

    def line(self, plug):
        """x, y of the points where the speed passes SHOULDER times the plug's, along the rows of the bed, from below up
        to where all of a row moves."""
        points = []
        for y, speed, nu in zip(self.y[self.floor:], self.speed[self.floor:] / plug, self.nu[self.floor:]):
            slow = np.flatnonzero((speed < SHOULDER) & (nu > 0.3))
            if not slow.size or slow[0] == 0:
                break
            pair = slice(slow[0] - 1, slow[0] + 1)  # between the centres of these cells
            points.append((float(np.interp(-SHOULDER, -speed[pair], self.x[pair])), float(y)))
        return np.array(points).reshape(-1, 2)

    def line_angle(self, plug):
        """Of that line against the floor [deg]: the straight line nearest to its points; NaN with fewer than two."""
        points = self.line(plug)
        if len(points) < 2:
            return float("nan")
        *_, directions = np.linalg.svd(points - points.mean(axis=0))
        return math.degrees(math.atan2(*(directions[0, ::-1] * np.sign(directions[0, 1]))))

    def line_at(self, plug, height):
        """Distance from the middle at which that line has a height [cm]; NaN where it does not reach it."""
        points = self.line(plug)
        reaches = len(points) > 1 and points[0, 1] <= height <= points[-1, 1]
        return float(np.interp(height, points[:, 1], points[:, 0])) if reaches else float("nan")

    def height_at_wall(self, plug):
        """Height at which the speed in the last column passes SHOULDER times the plug's [cm]; 0: the whole column moves."""
        column = self.speed[self.floor:, -1] / plug
        y = self.y[self.floor:]
        moving = int(np.argmax(column > SHOULDER))
        if moving == 0:
            return 0.0 if column[0] > SHOULDER else float("nan")
        return float(np.interp(SHOULDER, column[moving - 1:moving + 1], y[moving - 1:moving + 1]))


def averaged(field, x_faces, y_faces, new_x_faces, new_y_faces):
    """Means of a field [y, x] over other cells; outside of the old ones it is 0."""
    integral = np.zeros((len(y_faces), len(x_faces)))
    integral[1:, 1:] = np.cumsum(np.cumsum(field * np.outer(np.diff(y_faces), np.diff(x_faces)), axis=0), axis=1)
    along_x = np.stack([np.interp(new_x_faces, x_faces, row) for row in integral])
    both = np.stack([np.interp(new_y_faces, y_faces, column) for column in along_x.T], axis=1)
    return np.diff(np.diff(both, axis=0), axis=1) / np.outer(np.diff(new_y_faces), np.diff(new_x_faces))
