"""H4: fine particles in air at steps of 1 ms: every step works, and the slip is that of equilibrium from the start on.
And a bed of them on cells much wider than the particles, with free steps: a residual of the balances of mass leaves
velocities there that errors of steps were mistaken for."""
import numpy as np
from scipy.optimize import brentq
from scree_program import DIRECT, Checks, Program

RHO_S, RHO_G, MU, G, D = 2900.0, 1.3, 1.8e-5, 9.81, 2e-5


def settling_speed(nu):
    """Of particles in a closed vessel, (1-nu) w with drag (Wen-Yu) = weight in gas [m/s]."""

    def excess(w):
        Re = RHO_G * (1 - nu) * D * w / MU
        return 18 * MU / D**2 * (1 - nu) ** -3.65 * (1 + 0.15 * Re**0.687) * w - (RHO_S - RHO_G) * G

    return (1 - nu) * brentq(excess, 1e-9, 10, xtol=1e-15)


program, checks = Program(), Checks("particles of 20 um in air, steps of 1 ms", "H4")
for gas in ("incompressible", "darcy"):
    for nu in (0.3, 0.1, 0.01) if gas == "incompressible" else (0.1,):
        name = f"{gas}, nu {nu}"
        run = program.run("fine_particles.yaml", f"{gas}_{nu}", {**DIRECT, "gas": gas, "initial_everywhere_solids_fraction": nu})
        monitor = run.monitor
        checks.equal(f"{name}: steps", len(monitor["time"]) - 1, 300)
        checks.equal(f"{name}: steps that failed", monitor["rejected_solver"].sum(), 0)
        v = run.fields["velocity_y_face"]
        middle = v[18:23]
        checks.below(f"{name}: settling speed in the middle, relative error", np.abs(middle / -settling_speed(nu) - 1).max(), 1e-3)
        error = np.abs(middle / -settling_speed(nu) - 1).max()
        checks.below(f"{name}: spread across, relative", np.ptp(v, axis=1).max() / settling_speed(nu), 1e-6)
        checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-12)
        checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(),
                     1e-12 if gas == "incompressible" else 1e-9)
        checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
        if nu == 0.1:
            response = D**2 * RHO_G * (1 - nu) ** 3.65 / (18 * MU * nu)
            checks.hard_case("H4", f"20 um in air ({gas}), nu {nu}, dt 1 ms", run,
                             measured=f"settling speed off by {error:.1e} after 0.3 s",
                             bound="slip of equilibrium to 1e-3; 300 steps of 1 ms, none cut",
                             without=f"explicit drag: dt < {response:.1e} s, the response time of the gas")

rising = program.run("lifted_bed.yaml", "lifted")
v = rising.fields["velocity_y_face"]
checks.below("lifted bed: steps to 0.05 s", len(rising.monitor["time"]), 140)
checks.below("lifted bed: spread of v_y across over the greatest", np.ptp(v, axis=1).max() / np.abs(v).max(), 0.02)
checks.hard_case("H4", "20 um in air, a bed that rises, free steps", rising,
                 measured=f"{len(rising.monitor['time'])} steps", bound="140 steps, the same across")
checks.verdict()
