//! The judge: evidence in, verdict out. Nothing else decides what a claim is worth.

use crate::evidence::{Change, Evidence, Kind, Outcome, Route, Subject};
use crate::trials::{Condition, Sort};
use serde::Serialize;
use std::collections::BTreeSet;

/// What a claim is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every trial agrees, by two independent routes or by one that proves.
    Confirmed,
    /// The same, but for degenerate points: a set with empty interior, or one on which the claim has no value.
    Degenerate,
    /// True, but only under a condition of substance that the paper does not state; tried on both sides.
    Conditional,
    /// False as printed; a small correction is confirmed, and nothing takes the error over.
    Misprint,
    /// False by its own derivation; what is right is itself confirmed.
    Misderived,
    /// False because what it follows from is false; the step to it is right.
    Inherited,
    /// A statement in words that is false; what is right is itself confirmed.
    Refuted,
    /// Nothing to try but consistency, and that holds.
    Definition,
    /// The trials do not settle it.
    Undecided,
}

impl Verdict {
    /// All verdicts, in the order in which tables list them.
    pub const ALL: [Verdict; 9] = [
        Verdict::Confirmed,
        Verdict::Degenerate,
        Verdict::Conditional,
        Verdict::Misprint,
        Verdict::Misderived,
        Verdict::Inherited,
        Verdict::Refuted,
        Verdict::Definition,
        Verdict::Undecided,
    ];

    /// The verdict in words.
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Confirmed => "confirmed",
            Verdict::Degenerate => "confirmed but for degenerate points",
            Verdict::Conditional => "needs a condition",
            Verdict::Misprint => "misprint",
            Verdict::Misderived => "wrong by derivation",
            Verdict::Inherited => "inherits an error",
            Verdict::Refuted => "wrong",
            Verdict::Definition => "definition",
            Verdict::Undecided => "undecided",
        }
    }

    /// So many claims have this verdict, as the end of a sentence that names their number.
    pub fn of_many(self, claims: usize) -> &'static str {
        match (self, claims) {
            (_, 1) => self.words(),
            (Verdict::Conditional, _) => "need a condition",
            (Verdict::Misprint, _) => "misprints",
            (Verdict::Inherited, _) => "inherit an error",
            (Verdict::Definition, _) => "definitions",
            _ => self.words(),
        }
    }

    /// A short name without blanks, for records and style sheets.
    pub fn slug(self) -> &'static str {
        match self {
            Verdict::Degenerate => "degenerate",
            Verdict::Conditional => "conditional",
            Verdict::Misderived => "misderived",
            Verdict::Inherited => "inherited",
            Verdict::Refuted => "refuted",
            other => other.words(),
        }
    }

    /// True for a claim that is false as printed.
    pub fn is_wrong(self) -> bool {
        matches!(
            self,
            Verdict::Misprint | Verdict::Misderived | Verdict::Inherited | Verdict::Refuted
        )
    }

    /// It holds under a condition which the paper does not state.
    pub fn has_condition(self) -> bool {
        matches!(self, Verdict::Degenerate | Verdict::Conditional)
    }

    /// True for a verdict that asks for a change in the paper.
    pub fn asks_for_change(self) -> bool {
        self == Verdict::Conditional || self.is_wrong()
    }
}

/// A verdict and what it rests on, in one sentence.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// The ground for it; of an undecided claim, what would settle it.
    pub ground: String,
    /// Ids of the wrong claims from which an inherited error comes.
    pub inherits: Vec<String>,
}

fn judgement(verdict: Verdict, ground: impl Into<String>) -> Judgement {
    Judgement {
        verdict,
        ground: ground.into(),
        inherits: Vec::new(),
    }
}

