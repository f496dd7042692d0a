"""Runs in the environment that holds pyBmodes: a request of `bmodes.ask` in, frequencies out, JSON
both. The modes of a blade without twist or offsets are pure flap, lag or torsion at every speed, and
are labelled; where they are `mixed` there is a list of frequencies at each speed, ascending.
"""

import json
import math
import sys
import time
import warnings
from importlib.metadata import version

import numpy
from pybmodes.campbell import campbell_sweep
from pybmodes.models import RotatingBlade

LETTERS = ("F", "L", "T")
# Least part of a mode's motion that lies in one degree of freedom for it to be called by it.
PURE = 0.999


def labelled(frequencies, participation):
    """{label: rad/s} at one speed, numbered by ascending frequency within flap, lag and torsion."""
    found, counts = {}, [0, 0, 0]
    for hertz, parts in sorted(
        zip(frequencies, participation), key=lambda mode: mode[0]
    ):
        axis = int(numpy.argmax(parts))
        if parts[axis] < PURE:
            raise SystemExit(f"the mode at {hertz} Hz is mixed: {parts}")
        counts[axis] += 1
        found[f"{counts[axis]}{LETTERS[axis]}"] = 2 * math.pi * float(hertz)
    return found


def main():
    request = json.load(sys.stdin)
    # It advises to ask for fewer modes than its elements have; a warning changes no number.
    warnings.simplefilter("ignore")
    rpm = numpy.array(request["speeds"]) * 30 / math.pi
    blade = RotatingBlade(request["deck"])
    start = time.perf_counter()
    chart = campbell_sweep(blade, rpm, n_blade_modes=request["modes"])
    seconds = time.perf_counter() - start
    if request["mixed"]:
        modes = [
            sorted(2 * math.pi * float(f) for f in row) for row in chart.frequencies
        ]
    else:
        modes = [
            labelled(*at_speed)
            for at_speed in zip(chart.frequencies, chart.participation)
        ]
    versions = {name: version(name) for name in ("pybmodes", "numpy", "scipy")}
    json.dump({"versions": versions, "modes": modes, "chart_s": seconds}, sys.stdout)


main()
