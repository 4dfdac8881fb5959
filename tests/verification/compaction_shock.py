"""T15, compaction shock: solids fraction behind it and its speed, and how they depend on the step."""
import numpy as np
from scree_program import EXACT, Checks, Program, centres
CASES = [(1.0, 0.5, .612006, 4.4640), (1.0, 0.3, .600686, .9977), (5.0, 0.5, .628447, 19.463)]  # V, nu1, nu2, U_s

def front(fields, middle):
    x, nu = centres(fields["x_faces"]), fields["solids_fraction"]
    last = np.flatnonzero(nu > middle)[-1]
    return x[last] + (nu[last] - middle) / (nu[last] - nu[last + 1]) * (x[last + 1] - x[last])

program, checks = Program(), Checks("compaction shock")
for V, nu1, nu2, U in CASES:
    for cells in (60, 120, 240):
      for co in (0.5, 0.25, 0.125, 0.0625):
        dx = .12/cells
        dt = co * dx / U
        end = 0.08 / U
        options = {**EXACT, "grid_cells": cells, "time_step_initial": dt, "end_time": end, "output_interval": end / 4, "boundary_inlet_velocity": -V,
               "boundary_inlet_solids_fraction": nu1, "initial_everywhere_solids_fraction": nu1, "initial_everywhere_velocity": -V}
        run = program.run("compaction_shock.yaml", f"V{V}_nu{nu1}_{cells}_{co}", options, must_work=False)
        if run.code: print("FAILED", cells, co, run.errors[-300:]); continue
        snaps = run.all_fields()
        t = np.array([s["time"] for s in snaps[1:]]); X = np.array([front(s, 0.5 * (nu1 + nu2)) for s in snaps[1:]])
        speed = np.polyfit(t[1:], X[1:], 1)[0]
        last = snaps[-1]
        x = centres(last["x_faces"])
        behind = (x > 0.02) & (x < X[-1] - 0.02)
        m=run.monitor
        print(V, nu1, cells, co, "nu2-ref", last["solids_fraction"][behind].mean() - nu2, np.ptp(last["solids_fraction"][behind]), "wall", last["solids_fraction"][:3], "U rel", speed / U - 1, "numax", m["solids_fraction_max"].max(), "newton", m["newton_iterations"].mean(), "rej", m["rejected_solver"].sum(), "lim", m["limited"][-1])
