#![no_std]
//! Solver for the natural frequencies of rotating blades.