/// Judges one claim by its evidence.
///
/// `change` is how much the correction changes, if there is one; `conditions` are those under which it is
/// tried.
pub fn judge(
    kind: Kind,
    change: Option<Change>,
    conditions: &[Condition],
    evidence: &[Evidence],
) -> Judgement {
    let undecided = |ground: String| judgement(Verdict::Undecided, ground);
    if evidence.is_empty() {
        return undecided("no trial yet".into());
    }
    for e in evidence {
        match e.outcome() {
            Outcome::NotANumber => {
                let (route, at) = (e.route.name(), &e.at);
                return undecided(format!("the trial by {route} gave no number ({at})"));
            }
            Outcome::TooFewPoints => {
                let (route, points, least) = (e.route.name(), e.different(), e.needed());
                let ground =
                    format!("the trial by {route} has {points} different points, it needs {least}");
                return undecided(ground);
            }
            Outcome::Agrees | Outcome::Disagrees => {}
        }
    }
    let of = |subject| Weighed::new(evidence, subject);
    let remark = of(Subject::Remark);
    if let Some(e) = remark.against.first() {
        return undecided(format!("what is remarked beside it fails at {}", e.at));
    }
    if remark.agree.is_empty() && conditions.iter().any(|c| c.sort == Sort::Remark) {
        return undecided("what is remarked beside it is not tried".into());
    }
    let (printed, within, outside, corrected) = (
        of(Subject::Printed),
        of(Subject::Within),
        of(Subject::Outside),
        of(Subject::Corrected),
    );

    if let Some(e) = printed.against.first().or(within.against.first()) {
        let fails = format!("fails at {}", e.at);
        if let Some(e) = corrected.against.first() {
            return undecided(format!(
                "{fails}, and what is to replace it fails at {}",
                e.at
            ));
        }
        let step = of(Subject::Step);
        if !step.agree.is_empty() && step.against.is_empty() {
            let ground = format!(
                "{fails}; the step from what it rests on {}",
                step.standing()
            );
            return judgement(Verdict::Inherited, ground);
        }
        if !corrected.enough() {
            return undecided(format!(
                "{fails}, and no correction is confirmed: derive what is right and try it by two routes"
            ));
        }
        let standing = corrected.standing();
        let in_words = matches!(kind, Kind::Property | Kind::Figure);
        return match change {
            None => undecided("a correction holds, but how much it changes is not said".into()),
            Some(Change::Statement) if in_words => judgement(
                Verdict::Refuted,
                format!("{fails}; what replaces it {standing}"),
            ),
            Some(Change::Statement) => judgement(
                Verdict::Misderived,
                format!("{fails}; what replaces it {standing}"),
            ),
            Some(Change::Sign | Change::Factor | Change::Symbol) => judgement(
                Verdict::Misprint,
                format!("{fails}; the corrected form {standing}"),
            ),
        };
    }
    if let Some(e) = corrected.against.first() {
        return undecided(format!(
            "the form that is to hold everywhere fails at {}",
            e.at
        ));
    }
    let added = || conditions.iter().filter(|c| c.sort.is_added());
    if !outside.is_empty() {
        if added().next().is_none() {
            return undecided("it is tried outside a condition that is not named".into());
        }
        if !outside.agree.is_empty() {
            return undecided("it holds without the condition too, where that was tried: find where the condition matters".into());
        }
        let held = within.with(&printed);
        if !held.enough() {
            return undecided("under the condition one more independent route is needed".into());
        }
        let excepted = of(Subject::Excepted);
        if let Some(e) = excepted.against.first() {
            return undecided(format!(
                "what a condition excepts is not degenerate, at {}",
                e.at
            ));
        }
        let degenerate = added().filter(|c| c.sort.is_degenerate()).count();
        if excepted.agree.len() != degenerate {
            return undecided(format!(
                "{degenerate} conditions are said to except degenerate points, {} found to do so",
                excepted.agree.len()
            ));
        }
        let standing = held.standing();
        let needs = |sort| added().any(|c| c.sort == sort);
        return if needs(Sort::Substance) {
            judgement(
                Verdict::Conditional,
                format!("{standing} under the condition, fails without it"),
            )
        } else if needs(Sort::Degenerate) {
            judgement(
                Verdict::Degenerate,
                format!("{standing}; what is excepted is degenerate"),
            )
        } else {
            judgement(
                Verdict::Confirmed,
                format!("{standing} under the convention"),
            )
        };
    }
    if added().next().is_some() {
        return undecided("a condition is added, and what happens without it is not tried".into());
    }
    let held = printed.with(&within);
    if kind == Kind::Definition && held.distinct().contains(&Route::Consistency) {
        let proved = if held.is_proved() {
            ", as is shown"
        } else {
            ""
        };
        let ground = format!("is consistent with the use made of it{proved}");
        return judgement(Verdict::Definition, ground);
    }
    if held.enough() {
        judgement(Verdict::Confirmed, held.standing())
    } else {
        let standing = held.standing();
        undecided(match held.distinct().is_empty() {
            true => format!("{standing}: what is tried is a part of it"),
            false => format!("{standing} alone: one more independent route is needed"),
        })
    }
}

