//! The coupled blade on elements, ready to be solved.

use super::along::Along;
use super::blade::{CoupledBlade, CoupledSection, CoupledStretch};
use super::element::{Element, Functions, Rule, Square};
use super::elimination::{Factor, Roots};
use super::layout::Layout;
use crate::dof::Dof;
use crate::lagrange::Energy;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::vector::axpy;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// Points of an element beyond its polynomials: the residual moments are divided by the stiffness, and the
/// cosine of the local angle is no polynomial.
const MORE_POINTS: usize = 6;

/// Coefficients of the functions of every element, one element after the other, or loads on them.
pub type Vector = Vec<f64>;

/// The matrices K, C and M of an element.
type Matrices = [Square; 3];

/// Elements with their functions and matrices.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// From root to tip.
    pub elements: Vec<Rc<Element>>,
    /// Of each element.
    pub functions: Vec<Rc<Functions>>,
    /// Where the blade is held.
    pub roots: Roots,
    matrices: Vec<Rc<Matrices>>,
    /// Where the functions of each element begin among all, and their number.
    starts: Vec<usize>,
    /// What acts at the points of the whole blade.
    pub along: Along,
}

impl Assembly {
    /// Of a blade on a layout; `known` stands on the same elements, and where it has the same orders it has what is
    /// needed.
    pub fn new(blade: &CoupledBlade, layout: &Layout, rules: &GaussRules, known: Option<&Self>) -> Self {
        let mut made: Vec<(usize, Rc<Rule>)> = Vec::new();
        let mut rule = |order: usize| -> Rc<Rule> {
            if let Some((_, rule)) = made.iter().find(|(known, _)| *known == order) {
                return Rc::clone(rule);
            }
            let rule = Rc::new(Rule::new(rules.with_points(order + MORE_POINTS), order));
            made.push((order, Rc::clone(&rule)));
            rule
        };
        let (mut elements, mut functions, mut matrices) = (Vec::new(), Vec::new(), Vec::new());
        for (index, (stretch, orders)) in blade.stretches(&layout.radii).iter().zip(&layout.orders).enumerate() {
            let orders = active(blade, stretch.from, *orders);
            if let Some(known) = known.filter(|known| known.elements[index].orders == orders) {
                elements.push(Rc::clone(&known.elements[index]));
                functions.push(Rc::clone(&known.functions[index]));
                matrices.push(Rc::clone(&known.matrices[index]));
                continue;
            }
            let highest = orders.iter().fold(1, |most, order| most.max(*order));
            let element = Element::new(stretch, orders, rule(highest), lumps(blade, stretch.from, stretch.to));
            let own = element.functions();
            let energies = [Energy::Elastic, Energy::Centrifugal, Energy::Inertia];
            matrices.push(Rc::new(energies.map(|energy| element.matrix(&own, energy))));
            functions.push(Rc::new(own));
            elements.push(Rc::new(element));
        }
        Self { functions, matrices, ..Self::to_sum_on(blade, elements) }
    }

    /// Elements without functions of their own, to sum along the blade on.
    pub fn to_sum_on(blade: &CoupledBlade, elements: Vec<Rc<Element>>) -> Self {
        Self {
            roots: Roots::new(blade, elements.iter().map(|element| element.from)),
            starts: starts(elements.iter().map(|element| element.count())),
            along: Along::new(&elements),
            functions: Vec::new(),
            matrices: Vec::new(),
            elements,
        }
    }

    /// Elements of one order on these radii for sums alone.
    pub fn of_order(blade: &CoupledBlade, radii: &[f64], order: usize, rules: &GaussRules) -> Self {
        let rule = Rc::new(Rule::new(rules.with_points(order + MORE_POINTS), order));
        let element = |stretch: &CoupledStretch| {
            let orders = active(blade, stretch.from, [order; 3]);
            Rc::new(Element::new(stretch, orders, Rc::clone(&rule), lumps(blade, stretch.from, stretch.to)))
        };
        Self::to_sum_on(blade, blade.stretches(radii).iter().map(element).collect())
    }

