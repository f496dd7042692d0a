//! The assumed functions behind a result.

use crate::dof::Dof;
use crate::functions::BasisFamily;

report! {
    /// How many assumed functions each degree of freedom was given; `None` where it was not asked for.
    #[derive(Copy, Default)]
    FunctionCounts {
        /// Flap.
        flap: Option<usize>,
        /// Lag.
        lag: Option<usize>,
        /// Torsion.
        torsion: Option<usize>,
    }
}
impl FunctionCounts {
    /// Sets the number of one degree of freedom.
    pub fn set(&mut self, dof: Dof, count: usize) {
        match dof {
            Dof::Flap => self.flap = Some(count),
            Dof::Lag => self.lag = Some(count),
            Dof::Torsion => self.torsion = Some(count),
        }
    }

    /// Those of some degrees of freedom; `counts` has all three.
    pub fn of(dofs: &[Dof], counts: [usize; 3]) -> Self {
        let mut all = Self::default();
        for dof in dofs {
            all.set(*dof, counts[dof.index()]);
        }
        all
    }

    /// Those asked for, in the order flap, lag, torsion.
    pub fn known(&self) -> impl Iterator<Item = (Dof, usize)> + Clone {
        let counts = [self.flap, self.lag, self.torsion];
        Dof::ALL.into_iter().zip(counts).filter_map(|(dof, count)| Some((dof, count?)))
    }
}
report! {
    /// The assumed functions behind a result.
    #[derive(Copy)]
    BasisReport {
        /// Family.
        family: BasisFamily,
        /// Number of functions.
        functions: FunctionCounts,
    }
}
