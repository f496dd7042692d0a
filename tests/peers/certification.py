#!/usr/bin/env python3
"""bladefan, coupled, beside BModes and pyBmodes on the certification blade of BModes.

    tests/peers/certification.py FOLDER      compare, and write certification.md

FOLDER holds Test01_nonunif_blade.bmi and .out and blade_sec_props.dat of BModes v3's CertTest, which are not part of
this repository. pyBmodes is the one that `tests/peers/run --install` gets; bladefan as for that script. Exit code 1:
something is out of its tolerance.
"""

import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True

import bmodes
import measure
import ours
import table

NAME = "Test01_nonunif_blade"
RECORD = Path(__file__).parent / "certification.md"
# Parts of every interval of the section table that pyBmodes' elements are.
PARTS = (2, 4, 8, 16)
# Parts of every interval in tables of products of the section table's linear columns.
FINE = 32
MODES = 10
SPEEDS_RPM = (0.0, 30.0, 60.0)
# BModes prints five digits: half a unit of the fifth.
PRINTED = 0.5e-4
# What is left once elements and stretching are accounted for: h^4 and the rounding of 320 elements.
LEFT = 1e-5
BLADE = """schema = "bladefan-blade/1"
name = "certification"

[units]
angle = "deg"
speed = "rpm"

[rotor]
radius = {radius!r}
nominal_speed = {rpm!r}

[flap]
root = "hingeless"
offset = {root!r}

[lag]
root = "hingeless"
offset = {root!r}

[torsion]
root = "rigid"
offset = {root!r}

[distribution]
{distribution}
"""
PROPERTIES = ("twist", "mass", "flap_inertia", "lag_inertia", "flap_stiffness")
PROPERTIES += ("lag_stiffness", "torsion_stiffness", "mass_offset")
NOTES = """
- BModes itself, its own 12 elements, 60 rpm, 20 modes in five digits: pyBmodes on the same deck differs by {printed:.1e} at most, which is its printing. So pyBmodes stands for it.
- Columns: bladefan; differences of pyBmodes on the deck's 12 elements and on {meshes} elements for each of the {intervals} intervals of the table; *stretch*: what the blade's motion along itself does to pyBmodes' own frequency; *left*: the difference on the finest two meshes, extrapolated with h^2, less that. Elements have constant properties, which errs as h^2.
- *stretch*: where the tension centre is off the elastic axis, bending pulls the blade along itself. bladefan has the stiffness of that at rest along the blade, EI2 = edge_stff − axial_stff (tc − sc)^2, and no inertia in that direction, which lowers lag. It is taken from pyBmodes' deck with that EI2 in place of edge_stff, and tc = sc.
- Largest difference left {left:.1e}, tolerance {tolerance:.1e}: what h^2 does not extrapolate, largest in torsion, where the meshes of 4 and 8 leave eight times as much.
- Conventions: e = −cg_offst from the elastic axis, twist = −str_tw, inertias about the elastic axis and linear per mass, no trapeze term, no offset of tension in torsion, no rotary inertia.
"""


def linear(low, high, x):
    return [a + x * (b - a) for a, b in zip(low, high)]


class Deck:
    """A blade's deck: the lines of its main file, and the table of sections."""

    def __init__(self, folder):
        self.lines = (folder / f"{NAME}.bmi").read_text().splitlines()
        words = [line.split() for line in self.lines if len(line.split()) > 1]
        value = {word[1].rstrip(":"): word[0] for word in words}
        self.radius, self.root = float(value["radius"]), float(value["hub_rad"])
        self.rpm = float(value["rot_rpm"]) * float(value["rpm_mult"])
        self.text = (folder / "blade_sec_props.dat").read_text()
        rows = [line.split() for line in self.text.splitlines()]
        rows = [row for row in rows if len(row) == 13 and row[0][0].isdigit()]
        self.table = [[float(number) for number in row] for row in rows]
        lines = (folder / f"{NAME}.out").read_text().splitlines()
        hertz = [
            line.split("freq =")[1].split()[0] for line in lines if "freq =" in line
        ]
        self.published = [2 * math.pi * float(number) for number in hertz]

    def refined(self, parts):
        """The table with every interval parted, inertia linear per mass as BModes has it."""
        rows = []
        for low, high in zip(self.table, self.table[1:]):
            for i in range(parts):
                row = linear(low, high, i / parts)
                per_mass = ([end[4] / end[3], end[5] / end[3]] for end in (low, high))
                row[4:6] = [row[3] * part for part in linear(*per_mass, i / parts)]
                rows.append(row)
        return [*rows, self.table[-1]]

    def unstretched(self):
        """The sections with EI2 about the tension centre, on the elastic axis."""
        rows = [
            f"{FINE * (len(self.table) - 1) + 1} n_secs",
            "",
            "columns of BModes",
            "SI",
        ]
        for row in self.refined(FINE):
            values = [*row[:7], lag_stiffness(row), *row[8:11], 0.0, 0.0]
            rows.append(" ".join(map(repr, values)))
        return "\n".join(["unstretched", *rows]) + "\n"

    def write(self, name, sections, boundaries):
        """The main file with these elements, or its own, beside these sections."""
        folder = measure.WORK / "certification" / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "blade_sec_props.dat").write_text(sections)
        lines = list(self.lines)
        at = next(i for i, line in enumerate(lines) if "nselt" in line)
        if boundaries:
            lines[at] = f"{len(boundaries) - 1} nselt"
            lines[at + 2] = " ".join(map(repr, boundaries))
        path = folder / f"{NAME}.bmi"
        path.write_text("\n".join(lines) + "\n")
        return path

    def blade(self):
        """The blade as bladefan reads it: twist nose up, offsets ahead."""
        rows = self.refined(FINE)
        columns = [
            (
                -row[1],
                row[3],
                row[4],
                row[5],
                row[6],
                lag_stiffness(row),
                row[8],
                -row[10],
            )
            for row in rows
        ]
        radii = [self.root + row[0] * (self.radius - self.root) for row in rows]
        lines = [f"r = {[*radii[:-1], self.radius]}"]
        lines += [
            f"{name} = {list(column)}"
            for name, column in zip(PROPERTIES, zip(*columns))
        ]
        path = measure.WORK / "certification/blade.toml"
        path.write_text(
            BLADE.format(
                radius=self.radius,
                root=self.root,
                rpm=self.rpm,
                distribution="\n".join(lines),
            )
        )
        return path


