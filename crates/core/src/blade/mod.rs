//! The blade: as given (definition), and as checked (model).

mod definition;
mod model;

pub use definition::{
    BladeDefinition, DistributionDefinition, PropertyDefinition, RootDefinition, RootKind, RotorDefinition, Source,
};
pub use model::{Blade, Root, RootCondition};
