//! The search: an index of the finished pages, with formulas as words, in the form of mdBook's, which reads a
//! formula twice and drops Greek letters.

use super::{context::Context, text::unescape};
use crate::evidence::Change;
use crate::notation::{
    Tag,
    letters::{GREEK, HIGH, large},
    plain_words, tags,
};
use elasticlunr::lang::English;
use elasticlunr::{Index, IndexBuilder, Language, Pipeline};
use serde_json::json;
use std::collections::BTreeMap;

struct Stretch {
    address: String,
    title: String,
    path: String,
    body: String,
    aliases: String,
}

#[derive(serde::Serialize)]
struct Searched<'a> {
    results_options: serde_json::Value,
    search_options: serde_json::Value,
    doc_urls: &'a [&'a str],
    /// By the places of their boxes: slug and words.
    verdicts: &'a BTreeMap<String, [&'static str; 2]>,
    /// Words, and the number of the place; of several places the first.
    exact: Vec<(&'a str, usize)>,
    /// By as many digits as are known, with their places.
    values: Vec<(&'a str, usize)>,
    formulas: Vec<(&'a str, usize)>,
    index: &'a Index,
}

#[derive(Default)]
pub(super) struct Search {
    stretches: Vec<Stretch>,
    aliases: BTreeMap<String, String>,
    exact: Vec<(String, String)>,
    values: Vec<(String, String)>,
    formulas: Vec<(String, String)>,
    verdicts: BTreeMap<String, [&'static str; 2]>,
}

/// English without the step that takes Greek letters and brackets off a word; [`words`] does it with care.
struct Physics(English);

impl Language for Physics {
    fn name(&self) -> String {
        self.0.name()
    }
    fn code(&self) -> String {
        self.0.code()
    }
    fn tokenize(&self, text: &str) -> Vec<String> {
        words(text)
    }
    fn make_pipeline(&self) -> Pipeline {
        let mut pipeline = self.0.make_pipeline();
        pipeline.queue.retain(|step| step.name() != "trimmer");
        pipeline
    }
}

/// The words by which a text is found: `(37),` by "(37)" and "37", `λ_c` by "λ_c" and "λc".
fn words(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for word in text.split(|c: char| c.is_whitespace() || c == '-') {
        let word = word
            .trim_matches(['.', ',', ';', ':', '!', '?', '"', '“', '”', '…'])
            .to_lowercase();
        let bare = word.trim_matches(['(', ')', '[', ']', '|', '=']).to_owned();
        let flat: String = bare.chars().filter(|c| *c != '_').map(flat_digit).collect();
        let parts = bare.split(['/', '·', '=']).map(str::to_owned);
        let typed = typed(&bare);
        let mut forms: Vec<_> = [word, bare.clone(), flat]
            .into_iter()
            .chain(parts)
            .collect();
        if typed != bare {
            let names = typed.split(|c: char| !c.is_ascii_alphanumeric());
            forms.extend(names.map(str::to_owned));
            forms.push(typed.replace('_', ""));
            forms.push(typed);
        }
        // As one writes it before a number.
        if bare == "eq" {
            forms.push("eq.".to_owned());
        }
        forms.retain(|form| !form.is_empty() && form.len() <= 80);
        forms.sort();
        forms.dedup();
        found.extend(forms);
    }
    found
}

/// From a keyboard without Greek letters: `τ²` is `tau^2`, `λ_c` is `lambda_c`.
fn typed(word: &str) -> String {
    let mut out = String::new();
    for c in word.chars() {
        let is = |(_, letter): &&(&str, &str)| letter.chars().eq([c]);
        match (large(c, HIGH), GREEK.iter().find(is)) {
            (Some(digit), _) => out.extend(['^', digit]),
            (None, Some((name, _))) => out.push_str(name),
            (None, None) => out.push(flat_digit(c)),
        }
    }
    out
}

fn flat_digit(c: char) -> char {
    match c {
        '₀'..='₉' => char::from_digit(u32::from(c) - u32::from('₀'), 10).unwrap_or(c),
        c => c,
    }
}

impl Search {
    pub(super) fn new(context: &Context<'_>) -> Self {
        let mut search = Search::default();
        let lines = context.edition.aliases.lines();
        let lines = lines.filter_map(|line| line.split_once('\t'));
        let lines = lines.map(|(address, phrases)| (address.to_owned(), phrases));
        let claims = context.ledger.entries.iter();
        let claims = claims.map(|entry| (entry.address(), entry.claim.aliases));
        for (address, phrases) in lines.chain(claims.filter(|(_, phrases)| !phrases.is_empty())) {
            let phrases = phrases.split("; ");
            let exact = phrases
                .clone()
                .map(|phrase| (phrase.to_owned(), address.clone()));
            search.exact.extend(exact);
            let words = phrases.filter(|phrase| !phrase.contains(' '));
            let words = words.collect::<Vec<_>>().join(" ");
            search.aliases.insert(address, words);
        }
        for entry in &context.ledger.entries {
            let (claim, verdict) = (entry.claim, entry.judgement.verdict);
            let address = entry.address();
            let placed = |text: String| (text, address.clone());
            let number = claim.equation.map(|n| n.to_string());
            let names = [claim.id.to_owned(), plain_words(&claim.name())];
            let title = Some(plain_words(claim.title)).filter(|title| title.contains(' '));
            let names = number.into_iter().chain(names).chain(title);
            search.exact.extend(names.map(placed));
            // A page begins with the section that it is about; another begins with its first claim.
            let (section, page) = (
                format!("section {}", claim.section),
                format!("{}.html#", entry.topic.stem),
            );
            let known = |name: &str| {
                let mut exact = search.exact.iter();
                exact.any(|(words, at)| words.starts_with(name) && at.starts_with(&page))
            };
            if !known(&section) {
                let place = if known("section ") {
                    address.clone()
                } else {
                    page
                };
                search.exact.push((section, place));
            }
            let number = claim.equation;
            let number = number.map(|n| format!("eq eq{n} equation {n} ({n})"));
            let values = claim.values.iter();
            let values = values.filter_map(|value| value.shown().ok());
            search.values.extend(values.map(placed));
            let right = claim.correction.map(|correction| correction.plain);
            let formulas = [claim.plain].into_iter().chain(right);
            let formulas = formulas.map(|plain| placed(plain.to_owned()));
            search.formulas.extend(formulas);
            let sign = claim.correction.filter(|_| verdict.is_wrong());
            // What one means by it is in a formula, not in a sentence.
            let is_sign = |change| change == Change::Sign && claim.equation.is_some();
            let sign = sign.filter(|correction| is_sign(correction.change));
            let sign = sign.map(|_| "sign error".to_owned());
            let symbols = context.edition.symbols.iter();
            let symbols = symbols.filter(|symbol| symbol.claim == claim.id);
            let symbols: Vec<_> = symbols.map(|symbol| symbol.plain.to_owned()).collect();
            search.exact.extend(symbols.iter().cloned().map(placed));
            let words = number.into_iter().chain(symbols).chain(sign);
            let words: Vec<_> = words.collect();
            let aliases = search.aliases.entry(address.clone()).or_default();
            *aliases += &format!(" {} {}", verdict.slug(), words.join(" "));
            search
                .verdicts
                .insert(address, [verdict.slug(), verdict.words()]);
        }
        search
    }

    pub(super) fn add(&mut self, file: &str, html: &str) {
        let main = html.split_once("<main>").map_or("", |(_, rest)| rest);
        let main = main.split_once("</main>").map_or(main, |(main, _)| main);
        let first = self.stretches.len();
        let mut heading = false;
        // Open elements inside one that is left out, and what it is.
        let mut skipped: Option<(&str, usize)> = None;
        for tag in tags(main) {
            let Tag {
                name, closes, text, ..
            } = tag;
            if let Some((skip, depth)) = &mut skipped {
                if name == *skip && !tag.alone {
                    *depth = if closes { *depth - 1 } else { *depth + 1 };
                }
                if *depth > 0 {
                    continue;
                }
                skipped = None;
            } else if !closes && left_out(&tag) {
                skipped = Some((name, 1));
                continue;
            }
            if let "h1" | "h2" | "h3" = name {
                heading = !closes;
                if let (false, Some(id)) = (closes, tag.value("id")) {
                    let address = format!("{file}#{id}");
                    self.stretches.push(Stretch {
                        aliases: self.aliases.get(&address).cloned().unwrap_or_default(),
                        address,
                        title: String::new(),
                        path: String::new(),
                        body: String::new(),
                    });
                }
            }
            if self.stretches.len() > first
                && let Some(stretch) = self.stretches.last_mut()
            {
                let to = if heading {
                    &mut stretch.title
                } else {
                    &mut stretch.body
                };
                if !matches!(
                    name,
                    "em" | "strong" | "a" | "sub" | "sup" | "code" | "span"
                ) {
                    to.push(' ');
                }
                if name == "sup" && !closes {
                    to.push('^');
                }
                *to += &unescape(text);
            }
        }
        let mut chapter = String::new();
        for stretch in &mut self.stretches[first..] {
            for text in [&mut stretch.title, &mut stretch.body] {
                *text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            }
            stretch.path = match chapter.as_str() {
                "" => stretch.title.clone(),
                chapter => format!("{chapter} » {}", stretch.title),
            };
            if chapter.is_empty() {
                chapter.clone_from(&stretch.title);
            }
        }
    }

    pub(super) fn file(&self) -> Result<String, serde_json::Error> {
        let fields = ["title", "body", "breadcrumbs", "aliases"];
        let mut index: Index = IndexBuilder::with_language(Box::new(Physics(English::new())))
            .add_fields(fields)
            .build();
        for (i, stretch) in self.stretches.iter().enumerate() {
            let texts = [
                &stretch.title,
                &stretch.body,
                &stretch.path,
                &stretch.aliases,
            ];
            index.add_doc(&i.to_string(), texts);
        }
        let addresses: Vec<_> = self.stretches.iter().map(|s| s.address.as_str()).collect();
        // The title counts most: "(37)" is to find the equation before what refers to it.
        let data = serde_json::to_string(&Searched {
            results_options: json!({ "limit_results": 30, "teaser_word_count": 30 }),
            search_options: json!({
                "bool": "AND",
                "expand": true,
                "fields": { "title": { "boost": 4 }, "aliases": { "boost": 8 }, "body": { "boost": 1 }, "breadcrumbs": { "boost": 1 } }
            }),
            verdicts: &self.verdicts,
            exact: placed(&self.exact, &addresses),
            values: placed(&self.values, &addresses),
            formulas: placed(&self.formulas, &addresses),
            doc_urls: &addresses,
            index: &index,
        })?;
        let quoted = data.replace('\\', "\\\\").replace('\'', "\\'");
        Ok(format!(
            "window.search = Object.assign(window.search, JSON.parse('{quoted}'));"
        ))
    }
}

/// With the numbers of the addresses; a page is its first place, and what leads nowhere is left out.
fn placed<'a>(named: &'a [(String, String)], addresses: &[&str]) -> Vec<(&'a str, usize)> {
    let place = |address: &String| {
        let is =
            |a: &&str| *a == address || address.ends_with('#') && a.starts_with(address.as_str());
        addresses.iter().position(is)
    };
    let named = named.iter();
    let named = named.filter_map(|(words, address)| Some((words.as_str(), place(address)?)));
    named.collect()
}

/// What a reader would not search for.
fn left_out(tag: &Tag<'_>) -> bool {
    let has = |words: &[&str]| words.iter().any(|word| tag.tag.contains(word));
    match tag.name {
        "svg" | "script" | "style" | "button" => !tag.alone,
        "a" => has(&["class=\"code\""]),
        "details" => has(&["contents", "latex", "proof", "samples"]),
        "p" => has(&["class=\"measure\""]),
        "div" => has(&[
            "wrapper ledger",
            "wrapper equations",
            "wrapper falls",
            "wrapper rests",
            "class=\"skeleton",
        ]),
        "section" => has(&["erratum"]),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_symbols_are_words() {
        for (text, word) in [
            ("see (37), and", "(37)"),
            ("see (37), and", "37"),
            ("of λ_c.", "λc"),
            ("of λ₀", "λ0"),
            ("2/9 of", "2/9"),
            ("Stick-slip", "slip"),
            ("2τ²/9", "2tau^2/9"),
            ("τ²", "tau^2"),
            ("λ_c", "lambda"),
        ] {
            assert!(
                words(text).iter().any(|found| found == word),
                "{text}: {word}"
            );
        }
    }

    #[test]
    fn a_page_is_cut_at_its_headings() {
        let mut search = Search::default();
        search.add(
            "a.html",
            "<main><h1 id=\"a\"><a href=\"#a\">A page</a></h1><p>first &amp; <em>se</em>cond</p>\
             <figure><svg><g><text>0.5</text></g></svg></figure>\
             <h3 id=\"eq-1\">(1) Law</h3><p>third</p><p class=\"measure\">at 0.5</p><details class=\"latex\">hidden</details></main> footer",
        );
        let found: Vec<_> = search
            .stretches
            .iter()
            .map(|s| [&*s.address, &*s.title, &*s.body, &*s.path])
            .collect();
        assert_eq!(
            found,
            [
                ["a.html#a", "A page", "first & second", "A page"],
                ["a.html#eq-1", "(1) Law", "third", "A page » (1) Law"],
            ]
        );
        assert!(
            search
                .file()
                .unwrap()
                .starts_with("window.search = Object.assign(window.search, JSON.parse('{")
        );
    }
}
