//! A part of a print, held against a formula of the code.

use super::{
    compare::{self, Same},
    corrections,
    meaning::{lexicon, tree},
    reads::{Line, Place},
};
use slipbook::claims::formulas::formulas;
use slipbook::exact::{
    Expr,
    latex::{Lexicon, Side, Statement, Value, statements},
};
use slipbook::scalar::Scalar;
use slipbook::seeded::Formula;

pub struct Library {
    pub formulas: Vec<Formula<Expr>>,
}

impl Library {
    pub fn new() -> Self {
        let mut all = formulas::<Expr>();
        all.extend(corrections::joined());
        Library { formulas: all }
    }

    /// The formula whose path ends so, or why there is none.
    pub fn find(&self, name: &str) -> Result<&Formula<Expr>, String> {
        let mut of_name = self.formulas.iter().filter(|formula| {
            let before = formula.path.strip_suffix(name);
            before.is_some_and(|before| before.ends_with("::"))
        });
        let (first, second) = (of_name.next(), of_name.next());
        match second {
            None => first.ok_or_else(|| format!("there is no formula `{name}`")),
            Some(_) => Err(format!("`{name}` is the name of several formulas")),
        }
    }

    pub fn numbered(&self, number: &str) -> Vec<&Formula<Expr>> {
        let prefix = format!("eq{number}_");
        let own = |formula: &&Formula<Expr>| formula.name.starts_with(&prefix);
        self.formulas.iter().filter(own).collect()
    }

    pub fn hold(&self, latex: &str, line: &Line) -> Result<Vec<Same>, String> {
        self.pairs(latex, line)?
            .into_iter()
            .map(|(printed, code)| compare::same(printed, code))
            .collect()
    }

    pub fn reads(&self, latex: &str, line: &Line) -> bool {
        self.pairs(latex, line).is_ok()
    }

    /// As [`Library::hold`], by values alone.
    pub fn agrees(&self, latex: &str, line: &Line) -> bool {
        let pairs = self.pairs(latex, line);
        pairs.is_ok_and(|pairs| pairs.iter().all(|(a, b)| compare::differ(*a, *b).is_none()))
    }

    fn pairs(&self, latex: &str, line: &Line) -> Result<Vec<(Expr, Expr)>, String> {
        let formula = match line.segment {
            0 => Some(latex),
            n => latex.split('$').skip(1).step_by(2).nth(n - 1),
        };
        let formula = formula.ok_or("there is no such formula in the text")?;
        let error = |e: slipbook::exact::latex::LatexError| e.to_string();
        let statements = statements(formula).map_err(error)?;
        let names: Vec<&str> = line.formulas.split(' ').collect();
        let main = names.iter().find(|name| !["0", "π"].contains(name));
        let main = main.map(|name| self.find(without_component(name).0));
        let lexicon = lexicon(self, main.transpose()?, &line.names, &statements)?;
        let code: Result<Vec<_>, _> = names.iter().map(|name| self.code(name)).collect();
        let mut code = code?.concat();
        let printed = printed(&statements, line.place, &lexicon)?;
        let vector = matches!(printed[..], [Value::Vector(_)]);
        if vector && code.len() == 2 {
            // In the plane.
            code.push(Expr::int(0));
        }
        let printed: Vec<Expr> = printed.into_iter().flat_map(parts).collect();
        if printed.len() != code.len() {
            return Err(format!(
                "{} printed, {} in the code",
                printed.len(),
                code.len()
            ));
        }
        Ok(printed.into_iter().zip(code).collect())
    }

    fn code(&self, name: &str) -> Result<Vec<Expr>, String> {
        Ok(match name {
            "0" => vec![Expr::int(0)],
            "π" => vec![Expr::pi()],
            _ => {
                let (own, component) = without_component(name);
                let all = tree(self.find(own)?);
                match component {
                    None => all,
                    Some(i) => vec![
                        *all.get(i)
                            .ok_or_else(|| format!("`{name}` has no such part"))?,
                    ],
                }
            }
        })
    }
}

fn without_component(name: &str) -> (&str, Option<usize>) {
    match name.split_once('.') {
        Some((name, component)) => (name, component.parse().ok()),
        None => (name, None),
    }
}

fn parts(value: Value) -> Vec<Expr> {
    match value {
        Value::Number(x) => vec![x],
        Value::Vector(x) => x.to_vec(),
    }
}

fn printed(
    statements: &[Statement],
    place: Place,
    lexicon: &Lexicon,
) -> Result<Vec<Value>, String> {
    let read = |side: &Side| side.read(lexicon).map_err(|e| e.to_string());
    let side = |statement: usize, side: usize| {
        let found = statements.get(statement).and_then(|s| s.sides.get(side));
        found.ok_or_else(|| format!("there is no side {side} of statement {statement}"))
    };
    let pieces = || {
        let pieces = side(0, 1)?.pieces().ok_or("there are no cases")?;
        pieces.map_err(|e| e.to_string())
    };
    match place {
        Place::Side(s, i) => Ok(vec![read(side(s, i)?)?]),
        Place::Sides(s) => [0, 1].map(|i| read(side(s, i)?)).into_iter().collect(),
        Place::Rate => {
            let rate = side(0, 0)?.differentiated();
            Ok(vec![read(&rate.ok_or("nothing is differentiated")?)?])
        }
        Place::FromRightAngle => match read(side(0, 1)?)? {
            Value::Number(x) => Ok(vec![Value::Number(Expr::pi() / Expr::int(2) - x)]),
            Value::Vector(_) => Err("an angle is no vector".into()),
        },
        Place::Pieces => pieces()?.iter().map(|piece| read(&piece.value)).collect(),
        Place::Ends => {
            let mut ends: Vec<Value> = Vec::new();
            for piece in pieces()? {
                let [from, _, to] = &piece.condition.sides[..] else {
                    return Err("a case does not hold between two ends".into());
                };
                let from = read(from)?;
                if *ends.last().get_or_insert(&from) != &from {
                    return Err("a case does not begin where the one before it ends".into());
                }
                if ends.is_empty() {
                    ends.push(from);
                }
                ends.push(read(to)?);
            }
            Ok(ends)
        }
        Place::List => {
            let listed = side(0, 1)?.listed().ok_or("nothing is listed")?;
            let listed = listed.map_err(|e| e.to_string())?;
            let right = |s: &Statement| read(s.sides.get(1).ok_or("there is no right side")?);
            listed.iter().map(right).collect()
        }
    }
}
