//! λ = ω² of one degree of freedom as functions of Ω².
//!
//! Within one uncoupled degree of freedom the eigenvalues are simple, so order is identity and
//! each λ is an analytic function of Ω² (docs/THEORY.md): a few Chebyshev nodes carry a chart of
//! any number of speeds. Whether they suffice is checked against the eigenproblem between them.
//!
//! Near rest the λ of a soft blade bend sharply, where its own stiffness gives way to the centrifugal
//! one. They do so between complex Ω² at which neighbours would meet, about where their straight
//! lines k₀ + k₁ Ω² do (Southwell's coefficients), at a negative Ω². The nodes are therefore taken
//! in ln(1 + Ω²/bend) with the nearest such point as the bend: it moves that point far away.

use crate::lagrange::SystemMatrices;
use crate::modes::{Eigenvalues, Mode, SolveError, VALUES_PER_CUBE, eigenvalues};
use crate::numerics::chebyshev::{interpolate, node, with_slopes};
use crate::numerics::scalar::{ceil, exp_m1, is_above, ln_1p, maximum, pow};
use alloc::vec;
use alloc::vec::Vec;
use core::cell::Cell;

/// Relative error of λ accepted between the nodes; ω has half of it.
const TOLERANCE: f64 = 1e-10;
/// When the interpolant of half the degree is this good at the new nodes, the full one, whose error
/// is about its square, is worth checking.
const COARSE_TOLERANCE: f64 = 1e-6;
/// Degree tried first. Its own error is measured at the new nodes of twice the degree, which stand
/// between its own.
const FIRST_DEGREE: usize = 4;
/// Degree after which the range is halved instead.
const LAST_DEGREE: usize = 32;
/// Where the error is checked, as shares of the piece: between the nodes of every degree.
const CHECKS: [f64; 2] = [0.013, 0.47];
/// Most pieces; the last ones are taken as they are.
const MOST_PIECES: usize = 64;
/// Eigenproblems of a piece that is good at once, and of a fit of one piece that is not.
const LEAST_EVALUATIONS: usize = 2 * FIRST_DEGREE + 1 + CHECKS.len() + 1;
const USUAL_EVALUATIONS: f64 = 35.0;
/// Bounds of the bend of the scale as a share of the highest Ω²: outside them it is straight, or
/// rest is all there is of it.
const BEND: (f64, f64) = (1e-12, 1e3);

/// The lowest eigenvalues of one degree of freedom over a range of Ω².
#[derive(Clone, Debug)]
pub struct Curves {
    scale: Scale,
    pieces: Vec<Piece>,
    branches: usize,
    /// The first branch starts as a rigid motion, λ₁ = 0 at rest: λ₁/Ω² is interpolated, which
    /// stays away from 0.
    rigid: bool,
    error: f64,
    work: f64,
}

/// The scale t = ln(1 + s/bend) of s = Ω² on which the branches are smooth.
#[derive(Clone, Copy, Debug)]
struct Scale {
    bend: f64,
}

/// Values at the nodes of one piece of the range.
#[derive(Clone, Debug)]
struct Piece {
    /// On the scale.
    nodes: Vec<f64>,
    rows: Vec<Vec<f64>>,
    /// Largest relative error found; 0 where the tolerance was reached.
    error: f64,
}

/// One branch at one Ω².
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// λ, or λ/Ω² for the rigid branch.
    pub(super) value: f64,
    /// Derivative of `value` by Ω².
    pub(super) slope: f64,
}

impl Scale {
    /// For modes at rest and Ω² up to `to`.
    fn new(at_rest: &[Mode], to: f64) -> Self {
        let bend = at_rest
            .windows(2)
            .map(|pair| (pair[1].eigenvalue - pair[0].eigenvalue) / (pair[1].southwell - pair[0].southwell))
            .filter(|bend| *bend > 0.0)
            .fold(f64::INFINITY, f64::min);
        Self { bend: bend.clamp(BEND.0 * to, BEND.1 * to).max(f64::MIN_POSITIVE) }
    }

    fn at(self, speed_squared: f64) -> f64 {
        ln_1p(speed_squared / self.bend)
    }

    fn speed_squared(self, t: f64) -> f64 {
        self.bend * exp_m1(t)
    }
}

impl Curves {
    /// As many of the lowest eigenvalues as there are modes `at_rest`, for `from` ≤ Ω² ≤ `to` [rad²/s²].
    ///
    /// # Errors
    /// [`SolveError`].
    pub fn fit(matrices: &SystemMatrices, at_rest: &[Mode], from: f64, to: f64, work: f64) -> Result<Self, SolveError> {
        let rigid = !matrices.rigid().is_empty();
        let spent = Cell::new(0.0);
        let row = |s: f64| {
            row(at_rest, s, rigid, || {
                let Eigenvalues { values, work } = eigenvalues(matrices, s, at_rest.len())?;
                spent.set(spent.get() + work);
                Ok(values)
            })
        };
        let left = || work - spent.get();
        let mut curves = Self::through(at_rest.len(), rigid, Scale::new(at_rest, to), (from, to), left, row)?;
        curves.work = spent.get();
        Ok(curves)
    }

