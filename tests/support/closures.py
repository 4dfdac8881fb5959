"""The closures of the model (equation numbers of Srivastava and Sundaresan 2003) as plain functions of numbers or
arrays, written from the equations and not from the program, for reference solutions. SI units, their Table 2."""
import numpy as np

RHO_S, E_P, NU_MIN, NU_MAX, ALPHA = 2900.0, 0.91, 0.5, 0.65, 1.6
ETA = (1 + E_P) / 2
F, R, S = 0.05, 2, 5
SIN_PHI, TAN_DELTA = np.sin(np.radians(28.5)), np.tan(np.radians(12.3))
N_DILATION, N_COMPACTION = np.sqrt(3) / (2 * SIN_PHI), 1.03
SLIP_REGULARISATION = 3e-3  # v_e of v_sl/sqrt(v_sl^2 + v_e^2), for v_sl/|v_sl| in (25) [m/s]


def g0(nu):
    """Radial distribution at contact, (1.7)."""
    return 1 / (1 - np.cbrt(nu / NU_MAX))


# Without gas damping the closures of Table 1 are these factors, powers of T, and rho_s and d.


def pressure_factor(nu):
    """p_k/(rho_s T) of (1.1) without div v."""
    return nu * (1 + 4 * ETA * nu * g0(nu))


def shear_factor(nu):
    """mu_s/(rho_s d sqrt(T)), deviator of (1.1) = -2 mu_s S."""
    mu = 5 * np.sqrt(np.pi) / 96
    mu_b = 256 * mu * nu**2 * g0(nu) / (5 * np.pi)
    x = 8 / 5 * ETA * nu * g0(nu)
    return (2 + ALPHA) / 3 * (mu / (g0(nu) * ETA * (2 - ETA)) * (1 + x) * (1 + (3 * ETA - 2) * x) + 3 / 5 * ETA * mu_b)


def conductivity_factor(nu):
    """kappa/(rho_s d sqrt(T)), q = -kappa grad T, (1.3)."""
    k = 75 * np.sqrt(np.pi) / (48 * ETA * (41 - 33 * ETA))
    x = 12 / 5 * ETA * nu * g0(nu)
    return k / g0(nu) * ((1 + x) * (1 + ETA * (4 * ETA - 3) * x)
                         + 64 / (25 * np.pi) * (41 - 33 * ETA) * (ETA * nu * g0(nu)) ** 2)


def dissipation_factor(nu):
    """J_coll d/(rho_s T^1.5), (1.4)."""
    return 48 / np.sqrt(np.pi) * ETA * (1 - ETA) * nu**2 * g0(nu)


def critical_pressure(nu):
    """p_c, (18) [Pa]."""
    return F * np.maximum(nu - NU_MIN, 0) ** R / (NU_MAX - nu) ** S


def chi_star(div_v, strain_rate):
    """chi*, (21) and (24), at the strain rate sqrt(S:S + T/d^2)."""
    n = np.where(np.asarray(div_v) >= 0, N_DILATION, N_COMPACTION)
    return np.maximum(1 - div_v / (n * np.sqrt(2) * SIN_PHI * strain_rate), 0) ** (n - 1)


def frictional_shear(rate, p_f, T, d):
    """Shear stress of (20) at chi = 1 in plane shear at `rate`, where S:S = rate^2/2 [Pa]."""
    return p_f * SIN_PHI * rate / np.sqrt(rate**2 + 2 * T / d**2)


def wall_collisions(nu, T):
    """pi sqrt(3)/(6 nu_max) rho_s nu g0 sqrt(T), common to (25) and (26) [kg/(m2 s)]."""
    return np.pi * np.sqrt(3) / (6 * NU_MAX) * RHO_S * nu * g0(nu) * np.sqrt(T)


def wall_shear(nu, T, slip, p_f, specularity):
    """Shear stress that a wall passes on at the speed `slip`, (25) [Pa]."""
    coulomb = p_f * TAN_DELTA * slip / np.sqrt(slip**2 + SLIP_REGULARISATION**2)
    return coulomb + specularity * wall_collisions(nu, T) * slip


def wall_heat(nu, T, slip, specularity, e_w):
    """n.q, (26), n from the wall into the particles [W/m2]."""
    return wall_collisions(nu, T) * (specularity * slip**2 - 1.5 * (1 - e_w**2) * T)


def drag_at_rest(nu, d, mu_g=1.8e-5):
    """beta of (6), (7) at zero slip, where C_D |u - v| = 24 mu_g/(rho_g (1-nu) d) [kg/(m3 s)]."""
    return 18 * mu_g * nu * (1 - nu) ** -2.65 / d**2


#: nu: g0, shear, dissipation, conductivity, pressure factor, steady T/(d rate)^2 in simple shear
TABLE = {
    .1: (2.15439372, .110273759, .0250730554, .340396547, .182297840, 4.39810),
    .3: (4.40148381, .618722687, .461024286, 1.79631339, 1.81323013, 1.34206),
    .49: (11.1248000, 3.52699052, 3.10861228, 9.75601970, 10.6934663, 1.13459),
    .55: (18.4628960, 7.20974569, 6.49991069, 19.7653393, 21.8847995, 1.10921),
    .6: (37.9822148, 17.4033844, 15.9134731, 47.4253782, 52.8331419, 1.09363),
}
#: nu: p_c [dyn/cm2]
CRITICAL_PRESSURES = {.51: .9297, .52: 5.387, .55: 125.0, .58: 1904, .59: 5208, .60: 16000, .61: 5.908e4, .62: 2.963e5,
                      .63: 2.641e6}


def check_closures(checks):
    """The functions above against values computed apart from them."""
    worst = max(abs(f(nu) / value - 1) for nu, row in TABLE.items()
                for f, value in zip((g0, shear_factor, dissipation_factor, conductivity_factor, pressure_factor), row))
    checks.below("closures of the reference against the table: greatest difference, relative", worst, 1e-8)
    worst = max(abs(10 * critical_pressure(nu) / value - 1) for nu, value in CRITICAL_PRESSURES.items())
    checks.below("p_c of the reference against the table: greatest difference, relative", worst, 3e-4)
