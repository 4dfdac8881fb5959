"""Shape of what lies on a floor: depth, angle, front, from the fields of a run."""
import numpy as np
from scree_program import centres

DENSE = 0.585  # solids fraction of particles at rest under their own weight, a few centimetres deep


def depth(fields):
    """Positions [m] and depth of the particles there, as if they were dense [m]."""
    nu = fields["solids_fraction"]
    return centres(fields["x_faces"]), np.diff(fields["y_faces"]) @ nu / DENSE


def angle(fields, between):
    """Angle of the surface between two positions, falling to the right is positive [degrees]."""
    x, h = depth(fields)
    inside = (x > between[0]) & (x < between[1])
    return np.degrees(np.arctan(-np.polyfit(x[inside], h[inside], 1)[0]))


def front(fields, thickness):
    """Where the depth falls below `thickness` [m], counted from the left, between cell centres."""
    x, h = depth(fields)
    last = np.flatnonzero(h > thickness)[-1]
    if last + 1 == len(x):
        return x[last]
    return x[last] + (h[last] - thickness) / (h[last] - h[last + 1]) * (x[last + 1] - x[last])


def standing(run, since):
    """Greatest speed of what is there over the end of a run, from `since` on [m/s]."""
    monitor = run.monitor
    return float(np.max(monitor["speed_max_weighted"][np.asarray(monitor["time"]) >= since]))
