//! What a trial reads, noted while it runs, so that no name need be believed.

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::panic::Location;
use std::ptr;

/// What was read.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Read {
    /// Formulas, by their paths.
    pub formulas: BTreeSet<&'static str>,
    /// Shared runs, by the places where they are declared.
    pub runs: BTreeSet<&'static Location<'static>>,
    /// How often something failed meanwhile.
    pub failures: usize,
}

/// So many take turns in a motion.
const TURNS: usize = 6;

thread_local! {
    /// Most formulas are read many times, by turns.
    static LAST: Cell<Option<[&'static str; TURNS]>> = const { Cell::new(None) };
    static READ: RefCell<Option<Read>> = const { RefCell::new(None) };
}

struct Before(Option<Read>);

impl Before {
    fn set_aside(now: Option<Read>) -> Self {
        LAST.set(now.as_ref().map(|_| [""; TURNS]));
        Before(READ.replace(now))
    }
}

impl Drop for Before {
    fn drop(&mut self) {
        LAST.set(self.0.as_ref().map(|_| [""; TURNS]));
        READ.set(self.0.take());
    }
}

#[inline]
pub(super) fn note(formula: &'static str) {
    let Some(mut last) = LAST.get() else { return };
    if last.iter().any(|last| ptr::eq(*last, formula)) {
        return;
    }
    last.rotate_right(1);
    last[0] = formula;
    LAST.set(Some(last));
    READ.with_borrow_mut(|read| read.as_mut().map(|read| read.formulas.insert(formula)));
}

/// Notes that shared runs are read on this thread.
pub(crate) fn note_runs(runs: &'static Location<'static>) {
    READ.with_borrow_mut(|read| read.as_mut().map(|read| read.runs.insert(runs)));
}

/// Notes that something fails on this thread.
pub(crate) fn note_failure() {
    READ.with_borrow_mut(|read| read.as_mut().map(|read| read.failures += 1));
}

/// Calls `f`, and says what it has read on this thread.
pub fn of<T>(f: impl FnOnce() -> T) -> (T, Read) {
    let _before = Before::set_aside(Some(Read::default()));
    let value = f();
    (value, READ.take().unwrap_or_default())
}

/// Notes what was read when something used now was made.
pub fn also(read: &Read) {
    READ.with_borrow_mut(|noted| {
        if let Some(noted) = noted {
            noted.formulas.extend(&read.formulas);
            noted.runs.extend(&read.runs);
            noted.failures += read.failures;
        }
    });
}

#[cfg(test)]
mod tests {
    use super::{Read, also, note_runs, of};
    use crate::scalar::Scalar;
    use crate::seeded::formulas;
    use std::collections::BTreeSet;
    use std::panic::Location;

    formulas! {

    symbols &[];

    pub fn first<S: Scalar>(x: S) -> S {
        x + x
    }

    pub fn second<S: Scalar>(x: S) -> S {
        x * x
    }

    }

    #[test]
    fn what_is_read_is_noted_and_what_is_read_for_another_is_not() {
        let place = Location::caller();
        let mut later = Read::default();
        let (_, read) = of(|| {
            first(1.0);
            (_, later) = of(|| {
                note_runs(place);
                second(1.0)
            });
            first(2.0);
        });
        let paths: Vec<_> = formulas::<f64>().iter().map(|f| f.path).collect();
        let expected = [(0, BTreeSet::new()), (1, BTreeSet::from([place]))];
        let expected = expected.map(|(i, runs)| Read {
            formulas: BTreeSet::from([paths[i]]),
            runs,
            failures: 0,
        });
        assert_eq!([read, later.clone()], expected);
        assert_eq!(of(|| also(&later)).1, later);
        assert_eq!(of(|| ()).1, Read::default());
    }
}
