//! The blade as the coupled equations see it: what acts of it, with the options of the model.

use crate::blade::{Root, RootCondition};
use crate::dof::Dof;
use crate::numerics::scalar::sin_cos;
use crate::numerics::{Linear, PiecewiseLinear};
use alloc::vec::Vec;

/// A concentrated mass on the blade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lump {
    /// Radius [m].
    pub r: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Its centre ahead of the elastic axis [m].
    pub offset: f64,
    /// Moments of inertia about the elastic axis, out of and in the chord plane [kg·m²].
    pub inertia: [f64; 2],
}

/// What the trapeze radius kA is made of.
#[derive(Clone, Debug)]
pub enum Trapeze {
    /// No trapeze stiffness.
    Off,
    /// kA² along the span [m²].
    Squared(PiecewiseLinear),
    /// kA² = (EI₁ + EI₂)/EA + e_A² from the axial stiffness EA [N].
    Axial(PiecewiseLinear),
}

/// A blade whose flap, lag and torsion are coupled, in SI units.
///
/// Axes: x outboard, y towards the leading edge, z up, Ω about +z; the local angle β is positive nose
/// up. Section axes: η along the chord towards the leading edge, ζ normal to it.
#[derive(Clone, Debug)]
pub struct CoupledBlade {
    /// Tip radius R [m].
    pub radius: f64,
    /// Roots by degree of freedom.
    pub roots: [Root; 3],
    /// Mass per length m [kg/m].
    pub mass: PiecewiseLinear,
    /// EI₁ about the chord axis, EI₂ about the normal, GJ [N·m²].
    pub stiffness: [PiecewiseLinear; 3],
    /// I₁ = ∫ρζ² dA and I₂ = ∫ρη² dA about the elastic axis [kg·m].
    pub inertia: [PiecewiseLinear; 2],
    /// Mass centre e ahead of the elastic axis [m].
    pub mass_offset: PiecewiseLinear,
    /// Tension centre e_A ahead of the elastic axis [m].
    pub tension_offset: PiecewiseLinear,
    /// Trapeze stiffness.
    pub trapeze: Trapeze,
    /// Built-in twist [rad].
    pub twist: PiecewiseLinear,
    /// Collective pitch [rad], added to the twist everywhere.
    pub pitch: f64,
    /// Precone β_p [rad], tip up.
    pub precone: f64,
    /// Elastic axis ahead of the radial line e₀ [m].
    pub torque_offset: f64,
    /// By how much the flap and lag springs are turned [rad]; they then stand at one radius.
    pub spring_angle: f64,
    /// Whether sections have rotary inertia in bending.
    pub rotary: bool,
    /// Whether the propeller moment is the paper's, m e², instead of I₂ − I₁.
    pub paper_moment: bool,
    /// Concentrated masses, by ascending radius.
    pub lumps: Vec<Lump>,
}

/// All that the weight of a coupled term sees at one radius.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CoupledSection {
    /// Radius [m].
    pub r: f64,
    /// Mass per length m [kg/m].
    pub mass: f64,
    /// EI₁, EI₂, GJ [N·m²].
    pub stiffness: [f64; 3],
    /// I₁, I₂ about the elastic axis [kg·m].
    pub inertia: [f64; 2],
    /// e [m].
    pub mass_offset: f64,
    /// e_A [m].
    pub tension_offset: f64,
    /// kA² [m²].
    pub trapeze: f64,
    /// Tension per Ω², T [kg·m].
    pub tension: f64,
    /// sin β and cos β of the local angle.
    pub angle: (f64, f64),
    /// sin β_p and cos β_p of the precone.
    pub precone: (f64, f64),
    /// e₀ [m].
    pub torque_offset: f64,
    /// 1 with rotary inertia in bending, else 0.
    pub rotary: f64,
    /// Whether the propeller moment is the paper's.
    pub paper_moment: bool,
}

impl CoupledSection {
    /// m e [kg].
    pub fn moment(&self) -> f64 {
        self.mass * self.mass_offset
    }

    /// I₂ − I₁ [kg·m].
    pub fn racket(&self) -> f64 {
        self.inertia[1] - self.inertia[0]
    }

