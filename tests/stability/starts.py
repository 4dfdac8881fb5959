"""H14: a uniform start at nu = .60 against one in equilibrium (with wall friction). Both reach the same plateau. The uniform
one is a compressed spring: with p_c as the only stress it throws off its surface at up to the T16 speed, the integral of
c/nu from .5 to .6. The whole model throws it slower: in pure expansion chi* = 0, so that p_f is gone after tau."""
import numpy as np
from scipy.integrate import quad
from scree_program import Checks, Program

RHO_S, F, NU_MIN, NU_MAX = 2900.0, 0.05, 0.5, 0.65
STARTS = {"uniform": {}, "equilibrium": {"initial_fill_profile": "equilibrium", "initial_fill_surface": "35 cm",
                                         "initial_fill_janssen_width": "8 cm"}}

P_C_ALONE = {"friction_model": "critical_state", "friction_strain_rate_floor": 1e8, "granular_temperature": "constant",
             "granular_temperature_value": 0}


def wave_speed(nu):
    p_c = F * (nu - NU_MIN) ** 2 / (NU_MAX - nu) ** 5
    return np.sqrt(p_c * (2 / (nu - NU_MIN) + 5 / (NU_MAX - nu)) / RHO_S)


T16 = quad(lambda nu: wave_speed(nu) / nu, NU_MIN + 1e-12, 0.6)[0]


def thrown(states):
    """Greatest upward speed of faces between cells of at least nu = .05 [m/s]."""
    speeds = []
    for state in states:
        nu, v = state["solids_fraction"], state["velocity_y_face"][1:-1]
        bed = (nu[1:] > 0.05) & (nu[:-1] > 0.05)
        speeds.append(v[bed].max())
    return max(speeds)


program, checks = Program(), Checks("bin discharge from a uniform start and from equilibrium", "H14")
checks.close("reference T16 [m/s]", T16, 0.2506, absolute=1e-4)
runs, speeds, rates = {}, {}, {}
for name, start in STARTS.items():
    # the release takes as long as the wave through a few cells
    for stress, model in (("p_c alone", P_C_ALONE), ("whole model", {})):
        early = program.run("starts.yaml", f"{name}_{stress.replace(' ', '_')}",
                            {**start, **model, "time_step_adaptive": "no", "time_step_initial": 1e-4,
                             "end_time": 6e-3, "output_interval": 3e-4})
        speeds[name, stress] = thrown(early.all_fields())
    runs[name] = program.run("starts.yaml", name, start)
    monitor = runs[name].monitor
    t, rate = monitor["time"], monitor["flux_orifice"]
    late = t > 0.2
    rates[name] = np.trapz(rate[late], t[late]) / (t[late][-1] - t[late][0])
    checks.below(f"{name}: mass error", np.abs(monitor["mass_error"]).max(), 1e-12)
    checks.below(f"{name}: greatest nu ever, below nu_max", monitor["solids_fraction_max"].max(), NU_MAX - 1e-3)
    checks.above(f"{name}: least nu ever", monitor["solids_fraction_min"].min(), -1e-9)
# The speed of T16 is that of the last grain; a face of the grid has a mean over 4 mm, and gravity takes 6 cm/s meanwhile.
checks.below("uniform, p_c alone: its surface is thrown off, m/s, no faster than T16", speeds["uniform", "p_c alone"],
             1.02 * T16)
checks.above("uniform, p_c alone: nor slower than half of it", speeds["uniform", "p_c alone"], 0.5 * T16)
checks.below("uniform, whole model: no faster than by p_c alone", speeds["uniform", "whole model"],
             speeds["uniform", "p_c alone"])
checks.below("equilibrium, whole model: nothing is thrown off, m/s", speeds["equilibrium", "whole model"], 0.01 * T16)
# without the deviator nothing but pressure bears on the walls: the bed, in balance with wall friction, has too low a p_c, and
# sinks; its lower part throws up less than a fifth of T16
checks.below("equilibrium, p_c alone, m/s", speeds["equilibrium", "p_c alone"], 0.2 * T16)
checks.close("rate from 0.2 s on, uniform over equilibrium", rates["uniform"] / rates["equilibrium"], 1, absolute=0.02)
for name, run in runs.items():
    checks.hard_case("H14", f"bin discharge, {name} start", run,
                     measured=f"plateau {1e3 * rates[name]:.1f} g/s, surface thrown off at {100 * speeds[name, 'whole model']:.1f} cm/s, "
                              f"by p_c alone at {100 * speeds[name, 'p_c alone']:.1f} cm/s",
                     bound=f"same plateau (2 %); T16: {100 * T16:.1f} cm/s from the uniform start, none from equilibrium")
checks.verdict()
