//! What comes in and goes out: files, streams, messages, the terminal.

mod hold;
pub(crate) mod input;
pub(crate) mod measured;
pub(crate) mod messages;
pub(crate) mod output;
mod progress;
mod target;
