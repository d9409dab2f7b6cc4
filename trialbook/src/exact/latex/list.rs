//! From text to a list of items: names, numbers, signs, and what stands within each other.

use super::super::Function;
use super::{LatexError, Problem};
use crate::notation::letters::GREEK;

const DEEPEST: usize = 32;

const NAMES: &[&str] = &["infty", "perp"];

const ACCENTS: &[&str] = &["bm", "hat", "tilde", "dot", "ddot", "mathrm", "mathfrak"];

const FUNCTIONS: &[(&str, Function)] = &[
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("cot", Function::Cot),
    ("sinh", Function::Sinh),
    ("cosh", Function::Cosh),
    ("tanh", Function::Tanh),
    ("coth", Function::Coth),
    ("exp", Function::Exp),
    ("ln", Function::Ln),
];

const MARKS: &[(&str, char)] = &[("times", '×'), ("cdot", '·'), ("cdots", '⋯'), ("pm", '±')];

const SPACES: &[&str] = &[",", ";", ":", " ", "!", "quad", "qquad"];

#[derive(Debug, Clone)]
pub(super) struct Item {
    pub at: usize,
    pub spaced: bool,
    pub kind: Kind,
}

impl PartialEq for Item {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kind {
    /// A name of one letter: `v`, or `lambda` for `\lambda`.
    Letter(String),
    Number(String),
    Mark(char),
    Relation(Relation),
    Function(Function),
    Accent(&'static str, Vec<Item>),
    Fraction(Vec<Item>, Vec<Item>),
    Root(Vec<Item>),
    Bracket(Vec<Item>),
    Absolute(Vec<Item>),
    Sub(Vec<Item>),
    Sup(Vec<Item>),
    Cases(Vec<Vec<Item>>),
    Text(String),
}

#[derive(Clone, Copy, PartialEq)]
enum End {
    Text,
    Bracket(char),
    Bar,
    Cases,
}

pub(super) fn items(latex: &str) -> Result<Vec<Item>, LatexError> {
    let mut lister = Lister {
        chars: latex.chars().collect(),
        at: 0,
        depth: 0,
    };
    lister.list(End::Text)
}

struct Lister {
    chars: Vec<char>,
    at: usize,
    depth: usize,
}

impl Lister {
    fn peek(&self) -> Option<char> {
        self.chars.get(self.at).copied()
    }

    fn skip_blanks(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.at += 1;
        }
    }

    /// A command with its backslash, or a character; blanks before it do not count.
    fn token(&mut self) -> Option<(usize, String)> {
        self.skip_blanks();
        let at = self.at;
        let first = self.peek()?;
        self.at += 1;
        let mut token = String::from(first);
        if first == '\\' {
            token.extend(self.peek());
            self.at += 1;
            if token.ends_with(|c: char| c.is_ascii_alphabetic()) {
                while let Some(c) = self.peek().filter(char::is_ascii_alphabetic) {
                    token.push(c);
                    self.at += 1;
                }
            }
        }
        Some((at, token))
    }

