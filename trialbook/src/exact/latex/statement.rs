//! A text split into statements, a statement into sides.

use super::list::{Item, Kind, Relation, items};
use super::read::{Lexicon, Value};
use super::{LatexError, Problem};

/// One formula: its sides and the relations between them, without a label such as `\text{A:}` or words
/// behind.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// The sides, one at least; the first is empty in a line that carries on another.
    pub sides: Vec<Side>,
    /// The relations, one fewer than the sides.
    pub relations: Vec<Relation>,
}

/// One side of a formula.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    at: usize,
    items: Vec<Item>,
}

/// A line of a definition by cases.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// The value.
    pub value: Side,
    /// Where it holds.
    pub condition: Statement,
}

/// The formulas of a text, which commas divide.
///
/// # Errors
/// [`LatexError`] for what is no formula: unknown commands, brackets that do not match, nothing between two commas.
pub fn statements(latex: &str) -> Result<Vec<Statement>, LatexError> {
    divided(&items(latex)?, 0)
}

fn divided(items: &[Item], at: usize) -> Result<Vec<Statement>, LatexError> {
    let end = |item: &Item| matches!(item.kind, Kind::Mark(',' | '.'));
    let items = match items.split_last() {
        Some((last, rest)) if end(last) => rest,
        _ => items,
    };
    let comma = |item: &Item| item.kind == Kind::Mark(',');
    let parts = items.split(comma);
    parts.map(|part| statement(part, at)).collect()
}

fn statement(items: &[Item], at: usize) -> Result<Statement, LatexError> {
    let colon = |item: &Item| match &item.kind {
        Kind::Mark(mark) => *mark == ':',
        Kind::Text(words) => words.ends_with(':'),
        _ => false,
    };
    let label = items.iter().rposition(colon).map_or(0, |last| last + 1);
    let items = match &items[label..] {
        [formula @ .., words] if !formula.is_empty() && matches!(words.kind, Kind::Text(_)) => {
            formula
        }
        items => items,
    };
    let at = items.first().map_or(at, |first| first.at);
    if items.is_empty() {
        return Err(Problem::Missing.at(at));
    }
    let mut relations = Vec::new();
    let mut sides = vec![Side {
        at,
        items: Vec::new(),
    }];
    for item in items {
        if let Kind::Relation(relation) = item.kind {
            relations.push(relation);
            sides.push(Side {
                at: item.at,
                items: Vec::new(),
            });
        } else if let Some(side) = sides.last_mut() {
            side.items.push(item.clone());
        }
    }
    Ok(Statement { sides, relations })
}

impl Side {
    /// What the side means.
    ///
    /// # Errors
    /// [`LatexError`] for a name that the lexicon lacks, a missing operand, a vector for a number, and what could be read
    /// in two ways.
    pub fn read(&self, lexicon: &Lexicon) -> Result<Value, LatexError> {
        lexicon.read(&self.items, self.at)
    }

    /// The lines of a side that is given by cases; `None` of another.
    ///
    /// # Errors
    /// [`LatexError`] if a line has no condition.
    pub fn pieces(&self) -> Option<Result<Vec<Piece>, LatexError>> {
        let [item] = &self.items[..] else { return None };
        let Kind::Cases(lines) = &item.kind else {
            return None;
        };
        Some(lines.iter().map(|line| piece(line, item.at)).collect())
    }

    /// The statements of a side such as (q = 1, λ₀ = 1); `None` of another.
    ///
    /// # Errors
    /// [`LatexError`] if nothing stands between two commas.
    pub fn listed(&self) -> Option<Result<Vec<Statement>, LatexError>> {
        let [item] = &self.items[..] else { return None };
        let Kind::Bracket(inner) = &item.kind else {
            return None;
        };
        let relation = |item: &Item| matches!(item.kind, Kind::Relation(_));
        inner
            .iter()
            .any(relation)
            .then(|| divided(inner, item.at + 1))
    }

    /// What is differentiated by the time on a side such as (p² − ρ²)^·; `None` of another.
    pub fn differentiated(&self) -> Option<Side> {
        let [bracket, rate] = &self.items[..] else {
            return None;
        };
        let (Kind::Bracket(inner), Kind::Sup(dot)) = (&bracket.kind, &rate.kind) else {
            return None;
        };
        let dotted = matches!(&dot[..], [dot] if dot.kind == Kind::Mark('·'));
        dotted.then(|| Side {
            at: bracket.at + 1,
            items: inner.clone(),
        })
    }
}

fn piece(line: &[Item], at: usize) -> Result<Piece, LatexError> {
    let at = line.first().map_or(at, |first| first.at);
    let comma = line.iter().position(|item| item.kind == Kind::Mark(','));
    let (value, rest) = line.split_at(comma.ok_or_else(|| Problem::Missing.at(at))?);
    let condition = match &rest[1..] {
        [column, condition @ ..] if column.kind == Kind::Mark('&') => condition,
        condition => condition,
    };
    Ok(Piece {
        value: Side {
            at,
            items: value.to_vec(),
        },
        condition: statement(condition, rest[0].at)?,
    })
}
