"""T12, batch sedimentation: speed of the upper interface, the fan below a dense layer."""
import numpy as np
from gas_relations import BUOYANT, check_balances
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres

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


program, checks = Program(), Checks("batch sedimentation in a closed vessel")
checks.close("reference nu above which fans replace shocks", 2 / 5.65, .354, absolute=1e-3)

for nu0, gas in ((.2, "darcy"), (.4, "incompressible")):
    name = f"nu {nu0}, {gas}"
    end = 800 if nu0 == .2 else 1200
    options = {**EXACT, "gas": gas, "initial_everywhere_solids_fraction": nu0, "end_time": end,
               "output_interval": end / 4, "void_fraction_floor": 1e-9}
    run = program.run("batch_sedimentation.yaml", f"{gas}_{nu0}", options)
    states = run.all_fields()[1:]
    times = np.array([state["time"] for state in states])
    x = centres(states[0]["x_faces"])
    # Between the middle of the suspension and the lid all particles are below the interface: their volume tells its place.
    column = x > 0.04
    tops = [0.04 + np.sum(state["solids_fraction"][column]) * DX / nu0 for state in states[:-1]]
    checks.close(f"{name}: speed of the upper interface over terminal",
                 -np.polyfit(times[:-1], tops, 1)[0] / TERMINAL, (1 - nu0) ** 4.65, relative=1e-3)
    check_balances(checks, name, run, gas)

# A dense layer above clear gas: the particles rain from it in a fan, nu falls with depth as slope(nu) = depth/time.
DENSE, UNDER, END = .45, .05, 300
thin = touching(DENSE)
options = {"solver": "direct", "accuracy": 1e-3, "advection": "van_albada", "grid_cells": 400,
           "initial_everywhere_solids_fraction": 0, "initial_layer_order": 1, "initial_layer_box": f"{UNDER}, {LENGTH}",
           "initial_layer_solids_fraction": DENSE, "end_time": END, "time_step_initial": 1}
run = program.run("batch_sedimentation.yaml", "fan", options)
x = centres(run.fields["x_faces"])
below = x < 0.08
nu, x = run.fields["solids_fraction"][below], x[below]
# from the fan to half of the shock
for level, speed in [*((level, slope(level)) for level in (.05, .1, .15, .2)), (0.5 * (thin + DENSE), slope(thin))]:
    checks.close(f"below a layer of nu {DENSE}: fall of nu {level:.4g} over time and terminal speed",
                 (UNDER - np.interp(level, nu, x)) / END / TERMINAL, speed / TERMINAL, absolute=1e-2)
check_balances(checks, f"below a layer of nu {DENSE}", run)

checks.verdict()
