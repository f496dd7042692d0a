"""The strip that CalculiX solves in three dimensions: its section as a beam, and by how much solid
elements should differ from a slender beam. Each effect is of first order, and named."""

import math

EFFECTS = {
    "shear": "deformation by the shear force",
    "rotary": "inertia of the sections as they tilt",
    "clamp": "the root section cannot warp, which in torsion shortens the blade",
    "propeller": "the propeller moment, which bladefan's torsion term leaves out: to frequency^2 it adds speed^2 "
    "times the difference of the section's two moments of inertia, by their sum",
    "tension": "the pull on fibres off the axis: in torsion it straightens the twisted ones, which bladefan "
    "leaves out too; in bending it adds stress / E to EI, and bends by its fall along the blade",
    "contraction": "the stretched blade is thinner by Poisson's ratio",
}


def odd_terms(count=40):
    return range(1, 2 * count, 2)


class Section:
    """A rectangle, its chord in the disc plane, of a material without Poisson's effect or with it."""

    def __init__(self, strip, poisson):
        c, t = strip["chord"], strip["thickness"]
        self.youngs = strip["youngs_modulus"]
        self.poisson = poisson
        self.shear = self.youngs / (2 * (1 + poisson))
        self.area = c * t
        self.mass = strip["density"] * self.area
        self.density = strip["density"]
        # Timoshenko's, of a narrow rectangle
        self.shear_coefficient = 5 * (1 + poisson) / (6 + 5 * poisson)
        self.second_moment = {"flap": c * t**3 / 12, "lag": t * c**3 / 12}
        self.polar = sum(self.second_moment.values())
        tail = sum(math.tanh(n * math.pi * c / (2 * t)) / n**5 for n in odd_terms())
        self.torsion = c * t**3 / 3 * (1 - 192 * t / (math.pi**5 * c) * tail)
        self.warping = warping(c, t)

    def stiffness(self, dof):
        if dof == "torsion":
            return self.shear * self.torsion
        return self.youngs * self.second_moment[dof]

    def blade(self, strip):
        """The same strip as a blade file."""
        roots = {"flap": "hingeless", "lag": "hingeless", "torsion": "rigid"}
        lines = [
            'schema = "bladefan-blade/1"',
            f'name = "{strip["name"]}"',
            "",
            "[rotor]",
        ]
        lines += [
            f"radius = {strip['radius']!r}",
            f"nominal_speed = {strip['nominal_speed']!r}",
        ]
        for dof, root in roots.items():
            lines += ["", f"[{dof}]", f'root = "{root}"', f"offset = {strip['root']!r}"]
        lines += ["", "[distribution]", f"mass = {self.mass!r}"]
        lines += [f"{dof}_stiffness = {self.stiffness(dof)!r}" for dof in roots]
        lines += [f"polar_inertia = {self.density * self.polar!r}", ""]
        return "\n".join(lines)


def warping(c, t, panels=60):
    """Integral of the square of Saint-Venant's warping function over the rectangle."""

    def function(y, z):
        total = -y * z
        for index, n in enumerate(odd_terms(12)):
            k = n * math.pi / t
            # sinh / cosh, as a difference of powers that cannot overflow
            ratio = (
                math.exp(k * (y - c / 2))
                * (1 - math.exp(-2 * k * y))
                / (1 + math.exp(-k * c))
            )
            total += 8 * (-1) ** index / (t * k**3) * math.sin(k * z) * ratio
        return total

    # Odd in both directions: a quarter by midpoints holds all of it.
    dy, dz = c / 2 / panels, t / 2 / panels
    points = [
        (dy * (i + 0.5), dz * (j + 0.5)) for i in range(panels) for j in range(panels)
    ]
    return 4 * dy * dz * sum(function(y, z) ** 2 for y, z in points)


def integral(r, values):
    """Simpson's rule on evenly spaced radii."""
    step = (r[-1] - r[0]) / (len(r) - 1)
    return (
        step
        / 3
        * (values[0] + values[-1] + 4 * sum(values[1:-1:2]) + 2 * sum(values[2:-1:2]))
    )


def derivative(r, values):
    """Differences of second order, one-sided at the ends."""
    step = r[1] - r[0]
    inside = [
        (after - before) / (2 * step) for before, after in zip(values, values[2:])
    ]
    first = (-3 * values[0] + 4 * values[1] - values[2]) / (2 * step)
    last = (3 * values[-1] - 4 * values[-2] + values[-3]) / (2 * step)
    return [first, *inside, last]


def effects(strip, section, shape, r, speed):
    """{effect: change of frequency relative to the beam's} for one mode shape of bladefan."""
    omega2, dof = shape["frequency_rad_s"] ** 2, shape["dof"]
    x, slope, moment = shape["displacement"], shape["slope"], shape["moment"]
    stress = [
        section.density * speed**2 * (strip["radius"] ** 2 - at**2) / 2 for at in r
    ]

    def over(inertia, **energies):
        """From twice the energies, relative to omega squared of the beam; half of it to omega."""
        kinetic = inertia * integral(r, [u * u for u in x])
        return {name: value / kinetic / omega2 / 2 for name, value in energies.items()}

    # Twice the energy that the pull's own strain adds; Poisson's ratio of it is the sections' contraction,
    # squared in bending stiffness, and in torsion to the fourth over the square in inertia.
    stiffness = section.stiffness(dof)
    strained = [s / section.youngs * m * m / stiffness for s, m in zip(stress, moment)]
    thinner = -2 * section.poisson * integral(r, strained)
    if dof == "torsion":
        moments = section.second_moment
        difference = section.density * (moments["lag"] - moments["flap"])
        straightened = [s * d * d for s, d in zip(stress, slope)]
        rotating = over(
            section.density * section.polar,
            propeller=speed**2 * difference * integral(r, [u * u for u in x]),
            tension=section.polar * integral(r, straightened),
            contraction=thinner,
        )
        # The blade twists as if it were shorter by this length: the decay of what holds the warping.
        ratio = section.torsion / section.polar
        warping_length2 = section.youngs * section.warping / stiffness
        shorter = math.sqrt(warping_length2 * (1 - ratio))
        length = strip["radius"] - strip["root"]
        return {"clamp": shorter / (length - shorter), **rotating}
    # A fibre off the axis tilts by the slope over its stretch, and the stretch falls toward the tip.
    falling = [
        2 * speed**2 * section.density / section.youngs * at * d * m
        for at, d, m in zip(r, slope, moment)
    ]
    second = section.second_moment[dof]
    # A section that tilts out of the disc plane is thrown outward; one that turns in it is not.
    thrown = omega2 + (speed**2 if dof == "flap" else 0)
    force2 = integral(r, [v * v for v in derivative(r, moment)])
    tilted = integral(r, [s * s for s in slope])
    return over(
        section.mass,
        shear=-force2 / (section.shear_coefficient * section.shear * section.area),
        rotary=-section.density * second * thrown * tilted,
        tension=integral(r, strained) + integral(r, falling),
        contraction=thinner,
    )
