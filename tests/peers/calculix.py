"""One blade of solid elements in CalculiX: its deck, the run, and the modes told apart."""

import math
import os
import re
import shutil
import subprocess
import time

# Corners of a C3D20R, then the middles of its edges, in half elements along x, y, z.
BRICK = (
    (0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0),
    (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
    (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0),
    (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
    (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1),
)  # fmt: skip
MODES = 12
# Participation factors of motions that are not of a mode are below this (the equations at a root that
# may contract leave 1e-5); those that are, are 1e-3 and more.
NONE = 1e-4


def program():
    return shutil.which("ccx")


def version():
    text = subprocess.run([program(), "-v"], capture_output=True, text=True).stdout
    return re.search(r"Version (\S+)", text).group(1)


def mesh(strip, elements):
    """Nodes {lattice point: (number, coordinates)} and elements [node numbers] of the strip."""
    sizes = (strip["radius"] - strip["root"], strip["chord"], strip["thickness"])
    origin = (strip["root"], -strip["chord"] / 2, -strip["thickness"] / 2)
    nodes, bricks = {}, []
    for i in range(elements[0]):
        for j in range(elements[1]):
            for k in range(elements[2]):
                brick = []
                for offset in BRICK:
                    at = tuple(
                        2 * index + half for index, half in zip((i, j, k), offset)
                    )
                    if at not in nodes:
                        place = [
                            o + s * a / (2 * n)
                            for o, s, a, n in zip(origin, sizes, at, elements)
                        ]
                        nodes[at] = (len(nodes) + 1, place)
                    brick.append(nodes[at][0])
                bricks.append(brick)
    return nodes, bricks


def clamp(nodes, held):
    """The root section stays plane and upright. Held, it also keeps its shape; else it may change it,
    as a beam's section does where it bends, and only its mean motion and rotation about x are none."""
    root = [(number, place) for at, (number, place) in nodes.items() if at[0] == 0]
    lines = ["*NSET, NSET=ROOT", *(f"{number}," for number, _ in root), "*BOUNDARY"]
    if held:
        return [*lines, "ROOT, 1, 3"]
    lines.append("ROOT, 1, 1")
    means = [[(number, axis, 1.0) for number, _ in root] for axis in (2, 3)]
    turn = [(number, 3, y) for number, (_, y, _) in root] + [
        (number, 2, -z) for number, (_, _, z) in root
    ]
    # The first degree of freedom of an equation is eliminated, so each begins with another one.
    turn.sort(key=lambda term: -term[2])
    for terms in (*means, [term for term in turn if term[2]]):
        lines += ["*EQUATION", f"{len(terms)}"]
        flat = [f"{number}, {axis}, {factor:.15g}" for number, axis, factor in terms]
        lines += [", ".join(flat[i : i + 4]) for i in range(0, len(flat), 4)]
    return lines


def deck(strip, poisson, held, elements, speed):
    """Blade along x, turning about z: lag along y, flap along z."""
    nodes, bricks = mesh(strip, elements)
    lines = ["*NODE, NSET=ALL"]
    lines += [
        f"{number}, {x:.15g}, {y:.15g}, {z:.15g}"
        for number, (x, y, z) in nodes.values()
    ]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=BLADE")
    for number, brick in enumerate(bricks, 1):
        lines.append(f"{number}, " + ", ".join(map(str, brick[:15])) + ",")
        lines.append(", ".join(map(str, brick[15:])))
    lines += clamp(nodes, held)
    lines += [
        "*MATERIAL, NAME=M",
        "*ELASTIC",
        f"{strip['youngs_modulus']:.15g}, {poisson}",
    ]
    lines += [
        "*DENSITY",
        f"{strip['density']:.15g}",
        "*SOLID SECTION, ELSET=BLADE, MATERIAL=M",
    ]
    if speed:
        # The magnitude of CENTRIF is the speed squared; then a point of the axis and its direction.
        load = f"BLADE, CENTRIF, {speed * speed:.15g}, 0., 0., 0., 0., 0., 1."
        lines += ["*STEP", "*STATIC", "*DLOAD", load, "*END STEP"]
    lines += [
        "*STEP, PERTURBATION" if speed else "*STEP",
        "*FREQUENCY",
        f"{MODES}",
        "*END STEP",
    ]
    return "\n".join(lines) + "\n"


def solve(folder, strip, poisson, held, elements, speed):
    """{label: rad/s} of the modes that CalculiX finds, and the time of the whole process [s]."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "blade.inp").write_text(deck(strip, poisson, held, elements, speed))
    # One thread: the same sums in the same order on any machine.
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    start = time.perf_counter()
    run = subprocess.run(
        [program(), "blade"],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
    )
    seconds = time.perf_counter() - start
    if run.returncode != 0 or "*ERROR" in run.stdout:
        raise SystemExit(f"peers: CalculiX failed in {folder}:\n{run.stdout[-2000:]}")
    return modes((folder / "blade.dat").read_text()), seconds


def rows(text, title):
    """The numbers of the table under a spaced title of the .dat file, one list per mode."""
    body = text.split(title, 1)[1]
    found = re.findall(r"^ +\d+((?: +-?\d\.\d+E[+-]\d+)+) *$", body, re.M)
    return [[float(number) for number in row.split()] for row in found[:MODES]]


def modes(text):
    """Told apart by what a mode moves as a whole: y in lag, z in flap, rotation about x in torsion."""
    eigenvalues = rows(text, "E I G E N V A L U E   O U T P U T")
    factors = rows(text, "P A R T I C I P A T I O N   F A C T O R S")
    found, counts = {}, dict.fromkeys("LFT", 0)
    for (square, *_), (_, y, z, about_x, _, _) in zip(eigenvalues, factors):
        moving = [
            letter for letter, part in zip("LFT", (y, z, about_x)) if abs(part) > NONE
        ]
        if len(moving) != 1:
            raise SystemExit(
                f"peers: CalculiX's mode at {math.sqrt(square)} rad/s is neither flap, lag nor torsion"
            )
        letter = moving[0]
        counts[letter] += 1
        found[f"{counts[letter]}{letter}"] = math.sqrt(square)
    return found
