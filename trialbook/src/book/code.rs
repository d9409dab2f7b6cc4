//! The code behind the claims: sources as pages, and where a claim's parts stand.

use super::{
    error::Html,
    text::{count, escape, in_code},
};
use crate::publishing::{Edition, texts};
use crate::trials::{Claim, Topic, attempt::Attempt};
use include_dir::{Dir, include_dir};
use std::collections::BTreeMap;

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    file: String,
    /// The function, or the id of a claim; empty for the file as a whole.
    name: String,
}

impl Place {
    fn new(file: &str, name: &str) -> Self {
        let (file, name) = (file.to_owned(), name.to_owned());
        Place { file, name }
    }

    pub(super) fn address(&self) -> String {
        let hash = if self.name.is_empty() { "" } else { "#" };
        format!("{}{hash}{}", page(&self.file), self.name)
    }

    pub(super) fn link(&self) -> String {
        let words = match self.name.as_str() {
            "" => &self.file,
            name => name,
        };
        format!("<a href=\"{}\">{}</a>", self.address(), in_code(words))
    }
}

pub(super) struct Code<'a> {
    edition: &'a Edition,
    /// By their path below `src` or, of another crate, from the top; or where the claims are.
    files: BTreeMap<String, Source>,
}

struct Source {
    text: &'static str,
    places: Vec<(usize, &'static str)>,
}

fn path(file: &str) -> String {
    let here = file.ends_with(".rs") && !file.contains("/src/");
    format!("{}{file}", if here { "src/" } else { "" })
}

fn page(file: &str) -> String {
    format!("code/{}.html", file.trim_end_matches(".rs"))
}

impl<'a> Code<'a> {
    pub(super) fn new(edition: &'a Edition) -> Self {
        let files = (edition.sources.files)().into_iter().map(|(path, text)| {
            let places = functions(text).collect();
            (path, Source { text, places })
        });
        let topics = edition.paper.topics.iter();
        // What stands in a source is not shown apart.
        let claims = topics.filter(|topic| topic.file.above == 0).map(|topic| {
            let lines = topic.lines().map(|(line, claim)| (line - 1, claim.id));
            let text = topic.file.text.as_str();
            let places = lines.collect();
            (topic.file.path.to_owned(), Source { text, places })
        });
        let files = files.chain(claims).collect();
        Code { edition, files }
    }

    /// `claims/escape.rs` and all in `claims/escape`; all where there are no modules.
    fn of_topic(&self, module: &str, topic: &Topic) -> impl Iterator<Item = (&str, &Source)> {
        let stem = format!("{module}/{}", topic.stem);
        let mut modules = self.files.keys().filter(|file| file.ends_with(".rs"));
        let flat = modules.all(|file| !file.contains('/'));
        let files = self
            .files
            .iter()
            .map(|(file, source)| (file.as_str(), source));
        files.filter(move |(file, _)| {
            let rest = file.strip_prefix(stem.as_str());
            flat || rest.is_some_and(|rest| rest == ".rs" || rest.starts_with('/'))
        })
    }

    pub(super) fn printed(&self, topic: &Topic, claim: &Claim) -> Option<Place> {
        let start = format!("eq{}_", claim.equation?);
        let mut functions = self
            .of_topic("paper", topic)
            .flat_map(|(file, source)| source.places.iter().map(move |f| (file, f.1)));
        let (file, name) = functions.find(|(_, name)| name.starts_with(&start))?;
        Some(Place::new(file, name))
    }

    pub(super) fn corrections(&self, topic: &Topic) -> Option<Place> {
        let (file, _) = self.of_topic("corrections", topic).next()?;
        Some(Place::new(file, ""))
    }

    pub(super) fn motion(&self, topic: &Topic) -> Option<Place> {
        let file = (self.edition.sources.motion)(topic.stem)?;
        let (file, _) = self.files.get_key_value(file)?;
        Some(Place::new(file, ""))
    }

    pub(super) fn entry(&self, topic: &Topic, claim: &Claim) -> Option<Place> {
        let (file, _) = self.files.get_key_value(topic.file.path)?;
        Some(Place::new(file, claim.id))
    }

