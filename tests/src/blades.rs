//! Blades as the tests describe them. One description feeds the product (through its blade
//! definition and check) and the independent solution in [`exact`](crate::exact), so that neither
//! depends on how the other reads a table.

use crate::coupled::PointMass;
use bladefan_core::Dof;
use bladefan_core::PiecewiseLinear;
use bladefan_core::formats::{Format, read};
use bladefan_core::library;
use bladefan_core::{
    Blade, BladeDefinition, PointMassDefinition, Property, PropertyDefinition, RootCondition, RootDefinition,
};

/// A property along the span: linear between radii, a repeated radius is a step. SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Radii [m], ascending.
    pub r: Vec<f64>,
    /// Values at these radii.
    pub y: Vec<f64>,
}

impl Table {
    /// The same value at every radius.
    pub fn uniform(value: f64) -> Self {
        Self { r: vec![0.0], y: vec![value] }
    }

    /// Constant values between the `radii`; one value fewer than radii.
    pub fn steps(radii: &[f64], values: &[f64]) -> Self {
        assert_eq!(radii.len(), values.len() + 1, "one value per interval");
        let (mut r, mut y) = (Vec::new(), Vec::new());
        for (ends, &value) in radii.windows(2).zip(values) {
            r.extend_from_slice(ends);
            y.extend_from_slice(&[value, value]);
        }
        Self { r, y }
    }

    /// A function sampled at `count` + 1 evenly spaced radii of [0, `radius`].
    pub fn sampled(radius: f64, count: usize, f: impl Fn(f64) -> f64) -> Self {
        let r: Vec<f64> = (0..=count).map(|i| radius * i as f64 / count as f64).collect();
        let y = r.iter().map(|&x| f(x)).collect();
        Self { r, y }
    }

    /// The same property with every value multiplied by `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self { r: self.r.clone(), y: self.y.iter().map(|y| y * factor).collect() }
    }

    fn definition(&self) -> PropertyDefinition {
        if self.r.len() == 1 {
            PropertyDefinition::Uniform(self.y[0])
        } else {
            PropertyDefinition::OwnRadii { r: self.r.clone(), values: self.y.clone() }
        }
    }
}

/// How a root is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// No rotation.
    Clamped,
    /// Free to rotate; only bending has this word, torsion takes `Spring(0.0)`.
    Free,
    /// Spring [N·m/rad].
    Spring(f64),
}

/// Root of one degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Radius of the root [m].
    pub offset: f64,
    /// How it is held.
    pub hold: Hold,
}

impl End {
    /// A clamped root at radius `offset`.
    pub const fn clamped(offset: f64) -> Self {
        Self { offset, hold: Hold::Clamped }
    }

    /// A free hinge at radius `offset`.
    pub const fn free(offset: f64) -> Self {
        Self { offset, hold: Hold::Free }
    }

    /// A spring at radius `offset`.
    pub const fn spring(offset: f64, stiffness: f64) -> Self {
        Self { offset, hold: Hold::Spring(stiffness) }
    }
}

/// A blade, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct TestBlade {
    /// Tip radius [m].
    pub radius: f64,
    /// Nominal speed [rad/s].
    pub nominal_speed: f64,
    /// Roots of flap, lag, torsion.
    pub roots: [End; 3],
    /// Mass per length [kg/m].
    pub mass: Table,
    /// Stiffness of flap, lag, torsion [N·m²].
    pub stiffness: [Table; 3],
    /// Polar mass moment of inertia per length [kg·m].
    pub polar_inertia: Table,
    /// Mass offset [m].
    pub mass_offset: Table,
    /// Point masses.
    pub point_masses: Vec<PointMass>,
    /// I1 and I2, the mass moments per length out of the chord plane and in it [kg·m]; where they are given torsion
    /// feels the full propeller moment, I2 − I1, and the polar inertia is their sum.
    pub inertias: Option<[Table; 2]>,
}

impl TestBlade {
    /// A uniform blade of unit mass, stiffness and inertia, clamped at the rotor centre.
    pub fn uniform(radius: f64) -> Self {
        Self {
            radius,
            nominal_speed: 1.0,
            roots: [End::clamped(0.0); 3],
            mass: Table::uniform(1.0),
            stiffness: [Table::uniform(1.0), Table::uniform(1.0), Table::uniform(1.0)],
            polar_inertia: Table::uniform(1.0),
            mass_offset: Table::uniform(0.0),
            point_masses: Vec::new(),
            inertias: None,
        }
    }

    /// The hingeless blade with large stiffness steps on which smooth functions converge slowly.
    pub fn stepped() -> Self {
        let radii = [0.09, 0.2, 0.3, 0.962];
        let stiffness = Table::steps(&radii, &[1500.0, 60.0, 17.0]);
        Self {
            nominal_speed: 105.0,
            roots: [End::clamped(0.09); 3],
            mass: Table::steps(&radii, &[1.5, 0.8, 0.34]),
            stiffness: [stiffness.clone(), stiffness.clone(), stiffness],
            polar_inertia: Table::uniform(1e-3),
            ..Self::uniform(0.962)
        }
    }

    /// The same blade with another root of one degree of freedom.
    #[must_use]
    pub fn with_root(mut self, dof: Dof, end: End) -> Self {
        self.roots[dof.index()] = end;
        self
    }

