//! A blade written in code: every part by its name, numbers without `Some` around them.

use super::definition::{
    BladeDefinition, DistributionDefinition, PointMassDefinition, PropertyDefinition, RootDefinition, RootKind,
    RotorDefinition, Source, SpringAngle,
};
use super::property::Property;
use crate::units::Units;
use alloc::string::String;
use alloc::vec::Vec;

impl BladeDefinition {
    /// A blade of a name, a tip radius and a nominal rotor speed, which still lacks its roots and
    /// properties. In SI units unless [`in_units`](Self::in_units) says otherwise.
    pub fn new(name: impl Into<String>, radius: f64, nominal_speed: f64) -> Self {
        Self {
            name: Some(name.into()),
            rotor: Some(RotorDefinition {
                radius: Some(radius),
                nominal_speed: Some(nominal_speed),
                ..RotorDefinition::default()
            }),
            ..Self::default()
        }
    }

    /// Says what units all its numbers are in; converts none.
    #[must_use]
    pub fn in_units(self, units: Units) -> Self {
        Self { units, ..self }
    }

    /// With a number of blades.
    #[must_use]
    pub fn with_blades(mut self, count: u32) -> Self {
        self.rotor.get_or_insert_default().blades = Some(count.into());
        self
    }

    /// With a collective pitch [angle], + nose up.
    #[must_use]
    pub fn with_pitch(mut self, pitch: f64) -> Self {
        self.rotor.get_or_insert_default().pitch = Some(pitch);
        self
    }

    /// With a precone [angle], + tip up.
    #[must_use]
    pub fn with_precone(mut self, precone: f64) -> Self {
        self.rotor.get_or_insert_default().precone = Some(precone);
        self
    }

    /// With its elastic axis this far [length] ahead of the radial line through the rotor's axis.
    #[must_use]
    pub fn with_torque_offset(mut self, offset: f64) -> Self {
        self.rotor.get_or_insert_default().torque_offset = Some(offset);
        self
    }

    /// With the springs of flap and lag turned by this angle.
    #[must_use]
    pub fn with_spring_angle(mut self, angle: SpringAngle) -> Self {
        self.rotor.get_or_insert_default().spring_angle = Some(angle);
        self
    }

    /// With one more mass at a radius.
    #[must_use]
    pub fn with_point_mass(mut self, mass: PointMassDefinition) -> Self {
        self.point_masses.push(mass);
        self
    }

    /// With a source of its numbers and what that is worth: one of [`Source::QUALITIES`].
    #[must_use]
    pub fn with_source(self, citation: impl Into<String>, quality: impl Into<String>) -> Self {
        Self { source: Some(Source { citation: Some(citation.into()), quality: Some(quality.into()) }), ..self }
    }

    /// With this root in flap.
    #[must_use]
    pub fn with_flap(self, root: RootDefinition) -> Self {
        Self { flap: Some(root), ..self }
    }

    /// With this root in lag.
    #[must_use]
    pub fn with_lag(self, root: RootDefinition) -> Self {
        Self { lag: Some(root), ..self }
    }

    /// With this root in torsion.
    #[must_use]
    pub fn with_torsion(self, root: RootDefinition) -> Self {
        Self { torsion: Some(root), ..self }
    }

    /// With the radii on which properties stand that are lists of values.
    #[must_use]
    pub fn with_stations(mut self, radii: impl Into<Vec<f64>>) -> Self {
        self.distribution.get_or_insert_with(DistributionDefinition::default).r = Some(radii.into());
        self
    }

    /// With a property: one number for all radii, a list of values on the stations, or pairs of a
    /// radius and a value.
    #[must_use]
    pub fn with(mut self, property: Property, value: impl Into<PropertyDefinition>) -> Self {
        self.distribution.get_or_insert_with(DistributionDefinition::default)[property] = Some(value.into());
        self
    }
}

impl RootDefinition {
    const fn of(root: RootKind, offset: f64) -> Self {
        Self { root: Some(root), offset: Some(offset), offset_ratio: None, spring: None }
    }

    const fn sprung(root: RootKind, offset: f64, spring: f64) -> Self {
        Self { spring: Some(spring), ..Self::of(root, offset) }
    }

    /// Bending, clamped at this radius.
    pub const fn hingeless(offset: f64) -> Self {
        Self::of(RootKind::Hingeless, offset)
    }

    /// Bending, a free hinge at this radius.
    pub const fn hinged(offset: f64) -> Self {
        Self::of(RootKind::Hinged, offset)
    }

    /// Bending, a hinge with a spring [force·length/rad] at this radius.
    pub const fn spring_hinged(offset: f64, spring: f64) -> Self {
        Self::sprung(RootKind::SpringHinged, offset, spring)
    }

    /// Torsion, stiff pitch control at this radius.
    pub const fn rigid(offset: f64) -> Self {
        Self::of(RootKind::Rigid, offset)
    }

    /// Torsion, pitch control with a spring [force·length/rad] at this radius.
    pub const fn spring(offset: f64, spring: f64) -> Self {
        Self::sprung(RootKind::Spring, offset, spring)
    }
}

