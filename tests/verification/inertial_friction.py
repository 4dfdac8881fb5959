"""T21, friction that grows with the inertial number: a vertical chute, and the shear without change of volume of the flow
rule that belongs to M(I)."""
import numpy as np
from scipy.integrate import quad
from scree_program import EXACT, Checks, Program, centres, norm

MU_S, MU_2, I_0 = 0.3819, 0.6435, 0.278  # glass beads
RHO, D, G = 2450.0, 1e-3, 9.81

program, checks = Program(), Checks("mu(I), glass beads, d 0.1 cm", "T21")


def inertial_number(mu):
    """I at which M is mu."""
    return I_0 * (mu - MU_S) / (MU_2 - mu) if mu > MU_S else 0.0


# ---- chute ----

NU, P, HALF = 0.6, 500.0, 0.02


def chute_velocity(x):
    """v(x) - v(wall), downwards."""
    rate = lambda s: inertial_number(RHO * NU * G * s / P) / (D * np.sqrt(RHO / P))
    plug = MU_S * P / (RHO * NU * G)
    return quad(rate, max(x, plug), HALF, epsabs=1e-13)[0]


checks.close("chute: reference, half width of the plug [cm]", MU_S * P / (RHO * NU * G) * 100, 1.32414, relative=1e-5)
checks.close("chute: reference, plug less wall [cm/s]", chute_velocity(0) * 100, 70.8410, relative=1e-6)
# The half cell at the wall has the shear rate of the wall, the greatest there is: it errs by h^2/8 times the slope of the
# shear rate, more than the midpoints of all other cells.
plug_errors, wall_errors = [], []
for cells in (10, 20, 40):
    last = program.run("inertial_chute.yaml", f"chute_{cells}", {
        **EXACT, "pc_factor_mat_solver_type": "petsc", "grid_cells": f"{cells}, 2"}).fields
    exact = np.array([chute_velocity(x) for x in centres(last["x_faces"])])
    error = -last["velocity_y_face"][0] - exact
    plug_errors.append(error[0] / exact[0])
    wall_errors.append(error[-1] / exact[0])
    checks.below(f"chute, {cells} cells: spread of nu", np.ptp(last["solids_fraction"]), 1e-6)
checks.below("chute, 40 cells: error of v less v of the cell at the wall, relative L2",
             norm(error - error[-1]) / exact[0], 2.5e-3)
# A cold scene with critical_state friction has no unknown that acts in its node: the solver that a run changes to must
# not need one.
chosen = program.run("inertial_chute.yaml", "chute_solver", {"grid_cells": "10, 2"}).fields
checks.close("chute, 10 cells: plug less wall with the solver of the program [cm/s]",
             -chosen["velocity_y_face"][0][0] * 100, (1 + plug_errors[0]) * 70.8410, relative=5e-3)  # errors of its steps
checks.order("chute: plug less wall, relative, on 10, 20, 40 cells", plug_errors, 2, 7e-3)
checks.order("chute: the cell at the wall, over the plug", wall_errors, 2, 9e-3)

# ---- consistent flow rule ----

NU, N = 0.55, 1.81481
P_C = 0.05 * (NU - 0.5) ** 2 / (0.65 - NU) ** 5
for z, published in ((0.1, 0.99339), (1, 0.97477), (3, 0.97552)):
    M = MU_S + (MU_2 - MU_S) * z / (1 + z)
    mean = MU_S + (MU_2 - MU_S) * (1 - np.log(1 + z) / z)
    w = (M - mean) / 2
    chi = (1 - w / (N * mean - (N - 1) * w)) ** (N - 1)
    checks.close(f"shear, I/I_0 {z}: reference, chi", chi, published, absolute=1e-5)
    rate = z * I_0 / D * np.sqrt(chi * P_C / RHO)
    run = program.run("inertial_shear.yaml", f"shear_{z}", {
        **EXACT, "initial_everywhere_velocity_gradient": f"0, {rate}, 0, 0", "boundary_lid_velocity": f"{0.02 * rate}, 0"})
    last = run.fields
    checks.close(f"shear, I/I_0 {z}: chi", last["frictional_pressure_ratio"].mean(), chi, relative=1e-4)
    checks.close(f"shear, I/I_0 {z}: frictional pressure [Pa]", last["frictional_pressure"].mean(), chi * P_C, relative=1e-4)
    checks.below(f"shear, I/I_0 {z}: spread of nu", np.ptp(last["solids_fraction"]), 1e-8)
checks.verdict()
