"""H20: a bed whose jet is switched off at 0.1 s comes to rest, with the paper's friction law and with that of S:S + eps^2."""
import numpy as np
from piles import standing
from scree_program import Checks, Program

program, checks = Program(), Checks("a jet that is switched off", "H20")
for name, options in (("fluctuation", {"friction_fluctuation": 1, "friction_strain_rate_floor": 0}), ("none", {})):
    run = program.run("jet_off.yaml", name, options)
    monitor = run.monitor
    kinetic, heat = np.asarray(monitor["kinetic_energy"]), np.asarray(monitor["fluctuation_energy"])
    checks.below(f"{name}: kinetic energy at 0.6 s over its greatest", kinetic[-1] / kinetic.max(), 1e-4)
    checks.below(f"{name}: energy of fluctuation at 0.6 s over its greatest", heat[-1] / heat.max(), 1e-2)
    checks.below(f"{name}: greatest speed in the last 0.1 s over that before", standing(run, 0.5) / standing(run, 0), 0.02)
    checks.close(f"{name}: height of the bed over that at the start", monitor["bed_height"][-1] / monitor["bed_height"][0], 1,
                 absolute=0.05)
    checks.hard_case("H20", f"jet of 1.5 m/s until 0.1 s, friction law with c = {'1' if options else '0'}", run,
                     measured=f"kinetic energy {kinetic[-1] / kinetic.max():.1e} of its greatest")
checks.verdict()
