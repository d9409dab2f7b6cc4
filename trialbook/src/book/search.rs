//! The search: an index made from the finished pages, with formulas as words.
//!
//! mdBook's own index reads a formula twice, as MathML and as HTML, and drops Greek letters and brackets. This one
//! takes its place, in the form that mdBook's searcher reads.

use super::text::unescape;
use elasticlunr::lang::English;
use elasticlunr::{Index, IndexBuilder, Language, Pipeline};
use serde_json::json;

/// A stretch of a page, from one heading to the next.
struct Stretch {
    address: String,
    title: String,
    path: String,
    body: String,
}

/// What mdBook's searcher reads.
#[derive(serde::Serialize)]
struct Searched<'a> {
    results_options: serde_json::Value,
    search_options: serde_json::Value,
    doc_urls: &'a [&'a str],
    index: &'a Index,
}

/// The index in the making.
pub(super) struct Search {
    stretches: Vec<Stretch>,
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
        let mut forms: Vec<_> = [word, bare.clone(), flat]
            .into_iter()
            .chain(parts)
            .collect();
        forms.retain(|form| !form.is_empty() && form.len() <= 80);
        forms.sort();
        forms.dedup();
        found.extend(forms);
    }
    found
}

/// A digit of an index as one on the line.
fn flat_digit(c: char) -> char {
    match c {
        '₀'..='₉' => char::from_digit(u32::from(c) - u32::from('₀'), 10).unwrap_or(c),
        c => c,
    }
}

impl Search {
    pub(super) fn new() -> Self {
        Search {
            stretches: Vec::new(),
        }
    }

    /// Adds a page: its file, and its HTML with words for formulas.
    pub(super) fn add(&mut self, file: &str, html: &str) {
        let main = html.split_once("<main>").map_or("", |(_, rest)| rest);
        let main = main.split_once("</main>").map_or(main, |(main, _)| main);
        let first = self.stretches.len();
        let mut heading = false;
        // Open elements inside one that is left out, and what it is.
        let mut skipped: Option<(&str, usize)> = None;
        for part in main.split('<').skip(1) {
            let (tag, text) = part.split_once('>').unwrap_or((part, ""));
            let name = tag
                .split([' ', '/'])
                .find(|name| !name.is_empty())
                .unwrap_or("");
            let closes = tag.starts_with('/');
            if let Some((skip, depth)) = &mut skipped {
                if name == *skip && !tag.ends_with('/') {
                    *depth = if closes { *depth - 1 } else { *depth + 1 };
                }
                if *depth > 0 {
                    continue;
                }
                skipped = None;
            } else if !closes && left_out(name, tag) {
                skipped = Some((name, 1));
                continue;
            }
            if let "h1" | "h2" | "h3" = name {
                heading = !closes;
                let id = tag
                    .split_once("id=\"")
                    .and_then(|(_, rest)| rest.split_once('"'));
                if let (false, Some((id, _))) = (closes, id) {
                    self.stretches.push(Stretch {
                        address: format!("{file}#{id}"),
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
                to.push_str(&unescape(text));
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

    /// The file that mdBook's searcher loads.
    pub(super) fn file(&self) -> Result<String, serde_json::Error> {
        let fields = ["title", "body", "breadcrumbs"];
        let mut index: Index = IndexBuilder::with_language(Box::new(Physics(English::new())))
            .add_fields(fields)
            .build();
        for (i, stretch) in self.stretches.iter().enumerate() {
            let texts = [&stretch.title, &stretch.body, &stretch.path];
            index.add_doc(&i.to_string(), texts);
        }
        let addresses: Vec<_> = self.stretches.iter().map(|s| s.address.as_str()).collect();
        // The title counts most: "(37)" is to find the equation before what refers to it.
        let data = serde_json::to_string(&Searched {
            results_options: json!({ "limit_results": 30, "teaser_word_count": 30 }),
            search_options: json!({
                "bool": "AND",
                "expand": true,
                "fields": { "title": { "boost": 4 }, "body": { "boost": 1 }, "breadcrumbs": { "boost": 1 } }
            }),
            doc_urls: &addresses,
            index: &index,
        })?;
        let quoted = data.replace('\\', "\\\\").replace('\'', "\\'");
        Ok(format!(
            "window.search = Object.assign(window.search, JSON.parse('{quoted}'));"
        ))
    }
}

/// What a reader would not search for: drawings, what was compared where, the steps of proofs, sources, and
/// lists of what stands elsewhere.
fn left_out(name: &str, tag: &str) -> bool {
    let has = |words: &[&str]| words.iter().any(|word| tag.contains(word));
    match name {
        "svg" | "script" | "style" | "button" => !tag.ends_with('/'),
        "a" => has(&["class=\"code\""]),
        "details" => has(&["contents", "latex", "proof", "samples"]),
        "p" => has(&["class=\"measure\""]),
        "div" => has(&[
            "wrapper ledger",
            "wrapper equations",
            "wrapper falls",
            "wrapper rests",
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
        ] {
            assert!(
                words(text).iter().any(|found| found == word),
                "{text}: {word}"
            );
        }
    }

    #[test]
    fn a_page_is_cut_at_its_headings() {
        let mut search = Search::new();
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
