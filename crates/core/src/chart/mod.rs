//! Drawings: fan chart, mode shapes and convergence as SVG. Draws, computes no physics.
