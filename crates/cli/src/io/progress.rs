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
/// The spinner, what is done, and for how long.
const TEMPLATE: &str = "{spinner} {msg} {elapsed}";

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
    match ProgressStyle::with_template(TEMPLATE) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_answer_comes_through() {
        assert_eq!(with("working", || 1 + 1), 2);
        let slow = || {
            thread::sleep(PATIENCE + TICK);
            "done"
        };
        assert_eq!(with("working", slow), "done", "with a sign of life, where there is a terminal");
    }

    #[test]
    fn the_spinner_says_what_is_done() {
        assert!(ProgressStyle::with_template(TEMPLATE).is_ok(), "else it would look like the library's own");
        assert_eq!(spinner("working").message(), "working");
    }
}
