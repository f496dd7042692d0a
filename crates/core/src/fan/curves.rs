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
use crate::modes::{Mode, SolveError, eigenvalues};
use crate::numerics::chebyshev::{interpolate, node, slopes};
use crate::numerics::scalar::{exp_m1, ln_1p};
use alloc::vec;
use alloc::vec::Vec;

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
    pub fn fit(matrices: &SystemMatrices, at_rest: &[Mode], from: f64, to: f64) -> Result<Self, SolveError> {
        let rigid = !matrices.rigid().is_empty();
        let scale = Scale::new(at_rest, to);
        let row = |t: f64| row(matrices, at_rest, scale.speed_squared(t), rigid);
        let mut pieces = Vec::new();
        let mut waiting = vec![(scale.at(from), scale.at(to))];
        while let Some((from, to)) = waiting.pop() {
            let mut piece = Piece {
                nodes: (0..=FIRST_DEGREE).map(|i| node(from, to, FIRST_DEGREE, i)).collect(),
                rows: Vec::new(),
            };
            piece.rows = piece.nodes.iter().map(|&t| row(t)).collect::<Result<_, _>>()?;
            loop {
                let coarse_error = piece.refine(from, to, row)?;
                let enough = coarse_error < TOLERANCE
                    || (coarse_error < COARSE_TOLERANCE && piece.error(from, to, row)? < TOLERANCE);
                let middle = 0.5 * (from + to);
                let last = pieces.len() + waiting.len() >= MOST_PIECES || middle <= from || middle >= to;
                if enough || (last && piece.nodes.len() > LAST_DEGREE) {
                    pieces.push(piece);
                    break;
                }
                if piece.nodes.len() > LAST_DEGREE {
                    waiting.push((middle, to));
                    waiting.push((from, middle));
                    break;
                }
            }
        }
        Ok(Self { scale, pieces, branches: at_rest.len(), rigid })
    }

    /// Number of branches.
    pub fn branches(&self) -> usize {
        self.branches
    }

    /// λ of every branch at Ω² = `speed_squared` inside the range; never below 0.
    pub fn eigenvalues(&self, speed_squared: f64) -> Vec<f64> {
        let mut values = vec![0.0; self.branches];
        let t = self.scale.at(speed_squared);
        if let Some(piece) = self.piece(t) {
            interpolate(&piece.nodes, &piece.rows, t, &mut values);
        }
        if self.rigid
            && let Some(first) = values.first_mut()
        {
            *first *= speed_squared;
        }
        values.into_iter().map(|value| value.max(0.0)).collect()
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
        let (mut values, mut derivatives) = (vec![0.0; self.branches], vec![0.0; self.branches]);
        let t = self.scale.at(speed_squared);
        if let Some(piece) = self.piece(t) {
            interpolate(&piece.nodes, &piece.rows, t, &mut values);
            slopes(&piece.nodes, &piece.rows, t, &mut derivatives);
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

    /// Doubles the degree and returns the old interpolant's largest relative error at the new nodes.
    fn refine(
        &mut self,
        from: f64,
        to: f64,
        row: impl Fn(f64) -> Result<Vec<f64>, SolveError>,
    ) -> Result<f64, SolveError> {
        let degree = 2 * (self.nodes.len() - 1);
        let mut nodes = Vec::with_capacity(degree + 1);
        let mut rows = Vec::with_capacity(degree + 1);
        let mut worst = 0.0_f64;
        for index in 0..=degree {
            let t = node(from, to, degree, index);
            nodes.push(t);
            if index % 2 == 0 {
                rows.push(self.rows[index / 2].clone());
            } else {
                let exact = row(t)?;
                worst = worst.max(self.difference(t, &exact));
                rows.push(exact);
            }
        }
        (self.nodes, self.rows) = (nodes, rows);
        Ok(worst)
    }

    /// The largest relative error at the check points.
    fn error(&self, from: f64, to: f64, row: impl Fn(f64) -> Result<Vec<f64>, SolveError>) -> Result<f64, SolveError> {
        CHECKS.iter().try_fold(0.0_f64, |worst, share| {
            let t = from + share * (to - from);
            Ok(worst.max(self.difference(t, &row(t)?)))
        })
    }

    fn difference(&self, t: f64, exact: &[f64]) -> f64 {
        let mut values = vec![0.0; exact.len()];
        interpolate(&self.nodes, &self.rows, t, &mut values);
        values.iter().zip(exact).filter(|(_, e)| **e > 0.0).map(|(v, e)| (v / e - 1.0).abs()).fold(0.0, f64::max)
    }
}

/// What is interpolated: every λ at Ω² = `s`, the rigid branch's divided by Ω². At rest that ratio
/// is dλ/dΩ², the Southwell coefficient.
fn row(matrices: &SystemMatrices, at_rest: &[Mode], s: f64, rigid: bool) -> Result<Vec<f64>, SolveError> {
    if s <= 0.0 {
        let value = |(index, mode): (usize, &Mode)| {
            if rigid && index == 0 { mode.southwell.max(0.0) } else { mode.eigenvalue }
        };
        return Ok(at_rest.iter().enumerate().map(value).collect());
    }
    let mut values = eigenvalues(matrices, s, at_rest.len())?;
    if let Some(first) = values.first_mut().filter(|_| rigid) {
        // 0 at every speed where nothing pulls, else dλ/dΩ² at small ones.
        *first /= s;
    }
    Ok(values)
}
