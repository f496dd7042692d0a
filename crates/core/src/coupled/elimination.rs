//! Elimination along the blade, from the tip: solving (α(K + F) + sC + κM) x = load, and the number of its
//! negative directions, in time proportional to the elements.

use super::blade::CoupledBlade;
use super::element::{Element, STATES, Square};
use crate::blade::RootCondition;
use crate::dof::Dof;
use crate::numerics::vector::{axpy, dot};
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

/// The form in the state at an element's end.
pub type State = [f64; STATES];

/// A root at an element's inner end: which states it holds at 0 and which are free.
#[derive(Clone, Debug, Default)]
pub struct RootStates {
    held: Vec<usize>,
    free: Vec<usize>,
}

/// The roots along the blade, element by element, and their springs.
#[derive(Clone, Debug)]
pub struct Roots {
    at: Vec<RootStates>,
    /// Springs in w′, v′: ww, wv, vv; in φ.
    bending: [f64; 3],
    pitch: f64,
}

/// State of the rotation of a degree of freedom.
const ROTATIONS: [usize; 3] = [1, 3, 4];

impl Roots {
    /// Of a blade on elements whose inner ends stand at these radii.
    pub fn new(blade: &CoupledBlade, from: impl Iterator<Item = f64>) -> Self {
        let at = from
            .map(|r| {
                let mut states = RootStates::default();
                for dof in Dof::ALL {
                    let root = blade.root(dof);
                    #[allow(clippy::float_cmp, reason = "elements end at the roots to the bit")]
                    if root.offset != r {
                        continue;
                    }
                    let rotation = ROTATIONS[dof.index()];
                    if dof != Dof::Torsion {
                        states.held.push(rotation - 1);
                    }
                    let side =
                        if root.condition == RootCondition::Clamped { &mut states.held } else { &mut states.free };
                    side.push(rotation);
                }
                states
            })
            .collect();
        let pitch = match blade.root(Dof::Torsion).condition {
            RootCondition::Spring(spring) => spring,
            RootCondition::Free | RootCondition::Clamped => 0.0,
        };
        Self { at, bending: blade.bending_springs(), pitch }
    }

    /// Free states at the inner end of an element.
    pub fn free(&self, element: usize) -> &[usize] {
        &self.at[element].free
    }

    /// States that are 0 at the inner end of an element.
    pub fn held(&self, element: usize) -> &[usize] {
        &self.at[element].held
    }

    /// The springs between two states that are free at one root [N·m/rad].
    pub fn spring(&self, p: usize, q: usize) -> f64 {
        match (p, q) {
            (1, 1) => self.bending[0],
            (3, 3) => self.bending[2],
            (1, 3) | (3, 1) => self.bending[1],
            (4, 4) => self.pitch,
            _ => 0.0,
        }
    }
}

/// An element whose strains are eliminated: unit columns below the pivots.
#[derive(Clone, Debug)]
struct Eliminated {
    /// Rows of all functions, one column per strain.
    lower: Square,
    pivots: Vec<f64>,
    /// Free root states eliminated at the inner end, in order: which, its pivot, its column.
    root: Vec<(usize, f64, State)>,
    /// Root states that are 0 there.
    held: Vec<usize>,
}

/// The factor of a form along the blade.
#[derive(Clone, Debug)]
pub struct Factor {
    elements: Vec<Eliminated>,
    negative: usize,
}

