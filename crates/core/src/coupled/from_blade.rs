//! From a checked blade to what acts of it in the coupled model.

use super::blade::{CoupledBlade, Lump, Trapeze};
use crate::blade::{Blade, PointMass, Property, SpringAngle};
use crate::dof::Dof;
use crate::numerics::PiecewiseLinear;
use alloc::vec::Vec;

/// By so little, relatively, may the inertia of a section fall below that of its mass at its offset: rounding.
const ROUNDING: f64 = 1e-9;
/// Parts of a stretch at whose ends that is looked at.
const PARTS: u8 = 8;

/// What of the coupled model is switched on or replaced.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Collective pitch in place of the blade's own [rad].
    pub pitch: Option<f64>,
    /// Precone in place of the blade's own [rad].
    pub precone: Option<f64>,
    /// Trapeze stiffness, from the blade's data.
    pub trapeze: bool,
    /// Rotary inertia in bending.
    pub rotary: bool,
    /// The paper's propeller moment in place of the full one.
    pub paper_moment: bool,
}

/// A section whose mass would have negative inertia about its own centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impossible {
    /// Ends of the stretch that it lies in [m].
    pub stretch: (f64, f64),
    /// Its radius [m].
    pub r: f64,
    /// I₁ + I₂ there [kg·m].
    pub inertia: f64,
    /// The least that is possible, m e² [kg·m].
    pub least: f64,
}

impl CoupledBlade {
    /// Of a blade. One that gives polar inertia alone is taken for thin: I₁ = 0, I₂ all of it.
    pub fn new(blade: &Blade, options: &Options) -> Self {
        let pitch = options.pitch.unwrap_or_else(|| blade.pitch());
        let spring_angle = match blade.spring_angle() {
            SpringAngle::Angle(angle) => angle,
            SpringAngle::Pitch => pitch + blade.twist().at(blade.root(Dof::Flap).offset),
        };
        // Where nothing twists its stiffness is of no account, but not none.
        let none = |dof| dof == Dof::Torsion && !blade.has_torsion();
        let stiffness = |dof| if none(dof) { PiecewiseLinear::uniform(1.0) } else { blade.stiffness(dof).clone() };
        let lump = |mass: &PointMass| Lump {
            r: mass.r,
            mass: mass.mass,
            offset: mass.offset,
            inertia: [mass.flap_inertia, mass.lag_inertia],
        };
        Self {
            radius: blade.radius(),
            roots: Dof::ALL.map(|dof| blade.root(dof)),
            mass: blade.mass().clone(),
            stiffness: Dof::ALL.map(stiffness),
            inertia: blade.inertias().map(Clone::clone),
            mass_offset: blade.mass_offset().clone(),
            tension_offset: blade.tension_offset().clone(),
            trapeze: if options.trapeze { trapeze(blade) } else { Trapeze::Off },
            twist: blade.twist().clone(),
            pitch,
            precone: options.precone.unwrap_or_else(|| blade.precone()),
            torque_offset: blade.torque_offset(),
            spring_angle,
            rotary: options.rotary,
            paper_moment: options.paper_moment,
            lumps: blade.point_masses().iter().map(lump).collect(),
        }
    }

    /// One section of every stretch where I₁ + I₂ about the elastic axis is below m e².
    pub fn impossible(&self) -> Vec<Impossible> {
        let stretches = self.stretches(&self.stations());
        let first = |stretch: &super::blade::CoupledStretch| {
            (0..=PARTS).find_map(|i| {
                let share = f64::from(i) / f64::from(PARTS);
                let section = stretch.section(stretch.from + (stretch.to - stretch.from) * share);
                let least = section.moment() * section.mass_offset;
                let inertia = section.inertia[0] + section.inertia[1];
                let found = Impossible { stretch: (stretch.from, stretch.to), r: section.r, inertia, least };
                (inertia < least * (1.0 - ROUNDING)).then_some(found)
            })
        };
        stretches.iter().filter_map(first).collect()
    }
}

/// From the axial stiffness, or from the radius, which is interpolated as its square.
fn trapeze(blade: &Blade) -> Trapeze {
    if blade.gives(Property::AxialStiffness) {
        return Trapeze::Axial(blade.axial_stiffness().clone());
    }
    let radius = blade.trapeze_radius();
    let squared = radius.values().iter().map(|radius| radius * radius).collect();
    PiecewiseLinear::new(radius.stations().to_vec(), squared).map_or(Trapeze::Off, Trapeze::Squared)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::{BladeDefinition, RootDefinition, check};

    fn definition() -> BladeDefinition {
        BladeDefinition::new("test", 2.0, 1.0)
            .with_flap(RootDefinition::hingeless(0.0))
            .with_lag(RootDefinition::hingeless(0.0))
            .with_torsion(RootDefinition::rigid(0.0))
            .with(Property::Mass, 3.0)
            .with(Property::FlapStiffness, 20.0)
            .with(Property::LagStiffness, 30.0)
            .with(Property::TorsionStiffness, 7.0)
            .with(Property::PolarInertia, 0.02)
            .with(Property::TrapezeRadius, [(0.0, 0.1), (2.0, 0.3)].as_slice())
    }

    const OPTIONS: Options =
        Options { pitch: Some(0.1), precone: None, trapeze: true, rotary: true, paper_moment: false };

    #[test]
    fn a_blade_with_polar_inertia_alone_is_thin() {
        let blade = CoupledBlade::new(&check(&definition()).unwrap(), &OPTIONS);
        assert_eq!((blade.inertia[0].at(1.0), blade.inertia[1].at(1.0)), (0.0, 0.02));
        assert_eq!((blade.pitch, blade.precone), (0.1, 0.0));
        let both = definition().with(Property::FlapInertia, 0.004).with(Property::LagInertia, 0.03);
        let blade = CoupledBlade::new(&check(&both).unwrap(), &OPTIONS);
        assert_eq!((blade.inertia[0].at(1.0), blade.inertia[1].at(1.0)), (0.004, 0.03));
    }

    #[test]
    fn the_trapeze_radius_is_interpolated_as_its_square() {
        let blade = CoupledBlade::new(&check(&definition()).unwrap(), &OPTIONS);
        let section = blade.stretches(&blade.stations())[0].section(1.0);
        // The mean of 0.01 and 0.09.
        assert!((section.trapeze - 0.05).abs() < 1e-16, "{}", section.trapeze);
        let off = CoupledBlade::new(&check(&definition()).unwrap(), &Options { trapeze: false, ..OPTIONS });
        assert_eq!(off.stretches(&off.stations())[0].section(1.0).trapeze, 0.0);
    }

    #[test]
    fn impossible_sections_are_found_once_per_stretch() {
        let offset = [(0.0, 0.0), (1.0, 0.0), (1.5, 0.1), (2.0, 0.0)].as_slice();
        let blade = CoupledBlade::new(&check(&definition().with(Property::MassOffset, offset)).unwrap(), &OPTIONS);
        let found = blade.impossible();
        // 3 · 0.1² = 0.03 at r = 1.5, more than 0.02.
        assert_eq!(found.iter().map(|at| at.stretch).collect::<Vec<_>>(), [(1.0, 1.5), (1.5, 2.0)]);
        assert!(found.iter().all(|at| at.inertia < at.least));
    }
}
