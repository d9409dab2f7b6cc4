//! Every motion that begins with p < ρ and A > 1 ends on the spiral: theorems about (128) to (137) as corrected.
//!
//! With δ = π/2 − ψ and t = tan(δ/2), the numbers N = cosh α/(2 A t) and P = 1/(t² (e^(4α) − 1)) change in the time θ, for which
//! dθ = 2t dτ, as prey and predator do:
//!
//! dN/dθ = N (2 − 2N − P),  dP/dθ = P (4N − 2 − 2P),
//!
//! up to what vanishes with t and 1 − tanh α. They settle at N = ¾, P = ½, from every start; all laws follow. How fast
//! they settle gives the logarithm.

use super::chains::ALPHA_GROWS;
use super::{exponential, tau};
use crate::claims::escape::prelude::*;

/// N, P, h = tanh α, and t.
pub(crate) type State = [Expr; 4];

const NAMES: [&str; 4] = ["N", "P", "h", "t"];

macro_rules! from_every_start {
    ($what:literal) => {
        Compared::shown(concat!(
            r"from every start with $p<\rho$ and $A>1$, also one that comes straight in, ",
            $what
        ))
    };
}

#[track_caller]
const fn theorem(compared: Compared, of: Statement, prove: fn(Expr) -> Proof) -> Statement {
    Statement::new(Corrected, compared, of.formulas, prove)
}

pub(crate) const EQ128: Statement = theorem(
    from_every_start!(
        r"$\tau\,\mathrm d\alpha/\mathrm d\tau\to\frac12$ as $\tau\to\infty$, and $\tau$ times the corrected right side tends to the same"
    ),
    super::EQ128,
    eq128,
);
pub(crate) const EQ129: Statement = theorem(
    from_every_start!(r"$(\cosh\alpha)\cosh(2\alpha)/A\to\frac{3\sqrt2}4$ as $\tau\to\infty$"),
    super::EQ129,
    eq129,
);
pub(crate) const EQ130: Statement = theorem(
    from_every_start!(r"$A$ grows without end and $\alpha-\frac13\ln(3\sqrt2A)\to0$"),
    super::EQ130,
    eq130,
);
pub(crate) const EQ131: Statement = theorem(
    from_every_start!(
        r"$A$ grows without end and the ratio of $\mathrm dA/\mathrm d\tau$ to $\frac12(3\sqrt2A)^{1/3}$ tends to 1"
    ),
    super::EQ131,
    eq131,
);
pub(crate) const EQ132: Statement = theorem(
    from_every_start!(
        r"$A=\frac{2^{1/4}}3\tau^{3/2}\left[1-\frac{9\sqrt2}8\frac{\ln\tau}\tau+o\left(\frac{\ln\tau}\tau\right)\right]$ as $\tau\to\infty$"
    ),
    super::EQ132,
    eq132,
);
pub(crate) const EQ133: Statement = theorem(
    from_every_start!(r"$\alpha-\frac12\ln(\sqrt2\,\tau)\to0$ as $\tau\to\infty$"),
    super::EQ133,
    eq133,
);
pub(crate) const EQ134: Statement = theorem(
    from_every_start!(
        r"up to whole turns $\frac\pi2-\psi=\frac2\tau\left[1+\frac{3\sqrt2}4\frac{\ln\tau}\tau+o\left(\frac{\ln\tau}\tau\right)\right]$ as $\tau\to\infty$"
    ),
    super::EQ134,
    eq134,
);
pub(crate) const EQ135: Statement = theorem(
    from_every_start!(
        r"$p=\frac{\tau^2}{3\sqrt2}\left[1-\frac{3\sqrt2}2\frac{\ln\tau}\tau+o\left(\frac{\ln\tau}\tau\right)\right]$ as $\tau\to\infty$"
    ),
    super::EQ135,
    eq135,
);
pub(crate) const EQ136: Statement = theorem(
    from_every_start!(
        r"$\rho=\frac{\tau^2}{3\sqrt2}\left[1-\frac{3\sqrt2}2\frac{\ln\tau}\tau+o\left(\frac{\ln\tau}\tau\right)\right]$ as $\tau\to\infty$, while the particle turns about the axis, in the laboratory, by an angle that less $\sqrt2\ln\tau$ converges"
    ),
    super::EQ136,
    eq136,
);
pub(crate) const EQ137: Statement = theorem(
    from_every_start!(
        r"$s=\frac{\tau^3}{9\sqrt2}\left[1-\frac{9\sqrt2}4\frac{\ln\tau}\tau+o\left(\frac{\ln\tau}\tau\right)\right]$ as $\tau\to\infty$"
    ),
    super::EQ137,
    eq137,
);

