//! The ledger's rows for other programs; the book's page on JSON says what the fields mean.

use super::{Entry, Standing};
use crate::evidence::Sample;
use crate::notation::plain_words;
use crate::trials::Condition;
use serde::Serialize;

/// A claim with its verdict and its evidence.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row<'a> {
    /// Permanent id.
    pub id: &'a str,
    /// Number of the equation, for a numbered one.
    pub equation: Option<u16>,
    /// Section of the paper.
    pub section: &'a str,
    /// What sort of statement it is, in lower case.
    pub kind: &'a str,
    /// What it is about, in a few words.
    pub title: &'a str,
    /// The statement in LaTeX.
    pub formula: &'a str,
    /// The statement in plain text.
    pub plain: &'a str,
    /// The verdict, by its slug.
    pub verdict: &'a str,
    /// What is wrong, in one sentence; nothing for a claim that stands.
    pub wrong: Option<String>,
    /// What the verdict rests on.
    pub ground: &'a str,
    /// How that is known; nothing where the verdict is undecided.
    pub standing: Option<Standing>,
    /// The conditions under which it is tried.
    pub conditions: &'a [Condition],
    /// Ids of the claims that it is derived from or refers to.
    pub depends_on: &'a [&'a str],
    /// What replaces it, in LaTeX, where it fails.
    pub corrected: Option<&'a str>,
    /// The functions that the claim tries: path, arguments and formula in plain text, from what the code
    /// computes.
    pub code: Vec<String>,
    /// How many wrong variants of its formulas were tried.
    pub variants: usize,
    /// How many of them its trials reject.
    pub rejected: usize,
    /// What its trials brought.
    pub evidence: Vec<EvidenceRow<'a>>,
}

/// What one trial brought.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EvidenceRow<'a> {
    /// The last two names of its function's path, or the statement that it proves.
    pub trial: &'a str,
    /// How it was obtained, in lower case.
    pub route: &'a str,
    /// What it speaks about, in lower case.
    pub subject: crate::evidence::Subject,
    /// What was compared with what, by which method and where: a sentence.
    pub compared: String,
    /// What the claim states, as plain text; of a proof without two sides, what is shown.
    pub stated: String,
    /// What is found without it.
    pub found: Option<String>,
    /// Where, in words.
    pub over: Option<String>,
    /// How many points were compared.
    pub points: usize,
    /// At how many of them the sides differ by more than the tolerance.
    pub failed: usize,
    /// What came of it: a sentence.
    pub result: String,
    /// A few of the compared pairs; of a proof, all of them.
    pub samples: &'a [Sample],
    /// The largest disagreement; `null` where not finite.
    pub worst: f64,
    /// The largest disagreement that counts as agreement.
    pub tolerance: f64,
    /// The tolerance's name in the code.
    pub tolerance_name: &'a str,
    /// Where the tolerance comes from.
    pub reason: &'a str,
    /// The title of a proof; nothing for a measurement.
    pub title: Option<&'a str>,
    /// What became of a proof: shown, checked, disproved, not proved.
    pub proof: Option<&'a str>,
    /// True if it covers a part of the claim only.
    pub partial: bool,
    /// The runs that it shares with other trials, by where they are made.
    pub runs: Vec<String>,
}

impl Entry {
    /// The entry as a row.
    pub fn row(&self) -> Row<'_> {
        let claim = self.claim;
        let tally = self.tally();
        Row {
            id: claim.id,
            equation: claim.equation,
            section: claim.section,
            kind: claim.kind.name(),
            title: claim.title,
            formula: claim.latex,
            plain: claim.plain,
            verdict: self.judgement.verdict.slug(),
            wrong: self.in_short().as_deref().map(plain_words),
            ground: &self.judgement.ground,
            standing: self.standing(),
            conditions: claim.conditions,
            depends_on: claim.depends_on,
            corrected: claim.correction.map(|c| c.latex),
            code: self.paper.formulas.of_claim(claim.id),
            variants: tally.tried,
            rejected: tally.rejected,
            evidence: self.made().map(evidence).collect(),
        }
    }
}

