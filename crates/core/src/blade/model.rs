//! A checked blade in SI units: what the solver works on.

use super::property::Property;
use crate::dof::Dof;
use crate::fault::Warning;
use crate::numerics::PiecewiseLinear;
use alloc::string::String;
use alloc::vec::Vec;

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

/// A blade that passed every check, in SI units. Each stiffness covers the span of its degree of
/// freedom, mass that of flap and lag, and so on; the solver relies on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Blade {
    pub(super) name: String,
    pub(super) radius: f64,
    pub(super) nominal_speed: f64,
    pub(super) blades: Option<u32>,
    pub(super) roots: [Root; 3],
    pub(super) properties: [PiecewiseLinear; Property::COUNT],
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

    /// Root of a degree of freedom.
    pub fn root(&self, dof: Dof) -> Root {
        self.roots[dof.index()]
    }

    /// Least of the three root offsets [m].
    pub fn least_offset(&self) -> f64 {
        self.roots.iter().fold(f64::INFINITY, |least, root| least.min(root.offset))
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

    /// Centre of mass ahead of the elastic axis Y(r) [m]; + toward the leading edge.
    pub fn mass_offset(&self) -> &PiecewiseLinear {
        self.property(Property::MassOffset)
    }

    /// Built-in twist along the span [rad]; + nose up.
    pub fn twist(&self) -> &PiecewiseLinear {
        self.property(Property::Twist)
    }

    /// What in the blade's input does not act as its author may expect, whatever is solved.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
