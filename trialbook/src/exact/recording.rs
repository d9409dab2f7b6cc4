//! Where the elements of a proof come from, noted while they are formed: what its witness is made of.

use super::calculus::Derivation;
use super::constant_folding::folded;
use super::error::ExactError;
use super::expr::{Binary, Expr, Node};
use super::polynomial::Polynomial;
use super::rational::Rational;
use super::ring::{KnownPower, PI, Ring, Rule};
use super::series::Series;
use crate::witness::{
    self, Element, Equal, Generator, Identity, Inverse, Part, Power, Tree, Witness,
};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

/// Where an element comes from: how it was made, and its place in the tape of a recording.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Origin {
    recording: u32,
    place: usize,
    made: Made,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Made {
    /// It was given as it is: a number, a quantity.
    #[default]
    Given,
    /// It was read from the formula of this number in this thread's store.
    Read(u32),
    /// It was formed of others.
    Formed,
}

impl Origin {
    /// The same origin of what was made in another way.
    pub fn made(self, made: Made) -> Self {
        Origin { made, ..self }
    }
}

/// What is demanded in a proof that is being carried out.
#[derive(Default)]
struct Frame {
    equal: Vec<Equal>,
    given: Vec<String>,
}

/// A formula that was expanded, the series in it, and the order.
struct Expanded {
    formula: Expr,
    series: Vec<(String, Series)>,
    order: i64,
}

/// What a ring knows, by its place in the ring's list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Known {
    /// A power.
    Power(usize),
    /// An inverse function.
    Inverse(usize),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Outcome {
    /// All that was compared is equal.
    Holds,
    /// What was compared last is not.
    Fails,
    /// It could not be carried out.
    Open,
}

#[derive(Default)]
struct Tape {
    recording: u32,
    parts: Vec<Part>,
    /// The generators in what was given or formed at each place.
    generators: Vec<BTreeSet<usize>>,
    /// What was formed there.
    gives: Vec<Option<Element>>,
    frames: Vec<Frame>,
    /// What was expanded at a place.
    expanded: BTreeMap<usize, Expanded>,
    /// What is known of powers and inverse functions and is made use of in the operation that is under way.
    met: BTreeSet<Known>,
    /// The same at each place.
    met_at: Vec<BTreeSet<Known>>,
    /// What was demanded outside of any proof: it goes to the next one.
    loose: Vec<Equal>,
}

thread_local! {
    static TAPE: RefCell<Tape> = RefCell::default();
    /// How many operations are under way, whose own steps are not noted.
    static UNDER_WAY: Cell<u32> = const { Cell::new(0) };
}

/// Whether what is formed now is noted.
#[inline]
fn is_on() -> bool {
    witness::recording() != 0 && UNDER_WAY.get() == 0
}

fn with<T>(f: impl FnOnce(&mut Tape) -> T) -> T {
    TAPE.with_borrow_mut(|tape| {
        let recording = witness::recording();
        if tape.recording != recording {
            *tape = Tape {
                recording,
                ..Tape::default()
            };
        }
        f(tape)
    })
}

fn push(part: Part, generators: BTreeSet<usize>, gives: Option<Element>) -> usize {
    with(|tape| {
        tape.parts.push(part);
        tape.generators.push(generators);
        tape.gives.push(gives);
        tape.met_at.push(std::mem::take(&mut tape.met));
        tape.parts.len() - 1
    })
}

/// The place of an element; one that comes from nowhere is given as it is.
fn place(x: &Rational) -> usize {
    if x.origin().recording == witness::recording() {
        x.origin().place
    } else {
        push(Part::Element(element(x)), x.generators().collect(), None)
    }
}

/// The origin of what was formed so.
fn origin(part: Part, formed: &Rational) -> Origin {
    Origin {
        recording: witness::recording(),
        place: push(part, formed.generators().collect(), Some(element(formed))),
        made: Made::Formed,
    }
}

/// What an operation has formed, with its origin.
fn noted(part: Part, x: Rational) -> Rational {
    let origin = origin(part, &x);
    x.formed(origin)
}

/// The same while nothing is noted.
fn unnoted(x: Rational) -> Rational {
    x.formed(Origin::default().made(Made::Formed))
}

