//! A proof: steps that a reader can follow, each carried out.

use super::calculus::Derivation;
use super::constant_folding::folded;
use super::error::ExactError;
use super::expr::Expr;
use super::origin;
use super::rational::Rational;
use super::ring::Ring;
use super::series::Series;
use crate::notation::letters::{HIGH, large};
use crate::scalar::Scalar;
use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

/// In characters: more than that nobody reads.
const LONGEST: usize = 1000;
/// The longest normal form that stands beside another formula; twice as long it stands in a step by itself.
const LINE: usize = 40;
pub(crate) const NORMAL: &str = "; in normal form: ";

/// Up to the last whole term that is read, or its length if not even one is.
fn shortened(text: String) -> String {
    if text.chars().count() <= LONGEST {
        return text;
    }
    let mut depth = 0_i32;
    let mut end = 0;
    for (at, c) in text.char_indices().take(LONGEST) {
        depth += match c {
            '(' | '[' => 1,
            ')' | ']' => -1,
            _ => 0,
        };
        if depth == 0 && c == ' ' {
            end = at;
        }
    }
    let left_out = text[end..].chars().count();
    match end {
        0 => format!("an expression of {left_out} characters"),
        end => format!("{} … and {left_out} characters more", &text[..end]),
    }
}

fn written(formula: Expr) -> String {
    let text = folded(formula, &|_| None).to_string();
    let text = text.replace('-', "−");
    text.replace("+ −", "− ").replace("− −", "+ ")
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// Whether they are the same but for the order.
fn alike(a: &str, b: &str) -> bool {
    let sorted = |text: &str| {
        let mut all: Vec<_> = text.chars().filter(|c| *c != ' ').collect();
        all.sort_unstable();
        all
    };
    sorted(a) == sorted(b)
}

fn has_said(says: &str, formula: &str) -> bool {
    let plain = |text: &str| {
        let one = |c: char| match large(c, HIGH) {
            Some(digit) => format!("^{digit}"),
            None => c.to_string(),
        };
        let chars = text.chars().filter(|c| *c != ' ');
        chars.map(one).collect::<String>()
    };
    let (says, formula) = (plain(says), plain(formula));
    let mut sides = says.split('=').skip(usize::from(says.contains('=')));
    sides.any(|side| {
        let rest = side.strip_prefix(formula.as_str());
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(','))
    })
}

/// One step of a proof.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// What is done: what is read, put in, differentiated, compared.
    pub says: String,
    /// What comes of it, in plain text; empty where a sentence says both.
    pub gives: String,
    /// The same in the ring's normal form, where this is no help to a reader; else empty.
    pub normal: String,
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.says)?;
        for (before, text) in [(": ", &self.gives), (NORMAL, &self.normal)] {
            if !text.is_empty() {
                write!(f, "{before}{text}")?;
            }
        }
        Ok(())
    }
}

/// Why a proof does not hold.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Obstacle {
    /// A difference that had to be zero and is not.
    #[error("{says}: the difference is {normal_form}, not 0")]
    NotZero {
        /// What was compared.
        says: String,
        /// The difference.
        normal_form: String,
    },
    /// A step that cannot be carried out.
    #[error(transparent)]
    Impossible(#[from] ExactError),
    /// An element that had to be positive by its form.
    #[error("it does not show that {0} is positive")]
    NotPositive(String),
    /// A proof that this one rests on does not hold.
    #[error("it rests on {0}, which does not hold")]
    Premise(String),
    /// Nothing was compared.
    #[error("nothing was compared")]
    Empty,
}

/// What was tried to prove, how, and with what success.
#[derive(Debug, Clone, PartialEq, Eq)]
#[must_use = "it shows nothing unless it is asked whether it holds"]
pub struct Proof {
    title: String,
    steps: Vec<Step>,
    premises: Vec<Arc<Proof>>,
    positive: BTreeSet<String>,
    compares: bool,
    obstacle: Option<Obstacle>,
}

impl Proof {
    /// Carries out the steps of a proof in a ring.
    pub fn of(
        title: impl Into<String>,
        ring: &Ring,
        steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>,
    ) -> Self {
        let mut steps = Some(steps);
        let once = &mut |p: &mut Prover<'_>| steps.take().map_or(Ok(()), |steps| steps(p));
        Proof::carried_out(title.into(), ring, once)
    }

