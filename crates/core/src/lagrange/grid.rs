//! Quadrature points along the span with the blade's properties there, and what functions do at them.

use super::panels::{Segment, segments};
use crate::blade::{Blade, RootCondition, tension_inside};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, Sample};
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;
use nalgebra::DMatrix;

/// A stretch of the span with one Gauss rule, inside which every property is linear.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Inner end [m].
    pub from: f64,
    /// Outer end [m].
    pub to: f64,
    /// Its points among all of the grid.
    pub points: Range<usize>,
}

impl Cell {
    /// Half the length: dr/dξ of the rule on [−1, 1] [m].
    pub fn half(&self) -> f64 {
        0.5 * (self.to - self.from)
    }
}

/// Quadrature points of one degree of freedom from root to tip. Flap, lag and torsion have one
/// form here: the potential energy is ½ ∫ D e² dr + ½ Ω² ∫ P t² dr and the kinetic one
/// ½ ω² ∫ J u² dr with
///
/// | | motion u | turn t | strain e | D | P | J |
/// |---|---|---|---|---|---|---|
/// | bending | w | w′ | w″ | EI | T | m |
/// | torsion | θ | θ | θ′ | GJ | m Y² | ρI_p |
///
/// so that the turn is the integral of the strain in both. Lag is flap with its own stiffness but
/// for −Ω² m, which shifts every eigenvalue by −Ω² and no shape (Eq. 76).
#[derive(Clone, Debug)]
pub struct Grid {
    dof: Dof,
    root: f64,
    condition: RootCondition,
    cells: Vec<Cell>,
    radius: Vec<f64>,
    weight: Vec<f64>,
    inertia: Vec<f64>,
    stiffness: Vec<f64>,
    pull: Vec<f64>,
}

impl Grid {
    /// For assumed functions: points enough to integrate any product of two of them times a
    /// cubic. With `more` points in each cell, and cells cut where the stiffness tapers, such products
    /// may also be divided by the stiffness.
    pub fn for_functions(
        blade: &Blade,
        dof: Dof,
        functions: &dyn AssumedFunctions,
        rules: &GaussRules,
        more: usize,
    ) -> Self {
        let mut grid = Self::empty(blade, dof);
        let mut joints: Vec<f64> = functions.joints().iter().map(|x| grid.root + x).collect();
        if more > 0 {
            let stiffness = blade.stiffness(dof);
            joints.extend(segments(blade, dof, &[]).iter().flat_map(|segment| segment.taper_cuts(stiffness)));
        }
        for segment in segments(blade, dof, &joints) {
            segment.panels(functions, rules, |from, to, rule| {
                grid.push(blade, segment, from, to, rules.with_points(rule.len() + more));
            });
        }
        grid.add_pull(blade);
        grid
    }

    /// With given cells (from, to, points), ascending from root to tip; none may straddle a station.
    pub fn for_cells(
        blade: &Blade,
        dof: Dof,
        cells: impl Iterator<Item = (f64, f64, usize)>,
        rules: &GaussRules,
    ) -> Self {
        let mut grid = Self::empty(blade, dof);
        for (from, to, points) in cells {
            grid.push(blade, Segment { from, to }, from, to, rules.with_points(points));
        }
        grid.add_pull(blade);
        grid
    }

    fn empty(blade: &Blade, dof: Dof) -> Self {
        let root = blade.root(dof);
        Self {
            dof,
            root: root.offset,
            condition: root.condition,
            cells: Vec::new(),
            radius: Vec::new(),
            weight: Vec::new(),
            inertia: Vec::new(),
            stiffness: Vec::new(),
            pull: Vec::new(),
        }
    }

    fn push(&mut self, blade: &Blade, segment: Segment, from: f64, to: f64, rule: &[(f64, f64)]) {
        let first = self.radius.len();
        let (half, middle) = (0.5 * (to - from), 0.5 * (from + to));
        let torsion = self.dof == Dof::Torsion;
        let inertia = segment.linear(if torsion { blade.polar_inertia() } else { blade.mass() });
        let stiffness = segment.linear(blade.stiffness(self.dof));
        for &(node, weight) in rule {
            let r = middle + half * node;
            self.radius.push(r);
            self.weight.push(half * weight);
            self.inertia.push(inertia.at(r));
            self.stiffness.push(stiffness.at(r));
        }
        self.cells.push(Cell { from, to, points: first..self.radius.len() });
    }

    /// The tension, summed from the tip, or m Y².
    fn add_pull(&mut self, blade: &Blade) {
        self.pull = vec![0.0; self.radius.len()];
        let mut outboard = 0.0;
        for cell in self.cells.iter().rev() {
            let segment = Segment { from: cell.from, to: cell.to };
            let mass = segment.linear(blade.mass());
            let offset = segment.linear(blade.mass_offset());
            for (pull, &r) in self.pull[cell.points.clone()].iter_mut().zip(&self.radius[cell.points.clone()]) {
                *pull = if self.dof == Dof::Torsion {
                    mass.at(r) * offset.at(r) * offset.at(r)
                } else {
                    outboard + tension_inside(mass.at(r), mass.at(cell.to), r, cell.to)
                };
            }
            outboard += tension_inside(mass.at(cell.from), mass.at(cell.to), cell.from, cell.to);
        }
    }

