//! Results as text and pictures. Knows nothing of files and terminals.

pub(crate) mod accuracy;
pub(crate) mod columns;
pub(crate) mod csv;
pub(crate) mod heading;
pub(crate) mod json;
pub(crate) mod picture;
pub(crate) mod table;
pub(crate) mod text;
