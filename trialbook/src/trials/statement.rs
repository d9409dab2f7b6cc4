//! A statement that can be proved: formulas, what is said of them, and the proof, in one value.

use super::compare::proved;
use crate::evidence::{Compared, Evidence, Subject};
use crate::exact::{Obstacle, Proof, Prover};
use crate::seeded::{Seed, reading, with};
use std::collections::BTreeSet;
use std::panic::Location;

/// What is said of formulas in the shape `F`.
#[derive(Debug, Clone, Copy)]
pub struct Statement<F = crate::exact::Expr> {
    /// What it speaks about.
    pub subject: Subject,
    /// What is compared with what.
    pub compared: Compared,
    /// The formulas as the code has them.
    pub formulas: fn() -> F,
    /// Tries to prove what is said, of formulas in their place.
    pub prove: fn(F) -> Proof,
    /// It says a part of the claim only, as in [`Evidence::partial`].
    pub partial: bool,
    /// Where it is written.
    pub place: &'static Location<'static>,
}

impl<F> Statement<F> {
    /// A statement, written where this is called.
    #[track_caller]
    pub const fn new(
        subject: Subject,
        compared: Compared,
        formulas: fn() -> F,
        prove: fn(F) -> Proof,
    ) -> Self {
        Self {
            subject,
            compared,
            formulas,
            prove,
            partial: false,
            place: Location::caller(),
        }
    }

    /// A statement without two sides, by what it says, written where this is called.
    #[track_caller]
    pub const fn shown(
        subject: Subject,
        clause: &'static str,
        formulas: fn() -> F,
        prove: fn(F) -> Proof,
    ) -> Self {
        Self::new(subject, Compared::shown(clause), formulas, prove)
    }

    /// The same for a claim of which it says this.
    pub const fn about(self, subject: Subject) -> Self {
        Self { subject, ..self }
    }

    /// The same for a claim of which it is a part.
    pub const fn of_a_part(self) -> Self {
        Self {
            partial: true,
            ..self
        }
    }

    /// The proof of the formulas as they stand.
    pub fn proof(&self) -> Proof {
        (self.prove)((self.formulas)())
    }
}

/// A statement of any shape.
pub trait Proved: Sync {
    /// The paths of the formulas of which it speaks.
    fn speaks_of(&self) -> BTreeSet<&'static str>;

    /// The proof with a mistake in the formulas of which it speaks, and in nothing else.
    fn with_mistake(&self, mistake: Seed) -> Proof;

    /// The proof of the formulas as they stand.
    fn proof(&self) -> Proof;

    /// What the proof brings.
    fn evidence(&self) -> Evidence;

    /// Where it is written.
    fn place(&self) -> &'static Location<'static>;
}

impl<F> Proved for Statement<F> {
    fn speaks_of(&self) -> BTreeSet<&'static str> {
        reading::of(self.formulas).1.formulas
    }

    fn with_mistake(&self, mistake: Seed) -> Proof {
        (self.prove)(with(mistake, self.formulas))
    }

    fn proof(&self) -> Proof {
        Statement::proof(self)
    }

    fn evidence(&self) -> Evidence {
        let evidence = proved(&Statement::proof(self), self.subject, self.compared);
        match self.partial {
            true => evidence.of_a_part(),
            false => evidence,
        }
    }

    fn place(&self) -> &'static Location<'static> {
        self.place
    }
}

/// Rests a proof on those of other statements.
///
/// # Errors
/// [`Obstacle`] if one of them does not hold.
pub fn rest_on(p: &mut Prover<'_>, known: &[&dyn Proved]) -> Result<(), Obstacle> {
    known
        .iter()
        .try_for_each(|known| p.rests_on(&known.proof()))
}
