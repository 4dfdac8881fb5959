"""T1, particles at rest that lose their fluctuations by collisions, with gas by drag too: the exact T(t) at nu 0.3."""
import numpy as np
from closures import RHO_S, dissipation_factor, drag_at_rest

NU, T0 = 0.3, 1e-4


def temperature(t, d, gas=False):
    """T of (3/2) rho_s nu T' = -J_coll - 3 beta T; sqrt(T) obeys a Bernoulli equation."""
    a, s = 2 / 3 * dissipation_factor(NU) / (NU * d), np.sqrt(T0)
    if not gas:
        return T0 / (1 + a * s * t / 2) ** 2
    b = 2 * drag_at_rest(NU, d) / (RHO_S * NU)
    return (b * s / ((b + a * s) * np.exp(b * t / 2) - a * s)) ** 2
