//! X, Y, and a point where the list of regions fails: single points, proved.

use super::super::exact;
use super::{Two, on_a, prove_b, q_y};
use crate::claims::anisotropic::prelude::*;
use crate::validated::drive::arc;
use crate::validated::numbers::{LAMBDA_Y, Q_Y};
use trialbook::certified::interval::{Interval, PI};
use trialbook::certified::krawczyk;
use trialbook::trials::enclosed::{DIGITS, certified, numbers, on_balls};

/// The two sides of an equation of λ₀ and qλ₀, or of K and λ₀.
type Sides = fn(Two, Two) -> [Two; 2];

/// That the stated point may be the root, which is known to 1e-14.
fn prove_stated(root: [Interval; 2], stated: [Interval; 2]) -> Result<usize, CertifiedError> {
    let at = format!("{} × {}", root[0], root[1]);
    let mut sides = root.iter().zip(stated);
    if sides.any(|(a, b)| a.meet(b).is_none()) {
        return Err(CertifiedError::False(at));
    }
    if root.iter().any(|side| side.width() >= 1e-14) {
        let why = "the root is not known well enough";
        return Err(CertifiedError::NotProved { why, at });
    }
    Ok(1)
}

fn prove_x(a: Sides, b: Sides) -> Result<[Interval; 2], CertifiedError> {
    let curves = |[q, lambda0]: [Two; 2]| {
        let [left, right] = a(printed::eq53_k(q), lambda0);
        let [up, down] = b(lambda0, q * lambda0);
        [left - right, up - down]
    };
    krawczyk::unique(
        curves,
        [Interval::new(0.97, 1.03), Interval::new(0.525, 0.55)],
    )
}

pub(crate) fn y_digits() -> Evidence {
    let compared = Compared::one(
        "the sum of $q$ and the difference of the sides of (54) on (55), to 50 digits,",
        r"$q=\sqrt{1+x^2}$, for the one $x$ in $(4.4,4.6)$ with $\tan x=x$",
    );
    numbers([("q of Y", Q_Y)], Printed, compared, |bits| {
        let spare = bits + 32;
        let y = where_defined(Q_Y.ball(DIGITS + 8));
        let q = symbol("q");
        let [left, right] = printed::eq54_sides(printed::eq55_lambda0(q), int(1));
        [on_balls(q + left - right, spare, &|_| y.clone()).map(|ball| ball.with_bits(bits))]
    })
}

/// That a point lies in the printed region II: above A, below C, beyond q_Y.
fn in_second([q, lambda0]: [Interval; 2], critical: Interval) -> bool {
    on_a(q).below(lambda0) && lambda0.below(printed::eq55_lambda0(q)) && critical.below(q)
}

/// The last moment at which the drive could pull backward.
fn last_pull([q, lambda0]: [Interval; 2]) -> Interval {
    Interval::int(2) * PI - (q * lambda0).asin()
}

/// The sign of a velocity; no number where the enclosure does not tell it.
fn sign_of(velocity: Interval) -> f64 {
    velocity.sign().unwrap_or(f64::NAN)
}

fn no_way_back() -> Evidence {
    let trial = Trial::by(Certified, Printed, Compared::one(
        r"the sign of $\mathfrak w$ at the last moment at which the drive could pull backward, $-1$ in the printed region II, whose forward motion is over by then,",
        "the sign that the arc of Newton's law has there",
    )
    .over(r"$q=9$, $\lambda_0=1/10$"), NONE);
    trial.over([(9, Interval::ratio(1, 10))], |(q, lambda0)| {
        let q = Interval::int(q);
        // There is no B beyond q_Y.
        prove_b(exact::sides_of_b())?;
        if !in_second([q, lambda0], q_y()?) {
            return Err("the point is not proved to lie in the printed region II".into());
        }
        let last = last_pull([q, lambda0]);
        let velocity = arc(lambda0.asin(), last, lambda0);
        Ok(Pair::plain(
            "q = 9, λ₀ = 1/10".into(),
            -1.0,
            sign_of(velocity),
        ))
    })
}

attempts![
    x_unique = {
        let compared = Compared::one(
            "(57)",
            r"the only common root of (53) and (54) in $0.97\le q\le1.03$, $0.525\le\lambda_0\le0.55$, which is enclosed to $10^{-14}$ and has a positive $\lambda_0$",
        );
        let meeting = prove_x(printed::eq53_sides, printed::eq54_sides);
        let proof = meeting.and_then(|root| prove_stated(root, printed::eq57_x()));
        certified(proof, Printed, compared)
    },
    y_rounding = {
        let trial = Trial::by(
            Certified,
            Printed,
            ["(58)", "the enclosure of Y, rounded to three decimals"],
            NONE,
        );
        let points = [("q of Y", Q_Y), ("λ₀ of Y", LAMBDA_Y)]
            .into_iter()
            .zip(printed::eq58_y());
        trial.over(points, |((name, value), stated)| {
            Ok(Pair::plain(
                format!("{name}, rounded"),
                stated,
                value.decimal(3)?.parse()?,
            ))
        })
    },
    no_way_back,
    y_digits
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mutated_points_are_refused() {
        let off = prove_x(printed::eq53_sides, |l, u| {
            let [left, right] = printed::eq54_sides(l, u);
            [left, right + l / Two::int(1000)]
        });
        let stated = printed::eq57_x();
        assert!(off.and_then(|root| prove_stated(root, stated)).is_err());
        // The exact proof knows λ₀ by its square only; here its sign counts.
        let root = prove_x(printed::eq53_sides, printed::eq54_sides).unwrap();
        let [q, lambda0] = stated;
        assert!(prove_stated(root, [q, -lambda0]).is_err());
    }

    #[test]
    fn a_sign_that_is_not_known_is_none() {
        for (lo, hi, sign) in [(0.5, 2.0, 1.0), (-2.0, -0.5, -1.0)] {
            assert_eq!(sign_of(Interval::new(lo, hi)), sign);
        }
        for (lo, hi) in [(-1.0, 2.0), (-1e-9, 1e-9), (f64::NEG_INFINITY, 1.0)] {
            assert!(sign_of(Interval::new(lo, hi)).is_nan());
        }
    }

    #[test]
    fn the_printed_region_has_three_sides() {
        let critical = q_y().unwrap();
        let at = |n: i64| [Interval::int(9), Interval::ratio(n, 1000)];
        assert!(in_second(at(100), critical));
        // Below A, above C, and before a corner that lay farther out.
        assert!(!in_second(at(1), critical));
        assert!(!in_second(at(120), critical));
        assert!(!in_second(at(100), Interval::int(10)));
    }

    #[test]
    fn the_drive_pulls_backward_for_the_last_time_where_it_equals_friction() {
        let [q, lambda0] = [Interval::int(9), Interval::ratio(1, 10)];
        let last = last_pull([q, lambda0]);
        let pull = -last.sin();
        assert!(
            pull.meet(q * lambda0).is_some() && pull.width() < 1e-14,
            "{pull}"
        );
        assert!(last.inside(Interval::new(4.72, 6.2)), "{last}");
    }
}
