//! A sign of life for what takes long.

use core::time::Duration;
use indicatif::{ProgressBar, ProgressStyle};

/// Runs `work` under a spinner on standard error that says `what`; on a terminal only.
pub(crate) fn with<T>(what: String, work: impl FnOnce() -> T) -> T {
    let bar = ProgressBar::new_spinner().with_message(what);
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(120));
    let result = work();
    bar.finish_and_clear();
    result
}
