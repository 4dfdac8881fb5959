"""H5: a bed and a jet below an empty freeboard: velocities are bounded, nu is not negative, and the floor that regularises
voids changes nothing where there are particles."""
import numpy as np
from scree_program import DIRECT, Checks, Program

FLOORS = (1e-4, 1e-6)

program, checks = Program(), Checks("bed below an empty freeboard", "H5")
states = {}
for floor in FLOORS:
    name = f"floor {floor}"
    run = program.run("freeboard.yaml", f"{floor}", {**DIRECT, "accuracy": 1e-3, "end_time": 0.05, "solids_fraction_floor": floor})
    monitor, states[floor] = run.monitor, run.fields
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-12)
    checks.below(f"{name}: greatest speed ever [m/s]", monitor["speed_max"].max(), 3.0)  # of particles; the slit blows 1 m/s
    checks.below(f"{name}: greatest gas speed at the end [m/s]",
                 max(np.abs(states[floor][f"gas_velocity_{a}_face"]).max() for a in "xy"), 5.0)
    checks.equal(f"{name}: steps that failed", monitor["rejected_solver"].sum(), 0)
    checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)

least = states[FLOORS[-1]]
for floor in FLOORS[:-1]:
    name = f"floor {floor} against {FLOORS[-1]}"
    change = np.abs(states[floor]["solids_fraction"] - least["solids_fraction"]).max() / 0.58
    checks.below(f"{name}: nu", change, 1e-3)
    checks.below(f"{name}: p_g", np.abs(states[floor]["gas_pressure"] - least["gas_pressure"]).max()
                 / np.abs(least["gas_pressure"]).max(), 1e-3)
    nu, v = least["solids_fraction"], least["velocity_y_face"][1:-1]
    both = (nu[1:] > 1e-3) & (nu[:-1] > 1e-3)
    checks.below(f"{name}: v_y where nu > 1e-3, over the 1 m/s that the slit blows",
                 np.abs(states[floor]["velocity_y_face"][1:-1] - v)[both].max(), 1e-3)
checks.hard_case("H5", "bed and jet below an empty freeboard", run,
                 measured=f"nu changes by {change:.1e} (relative) from void floor {FLOORS[0]:g} to {FLOORS[-1]:g}; greatest "
                          f"speed of particles {monitor['speed_max'].max():.2f} m/s",
                 bound="same answer for any floor (1e-3), bounded velocities, nu >= 0")
checks.verdict()
