//! How a certificate becomes [`Evidence`], and how a formula is evaluated on balls.

use super::compare::{Kept, lemma};
use super::tolerances;
use crate::certified::ball::{Ball, bits_for};
use crate::certified::enclosure::Enclosure;
use crate::certified::error::CertifiedError;
use crate::evidence::{Compared, Evidence, Route, Sample, Subject};
use crate::exact::{Binary, Expr, Function, Node, Obstacle, Proof, Step};

/// Decimals to which a stated number is held against an enclosure.
pub const DIGITS: usize = 50;

/// Evidence from a certificate, as the number of its parts: what was proved false disagrees; what was not
/// proved gives no number.
pub fn certified(
    proof: Result<usize, CertifiedError>,
    subject: Subject,
    compared: Compared,
) -> Evidence {
    let (points, worst, at) = match proof {
        Ok(parts) => (parts, 0.0, String::new()),
        Err(error @ CertifiedError::False { .. }) => (1, f64::INFINITY, error.to_string()),
        Err(error @ CertifiedError::NotProved { .. }) => (1, f64::NAN, error.to_string()),
    };
    Evidence {
        points,
        worst,
        at,
        ..Evidence::new(Route::Certified, subject, compared, tolerances::NONE)
    }
}

/// The evidence, which rests on these proofs too.
pub fn citing(premises: &[Proof], evidence: Evidence) -> Evidence {
    let named = premises.iter().map(Proof::cited);
    let lemmas = premises
        .iter()
        .flat_map(|p| p.premises().into_iter().chain([p]));
    Evidence {
        steps: named.chain(evidence.steps).collect(),
        lemmas: lemmas.map(lemma).collect(),
        ..evidence
    }
}

/// Evidence from a certificate that rests on exact proofs, with their steps.
pub fn resting_on(
    premises: &[Proof],
    certificate: impl FnOnce() -> Result<usize, CertifiedError>,
    subject: Subject,
    compared: Compared,
) -> Evidence {
    let obstacle = premises.iter().find_map(Proof::obstacle);
    let outcome = match obstacle {
        None => certificate(),
        Some(obstacle) => {
            let at = obstacle.to_string();
            Err(match obstacle {
                Obstacle::NotZero { .. } => CertifiedError::False(at),
                _ => CertifiedError::NotProved {
                    why: "a step cannot be carried out",
                    at,
                },
            })
        }
    };
    let steps = premises.iter().flat_map(Proof::steps);
    let mut steps: Vec<_> = steps.map(Step::to_string).collect();
    if let Ok(parts) = outcome {
        steps.push(format!("The rest by subdivision: {parts} parts decide"));
    }
    let lemmas = premises.iter().flat_map(Proof::premises).map(lemma);
    Evidence {
        lemmas: lemmas.collect(),
        steps,
        ..certified(outcome, subject, compared)
    }
}

