//! Modes of a coupled blade at one speed.

use super::{BasisReport, Margin, ModelReport};
use crate::dof::Dof;
use crate::fault::Warning;
use crate::label::Label;
use alloc::string::String;
use alloc::vec::Vec;

report! {
    /// How much of a mode's kinetic energy about the mass centre is in each motion; in sum 1.
    Shares {
        /// Flap.
        flap: f64,
        /// Lag.
        lag: f64,
        /// Torsion.
        torsion: f64,
    }
}
report! {
    /// One mode of a coupled blade.
    CoupledModeReport {
        /// `2F`, `1T`; `3F/T` where it is mixed.
        label: Label,
        /// The motion with the largest share.
        dof: Dof,
        /// Number among the modes with that leading motion, mixed or not, from 1.
        number: usize,
        /// Whether no motion has three fifths.
        mixed: bool,
        /// Shares of the three motions.
        shares: Shares,
        /// Natural frequency; `None` where unstable.
        frequency_rad_s: Option<f64>,
        /// The same in Hz.
        frequency_hz: Option<f64>,
        /// The same per revolution; `None` at rest.
        per_rev: Option<f64>,
        /// Integer nearest to `per_rev`, at least 1.
        nearest_harmonic: Option<u32>,
        /// `per_rev` less `nearest_harmonic`.
        margin_per_rev: Option<f64>,
        /// λ = ω² [rad²/s²], negative where unstable.
        eigenvalue_s2: f64,
        /// Whether λ < 0: divergence.
        unstable: bool,
        /// Proven lower bound; `None` without proof or where λ may be negative.
        lower_rad_s: Option<f64>,
        /// Proven upper bound.
        upper_rad_s: Option<f64>,
        /// Proven lower bound of λ.
        lower_eigenvalue_s2: Option<f64>,
        /// Proven upper bound of λ.
        upper_eigenvalue_s2: Option<f64>,
        /// Why there are no bounds: `separation not proven` or `no shift`.
        bounds_missing: Option<&'static str>,
        /// Where there are none: an estimate of the error, which is no bound.
        error_estimate_rad_s: Option<f64>,
        /// √ρ: so many eigenvalues as are bounded are proven to lie below it.
        separation_rad_s: Option<f64>,
        /// The paper's functions, as many as `--functions` says; `None` where they are too few or it is unstable.
        classical_rad_s: Option<f64>,
        /// The piecewise functions.
        converged_rad_s: Option<f64>,
    }
}
report! {
    /// Modes of a coupled blade at one speed, ascending.
    CoupledModesReport {
        /// `bladefan-modes/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Rotor speed.
        speed_rad_s: f64,
        /// What acts.
        model: ModelReport,
        /// Assumed functions.
        basis: BasisReport,
        /// How many of the paper's functions of each motion are behind `classical_rad_s`.
        classical_functions: usize,
        /// The modes.
        modes: Vec<CoupledModeReport>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
impl CoupledModesReport {
    /// How far each mode is from the nearest harmonic; nothing at rest.
    pub fn margins(&self) -> Vec<Margin> {
        let margin = |mode: &CoupledModeReport| {
            Some(Margin {
                label: mode.label,
                branch: None,
                per_rev: mode.per_rev?,
                nearest_harmonic: mode.nearest_harmonic?,
                margin_per_rev: mode.margin_per_rev?,
            })
        };
        self.modes.iter().filter_map(margin).collect()
    }
}

report! {
    /// One bending motion of a coupled mode along the span; 0 inboard of its root.
    #[derive(Default)]
    BendingComponent {
        /// Displacement, flap out of the disc plane and lag in it, forward.
        displacement: Vec<f64>,
        /// Slope [1/m].
        slope: Vec<f64>,
        /// Bending moment about the same fixed axes [N·m], from equilibrium.
        moment: Vec<f64>,
        /// Force along the displacement that the part outboard hands inboard [N], from equilibrium.
        force: Vec<f64>,
    }
}
report! {
    /// Torsion of a coupled mode along the span; 0 inboard of its root.
    #[derive(Default)]
    TorsionComponent {
        /// Twist about the elastic axis, nose up [rad].
        twist: Vec<f64>,
        /// Torque [N·m], from equilibrium.
        moment: Vec<f64>,
    }
}
report! {
    /// The three motions of a coupled mode.
    #[derive(Default)]
    Components {
        /// Flap.
        flap: BendingComponent,
        /// Lag.
        lag: BendingComponent,
        /// Torsion.
        torsion: TorsionComponent,
    }
}
impl Components {
    /// Displacement or twist of one motion.
    pub fn leading(&self, dof: Dof) -> &[f64] {
        match dof {
            Dof::Flap => &self.flap.displacement,
            Dof::Lag => &self.lag.displacement,
            Dof::Torsion => &self.torsion.twist,
        }
    }
}

report! {
    /// One mode shape of a coupled blade, scaled so that the leading motion is at most 1 (m or rad) and positive at
    /// the tip, or to unit modal mass.
    CoupledShapeReport {
        /// `2F`, `3F/T`.
        label: Label,
        /// The motion with the largest share.
        dof: Dof,
        /// Number among the modes with that leading motion.
        number: usize,
        /// Shares of the three motions.
        shares: Shares,
        /// Natural frequency; `None` where unstable.
        frequency_rad_s: Option<f64>,
        /// Radii where the leading motion passes through zero between root and tip [m], ascending.
        nodes_m: Vec<f64>,
        /// The three motions.
        components: Components,
    }
}
report! {
    /// Mode shapes of a coupled blade at one speed.
    CoupledShapesReport {
        /// `bladefan-shapes/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Rotor speed.
        speed_rad_s: f64,
        /// What acts.
        model: ModelReport,
        /// Assumed functions.
        basis: BasisReport,
        /// Radii from the least offset to the tip, ends included.
        r_m: Vec<f64>,
        /// Tip radius.
        radius_m: f64,
        /// The shapes, ascending by frequency.
        shapes: Vec<CoupledShapeReport>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