/// The judgement in view of the claims that it rests on and of those that rest on it: an error may be
/// inherited, and a wrong formula that hands one on is more than a misprint.
pub fn in_view_of(
    own: Judgement,
    below: &[(&str, Verdict)],
    above: &[(&str, Verdict)],
) -> Judgement {
    let list = |claims: &[(&str, Verdict)], wanted: fn(Verdict) -> bool| -> Vec<String> {
        let ids = claims.iter().filter(|(_, verdict)| wanted(*verdict));
        ids.map(|(id, _)| (*id).to_owned()).collect()
    };
    match own.verdict {
        Verdict::Inherited => match list(below, Verdict::is_wrong) {
            wrong if wrong.is_empty() => judgement(
                Verdict::Undecided,
                format!("{}, and nothing that it rests on is wrong", own.ground),
            ),
            wrong if own.inherits.is_empty() => Judgement {
                ground: format!(
                    "{}; what it follows from is wrong: {}",
                    own.ground,
                    wrong.join(", ")
                ),
                inherits: wrong,
                ..own
            },
            _ => own,
        },
        Verdict::Misprint => match list(above, |verdict| verdict == Verdict::Inherited) {
            heirs if heirs.is_empty() => own,
            heirs => judgement(
                Verdict::Misderived,
                format!("{}; its error passes to {}", own.ground, heirs.join(", ")),
            ),
        },
        _ => own,
    }
}

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

    fn distinct(&self) -> BTreeSet<Route> {
        let whole = self.agree.iter().filter(|e| !e.partial);
        whole.map(|e| e.route).collect()
    }

    fn is_proved(&self) -> bool {
        self.distinct().iter().any(|route| route.is_proof())
    }

    /// Routes that have read the same runs are one.
    fn enough(&self) -> bool {
        let whole = || self.agree.iter().filter(|e| !e.partial);
        let independent =
            |a: &Evidence, b: &Evidence| a.route != b.route && a.runs.is_disjoint(&b.runs);
        let two = whole().any(|a| whole().any(|b| independent(a, b)));
        two || self.is_proved()
    }

    /// Exact algebra and enclosures first, those of a part last.
    fn standing(&self) -> String {
        let routes = self.distinct();
        let agree = self.agree.iter().map(|e| e.route);
        let proofs: BTreeSet<_> = agree.filter(|route| route.is_proof()).collect();
        let whole = match routes.is_empty() {
            true => "is not tried as a whole".to_owned(),
            false => format!("holds by {}", list(&routes)),
        };
        match self.is_proved() || proofs.is_empty() {
            true => whole,
            false => format!("{whole}; a part of it holds by {}", list(&proofs)),
        }
    }
}

/// Whether what is shown so is the whole of the claim, its [standing](super::Standing) says.
fn list(routes: &BTreeSet<Route>) -> String {
    let names = routes.iter().map(|route| match route {
        Route::Exact => "exact algebra",
        Route::Certified => "enclosure",
        route => route.name(),
    });
    names.collect::<Vec<_>>().join(", ")
}
