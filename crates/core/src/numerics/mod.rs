//! Numerical parts that know no blade: scalar functions, quadrature, roots, piecewise-linear
//! functions, eigenproblems.

mod piecewise_linear;

pub use piecewise_linear::PiecewiseLinear;
