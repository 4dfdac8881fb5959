"""T21, Bagnold's slope: mu(I) down a rough plane under its own weight, with a lid that carries nothing for the surface,
and with a free surface."""
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres, norm

MU_S, MU_2, I_0 = 0.3819, 0.6435, 0.278  # glass beads
RHO, D, G, NU, DEPTH = 2450.0, 1e-3, 9.81, 0.6, 0.02
#: Newton far below the errors; the factor of PETSc is the fastest on columns of cells.
OPTIONS = {**EXACT, "pc_factor_mat_solver_type": "petsc"}
GRIDS = 10, 20, 40

program, checks = Program(), Checks("mu(I) down a slope, glass beads, d 0.1 cm", "T21")


def inertial_number(mu):
    """I at which M is mu."""
    return I_0 * (mu - MU_S) / (MU_2 - mu)


def velocity(y, slope):
    """Down the slope, at a height over the plane [m/s]."""
    I = inertial_number(np.tan(slope))
    return 2 / 3 * I * np.sqrt(NU * G * np.cos(slope)) * DEPTH**1.5 / D * (1 - (1 - y / DEPTH) ** 1.5)


NU_MIN, NU_MAX, F, S = 0.5995, 0.65, 0.0783, 5  # of the p_c of the case


def layer(slope):
    """Options of a slope: gravity, and the mean nu at which p_c is 0 at the top of the layer."""
    p_c = lambda nu: F * (nu - NU_MIN) / (NU_MAX - nu) ** S
    stiffness = lambda nu: F * (1 + S * (nu - NU_MIN) / (NU_MAX - nu)) / (NU_MAX - nu) ** S
    weight = RHO * G * np.cos(slope)
    depth = lambda bottom: quad(lambda nu: stiffness(nu) / (weight * nu), NU_MIN, bottom)[0]
    bottom = brentq(lambda nu: depth(nu) - DEPTH, NU_MIN, 0.61, xtol=1e-14)
    return {"gravity": f"{G * np.sin(slope)}, {-G * np.cos(slope)}"}, p_c(bottom) / (weight * DEPTH)


def rows(fields):
    """Heights and velocities of the rows of the layer."""
    y = centres(fields["y_faces"])
    return y[y < DEPTH], fields["velocity_x_face"][y < DEPTH, 0]


def run(case, name, slope, cells):
    gravity, nu = layer(slope)
    region = "layer" if "surface" in case else "everywhere"
    y, u = rows(program.run(case, name, {**OPTIONS, **gravity, "grid_cells": f"2, {cells}",
                                         f"initial_{region}_solids_fraction": f"{nu:.12g}"}).fields)
    return y, u, velocity(y, slope)


slope = np.radians(24)
for degrees, published in ((24, 38.825), (26, 81.918)):  # beyond them the digits of nu and g count
    checks.close(f"{degrees} deg: reference, velocity of the surface [cm/s]",
                 velocity(DEPTH, np.radians(degrees)) * 100, published, relative=2e-5)

# ---- lid ----

errors, feet = [], []
for cells in GRIDS:
    y, u, exact = run("inertial_slope.yaml", f"lid_{cells}", slope, cells)
    errors.append(norm(u - exact) / velocity(DEPTH, slope))
    feet.append((u[0] - exact[0]) / velocity(DEPTH, slope))
checks.above("24 deg: v, relative L2, mean order on 10, 20, 40 cells", np.log2(errors[0] / errors[2]) / 2, 1.9)
checks.below("24 deg: v, relative L2, on 10 cells", errors[0], 3e-3)
checks.below("24 deg: v, relative L2, on 40 cells", errors[2], 1.5e-4)
# The row on the plane: the half cell below it has the shear rate of the plane, the greatest there is. It errs by h^2/8
# times the slope of the shear rate, which is more than the midpoints of all cells above add.
checks.order("24 deg: v of the row on the plane", feet, 2, 1e-4)
steep = np.radians(26)
y, u, exact = run("inertial_slope.yaml", "lid_steep", steep, 20)
checks.below("26 deg, 20 cells: v, relative L2", norm(u - exact) / velocity(DEPTH, steep), 1e-3)

# ---- free surface ----


def excess(cells):
    """What the top row is faster than the row below, beyond what is exact [m/s]."""
    y, u, exact = run("inertial_slope_surface.yaml", f"surface_{cells}", slope, cells * 12 // 10)
    return (u[-1] - u[-2]) - (exact[-1] - exact[-2]), norm((u - exact)[:-1]) / velocity(DEPTH, slope)


found = [excess(cells) for cells in GRIDS]
below, above = [row for _, row in found], [top for top, _ in found]
for cells, error in zip(GRIDS, below):
    checks.below(f"24 deg, free surface, {cells} cells: v below the top row, relative L2", error, 1e-2 / cells)
# The top row carries itself by the stress of surfaces, without p_c. Friction under it needs all of its weight: with p_c
# alone the row is 2.4 cm/s too fast on 40 cells.
checks.above("24 deg, free surface: order of what the top row is too fast by", np.log2(above[0] / above[2]) / 2, 1)
checks.below("24 deg, free surface: what the top row is too fast by on 40 cells [m/s]", abs(above[2]), 5e-4)
checks.verdict()
