"""bladefan beside independent programs: pyBmodes (beam elements) and CalculiX (solid elements).

    tests/peers/run             compare with the programs that are here, and with the record
    tests/peers/run --install   first get those that are not: pyBmodes from PyPI, CalculiX from Debian
    tests/peers/run --record    compare, time, and write results.json and results.md
    tests/peers/run --table     write results.md from results.json; runs nothing
    tests/peers/run --check     our numbers again, against the record; needs none of the others

bladefan is the program that BLADEFAN names, else target/release/bladefan or target/debug/bladefan.
What is made on the way lies in target/peers. Exit code 1: something is out of its tolerance.
"""

import argparse
import datetime
import json
import subprocess
import sys
from pathlib import Path

import bmodes
import calculix
import measure
import ours
import table
from cases import CASES

HERE = Path(__file__).parent
RECORD = HERE / "results.json"
# The record as docs/VALIDATION.md shows it.
TABLE = HERE / "results.md"
REQUIREMENTS = HERE / "requirements.txt"
VENV = measure.WORK / "venv"
# Written after an installation that went well; says what was installed.
STAMP = VENV / "requirements.txt"
SCHEMA = "bladefan-peers/1"
# bladefan's values are converged to 1e-10 and better; a better solver may differ by that.
OURS_AGAIN = 1e-9
# The same program on the same input: pyBmodes iterates from a random start and rounds low modes to
# some 1e-7, otherwise with another processor's kernels; CalculiX prints seven digits.
THEIRS_AGAIN = 1e-6
MISSING = {
    "pybmodes": "pyBmodes is not installed here; `tests/peers/run --install` gets it with pip",
    "calculix": "no ccx on PATH; `tests/peers/run --install` gets Debian's calculix-ccx",
}


class Tally:
    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def line(self, verdict, text):
        print(f"{verdict:5}{text}")

    def check(self, good, text):
        self.passed, self.failed = self.passed + bool(good), self.failed + (not good)
        self.line("ok" if good else "FAIL", text)

    def skip(self, text):
        self.skipped += 1
        self.line("skip", text)

    def end(self):
        print(f"\n  {self.passed} passed\n  {self.failed} failed\n  {self.skipped} skipped")
        return 1 if self.failed else 0


def present(program):
    if program == "calculix":
        return calculix.program() is not None
    return (
        measure.PYTHON.is_file()
        and STAMP.is_file()
        and STAMP.read_text() == REQUIREMENTS.read_text()
    )


def install():
    """Gets what is missing; a second call finds everything and does nothing."""
    if present("pybmodes"):
        print("pyBmodes is installed")
    else:
        print("installing pyBmodes into target/peers/venv")
        pip = [
            str(measure.PYTHON),
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
        ]
        steps = (
            [sys.executable, "-m", "venv", str(VENV)],
            [*pip, "-r", str(REQUIREMENTS)],
        )
        if all(subprocess.run(step).returncode == 0 for step in steps):
            STAMP.write_text(REQUIREMENTS.read_text())
        else:
            print(
                "pyBmodes could not be installed (needs Python's venv and pip, and PyPI); it will be skipped"
            )
    if present("calculix"):
        print("CalculiX is installed")
    else:
        print("installing CalculiX")
        script = ". scripts/debian.sh && install_debian calculix-ccx"
        if subprocess.run(["bash", "-c", script], cwd=ours.ROOT).returncode != 0:
            print(
                "CalculiX could not be installed (needs Debian's apt-get); it will be skipped"
            )


def here():
    """The cases whose program is here; says which are not."""
    found = [program for program in MISSING if present(program)]
    for program in MISSING:
        if program not in found:
            print(MISSING[program])
    return [case for case in CASES if case.program in found]


def compare(tally):
    """{case: rows} of every case whose program is here."""
    results = {}
    for case in here():
        rows = measure.measured(case)
        results[case.name] = rows
        judge(tally, case, rows)
    return results


def judge(tally, case, rows):
    worst = max(rows, key=lambda row: abs(table.remainder(case, row)))
    text = f"{case.title}: {len(rows)} frequencies beside {table.PROGRAMS[case.program]} within {case.tolerance:.1e}"
    left, at = (
        table.remainder(case, worst),
        f"{worst['mode']} at {worst['speed_rad_s']:g} rad/s",
    )
    tally.check(
        abs(left) <= case.tolerance,
        f"{text}; largest difference left {left:+.1e}, {at}",
    )


