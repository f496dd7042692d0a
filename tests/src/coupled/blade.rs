//! The coupled blade as the oracle takes it. SI, angles in radians; properties are linear between
//! radii, and a repeated radius is a step.

use crate::blades::{End, Hold, Table};

/// Where the trapeze term takes its radius of gyration from.
#[derive(Clone, Debug, PartialEq)]
pub enum Trapeze {
    /// No trapeze term.
    Off,
    /// The square of the radius of gyration about the elastic axis, kA² [m²].
    Square(Table),
    /// The axial stiffness EA [N]: kA² = (EI1 + EI2)/EA + eA².
    AxialStiffness(Table),
}

/// A mass at one radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass {
    /// Radius [m].
    pub r: f64,
    /// Mass [kg].
    pub mass: f64,
    /// How far it lies ahead of the elastic axis, e [m].
    pub offset: f64,
    /// Mass moments about the elastic axis [kg m²]: J1 = ∫ζ², J2 = ∫η².
    pub inertia: [f64; 2],
}

/// A rotating blade that bends in two planes and twists. Stiffnesses are positive and I1 + I2 ≥ m e²
/// everywhere, or what is proven of a panel would not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledBlade {
    /// Radius of the tip [m].
    pub radius: f64,
    /// Mass per length m [kg/m].
    pub mass: Table,
    /// Bending stiffness about the chord axis (flapwise) and about its normal (chordwise), EI1 and EI2 [N m²].
    pub bending: [Table; 2],
    /// Torsional stiffness GJ [N m²].
    pub torsion: Table,
    /// Mass moments per length about the elastic axis, I1 = ∫ρζ² and I2 = ∫ρη² [kg m].
    pub inertia: [Table; 2],
    /// Mass centre ahead of the elastic axis, e [m].
    pub mass_offset: Table,
    /// Tension centre ahead of the elastic axis, eA [m].
    pub tension_offset: Table,
    /// Trapeze term.
    pub trapeze: Trapeze,
    /// Built-in twist, nose up [rad].
    pub twist: Table,
    /// Collective pitch, added to the twist [rad].
    pub pitch: f64,
    /// Precone, tip up [rad].
    pub precone: f64,
    /// Torque offset e0 [m].
    pub torque_offset: f64,
    /// Whether rotary inertia counts.
    pub rotary: bool,
    /// Angle by which two hinge springs at one radius are turned [rad].
    pub spring_angle: f64,
    /// Roots of flap, lag and torsion; inboard of its root a degree of freedom does not exist.
    pub roots: [End; 3],
    /// Point masses.
    pub point_masses: Vec<PointMass>,
}

impl CoupledBlade {
    /// A uniform blade without offsets, clamped on the axis: m = 1 and the stiffnesses given; it
    /// hardly twists (GJ 1e4, I2 1e-6).
    pub fn uniform(radius: f64, bending: [f64; 2]) -> Self {
        Self {
            radius,
            mass: Table::uniform(1.0),
            bending: bending.map(Table::uniform),
            torsion: Table::uniform(1e4),
            inertia: [0.0, 1e-6].map(Table::uniform),
            mass_offset: Table::uniform(0.0),
            tension_offset: Table::uniform(0.0),
            trapeze: Trapeze::Off,
            twist: Table::uniform(0.0),
            pitch: 0.0,
            precone: 0.0,
            torque_offset: 0.0,
            rotary: false,
            spring_angle: 0.0,
            roots: [End::clamped(0.0); 3],
            point_masses: Vec::new(),
        }
    }

    /// The tapered and twisted blade of the reference values, with every offset and the trapeze term.
    pub fn tapered() -> Self {
        let line = |root: f64, tip: f64| Table { r: vec![0.25, 2.0], y: vec![root, tip] };
        Self {
            mass: line(3.0, 2.0),
            bending: [line(20.0, 8.0), line(200.0, 100.0)],
            torsion: line(15.0, 7.0),
            inertia: [Table::uniform(0.002), line(0.04, 0.02)],
            mass_offset: line(0.04, 0.07),
            tension_offset: line(0.02, 0.03),
            trapeze: Trapeze::Square(Table::uniform(0.01)),
            twist: line(0.6, 0.1),
            roots: [End::clamped(0.25); 3],
            ..Self::uniform(2.0, [1.0, 1.0])
        }
    }

    /// Radii where a property, a degree of freedom or a mass begins or ends, from the tip inward.
    pub(super) fn cuts(&self) -> Vec<f64> {
        let first = self.roots.iter().map(|root| root.offset).fold(self.radius, f64::min);
        let gyration = match &self.trapeze {
            Trapeze::Off => None,
            Trapeze::Square(table) | Trapeze::AxialStiffness(table) => Some(table),
        };
        let tables = [&self.mass, &self.torsion, &self.mass_offset, &self.tension_offset, &self.twist];
        let tables = tables.into_iter().chain(&self.bending).chain(&self.inertia).chain(gyration);
        let mut cuts: Vec<f64> = tables.flat_map(|table| table.r.iter().copied()).collect();
        cuts.extend(self.roots.iter().map(|root| root.offset));
        cuts.extend(self.point_masses.iter().map(|mass| mass.r));
        cuts.push(self.radius);
        cuts.retain(|&r| r >= first && r <= self.radius);
        cuts.sort_by(|a, b| b.total_cmp(a));
        cuts.dedup();
        cuts
    }

    /// The springs that resist w′, v′ and φ [N m/rad].
    pub(super) fn springs(&self) -> [[f64; 3]; 3] {
        let stiffness = self.roots.map(|root| if let Hold::Spring(k) = root.hold { k } else { 0.0 });
        let [flap, lag, torsion] = stiffness;
        let hinged = self.roots[..2].iter().all(|root| root.hold != Hold::Clamped);
        #[allow(clippy::float_cmp, reason = "one radius, given twice")]
        let turned = hinged && self.roots[0].offset == self.roots[1].offset;
        let (sin, cos) = if turned { self.spring_angle.sin_cos() } else { (0.0, 1.0) };
        let coupling = (lag - flap) * sin * cos;
        let (ww, vv) = (flap * cos * cos + lag * sin * sin, flap * sin * sin + lag * cos * cos);
        [[ww, coupling, 0.0], [coupling, vv, 0.0], [0.0, 0.0, torsion]]
    }
}

/// Values of a table at both ends of [a, b], inside which it has neither step nor kink.
pub(super) fn ends(table: &Table, a: f64, b: f64) -> [f64; 2] {
    let (r, y, middle) = (&table.r, &table.y, 0.5 * (a + b));
    let after = r.partition_point(|&radius| radius <= middle);
    if after == 0 || after == r.len() {
        return [y[after.saturating_sub(1)]; 2];
    }
    let (r0, r1, y0, y1) = (r[after - 1], r[after], y[after - 1], y[after]);
    [a, b].map(|x| (y0 * (r1 - x) + y1 * (x - r0)) / (r1 - r0))
}
