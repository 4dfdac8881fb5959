"""H10, short: 100 um particles with air leave a bin; and the same with the space below it closed, where the air that they
displace can only go up through the orifice against them."""
import numpy as np
from fine_bin_sides import CLOSED
from scree_program import Checks, Program

program, checks = Program(), Checks("100 um bin with air, open and closed at the bottom, 0.3 s", "H10")
rates = {}
for name, options in (("open", {}), ("closed", CLOSED)):
    run = program.run("fine_bin.yaml", name, options, must_work=False)
    checks.equal(f"{name}: exit code", run.code, 0)
    if run.code:
        continue
    monitor, last = run.monitor, run.fields
    t, rate = monitor["time"], monitor["flux_orifice"]
    late = t > 0.15
    rates[name] = np.trapz(rate[late], t[late]) / (t[late][-1] - t[late][0])
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
    checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-9)
    checks.below(f"{name}: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), 0.649)
    checks.above(f"{name}: particles pass the orifice, kg/s", rates[name], 1e-3)
    # cells over the orifice: x < .7 cm, .5 to 3 cm above the floor
    pressure = last["gas_pressure"][5:8, :2]
    if name == "open":
        checks.below("open: p_g over the orifice below that of the atmosphere [Pa]", pressure.max(), 0)
        figure = f"p_g over the orifice {pressure.min():.0f} Pa"
    else:
        nu, dy, dx = last["solids_fraction"], np.diff(last["y_faces"]), np.diff(last["x_faces"])
        share = np.einsum("yx,y,x->", nu, dy, dx) / np.einsum("yx,y,x->", run.first_fields["solids_fraction"], dy, dx)
        checks.close("closed: mass in the box at the end over that of the start", share, 1, absolute=1e-12)
        # below the floor air is displaced and pressed upwards: its pressure is above that in the bin
        checks.above("closed: p_g below the floor less that over the orifice [Pa]",
                     last["gas_pressure"][:5, :2].mean() - pressure.mean(), 0)
        figure = f"p_g below the floor {last['gas_pressure'][:5].mean():.0f} Pa"
    checks.hard_case("H10", f"100 um bin with air, {name} at the bottom, coarse, 0.3 s", run,
                     measured=f"rate {1e3 * rates[name]:.1f} g/s from 0.15 s on; {figure}",
                     bound="runs; sub-atmospheric over an open orifice; volumes kept to 1e-12")
checks.verdict()
