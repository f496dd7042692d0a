//! A coupled blade as the product takes it.

use super::{CoupledBlade, Trapeze};
use crate::blades::{End, Hold, Table};
use bladefan_core::{BladeDefinition, PointMassDefinition, Property, PropertyDefinition, RootDefinition, SpringAngle};

impl CoupledBlade {
    /// The same blade as a definition, with everything that it has; `rotary` is a setting there.
    pub fn definition(&self) -> BladeDefinition {
        let bending = |end: End| match end.hold {
            Hold::Clamped => RootDefinition::hingeless(end.offset),
            Hold::Free => RootDefinition::hinged(end.offset),
            Hold::Spring(spring) => RootDefinition::spring_hinged(end.offset, spring),
        };
        let [flap, lag, torsion] = self.roots;
        let pitch = match torsion.hold {
            Hold::Clamped => RootDefinition::rigid(torsion.offset),
            Hold::Free => RootDefinition::spring(torsion.offset, 0.0),
            Hold::Spring(spring) => RootDefinition::spring(torsion.offset, spring),
        };
        let mut definition = BladeDefinition::new("random", self.radius, 1.0)
            .with_flap(bending(flap))
            .with_lag(bending(lag))
            .with_torsion(pitch)
            .with(Property::Mass, given(&self.mass))
            .with(Property::FlapStiffness, given(&self.bending[0]))
            .with(Property::LagStiffness, given(&self.bending[1]))
            .with(Property::TorsionStiffness, given(&self.torsion))
            .with(Property::FlapInertia, given(&self.inertia[0]))
            .with(Property::LagInertia, given(&self.inertia[1]))
            .with(Property::MassOffset, given(&self.mass_offset))
            .with(Property::TensionOffset, given(&self.tension_offset))
            .with(Property::Twist, given(&self.twist))
            .with_pitch(self.pitch)
            .with_precone(self.precone)
            .with_torque_offset(self.torque_offset);
        let both = [flap, lag].iter().all(|end| end.hold != Hold::Clamped);
        #[allow(clippy::float_cmp, reason = "one radius to the bit")]
        let at_one_radius = flap.offset == lag.offset;
        if both && at_one_radius {
            definition = definition.with_spring_angle(SpringAngle::Angle(self.spring_angle));
        }
        definition = match &self.trapeze {
            Trapeze::Off => definition,
            Trapeze::Square(table) => {
                let radius = Table { r: table.r.clone(), y: table.y.iter().map(|square| square.sqrt()).collect() };
                definition.with(Property::TrapezeRadius, given(&radius))
            }
            Trapeze::AxialStiffness(table) => definition.with(Property::AxialStiffness, given(table)),
        };
        for mass in &self.point_masses {
            let own = PointMassDefinition::new(mass.r, mass.mass)
                .with_offset(mass.offset)
                .with_inertias(mass.inertia[0], mass.inertia[1]);
            definition = definition.with_point_mass(own);
        }
        definition
    }
}

fn given(table: &Table) -> PropertyDefinition {
    match table.y.as_slice() {
        [value] => PropertyDefinition::Uniform(*value),
        _ => PropertyDefinition::OwnRadii { r: table.r.clone(), values: table.y.clone() },
    }
}
