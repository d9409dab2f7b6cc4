//! Claims by their ids, as people write them.

use crate::publishing::{Edition, Failure};
use crate::trials::{Claim, Paper};
use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::error::Error;
use clap::{Arg, Command};
use std::ffi::OsStr;

/// Takes any word, and tells the shells the ids that there are.
#[derive(Clone)]
pub(super) struct Ids(pub(super) &'static Paper);

impl TypedValueParser for Ids {
    type Value = String;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<String, Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let ids = self.0.claims().map(|(_, claim)| claim.id);
        Some(Box::new(ids.map(PossibleValue::new)))
    }
}

/// The ids of these claims, each once.
pub(super) fn known_all(edition: &Edition, words: &[String]) -> Result<Vec<&'static str>, Failure> {
    let mut ids = Vec::new();
    for word in words {
        let id = known(edition, word)?;
        if !ids.contains(&id) {
            ids.push(id);
        }
    }
    Ok(ids)
}

/// Ids that are named where a word fits several or none.
const NAMED: usize = 6;

/// The id that is meant: one as it stands, an equation by its number as in `13`, `(13)`, `EQ-13` or `eq13`, a figure in the
/// same way, the claim of a number by its name, `lambda-c`, or the one id that begins like that or has it within.
pub(super) fn known(edition: &Edition, word: &str) -> Result<&'static str, Failure> {
    let ids = || edition.paper.claims().map(|(_, Claim { id, .. })| *id);
    let name = edition.name;
    let lower = word.trim().to_lowercase();
    let number = numbered(&lower);
    let plain = number
        .clone()
        .unwrap_or_else(|| lower.replace([' ', '_'], "-"));
    let is = |id: &&str| id.to_lowercase() == plain;
    if let Some(id) = ids().find(|id| *id == word).or_else(|| ids().find(is)) {
        return Ok(id);
    }
    if let Some(value) = edition.paper.value(&lower) {
        return Ok(value.claim);
    }
    let begins = |id: &&str| id.to_lowercase().starts_with(&plain);
    let within = |id: &&str| id.to_lowercase().contains(&plain);
    let mut some: Vec<_> = ids().filter(begins).collect();
    // A part of a number is none of an id.
    let word_like = plain.starts_with(char::is_alphabetic);
    if some.is_empty() && word_like {
        some = ids().filter(within).collect();
    }
    match &some[..] {
        // Digits alone are a number, not a part of one.
        [id] if !plain.ends_with(|c: char| c.is_ascii_digit()) => Ok(id),
        several if several.len() > 1 && word_like && number.is_none() => {
            let shown: Vec<_> = several.iter().take(NAMED).copied().collect();
            let more = if several.len() > NAMED { ", …" } else { "" };
            Err(format!("`{word}` may be {}{more}", shown.join(", ")).into())
        }
        _ => {
            let section = lower.trim_matches(|c: char| !c.is_ascii_digit());
            let mut claims = edition.paper.claims().map(|(_, claim)| claim);
            if section.contains('.') && claims.any(|claim| claim.section == section) {
                let list = format!("{name} list --section {section}");
                return Err(format!("`{word}` is no claim but a section: `{list}`").into());
            }
            let hint =
                nearest(&plain, ids()).map_or(String::new(), |id| format!("did you mean `{id}`? "));
            Err(format!("there is no claim `{word}`: {hint}`{name} list` names all").into())
        }
    }
}

/// The word that is likely meant, if any is.
pub(super) fn nearest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let near = |known: &&str| (strsim::jaro_winkler(&known.to_lowercase(), word) * 1e6) as u32;
    known.max_by_key(near).filter(|best| near(best) > 850_000)
}

/// The id of an equation or a figure that a word in small letters names by its number and nothing else: `13`, `(13)`,
/// `eq. (13)`, `eq-13`, `eq13`; `figure 3`.
pub(super) fn numbered(word: &str) -> Option<String> {
    let before = word.find(|c: char| !c.is_ascii_alphabetic())?;
    let (kind, rest) = word.split_at(before);
    let prefix = match kind {
        "" | "eq" | "eqn" | "equation" => "eq",
        "fig" | "figure" => "fig",
        _ => return None,
    };
    let rest = match kind {
        "" => rest,
        _ => {
            let rest = rest.strip_prefix('.').unwrap_or(rest);
            rest.strip_prefix([' ', '-', '_']).unwrap_or(rest)
        }
    };
    let inside = rest.strip_prefix('(').and_then(|r| r.strip_suffix(')'));
    let digits = inside.unwrap_or(rest);
    let all = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    all.then(|| format!("{prefix}-{}", digits.trim_start_matches('0')))
}
