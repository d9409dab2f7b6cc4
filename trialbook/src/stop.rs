//! Ctrl-C: long work ends after the piece that it is at, and what is written is whole.

use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// Exit code of work that was stopped, as shells have it.
pub const STOPPED: u8 = 130;

/// Whether somebody has asked to stop, since `listen` was called.
pub fn is_asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// Takes Ctrl-C as a wish to stop, and a second one as an order.
///
/// # Errors
/// What the system says where it lets nobody listen.
#[cfg(feature = "book")]
pub fn listen() -> Result<(), ctrlc::Error> {
    static LISTENS: std::sync::Once = std::sync::Once::new();
    let mut heard = Ok(());
    LISTENS.call_once(|| {
        heard = ctrlc::set_handler(|| {
            if ASKED.swap(true, Ordering::Relaxed) {
                std::process::exit(STOPPED.into());
            }
        });
    });
    heard
}