    /// Curves through what `row` gives at any Ω², a number for each branch, while there is work `left`.
    fn through<E>(
        branches: usize,
        rigid: bool,
        scale: Scale,
        (from, to): (f64, f64),
        left: impl Fn() -> f64,
        row: impl Fn(f64) -> Result<Vec<f64>, E>,
    ) -> Result<Self, E> {
        let row = |t: f64| row(scale.speed_squared(t));
        let mut curves = Self { scale, pieces: Vec::new(), branches, rigid, error: 0.0, work: 0.0 };
        let mut waiting = vec![(scale.at(from), scale.at(to))];
        while let Some((from, to)) = waiting.pop() {
            let mut piece = Piece {
                nodes: (0..=FIRST_DEGREE).map(|i| node(from, to, FIRST_DEGREE, i)).collect(),
                rows: Vec::new(),
                error: 0.0,
            };
            let before = left();
            piece.rows = piece.nodes.iter().map(|&t| row(t)).collect::<Result<_, _>>()?;
            let each = (before - left()) / piece.nodes.len() as f64;
            loop {
                let (coarse_error, worst) = piece.refine(from, to, row)?;
                let enough = coarse_error < TOLERANCE
                    || (coarse_error < COARSE_TOLERANCE && piece.error(from, to, worst, row)? < TOLERANCE);
                let middle = 0.5 * (from + to);
                let is_full = piece.nodes.len() > LAST_DEGREE;
                // What is left is for the pieces that wait, too.
                let evaluations = left() / each / (waiting.len() + 1) as f64;
                let needed = if is_full { 2 * LEAST_EVALUATIONS } else { piece.nodes.len() + CHECKS.len() + 1 };
                let divides = middle > from && middle < to && curves.pieces.len() + waiting.len() < MOST_PIECES;
                let goes_on = (!is_full || divides) && (evaluations.is_nan() || evaluations > needed as f64);
                if enough || !goes_on {
                    if !enough {
                        // The half of the degree tells where the check happens to stand well.
                        piece.error = maximum(coarse_error, piece.error(from, to, worst, row)?);
                        curves.error = maximum(curves.error, piece.error);
                    }
                    curves.pieces.push(piece);
                    break;
                }
                if is_full {
                    waiting.push((middle, to));
                    waiting.push((from, middle));
                    break;
                }
            }
        }
        Ok(curves)
    }

    /// About how many multiplications the fit took.
    pub fn work(&self) -> f64 {
        self.work
    }

    /// The largest relative error of λ found where the curves were left as they are; 0 where they
    /// reached their tolerance everywhere.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Whether the curves follow the branches at Ω² = `speed_squared` to their tolerance.
    pub fn follow(&self, speed_squared: f64) -> bool {
        self.piece(self.scale.at(speed_squared)).is_some_and(|piece| piece.error == 0.0)
    }

    /// Number of branches.
    pub fn branches(&self) -> usize {
        self.branches
    }

    /// λ of every branch at Ω² = `speed_squared` inside the range. Where λ is 0 the curve may lie below
    /// by rounding.
    pub fn eigenvalues(&self, speed_squared: f64) -> Vec<f64> {
        let mut values = vec![0.0; self.branches];
        let t = self.scale.at(speed_squared);
        if let Some(piece) = self.piece(t) {
            interpolate(&piece.nodes, &piece.rows, 0, t, &mut values);
        }
        if self.rigid
            && let Some(first) = values.first_mut()
        {
            *first *= speed_squared;
        }
        values
    }

    fn piece(&self, t: f64) -> Option<&Piece> {
        let index = self.pieces.partition_point(|piece| piece.end() < t);
        self.pieces.get(index).or(self.pieces.last())
    }

    /// Whether a branch holds λ/Ω² instead of λ.
    pub(super) fn is_rigid(&self, branch: usize) -> bool {
        self.rigid && branch == 0
    }

    /// Value and slope of every branch.
    pub(super) fn points(&self, speed_squared: f64) -> Vec<Point> {
        self.points_of(0, self.branches, speed_squared)
    }

    /// Value and slope of one branch.
    pub(super) fn point(&self, branch: usize, speed_squared: f64) -> Point {
        self.points_of(branch, 1, speed_squared)[0]
    }

