//! Certificates: for each proof a file that a stranger's program can check.

use super::{
    output::{VERSION, csv, json, say},
    screen::progress,
};
use crate::book;
use crate::evidence::{Evidence, Kind, Subject};
use crate::publishing::{Edition, Failure, Format};
use crate::trials::{Claim, Paper, Sort, attempt::Attempt};
use crate::witness::{self, Witness};

use rayon::prelude::*;
use serde::Serialize;
use std::path::Path;

/// The version of the files' format.
const FORMAT: u32 = 4;

#[derive(Serialize)]
struct Certificate {
    format: u32,
    claim: &'static str,
    /// The LaTeX of what is proved: the claim's, or that of what replaces it.
    statement: &'static str,
    /// The claim's conditions, in LaTeX and words.
    conditions: Vec<&'static str>,
    /// About what form of the claim it speaks.
    about: String,
    /// Which of the claim's proofs it is, from 1 in the order of the row.
    proof: usize,
    #[serde(skip)]
    trial: &'static str,
    /// What was compared with what.
    says: String,
    witnesses: Vec<Witness>,
}

#[derive(Serialize)]
struct Row {
    claim: &'static str,
    trial: &'static str,
    /// The file's name; empty for a proof that leaves nothing.
    file: String,
    witnesses: usize,
    bytes: usize,
}

#[derive(Serialize)]
struct List<'a> {
    version: u32,
    folder: String,
    proofs: &'a [Row],
}

/// Writes the certificates of these claims, or of all, into a folder.
pub(super) fn certify(
    edition: &Edition,
    ids: &[&str],
    out: &Path,
    format: Format,
) -> Result<u8, Failure> {
    let proofs = made(edition.paper, ids);
    let (mut rows, mut files) = (Vec::new(), Vec::new());
    for certificate in proofs {
        let text = serde_json::to_vec(&certificate)?;
        let mut row = Row {
            claim: certificate.claim,
            trial: certificate.trial,
            file: String::new(),
            witnesses: certificate.witnesses.len(),
            bytes: text.len(),
        };
        if row.witnesses > 0 {
            row.file = format!("{}-{}.json", certificate.claim, certificate.proof);
            files.push((row.file.clone(), text));
        }
        rows.push(row);
    }
    let folder = book::replace(out, edition.name, "certificates", &files)?;
    match format {
        Format::Text => say(&text(&rows, &folder))?,
        Format::Json => json(&List {
            version: VERSION,
            folder: folder.display().to_string(),
            proofs: &rows,
        })?,
        Format::Csv => {
            let cells = |row: &Row| {
                vec![
                    row.claim.to_owned(),
                    row.trial.to_owned(),
                    row.file.clone(),
                    row.witnesses.to_string(),
                    row.bytes.to_string(),
                ]
            };
            csv(
                &["claim", "trial", "file", "witnesses", "bytes"],
                rows.iter().map(cells),
            )?;
        }
    }
    Ok(0)
}

/// How many certificates there are, and which proofs have none.
fn text(rows: &[Row], folder: &Path) -> String {
    let (bare, with): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.witnesses == 0);
    let names = bare
        .iter()
        .map(|row| format!("  {} {}\n", row.claim, row.trial));
    format!(
        "{} certificates in {}; {} proofs have none\n{}",
        with.len(),
        folder.display(),
        bare.len(),
        names.collect::<String>()
    )
}

/// Carries out all proofs of these claims, or of all claims, in the order of the paper.
fn made(paper: &'static Paper, ids: &[&str]) -> Vec<Certificate> {
    let wanted = |claim: &Claim| ids.is_empty() || ids.contains(&claim.id);
    let attempts: Vec<_> = paper
        .claims()
        .filter(|(_, claim)| wanted(claim))
        .flat_map(|(_, claim)| claim.trials.iter().map(move |attempt| (claim, attempt)))
        .collect();
    let length = attempts.len() as u64;
    let bar = progress(length, "{bar:40} {pos}/{len} trials  {eta} left");
    let one = |(claim, attempt): &(&'static Claim, &'static Attempt)| {
        let (evidence, witnesses) = witness::of(|| attempt.evidence());
        bar.inc(1);
        evidence
            .proof_words()
            .map(|_| certificate(claim, &evidence, witnesses))
    };
    let mut made: Vec<_> = attempts.par_iter().filter_map(one).collect();
    bar.finish_and_clear();
    for of_claim in made.chunk_by_mut(|a, b| a.claim == b.claim) {
        for (proof, certificate) in (1..).zip(of_claim) {
            certificate.proof = proof;
        }
    }
    made
}

