"""H9, short: the lip of the orifice on cells of 2 and 1 mm, the first hundredths of a second: what leaves grows steadily and
alike on both, and left and right stay alike. lip_long.py follows the rate over the grids."""
import numpy as np
from scree_program import Checks, Program
from symmetry import asymmetry

program, checks = Program(), Checks("lip of the orifice, start on 2 and 1 mm", "H9")
TIGHT = {"solver": "multigrid", "ksp_rtol": 1e-6, "time_step_adaptive": "no", "time_step_initial": 5e-4, "snes_rtol": 1e-9,
         "snes_atol": 1e-8}
left = {}
for refine, end in ((1, 0.02), (2, 0.01)):
    name = f"{2 / refine:g} mm"
    run = program.run("lip.yaml", f"refine_{refine}", {"grid_refine": refine, "end_time": end})
    monitor = run.monitor
    t, rate = monitor["time"], monitor["flux_orifice"]
    checks.above(f"{name}: least growth of the rate from step to step over its last value", np.diff(rate).min() / rate[-1], 0)
    left[refine] = np.interp(0.01, t, rate)
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
    checks.below(f"{name}: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), 0.649)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-12)
    checks.below(f"{name}: asymmetry of nu, default tolerances", asymmetry(run.fields)[0], 1e-4)
    if refine == 1:
        coarse = run
# within .01 s particles fall by .5 mm, a quarter of a cell
checks.close("rate at .01 s, 2 mm over 1 mm", left[1] / left[2], 1, absolute=0.25)
tight = program.run("lip.yaml", "tight", {**TIGHT, "end_time": 5e-3})
checks.below("2 mm, Newton to 1e-9: asymmetry of nu", asymmetry(tight.fields)[0], 1e-8)
checks.hard_case("H9", "lip of the orifice, 2 mm, 0.02 s", coarse, measured=f"asymmetry {asymmetry(coarse.fields)[0]:.0e} of nu, "
                 f"{asymmetry(tight.fields)[0]:.0e} with Newton to 1e-9; rate grows steadily", bound="symmetric, monotone",
                 mirror_error=asymmetry(coarse.fields)[0])
checks.verdict()
