//! Interrupts held back for a moment.

/// While this lives, an interrupt (Ctrl-C, `kill`) waits: so short that nobody notices, and no
/// half-written file is left behind. What came meanwhile takes effect when it goes.
#[derive(Debug)]
pub(super) struct Hold {
    /// The signals that were held back before.
    #[cfg(unix)]
    before: Option<nix::sys::signal::SigSet>,
}

#[cfg(unix)]
impl Hold {
    pub(super) fn new() -> Self {
        use nix::sys::signal::{SigSet, SigmaskHow, Signal};
        let ends = SigSet::from_iter([Signal::SIGHUP, Signal::SIGINT, Signal::SIGQUIT, Signal::SIGTERM]);
        Self { before: ends.thread_swap_mask(SigmaskHow::SIG_BLOCK).ok() }
    }
}

#[cfg(unix)]
impl Drop for Hold {
    fn drop(&mut self) {
        // It was set a moment ago: setting it back does not fail.
        let _ = self.before.map(|before| before.thread_set_mask());
    }
}

/// Elsewhere an interrupt ends the program at once.
#[cfg(not(unix))]
impl Hold {
    pub(super) fn new() -> Self {
        Self {}
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use nix::sys::signal::{SigSet, Signal, raise};

    #[test]
    fn an_interrupt_waits() {
        let hold = Hold::new();
        raise(Signal::SIGTERM).unwrap();
        // Still here. The signal is taken away before it takes effect.
        assert_eq!(SigSet::from(Signal::SIGTERM).wait().unwrap(), Signal::SIGTERM);
        drop(hold);
        let held = SigSet::thread_get_mask().unwrap();
        assert!(!held.contains(Signal::SIGTERM), "and is no longer held back");
    }
}
