"""H18 and the second half of H17: a column as high as wide collapses to a heap, which stops and stands."""
import numpy as np
from piles import angle, depth, front, standing
from scree_program import Checks, Program

WIDTH, G, D = 0.05, 9.81, 1e-3

program, checks = Program(), Checks("column collapse", "H17", "H18")
run = program.run("collapse.yaml", "column")
fields = run.all_fields()
times = np.linspace(0, run.summary["time"], len(fields))
fronts = np.array([front(f, 2 * D) for f in fields])
stopped = times[np.flatnonzero(fronts < WIDTH + 0.95 * (fronts[-1] - WIDTH))[-1] + 1]
fall = np.sqrt(WIDTH / G)
flank = (0.02, 0.07)
checks.close("run-out between 0.5 and 1 s over the final one", (fronts[len(fields) // 2] - WIDTH) / (fronts[-1] - WIDTH), 1,
             absolute=0.02)
checks.close("height at the wall at 0.75 s over that at 1 s", depth(fields[3 * len(fields) // 4])[1][0] / depth(fields[-1])[1][0], 1,
             absolute=0.01)
checks.close("angle of the flank at 0.75 s less that at 1 s [degrees]",
             angle(fields[3 * len(fields) // 4], flank) - angle(fields[-1], flank), 0, absolute=0.2)
checks.below("greatest speed over the last 0.1 s over sqrt(g h)", standing(run, 0.9) / np.sqrt(G * WIDTH), 0.02)
checks.above("angle of the flank [degrees]", angle(fields[-1], flank), 14)
checks.below("angle of the flank over atan(sin phi)", angle(fields[-1], flank) / 25.5, 1)
checks.below("95 % of the run-out is reached at t/sqrt(h/g)", stopped / fall, 5)
checks.below("mass lost", abs(run.summary["quantities"]["mass_error"]), 1e-10)
checks.hard_case("H18", "column 5 cm x 5 cm on cells of 5 mm", run,
                 measured=f"run-out {fronts[-1] / WIDTH - 1:.2f}, height {depth(fields[-1])[1][0] / WIDTH:.2f}, "
                          f"stops at {stopped / fall:.1f} sqrt(h/g), {angle(fields[-1], flank):.1f} degrees",
                 bound="1.2, 1, 3.3 (Lube et al. 2005)")
checks.verdict()