    fn points_of(&self, first: usize, count: usize, speed_squared: f64) -> Vec<Point> {
        let (mut values, mut derivatives) = (vec![0.0; count], vec![0.0; count]);
        let t = self.scale.at(speed_squared);
        if let Some(piece) = self.piece(t) {
            with_slopes(&piece.nodes, &piece.rows, first, t, &mut values, &mut derivatives);
        }
        let rate = 1.0 / (speed_squared + self.scale.bend);
        values.into_iter().zip(derivatives).map(|(value, slope)| Point { value, slope: slope * rate }).collect()
    }

    /// Ω² at the nodes of all pieces, ascending: between two of them a branch is smooth.
    pub(super) fn nodes(&self) -> Vec<f64> {
        let nodes = self.pieces.iter().flat_map(|piece| &piece.nodes);
        let mut squares: Vec<f64> = nodes.map(|&t| self.scale.speed_squared(t)).collect();
        squares.dedup();
        squares
    }
}

impl Piece {
    fn end(&self) -> f64 {
        self.nodes.last().copied().unwrap_or(0.0)
    }

    /// Doubles the degree and returns the old interpolant's largest relative error at the new nodes, and at
    /// which of all nodes that is.
    fn refine<E>(&mut self, from: f64, to: f64, row: impl Fn(f64) -> Result<Vec<f64>, E>) -> Result<(f64, usize), E> {
        let degree = 2 * (self.nodes.len() - 1);
        let mut nodes = Vec::with_capacity(degree + 1);
        let mut rows = Vec::with_capacity(degree + 1);
        let (mut worst, mut at) = (0.0_f64, 0);
        for index in 0..=degree {
            let t = node(from, to, degree, index);
            nodes.push(t);
            if index % 2 == 0 {
                rows.push(self.rows[index / 2].clone());
            } else {
                let exact = row(t)?;
                let difference = self.difference(t, &exact);
                if is_above(difference, worst) {
                    (worst, at) = (difference, index);
                }
                rows.push(exact);
            }
        }
        (self.nodes, self.rows) = (nodes, rows);
        Ok((worst, at))
    }

    /// The largest relative error at the check points, one of which is beside the node `worst`.
    fn error<E>(&self, from: f64, to: f64, worst: usize, row: impl Fn(f64) -> Result<Vec<f64>, E>) -> Result<f64, E> {
        // Where the branches of two modes nearly meet, the error stands there alone.
        let beside = worst.min(self.nodes.len() - 2);
        let at_worst = 0.5 * (self.nodes[beside] + self.nodes[beside + 1]);
        let points = CHECKS.iter().map(|share| from + share * (to - from)).chain([at_worst]);
        points.into_iter().try_fold(0.0_f64, |worst, t| Ok(maximum(worst, self.difference(t, &row(t)?))))
    }

    fn difference(&self, t: f64, exact: &[f64]) -> f64 {
        let mut values = vec![0.0; exact.len()];
        interpolate(&self.nodes, &self.rows, 0, t, &mut values);
        // A branch that stays at 0 has no relative error.
        values.iter().zip(exact).filter(|(_, e)| **e != 0.0).map(|(v, e)| (v / e - 1.0).abs()).fold(0.0, maximum)
    }
}

/// Ω² over a range, ends included, evenly on the scale on which the branches of a blade with these modes at rest
/// are smooth; none farther than `step` from the next, where they bend once per unit, but `most` in all.
pub fn sample(at_rest: &[Mode], (from, to): (f64, f64), step: f64, most: usize) -> Vec<f64> {
    let scale = Scale::new(at_rest, to);
    let (low, high) = (scale.at(from), scale.at(to));
    let parts = ceil((high - low) / step).min(most as f64).max(1.0);
    let at = |i: usize| scale.speed_squared(low + (high - low) * (i as f64 / parts)).min(to);
    (0..=most.max(1)).take_while(|i| *i as f64 <= parts).map(at).collect()
}

/// How many functions an ordinary fit may have with so much work.
pub fn most_functions(work: f64) -> usize {
    let cube = maximum(work, 0.0) / (USUAL_EVALUATIONS * VALUES_PER_CUBE);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative; the cast saturates")]
    let most = pow(cube, 1.0 / 3.0) as usize;
    most
}

/// What is interpolated: every λ at Ω² = `s`, the rigid branch's divided by Ω². At rest that ratio
/// is dλ/dΩ², the Southwell coefficient.
fn row(
    at_rest: &[Mode],
    s: f64,
    rigid: bool,
    solved: impl Fn() -> Result<Vec<f64>, SolveError>,
) -> Result<Vec<f64>, SolveError> {
    if s <= 0.0 {
        let value = |(index, mode): (usize, &Mode)| {
            if rigid && index == 0 { maximum(mode.southwell, 0.0) } else { mode.eigenvalue }
        };
        return Ok(at_rest.iter().enumerate().map(value).collect());
    }
    let mut values = solved()?;
    if let Some(first) = values.first_mut().filter(|_| rigid) {
        // 0 at every speed where nothing pulls, else dλ/dΩ² at small ones.
        *first /= s;
    }
    Ok(values)
}

