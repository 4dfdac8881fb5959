#!/usr/bin/env python3
"""Growth rates of short waves about homogeneous shear under each stress law: where the law is well-posed.

    scripts/growth_rates.py [--build build] [--out out/growth_rates] [--case CASE.yaml [-option value ...]]
                            [--nu 0.55,0.60] [--I 1e-4,1e-3,...] [--ratio 0,-0.1,0.1] [--laws 'NAME; ...']

The rates are eigenvalues of the program's own Jacobian, by the program growth_rates of the tests
(tests/stability/growth/growth_rates.cpp), which says what a base state is. Each law is a set of options of a case. Of
each, over a grid of nu, inertial number I and ratio div v/gdot, the greatest growth rate is written against the wave
number, in OUT/rates.csv. OUT/laws.csv and the screen have a line for each base state, OUT/growth_rates.png draws them:

    greatest     greatest growth rate over the rate of shear, of waves down to k d = 1: six diameters long
    shortest     the same of the shortest wave that was looked at, k d = 1e4
    exponent     d ln(growth)/d ln(k) over the last decade; nan where the shortest waves decay
    verdict      `decay`: the shortest waves do; `bounded`: they grow, no faster the shorter they are; `ill-posed`: growth
                 rises with k without a bound, and a finer grid shows another flow

With --case the law is that of a case file, with options behind it, and the built-in ones are left out."""
import argparse
import csv
import io
import subprocess
from pathlib import Path

import numpy as np
from scree.plots import draw_to_files, plt

ROOT = Path(__file__).resolve().parents[1]
CASE = ROOT / "tests" / "stability" / "growth" / "shear.yaml"
GLASS = {"friction_angle": "0.3918512493881 rad", "friction_coefficient_limit": 0.6435, "friction_inertial_number": 0.278}
COLD = {"granular_temperature": "constant", "granular_temperature_value": 0, "friction_strain_rate_floor": 1e-6}
EPS = {"friction_fluctuation": 0, "friction_strain_rate_floor": 1}

#: Name -> options of the case. The first five are those of the paper's particles with transported T; the others are
#: friction alone, without T, of glass beads.
LAWS = {
    "relaxed, c = 1": {"friction_model": "relaxed"},
    "relaxed, c = 0, eps = 1 1/s": {"friction_model": "relaxed", **EPS},
    "instantaneous, c = 1": {"friction_model": "instantaneous"},
    "critical_state, c = 1": {"friction_model": "critical_state"},
    "critical_state, c = 0, eps = 1 1/s": {"friction_model": "critical_state", **EPS},
    "critical_state, cold": {"friction_model": "critical_state", **COLD, "friction_angle": GLASS["friction_angle"]},
    "critical_state, mu_i": {"friction_model": "critical_state", **COLD, **GLASS, "friction_coefficient": "mu_i"},
    "critical_state, mu_i_regularised": {"friction_model": "critical_state", **COLD, **GLASS,
                                         "friction_coefficient": "mu_i_regularised"},
    "relaxed, mu_i": {"friction_model": "relaxed", **COLD, **GLASS, "friction_coefficient": "mu_i"},
    "relaxed, cidr": {"friction_model": "relaxed", **COLD, **GLASS, "friction_coefficient": "cidr"},
}
WAVES = np.geomspace(1e-2, 1e4, 19)
#: A growth that rises by less than this power of k over the last decade has a bound: where it has one, the power is
#: a few hundredths there, and where it has none at least 1/2.
BOUNDED = 0.25
KEYS = ("nu", "I", "ratio")


def numbers(text):
    return [float(word) for word in text.split(",")]


def rates(program, case, options, states):
    """Rows of growth_rates, as dictionaries of numbers, for `states`, tuples of nu, I, div v/gdot, k d."""
    words = [str(program), str(case)] + [str(word) for key, value in options.items() for word in ("-" + key, value)]
    lines = "".join(", ".join(f"{value:.12g}" for value in state) + "\n" for state in states)
    done = subprocess.run(words, input=lines, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr.strip() or f"{program} failed")
    return [{key: float(text) for key, text in row.items()} for row in csv.DictReader(io.StringIO(done.stdout))]


def verdicts(rows):
    """A line for each base state of the rows of one law."""
    lines = []
    for state in dict.fromkeys(tuple(row[key] for key in KEYS) for row in rows):
        here = sorted((row for row in rows if tuple(row[key] for key in KEYS) == state), key=lambda row: row["k_d"])
        k, growth = (np.array([row[key] for row in here]) for key in ("k_d", "growth"))
        growth = growth / here[0]["strain_rate"]
        decade = np.argmin(abs(np.log(k / (k[-1] / 10))))
        grows = min(growth[-1], growth[decade]) > 0
        exponent = np.log(growth[-1] / growth[decade]) / np.log(k[-1] / k[decade]) if grows else np.nan
        lines.append({**dict(zip(KEYS, state)), "strain_rate": here[0]["strain_rate"], "temperature": here[0]["temperature"],
                      "chi": here[0]["chi"], "greatest": growth[k < 1.001].max(), "shortest": growth[-1],
                      "exponent": exponent,
                      "verdict": "decay" if growth[-1] <= 0 else "ill-posed" if exponent > BOUNDED else "bounded"})
    return lines