def record(results, runs):
    answer, _ = bmodes.ask(
        measure.PYTHON,
        measure.deck(CASES[0], CASES[0].coarse),
        [0.0],
        measure.PYBMODES_MODES,
    )
    value = {
        "schema": SCHEMA,
        "date": datetime.date.today().isoformat(),
        "versions": {
            "bladefan": ours.version(),
            **answer["versions"],
            "calculix": calculix.version(),
        },
        "runs": runs,
        "cases": results,
        "times": [*measure.chart_times(runs), *measure.speed_times(runs)],
    }
    RECORD.write_text(json.dumps(value, indent=1) + "\n")
    print(f"wrote {RECORD.relative_to(ours.ROOT)}")
    write_table(value)


def write_table(value):
    TABLE.write_text(table.whole(value) + "\n")
    print(f"wrote {TABLE.relative_to(ours.ROOT)}")


def recorded():
    if not RECORD.is_file():
        raise SystemExit(
            "peers: there is no record yet; `tests/peers/run --record` makes one"
        )
    try:
        value = json.loads(RECORD.read_text())
    except json.JSONDecodeError as fault:
        raise SystemExit(f"peers: {RECORD.name} is not JSON: {fault}") from None
    if value.get("schema") != SCHEMA:
        raise SystemExit(
            f"peers: {RECORD.name} is not a record of this version ({SCHEMA})"
        )
    return value


def again(tally, case, program, change, most):
    text = f"{case.title}: {program} as recorded within {most:.0e}"
    tally.check(change <= most, f"{text}; largest change {change:.1e}")


def unrepeatable(program, versions):
    """Why a recorded result cannot be had again; pyBmodes is pinned, a Debian has its CalculiX."""
    if not present(program):
        return MISSING[program]
    if program == "calculix" and calculix.version() != versions["calculix"]:
        return f"recorded with CalculiX {versions['calculix']}, here is {calculix.version()}"
    return None


def check(tally, rerun):
    """The record against a new calculation of ours, and of theirs where they are to be run."""
    past = recorded()
    cases = past["cases"]
    stands = TABLE.is_file() and TABLE.read_text() == table.whole(past) + "\n"
    tally.check(stands, f"{TABLE.name} is the record as a table")
    for case in CASES:
        own = measure.our_rows(case)
        rows = {
            (row["mode"], row["speed_rad_s"]): row for row in cases.get(case.name, [])
        }
        if rows.keys() != own.keys():
            tally.check(
                False,
                f"{case.title}: the record has other modes or speeds; record it anew",
            )
            continue
        change = max(
            abs(own[key][0] / row["bladefan_rad_s"] - 1) for key, row in rows.items()
        )
        again(tally, case, "bladefan", change, OURS_AGAIN)
        fresh = [
            {**row, "bladefan_rad_s": own[key][0], "effects": own[key][2]}
            for key, row in rows.items()
        ]
        judge(tally, case, fresh)
        if not rerun:
            continue
        if reason := unrepeatable(case.program, past["versions"]):
            tally.skip(f"{case.title}: {reason}")
            continue
        theirs = (
            (name, measure.their_rows(case, getattr(case, name)))
            for name in ("coarse", "fine")
        )
        change = max(
            abs(new[key] / rows[key][f"{name}_rad_s"] - 1)
            for name, new in theirs
            for key in rows
        )
        again(tally, case, table.PROGRAMS[case.program], change, THEIRS_AGAIN)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    what = parser.add_mutually_exclusive_group()
    for name in ("record", "table", "check"):
        what.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--install", action="store_true")
    parser.add_argument(
        "--runs",
        type=int,
        default=5,
        help="of which each recorded time is the median (default 5)",
    )
    options = parser.parse_args()
    if options.runs < 1:
        parser.error("--runs must be at least 1")
    if options.table:
        write_table(recorded())
        return 0
    tally = Tally()
    if options.install:
        install()
    if not options.record:
        check(tally, rerun=not options.check)
        return tally.end()
    results = compare(tally)
    if tally.failed or len(results) < len(CASES):
        raise SystemExit(
            "peers: nothing recorded: a comparison failed, or a program is not here"
        )
    record(results, options.runs)
    return tally.end()
