"""T10, minimum fluidisation: beds below and above it settle on p_s' = -nu (rho_s - rho_g) g - dp_g/dx."""
import numpy as np
from gas_relations import BUOYANT, check_balances, critical_pressure, fluidising_flow, pressure_gradient
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scree_program import DIRECT, Checks, Program, centres

D = 4e-4
TABLE = [(.55, D, 22.268), (.58, D, 17.144), (.60, D, 14.200), (.58, 1e-4, 1.505)]  # nu, d, U [cm/s]


def solids_fraction(pressure):
    """Of p_c = pressure."""
    return brentq(lambda nu: critical_pressure(nu) - pressure, .5, .6499, xtol=1e-14)


def bed(mass, U):
    """{height, p_c on the floor, p_g on the floor, nu on the floor} of a bed of nu integrated over its height = mass [m]."""

    def slopes(_, y):
        nu = solids_fraction(max(y[0], 0))
        carried = pressure_gradient(nu, U / (1 - nu), D)
        return [(nu * BUOYANT - carried) / nu, carried / nu, 1 / nu]  # by the mass above

    y = solve_ivp(slopes, (0, mass), [0, 0, 0], rtol=1e-9, atol=1e-10, method="LSODA").y[:, -1]
    return y[2], y[0], y[1], solids_fraction(y[0])


program, checks = Program(), Checks("bed of 10 cm that gas passes from below, d 0.04 cm", "T10")
for nu, d, U in TABLE:
    checks.close(f"reference U at nu {nu}, d {d} m [cm/s]", fluidising_flow(nu, d) * 100, U, absolute=1e-3)
uniform = brentq(lambda nu: fluidising_flow(nu, D) - .22, .5, .6)
checks.close("reference nu at U 22 cm/s", uniform, .551452, absolute=1e-6)

# Particles held fast, at these flows: the gas carries them.
for nu, d, U in TABLE:
    options = {**DIRECT, "particle_diameter": d, "initial_everywhere_solids_fraction": nu,
               "boundary_floor_gas_velocity": fluidising_flow(nu, d)}
    run = program.run("fixed_bed.yaml", f"held_{nu}_{d}", options)
    p, x = run.fields["gas_pressure"], centres(run.fields["x_faces"])
    checks.close(f"nu {nu}, d {d} m held fast, U {U} cm/s: p_g gradient over the weight",
                 (p[0] - p[-1]) / (x[-1] - x[0]) / (nu * BUOYANT), 1, absolute=1e-6)

FLOWS = ((0.22, "incompressible"), (0.22, "darcy"))
FURTHER_FLOWS = ((0.10, "incompressible"), (0.14, "incompressible"), (0.20, "incompressible"))
for U, gas in FLOWS + FURTHER_FLOWS:
    name = f"U {U * 100:g} cm/s, {gas}"
    run = program.run("fluidised_bed.yaml", f"{gas}_{U}", {**DIRECT, "gas": gas, "boundary_floor_gas_velocity": U})
    last, dx = run.fields, 1e-3
    nu, p = last["solids_fraction"], last["gas_pressure"]
    mass = np.sum(nu) * dx
    height, p_c, p_g, nu_floor = bed(mass, U)
    bulk = centres(last["x_faces"]) < 0.095
    checks.below(f"{name}: speed in the bed at the end [m/s]", np.abs(last["velocity_x_face"][1:-1][bulk[1:]]).max(), 1e-5)
    checks.close(f"{name}: nu on the floor", nu[0] + 0.5 * (nu[0] - nu[1]), nu_floor, absolute=1e-4)
    # of first order by the last, partly filled cell
    checks.close(f"{name}: height of the bed [m]", run.monitor["bed_height"][-1], height, absolute=1e-3)
    weight = BUOYANT * (mass - 0.5 * nu[0] * dx)  # above the centre of the first cell
    checks.close(f"{name}: what gas and p_c carry, over the weight", (p[0] + critical_pressure(nu[0])) / weight, 1,
                 absolute=1e-4)
    checks.close(f"{name}: p_g drop over the weight", p[0] / weight, p_g / (BUOYANT * mass), absolute=2e-3)
    # each layer, a centimetre below the surface
    deep = centres(last["x_faces"]) < 0.09
    middle = 0.5 * (nu[1:] + nu[:-1])
    layers = -np.diff(critical_pressure(nu)) / dx - (middle * BUOYANT - pressure_gradient(middle, U / (1 - middle), D))
    checks.below(f"{name}: unbalanced force of a layer, over its weight", np.abs(layers[deep[1:]]).max() / BUOYANT, 1e-4)
    if U == 0.22:
        half = centres(last["x_faces"]) < 0.05
        checks.below(f"{name}: nu in the lower half against {uniform:.6f}", np.abs(nu[half] - uniform).max(), 2e-5)
        if gas == "incompressible":
            slip = (last["gas_velocity_x_face"] - last["velocity_x_face"])[1:50]
            checks.below(f"{name}: slip in the lower half, relative error", np.abs(slip * (1 - uniform) / U - 1).max(), 1e-4)
    check_balances(checks, name, run, gas)
checks.verdict()