fn half() -> Expr {
    int(1) / 2
}

/// What the theorem says of the two numbers.
#[derive(Debug, Clone, Copy)]
struct Species {
    /// dN/dθ over N and dP/dθ over P, in the symbols of a [`State`].
    rates: [Expr; 2],
    /// Where N and P settle.
    rest: [Expr; 2],
    /// By how much 1/t falls behind τ, per unit of ln τ.
    delay: Expr,
}

impl Species {
    fn found() -> Self {
        let [n, predator, h, t] = symbols(NAMES);
        let (k, less) = (cosine(t), 1 - t.squared());
        let more = 1 + t.squared() * predator;
        let prey_rate = 1 + k * h - 2 * h * n - less * predator;
        let predator_rate = 2 * (1 - less * predator - 2 * more * k + 2 * more * n);
        Species {
            rates: [prey_rate, predator_rate],
            rest: [int(3) / 4, half()],
            delay: corrected::delay(),
        }
    }

    fn rates_at(&self, state: State) -> [Expr; 2] {
        let put = |formula: Expr, (name, value): (&'static str, Expr)| formula.with(name, value);
        self.rates
            .map(|rate| NAMES.into_iter().zip(state).fold(rate, put))
    }

    fn limit(&self) -> State {
        let [n, predator] = self.rest;
        [n, predator, int(1), int(0)]
    }
}

/// k = cos²(δ/2).
fn cosine(t: Expr) -> Expr {
    1 / (1 + t.squared())
}

/// dt/dθ.
fn fall(predator: Expr, t: Expr) -> Expr {
    -(t * (1 - (1 - t.squared()) * predator))
}

fn delta() -> Expr {
    symbol("δ")
}

/// The state of a motion, in A, α and δ.
fn state() -> State {
    let [a, alpha] = symbols(["A", "α"]);
    let t = (delta() / 2).tan();
    let less = (4 * alpha).exp() - 1;
    [
        alpha.cosh() / (2 * a * t),
        1 / (t.squared() * less),
        alpha.tanh(),
        t,
    ]
}

/// A, α and δ; the state in symbols of its own, and what else the proof is about; τ and its logarithm L.
fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let [_, tau] = ring.symbols(["A", "τ"]);
    ring.hyperbolic("α");
    ring.angle("δ");
    for name in NAMES.into_iter().chain(["q", "v", "w", "x", "y", "L"]) {
        ring.symbol(name);
    }
    for species in ["N", "P"] {
        let species = ring.named(species)?;
        ring.logarithm(&species)?;
    }
    ring.root(&tau, 2)?;
    let two = ring.root(&Rational::int(2), 2)?;
    ring.root(&two, 2)?;
    Ok(ring)
}

