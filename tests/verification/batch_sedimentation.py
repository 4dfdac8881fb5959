"""T12, batch sedimentation: speed of the upper interface, the fan below a dense layer, the sediment at rest."""
import numpy as np
from gas_relations import BUOYANT, check_balances, critical_pressure
from scipy.optimize import brentq
from scree_program import COLUMN, DIRECT, EXACT, Checks, Program, centres

TERMINAL = BUOYANT * 1e-8 / (18 * 0.1)  # [m/s]
LENGTH, CELLS = 0.1, 200
DX = LENGTH / CELLS


def flux(nu):
    """Downward, of particles [m/s]."""
    return TERMINAL * nu * (1 - nu) ** 4.65


def slope(nu):
    return TERMINAL * (1 - nu) ** 3.65 * (1 - 5.65 * nu)


def touching(nu0):
    """The nu between which and nu0 > 0.354 a shock moves as fast as the fan of all thinner suspension begins."""
    return brentq(lambda nu: (flux(nu) - flux(nu0)) / (nu - nu0) - slope(nu), 0.01, 0.353)


program, checks = Program(), Checks("batch sedimentation in a closed vessel", "T12")
checks.close("reference nu above which fans replace shocks", 2 / 5.65, .354, absolute=1e-3)

for nu0, gas in ((.2, "incompressible"), (.2, "darcy"), (.4, "incompressible")):
    name = f"nu {nu0}, {gas}"
    end = 800 if nu0 == .2 else 1200
    options = {**EXACT, **COLUMN, "gas": gas, "initial_everywhere_solids_fraction": nu0, "end_time": end,
               "output_interval": end / 4, "solids_fraction_floor": 1e-9}
    run = program.run("batch_sedimentation.yaml", f"{gas}_{nu0}", options)
    states = run.all_fields()[1:]
    times = np.array([state["time"] for state in states])
    x = centres(states[0]["x_faces"])
    # Between the middle of the suspension and the lid all particles are below the interface: their volume tells its place.
    column = x > 0.04
    tops = [0.04 + np.sum(state["solids_fraction"][column]) * DX / nu0 for state in states[:-1]]
    checks.close(f"{name}: speed of the upper interface over terminal",
                 -np.polyfit(times[:-1], tops, 1)[0] / TERMINAL, (1 - nu0) ** 4.65, relative=1e-3)
    near = int(np.argmin(np.abs(x - 0.06)))
    u = states[0]["velocity_x_face"][near]
    checks.close(f"{name}: speed in the suspension over terminal", -u / TERMINAL, (1 - nu0) ** 4.65, relative=1e-4)
    check_balances(checks, name, run, gas)

# A dense layer above clear gas: the particles rain from it in a fan, nu falls with depth as slope(nu) = depth/time.
DENSE, UNDER, END = .45, .05, 300
thin = touching(DENSE)
options = {"solver": "direct", **COLUMN, "accuracy": 1e-3, "advection": "van_albada",
           "initial_everywhere_solids_fraction": 0, "initial_layer_order": 1, "initial_layer_box": f"{UNDER}, {LENGTH}",
           "initial_layer_solids_fraction": DENSE, "end_time": END}
fall = np.linspace(0, thin, 2001)  # nu from the front of the fan to its shock
errors = []
for cells in (100, 200, 400):
    run = program.run("batch_sedimentation.yaml", f"fan_{cells}",
                      {**options, "grid_cells": cells, "time_step_initial": 400 / cells})
    x = centres(run.fields["x_faces"])
    below = x < 0.08
    nu, x = run.fields["solids_fraction"][below], x[below]
    way = (UNDER - x) / END / TERMINAL  # 1 where the first particle is, slope(thin)/TERMINAL at the shock
    exact = np.where(way * TERMINAL > slope(thin), np.interp(-way * TERMINAL, -slope(fall), fall), DENSE)
    errors.append(np.sum(np.abs(nu - exact)) / np.sum(exact))
# The kink at the front and the shock, over a few cells whatever their size: of first order at best.
checks.above(f"below a layer of nu {DENSE}: order of nu (L1) on 100, 200, 400 cells, errors "
             + ", ".join(f"{e:.3e}" for e in errors), np.log2(errors[-2] / errors[-1]), 0.7)
# from the fan to half of the shock
for level, speed in [*((level, slope(level)) for level in (.05, .1, .15, .2)), (0.5 * (thin + DENSE), slope(thin))]:
    checks.close(f"below a layer of nu {DENSE}: fall of nu {level:.4g} over time and terminal speed",
                 (UNDER - np.interp(level, nu, x)) / END / TERMINAL, speed / TERMINAL, absolute=1e-2)
check_balances(checks, f"below a layer of nu {DENSE}", run)

# The sediment packs until p_c carries it all, by the weight of rho_s - rho_g.
for gas in ("darcy",):  # incompressible may take 1e5 steps to the same end: the step sticks at .1 s
    options = {**DIRECT, **COLUMN, "gas": gas, "initial_everywhere_solids_fraction": .3, "grid_cells": 100, "gas_viscosity": 1e-3,
               "time_step_adaptive": "yes", "time_step_initial": 1e-3, "time_step_max": 100, "end_time": 1e4,
               "output_interval": 0}
    run = program.run("batch_sedimentation.yaml", f"sediment_{gas}", options, timeout=240)
    nu, dx = run.fields["solids_fraction"], LENGTH / 100
    weight = BUOYANT * (np.cumsum((nu * dx)[::-1])[::-1] - 0.5 * nu * dx)
    # The face between the last, partly filled cell and the void falls for ever, see column_at_rest.py: gas carries it.
    bed = weight > 200
    checks.above(f"sediment, {gas}: cells in it", bed.sum(), 30)
    layers = -np.diff(critical_pressure(nu[bed])) / dx / (0.5 * (nu[bed][1:] + nu[bed][:-1]) * BUOYANT)
    checks.below(f"sediment, {gas}: rise of p_c over the weight of a layer, less 1", np.abs(layers - 1).max(), 1e-5)
    checks.close(f"sediment, {gas}: p_c in the lowest cell over the weight above", critical_pressure(nu[0]) / weight[0], 1,
                 absolute=1e-2)
    checks.below(f"sediment, {gas}: greatest p_g gradient there over the weight",
                 np.abs(np.diff(run.fields["gas_pressure"][bed])).max() / dx / BUOYANT, 1e-6)
    check_balances(checks, f"sediment, {gas}", run, gas)
checks.verdict()
