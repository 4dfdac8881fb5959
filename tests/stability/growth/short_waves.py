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
    J. Fluid Mech. 779, 794, for q < 1/2; Schaeffer (1987) for q = 0."""
    q = law.slope(I)
    m = law.value(I) * (1 - q / 2)
    return 2 * (1 - q) * (1 - np.sqrt(1 - m * m)) / (m * m) - 1


def measured_growth(law, numbers):
    """The same by the program. Waves are so short that their viscous rate is 1e5 times the rate of shear."""
    states = [(NU, I, 0.0, 300 * I) for I in numbers]
    rows = growth_rates.rates(tool, HERE / "incompressible.yaml", law.options, states)
    return [row["growth"] / row["strain_rate"] * NU * (row["I"] / row["k_d"]) ** 2 / law.value(row["I"]) for row in rows]


def check_incompressible(law, numbers):
    for I, growth in zip(numbers, measured_growth(law, numbers)):
        # the base flow turns a wave at the rate of shear: 1e-5 of the viscous rate; differences err by (k h)^2/12 = 3e-5
        checks.close(f"no change of volume, {law.name}, I {I:.4g}: growth over viscous rate", growth,
                     incompressible_growth(law, I), absolute=5e-5)
        checks.true(f"no change of volume, {law.name}, I {I:.4g}: grows where theory says so",
                    (growth > 0) == (incompressible_growth(law, I) > 0))


ill_posedness = lambda I: 4 * Mu.slope(I) ** 2 - 4 * Mu.slope(I) + (Mu.value(I) * (1 - Mu.slope(I) / 2)) ** 2
slowest, fastest = brentq(ill_posedness, 1e-6, 0.1), brentq(ill_posedness, 0.1, 10)
check_incompressible(Coulomb, [1e-3, 0.1])
check_incompressible(Mu, [1e-3, 0.98 * slowest, 1.02 * slowest, 0.1, 0.98 * fastest, 1.02 * fastest, 3])

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
for name in ("relaxed, c = 1", "critical_state, c = 1", "critical_state, mu_i", "relaxed, cidr"):
    for line in verdicts(name, (1e-3, 0.1), (0.0, -0.1, 0.1)):
        checks.equal(f"{name}, I {line['I']:g}, div v/gdot {line['ratio']:g}", line["verdict"], "well-posed")
checks.verdict()
