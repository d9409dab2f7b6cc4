//! The ledger as the claims' sheets have it: enough to list the claims and to write the errata.

use super::{Entry, Judgement, Ledger, RecordError, Verdict};
use crate::evidence::{Compared, Evidence, Subject};
use crate::trials::{Paper, tolerances::NONE};
use std::collections::BTreeMap;

impl Ledger {
    /// The ledger by the [sheets](Paper::sheets).
    ///
    /// # Errors
    /// [`RecordError::Sheet`] for the first claim whose sheet is missing or cannot be read.
    pub fn recorded(paper: &'static Paper) -> Result<Self, RecordError> {
        let sheets: BTreeMap<_, _> = paper.sheets.texts(".snap").into_iter().collect();
        let entries = paper.claims().map(|(topic, claim)| {
            let path = format!("{}/{}.snap", topic.stem, claim.id);
            let read = sheets.get(&path).ok_or("is missing");
            match read.and_then(|sheet| said(sheet)) {
                Ok((judgement, evidence)) => Ok(Entry {
                    paper,
                    claim,
                    topic,
                    evidence,
                    judgement,
                }),
                Err(why) => Err(RecordError::Sheet { path, why }),
            }
        });
        Ok(Ledger {
            paper,
            entries: entries.collect::<Result<_, _>>()?,
            beside: Vec::new(),
        })
    }
}

fn said(sheet: &str) -> Result<(Judgement, Vec<Evidence>), &'static str> {
    let mut parts = sheet.split("\ntrial by ");
    let head = parts.next().unwrap_or_default();
    let of = |name| head.lines().find_map(|line| line.strip_prefix(name));
    let verdict = of("verdict: ").and_then(|words| {
        let mut all = Verdict::ALL.into_iter();
        all.find(|verdict| verdict.words() == words)
    });
    let verdict = verdict.ok_or("has no verdict")?;
    let ground = of("ground: ").ok_or("has no ground")?;
    let from = ground.split_once("; what it follows from is wrong: ");
    let from = from.into_iter().flat_map(|(_, ids)| ids.split(", "));
    let judgement = Judgement {
        verdict,
        ground: ground.to_owned(),
        inherits: from.map(str::to_owned).collect(),
    };
    let evidence = parts.map(trial).collect::<Option<_>>();
    Ok((judgement, evidence.ok_or("has a trial that is none")?))
}

fn trial(text: &str) -> Option<Evidence> {
    let mut lines = text.lines();
    let (route, about) = lines.next()?.strip_suffix(':')?.split_once(", ")?;
    let said = lines.next()?.trim_start();
    let whole = about.strip_suffix(", a part of it");
    let subject = Subject::ALL.into_iter().find(|subject| {
        let forms = [(true, false), (false, false), (false, true)];
        let words = forms.map(|(conditional, ours)| subject.words(conditional, ours));
        words.contains(&whole.unwrap_or(about))
    });
    let words = lines.next().unwrap_or_default().split([' ', ',', ';']);
    let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
    let [different, points, failed] = match words[..] {
        [different, "of", points, "points", "differ", ref more @ ..] => {
            let failed = more.first().and_then(|n| n.parse().ok()).unwrap_or(0);
            [different.parse().ok()?, points.parse().ok()?, failed]
        }
        // Of most proofs nothing is said.
        _ => [1, 1, 0],
    };
    let any = |words: [&str; 3]| words.iter().any(|of| said.contains(&format!(". {of}")));
    Some(Evidence {
        points,
        failed,
        repeated: points.checked_sub(different)?,
        worst: match () {
            () if any(["All agree", "Shown", "Checked"]) => 0.0,
            () if any(["No number", "Not proved", "Too few"]) => f64::NAN,
            () => f64::INFINITY,
        },
        partial: whole.is_some(),
        recorded: Some(format!("{about}, by {route}. {said}")),
        ..Evidence::new(
            serde_json::from_value(route.into()).ok()?,
            subject?,
            match said.starts_with("The statement, ") {
                true => Compared::shown(""),
                false => Compared::one("", ""),
            },
            NONE,
        )
    })
}

#[cfg(test)]
mod tests {
    use super::super::example;
    use super::*;
    use crate::data::Folder;
    use std::fs;

    #[test]
    fn sheets_say_what_the_trials_did() {
        let mut tried = example::ledger();
        tried.entries[0].evidence[0].worst = f64::NAN;
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("examples")).unwrap();
        let path = |id| folder.path().join(format!("examples/{id}.snap"));
        for entry in &tried.entries {
            let text = format!("---\nsource: x\n---\n{}", entry.snapshot());
            fs::write(path(entry.claim.id), text).unwrap();
        }
        let paper: &'static Paper = Box::leak(Box::new(Paper {
            sheets: Folder::Here(folder.path().to_str().unwrap().to_owned().leak()),
            ..example::PAPER
        }));
        let known = |ledger: &Ledger| -> Vec<_> {
            let said = |e: &Entry| {
                let of: Vec<_> = e.evidence.iter().map(Evidence::outcome).collect();
                let all = (&e.judgement, e.standing(), e.routes(), e.points(), of);
                format!("{all:?}")
            };
            ledger.entries.iter().map(said).collect()
        };
        assert_eq!(known(&Ledger::recorded(paper).unwrap()), known(&tried));
        let sheet = fs::read_to_string(path("eq-4")).unwrap();
        for (from, to, why) in [
            ("verdict: misprint", "verdict: print", "has no verdict"),
            ("ground: ", "ground ", "has no ground"),
            ("by root, as", "by roof, as", "has a trial that is none"),
            ("20 of 20", "21 of 20", "has a trial that is none"),
        ] {
            fs::write(path("eq-4"), sheet.replace(from, to)).unwrap();
            let path = "examples/eq-4.snap".to_owned();
            let lacks = RecordError::Sheet { path, why };
            assert_eq!(Ledger::recorded(paper).unwrap_err(), lacks);
        }
        fs::remove_file(path("eq-4")).unwrap();
        let told = Ledger::recorded(paper).unwrap_err().to_string();
        assert!(told.starts_with("the recorded sheet examples/eq-4.snap is missing"));
    }
}
