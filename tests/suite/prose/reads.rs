//! Which part of a text is which formula of the code, as the claims' entries say: `reads`, and of a correction `corrected-reads`.
//!
//! ```toml
//! reads = ['side 0.1: eq36_sides; \lambda_\mathrm{c} = eq37_lambda_c']
//! corrected-reads = ["$6 sides 0: anisotropic::e_sides"]
//! ```
//!
//! A part is that of a formula between dollar signs, if one is counted (`$6`), from 1. Then come the formulas that it is held
//! against, one after the other: each by the end of its path, with `.2` for the third of its components; or `0` or `π`. Then come
//! names that mean something of their own there: an argument of the formula or a component of one, a formula, a number, or with `@`
//! the right side of that statement. `words: κ =` says how the print begins where the plain text states it in other words.
//!
//! An equation of which nothing is said is held by the default: its right side is its only formula.

use super::{printed_part::Library, words};
use slipbook::claims::PAPER;
use trialbook::trials::{Claim, Topic};

/// Statements and sides are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// `side 0.1`: of this statement, of this number.
    Side(usize, usize),
    /// `sides 0`: both sides of this statement.
    Sides(usize),
    /// `rate`: what is differentiated on the left of the first statement.
    Rate,
    /// `from right angle`: π/2 less the right side.
    FromRightAngle,
    /// `pieces`: the values of all cases.
    Pieces,
    /// `ends`: each case has to begin where the one before it ends.
    Ends,
    /// `list`: the right sides of what is listed in brackets.
    List,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub segment: usize,
    pub place: Place,
    pub formulas: &'static str,
    pub names: Vec<(&'static str, &'static str)>,
}

impl Line {
    fn parse(text: &'static str) -> Option<Self> {
        let (place, rest) = text.split_once(": ")?;
        let mut parts = rest.split("; ");
        let formulas = parts.next()?;
        let names = parts.map(|name| name.split_once(" = "));
        let (segment, place) = match place.strip_prefix('$') {
            Some(counted) => {
                let (segment, place) = counted.split_once(' ')?;
                (segment.parse().ok().filter(|n| *n > 0)?, place)
            }
            None => (0, place),
        };
        let place = match place {
            "rate" => Place::Rate,
            "from right angle" => Place::FromRightAngle,
            "pieces" => Place::Pieces,
            "ends" => Place::Ends,
            "list" => Place::List,
            _ => match place.split_once(' ')? {
                ("sides", statement) => Place::Sides(statement.parse().ok()?),
                ("side", place) => {
                    let (statement, side) = place.split_once('.')?;
                    Place::Side(statement.parse().ok()?, side.parse().ok()?)
                }
                _ => return None,
            },
        };
        Some(Line {
            segment,
            place,
            formulas,
            names: names.collect::<Option<_>>()?,
        })
    }
}

pub struct Held {
    pub id: &'static str,
    pub at: String,
    pub corrected: bool,
    pub latex: &'static str,
    plain: &'static str,
    /// Where the plain text says the print's beginning in other words.
    words: Option<&'static str>,
    pub lines: Vec<Line>,
}

impl Held {
    /// Or, `corrected`, what is right in its place; with what is wrong in its entry.
    fn of(
        library: &Library,
        topic: &Topic,
        claim: &Claim,
        corrected: bool,
    ) -> Option<(Self, Vec<String>)> {
        let (field, latex, plain, reads) = match claim.correction {
            Some(right) if corrected => ("corrected-reads", right.latex, right.plain, right.reads),
            None if corrected => return None,
            _ => ("reads", claim.latex, claim.plain, claim.reads),
        };
        let mut held = Held {
            id: claim.id,
            at: format!("{}, {}", topic.file.path, claim.id),
            corrected,
            latex,
            plain,
            words: None,
            lines: Vec::new(),
        };
        let mut wrong = Vec::new();
        for said in reads {
            if let Some(words) = said.strip_prefix("words: ") {
                held.words = Some(words);
            } else if let Some(line) = Line::parse(said) {
                held.lines.push(line);
            } else {
                let how =
                    "`side 0.1: formula; name = meaning`, as tests/suite/prose/reads.rs has it";
                wrong.push(format!(
                    "{}: `{field}` has `{said}`, which is not {how}",
                    held.at
                ));
            }
        }
        if held.words.is_some() && words::of_latex(latex) == words::of_plain(plain) {
            let told = "`words` has no effect: the plain text is that of the print";
            wrong.push(format!("{}: {told}", held.at));
        }
        if let (Some(number), false) = (claim.equation, corrected)
            && let [only] = library.numbered(&number.to_string())[..]
        {
            let usual = Line {
                segment: 0,
                place: Place::Side(0, 1),
                formulas: only.name,
                names: Vec::new(),
            };
            if held.lines == [usual.clone()] {
                wrong.push(format!(
                    "{}: `{field}` has no effect: it is held so anyway",
                    held.at
                ));
            }
            if held.lines.is_empty() && wrong.is_empty() {
                held.lines.push(usual);
            }
        }
        Some((held, wrong))
    }

    /// Whether its letters are those of the plain text.
    pub fn says(&self, latex: &str) -> bool {
        let printed = words::of_latex(latex);
        match self.words {
            Some(begins) => printed.starts_with(&words::of_plain(begins)),
            None => {
                let plain = self.plain.trim_end_matches(", c constant");
                printed == words::of_plain(plain.trim_end_matches(", 𝐜 constant"))
            }
        }
    }
}

/// Of each equation and of what else says `reads`; with what is wrong in the entries.
pub fn held(library: &Library, corrected: bool) -> (Vec<Held>, Vec<String>) {
    let of = |(topic, claim): (&'static Topic, &'static Claim)| {
        let read = corrected || claim.equation.is_some() || !claim.reads.is_empty();
        read.then(|| Held::of(library, topic, claim, corrected))?
    };
    let (held, wrong): (_, Vec<_>) = PAPER.claims().filter_map(of).unzip();
    (held, wrong.concat())
}

#[test]
fn a_line_is_read_or_refused() {
    assert_eq!(
        Line::parse(r"$6 side 0.1: a::b.2 0; \chi = @1; v_0 = v"),
        Some(Line {
            segment: 6,
            place: Place::Side(0, 1),
            formulas: "a::b.2 0",
            names: vec![(r"\chi", "@1"), ("v_0", "v")],
        })
    );
    for wrong in [
        "",
        "side 0.1",
        "side 0: a",
        "sides 0.1: a",
        "side: a",
        "$0 rate: a",
        "$a rate: a",
        "rates: a",
        "rate: a; b",
    ] {
        assert_eq!(Line::parse(wrong), None, "{wrong}");
    }
}
