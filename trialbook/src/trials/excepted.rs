//! What a condition excepts: that it has no inside, or that the claim has no value there.

use super::compare::{Compared, Pair, Trial};
use super::points::Points;
use crate::certified::interval::Interval;
use crate::evidence::{Evidence, Subject};

const POINTS: usize = 40;

/// In parts of the domain.
const NEAR: [f64; 3] = [1e-2, 1e-5, 1e-8];

/// That what a condition excepts has no inside: no point drawn from the ranges of the `coordinates` is
/// excepted, nor any close to an `excepted` one. The words say `what` is drawn, and what `alone` is excepted.
pub fn no_inside<const N: usize>(
    what: &'static str,
    alone: &'static str,
    coordinates: [(&str, [f64; 2]); N],
    excepted: &[[f64; N]],
    holds: impl Fn([f64; N]) -> bool,
) -> Evidence {
    let compared = Compared::composed(
        ["whether ", what, " meets the condition (1 if so)"],
        ["the expectation that all do but ", alone, ""],
    );
    let compared = compared.over("random ones, those that are excepted, and some close to them");
    let domain = coordinates.map(|(_, range)| range);
    let mut random = Points::here();
    let mut points: Vec<_> = excepted.iter().map(|point| (*point, false)).collect();
    for i in 0..POINTS {
        points.push((domain.map(|[low, high]| random.uniform(low, high)), true));
        let near = NEAR[i % NEAR.len()];
        let mut neighbour = excepted[i % excepted.len()];
        for (x, [low, high]) in neighbour.iter_mut().zip(domain) {
            let step = near * (high - low) * random.uniform(0.5, 1.0);
            // Inwards where it lies on the edge of the domain.
            let outwards = *x + step > high || (*x - step >= low && random.sign() < 0.0);
            *x += if outwards { -step } else { step };
        }
        points.push((neighbour, true));
    }
    let looked_at = points
        .into_iter()
        .map(|(point, expected)| (point, holds(point), expected));
    whether(compared, coordinates, looked_at)
}

/// That a law has no value at the `excepted` points, and has one at usual ones, drawn from the ranges of the
/// `coordinates`, exactly. The words say what `holds` at the usual points, and where the `others` are.
pub fn no_value<const N: usize>(
    name: &'static str,
    holds: &'static str,
    others: &'static str,
    coordinates: [(&str, [f64; 2]); N],
    excepted: impl IntoIterator<Item = [Interval; N]>,
    law: impl Fn([Interval; N]) -> Interval,
) -> Evidence {
    let compared = Compared::composed(
        ["whether ", name, " has a value (1 if so)"],
        ["whether ", holds, ""],
    );
    let compared = compared.over_composed(["some of them random, the others ", others, ""]);
    let usual = Points::here().within(POINTS, coordinates.map(|(_, range)| range));
    let usual = usual
        .into_iter()
        .map(|point| (point.map(Interval::point), true));
    let points = usual.chain(excepted.into_iter().map(|point| (point, false)));
    let looked_at = points.map(|(point, expected)| {
        let value = law(point);
        let bounded = value.lo().is_finite() && value.hi().is_finite();
        (point.map(Interval::mid), bounded, expected)
    });
    whether(compared, coordinates, looked_at)
}

/// With six decimals, or as many as show on which side of a round number it is.
fn place(x: f64) -> String {
    let from_round = (x - libm::round(1e3 * x) / 1e3).abs();
    match from_round > 0.0 && from_round < 1e-7 {
        true => format!("{x:.12}"),
        false => format!("{x:.6}"),
    }
}

fn whether<const N: usize>(
    compared: Compared,
    coordinates: [(&str, [f64; 2]); N],
    points: impl IntoIterator<Item = ([f64; N], bool, bool)>,
) -> Evidence {
    let trial = Trial::census(Subject::Excepted, compared);
    trial.over(points, |(point, is_so, expected)| {
        let named = coordinates.iter().zip(point);
        let at: Vec<_> = named
            .map(|((name, _), x)| format!("{name} = {}", place(x)))
            .collect();
        Ok(Pair {
            at: at.join(", "),
            stated: f64::from(u8::from(is_so)),
            found: f64::from(u8::from(expected)),
            scale: 1.0,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Outcome;
    use crate::scalar::Scalar;

    #[test]
    fn a_set_with_an_inside_is_not_degenerate() {
        let outcome = |excepted: &[[f64; 2]], holds: fn([f64; 2]) -> bool| {
            let plane = ["x", "y"].map(|name| (name, [0.0, 1.0]));
            no_inside("a point", "one", plane, excepted, holds).outcome()
        };
        // An edge, a line, a point.
        assert_eq!(outcome(&[[0.0, 0.3]], |[x, _]| x > 0.0), Outcome::Agrees);
        assert_eq!(outcome(&[[0.5, 0.5]], |[x, y]| x != y), Outcome::Agrees);
        assert_eq!(
            outcome(&[[1.0, 1.0]], |point| point != [1.0; 2]),
            Outcome::Agrees
        );
        // A strip however thin; and a condition that excepts nothing.
        assert_eq!(
            outcome(&[[0.0, 0.3]], |[x, _]| x > 1e-7),
            Outcome::Disagrees
        );
        assert_eq!(outcome(&[[0.0, 0.3]], |_| true), Outcome::Disagrees);
    }

    #[test]
    fn a_claim_that_has_a_value_where_it_is_said_to_have_none_is_found() {
        let at = |excepted: i64, law: fn(Interval) -> Interval| {
            let excepted = [[Interval::int(excepted)]];
            let line = [("x", [0.5, 1.0])];
            no_value("(1)", "it holds", "not", line, excepted, |[x]| law(x)).outcome()
        };
        assert_eq!(at(0, |x| x / x), Outcome::Agrees);
        assert_eq!(at(0, Scalar::ln), Outcome::Agrees);
        assert_eq!(at(2, |x| x / x), Outcome::Disagrees);
        // Without a value at the usual points too.
        assert_eq!(at(0, |x| Scalar::sqrt(-x)), Outcome::Disagrees);
    }
}
