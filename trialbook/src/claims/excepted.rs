//! What a condition excepts: that it has no inside, or that the claim has no value there.

use super::compare::{Compared, Pair, Trial};
use super::points::Points;
use super::tolerances::NONE;
use crate::certified::interval::Interval;
use crate::evidence::{Evidence, Route, Subject};

/// Points of the domain, and as many more near what is excepted, that are looked at.
const POINTS: usize = 40;

/// How far from what is excepted its neighbours lie, in parts of the domain.
const NEAR: [f64; 3] = [1e-2, 1e-5, 1e-8];

/// That what a condition excepts has no inside: no point drawn from the `domain` is excepted, nor any that is drawn close to
/// one of the `excepted` points, while those are themselves. `holds` says whether the condition holds.
pub fn no_inside<const N: usize>(
    compared: Compared,
    names: [&str; N],
    domain: [[f64; 2]; N],
    excepted: &[[f64; N]],
    holds: impl Fn([f64; N]) -> bool,
) -> Evidence {
    let mut random = Points::stream(700);
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
    let trial = Trial::by(Route::Census, Subject::Excepted, compared, NONE);
    trial.over(points, |(point, expected)| {
        Ok(Pair {
            at: named(names, point),
            stated: f64::from(u8::from(holds(point))),
            found: f64::from(u8::from(expected)),
            scale: 1.0,
        })
    })
}

/// That a claim has no value at the `excepted` points, and has one at the `usual` ones, by arithmetic that is exact about
/// what is zero.
pub fn no_value<const N: usize>(
    compared: Compared,
    names: [&str; N],
    usual: [[f64; 2]; N],
    excepted: impl IntoIterator<Item = [Interval; N]>,
    law: impl Fn([Interval; N]) -> Interval,
) -> Evidence {
    let usual = Points::stream(701).within(POINTS, usual);
    let usual = usual
        .into_iter()
        .map(|point| (point.map(Interval::point), true));
    let excepted = excepted.into_iter().map(|point| (point, false));
    let trial = Trial::by(Route::Census, Subject::Excepted, compared, NONE);
    trial.over(usual.chain(excepted), |(point, expected)| {
        let value = law(point);
        let bounded = value.lo().is_finite() && value.hi().is_finite();
        Ok(Pair {
            at: named(names, point.map(|x| x.mid())),
            stated: f64::from(u8::from(bounded)),
            found: f64::from(u8::from(expected)),
            scale: 1.0,
        })
    })
}

fn named<const N: usize>(names: [&str; N], point: [f64; N]) -> String {
    let named = names.iter().zip(point);
    let named: Vec<_> = named.map(|(name, x)| format!("{name} = {x:.6}")).collect();
    named.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Outcome;
    use crate::scalar::Scalar;

    #[test]
    fn a_set_with_an_inside_is_not_degenerate() {
        let outcome = |excepted: &[[f64; 2]], holds: fn([f64; 2]) -> bool| {
            no_inside(
                Compared::shown(""),
                ["x", "y"],
                [[0.0, 1.0]; 2],
                excepted,
                holds,
            )
            .outcome()
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
            no_value(Compared::shown(""), ["x"], [[0.5, 1.0]], excepted, |[x]| {
                law(x)
            })
            .outcome()
        };
        assert_eq!(at(0, |x| x / x), Outcome::Agrees);
        assert_eq!(at(0, Scalar::ln), Outcome::Agrees);
        assert_eq!(at(2, |x| x / x), Outcome::Disagrees);
        // Without a value at the usual points too.
        assert_eq!(at(0, |x| Scalar::sqrt(-x)), Outcome::Disagrees);
    }
}