    /// The same blade with another stiffness of one degree of freedom.
    #[must_use]
    pub fn with_stiffness(mut self, dof: Dof, stiffness: Table) -> Self {
        self.stiffness[dof.index()] = stiffness;
        self
    }

    /// The same blade with all stiffnesses and springs multiplied by `stiffness`, all masses and
    /// inertias by `mass`.
    #[must_use]
    pub fn scaled(&self, stiffness: f64, mass: f64) -> Self {
        let mut scaled = self.clone();
        for table in &mut scaled.stiffness {
            *table = table.times(stiffness);
        }
        for root in &mut scaled.roots {
            if let Hold::Spring(k) = &mut root.hold {
                *k *= stiffness;
            }
        }
        scaled.mass = scaled.mass.times(mass);
        scaled.polar_inertia = scaled.polar_inertia.times(mass);
        for table in scaled.inertias.iter_mut().flatten() {
            *table = table.times(mass);
        }
        for lump in &mut scaled.point_masses {
            lump.mass *= mass;
            lump.inertia = lump.inertia.map(|inertia| inertia * mass);
        }
        scaled
    }

    /// The blade as a user would define it.
    pub fn definition(&self) -> BladeDefinition {
        let root = |dof: Dof| {
            let End { offset, hold } = self.roots[dof.index()];
            match (dof, hold) {
                (Dof::Torsion, Hold::Clamped) => RootDefinition::rigid(offset),
                (Dof::Torsion, Hold::Free) => RootDefinition::spring(offset, 0.0),
                (Dof::Torsion, Hold::Spring(k)) => RootDefinition::spring(offset, k),
                (_, Hold::Clamped) => RootDefinition::hingeless(offset),
                (_, Hold::Free) => RootDefinition::hinged(offset),
                (_, Hold::Spring(k)) => RootDefinition::spring_hinged(offset, k),
            }
        };
        let blade = BladeDefinition::new("test blade", self.radius, self.nominal_speed)
            .with_flap(root(Dof::Flap))
            .with_lag(root(Dof::Lag))
            .with_torsion(root(Dof::Torsion))
            .with(Property::Mass, self.mass.definition())
            .with(Property::FlapStiffness, self.stiffness[0].definition())
            .with(Property::LagStiffness, self.stiffness[1].definition())
            .with(Property::TorsionStiffness, self.stiffness[2].definition())
            .with(Property::PolarInertia, self.polar_inertia.definition())
            .with(Property::MassOffset, self.mass_offset.definition());
        let blade = match &self.inertias {
            Some([flap, lag]) => {
                blade.with(Property::FlapInertia, flap.definition()).with(Property::LagInertia, lag.definition())
            }
            None => blade,
        };
        self.point_masses.iter().fold(blade, |blade, mass| {
            let own = PointMassDefinition::new(mass.r, mass.mass).with_offset(mass.offset);
            blade.with_point_mass(own.with_inertias(mass.inertia[0], mass.inertia[1]))
        })
    }

    /// A built-in blade, by its name.
    ///
    /// # Panics
    /// Where there is none of this name, or it has faults.
    pub fn built_in(name: &str) -> Self {
        Self::from(&built_in(name))
    }

    /// The checked blade.
    ///
    /// # Panics
    /// Where the product refuses the blade: every test blade is legal.
    pub fn blade(&self) -> Blade {
        bladefan_core::check(&self.definition()).unwrap_or_else(|faults| panic!("refused: {faults:?}\n{self:?}"))
    }
}

impl From<&Blade> for TestBlade {
    /// The tables and roots of a checked blade.
    fn from(blade: &Blade) -> Self {
        let table =
            |property: &PiecewiseLinear| Table { r: property.stations().to_vec(), y: property.values().to_vec() };
        Self {
            radius: blade.radius(),
            nominal_speed: blade.nominal_speed(),
            roots: Dof::ALL.map(|dof| {
                let root = blade.root(dof);
                let hold = match root.condition {
                    RootCondition::Clamped => Hold::Clamped,
                    RootCondition::Free => Hold::Free,
                    RootCondition::Spring(k) => Hold::Spring(k),
                };
                End { offset: root.offset, hold }
            }),
            mass: table(blade.mass()),
            stiffness: Dof::ALL.map(|dof| table(blade.stiffness(dof))),
            polar_inertia: table(blade.polar_inertia()),
            mass_offset: table(blade.mass_offset()),
            point_masses: blade
                .point_masses()
                .iter()
                .map(|mass| PointMass {
                    r: mass.r,
                    mass: mass.mass,
                    offset: mass.offset,
                    inertia: [mass.flap_inertia, mass.lag_inertia],
                })
                .collect(),
            inertias: None,
        }
    }
}

/// The same blade with flap and lag alone.
#[must_use]
pub fn without_torsion(mut blade: BladeDefinition) -> BladeDefinition {
    blade.torsion = None;
    if let Some(given) = &mut blade.distribution {
        for property in Property::OF_TORSION {
            given[property] = None;
        }
    }
    blade
}

/// A built-in blade as the product reads it.
///
/// # Panics
/// Where there is none of this name, or it has faults.
pub fn built_in(name: &str) -> Blade {
    let entry = library::find(name).unwrap_or_else(|| panic!("no built-in blade {name}"));
    read(entry.toml, Format::Toml).unwrap_or_else(|faults| panic!("{name}: {faults:?}")).blade
}