fn moves(p: &mut Prover<'_>, found: &Species) -> Result<(), Obstacle> {
    rest_on(
        p,
        &[
            &ALPHA_GROWS,
            &turntable::EQ113,
            &turntable::EQ114,
            &turntable::EQ115,
        ],
    )?;
    let [a, alpha] = symbols(["A", "α"]);
    let psi = pi() / 2 - delta();
    let push = 2 / ((4 * alpha).exp() - 1);
    let turn = p.read(
        "With δ = π/2 − ψ, dδ/dτ by (115)",
        -motion::eq115_psi_rate(alpha, psi),
    )?;
    let parts = 2 * push * delta().cos() - 4 * (delta() / 2).sin().squared();
    p.reads_as(&turn, "with m = 2/(exp(4α) − 1)", parts)?;
    p.note(
        "Where cos δ ≤ 0",
        "δ falls at the rate 2 at least, to π/2; it falls there, too, and so stays below",
    );
    let along = p.ring().along(&[
        ("A", p.ring().read(motion::eq113_a_rate::tree())?),
        ("α", p.ring().read(motion::eq114_alpha_rate(a, alpha, psi))?),
        ("δ", turn),
    ])?;
    let own = state();
    let [n, predator, h, t] = own;
    let tangent = p.read("t = tan(δ/2), then between 0 and 1", t)?;
    let rate = p.derivative("dt/dτ", &tangent, &along)?;
    let parts = push * (1 - t.squared()) - 2 * t.squared();
    p.reads_as(&rate, "", parts)?;
    let clock = p.ring().read(2 * t)?;
    let slower = p.quotient("dt/dθ", &rate, &clock)?;
    let stated = p.read("−t (1 − (1 − t²) P)", fall(predator, t))?;
    p.equal(
        "With P = 1/(t² (exp(4α) − 1)), the two are equal",
        &slower,
        &stated,
    )?;
    let logarithmic = found.rates_at(own);
    let species = [
        ("N = cosh α/(2 A t)", n, logarithmic[0]),
        ("P", predator, logarithmic[1]),
    ];
    for (name, formula, stated) in species {
        let number = p.read(name, formula)?;
        let rate = p.derivative("Its rate in τ", &number, &along)?;
        let rate = p.quotient("In θ, over itself", &rate, &(&number * &clock))?;
        p.reads_as(&rate, "as stated, with h = tanh α", stated)?;
    }
    p.identity(
        ("((1 − h)/t)²", ((1 - h) / t).squared()),
        ("", 4 * predator * h),
    )?;
    let inverse = p.ring().read(1 / t)?;
    let grows = p.derivative("The rate of 1/t in τ", &inverse, &along)?;
    let stated = 2 - 2 * (1 - t.squared()) * predator;
    p.reads_as(&grows, "", stated)
}

fn by_theta(p: &Prover<'_>, found: &Species) -> Result<Derivation, Obstacle> {
    let [n, predator, _, t] = symbols(NAMES);
    let ring = p.ring();
    Ok(ring.along(&[
        ("N", ring.read(n * found.rates[0])?),
        ("P", ring.read(predator * found.rates[1])?),
        ("t", ring.read(fall(predator, t))?),
    ])?)
}

fn settles(p: &mut Prover<'_>, found: &Species) -> Result<(), Obstacle> {
    let [n, predator, h, t] = symbols(NAMES);
    let [n0, p0] = found.rest;
    for rate in found.rates_at([n, predator, int(1), int(0)]) {
        p.read("A rate for h = 1 and t = 0", rate)?;
    }
    for rate in found.rates_at(found.limit()) {
        p.vanishes("There, at N = 3/4 and P = 1/2", rate)?;
    }
    let height = 4 * (n - n0 * n.ln()) + predator - p0 * predator.ln();
    let height = p.read("V", height)?;
    let slopes = [("N", 4 * (n - n0) / n), ("P", (predator - p0) / predator)];
    for (name, stated) in slopes {
        let slope = p.slope("Its slope", &height, name)?;
        p.reads_as(
            &slope,
            "negative below this value, positive above it",
            stated,
        )?;
    }
    let falls = p.derivative("dV/dθ", &height, &by_theta(p, found)?)?;
    let (k, little) = (cosine(t), t.squared() * predator);
    let last = 1 - (1 + little) * k;
    let first = (k * h - 1) + 2 * (1 - h) * n + t.squared() * predator;
    let second = t.squared() * predator + 2 * last + 2 * little * n;
    let stated = 4 * (n - n0) * first + 2 * (predator - p0) * second
        - 8 * (n - n0).squared()
        - 2 * (predator - p0).squared();
    p.reads_as(
        &falls,
        "two products with brackets, less two squares",
        stated,
    )?;
    p.identity(("1 − (1 + t² P) k", last), ("", k * (t.squared() - little)))?;
    p.note(
        "With x = |N − 3/4| and y = |P − 1/2|",
        "the first bracket is at most η (1 + 2N + P), and so η (3 + 2x + y), in size, the second η (2 + 2N + P), and so η (4 + 2x + y)",
    );
    let [x, y] = symbols(["x", "y"]);
    let most = 4 * x * (3 + 2 * x + y) + 2 * y * (4 + 2 * x + y);
    let spare = 10 + 18 * x.squared() + 10 * y.squared() - most;
    let squares = 6 * (1 - x).squared() + 4 * (1 - y).squared() + 4 * (x - y).squared();
    p.identity(
        (
            "10 + 18x² + 10y² less 4x (3 + 2x + y) + 2y (4 + 2x + y)",
            spare,
        ),
        ("squares", squares),
    )?;
    p.note(
        "Where V exceeds its least value by a given amount or more",
        "x² + y² is above a positive number, and 10η below half of that from some time on: so V comes below that amount, and stays there",
    );
    let unity = p.read("2 − 2P at P = 1/2", 2 - 2 * p0)?;
    p.reads_as(&unity, "", int(1))?;
    Ok(())
}

