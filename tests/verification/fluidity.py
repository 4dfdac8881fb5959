"""T23, nonlocal friction: uniform shear, a slab below the yield stress between plates that hold the fluidity, and layers
on a slope that flow where they are thick enough."""
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres

MU_S, A, B = 0.3819, 0.48, 0.9377  # glass beads
RHO, D, G = 2450.0, 1e-3, 9.81
#: Newton far below the errors; the factor of PETSc is the fastest on columns of cells.
OPTIONS = {**EXACT, "pc_factor_mat_solver_type": "petsc"}

program, checks = Program(), Checks("fluidity, glass beads, d 0.1 cm", "T23")

# ---- uniform shear ----

RATE, P = 10.0, 100.0
inertial = RATE * D * np.sqrt(RHO / P)
exact = RATE / (MU_S + B * inertial)
checks.close("shear: reference, fluidity [1/s]", exact, 23.34737, relative=3e-7)
checks.close("shear: reference, M", RATE / exact, 0.428314, relative=2e-6)
nu = brentq(lambda nu: 0.05 * (nu - 0.5) ** 2 / (0.65 - nu) ** 5 - P, 0.51, 0.6, xtol=1e-15)
run = program.run("fluid_shear.yaml", "shear", {**OPTIONS, "initial_everywhere_solids_fraction": f"{nu:.15g}"})
# The pressure floor of the closure, 1e-3 Pa, takes 5e-6 of I: 6e-7 of g.
checks.close("shear: fluidity [1/s]", run.fields["fluidity"].mean(), exact, relative=1e-6)
checks.below("shear: spread of the fluidity, relative", np.ptp(run.fields["fluidity"]) / exact, 1e-9)
drag = run.monitor["force_boundary_lid_x"][-1] / run.monitor["force_boundary_lid_y"][-1]
checks.close("shear: shear over normal force on the lid", abs(drag), RATE / exact, relative=1e-6)

# ---- slab below the yield stress ----

MU, HEIGHT, AT_WALL = 0.25, 0.02, 10.0
# With friction linear in S: A^2 d^2 g'' = (mu_s - mu) g. (Henann & Kamrin's own form has (mu_2 - mu)/(mu_2 - mu_s)
# more under the root, and 0.16210 cm here.)
xi = A * D / np.sqrt(MU_S - MU)
middle = 1 / np.cosh(HEIGHT / (2 * xi))
speed = MU * AT_WALL * 2 * xi * np.tanh(HEIGHT / (2 * xi))
checks.close("slab: reference, decay length [cm]", xi * 100, 0.132165, relative=1e-5)
checks.close("slab: reference, speed of the lid [cm/s]", speed * 100, 0.660825, relative=1e-5)
ratios, middles = [], []
for cells in (40, 80, 160):
    run = program.run("fluid_slab.yaml", f"slab_{cells}", {
        **OPTIONS, "grid_cells": f"2, {cells}", "boundary_lid_velocity": f"{speed:.12g}, 0",
        "initial_everywhere_solids_fraction": f"{nu:.15g}"})
    ratio = abs(run.monitor["force_boundary_lid_x"][-1] / run.monitor["force_boundary_lid_y"][-1])
    ratios.append(ratio / MU - 1)
    g = run.fields["fluidity"][:, 0]
    middles.append(np.sqrt(g[cells // 2] * g[cells // 2 - 1]) / AT_WALL / middle - 1)
checks.order("slab: shear over normal force, relative, on 40, 80, 160 cells", ratios, 2, 2e-3, slack=0.25)
checks.order("slab: fluidity of the middle over that of the plates, relative", middles, 2, 2e-2)

# ---- threshold of flow on a slope ----

NU_MIN, NU_MAX, F, S = 0.5995, 0.65, 0.0783, 5  # of the p_c of the case
T_0 = 1e-3


def at_rest(slope, depth, path):
    """Writes nu of a layer at rest, with p_c = 0 at its top, as a table of the height."""
    stiffness = lambda nu: F * (1 + S * (nu - NU_MIN) / (NU_MAX - nu)) / (NU_MAX - nu) ** S
    weight = RHO * G * np.cos(slope)
    below_top = lambda nu: quad(lambda nu: stiffness(nu) / (weight * nu), NU_MIN, nu)[0]
    heights = np.linspace(0, depth, 101)
    table = [(y, brentq(lambda nu: below_top(nu) - (depth - y), NU_MIN, 0.61, xtol=1e-15)) for y in heights]
    path.write_text("\n".join(f"{y:.15g} {nu:.15g}" for y, nu in table))
    return path


def threshold(degrees, depth, cells):
    """Depth from which layers flow, over d, from the rate at which the fluidity grows in a layer of that depth: growth
    follows (mu - mu_s - (pi A d/(2 h))^2)/t_0."""
    slope = np.radians(degrees)
    table = at_rest(slope, depth, program.work / f"at_rest_{degrees}.txt")
    run = program.run("fluid_slope.yaml", f"slope_{degrees}_{cells}", {
        **OPTIONS, "gravity": f"{G * np.sin(slope)}, {-G * np.cos(slope)}", "grid_cells": f"2, {cells}",
        "extent": f"0.005, {depth}", "initial_everywhere_table": table})
    late = [(fields["time"], fields["fluidity"].mean()) for fields in run.all_fields()[-2:]]
    rate = np.log(late[1][1] / late[0][1]) / (late[1][0] - late[0][0])
    return np.pi / 2 * A / np.sqrt(np.tan(slope) - MU_S - rate * T_0)


for degrees, published in ((23, 3.654), (24, 2.996), (26, 2.318)):
    exact = np.pi / 2 * A / np.sqrt(np.tan(np.radians(degrees)) - MU_S)
    checks.close(f"slope of {degrees} deg: reference, least depth that flows, over d", exact, published, absolute=5e-4)
    errors = [threshold(degrees, exact * D, cells) / exact - 1 for cells in (10, 20, 40)]
    # First order is what the row at the lid adds: the pressure under it has the rounded clip of rows that rest on others,
    # 0.35 % too much.
    checks.above(f"slope of {degrees} deg: least depth that flows, mean order on 10, 20, 40 cells",
                 np.log2(errors[0] / errors[2]) / 2, 1.5)
    checks.below(f"slope of {degrees} deg: least depth that flows, relative, on 40 cells", abs(errors[2]), 2.5e-3)
checks.verdict()
