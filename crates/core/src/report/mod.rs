//! What a question answers: the JSON of the command line and the objects of the page.
//! Frequencies and speeds are in rad/s unless the name says otherwise.

/// Declares a result type: public fields, `Debug`, `Clone`, and `Serialize` where asked for.
macro_rules! report {
    ($(#[$doc:meta])* $name:ident { $($(#[$fdoc:meta])* $field:ident: $type:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        pub struct $name { $($(#[$fdoc])* pub $field: $type),+ }
    };
}

mod basis;
mod compare;
mod converge;
mod coupled;
mod fan;
mod model;
mod modes;
mod shapes;
mod summary;

pub use basis::{BasisReport, FunctionCounts};
pub use compare::{ComparedPoint, MeasuredPoint};
pub use converge::{ConvergeReport, ConvergeSeries};
pub use coupled::{
    BendingComponent, Components, CoupledModeReport, CoupledModesReport, CoupledShapeReport, CoupledShapesReport,
    Shares, TorsionComponent,
};
pub use fan::{Branch, BranchLabel, Coincidence, Crossing, FanChart, ModeAtSpeed, Nominal, Southwell, VeeringReport};
pub use model::ModelReport;
pub use modes::{Margin, ModeReport, ModesReport};
pub use shapes::{ShapeReport, ShapesReport};
pub use summary::{BladeSummary, DofSummary};
