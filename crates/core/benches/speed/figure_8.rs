//! The paper's Fig. 8: time of a complete analysis against the number of functions, for each degree
//! of freedom of both of its small blades, by this solver and by the paper's march on the same matrices.

use crate::{MODES, best, built_in, march, matrices_of};
use bladefan_core::Dof;
use bladefan_core::internals::solve;
use core::hint::black_box;

/// Prints the times [ms] as CSV.
pub(crate) fn print() {
    println!(
        "# Times in ms, one core, best of 101 runs (march: of 11), five modes, the march in steps of 2.5 rad/s and \
         bisection to 1e-15: `scripts/reproduce-paper --times`."
    );
    println!("blade,dof,functions,assembly,solve,march");
    for (name, speed) in [("tm4760", 69.115), ("hingeless-1000", 105.0)] {
        let blade = built_in(name);
        for dof in Dof::ALL {
            for count in (5..=40).step_by(5) {
                let assembly = best(101, || drop(black_box(matrices_of(black_box(&blade), dof, count))));
                let matrices = matrices_of(&blade, dof, count);
                let ours = best(101, || drop(black_box(solve(black_box(&matrices), speed * speed, MODES).unwrap())));
                let theirs = best(11, || drop(black_box(march::frequencies(black_box(&matrices), speed, MODES))));
                let [assembly, ours, theirs] = [assembly, ours, theirs].map(|seconds| 1e3 * seconds);
                println!("{name},{dof},{count},{assembly:.4},{ours:.4},{theirs:.3}");
            }
        }
    }
}