    fn list(&mut self, end: End) -> Result<Vec<Item>, LatexError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Problem::TooDeep.at(self.at));
        }
        let start = self.at;
        let mut items = Vec::new();
        let mut spaced = false;
        loop {
            let Some((at, token)) = self.token() else {
                if end == End::Text {
                    break;
                }
                return Err(Problem::Bracket.at(start));
            };
            if SPACES.iter().any(|s| token.strip_prefix('\\') == Some(s)) {
                spaced = true;
                continue;
            }
            if self.ends(at, &token, end)? {
                break;
            }
            let kind = self.kind(at, token)?;
            items.push(Item { at, spaced, kind });
            spaced = false;
        }
        self.depth -= 1;
        Ok(items)
    }

    /// An error if it would end another.
    fn ends(&mut self, at: usize, token: &str, end: End) -> Result<bool, LatexError> {
        let token = match token {
            "\\right" => {
                let (_, delimiter) = self.token().unwrap_or_default();
                match &delimiter[..] {
                    "\\vert" | "|" => "\\rvert".to_owned(),
                    ")" | "]" | "\\}" => delimiter,
                    _ => return Err(Problem::Unknown(delimiter).at(at)),
                }
            }
            _ => token.to_owned(),
        };
        let closing = match &token[..] {
            ")" | "]" | "}" => End::Bracket(token.chars().next().unwrap_or_default()),
            // A brace that is printed, apart from one that is not.
            "\\}" => End::Bracket('\\'),
            "\\rvert" => End::Bar,
            "\\vert" | "|" if end == End::Bar => End::Bar,
            "\\end" => {
                self.environment()?;
                End::Cases
            }
            _ => return Ok(false),
        };
        if closing == end {
            Ok(true)
        } else {
            Err(Problem::Bracket.at(at))
        }
    }

    fn environment(&mut self) -> Result<(), LatexError> {
        let (at, name) = (self.at, self.words()?);
        if name == "cases" {
            Ok(())
        } else {
            Err(Problem::Unknown(name).at(at))
        }
    }

    fn words(&mut self) -> Result<String, LatexError> {
        let start = self.at;
        match self.token() {
            Some((_, brace)) if brace == "{" => {}
            _ => return Err(Problem::Missing.at(start)),
        }
        let from = self.at;
        while let Some(c) = self.peek() {
            self.at += 1;
            if c == '}' {
                return Ok(self.chars[from..self.at - 1].iter().collect());
            }
        }
        Err(Problem::Bracket.at(start))
    }

    fn argument(&mut self) -> Result<Vec<Item>, LatexError> {
        let start = self.at;
        let Some((at, token)) = self.token() else {
            return Err(Problem::Missing.at(start));
        };
        if token == "{" {
            return self.list(End::Bracket('}'));
        }
        // A single digit, as in `\frac12`.
        if token.starts_with(|c: char| c.is_ascii_digit()) {
            let kind = Kind::Number(token);
            return Ok(vec![Item {
                at,
                spaced: false,
                kind,
            }]);
        }
        if matches!(&token[..], ")" | "]" | "}" | "\\right" | "\\end") {
            return Err(Problem::Missing.at(at));
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Problem::TooDeep.at(at));
        }
        let kind = self.kind(at, token)?;
        self.depth -= 1;
        Ok(vec![Item {
            at,
            spaced: false,
            kind,
        }])
    }

    fn kind(&mut self, at: usize, token: String) -> Result<Kind, LatexError> {
        let unknown = |what: &str| Problem::Unknown(what.into()).at(at);
        if let Some(relation) = Relation::of(&token) {
            return Ok(Kind::Relation(relation));
        }
        let mut chars = token.chars();
        let first = chars.next().unwrap_or_default();
        if first != '\\' {
            return Ok(match first {
                '{' => Kind::Bracket(self.list(End::Bracket('}'))?),
                '(' => Kind::Bracket(self.list(End::Bracket(')'))?),
                '[' => Kind::Bracket(self.list(End::Bracket(']'))?),
                '|' => Kind::Absolute(self.list(End::Bar)?),
                '_' => Kind::Sub(self.argument()?),
                '^' => Kind::Sup(self.argument()?),
                '+' | '-' | '/' | ',' | '.' | ':' | '&' => Kind::Mark(first),
                _ if first.is_ascii_alphabetic() => Kind::Letter(token),
                _ if first.is_ascii_digit() => Kind::Number(self.number(token)),
                _ => return Err(unknown(&token)),
            });
        }
        let command = chars.as_str();
        if let Some((_, function)) = FUNCTIONS.iter().find(|(name, _)| *name == command) {
            return Ok(Kind::Function(*function));
        }
        if let Some((_, mark)) = MARKS.iter().find(|(name, _)| *name == command) {
            return Ok(Kind::Mark(*mark));
        }
        if let Some(accent) = ACCENTS.iter().find(|name| **name == command) {
            return Ok(Kind::Accent(accent, self.argument()?));
        }
        if NAMES.contains(&command) || GREEK.iter().any(|(name, _)| *name == command) {
            return Ok(Kind::Letter(command.into()));
        }
        Ok(match command {
            "frac" | "tfrac" => {
                let above = self.argument()?;
                Kind::Fraction(above, self.argument()?)
            }
            "sqrt" => Kind::Root(self.argument()?),
            "{" => Kind::Bracket(self.list(End::Bracket('\\'))?),
            "vert" | "lvert" => Kind::Absolute(self.list(End::Bar)?),
            "left" => match self.token() {
                Some((at, delimiter))
                    if matches!(&delimiter[..], "(" | "[" | "\\{" | "\\vert" | "|") =>
                {
                    self.kind(at, delimiter)?
                }
                _ => return Err(unknown(&token)),
            },
            "begin" => {
                self.environment()?;
                let lines = self.list(End::Cases)?;
                let new_line = |item: &Item| item.kind == Kind::Mark('\n');
                Kind::Cases(lines.split(new_line).map(<[Item]>::to_vec).collect())
            }
            "\\" => Kind::Mark('\n'),
            "text" | "mbox" => Kind::Text(self.words()?),
            _ => return Err(unknown(&token)),
        })
    }

    fn number(&mut self, mut digits: String) -> String {
        let digit = |c: Option<&char>| c.is_some_and(char::is_ascii_digit);
        let mut point = false;
        loop {
            let next = self.chars.get(self.at);
            let decimal = !point && next == Some(&'.') && digit(self.chars.get(self.at + 1));
            if !decimal && !digit(next) {
                return digits;
            }
            point |= decimal;
            digits.extend(next);
            self.at += 1;
        }
    }
}

/// How two sides are related.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// =
    Equal,
    /// <
    Less,
    /// >
    Greater,
    /// ≤
    AtMost,
    /// ≥
    AtLeast,
    /// ~
    Like,
    /// ≈
    About,
    /// ≃
    Nearly,
    /// ≪
    MuchLess,
    /// ≫
    MuchGreater,
    /// →
    Tends,
}

const RELATIONS: &[(&str, Relation)] = &[
    ("=", Relation::Equal),
    ("<", Relation::Less),
    (">", Relation::Greater),
    ("\\leq", Relation::AtMost),
    ("\\le", Relation::AtMost),
    ("\\geq", Relation::AtLeast),
    ("\\ge", Relation::AtLeast),
    ("\\sim", Relation::Like),
    ("\\approx", Relation::About),
    ("\\simeq", Relation::Nearly),
    ("\\ll", Relation::MuchLess),
    ("\\gg", Relation::MuchGreater),
    ("\\to", Relation::Tends),
];

impl Relation {
    fn of(token: &str) -> Option<Self> {
        let known = RELATIONS.iter().find(|(name, _)| *name == token);
        known.map(|(_, relation)| *relation)
    }
}
