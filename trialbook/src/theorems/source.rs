//! What files of Rocq declare, and which of it a statement speaks of.

use std::collections::{BTreeMap, BTreeSet};

/// What a sentence declares.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// The file, by its path from the folder.
    pub file: String,
    /// Its name.
    pub name: String,
    /// The word it begins with: `Theorem`, `Definition`, `Record`.
    pub word: &'static str,
    /// What the comment before it says; empty for none.
    pub about: String,
    /// The sentence, without comments and with single spaces.
    pub text: String,
    /// What is declared in the sections in which it stands.
    pub context: Vec<String>,
    /// The line in which it begins, from 1.
    pub line: usize,
    /// From which byte to which it stands, with its proof.
    pub span: [usize; 2],
}

const MEANINGS: [&str; 5] = ["Definition", "Record", "Fixpoint", "Inductive", "Notation"];
const PROVED: [&str; 3] = ["Theorem", "Lemma", "Corollary"];
const WITHIN: [&str; 7] = [
    "Variable",
    "Variables",
    "Hypothesis",
    "Hypotheses",
    "Context",
    "Let",
    "Notation",
];

impl Item {
    /// The file's name without folders and ending.
    pub fn stem(&self) -> &str {
        let name = self.file.rsplit('/').next().unwrap_or_default();
        name.trim_end_matches(".v")
    }

    /// True if it is a theorem or a lemma.
    pub(crate) fn is_proved(&self) -> bool {
        PROVED.contains(&self.word)
    }
}

/// All that the files declare.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    /// In the files' order.
    pub items: Vec<Item>,
    meanings: BTreeMap<String, Vec<usize>>,
    requires: BTreeMap<String, Vec<String>>,
}

impl Sources {
    /// Reads files, each a path and a text.
    pub fn read<'a>(files: impl Iterator<Item = (&'a str, &'a str)>) -> Self {
        let (mut items, mut requires) = (Vec::new(), BTreeMap::new());
        for (path, text) in files {
            items.extend(declared(path, text));
            let lines = text.lines().filter(|line| line.contains("Require"));
            let names = lines.flat_map(names).map(str::to_owned);
            requires.insert(path.to_owned(), names.collect());
        }
        let mut meanings: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (i, item) in items
            .iter()
            .enumerate()
            .filter(|(_, item)| MEANINGS.contains(&item.word))
        {
            meanings.entry(item.name.clone()).or_default().push(i);
        }
        Sources {
            items,
            meanings,
            requires,
        }
    }

    /// The theorem or lemma of this name.
    pub fn proved(&self, name: &str) -> Option<&Item> {
        self.items
            .iter()
            .find(|item| item.is_proved() && item.name == name)
    }

    /// The definition of a name, with the file before it or without: `line`, `Line.line`.
    pub fn meaning(&self, name: &str) -> Option<&Item> {
        let (file, own) = name.rsplit_once('.').unwrap_or(("", name));
        let all = self.meanings.get(own)?;
        let there = all.iter().find(|i| self.items[**i].stem() == file);
        self.items.get(*there.or(all.first())?)
    }

    /// Whether a file requires one of this name, also through others.
    pub fn requires(&self, file: &str, name: &str) -> bool {
        let (mut open, mut known) = (vec![file], BTreeSet::new());
        while let Some(file) = open.pop() {
            let required = self.requires.get(file).map_or(&[][..], Vec::as_slice);
            if required.iter().any(|required| required == name) {
                return true;
            }
            let stem = |path: &str| {
                path.rsplit('/')
                    .next()
                    .map(|name| name.trim_end_matches(".v").to_owned())
            };
            let next = self
                .requires
                .keys()
                .filter(|path| stem(path).is_some_and(|stem| required.contains(&stem)));
            open.extend(
                next.filter(|path| known.insert(path.as_str()))
                    .map(String::as_str),
            );
        }
        false
    }

    /// What a text of a file uses, and what that uses: the nearest of one name.
    pub fn used<'a>(
        &'a self,
        texts: impl Iterator<Item = &'a str>,
        file: &'a str,
    ) -> BTreeSet<usize> {
        self.reached(texts.flat_map(names), file, |_, _| true)
    }

    /// What is of the same file, or all elsewhere that a file may mean.
    fn reached<'a>(
        &'a self,
        named: impl Iterator<Item = &'a str>,
        file: &'a str,
        may: impl Fn(&str, &Item) -> bool,
    ) -> BTreeSet<usize> {
        let mut known = BTreeSet::new();
        let mut open: Vec<_> = named.map(|name| (name, file)).collect();
        while let Some((name, file)) = open.pop() {
            let all = self.meanings.get(name).map_or(&[][..], Vec::as_slice);
            let here = all.iter().find(|i| self.items[**i].file == file);
            for i in here.map_or(all, std::slice::from_ref) {
                let item = &self.items[*i];
                if (here.is_some() || may(file, item)) && known.insert(*i) {
                    let texts = item.context.iter().chain([&item.text]);
                    let named = texts.flat_map(|text| names(text));
                    open.extend(named.map(|name| (name, item.file.as_str())));
                }
            }
        }
        known
    }

    /// What the statement of a theorem uses.
    pub fn behind<'a>(&'a self, item: &'a Item) -> BTreeSet<usize> {
        let texts = item.context.iter().chain([&item.text]).map(String::as_str);
        self.used(texts, &item.file)
    }

    /// What a statement of a file, as `coqc` prints it, speaks of, and what that does, for readers: without
    /// what it binds. [`Sources::behind`] leaves nothing out.
    pub fn explains<'a>(&'a self, statement: &'a str, file: &'a str) -> Vec<&'a Item> {
        let mut binders = statement.split(':');
        binders.next_back();
        let ends = ["forall", "exists", "fun", "(", ","];
        let bound = binders.flat_map(|part| {
            let ends = ends.iter();
            let last = ends.filter_map(|end| Some(part.rfind(end)? + end.len()));
            names(&part[last.max().unwrap_or(0)..])
        });
        let bound: BTreeSet<_> = bound.collect();
        let free = names(statement).filter(|name| !bound.contains(name));
        let all = self.reached(free, file, |file, item| self.requires(file, item.stem()));
        all.into_iter().map(|i| &self.items[i]).collect()
    }

    /// Another number when the statement's text, or one that it uses, is another but for spaces.
    pub fn mark(&self, item: &Item) -> u64 {
        let used = self.behind(item);
        let mut texts: Vec<String> = used.iter().map(|i| self.items[*i].text.clone()).collect();
        texts.sort_unstable();
        texts.extend(item.context.iter().cloned());
        texts.push(item.text.clone());
        // The hash of Fowler, Noll and Vo.
        let bytes = texts
            .iter()
            .flat_map(|text| text.bytes().filter(|byte| *byte != b' '));
        bytes.fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
            (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
    }
}

