//! Functions for a whole range of rotor speeds: the span of the modes at some of them. Every matrix and every
//! residual of these functions is affine in Ω², so each speed is a small dense problem.

use super::assembly::{Assembly, Vector};
use super::blade::CoupledBlade;
use super::bounds::{Missing, Proof, ROUNDING, lower_bounds, prove_separation, prove_shift, settle_free};
use super::classical::Classical;
use super::equilibrium::{Factors, ModeEnergies, ModeFields, energies, residual};
use super::layout::{first_layout, raise};
use super::reduced::Reduced;
use super::{MOST_ROUNDS, ORDER_OF_PROOFS, SHARE, SHIFT, Solved, TOLERANCE, iterate, shares};
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{maximum, sqrt};
use crate::numerics::vector::{axpy, long_dot, scale};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Where the modes are found first, as shares of the highest Ω², and where they are added, one after the other,
/// until the check between them holds.
const ANCHORS: [f64; 3] = [0.5, 0.0, 1.0];
const MORE_ANCHORS: [f64; 4] = [0.05, 0.25, 0.75, 0.01];
/// Modes beyond those asked for, among which a separation is sought.
const BEYOND: usize = 3;
/// Where they are checked.
const CHECKS: [f64; 5] = [0.02, 0.12, 0.35, 0.65, 0.88];
/// Relative error of λ accepted at the checks.
const ACCEPTED: f64 = 1e-10;
/// A function of which so little is left beside the others, in energy, is nothing new.
const NOTHING_NEW: f64 = 1e-6;
/// A separation is proven anew where the last mode comes so near to it.
const NEAR: f64 = 0.95;

/// One mode of a coupled blade at one speed of a range.
#[derive(Clone, Debug)]
pub struct RangeMode {
    /// λ = ω² [rad²/s²].
    pub eigenvalue: f64,
    /// dλ/dΩ².
    pub slope: f64,
    /// Shares of flap, lag and torsion.
    pub shares: [f64; 3],
}

/// The modes at one speed of a range.
#[derive(Clone, Debug)]
pub struct Bounded {
    /// λ of the modes asked for and some more [rad²/s²], ascending.
    pub eigenvalues: Vec<f64>,
    /// Bounds of those asked for, or why there are none.
    pub bounds: Result<Vec<(f64, f64)>, Missing>,
}

/// A separation that was proven at one Ω² and holds from there on, if lower.
#[derive(Clone, Copy, Debug)]
struct Separation {
    below: usize,
    rho: f64,
    from: f64,
}

/// The modes at the first speeds, and how good the elements are for them.
struct Anchors {
    modes: Vec<Vector>,
    sigma: f64,
    worst: f64,
    shares: Vec<f64>,
}

impl Anchors {
    fn new(
        blade: &CoupledBlade,
        assembly: &Assembly,
        eigenvalue: f64,
        highest: f64,
        count: usize,
    ) -> Result<Self, EigenError> {
        let sigma = SHIFT.0 * eigenvalue;
        let mut all = Self { modes: Vec::new(), sigma, worst: 0.0, shares: vec![0.0; assembly.elements.len()] };
        for share in ANCHORS {
            // C enters in proportion: what is definite at both ends is definite between them.
            let (found, sigma) = iterate(assembly, share * highest, (count, BEYOND), all.sigma)?;
            let solved = Solved::new(blade, assembly, &found, (share * highest, sigma), BEYOND)?;
            all.sigma = sigma;
            all.worst = maximum(all.worst, solved.worst);
            all.shares.iter_mut().zip(&solved.shares).for_each(|(most, own)| *most = maximum(*most, *own));
            all.modes.extend(found);
        }
        Ok(all)
    }
}

/// A coupled blade over a range of rotor speeds.
#[derive(Clone, Debug)]
pub struct Range {
    count: usize,
    reduced: Reduced,
    /// For proofs, coarse and fine; none of functions of which nothing is proven.
    on: Vec<Assembly>,
    /// Number of functions of flap, lag and torsion behind the modes.
    functions: [usize; 3],
    highest: f64,
    shift: Option<(f64, f64)>,
    error: f64,
    /// Motions that cost nothing, at rest and at speed.
    free: [usize; 2],
}

