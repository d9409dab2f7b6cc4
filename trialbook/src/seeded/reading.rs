//! Which formulas a trial reads: noted while it runs, so that no name of a formula need be believed.

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::ptr;

thread_local! {
    /// The formula read last, while anything watches.
    static LAST: Cell<Option<&'static str>> = const { Cell::new(None) };
    static READ: RefCell<Option<BTreeSet<&'static str>>> = const { RefCell::new(None) };
}

/// What was noted before, until it is put back.
struct Before(Option<BTreeSet<&'static str>>);

impl Before {
    fn set_aside(now: Option<BTreeSet<&'static str>>) -> Self {
        LAST.set(now.as_ref().map(|_| ""));
        Before(READ.replace(now))
    }
}

impl Drop for Before {
    fn drop(&mut self) {
        LAST.set(self.0.as_ref().map(|_| ""));
        READ.set(self.0.take());
    }
}

/// Notes that a formula is read on this thread.
#[inline]
pub(super) fn note(formula: &'static str) {
    // Most are read many times in a row.
    if LAST.get().is_some_and(|last| !ptr::eq(last, formula)) {
        LAST.set(Some(formula));
        READ.with_borrow_mut(|read| read.as_mut().map(|read| read.insert(formula)));
    }
}

/// Calls `f`, and says which formulas it has read on this thread: their paths.
pub fn of<T>(f: impl FnOnce() -> T) -> (T, BTreeSet<&'static str>) {
    let _before = Before::set_aside(Some(BTreeSet::new()));
    let value = f();
    (value, READ.take().unwrap_or_default())
}

/// Notes formulas that were read when something was derived that is used now.
pub fn also(read: &BTreeSet<&'static str>) {
    READ.with_borrow_mut(|noted| noted.as_mut().map(|noted| noted.extend(read)));
}

#[cfg(test)]
mod tests {
    use super::{also, of};
    use crate::scalar::Scalar;
    use crate::seeded::formulas;
    use std::collections::BTreeSet;

    formulas! {

    symbols &[];

    /// One formula.
    pub fn first<S: Scalar>(x: S) -> S {
        x + x
    }

    /// Another.
    pub fn second<S: Scalar>(x: S) -> S {
        x * x
    }

    }

    #[test]
    fn what_is_read_is_noted_and_what_is_read_for_another_is_not() {
        let mut later = BTreeSet::new();
        let (_, read) = of(|| {
            first(1.0);
            (_, later) = of(|| second(1.0));
            first(2.0);
        });
        let paths: Vec<_> = formulas::<f64>().iter().map(|f| f.path).collect();
        assert_eq!(
            [read, later.clone()],
            [0, 1].map(|i| BTreeSet::from([paths[i]]))
        );
        assert_eq!(of(|| also(&later)).1, later);
        assert!(of(|| ()).1.is_empty());
    }
}
