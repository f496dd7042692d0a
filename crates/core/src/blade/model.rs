//! A checked blade in SI units: what the solver works on.

use super::definition::SpringAngle;
use super::property::Property;
use crate::dof::Dof;
use crate::fault::Warning;
use crate::numerics::PiecewiseLinear;
use alloc::string::String;
use alloc::vec::Vec;

/// By so little, relatively, may inertias contradict one another.
const NEAR: f64 = 1e-9;

/// How a root is held, as the equations see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RootCondition {
    /// No rotation at the root: hingeless bending, rigid pitch control.
    Clamped,
    /// Free to rotate: hinge without spring, pitch free (a spring of 0).
    Free,
    /// Held by a spring [N·m/rad], greater than 0.
    Spring(f64),
}

/// Root of one degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Radius of hinge or root, 0 ≤ offset < radius [m].
    pub offset: f64,
    /// How it is held.
    pub condition: RootCondition,
}

/// A mass at one radius. It acts in every degree of freedom whose root is inboard of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass {
    /// Radius, from the least root offset to the tip radius [m].
    pub r: f64,
    /// Mass, at least 0 [kg].
    pub mass: f64,
    /// Its centre ahead of the elastic axis [m]; + toward the leading edge.
    pub offset: f64,
    /// Moment of inertia of its extent out of the chord plane, about the elastic axis [kg·m²].
    pub flap_inertia: f64,
    /// Moment of inertia of its extent along the chord, about the elastic axis [kg·m²]. But for
    /// rounding, the sum of both is at least mass·offset².
    pub lag_inertia: f64,
}

/// How a blade stands on its rotor: all angles in rad, the offset in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    pub(super) pitch: f64,
    pub(super) precone: f64,
    pub(super) torque_offset: f64,
    pub(super) spring_angle: SpringAngle,
}

/// What the rotor's turning does to the twist of a blade: it turns sections flat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PropellerMoment {
    /// I₂ − I₁, of the moments of inertia of a section about the elastic axis in and out of its chord plane.
    Full,
    /// m Y² of the offset of the mass centre alone: the paper's (77).
    Paper,
}

impl PropellerMoment {
    /// The name used in options and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Paper => "paper",
        }
    }
}

/// The same, with what the signs of the full one are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Racket {
    /// That of the paper.
    #[default]
    Paper,
    /// The full one, negative nowhere.
    Flat,
    /// The full one, negative somewhere: there the extent out of the chord plane is the larger.
    Steep,
}

/// A blade that passed every check, in SI units. Each stiffness covers the span of its degree of
/// freedom, mass that of flap and lag, and so on; the solver relies on it.
///
/// One [without torsion](Self::has_torsion) has its root of torsion clamped at the tip, so that nothing of it twists,
/// and no torsional stiffness or inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct Blade {
    pub(super) name: String,
    pub(super) radius: f64,
    pub(super) nominal_speed: f64,
    pub(super) blades: Option<u32>,
    pub(super) roots: [Root; 3],
    pub(super) pose: Pose,
    pub(super) properties: [PiecewiseLinear; Property::COUNT],
    /// Which properties the definition gives; the others are 0, or a sum of some that it gives.
    pub(super) given: [bool; Property::COUNT],
    pub(super) point_masses: Vec<PointMass>,
    pub(super) racket: Racket,
    pub(super) warnings: Vec<Warning>,
}

impl Blade {
    /// Name shown in every result.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Tip radius R [m].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Nominal rotor speed [rad/s], greater than 0.
    pub fn nominal_speed(&self) -> f64 {
        self.nominal_speed
    }

    /// Number of blades, where given.
    pub fn blades(&self) -> Option<u32> {
        self.blades
    }

    /// Whether the definition gives anything of torsion; else flap and lag alone exist.
    pub fn has_torsion(&self) -> bool {
        self.gives(Property::TorsionStiffness)
    }

