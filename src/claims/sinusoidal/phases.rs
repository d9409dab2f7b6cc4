//! Trials of (27) to (30) and of what happens at these phases.

use super::prelude::*;
use super::reference_motions::{all, at};

type Formula = fn(Double) -> Double;

fn by_root(law: &'static str, formula: Formula, quarter: u8) -> Evidence {
    const QUARTERS: [&str; 4] = [
        r"$[0,\pi/2]$",
        r"$[\pi/2,\pi]$",
        r"$[\pi,3\pi/2]$",
        r"$[3\pi/2,2\pi]$",
    ];
    const ZERO: &str = r"the zero of $\lvert\sin\phi\rvert-\lambda_0$ in ";
    Trial::by(
        Root,
        Printed,
        Compared::composed([law, "", ""], [ZERO, QUARTERS[usize::from(quarter)], ""]),
        ROOT,
    )
    .over(all(), |lambda| {
        let from = FRAC_PI_2 * f64::from(quarter);
        let excess = |phi: f64| libm::sin(phi).abs() - lambda;
        let found = root(excess, from, from + FRAC_PI_2)?;
        let stated = formula(Double::from(lambda));
        // Rounding of the friction moves the phase, the more the flatter the drive.
        let scale = found.max(lambda / libm::cos(found).abs());
        Ok(Pair::wide(at(lambda), stated, found).within(scale))
    })
}

fn by_release(law: &'static str, formula: Formula, (name, from): (&'static str, f64)) -> Evidence {
    const REST: &str = r"the end of a simulated rest that holds at $\phi=";
    Trial::motion(
        Printed,
        Compared::composed([law, "", ""], [REST, name, "$"]),
    )
    .over(all(), |lambda| {
        let rest = DriveState {
            phi: from,
            ..ORIGIN
        };
        let path = drive()?.advance(Friction::new(lambda, lambda)?, rest, from + 2.0)?;
        let first = path.intervals.first().filter(|i| i.sign == Sign::Rest);
        let found = first.ok_or("no rest")?.end;
        Ok(beside_a_motion(lambda, formula, found))
    })
}

/// A printed phase with one of a motion, which knows the drive to a unit of rounding of its amplitude.
fn beside_a_motion(lambda: f64, formula: Formula, found: f64) -> Pair {
    let stated = formula(Double::from(lambda));
    let scale = found.max(1.0 / libm::cos(found).abs());
    Pair::wide(at(lambda), stated, found).within(scale)
}

