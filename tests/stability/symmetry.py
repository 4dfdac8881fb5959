"""How far a plane scene is from its mirror image in x."""
from scree_program import mirror_error


def asymmetry(fields):
    """Greatest difference of nu from its mirror image, and of v_y where there are particles [m/s]."""
    nu = fields["solids_fraction"]
    there = (nu > 1e-3) & (nu[:, ::-1] > 1e-3)
    v = fields["velocity"][..., 1]
    return mirror_error(nu), float(abs(v - v[:, ::-1])[there].max())


def bubble(fields, threshold=0.3):
    """The void below the surface that the bed has at the wall: {area [m2], height of its top, of its centre [m]}."""
    nu, x, y = fields["solids_fraction"], fields["x_faces"], fields["y_faces"]
    area = (y[1:] - y[:-1])[:, None] * (x[1:] - x[:-1])[None, :]
    middle = 0.5 * (y[1:] + y[:-1])
    surface = middle[nu[:, 0] > threshold].max()
    void = (nu < threshold) & (middle < surface)[:, None]
    if not void.any():
        return 0.0, 0.0, 0.0
    total = area[void].sum()
    return total, float(y[1:][void.any(axis=1)].max()), float((area * middle[:, None])[void].sum() / total)
