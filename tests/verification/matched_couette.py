"""T7, matched Couette flow: between walls that obey (25) and (26) shear and granular temperature stay uniform."""
import numpy as np
from closures import (check_closures, dissipation_factor, g0, NU_MAX, RHO_S, shear_factor, wall_collisions, wall_heat,
                      wall_shear)
from scree_program import EXACT, Checks, Program, centres

NU, T, D, E_W, HEIGHT = 0.3, 1e-4, 1e-3, 0.91, 0.02
TABLE = (8.632049, .889454, .325927)  # rate [1/s], slip [cm/s], specularity
RATE = np.sqrt(T * dissipation_factor(NU) / shear_factor(NU)) / D
PULL = 6 * NU_MAX * shear_factor(NU) * D * RATE / (np.pi * np.sqrt(3) * NU * g0(NU))  # specularity times slip [m/s]
SLIP = 1.5 * (1 - E_W**2) * T / PULL
SPECULARITY = PULL / SLIP
U = RATE * HEIGHT / 2 + SLIP

program, checks = Program(), Checks("matched Couette flow, nu 0.3, T 1 cm2/s2, walls 2 cm apart", "T7")
check_closures(checks)
for name, found, table in zip(("rate [1/s]", "slip [cm/s]", "specularity"), (RATE, SLIP * 100, SPECULARITY), TABLE):
    checks.close(f"reference {name}", found, table, relative=1e-6)
checks.close("reference (25): wall over kinetic shear stress", wall_shear(NU, T, SLIP, 0, SPECULARITY)
             / (shear_factor(NU) * RHO_S * D * np.sqrt(T) * RATE), 1, absolute=1e-12)
checks.below("reference (26): heat to the wall over slip work",
             abs(wall_heat(NU, T, SLIP, SPECULARITY, E_W)) / (wall_collisions(NU, T) * SPECULARITY * SLIP**2), 1e-12)

for cells in (8, 16, 32):
    options = {**EXACT, "grid_cells": f"2, {cells}", "wall_specularity": SPECULARITY,
               "boundary_floor_velocity": f"{-U}, 0", "boundary_lid_velocity": f"{U}, 0"}
    last = program.run("matched_couette.yaml", f"cells_{cells}", options).fields
    y, v, found = centres(last["y_faces"]), last["velocity_x_face"], last["granular_temperature"]
    rate = np.polyfit(y - HEIGHT / 2, v.mean(axis=1), 1)[0]
    # Newton's tolerance of 1e-10 is that share of T: its row, J over rho_s V^2/time, is 4.6e-4 here; nu follows by p = const
    checks.below(f"{cells} cells: spread of T, relative", np.ptp(found) / T, 1e-10 / 4.6e-4)
    checks.below(f"{cells} cells: spread of nu", np.ptp(last["solids_fraction"]), 0.3 * 1e-10 / 4.6e-4)
    checks.below(f"{cells} cells: v against the linear profile of its own rate, over U",
                 np.abs(v - rate * (y - HEIGHT / 2)[:, None]).max() / U, 1e-7)
    checks.close(f"{cells} cells: T over the square of the rate, d2 [-]", found.mean() / (D * rate) ** 2,
                 T / (D * RATE) ** 2, relative=1e-6)
    # Slip and T of the wall laws are those on the wall, so that uniform shear solves the discrete balances too.
    for name, error in (("T", found.mean() / T - 1), ("rate", rate / RATE - 1), ("slip", (U - rate * HEIGHT / 2) / SLIP - 1)):
        checks.below(f"{cells} cells: relative error of {name}", abs(error), 1e-6)
checks.verdict()