    /// The degrees of freedom that exist.
    pub fn dofs(&self) -> &'static [Dof] {
        if self.has_torsion() { &Dof::ALL } else { &[Dof::Flap, Dof::Lag] }
    }

    /// Root of a degree of freedom.
    pub fn root(&self, dof: Dof) -> Root {
        self.roots[dof.index()]
    }

    /// Least of the three root offsets [m].
    pub fn least_offset(&self) -> f64 {
        self.roots.iter().fold(f64::INFINITY, |least, root| least.min(root.offset))
    }

    /// Collective pitch [rad], + nose up; added to the twist everywhere.
    pub fn pitch(&self) -> f64 {
        self.pose.pitch
    }

    /// Precone [rad], + tip up; its apex lies on the rotor's axis.
    pub fn precone(&self) -> f64 {
        self.pose.precone
    }

    /// Elastic axis ahead of the radial line through the rotor's axis [m]; + toward the leading edge.
    pub fn torque_offset(&self) -> f64 {
        self.pose.torque_offset
    }

    /// By what angle [rad] the springs of flap and lag are turned; 0 where their radii differ.
    pub fn spring_angle(&self) -> SpringAngle {
        self.pose.spring_angle
    }

    /// Masses that are not spread along the span, by ascending radius.
    pub fn point_masses(&self) -> &[PointMass] {
        &self.point_masses
    }

    /// The propeller moment that torsion feels by itself; [`Racket::Paper`] unless
    /// [asked for](Self::with_full_propeller_moment).
    pub(crate) fn racket(&self) -> Racket {
        self.racket
    }

    /// The same blade with the full propeller moment.
    ///
    /// # Errors
    /// A radius [m] at which the polar inertia is less than what the moment turns: the inertias of no section.
    pub(crate) fn with_full_propeller_moment(&self) -> Result<Self, f64> {
        let ([flap, lag], polar, root) = (self.inertias(), self.polar_inertia(), self.root(Dof::Torsion).offset);
        let both = |property: &PiecewiseLinear, r: f64| <[f64; 2]>::from(property.limits(r));
        let stations = [flap, lag, polar].into_iter().flat_map(PiecewiseLinear::stations).copied();
        let mut steep = self.point_masses.iter().any(|mass| mass.flap_inertia > mass.lag_inertia);
        for r in stations.filter(|r| *r > root && *r < self.radius).chain([root, self.radius]) {
            // What lies inboard of the root and beyond the tip does not act.
            let acts = |(side, _): &(usize, f64)| if *side == 0 { r > root } else { r < self.radius };
            for (side, flap) in both(flap, r).into_iter().enumerate().filter(acts) {
                let racket = both(lag, r)[side] - flap;
                // Inertias that were rounded to be written are as good.
                if racket + both(polar, r)[side] < -NEAR * flap {
                    return Err(r);
                }
                steep |= racket < 0.0;
            }
        }
        let racket = if steep { Racket::Steep } else { Racket::Flat };
        Ok(Self { racket, ..self.clone() })
    }

    /// Moments of inertia per length about the elastic axis [kg·m] of a section's extents out of its chord plane
    /// and in it: where polar inertia alone is given a thin section is meant, all of whose inertia is in the plane.
    pub fn inertias(&self) -> [&PiecewiseLinear; 2] {
        let lag = if self.inertias_given() { self.lag_inertia() } else { self.polar_inertia() };
        [self.flap_inertia(), lag]
    }

    /// Whether flap and lag inertia are given; else a thin section is meant, all of whose polar
    /// inertia is that of lag.
    pub fn inertias_given(&self) -> bool {
        self.gives(Property::FlapInertia)
    }

    /// Whether the definition gives a property itself; else it is 0, or a sum of some that it gives.
    pub fn gives(&self, property: Property) -> bool {
        self.given[property.index()]
    }

    /// A property along the span, in SI units.
    pub fn property(&self, property: Property) -> &PiecewiseLinear {
        &self.properties[property.index()]
    }

    /// Mass per length m(r) [kg/m].
    pub fn mass(&self) -> &PiecewiseLinear {
        self.property(Property::Mass)
    }

    /// `EI_flap`, `EI_lag` or GJ along the span [N·m²].
    pub fn stiffness(&self, dof: Dof) -> &PiecewiseLinear {
        self.property(Property::stiffness(dof))
    }

    /// Polar mass moment of inertia per length ρI_p(r) [kg·m].
    pub fn polar_inertia(&self) -> &PiecewiseLinear {
        self.property(Property::PolarInertia)
    }

    /// Moment of inertia per length of the extent out of the chord plane, about the elastic axis
    /// [kg·m]; 0 where it [is not given](Self::inertias_given).
    pub fn flap_inertia(&self) -> &PiecewiseLinear {
        self.property(Property::FlapInertia)
    }

    /// Moment of inertia per length of the extent along the chord, about the elastic axis [kg·m]; 0
    /// where it [is not given](Self::inertias_given).
    pub fn lag_inertia(&self) -> &PiecewiseLinear {
        self.property(Property::LagInertia)
    }

    /// Centre of mass ahead of the elastic axis Y(r) [m]; + toward the leading edge.
    pub fn mass_offset(&self) -> &PiecewiseLinear {
        self.property(Property::MassOffset)
    }

    /// Built-in twist along the span [rad]; + nose up.
    pub fn twist(&self) -> &PiecewiseLinear {
        self.property(Property::Twist)
    }

    /// Tension centre ahead of the elastic axis [m]; + toward the leading edge.
    pub fn tension_offset(&self) -> &PiecewiseLinear {
        self.property(Property::TensionOffset)
    }

    /// Axial stiffness EA [N], greater than 0; 0 everywhere where it is not known.
    pub fn axial_stiffness(&self) -> &PiecewiseLinear {
        self.property(Property::AxialStiffness)
    }

    /// Radius of gyration of the tensioned area about the elastic axis [m], where it is given in place
    /// of the axial stiffness.
    pub fn trapeze_radius(&self) -> &PiecewiseLinear {
        self.property(Property::TrapezeRadius)
    }

    /// What in the blade's input does not act as its author may expect, whatever is solved.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