/// The rates in θ of q = (N − ¾)/t and v = (P − ½)/t, with w = (1 − h)/t.
pub(crate) fn follow([q, v, w]: [Expr; 3], [n, predator, h, t]: State) -> [Expr; 2] {
    let (k, less) = (cosine(t), 1 - t.squared());
    let feeds = predator + 2 * (1 - predator) * k + 2 * predator * n;
    let prey_rate = -(2 * q) - v + w * (2 * n - 1) + t * (predator - k * h);
    let predator_rate = 4 * q - 2 * v + 2 * t * feeds;
    [
        n * prey_rate + q * (1 - less * predator),
        predator * predator_rate + v * (1 - less * predator),
    ]
}

/// How far N and P are from where they settle, over t; and what 1/t makes of it.
fn falls_behind(p: &mut Prover<'_>, found: &Species) -> Result<(), Obstacle> {
    let [n, predator, h, t] = symbols(NAMES);
    let [n0, p0] = found.rest;
    let own = [n, predator, h, t];
    let deviations = [(n - n0) / t, (predator - p0) / t];
    let lag = (1 - h) / t;
    let stated = follow([deviations[0], deviations[1], lag], own);
    let along = by_theta(p, found)?;
    let names = ["q = (N − 3/4)/t", "v = (P − 1/2)/t"];
    for ((name, formula), stated) in names.into_iter().zip(deviations).zip(stated) {
        let deviation = p.read(name, formula)?;
        let rate = p.derivative("Its rate in θ", &deviation, &along)?;
        p.reads_as(&rate, "with w = (1 − h)/t", stated)?;
    }
    let [q, v, w, x, y] = symbols(["q", "v", "w", "x", "y"]);
    let root = int(2).sqrt();
    let exact = follow([q, v, w], own);
    let limit = follow([q, v, root], found.limit());
    let (k, slower) = (cosine(t), p0 - (1 - t.squared()) * predator);
    let feeds = predator + 2 * (1 - predator) * k + 2 * predator * n;
    let rest_of = [
        -((n - n0) * (2 * q + v))
            + (n * w * (2 * n - 1) - n0 * root * (2 * n0 - 1))
            + n * t * (predator - k * h)
            + q * slower,
        (predator - p0) * (4 * q - 2 * v) + 2 * predator * t * feeds + v * slower,
    ];
    for ((exact, limit), rest_of) in exact.into_iter().zip(limit).zip(rest_of) {
        let limit = p.read("A rate with the limits put in", limit)?;
        let exact = p.ring().read(exact)?;
        let rest_of = p.read("1, q and v with factors that go to 0", rest_of)?;
        p.equal("The rate differs by that", &(&exact - &limit), &rest_of)?;
    }
    let [q0, v0] = [found.delay / 8, found.delay / 2];
    let linear = limit.map(|rate| rate.with("q", q0 + x).with("v", v0 + y));
    for rate in linear {
        let rate = rate.with("x", int(0)).with("y", int(0));
        p.vanishes("A rate with the limits, at q = 3√2/32, v = 3√2/8", rate)?;
    }
    let along = p.ring().along(&[
        ("x", p.read("Of x = q − 3√2/32", linear[0])?),
        ("y", p.read("Of y = v − 3√2/8", linear[1])?),
    ])?;
    let size = int(8) / 3 * x.squared() + y.squared();
    let size = p.read("Q", size)?;
    let shrinks = p.derivative("Its rate with the limits", &size, &along)?;
    let stated = -(int(16) / 3 * x.squared()) - y.squared();
    p.reads_as(&shrinks, "squares", stated)?;
    let most = 6 * (x + y) * (1 + x + y);
    let spare = 3 + 18 * (x.squared() + y.squared()) - most;
    let squares = 3 * (1 - x - y).squared() + 9 * (x - y).squared();
    p.identity(
        (
            "3 + 18 (x² + y²) less 6 (x + y) (1 + x + y), with x for |x| and y for |y|",
            spare,
        ),
        ("squares", squares),
    )?;
    let inverse = 2 - 2 * (1 - t.squared()) * predator;
    let stated = 2 * predator * t - 2 * deviations[1];
    p.identity(
        ("The rate of 1/t less 1, over t", (inverse - 1) / t),
        ("", stated),
    )?;
    Ok(())
}