    pub(super) fn trial(&self, trial: &Attempt) -> Option<Place> {
        let path = trial.file();
        let here = |file: &&String| {
            let stem = file.trim_end_matches(".rs");
            let above = path.strip_suffix(stem);
            let root = path == "src/" && matches!(stem, "main" | "lib");
            root || above.is_some_and(|above| above.is_empty() || above.ends_with('/'))
        };
        let file = self.files.keys().find(here)?;
        let name = trial.name();
        let name = name.rsplit_once("::").map_or(name, |(_, name)| name);
        Some(Place::new(file, name))
    }

    /// Without comments and tests.
    pub(super) fn lines(&self, modules: &[&str]) -> Html {
        let shown = self.files.iter().filter(|(file, _)| file.ends_with(".rs"));
        let shown = shown.map(|(file, source)| (path(file), source.text));
        let engine = texts(&ENGINE).into_iter();
        let engine = engine.map(|(file, text)| (format!("trialbook/src/{file}"), text));
        let all: Vec<_> = shown.chain(engine).collect();
        for module in modules {
            if !all.iter().any(|(file, _)| is_of_module(file, module)) {
                return Err(format!("there is no source `{module}`").into());
            }
        }
        let is_counted =
            |file: &str| !is_test(file) && modules.iter().any(|module| is_of_module(file, module));
        let counted = all.iter().filter(|(file, _)| is_counted(file));
        let lines = counted.map(|(_, text)| lines_of_code(text)).sum();
        let names: Vec<_> = modules.iter().map(|module| in_code(module)).collect();
        Ok(format!("{} lines in {}", count(lines), names.join(", ")))
    }

    pub(super) fn pages(&self) -> impl Iterator<Item = (String, String)> {
        self.files
            .iter()
            .map(|(file, source)| (page(file), code_page(file, source, self.edition.title)))
    }
}

static ENGINE: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/src");

fn is_of_module(file: &str, module: &str) -> bool {
    let rest = file.strip_prefix(module);
    rest.is_some_and(|rest| matches!(rest, "" | ".rs") || rest.starts_with('/'))
}

fn is_test(file: &str) -> bool {
    file.ends_with("/tests.rs") || file.contains("/tests/")
}

fn lines_of_code(text: &str) -> usize {
    let code = text
        .lines()
        .map(str::trim)
        .take_while(|line| *line != "mod tests {");
    code.filter(|line| !line.is_empty() && !line.starts_with("//") && *line != "#[cfg(test)]")
        .count()
}

fn functions(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().flat_map(|(i, line)| {
        let mut words = line.trim_start();
        for word in ["pub ", "pub(super) ", "pub(crate) "] {
            words = words.strip_prefix(word).unwrap_or(words);
        }
        let constant = words.strip_prefix("const ");
        let item = constant.unwrap_or(words).strip_prefix("fn ").or(constant);
        let name = item.and_then(|item| item.split(['(', '<', ':']).next());
        let row = || match words.split_once(" = ") {
            Some((row, _)) => Some(row),
            None => words.strip_suffix(" ="),
        };
        // A row of trials may have two names, `eq75 | corrected75 = `.
        let names = name.or_else(row).unwrap_or_default().split(" | ");
        let names = names.map(|name| name.trim_start_matches('&'));
        let is_name =
            |name: &&str| !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_');
        names.filter(is_name).map(move |name| (i, name))
    })
}

fn code_page(file: &str, source: &Source, book: &str) -> String {
    let text = source.text;
    let up = "../".repeat(file.matches('/').count() + 1);
    // Of several places of a name, the first.
    let mut anchors: Vec<(usize, &str)> = Vec::new();
    for (line, name) in source.places.iter().copied() {
        if !anchors.iter().any(|(_, taken)| *taken == name) {
            anchors.push((line, name));
        }
    }
    let mut code = String::with_capacity(text.len() * 2);
    let mut state = State::Plain;
    for (i, line) in text.lines().enumerate() {
        for (_, name) in anchors.iter().filter(|(line, _)| *line == i) {
            code += &format!("<a id=\"{}\"></a>", escape(name));
        }
        state = match file.ends_with(".rs") {
            true => highlight(line, state, &mut code),
            false => {
                code += &escape(line);
                state
            }
        };
        code.push('\n');
    }
    let book = escape(book);
    let path = path(file);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{file}</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
         <style>{STYLE}</style></head><body><header><a href=\"{up}index.html\">{book}</a></header>\
         <main><h1>{path}</h1><pre tabindex=\"0\"><code>{code}</code></pre></main></body></html>\n"
    )
}

