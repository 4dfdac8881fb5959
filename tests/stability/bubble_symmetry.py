"""H11: a bed with a central jet on the full width stays symmetric. What asymmetry there is comes from Newton's tolerance: it
falls with it, to rounding, also where two ranks have half of the bed each. bubble_symmetry_long.py has 3 and 1.5 mm cells, and the bubble."""
import numpy as np
from scree_program import Checks, Program
from symmetry import asymmetry

FIXED = {"time_step_adaptive": "no", "time_step_initial": 2e-4, "ksp_rtol": 1e-10}
BOUNDS = {1e-3: 1e-6, 1e-9: 1e-12}  # Newton's tolerance: asymmetry of nu
program, checks = Program(), Checks("bubbling bed on the full width, 6 mm cells", "H11")

run = program.run("bubble_symmetry.yaml", "default")
monitor, default = run.monitor, asymmetry(run.fields)
first = asymmetry(run.first_fields)
checks.equal("asymmetry of nu and v at the start", first, (0.0, 0.0))
# at default tolerances: what accuracy 1e-2 a step leaves, far below what a bubble would show
checks.below("default tolerances: asymmetry of nu", default[0], 1e-3)
checks.below("default tolerances: asymmetry of v_y [m/s]", default[1], 1e-3)
checks.below("mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
checks.below("gas volume error", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
checks.below("a jet: nu on the axis in the lowest 4 cm, least", run.fields["solids_fraction"][:7, 11:13].min(), 0.3)

found = []
for tolerance, ranks, end in ((1e-3, 1, 0.02), (1e-9, 1, 0.006), (1e-9, 2, 0.006)):
    name = f"Newton to {tolerance:g}, ranks {ranks}"
    tight = program.run("bubble_symmetry.yaml", f"tolerance_{tolerance:g}_{ranks}", {
        **FIXED, "end_time": end, "snes_rtol": tolerance, "snes_atol": tolerance * 1e-1, "snes_stol": 0}, ranks=ranks)
    found.append(asymmetry(tight.fields)[0])
    checks.equal(f"{name}: cut steps", tight.monitor["rejected_solver"].sum(), 0)
    checks.below(f"{name}: asymmetry of nu", found[-1], BOUNDS[tolerance])
checks.hard_case("H11", "bubble on the full width, 6 mm, 0.06 s", run,
                 measured="asymmetry of nu " + ", ".join(f"{a:.0e}" for a in found) + " with Newton to 1e-3, to 1e-9, and to that on 2 ranks",
                 bound="symmetric to rounding from a symmetric start", mirror_error=default[0])
checks.verdict()