impl Range {
    /// The `count` lowest modes, for 0 ≤ Ω² ≤ `highest`.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn new(blade: &CoupledBlade, highest: f64, count: usize, rules: &GaussRules) -> Result<Self, EigenError> {
        let sought = count + BEYOND;
        let mut layout = first_layout(blade, highest, sought);
        let mut rounds = 1;
        let mut known: Option<Assembly> = None;
        let (fine, mut modes, sigma) = loop {
            let fine = Assembly::new(blade, &layout, rules, known.as_ref());
            let found = Anchors::new(blade, &fine, layout.highest, highest, count)?;
            let good = found.worst <= TOLERANCE || rounds == MOST_ROUNDS;
            if good || !raise(&mut layout, &found.shares, TOLERANCE * SHARE) {
                break (fine, found.modes, found.sigma);
            }
            rounds += 1;
            known = Some(fine);
        };
        let mut more = MORE_ANCHORS.iter();
        let (reduced, error) = loop {
            let reduced = reduced(blade, &fine, highest, sigma, &modes);
            let error =
                CHECKS.iter().try_fold(0.0, |most, share| Ok(maximum(most, reduced.error(share * highest, count)?)))?;
            match more.next() {
                Some(share) if error > ACCEPTED => {
                    modes.extend(iterate(&fine, share * highest, (count, BEYOND), sigma)?.0);
                }
                _ => break (reduced, error),
            }
        };
        let coarse = layout.with_orders_up_to(ORDER_OF_PROOFS);
        let coarse = Assembly::new(blade, &coarse, rules, Some(&fine));
        let free = [0.0, highest].map(|s| blade.free_motions(s));
        let functions = fine.unknowns_by_motion();
        Self { count, reduced, on: vec![coarse, fine], functions, highest, shift: None, error, free }.with_shift()
    }

    /// The same of the paper's functions, as they are: nothing is proven of them.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn classical(paper: &Classical<'_>, highest: f64, count: usize) -> Result<Self, EigenError> {
        let reduced = paper.reduced(highest, count + BEYOND)?;
        let (on, functions) = (Vec::new(), paper.counts());
        Ok(Self { count, reduced, on, functions, highest, shift: None, error: 0.0, free: [0; 2] })
    }

    /// With the shift of all its bounds, which is about in proportion to the highest eigenvalue.
    fn with_shift(mut self) -> Result<Self, EigenError> {
        let rho = self.eigenvalues(self.highest)?.last().copied().unwrap_or(0.0);
        self.shift = self.on.iter().find_map(|on| prove_shift(on, self.highest, rho));
        Ok(self)
    }

    /// Number of functions of flap, lag and torsion behind the modes.
    pub fn functions(&self) -> [usize; 3] {
        self.functions
    }

    /// Whether bounds are sought at all.
    pub fn is_bounded(&self) -> bool {
        !self.on.is_empty()
    }

    /// The largest relative error of an eigenvalue where they were checked.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Whether the errors are as small as they should be.
    pub fn is_converged(&self) -> bool {
        self.error <= maximum(ACCEPTED, TOLERANCE)
    }

    /// The eigenvalues at Ω² = s alone, those asked for and some more, ascending: quick, and good to rounding of
    /// the highest one among the functions.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn eigenvalues(&self, s: f64) -> Result<Vec<f64>, EigenError> {
        self.reduced.eigenvalues(s, self.count + BEYOND)
    }

    /// The lowest modes at Ω² = s.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn modes(&self, s: f64, count: usize) -> Result<Vec<RangeMode>, EigenError> {
        self.reduced.modes(s, count)
    }

    /// λ at ascending Ω², of the modes asked for and some more, and proven bounds of those asked for.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn bounded(&self, squares: &[f64]) -> Result<Vec<Bounded>, EigenError> {
        let mut last: Option<Separation> = None;
        let at = |s: &f64| {
            let (eigenvalues, vectors) = self.reduced.solve(*s, self.count + BEYOND)?;
            let bounds = self.bounds(*s, &eigenvalues, &vectors, &mut last);
            Ok(Bounded { eigenvalues, bounds })
        };
        squares.iter().map(at).collect()
    }

    fn bounds(
        &self,
        s: f64,
        values: &[f64],
        vectors: &DMatrix<f64>,
        last: &mut Option<Separation>,
    ) -> Result<Vec<(f64, f64)>, Missing> {
        let (theta, sigma) = self.shift.ok_or(Missing::Shift)?;
        let carried = |known: &Separation| {
            let d = (s - known.from) / self.highest;
            known.rho * (1.0 - d * theta / (1.0 - theta)) - d * sigma / (1.0 - theta)
        };
        let usable = |known: &Separation| {
            known.below >= self.count
                && known.below <= values.len()
                && values[known.below - 1] + sigma < NEAR * (carried(known) + sigma)
        };
        let known = if let Some(known) = last.filter(usable) {
            known
        } else {
            let proven = self.on.iter().find_map(|on| prove_separation(on, values, self.count, s));
            let (below, rho) = proven.ok_or(Missing::Separation)?;
            Separation { below, rho, from: s }
        };
        *last = Some(known);
        let proof = Proof { below: known.below, rho: carried(&known), theta, sigma };
        let n = known.below;
        let gaps = self.reduced.gaps(s, &values[..n], &vectors.columns(0, n).into_owned());
        let lower = lower_bounds(&values[..n], &gaps, &proof).ok_or(Missing::Shift)?;
        let rounding = |i: usize| {
            // The functions have unit energy in the middle of the range: a mode has about as much there.
            let size = 4.0 * vectors.column(i).norm_squared();
            ROUNDING * (size + values[i].abs() + sigma)
        };
        let pair = |i: usize| (lower[i].min(values[i]) - rounding(i), values[i] + rounding(i));
        let mut intervals: Vec<(f64, f64)> = (0..n).map(pair).collect();
        settle_free(&mut intervals, self.free[usize::from(s > 0.0)]);
        intervals.truncate(self.count);
        Ok(intervals)
    }
}

