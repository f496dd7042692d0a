//! A blade cut into panels, each proven to be short enough to count with.

use super::PointMass;
use super::blade::{CoupledBlade, Trapeze, ends};
use super::crossing::{Crossing, Parts};
use super::loads::{Inertia, Motion};
use super::series::Series;
use core::f64::consts::PI;

/// Halvings of a stretch after which something must be wrong.
const DEPTH: usize = 40;
/// First root of cos x cosh x = 1, squared: the lowest clamped beam has ω L² √(m/EI) of this.
const CLAMPED: f64 = 22.373_285_448_061_15;

/// A stretch without steps and kinks, with properties at its inboard and outboard ends.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    r: [f64; 2],
    mass: [f64; 2],
    bending: [[f64; 2]; 2],
    torsion: [f64; 2],
    inertia: [[f64; 2]; 2],
    offset: [f64; 2],
    tension_offset: [f64; 2],
    angle: [f64; 2],
    gyration: Gyration,
    /// T at its outboard end.
    tension: f64,
    active: [bool; 3],
}

#[derive(Clone, Copy, Debug)]
enum Gyration {
    Off,
    Square([f64; 2]),
    AxialStiffness([f64; 2]),
}

/// What stands along the blade, from the tip inward.
#[derive(Clone, Debug)]
pub(super) enum Piece {
    Panel(Box<Crossing>),
    /// A point mass: its coefficients of Ω² C and M.
    Mass(Vec<(usize, usize, f64, f64)>),
    /// The roots at one radius.
    Roots([bool; 3]),
}

/// How a blade moves.
pub(super) fn motion(blade: &CoupledBlade, speed: f64) -> Motion {
    Motion {
        pull: speed * speed,
        precone: blade.precone.sin_cos(),
        torque_offset: blade.torque_offset,
        rotary: blade.rotary,
    }
}

/// The pieces with which eigenvalues up to `highest` in size can be counted; panels are at most
/// `share` of what could be proven.
pub(super) fn of(blade: &CoupledBlade, speed: f64, highest: f64, share: f64) -> Vec<Piece> {
    let motion = motion(blade, speed);
    let cuts = blade.cuts();
    let (mut pieces, mut tension) = (Vec::new(), 0.0);
    for (i, &outer) in cuts.iter().enumerate() {
        #[allow(clippy::float_cmp, reason = "the cuts hold these very numbers")]
        let here = |r: f64| r == outer;
        for point in blade.point_masses.iter().filter(|point| here(point.r)) {
            pieces.push(mass_at(blade, &motion, point));
            tension += point.mass * point.r;
        }
        let rooted = blade.roots.map(|root| here(root.offset));
        if rooted.contains(&true) {
            pieces.push(Piece::Roots(rooted));
        }
        if let Some(&inner) = cuts.get(i + 1) {
            let stretch = stretch(blade, [inner, outer], tension);
            stretch.panels(&motion, highest, share, DEPTH, &mut pieces);
            tension = stretch.part(0.0, 0.0).tension;
        }
    }
    pieces
}

fn mass_at(blade: &CoupledBlade, motion: &Motion, point: &PointMass) -> Piece {
    // Where the twist has a step, the angle just outboard of it.
    let angle = ends(&blade.twist, point.r, point.r)[0] + blade.pitch;
    let constant = Series::constant;
    let inertia = Inertia {
        r: constant(point.r),
        mass: constant(point.mass),
        offset: constant(point.offset),
        moments: point.inertia.map(constant),
        angle: constant(angle),
    };
    let loads = inertia.loads(motion);
    Piece::Mass(loads.into_iter().map(|(i, j, base, mass)| (i, j, base.0[0], mass.0[0])).collect())
}

fn stretch(blade: &CoupledBlade, r: [f64; 2], tension: f64) -> Stretch {
    let at = |table| ends(table, r[0], r[1]);
    Stretch {
        r,
        mass: at(&blade.mass),
        bending: blade.bending.each_ref().map(at),
        torsion: at(&blade.torsion),
        inertia: blade.inertia.each_ref().map(at),
        offset: at(&blade.mass_offset),
        tension_offset: at(&blade.tension_offset),
        angle: at(&blade.twist).map(|angle| angle + blade.pitch),
        gyration: match &blade.trapeze {
            Trapeze::Off => Gyration::Off,
            Trapeze::Square(table) => Gyration::Square(at(table)),
            Trapeze::AxialStiffness(table) => Gyration::AxialStiffness(at(table)),
        },
        tension,
        active: blade.roots.map(|root| root.offset <= r[0]),
    }
}

impl Stretch {
    /// The part between two fractions of the stretch, from its inboard end.
    fn part(&self, from: f64, to: f64) -> Self {
        let at = |[a, b]: [f64; 2], x: f64| if x < 1.0 { a + x * (b - a) } else { b };
        let cut = |ends: [f64; 2]| [at(ends, from), at(ends, to)];
        // Simpson's rule is exact for m(r) r. Lengths are those of the stretch, so that no digits go.
        let outer = [to, 0.5 * (to + 1.0), 1.0].map(|x| at(self.mass, x) * at(self.r, x));
        let weight = (1.0 - to) * (self.r[1] - self.r[0]) / 6.0;
        Self {
            r: cut(self.r),
            mass: cut(self.mass),
            bending: self.bending.map(cut),
            torsion: cut(self.torsion),
            inertia: self.inertia.map(cut),
            offset: cut(self.offset),
            tension_offset: cut(self.tension_offset),
            angle: cut(self.angle),
            gyration: match self.gyration {
                Gyration::Off => Gyration::Off,
                Gyration::Square(square) => Gyration::Square(cut(square)),
                Gyration::AxialStiffness(stiffness) => Gyration::AxialStiffness(cut(stiffness)),
            },
            tension: self.tension + weight * (outer[0] + 4.0 * outer[1] + outer[2]),
            active: self.active,
        }
    }

