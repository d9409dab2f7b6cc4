//! Section 2.4, for all q from 1 to 12: how many roots the curves' equations have, the order of the curves, X, Y, and
//! a counterexample to the list of regions.
//!
//! B and E are parametrised by β = asin(qλ₀) between 0 and π/2, in which the arcs of Newton's law have slopes
//! everywhere: from α = asin λ₀ to π + β for B, to 2π − β for E. The printed (54) is held against the arc on every
//! part of a range. Where each root of a function crosses zero downwards, there is one at most; for that a part of
//! the range needs a sign of the function, or a negative slope.
//!
//! B's arc is positive at β = 0 and E's is 0 there and falls. At β = π/2 both arcs end at 3π/2 and are the same
//! function c of q, which is zero at q_Y only, where it changes from negative to positive. So B has one root for
//! q < q_Y and none beyond, E none before q_Y and one beyond.

use crate::certified::cover::{Said, everywhere};
use crate::certified::drive::{Edge, arc};
use crate::certified::error::CertifiedError;
use crate::certified::interval::{Interval, PI};
use crate::certified::jet::{Jet, over};
use crate::certified::{krawczyk, values};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::enclosed::{DIGITS, certified, numbers, on_balls};
use crate::claims::tolerances::NONE;
use crate::corrections::anisotropic as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::exact::Expr;
use crate::paper::anisotropic as printed;
use crate::scalar::Scalar;

type Two = Jet<2>;
type Outcome = Result<usize, CertifiedError>;
/// The two sides of an equation of λ₀ and qλ₀.
type Sides = fn(Two, Two) -> [Two; 2];

/// From 1 to 12.
fn ratios() -> Interval {
    Interval::new(1.0, 12.0)
}

/// q_Y, to the last places of an f64.
fn q_y() -> Result<Interval, CertifiedError> {
    let missing = CertifiedError::False { at: "q-Y".into() };
    values::find("q-Y").ok_or(missing)?.interval()
}

/// The arc that ends at the edge of the stretch in which the drive could pull backward, by q and β.
fn arc_to<S: Scalar>(edge: Edge, [q, beta]: [S; 2]) -> S {
    let lambda0 = beta.sin() / q;
    let end = match edge {
        Edge::Beginning => S::pi() + beta,
        Edge::End => S::int(2) * S::pi() - beta,
    };
    arc(lambda0.asin(), end, lambda0)
}

/// Whether the difference of an equation's sides is the arc, as far as can be seen in the middle of a part.
fn is_arc(sides: Sides, edge: Edge, cell: &[Interval; 2]) -> bool {
    let middle = cell.map(|x| Interval::point(x.mid()));
    let [left, right] = {
        let [q, beta] = middle.map(Jet::constant);
        sides(beta.sin() / q, beta.sin())
    };
    let difference = (left - right).value;
    difference.meet(arc_to(edge, middle)).is_some()
}

/// That the equation has one root β at most for each q, and that it is crossed in the direction of `way`.
fn prove_single_root(sides: Sides, edge: Edge, way: f64) -> Outcome {
    let range = [ratios(), Interval::new(0.0, (PI / Interval::int(2)).hi())];
    everywhere(range, |cell| {
        if !is_arc(sides, edge, cell) {
            return Said::Fails;
        }
        let jet = over(|x| arc_to(edge, x), cell);
        let falls = Said::of_sign(jet.slope[1], -1.0);
        if edge == Edge::End && cell[1].lo() == 0.0 {
            // The arc of E is 0 at β = 0: next to it, it falls, and is negative.
            return falls;
        }
        let crosses = Said::of_sign(jet.slope[1], way);
        let signs = [1.0, -1.0].map(|sign| Said::of_sign(jet.value, sign));
        match Said::any([crosses, signs[0], signs[1]]) {
            Said::Fails => Said::Nothing,
            said => said,
        }
    })
}

/// How far from q_Y its sides are looked at.
const NEAR_Y: f64 = 1e-13;

