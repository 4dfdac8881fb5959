"""T1, homogeneous cooling, without gas and with gas at zero slip: the exact T(t) and the time order of each scheme."""
from closures import check_closures
from gas_relations import check_balances
from haff_cooling_exact import temperature
from scree_program import EXACT, Checks, Program

SCHEMES = {"beuler": (1, 1.5e-2), "bdf": (2, 2e-4), "arkimex": (2, 1e-5)}
WITH_GAS = {"beuler": (1, 8e-2), "bdf": (2, 4e-3), "arkimex": (2, 3e-4)}  # T falls to a tenth: larger steps


program, checks = Program(), Checks("cooling of particles at rest, nu 0.3, T0 1 cm2/s2", "T1")
check_closures(checks)
checks.close("reference T(0.1 s), d 0.1 cm [cm2/s2]", temperature(0.1, 1e-3) * 1e4, 0.4372736, relative=1e-6)
checks.close("reference T(1 s), d 0.1 cm [cm2/s2]", temperature(1, 1e-3) * 1e4, 0.0266774, relative=1e-5)

# In air 0.1 mm particles lose by drag about what they lose by collisions.
for name, d, end, gas, schemes in (("no gas, d 0.1 cm", 1e-3, 0.1, "none", SCHEMES),
                                   ("air, d 0.01 cm", 1e-4, 0.02, "incompressible", WITH_GAS)):
    exact = temperature(end, d, gas != "none")
    for scheme, (order, bound) in schemes.items():
        errors = []
        for steps in (10, 20, 40):
            options = {**EXACT, "gas": gas, "particle_diameter": d, "end_time": end, "time_scheme": scheme,
                       "time_step_initial": end / steps}
            run = program.run("haff_cooling.yaml", f"{gas}_{scheme}_{steps}", options)
            T = run.fields["granular_temperature"]
            checks.below(f"{name}, {scheme}, {steps} steps: spread over the cells, relative",
                         (T.max() - T.min()) / T.max(), 1e-12)
            errors.append(abs(T.mean() / exact - 1))
            if gas != "none":
                check_balances(checks, f"{name}, {scheme}, {steps} steps", run)
        checks.order(f"{name}, {scheme}: relative error of T({end} s) after 10, 20, 40 steps", errors, order, bound)

# A second-order scheme to the times of the table, and darcy, whose gas is at rest with the particles too.
for name, d, end, options in (("no gas, d 0.1 cm", 1e-3, 1, {}),
                              ("air, d 0.01 cm", 1e-4, 0.05, {"gas": "incompressible"}),
                              ("air, darcy, d 0.01 cm", 1e-4, 0.05,
                               {"gas": "darcy", "gas_darcy_solids_fraction": 1e-8})):
    options = {**EXACT, **options, "particle_diameter": d, "end_time": end, "time_scheme": "arkimex",
               "time_step_initial": end / 200}
    run = program.run("haff_cooling.yaml", name.replace(", ", "_").replace(" ", "_"), options)
    T = run.fields["granular_temperature"]
    exact = temperature(end, d, "gas" in options)
    checks.close(f"{name}, arkimex, 200 steps: T({end} s) [cm2/s2]", T.mean() * 1e4, exact * 1e4, relative=1e-4)
checks.verdict()
