"""Runs the programs on the cases. A result is {(mode, speed): rad/s}."""

import math
import tomllib
from pathlib import Path

import bmodes
import calculix
import ours
from cases import STRIP, case
from strip import Section, effects

WORK = ours.ROOT / "target/peers"
PYTHON = WORK / "venv/bin/python"
# Enough for the nine modes compared and those between them.
PYBMODES_MODES = 14


def blade_file(case):
    """The case's blade as a file or name that bladefan reads."""
    if case.program != "calculix":
        return case.blade
    WORK.mkdir(parents=True, exist_ok=True)
    path = WORK / f"{case.name}.toml"
    path.write_text(Section(STRIP, case.poisson).blade(STRIP))
    return path


def our_rows(case):
    """{(mode, speed): (rad/s, half the bounds' interval / frequency, {effect: part})}."""
    found, blade = {}, blade_file(case)
    for speed in case.speeds:
        named = explained(case, blade, speed)
        for mode in ours.modes(blade, speed)[0]["modes"]:
            label, omega = mode["label"], mode["frequency_rad_s"]
            if label in case.modes:
                half = (mode["upper_rad_s"] - mode["lower_rad_s"]) / 2 / omega
                found[label, speed] = (omega, half, named(mode))
    return found


def explained(case, blade, speed):
    """A function from a mode to what the other program's model adds, by effect."""
    if case.program == "calculix":
        report = ours.shapes(blade, speed)
        by_label = {shape["label"]: shape for shape in report["shapes"]}
        section = Section(STRIP, case.poisson)
        return lambda mode: effects(
            STRIP, section, by_label[mode["label"]], report["r_m"], speed
        )
    if case.flat == 0.5:
        return lambda mode: {}
    added = (2 * case.flat - 1) * speed**2
    return lambda mode: {
        "propeller": math.sqrt(1 + added / mode["frequency_rad_s"] ** 2) - 1
    }


def deck(case, elements):
    text = (
        case.blade.read_text()
        if isinstance(case.blade, Path)
        else ours.text("blades", case.blade)
    )
    return bmodes.write(
        WORK / f"{case.name}-{elements}", tomllib.loads(text), elements, case.flat
    )


def solid(case, mesh, speed):
    return calculix.solve(WORK / case.name, STRIP, case.poisson, case.held, mesh, speed)


def their_rows(case, mesh):
    if case.program == "calculix":
        by_speed = [solid(case, mesh, speed)[0] for speed in case.speeds]
    else:
        answer, _ = bmodes.ask(PYTHON, deck(case, mesh), case.speeds, PYBMODES_MODES)
        by_speed = answer["modes"]
    rows = {}
    for speed, modes in zip(case.speeds, by_speed):
        for label in case.modes:
            if label not in modes:
                raise SystemExit(
                    f"peers: {case.program} did not find {label} of {case.name} at {speed} rad/s"
                )
            rows[label, speed] = modes[label]
    return rows


def measured(case):
    """The rows of the record."""
    own, coarse, fine = (
        our_rows(case),
        their_rows(case, case.coarse),
        their_rows(case, case.fine),
    )
    return [
        {
            "mode": mode,
            "speed_rad_s": speed,
            "bladefan_rad_s": omega,
            "coarse_rad_s": coarse[mode, speed],
            "fine_rad_s": fine[mode, speed],
            "effects": named,
        }
        for (mode, speed), (omega, _, named) in sorted(
            own.items(), key=lambda item: item[0][1]
        )
    ]


def median(values):
    return sorted(values)[len(values) // 2]


def chart_times(runs):
    """One fan chart of the tapered blade in each program: whole process, and pyBmodes' sweep in it."""
    tapered = case("tapered")
    report, _ = ours.chart(tapered.blade, tapered.speeds[-1])
    speeds = report["speeds_rad_s"]
    exact = {
        branch["label"]: branch["frequency_rad_s"] for branch in report["branches"]
    }
    half = max(half for _, half, _ in our_rows(tapered).values())
    task = f"fan chart of the {tapered.title}, {len(exact)} modes, {len(speeds)} speeds"
    process = median(
        [ours.chart(tapered.blade, tapered.speeds[-1])[1] for _ in range(runs)]
    )
    rows = [time_row(task, "bladefan", "converged", process, half, "bounds")]
    for elements in (20, 80):
        path = deck(tapered, elements)
        answers = [
            bmodes.ask(PYTHON, path, speeds, PYBMODES_MODES) for _ in range(runs)
        ]
        charts = answers[0][0]["modes"]
        error = max(
            abs(modes[label] / exact[label][i] - 1)
            for i, modes in enumerate(charts)
            for label in exact
        )
        process = median([seconds for _, seconds in answers])
        row = time_row(
            task, "pybmodes", mesh_name(elements), process, error, "from bladefan"
        )
        rows.append(
            {**row, "solve_s": median([answer["chart_s"] for answer, _ in answers])}
        )
    return rows


def speed_times(runs):
    """One speed of the strip: a beam in bladefan, solid elements in CalculiX."""
    strip = case("strip")
    blade, speed = blade_file(strip), strip.speeds[-1]
    task = f"{STRIP['name']} at {speed:g} rad/s, {len(strip.modes)} modes"
    half = max(half for _, half, _ in our_rows(strip).values())
    process = median([ours.modes(blade, speed)[1] for _ in range(runs)])
    rows = [time_row(task, "bladefan", "converged", process, half, "bounds")]
    finest = None
    for mesh in (strip.fine, strip.coarse):
        answers = [solid(strip, mesh, speed) for _ in range(runs)]
        modes, process = answers[0][0], median([seconds for _, seconds in answers])
        finest = finest or modes
        error = max(abs(modes[label] / finest[label] - 1) for label in strip.modes)
        error_is = "from the finer mesh" if mesh != strip.fine else None
        rows.append(
            time_row(task, "calculix", mesh_name(mesh), process, error, error_is)
        )
    return rows


def time_row(task, program, setting, process, error, error_is):
    row = {"task": task, "program": program, "setting": setting, "process_s": process}
    return {**row, "error": error, "error_is": error_is} if error_is else row


def mesh_name(mesh):
    return (
        " × ".join(map(str, mesh)) + " elements"
        if isinstance(mesh, tuple)
        else f"{mesh} elements"
    )
