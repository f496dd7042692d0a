//! The coupled blade on elements, ready to be solved.

use super::blade::{CoupledBlade, CoupledSection};
use super::element::{Element, PointFields, Rule, Square};
use super::elimination::{Factor, Roots};
use super::layout::Layout;
use crate::dof::Dof;
use crate::lagrange::Energy;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::vector::{self, dot};
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

/// Points of an element beyond its polynomials: the residual moments are divided by the stiffness, and the
/// cosine of the local angle is no polynomial.
const MORE_POINTS: usize = 6;

/// Coefficients of the functions of every element, or loads on them.
pub type Vector = Vec<Vec<f64>>;
/// Elements with their functions and matrices.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// From root to tip.
    pub elements: Vec<Element>,
    /// Of each element.
    pub functions: Vec<Vec<PointFields>>,
    /// Where the blade is held.
    pub roots: Roots,
    elastic: Vec<Square>,
    centrifugal: Vec<Square>,
    inertia: Vec<Square>,
}

impl Assembly {
    /// Of a blade on a layout.
    pub fn new(blade: &CoupledBlade, layout: &Layout, rules: &GaussRules) -> Self {
        let on = Self::to_sum_on(blade, layout, rules);
        let functions: Vec<Vec<PointFields>> = on.elements.iter().map(Element::functions).collect();
        let matrices = |energy| -> Vec<Square> {
            on.elements.iter().zip(&functions).map(|(element, functions)| element.matrix(functions, energy)).collect()
        };
        let [elastic, centrifugal, inertia] = [Energy::Elastic, Energy::Centrifugal, Energy::Inertia].map(matrices);
        Self { functions, elastic, centrifugal, inertia, ..on }
    }

    /// The elements alone, without functions of their own, for sums along the blade.
    pub fn to_sum_on(blade: &CoupledBlade, layout: &Layout, rules: &GaussRules) -> Self {
        let mut known: Vec<(usize, Rc<Rule>)> = Vec::new();
        let mut rule = |order: usize| -> Rc<Rule> {
            if let Some((_, rule)) = known.iter().find(|(known, _)| *known == order) {
                return Rc::clone(rule);
            }
            let rule = Rc::new(Rule::new(rules.with_points(order + MORE_POINTS), order));
            known.push((order, Rc::clone(&rule)));
            rule
        };
        let elements: Vec<Element> = blade
            .stretches(&layout.radii)
            .iter()
            .zip(&layout.orders)
            .map(|(stretch, orders)| {
                let orders = active(blade, stretch.from, *orders);
                let highest = orders.iter().fold(1, |most, order| most.max(*order));
                Element::new(stretch, orders, rule(highest), lumps(blade, stretch.from, stretch.to))
            })
            .collect();
        let roots = Roots::new(blade, elements.iter().map(|element| element.from));
        Self { elements, roots, functions: vec![], elastic: vec![], centrifugal: vec![], inertia: vec![] }
    }

    /// α K + s C + κ M of every element, without the springs.
    pub fn forms(&self, alpha: f64, s: f64, kappa: f64) -> Vec<Square> {
        let each = self.elastic.iter().zip(&self.centrifugal).zip(&self.inertia);
        each.map(|((elastic, centrifugal), inertia)| {
            let mut form = Square::zero(elastic.order());
            form.add(alpha, elastic);
            form.add(s, centrifugal);
            form.add(kappa, inertia);
            form
        })
        .collect()
    }

    /// The factor of K + F + sC + σM, where that is positive definite.
    pub fn factor(&self, s: f64, sigma: f64) -> Option<Factor> {
        Factor::new(&self.elements, self.forms(1.0, s, sigma), &self.roots, 1.0, true)
    }

    /// M times a function: loads.
    pub fn inertia_times(&self, vector: &[Vec<f64>]) -> Vector {
        let mut out = vec![Vec::new(); vector.len()];
        for ((matrix, own), out) in self.inertia.iter().zip(vector).zip(&mut out) {
            matrix.times(own, out);
        }
        out
    }

    /// α(K + F) + sC + κM times a function, from the forms of the elements: loads.
    pub fn form_times(&self, forms: &[Square], alpha: f64, vector: &[Vec<f64>]) -> Vector {
        let mut out = vec![Vec::new(); vector.len()];
        for (index, (own, out)) in vector.iter().zip(&mut out).enumerate() {
            forms[index].times(own, out);
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

/// The product of a function with loads.
pub fn product(function: &[Vec<f64>], loads: &[Vec<f64>]) -> f64 {
    function.iter().zip(loads).map(|(a, b)| dot(a, b)).sum()
}

/// Adds `factor` times another.
pub fn add(to: &mut [Vec<f64>], factor: f64, other: &[Vec<f64>]) {
    to.iter_mut().zip(other).for_each(|(to, other)| vector::axpy(to, factor, other));
}

/// Multiplies a function by a factor.
pub fn scale(function: &mut [Vec<f64>], factor: f64) {
    for part in function {
        vector::scale(part, factor);
    }
}

/// A sum of functions, of which there is one at least.
pub fn sum(functions: &[Vector], parts: &[f64]) -> Vector {
    let mut sum: Vector = functions[0].iter().map(|part| vec![0.0; part.len()]).collect();
    for (function, part) in functions.iter().zip(parts) {
        add(&mut sum, *part, function);
    }
    sum
}