fn turns(p: &mut Prover<'_>, found: &Species) -> Result<(), Obstacle> {
    rest_on(
        p,
        &[
            &turntable::EQ95,
            &turntable::EQ96,
            &turntable::EQ111,
            &turntable::EQ112,
        ],
    )?;
    let [_, _, h, t] = state();
    let (rho, psi) = (motion::eq112_rho::tree(), pi() / 2 - delta());
    let across = motion::eq95_ell(rho, psi);
    let turn = 1 + speed() * across / rho.squared();
    let stated = (1 - h) / t + 2 * h * cosine(t) * t;
    p.identity(("The rate 1 + pℓ/ρ², over t", turn / t), ("", stated))?;
    let [_, predator, h, _] = found.limit();
    p.identity(
        ("The square of w, 4Ph, in the limit", 4 * predator * h),
        (
            "the square of the winding",
            corrected::winding::<Expr>().squared(),
        ),
    )?;
    Ok(())
}

fn spiral(found: Species) -> Proof {
    Proof::in_ring(
        "Every escape as prey and predator, which settle",
        ring(),
        |p| {
            p.shows("From every start with p < ρ and A > 1, with t = tan(π/4 − ψ/2): N = cosh α/(2 A t) → 3/4, P = 1/(t² (exp(4α) − 1)) → 1/2, and 1/t is τ − (3√2/4) ln τ + o(ln τ). In the laboratory the angle less √2 ln τ converges.");
            moves(p, &found)?;
            settles(p, &found)?;
            falls_behind(p, &found)?;
            turns(p, &found)
        },
    )
}

static SPIRAL: Derived<Proof> = Derived::new(|| spiral(Species::found()));

/// Rests a proof on the theorem on all escapes.
pub(crate) fn comes(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    SPIRAL.with(|proof| p.rests_on(proof))
}

fn after(title: &str, steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>) -> Proof {
    Proof::in_ring(title, ring(), |p| {
        comes(p)?;
        steps(p)
    })
}

/// A positive quantity: its m-th power, m being 1, 2 or 4, times t^n is a value that tends to a limit. So is the law's, with
/// τ for 1/t.
fn has_limit(
    p: &mut Prover<'_>,
    (quantity, m, n): (Expr, i64, i64),
    value: fn(State) -> Expr,
    first: Expr,
) -> Result<(), Obstacle> {
    let own = state();
    let exact = quantity.pow(int(m)) * own[3].pow(int(n));
    p.identity(("At any time", exact), ("in N, P, h and t", value(own)))?;
    let mut limit = value(Species::found().limit());
    for _ in 0..m.ilog2() {
        limit = limit.sqrt();
    }
    let limit = limit * tau().pow(int(n) / int(m));
    p.identity(
        ("The positive root in the limit, with 1/τ for t", limit),
        ("the first term of the law", first),
    )
}