fn evidence(e: &crate::evidence::Evidence) -> EvidenceRow<'_> {
    let over = e.compared.points().map(|words| plain_words(&words));
    EvidenceRow {
        trial: e.trial,
        route: e.route.name(),
        subject: e.subject,
        compared: plain_words(&e.comparison()),
        stated: plain_words(&e.compared.stated()),
        found: e.compared.found().map(|words| plain_words(&words)),
        over: over.or_else(|| e.ranges.words()),
        points: e.points,
        failed: e.failed,
        result: plain_words(&e.measured()),
        samples: &e.samples,
        worst: e.worst,
        tolerance: e.tolerance.value,
        tolerance_name: e.tolerance.name,
        reason: e.tolerance.reason,
        title: Some(e.title.as_str()).filter(|title| !title.is_empty()),
        proof: e.proof_words(),
        partial: e.partial,
        runs: e.runs.iter().map(ToString::to_string).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::example::tried,
        super::{Entry, Judgement, Verdict},
        EvidenceRow, Row, evidence,
    };
    use crate::evidence::{Compared, Evidence, Route, Sample, Subject, Tolerance};
    use crate::notation::plain_words;
    use crate::trials::{Paper, Topic, read::File};
    use std::panic::Location;

    static TOPIC: Topic = Topic::new(
        "ratios",
        "Ratios",
        File::here(
            r#"
                section = "2.1"
                [eq-9]
                kind = "number"
                title = "a ratio"
                latex = '\lambda=1'
                conditions = [{ substance = '$x>0$' }]
                from = ["eq-1", "eq-2"]
                corrected = '\lambda=-1'
            "#,
        ),
        &[],
    );

    #[test]
    fn a_row_says_what_the_entry_does() {
        let [here, there] = [Location::caller(), Location::caller()];
        let tolerance = Tolerance {
            name: "RATIO",
            value: 0.25,
            reason: "the paper rounds",
        };
        let measured = Evidence {
            trial: "ratios::measured",
            points: 40,
            failed: 3,
            worst: 0.5,
            at: "x = 3".into(),
            samples: vec![Sample {
                at: "x = 3".into(),
                stated: 1.5,
                found: 1.0,
            }],
            runs: [here, there].into_iter().collect(),
            ..Evidence::new(
                Route::Root,
                Subject::Within,
                Compared::one("$a$", "the root $b$").over("$x=1$ to $3$"),
                tolerance,
            )
        };
        let proved = Evidence {
            trial: "ratios::PROVED",
            points: 1,
            title: "Of ratios".into(),
            partial: true,
            ..Evidence::new(
                Route::Exact,
                Subject::Corrected,
                Compared::shown("$a$ is less than $c$"),
                tolerance,
            )
        };
        let judgement = Judgement {
            verdict: Verdict::Conditional,
            ground: "two routes".into(),
            inherits: Vec::new(),
        };
        let entry = Entry {
            paper: &Paper::BLANK,
            claim: &TOPIC.claims()[0],
            topic: &TOPIC,
            evidence: vec![measured, proved],
            judgement,
        };
        let [measured, proved] = &entry.evidence[..] else {
            panic!("two trials")
        };
        let common = EvidenceRow {
            trial: "ratios::measured",
            route: "root",
            subject: Subject::Within,
            compared: plain_words(&measured.comparison()),
            stated: "a".into(),
            found: Some("the root b".into()),
            over: Some(plain_words("$x=1$ to $3$")),
            points: 40,
            failed: 3,
            result: plain_words(&measured.measured()),
            samples: &measured.samples,
            worst: 0.5,
            tolerance: 0.25,
            tolerance_name: "RATIO",
            reason: "the paper rounds",
            title: None,
            proof: None,
            partial: false,
            runs: vec![here.to_string(), there.to_string()],
        };
        let expected = Row {
            id: "eq-9",
            equation: Some(9),
            section: "2.1",
            kind: "number",
            title: "a ratio",
            formula: r"\lambda=1",
            plain: "λ = 1",
            verdict: "conditional",
            wrong: Some(plain_words("Needs a condition: $x>0$.")),
            ground: "two routes",
            standing: None,
            conditions: entry.claim.conditions,
            depends_on: &["eq-1", "eq-2"],
            corrected: Some(r"\lambda=-1"),
            code: Vec::new(),
            variants: 0,
            rejected: 0,
            evidence: vec![
                common.clone(),
                EvidenceRow {
                    trial: "ratios::PROVED",
                    route: "exact",
                    subject: Subject::Corrected,
                    compared: plain_words(&proved.comparison()),
                    stated: "a is less than c".into(),
                    found: None,
                    over: None,
                    points: 1,
                    failed: 0,
                    result: plain_words(&proved.measured()),
                    samples: &[],
                    worst: 0.0,
                    title: Some("Of ratios"),
                    proof: Some("checked"),
                    partial: true,
                    runs: Vec::new(),
                    ..common
                },
            ],
        };
        assert_eq!(entry.row(), expected);
    }

    #[test]
    fn a_row_counts_those_that_disagree() {
        for (failed, worst) in [(0, 1e-16), (3, 1.0), (20, 1.0)] {
            let evidence_of = tried(Route::Census, Subject::Printed, failed);
            let row = evidence(&evidence_of);
            assert_eq!((row.points, row.failed), (20, failed.into()));
            assert_eq!(
                (row.worst, row.tolerance),
                (worst, evidence_of.tolerance.value)
            );
            assert!(!row.partial && evidence(&evidence_of.of_a_part()).partial);
        }
    }
}
