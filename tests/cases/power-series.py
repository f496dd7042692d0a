"""Reference values of tests/cases: bending of rotating blades by power series in 50 digits.

    pip install mpmath==1.3.0 && python3 tests/cases/power-series.py

Shares no code and no idea with the product: from the root, w'' = M / EI, M' = V + W^2 T w',
V' = lambda m w are summed as power series in x = r - e; a frequency is a zero of the
determinant of what moment and force are left at the tip, lambda = w^2 in flap, w^2 + W^2 in lag.
EI and m are polynomials in x, lowest power first; length R - e = 1.
"""

from mpmath import mp, mpf, findroot, sqrt

mp.dps = 50
TERMS = 320


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


def frequencies(count, speed, offset=0, stiffness=(1,), mass=(1,), root="clamped", lag=False):
    """The lowest frequencies; `root` is "clamped" or the spring of a hinge."""
    stiffness, mass = [mpf(c) for c in stiffness], [mpf(c) for c in mass]
    speed, pull = mpf(speed), tension(mass, mpf(offset))
    starts = [(0, 0, 1, 0), (0, 0, 0, 1)] if root == "clamped" else [(0, 1, mpf(root), 0), (0, 0, 0, 1)]

    def left(eigenvalue):
        (a, b), (c, d) = (tip(stiffness, mass, pull, speed, eigenvalue, [mpf(v) for v in s]) for s in starts)
        return a * d - b * c

    found, low, step = [], mpf(1) / 1000, mpf("0.4")
    before = left(low**2)
    while len(found) < count:
        high = low + step
        after = left(high**2)
        if before * after < 0:
            square = findroot(left, (low**2, high**2), solver="anderson", tol=mpf(10) ** -35, verify=False)
            found.append(sqrt(square - (speed**2 if lag else 0)))
        low, before = high, after
    return found


def show(title, speeds, count, **blade):
    print(f"\n{title}")
    for speed in speeds:
        print(f"  [{speed}, {', '.join(mp.nstr(f, 12) for f in frequencies(count, speed, **blade))}],", flush=True)


if __name__ == "__main__":
    taper = {"stiffness": (1, "-1.5", "0.75", "-0.125"), "mass": (1, "-0.5")}
    show("uniform, clamped at the centre", range(13), 3)
    show("uniform, clamped at e = L", (2, 4, 8, 12), 3, offset=1)
    show("the same, lag", (2, 4, 8, 12), 3, offset=1, lag=True)
    show("taper m = 1 - x/2, EI = (1 - x/2)^3", range(13), 3, **taper)
    show("hinge at e = L/19 (5 % of the radius)", (2, 6, 12), 4, offset=mpf(1) / 19, root=0)
    show("the same, lag", (2, 6, 12), 4, offset=mpf(1) / 19, root=0, lag=True)
    show("hinge at e = L/19 with K = 1", (0, 2, 6, 12), 4, offset=mpf(1) / 19, root=1)
    show("the same, lag", (0, 2, 6, 12), 4, offset=mpf(1) / 19, root=1, lag=True)