def lag_stiffness(row):
    return row[7] - row[9] * (row[12] - row[11]) ** 2


def our_modes(path, rpm):
    options = "--model coupled --trapeze off --rotary off --modes".split()
    report, _ = ours.ask(
        "modes", str(path), "--speed", f"{rpm!r}rpm", *options, str(MODES)
    )
    return [(mode["label"], mode["frequency_rad_s"]) for mode in report["modes"]]


def their_modes(deck, modes=MODES):
    """Frequencies at each speed, and the versions of pyBmodes and what it stands on."""
    speeds = [rpm * math.pi / 30 for rpm in SPEEDS_RPM]
    answer, _ = bmodes.ask(measure.PYTHON, deck, speeds, modes, mixed=True)
    return answer["modes"], answer["versions"]


def limit(coarse, fine):
    """Extrapolated with h^2."""
    return fine + (fine - coarse) / 3


def compare(deck):
    """The lines of the table, what is left at most, pyBmodes beside BModes at most, and versions."""

    def meshes(name, sections, all_parts):
        shares = {parts: [row[0] for row in deck.refined(parts)] for parts in all_parts}
        decks = [
            deck.write(f"{name}-{parts}", sections, shares[parts])
            for parts in all_parts
        ]
        return [their_modes(path)[0] for path in decks]

    own, versions = their_modes(deck.write("own", deck.text, None), len(deck.published))
    at_speed = own[SPEEDS_RPM.index(deck.rpm)]
    printed = max(abs(a / b - 1) for a, b in zip(at_speed, deck.published, strict=True))
    refined = meshes("refined", deck.text, PARTS)
    plain = meshes("unstretched", deck.unstretched(), PARTS[-2:])
    lines, most = [], 0.0
    for i, rpm in enumerate(SPEEDS_RPM):
        for k, (label, omega) in enumerate(our_modes(deck.blade(), rpm)):
            found = [mesh[i][k] for mesh in (own, *refined)]
            exact, stiff = limit(*found[-2:]), limit(*(mesh[i][k] for mesh in plain))
            stretch = exact / stiff - 1
            left = exact / omega - 1 - stretch
            most = max(most, abs(left))
            differences = [*(value / omega - 1 for value in found), stretch, left]
            cells = [f"{rpm:g}", label, table.significant(omega, 8)]
            lines.append(cells + [table.parts(value) for value in differences])
    return lines, most, printed, versions


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        raise SystemExit(__doc__)
    deck = Deck(Path(sys.argv[1]))
    lines, left, printed, versions = compare(deck)
    head = ["rpm", "mode", "bladefan, rad/s", "12", *map(str, PARTS), "stretch", "left"]
    notes = NOTES.format(
        printed=printed,
        meshes=", ".join(map(str, PARTS)),
        intervals=len(deck.table) - 1,
        left=left,
        tolerance=LEFT,
    )
    named = ", ".join(f"{name} {number}" for name, number in versions.items())
    title = "**Certification blade of BModes, coupled**, beside pyBmodes and BModes v3."
    first = f"Recorded with bladefan {ours.version()}, {named}."
    RECORD.write_text(
        "\n".join([first, "", title, "", *table.markdown([head, *lines])])
        + "\n"
        + notes
    )
    print(f"wrote {RECORD.name}: left {left:.1e}, pyBmodes from BModes {printed:.1e}")
    return 1 if left > LEFT or printed > PRINTED else 0


if __name__ == "__main__":
    sys.exit(main())
