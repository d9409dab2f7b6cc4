//! What several trials share: motions that are followed once, and why one could not be.

use super::points::shared;
use crate::certified::error::CertifiedError;
use crate::numerics::NumericsError;
use crate::seeded;
use crate::seeded::reading::{self, Read};
use std::error::Error;
use std::fmt::{self, Display};
use std::num::ParseFloatError;
use std::panic::Location;
use std::sync::{Arc, OnceLock};

/// Why our own side gave no number.
#[derive(Debug, Clone)]
pub struct Failure(Arc<dyn Error + Send + Sync>);

impl Failure {
    /// An error as the reason.
    pub fn of(error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        reading::note_failure();
        Failure(error.into().into())
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Error for Failure {}

/// Makes a [`Failure`] of each of these errors.
#[macro_export]
macro_rules! failures {
    ($($error:ty),* $(,)?) => {
        $(impl From<$error> for $crate::trials::runs::Failure {
            fn from(error: $error) -> Self {
                $crate::trials::runs::Failure::of(error)
            }
        })*
    };
}

pub use failures;

failures!(&str, String, ParseFloatError, CertifiedError, NumericsError);

/// What is set up and has not moved yet, such as a drive: who uses it has read nothing.
pub trait Setting {}

/// Motions and their like, made when first asked for. Not the values of formulas: a mistake seeded later
/// would not reach them.
#[derive(Debug)]
pub struct Runs<T: 'static> {
    made: OnceLock<(Result<T, Failure>, Read)>,
    make: fn() -> Result<T, Failure>,
    /// Tells them apart; none where they are a setting.
    place: Option<&'static Location<'static>>,
}

impl<T> Runs<T> {
    /// Runs that `make` makes.
    #[track_caller]
    pub const fn new(make: fn() -> Result<T, Failure>) -> Self {
        Runs {
            made: OnceLock::new(),
            make,
            place: Some(Location::caller()),
        }
    }

    /// What is only set up: who uses it has read no run.
    pub const fn setting(make: fn() -> Result<T, Failure>) -> Self
    where
        T: Setting,
    {
        Runs {
            made: OnceLock::new(),
            make,
            place: None,
        }
    }

    /// The runs. Who asks is noted to have read them, and those that they are made from.
    ///
    /// # Errors
    /// Why there are none; a formula that was read in making them is a reason too.
    pub fn get(&self) -> Result<&T, Failure> {
        let made = || match reading::of(|| shared(self.make)) {
            (made, read) if read.formulas.is_empty() => (made, read),
            (_, read) => {
                let formulas = &read.formulas;
                let error = format!("runs that are shared have read {formulas:?}");
                (Err(error.into()), read)
            }
        };
        let (made, read) = self.made.get_or_init(made);
        reading::also(read);
        if let Some(place) = self.place {
            reading::note_runs(place);
        }
        made.as_ref().map_err(Failure::clone)
    }
}

/// What is derived from formulas once: who asks has read them. While a mistake is seeded in one, it is
/// derived anew.
#[derive(Debug)]
pub struct Derived<T: 'static> {
    made: OnceLock<(T, Read)>,
    make: fn() -> T,
}

impl<T> Derived<T> {
    /// What `make` derives.
    pub const fn new(make: fn() -> T) -> Self {
        Derived {
            made: OnceLock::new(),
            make,
        }
    }

    /// Hands out what is derived.
    pub fn with<R>(&self, then: impl FnOnce(&T) -> R) -> R {
        let made = || seeded::without(|| reading::of(|| shared(self.make)));
        let (made, read) = self.made.get_or_init(made);
        reading::also(read);
        if seeded::is_in_any(&read.formulas) {
            return then(&shared(self.make));
        }
        then(made)
    }
}

/// All of what is found, or why one is not.
///
/// # Errors
/// The first.
pub fn every<T, E: Into<Failure>>(
    found: impl IntoIterator<Item = Result<T, E>>,
) -> Result<Vec<T>, Failure> {
    let found = found.into_iter();
    found.map(|one| one.map_err(Into::into)).collect()
}

/// One part after the other of what is found, or the reason.
pub fn parts<I: IntoIterator, E: Into<Failure>>(
    whole: Result<I, E>,
) -> impl Iterator<Item = Result<I::Item, Failure>> {
    let (parts, failure) = match whole {
        Ok(parts) => (Some(parts), None),
        Err(failure) => (None, Some(Err(failure.into()))),
    };
    parts.into_iter().flatten().map(Ok).chain(failure)
}

/// Each run with each of these, in turn.
pub fn with_each<T: Clone, X: Copy, const N: usize>(
    runs: impl Iterator<Item = Result<T, Failure>>,
    all: [X; N],
) -> impl Iterator<Item = Result<(T, X), Failure>> {
    runs.flat_map(move |run| all.map(|one| run.clone().map(|run| (run, one))))
}

