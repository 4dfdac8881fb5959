"""T9, T17: gas through particles held fast: pressure gradient, and granular temperature by its slip."""
import numpy as np
from gas_relations import MU_G, RHO_S, check_balances, drag, pressure_gradient
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres

GRADIENTS = {1: 91.602, 5: 513.627, 10: 1128.67, 22: 2906.40}  # U [cm/s]: [dyn/cm3]
TEMPERATURES = [(.3, 1e-4, .2, .207491), (.3, 4e-4, 1.0, .325318)]  # nu, d [m], w [m/s], T [cm2/s2]
F_J = .461024286  # of collisions at nu = .3, J_coll = F_J rho_s T^1.5/d
G_0 = 4.40148381  # at nu = .3
LIMIT = 1e-5  # 1/sqrt(T) of the agitation by slip is taken as 1/(sqrt(T) + LIMIT) [m/s]


def temperature(nu, d, w, limit):
    """Steady T of (9) for uniform particles at rest."""

    def gain(s):
        agitation = 81 * nu * MU_G**2 * w**2 / (G_0 * d**3 * RHO_S * np.sqrt(np.pi) * (s + limit))
        return agitation - F_J * RHO_S * s**3 / d - 3 * drag(nu, w, d) * s**2

    return brentq(gain, 1e-6, 1, xtol=1e-15) ** 2


program, checks = Program(), Checks("gas through particles held fast", "T9", "T17")
for U, gradient in GRADIENTS.items():
    exact = pressure_gradient(.6, U / 40, 4e-4)
    checks.close(f"reference U {U} cm/s: gradient [dyn/cm3]", exact / 10, gradient, relative=1e-5)
    for gas in ("incompressible", "darcy"):
        name = f"U {U} cm/s, {gas}"
        # what the drag of voids adds at nu = .6 has to be nothing for darcy
        options = {**EXACT, "gas": gas, "boundary_floor_gas_velocity": U / 100}
        if gas == "darcy":
            options["gas_darcy_solids_fraction"] = 1e-6
        run = program.run("fixed_bed.yaml", f"{gas}_{U}", options)
        p, x = run.fields["gas_pressure"], centres(run.fields["x_faces"])
        found = np.append(-np.diff(p) / np.diff(x), p[-1] / (0.1 - x[-1]))
        checks.below(f"{name}: greatest error of the gradient, relative", np.abs(found / exact - 1).max(), 1e-6)
        check_balances(checks, name, run, gas)

for nu, d, w, table in TEMPERATURES:
    checks.close(f"reference nu {nu}, d {d} m, w {w} m/s: T without limit [cm2/s2]", temperature(nu, d, w, 0) * 1e4, table,
                 relative=1e-5)
    exact = temperature(nu, d, w, LIMIT)
    for gas in ("incompressible", "darcy"):
        for factor in (1e-2, 1e2) if gas == "incompressible" else (1e2,):
            name = f"nu {nu}, d {d} m, w {w} m/s, {gas}, from {factor:g} T"
            options = {**EXACT, "gas": gas, "granular_temperature": "transport", "particle_diameter": d,
                       "initial_everywhere_solids_fraction": nu, "boundary_floor_gas_velocity": w * (1 - nu),
                       "initial_everywhere_granular_temperature": factor * exact, "end_time": 5}
            if gas == "darcy":
                options["gas_darcy_solids_fraction"] = 1e-6
            run = program.run("fixed_bed.yaml", f"T_{gas}_{d}_{factor}", options)
            T = run.fields["granular_temperature"]
            checks.close(f"{name}: T at the end", T.mean(), exact, relative=1e-5)
            checks.below(f"{name}: spread of T, relative", np.ptp(T) / exact, 1e-5)
            checks.close(f"{name}: T against the table [cm2/s2]", T.mean() * 1e4, table, relative=1e-2)
            check_balances(checks, name, run, gas)
checks.verdict()
