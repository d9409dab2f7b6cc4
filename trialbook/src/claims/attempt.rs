//! One way in which a claim is tried, as its row names it.

use super::compare::noted;
use super::statement::Proved;
use crate::evidence::Evidence;
use std::fmt;

/// A trial or a proof, with its name, and with what it is excused from. An excuse says why; a test asks that it is needed.
#[derive(Clone, Copy)]
pub struct Attempt {
    how: How,
    /// The path of the function, from the crate on, or the statement's as the row has it.
    name: fn() -> &'static str,
    /// Why it notices no mistake in what it reads, or reads nothing, though it agrees: what of the claim no formula says.
    pub idle: Option<&'static str>,
    /// Why it reads no formula of its claim.
    pub elsewhere: Option<&'static str>,
    /// The formulas of its claim that may be wrong by twice its tolerance without its noticing, by their names, each with why.
    pub coarse: &'static [(&'static str, &'static str)],
}

#[derive(Clone, Copy)]
enum How {
    Measured(fn() -> Evidence),
    Proved(&'static dyn Proved),
}

impl Attempt {
    /// What a function compares; `name` gives its path.
    pub const fn measured(trial: fn() -> Evidence, name: fn() -> &'static str) -> Self {
        Self::of(How::Measured(trial), name)
    }

    /// A statement that is proved.
    pub const fn proved(statement: &'static dyn Proved, name: fn() -> &'static str) -> Self {
        Self::of(How::Proved(statement), name)
    }

    const fn of(how: How, name: fn() -> &'static str) -> Self {
        Self {
            how,
            name,
            idle: None,
            elsewhere: None,
            coarse: &[],
        }
    }

    /// The same, which need notice no mistake.
    pub const fn idle(self, why: &'static str) -> Self {
        let idle = Some(why);
        Self { idle, ..self }
    }

    /// The same, which need read no formula of its claim.
    pub const fn elsewhere(self, why: &'static str) -> Self {
        let elsewhere = Some(why);
        Self { elsewhere, ..self }
    }

    /// The same, which need not notice slight mistakes in these formulas of its claim.
    pub const fn coarse(self, coarse: &'static [(&'static str, &'static str)]) -> Self {
        Self { coarse, ..self }
    }

    /// The last two names of the path: `near::eq140_motion`, `exact::EQ139`.
    pub fn name(&self) -> &'static str {
        let path = (self.name)();
        let modules = path.rmatch_indices("::").nth(1);
        modules.map_or(path, |(at, colons)| &path[at + colons.len()..])
    }

    /// The file in which it is written, below the crate's folder, without `.rs`: `src/claims/rest/near`.
    pub fn file(&self) -> String {
        match self.how {
            How::Measured(_) => {
                let path = (self.name)();
                let modules = path.rsplit_once("::").map_or("", |(modules, _)| modules);
                let below = modules.split_once("::").map_or("", |(_, below)| below);
                format!("src/{}", below.replace("::", "/"))
            }
            How::Proved(statement) => statement.place().file().trim_end_matches(".rs").to_owned(),
        }
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
        let evidence = noted(|| match self.how {
            How::Measured(trial) => trial(),
            How::Proved(statement) => statement.evidence(),
        });
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

/// The list of a claim's trials: functions, and statements that are proved by reference. An excuse goes behind a name:
/// `time::eq13_motion.idle("why")`.
#[macro_export]
macro_rules! trials {
    (@one & $first:ident $(:: $next:ident)*) => {
        $crate::claims::attempt::Attempt::proved(
            &$first$(::$next)*,
            || concat!(stringify!($first) $(, "::", stringify!($next))*),
        )
    };
    (@one $trial:path) => {
        $crate::claims::attempt::Attempt::measured(
            $trial,
            || ::std::any::type_name_of_val(&$trial),
        )
    };
    (@ [$($done:expr,)*] $(,)?) => {
        &[$($done),*]
    };
    (@ [$($done:expr,)*]
        $(& $($statement:ident)::+)? $($($trial:ident)::+)? $(.$excuse:ident($why:expr))*, $($rest:tt)*
    ) => {
        $crate::claims::attempt::trials!(@ [
            $($done,)*
            $crate::claims::attempt::trials!(
                @one $(& $($statement)::+)? $($($trial)::+)?
            )$(.$excuse($why))*,
        ] $($rest)*)
    };
    ($($all:tt)*) => {
        $crate::claims::attempt::trials!(@ [] $($all)*,)
    };
}

pub use trials;