fn certificate(claim: &Claim, evidence: &Evidence, witnesses: Vec<Witness>) -> Certificate {
    // Of a formula the last of them, the claim's own, has to compare something.
    let is_formula = matches!(claim.kind, Kind::Definition | Kind::Equation | Kind::Number);
    let bare = |left: &Witness| matches!(left, Witness::Identity(left) if left.equal.is_empty());
    let is_bare = is_formula && witnesses.last().is_some_and(bare);
    let corrected = claim
        .correction
        .filter(|_| evidence.subject == Subject::Corrected);
    let statement = corrected.map_or(claim.latex, |correction| correction.latex);
    let conditions = claim.conditions.iter();
    let conditions = conditions.filter(|condition| condition.sort != Sort::Remark);
    Certificate {
        format: FORMAT,
        claim: claim.id,
        statement,
        conditions: conditions.map(|condition| condition.text).collect(),
        about: evidence.about(claim.correction.is_none()),
        proof: 1,
        trial: evidence.trial,
        says: evidence.comparison(),
        witnesses: if is_bare { Vec::new() } else { witnesses },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::{Compared, Route};
    use crate::trials::{Topic, read::File, tolerances::NONE};

    #[test]
    fn proofs_without_a_certificate_are_named_and_not_counted() {
        let row = |claim, witnesses| Row {
            claim,
            trial: "t",
            file: String::new(),
            witnesses,
            bytes: 9,
        };
        let rows = [
            row("a", 3),
            row("b", 0),
            row("c", 1),
            row("d", 0),
            row("e", 2),
        ];
        assert_eq!(
            text(&rows, Path::new("folder")),
            "3 certificates in folder; 2 proofs have none\n  b t\n  d t\n"
        );
    }

    #[test]
    fn a_certificate_bears_what_its_proof_speaks_of() {
        let text = "[eq-6]\ntitle = 'top'\nlatex = 'H=+1'\ncorrected = 'H=-1'\n\
                    conditions = [{ stated = '$H>0$' }, { remark = 'seen' }, { reading = 'read so' }]";
        let under = Topic::new("", "", File::here(text), &[]).claims()[0];
        let corrected = Claim {
            conditions: &[],
            ..under
        };
        let printed = Claim {
            correction: None,
            ..corrected
        };
        let compared = Compared::one("$H$", "the motion");
        let proof = |subject| Evidence::new(Route::Exact, subject, compared, NONE);
        for subject in [
            Subject::Printed,
            Subject::Within,
            Subject::Outside,
            Subject::Corrected,
            Subject::Step,
            Subject::Excepted,
            Subject::Remark,
        ] {
            let evidence = proof(subject);
            let of = |claim: &Claim| certificate(claim, &evidence, Vec::new());
            let expected = match subject {
                Subject::Corrected => "H=-1",
                _ => "H=+1",
            };
            assert_eq!(of(&corrected).statement, expected, "{subject:?}");
            assert_eq!(of(&printed).statement, "H=+1", "{subject:?}");
        }
        // It says whether it is about the whole of that.
        for (subject, partial, about) in [
            (Subject::Printed, false, "as printed"),
            (Subject::Printed, true, "as printed, a part of it"),
            (Subject::Corrected, false, "as corrected"),
            (Subject::Corrected, true, "as corrected, a part of it"),
        ] {
            let whole = proof(subject);
            let evidence = if partial { whole.of_a_part() } else { whole };
            let made = certificate(&corrected, &evidence, Vec::new());
            assert_eq!(made.about, about);
        }
        // And under which conditions; what we remark is none.
        let made = certificate(&under, &proof(Subject::Within), Vec::new());
        assert_eq!(made.conditions, ["$H>0$", "read so"]);
    }
}
