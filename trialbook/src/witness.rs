//! What a proof leaves behind, so that a stranger's program can check it: plain data, whole numbers as text.
//!
//! A proof that runs inside [`of`] leaves a [`Witness`]; elsewhere it leaves nothing and takes no longer.

mod data;

pub use data::{
    Case, Condition, Cover, Element, Equal, Generator, Identity, Interval, Inverse, Motion, Number,
    Part, Piece, Polynomial, Power, Root, Step, Tree, Where, Witness,
};

use std::cell::{Cell, RefCell};

thread_local! {
    /// Which recording runs on this thread; 0 for none.
    static RECORDING: Cell<u32> = const { Cell::new(0) };
    static LAST: Cell<u32> = const { Cell::new(0) };
    static LEFT: RefCell<Vec<Witness>> = const { RefCell::new(Vec::new()) };
}

/// The number of the recording that runs on this thread, or 0.
#[inline]
pub fn recording() -> u32 {
    RECORDING.get()
}

/// What was recorded before, until it is put back.
struct Before(u32, Vec<Witness>);

impl Drop for Before {
    fn drop(&mut self) {
        RECORDING.set(self.0);
        LEFT.set(std::mem::take(&mut self.1));
    }
}

/// Calls `f`, and says what the proofs in it left on this thread.
pub fn of<T>(f: impl FnOnce() -> T) -> (T, Vec<Witness>) {
    let next = LAST.get() + 1;
    LAST.set(next);
    let _before = Before(RECORDING.replace(next), LEFT.take());
    let value = f();
    (value, LEFT.take())
}

/// Leaves a witness, if anybody wants one.
pub fn leave(witness: impl FnOnce() -> Witness) {
    if recording() != 0 {
        let witness = witness();
        LEFT.with_borrow_mut(|left| left.push(witness));
    }
}

/// Leaves a witness that speaks of the root that was left last, if there is one.
pub fn last_root(witness: impl FnOnce(usize) -> Witness) {
    let is_root = |witness: &Witness| matches!(witness, Witness::Root(_));
    let last = LEFT.with_borrow(|left| left.iter().rposition(is_root));
    if let Some(root) = last {
        leave(|| witness(root));
    }
}