fn first(law: Expr) -> Expr {
    law.with("L", int(0))
}

/// The law is its first term at the time 1/t.
fn in_its_time(p: &mut Prover<'_>, law: Expr) -> Result<(), Obstacle> {
    let stated = p.read("The law, with L = ln τ", law)?;
    let start = p.read("Its first term", first(law))?;
    let slope = p.slope("The rate of that", &start, "τ")?;
    let shift = p.read("κ ln τ", corrected::delay::<Expr>() * symbol("L"))?;
    let later = start - slope * shift;
    p.equal("The law is its first term at τ − κ ln τ", &stated, &later)?;
    Ok(())
}

fn speed() -> Expr {
    motion::eq111_p::tree()
}

fn eq128(law: Expr) -> Proof {
    after("(128) in every escape", |p| {
        rest_on(p, &[&turntable::EQ114])?;
        let [a, alpha] = symbols(["A", "α"]);
        let [n, predator, h, t] = state();
        let psi = pi() / 2 - delta();
        let rate = motion::eq114_alpha_rate(a, alpha, psi) / t;
        p.identity(
            ("dα/dτ over t, by (114)", rate),
            ("with k = 1/(1 + t²)", 2 * (cosine(t) - n)),
        )?;
        let friction = alpha.cosh() / a;
        p.identity(("cosh α/A, over t", friction / t), ("", 2 * n))?;
        let square = |[_, predator, h, _]: State| {
            let squares = 1 + h.squared();
            4 * predator * h * (1 + h).squared() / squares.squared()
        };
        let slow = 1 / (t * (2 * alpha).cosh()).squared();
        p.identity(("1/(t cosh 2α)²", slow), ("", square([n, predator, h, t])))?;
        let limit = Species::found().limit();
        let slow = p.read("The positive root, in the limit", square(limit).sqrt())?;
        let factor = (law + friction) * (2 * alpha).cosh();
        let factor = p.read("The factor of 1/cosh 2α in the law", factor)?;
        let own = p.read(
            "k in place of it, twice, in the limit",
            2 * cosine(limit[3]),
        )?;
        p.equal(
            "That is the product of the two before",
            &(&slow * &factor),
            &own,
        )?;
        p.identity(("2 − 2N in the limit", 2 - 2 * limit[0]), ("not 0", half()))?;
        Ok(())
    })
}

fn eq129(law: Expr) -> Proof {
    after("(129) in every escape", |p| {
        let a = symbol("A");
        let product = crate::paper::escape::eq129_a::tree() / a;
        let value = |[n, predator, h, _]: State| {
            let above = n * (1 + h.squared());
            above.squared() / (predator * h * (1 + h).squared())
        };
        has_limit(p, (product, 2, 0), value, law / a)
    })
}

fn eq130(law: Expr) -> Proof {
    after("(130) in every escape", |p| {
        let [a, alpha] = symbols(["A", "α"]);
        let value = |state| fourth_exponential(state).pow(int(3)) / fourth_power(state);
        let powers = [(12 * alpha).exp(), exponential(law, 12)];
        let [own, stated] = powers.map(|power| power / a.pow(int(4)));
        has_limit(p, (own, 1, 0), value, stated)?;
        Ok(())
    })
}

