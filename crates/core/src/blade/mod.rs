//! The blade: as given (definition), in other units (convert), and as checked (model).

mod check;
mod convert;
mod definition;
mod model;
mod tension;

pub use check::check;
#[cfg(feature = "formats")]
pub(crate) use check::{Shortest, choice_fault, shortest};
pub use convert::convert;
pub use definition::{
    BladeDefinition, DistributionDefinition, PropertyDefinition, RootDefinition, RootKind, RotorDefinition, Source,
};
pub use model::{Blade, Root, RootCondition};
pub use tension::{Tension, moments, tension_inside};