/// A printed phase with the place of the largest |𝔴| where friction forbids the other direction.
fn by_extremum(
    law: &'static str,
    formula: Formula,
    (name, side): (&'static str, Sign),
) -> Evidence {
    const FASTEST: &str =
        r"the phase of the largest $\lvert\mathfrak w\rvert$ of a particle that can only slip ";
    let trial = Trial::motion(
        Printed,
        Compared::composed([law, "", ""], [FASTEST, name, ""]),
    );
    // Nearer to a zero of the drive, rounding hides which of two values of 𝔴 is the larger.
    let frictions = all().into_iter().filter(|lambda| *lambda > 1e-5);
    trial.over(frictions, |lambda| {
        let friction = match side {
            Sign::Positive => Friction::new(lambda, 2.0)?,
            _ => Friction::new(2.0, lambda)?,
        };
        let outcome = drive()?.attractor(friction, ORIGIN, 200)?;
        let top = outcome.settled().ok_or("it drifts")?.largest();
        let side_found = if top.w > 0.0 {
            Sign::Positive
        } else {
            Sign::Negative
        };
        let found = if side_found == side {
            top.phi
        } else {
            f64::NAN
        };
        Ok(beside_a_motion(lambda, formula, found))
    })
}

/// The distinct phases in [0, 2π) at which |h| equals the friction, from the monotone pieces of h.
fn balanced(drive: &Drive, lambda: f64) -> Vec<f64> {
    let mut found = Vec::new();
    for piece in drive.shape().pieces() {
        for level in [lambda, -lambda] {
            if (piece.left() - level) * (piece.right() - level) <= 0.0 {
                let s = piece.crossing(level, 0.0, piece.length());
                found.push((piece.start() + s).rem_euclid(TAU));
            }
        }
    }
    distinct(found)
}

/// In order, without those that are the same but for rounding or a period.
fn distinct(mut found: Vec<f64>) -> Vec<f64> {
    found.sort_by(f64::total_cmp);
    let same = |a: f64, b: f64| (a - b).abs() < 1e-12;
    found.dedup_by(|a, b| same(*a, *b));
    // The first may be the last, a period on.
    if let [first, .., last] = found[..]
        && same(first + TAU, last)
    {
        found.pop();
    }
    found
}

fn rests_from(lambda: f64, start: DriveState) -> Result<Vec<f64>, Failure> {
    let until = start.phi + 30.0;
    let path = drive()?.advance(Friction::new(lambda, lambda)?, start, until)?;
    let rests = path.intervals.iter().filter(|i| i.sign == Sign::Rest);
    Ok(rests.map(|i| i.end).filter(|end| *end < until).collect())
}

fn rest_ends_census() -> Evidence {
    let trial = Trial::census(
        Printed,
        [
            r"the number of rests that end elsewhere than at (27) and (29), of a particle that began with $v_y\ne0$ and rests at least once,",
            "0",
        ],
    );
    trial.drawn(0..20, |_, points| {
        let lambda = points.uniform(lambda_c() + 0.02, 0.97);
        let v = [points.uniform(-0.5, 0.5), points.uniform(0.1, 0.5)];
        let until = 3.0 * TAU;
        let motion = Particle::plain(lambda).run(points.uniform(0.0, TAU), v, until)?;
        let rests = motion
            .phases()
            .iter()
            .filter(|p| p.kind == PhaseKind::Stick);
        let ends: Vec<_> = rests.map(|p| p.to).filter(|to| *to < until).collect();
        let known = [printed::eq27_phi1(lambda), printed::eq29_phi3(lambda)];
        let elsewhere = |end: &&f64| {
            let off = |phi: f64| libm::remainder(**end - phi, TAU).abs();
            known.into_iter().all(|phi| off(phi) > 1e-10)
        };
        let wrong = ends.iter().filter(elsewhere).count();
        Ok(Pair::plain(
            format!("λ₀ = {lambda:.6}, v_y = {:.6}", v[1]),
            wrong as f64,
            if ends.is_empty() { f64::NAN } else { 0.0 },
        ))
    })
}

attempts![
    eq27_root = by_root("(27)", printed::eq27_phi1, 0),
    eq27_motion = by_release("(27)", printed::eq27_phi1, ("0", 0.0)),
    eq28_root = by_root("(28)", printed::eq28_phi2, 1),
    eq28_motion = by_extremum("(28)", printed::eq28_phi2, ("forwards", Sign::Positive)),
    eq29_root = by_root("(29)", printed::eq29_phi3, 2),
    eq29_motion = by_release("(29)", printed::eq29_phi3, (r"\pi", PI)),
    eq30_root = by_root("(30)", printed::eq30_phi4, 3),
    eq30_motion = by_extremum("(30)", printed::eq30_phi4, ("backwards", Sign::Negative)),
    four_points_census = Trial::census(
        Within,
        Compared::constant(
            "the stated 4",
            r"the number of phases in a period at which $\lvert h\rvert$ equals the friction",
        ),
    )
    .over(all(), |lambda| {
        Ok(Pair::plain(
            at(lambda),
            printed::s22_points(),
            balanced(drive()?, lambda).len() as f64,
        ))
    }),
    four_points_root = Trial::by(
        Root,
        Within,
        Compared::many(
            "(27) to (30)",
            r"the crossings of $h$ with $\pm\lambda_0$, in order",
        ),
        ROOT,
    )
    .pairs(all(), |lambda| {
        let stated: [Formula; 4] = [
            printed::eq27_phi1,
            printed::eq28_phi2,
            printed::eq29_phi3,
            printed::eq30_phi4,
        ];
        let found = balanced(drive()?, lambda);
        let pairs = stated.into_iter().enumerate().map(|(i, stated)| {
            let found = found.get(i).copied().unwrap_or(f64::NAN);
            beside_a_motion(lambda, stated, found)
        });
        Ok(pairs.collect())
    }),
    // λ₀ = 0: the points meet in pairs.
    four_points_outside = Trial::census(
        Outside,
        Compared::constant(
            "the stated 4",
            r"the number of phases in $[a,a+2\pi)$ at which $h$ vanishes, without friction,",
        ),
    )
    .drawn(0..24, |_, points| {
        let a = points.uniform(0.0, TAU);
        let zeros = balanced(drive()?, 0.0);
        let all = zeros.iter().flat_map(|phi| [*phi, phi + TAU]);
        Ok(Pair::plain(
            format!("λ₀ = 0, a = {a:.6}"),
            printed::s22_points(),
            all.filter(|phi| (a..a + TAU).contains(phi)).count() as f64,
        ))
    }),
    rest_ends_motion = {
        let trial = Trial::motion(
            Printed,
            ["the nearer of (27) and (29)", "the end of a simulated rest"],
        );
        let mut points = Points::here();
        let mut ends = Vec::new();
        for _ in 0..100 {
            let lambda = points.uniform(0.03, 0.999);
            let start = DriveState {
                phi: points.uniform(0.0, TAU),
                w: points.uniform(-1.0, 1.0) * points.uniform(0.0, 1.0).round(),
            };
            let over = parts(rests_from(lambda, start));
            ends.extend(over.map(|end| Ok::<_, Failure>((lambda, end?))));
        }
        trial.over(ends, |end| {
            let (lambda, end) = end?;
            let l = Double::from(lambda);
            let phase = end.rem_euclid(TAU);
            let [phi1, phi3] = [printed::eq27_phi1(l), printed::eq29_phi3(l)];
            let off = |phi: Double| (phi.to_f64() - phase).abs();
            let nearer = if off(phi1) < off(phi3) { phi1 } else { phi3 };
            let scale = end.max(1.0 / libm::cos(end).abs());
            let at = format!("λ₀ = {lambda:.6}, φ = {end:.6}");
            Ok(Pair::wide(at, nearer, phase).within(scale))
        })
    },
    rest_ends_census
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_phases_are_listed_once() {
        let phases = vec![TAU - 1e-13, 1.0, 1e-13, 1.0 + 1e-13, 2.0];
        assert_eq!(distinct(phases), [1e-13, 1.0, 2.0]);
        assert_eq!(distinct(vec![3.0, 0.5]), [0.5, 3.0]);
    }

    /// Where nothing is symmetrical.
    #[test]
    fn the_drive_is_as_large_as_the_friction_where_they_balance() {
        let two = |phi: f64| libm::sin(phi) + 0.3 * libm::sin(2.0 * phi + 0.5);
        let drive = Drive::new(two, &[]).unwrap();
        let found = balanced(&drive, 0.4);
        assert_eq!(found.len(), 4);
        for phi in found {
            assert!((drive.h(phi).abs() - 0.4).abs() < 1e-12, "{phi}");
        }
    }
}
