//! Another paper on trial: a stone is thrown, the drag is in proportion to its velocity; (6) is wrong in print.
use trialbook::prelude::*;
/// As printed: k is the drag over the mass, g gravity, u and w the velocity at the start across and upwards.
mod paper {
    use trialbook::prelude::*;
    formulas! { symbols &[];
    pub fn eq1_across<S: Scalar>(k: S, u: S, t: S) -> S { u * (-(k * t)).exp() }
    pub fn eq2_upwards<S: Scalar>(k: S, g: S, w: S, t: S) -> S { (w + g / k) * (-(k * t)).exp() - g / k }
    pub fn eq3_way<S: Scalar>(k: S, u: S, t: S) -> S { u / k * (S::int(1) - (-(k * t)).exp()) }
    pub fn eq4_height<S: Scalar>(k: S, g: S, w: S, t: S) -> S {
        (w + g / k) / k * (S::int(1) - (-(k * t)).exp()) - g * t / k
    }
    pub fn eq5_rise<S: Scalar>(k: S, g: S, w: S) -> S { (S::int(1) + k * w / g).ln() / k }
    pub fn eq6_top<S: Scalar>(k: S, g: S, w: S) -> S { w / k + g / k.squared() * (S::int(1) + k * w / g).ln() }
    }
}
/// What is right.
mod corrections {
    use trialbook::prelude::*;
    formulas! { symbols &[];
    pub fn eq6_top<S: Scalar>(k: S, g: S, w: S) -> S { w / k - g / k.squared() * (S::int(1) + k * w / g).ln() }
    }
}
/// Proves that a formula changes at this rate, and what it begins with.
fn law([formula, rate, start]: [Expr; 3]) -> Proof {
    let mut ring = Ring::of(["k", "g", "u", "w"]);
    ring.hyperbolic("kt");
    let [k, kt] = Expr::symbols(["k", "kt"]);
    let at = |x: Expr, kt: Expr| x.with("t", kt / k);
    Proof::of("Newton's law", &ring, |p| {
        let now = p.read("the formula", at(formula, kt))?;
        let change = p.slope("its change with kt", &now, "kt")?;
        p.reads_as(&change, "the rate over k", at(rate / k, kt))?;
        let first = p.read("the formula at t = 0", at(formula, Expr::int(0)))?;
        p.reads_as(&first, "the start", start)
    })
}
/// What (1) to (4) are, with their rates and what they begin with.
fn laws() -> [[Expr; 3]; 4] {
    let [k, g, u, w] = Expr::symbols(["k", "g", "u", "w"]);
    let (across, upwards) = (paper::eq1_across::tree(), paper::eq2_upwards::tree());
    let (way, height) = (paper::eq3_way::tree(), paper::eq4_height::tree());
    let (zero, fall) = (Expr::int(0), [upwards, -g - k * upwards, w]);
    let ways = [[way, across, zero], [height, upwards, zero]];
    [[across, -k * across, u], fall, ways[0], ways[1]]
}
const fn proved(formulas: fn() -> [Expr; 3]) -> Statement<[Expr; 3]> {
    let newton = r"Newton's law, as rational functions of $\mathrm e^{kt}$";
    Statement::new(Printed, Compared::one("the formula", newton), formulas, law)
}
type Stated = fn(f64, f64, f64) -> f64;
type Found = fn([f64; 3]) -> Result<f64, Failure>;
/// Compares what a formula states with what is found, for forty throws.
fn tried(by: fn(Subject, Compared) -> Trial, of: Subject, says: Stated, is: Found) -> Evidence {
    let trial = by(of, Compared::one("the formula", "what Newton's law gives"));
    let pair = |[k, g, w]: [f64; 3]| Ok([says(k, g, w), is([k, g, w])?]);
    let throws = Points::here().within(40, [[0.5, 2.0]; 3]);
    trial.at(["k", "g", "w"], throws, 10.0, pair)
}
/// Velocity upwards and height at the time `t`.
fn motion([k, g, w]: [f64; 3], t: f64) -> Result<[f64; 2], Failure> {
    let law = |_, [v, _]: &[f64; 2]| [-g - k * v, *v];
    Ok(dop853::end(law, 0.0, [w, 0.0], t, 1e-14, 1e-14)?)
}
fn rise([k, g, w]: [f64; 3]) -> Result<f64, Failure> {
    Ok(integral(|v| 1.0 / (g + k * v), 0.0, w)?.value)
}
fn top(throw: [f64; 3]) -> Result<f64, Failure> {
    Ok(motion(throw, rise(throw)?)?[1])
}
/// How the claims are tried, which name them.
const TRIALS: &[Attempt] = trials! {
    &EQ1 = proved(|| laws()[0]),
    &EQ2 = proved(|| laws()[1]),
    &EQ3 = proved(|| laws()[2]),
    &EQ4 = proved(|| laws()[3]),
    eq5_motion = tried(Trial::motion, Printed, paper::eq5_rise,
        |throw| Ok(root(|t| motion(throw, t).map_or(f64::NAN, |[v, _]| v), 1e-3, 4.0)?)),
    eq5_quadrature = tried(Trial::quadrature, Printed, paper::eq5_rise, rise),
    eq6_motion = tried(Trial::motion, Printed, paper::eq6_top, top),
    right_motion = tried(Trial::motion, Corrected, corrections::eq6_top, top),
    right_quadrature = tried(Trial::quadrature, Corrected, corrections::eq6_top,
        |[k, g, w]| Ok(integral(|v| v / (g + k * v), 0.0, w)?.value))
};
static STONE: Topic = Topic::new(
    "stone",
    "The stone",
    claims!("examples/drag/claims.toml"),
    &[TRIALS],
);
static PAPER: Paper = Paper {
    title: "The thrown stone",
    authors: "N. N.",
    topics: &[&STONE],
    record: text!("examples/drag/verdicts.txt"),
    formulas: formulas_of!(paper, corrections),
    ..Paper::BLANK
};
/// The height of the top over the drag, as printed and as it is found.
fn figures() -> Result<Vec<Figure>, trialbook::publishing::Failure> {
    let row = |k| Ok((k, [paper::eq6_top(k, 9.8, 5.0), top([k, 9.8, 5.0])?]));
    let rows: Result<Vec<_>, Failure> = (1..=40).map(|i| row(f64::from(i) / 20.0)).collect();
    let plot = Plot::new("top", "The top")
        .caption("The height of the top over the drag, for $g=9.8$ m/s² and $w=5$ m/s.")
        .alt("The printed height falls from far above; the one found falls from 1.2 m.");
    let axes = [Axis::linear("k (1/s)"), Axis::log("H (m)")];
    Ok(vec![plot.curves(axes, ["printed", "found"], &rows?)?])
}
static EDITION: Edition = Edition {
    pages: &[
        Page::new("index", "The thrown stone", include_str!("pages/index.md")),
        Page::new("stone", "", include_str!("pages/stone.md")),
    ],
    figures,
    sources: sources!["main.rs"],
    ..Edition::of("stone", &PAPER)
};
fn main() -> ExitCode {
    trialbook::cli::run(&EDITION)
}

#[cfg(test)]
mod tests;
