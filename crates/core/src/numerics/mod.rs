//! Numerical parts that know no blade: scalar functions, quadrature, roots, piecewise-linear
//! functions, eigenproblems, Legendre and Chebyshev polynomials, recursion along the blade, sums over
//! lists.

pub mod chebyshev;
pub mod eigen;
pub mod legendre;
pub mod quadrature;
pub mod recursion;
pub mod roots;
pub mod scalar;
pub mod vector;

mod piecewise_linear;

pub use piecewise_linear::{Linear, PiecewiseLinear};
