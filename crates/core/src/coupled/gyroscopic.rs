//! Coriolis terms: the lowest modes of (A + iωΩG − ω²M) x = 0, A = K + F + Ω²C, with bounds (docs/THEORY.md).
//!
//! Where A is positive definite every frequency is real, sums of functions bound it from above as without these
//! terms, and the number of frequencies below ρ is that of the negative directions of A + iρΩG − ρ²M.

use super::assembly::{Assembly, Vector, sum};
use super::blade::{CoupledBlade, CoupledSection};
use super::bounds::{Missing, ROUNDING, SHIFTS, SLACK, separations};
use super::certificate::{Form, index};
use super::element::{Couplings, Element, STATE_FIELDS, SkewTerm, Square};
use super::equilibrium::{Factors, ModeFields, OwnEnergies, Turned, energies, own_energies, residual_turned};
use super::range::orthonormal;
use super::terms::{FIELDS, Weights};
use super::{BEYOND, CoupledMode, CoupledModes, MOST_ROUNDS, ORDER_OF_PROOFS, TOLERANCE, converged, shares};
use crate::numerics::eigen::{EigenError, Turning, turning};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{maximum, sqrt};
use crate::numerics::vector::dot;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, SymmetricEigen};

/// The couplings of G between w, w′, v, v′ and φ, places among the fields.
const TERMS: &[SkewTerm] = &[
    (0, 3, |p| 2.0 * p.precone.0 * p.mass),
    (0, 6, |p| -2.0 * p.precone.0 * p.moment() * p.angle.0),
    (1, 3, |p| 2.0 * p.precone.1 * p.moment() * p.angle.0),
    (1, 6, |p| -2.0 * p.precone.1 * flap_inertia(p)),
    (3, 4, |p| -2.0 * p.precone.1 * p.moment() * p.angle.1),
    (3, 6, |p| -2.0 * p.precone.0 * p.moment() * p.angle.1),
    (4, 6, |p| -2.0 * p.precone.1 * p.racket() * p.angle.0 * p.angle.1),
];

/// I₂ sin²β + I₁ cos²β.
fn flap_inertia(p: &CoupledSection) -> f64 {
    let ((s, c), [first, second]) = (p.angle, p.inertia);
    second * s * s + first * c * c
}

fn weights(section: &CoupledSection) -> Weights {
    let mut weights = [[0.0; FIELDS]; FIELDS];
    for (row, column, weight) in TERMS {
        let weight = weight(section);
        weights[*row][*column] += weight;
        weights[*column][*row] -= weight;
    }
    weights
}

/// G along a blade.
#[derive(Clone, Debug)]
pub struct Gyroscopic {
    /// At the points of every element.
    pub couplings: Vec<Couplings>,
    /// At all points.
    pub along: Couplings,
    /// Of what hangs at the outer end of every element.
    pub hung: Vec<Option<Weights>>,
}

impl Gyroscopic {
    /// On an assembly.
    pub fn new(assembly: &Assembly) -> Self {
        let of = |sections: &[CoupledSection]| -> Vec<Weights> { sections.iter().map(weights).collect() };
        let plus = |a: Weights, b: Weights| core::array::from_fn(|i| core::array::from_fn(|j| a[i][j] + b[i][j]));
        let couplings: Vec<Couplings> =
            assembly.elements.iter().map(|element| Couplings::skew(&element.sections, TERMS)).collect();
        let mut along = Couplings::default();
        for (index, own) in couplings.iter().enumerate() {
            own.scatter(assembly.along.part(index).start, assembly.along.points(), &mut along);
        }
        Self {
            couplings,
            along,
            hung: assembly.elements.iter().map(|element| of(&element.lumps).into_iter().reduce(plus)).collect(),
        }
    }

    /// G of the functions of every element.
    pub fn matrices(&self, assembly: &Assembly) -> Vec<Square> {
        let matrix = |(index, element): (usize, &Rc<Element>)| {
            let mut matrix = element.lower(&assembly.functions[index], &self.couplings[index]);
            for j in 0..matrix.order() {
                for i in j..matrix.order() {
                    *matrix.at_mut(j, i) = -matrix.at(i, j);
                }
            }
            if let Some(hung) = &self.hung[index] {
                matrix.add_outer(&element.transfer, |p, q| hung[STATE_FIELDS[p]][STATE_FIELDS[q]]);
            }
            matrix
        };
        assembly.elements.iter().enumerate().map(matrix).collect()
    }

    /// G of modes with one another.
    fn between(&self, assembly: &Assembly, fields: &ModeFields) -> DMatrix<f64> {
        let n = fields.count();
        let mut matrix = DMatrix::zeros(n, n);
        for j in 0..n {
            for i in j + 1..n {
                let own = fields.turned(assembly, self, i, j);
                matrix[(i, j)] = own;
                matrix[(j, i)] = -own;
            }
        }
        matrix
    }
}

