"""The bin of Anand et al. (2008) on coarse cells against the reference data that lie beside the case: the rate of discharge
in a band about discrete elements and about the paper's points, and the friction of the paper's model outside of it."""
import numpy as np
from scree_program import Checks, Program

from scree import silo_anand, slot_flow  # on the path since scree_program

WINDOW = (0.1, 0.3)  # [s]
BAND = 0.1  # cells of 1 mm at the lip
COARSE = {"grid_finest": "1 mm", "grid_coarsest": "8 mm", "grid_growth": 1.5, "end_time": WINDOW[1],
          "output_interval": WINDOW[1]}

program, checks = Program(), Checks("bin of Anand et al. (2008) against discrete elements")
elements = slot_flow.slope(*silo_anand.reference_mass("mass_anand"), WINDOW)
rates = {}
for name in ("case", "paper"):
    run = program.run(silo_anand.PAGE / f"{name}.yaml", name, COARSE)
    found = silo_anand.run_of(run.directory)
    rates[name] = found.rate_in(WINDOW)
    silo_anand.report(found)
    checks.below(f"{name}: mass error", np.abs(run.monitor["mass_error"]).max(), 1e-12)
checks.close("rate of discrete elements [g/s]", rates["case"], elements, relative=BAND)
checks.above("paper's friction: rate [g/s]", rates["paper"], elements * (1 + BAND))
checks.verdict()