/// What comes of two elements by an operator.
pub(super) fn joined(
    by: fn(usize, usize) -> Part,
    x: &Rational,
    y: &Rational,
    formed: Rational,
) -> Rational {
    if !is_on() {
        return unnoted(formed);
    }
    let (x, y) = (place(x), place(y));
    noted(by(x, y), formed)
}

pub(super) fn negative(x: &Rational, formed: Rational) -> Rational {
    if !is_on() {
        return unnoted(formed);
    }
    noted(Part::Negative(place(x)), formed)
}

/// Keeps the steps of an operation out of the tape while it lives.
struct Quiet;

impl Quiet {
    fn new() -> Self {
        UNDER_WAY.set(UNDER_WAY.get() + 1);
        Quiet
    }
}

impl Drop for Quiet {
    fn drop(&mut self) {
        UNDER_WAY.set(UNDER_WAY.get() - 1);
    }
}

/// Forms an element by an operation that is noted as one.
pub(super) fn formed(
    part: impl FnOnce() -> Part,
    operation: impl FnOnce() -> Result<Rational, ExactError>,
) -> Result<Rational, ExactError> {
    if !is_on() {
        return operation().map(unnoted);
    }
    let part = part();
    with(|tape| tape.met.clear());
    let quiet = Quiet::new();
    let element = operation()?;
    drop(quiet);
    Ok(noted(part, element))
}

/// Forms another shape of the same element.
pub(super) fn kept(x: &Rational, operation: impl FnOnce() -> Rational) -> Rational {
    let _quiet = Quiet::new();
    operation().formed(x.origin())
}

/// A formula, read in a ring: with whole numbers for the symbols that stand for such, and without idle parts.
pub(super) fn read(formula: Expr, ring: &Ring) -> Part {
    Part::Read(tree(named(formula, ring)))
}

fn named(formula: Expr, ring: &Ring) -> Expr {
    folded(formula, &|name| {
        let value = ring.named(name).ok()?.as_integer()?;
        i64::try_from(value).ok()
    })
}

/// Notes that something known was made use of.
pub(super) fn met(known: Known) {
    if witness::recording() != 0 {
        with(|tape| tape.met.insert(known));
    }
}

pub(super) fn quotient(x: &Rational, y: &Rational) -> Part {
    Part::Quotient(place(x), place(y))
}

pub(super) fn raised(x: &Rational, y: &Rational) -> Part {
    Part::Raised(place(x), place(y))
}

pub(super) fn derivative(x: &Rational, by: &Derivation) -> Part {
    let rates = by.rates().map(|(g, rate)| (g, place(rate))).collect();
    Part::Derivative(place(x), rates)
}

pub(super) fn put(x: &Rational, values: &[(&Rational, &Rational)]) -> Part {
    let values = values
        .iter()
        .filter_map(|(g, value)| Some((g.generators().next()?, place(value))));
    let values = values.collect();
    Part::Put(place(x), values)
}

/// Expands a formula into a series, noted as one operation with its coefficients.
pub(super) fn expanded(
    (formula, series, order): (Expr, &[(&str, &Series)], i64),
    operation: impl FnOnce() -> Result<Series, ExactError>,
) -> Result<Series, ExactError> {
    if !is_on() {
        return Ok(operation()?.mapped(|_, c| unnoted(c)));
    }
    let of = |(name, series): &(&str, &Series)| {
        let places = series.coefficients().iter().map(place).collect();
        ((*name).to_owned(), series.start(), places)
    };
    let part = Part::Series(tree(formula), series.iter().map(of).collect());
    with(|tape| tape.met.clear());
    let quiet = Quiet::new();
    let result = operation()?;
    drop(quiet);
    let whole = push(part, BTreeSet::new(), None);
    let series = series
        .iter()
        .map(|(name, series)| ((*name).to_owned(), (*series).clone()));
    let expanded = Expanded {
        formula,
        series: series.collect(),
        order,
    };
    with(|tape| tape.expanded.insert(whole, expanded));
    Ok(result.mapped(|power, c| noted(Part::Coefficient(whole, power), c)))
}

