//! The blade: as given (definition), and as checked (model).

mod definition;
mod model;
mod tension;

pub use definition::{
    BladeDefinition, DistributionDefinition, PropertyDefinition, RootDefinition, RootKind, RotorDefinition, Source,
};
pub use model::{Blade, Root, RootCondition};
pub use tension::{Tension, moments};
