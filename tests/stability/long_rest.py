"""H1: 1 m of particles at rest in gas for 100 s, with fixed and adaptive steps, T frozen and as an unknown."""
import numpy as np
from scree_program import DIRECT, Checks, Program

FROZEN = {"dt 1 s": {"time_step_initial": 1}, "dt 10 s": {"time_step_initial": 10}}
COOLING = {"granular_temperature": "transport", "initial_fill_granular_temperature": 1e-6, "time_step_adaptive": "yes",
           "time_step_initial": 1e-3, "time_step_max": 10}

program, checks = Program(), Checks("column of 1 m at rest in gas, 100 s", "H1")
for gas in ("incompressible", "darcy"):
    for T, steps in (("frozen", "dt 1 s"), ("frozen", "dt 10 s"), ("cooling", "adaptive")):
        name = f"{gas}, {steps}, T {T}"
        choice = COOLING if T == "cooling" else FROZEN[steps]
        run = program.run("long_rest.yaml", f"{gas}_{steps}_{T}".replace(" ", "_"), {**DIRECT, **choice, "gas": gas},
                          must_work=False, timeout=240)
        checks.equal(f"{name}: exit code", run.code, 0)
        if run.code:
            continue
        first, last, monitor = run.first_fields, run.fields, run.monitor
        bed = first["solids_fraction"] > 0
        inside = np.flatnonzero(bed)[1:-1]  # faces between filled cells, but for the last one, which is the surface
        checks.below(f"{name}: speed in the bed at the end [m/s]", np.abs(last["velocity_x_face"][inside]).max(), 1e-9)
        if T == "frozen":
            checks.below(f"{name}: greatest speed ever [m/s]", monitor["speed_max"].max(), 1e-9)
            checks.below(f"{name}: p_g ever, over the weight",
                         max(monitor["gas_pressure_max"].max(), -monitor["gas_pressure_min"].min()) / 1.7e4, 1e-12)
            drift = np.abs(last["solids_fraction"] - first["solids_fraction"]).max()
            checks.below(f"{name}: drift of nu", drift, 1e-9)
        else:
            # what T throws off the surface falls no faster than single particles do
            checks.below(f"{name}: greatest speed ever [m/s]", monitor["speed_max"].max(), 7.264)
        checks.below(f"{name}: greatest rise of nu upwards: no checkerboard", np.diff(last["solids_fraction"][inside]).max(), 0)
        checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-12)
        checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(),
                     1e-12 if gas == "incompressible" else 1e-9)
        checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
        if T == "frozen" and steps == "dt 10 s":
            checks.hard_case("H1", f"column of 1 m at rest in gas ({gas}), 100 s", run,
                             measured=f"greatest speed {monitor['speed_max'].max():.1e} m/s with steps of 10 s",
                             bound="speeds at tolerance (1e-9 m/s) for any dt, no checkerboard")
checks.verdict()
