//! How a claim is known: proved, argued or measured.

use super::{Entry, Ledger};
use crate::evidence::{Evidence, Kind, Route};
use serde::Serialize;

/// How what a verdict rests on is known: the claim, or what is right in its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// The program has checked the whole statement: a formula, or a sentence that says no more than one, held against what it
    /// has to equal, or enclosed, for the signs at which it was tried. What is continuous, and has the rate 0 but at single
    /// instants, is taken to be constant: so equal rates and equal starts are enough.
    Proved,
    /// The program has checked the steps of a proof; what joins them is said in words.
    Argued,
    /// It was compared at many points, by independent routes.
    Measured,
}

impl Standing {
    /// All of them, the strongest first.
    pub const ALL: [Self; 3] = [Self::Proved, Self::Argued, Self::Measured];

    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Argued => "argued",
            Self::Measured => "measured",
        }
    }
}

impl Evidence {
    /// Whether sentences join the steps of the proof.
    pub fn is_in_words(&self) -> bool {
        self.route.is_proof() && self.compared.found().is_none()
    }
}

/// Relations by which a formula says what something tends to, and not what it is.
const TENDS: [&str; 5] = [r"\approx", r"\sim", r"\cdots", r"\to", r"\infty"];

impl Entry {
    /// How what the verdict rests on is known; nothing for an undecided claim.
    pub fn standing(&self) -> Option<Standing> {
        let (claim, whole) = (self.claim, self.whole());
        let by = |route| whole.iter().any(|e| e.route == route);
        let is_proof = by(Route::Exact) || by(Route::Certified);
        let latex = match claim.correction {
            Some(right) if self.judgement.verdict.is_wrong() => right.latex,
            _ => claim.latex,
        };
        let is_formula = match claim.kind {
            Kind::Definition | Kind::Equation | Kind::Number | Kind::Property => is_proof,
            // What sign an identity leaves is a matter of words.
            Kind::Inequality => by(Route::Certified),
            Kind::Limit | Kind::Figure => false,
        };
        // What its trials take in, too, has to be covered by the proof.
        let covered = |proof: &&Evidence| {
            let mut signs = proof.positive.iter().map(|base| {
                let half = base
                    .strip_prefix("tan(")
                    .and_then(|of| of.strip_suffix("/2)"));
                half.unwrap_or(base)
            });
            !signs.any(|of| whole.iter().any(|e| e.ranges.falls_below_zero(of)))
        };
        let proofs = whole.iter().filter(|e| e.route == Route::Exact);
        let is_covered = proofs.copied().all(|proof| covered(&proof));
        if whole.is_empty() {
            None
        } else if whole.iter().any(|e| e.is_in_words()) || is_proof && !claim.argument.is_empty() {
            Some(Standing::Argued)
        } else if claim.whole
            && is_formula
            && is_covered
            && !TENDS.iter().any(|tends| latex.contains(tends))
        {
            Some(Standing::Proved)
        } else {
            Some(Standing::Measured)
        }
    }
}

impl Ledger {
    /// How many claims are known in this way.
    pub fn known(&self, by: Standing) -> usize {
        let known = self.entries.iter().filter(|e| e.standing() == Some(by));
        known.count()
    }
}

#[cfg(all(test, feature = "trials"))]
mod tests {
    use super::Standing::{Argued, Measured, Proved};
    use super::*;
    use crate::evidence::{Compared, Ranges, Subject};
    use crate::ledger::example::{ledger, tried};
    use crate::trials::Claim;

    #[test]
    fn a_proof_for_positive_angles_is_not_one_for_all() {
        let by = |route| tried(route, Subject::Printed, 0);
        let mut entry = ledger().entry("eq-8").unwrap().clone();
        entry.claim = Box::leak(Box::new(Claim {
            kind: Kind::Equation,
            latex: "a=b",
            argument: "",
            whole: true,
            ..*entry.claim
        }));
        for (bases, at, standing) in [
            (&["tan(θ/2)"][..], "θ = 0.1", Proved),
            (&["tan(θ/2)"], "θ = -0.1", Measured),
            (&["θ"], "θ = -0.1", Measured),
            (&["tan(θ/2)"], "φ = -0.1", Proved),
            (&["λ", "θ"], "θ = -0.1", Measured),
            (&["θ", "λ", "μ"], "θ = -0.1, λ = 1", Measured),
            (&["λ", "μ"], "θ = -0.1", Proved),
        ] {
            let (mut proof, mut motion) = (by(Route::Exact), by(Route::Integration));
            proof.positive = bases.iter().map(ToString::to_string).collect();
            motion.ranges = Ranges::default();
            motion.ranges.take(at);
            entry.evidence = vec![proof, motion];
            assert_eq!(entry.standing(), Some(standing), "{bases:?} {at}");
        }
    }

    #[test]
    fn only_a_whole_formula_is_proved() {
        let by = |route| tried(route, Subject::Printed, 0);
        let words = Evidence {
            compared: Compared::shown("it never stops"),
            ..by(Route::Exact)
        };
        let shown = Evidence {
            route: Route::Certified,
            ..words.clone()
        };
        let (exact, certified) = (by(Route::Exact), by(Route::Certified));
        let formula = r"a=b";
        for (kind, latex, argument, evidence, standing) in [
            (Kind::Equation, formula, "", &exact, Proved),
            (Kind::Number, formula, "", &certified, Proved),
            (Kind::Equation, formula, "", &by(Route::Root), Measured),
            // A limit, a sign, a statement in words: an identity is not the whole of it.
            (Kind::Equation, r"a\approx b", "", &exact, Measured),
            (Kind::Inequality, "a<b", "", &exact, Measured),
            (Kind::Inequality, "a<b", "", &certified, Proved),
            (
                Kind::Property,
                "(3) has the constant (4)",
                "",
                &exact,
                Proved,
            ),
            (Kind::Property, "it stops", "", &shown, Argued),
            (Kind::Limit, "it stops", "", &exact, Measured),
            (Kind::Property, "it stops", "As $a<b$.", &exact, Argued),
            (Kind::Equation, formula, "As $a<b$.", &exact, Argued),
            (
                Kind::Property,
                "it stops",
                "As $a<b$.",
                &by(Route::Root),
                Measured,
            ),
            (Kind::Equation, formula, "", &words, Argued),
            (Kind::Inequality, "a<b", "", &shown, Argued),
        ] {
            let mut entry = ledger().entry("eq-8").unwrap().clone();
            entry.evidence = vec![evidence.clone()];
            entry.claim = Box::leak(Box::new(Claim {
                kind,
                latex,
                argument,
                whole: true,
                ..*entry.claim
            }));
            assert_eq!(
                entry.standing(),
                Some(standing),
                "{kind:?} {latex} {argument}"
            );
            // What is not said of it does not count.
            let unsaid = Claim {
                whole: false,
                ..*entry.claim
            };
            let claim = std::mem::replace(&mut entry.claim, Box::leak(Box::new(unsaid)));
            assert_ne!(entry.standing(), Some(Proved));
            entry.claim = claim;
            entry.evidence[0].partial = true;
            assert_eq!(entry.standing(), None);
        }
    }
}