    /// The same, compiled once for all.
    fn carried_out(
        title: String,
        ring: &Ring,
        steps: &mut dyn FnMut(&mut Prover<'_>) -> Result<(), Obstacle>,
    ) -> Self {
        let mut prover = Prover {
            ring,
            steps: Vec::new(),
            brought: Vec::new(),
            bare: false,
            premises: Vec::new(),
            compared: false,
        };
        let outcome = steps(&mut prover);
        let is_empty = !prover.compared && prover.premises.is_empty();
        let empty = is_empty.then_some(Obstacle::Empty);
        Proof {
            title,
            steps: prover.steps,
            premises: prover.premises,
            compares: prover.compared,
            positive: ring.positive(),
            obstacle: outcome.err().or(empty),
        }
    }

    /// The same in a ring that may be impossible to set up.
    pub fn in_ring(
        title: impl Into<String>,
        ring: Result<Ring, ExactError>,
        steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>,
    ) -> Self {
        match ring {
            Ok(ring) => Proof::of(title, &ring, steps),
            Err(error) => Proof::impossible(title, error),
        }
    }

    /// Carries out steps that find something for other proofs; nothing where they fail.
    pub fn finding<T>(
        title: impl Into<String>,
        ring: Result<Ring, ExactError>,
        steps: impl FnOnce(&mut Prover<'_>) -> Result<T, Obstacle>,
    ) -> (Option<T>, Self) {
        let mut found = None;
        let proof = Proof::in_ring(title, ring, |p| {
            found = Some(steps(p)?);
            Ok(())
        });
        (found, proof)
    }

    /// A proof whose ring cannot be set up.
    pub fn impossible(title: impl Into<String>, error: ExactError) -> Self {
        Proof {
            title: title.into(),
            steps: Vec::new(),
            premises: Vec::new(),
            positive: BTreeSet::new(),
            compares: false,
            obstacle: Some(error.into()),
        }
    }

    /// A proof carried out for either sign of something.
    pub fn for_both_signs(of: impl Fn(i64) -> Proof) -> Self {
        let first = of(1);
        if !first.holds() {
            return first;
        }
        let mut second = of(-1);
        second.positive.retain(|x| first.positive.contains(x));
        second
    }

    /// What is proved.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// True if every comparison came out zero, and there was one.
    pub fn holds(&self) -> bool {
        self.obstacle.is_none()
    }

    /// Whether it compares anything itself, and does not rest on others alone.
    pub fn compares(&self) -> bool {
        self.compares
    }

    /// Why it does not hold; `None` if it does.
    pub fn obstacle(&self) -> Option<&Obstacle> {
        self.obstacle.as_ref()
    }

    /// The steps, in order, up to the obstacle if there is one.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// What has to be positive for all that is shown.
    pub fn positive(&self) -> BTreeSet<&str> {
        let premises = self.premises.iter().flat_map(|premise| premise.positive());
        premises
            .chain(self.positive.iter().map(String::as_str))
            .collect()
    }

    fn as_step(&self) -> Step {
        Step {
            says: "Shown before".into(),
            gives: self.title.clone(),
            normal: String::new(),
        }
    }

    /// The same, as text.
    pub fn cited(&self) -> String {
        self.as_step().to_string()
    }

    /// The proofs that it rests on, each after its own.
    pub fn premises(&self) -> Vec<&Proof> {
        let mut known = BTreeSet::new();
        let mut all: Vec<&Proof> = Vec::new();
        for premise in &self.premises {
            let those = premise.premises().into_iter().chain([&**premise]);
            all.extend(those.filter(|proof| known.insert(&proof.title)));
        }
        all
    }
}

/// The proof as numbered lines of plain text.
impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.title)?;
        for (i, step) in self.steps.iter().enumerate() {
            writeln!(f, "{}. {step}", i + 1)?;
        }
        match &self.obstacle {
            None => writeln!(f, "Shown."),
            Some(obstacle) => writeln!(f, "Not proved: {obstacle}."),
        }
    }
}

