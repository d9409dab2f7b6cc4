//! The judge: evidence in, verdict out. Nothing else decides what a claim is worth.

use crate::evidence::{Change, Evidence, Kind, Outcome, Route, Subject};
use serde::Serialize;
use std::collections::BTreeSet;

/// What a claim is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every trial agrees, by two independent routes or by one that proves.
    Confirmed,
    /// True, but only under a condition that the paper does not state; tried on both sides.
    Conditional,
    /// False as printed; a small correction is confirmed, and what follows is unharmed.
    Misprint,
    /// False; what is right is itself confirmed.
    Refuted,
    /// Nothing to try but consistency, and that holds.
    Definition,
    /// The trials do not settle it.
    Undecided,
}

impl Verdict {
    /// All verdicts, in the order in which tables list them.
    pub const ALL: [Verdict; 6] = [
        Verdict::Confirmed,
        Verdict::Conditional,
        Verdict::Misprint,
        Verdict::Refuted,
        Verdict::Definition,
        Verdict::Undecided,
    ];

    /// The verdict in words.
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Confirmed => "confirmed",
            Verdict::Conditional => "confirmed with a condition",
            Verdict::Misprint => "misprint",
            Verdict::Refuted => "refuted",
            Verdict::Definition => "definition",
            Verdict::Undecided => "undecided",
        }
    }

    /// A short name without blanks, for records and style sheets.
    pub fn slug(self) -> &'static str {
        match self {
            Verdict::Conditional => "conditional",
            other => other.words(),
        }
    }

    /// True for a verdict that asks for a change in the paper.
    pub fn asks_for_change(self) -> bool {
        matches!(
            self,
            Verdict::Conditional | Verdict::Misprint | Verdict::Refuted
        )
    }
}

/// A verdict and what it rests on, in one sentence.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// The ground for it; of an undecided claim, what would settle it.
    pub ground: String,
}

fn judgement(verdict: Verdict, ground: impl Into<String>) -> Judgement {
    Judgement {
        verdict,
        ground: ground.into(),
    }
}

/// Judges one claim by its evidence.
///
/// `change` is how much the correction changes that the evidence on [`Subject::Corrected`] is about,
/// if there is one. The function depends on nothing but its arguments.
pub fn judge(kind: Kind, change: Option<Change>, evidence: &[Evidence]) -> Judgement {
    let undecided = |ground: String| judgement(Verdict::Undecided, ground);
    if evidence.is_empty() {
        return undecided("no trial yet".into());
    }
    for e in evidence {
        match e.outcome() {
            Outcome::NotANumber => {
                return undecided(format!(
                    "the trial by {} gave no number ({})",
                    e.route.name(),
                    e.at
                ));
            }
            Outcome::TooFewPoints => {
                return undecided(format!(
                    "the trial by {} has {} points, it needs {}",
                    e.route.name(),
                    e.points,
                    e.route.min_points()
                ));
            }
            Outcome::Agrees | Outcome::Disagrees => {}
        }
    }
    let of = |subject| Weighed::new(evidence, subject);
    let (printed, within, outside, corrected) = (
        of(Subject::Printed),
        of(Subject::Within),
        of(Subject::Outside),
        of(Subject::Corrected),
    );

    if let Some(e) = printed.against.first().or(within.against.first()) {
        return if corrected.against.is_empty() && corrected.enough() {
            match change {
                Some(Change::Sign | Change::Factor | Change::Symbol) => judgement(
                    Verdict::Misprint,
                    format!(
                        "fails at {}; the corrected form {}",
                        e.at,
                        corrected.standing()
                    ),
                ),
                Some(Change::Statement) => judgement(
                    Verdict::Refuted,
                    format!(
                        "fails at {}; what replaces it {}",
                        e.at,
                        corrected.standing()
                    ),
                ),
                None => undecided("a correction holds, but how much it changes is not said".into()),
            }
        } else {
            undecided(format!(
                "fails at {}, and no correction is confirmed: derive what is right and try it by two routes",
                e.at
            ))
        };
    }
    if let Some(e) = corrected.against.first() {
        return undecided(format!(
            "the form that is to hold everywhere fails at {}",
            e.at
        ));
    }
    if !outside.is_empty() {
        return if !outside.agree.is_empty() {
            undecided("it holds without the condition too, where that was tried: find where the condition matters".into())
        } else if within.with(&printed).enough() {
            judgement(
                Verdict::Conditional,
                format!(
                    "{} under the condition, fails without it",
                    within.with(&printed).standing()
                ),
            )
        } else {
            undecided("under the condition one more independent route is needed".into())
        };
    }
    let held = printed.with(&within);
    if kind == Kind::Definition && held.distinct().contains(&Route::Consistency) {
        let proved = if held.is_proved() { ", by a proof" } else { "" };
        let ground = format!("consistent with the use made of it{proved}");
        return judgement(Verdict::Definition, ground);
    }
    if held.enough() {
        judgement(Verdict::Confirmed, held.standing())
    } else {
        undecided(format!(
            "{} alone: one more independent route is needed",
            held.standing()
        ))
    }
}

