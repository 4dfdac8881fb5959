"""Short waves of div v: how strong they are in a field, and by how much theory says they grow in a step when friction
is lagged."""
import numpy as np

PHI = np.radians(28.5)
N = np.sqrt(3) / (2 * np.sin(PHI))  # of dilation
NU_MIN, NU_MAX, F, RHO_S, D = 0.5, 0.65, 0.05, 2900.0, 1e-3

#: Bulk viscosity that (21) gives to p_f over 4/3 of the shear viscosity of (20), for T/d^2 >> S:S: whatever p_c, T and
#: grid are.
RATIO = 3 * (N - 1) / (4 * N * np.sin(PHI) ** 2)


def lagged_factor(nu, T, cells, tau, dt):
    """Greatest factor per step of the shortest wave, in a plug that dilates slowly: v and nu by backward Euler, chi of
    the step from the state before it (tau = 0: chi*). Longitudinal wave, viscosities of friction alone:

        rho nu (v1 - v0)/dt = -ik p_c chi1 - ik p_c' nu1 - 4/3 eta k^2 v1,   nu1 = nu0 - dt nu ik v1,
        chi1 = chi0 + dt/(dt + tau) (-zeta/p_c ik v0 - chi0)

    with zeta = p_c (n-1)/(n sqrt2 sin(phi) gamma), eta = p_c sqrt2 sin(phi)/(2 gamma), gamma = sqrt(T)/d."""
    p_c = F * (nu - NU_MIN) ** 2 / (NU_MAX - nu) ** 5
    slope = p_c * (2 / (nu - NU_MIN) + 5 / (NU_MAX - nu))
    k_k = sum(4 / size**2 for size in cells)
    shear = np.sqrt(2) * np.sin(PHI) * p_c * D / (2 * np.sqrt(T))
    viscous = float(4 / 3 * shear * k_k * dt / (RHO_S * nu))
    bulk = RATIO * viscous
    elastic = float(slope * k_k * dt**2 / RHO_S)
    share = dt / (dt + tau)
    z, z_1, z_chi = np.poly1d([1, 0]), np.poly1d([1, -1]), np.poly1d([1, share - 1])
    return np.abs((z_1 * z_1 * z_chi + z * z_1 * z_chi * viscous + z * z_1 * (bulk * share)
                   + z * z * z_chi * elastic).roots).max()


def divergence(fields):
    """div v of the cells [1/s]."""
    across = np.diff(fields["velocity_x_face"], axis=1) / np.diff(fields["x_faces"])
    return across + np.diff(fields["velocity_y_face"], axis=0) / np.diff(fields["y_faces"])[:, None]


def roughness(values, axis):
    """Root mean square of second differences, over 4: the amplitude of what alternates from cell to cell."""
    return float(np.sqrt(np.mean(np.diff(values, 2, axis=axis) ** 2)) / 4)


def rows(fields, lower, upper):
    """The rows of cells between two heights."""
    y = fields["y_faces"]
    return slice(np.searchsorted(y, lower - 1e-9), np.searchsorted(y, upper + 1e-9) - 1)