impl Expanded {
    /// How many coefficients of each series are needed for that of the power `asked`.
    fn needed(&self, asked: i64, ring: &Ring) -> Vec<usize> {
        let _quiet = Quiet::new();
        let all = self.series.iter().map(|(_, s)| s.coefficients().len());
        let mut lengths: Vec<_> = all.collect();
        let enough = |lengths: &[usize]| {
            let cut = |((_, s), n): (&(String, Series), &usize)| {
                Series::new(s.start(), s.coefficients()[..*n].to_vec())
            };
            let cut: Vec<_> = self.series.iter().zip(lengths).map(cut).collect();
            let names = self.series.iter().map(|(name, _)| name.as_str());
            let series: Vec<_> = names.zip(&cut).collect();
            let expansion = ring.expand(self.formula, &series, self.order);
            expansion.is_ok_and(|expansion| expansion.order() >= asked)
        };
        for i in 0..lengths.len() {
            let (mut few, mut many) = (0, lengths[i]);
            while few < many {
                lengths[i] = few.midpoint(many);
                match enough(&lengths) {
                    true => many = lengths[i],
                    false => few = lengths[i] + 1,
                }
            }
            lengths[i] = many;
        }
        lengths
    }
}

/// Solves equations; what is noted is that the solution fulfils them.
pub(super) fn solved(
    equations: &[Rational],
    operation: impl FnOnce() -> Result<Vec<(Rational, Rational)>, ExactError>,
) -> Result<Vec<(Rational, Rational)>, ExactError> {
    let quiet = Quiet::new();
    let solved = operation()?.into_iter();
    drop(quiet);
    let given = |x: Rational| x.formed(Origin::default());
    let solved: Vec<_> = solved.map(|(x, value)| (given(x), given(value))).collect();
    if !is_on() {
        return Ok(solved);
    }
    let values: Vec<_> = solved.iter().map(|(x, value)| (x, value)).collect();
    for equation in equations {
        let put = push(put(equation, &values), BTreeSet::new(), None);
        demand("The solution, put into its equation", put, None);
    }
    Ok(solved)
}

fn demand(says: &str, left: usize, right: Option<usize>) {
    with(|tape| {
        let equal = Equal {
            says: says.to_owned(),
            left,
            right,
        };
        match tape.frames.last_mut() {
            Some(frame) => frame.equal.push(equal),
            None => tape.loose.push(equal),
        }
    });
}

/// Whether two equal elements are so as they stand, without a proof: both were given so, or read from one formula.
pub(super) fn is_plain(x: &Rational, y: &Rational, difference: &Rational, ring: &Ring) -> bool {
    // The formula, if it was read from more than a name or a number.
    let of = |x: &Rational| match x.origin().made {
        Made::Given => Some(None),
        Made::Read(formula) => {
            let formula = named(Expr::numbered(formula)?, ring);
            let leaf = matches!(formula.node(), Node::Pi | Node::Symbol(_)) || is_number(formula);
            Some((!leaf).then_some(formula))
        }
        Made::Formed => None,
    };
    match (of(x), of(y)) {
        (Some(None), Some(None)) => difference.is_literally_zero(),
        (Some(x), Some(y)) => x == y,
        _ => false,
    }
}

/// Whether nothing but whole numbers stands in a formula.
fn is_number(formula: Expr) -> bool {
    match formula.node() {
        Node::Int(_) => true,
        Node::Neg(x) => is_number(x),
        Node::Binary(_, x, y) => is_number(x) && is_number(y),
        _ => false,
    }
}

pub(super) fn compared(says: &str, x: &Rational, y: &Rational) {
    if is_on() {
        let (x, y) = (place(x), place(y));
        demand(says, x, Some(y));
    }
}

pub(super) fn given(title: &str) {
    if is_on() {
        with(|tape| {
            if let Some(frame) = tape.frames.last_mut() {
                frame.given.push(title.to_owned());
            }
        });
    }
}

pub(super) fn begin() {
    if is_on() {
        with(|tape| tape.frames.push(Frame::default()));
    }
}

