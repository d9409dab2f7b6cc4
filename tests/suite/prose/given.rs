//! Formulas that hold where something is given: `name=formula`, or `name=@function(arguments)` of the code, parted by semicolons.
//! Without a name it is what the formula itself is to be. `left`, `right` and `difference` are the sides of its relation, or the
//! left one less the right one, `within` how much two numbers may differ, with a digit that counts the relations, `row` one of
//! its cases. A piece that the reader does not understand, such as an integral, has its value as «piece»; «piece»=, parts two
//! statements there.

use super::{
    compare,
    formulas::{Found, Given, found, number, read},
    printed_part::Library,
};
use slipbook::exact::{
    Expr,
    latex::{Value, statements},
};

pub fn hold(library: &Library, givens: &str, formula: &str) -> Result<(), String> {
    let mut given = Given::new();
    let mut formula = formula.to_owned();
    let mut whole = None;
    let mut asked = Vec::new();
    for line in givens.split("; ") {
        let (name, right) = line
            .rsplit_once("»=")
            .or_else(|| line.split_once('='))
            .ok_or("nothing is given")?;
        if right == "," {
            formula = formula.replace(name.trim_start_matches('«'), ",");
            continue;
        }
        let value = match right.strip_prefix('@') {
            Some(call) => called(library, call, &given)?,
            None => value(right, &given)?,
        };
        match name {
            "" => whole = Some(value),
            name if Asked::of(name).is_some() => {
                asked.extend(Asked::of(name).map(|what| (what, value)))
            }
            name if name.starts_with('«') => {
                let piece = name.trim_matches(['«', '»']);
                if !formula.contains(piece) {
                    return Err(format!("there is no {piece}"));
                }
                let stands_for = format!(r"\chi_{}", given.len());
                formula = formula.replace(piece, &format!("{stands_for} "));
                given.push((stands_for, value));
            }
            name => given.push((name.to_owned(), value)),
        }
    }
    let formula = formula.as_str();
    if let Some(whole) = whole {
        let (found, whole) = (value(formula, &given)?.number(), whole.number());
        return match found.zip(whole) {
            Some((a, b)) => compare::same(a, b).map(drop),
            None => Err("a vector".to_owned()),
        };
    }
    if !asked.is_empty() {
        let apart = asked.iter().any(|(what, _)| what.what == "within");
        asked
            .into_iter()
            .try_for_each(|(what, value)| what.is(value, formula, &given))?;
        // Numbers are related as it says, too, unless they may differ.
        return match found(formula, &mut Given::with(given)) {
            Some(Found::Wrong(why)) if !apart => Err(why),
            _ => Ok(()),
        };
    }
    // First counts what is given, not what the formula gives.
    match found(formula, &mut Given::with(given)) {
        Some(Found::Holds) => Ok(()),
        other => Err(format!("{other:?}")),
    }
}

struct Asked {
    what: &'static str,
    relation: usize,
}

impl Asked {
    fn of(name: &str) -> Option<Self> {
        let what = ["left", "right", "difference", "within", "row"]
            .into_iter()
            .find(|what| name.starts_with(what))?;
        let relation = match &name[what.len()..] {
            "" => 0,
            digit => digit.parse::<usize>().ok()?.checked_sub(1)?,
        };
        Some(Self { what, relation })
    }

    fn is(&self, wanted: Value, formula: &str, given: &Given) -> Result<(), String> {
        // What is left out in the print is left out here, too.
        let formula = formula.replace(r"+\dots", "");
        let formula = formula.trim_end_matches([':', ',', '.', ' ']);
        if self.what == "row" {
            let row = row(formula, self.relation).ok_or("no such row")?;
            let [found, wanted] = [value(row, given)?, wanted].map(|side| side.number());
            return match found.zip(wanted) {
                Some((found, wanted)) => compare::same(found, wanted).map(drop),
                None => Err("a vector".to_owned()),
            };
        }
        let statements = statements(formula).map_err(|why| why.to_string())?;
        let pair = statements
            .iter()
            .flat_map(|statement| statement.sides.windows(2))
            .nth(self.relation)
            .ok_or("no such relation")?;
        let side = |i: usize| {
            let side = read(formula, &pair[i], given).map_err(|why| why.to_string())?;
            side.number().ok_or("a vector".to_owned())
        };
        let wanted = wanted.number().ok_or("a vector")?;
        let found = match self.what {
            "left" => side(0)?,
            "right" => side(1)?,
            _ => side(0)? - side(1)?,
        };
        if self.what == "within" {
            let numbers = [found, wanted].map(|side| number(Value::Number(side)));
            return match numbers {
                [Some(apart), Some(most)] if apart.abs() <= most => Ok(()),
                numbers => Err(format!("{numbers:?}")),
            };
        }
        compare::same(found, wanted).map(drop)
    }
}

