"""T1, homogeneous cooling: the exact T(t) and the order in time of each scheme."""
from scree_program import EXACT, Checks, Program

CM2 = 1e-4
A = 10.2449841  # 32 eta (1 - eta) nu g0/(sqrt(pi) d) [1/cm]
SCHEMES = {"beuler": (1, 1.5e-2), "bdf": (2, 2e-4), "arkimex": (2, 1e-5)}


def temperature(t):
    return CM2 / (1 + A * t / 2) ** 2


program, checks = Program(), Checks("Haff cooling, nu 0.3, d 0.1 cm, T0 1 cm2/s2, T(0.1 s)", "T1")
checks.close("reference T(0.1) [cm2/s2]", temperature(0.1) / CM2, 0.4372736, relative=1e-6)
checks.close("reference T(1) [cm2/s2]", temperature(1) / CM2, 0.0266774, relative=1e-5)
for scheme, (order, bound) in SCHEMES.items():
    errors = []
    for steps in (10, 20, 40):
        options = {**EXACT, "time_scheme": scheme, "time_step_initial": 0.1 / steps}
        T = program.run("haff_cooling.yaml", f"{scheme}_{steps}", options).fields["granular_temperature"]
        checks.below(f"{scheme}, {steps} steps: spread over the cells, relative", (T.max() - T.min()) / T.max(), 1e-12)
        errors.append(abs(T.mean() / temperature(0.1) - 1))
    checks.order(f"{scheme}: relative error after 10, 20, 40 steps", errors, order, bound)
checks.verdict()
