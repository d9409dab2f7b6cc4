//! What a proof leaves behind, so that a stranger's program can check it: plain data, whole numbers as text.
//!
//! A proof that runs inside [`of`] leaves a [`Witness`]; elsewhere it leaves nothing and takes no longer.

mod data;

pub use data::{
    Condition, Cover, Element, Equal, Generator, Identity, Interval, Inverse, Motion, Number, Part,
    Polynomial, Power, Root, Step, Tree, Where, Witness,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Expr, Proof, Ring};

    fn proof() -> Proof {
        let mut ring = Ring::new();
        let x = ring.symbol("x");
        Proof::of("x² − x² = 0", &ring, |p| {
            let square = p.read("x²", Expr::symbol("x") * Expr::symbol("x"))?;
            p.equal("The two", &square, &(&x * &x))
        })
    }

    #[test]
    fn only_what_runs_inside_leaves_a_witness() {
        assert!(proof().holds());
        let (inner, left) = of(|| {
            assert!(proof().holds());
            of(proof).1.len()
        });
        assert_eq!((inner, left.len()), (1, 1));
        assert!(of(|| ()).1.is_empty());
        let Witness::Identity(identity) = &left[0] else {
            panic!("{left:?}");
        };
        // The formula is there, and the product with what it is compared to.
        assert_eq!(identity.equal.len(), 1);
        assert!(matches!(identity.parts[..], [Part::Read(..), Part::Element(..), Part::Product(..)]));
    }
}
