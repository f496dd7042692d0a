//! Command line of bladefan.
fn main() {}
