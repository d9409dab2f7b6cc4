//! Statements of Rocq, read as far as `coqc` prints them here.

use std::collections::BTreeSet;

/// A term, or a statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Term {
    /// A name, without the file before it, or a number.
    Name(String),
    /// A function or predicate and what it is of.
    Of(String, Vec<Term>),
    /// A value of a function that has no name.
    Value(Box<Term>, Vec<Term>),
    /// Terms with the signs between them: more than one for `0 <= s <= t`.
    Joined(Box<Term>, Vec<(&'static str, Term)>),
    /// A sign before a term: `-`, `/` or `~`.
    Before(&'static str, Box<Term>),
    /// `forall`, `exists` or `fun`: what is bound, with its sort, and the term.
    Bound(&'static str, Vec<(String, String)>, Box<Term>),
    /// `let … := … in …`.
    Let(String, Box<Term>, Box<Term>),
    /// `if … then … else …`.
    If(Box<Term>, Box<Term>, Box<Term>),
    /// A pair or more.
    Tuple(Vec<Term>),
}

/// The loosest first; those of a line bind alike.
const SIGNS: [&[&str]; 7] = [
    &["->"],
    &["<->"],
    &["\\/"],
    &["/\\"],
    &["=", "<>", "<", "<=", ">", ">="],
    &["+", "-", "::"],
    &["*", "/"],
];
const LONG: [&str; 10] = [
    "::", "<->", "->", "/\\", "\\/", "<=", ">=", "<>", ":=", "=>",
];
const BINDERS: [&str; 3] = ["forall", "exists", "fun"];

impl Term {
    /// Reads a statement; nothing for what is written otherwise.
    pub fn read(text: &str) -> Option<Term> {
        let mut reader = Reader {
            words: words(text),
            at: 0,
        };
        let term = reader.term()?;
        (reader.at == reader.words.len()).then_some(term)
    }

    /// The names in it, but for those of what is bound in it.
    pub fn free(&self) -> BTreeSet<&str> {
        let mut names = BTreeSet::new();
        self.gather(&mut Vec::new(), &mut names);
        names
    }

    fn gather<'a>(&'a self, bound: &mut Vec<&'a str>, names: &mut BTreeSet<&'a str>) {
        let known = bound.len();
        match self {
            Term::Name(name) | Term::Of(name, _) if !bound.contains(&name.as_str()) => {
                names.insert(name);
            }
            Term::Bound(_, own, _) => bound.extend(own.iter().map(|(name, _)| name.as_str())),
            Term::Let(name, value, _) => {
                value.gather(bound, names);
                bound.push(name);
            }
            _ => {}
        }
        match self {
            Term::Name(_) => {}
            Term::Of(_, of) | Term::Tuple(of) => of.iter().for_each(|one| one.gather(bound, names)),
            Term::Value(head, of) => std::iter::once(&**head)
                .chain(of)
                .for_each(|one| one.gather(bound, names)),
            Term::Joined(first, rest) => {
                let all = std::iter::once(&**first).chain(rest.iter().map(|(_, one)| one));
                all.for_each(|one| one.gather(bound, names));
            }
            Term::Before(_, one) | Term::Bound(_, _, one) | Term::Let(_, _, one) => {
                one.gather(bound, names)
            }
            Term::If(a, b, c) => [a, b, c]
                .into_iter()
                .for_each(|one| one.gather(bound, names)),
        }
        bound.truncate(known);
    }

    /// What a statement supposes.
    pub fn supposed(&self) -> Vec<&Term> {
        match self {
            Term::Bound("forall", _, body) => body.supposed(),
            Term::Let(_, _, body) => body.supposed(),
            Term::Joined(first, rest) if rest[0].0 == "->" => {
                let mut all: Vec<&Term> = vec![first];
                all.extend(rest.iter().map(|(_, term)| term));
                let last = all.pop();
                all.extend(last.into_iter().flat_map(Term::supposed));
                all
            }
            _ => Vec::new(),
        }
    }
}

fn words(text: &str) -> Vec<&str> {
    let mut out = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '.');
        let length = match LONG.iter().find(|sign| rest.starts_with(**sign)) {
            Some(sign) => sign.len(),
            None if name(first) => rest.find(|c: char| !name(c)).unwrap_or(rest.len()),
            // In which scope something is read says nothing.
            None if first == '%' => rest.find([' ', ')', ',']).unwrap_or(rest.len()),
            None => first.len_utf8(),
        };
        if first != '%' {
            out.push(&rest[..length]);
        }
        rest = rest[length..].trim_start();
    }
    out
}

struct Reader<'a> {
    words: Vec<&'a str>,
    at: usize,
}

