"""Friction of spheres in simple shear by discrete elements: where the angle of friction of a case can come from.

    scripts/reference/shear_cell.py [anand|paper] [--work out/shear_cell]

Shears a periodic box of the spheres of a bin of discrete_elements.py with LAMMPS, at several solids fractions, each at a
constant one. Writes shear_cell.csv into the folder of the reference data of that bin: the ratio of stresses against the
inertial number, means over the second half."""
import argparse
import dataclasses
import math
import shutil
import subprocess
from pathlib import Path

import numpy as np

from scree.discrete_elements import ANAND, PAPER, REFERENCES, TANGENTIAL, grain_commands, write

COUNT = 8  # spheres along each axis
FRACTIONS = (0.56, 0.575, 0.585, 0.595, 0.605)
SPHERES = {"anand": ANAND, "paper": PAPER}
ROLLING = {"anand": (0.0, 0.1786), "paper": (0.0, PAPER.rolling)}  # as in the runs of the bins, and none
RATE = 10.0  # of shear [1/s]
STRAIN = 4.0
COMPRESS = 0.1  # seconds in which the box shrinks to the solids fraction


def lammps_input(silo, fraction):
    """The input for one solids fraction."""
    start = 1.1 * silo.diameter * COUNT
    side = (COUNT**3 * math.pi / 6 / fraction) ** (1 / 3) * silo.diameter
    low, high = (start - side) / 2, (start + side) / 2
    box = " ".join(f"{axis} final {low:.8g} {high:.8g}" for axis in "xyz")
    compress, shear = round(COMPRESS / silo.step()), round(STRAIN / RATE / silo.step())
    every = shear // 400
    return f"""units cgs
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
box tilt large
lattice sc {1.1 * silo.diameter:.8g}
region box prism 0 {start:.8g} 0 {start:.8g} 0 {start:.8g} 0 0 0 units box
create_box 1 box
create_atoms 1 box
set group all diameter {silo.diameter:g}
set group all density {silo.density:g}
displace_atoms all random {0.04 * silo.diameter:g} {0.04 * silo.diameter:g} {0.04 * silo.diameter:g} {silo.seed} units box
{grain_commands(silo)}
fix squeeze all deform 1 {box} remap x units box
run {compress}
unfix squeeze
fix shear all deform 1 xy erate {RATE:g} remap v units box
velocity all ramp vx 0 {RATE * side:.8g} y {low:.8g} {high:.8g} units box
compute warmth all temp/deform
compute stress all pressure warmth
variable xy equal -c_stress[4]
variable yy equal c_stress[2]
variable mean equal c_stress
fix out all ave/time {every} 1 {every} v_xy v_yy v_mean file stress.txt
run {shear}
"""


def run(silo, fraction, directory, command):
    """Runs LAMMPS; leaves the file `done` when it has ended well."""
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "shear.in").write_text(lammps_input(silo, fraction))
    with open(directory / "screen", "w") as screen:
        subprocess.run([command, "-in", "shear.in"], cwd=directory, stdout=screen, stderr=subprocess.STDOUT, check=True)
    (directory / "done").touch()


def row(silo, fraction, directory):
    """Means over the second half of the strain, and the error of the mean from eight parts of it."""
    values = np.loadtxt(directory / "stress.txt")
    late = values[len(values) // 2:, 1:]
    shear, normal, mean = late.mean(axis=0)
    parts = np.array([p[:, 0].mean() / p[:, 2].mean() for p in np.array_split(late, 8)])
    inertial = RATE * silo.diameter * math.sqrt(silo.density / mean)
    return [f"{silo.rolling:g}", f"{fraction:g}", f"{mean:.4g}", f"{inertial:.4g}", f"{shear / mean:.4f}",
            f"{parts.std(ddof=1) / math.sqrt(8):.4f}", f"{shear / normal:.4f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", nargs="?", default="anand", choices=sorted(SPHERES), help="whose spheres (anand)")
    parser.add_argument("--work", type=Path, default=Path("out/shear_cell"), help="directory of the runs")
    parser.add_argument("--command", default=shutil.which("lmp") or "lmp", help="LAMMPS")
    given = parser.parse_args()
    rows = []
    spheres = SPHERES[given.bin]
    for rolling in ROLLING[given.bin]:
        silo = dataclasses.replace(spheres, rolling=rolling)
        for fraction in FRACTIONS:
            directory = given.work / given.bin / f"rolling_{rolling:g}_{fraction:g}"
            if not (directory / "done").exists():
                run(silo, fraction, directory, given.command)
            rows.append(row(silo, fraction, directory))
            print(rows[-1], flush=True)
    write(REFERENCES[given.bin] / "shear_cell.csv",
          f"scripts/reference/shear_cell.py: LAMMPS, {COUNT**3} spheres of mu {spheres.friction:g}, e {spheres.restitution:g} "
          f"(across the contact {TANGENTIAL:.3f} of the stiffness) at a rate of shear of {RATE:g} 1/s",
          ["rolling", "nu", "p [dyn/cm2]", "inertial number", "tau/p", "error", "tau/p_yy"], rows)


if __name__ == "__main__":
    main()
