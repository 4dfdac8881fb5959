"""T22: growth of short waves about plane shear, from the program's Jacobian (growth_rates), against theory: without
change of volume in closed form, with p_c(nu) as a matrix of three unknowns; and which laws are well-posed."""
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import brentq
from scree_program import Checks, Program

MU_S, MU_2, I_0 = 0.3819, 0.6435, 0.278  # glass beads
NU = 0.6


def taken(option):
    """The value of an option that Program does not know, off the command line."""
    place = sys.argv.index(option)
    value = sys.argv[place + 1]
    del sys.argv[place:place + 2]
    return value


tool = Path(taken("--growth"))
program, checks = Program(), Checks("short waves, by law of friction", "T22")
import growth_rates  # noqa: E402  of scripts/, which scree_program has put on the path

HERE = Path(__file__).resolve().parent


class Mu:
    """mu(I): its value, and q = I mu'/mu."""

    name = "mu_i"
    options = {"friction_coefficient": "mu_i"}

    @staticmethod
    def value(I):
        return MU_S + (MU_2 - MU_S) * I / (I + I_0)

    @classmethod
    def slope(cls, I):
        return (MU_2 - MU_S) * I * I_0 / (I + I_0) ** 2 / cls.value(I)


class Regularised:
    """M of Barker & Gray (2017), J. Fluid Mech. 828, 5: well-posed from rest up to some I."""

    name = "mu_i_regularised"
    options = {"friction_coefficient": "mu_i_regularised"}
    alpha, mu_infinity = 1.9, 0.05

    @classmethod
    def fast(cls, I):
        return (MU_S * I_0 + MU_2 * I + cls.mu_infinity * I * I) / (I_0 + I)

    @classmethod
    def log_ratio(cls, I):
        """ln(A/I), with A such that both forms meet."""
        return cls.alpha / cls.fast(slowest) ** 2 - np.log(I / slowest)

    @classmethod
    def value(cls, I):
        return np.sqrt(cls.alpha / cls.log_ratio(I)) if I < slowest else cls.fast(I)

    @classmethod
    def slope(cls, I):
        if I < slowest:
            return 0.5 / cls.log_ratio(I)
        return I * (MU_2 + 2 * cls.mu_infinity * I - cls.fast(I)) / (I_0 + I) / cls.fast(I)


class Coulomb:
    name = "constant"
    options = {"friction_coefficient": "constant"}
    value = staticmethod(lambda I: MU_S)
    slope = staticmethod(lambda I: 0.0)


# ---- without change of volume ----


def incompressible_growth(law, I):
    """Greatest growth rate over the viscous rate mu p k^2/(gdot rho_s nu). A wave at the angle with cosine c between
    twice its direction and that of compression grows by (1-q) (1-c^2)/(1 - m c) - 1, m = mu (1 - q/2): the greatest is
    at c = (1 - sqrt(1-m^2))/m. It is positive where C = 4 q^2 - 4 q + m^2 is, Barker, Schaeffer, Bohorquez & Gray (2015),
    J. Fluid Mech. 779, 794, as long as q < 1/2; Schaeffer (1987) for q = 0. With m >= 1 it is infinite."""
    q = law.slope(I)
    m = law.value(I) * (1 - q / 2)
    if m >= 1:
        return np.inf
    return 2 * (1 - q) * (1 - np.sqrt(1 - m * m)) / (m * m) - 1


def measured_growth(law, numbers):
    """The same by the program. Waves are so short that their viscous rate is 1e5 times the rate of shear."""
    states = [(NU, I, 0.0, 300 * I) for I in numbers]
    rows = growth_rates.rates(tool, HERE / "incompressible.yaml", law.options, states)
    return [row["growth"] / row["strain_rate"] * NU * (row["I"] / row["k_d"]) ** 2 / law.value(row["I"]) for row in rows]


def check_incompressible(law, numbers):
    for I, growth in zip(numbers, measured_growth(law, numbers)):
        expected = incompressible_growth(law, I)
        # the base flow turns a wave at the rate of shear: 1e-5 of the viscous rate; differences err by (k h)^2/12 = 3e-5
        # of each of the terms that cancel
        if np.isfinite(expected):
            checks.close(f"no change of volume, {law.name}, I {I:.4g}: growth over viscous rate", growth, expected,
                         absolute=1e-4)
        checks.true(f"no change of volume, {law.name}, I {I:.4g}: grows where theory says so", (growth > 0) == (expected > 0))


def ill_posedness(I, law):
    """C of Barker et al. (2015)."""
    q = law.slope(I)
    return 4 * q * q - 4 * q + (law.value(I) * (1 - q / 2)) ** 2


