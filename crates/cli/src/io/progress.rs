//! A sign of life for what takes long.

use core::time::Duration;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;

/// What takes less than this needs no sign.
const PATIENCE: Duration = Duration::from_millis(400);
/// Between two pictures of the spinner.
const TICK: Duration = Duration::from_millis(120);

/// Runs `work`; where it takes long, under a spinner on standard error that says `what` and for how
/// long. On a terminal only.
pub(crate) fn with<T>(what: &'static str, work: impl FnOnce() -> T) -> T {
    if !io::stderr().is_terminal() {
        return work();
    }
    let (working, wait) = mpsc::channel::<()>();
    thread::scope(|scope| {
        scope.spawn(move || {
            if wait.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                let bar = spinner(what);
                bar.enable_steady_tick(TICK);
                // Nothing is ever sent: this ends when the other end goes.
                let _ = wait.recv();
                bar.finish_and_clear();
            }
        });
        let result = work();
        drop(working);
        result
    })
}

fn spinner(what: &'static str) -> ProgressBar {
    let bar = ProgressBar::new_spinner().with_message(what);
    match ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