#[cfg(test)]
impl Curves {
    /// Of made-up branches λ(Ω²).
    pub(super) fn of_functions(branches: usize, (from, to): (f64, f64), row: impl Fn(f64) -> Vec<f64>) -> Self {
        let row = |s: f64| -> Result<Vec<f64>, core::convert::Infallible> { Ok(row(s)) };
        Self::through(branches, false, Scale { bend: to }, (from, to), || f64::INFINITY, row)
            .unwrap_or_else(|never| match never {})
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::cell::Cell;

    #[test]
    fn smooth_branches_are_met_between_few_nodes() {
        let solved = Cell::new(0);
        let row = |s: f64| {
            solved.set(solved.get() + 1);
            vec![2.0 + s, 40.0 + 3.0 * s - 7.0 / (1.0 + 0.01 * s)]
        };
        let curves = Curves::of_functions(2, (0.0, 300.0), row);
        assert!(solved.get() < 40, "{}", solved.get());
        assert_eq!((curves.branches(), curves.error()), (2, 0.0));
        for i in 0..=1000 {
            let s = 0.3 * f64::from(i);
            for (value, exact) in curves.eigenvalues(s).iter().zip(row(s)) {
                assert!((value / exact - 1.0).abs() < TOLERANCE, "{s}: {value} {exact}");
            }
        }
        let (points, h) = (curves.points(100.0), 1e-3);
        let (above, below) = (curves.eigenvalues(100.0 + h), curves.eigenvalues(100.0 - h));
        for (branch, point) in points.iter().enumerate() {
            let slope = (above[branch] - below[branch]) / (2.0 * h);
            assert!((point.slope / slope - 1.0).abs() < 1e-5, "{} {slope}", point.slope);
        }
    }

    #[test]
    fn negative_branches_stay_negative() {
        let curves = Curves::of_functions(1, (0.0, 10.0), |s| vec![s - 4.0]);
        for (s, exact) in [(0.0, -4.0), (1.7, -2.3), (9.0, 5.0)] {
            assert!((curves.eigenvalues(s)[0] - exact).abs() < 1e-9, "{s}");
        }
    }

    /// Nodes no number of which follows a corner: pieces close in on it, and what is left is told.
    #[test]
    fn what_no_polynomial_follows_is_told() {
        let corner = Curves::of_functions(1, (0.0, 10.0), |s| vec![1.0 + (s - 3.3).abs()]);
        assert!(corner.pieces.len() > 10);
        assert!((corner.eigenvalues(5.0)[0] - 2.7).abs() < 1e-9);
        let comb = Curves::of_functions(1, (0.0, 10.0), |s| vec![2.0 + (1e4 * s).sin()]);
        assert!(comb.error() > TOLERANCE, "{}", comb.error());
    }

    #[test]
    fn what_is_not_a_number_is_not_converged() {
        let solved = Cell::new(0);
        let curves = Curves::of_functions(2, (0.0, 10.0), |s| {
            solved.set(solved.get() + 1);
            vec![1.0 + s, if s > 5.0 { f64::NAN } else { 1.0 }]
        });
        assert!(is_above(curves.error(), TOLERANCE), "{}", curves.error());
        assert!(solved.get() < 70 * MOST_PIECES * 2, "{}", solved.get());
    }

    #[test]
    fn one_speed_is_a_range_too() {
        let curves = Curves::of_functions(1, (7.0, 7.0), |s| vec![s * s]);
        assert_eq!(curves.eigenvalues(7.0), [curves.pieces[0].rows[0][0]]);
        assert!((curves.eigenvalues(7.0)[0] - 49.0).abs() < 1e-12);
    }

    #[test]
    fn a_straight_scale_and_one_that_bends_at_once_are_held_to_the_range() {
        let mode = |eigenvalue: f64, southwell: f64| Mode {
            eigenvalue,
            frequency: eigenvalue.sqrt(),
            coordinates: nalgebra::DVector::zeros(1),
            southwell,
            residual: 0.0,
        };
        // Lines 1 + s and 11 + 2 s meet at s = −10.
        assert_eq!(Scale::new(&[mode(1.0, 1.0), mode(11.0, 2.0)], 100.0).bend, 10.0);
        assert_eq!(Scale::new(&[mode(1.0, 1.0)], 100.0).bend, 1e5);
        assert_eq!(Scale::new(&[mode(1.0, 1.0), mode(1.0 + 1e-12, 1e9)], 100.0).bend, 1e-10);
        let scale = Scale { bend: 10.0 };
        for s in [0.0, 1e-9, 3.0, 1e6] {
            assert!((scale.speed_squared(scale.at(s)) - s).abs() <= 1e-15 * 16.0 * s);
        }
    }
}