    /// The degree of freedom.
    pub fn dof(&self) -> Dof {
        self.dof
    }

    /// Radius of the root [m].
    pub fn root(&self) -> f64 {
        self.root
    }

    /// How the root is held.
    pub fn condition(&self) -> RootCondition {
        self.condition
    }

    /// The cells, root to tip.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.radius.len()
    }

    /// Whether there are no points; a blade has some.
    pub fn is_empty(&self) -> bool {
        self.radius.is_empty()
    }

    /// Distance of each point from the root [m].
    pub fn x(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        self.radius.iter().map(|r| r - self.root)
    }

    /// The motion of a unit rigid turn about the root: x in bending, 1 in torsion.
    pub fn rigid_motion(&self) -> Vec<f64> {
        if self.dof == Dof::Torsion { vec![1.0; self.len()] } else { self.x().collect() }
    }

    /// Quadrature weights [m].
    pub fn weight(&self) -> &[f64] {
        &self.weight
    }

    /// m [kg/m] or ρI_p [kg·m].
    pub fn inertia(&self) -> &[f64] {
        &self.inertia
    }

    /// EI or GJ [N·m²].
    pub fn stiffness(&self) -> &[f64] {
        &self.stiffness
    }

    /// T or m Y² [kg·m].
    pub fn pull(&self) -> &[f64] {
        &self.pull
    }

    /// Weights times a property.
    pub fn weighted<'a>(&'a self, property: &'a [f64]) -> impl ExactSizeIterator<Item = f64> + 'a {
        self.weight.iter().zip(property).map(|(weight, value)| weight * value)
    }
}

/// What some functions do at the points of a grid (points × functions).
#[derive(Clone, Debug)]
pub struct Fields {
    /// w or θ.
    pub motion: DMatrix<f64>,
    /// w′ or θ.
    pub turn: DMatrix<f64>,
    /// w″ or θ′.
    pub strain: DMatrix<f64>,
    /// The turn at the root.
    pub root_turn: Vec<f64>,
}

impl Fields {
    /// Samples assumed functions at every point.
    pub fn sample(grid: &Grid, functions: &dyn AssumedFunctions) -> Self {
        let n = functions.count();
        let mut samples = vec![Sample::default(); n];
        let mut fields = Self {
            motion: DMatrix::zeros(grid.len(), n),
            turn: DMatrix::zeros(grid.len(), n),
            strain: DMatrix::zeros(grid.len(), n),
            root_turn: Vec::with_capacity(n),
        };
        let torsion = grid.dof == Dof::Torsion;
        let mut about = Vec::new();
        let mut offsets = Vec::new();
        for cell in &grid.cells {
            let middle = 0.5 * (cell.from + cell.to);
            offsets.clear();
            offsets.extend(grid.radius[cell.points.clone()].iter().map(|r| r - middle));
            about.clear();
            about.resize(n * offsets.len(), Sample::default());
            functions.sample_about(middle - grid.root, &offsets, &mut about);
            for (i, samples) in about.chunks_exact(offsets.len()).enumerate() {
                for (point, sample) in cell.points.clone().zip(samples) {
                    fields.motion[(point, i)] = sample.value;
                    fields.turn[(point, i)] = if torsion { sample.value } else { sample.slope };
                    fields.strain[(point, i)] = if torsion { sample.slope } else { sample.curvature };
                }
            }
        }
        functions.sample(0.0, &mut samples);
        fields.root_turn.extend(samples.iter().map(|sample| if torsion { sample.value } else { sample.slope }));
        fields
    }

    /// The fields of sums of the functions: one column of `coordinates` per sum.
    #[must_use]
    pub fn combined(&self, coordinates: &DMatrix<f64>) -> Self {
        let root = nalgebra::RowDVector::from_row_slice(&self.root_turn) * coordinates;
        Self {
            motion: &self.motion * coordinates,
            turn: &self.turn * coordinates,
            strain: &self.strain * coordinates,
            root_turn: root.iter().copied().collect(),
        }
    }
}

/// Σ weight a_i a_j over the points (functions × functions).
pub(super) fn gram(a: &DMatrix<f64>, weight: impl ExactSizeIterator<Item = f64>) -> DMatrix<f64> {
    let (points, n) = (a.nrows(), a.ncols());
    let weight: Vec<f64> = weight.collect();
    let mut out = DMatrix::zeros(n, n);
    let mut weighted = vec![0.0; points];
    for j in 0..n {
        let column = &a.as_slice()[j * points..(j + 1) * points];
        weighted.iter_mut().zip(column).zip(&weight).for_each(|((out, a), w)| *out = a * w);
        for i in j..n {
            let value = dot(&weighted, &a.as_slice()[i * points..(i + 1) * points]);
            out[(i, j)] = value;
            out[(j, i)] = value;
        }
    }
    out
}

/// Σ a b in four sums side by side: a fixed order that a compiler may run in vectors.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (chunks_a, chunks_b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = chunks_a.remainder().iter().zip(chunks_b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in chunks_a.zip(chunks_b) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}
