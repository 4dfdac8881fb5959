"""T18: a gas of vanishing density and viscosity changes nothing."""
import numpy as np
from gas_relations import check_balances
from scree_program import Checks, Program

FIELDS = ("solids_fraction", "velocity_x_face", "velocity_y_face", "granular_temperature", "frictional_pressure_ratio")

program, checks = Program(), Checks("bin with a gas of 1e-6 kg/m3 and 1e-12 Pa s", "T18")
# Newton far below the difference that is looked for. Backward Euler keeps momentum in a step without gas alone, and would
# differ by as much as nu changes in a step.
TIGHT = {"solver": "direct", "time_scheme": "arkimex", "accuracy": 1e-4}
without = program.run("faint_gas.yaml", "none", TIGHT).fields
for gas in ("incompressible", "darcy"):
    run = program.run("faint_gas.yaml", gas, {**TIGHT, "gas": gas, "gas_density": 1e-6, "gas_viscosity": 1e-12})
    checks.equal(f"{gas}: steps that had to be cut", run.monitor["rejected_solver"].sum(), 0)
    for name in FIELDS:
        found, exact = run.fields[name], without[name]
        checks.below(f"{gas}: greatest difference of {name}, over the greatest value",
                     np.abs(found - exact).max() / np.abs(exact).max(), 1e-6)
    check_balances(checks, gas, run, gas)
checks.verdict()
