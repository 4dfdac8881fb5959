"""H2: rain onto a floor. The shock obeys T15 whatever share of a cell it passes in a step, nu stays below nu_max by the
stiffness of p_c and not by clipping, and mass is kept. Then the whole model, whose stress is not p_c alone, on the balance
of volume at the shock; and the largest step of either."""
import numpy as np
from scipy.optimize import brentq
from scree_program import EXACT, Checks, Program, centres
from steps import largest_step

RHO_S, NU1, V, F, NU_MIN, NU_MAX = 2900.0, 0.3, 2.0, 0.05, 0.5, 0.65
LENGTH, CELLS, END = 0.12, 60, 0.04
DX = LENGTH / CELLS
TIGHT = {**EXACT, "snes_atol": 1e-9}
WHOLE = {"friction_model": "relaxed", "friction_strain_rate_floor": 1e-4, "granular_temperature": "transport",
         "initial_everywhere_granular_temperature": 1e-4, "boundary_rain_granular_temperature": 1e-4}


def p_c(nu):
    return F * (nu - NU_MIN) ** 2 / (NU_MAX - nu) ** 5


def p_c_slope(nu):
    return p_c(nu) * (2 / (nu - NU_MIN) + 5 / (NU_MAX - nu))


NU2 = brentq(lambda nu: p_c(nu) - RHO_S * NU1 * V**2 * nu / (nu - NU1), NU_MIN + 1e-6, NU_MAX - 1e-6, xtol=1e-15)
U_S = NU1 * V / (NU2 - NU1)
OUTPUT = 5 * DX / U_S  # the front is at the same place in its cell at each output


def front(fields):
    """Where nu falls through the middle of the jump [m]."""
    x, nu = centres(fields["x_faces"]), fields["solids_fraction"]
    middle = 0.5 * (NU1 + NU2)
    last = np.flatnonzero(nu > middle)[-1]
    return x[last] + (nu[last] - middle) / (nu[last] - nu[last + 1]) * DX


def shock(run):
    """{nu behind the shock, between 2 cm above the floor and 2 cm below the front; speed of the front [m/s]}"""
    states = [state for state in run.all_fields()[1:] if front(state) > 0.02]
    places = [front(state) for state in states]
    x = centres(states[-1]["x_faces"])
    behind = (x > 0.02) & (x < places[-1] - 0.02)
    speed = np.polyfit([state["time"] for state in states], places, 1)[0]
    return states[-1]["solids_fraction"][behind].mean(), speed


def bounded(run):
    monitor = run.monitor
    return monitor["solids_fraction_max"].max() < NU_MAX and np.abs(monitor["mass_error"]).max() < 1e-12


program, checks = Program(), Checks("rain of nu = 0.3 at 200 cm/s onto a floor", "H2")
# The share of a cell that the shock passes in a step; below .2 what bounces behind it is no longer damped by the step.
for courant in (0.5, 0.25):
    name = f"Courant {courant}"
    options = {**TIGHT, "time_step_initial": courant * DX / U_S, "output_interval": OUTPUT}
    run = program.run("rain.yaml", f"shock_{courant}", options)
    nu2, speed = shock(run)
    error = abs(nu2 - NU2)
    monitor = run.monitor
    checks.below(f"{name}: greatest nu ever, below nu_max = 0.65", monitor["solids_fraction_max"].max(), NU_MAX - 1e-3)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), NU1 - 1e-9)
    checks.below(f"{name}: mass error, greatest ever", np.abs(monitor["mass_error"]).max(), 1e-12)
    # kinematic: volume swept by the front against what rains; its place is by interpolation within a cell
    checks.close(f"{name}: U_s (nu2 - nu1)/(nu1 V) with nu2 as found", speed * (nu2 - NU1) / (NU1 * V), 1, absolute=3e-3)
    checks.equal(f"{name}: cut steps", monitor["rejected_solver"].sum(), 0)
    checks.close(f"{name}: nu2", nu2, NU2, absolute=1e-4)
checks.close("U_s [m/s]", speed, U_S, relative=2e-3)
checks.close("p_c(nu2) over rho_s nu1 V^2 nu2/(nu2 - nu1), nu2 as found", p_c(nu2) / (RHO_S * NU1 * V**2 * nu2 / (nu2 - NU1)), 1,
             absolute=1.1 * p_c_slope(NU2) / p_c(NU2) * error + 1e-3)

whole = program.run("rain.yaml", "whole_model", {**TIGHT, **WHOLE, "time_step_initial": 0.25 * DX / U_S, "output_interval": OUTPUT})
nu2_whole, speed_whole = shock(whole)
checks.close("whole model: U_s (nu2 - nu1)/(nu1 V)", speed_whole * (nu2_whole - NU1) / (NU1 * V), 1, absolute=1e-2)
checks.true("whole model: nu below nu_max, mass error below 1e-12", bounded(whole))

STEPS = [courant * DX / U_S for courant in (1, 2, 4, 8, 16, 32)]
dt, run = largest_step(program, "rain.yaml", "largest", {"solver": "direct"}, STEPS, bounded)
checks.true("a step of the time in which the shock passes a cell works", dt, "it does not")
wave = np.sqrt(p_c_slope(NU2) / RHO_S)
if dt:
    checks.hard_case("H2", "rain, nu 0.3 at 200 cm/s, onto a floor", run,
                     measured=f"nu2 {nu2:.6f}, U_s {100 * speed:0.1f} cm/s at Courant 0.25, greatest nu "
                              f"{run.monitor['solids_fraction_max'].max():.4f} at the largest step, which is "
                              f"{dt / (DX / U_S):.0f} cells of the shock",
                     bound=f"T15: nu2 {NU2:.6f}, U_s {100 * U_S:.1f} cm/s; nu < 0.65 without clipping; mass to 1e-12",
                     without=f"an explicit step is bounded by the wave behind the shock: dx/c = {DX / wave:.1e} s")
checks.verdict()