/// Modes on functions of the whole blade.
pub(super) struct Solved {
    pub(super) values: Vec<f64>,
    /// Two by two, real and imaginary part.
    fields: ModeFields,
    energies: Vec<OwnEnergies>,
    vectors: Vec<Vector>,
    /// Energies of the residual moments, real and imaginary part, and the largest among the modes asked for.
    pub(super) gaps: [DMatrix<f64>; 2],
    worst: f64,
}

/// The `count` lowest modes at rotor speed Ω > 0 with Coriolis terms.
///
/// # Errors
/// [`EigenError::NotPositiveDefinite`] where the blade is not statically stable, and others.
pub fn modes(blade: &CoupledBlade, speed: f64, count: usize, rules: &GaussRules) -> Result<CoupledModes, EigenError> {
    let s = speed * speed;
    let (layout, assembly, plain) = converged(blade, s, count, rules)?;
    let g = Gyroscopic::new(&assembly);
    let factor = assembly.factor(s, 0.0).ok_or(EigenError::NotPositiveDefinite)?;
    let squares = g.matrices(&assembly);
    let mut functions = orthonormal(&assembly, s, 0.0, &plain.modes);
    let mut best = solve(blade, &assembly, &g, &functions, speed, count)?;
    for _ in 0..MOST_ROUNDS {
        if best.worst <= TOLERANCE {
            break;
        }
        // What the inverse of A makes of the other loads of a mode is nearer to it.
        let mut more = best.vectors.clone();
        for (pair, value) in best.vectors.chunks(2).zip(&best.values) {
            for (own, other, sign) in [(&pair[0], &pair[1], 1.0), (&pair[1], &pair[0], -1.0)] {
                let mut loads = assembly.inertia_times(own);
                let mut turned = vec![0.0; loads.len()];
                for (index, square) in squares.iter().enumerate() {
                    let part = assembly.part(index);
                    square.add_times(&other[part.clone()], &mut turned[part]);
                }
                loads.iter_mut().zip(turned).for_each(|(load, t)| *load = value * *load + sign * speed * t);
                factor.solve(&assembly.elements, &mut loads);
                more.push(loads);
            }
        }
        functions = orthonormal(&assembly, s, 0.0, &more);
        let found = solve(blade, &assembly, &g, &functions, speed, count)?;
        if found.worst >= best.worst {
            break;
        }
        best = found;
    }
    let coarse = Assembly::new(blade, &layout.with_orders_up_to(ORDER_OF_PROOFS), rules, Some(&assembly));
    let proof = [&coarse, &assembly].into_iter().map(|on| prove(on, &best.values, count, speed)).reduce(Result::or);
    Ok(best.bounded(&assembly, speed, count, proof.unwrap_or(Err(Missing::Separation))))
}

/// Modes with Coriolis terms among sums of functions.
pub(super) fn solve(
    blade: &CoupledBlade,
    assembly: &Assembly,
    g: &Gyroscopic,
    functions: &[Vector],
    speed: f64,
    count: usize,
) -> Result<Solved, EigenError> {
    let (s, all) = (speed * speed, ModeFields::new(assembly, functions));
    let raw = energies(assembly, &all);
    let coupling = g.between(assembly, &all) * speed;
    let Turning { values, vectors } =
        turning(&(&raw.elastic + &raw.centrifugal * s), &coupling, &raw.inertia, count + BEYOND)?;
    let fields = all.combined(&vectors);
    let energies = own_energies(assembly, &fields);
    // The quotient of the modes' own fields: a + γω − mω² = 0.
    let quotient = |k: usize| {
        let energy = |kind: usize| energies[2 * k].sums[kind] + energies[2 * k + 1].sums[kind];
        let (a, m) = (energy(0) + s * energy(1), energy(2));
        let turned = -2.0 * speed * fields.turned(assembly, g, 2 * k, 2 * k + 1);
        (turned + sqrt(turned * turned + 4.0 * a * m)) / (2.0 * m)
    };
    let values: Vec<f64> = (0..values.len()).map(quotient).collect();
    let rows: Vec<[Vec<f64>; 2]> = values
        .iter()
        .enumerate()
        .map(|(k, value)| {
            let row = |own: usize, other: usize, sign: f64| {
                let turned = Turned { g, other, factor: sign * value * speed };
                let factors = Factors { elastic: 1.0, centrifugal: s, inertia: value * value };
                residual_turned(blade, assembly, &fields, own, factors, Some(&turned))
            };
            [row(2 * k, 2 * k + 1, 1.0), row(2 * k + 1, 2 * k, -1.0)]
        })
        .collect();
    let n = rows.len();
    let product = |(i, a): (usize, usize), (j, b): (usize, usize)| dot(&rows[i][a], &rows[j][b]);
    let gaps = [
        DMatrix::from_fn(n, n, |i, j| product((i, 0), (j, 0)) + product((i, 1), (j, 1))),
        DMatrix::from_fn(n, n, |i, j| product((i, 0), (j, 1)) - product((i, 1), (j, 0))),
    ];
    // With x*Ax + ω²x*Mx = 1 the energy of the gap is about the relative error of ω.
    let worst = (0..count.min(values.len())).map(|k| gaps[0][(k, k)]).fold(0.0, maximum);
    let vectors = vectors.column_iter().map(|parts| sum(functions, parts.as_slice())).collect();
    Ok(Solved { values, fields, energies, vectors, gaps, worst })
}