fn eq131(law: Expr) -> Proof {
    let with_cubes = || {
        let mut ring = ring()?;
        let a = ring.named("A")?;
        ring.root(&a, 3)?;
        let number = ring.read(3 * int(2).sqrt())?;
        ring.root(&number, 3)?;
        Ok(ring)
    };
    Proof::in_ring("(131) in every escape", with_cubes(), |p| {
        rest_on(p, &[&turntable::EQ113, &EQ130])?;
        let [alpha] = symbols(["α"]);
        let rate = 2 * motion::eq113_a_rate::tree() * (-alpha).exp();
        p.identity(
            ("Twice dA/dτ by (113), over exp α", rate),
            ("which tends to 1", 1 - (-2 * alpha).exp()),
        )?;
        p.identity(("The cube of twice the law", (2 * law).pow(int(3))), ("exp(3α) by (130) as corrected, to which that of the motion has a ratio that tends to 1", exponential((EQ130.formulas)(), 3)))
    })
}

/// A⁴ t⁶.
pub(crate) fn fourth_power([n, predator, h, _]: State) -> Expr {
    1 / (64 * predator * h * n.pow(int(4)) * (1 + h).squared())
}

fn eq132(law: Expr) -> Proof {
    after("(132) in every escape", |p| {
        let [a] = symbols(["A"]);
        has_limit(p, (a, 4, 6), fourth_power, first(law))?;
        in_its_time(p, law)
    })
}

/// exp(4α) t².
pub(crate) fn fourth_exponential([_, predator, _, t]: State) -> Expr {
    1 / predator + t.squared()
}

fn eq133(law: Expr) -> Proof {
    after("(133) in every escape", |p| {
        let [alpha] = symbols(["α"]);
        let own = (4 * alpha).exp();
        has_limit(p, (own, 1, 2), fourth_exponential, exponential(law, 4))?;
        Ok(())
    })
}

fn eq134(law: Expr) -> Proof {
    after("(134) in every escape", |p| {
        let lag = p.read("The law's first term", first(law))?;
        p.reads_as(&lag, "as 2t in the limit, where tτ is 1", 2 / tau())?;
        in_its_time(p, law)
    })
}

/// (ρt²)².
pub(crate) fn square_of_distance([n, predator, h, _]: State) -> Expr {
    1 / (16 * predator * h * n.squared() * (1 + h).squared())
}

/// (pt²)².
pub(crate) fn square_of_speed(state: State) -> Expr {
    state[2].squared() * square_of_distance(state)
}

fn eq135(law: Expr) -> Proof {
    after("(135) in every escape", |p| {
        rest_on(p, &[&turntable::EQ111])?;
        has_limit(p, (speed(), 2, 4), square_of_speed, first(law))?;
        in_its_time(p, law)
    })
}

fn eq136(law: Expr) -> Proof {
    after("(136) in every escape", |p| {
        rest_on(p, &[&turntable::EQ112])?;
        let rho = motion::eq112_rho::tree();
        has_limit(p, (rho, 2, 4), square_of_distance, first(law))?;
        in_its_time(p, law)
    })
}

fn eq137(law: Expr) -> Proof {
    after("(137) in every escape", |p| {
        rest_on(p, &[&EQ135])?;
        let speed = motion::eq105_arc_rate((EQ135.formulas)());
        let stated = p.read("The law, with L = ln τ", law)?;
        let one = Rational::int(1);
        let logarithm = p.ring().divide(&one, &p.ring().named("τ")?)?;
        let along = p.ring().along(&[("τ", one), ("L", logarithm)])?;
        let rate = p.derivative("Its rate", &stated, &along)?;
        let speed = p.read("ds/dτ by (105), with p by (135) as corrected", speed)?;
        let by = p.ring().named("τ")?;
        let left = p.quotient("The difference over τ", &(&rate - &speed), &by)?;
        for name in ["τ", "L"] {
            let slope = p.slope(&format!("Its rate by {name}"), &left, name)?;
            p.reads_as(&slope, "", int(0))?;
        }
        p.remark("So the law's rate is p, up to less than τ ln τ by any factor in the end, and s, the integral of p by (105), is the law, up to less than τ² ln τ by any factor");
        Ok(())
    })
}

attempts![
    &EQ128, &EQ129, &EQ130, &EQ131, &EQ132, &EQ133, &EQ134, &EQ135, &EQ136, &EQ137
];