/// The span of modes as a few functions.
fn reduced(blade: &CoupledBlade, fine: &Assembly, highest: f64, sigma: f64, modes: &[Vector]) -> Reduced {
    let functions = orthonormal(fine, 0.5 * highest, sigma, modes);
    let fields = ModeFields::new(fine, &functions);
    let ModeEnergies { elastic, centrifugal, inertia } = energies(fine, &fields);
    let residuals = residual_moments(blade, fine, &fields);
    Reduced::new(sigma, [elastic, centrifugal, inertia], shares::kinetic(fine, &fields), residuals)
}

/// The span of modes as functions that are orthonormal in the energy in the middle of the range.
pub fn orthonormal(assembly: &Assembly, s: f64, sigma: f64, modes: &[Vector]) -> Vec<Vector> {
    let forms = assembly.forms(1.0, s, sigma);
    let mut out: Vec<Vector> = Vec::new();
    let mut loads: Vec<Vector> = Vec::new();
    for mode in modes {
        let mut function = mode.clone();
        let own = assembly.form_times(&forms, 1.0, &function);
        let before = sqrt(long_dot(&function, &own).max(0.0));
        for _ in 0..2 {
            for (known, loads) in out.iter().zip(&loads) {
                let along = long_dot(&function, loads);
                axpy(&mut function, -along, known);
            }
        }
        let mut own = assembly.form_times(&forms, 1.0, &function);
        let length = sqrt(long_dot(&function, &own).max(0.0));
        if length > NOTHING_NEW * before {
            scale(&mut function, 1.0 / length);
            scale(&mut own, 1.0 / length);
            out.push(function);
            loads.push(own);
        }
    }
    out
}

/// Columns: the residual moments of the inertia of every function, then of its centrifugal loads, then of its
/// strains.
pub fn residual_moments(blade: &CoupledBlade, assembly: &Assembly, fields: &ModeFields) -> DMatrix<f64> {
    let parts = [
        Factors { inertia: 1.0, ..Factors::default() },
        Factors { centrifugal: 1.0, ..Factors::default() },
        Factors { elastic: 1.0, ..Factors::default() },
    ];
    let columns: Vec<Vec<f64>> = parts
        .into_iter()
        .flat_map(|factors| (0..fields.count()).map(move |mode| residual(blade, assembly, fields, mode, factors)))
        .collect();
    let rows = columns.first().map_or(0, Vec::len);
    DMatrix::from_vec(rows, columns.len(), columns.concat())
}
