"""T8, Couette flow between walls that obey (25) and (26): profiles of v, T and nu against a boundary value problem that
is solved by collocation, without friction (mean nu .3) and with it (mean nu .55)."""
import numpy as np
from closures import (RHO_S, check_closures, conductivity_factor, critical_pressure, dissipation_factor,
                      frictional_shear, pressure_factor, shear_factor, wall_heat, wall_shear)
from scipy.integrate import solve_bvp
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres, norm

D, HALF, U, SPECULARITY, E_W = 1e-3, 0.01, 0.1, 0.25, 0.91
T0, P0 = U**2 * D**2 / HALF**2, RHO_S * U**2  # scales of the boundary value problem


def solids_fraction(N, T):
    """nu at which kinetic and critical-state pressure make the normal stress N."""
    excess = lambda nu, t: pressure_factor(nu) * RHO_S * t + critical_pressure(nu) - N
    return np.array([brentq(excess, 1e-3, 0.6499, args=(t,), xtol=1e-15) for t in np.maximum(T, 1e-12)])


def shear_rate(tau, nu, T):
    """dv/dy at which kinetic and frictional shear stress, (20), make tau."""
    mu = shear_factor(nu) * RHO_S * D * np.sqrt(T)
    law = lambda rate, m, p, t: m * rate + frictional_shear(rate, p, t, D) - tau
    return np.array([brentq(law, -1e5, 1e5, args=each, xtol=1e-13)
                     for each in zip(mu, critical_pressure(nu), T)])


def reference(mean):
    """v, T and nu as functions of the distance y from the middle, N and tau. N and tau, the same everywhere, are
    unknown parameters; the unknowns are T, the heat flux q, v and the integral of nu, all scaled."""

    def slopes(y, z, parameters):
        T = np.maximum(z[0], 1e-6) * T0
        N, tau = np.abs(parameters) * P0
        nu = solids_fraction(N, T)
        rate = shear_rate(tau, nu, T)
        scale = RHO_S * D * np.sqrt(T)
        gain = shear_factor(nu) * scale * rate**2 - dissipation_factor(nu) * RHO_S * T**1.5 / D  # friction feeds no T
        q = z[1] * P0 * U
        gradient = -q / (conductivity_factor(nu) * scale)
        return np.array([gradient * HALF / T0, gain * HALF / (P0 * U), rate * HALF / U, nu])

    def sides(middle, wall, parameters):
        T = np.maximum(wall[:1], 1e-6) * T0
        N, tau = np.abs(parameters) * P0
        nu, slip = solids_fraction(N, T), U * (1 - wall[2])
        heat = wall_heat(nu, T, slip, SPECULARITY, E_W)[0] / (P0 * U)
        shear = wall_shear(nu, T, slip, critical_pressure(nu), SPECULARITY)[0] / P0
        return np.array([middle[1], middle[2], middle[3], wall[1] + heat, tau / P0 - shear, wall[3] - mean])

    y = np.linspace(0, 1, 41)
    rate, T = 0.8 * U / HALF, 0.8 * T0
    N = pressure_factor(mean) * RHO_S * T + critical_pressure(mean)
    tau = shear_factor(mean) * RHO_S * D * np.sqrt(T) * rate + frictional_shear(rate, critical_pressure(mean), T, D)
    guess = np.array([np.full_like(y, 0.8), 0 * y, 0.8 * y, mean * y])
    found = solve_bvp(slopes, sides, y, guess, p=[N / P0, tau / P0], tol=1e-9, max_nodes=20000)
    if not found.success:
        raise RuntimeError(found.message)
    N, tau = found.p * P0
    v = lambda y: np.sign(y) * found.sol(np.abs(y) / HALF)[2] * U
    T = lambda y: found.sol(np.abs(y) / HALF)[0] * T0
    return v, T, lambda y: solids_fraction(N, T(y)), N, tau


program, checks = Program(), Checks("Couette flow between Johnson-Jackson walls, +-10 cm/s, 2 cm apart, d 0.1 cm", "T8")
check_closures(checks)
CELLS = (16, 32, 64)
for mean in (0.3, 0.55):
    v, T, nu, N, tau = reference(mean)
    print(f"  mean nu {mean}, exact: N {10 * N:.6g} dyn/cm2, tau {10 * tau:.6g} dyn/cm2, from the middle to the wall: "
          f"T {T(0) * 1e4:.6g} to {T(HALF) * 1e4:.6g} cm2/s2, nu {nu([0])[0]:.6g} to {nu([HALF])[0]:.6g}, "
          f"slip {100 * (U - v(HALF)):.6g} cm/s")
    errors = {"v": [], "T": [], "nu": []}
    for cells in CELLS:
        name = f"mean nu {mean}, {cells} cells"
        options = {**EXACT, "grid_cells": f"2, {cells}", "initial_everywhere_solids_fraction": mean}
        last = program.run("johnson_jackson_couette.yaml", f"nu_{mean}_{cells}", options).fields
        y = centres(last["y_faces"]) - HALF
        found = {"v": last["velocity_x_face"], "T": last["granular_temperature"], "nu": last["solids_fraction"]}
        skew = 0.0
        for unknown, exact in (("v", v(y)), ("T", T(y)), ("nu", nu(y))):
            errors[unknown].append(norm(found[unknown] - exact[:, None]) / norm(exact))
            sign = -1 if unknown == "v" else 1
            skew = max(skew, np.abs(found[unknown] - sign * found[unknown][::-1]).max() / np.abs(exact).max())
        checks.below(f"{name}: v, T and nu mirrored against themselves, relative", skew, 1e-7)
        checks.close(f"{name}: mean nu", found["nu"].mean(), mean, absolute=1e-12)
    # By half the cells each error falls to less than 0.27 of itself; nu, whose mean is given, is the most exact.
    for unknown, most in (("v", 3e-3), ("T", 5e-3), ("nu", 2e-4)):
        orders = ", ".join(f"{np.log2(a / b):.3f}" for a, b in zip(errors[unknown], errors[unknown][1:]))
        checks.above(f"mean nu {mean}: order of {unknown} (L2) on 16, 32, 64 cells, errors "
                     + ", ".join(f"{e:.3e}" for e in errors[unknown]) + f", orders {orders}",
                     np.log2(errors[unknown][-2] / errors[unknown][-1]), 1.9)
        checks.below(f"mean nu {mean}: relative L2 error of {unknown} on 64 cells", errors[unknown][-1], most)
checks.verdict()