    fn length(&self) -> f64 {
        self.r[1] - self.r[0]
    }

    /// Cuts the stretch into panels that are short enough, from its outboard end.
    fn panels(&self, motion: &Motion, highest: f64, share: f64, depth: usize, pieces: &mut Vec<Piece>) {
        if !self.active.contains(&true) {
            return;
        }
        assert!(depth > 0, "no panel is short enough at {:?}", self.r);
        let steady = self.steady(motion, highest, self.length() / share);
        let crossing = if steady { self.crossing(motion) } else { None };
        if let Some(crossing) = crossing.filter(|crossing| crossing.converges(highest, share)) {
            pieces.push(Piece::Panel(Box::new(crossing)));
            return;
        }
        self.part(0.5, 1.0).panels(motion, highest, share, depth - 1, pieces);
        self.part(0.0, 0.5).panels(motion, highest, share, depth - 1, pieces);
    }

    /// Whether the panel, held at both ends, has no eigenvalue up to `highest`: proven with the
    /// largest of each property on it and the inequalities of a clamped beam,
    /// ‖w‖ ≤ h²/22.37 ‖w″‖ and ‖w′‖ ≤ h/2π ‖w″‖, and of a fixed rod, ‖φ‖ ≤ h/π ‖φ′‖.
    /// Tension and trapeze only help. With M ≥ 0 it holds for every lower λ, too.
    fn steady(&self, motion: &Motion, highest: f64, length: f64) -> bool {
        let most = |ends: [f64; 2]| ends.into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let least = |ends: [f64; 2]| ends[0].min(ends[1]);
        let [w, slope, twist] = [length * length / CLAMPED, length / (2.0 * PI), length / PI];
        let ((sp, cp), pull, load) = (motion.precone, motion.pull, highest.max(0.0));
        let skew = pull * (sp * cp).abs();
        let (m, r, e) = (most(self.mass), self.r[1], most(self.offset));
        let me = m * e;
        let difference = most([self.inertia[1][0] - self.inertia[0][0], self.inertia[1][1] - self.inertia[0][1]]);
        let section = most(self.inertia[0]).max(most(self.inertia[1]));
        let polar = most([self.inertia[0][0] + self.inertia[1][0], self.inertia[0][1] + self.inertia[1][1]]);
        let tension = self.part(0.0, 0.0).tension;
        let mut bending = w * w * m * (load + pull) + 2.0 * skew * me * w * slope;
        if motion.rotary {
            bending += (load + pull) * section * slope * slope;
        }
        let both = me * w * twist * (load + pull)
            + (pull * me * r + skew * difference) * slope * twist
            + pull * tension * most(self.tension_offset) * twist;
        let turning = polar * load + pull * (difference + me * motion.torque_offset.abs()) + skew * me * r;
        let stiff = least(self.bending[0]).min(least(self.bending[1])) - bending;
        let stiff_in_torsion = least(self.torsion) - twist * twist * turning;
        // 0.98: a hundred roundings would not need so much.
        stiff > 0.0 && stiff_in_torsion > 0.0 && both * both < 0.98 * stiff * stiff_in_torsion
    }

    /// The differential equations on this panel, unless a property varies too much along it.
    fn crossing(&self, motion: &Motion) -> Option<Crossing> {
        let line = Series::linear;
        let length = self.length();
        let ((_, cp), pull) = (motion.precone, motion.pull);
        let tension_pull = pull * cp * cp;
        let r = line(self.r);
        let mass = line(self.mass);
        let tension = Series::constant(self.tension) + (mass * r).integral().times(length);
        let angle = line(self.angle);
        let [s, c] = Series::sin_cos(&angle);
        let [first, second] = self.bending.map(line);
        let offset = line(self.tension_offset);
        let gyration = match self.gyration {
            Gyration::Off => Series::constant(0.0),
            Gyration::Square(square) => line(square),
            Gyration::AxialStiffness(stiffness) => (first + second) * line(stiffness).reciprocal() + offset * offset,
        };
        let torsion = line(self.torsion) + (tension * gyration).times(tension_pull);
        let inertia = Inertia { r, mass, offset: line(self.offset), moments: self.inertia.map(line), angle };
        let mut loads = inertia.loads(motion);
        let pulled = tension.times(tension_pull);
        loads.extend([1, 3].map(|i| (i, i, pulled, Series::constant(0.0))));

        // Flexibility of what bends, and the moments that a twist brings at the tension axis.
        let (easy, stiff) = (first.reciprocal(), second.reciprocal());
        let [a, b] = [pulled * offset * c, (pulled * offset * s).times(-1.0)];
        let none = Series::constant(0.0);
        let flexibility = match (self.active[0], self.active[1]) {
            (true, true) => [c * c * easy + s * s * stiff, s * c * (stiff - easy), s * s * easy + c * c * stiff],
            (true, false) => [(c * c * first + s * s * second).reciprocal(), none, none],
            (false, true) => [none, none, (s * s * first + c * c * second).reciprocal()],
            (false, false) => [none; 3],
        };
        let middle = |s: &Series| s.0[0];
        let bending = (middle(&first) * middle(&second)).sqrt();
        let parts = Parts { loads, flexibility, twist: torsion.reciprocal(), moments: [a, b] };
        Crossing::new(length, self.active, [bending, middle(&torsion)], &parts)
    }
}
