"""T24, the accuracy steers: errors in time are about what was asked for and fall in proportion to it. Neither empty space,
nor the velocity scale, nor a change of units changes the steps."""
import numpy as np
from haff_cooling_exact import temperature
from scree_program import EXACT, Checks, Program

program, checks = Program(), Checks("errors in time against the accuracy asked for", "T24")
ORDER_ONE, ORDER_TWO = 5, 2.5  # the least factor by which the error falls for a tenth of the accuracy; see below


def falls(what, errors, least, most_over_accuracy):
    """errors: accuracy -> error."""
    for accuracy, error in errors.items():
        checks.below(f"{what}, accuracy {accuracy:g}: error over accuracy", error / accuracy, most_over_accuracy)
    pairs = list(errors.items())
    for (coarse, before), (fine, after) in zip(pairs, pairs[1:]):
        per_ten = (before / after) ** (1 / np.log10(coarse / fine))
        checks.above(f"{what}: factor by which the error falls per factor 10, {coarse:g} to {fine:g}", per_ten, least)


# ---- cooling of particles at rest, whose T is known ----

END, DIAMETER = 0.3, 1e-3
for scheme in ("beuler", "bdf", "arkimex"):
    errors = {}
    for accuracy in (1e-1, 1e-2, 1e-3):
        options = {**EXACT, "time_step_adaptive": "yes", "time_step_initial": 1e-5, "end_time": END,
                   "particle_diameter": DIAMETER, "time_scheme": scheme, "accuracy": accuracy}
        run = program.run("haff_cooling.yaml", f"cooling_{scheme}_{accuracy:g}", options)
        errors[accuracy] = abs(run.fields["granular_temperature"].mean() / temperature(END, DIAMETER) - 1)
    if scheme != "beuler":
        del errors[1e-1]  # three steps would do: they are shorter, since each is at most 1.3 times the one before
    falls(f"cooling, {scheme}", errors, ORDER_ONE if scheme == "beuler" else ORDER_TWO, 3)

# ---- a bin that begins to flow out, against its own solution with much shorter steps ----


def bin_run(name, **options):
    return program.run("accuracy_steers.yaml", name, options)


def quantities(run):
    """Mass that has left, rate and energy of motion at the end."""
    monitor = run.monitor
    return np.array([monitor["mass"][0] - monitor["mass"][-1], monitor["flux_orifice"][-1], monitor["kinetic_energy"][-1]])


NAMES = ("mass that has left", "rate of discharge", "kinetic energy")
runs = {accuracy: bin_run(f"bin_{accuracy:g}", accuracy=accuracy) for accuracy in (1e-1, 5e-2, 2e-2, 8e-3)}
at = {accuracy: quantities(run) for accuracy, run in runs.items()}
exact = at[8e-3] + (at[8e-3] - at[2e-2]) / 1.5  # order 1, and steps of two fifths
for number, name in enumerate(NAMES):
    errors = {accuracy: abs(found[number] / exact[number] - 1) for accuracy, found in at.items()}
    # The first steps grow by no more than 1.3 each, so that at 1e-1 errors are smaller than was asked for.
    checks.below(f"bin, {name}, accuracy 0.1: error over accuracy", errors[1e-1] / 1e-1, 3)
    falls(f"bin, {name}", {accuracy: errors[accuracy] for accuracy in (5e-2, 2e-2)}, ORDER_ONE, 3)

# ---- what must not matter ----

usual = len(runs[5e-2].monitor["time"])
for name, options in (("20 cm of empty cells over the bed", {"empty": "20 cm", "empty_cells": 50}),
                      ("half the velocity scale", {"scale_velocity": 0.05})):
    run = bin_run(name.replace(" ", "_"), accuracy=5e-2, **options)
    checks.close(f"bin, {name}: steps over those without", len(run.monitor["time"]) / usual, 1, absolute=0.1)
    for number, quantity in enumerate(NAMES):
        checks.close(f"bin, {name}: {quantity} over that without", quantities(run)[number] / at[5e-2][number], 1,
                     absolute=2e-3)
checks.verdict()
