//! Changes of a coupled blade under which its frequencies stay, or change in a known way.

use super::{CoupledBlade, PointMass, Trapeze};
use crate::blades::{Hold, Table};
use core::f64::consts::FRAC_PI_2;

impl CoupledBlade {
    /// The blade as a mirror beside it shows it (y to −y): angles and offsets change their sign, precone does not.
    #[must_use]
    pub fn mirrored_in_plane(&self) -> Self {
        self.with_angles(-1.0).with_offsets(-1.0)
    }

    /// The blade as a mirror below it shows it (z to −z): angles and precone change their sign, offsets do not.
    #[must_use]
    pub fn mirrored_out_of_plane(&self) -> Self {
        Self { precone: -self.precone, ..self.with_angles(-1.0) }
    }

    /// Twist, pitch and the angle of the springs times `factor`.
    #[must_use]
    pub fn with_angles(&self, factor: f64) -> Self {
        Self {
            twist: self.twist.times(factor),
            pitch: factor * self.pitch,
            spring_angle: factor * self.spring_angle,
            ..self.clone()
        }
    }

    /// All offsets along the chord, and the torque offset, times `factor`; inertias about the elastic axis stay.
    #[must_use]
    pub fn with_offsets(&self, factor: f64) -> Self {
        let moved = |mass: &PointMass| PointMass { offset: factor * mass.offset, ..*mass };
        Self {
            mass_offset: self.mass_offset.times(factor),
            tension_offset: self.tension_offset.times(factor),
            torque_offset: factor * self.torque_offset,
            point_masses: self.point_masses.iter().map(moved).collect(),
            ..self.clone()
        }
    }

    /// Pitched up by a quarter turn.
    #[must_use]
    pub fn a_quarter_turn_up(&self) -> Self {
        Self { pitch: self.pitch + FRAC_PI_2, ..self.clone() }
    }

    /// Flap's root in place of lag's, and lag's in place of flap's.
    #[must_use]
    pub fn with_bending_roots_exchanged(&self) -> Self {
        let [flap, lag, torsion] = self.roots;
        Self { roots: [lag, flap, torsion], ..self.clone() }
    }

    /// What a section has about its chord in place of what it has about the normal of it, and the other way round.
    #[must_use]
    pub fn with_axes_exchanged(&self) -> Self {
        let exchange = |[first, second]: &[Table; 2]| [second.clone(), first.clone()];
        let turned = |mass: &PointMass| PointMass { inertia: [mass.inertia[1], mass.inertia[0]], ..*mass };
        Self {
            bending: exchange(&self.bending),
            inertia: exchange(&self.inertia),
            point_masses: self.point_masses.iter().map(turned).collect(),
            ..self.clone()
        }
    }

    /// All masses times `mass` and all stiffnesses times `stiffness`.
    #[must_use]
    pub fn scaled(&self, mass: f64, stiffness: f64) -> Self {
        self.in_units(1.0, mass, stiffness)
    }

    /// Every length times `factor`, each mass per length as it was, and stiffnesses so that frequencies stay.
    #[must_use]
    pub fn enlarged(&self, factor: f64) -> Self {
        self.in_units(factor, factor, factor.powi(2))
    }

    /// Lengths times `length`, masses times `mass`, forces times `force`, in all that is made of them.
    #[must_use]
    pub fn in_units(&self, length: f64, mass: f64, force: f64) -> Self {
        let table = |table: &Table, unit: f64| Table {
            r: table.r.iter().map(|r| length * r).collect(),
            y: table.y.iter().map(|y| unit * y).collect(),
        };
        let (inertia, stiffness) = (mass * length, force * length * length);
        let point = |own: &PointMass| PointMass {
            r: length * own.r,
            mass: mass * own.mass,
            offset: length * own.offset,
            inertia: own.inertia.map(|j| mass * length * length * j),
        };
        let root = |mut root: crate::blades::End| {
            root.offset *= length;
            if let Hold::Spring(spring) = &mut root.hold {
                *spring *= force * length;
            }
            root
        };
        Self {
            radius: length * self.radius,
            mass: table(&self.mass, mass / length),
            bending: self.bending.each_ref().map(|own| table(own, stiffness)),
            torsion: table(&self.torsion, stiffness),
            inertia: self.inertia.each_ref().map(|own| table(own, inertia)),
            mass_offset: table(&self.mass_offset, length),
            tension_offset: table(&self.tension_offset, length),
            trapeze: match &self.trapeze {
                Trapeze::Off => Trapeze::Off,
                Trapeze::Square(square) => Trapeze::Square(table(square, length * length)),
                Trapeze::AxialStiffness(stiffness) => Trapeze::AxialStiffness(table(stiffness, force)),
            },
            twist: table(&self.twist, 1.0),
            torque_offset: length * self.torque_offset,
            roots: self.roots.map(root),
            point_masses: self.point_masses.iter().map(point).collect(),
            ..self.clone()
        }
    }
}
