"""bladefan as any script would use it: as a program that prints JSON."""

import json
import os
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).parents[2]
# Peers are compared motion by motion.
MODEL = ("--model", "uncoupled")


def program():
    """BLADEFAN, or the release build, or the debug build."""
    named = os.environ.get("BLADEFAN")
    places = (
        [Path(named)]
        if named
        else [ROOT / f"target/{profile}/bladefan" for profile in ("release", "debug")]
    )
    for place in places:
        if place.is_file():
            return str(place.resolve())
    tried = named or "target/release/bladefan or target/debug/bladefan"
    raise SystemExit(
        f"peers: no {tried}; build it with `cargo build --release -p bladefan`"
    )


def text(*arguments):
    run = subprocess.run([program(), *arguments], capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"peers: bladefan {' '.join(arguments)} failed:\n{run.stderr}")
    return run.stdout


def ask(*arguments):
    """The report, and the time of the whole process [s]."""
    start = time.perf_counter()
    printed = text(*arguments, "--format", "json")
    seconds = time.perf_counter() - start
    return json.loads(printed), seconds


def version():
    return text("--version").split()[-1]


def modes(blade, speed, count=3):
    return ask(
        "modes", str(blade), *MODEL, "--speed", repr(float(speed)), "--modes", str(count)
    )


def shapes(blade, speed, count=3, points=801):
    arguments = (
        "--speed",
        repr(float(speed)),
        "--modes",
        str(count),
        "--points",
        str(points),
    )
    return ask("shapes", str(blade), *MODEL, *arguments)[0]


def chart(blade, speed, count=3, speeds=101):
    return ask(
        "fan",
        str(blade),
        *MODEL,
        "--speeds",
        f"0:{float(speed)!r}:{speeds}",
        "--modes",
        str(count),
    )