/// That c, the arc at β = π/2 by q, has its one zero at q_Y, where it changes from negative to positive.
fn prove_corner(critical: Interval) -> Outcome {
    let corner = |[q]: [Jet<1>; 1]| {
        let lambda0 = Jet::int(1) / q;
        let end = Jet::int(3) * Jet::pi() / Jet::int(2);
        arc(lambda0.asin(), end, lambda0)
    };
    let once = everywhere([ratios()], |cell| {
        let jet = over(corner, cell);
        let before = cell[0].below(critical);
        let sign = Said::of_sign(jet.value, if before { -1.0 } else { 1.0 });
        match Said::any([sign, Said::of_sign(jet.slope[0], 1.0)]) {
            Said::Fails => Said::Nothing,
            said => said,
        }
    })?;
    let mut parts = once;
    for sign in [-1.0, 1.0] {
        let q = critical + Interval::point(sign * NEAR_Y);
        parts += everywhere([q], |cell| Said::of_sign(over(corner, cell).value, sign))?;
    }
    Ok(parts)
}

/// That B's arc is positive at β = 0: (54) has a root only where c is negative.
fn prove_beginning() -> Outcome {
    everywhere([ratios()], |cell| {
        Said::of_sign(arc_to(Edge::Beginning, [cell[0], Interval::int(0)]), 1.0)
    })
}

fn prove_b(sides: Sides) -> Outcome {
    Ok(prove_single_root(sides, Edge::Beginning, -1.0)?
        + prove_beginning()?
        + prove_corner(q_y()?)?)
}

fn prove_e(sides: Sides) -> Outcome {
    Ok(prove_single_root(sides, Edge::End, 1.0)? + prove_corner(q_y()?)?)
}

/// (54) has one root before q_Y and none beyond.
pub fn b_once() -> Evidence {
    let compared = "(54) has one root for every 1 ≤ q < q_Y and none for q_Y < q ≤ 12, by the signs and slopes of the arc that ends at π + asin(qλ₀)";
    certified(prove_b(printed::eq54_sides), Subject::Within, compared)
}

/// E has no root before q_Y and one beyond.
pub fn e_once() -> Evidence {
    let compared = "E has no root but λ₀ = 0 for 1 ≤ q < q_Y and one for every q_Y < q ≤ 12, by the signs and slopes of the arc that ends at 2π − asin(qλ₀)";
    certified(prove_e(corrected::e_sides), Subject::Corrected, compared)
}

/// λ₀ on A by (53): its left side is cot asin λ₀.
fn on_a<S: Scalar>(q: S) -> S {
    let [_, right] = printed::eq53_sides(printed::eq53_k(q), S::int(1));
    S::int(1) / (S::int(1) + right.squared()).sqrt()
}

/// That (53) has one root for each q: its left side falls from ∞ to 0, its right side is positive.
fn prove_a(sides: fn(Two, Two) -> [Two; 2]) -> Outcome {
    let by = |[q, lambda0]: [Two; 2]| sides(printed::eq53_k(q), lambda0);
    let range = [ratios(), Interval::new(1e-3, 1.0)];
    let falls = everywhere(range, |cell| {
        let [left, right] = by(Jet::variables(cell));
        let difference = left - right;
        let below = Said::of_sign(difference.value, -1.0);
        match Said::any([below, Said::of_sign(difference.slope[1], -1.0)]) {
            Said::Fails => Said::Nothing,
            said => said,
        }
    })?;
    // At its ends, the lower one standing for all below.
    let ends = everywhere([ratios()], |cell| {
        let difference = |lambda0| {
            let [left, right] = by([cell[0], lambda0].map(Jet::constant));
            (left - right).value
        };
        let at_least = Interval::new(0.0, 1e-3);
        match (
            difference(at_least).sign(),
            difference(Interval::int(1)).sign(),
        ) {
            (Some(1.0), Some(-1.0)) => Said::Holds,
            (Some(-1.0), _) | (_, Some(1.0)) => Said::Fails,
            _ => Said::Nothing,
        }
    })?;
    Ok(falls + ends)
}

