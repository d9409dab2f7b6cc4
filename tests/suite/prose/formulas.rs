//! Formulas in running text: what of them is true as it stands.

use super::compare;
use slipbook::exact::{
    Expr,
    latex::{LatexError, Lexicon, Problem, Relation, Side, Statement, Value, statements},
};
use slipbook::scalar::Scalar;

#[derive(Debug, Clone, PartialEq)]
pub enum Found {
    /// All its relations hold for all values of what is not given, or between numbers.
    Holds,
    /// It is understood, and does not hold for all values.
    Open,
    /// The reader of LaTeX does not understand it.
    Unread(String),
    /// Two numbers are not related as it says.
    Wrong(String),
}

#[derive(Debug, Clone, Default)]
pub struct Given {
    names: Vec<(String, Value)>,
    /// A formula that says what a name is may not change that.
    fixed: bool,
}

impl Given {
    pub fn new() -> Self {
        Self::default()
    }

    pub fn push(&mut self, name: (String, Value)) {
        self.names.push(name);
    }

    pub fn len(&self) -> usize {
        self.names.len()
    }

    pub fn complete(&mut self, later: &Self) {
        for (name, value) in &later.names {
            if self.names.iter().all(|(known, _)| known != name) {
                self.push((name.clone(), *value));
            }
        }
    }

    pub fn with(given: Self) -> Self {
        Self {
            fixed: true,
            ..given
        }
    }
}

fn lexicon(given: &Given) -> Lexicon {
    let mut lexicon = Lexicon::new();
    for (name, value) in &given.names {
        lexicon.add(name, *value).expect("a name");
    }
    for e in [r"\mathrm e", r"\mathrm{e}"] {
        let e = lexicon.add(e, Value::Number(Expr::int(1).exp()));
        e.expect("a name");
    }
    lexicon
}

/// Whatever has no meaning is a symbol, or three if it is bold.
pub fn read(latex: &str, side: &Side, given: &Given) -> Result<Value, LatexError> {
    let mut lexicon = lexicon(given);
    loop {
        let error = match side.read(&lexicon) {
            Err(error) if matches!(error.problem, Problem::Name { .. }) => error,
            other => return other,
        };
        let name = name_at(latex, error.at);
        let symbol = |i: &str| Expr::symbol(format!("{name}{i}").leak());
        let value = match name.contains(r"\bm") {
            true => Value::Vector(["₁", "₂", "₃"].map(symbol)),
            false => Value::Number(symbol("")),
        };
        // A name that adds nothing would be asked for again.
        let size = lexicon.clone();
        lexicon.add(&name, value)?;
        if side.read(&lexicon) == side.read(&size) {
            return Err(error);
        }
    }
}

/// A letter or command, its argument, and its subscript.
fn name_at(latex: &str, at: usize) -> String {
    let chars: Vec<char> = latex.chars().collect();
    let mut end = part(&chars, at);
    let first: String = chars[at..end].iter().collect();
    if ["bm", "hat", "tilde", "dot", "ddot", "mathrm", "mathfrak"]
        .iter()
        .any(|accent| first == format!("\\{accent}"))
    {
        end = part(&chars, end);
    }
    if chars.get(end) == Some(&'_') {
        end = part(&chars, end + 1);
    }
    chars[at..end].iter().collect()
}

/// A character, a command with its argument if it changes a name, or what stands in braces.
fn part(chars: &[char], mut at: usize) -> usize {
    while chars.get(at) == Some(&' ') {
        at += 1;
    }
    match chars.get(at) {
        Some('\\') => {
            let letters = chars[at + 1..]
                .iter()
                .take_while(|c| c.is_ascii_alphabetic());
            let end = at + 1 + letters.count();
            let command: String = chars[at + 1..end].iter().collect();
            match ["mathrm", "mathfrak", "bm"].contains(&&command[..]) {
                true => part(chars, end),
                false => end,
            }
        }
        Some('{') => {
            let mut depth = 0;
            for (i, c) in chars[at..].iter().enumerate() {
                depth += i32::from(*c == '{') - i32::from(*c == '}');
                if depth == 0 {
                    return at + i + 1;
                }
            }
            chars.len()
        }
        _ => (at + 1).min(chars.len()),
    }
}

