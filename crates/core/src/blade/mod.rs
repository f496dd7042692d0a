//! The blade: as given (definition), in other units (convert), changed (change), and as checked (model).

mod change;
mod check;
mod convert;
mod definition;
mod in_code;
mod model;
mod property;
mod range;
mod restation;
mod section;
mod tension;

pub use change::{Amount, Change, Changed, Part, What, change};
pub use check::check;
#[cfg(feature = "formats")]
pub(crate) use check::choice_fault;
pub use convert::convert;
pub use definition::{
    BladeDefinition, DistributionDefinition, PointMassDefinition, PropertyDefinition, RootDefinition, RootKind,
    RotorDefinition, Source, SpringAngle,
};
pub use model::{Blade, PointMass, PropellerMoment, Racket, Root, RootCondition};
pub use property::Property;
pub use section::{Place, Section, Stretch, stretches};
pub use tension::moments;