/// Carries out steps in a ring and writes them down.
#[derive(Debug)]
pub struct Prover<'a> {
    ring: &'a Ring,
    steps: Vec<Step>,
    /// With the step that brought each and the formula that was read for it, if any was.
    brought: Vec<(usize, Rational, Option<String>)>,
    bare: bool,
    premises: Vec<Arc<Proof>>,
    compared: bool,
}

impl<'a> Prover<'a> {
    /// The ring.
    pub fn ring(&self) -> &'a Ring {
        self.ring
    }

    /// Writes down an assumption or a result, shortened if very long.
    pub fn note(&mut self, says: &str, gives: impl Into<String>) {
        self.write(says, gives.into(), String::new());
    }

    fn write(&mut self, says: &str, gives: String, normal: String) {
        let [gives, normal] = [gives, normal].map(shortened);
        self.steps.push(Step {
            says: says.into(),
            gives,
            normal,
        });
    }

    /// Writes down a remark that is one sentence.
    pub fn remark(&mut self, says: &str) {
        self.note(says, "");
    }

    /// Writes down what is shown, for the page of lemmas, where the title does not say it all.
    pub fn shows(&mut self, says: &str) {
        self.note("To be shown", says);
    }

    fn bring(&mut self, says: &str, formula: Option<Expr>, x: &Rational) {
        let normal = self.ring.text(x);
        let formula = formula.map(written);
        let long = length(&normal) > LINE;
        let (gives, normal) = match &formula {
            Some(formula) if alike(formula, &normal) => (formula.clone(), String::new()),
            Some(formula) if has_said(says, formula) && !long => (String::new(), String::new()),
            Some(formula) if has_said(says, formula) => (String::new(), normal),
            Some(formula) if long && length(formula) < length(&normal) => (formula.clone(), normal),
            Some(formula) => (format!("{formula} = {normal}"), String::new()),
            None if length(&normal) > 2 * LINE => (String::new(), normal),
            None => (normal, String::new()),
        };
        self.write(says, gives, normal);
        let step = self.steps.len() - 1;
        self.brought.push((step, x.clone(), formula));
        self.bare = true;
    }

    /// Rests on another proof.
    ///
    /// # Errors
    /// [`Obstacle::Premise`] if that one does not hold.
    pub fn rests_on(&mut self, other: &Proof) -> Result<(), Obstacle> {
        if !other.holds() {
            return Err(Obstacle::Premise(other.title.clone()));
        }
        self.steps.push(other.as_step());
        self.premises.push(Arc::new(other.clone()));
        Ok(())
    }

    /// Expands a formula in powers of a small quantity `small`, in which some symbols stand for series.
    ///
    /// # Errors
    /// As [`Ring::expand`].
    pub fn expand(
        &mut self,
        says: &str,
        formula: Expr,
        series: &[(&str, &Series)],
        (small, order): (&str, i64),
    ) -> Result<Series, Obstacle> {
        let expansion = self.ring.expand(formula, series, order)?;
        let text = expansion.text(small, self.ring);
        self.note(says, format!("{} = {text}", written(formula)));
        Ok(expansion)
    }

    /// Solves equations by comparing the coefficients of the powers of a symbol.
    ///
    /// # Errors
    /// As [`Ring::solve`].
    pub fn solve(
        &mut self,
        says: &str,
        equations: &[Rational],
        powers_of: Option<&Rational>,
        unknowns: &[&str],
    ) -> Result<Vec<(Rational, Rational)>, Obstacle> {
        let solved = self.ring.solve(equations, powers_of, unknowns)?;
        let text = |(x, value): &(Rational, Rational)| {
            format!("{} = {}", self.ring.text(x), self.ring.text(value))
        };
        let texts: Vec<_> = solved.iter().map(text).collect();
        self.note(says, texts.join(", "));
        Ok(solved)
    }

    /// Reads a formula into the ring.
    ///
    /// # Errors
    /// As [`Ring::read`].
    pub fn read(&mut self, says: &str, formula: Expr) -> Result<Rational, Obstacle> {
        let element = self.ring.read(formula)?;
        self.bring(says, Some(formula), &element);
        Ok(element)
    }

    /// Differentiates an element.
    ///
    /// # Errors
    /// As [`Ring::derivative`].
    pub fn derivative(
        &mut self,
        says: &str,
        x: &Rational,
        by: &Derivation,
    ) -> Result<Rational, Obstacle> {
        let slope = self.ring.derivative(x, by)?;
        self.bring(says, None, &slope);
        Ok(slope)
    }

    /// Differentiates an element by a symbol.
    ///
    /// # Errors
    /// As [`Ring::by`] and [`Ring::derivative`].
    pub fn slope(&mut self, says: &str, x: &Rational, by: &str) -> Result<Rational, Obstacle> {
        let by = self.ring.by(by)?;
        self.derivative(says, x, &by)
    }

    /// Divides an element by another.
    ///
    /// # Errors
    /// As [`Ring::divide`].
    pub fn quotient(
        &mut self,
        says: &str,
        x: &Rational,
        y: &Rational,
    ) -> Result<Rational, Obstacle> {
        let quotient = self.ring.divide(x, y)?;
        self.bring(says, None, &quotient);
        Ok(quotient)
    }

    /// Demands that two elements are equal, as a sentence says; what is so as it stands is no step.
    ///
    /// # Errors
    /// [`Obstacle::NotZero`] with the difference, if they are not.
    pub fn equal(&mut self, says: &str, x: &Rational, y: &Rational) -> Result<(), Obstacle> {
        if self.compare(says, x, y)? {
            self.remark(says);
        }
        Ok(())
    }

    /// Demands that an element is what a formula says; it is written beside it, with what is to be seen.
    ///
    /// # Errors
    /// As [`read`](Self::read) and [`equal`](Self::equal).
    pub fn reads_as(&mut self, x: &Rational, seen: &str, formula: Expr) -> Result<(), Obstacle> {
        let y = self.ring.read(formula)?;
        let mut brought = self.brought.iter().rev();
        let brought = brought.find(|(_, element, _)| element.is_written_as(x));
        let left = brought.and_then(|(.., left)| left.clone());
        let step = brought.map(|(step, ..)| *step);
        let says = step.and_then(|step| self.steps.get(step));
        let says = says.map_or("So", |step| &step.says).to_owned();
        self.compare(&says, x, &y)?;
        if std::mem::take(&mut self.bare) && step.is_some_and(|step| step + 1 == self.steps.len()) {
            self.steps.pop();
        }
        let (right, normal) = (written(formula), self.ring.text(x));
        let folds = left.is_none() && length(&normal) > LINE;
        let (left, normal) = match (left, folds) {
            (None, true) => (right.clone(), normal),
            (left, _) => (left.unwrap_or(normal), String::new()),
        };
        let mut gives = match alike(&left, &right) {
            true => right,
            false => format!("{left} = {right}"),
        };
        if !seen.is_empty() {
            gives += &format!(", {seen}");
        }
        self.write(&says, gives, normal);
        Ok(())
    }

    /// Says whether they look different.
    fn compare(&mut self, says: &str, x: &Rational, y: &Rational) -> Result<bool, Obstacle> {
        let difference = x - y;
        let is_zero = self.ring.is_zero(&difference)?;
        if is_zero && origin::is_plain(x, y, &difference, self.ring) {
            return Ok(false);
        }
        self.compared = true;
        if is_zero {
            return Ok(true);
        }
        Err(Obstacle::NotZero {
            says: says.into(),
            normal_form: self.ring.text(&self.ring.normal(&difference)),
        })
    }

    /// Demands that an element changes with the state and keeps its value along a motion.
    ///
    /// # Errors
    /// [`Obstacle::NotZero`] if it is not so.
    pub fn constant(&mut self, x: &Rational, motion: &Derivation) -> Result<(), Obstacle> {
        let moves = |g| {
            let rate = self.ring.derivative(&Rational::generator(g), motion);
            rate.is_ok_and(|rate| !rate.is_literally_zero())
        };
        if !x.generators().any(moves) {
            // A number keeps its value along any motion: that would say nothing about this one.
            return Err(Obstacle::NotZero {
                says: "It must depend on the state of motion".into(),
                normal_form: self.ring.text(x),
            });
        }
        let rate = self.derivative("Its rate along the motion", x, motion)?;
        self.zero("The rate", &rate)
    }

    /// Demands that an element is positive by its form: a product of supposed ones and of sums without a
    /// negative term.
    ///
    /// # Errors
    /// [`Obstacle::NotPositive`] if it has another form.
    pub fn positive(&mut self, says: &str, x: &Rational) -> Result<(), Obstacle> {
        let text = self.ring.text(x);
        if !self.ring.is_positive(x)? {
            return Err(Obstacle::NotPositive(text));
        }
        self.note(says, format!("{text}, which is positive"));
        Ok(())
    }

    /// Demands that two formulas, each with what is said of it, are the same.
    ///
    /// # Errors
    /// As [`reads_as`](Self::reads_as).
    pub fn identity(&mut self, left: (&str, Expr), right: (&str, Expr)) -> Result<(), Obstacle> {
        let element = self.read(left.0, left.1)?;
        self.reads_as(&element, right.0, right.1)
    }

    /// Demands that an element is zero.
    ///
    /// # Errors
    /// [`Obstacle::NotZero`], if it is not.
    pub fn zero(&mut self, says: &str, x: &Rational) -> Result<(), Obstacle> {
        self.equal(says, x, &Rational::int(0))
    }

    /// Demands that a formula is zero, which it reads.
    ///
    /// # Errors
    /// As [`reads_as`](Self::reads_as).
    pub fn vanishes(&mut self, says: &str, formula: Expr) -> Result<(), Obstacle> {
        self.identity((says, formula), ("", Expr::int(0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_long_is_cut_between_terms() {
        let long = format!("[{}]", "a + ".repeat(LONGEST));
        for (text, expected) in [
            (format!("a + b {long}"), "a + b … and 4003 characters more"),
            (long, "an expression of 4002 characters"),
        ] {
            assert_eq!(shortened(text), expected);
        }
    }

    #[test]
    fn a_proof_compares_something() {
        let ring = Ring::new();
        let one = Rational::int(1);
        let note = |p: &mut Prover<'_>| {
            p.note("It is said", "and not compared");
            Ok(())
        };
        for empty in [
            Proof::of("nothing", &ring, |_| Ok(())),
            Proof::of("a note", &ring, note),
        ] {
            assert_eq!(empty.obstacle(), Some(&Obstacle::Empty), "{empty}");
        }
        let idle = |premises: &[Proof]| {
            Proof::of("one is one", &ring, |p| {
                premises.iter().try_for_each(|other| p.rests_on(other))?;
                p.equal("It", &one, &one)
            })
        };
        assert_eq!(idle(&[]).obstacle(), Some(&Obstacle::Empty));
        let sum = Proof::of("a sum", &ring, |p| {
            p.equal("It", &(&one + &one), &Rational::int(2))
        });
        let rests = idle(std::slice::from_ref(&sum));
        assert!(sum.compares() && rests.holds() && !rests.compares());
    }

    #[test]
    fn what_holds_for_both_signs_needs_neither() {
        let of = |sign: i64| {
            let mut ring = Ring::of(["x"]);
            let x = ring.named("x").unwrap();
            let root = &x * &Rational::int(sign);
            ring.root_is(&x.pow(2), 2, &root).unwrap();
            Proof::of("t", &ring, |p| p.equal("It", &root.pow(2), &x.pow(2)))
        };
        assert_eq!(of(-1).positive().into_iter().collect::<Vec<_>>(), ["−x"]);
        assert!(Proof::for_both_signs(of).positive().is_empty());
        for wrong in [1, -1] {
            let fails = || Proof::impossible("t", ExactError::UnknownSymbol("y".into()));
            let either = |sign| if sign == wrong { fails() } else { of(sign) };
            assert!(!Proof::for_both_signs(either).holds());
        }
    }

    #[test]
    fn what_is_so_as_it_stands_is_no_step() {
        let mut ring = Ring::new();
        let (x, one) = (ring.symbol("x"), Rational::int(1));
        let twice = Expr::symbol("x") * Expr::int(2);
        let read = |formula| ring.read(formula).unwrap();
        for (steps, left, right) in [
            (0, one.clone(), one.clone()),
            (0, x.clone(), read(Expr::symbol("x"))),
            (0, read(Expr::int(1)), one.clone()),
            (0, read(twice), read(twice)),
            // Without idle parts it is the same formula.
            (0, read(twice + Expr::int(0)), read(twice)),
            (1, read(twice), read(Expr::int(2) * Expr::symbol("x"))),
            (1, read(twice), &x + &x),
            (1, &x - &x, Rational::int(0)),
            (1, read(Expr::int(1) - Expr::pi().sin()), one.clone()),
        ] {
            let proof = Proof::of("t", &ring, |p| p.equal("It", &left, &right));
            let found = (proof.holds(), proof.steps().len());
            assert_eq!(found, (steps > 0, steps), "{proof}");
        }
    }

    #[test]
    fn a_formula_stands_there_once() {
        let mut ring = Ring::new();
        ring.angle("δ");
        let half = Expr::symbol("δ") / Expr::int(2);
        let steps = |says: &str, formula: Expr| {
            let proof = Proof::of("t", &ring, |p| p.read(says, formula).map(drop));
            proof.steps()[0].to_string()
        };
        for (says, formula, step) in [
            ("t = tan(δ/2), then small", half.tan(), ""),
            ("t² = tan(δ/2)²", half.tan().squared(), ""),
            ("tan(δ/2)", half.tan(), ""),
            ("t = tan(δ/2) + 1", half.tan(), ": tan(δ/2)"),
            ("Four", Expr::int(8) / Expr::int(2), ": 4"),
            ("It", -Expr::int(1), ": −1"),
            (
                "The sine",
                half.sin() + Expr::symbol("δ").sin(),
                ": sin(δ/2) + sin(δ); in normal form: ",
            ),
        ] {
            let found = steps(says, formula);
            assert!(found.starts_with(&format!("{says}{step}")), "{found}");
            assert_eq!(found.contains(NORMAL), step.contains(NORMAL), "{found}");
        }
    }

    #[test]
    fn what_is_the_same_is_one_step() {
        let mut ring = Ring::new();
        ring.symbol("x");
        let (x, two) = (Expr::symbol("x"), Expr::int(2));
        let proof = Proof::of("t", &ring, |p| {
            let square = p.read("A square", (x + two).squared())?;
            p.reads_as(&square, "", x * x + (x + Expr::int(1)) * Expr::int(4))?;
            p.reads_as(&square, "not negative", (two + x).squared())?;
            let slope = p.derivative("Its slope", &square, &p.ring().by("x")?)?;
            p.reads_as(&slope, "", two * x + two * two)?;
            p.reads_as(&(&slope * &slope), "", Expr::int(4) * (x + two).squared())
        });
        let steps: Vec<_> = proof.steps().iter().map(Step::to_string).collect();
        assert_eq!(
            steps,
            [
                "A square: (x + 2)^2 = x^2 + (x + 1) 4",
                "A square: (2 + x)^2, not negative",
                "Its slope: 2 (x + 2) = 2 x + 4",
                "So: 4 (x^2 + 4 x + 4) = 4 (x + 2)^2",
            ]
        );
        let wrong = Proof::of("t", &ring, |p| {
            let double = p.read("Twice", two * x)?;
            p.reads_as(&double, "", x)
        });
        assert!(
            wrong
                .to_string()
                .contains("Not proved: Twice: the difference is x"),
            "{wrong}"
        );
    }

    #[test]
    fn a_proof_names_all_that_it_rests_on() {
        let ring = Ring::new();
        let one = Rational::int(1);
        let none = &one - &one;
        let [first, second] =
            ["first", "second"].map(|title| Proof::of(title, &ring, |p| p.zero("It", &none)));
        let fails = Proof::of("false", &ring, |p| p.zero("It", &one));
        let resting_on = |premises: &[&Proof]| {
            Proof::of("last", &ring, |p| {
                premises.iter().try_for_each(|other| p.rests_on(other))?;
                p.zero("It", &none)
            })
        };
        for premises in [vec![], vec![&first], vec![&first, &second]] {
            let proof = resting_on(&premises);
            assert!(proof.holds());
            for title in premises.iter().map(|other| other.title()) {
                assert!(proof.to_string().contains(title), "{proof}");
            }
        }
        for premises in [vec![&fails], vec![&first, &fails], vec![&fails, &first]] {
            assert!(!resting_on(&premises).holds());
        }
    }
}