slowest, fastest = brentq(ill_posedness, 1e-6, 0.1, Mu), brentq(ill_posedness, 0.1, 10, Mu)
# There q is above 1/2 before C changes its sign, at 14.91: what ends it is m = 1.
greatest = brentq(lambda I: Regularised.value(I) * (1 - Regularised.slope(I) / 2) - 1, 1, 100)
checks.close("mu_i_regularised: reference, I up to which it is well-posed", greatest, 15.0833, absolute=1e-4)
check_incompressible(Coulomb, [1e-3, 0.1])
check_incompressible(Mu, [1e-3, 0.98 * slowest, 1.02 * slowest, 0.1, 0.98 * fastest, 1.02 * fastest, 3])
check_incompressible(Regularised, [1e-4, 1e-3, 0.98 * slowest, 1.02 * slowest, 0.1, 1, 10, 0.94 * greatest,
                                   1.02 * greatest])

# ---- with p_c(nu) ----

NU_MIN, NU_MAX, RHO = 0.5, 0.65, 2900.0  # of the paper's particles


def compressible_growth(law, I, k_d, angle):
    """Growth rate over gdot of one wave: nu, v_x, v_y with p_c(nu) and friction at its critical state, in plane shear;
    lengths in d, times in 1/gdot, stresses in p_c."""
    mu, q = law.value(I), law.slope(I)
    density = NU * I**2
    stiffness = NU * (2 / (NU - NU_MIN) + 5 / (NU_MAX - NU))  # nu p_c'/p_c
    k = k_d * np.array([np.cos(angle), np.sin(angle)])
    shear = np.array([[0.0, 1.0], [1.0, 0.0]])  # D/|D|
    A = np.zeros((3, 3), complex)  # of p_c'/p_c nu and v
    A[0, 1:] = -1j * stiffness * k
    A[1:, 0] = 1j * (mu * (1 - q / 2) * shear @ k - k) / density
    for axis in range(2):
        D = 0.5j * (np.outer(k, np.eye(2)[axis]) + np.outer(np.eye(2)[axis], k))
        stress = 2 * mu * (D - np.trace(D) / 3 * np.eye(2) - (1 - q) * 0.5 * np.sum(shear * D) * shear)
        A[1:, 1 + axis] = 1j * stress @ k / density
    A[1, 2] -= 1  # what the wave brings from layers of other speed
    return np.linalg.eigvals(A).real.max()


cold = {**growth_rates.LAWS["critical_state, mu_i"]}
states = [(NU, I, 0.0, k_d) for I in (1e-3, 1e-2, 0.1, 1.0) for k_d in (1.0, 30.0, 1e4)]
for row in growth_rates.rates(tool, growth_rates.CASE, cold, states):
    # by the mean shear that edges and cells take: 3e-5 of the viscous rate, which is most where k is great
    expected = compressible_growth(Mu, row["I"], row["k_d"], np.radians(row["angle"]))
    checks.close(f"p_c(nu), mu_i, I {row['I']:g}, k d {row['k_d']:g}: growth over gdot", row["growth"] / row["strain_rate"],
                 expected, relative=0.01, absolute=0.01)

# ---- verdicts ----


def verdicts(name, numbers, ratios=(0.0,)):
    waves = np.geomspace(1, 1e4, 5)
    states = [(NU, I, ratio, k) for ratio in ratios for I in numbers for k in waves]
    return growth_rates.verdicts(growth_rates.rates(tool, growth_rates.CASE, growth_rates.LAWS[name], states))


# Friction without a viscosity along the shear, and pressure by nu alone: growth to the power 2/3 of k, for the product
# of the angle to the direction without viscosity and of k^2 balances the coupling of p_c(nu) to shear.
for line in verdicts("critical_state, cold", (0.1, 0.3)):
    checks.equal(f"critical_state, cold, I {line['I']:g}", line["verdict"], "ill-posed")
    checks.close(f"critical_state, cold, I {line['I']:g}: power of k", line["exponent"], 2 / 3, absolute=0.03)
for name, right in (("relaxed, c = 1", ("decay",)), ("critical_state, c = 1", ("decay",)),
                    ("relaxed, cidr", ("bounded", "decay")), ("critical_state, mu_i", ("bounded", "decay")),
                    ("critical_state, mu_i_regularised", ("bounded", "decay"))):
    for line in verdicts(name, (1e-3, 1e-2), (0.0, -0.1, 0.1)):
        checks.true(f"{name}, I {line['I']:g}, div v/gdot {line['ratio']:g}: shortest waves {' or '.join(right)}",
                    line["verdict"] in right, line["verdict"])
checks.verdict()
