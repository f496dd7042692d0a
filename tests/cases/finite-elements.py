"""Reference values of tests/cases: uncoupled rotating blades by finite elements.

    pip install numpy==2.4.6 && python3 tests/cases/finite-elements.py

Python 3.11 or later. Reads the built-in blade files and shares nothing else with the product: no code, and the plainest
method there is. Bending by cubic Hermite elements with the pull of the mass outboard, in lag less the softening
speed^2 M; torsion by quadratic elements with the paper's centrifugal term, the offset of the mass centre. Elements end
at every station, so that no property steps or bends inside one, and Gauss's rule is exact. Compares every row of the
cases named below and exits 1 where a value differs from the file's by more than half a unit of its last digit and what
the mesh still changes. --print only prints; so does --propeller, which takes the whole propeller moment of a thin
section, speed^2 polar inertia, in place of the paper's term.
"""

import argparse
import sys
import tomllib
from decimal import Decimal
from math import ceil, pi
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
BLADES = HERE / "../../crates/core/src/library/blades"
NAMES = ("tm4760-finite-elements", "sa330-finite-elements")
DOFS = {"F": "flap", "L": "lag", "T": "torsion"}
POUND, GRAVITY = 0.45359237, 9.80665
UNITS = {"m": 1, "in": 0.0254, "kg": 1, "lb": POUND, "N": 1, "lbf": POUND * GRAVITY}
SPEEDS = {"rad/s": 1, "rpm": 2 * pi / 60}
FREQUENCIES = {"rad/s": 1, "Hz": 1 / (2 * pi)}
GAUSS, WEIGHTS = np.polynomial.legendre.leggauss(4)  # exact to degree 7: linear mass times two cubics
GAUSS, WEIGHTS = (GAUSS + 1) / 2, WEIGHTS / 2  # on 0 to 1


