"""H11: the bubble of ../../cases/bubble_rise on the full width with cells of 3 and 1.5 mm (and .75 mm if SCREE_BUBBLE_REFINE says
so: "1 2 4"): symmetry, and area and height of the bubble over the grids. Six minutes on 2 ranks."""
import os

import numpy as np
from scree_program import Checks, Program
from symmetry import asymmetry, bubble

REFINE = [int(word) for word in os.environ.get("SCREE_BUBBLE_REFINE", "1 2").split()]
END = float(os.environ.get("SCREE_BUBBLE_END", 0.5))

program, checks = Program(), Checks("bubble on the full width over grids", "H11")
results = []
for refine in REFINE:
    name = f"{3 / refine:g} mm"
    print(f"{name} ...", flush=True)
    run = program.run("../../cases/bubble_rise/full_width.yaml", f"refine_{refine}",
                      {"grid_refine": refine, "end_time": END, "output_interval": END / 25}, timeout=None)
    monitor, (nu, v) = run.monitor, asymmetry(run.fields)
    area, top, centre = bubble(run.fields)
    results.append((refine, run, nu, area, top, centre))
    # Newton's tolerance is the only source of asymmetry; the surface of a bubble lets it grow
    checks.below(f"{name}: asymmetry of nu", nu, 1e-2)
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
    checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-9)
    print(f"{name}: asymmetry of nu {nu:.1e}, of v_y {v:.1e} m/s; bubble {1e4 * area:.1f} cm2, top {100 * top:.1f} cm, "
          f"centre {100 * centre:.1f} cm", flush=True)
for a, b in zip(results, results[1:]):
    # upwind, cells of 1/20 to 1/40 of the bubble
    checks.close(f"centre of the bubble, {3 / b[0]:g} mm against {3 / a[0]:g} mm", b[5] / a[5], 1, absolute=0.1)
    checks.close(f"area of the bubble, {3 / b[0]:g} mm against {3 / a[0]:g} mm", b[3] / a[3], 1, absolute=0.3)
if len(results) > 2:
    for index, what in ((3, "area"), (5, "centre")):
        first, last = abs(results[-2][index] - results[-3][index]), abs(results[-1][index] - results[-2][index])
        checks.below(f"{what}: last change over the one before", last / first, 1)
for refine, run, nu, area, top, centre in results:
    checks.hard_case("H11", f"bubble on the full width, {3 / refine:g} mm, {END:g} s", run, mirror_error=nu,
                     measured=f"bubble {1e4 * area:.1f} cm2, top {100 * top:.1f} cm, centre {100 * centre:.1f} cm",
                     bound="symmetric from a symmetric start, rise and area converge")
checks.verdict()
