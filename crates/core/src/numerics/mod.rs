//! Numerical parts that know no blade: scalar functions, quadrature, roots, piecewise-linear
//! functions, eigenproblems, Chebyshev interpolation.

pub mod chebyshev;
pub mod eigen;
pub mod quadrature;
pub mod roots;
pub mod scalar;

mod piecewise_linear;

pub use piecewise_linear::PiecewiseLinear;