/// (53) has one root.
pub fn a_once() -> Evidence {
    let compared = "(53) has one root in 0 < λ₀ < 1 for every 1 ≤ q ≤ 12: the left side falls with λ₀ from above the right side to 0";
    certified(prove_a(printed::eq53_sides), Subject::Printed, compared)
}

/// That A lies below B up to Y and below E from Y on: the arc to the edge, on A.
fn prove_a_lowest(on_a: fn(Jet<1>) -> Jet<1>) -> Outcome {
    let y = q_y()?;
    let on = |edge| {
        move |[q]: [Jet<1>; 1]| {
            let lambda0 = on_a(q);
            arc_to(edge, [q, (q * lambda0).asin()])
        }
    };
    // At q = 1, where A and B meet, the arc is 0, as far as can be seen (and exactly so, by the proof of (57)).
    let before = everywhere([Interval::new(1.0, y.hi())], |cell| {
        let jet = over(on(Edge::Beginning), cell);
        if cell[0].lo() == 1.0 {
            let corner = over(on(Edge::Beginning), &[Interval::int(1)]).value;
            Said::all([Said::of_zero(corner), Said::of_sign(jet.slope[0], 1.0)])
        } else {
            Said::of_sign(jet.value, 1.0)
        }
    })?;
    let beyond = everywhere([Interval::new(y.lo(), 12.0)], |cell| {
        Said::of_sign(over(on(Edge::End), cell).value, -1.0)
    })?;
    Ok(before + beyond)
}

fn prove_order(on_a: fn(Jet<1>) -> Jet<1>, on_c: fn(Jet<1>) -> Jet<1>) -> Outcome {
    // C falls from 1, where D is.
    let c = everywhere([ratios()], |cell| {
        Said::of_sign(over(|[q]| on_c(q), cell).slope[0], -1.0)
    })?;
    let b = prove_b(printed::eq54_sides)?;
    Ok(c + b + prove_e(corrected::e_sides)? + prove_a_lowest(on_a)?)
}

/// The order of the curves.
pub fn order() -> Evidence {
    let compared = "A < B < C < D for all 1 < q < q_Y and A < E < C < D for all q_Y < q ≤ 12, with A = B and C = D at q = 1, where the slopes of their differences have a sign";
    let proof = prove_order(on_a, printed::eq55_lambda0);
    certified(proof, Subject::Corrected, compared)
}