/// The judgement of a claim in view of the claims that depend on it: a misprint leaves what follows
/// unharmed, so one from which something refuted follows is refuted itself.
pub fn in_view_of(own: Judgement, dependents: &[(&str, Verdict)]) -> Judgement {
    let fallen: Vec<_> = dependents
        .iter()
        .filter(|(_, verdict)| *verdict == Verdict::Refuted)
        .map(|(id, _)| *id)
        .collect();
    if own.verdict != Verdict::Misprint || fallen.is_empty() {
        return own;
    }
    let ground = format!(
        "{}; what follows falls too: {}",
        own.ground,
        fallen.join(", ")
    );
    judgement(Verdict::Refuted, ground)
}

/// The evidence on one subject, by what it says.
struct Weighed<'a> {
    agree: Vec<&'a Evidence>,
    against: Vec<&'a Evidence>,
}

impl<'a> Weighed<'a> {
    fn new(evidence: &'a [Evidence], subject: Subject) -> Self {
        let (agree, against) = evidence
            .iter()
            .filter(|e| e.subject == subject)
            .partition(|e| e.outcome() == Outcome::Agrees);
        Weighed { agree, against }
    }

    fn with(&self, other: &Self) -> Self {
        let join = |a: &[&'a Evidence], b: &[&'a Evidence]| [a, b].concat();
        Weighed {
            agree: join(&self.agree, &other.agree),
            against: join(&self.against, &other.against),
        }
    }

    fn is_empty(&self) -> bool {
        self.agree.is_empty() && self.against.is_empty()
    }

    /// The routes by which the whole holds.
    fn distinct(&self) -> BTreeSet<Route> {
        let whole = self.agree.iter().filter(|e| !e.partial);
        whole.map(|e| e.route).collect()
    }

    fn is_proved(&self) -> bool {
        self.distinct().iter().any(|route| route.is_proof())
    }

    /// Two independent routes, or one that proves. Routes that have read the same runs are one.
    fn enough(&self) -> bool {
        let whole = || self.agree.iter().filter(|e| !e.partial);
        let independent =
            |a: &Evidence, b: &Evidence| a.route != b.route && a.runs.is_disjoint(&b.runs);
        let two = whole().any(|a| whole().any(|b| independent(a, b)));
        two || self.is_proved()
    }

    /// How it holds: proofs first, those of a part last.
    fn standing(&self) -> String {
        let list = |routes: &BTreeSet<Route>| {
            let names: Vec<_> = routes.iter().map(|r| r.name()).collect();
            names.join(", ")
        };
        let (proofs, others): (BTreeSet<_>, BTreeSet<_>) =
            self.distinct().into_iter().partition(|r| r.is_proof());
        let whole = match (proofs.is_empty(), others.is_empty()) {
            (true, true) => "is not tried as a whole".to_owned(),
            (true, _) => format!("holds by {}", list(&others)),
            (_, true) => format!("is proved ({})", list(&proofs)),
            _ => {
                let (proofs, others) = (list(&proofs), list(&others));
                format!("is proved ({proofs}) and holds by {others}")
            }
        };
        let parts = self
            .agree
            .iter()
            .filter(|e| e.partial && e.route.is_proof());
        let parts: BTreeSet<_> = parts.map(|e| e.route).collect();
        match proofs.is_empty() && !parts.is_empty() {
            true => format!("{whole}; a part of it is proved ({})", list(&parts)),
            false => whole,
        }
    }
}