/// The names in a text, without the files before them.
pub fn names(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '\'' | '.')));
    words.filter_map(|word| word.trim_end_matches('.').rsplit('.').next())
}

struct Sentence {
    text: String,
    about: String,
    span: [usize; 2],
}

fn sentences(file: &str) -> Vec<Sentence> {
    let mut out = Vec::new();
    let (mut text, mut comment, mut about) = (String::new(), String::new(), String::new());
    let (mut depth, mut quoted, mut start) = (0, false, 0);
    let mut chars = file.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        let next = chars.peek().map(|(_, c)| *c);
        match (c, next) {
            ('(', Some('*')) if !quoted => {
                chars.next();
                depth += 1;
                if depth == 1 {
                    comment.clear();
                }
            }
            ('*', Some(')')) if depth > 0 => {
                chars.next();
                depth -= 1;
                if depth == 0 && text.trim().is_empty() {
                    about = comment.split_whitespace().collect::<Vec<_>>().join(" ");
                }
            }
            _ if depth > 0 => comment.push(c),
            ('.', None) | ('.', Some(' ' | '\n' | '\t')) if !quoted => {
                let words: Vec<_> = text.split_whitespace().collect();
                out.push(Sentence {
                    text: words.join(" "),
                    about: std::mem::take(&mut about),
                    span: [start, at + 1],
                });
                text.clear();
            }
            _ => {
                quoted ^= c == '"';
                if text.is_empty() && c.is_whitespace() {
                    // An empty line parts a comment from what follows it.
                    if c == '\n' && next == Some('\n') {
                        about.clear();
                    }
                    continue;
                }
                if text.is_empty() {
                    start = at;
                }
                text.push(c);
            }
        }
    }
    out
}