/// X: (53) and (54) have one common root near (57).
pub fn x_unique() -> Evidence {
    let compared = "(57) with the only common root of (53) and (54) in 0.97 ≤ q ≤ 1.03, 0.525 ≤ λ₀ ≤ 0.55, enclosed to 1e-14";
    let meeting = prove_x(printed::eq53_sides, printed::eq54_sides);
    let stated = printed::eq57_x::<Interval>();
    let proof = meeting.and_then(|root| {
        let close = root
            .iter()
            .zip(stated)
            .all(|(a, b)| a.meet(b).is_some() && a.width() < 1e-14);
        let at = format!("{} × {}", root[0], root[1]);
        if close {
            Ok(1)
        } else {
            Err(CertifiedError::False { at })
        }
    });
    certified(proof, Subject::Printed, compared)
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

/// The decimals of (58), to the last one.
pub fn y_rounding() -> Evidence {
    let compared = "(58) with the enclosure of Y, rounded to three decimals";
    let trial = Trial::by(Route::Certified, Subject::Printed, compared, NONE);
    let points = ["q-Y", "lambda-Y"].into_iter().zip(printed::eq58_y());
    trial.over(points, |(name, stated)| {
        let value = values::find(name).ok_or("no such value")?;
        Ok::<_, Failure>(Pair {
            at: format!("{name}, rounded"),
            stated,
            found: value.decimal(3)?.parse()?,
            scale: 1.0,
        })
    })
}

/// (54) and (55) at Y.
pub fn y_digits() -> Evidence {
    let compared = "q = √(1 + x²) for the one x in (4.4, 4.6) with tan x = x, to 50 digits, with the sum of q and the difference of the sides of (54) on (55)";
    numbers(["q-Y"], Subject::Printed, compared, |bits| {
        let spare = bits + 32;
        let y = values::find("q-Y").and_then(|value| value.ball(DIGITS + 8).ok());
        let q = Expr::symbol("q");
        let [left, right] = printed::eq54_sides(printed::eq55_lambda0(q), Expr::int(1));
        [on_balls(q + left - right, spare, &|_| y.clone()).map(|ball| ball.with_bits(bits))]
    })
}

/// A point of the printed region II where the drive never pulls the particle back.
pub fn no_way_back() -> Evidence {
    let compared = "the sign of 𝔴 at the last moment at which the drive could pull backward: −1 in the printed region II, whose forward motion is over by then, with that of the arc of Newton's law, at q = 9, λ₀ = 1/10";
    let trial = Trial::by(Route::Certified, Subject::Printed, compared, NONE);
    trial.over([(9, Interval::ratio(1, 10))], |(q, lambda0)| {
        let q = Interval::int(q);
        // There is no B beyond q_Y.
        prove_b(printed::eq54_sides)?;
        let in_second =
            on_a(q).below(lambda0) && lambda0.below(printed::eq55_lambda0(q)) && q_y()?.below(q);
        if !in_second {
            return Err("the point is not proved to lie in the printed region II".into());
        }
        let last = Interval::int(2) * PI - (q * lambda0).asin();
        let velocity = arc(lambda0.asin(), last, lambda0);
        Ok::<_, Failure>(Pair {
            at: "q = 9, λ₀ = 1/10".into(),
            stated: -1.0,
            found: velocity.sign().unwrap_or(f64::NAN),
            scale: 1.0,
        })
    })
}

/// Between E and C there is no backward motion: E is where the arc to the last moment is zero.
pub fn e_below_c() -> Evidence {
    let compared = "the arc to the last moment at which the drive could pull backward is negative below E and positive between E and C, for every q_Y < q ≤ 12";
    certified(prove_e(corrected::e_sides), Subject::Corrected, compared)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_statements_are_proved() {
        for evidence in [
            a_once(),
            b_once(),
            e_once(),
            order(),
            x_unique(),
            y_rounding(),
            y_digits(),
            e_below_c(),
        ] {
            println!("{} {} {}", evidence.points, evidence.worst, evidence.at);
            assert_eq!(evidence.worst, 0.0, "{}", evidence.compared);
        }
        assert_eq!(no_way_back().worst, 2.0);
    }

    fn refused(proof: Outcome) -> Result<(), Failure> {
        match proof {
            Err(CertifiedError::False { .. }) => Ok(()),
            other => Err(format!("{other:?}").into()),
        }
    }

    #[test]
    fn mutated_statements_are_refused() -> Result<(), Failure> {
        refused(prove_b(corrected::e_sides))?;
        refused(prove_e(printed::eq54_sides))?;
        refused(prove_b(|l, u| {
            let [left, right] = printed::eq54_sides(l, u);
            [left, right + l / Two::int(1_000_000)]
        }))?;
        refused(prove_corner(q_y()? + Interval::point(1e-12)))?;
        // A raised by a part in a thousand crosses B.
        refused(prove_a_lowest(|q| {
            on_a(q) * Jet::int(1001) / Jet::int(1000)
        }))?;
        // A with the right side's sign changed.
        refused(prove_a(|k, l| {
            let [left, right] = printed::eq53_sides(k, l);
            [left, -right]
        }))?;
        refused(prove_order(on_a, |q| q))
    }

    #[test]
    fn mutated_points_are_refused() {
        let off = prove_x(printed::eq53_sides, |l, u| {
            let [left, right] = printed::eq54_sides(l, u);
            [left, right + l / Two::int(1000)]
        });
        let stated = printed::eq57_x::<Interval>();
        assert!(off.is_err() || off.is_ok_and(|root| root[1].meet(stated[1]).is_none()));
    }
}