impl Factor {
    /// Of the forms of all elements, which are used up; springs are multiplied by `alpha`. `None` where a pivot
    /// is 0 or not a number, and where `definite` is asked for and one is not above 0.
    pub fn new(
        elements: &[Rc<Element>],
        forms: Vec<Square>,
        roots: &Roots,
        alpha: f64,
        definite: bool,
    ) -> Option<Self> {
        let mut outboard = [[0.0; STATES]; STATES];
        let mut negative = 0;
        let mut out: Vec<Eliminated> = Vec::with_capacity(elements.len());
        for (index, (element, mut form)) in elements.iter().zip(forms).enumerate().rev() {
            form.add_outer(&element.transfer, |p, q| outboard[p][q]);
            let strains = element.strains();
            let mut pivots = Vec::with_capacity(strains);
            for k in 0..strains {
                let pivot = form.at(k, k);
                if !is_sound(pivot, definite) {
                    return None;
                }
                negative += usize::from(pivot < 0.0);
                for j in k + 1..form.order() {
                    let factor = form.at(j, k) / pivot;
                    if factor != 0.0 {
                        let (own, column) = form.pair(k, j);
                        column[j..].iter_mut().zip(&own[j..]).for_each(|(c, o)| *c -= factor * o);
                    }
                }
                for j in k + 1..form.order() {
                    *form.at_mut(j, k) /= pivot;
                }
                pivots.push(pivot);
            }
            for (p, row) in outboard.iter_mut().enumerate() {
                for (q, entry) in row.iter_mut().enumerate() {
                    *entry = form.at(strains + p.max(q), strains + p.min(q));
                }
            }
            let mut root = Vec::new();
            roots.at[index].held.iter().for_each(|held| clear(&mut outboard, *held));
            let free = roots.free(index);
            for &p in free {
                for &q in free {
                    outboard[p][q] += alpha * roots.spring(p, q);
                }
            }
            for &state in free {
                let pivot = outboard[state][state];
                if !is_sound(pivot, definite) {
                    return None;
                }
                negative += usize::from(pivot < 0.0);
                let column = outboard.map(|row| row[state] / pivot);
                for p in 0..STATES {
                    for q in 0..STATES {
                        if p != state && q != state {
                            outboard[p][q] -= column[p] * column[q] * pivot;
                        }
                    }
                }
                clear(&mut outboard, state);
                root.push((state, pivot, column));
            }
            out.push(Eliminated { lower: form, pivots, root, held: roots.at[index].held.clone() });
        }
        out.reverse();
        Some(Self { elements: out, negative })
    }

    /// Number of negative directions of the form.
    pub fn negative(&self) -> usize {
        self.negative
    }

    /// The answer to loads on the functions of every element, in their place: coefficients of all functions.
    pub fn solve(&self, elements: &[Rc<Element>], vector: &mut [f64]) {
        let mut outboard: State = [0.0; STATES];
        let mut at_roots: Vec<State> = vec![[0.0; STATES]; elements.len()];
        let mut end = vector.len();
        for (index, (element, own)) in elements.iter().zip(&self.elements).enumerate().rev() {
            let from = end - element.count();
            let load = &mut vector[from..end];
            end = from;
            for (row, outboard) in element.transfer.iter().zip(outboard) {
                for (place, factor) in row {
                    load[*place] += factor * outboard;
                }
            }
            let strains = element.strains();
            for k in 0..strains {
                let (value, below) = load[k..].split_first_mut().map_or((0.0, &mut [][..]), |(v, below)| (*v, below));
                axpy(below, -value, &own.lower.column(k)[k + 1..]);
            }
            outboard.copy_from_slice(&load[strains..]);
            own.held.iter().for_each(|held| outboard[*held] = 0.0);
            for (state, _, column) in &own.root {
                let value = outboard[*state];
                at_roots[index][*state] = value;
                for (p, outboard) in outboard.iter_mut().enumerate() {
                    if p != *state {
                        *outboard -= column[p] * value;
                    }
                }
            }
            // What is eliminated loads nothing inboard.
            for (state, _, _) in &own.root {
                outboard[*state] = 0.0;
            }
        }
        let mut state: State = [0.0; STATES];
        let mut from = 0;
        for (index, (element, own)) in elements.iter().zip(&self.elements).enumerate() {
            for (free, pivot, column) in own.root.iter().rev() {
                let others: f64 = (0..STATES).filter(|p| p != free).map(|p| column[p] * state[p]).sum();
                state[*free] = at_roots[index][*free] / pivot - others;
            }
            let solution = &mut vector[from..from + element.count()];
            from += element.count();
            let strains = element.strains();
            solution[strains..].copy_from_slice(&state);
            for k in (0..strains).rev() {
                let column = &own.lower.column(k)[k + 1..];
                solution[k] = solution[k] / own.pivots[k] - dot(column, &solution[k + 1..]);
            }
            state = element.outer_state(solution);
        }
    }
}

/// Takes a state out of a form.
fn clear(form: &mut [State; STATES], state: usize) {
    form[state] = [0.0; STATES];
    for row in form {
        row[state] = 0.0;
    }
}

fn is_sound(pivot: f64, definite: bool) -> bool {
    pivot.is_finite() && (pivot > 0.0 || (!definite && pivot != 0.0))
}