def write(path, rows):
    with open(path, "w", newline="") as stream:
        table = csv.DictWriter(stream, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}
                        for row in rows)


def draw(path, rows):
    """Growth over the rate of shear against k d, a panel a law, a line an I; the first nu and ratio."""
    draw_to_files(**{"font.size": 9, "axes.labelsize": 9, "axes.titlesize": 9, "savefig.dpi": 110})
    laws = list(dict.fromkeys(row["law"] for row in rows))
    first = {key: rows[0][key] for key in ("nu", "ratio")}
    across = min(len(laws), 5)
    figure, panels = plt.subplots(-(-len(laws) // across), across, figsize=(3 * across, 2.8 * -(-len(laws) // across)),
                                  sharex=True, sharey=True, squeeze=False)
    numbers_I = sorted({row["I"] for row in rows})
    for axes, law in zip(panels.flat, laws):
        for place, I in enumerate(numbers_I):
            line = [(row["k_d"], row["growth"] / row["strain_rate"]) for row in rows
                    if row["law"] == law and row["I"] == I and all(row[key] == first[key] for key in first)]
            axes.plot(*zip(*line), color=plt.cm.viridis(place / max(1, len(numbers_I) - 1)), label=f"{I:g}", linewidth=1.3)
        axes.set_xscale("log")
        axes.set_yscale("symlog", linthresh=1)
        axes.axhline(0, color="0.7", linewidth=0.8)
        axes.axvline(1, color="0.7", linewidth=0.8, linestyle=":")
        axes.set_title(law)
    for axes in panels[-1]:
        axes.set_xlabel("$k\\,d$")
    for axes in panels[:, 0]:
        axes.set_ylabel("growth rate/$\\dot\\gamma$")
    panels.flat[0].legend(title="$I$", fontsize=7, title_fontsize=8)
    figure.savefig(path)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "growth_rates")
    parser.add_argument("--case", type=Path, help="a case file whose law is looked at")
    parser.add_argument("--nu", type=numbers, default=[0.6, 0.55], metavar="NU,...")
    parser.add_argument("--I", type=numbers, default=[1e-4, 1e-3, 1e-2, 1e-1, 1.0], metavar="I,...")
    parser.add_argument("--ratio", type=numbers, default=[0.0, -0.1, 0.1], metavar="RATIO,...", help="div v over the rate of shear")
    parser.add_argument("--laws", metavar="'NAME; ...'", help="some of: " + "; ".join(LAWS))
    given, options = parser.parse_known_args()
    if options and not given.case:
        parser.error(f"{options[0]}: options of a case need --case")
    given.options = dict(zip([word.lstrip("-") for word in options[::2]], options[1::2]))
    chosen = [name.strip() for name in given.laws.split(";")] if given.laws else list(LAWS)
    for name in chosen:
        if name not in LAWS:
            parser.error(f"--laws: no law '{name}'; there are: {'; '.join(LAWS)}")
    given.cases = {given.case.stem: (given.case, given.options)} if given.case else {
        name: (CASE, LAWS[name]) for name in chosen}
    return given


def main():
    given = arguments()
    program = given.build / "bin" / "growth_rates"
    if not program.exists():
        raise SystemExit(f"growth_rates.py: no {program}: scripts/build.sh builds it")
    states = [(nu, I, ratio, k) for nu in given.nu for ratio in given.ratio for I in given.I for k in WAVES]
    every, lines = [], []
    for law, (case, options) in given.cases.items():
        found = rates(program, case, options, states)
        every += [{"law": law, **row} for row in found]
        for line in verdicts(found):
            lines.append({"law": law, **line})
            print("{law:35} nu {nu:<5g} I {I:<7g} ratio {ratio:<5g} greatest {greatest:10.3g} shortest {shortest:10.3g} "
                  "exponent {exponent:6.3f} {verdict}".format(**lines[-1]), flush=True)
    given.out.mkdir(parents=True, exist_ok=True)
    write(given.out / "rates.csv", every)
    write(given.out / "laws.csv", lines)
    draw(given.out / "growth_rates.png", every)
    print(f"written: {given.out}/rates.csv, laws.csv, growth_rates.png")


if __name__ == "__main__":
    main()
