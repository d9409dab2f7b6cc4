//! One way in which a claim is tried, as its module lists it and its entry names it.

use super::Excuse;
use super::compare::noted;
use super::points::seated;
use super::statement::Proved;
use crate::evidence::Evidence;
use std::fmt;
use std::panic::Location;

/// A trial or a proof, with its name, and with what the claim that names it excuses it from.
#[derive(Clone, Copy)]
pub struct Attempt {
    pub(super) how: How,
    pub(super) path: &'static str,
    pub(super) place: &'static Location<'static>,
    /// Its claim, and its number there.
    pub(super) seat: u64,
    /// Why it notices no mistake in what it reads, or reads nothing, though it agrees.
    pub idle: Option<&'static str>,
    /// Why it reads no formula of its claim.
    pub elsewhere: Option<&'static str>,
    /// The formulas that may be wrong by twice its tolerance without its noticing, by their names.
    pub coarse: &'static [Excuse],
    /// The formulas of which this proof does not reject every wrong variant, or of another claim's none, by
    /// their names.
    pub spared: &'static [Excuse],
}

#[derive(Clone, Copy)]
pub(super) enum How {
    Measured(fn() -> Evidence),
    Proved(&'static dyn Proved),
}

impl Attempt {
    /// What a function compares; `path` leads to it, or ends so.
    #[track_caller]
    pub const fn measured(trial: fn() -> Evidence, path: &'static str) -> Self {
        Self::of(How::Measured(trial), path)
    }

    /// A statement that is proved.
    #[track_caller]
    pub const fn proved(statement: &'static dyn Proved, path: &'static str) -> Self {
        Self::of(How::Proved(statement), path)
    }

    #[track_caller]
    const fn of(how: How, path: &'static str) -> Self {
        Self {
            how,
            path,
            place: Location::caller(),
            seat: 0,
            idle: None,
            elsewhere: None,
            coarse: &[],
            spared: &[],
        }
    }

    /// The last two names of the path: `near::eq140_motion`, `exact::EQ139`.
    pub fn name(&self) -> &'static str {
        let modules = self.path.rmatch_indices("::").nth(1);
        modules.map_or(self.path, |(at, colons)| &self.path[at + colons.len()..])
    }

    /// The file in which it is written, below the crate's folder: `src/claims/rest/near`.
    pub fn file(&self) -> &'static str {
        let place = self
            .statement()
            .map_or(self.place, |statement| statement.place());
        place.file().trim_end_matches(".rs")
    }

    /// The statement of a proof.
    pub fn statement(&self) -> Option<&'static dyn Proved> {
        match self.how {
            How::Measured(_) => None,
            How::Proved(statement) => Some(statement),
        }
    }

    /// What it brings, and which formulas it has read for it.
    pub fn evidence(&self) -> Evidence {
        let brought = || match self.how {
            How::Measured(trial) => trial(),
            How::Proved(statement) => statement.evidence(),
        };
        let evidence = noted(|| seated(self.seat, brought));
        Evidence {
            trial: self.name(),
            ..evidence
        }
    }
}

impl fmt::Debug for Attempt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The list of a module's trials: functions, and by reference statements that are proved; or what they are,
/// behind their names: `eq6_motion = tried(eq6_top, top)`, `&EQ1 = law(eq1_speed)`. Claims name them with the
/// module: `time::eq13_motion`, `exact::EQ13`. What is printed and what corrects it are one row, `eq75 | corrected75 =
/// spin((…) | (…))`: the [`Subject`](crate::evidence::Subject) comes first, then what both share, `at_turns(TIME)((…) | (…))`, and
/// what is each one's own.
#[macro_export]
macro_rules! trials {
    (@ [$($done:expr,)*] $(,)?) => {
        &[$($done),*]
    };
    (@ [$($done:expr,)*] $printed:ident | $corrected:ident =
        $($row:ident)::+ (($($first:tt)*) | ($($second:tt)*)), $($rest:tt)*
    ) => {
        $crate::trials::attempt::trials!(@ [$($done,)*]
            $printed | $corrected = $($row)::+()(($($first)*) | ($($second)*)), $($rest)*
        )
    };
    (@ [$($done:expr,)*] $printed:ident | $corrected:ident =
        $($row:ident)::+ ($($shared:expr),*)(($($first:expr),* $(,)?) | ($($second:expr),* $(,)?)), $($rest:tt)*
    ) => {
        $crate::trials::attempt::trials!(@ [$($done,)*]
            $printed = $crate::trials::attempt::trials!(@row $($row)::+ [Printed $(, $shared)*] [$($first),*]),
            $corrected = $crate::trials::attempt::trials!(@row $($row)::+ [Corrected $(, $shared)*] [$($second),*]),
            $($rest)*
        )
    };
    (@ [$($done:expr,)*] &$printed:ident | &$corrected:ident =
        $($row:ident)::+ ($($shared:expr),*)(($($first:expr),* $(,)?) | ($($second:expr),* $(,)?)), $($rest:tt)*
    ) => {
        $crate::trials::attempt::trials!(@ [$($done,)*]
            &$printed = $crate::trials::attempt::trials!(@row $($row)::+ [Printed $(, $shared)*] [$($first),*]),
            &$corrected = $crate::trials::attempt::trials!(@row $($row)::+ [Corrected $(, $shared)*] [$($second),*]),
            $($rest)*
        )
    };
    (@row $($row:ident)::+ [$subject:ident $(, $shared:expr)*] [$($own:expr),*]) => {
        $($row)::+($crate::evidence::Subject::$subject, $($shared,)* $($own),*)
    };
    (@ [$($done:expr,)*] & $name:ident = $statement:expr, $($rest:tt)*) => {
        $crate::trials::attempt::trials!(@ [
            $($done,)*
            $crate::trials::attempt::Attempt::proved(
                const { &$statement },
                concat!(module_path!(), "::", stringify!($name)),
            ),
        ] $($rest)*)
    };
    (@ [$($done:expr,)*] $name:ident = $trial:expr, $($rest:tt)*) => {
        $crate::trials::attempt::trials!(@ [
            $($done,)*
            $crate::trials::attempt::Attempt::measured(
                || $trial,
                concat!(module_path!(), "::", stringify!($name)),
            ),
        ] $($rest)*)
    };
    (@ [$($done:expr,)*] & $statement:ident, $($rest:tt)*) => {
        $crate::trials::attempt::trials!(@ [$($done,)*] &$statement = $statement, $($rest)*)
    };
    (@ [$($done:expr,)*] $trial:ident, $($rest:tt)*) => {
        $crate::trials::attempt::trials!(@ [$($done,)*] $trial = $trial(), $($rest)*)
    };
    ($($all:tt)*) => {
        $crate::trials::attempt::trials!(@ [] $($all)*,)
    };
}

pub use trials;