/// A proof in a ring ends; it leaves a witness if it is settled.
pub(super) fn end(title: &str, ring: &Ring, outcome: Outcome) {
    if !is_on() {
        return;
    }
    let Some(frame) = with(|tape| tape.frames.pop()) else {
        return;
    };
    if outcome == Outcome::Open {
        return;
    }
    let mut equal = with(|tape| std::mem::take(&mut tape.loose));
    equal.extend(frame.equal);
    let (parts, gives, equal, generators, met) = used(equal, ring);
    witness::leave(|| {
        let names = names(&parts);
        let needed = needed(ring, generators, &names);
        let symbols = ring.declared().filter(|(name, _)| {
            let itself = ring.free_index(name).is_ok();
            names.contains(*name) && !itself
        });
        let powers = (0..).zip(&ring.powers);
        let powers =
            powers.filter(|(i, known)| met.contains(&Known::Power(*i)) && !is_own(ring, known));
        let inverses = (0..).zip(&ring.inverses);
        let inverses = inverses.filter(|(i, _)| met.contains(&Known::Inverse(*i)));
        let mut identity = Identity {
            title: title.to_owned(),
            given: frame.given,
            generators: needed.iter().map(|g| generator(ring, *g)).collect(),
            symbols: symbols
                .map(|(name, x)| (name.to_owned(), element(x)))
                .collect(),
            powers: powers
                .map(|(_, known)| Power {
                    of: element(&known.base),
                    to: element(&known.exponent),
                    is: element(&known.value),
                })
                .collect(),
            inverses: inverses
                .map(|(_, known)| Inverse {
                    function: known.function.name().to_owned(),
                    of: element(&known.of),
                    is: element(&known.angle),
                })
                .collect(),
            parts,
            gives,
            equal,
            fails: outcome == Outcome::Fails,
        };
        numbered(&mut identity, &needed);
        Witness::Identity(identity)
    });
}

/// Numbers the generators anew: those that are needed, in order.
fn numbered(identity: &mut Identity, needed: &BTreeSet<usize>) {
    let numbers: BTreeMap<usize, usize> = needed.iter().copied().zip(0..).collect();
    let polynomial = |p: &mut witness::Polynomial| {
        for (_, exponents) in p {
            let highest = exponents.iter().rposition(|k| *k > 0);
            let mut short = vec![0; highest.map_or(0, |g| numbers[&g] + 1)];
            for (g, k) in exponents.iter().enumerate().filter(|(_, k)| **k > 0) {
                short[numbers[&g]] = *k;
            }
            *exponents = short;
        }
    };
    let element = |x: &mut Element| {
        polynomial(&mut x.above);
        x.below.iter_mut().for_each(|(f, _)| polynomial(f));
    };
    for rule in &mut identity.generators {
        match rule {
            Generator::Pi | Generator::Free { .. } => {}
            Generator::HalfTangent { of } | Generator::HalfExponential { of } => *of = numbers[of],
            Generator::Power { of, to } => [of, to].into_iter().for_each(element),
            Generator::Root { of, .. } | Generator::Logarithm { of } => element(of),
        }
    }
    identity.symbols.iter_mut().for_each(|(_, x)| element(x));
    for known in &mut identity.powers {
        [&mut known.of, &mut known.to, &mut known.is]
            .into_iter()
            .for_each(element);
    }
    for known in &mut identity.inverses {
        [&mut known.of, &mut known.is].into_iter().for_each(element);
    }
    for part in &mut identity.parts {
        match part {
            Part::Element(x) => element(x),
            Part::Derivative(_, values) | Part::Put(_, values) => {
                values.iter_mut().for_each(|(g, _)| *g = numbers[g]);
            }
            _ => {}
        }
    }
    identity.gives.iter_mut().flatten().for_each(element);
}

/// Whether a power is known from the rule of its own generator.
fn is_own(ring: &Ring, known: &KnownPower) -> bool {
    let mut generators = known.value.generators();
    let (Some(g), None) = (generators.next(), generators.next()) else {
        return false;
    };
    let own = matches!(ring.rules[g], Rule::Power { .. } | Rule::Root { .. });
    own && (&known.value - &Rational::generator(g)).is_literally_zero()
        && match &ring.rules[g] {
            Rule::Root { radicand, .. } => (radicand - &known.base).is_literally_zero(),
            _ => true,
        }
}

/// The names in the formulas that are read.
fn names(parts: &[Part]) -> BTreeSet<String> {
    fn of(tree: &Tree, names: &mut BTreeSet<String>) {
        match tree {
            Tree::Leaf(name) => {
                names.insert(name.clone());
            }
            Tree::Node(parts) => parts.iter().for_each(|part| of(part, names)),
        }
    }
    let mut names = BTreeSet::new();
    for part in parts {
        if let Part::Read(tree) | Part::Series(tree, ..) = part {
            of(tree, &mut names);
        }
    }
    names
}