impl<'a> Reader<'a> {
    fn next(&self) -> &'a str {
        self.words.get(self.at).copied().unwrap_or_default()
    }

    fn take(&mut self) -> &'a str {
        let word = self.next();
        self.at += 1;
        word
    }

    fn comes(&mut self, word: &str) -> bool {
        let comes = self.next() == word;
        self.at += usize::from(comes);
        comes
    }

    fn must(&mut self, word: &str) -> Option<()> {
        self.comes(word).then_some(())
    }

    fn term(&mut self) -> Option<Term> {
        self.read_joined(0)
    }

    fn open(&mut self) -> Option<Term> {
        if let Some(binder) = BINDERS.into_iter().find(|binder| *binder == self.next()) {
            self.at += 1;
            let end = if binder == "fun" { "=>" } else { "," };
            let mut bound = Vec::new();
            while self.next() != end {
                let bracketed = self.comes("(");
                let mut names = Vec::new();
                while !matches!(self.next(), ":" | "," | "=>" | ")" | "") {
                    names.push(self.take());
                }
                let mut what = Vec::new();
                if self.comes(":") {
                    let mut depth = 0;
                    while !(depth == 0 && (self.next() == end || self.next() == ")" && bracketed)) {
                        match self.take() {
                            "" => return None,
                            "(" => depth += 1,
                            ")" => depth -= 1,
                            word => what.push(word),
                        }
                    }
                }
                if bracketed {
                    self.must(")")?;
                }
                bound.extend(
                    names
                        .iter()
                        .map(|name| ((*name).to_owned(), what.join(" "))),
                );
            }
            self.must(end)?;
            return Some(Term::Bound(binder, bound, Box::new(self.term()?)));
        }
        if self.comes("let") {
            let name = self.take().to_owned();
            self.must(":=")?;
            let value = self.term()?;
            self.must("in")?;
            return Some(Term::Let(name, Box::new(value), Box::new(self.term()?)));
        }
        self.must("if")?;
        let mut parts = vec![self.term()?];
        for word in ["then", "else"] {
            self.must(word)?;
            parts.push(self.term()?);
        }
        let [a, b, c] = parts.try_into().ok()?;
        Some(Term::If(Box::new(a), Box::new(b), Box::new(c)))
    }

    fn read_joined(&mut self, level: usize) -> Option<Term> {
        if BINDERS.contains(&self.next()) || matches!(self.next(), "let" | "if") {
            return self.open();
        }
        let Some(signs) = SIGNS.get(level) else {
            return self.before();
        };
        // Where `~` stands: tighter than "and", looser than "equal".
        if level == 4 && self.comes("~") {
            return Some(Term::Before("~", Box::new(self.read_joined(4)?)));
        }
        let first = self.read_joined(level + 1)?;
        let mut rest = Vec::new();
        while let Some(sign) = signs.iter().find(|sign| **sign == self.next()) {
            self.at += 1;
            rest.push((*sign, self.read_joined(level + 1)?));
        }
        Some(match rest.is_empty() {
            true => first,
            false => Term::Joined(Box::new(first), rest),
        })
    }

    fn before(&mut self) -> Option<Term> {
        for sign in ["-", "/"] {
            if self.comes(sign) {
                return Some(Term::Before(sign, Box::new(self.before()?)));
            }
        }
        let base = self.read_applied()?;
        match self.comes("^") {
            true => Some(Term::Joined(Box::new(base), vec![("^", self.before()?)])),
            false => Some(base),
        }
    }

    fn read_applied(&mut self) -> Option<Term> {
        let head = self.atom()?;
        let mut of = Vec::new();
        while self.next() == "("
            || self
                .next()
                .starts_with(|c: char| c.is_alphanumeric() || c == '_')
        {
            if matches!(self.next(), "in" | "then" | "else") {
                break;
            }
            of.push(self.atom()?);
        }
        Some(match (head, of.is_empty()) {
            (head, true) => head,
            (Term::Name(name), false) => Term::Of(name, of),
            (head, false) => Term::Value(Box::new(head), of),
        })
    }

    fn atom(&mut self) -> Option<Term> {
        if self.comes("(") {
            let mut parts = vec![self.term()?];
            while self.comes(",") {
                parts.push(self.term()?);
            }
            self.must(")")?;
            return match parts.len() {
                1 => parts.pop(),
                _ => Some(Term::Tuple(parts)),
            };
        }
        let word = self.take();
        let named = word.starts_with(|c: char| c.is_alphanumeric() || c == '_');
        let own = word
            .rsplit('.')
            .next()
            .filter(|own| named && !own.is_empty())?;
        Some(Term::Name(own.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_statement_is_read_to_its_end() {
        let name = |text: &str| Term::Name(text.to_owned());
        let read = |text: &str| Term::read(text).unwrap_or_else(|| panic!("{text}"));
        assert_eq!(
            read("0 <= s < t /\\ ~ a = b"),
            Term::Joined(
                Box::new(Term::Joined(
                    Box::new(name("0")),
                    vec![("<=", name("s")), ("<", name("t"))]
                )),
                vec![(
                    "/\\",
                    Term::Before(
                        "~",
                        Box::new(Term::Joined(Box::new(name("a")), vec![("=", name("b"))]))
                    )
                )]
            )
        );
        assert_eq!(
            read("- x ^ 2"),
            Term::Before(
                "-",
                Box::new(Term::Joined(Box::new(name("x")), vec![("^", name("2"))]))
            )
        );
        assert_eq!(
            read("Formulas.eq5 (v 0)"),
            Term::Of("eq5".into(), vec![Term::Of("v".into(), vec![name("0")])])
        );
        let Term::Bound("forall", bound, _) =
            read("forall (k : R) (x y : R -> R), motion k (fun _ : R => - A) x y -> True")
        else {
            panic!()
        };
        let real = |name: &str| (name.to_owned(), "R -> R".to_owned());
        assert_eq!(
            bound,
            [("k".to_owned(), "R".to_owned()), real("x"), real("y")]
        );
        for text in [
            "exists t0 : R, 0 <= t0 /\\ (forall t : R, t0 <= t -> x t = 0)",
            "let p := (a, b, 0) in p = q <-> z = 0",
            "(fun x : R => x) 2 = 2",
        ] {
            assert!(Term::read(text).is_some(), "{text}");
        }
        assert_eq!(Term::read("0 <= "), None);
        assert_eq!(Term::read("(a"), None);
    }
}
