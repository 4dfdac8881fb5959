"""H10: the coarse grid of ../../cases/bin_discharge_fine with air for 5 s (SCREE_FINE_END changes it)
and 1.5 s with its bottom closed: steady rate, pressure below that of the atmosphere, no drift. Five minutes on 2 ranks."""
import os

import numpy as np
from scree_program import Checks, Program
from fine_bin_sides import CLOSED

END = float(os.environ.get("SCREE_FINE_END", 5))
CASE = "../../cases/bin_discharge_fine/case.yaml"
program, checks = Program(), Checks("100 um bin with air, open and closed at the bottom, long", "H10")
for name, options in (("open", {"end_time": END}), ("closed", {**CLOSED, "end_time": 0.3 * END})):
    print(f"{name} ...", flush=True)
    run = program.run(CASE, name, {"output_interval": END / 20, **options}, must_work=False, timeout=None)
    checks.equal(f"{name}: exit code", run.code, 0)
    if run.code:
        print(run.errors)
        continue
    monitor = run.monitor
    t, passed = monitor["time"], monitor["flux_orifice"]
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
    checks.below(f"{name}: gas volume error", np.abs(monitor["gas_volume_error"]).max(), 1e-12)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-9)
    text = ""
    if name == "open":
        thirds = [np.trapz(passed[part], t[part]) / np.ptp(t[part])
                  for part in ((t >= a * END) & (t <= b * END) for a, b in ((0.3, 0.5), (0.5, 0.75), (0.75, 1)))]
        checks.below("open: rate over 30-50, 50-75, 75-100 % of the time, spread over mean",
                     np.ptp(thirds) / np.mean(thirds), 0.05)
        over = [state["gas_pressure"][13:15, :4].max() for state in run.all_fields()[6:]]
        checks.below("open: greatest p_g over the orifice, in fields from 30 % of the time on [Pa]", max(over), 0)
        text = (f"rates {', '.join(f'{1e3 * rate:.1f}' for rate in thirds)} g/s; p_g over the orifice {min(over):.0f} to "
                f"{max(over):.0f} Pa")
    checks.hard_case("H10", f"100 um bin with air, {name} at the bottom, {options['end_time']:g} s", run, measured=text,
                     bound="steady rate (5 %), sub-atmospheric p_g, no drift; the closed one runs")
checks.verdict()