fn row(formula: &str, number: usize) -> Option<&str> {
    let (_, cases) = formula.split_once(r"\begin{cases}")?;
    let (cases, after) = cases.split_once(r"\end{cases}")?;
    if !after.is_empty() {
        return None;
    }
    let (says, _) = cases.split(r"\\").nth(number)?.split_once('&')?;
    Some(says.trim().trim_end_matches(','))
}

fn value(latex: &str, given: &Given) -> Result<Value, String> {
    let statements = statements(latex).map_err(|why| format!("{latex}: {why}"))?;
    let side = &statements[0].sides[0];
    read(latex, side, given).map_err(|why| format!("{latex}: {why}"))
}

/// `path(a,b)`, or `path.1(a,b)` for its second component.
fn called(library: &Library, call: &str, given: &Given) -> Result<Value, String> {
    let (path, arguments) = call
        .trim_end_matches(')')
        .split_once('(')
        .ok_or("no arguments")?;
    let (path, component) = path.split_once('.').unwrap_or((path, "0"));
    let arguments = arguments.split(',').filter(|argument| !argument.is_empty());
    let arguments: Result<Vec<Expr>, String> = arguments
        .map(|argument| {
            value(argument, given)?
                .number()
                .ok_or("a vector".to_owned())
        })
        .collect();
    let formula = library.find(path)?;
    let arguments = arguments?;
    if arguments.len() != formula.symbols.len() {
        return Err(format!("{path} takes {:?}", formula.symbols));
    }
    let values = (formula.value)(&arguments);
    let component: usize = component.parse().map_err(|_| "no component")?;
    values
        .get(component)
        .map(|value| Value::Number(*value))
        .ok_or("no such component".to_owned())
}

#[test]
fn what_is_given_is_put_in() {
    let library = Library::new();
    for (given, formula, holds) in [
        (r"b=\frac72", r"(1-1/b)\,v_0=\frac57v_0", true),
        (r"b=\frac52", r"(1-1/b)\,v_0=\frac57v_0", false),
        (r"C=\cos(\psi/2); =@rest::boundary_slope(\psi)", "C^2", true),
        (
            r"C=\sin(\psi/2); =@rest::boundary_slope(\psi)",
            "C^2",
            false,
        ),
        (r"x=3", r"2<x<4", true),
        (r"x=3", r"2<x<3", false),
        (r"x=3", r"y=x", false),
        (r"right=2x", r"y\to x+x", true),
        (r"right=3x", r"y\to x+x", false),
        (r"left=y; right2=y", r"y\le x<y", true),
        (r"difference=y", r"y+x>x", true),
        (r"x=1/10; within=10^{-5}", r"\cos x\approx1-x^2/2", true),
        (r"x=1/10; within=10^{-6}", r"\cos x\approx1-x^2/2", false),
        (r"«\int_0^1f»=2x; difference=x", r"\int_0^1f=x", true),
        (r"«\int_0^1f»=2x; difference=x", r"\int_0^2f=x", false),
        (r"x=2; difference=-1", r"x<3", true),
        (r"x=2; difference=-1", r"x>3", false),
        (
            r"row2=-x",
            r"y=\begin{cases}x,&x>0\\-x,&x<0\end{cases}",
            true,
        ),
        (
            r"row1=-x",
            r"y=\begin{cases}x,&x>0\\-x,&x<0\end{cases}",
            false,
        ),
        (
            r"row3=-x",
            r"y=\begin{cases}x,&x>0\\-x,&x<0\end{cases}",
            false,
        ),
    ] {
        assert_eq!(
            hold(&library, given, formula).is_ok(),
            holds,
            "{given}: {formula}"
        );
    }
    assert_eq!(number(value("2^3", &Given::default()).unwrap()), Some(8.0));
}