const STYLE: &str = include_str!("../../theme/code.css");

#[derive(Clone, Copy, PartialEq)]
enum State {
    Plain,
    Text,
}

const KEYWORDS: &[&str] = &[
    "as", "break", "const", "continue", "crate", "else", "enum", "fn", "for", "if", "impl", "in",
    "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "Self", "static",
    "struct", "super", "trait", "type", "use", "where", "while",
];

fn highlight(line: &str, mut state: State, out: &mut String) -> State {
    let mut rest = line;
    while let Some(c) = rest.chars().next() {
        let (end, class) = if state == State::Text {
            (end_of_string(rest, &mut state), "s")
        } else if rest.starts_with("//") {
            (rest.len(), "c")
        } else if c == '"' {
            state = State::Text;
            (1 + end_of_string(&rest[1..], &mut state), "s")
        } else if c.is_alphabetic() || c == '_' {
            let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
            let end = end.unwrap_or(rest.len());
            let keyword = KEYWORDS.contains(&&rest[..end]);
            (end, if keyword { "k" } else { "" })
        } else if rest.starts_with("'\"'") {
            (3, "s")
        } else {
            (c.len_utf8(), "")
        };
        let text = escape(&rest[..end]);
        match class {
            "" => out.push_str(&text),
            class => out.push_str(&format!("<i class=\"{class}\">{text}</i>")),
        }
        rest = &rest[end..];
    }
    state
}

fn end_of_string(rest: &str, state: &mut State) -> usize {
    let mut escaped = false;
    for (at, c) in rest.char_indices() {
        match c {
            '"' if !escaped => {
                *state = State::Plain;
                return at + 1;
            }
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_tests_are_no_lines_of_code() {
        let text = "//! a\nuse b;\n\n/// c\nfn d() {} // e\n\n#[cfg(test)]\nmod tests {\n    fn f() {}\n}\n";
        assert_eq!(lines_of_code(text), 2);
        let of = |file| is_of_module(file, "src/a");
        assert_eq!(
            ["src/a.rs", "src/a/b.rs", "src/ab.rs"].map(of),
            [true, true, false]
        );
        assert!(
            is_test("src/a/tests.rs") && is_test("src/a/tests/b.rs") && !is_test("src/tests_of.rs")
        );
    }

    #[test]
    fn modules_are_counted_by_their_paths() {
        let edition = Edition::of("none", &crate::trials::Paper::BLANK);
        let lines = |modules: &[&str]| Code::new(&edition).lines(modules);
        let said = lines(&["trialbook/src/exact", "trialbook/src/scalar"]).unwrap();
        let (number, rest) = said.split_once(' ').unwrap();
        assert!(
            number.replace(',', "").parse::<usize>().unwrap() > 1000,
            "{said}"
        );
        assert_eq!(
            rest,
            "lines in <code>trialbook/src/exact</code>, <code>trialbook/src/scalar</code>"
        );
        assert!(lines(&["trialbook/src/exac"]).is_err());
    }

    #[test]
    fn rust_is_marked() {
        let mut out = String::new();
        assert!(
            highlight("let a = \"b \\\" // c\"; // <d>", State::Plain, &mut out) == State::Plain
        );
        assert_eq!(
            out,
            "<i class=\"k\">let</i> a = <i class=\"s\">&quot;b \\&quot; // c&quot;</i>; <i class=\"c\">// &lt;d&gt;</i>"
        );
        assert!(highlight("x(\"open", State::Plain, &mut out) == State::Text);
    }
}
