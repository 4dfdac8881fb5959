"""Discharge of flat-floored bins by discrete elements, as reference data: input for LAMMPS, its run, numbers from it.

    scripts/reference/discrete_elements.py anand|paper [--work out/discrete_elements] [--only NAME,...] [--dry-run]

Settles spheres in a bin, opens the slot in its floor, and measures the discharge. Needs LAMMPS, in Debian the package
`lammps`; Scree itself does not. What is there already is not run again. Writes CSV files into the folder `reference` of
cases/silo_anand, or of cases/why_c for the bin of Srivastava & Sundaresan (2003): the mass discharged against time, the
fields of the steady part on cells of two diameters, and a row a run of numbers.
The grains are those of `pair_style granular`: springs and dashpots along the normal, springs with a Coulomb limit across
it. Units are cgs. x is across the bin from its middle, y up from its floor, z along the slot, where the bin is periodic."""
import argparse
import csv
import dataclasses
import json
import math
import resource
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from scree import slot_flow

ROOT = Path(__file__).resolve().parents[2]
GRAVITY = 981.0  # [cm/s2]
STEPS_PER_COLLISION = 40
BELOW = 3.0  # where grains leave the box, under the floor [cm]
LATTICE = 1.2  # distance of the grains before they settle, in diameters; they are shaken by 0.09 diameters
VISCOUS_SPEED = 100.0  # at which grains fall while they settle first [cm/s]
FRAME = 5e-3  # between two dumps of all grains [s]
CELL = 2.0  # of the fields, in diameters
TANGENTIAL = 2 / 7  # stiffness across over along the normal, as in Silbert et al. (2001)


@dataclass(frozen=True)
class Bin:
    """A bin of spheres, in cgs units."""

    name: str
    count: int
    width: float
    depth: float  # periodic
    orifice: float
    diameter: float
    density: float
    friction: float  # between grains, and with the floor
    restitution: float
    wall_restitution: float
    stiffness: float  # of the normal spring [dyn/cm]
    settle: float  # [s], half of it with a viscous drag
    discharge: float  # [s]
    window: tuple  # of the fields [s]
    rate_window: tuple  # of the rate [s]
    rolling: float = 0.0  # greatest rolling torque over normal force times reduced radius
    wall_friction: float = None  # with the sides; None: as with the floor
    seed: int = 1

    @property
    def mass(self):
        """Of a grain [g]."""
        return self.density * math.pi / 6 * self.diameter**3

    def damping(self, restitution, mass):
        """gamma of the dashpot m gamma v, m the reduced mass, that gives the restitution of a linear spring [1/s]."""
        loss = -math.log(restitution)
        return 2 * math.sqrt(self.stiffness / mass) * loss / math.hypot(math.pi, loss)

    def collision_time(self):
        """Of two grains [s]."""
        reduced = self.mass / 2
        return math.pi / math.sqrt(self.stiffness / reduced - self.damping(self.restitution, reduced) ** 2 / 4)

    def step(self):
        """Of time [s]."""
        return self.collision_time() / STEPS_PER_COLLISION

    def steps_between(self):
        """Steps between two lines of the mass, and between two frames: five times as many."""
        every = round(FRAME / 5 / self.step())
        return every, 5 * every


#: Anand et al. (2008), Chem. Eng. Sci. 63, 5821, base case: dimensions as in Lethe's example of it. Rolling friction of
#: 0.1786 is in Lethe's input (0.02 cm over the radius), not in its list of what the paper says.
ANAND = Bin("anand", 6790, 12.544, 0.56, 2.5088, 0.224, 2.5, 0.2, 0.94, 0.9, stiffness=2e6, settle=0.7, discharge=2.4,
            window=(0.15, 0.45), rate_window=(0.07, 0.72))
#: Softer contacts, for what takes longer steps and for what stiffness changes.
SOFT = dataclasses.replace(ANAND, name="anand_soft", stiffness=ANAND.stiffness / 4, discharge=0.75)
#: The bin of Srivastava & Sundaresan (2003), a slice of it filled 10 cm high. Friction and rolling are those with which
#: a shear cell of these spheres has the paper's angle of friction, sin 28.5 deg = 0.477; the sides have its 12.3 deg.
PAPER = Bin("paper", 22500, 8.0, 0.25, 1.4, 0.1, 2.9, 0.5, 0.91, 0.91, stiffness=3e5, settle=0.7, discharge=0.35,
            window=(0.15, 0.35), rate_window=(0.1, 0.35), rolling=0.15, wall_friction=math.tan(math.radians(12.3)))
