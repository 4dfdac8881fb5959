"""H19: a flat-floored bin empties until a wedge is left in its corner, which stands at its angle of repose."""
import numpy as np
from piles import angle, depth, standing
from scree_program import Checks, Program

FLANK = (0.03, 0.08)  # m, clear of slot and wall

program, checks = Program(), Checks("bin that empties", "H19")
run = program.run("emptying.yaml", "bin")
monitor, fields = run.monitor, run.all_fields()
time, mass = np.asarray(monitor["time"]), np.asarray(monitor["mass"])
mass_at = lambda t: np.interp(t, time, mass)
end = time[-1]
checks.below("discharge in the last half second over the mass that is left", (mass_at(end - 0.5) - mass[-1]) / mass[-1], 2e-3)
checks.close("share of the mass that is left", mass[-1] / mass[0], 0.22, absolute=0.06)
checks.above("angle of the wedge [degrees]", -angle(fields[-1], FLANK), 15)
checks.below("angle of the wedge over atan(sin phi)", -angle(fields[-1], FLANK) / 25.5, 1)
checks.close("angle half a second before less that at the end [degrees]",
             angle(fields[-3], FLANK) - angle(fields[-1], FLANK), 0, absolute=0.2)
checks.below("depth on the axis over that at the wall", depth(fields[-1])[1][0] / depth(fields[-1])[1][-1], 0.02)
checks.below("greatest speed in the last quarter second over sqrt(g h)", standing(run, end - 0.25) / np.sqrt(9.81 * 0.06), 0.01)
checks.hard_case("H19", "flat-floored bin, 20 cm wide, 5 mm cells", run,
                 measured=f"wedge of {-angle(fields[-1], FLANK):.1f} degrees")
checks.verdict()