/// The generators that a generator is made of.
pub(super) fn below(rule: &Rule) -> BTreeSet<usize> {
    match rule {
        Rule::Constant | Rule::Free => BTreeSet::new(),
        Rule::HalfTangent { angle: of } | Rule::HalfExponential { argument: of } => [*of].into(),
        Rule::Power { base, exponent } => base.generators().chain(exponent.generators()).collect(),
        Rule::Root { radicand, .. } => radicand.generators().collect(),
        Rule::Logarithm { of } => of.generators().collect(),
    }
}

/// The generators that these are made of, with these.
pub(super) fn made_of(ring: &Ring, mut these: BTreeSet<usize>) -> BTreeSet<usize> {
    for g in (0..ring.rules.len()).rev() {
        if these.contains(&g) {
            these.extend(below(&ring.rules[g]));
        }
    }
    these
}

/// The generators that a checker meets: those of the elements and names, with all that these are made of; the half of an
/// angle, and of a hyperbolic argument, too.
fn needed(ring: &Ring, mut needed: BTreeSet<usize>, names: &BTreeSet<String>) -> BTreeSet<usize> {
    needed.insert(PI);
    let named = ring.declared().filter(|(name, _)| names.contains(*name));
    needed.extend(named.flat_map(|(_, x)| x.generators()));
    let mut needed = made_of(ring, needed);
    let angles = ring.angles.iter().map(|all| all.as_slice());
    for halves in angles.chain(ring.arguments.iter().map(|all| all.as_slice())) {
        if needed.contains(&halves[0]) {
            needed.extend(halves);
        }
    }
    needed
}

/// Parts, what they give, what is demanded of them, the generators in them, and what is made use of.
type Used = (
    Vec<Part>,
    Vec<Option<Element>>,
    Vec<Equal>,
    BTreeSet<usize>,
    BTreeSet<Known>,
);

/// The parts that what is demanded is made of, numbered anew.
fn used(mut equal: Vec<Equal>, ring: &Ring) -> Used {
    let (mut all, all_gives, met) = with(|tape| {
        (
            tape.parts.clone(),
            tape.gives.clone(),
            tape.generators.clone(),
        )
    });
    let mut asked = BTreeMap::new();
    let wanted = marked(&equal, &mut all, |part, i| {
        if let Part::Coefficient(whole, power) = *part {
            let most = asked.entry(whole).or_insert(power);
            *most = power.max(*most);
        }
        shortened(part, i, &asked, &met, ring);
    });
    let alike = simplified(&mut all, &wanted, &equal, &met, ring);
    for one in &mut equal {
        one.left = alike[one.left];
        one.right = one.right.map(|right| alike[right]);
    }
    let wanted = marked(&equal, &mut all, |_, _| ());
    let mut numbers = BTreeMap::new();
    let (mut parts, mut gives, mut generators) = (Vec::new(), Vec::new(), BTreeSet::new());
    let mut known = BTreeSet::new();
    let met_at = with(|tape| tape.met_at.clone());
    for i in (0..all.len()).filter(|i| wanted[*i]) {
        let mut part = all[i].clone();
        each(&mut part, &mut |j| {
            *j = numbers.get(j).copied().unwrap_or(*j)
        });
        generators.extend(&met[i]);
        if let Part::Derivative(_, rates) = &part {
            generators.extend(rates.iter().map(|(g, _)| g));
        }
        known.extend(&met_at[i]);
        numbers.insert(i, parts.len());
        parts.push(part);
        gives.push(all_gives[i].clone());
    }
    for known in &known {
        generators.extend(match known {
            Known::Power(i) => {
                let known = &ring.powers[*i];
                known
                    .value
                    .generators()
                    .chain(known.base.generators())
                    .collect::<Vec<_>>()
            }
            Known::Inverse(i) => ring.inverses[*i].angle.generators().collect(),
        });
    }
    for one in &mut equal {
        one.left = numbers[&one.left];
        one.right = one.right.map(|right| numbers[&right]);
    }
    (parts, gives, equal, generators, known)
}