    /// Flap, lag and torsion about the mass centre of w, w′, v, v′, φ.
    pub fn motions(&self, [w, w1, v, v1, phi]: [f64; 5]) -> Motions {
        let ((s, c), e) = (self.angle, self.mass_offset);
        let [flap, lag, both] = self.rotary_inertia();
        let (up, ahead) = (w + e * c * phi, v - e * s * phi);
        let own = self.inertia[0] + self.inertia[1] - self.mass * e * e;
        [
            [(self.mass * up, up), (flap * w1 + both * v1, w1)],
            [(self.mass * ahead, ahead), (lag * v1 + both * w1, v1)],
            [(own * phi, phi), (0.0, 0.0)],
        ]
    }

    /// What of the propeller moment acts, I₂ − I₁, or m e² as in the paper's (77) [kg·m].
    pub fn propeller(&self) -> f64 {
        if self.paper_moment { self.mass * self.mass_offset * self.mass_offset } else { self.racket() }
    }

    /// sin 2β and cos 2β.
    pub fn double_angle(&self) -> (f64, f64) {
        let (s, c) = self.angle;
        (2.0 * s * c, c * c - s * s)
    }

    /// Torsional stiffness by the tension of the fibres per Ω² [kg·m³]: trapeze.
    pub fn trapeze_stiffness(&self) -> f64 {
        self.precone.1 * self.precone.1 * self.tension * self.trapeze
    }

    /// Rotary inertia of w′, of v′ and between them; 0 where it is off [kg·m].
    pub fn rotary_inertia(&self) -> [f64; 3] {
        let ((s, c), [i1, i2]) = (self.angle, self.inertia);
        [i2 * s * s + i1 * c * c, i2 * c * c + i1 * s * s, (i2 - i1) * s * c].map(|inertia| self.rotary * inertia)
    }
}

/// Of flap, lag and torsion: what their inertia makes of a motion, and the motion; the kinetic energy of two modes
/// is the sum of the first of one times the second of the other.
pub type Motions = [[(f64, f64); 2]; 3];

/// A part of the span within which every property is linear.
#[derive(Clone, Debug)]
pub struct CoupledStretch {
    /// Inner end [m].
    pub from: f64,
    /// Outer end [m].
    pub to: f64,
    mass: Linear,
    stiffness: [Linear; 3],
    inertia: [Linear; 2],
    mass_offset: Linear,
    tension_offset: Linear,
    trapeze: Linear,
    is_axial: bool,
    angle: Linear,
    pitch: f64,
    common: CoupledSection,
    /// Tension per Ω² at the outer end [kg·m].
    outboard: f64,
}

impl CoupledBlade {
    /// How many motions cost nothing at Ω² = s: at rest the turns about free roots, at speed the one in the disc
    /// plane about a free lag hinge on the rotor's axis.
    pub fn free_motions(&self, s: f64) -> usize {
        let [flap, lag, _] = &self.roots;
        let is_free = |root: &Root| root.condition == RootCondition::Free;
        if s == 0.0 {
            return self.roots.iter().filter(|root| is_free(root)).count();
        }
        let held = self.spring_angle != 0.0 && matches!(flap.condition, RootCondition::Spring(_));
        usize::from(is_free(lag) && lag.offset == 0.0 && self.precone == 0.0 && !held)
    }

    /// Radii at which any property has a station, a root stands or a mass hangs, from the innermost root to the
    /// tip.
    pub fn stations(&self) -> Vec<f64> {
        let first = self.innermost();
        let trapeze = match &self.trapeze {
            Trapeze::Off => None,
            Trapeze::Squared(property) | Trapeze::Axial(property) => Some(property),
        };
        let properties = [&self.mass, &self.mass_offset, &self.tension_offset, &self.twist];
        let all = properties.into_iter().chain(&self.stiffness).chain(&self.inertia).chain(trapeze);
        let mut radii: Vec<f64> = all
            .flat_map(|property| property.stations().iter().copied())
            .chain(self.roots.iter().map(|root| root.offset))
            .chain(self.lumps.iter().map(|lump| lump.r))
            .filter(|r| *r > first && *r < self.radius)
            .chain([first, self.radius])
            .collect();
        radii.sort_by(f64::total_cmp);
        radii.dedup();
        radii
    }

    /// Radius of the innermost root [m].
    pub fn innermost(&self) -> f64 {
        self.roots.iter().fold(self.radius, |least, root| least.min(root.offset))
    }

    /// How a degree of freedom is held.
    pub fn root(&self, dof: Dof) -> Root {
        self.roots[dof.index()]
    }

