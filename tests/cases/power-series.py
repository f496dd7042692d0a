"""Reference values of tests/cases: bending of rotating blades by power series in 30 digits.

    pip install mpmath==1.3.0 && python3 tests/cases/power-series.py

Python 3.11 or later. Shares no code and no idea with the product: from the root, w'' = M / EI, M' = V + W^2 T w',
V' = lambda m w are summed as power series in x = r - e; a frequency is a zero of the
determinant of what moment and force are left at the tip, lambda = w^2 in flap, w^2 + W^2 in lag.
EI and m are polynomials in x, lowest power first; length R - e = 1.

Compares every row of the cases named below and exits 1 where a value differs from the file's by more than half a
unit of its last digit, the twelfth for its own cases; --print only prints.
"""

import sys
import tomllib
from decimal import Decimal
from pathlib import Path

from mpmath import mp, mpf, findroot, sqrt

mp.dps = 30
TERMS = 140  # 100 and 160 give the same 16 digits

# Cases by name: the blade, and for those whose values are from here the digits in the file.
TAPER = {"stiffness": (1, "-1.5", "0.75", "-0.125"), "mass": (1, "-0.5")}
HINGE = mpf(1) / 19  # 5 % of the radius, where the blade is 1 long
CASES = {
    "wright-1982": ({}, None),
    "hodges-rutkowski-1981": (TAPER, None),
    "hub-offset": ({"offset": 1}, 12),
    "hinge-offset": ({"offset": HINGE, "root": 0}, 12),
    "spring-hinge": ({"offset": HINGE, "root": 1}, 12),
}


def tension(mass, offset):
    """T(x) = integral of m r from x to the tip, as a polynomial."""
    moment = [mpf(0)] * (len(mass) + 1)
    for i, m in enumerate(mass):
        moment[i] += m * offset
        moment[i + 1] += m
    indefinite = [mpf(0)] + [-c / (i + 1) for i, c in enumerate(moment)]
    indefinite[0] = -sum(indefinite)
    return indefinite


def tip(stiffness, mass, pull, speed, eigenvalue, start):
    """Moment and force at the tip from (w, w', M, V) at the root."""
    w, moment, force = [start[0], start[1]], [start[2]], [start[3]]
    curvature = []
    for n in range(TERMS):
        bent = moment[n] - sum(stiffness[k] * curvature[n - k] for k in range(1, min(n + 1, len(stiffness))))
        curvature.append(bent / stiffness[0])
        w.append(curvature[n] / ((n + 1) * (n + 2)))
        pulled = sum(pull[k] * (n - k + 1) * w[n - k + 1] for k in range(min(n + 1, len(pull))))
        moment.append((force[n] + speed**2 * pulled) / (n + 1))
        force.append(eigenvalue * sum(mass[k] * w[n - k] for k in range(min(n + 1, len(mass)))) / (n + 1))
    return sum(moment), sum(force)


def eigenvalues(count, speed, offset=0, stiffness=(1,), mass=(1,), root="clamped"):
    """The lowest lambda; `root` is "clamped" or the spring of a hinge."""
    stiffness, mass = [mpf(c) for c in stiffness], [mpf(c) for c in mass]
    speed, pull = mpf(speed), tension(mass, mpf(offset))
    starts = [(0, 0, 1, 0), (0, 0, 0, 1)] if root == "clamped" else [(0, 1, mpf(root), 0), (0, 0, 0, 1)]

    def left(eigenvalue):
        (a, b), (c, d) = (tip(stiffness, mass, pull, speed, eigenvalue, [mpf(v) for v in s]) for s in starts)
        return a * d - b * c

    # In steps of 1 in sqrt(lambda). Two zeros in one step would be missed; those found lie 14 and more apart.
    found, low = [], mpf(1) / 1000
    before = left(low**2)
    while len(found) < count:
        high = low + 1
        after = left(high**2)
        if before * after < 0:
            found.append(findroot(left, (low**2, high**2), solver="anderson", tol=mpf(10) ** -20, verify=False))
        low, before = high, after
    return found


def row(labels, speed, blade):
    """Frequencies by label. Lag has the same lambda as flap, for here the blade is as stiff in both."""
    found = eigenvalues(max(int(label[0]) for label in labels), speed, **blade)
    return [sqrt(found[int(label[0]) - 1] - (speed**2 if label[1] == "L" else 0)) for label in labels]


def half(printed, digits):
    """Half a unit of the last digit: of that many in all, else of those printed."""
    last = printed.adjusted() + 1 - digits if digits else printed.as_tuple().exponent
    return mpf(10) ** last / 2


if __name__ == "__main__":
    wrong = 0
    for name, (blade, digits) in CASES.items():
        path = Path(__file__).parent / f"{name}.toml"
        case = tomllib.loads(path.read_text(), parse_float=Decimal)
        print(f"\n{name}")
        for speed, *printed in case["rows"]:
            found = row(case["labels"], speed, blade)
            print(f"  [{speed}, {', '.join(mp.nstr(f, 12) for f in found)}],", flush=True)
            for label, value, expected in zip(case["labels"], found, printed):
                if "--print" not in sys.argv and abs(value - mpf(str(expected))) > half(expected, digits):
                    print(f"    {label}: the file has {expected}")
                    wrong += 1
    sys.exit(f"{wrong} values differ from the files" if wrong else 0)