impl PointMassDefinition {
    /// A mass [mass] on the elastic axis at this radius [length].
    pub const fn new(r: f64, mass: f64) -> Self {
        Self { r: Some(r), mass: Some(mass), offset: None, flap_inertia: None, lag_inertia: None }
    }

    /// The same with its centre this far [length] ahead of the elastic axis.
    #[must_use]
    pub const fn with_offset(self, offset: f64) -> Self {
        Self { offset: Some(offset), ..self }
    }

    /// The same with these moments of inertia about the elastic axis [mass·length²], of its extents
    /// out of the chord plane and along the chord.
    #[must_use]
    pub const fn with_inertias(self, flap: f64, lag: f64) -> Self {
        Self { flap_inertia: Some(flap), lag_inertia: Some(lag), ..self }
    }
}

impl From<f64> for PropertyDefinition {
    /// One number for all radii.
    fn from(value: f64) -> Self {
        Self::Uniform(value)
    }
}

impl From<Vec<f64>> for PropertyDefinition {
    /// Values on the stations.
    fn from(values: Vec<f64>) -> Self {
        Self::OnStations(values)
    }
}

impl<const N: usize> From<[f64; N]> for PropertyDefinition {
    /// Values on the stations.
    fn from(values: [f64; N]) -> Self {
        Self::OnStations(values.into())
    }
}

impl From<&[(f64, f64)]> for PropertyDefinition {
    /// Pairs of a radius and the value there.
    fn from(points: &[(f64, f64)]) -> Self {
        let (r, values) = points.iter().copied().unzip();
        Self::OwnRadii { r, values }
    }
}

impl<const N: usize> From<[(f64, f64); N]> for PropertyDefinition {
    /// Pairs of a radius and the value there.
    fn from(points: [(f64, f64); N]) -> Self {
        points.as_slice().into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::check;
    use crate::dof::Dof;
    use alloc::vec;

    #[test]
    fn a_blade_in_code_is_the_blade_of_its_fields() {
        let blade = BladeDefinition::new("in code", 2.0, 60.0)
            .with_blades(4)
            .with_pitch(0.1)
            .with_precone(-0.2)
            .with_torque_offset(0.03)
            .with_spring_angle(SpringAngle::Pitch)
            .with_point_mass(PointMassDefinition::new(2.0, 0.4))
            .with_point_mass(PointMassDefinition::new(1.0, 0.3).with_offset(0.1).with_inertias(0.2, 0.5))
            .with_source("nobody", "example")
            .with_flap(RootDefinition::hinged(0.1))
            .with_lag(RootDefinition::spring_hinged(0.1, 3.0))
            .with_torsion(RootDefinition::spring(0.0, 5.0))
            .with_stations([0.0, 1.0, 2.0])
            .with(Property::Mass, [3.0, 2.0, 1.0])
            .with(Property::FlapStiffness, [(0.1, 7.0), (2.0, 6.0)])
            .with(Property::LagStiffness, 9.0)
            .with(Property::TorsionStiffness, vec![1.0; 3])
            .with(Property::PolarInertia, 0.1);
        let rotor = RotorDefinition {
            radius: Some(2.0),
            nominal_speed: Some(60.0),
            blades: Some(4.0),
            pitch: Some(0.1),
            precone: Some(-0.2),
            torque_offset: Some(0.03),
            spring_angle: Some(SpringAngle::Pitch),
        };
        assert_eq!(blade.rotor, Some(rotor));
        let all = |r, mass, [offset, flap_inertia, lag_inertia]: [Option<f64>; 3]| PointMassDefinition {
            r: Some(r),
            mass: Some(mass),
            offset,
            flap_inertia,
            lag_inertia,
        };
        let masses = [all(2.0, 0.4, [None; 3]), all(1.0, 0.3, [Some(0.1), Some(0.2), Some(0.5)])];
        assert_eq!(blade.point_masses, masses);
        let distribution = blade.distribution.as_ref().unwrap();
        assert_eq!(distribution.r, Some(vec![0.0, 1.0, 2.0]));
        assert_eq!(distribution[Property::Mass], Some(PropertyDefinition::OnStations(vec![3.0, 2.0, 1.0])));
        let own = PropertyDefinition::OwnRadii { r: vec![0.1, 2.0], values: vec![7.0, 6.0] };
        assert_eq!(distribution[Property::FlapStiffness], Some(own));
        assert_eq!(check(&blade).unwrap().stiffness(Dof::Lag).at(1.0), 9.0);
        let clamped = blade
            .with_flap(RootDefinition::hingeless(0.2))
            .with_lag(RootDefinition::hingeless(0.2))
            .with_torsion(RootDefinition::rigid(0.3));
        assert_eq!(check(&clamped).unwrap().root(Dof::Torsion).offset, 0.3);
    }

    #[test]
    fn what_is_not_said_is_missing_and_nothing_else() {
        let faults = check(&BladeDefinition::new("bare", 1.0, 1.0).in_units(Units::default())).unwrap_err();
        let paths: Vec<&str> = faults.iter().map(|fault| fault.path.as_str()).collect();
        assert_eq!(paths, ["flap", "lag", "distribution"]);
    }
}