/// Which parts what is demanded is made of; `f` is called with each and its place, the last one first.
fn marked(equal: &[Equal], all: &mut [Part], mut f: impl FnMut(&mut Part, usize)) -> Vec<bool> {
    let mut wanted = vec![false; all.len()];
    for place in equal
        .iter()
        .flat_map(|one| [Some(one.left), one.right])
        .flatten()
    {
        wanted[place] = true;
    }
    // Each is made of earlier ones.
    for i in (0..all.len()).rev() {
        if wanted[i] {
            f(&mut all[i], i);
            each(&mut all[i], &mut |j| wanted[*j] = true);
        }
    }
    wanted
}

/// Takes out what adds nothing, as a checker could not tell what stands beside it: products with 0, sums with it,
/// derivatives by what does not occur. What is itself compared is left. Returns where each part is to be found now.
fn simplified(
    all: &mut [Part],
    wanted: &[bool],
    equal: &[Equal],
    met: &[BTreeSet<usize>],
    ring: &Ring,
) -> Vec<usize> {
    let mut alike: Vec<usize> = (0..all.len()).collect();
    for i in (0..all.len()).filter(|i| wanted[*i]) {
        each(&mut all[i], &mut |j| *j = alike[*j]);
        let zero = |j: &usize| matches!(&all[*j], Part::Read(Tree::Leaf(n)) if n == "0");
        let compared = equal
            .iter()
            .any(|one| one.left == i || one.right == Some(i));
        match &all[i] {
            Part::Put(x, values) if values.is_empty() => alike[i] = *x,
            _ if compared => {}
            Part::Sum(x, y) | Part::Difference(x, y) if zero(y) => alike[i] = *x,
            Part::Sum(x, y) if zero(x) => alike[i] = *y,
            Part::Difference(x, y) if zero(x) => all[i] = Part::Negative(*y),
            Part::Product(x, y) if zero(x) || zero(y) => all[i] = nought(),
            Part::Quotient(x, _) | Part::Negative(x) if zero(x) => all[i] = nought(),
            Part::Derivative(x, rates) if !occurs(rates, &met[*x], ring) => all[i] = nought(),
            _ => {}
        }
    }
    alike
}

/// Whether one of the generators with these rates is among these, or they are made of it.
fn occurs(rates: &[(usize, usize)], these: &BTreeSet<usize>, ring: &Ring) -> bool {
    let occurring = made_of(ring, these.clone());
    rates.iter().any(|(g, _)| occurring.contains(g))
}

fn nought() -> Part {
    Part::Read(Tree::Leaf("0".to_owned()))
}

/// Takes from a part what does not count: values of generators that do not occur, and rates, if any of the others does; coefficients beyond those that
/// are asked for; and names a generator or a number.
fn shortened(
    part: &mut Part,
    place: usize,
    asked: &BTreeMap<usize, i64>,
    met: &[BTreeSet<usize>],
    ring: &Ring,
) {
    match part {
        Part::Element(x) => {
            if let Some(name) = bare(x, ring) {
                *part = Part::Read(Tree::Leaf(name));
            }
        }
        // By what alone does not occur, the derivative says just that.
        Part::Derivative(x, rates) if occurs(rates, &met[*x], ring) => {
            let occurring = made_of(ring, met[*x].clone());
            rates.retain(|(g, _)| occurring.contains(g));
        }
        Part::Put(x, values) => values.retain(|(g, _)| met[*x].contains(g)),
        Part::Series(formula, series) => {
            let expanded = with(|tape| tape.expanded.remove(&place));
            if let (Some(expanded), Some(asked)) = (expanded, asked.get(&place)) {
                let lengths = expanded.needed(*asked, ring);
                for ((_, _, places), length) in series.iter_mut().zip(lengths) {
                    places.truncate(length);
                }
                *formula = tree(folded(expanded.formula, &|_| None));
                with(|tape| tape.expanded.insert(place, expanded));
            }
        }
        _ => {}
    }
}

/// The name of a free generator, or the digits of a whole number.
fn bare(x: &Element, ring: &Ring) -> Option<String> {
    if x.number != "1" || !x.below.is_empty() {
        return None;
    }
    match x.above.as_slice() {
        [] => Some("0".to_owned()),
        [(c, exponents)] if exponents.iter().all(|k| *k == 0) => Some(c.clone()),
        [(c, exponents)] if c == "1" && exponents.iter().sum::<u32>() == 1 => {
            let g = exponents.iter().position(|k| *k == 1)?;
            matches!(ring.rules[g], Rule::Free).then(|| ring.names[g].clone())
        }
        _ => None,
    }
}