    /// Where the functions of an element stand among all.
    pub fn part(&self, element: usize) -> Range<usize> {
        self.starts[element]..self.starts[element + 1]
    }

    /// Number of functions of all elements.
    pub fn functions(&self) -> usize {
        self.starts.last().copied().unwrap_or(0)
    }

    /// α K + s C + κ M of every element, without the springs.
    pub fn forms(&self, alpha: f64, s: f64, kappa: f64) -> Vec<Square> {
        let form = |matrices: &Rc<Matrices>| {
            let mut form = Square::zero(matrices[0].order());
            for (matrix, factor) in matrices.iter().zip([alpha, s, kappa]) {
                form.add(factor, matrix);
            }
            form
        };
        self.matrices.iter().map(form).collect()
    }

    /// The factor of K + F + sC + σM, where that is positive definite.
    pub fn factor(&self, s: f64, sigma: f64) -> Option<Factor> {
        Factor::new(&self.elements, self.forms(1.0, s, sigma), &self.roots, 1.0, true)
    }

    /// M times a function: loads.
    pub fn inertia_times(&self, vector: &[f64]) -> Vector {
        let mut out = vec![0.0; vector.len()];
        for (index, matrices) in self.matrices.iter().enumerate() {
            let part = self.part(index);
            matrices[Energy::Inertia as usize].add_times(&vector[part.clone()], &mut out[part]);
        }
        out
    }

    /// α(K + F) + sC + κM times a function, from the forms of the elements: loads.
    pub fn form_times(&self, forms: &[Square], alpha: f64, vector: &[f64]) -> Vector {
        let mut out = vec![0.0; vector.len()];
        for (index, form) in forms.iter().enumerate() {
            let part = self.part(index);
            let (own, out) = (&vector[part.clone()], &mut out[part]);
            form.add_times(own, out);
            let (strains, free) = (self.elements[index].strains(), self.roots.free(index));
            for &p in free {
                let spring: f64 = free.iter().map(|q| self.roots.spring(p, *q) * own[strains + q]).sum();
                out[strains + p] += alpha * spring;
            }
        }
        out
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns_by_motion().iter().sum()
    }

    /// Number of unknowns of flap, lag and torsion.
    pub fn unknowns_by_motion(&self) -> [usize; 3] {
        let mut counts = [0; 3];
        for (index, element) in self.elements.iter().enumerate() {
            counts.iter_mut().zip(element.orders).for_each(|(count, order)| *count += order);
            // States w, w′, v, v′, φ.
            self.roots.free(index).iter().for_each(|state| counts[state / 2] += 1);
        }
        counts
    }
}

/// Orders of an element whose inner end is here: 0 for what is held farther outboard.
fn active(blade: &CoupledBlade, from: f64, mut orders: [usize; 3]) -> [usize; 3] {
    for dof in Dof::ALL {
        if from < blade.root(dof).offset {
            orders[dof.index()] = 0;
        }
    }
    orders
}

/// The concentrated masses in `from` < r ≤ `to`, which stand at the outer end.
fn lumps(blade: &CoupledBlade, from: f64, to: f64) -> Vec<CoupledSection> {
    let inside = blade.lumps.iter().filter(|lump| lump.r > from && lump.r <= to);
    inside.map(|lump| blade.lump_section(lump)).collect()
}

/// A sum of functions, of which there is one at least.
pub fn sum(functions: &[Vector], parts: &[f64]) -> Vector {
    let mut sum = vec![0.0; functions[0].len()];
    for (function, part) in functions.iter().zip(parts) {
        axpy(&mut sum, *part, function);
    }
    sum
}

/// Running sums of counts, from 0.
pub fn starts(counts: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut starts = vec![0];
    for count in counts {
        starts.push(starts[starts.len() - 1] + count);
    }
    starts
}
