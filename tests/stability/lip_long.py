"""H9: rate of discharge on grids of 2, 1, .5 mm (and .25 mm if SCREE_LIP_REFINE says so: "1 2 4 8"): order, extrapolated
value, mirror symmetry. Five minutes on 2 ranks; .25 mm is ten times as long."""
import os

import numpy as np
from scree_program import Checks, Program
from symmetry import asymmetry

REFINE = [int(word) for word in os.environ.get("SCREE_LIP_REFINE", "1 2 4").split()]
END, FROM = float(os.environ.get("SCREE_LIP_END", 0.35)), 0.6  # s; the mean rate is taken over the last part of the time

program, checks = Program(), Checks("lip of the orifice, rate over grids", "H9")
rates, runs, mirrors = [], [], []
for refine in REFINE:
    name = f"{2 / refine:g} mm"
    print(f"{name} ...", flush=True)
    run = program.run("lip_long.yaml", f"refine_{refine}", {"grid_refine": refine, "end_time": END}, timeout=None)
    monitor = run.monitor
    t, rate = monitor["time"], monitor["flux_orifice"]
    late = t > FROM * END
    rates.append(1e3 * np.trapz(rate[late], t[late]) / np.ptp(t[late]))
    mirrors.append(asymmetry(run.fields)[0])
    runs.append(run)
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
    checks.below(f"{name}: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), 0.65 - 1e-6)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-9)
    checks.below(f"{name}: asymmetry of nu", mirrors[-1], 1e-3)
    print(f"{name}: {rates[-1]:.2f} g/s", flush=True)
steps = np.diff(rates)
if len(steps) > 1:
    checks.true("the rate changes monotonically with the grid", np.all(steps > 0) or np.all(steps < 0), f"{rates}")
    ratio = steps[-2] / steps[-1]
    order = np.log2(abs(ratio))
    limit = rates[-1] + steps[-1] / (2**order - 1)
    # upwind is of first order; the lip is a singularity whose order is lower
    checks.above("order of the rate", order, 0.3)
    text = f"order {order:.2f}, extrapolated {limit:.1f} g/s"
else:
    text = "no order from fewer than three grids"
for refine, run, mean, mirror in zip(REFINE, runs, rates, mirrors):
    checks.hard_case("H9", f"lip of the orifice, {2 / refine:g} mm", run, measured=f"rate {mean:.2f} g/s; {text}",
                     bound="monotone in the grid, symmetric", mirror_error=mirror)
checks.verdict()