    /// Stiffness of the flap and lag springs in w′ and v′: ww, wv, vv [N·m/rad].
    pub fn bending_springs(&self) -> [f64; 3] {
        let spring = |dof| match self.root(dof).condition {
            RootCondition::Spring(spring) => spring,
            RootCondition::Free | RootCondition::Clamped => 0.0,
        };
        let (flap, lag) = (spring(Dof::Flap), spring(Dof::Lag));
        let (s, c) = sin_cos(self.spring_angle);
        [flap * c * c + lag * s * s, (lag - flap) * s * c, flap * s * s + lag * c * c]
    }

    /// The stretches between ascending radii; none may straddle a station.
    pub fn stretches(&self, radii: &[f64]) -> Vec<CoupledStretch> {
        let mut outboard: f64 = self.hung(self.radius, f64::INFINITY);
        let mut found: Vec<CoupledStretch> = radii
            .windows(2)
            .rev()
            .map(|ends| {
                let stretch = self.stretch(ends[0], ends[1], outboard);
                outboard = stretch.section(ends[0]).tension + self.hung(ends[0], ends[1]);
                stretch
            })
            .collect();
        found.reverse();
        found
    }

    /// What masses at `from` ≤ r < `to` add to the tension per Ω² [kg·m].
    fn hung(&self, from: f64, to: f64) -> f64 {
        self.lumps.iter().filter(|lump| lump.r >= from && lump.r < to).map(|lump| lump.mass * lump.r).sum()
    }

    fn stretch(&self, from: f64, to: f64, outboard: f64) -> CoupledStretch {
        let linear = |property: &PiecewiseLinear| property.between(from, to);
        let zero = PiecewiseLinear::uniform(0.0);
        let (trapeze, is_axial) = match &self.trapeze {
            Trapeze::Off => (&zero, false),
            Trapeze::Squared(property) => (property, false),
            Trapeze::Axial(property) => (property, true),
        };
        CoupledStretch {
            from,
            to,
            mass: linear(&self.mass),
            stiffness: [0, 1, 2].map(|i| linear(&self.stiffness[i])),
            inertia: [0, 1].map(|i| linear(&self.inertia[i])),
            mass_offset: linear(&self.mass_offset),
            tension_offset: linear(&self.tension_offset),
            trapeze: linear(trapeze),
            is_axial,
            angle: linear(&self.twist),
            pitch: self.pitch,
            common: self.common(),
            outboard,
        }
    }

    fn common(&self) -> CoupledSection {
        CoupledSection {
            precone: sin_cos(self.precone),
            torque_offset: self.torque_offset,
            rotary: if self.rotary { 1.0 } else { 0.0 },
            paper_moment: self.paper_moment,
            ..CoupledSection::default()
        }
    }

    /// A concentrated mass as a section without stiffness and tension, where the local angle is that of the
    /// blade there: its terms are those of a section.
    pub fn lump_section(&self, lump: &Lump) -> CoupledSection {
        CoupledSection {
            r: lump.r,
            mass: lump.mass,
            inertia: lump.inertia,
            mass_offset: lump.offset,
            angle: sin_cos(self.twist.at(lump.r) + self.pitch),
            ..self.common()
        }
    }
}

impl CoupledStretch {
    /// By how much the local angle changes over the stretch [rad].
    pub fn turn(&self) -> f64 {
        (self.angle.at(self.to) - self.angle.at(self.from)).abs()
    }

    /// The section at `r` inside the stretch. The tension is summed from its outer end: a difference of
    /// primitives in r would lose (r/length)² of its digits on a short stretch.
    pub fn section(&self, r: f64) -> CoupledSection {
        let (mass, stiffness) = (self.mass.at(r), self.stiffness.map(|stiffness| stiffness.at(r)));
        let (tension_offset, trapeze) = (self.tension_offset.at(r), self.trapeze.at(r));
        let trapeze = if self.is_axial {
            if trapeze > 0.0 { (stiffness[0] + stiffness[1]) / trapeze + tension_offset * tension_offset } else { 0.0 }
        } else {
            trapeze
        };
        // Simpson's rule is exact for a linear mass times r.
        let (length, middle) = (self.to - r, 0.5 * (r + self.to));
        let outer = self.mass.at(self.to);
        let own = length / 6.0 * (mass * r + 2.0 * (mass + outer) * middle + outer * self.to);
        CoupledSection {
            r,
            mass,
            stiffness,
            inertia: self.inertia.map(|inertia| inertia.at(r)),
            mass_offset: self.mass_offset.at(r),
            tension_offset,
            trapeze,
            tension: self.outboard + own,
            angle: sin_cos(self.angle.at(r) + self.pitch),
            ..self.common
        }
    }
}