class Blade:
    """A blade file in SI."""

    def __init__(self, name):
        self.file = tomllib.loads((BLADES / f"{name}.toml").read_text())
        units = self.file.get("units", {})
        length, mass, force = (UNITS[units.get(k, si)] for k, si in (("length", "m"), ("mass", "kg"), ("force", "N")))
        self.length, self.moment = length, force * length
        self.radius = self.file["rotor"]["radius"] * length
        stiffness = force * length**2
        scale = {
            "mass": mass / length,
            "flap_stiffness": stiffness,
            "lag_stiffness": stiffness,
            "torsion_stiffness": stiffness,
            "polar_inertia": mass * length,
            "mass_offset": length,
        }
        table = self.file["distribution"]
        self.tables = {}
        for key, unit in scale.items():
            value = table.get(key, 0.0)
            r, values = (value["r"], value["values"]) if isinstance(value, dict) else (table.get("r"), value)
            if not isinstance(values, list):
                r, values = [0.0, self.file["rotor"]["radius"]], [values, values]
            self.tables[key] = np.array(r) * length, np.array(values) * unit

    def root(self, dof):
        """Radius and spring; no spring where the root is clamped."""
        root = self.file[dof]
        offset = root.get("offset", 0.0) * self.length
        return offset, None if root["root"] in ("hingeless", "rigid") else root.get("spring", 0.0) * self.moment

    def at(self, key, r):
        """Inside elements only, where no property steps."""
        return np.interp(r, *self.tables[key])

    def nodes(self, dof, elements):
        """Every station from the root to the tip, and points between: no element is long, and none a whole ramp, in
        which stiffness may fall to a fifth and curvature is far from linear."""
        root, _ = self.root(dof)
        own = ("polar_inertia", "mass_offset") if dof == "torsion" else ()
        stations = np.concatenate([self.tables[key][0] for key in ("mass", f"{dof}_stiffness", *own)])
        stations = stations[(stations > root) & (stations < self.radius)]
        stations = np.unique(np.concatenate([[root], stations, [self.radius]]))
        # The same station in another table may differ by rounding.
        stations = stations[np.concatenate([[True], np.diff(stations) > 1e-12 * self.radius])]
        longest = (self.radius - root) / elements
        pieces = [max(ceil((b - a) / longest), elements // 20) for a, b in zip(stations, stations[1:])]
        cuts = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(stations, stations[1:], pieces)]
        return np.concatenate([*cuts, [self.radius]])

    def pull(self, nodes):
        """Integral of m r to the tip from every Gauss point of every element."""

        def moment(start, end):
            r = start[..., None] + (end - start)[..., None] * GAUSS
            return (end - start) * np.sum(WEIGHTS * self.at("mass", r) * r, axis=-1)

        start, end = nodes[:-1], nodes[1:]
        outboard = np.append(np.cumsum(moment(start, end)[::-1])[::-1][1:], 0.0)
        points = start[:, None] + (end - start)[:, None] * GAUSS
        return outboard[:, None] + moment(points, np.broadcast_to(end[:, None], points.shape))


def bending(h):
    """Hermite cubics of both ends' displacement and slope at the Gauss points: value, slope, curvature."""
    x = GAUSS
    value = [1 - 3 * x**2 + 2 * x**3, h * (x - 2 * x**2 + x**3), 3 * x**2 - 2 * x**3, h * (x**3 - x**2)]
    slope = [(6 * x**2 - 6 * x) / h, 1 - 4 * x + 3 * x**2, (6 * x - 6 * x**2) / h, 3 * x**2 - 2 * x]
    curvature = [(12 * x - 6) / h**2, (6 * x - 4) / h, (6 - 12 * x) / h**2, (6 * x - 2) / h]
    return np.array([value, slope, curvature]).transpose(0, 2, 1)


def twisting(h):
    """Parabolas through both ends and the middle at the Gauss points: the twist, again, and its rate."""
    x = GAUSS
    value = [(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)]
    rate = [(4 * x - 3) / h, (4 - 8 * x) / h, (4 * x - 1) / h]
    return np.array([value, value, rate]).transpose(0, 2, 1)


class System:
    """One motion of a blade: three energies, each a weighted sum of squares over all Gauss points."""

    def __init__(self, blade, dof, elements, propeller):
        torsion = dof == "torsion"
        self.softened = dof == "lag"
        nodes = blade.nodes(dof, elements)
        h = np.diff(nodes)
        r = nodes[:-1, None] + h[:, None] * GAUSS
        polar, mass = blade.at("polar_inertia", r), blade.at("mass", r)
        if torsion:
            inertia, pull = polar, polar if propeller else mass * blade.at("mass_offset", r) ** 2
        else:
            inertia, pull = mass, blade.pull(nodes)
        factors = inertia, pull, blade.at(f"{dof}_stiffness", r)
        self.weights = [(h[:, None] * WEIGHTS * factor).ravel() for factor in factors]
        functions = np.zeros((3, r.size, 2 * len(nodes) - torsion))
        for i, length in enumerate(h):
            part = (twisting if torsion else bending)(length)
            functions[:, 4 * i : 4 * i + 4, 2 * i : 2 * i + part.shape[2]] = part
        # The root holds the displacement; a clamp the slope too, or the twist, and else a spring of 0 or more.
        _, spring = blade.root(dof)
        self.spring = spring or 0.0
        self.functions = functions[:, :, (0 if torsion else 1) + (spring is None) :]
        self.squares = [f.T @ (w[:, None] * f) for f, w in zip(self.functions, self.weights)]
        self.squares[2][0, 0] += self.spring

    def frequencies(self, speed, count):
        """The lowest. Posed for 1 / (w^2 + shift) they are the largest eigenvalues; the shift is for a free hinge at
        rest. The matrix of short elements holds large numbers that nearly cancel and spoils the sixth digit: so only
        shapes are taken from it, and the frequencies from their energies, point by point."""
        inertia, pull, stiffness = self.squares
        shift = 1.0 + speed**2
        factor = np.linalg.cholesky(stiffness + speed**2 * pull + shift * inertia)
        half = np.linalg.solve(factor, inertia)
        _, vectors = np.linalg.eigh(np.linalg.solve(factor, half.T))
        shapes = np.linalg.solve(factor.T, vectors[:, : -count - 1 : -1])
        kinetic, pulled, strain = (w @ (f @ shapes) ** 2 for f, w in zip(self.functions, self.weights))
        held = self.spring * shapes[0] ** 2
        squares = (strain + held + speed**2 * pulled) / kinetic - (speed**2 if self.softened else 0.0)
        # A free hinge at rest has 0; the rounding of its shape would leave some 1e-4 rad/s.
        return np.sqrt(np.where(squares < 1e-9 * squares[-1], 0.0, squares))


def table(case, elements, propeller):
    """Rows as in the case's file."""
    blade = Blade(case["blade"])
    systems = {letter: System(blade, dof, elements, propeller) for letter, dof in DOFS.items()}
    rows = []
    for speed, *_ in case["rows"]:
        rate = float(speed) * SPEEDS[case["speed_unit"]]
        found = {letter: system.frequencies(rate, 4) for letter, system in systems.items()}
        unit = FREQUENCIES[case["frequency_unit"]]
        rows.append([speed, *(unit * found[label[1]][int(label[0]) - 1] for label in case["labels"])])
    return rows


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--elements", type=int, default=240, help="as many and more")
    parser.add_argument("--propeller", action="store_true", help="the whole propeller moment; no comparison")
    parser.add_argument("--print", action="store_true", help="the rows alone")
    options = parser.parse_args()
    wrong = 0
    for name in NAMES:
        case = tomllib.loads((HERE / f"{name}.toml").read_text(), parse_float=Decimal)
        fine = table(case, options.elements, options.propeller)
        coarse = table(case, options.elements // 2, options.propeller)
        moved = max(abs(a - b) for rows in zip(fine, coarse) for a, b in list(zip(*rows))[1:])
        print(f"{name}: {options.elements} elements and more; from half as many the values move by up to {moved:.1e}")
        for row, printed in zip(fine, case["rows"]):
            print(f"  [{row[0]}, {', '.join(f'{value:.6f}' for value in row[1:])}],")
            if options.print or options.propeller:
                continue
            for label, value, expected in zip(case["labels"], row[1:], printed[1:]):
                half = 0.5 * 10.0 ** expected.as_tuple().exponent
                if abs(value - float(expected)) > half + moved:
                    print(f"    {label}: {value:.6f}, the file has {expected}")
                    wrong += 1
    sys.exit(f"{wrong} values differ from the files" if wrong else 0)