/// Calls `f` with each place that a part names.
fn each(part: &mut Part, f: &mut impl FnMut(&mut usize)) {
    match part {
        Part::Element(_) | Part::Read(_) => {}
        Part::Sum(x, y)
        | Part::Difference(x, y)
        | Part::Product(x, y)
        | Part::Quotient(x, y)
        | Part::Raised(x, y) => {
            f(x);
            f(y);
        }
        Part::Negative(x) | Part::Coefficient(x, _) => f(x),
        Part::Derivative(x, values) | Part::Put(x, values) => {
            f(x);
            values.iter_mut().for_each(|(_, value)| f(value));
        }
        Part::Series(_, series) => {
            let places = series.iter_mut().flat_map(|(_, _, places)| places);
            places.for_each(f);
        }
    }
}

fn generator(ring: &Ring, g: usize) -> Generator {
    match &ring.rules[g] {
        Rule::Constant => Generator::Pi,
        Rule::Free => Generator::Free {
            name: ring.names[g].clone(),
        },
        Rule::HalfTangent { angle } => Generator::HalfTangent { of: *angle },
        Rule::HalfExponential { argument } => Generator::HalfExponential { of: *argument },
        Rule::Power { base, exponent } => Generator::Power {
            of: element(base),
            to: element(exponent),
        },
        Rule::Root { radicand, degree } => Generator::Root {
            of: element(radicand),
            degree: *degree,
        },
        Rule::Logarithm { of } => Generator::Logarithm { of: element(of) },
    }
}

fn polynomial(p: &Polynomial) -> witness::Polynomial {
    let terms = p.terms();
    terms
        .map(|(exponents, c)| (c.to_string(), exponents.to_vec()))
        .collect()
}

fn element(x: &Rational) -> Element {
    Element {
        above: polynomial(x.numerator()),
        number: x.number().to_string(),
        below: x
            .factors()
            .iter()
            .map(|(f, k)| (polynomial(f), *k))
            .collect(),
    }
}

/// A formula as a nested list.
pub fn tree(formula: Expr) -> Tree {
    let node = |name: &str, of: &[Expr]| {
        let name = std::iter::once(Tree::Leaf(name.to_owned()));
        Tree::Node(name.chain(of.iter().map(|x| tree(*x))).collect())
    };
    match formula.node() {
        Node::Int(n) => Tree::Leaf(n.to_string()),
        Node::Pi => Tree::Leaf("π".to_owned()),
        Node::Symbol(name) => Tree::Leaf(name.to_owned()),
        Node::Neg(x) => node("-", &[x]),
        Node::Binary(op, x, y) => {
            let sign = match op {
                Binary::Add => "+",
                Binary::Sub => "-",
                Binary::Mul => "*",
                Binary::Div => "/",
                Binary::Pow => "^",
            };
            node(sign, &[x, y])
        }
        Node::Call(function, x) => node(function.name(), &[x]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Proof;
    use crate::witness::of;

    fn proof() -> Proof {
        let mut ring = Ring::new();
        let x = ring.symbol("x");
        Proof::of("x² − x² = 0", &ring, |p| {
            let square = p.read("x²", Expr::symbol("x") * Expr::symbol("x"))?;
            p.equal("The two", &square, &(&x * &x))
        })
    }

    #[test]
    fn only_what_runs_inside_leaves_a_witness() {
        assert!(proof().holds());
        let (inner, left) = of(|| {
            assert!(proof().holds());
            of(proof).1.len()
        });
        assert_eq!((inner, left.len()), (1, 1));
        assert!(of(|| ()).1.is_empty());
        let Witness::Identity(identity) = &left[0] else {
            panic!("{left:?}");
        };
        // The formula is there, and the product with what it is compared to.
        assert_eq!(identity.equal.len(), 1);
        let read = |part: &&Part| matches!(part, Part::Read(Tree::Node(_)));
        let product = |part: &&Part| matches!(part, Part::Product(..));
        let parts = identity.parts.iter();
        let counts = (
            parts.clone().filter(read).count(),
            parts.filter(product).count(),
        );
        assert_eq!(counts, (1, 1), "{:?}", identity.parts);
    }
}
