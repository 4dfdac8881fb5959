"""H17: a heap that is less steep than its angle of repose stands for 10 s, but for the creep that the floor eps of the
strain rate leaves: shear of the order of eps, so that what is h high moves less than eps h t."""
import numpy as np
from piles import angle, depth, standing
from scree_program import Checks, Program

EPS, FLANK = 1e-2, (0.01, 0.04)

program, checks = Program(), Checks("heaps", "H17")
# Steps of 1 cm x 2 mm: atan(0.2) = 11 degrees, on a layer that the steps lie on.
steps = {f"initial_step_{k}_{key}": value for k in range(6) for key, value in (
    ("order", k + 1), ("box", f"0, {6 - k} cm, 0, {4 + 2 * k} mm"), ("solids_fraction", 0.58))}
run = program.run("heaps.yaml", "stands", {**steps, "friction_strain_rate_floor": EPS})
fields = run.all_fields()
start, end = fields[1], fields[-1]
checks.close("11 degrees: angle of the flank after 10 s over that after 1 s", angle(end, FLANK) / angle(start, FLANK), 1,
             absolute=0.02)
checks.close("11 degrees: angle after 10 s over that at the start", angle(end, FLANK) / angle(fields[0], FLANK), 1, absolute=0.15)
highest = depth(start)[1].max()
checks.below("11 degrees: fall of the top between 1 and 10 s over eps h t",
             (highest - depth(end)[1].max()) / (EPS * highest * 9), 1)
checks.below("11 degrees: greatest speed in the last second over eps h", standing(run, 9) / (EPS * highest), 3)
checks.hard_case("H17", "heap of 11 degrees, 10 s", run, measured=f"{angle(end, FLANK):.1f} degrees")
checks.verdict()