fn declared(file: &str, text: &str) -> Vec<Item> {
    let mut items: Vec<Item> = Vec::new();
    let mut sections: Vec<Vec<String>> = Vec::new();
    let mut in_proof = false;
    for sentence in sentences(text) {
        let said = sentence
            .text
            .trim_start_matches(['-', '+', '*', '{', '}', ' ']);
        let first = said.split(' ').next().unwrap_or_default();
        if in_proof {
            if ["Qed", "Defined", "Abort", "Admitted"].contains(&first) {
                in_proof = false;
                if let Some(last) = items.last_mut() {
                    last.span[1] = sentence.span[1];
                }
            }
            continue;
        }
        match first {
            "Section" | "Module" => sections.push(Vec::new()),
            "End" => drop(sections.pop()),
            "Proof" => in_proof = true,
            _ => {
                let known = MEANINGS.iter().chain(&PROVED).find(|word| **word == first);
                let within = WITHIN.contains(&first);
                if let (true, Some(section)) = (within, sections.last_mut()) {
                    section.push(said.to_owned());
                } else if let Some(word) = known {
                    let rest = said[first.len()..].trim_start();
                    let end = rest
                        .find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\''))
                        .unwrap_or(rest.len());
                    items.push(Item {
                        file: file.to_owned(),
                        name: rest[..end].to_owned(),
                        word,
                        about: sentence.about,
                        text: said.to_owned(),
                        context: sections.concat(),
                        line: 1 + text[..sentence.span[0]].matches('\n').count(),
                        span: sentence.span,
                    });
                    in_proof = PROVED.contains(word);
                }
            }
        }
    }
    items
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "(* The head. *)\n\n(* How fast. *)\nDefinition fast (x : R) := x.\nSection S.\nVariable k : R.\n\
        Hypothesis hk : 0 < k. (* a remark *)\n(* It stops, \n at once. *)\nTheorem eq_1 x : fast x\n  = k. Proof. now trivial. Qed.\n\
        End S.\nLemma other : True.\nProof. exact I. Qed.\n";

    fn read(text: &str) -> Sources {
        Sources::read([("A.v", text)].into_iter())
    }

    #[test]
    fn a_statement_is_explained_by_what_its_file_knows() {
        let files = [
            (
                "A.v",
                "Definition fast x := x + d.\nDefinition d := 1.\nDefinition t := 2.",
            ),
            (
                "B.v",
                "Require Import A.\nDefinition d := 3.\nDefinition slow x := fast x - d.",
            ),
            ("C.v", "Definition fast x := 5.\nDefinition slow x := 6."),
        ];
        let sources = Sources::read(files.into_iter());
        let explained = |statement| {
            let items = sources.explains(statement, "B.v").into_iter();
            items
                .map(|item| format!("{} {}", item.file, item.name))
                .collect::<Vec<_>>()
        };
        let slow = ["A.v fast", "A.v d", "B.v d", "B.v slow"];
        assert_eq!(explained("forall t : R,\n0 <= t -> B.slow t"), slow);
        assert_eq!(explained("(forall x d : R, x = d) /\\ t = 1"), ["A.v t"]);
        assert_eq!(explained("exists fast : R, fast = 1"), [""; 0]);
    }

    #[test]
    fn a_theorem_is_known_by_its_statement_and_what_that_speaks_of() {
        let sources = read(FILE);
        let names: Vec<_> = sources.items.iter().map(|item| &*item.name).collect();
        assert_eq!(names, ["fast", "eq_1", "other"]);
        let theorem = sources.proved("eq_1").unwrap();
        assert_eq!(theorem.about, "It stops, at once.");
        assert_eq!(theorem.text, "Theorem eq_1 x : fast x = k");
        assert_eq!(theorem.context, ["Variable k : R", "Hypothesis hk : 0 < k"]);
        assert_eq!(
            (theorem.line, &FILE[theorem.span[1] - 4..theorem.span[1]]),
            (10, "Qed.")
        );
        assert_eq!(sources.items[0].about, "How fast.");
        let mark = |text: &str| {
            let sources = read(text);
            sources.mark(sources.proved("eq_1").unwrap())
        };
        let own = mark(FILE);
        // Neither comments nor proofs nor other theorems are part of it.
        for (from, to) in [
            ("now trivial", "auto"),
            ("a remark", "two"),
            ("True", "1 = 1"),
            (":= x", ":=\n x"),
        ] {
            assert_eq!(mark(&FILE.replace(from, to)), own, "{from}");
        }
        for (from, to) in [(":= x", ":= 2"), ("0 < k", "0 <= k"), ("= k", "= 1")] {
            assert_ne!(mark(&FILE.replace(from, to)), own, "{from}");
        }
    }
}