/// The runs of which this holds; a failure stays in its place.
pub fn only<T, E>(
    runs: impl Iterator<Item = Result<T, E>>,
    wanted: impl Fn(&T) -> bool,
) -> impl Iterator<Item = Result<T, E>> {
    runs.filter(move |run| run.as_ref().map_or(true, &wanted))
}

impl<T> Runs<Vec<T>> {
    /// One run after the other, or the reason.
    pub fn each(&'static self) -> impl Iterator<Item = Result<&'static T, Failure>> {
        parts(self.get())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;
    use crate::seeded::{Mistake, Seed, formulas};
    use std::collections::BTreeSet;
    use std::sync::atomic::{AtomicUsize, Ordering};

    formulas! {

    symbols &[];

    pub fn twice<S: Scalar>(x: S) -> S {
        x + x
    }

    }

    #[test]
    fn runs_that_are_made_of_a_formula_are_none() {
        static MOTION: Runs<f64> = Runs::new(|| Ok(6.0));
        static VALUE: Runs<f64> = Runs::new(|| Ok(twice(3.0)));
        assert_eq!(*MOTION.get().unwrap(), 6.0);
        let why = VALUE.get().unwrap_err().to_string();
        assert!(why.contains("have read") && why.contains("twice"), "{why}");
    }

    #[test]
    fn what_is_derived_of_a_formula_is_derived_anew_with_a_mistake_in_it() {
        static DERIVED: Derived<f64> = Derived::new(|| twice(3.0));
        let value = || DERIVED.with(|six| *six);
        let path = formulas::<f64>()[0].path;
        let wrong = Seed::of_value(path, Mistake::Part(2));
        assert_eq!(
            [value(), seeded::with(wrong, value), value()],
            [6.0, 9.0, 6.0]
        );
    }

    #[test]
    fn what_is_derived_is_derived_once() {
        static MADE: AtomicUsize = AtomicUsize::new(0);
        static DERIVED: Derived<()> = Derived::new(|| _ = MADE.fetch_add(1, Ordering::Relaxed));
        for _ in 0..3 {
            DERIVED.with(|()| ());
        }
        assert_eq!(MADE.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn a_run_that_cannot_be_made_is_a_trial_that_fails() {
        static TWO: Runs<Vec<f64>> = Runs::new(|| Ok(vec![1.0, 2.0]));
        static NONE: Runs<Vec<f64>> = Runs::new(|| Err("it does not move".into()));
        let found = |runs: &'static Runs<Vec<f64>>| -> Vec<_> {
            let each = runs.each().map(|run| run.copied());
            each.map(|run| run.map_err(|why| why.to_string())).collect()
        };
        assert_eq!(found(&TWO), [Ok(1.0), Ok(2.0)]);
        for _ in 0..2 {
            assert_eq!(found(&NONE), [Err("it does not move".to_owned())]);
        }
    }

    #[test]
    fn what_went_into_shared_runs_is_noted_by_all_who_use_them() {
        struct Set(f64);
        impl Setting for Set {}
        static SETTING: Runs<Set> = Runs::setting(|| Ok(Set(1.0)));
        static FIRST: Runs<f64> = Runs::new(|| Ok(2.0 * SETTING.get()?.0));
        static SECOND: Runs<f64> = Runs::new(|| Ok(3.0 * FIRST.get()?));
        static THIRD: Runs<Vec<f64>> = Runs::new(|| Ok(vec![5.0 * SECOND.get()?]));
        static DERIVED: Derived<f64> = Derived::new(|| twice(SECOND.get().map_or(0.0, |x| *x)));
        let places = |runs: &[Option<&'static Location<'static>>]| -> BTreeSet<_> {
            runs.iter().flatten().copied().collect()
        };
        let (first, second, third) = (FIRST.place, SECOND.place, THIRD.place);
        for _ in 0..2 {
            let (value, read) = reading::of(|| THIRD.each().next().map(|run| *run.unwrap()));
            assert_eq!(
                (value, read.runs),
                (Some(30.0), places(&[first, second, third]))
            );
            let (value, read) = reading::of(|| *SECOND.get().unwrap());
            assert_eq!((value, read.runs), (6.0, places(&[first, second])));
            let (value, read) = reading::of(|| DERIVED.with(|x| *x));
            assert_eq!((value, read.runs), (12.0, places(&[first, second])));
            assert!(read.formulas.contains(formulas::<f64>()[0].path));
            let (_, read) = reading::of(|| SETTING.get().unwrap().0);
            assert_eq!(read, Read::default());
        }
    }
}
