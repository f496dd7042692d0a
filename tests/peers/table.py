"""The record as Markdown."""

from cases import CASES
from measure import mesh_name
from strip import EFFECTS

PROGRAMS = {"pybmodes": "pyBmodes", "calculix": "CalculiX", "bladefan": "bladefan"}


def significant(value, digits):
    return f"{value:#.{digits}g}".rstrip(".")


def parts(value):
    """A relative difference for reading."""
    return (
        "0"
        if value == 0
        else f"{value:+.1e}".replace("-", "−").replace("e−0", "e−").replace("e+0", "e")
    )


def percent(value):
    return f"{100 * value:+.3f} %".replace("-", "−")


def peer(case, row):
    """The other program's frequency, extrapolated over its meshes where the case says so."""
    coarse, fine = row["coarse_rad_s"], row["fine_rad_s"]
    return fine + (fine - coarse) / (2**case.order - 1) if case.order else fine


def difference(case, row):
    return peer(case, row) / row["bladefan_rad_s"] - 1


def remainder(case, row):
    """What no named effect explains."""
    return difference(case, row) - sum(row["effects"].values())


def mesh_change(row):
    return row["fine_rad_s"] / row["coarse_rad_s"] - 1


def markdown(lines):
    head, *body = lines
    return [f"| {' | '.join(line)} |" for line in (head, ["---"] * len(head), *body)]


def by_speed(case, rows):
    """One line a mode: the frequency and the remainder at each speed."""
    found = {(row["mode"], row["speed_rad_s"]): row for row in rows}
    lines = [["mode", *(f"{speed:g} rad/s" for speed in case.speeds)]]
    for mode in case.modes:
        cells = []
        for speed in case.speeds:
            row = found[mode, speed]
            named = " ".join(
                f"({name} {percent(part)})"
                for name, part in row["effects"].items()
                if part
            )
            cell = f"{significant(row['bladefan_rad_s'], 8)} {named} {parts(remainder(case, row))}"
            cells.append(" ".join(cell.split()))
        lines.append([mode, *cells])
    return lines


def by_effect(case, rows):
    """One line a mode and speed: the difference, each effect in it, and what is left."""
    names = list(dict.fromkeys(name for row in rows for name in row["effects"]))
    lines = [
        [
            "rad/s",
            "mode",
            "bladefan",
            PROGRAMS[case.program],
            "difference",
            *names,
            "left",
            "mesh",
        ]
    ]
    ranks = {mode: rank for rank, mode in enumerate(case.modes)}
    for row in sorted(rows, key=lambda row: (row["speed_rad_s"], ranks[row["mode"]])):
        effects = [
            percent(row["effects"][name]) if row["effects"].get(name) else ""
            for name in names
        ]
        frequencies = [
            significant(value, 6) for value in (row["bladefan_rad_s"], peer(case, row))
        ]
        last = [percent(remainder(case, row)), percent(mesh_change(row))]
        lines.append(
            [
                f"{row['speed_rad_s']:g}",
                row["mode"],
                *frequencies,
                percent(difference(case, row)),
                *effects,
                *last,
            ]
        )
    return lines


def comparison(case, rows):
    """Heading, table, and the lines that say what it may be taken for."""
    layout = by_effect if case.program == "calculix" else by_speed
    worst = max(abs(remainder(case, row)) for row in rows)
    coarse = max(abs(mesh_change(row)) for row in rows)
    beside = PROGRAMS[case.program]
    cell = "each cell: bladefan [rad/s], effects, and what is left of the difference"
    what = "" if case.program == "calculix" else f"; {cell}"
    lines = [f"**{case.title[0].upper()}{case.title[1:]}** beside {beside}{what}.", ""]
    lines += markdown(layout(case, rows))
    finer, coarser = mesh_name(case.fine), mesh_name(case.coarse)
    extrapolated = f", extrapolated with h^{case.order}" if case.order else ""
    lines += [
        "",
        f"- Largest difference left {worst:.1e}, tolerance {case.tolerance:.1e}: {case.reason}.",
        f"- Source: {case.source}.",
        f"- Mesh: {finer}{extrapolated}; from {coarser} to these it changes by {coarse:.1e} at most.",
        "",
    ]
    return lines


def duration(seconds):
    return (
        f"{significant(1000 * seconds, 2)} ms"
        if seconds < 1
        else f"{significant(seconds, 2)} s"
    )


def times(record):
    lines = [
        ["task", "program", "whole process", "of it solving", "error", "measured by"]
    ]
    for row in record["times"]:
        solving = duration(row["solve_s"]) if "solve_s" in row else ""
        error = f"{row['error']:.0e}" if "error" in row else ""
        program = f"{PROGRAMS[row['program']]}, {row['setting']}"
        lines.append(
            [
                row["task"],
                program,
                duration(row["process_s"]),
                solving,
                error,
                row.get("error_is", ""),
            ]
        )
    return markdown(lines)


def whole(record):
    versions = ", ".join(
        f"{PROGRAMS.get(name, name)} {number}"
        for name, number in record["versions"].items()
    )
    lines = [f"Recorded {record['date']} with {versions}.", ""]
    for case in CASES:
        if case.name in record["cases"]:
            lines += comparison(case, record["cases"][case.name])
    lines += [
        "The effects:",
        "",
        *(f"- *{name}*: {text}." for name, text in EFFECTS.items()),
        "",
    ]
    note = f"Wall times, median of {record['runs']} runs on one core of a shared machine, start and output included."
    return "\n".join([*lines, note, "", *times(record)])
