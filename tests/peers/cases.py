"""What is compared with which program, how near it must come, and why just that near."""

from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).parent
BENDING = ("1F", "2F", "3F", "1L", "2L", "3L")
TORSION = ("1T", "2T", "3T")

# Rectangular section, clamped at 0.1 m. Steel but for Poisson's ratio, which each case chooses.
STRIP = {
    "name": "rectangular strip",
    "radius": 1.0,
    "root": 0.1,
    "chord": 0.02,
    "thickness": 0.005,
    "youngs_modulus": 2.1e11,
    "density": 7800.0,
    "nominal_speed": 150.0,
}


@dataclass(frozen=True)
class Case:
    name: str
    title: str
    program: str  # pybmodes or calculix
    speeds: tuple  # rad/s
    modes: tuple
    coarse: (
        object  # number of elements: along the blade, or along, chordwise and through
    )
    fine: object
    tolerance: float  # of the frequency, on what no named effect explains
    reason: str
    source: str
    blade: Path | str | None = None  # a file, or a built-in blade
    order: int = 0  # the fine and coarse results are extrapolated with this order, 0: they are not
    flat: float = (
        0.5  # part of the polar inertia that lies in the chord, see bmodes.write
    )
    poisson: float = 0.0
    held: bool = True  # the root section of solid elements keeps its shape


CASES = (
    Case(
        name="uniform",
        title="uniform cantilever",
        program="pybmodes",
        blade=HERE / "blades/uniform.toml",
        speeds=(0.0, 2.0, 6.0, 12.0),
        modes=BENDING + TORSION,
        coarse=40,
        fine=80,
        tolerance=1e-7,
        source="the same equations, in cubic beam elements (quadratic in torsion); inertia split evenly, "
        "which leaves no propeller moment",
        reason="the elements' own error falls as h^4, 16-fold from the coarse mesh to the fine, and third "
        "modes keep 6.5e-8 of it",
    ),
    Case(
        name="tapered",
        title="tapered cantilever",
        program="pybmodes",
        blade=HERE / "blades/tapered.toml",
        speeds=(0.0, 20.0, 40.0, 60.0),
        modes=BENDING + TORSION,
        coarse=80,
        fine=160,
        order=2,
        tolerance=3e-7,
        source="as above; every property is linear along the blade in both programs",
        reason="pyBmodes holds properties constant in an element, which errs as h^2; extrapolated from two "
        "meshes h^4 is left, 3e-8, and the rounding of 160 elements, seen up to 1e-7 in 1L near rest on the "
        "uniform blade",
    ),
    Case(
        name="bo105",
        title="Bo 105 (estimated), built in",
        program="pybmodes",
        blade="bo105",
        speeds=(0.0, 22.2, 44.4),
        modes=BENDING,
        coarse=40,
        fine=80,
        tolerance=4e-7,
        source="as above; twist and mass offset left out on both sides, torsion not compared: pyBmodes has no "
        "pitch spring",
        reason="steps lie between elements, so h^4 as on the uniform blade; the short soft neck has 10 of the "
        "80 elements and keeps 3e-7",
    ),
    Case(
        name="propeller",
        title="uniform cantilever with the propeller moment of a flat section",
        program="pybmodes",
        blade=HERE / "blades/uniform.toml",
        speeds=(0.0, 2.0, 6.0, 12.0),
        modes=TORSION,
        coarse=40,
        fine=80,
        flat=0.99,
        tolerance=1e-7,
        source="pyBmodes with 99 % of the polar inertia in the chord; bladefan has the paper's torsion term, "
        "without that moment",
        reason="on a uniform section the moment adds exactly 0.98 speed^2 to frequency^2, named `propeller`; "
        "what is left is the elements' error",
    ),
    Case(
        name="strip",
        title="rectangular strip of solid elements, Poisson's ratio 0",
        program="calculix",
        speeds=(0.0, 75.0, 150.0),
        modes=BENDING + ("1T",),
        coarse=(60, 4, 2),
        fine=(60, 8, 4),
        tolerance=2e-4,
        source="C3D20R, all nodes of the root section held, static step with CENTRIF, then a perturbation "
        "frequency step; bladefan has the section's EI, GJ (Saint-Venant's series), m and polar inertia",
        reason="the named effects are of first order; the largest is 0.5 %, and its square 3e-5. 1T still moves by "
        "some 1e-4 with the mesh, and its clamp is estimated as a beam's. Without Poisson's effect the clamp holds nothing in bending",
    ),
    Case(
        name="steel",
        title="the same strip, Poisson's ratio 0.3, its root section free to change shape",
        program="calculix",
        speeds=(0.0, 150.0),
        modes=BENDING + ("1T",),
        coarse=(60, 4, 2),
        fine=(60, 6, 3),
        poisson=0.3,
        held=False,
        tolerance=2e-4,
        source="as above, but the root section only stays plane, its mean displacements and mean rotation about "
        "the blade's axis zero",
        reason="as above",
    ),
    Case(
        name="steel-held",
        title="the same strip, Poisson's ratio 0.3, its root section held",
        program="calculix",
        speeds=(0.0, 150.0),
        modes=BENDING + ("1T",),
        coarse=(60, 4, 2),
        fine=(60, 6, 3),
        poisson=0.3,
        tolerance=2e-3,
        source="as the first strip",
        reason="such a clamp also holds the section's change of shape that goes with bending, and a length s near it "
        "is up to 1/(1 - 0.3^2) times as stiff. Strain energy per length is there 4 times its mean in every mode at "
        "rest, so that this adds 0.2 s per blade length to the frequency. In flap s is a third of the chord, 0.145 %, "
        "of which a finer mesh keeps 0.127 %. In lag it is 0.054 %, in two parts that further runs told apart, which "
        "are not in this record: held across the chord alone the root adds 0.03 %, be the strip 2.5, 5 or 10 mm "
        "thick; held through the thickness alone 0.008, 0.017 and 0.032 %, in proportion to the thickness. No beam "
        "has this, and without it (the two strips above) nothing of this size is left",
    ),
)


def case(name):
    return next(one for one in CASES if one.name == name)
