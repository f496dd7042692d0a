"""A blade in the files that pyBmodes reads, and its answers."""

import json
import os
import subprocess
import time
from pathlib import Path

HERE = Path(__file__).parent
# One thread: on matrices this small several only wait for each other, and sums keep their order.
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
MAIN = """{name}
{name}

--------- General parameters
false echo
1 beam_type
0.0 rot_rpm
1.0 rpm_mult
{radius!r} radius
{root!r} hub_rad
0.0 precone
0.0 bl_thp
1 hub_conn
20 modepr
t TabDelim
f mid_node_tw

--------- Blade-tip mass
0.0 tip_mass
0.0 cm_loc
0.0 cm_axial
0.0 ixx_tip
0.0 iyy_tip
0.0 izz_tip
0.0 ixy_tip
0.0 izx_tip
0.0 iyz_tip

--------- Distributed-property identifiers
1 id_mat
'sections.dat' sec_props_file

Property scaling factors
{scales}

--------- Finite element discretization
{count} nselt
element boundaries, as parts of the blade length
{boundaries}
"""
# Stiffness of the blade along itself, in largest EI / R^2: so stiff that no stretching mode lies
# among those compared, and without part in them, since no offset couples it to bending.
AXIAL = 1e6


def stations(blade, name):
    """Radii and values of one property, on the radii of its own, the shared ones, or constant."""
    value = blade["distribution"][name]
    if isinstance(value, dict):
        return value["r"], value["values"]
    if isinstance(value, list):
        return blade["distribution"]["r"], value
    return [0.0, blade["rotor"]["radius"]], [value, value]


def at(blade, name, r):
    """A property at a radius that is no step."""
    radii, values = stations(blade, name)
    for (a, b), (u, v) in zip(zip(radii, radii[1:]), zip(values, values[1:])):
        if a <= r <= b and a < b:
            return u + (v - u) * (r - a) / (b - a)
    raise SystemExit(f"peers: {blade['name']}: no {name} at radius {r}")


def boundaries(blade, root, elements):
    """Radii of the ends of elements: every station, and even pieces between."""
    radius = blade["rotor"]["radius"]
    names = (
        "mass",
        "flap_stiffness",
        "lag_stiffness",
        "torsion_stiffness",
        "polar_inertia",
    )
    cuts = sorted(
        {root, radius}
        | {r for name in names for r in stations(blade, name)[0] if root < r < radius}
    )
    ends = [root]
    for a, b in zip(cuts, cuts[1:]):
        pieces = max(1, round(elements * (b - a) / (radius - root)))
        ends += [a + (b - a) * i / pieces for i in range(1, pieces)] + [b]
    return ends


def write(folder, blade, elements, flat):
    """The deck of a blade. `flat` is the part of the polar inertia that lies in the chord: one half
    has no propeller moment, one is a plate's. pyBmodes takes an element's properties at its middle,
    so they are tabulated there, and steps stay between elements."""
    if set(blade.get("units", {})) - {"angle"}:
        raise SystemExit(
            f"peers: {blade['name']}: only blades in SI units are written for pyBmodes"
        )
    root, radius = blade["flap"].get("offset", 0.0), blade["rotor"]["radius"]
    ends = boundaries(blade, root, elements)
    span = [(r - root) / (radius - root) for r in ends]
    scales = ("sec_mass", "flp_iner", "lag_iner", "flp_stff", "edge_stff", "tor_stff")
    scales += ("axial_stff", "cg_offst", "sc_offst", "tc_offst")
    folder.mkdir(parents=True, exist_ok=True)
    main = MAIN.format(
        name=blade["name"],
        radius=float(radius),
        root=float(root),
        scales="\n".join(f"1.0 {scale}_mult" for scale in scales),
        count=len(ends) - 1,
        boundaries=" ".join(map(repr, span)),
    )
    (folder / "blade.bmi").write_text(main)
    middles = [(a + b) / 2 for a, b in zip(ends, ends[1:])]
    tabulated = [
        (0.0, middles[0]),
        *(((r - root) / (radius - root), r) for r in middles),
        (1.0, middles[-1]),
    ]
    stiffest = max(at(blade, "lag_stiffness", r) for r in middles)
    rows = [
        blade["name"],
        f"{len(tabulated)} n_secs",
        "",
        "columns as pyBmodes names them",
        "SI",
    ]
    for part, r in tabulated:
        polar = at(blade, "polar_inertia", r)
        row = [part, 0.0, 0.0, at(blade, "mass", r), (1 - flat) * polar, flat * polar]
        row += [at(blade, f"{dof}_stiffness", r) for dof in ("flap", "lag", "torsion")]
        rows.append(
            " ".join(map(repr, [*row, AXIAL * stiffest / radius**2, 0.0, 0.0, 0.0]))
        )
    (folder / "sections.dat").write_text("\n".join(rows) + "\n")
    return folder / "blade.bmi"


def ask(python, deck, speeds, modes, mixed=False):
    """What `bmodes_worker.py` answers, and the time of the whole process [s]."""
    request = {"deck": str(deck), "speeds": speeds, "modes": modes, "mixed": mixed}
    command = [str(python), str(HERE / "bmodes_worker.py")]
    start = time.perf_counter()
    run = subprocess.run(
        command,
        input=json.dumps(request),
        env=ENVIRONMENT,
        capture_output=True,
        text=True,
    )
    seconds = time.perf_counter() - start
    if run.returncode != 0:
        raise SystemExit(f"peers: pyBmodes failed on {deck}:\n{run.stderr[-2000:]}")
    return json.loads(run.stdout), seconds