/// Evidence from stated numbers against enclosed ones with their names, each to [`DIGITS`] decimals.
pub fn numbers<const N: usize>(
    found: [(&'static str, Enclosure); N],
    subject: Subject,
    compared: Compared,
    stated: impl Fn(usize) -> [Option<Ball>; N],
) -> Evidence {
    let mut evidence = certified(Ok(N), subject, compared);
    let mut kept = Kept::default();
    for ((name, found), stated) in found.into_iter().zip(stated(bits_for(DIGITS))) {
        let (Some(stated), Ok(found)) = (stated, found.ball(DIGITS)) else {
            evidence.worst = f64::NAN;
            evidence.at = name.to_owned();
            break;
        };
        let enough = bits_for(DIGITS) - 8;
        let disagrees = !stated.meets(&found);
        if stated.known_bits().min(found.known_bits()) < enough {
            evidence.worst = f64::NAN;
            evidence.at = format!("{name}, too wide");
        } else if disagrees {
            evidence.worst = f64::INFINITY;
            evidence.at = name.to_owned();
        }
        let sample = Sample {
            at: format!("{name}, {DIGITS} digits"),
            stated: stated.interval().mid(),
            found: found.interval().mid(),
        };
        let disagreement = if disagrees { f64::INFINITY } else { 0.0 };
        kept.keep(&mut evidence, sample, disagreement);
    }
    evidence
}

/// A formula's value on balls; `None` where it or a symbol has none, or where it is too large.
pub fn on_balls(formula: Expr, bits: usize, symbol: &dyn Fn(&str) -> Option<Ball>) -> Option<Ball> {
    let of = |x: Expr| on_balls(x, bits, symbol);
    Some(match formula.node() {
        Node::Int(n) => Ball::int(n, bits),
        Node::Pi => Ball::pi(bits),
        Node::Symbol(name) => symbol(name)?,
        Node::Neg(x) => -of(x)?,
        Node::Binary(Binary::Add, x, y) => of(x)? + of(y)?,
        Node::Binary(Binary::Sub, x, y) => of(x)? - of(y)?,
        Node::Binary(Binary::Mul, x, y) => of(x)? * of(y)?,
        Node::Binary(Binary::Div, x, y) => of(x)?.over(&of(y)?)?,
        Node::Call(Function::Sqrt, x) => of(x)?.sqrt()?,
        Node::Call(Function::Asin, x) => of(x)?.asin()?,
        Node::Call(Function::Sin, x) => {
            let [sine, _] = of(x)?.sin_cos();
            sine
        }
        Node::Call(Function::Cos, x) => {
            let [_, cosine] = of(x)?.sin_cos();
            cosine
        }
        Node::Binary(Binary::Pow, x, power) => match power.node() {
            Node::Int(n) => whole_power(&of(x)?, n, bits)?,
            Node::Binary(Binary::Div, n, two) => match (n.node(), two.node()) {
                (Node::Int(n), Node::Int(2)) => whole_power(&of(x)?.sqrt()?, n, bits)?,
                _ => any_power(&of(x)?, &of(power)?)?,
            },
            Node::Neg(n) => match n.node() {
                Node::Int(n) => whole_power(&of(x)?, n.checked_neg()?, bits)?,
                _ => any_power(&of(x)?, &of(power)?)?,
            },
            _ => any_power(&of(x)?, &of(power)?)?,
        },
        Node::Call(Function::Exp, x) => of(x)?.exp()?,
        Node::Call(Function::Ln, x) => of(x)?.ln()?,
        Node::Call(Function::Acos, x) => {
            Ball::pi(bits) * Ball::ratio(1, 2, bits)? - of(x)?.asin()?
        }
        Node::Call(Function::Tan, x) => {
            let [sine, cosine] = of(x)?.sin_cos();
            sine.over(&cosine)?
        }
        Node::Call(Function::Cot, x) => {
            let [sine, cosine] = of(x)?.sin_cos();
            cosine.over(&sine)?
        }
        Node::Call(Function::Sinh, x) => hyperbolic(&of(x)?)?[0].clone(),
        Node::Call(Function::Cosh, x) => hyperbolic(&of(x)?)?[1].clone(),
        Node::Call(Function::Tanh, x) => {
            let [sine, cosine] = hyperbolic(&of(x)?)?;
            sine.over(&cosine)?
        }
        Node::Call(Function::Coth, x) => {
            let [sine, cosine] = hyperbolic(&of(x)?)?;
            cosine.over(&sine)?
        }
    })
}

fn hyperbolic(x: &Ball) -> Option<[Ball; 2]> {
    let half = Ball::ratio(1, 2, x.bits())?;
    let [grows, falls] = [x.exp()?, (-x).exp()?];
    Some([&(&grows - &falls) * &half, &(&grows + &falls) * &half])
}

fn any_power(x: &Ball, power: &Ball) -> Option<Ball> {
    (x.ln()? * power).exp()
}

const LARGEST_POWER: usize = 1000;

/// For n of at most [`LARGEST_POWER`] in size.
fn whole_power(x: &Ball, n: i64, bits: usize) -> Option<Ball> {
    let factors = usize::try_from(n.unsigned_abs()).ok()?;
    if factors > LARGEST_POWER {
        return None;
    }
    let power = std::iter::repeat_n(x, factors).fold(Ball::int(1, bits), |power, x| &power * x);
    match n {
        0.. => Some(power),
        _ => Ball::int(1, bits).over(&power),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certified::interval::Interval;
    use crate::evidence::Outcome;
    use crate::scalar::Scalar;

    #[test]
    fn what_is_known_to_fewer_digits_is_no_agreement() {
        let compared = Compared::one("$x$", "the number");
        let third = Enclosure(|bits| Ok(Ball::ratio(1, 3, bits).expect("a number")));
        // A third with this many of its bits known, and this far off in units of 2⁻²⁰⁰.
        let stated = |known: usize, off: i64| {
            let wide = Ball::ratio(1, 3, known).expect("a number").with_bits(200);
            let unit = Ball::ratio(1, 2, 200).expect("a number");
            let shift = (0..40).fold(Ball::int(off, 200), |shift, _| &shift * &unit);
            Some(&wide + &shift)
        };
        // Fifty digits are 166 bits and a few to spare.
        for (known, off, worst) in [
            (190, 0, 0.0),
            (178, 0, 0.0),
            (170, 0, f64::NAN),
            (140, 0, f64::NAN),
            (100, 0, f64::NAN),
            (190, 1, f64::INFINITY),
        ] {
            let evidence = numbers([("x", third)], Subject::Printed, compared, |_| {
                [stated(known, off)]
            });
            let same = evidence.worst == worst || evidence.worst.is_nan() && worst.is_nan();
            assert!(same, "{known} {off}: {}, {}", evidence.worst, evidence.at);
        }
    }

    #[test]
    fn what_is_not_proved_is_not_disproved() {
        let cell = [Interval::point(1.0)];
        let outcome = |error| {
            let evidence = certified(Err(error), Subject::Printed, Compared::shown("it holds"));
            evidence.outcome()
        };
        let not_proved = CertifiedError::unproved("too wide", &cell);
        assert_eq!(outcome(not_proved), Outcome::NotANumber);
        assert_eq!(outcome(CertifiedError::failing(&cell)), Outcome::Disagrees);
    }

    #[test]
    fn signs_are_kept_on_balls() {
        let two = |_: &str| Some(Ball::int(2, 64));
        let x = || Expr::symbol("x");
        let value = |formula: Expr| on_balls(formula, 64, &two).unwrap();
        for formula in [-x(), x() - x() - x()] {
            assert_eq!(value(formula).interval(), Ball::int(-2, 64).interval());
        }
        let power = |n, m| x().squared().pow(Expr::int(n) / Expr::int(m));
        for (formula, whole) in [(power(3, 2), 8), (x().pow(Expr::int(5)), 32)] {
            assert!(value(formula).meets(&Ball::int(whole, 64)));
        }
        let root = value(power(1, 3));
        assert!((&root * &root * &root).meets(&Ball::int(4, 64)) && root.known_bits() > 50);
        let negative = |of: &str| (of == "x").then(|| Ball::int(-2, 64));
        let cube = x().pow(Expr::int(-3));
        assert!(
            on_balls(cube, 64, &negative)
                .unwrap()
                .meets(&Ball::ratio(-1, 8, 64).unwrap())
        );
        assert!(on_balls(x().pow(Expr::int(1) / Expr::int(3)), 64, &negative).is_none());
    }

    #[test]
    fn functions_on_balls_are_those_of_numbers() {
        let third = |_: &str| Ball::ratio(1, 3, 64);
        let x = Expr::symbol("x");
        for formula in [
            x.sin(),
            x.cos(),
            x.tan(),
            x.asin(),
            x.acos(),
            x.sinh(),
            x.cosh(),
            x.tanh(),
            x.exp(),
            x.ln(),
            x.sqrt(),
            x.pow(x),
            x.cosh() / x.sinh(),
        ] {
            let ball = on_balls(formula, 64, &third).unwrap();
            let number = formula.evaluate(&|_| Some(1.0_f64 / 3.0)).unwrap();
            assert!(
                ball.interval().widened(1e-14).contains(number),
                "{formula:?}"
            );
            assert!(ball.known_bits() > 50, "{formula:?}");
        }
    }
}
