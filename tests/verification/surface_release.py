"""T16, release of a compressed surface: a uniform bed throws its surface off, in a simple wave of p_c; a bed that
starts in equilibrium does not."""
import numpy as np
from closures import NU_MAX, NU_MIN, RHO_S, critical_pressure
from scipy.integrate import quad
from scree_program import COLUMN, DIRECT, EXACT, Checks, Program, centres

START, SURFACE, LENGTH, END = 0.6, 0.1, 0.12, 0.01
CELLS = (120, 240, 480)


def wave_speed(nu):
    """c = sqrt(p_c'/rho_s) [m/s]."""
    excess, room = nu - NU_MIN, NU_MAX - nu
    return np.sqrt(critical_pressure(nu) * (2 / np.maximum(excess, 1e-300) + 5 / room) / RHO_S)


def thrown(nu):
    """Velocity of the particles where the wave has brought them from the start to nu [m/s]."""
    return quad(lambda x: wave_speed(x) / x, nu, START, epsabs=1e-13)[0]


program, checks = Program(), Checks("surface of a bed of nu 0.6, p_c 1.6e4 dyn/cm2, released into a void", "T16")
SPEED = thrown(NU_MIN)
checks.close("reference speed of the surface [cm/s]", 100 * SPEED, 25.06, absolute=0.005)
checks.close("reference wave speed at nu 0.6 [cm/s]", 100 * wave_speed(START), 813.7, absolute=0.05)

# The wave is a function of (x - surface)/t = v - c; it has not reached the floor.
levels = NU_MIN + (START - NU_MIN) * np.linspace(0, 1, 2001) ** 2
speeds = np.array([thrown(nu) for nu in levels])
along = speeds - wave_speed(levels)

# The surface smears as a contact does, over the root of cell times way with upwind: order 1/2 at least. What is fast at
# the surface is what is thin there, v(.5) - v(nu) ~ (nu - .5)^(1/2).
for scheme in ("upwind", "van_albada"):
    errors = {"nu, L1": [], "v, L1": [], "surface speed": []}
    for cells in CELLS:
        dx = LENGTH / cells
        steps = int(np.ceil(END * wave_speed(START) / dx))  # the fastest wave passes a cell a step
        options = {**EXACT, **COLUMN, "advection": scheme, "grid_cells": cells, "time_step_initial": END / steps, "end_time": END}
        run = program.run("surface_release.yaml", f"{scheme}_{cells}", options)
        last = run.fields
        place, face = (centres(last["x_faces"]) - SURFACE) / END, (last["x_faces"] - SURFACE) / END
        nu = np.where(place < SPEED, np.interp(place, along[::-1], levels[::-1]), 0)
        v = np.interp(face, along[::-1], speeds[::-1], left=0)
        filled = face < SPEED
        errors["nu, L1"].append(np.sum(np.abs(last["solids_fraction"] - nu)) * dx / (START * SURFACE))
        errors["v, L1"].append(np.sum(np.abs(last["velocity_x_face"] - v)[filled]) * dx / (SPEED * SURFACE))
        fastest = run.monitor["speed_max"].max()
        errors["surface speed"].append(1 - fastest / SPEED)
        name = f"{scheme}, {cells} cells"
        checks.below(f"{name}: greatest speed ever, over that of the surface", fastest / SPEED, 1)
        checks.below(f"{name}: greatest nu ever, less that at the start",
                     run.monitor["solids_fraction_max"].max() - START, 1e-9)
        checks.above(f"{name}: least nu ever", run.monitor["solids_fraction_min"].min(), -1e-12)
        checks.below(f"{name}: mass error over mass",
                     np.abs(run.monitor["mass_error"]).max() / run.monitor["mass"][0], 1e-14)
    for quantity, found in errors.items():
        orders = [np.log2(a / b) for a, b in zip(found, found[1:])]
        checks.above(f"{scheme}: order of the relative error of {quantity} on 120, 240, 480 cells, errors "
                     + ", ".join(f"{e:.3e}" for e in found) + ", orders " + ", ".join(f"{p:.3f}" for p in orders),
                     orders[-1], 0.5)
    checks.close(f"{scheme}, 480 cells: speed of the surface [cm/s]", 100 * fastest, 100 * SPEED, relative=2e-2)

# Under gravity: thrown off from the uniform start, as the paper's bin is; nothing moves from equilibrium.
for profile in ("uniform", "equilibrium"):
    options = {**DIRECT, **COLUMN, "gravity": -9.81, "initial_fill_profile": profile, "initial_fill_surface": "10 cm",
               "time_step_initial": 2e-5, "end_time": 2e-3, "solids_fraction_floor": 1e-5}
    if profile == "uniform":
        del options["initial_fill_surface"]
    run = program.run("surface_release.yaml", f"gravity_{profile}", options)
    fastest = run.monitor["speed_max"].max()
    if profile == "uniform":
        checks.above("uniform start under gravity: greatest speed [cm/s]", 100 * fastest, 20)
    else:
        checks.below("equilibrium start under gravity: greatest speed [m/s]", fastest, 1e-9)
checks.verdict()
