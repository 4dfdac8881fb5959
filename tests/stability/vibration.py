"""H13: a bed thrown by a vibrating floor, without and with gas. With p_c as the only stress (T zero, no deviator) the floor's
force is p_c of the lowest cell: impulse is conserved over a throw and a landing, and in flight the centre of mass falls
freely, to the first order of the scheme in the step and the cell. Then the whole model, two periods."""
import numpy as np
from scree_program import COLUMN, EXACT, Checks, Program

RHO_S, RHO_G, G, A, F, NU_MIN, NU_MAX = 2900.0, 1.3, 9.81, 1.193e-3, 0.05, 0.5, 0.65
OMEGA = 2 * np.pi * 25
P_C_ALONE = {"friction_model": "critical_state", "friction_strain_rate_floor": 1e8, "granular_temperature": "constant",
             "granular_temperature_value": 0}
#: Cells, step [s]. Without gas momentum is kept in each step, and what is missing is what the half cell at the floor takes.
GRIDS = {False: ((100, 2e-4), (200, 1e-4), (400, 5e-5)), True: ((50, 2e-4), (100, 1e-4), (200, 5e-5))}


def p_c(nu):
    nu = np.maximum(nu, NU_MIN)
    return F * (nu - NU_MIN) ** 2 / (NU_MAX - nu) ** 5


def velocity_gained(t0, t1):
    """By free fall in the frame of the floor [m/s]."""
    return -G * (t1 - t0) + A * OMEGA * (np.cos(OMEGA * t0) - np.cos(OMEGA * t1))


def momentum(state, gas):
    """Of particles and gas over the mass of particles less that of the gas they displace [m/s]."""
    nu, dx = state["solids_fraction"], np.diff(state["x_faces"])
    face = 0.5 * (nu[1:] + nu[:-1])
    total = RHO_S * np.sum(face * state["velocity_x_face"][1:-1]) * dx[0]
    if gas:
        total += RHO_G * np.sum((1 - face) * state["gas_velocity_x_face"][1:-1]) * dx[0]
    return total / ((RHO_S - RHO_G * gas) * np.sum(nu * dx))


def centre_of_mass(state):
    x = 0.5 * (state["x_faces"][1:] + state["x_faces"][:-1])
    return np.sum(state["solids_fraction"] * x) / np.sum(state["solids_fraction"])


program, checks = Program(), Checks("bed on a vibrating floor", "H13")
for gas in (False, True):
    errors, flights, landings = [], [], []
    for cells, dt in GRIDS[gas]:
        name = f"{'gas' if gas else 'vacuum'}, {cells} cells, dt {1e6 * dt:g} us"
        options = {**EXACT, **COLUMN, "snes_rtol": 1e-8, "snes_atol": 1e-8, **P_C_ALONE, "gas": "incompressible" if gas else "none",
                   "grid_cells": cells, "probe_floor_point": 0.05 / cells, "time_step_initial": dt, "output_interval": 1e-3,
                   "end_time": 0.048}
        run = program.run("vibration.yaml", f"{'gas' if gas else 'vacuum'}_{dt:g}", options)
        monitor, states = run.monitor, run.all_fields()
        t, nu_floor = monitor["time"], monitor["floor_solids_fraction"]
        mass = np.sum(states[0]["solids_fraction"] * np.diff(states[0]["x_faces"])) * (RHO_S - RHO_G * gas)
        floor = p_c(nu_floor[1:]) + (monitor["floor_gas_pressure"][1:] if gas else 0)
        impulse = np.concatenate([[0], np.cumsum(floor * np.diff(t))]) / mass
        balance = [momentum(s, gas) - velocity_gained(0, s["time"]) - np.interp(s["time"], t, impulse) for s in states]
        errors.append(np.abs(balance).max() / (A * OMEGA))
        # the first throw: while the lowest cell bears nothing
        off = np.flatnonzero(nu_floor < NU_MIN)[0]
        on = off + np.flatnonzero(nu_floor[off:] > NU_MIN)[0]
        landings.append(np.interp(NU_MIN, nu_floor[on - 1:on + 1], t[on - 1:on + 1]))
        flight = [s for s in states if t[off] <= s["time"] <= t[on - 1]]
        checks.above(f"{name}: fields in the first flight", len(flight), 8)
        if not gas:
            # z'' = g + A omega^2 sin(omega t) in the frame of the floor: the lab's height falls freely
            lab = np.array([centre_of_mass(s) + A * np.sin(OMEGA * s["time"]) for s in flight])
            times = np.array([s["time"] for s in flight])
            fall = np.polyfit(times - times[0], lab, 2)[0] * 2
            flights.append(fall / -G - 1)
        checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
        checks.below(f"{name}: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), NU_MAX - 1e-3)
        checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-12)
        checks.equal(f"{name}: cut steps", monitor["rejected_solver"].sum(), 0)
        if gas:
            checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
            # no volume passes the floor, so none passes any plane: (1-nu) u = -nu v
            checks.below(f"{name}: greatest gas speed over that of the particles times nu_max/(1-nu_max)",
                         monitor["gas_speed_max"].max() / (monitor["speed_max"].max() * NU_MAX / (1 - NU_MAX)), 1)
    kind = "gas" if gas else "vacuum"
    checks.order(f"{kind}: impulse missing at any time, over that of the floor's greatest speed", errors, 1, 1e-2, slack=0.4)
    if not gas:
        checks.order("vacuum: acceleration of the centre of mass in flight over g, less 1", flights, 1, 3e-2)
    checks.below(f"{kind}: landing time, change to the last grid over the one before", abs(landings[2] - landings[1])
                 / abs(landings[1] - landings[0]), 1)
    whole = program.run("vibration.yaml", f"whole_{kind}", {"solver": "direct", **COLUMN, "gas": options["gas"]})
    checks.below(f"{kind}, whole model: mass error", np.abs(whole.monitor["mass_error"]).max(), 1e-12)
    checks.equal(f"{kind}, whole model: cut steps", whole.monitor["rejected_solver"].sum(), 0)
    if gas:
        checks.below("gas, whole model: gas volume error", np.abs(whole.monitor["gas_volume_error"]).max(), 1e-12)
    checks.hard_case("H13", f"bed on a vibrating floor, 3 g at 25 Hz, {kind}", whole,
                     measured=f"impulse missing {errors[-1]:.1e} A omega at dt 50 us, of first order; landing at "
                              f"{landings[-1]:.5f} s" + (f"; gas volume {np.abs(whole.monitor['gas_volume_error']).max():.0e}"
                                                         if gas else f"; fall in flight {1 + flights[-1]:.3f} g"),
                     bound="impulse conserved to the order of the scheme, no gas artefact, mass to 1e-12")
checks.verdict()