/// What is proven with Coriolis terms: at most so many frequencies below ρ, and θ(K + F) + sC is not negative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Proof {
    pub(super) below: usize,
    pub(super) rho: f64,
    pub(super) theta: f64,
}

fn prove(assembly: &Assembly, values: &[f64], wanted: usize, speed: f64) -> Result<Proof, Missing> {
    let s = speed * speed;
    let separation = separations(values, wanted).find(|&(n, rho)| {
        let form = Form { alpha: 1.0, s, kappa: -rho * rho, turning: rho * speed };
        rho > 0.0 && index(assembly, form).is_some_and(|below| below <= n)
    });
    let (below, rho) = separation.ok_or(Missing::Separation)?;
    let shift = |theta: f64| index(assembly, Form { alpha: theta, s, kappa: 0.0, turning: 0.0 }) == Some(0);
    let theta = SHIFTS.into_iter().map(|(theta, _)| theta).find(|theta| shift(*theta)).ok_or(Missing::Unstable)?;
    Ok(Proof { below, rho, theta })
}

/// Lower bounds of the frequencies below ρ, from as many modes and the energies of their residual moments.
pub(super) fn lower_bounds(values: &[f64], gaps: &[DMatrix<f64>; 2], proof: &Proof) -> Option<Vec<f64>> {
    let n = proof.below;
    let share = |i: usize| 1.0 - values[i] / proof.rho;
    if n > values.len() || (0..n).any(|i| share(i) <= 0.0) {
        return None;
    }
    let entry = |part: &DMatrix<f64>, i: usize, j: usize| {
        SLACK * part[(i, j)] / ((1.0 - proof.theta) * sqrt(values[i] * values[j] * share(i) * share(j)))
    };
    // A Hermitian matrix as a symmetric one of twice the order: every eigenvalue is there twice.
    let h = DMatrix::from_fn(2 * n, 2 * n, |i, j| {
        let own = if i == j { 1.0 / values[i % n] } else { 0.0 };
        own + match (i < n, j < n) {
            (true, true) | (false, false) => entry(&gaps[0], i % n, j % n),
            (true, false) => -entry(&gaps[1], i, j - n),
            (false, true) => entry(&gaps[1], i - n, j),
        }
    });
    let eigen = SymmetricEigen::try_new(h, f64::EPSILON, 120 * n)?;
    let mut inverse: Vec<f64> = eigen.eigenvalues.iter().copied().collect();
    inverse.sort_by(|a, b| b.total_cmp(a));
    Some(inverse.chunks(2).map(|pair| 1.0 / pair[0]).collect())
}

impl Solved {
    fn bounded(&self, assembly: &Assembly, speed: f64, count: usize, proof: Result<Proof, Missing>) -> CoupledModes {
        let (s, count) = (speed * speed, count.min(self.values.len()));
        let lower = proof.ok().and_then(|proof| lower_bounds(&self.values, &self.gaps, &proof));
        let separation = match (proof, &lower) {
            (Err(missing), _) => Err(missing),
            (Ok(_), None) => Err(Missing::Shift),
            (Ok(proof), Some(_)) => Ok(proof.rho * proof.rho),
        };
        let mode = |k: usize| {
            let value = self.values[k];
            let [re, im] = [2 * k, 2 * k + 1];
            let weigh = |[e, c, m]: [f64; 3]| e + s * c + value * value * m;
            let size = weigh(self.energies[re].sizes) + weigh(self.energies[im].sizes);
            // x*Ax + ω²x*Mx, the most that the quotient is divided by, over ω.
            let total = weigh(self.energies[re].sums) + weigh(self.energies[im].sums);
            let rounding = 2.0 * ROUNDING * value * (1.0 + size / total);
            let [first, second] = [re, im].map(|part| shares::own(assembly, &self.fields, part));
            let square = |bound: f64| bound.max(0.0) * bound.max(0.0);
            CoupledMode {
                eigenvalue: value * value,
                error: 2.0 * value * value * self.gaps[0][(k, k)],
                bounds: lower.as_ref().and_then(|lower| {
                    let lower = lower.get(k)?.min(value) - rounding;
                    Some((square(lower), square(value + rounding)))
                }),
                shares: shares::in_sum_one(core::array::from_fn(|i| first[i] + second[i])),
            }
        };
        CoupledModes {
            modes: (0..count).map(mode).collect(),
            separation,
            proven: None,
            functions: assembly.unknowns_by_motion(),
        }
    }
}
