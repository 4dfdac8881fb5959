"""T2, shear stress: velocity profile of a layer whose shear stress the balance of momentum fixes; order in space."""
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres, norm

RHO, D, T, H, SIN_PHI = 2900.0, 1e-3, 1e-4, 0.02, np.sin(np.radians(28.5))
# nu: shear factor fmu, p_c [Pa] (tests/VERIFICATION.md, 1), pull [m/s2]: up to .9 of the yield stress for friction
CASES = {0.3: (0.618722687, 0.0, 0.02), 0.55: (7.20974569, 12.5, 0.15)}


def velocity(y, fmu, p_c, nu, g):
    """v(y) - v(H) by integration of the shear rate."""

    def shear_rate(y):
        stress = RHO * nu * g * y
        law = lambda s: fmu * RHO * D * np.sqrt(T) * s + p_c * SIN_PHI * s / np.sqrt(s * s + 2 * T / D**2) - stress
        return brentq(law, 0, 1e4, xtol=1e-14)

    return quad(shear_rate, y, H, epsabs=1e-13, epsrel=1e-12)[0]


program, checks = Program(), Checks("layer pulled along a wall, T 1 cm2/s2, d 0.1 cm, H 2 cm", "T2")
for nu, (fmu, p_c, g) in CASES.items():
    if p_c:  # the table has four digits
        p_c = 0.05 * (nu - 0.5) ** 2 / (0.65 - nu) ** 5
    errors = []
    for cells in (8, 16, 32):
        options = {**EXACT, "initial_everywhere_solids_fraction": nu, "gravity": f"{g}, 0", "grid_cells": f"2, {cells}"}
        last = program.run("shear_stress.yaml", f"nu_{nu}_{cells}", options).fields
        exact = np.array([velocity(y, fmu, p_c, nu, g) for y in centres(last["y_faces"])])
        found = last["velocity_x_face"][:, 0]
        errors.append(norm(found - exact) / exact[0])
        checks.below(f"nu {nu}, {cells} cells: spread of nu", np.ptp(last["solids_fraction"]), 1e-8)
    checks.order(f"nu {nu}: relative L2 error of v on 8, 16, 32 cells", errors, 2, 2e-3)
checks.verdict()