/// None if nothing is related. What it says some names are is given from there on.
pub fn found(latex: &str, given: &mut Given) -> Option<Found> {
    let statements = match statements(latex) {
        Ok(statements) => statements,
        Err(why) => {
            let related = [
                "=", "<", ">", r"\le", r"\ge", r"\sim", r"\approx", r"\to", r"\ll", r"\gg",
            ];
            let any = related.iter().any(|sign| latex.contains(sign));
            return any.then(|| Found::Unread(why.to_string()));
        }
    };
    if statements
        .iter()
        .all(|statement| statement.relations.is_empty())
    {
        return None;
    }
    let mut all = Found::Holds;
    for statement in &statements {
        // Of a name that is given once more, what it was is forgotten.
        if !given.fixed
            && let Some(Ok(value)) = statement
                .sides
                .first()
                .map(|side| read(latex, side, &Given::new()))
        {
            given
                .names
                .retain(|(name, _)| Some(&name[..]) != symbol(value));
        }
        let sides: Vec<_> = statement
            .sides
            .iter()
            .map(|side| read(latex, side, given))
            .collect();
        if let Some(Err(why)) = sides.iter().find(|side| side.is_err()) {
            return Some(Found::Unread(why.to_string()));
        }
        let sides: Vec<Value> = sides.into_iter().flatten().collect();
        for (pair, relation) in sides.windows(2).zip(&statement.relations) {
            match related(latex, pair[0], pair[1], *relation) {
                Some(true) => {}
                Some(false) => {
                    return Some(Found::Wrong(format!(
                        "{:?} {relation:?} {:?}",
                        pair[0], pair[1]
                    )));
                }
                None => all = Found::Open,
            }
        }
        if let ([name, .., last], [Relation::Equal, ..]) = (&sides[..], &statement.relations[..])
            && let Some(symbol) = symbol(*name)
            && number(*last).is_some()
            && !given.fixed
            && statement.relations.iter().all(|r| *r == Relation::Equal)
        {
            given.push((symbol.to_owned(), *last));
        }
    }
    Some(all)
}

pub fn is_arithmetic(latex: &str, given: &Given) -> bool {
    let statements = statements(latex).unwrap_or_default();
    statements.iter().any(|statement| {
        let numbers = statement
            .sides
            .iter()
            .map(|side| number(read(latex, side, given).ok()?));
        numbers
            .collect::<Vec<_>>()
            .windows(2)
            .any(|pair| pair.iter().all(Option::is_some))
    })
}

pub fn is_name(latex: &str) -> bool {
    let sides = statements(latex).unwrap_or_default();
    let [Statement { sides, .. }] = &sides[..] else {
        return false;
    };
    let value = sides.first().map(|side| read(latex, side, &Given::new()));
    let name = value.and_then(|value| match value.ok()? {
        Value::Vector([x, ..]) | Value::Number(x) => symbol(Value::Number(x)),
    });
    sides.len() == 1 && !latex.starts_with('+') && name.is_some()
}

fn symbol(side: Value) -> Option<&'static str> {
    match side.number()?.node() {
        slipbook::exact::Node::Symbol(name) => Some(name),
        _ => None,
    }
}

pub fn number(side: Value) -> Option<f64> {
    side.number()?.evaluate(&|_| None)
}

/// None if that depends on what is not given.
fn related(latex: &str, a: Value, b: Value, relation: Relation) -> Option<bool> {
    if let (Some(x), Some(y)) = (number(a), number(b)) {
        let half = 0.5 * 0.1_f64.powi(decimals(latex)) * (1.0 + 1e-9);
        let (near, exact) = (
            (x - y).abs() <= half,
            (x - y).abs() <= 1e-11 * x.abs().max(1e-3),
        );
        return Some(match relation {
            Relation::Equal if decimals(latex) == 0 => exact,
            Relation::Equal | Relation::About | Relation::Nearly => near,
            Relation::Less => x < y,
            Relation::Greater => x > y,
            Relation::AtMost => x <= y,
            Relation::AtLeast => x >= y,
            Relation::MuchLess | Relation::MuchGreater | Relation::Like | Relation::Tends => {
                return None;
            }
        });
    }
    let parts = |value: Value| match value {
        Value::Number(x) => vec![x],
        Value::Vector(x) => x.to_vec(),
    };
    let (a, b) = (parts(a), parts(b));
    let same = a.len() == b.len()
        && a.iter()
            .zip(&b)
            .all(|(a, b)| compare::differ(*a, *b).is_none());
    (relation == Relation::Equal && same).then_some(true)
}

/// 0 if there is none. A full stop at its end is no part of it.
fn decimals(latex: &str) -> i32 {
    let latex = latex.trim_end_matches(['.', ',', ':', ' ']);
    let after = latex.rsplit_once('.').map_or("", |(_, after)| after);
    after.chars().take_while(char::is_ascii_digit).count() as i32
}
