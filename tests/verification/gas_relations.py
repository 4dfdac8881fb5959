"""Drag of the gas (Wen-Yu) and what rests or settles on it, SI units, independent of the program. Particles of
2.9 g/cm3 in air, as in the cases of this folder."""
import numpy as np
from scipy.optimize import brentq

RHO_S, RHO_G, MU_G, G = 2900.0, 1.3, 1.8e-5, 9.81
BUOYANT = (RHO_S - RHO_G) * G  # weight in gas of a unit volume of particles [N/m3]


def drag(nu, w, d, mu=MU_G):
    """beta at slip w, Re < 950 [kg/(m3 s)]."""
    Re = RHO_G * (1 - nu) * d * abs(w) / mu
    return 18 * mu * nu / d**2 * (1 - nu) ** -2.65 * (1 + 0.15 * Re**0.687)


def pressure_gradient(nu, w, d, mu=MU_G):
    """-dp_g/dx of gas that passes particles in steady flow [Pa/m]."""
    return drag(nu, w, d, mu) * w / (1 - nu)


def settling_slip(nu, d, mu=MU_G):
    """Slip at which drag carries the particles [m/s]."""
    return brentq(lambda w: pressure_gradient(nu, w, d, mu) / nu - BUOYANT, 1e-9, 30, xtol=1e-15, rtol=1e-14)


def fluidising_flow(nu, d):
    """Superficial velocity that carries a bed [m/s]."""
    return (1 - nu) * settling_slip(nu, d)


def critical_pressure(nu):
    """p_c(nu) [Pa]."""
    excess = np.maximum(nu - 0.5, 0)
    return 0.05 * excess**2 / (0.65 - nu) ** 5


def check_balances(checks, name, run, gas="incompressible"):
    """What every run with gas has to keep. Gas with inertia is projected; darcy's volume is as good as Newton's tolerance."""
    bound = 1e-12 if gas == "incompressible" else 1e-9
    checks.below(f"{name}: gas volume error", np.abs(run.monitor["gas_volume_error"]).max(), bound)
    checks.below(f"{name}: mass error", np.abs(run.monitor["mass_error"]).max(), 1e-12)
