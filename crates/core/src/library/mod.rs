//! The built-in blades.
