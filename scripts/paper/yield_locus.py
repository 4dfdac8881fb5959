"""The yield locus (14), (15) of the frictional stress in plane principal stresses, and p_c of (18); Table 2, cgs units.

This is the paper's form. The program rounds n of (14) between its branches over a stated width of div v (src/MODEL.md)."""
import numpy as np

SIN_PHI = np.sin(np.radians(28.5))
N_DILATION, N_COMPACTION = np.sqrt(3) / (2 * SIN_PHI), 1.03
F, R, S, NU_MIN, NU_MAX = 0.5, 2, 5, 0.5, 0.65  # F in dyn/cm2


def critical_pressure(nu):
    """p_c, (18) [dyn/cm2]."""
    return F * np.maximum(nu - NU_MIN, 0) ** R / (NU_MAX - nu) ** S


def shear(chi, n):
    """-A/(sqrt(2) p_c) of (14): half the difference of the principal stresses over p_c."""
    return chi * SIN_PHI * (n - (n - 1) * chi ** (1 / (n - 1)))


def principal_stresses(chi, n):
    """sigma_1/p_c, sigma_2/p_c: chi with S/sqrt(S:S) = diag(-1, 1)/sqrt(2) in (10)."""
    return chi + shear(chi, n), chi - shear(chi, n)


def apex():
    """Greatest chi, where the compaction branch ends on sigma_1 = sigma_2: A = 0."""
    return (N_COMPACTION / (N_COMPACTION - 1)) ** (N_COMPACTION - 1)


def branches(points=201):
    """name -> (chi, sigma_1/p_c, sigma_2/p_c), from the origin to the critical state and on to the apex."""
    # towards the apex points crowd, where the locus turns
    dilation = np.linspace(0, 1, points)
    compaction = apex() - (apex() - 1) * np.linspace(1, 0, points) ** 2
    return {"dilation": (dilation, *principal_stresses(dilation, N_DILATION)),
            "compaction": (compaction, *principal_stresses(compaction, N_COMPACTION))}