BINS = {
    "anand": (ANAND, SOFT,
              dataclasses.replace(SOFT, name="anand_soft_rolling", rolling=0.1786, discharge=2.4)),
    "paper": (PAPER,),
}
REFERENCES = {"anand": ROOT / "cases" / "silo_anand" / "reference", "paper": ROOT / "cases" / "why_c" / "reference"}


# ---- input ----


def contact(silo, restitution, reduced_mass, friction):
    """The contact law of pair_style granular, for grains or for a wall."""
    words = (f"hooke {silo.stiffness:.8g} {silo.damping(restitution, reduced_mass):.8g} damping mass_velocity "
             f"tangential linear_history {TANGENTIAL * silo.stiffness:.8g} 0.5 {friction:g}")
    if silo.rolling:
        # The rolling spring is that of the tangent; its dashpot critically damps a grain of this size.
        stiffness = TANGENTIAL * silo.stiffness
        words += f" rolling sds {stiffness:.8g} {2 * math.sqrt(stiffness * reduced_mass):.8g} {silo.rolling:g}"
    return words


def grains(silo):
    """Places of the grains before they settle, (count, 3): a shaken lattice that fills the width of the bin."""
    random = np.random.default_rng(silo.seed)
    step = LATTICE * silo.diameter
    across, along = int(silo.width / step), max(1, int(silo.depth / step))
    number = np.arange(silo.count)
    spacing = np.array([silo.width / across, step, silo.depth / along])
    column = np.stack([number % across, number // (across * along), number // across % along], axis=1)
    places = (column + 0.5) * spacing - [silo.width / 2, 0, 0]
    return places + random.uniform(-0.09, 0.09, places.shape) * silo.diameter


def data_file(silo, places):
    """The grains as LAMMPS reads them."""
    top = places[:, 1].max() + 2 * silo.diameter
    side = silo.width / 2 + silo.diameter
    lines = ["grains before they settle", "", f"{silo.count} atoms", "1 atom types", "", f"{-side} {side} xlo xhi",
             f"{-BELOW} {top} ylo yhi", f"0 {silo.depth} zlo zhi", "", "Atoms # sphere", ""]
    lines += [f"{n} 1 {silo.diameter:g} {silo.density:g} {x:.6f} {y:.6f} {z:.6f}" for n, (x, y, z) in enumerate(places, 1)]
    return "\n".join(lines) + "\n"


def grain_commands(silo):
    """Contacts between grains, and their motion."""
    return f"""neighbor {0.2 * silo.diameter:g} bin
neigh_modify delay 0 every 5 check yes
pair_style granular
pair_coeff * * {contact(silo, silo.restitution, silo.mass / 2, silo.friction)}
timestep {silo.step():.8g}
fix motion all nve/sphere"""


def lammps_input(silo):
    """The input: settles, opens the slot at once, discharges. A plate 0.1 diameters thick is what remains of the floor."""
    every, frame = silo.steps_between()
    settling = frame * round(silo.settle / 2 / FRAME)
    floor = contact(silo, silo.wall_restitution, silo.mass, silo.friction)
    smooth = silo.friction if silo.wall_friction is None else silo.wall_friction
    sides = contact(silo, silo.wall_restitution, silo.mass, smooth)
    half, far, plate = silo.width / 2, silo.width, 0.1 * silo.diameter
    return f"""units cgs
atom_style sphere
boundary f f p
newton off
comm_modify vel yes
read_data grains.data
{grain_commands(silo)}
fix weight all gravity {GRAVITY:g} vector 0 -1 0
fix sides all wall/gran granular {sides} xplane {-half:g} {half:g}
fix floor all wall/gran granular {floor} yplane 0 NULL
compute pairs all pair/local dist
compute nearest all reduce min c_pairs
thermo_style custom step atoms ke c_nearest
thermo {frame}
thermo_modify lost ignore norm no flush yes

fix drag all viscous {silo.mass * GRAVITY / VISCOUS_SPEED:.6g}
run {settling}
unfix drag
run {settling}
write_dump all custom settled.dump x y z vx vy vz modify format float %.6g

unfix floor
region left block {-far:g} {-silo.orifice / 2:g} {-plate:g} 0 -100 100 side out units box
region right block {silo.orifice / 2:g} {far:g} {-plate:g} 0 -100 100 side out units box
fix left all wall/gran/region granular {floor} region left
fix right all wall/gran/region granular {floor} region right
region inside block INF INF {-silo.diameter / 2:g} INF INF INF units box
variable seconds equal (step-{2 * settling})*dt
variable inside equal count(all,inside)
fix out all print {every} "${{seconds}} ${{inside}}" file discharged.txt screen no title "# time inside"
dump frames all custom {frame} frames.dump x y vx vy vz
dump_modify frames format float %.5g first yes
run {frame * round(silo.discharge / FRAME)}
write_dump all custom end.dump x y z vx vy vz modify format float %.6g
"""


def run(silo, directory, command):
    """Runs LAMMPS; leaves bin.json with the CPU seconds that it took when it has ended well."""
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    (directory / "grains.data").write_text(data_file(silo, grains(silo)))
    (directory / "bin.in").write_text(lammps_input(silo))
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    with open(directory / "screen", "w") as screen:
        subprocess.run([command, "-in", "bin.in"], cwd=directory, stdout=screen, stderr=subprocess.STDOUT, check=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    (directory / "bin.json").write_text(json.dumps({**dataclasses.asdict(silo), "cpu_seconds": seconds}))


def is_done(silo, directory):
    """Whether the run of this very bin is there."""
    kept = directory / "bin.json"
    stored = json.loads(kept.read_text()) if kept.exists() else {}
    return all(stored.get(name) == (list(value) if isinstance(value, tuple) else value)
               for name, value in dataclasses.asdict(silo).items())


# ---- what a run leaves ----


def frames(path):
    """The frames of a dump: (number of the step, array of the grains by columns), one after the other."""
    with open(path) as file:
        while file.readline():  # ITEM: TIMESTEP
            step = int(file.readline())
            file.readline()
            count = int(file.readline())
            for _ in range(4):  # the box
                file.readline()
            columns = len(file.readline().split()) - 2
            values = np.array(" ".join(file.readline() for _ in range(count)).split(), dtype=float)
            yield step, values.reshape(count, columns)


def nearest(screen, start):
    """Smallest distances of two grains [cm], of the lines that LAMMPS writes from a step on."""
    lines = (line.split() for line in Path(screen).read_text().splitlines())
    return np.array([float(words[3]) for words in lines
                     if len(words) == 4 and words[0].isdigit() and words[1].isdigit() and int(words[0]) >= start])


class Fields:
    """Solids fraction, velocity and granular temperature on cells, as means over frames of grains.

    A grain counts in the cells that its parts lie in. Fields are mirrored at x = 0, and hold x > 0: arrays (y, x)."""

    def __init__(self, silo, top):
        across = round(silo.width / 2 / (CELL * silo.diameter))
        self.silo, self.size = silo, silo.width / 2 / across
        below = math.ceil(1.0 / self.size)  # cells under the floor
        self.x_faces = self.size * np.arange(across + 1)
        self.y_faces = self.size * np.arange(-below, math.ceil(top / self.size) + 1)
        self.parts = sphere_points() * silo.diameter / 2

    def sums(self, x, y, weights):
        """Sums of weights of grains over cells, [weight, y, x]."""
        px = np.abs(x[:, None] + self.parts[:, 0]) / self.size
        py = (y[:, None] + self.parts[:, 1] - self.y_faces[0]) / self.size
        nx, ny = len(self.x_faces) - 1, len(self.y_faces) - 1
        i, j = np.minimum(px.astype(int), nx - 1), np.floor(py).astype(int)
        good = (j >= 0) & (j < ny)
        cell = (j * nx + i)[good]
        return np.stack([np.bincount(cell, np.broadcast_to(w[:, None] / len(self.parts), good.shape)[good], nx * ny)
                         for w in weights]).reshape(len(weights), ny, nx)

    def mean(self, grains_of_frames):
        """nu, vx, vy, T of frames of columns x, y, vx, vy, vz; T = (1/3) of the mean square of the fluctuations."""
        grains_of_frames = list(grains_of_frames)
        total = sum(self.sums(g[:, 0], g[:, 1], [np.ones(len(g)), np.sign(g[:, 0]) * g[:, 2], g[:, 3], g[:, 4]])
                    for g in grains_of_frames)
        count = np.maximum(total[0], 1e-12)
        velocity = total[1:] / count
        squares = 0
        for g in grains_of_frames:
            at = np.clip((np.abs(g[:, 0]) / self.size) - 0.5, 0, None), (g[:, 1] - self.y_faces[0]) / self.size - 0.5
            own = np.stack([np.sign(g[:, 0]) * g[:, 2], g[:, 3], g[:, 4]])
            squares = squares + self.sums(g[:, 0], g[:, 1], [np.sum((own - bilinear(velocity, *at)) ** 2, axis=0)])[0]
        volume = self.size**2 * 2 * self.silo.depth * len(grains_of_frames)  # both halves
        nu = total[0] * self.silo.mass / self.silo.density / volume
        return nu, velocity[0], velocity[1], squares / count / 3


def bilinear(fields, i, j):
    """Fields [n, y, x] at fractional cells i along x and j along y."""
    rows, columns = fields.shape[1:]
    i, j = np.clip(i, 0, columns - 1.001), np.clip(j, 0, rows - 1.001)
    i0, j0 = i.astype(int), j.astype(int)
    a, b = i - i0, j - j0
    return ((1 - b) * ((1 - a) * fields[:, j0, i0] + a * fields[:, j0, i0 + 1])
            + b * ((1 - a) * fields[:, j0 + 1, i0] + a * fields[:, j0 + 1, i0 + 1]))


def sphere_points(shells=3, around=8):
    """Points (x, y) that share the volume of a unit sphere seen along z in equal parts."""
    points = []
    for shell in range(shells):
        # A cylinder of radius r along z cuts a part 1 - (1 - r^2)^1.5 off the sphere.
        radius = math.sqrt(1 - (1 - (shell + 0.5) / shells) ** (2 / 3))
        angle = 2 * math.pi * (np.arange(around) + 0.5 * shell) / around
        points.append(radius * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    return np.concatenate(points)


class Measured:
    """The numbers of one run."""

    def __init__(self, silo, directory):
        self.silo = silo
        table = np.loadtxt(directory / "discharged.txt")
        self.time, self.mass = table[:, 0], silo.mass * (silo.count - table[:, 1])
        self.rate = slot_flow.slope(self.time, self.mass, silo.rate_window)
        _, settled = next(frames(directory / "settled.dump"))
        self.fill_nu, self.fill_height = filling(silo, settled)
        found = frames(directory / "frames.dump")
        start, _ = next(found)
        steady = [one for number, one in found
                  if silo.window[0] - 1e-9 <= (number - start) * silo.step() <= silo.window[1] + 1e-9]
        self.fields = Fields(silo, self.fill_height)
        nu, vx, vy, temperature = self.fields.mean(steady)
        self.flow = slot_flow.Flow(self.fields.x_faces, self.fields.y_faces, nu, vx, vy, temperature)
        overlaps = 1 - nearest(directory / "screen", start) / silo.diameter
        self.overlap = overlaps.mean(), overlaps.max()  # of the greatest of all contacts, every FRAME seconds
        _, self.end = next(frames(directory / "end.dump"))
        self.seconds = json.loads((directory / "bin.json").read_text()).get("cpu_seconds")

    def plug(self):
        """Speed of a plug over the whole width that has this rate [cm/s]."""
        return self.rate / (self.silo.density * self.fill_nu * self.silo.width * self.silo.depth)

    def is_empty(self):
        """Whether the run went on until hardly anything flows: less than a hundredth leaves in its last tenth."""
        late = self.mass[-1] - np.interp(0.9 * self.time[-1], self.time, self.mass)
        return late < 0.01 * self.silo.count * self.silo.mass

    def wedge(self):
        """Heights of what remains at the end over the cells along x > 0 [cm], at the solids fraction of the fill."""
        inside = self.end[self.end[:, 1] > 0]
        volume = self.fields.sums(inside[:, 0], inside[:, 1], [np.ones(len(inside))])[0].sum(axis=0)
        return volume * self.silo.mass / self.silo.density / (2 * self.silo.depth * self.fields.size * self.fill_nu)

    def row(self):
        """The numbers of the table of all runs."""
        silo, flow, plug = self.silo, self.flow, self.plug()
        x = slot_flow.centres(self.fields.x_faces)
        return {
            "run": silo.name, "stiffness [dyn/cm]": f"{silo.stiffness:g}", "rolling": silo.rolling, "seed": silo.seed,
            "fill nu": f"{self.fill_nu:.4f}", "fill height [cm]": f"{self.fill_height:.3f}",
            "rate [g/s]": f"{self.rate:.2f}", "rate [g/s/cm]": f"{self.rate / silo.depth:.2f}",
            "C": f"{slot_flow.coefficient(self.rate / silo.depth, silo.density, self.fill_nu, silo.orifice):.3f}",
            "plug [cm/s]": f"{plug:.3f}", "corner / plug": f"{flow.corner() / plug:.2e}",
            "shoulder angle [deg]": f"{flow.line_angle(plug):.1f}",
            "shoulder at 2 cm [cm]": f"{flow.line_at(plug, 2.0):.2f}",
            "shoulder height at the wall [cm]": f"{flow.height_at_wall(plug):.2f}",
            "nu in the orifice": f"{flow.in_orifice(flow.nu):.3f}",
            "nu over the orifice": f"{flow.above_orifice(flow.nu):.3f}",
            "T over the orifice [cm2/s2]": f"{flow.above_orifice(flow.temperature):.1f}",
            "remaining [g]": f"{silo.mass * np.sum(self.end[:, 1] > 0):.2f}" if self.is_empty() else "",
            "wedge angle [deg]": f"{slot_flow.wedge_angle(x, self.wedge(), silo.diameter):.1f}" if self.is_empty() else "",
            "greatest overlap / d": f"{self.overlap[1]:.4f}", "mean greatest overlap / d": f"{self.overlap[0]:.4f}",
            "cpu [s]": f"{self.seconds:.0f}" if self.seconds else "",
        }


def filling(silo, settled):
    """Solids fraction of the bed at rest over the width, and the height that its mass has with it [cm].

    The fraction is that between two diameters above the floor and four below the top, where layers do not count."""
    y = np.sort(settled[:, 1])
    low, high = 2 * silo.diameter, y[-len(y) // 50] - 4 * silo.diameter
    radius = silo.diameter / 2

    def part_below(level):  # of each sphere
        h = np.clip((level - y + radius) / silo.diameter, 0, 1)
        return 3 * h**2 - 2 * h**3

    volume = np.sum(part_below(high) - part_below(low)) * silo.mass / silo.density
    nu = volume / ((high - low) * silo.width * silo.depth)
    return nu, silo.count * silo.mass / silo.density / (nu * silo.width * silo.depth)


# ---- files ----


def source(silo):
    return f"scripts/reference/discrete_elements.py {group(silo)}, run {silo.name}: LAMMPS, {silo.count} spheres"


def group(silo):
    return next(name for name, bins in BINS.items() if any(one.name == silo.name for one in bins))


def write(path, head, columns, rows):
    """A CSV file: a comment that says where it comes from, names of the columns, rows."""
    with open(path, "w", newline="") as file:
        file.write(f"# {head}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(columns)
        table.writerows(rows)


def write_run(measured):
    """mass_NAME.csv and fields_NAME.csv of a run."""
    silo = measured.silo
    every = slice(None, None, 10)  # 10 ms
    folder = REFERENCES[group(silo)]
    write(folder / f"mass_{silo.name}.csv", f"{source(silo)}; grains that are below the slot as a whole",
          ["time [s]", "discharged [g]"],
          [(f"{t:.3f}", f"{m:.3f}") for t, m in zip(measured.time[every], measured.mass[every])])
    flow = measured.flow
    rows = [(f"{x:.4f}", f"{y:.4f}", f"{flow.nu[j, i]:.4f}", f"{flow.vx[j, i]:.4g}", f"{flow.vy[j, i]:.4g}",
             f"{flow.temperature[j, i]:.4g}") for j, y in enumerate(flow.y) for i, x in enumerate(flow.x)]
    write(folder / f"fields_{silo.name}.csv",
          f"{source(silo)}; means from {silo.window[0]} to {silo.window[1]} s over both halves and over cells of "
          f"{measured.fields.size:.4f} cm; x from the middle, y from the floor, centres of cells",
          ["x [cm]", "y [cm]", "nu", "vx [cm/s]", "vy [cm/s]", "T [cm2/s2]"], rows)


def write_numbers(rows, name):
    write(REFERENCES[name] / f"{name}.csv", f"scripts/reference/discrete_elements.py {name}: LAMMPS, a row a run",
          list(rows[0]), [list(row.values()) for row in rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", choices=sorted(BINS), help="the bin")
    parser.add_argument("--work", type=Path, default=Path("out/discrete_elements"), help="directory of the runs")
    parser.add_argument("--only", help="runs, separated by commas")
    parser.add_argument("--command", default=shutil.which("lmp") or "lmp", help="LAMMPS")
    parser.add_argument("--dry-run", action="store_true", help="write the input of LAMMPS to the screen, run nothing")
    given = parser.parse_args()
    chosen = [silo for silo in BINS[given.bin] if not given.only or silo.name in given.only.split(",")]
    for silo in chosen:
        if given.dry_run:
            print(lammps_input(silo))
        elif not is_done(silo, given.work / silo.name):
            print(f"{silo.name}: {silo.count} grains, step {silo.step():.3g} s", flush=True)
            run(silo, given.work / silo.name, given.command)
    if given.dry_run:
        return
    REFERENCES[given.bin].mkdir(parents=True, exist_ok=True)
    measured = [Measured(silo, given.work / silo.name) for silo in BINS[given.bin] if is_done(silo, given.work / silo.name)]
    for one in measured:
        write_run(one)
    write_numbers([one.row() for one in measured], given.bin)


if __name__ == "__main__":
    main()
