//! Trials of (140) to (145): the last moments before rest.
//!
//! Each equation is tried where what it leaves out is below the tolerance (p = 10⁻²⁰), where it is not (p = 10⁻³, in
//! units of its order), and where ψ → π.

use super::boundary::{angle_towards_one, border};
use super::prelude::*;
use super::trajectories::{
    APPROACHES, APPROACHES_TO_ONE_HALF, Approach, Close, OTHER_APPROACHES, approaches_to,
    gentle_approaches_to,
};
use crate::claims::escape::straight::{StraightIn, WITHIN_ONE, time_to_stop};
use crate::claims::escape::trajectories::{a, alpha, rates};
use crate::motion::turntable::intrinsic;
use crate::numerics::eigenvalues::{eigenvalues, jacobian};

/// What an equation says at σ, what the motion does, and the size of its terms.
type Sides = fn(sigma: f64, close: &Close) -> [f64; 3];

type Equation = (&'static str, &'static str, Sides);

/// A moment at which an equation is tried: its name, σ, the motion then, and the unit in which a difference is counted.
type Moment = Result<(String, f64, Close, f64), Failure>;

struct Way {
    route: Route,
    subject: Subject,
    tolerance: Tolerance,
    words: [&'static str; 2],
    moments: fn() -> Box<dyn Iterator<Item = Moment>>,
}

impl Way {
    fn tries(&self, (law, found, sides): Equation) -> Evidence {
        let [before, after] = self.words;
        let compared = Compared::composed([before, law, ""], [found, after, ""]);
        Trial::by(self.route, self.subject, compared, self.tolerance).over(
            (self.moments)(),
            |moment| {
                let (at, sigma, close, unit) = moment?;
                let [stated, found, size] = sides(sigma, &close);
                Ok(Pair {
                    at,
                    stated,
                    found,
                    scale: size * unit,
                })
            },
        )
    }
}

/// At p = 10⁻²⁰, for σ not so small that ψ has not relaxed even there.
const EXACTLY: Way = Way {
    route: Integration,
    subject: Within,
    tolerance: DIFFERENCES,
    words: [r"at $p=10^{-20}$, ", ""],
    moments: || {
        Box::new(approaches_to(&[(0.3, 0.98)]).map(|approach| {
            let approach = approach?;
            let close = approach.close(1e-20)?;
            Ok((named(approach.at(), &close), approach.sigma, close, 1.0))
        }))
    },
};

/// At p = 10⁻³, in units of the order of what is left out.
const BY_ORDER: Way = Way {
    route: Limit,
    subject: Within,
    tolerance: FIRST_OMITTED,
    words: [
        r"at $p=10^{-3}$, relatively and in units of $100(\alpha^2+\psi^2)/[\sigma(1-\sigma)^2]$, ",
        "",
    ],
    moments: || {
        Box::new(APPROACHES.each().map(|approach| {
            let approach = approach?;
            let (sigma, close) = (approach.sigma, approach.close(1e-3)?);
            let unit = 100.0 * close.omitted(sigma);
            Ok((named(approach.at(), &close), sigma, close, unit))
        }))
    },
};

const STRAIGHT: Way = Way {
    route: Integration,
    subject: Outside,
    tolerance: RELAXED,
    words: [r"on the way into a rest with $\psi\to\pi$, ", ""],
    moments: || {
        Box::new(WITHIN_ONE.each().map(|straight| {
            let straight = straight?;
            let (sigma, close) = close(straight)?;
            Ok((named(straight.at(), &close), sigma, close, 1.0))
        }))
    },
};

const STRAIGHT_CORRECTED: Way = Way {
    subject: Corrected,
    words: ["", r" of a motion that comes to rest with $\psi\to\pi$"],
    ..STRAIGHT
};

/// At σ = 1, where the motion takes for ever: on the boundary.
const AT_ONE: Way = Way {
    route: Root,
    subject: Outside,
    tolerance: BOUNDARY,
    words: ["on the boundary, ", ""],
    moments: || {
        Box::new(BORDERS_NEAR_ONE.each().map(|close| {
            let close = *close?;
            let at = format!("σ = 1, α = {:.3}, ψ = {:.6}", close.alpha, close.psi);
            Ok((at, 1.0, close, 1.0))
        }))
    },
};

fn named(at: String, close: &Close) -> String {
    format!("{at}, α = {:.6e}", close.alpha)
}

/// A moment just before a stop with ψ → π, α being about 10⁻³; σ to the square of that.
fn close(straight: &StraightIn) -> Result<(f64, Close), MotionError> {
    let state = straight.with_alpha_below(1e-3);
    let time = time_to_stop(&state);
    let run = Run::new(&state.parts, 0.5 * time)?;
    let (t, h) = (0.25 * time, 1e-2 * time);
    let [alpha_rate, psi_rate, a_rate, way_rate] = rates(t, h, |t| {
        let s = run.at(t)?;
        Ok([alpha(&s), s.psi(), s.a().unwrap_or(f64::NAN), s.s])
    })?;
    let now = run.at(t)?;
    let size = now.a().unwrap_or(f64::NAN);
    let left = time - t;
    let way_left = 0.5 * now.p() * left;
    let sigma = libm::sqrt(size * size + 2.0 * way_left);
    Ok((
        sigma,
        Close {
            left,
            alpha: alpha(&now),
            psi: now.psi(),
            a: size,
            alpha_rate,
            psi_slope: psi_rate / alpha_rate,
            ratio_slope: (psi_rate / alpha_rate - now.psi() / alpha(&now)) / 2.0,
            a_slope: a_rate / alpha_rate,
            a_slope_by_way: way_rate / (size * alpha_rate),
            way_left,
        },
    ))
}

/// On the boundary, which leads to A = 1, α = 0, with ψ = 2α + 2α².
static BORDERS_NEAR_ONE: Runs<Vec<Close>> = Runs::new(|| {
    let alphas = (1..=20).map(|i| 0.005 * f64::from(i));
    every(Points::here().grid(alphas).into_iter().map(leaving))
});

/// Just after the point of the boundary with this α. It never comes to rest: where (141) asks for the time that is
/// left, any will do.
fn leaving(alpha0: f64) -> Result<Close, Failure> {
    let psi = angle_towards_one(alpha0);
    let a0 = border(alpha0, psi)?.a;
    let h = 1e-3 * alpha0;
    let run = Run::new(&Start::hyperbolic(a0, alpha0, psi)?, 4.0 * h)?;
    let [a_rate, alpha_rate, psi_rate] = rates(2.0 * h, h, |t| {
        let state = run.at(t)?;
        Ok([a(&state), alpha(&state), state.psi()])
    })?;
    let now = run.at(2.0 * h)?;
    Ok(Close {
        left: 1.0,
        alpha: alpha(&now),
        psi: now.psi(),
        a: a(&now),
        alpha_rate,
        psi_slope: psi_rate / alpha_rate,
        ratio_slope: f64::NAN,
        a_slope: a_rate / alpha_rate,
        a_slope_by_way: f64::NAN,
        way_left: f64::NAN,
    })
}

const EQ140: Equation = (
    "(140)",
    r"$\mathrm d\alpha/\mathrm d\tau$ of the motion",
    |sigma, c| {
        let stated = printed::eq140_alpha_rate(sigma);
        [stated, c.alpha_rate, c.alpha_rate.abs()]
    },
);
const EQ141: Equation = (
    r"(141), with $\tau$ counted from the stop,",
    r"$\alpha$ of the motion",
    eq141,
);
fn eq141(sigma: f64, c: &Close) -> [f64; 3] {
    [printed::eq141_alpha(sigma, -c.left), c.alpha, c.alpha]
}
const EQ142: Equation = (
    r"the difference of the sides of (142), over $2+\psi/\alpha$, with $\mathrm d\psi/\mathrm d\alpha$ of the motion,",
    "0",
    |sigma, c| {
        let left = printed::eq142_left(sigma, c.psi_slope);
        let size = 2.0 + (c.psi / c.alpha).abs();
        [left - printed::eq142_right(c.alpha, c.psi), 0.0, size]
    },
);
const EQ144: Equation = (
    r"the relative difference of the sides of (144), with $\mathrm dA/\mathrm d\alpha$ of the motion,",
    "0",
    |sigma, c| eq144(sigma, c.a_slope, c.alpha),
);
const EQ144_WAY: Equation = (
    r"the relative difference of the sides of (144), with $A\,\mathrm dA=\mathrm ds$ from the path still to go,",
    "0",
    |sigma, c| eq144(sigma, c.a_slope_by_way, c.alpha),
);
fn eq144(sigma: f64, slope: f64, alpha: f64) -> [f64; 3] {
    let left = printed::eq144_left(sigma, slope);
    [left - printed::eq144_right(alpha), 0.0, alpha]
}
const EQ145: Equation = (
    "(145)",
    r"$A$ of the motion, over $A-\sigma$",
    |sigma, c| {
        let stated = printed::eq145_a(sigma, c.alpha);
        [stated, c.a, (c.a - sigma).abs()]
    },
);
/// The coefficient of α², where A − σ is too small to be taken as a difference: σ² − A² is twice the way still to go.
const EQ145_WAY: Equation = (
    r"the coefficient of $\alpha^2$ in (145)",
    r"$(A-\sigma)/\alpha^2$ of the motion, where $A^2$ is $\sigma^2$ less twice the length of the path still to go",
    |sigma, c| {
        let found = -c.way_left / (sigma * c.alpha * c.alpha);
        [printed::eq145_a(sigma, 1.0) - sigma, found, found.abs()]
    },
);

/// Two levels of p at which the terms of (143) are well apart from rounding and from what is left out.
fn levels(sigma: f64) -> [f64; 2] {
    if sigma < 0.5 {
        [1e-12, 1e-14]
    } else if sigma < 0.6 {
        [1e-6, 1e-8]
    } else {
        [1e-5, 1e-7]
    }
}

/// The constant in the brackets of (143), from two moments. By how much the power of α that stands beside it changes from one
/// to the other, the slopes tell. Also α at the later one, and what is left out at the earlier one.
fn constant(approach: &Approach) -> Result<[f64; 3], Failure> {
    let [far, near] = levels(approach.sigma);
    let (far, near) = (approach.close(far)?, approach.close(near)?);
    let q = far.ratio_slope / near.ratio_slope;
    let found = (far.ratio() - q * near.ratio()) / (1.0 - q);
    // Of the slopes, too, of which an error is as much larger in what they give as the ratio is larger than they are.
    let left_out = far.left_out() * (1.0 + (far.ratio() / far.ratio_slope).abs());
    Ok([found, near.alpha, left_out])
}

const CONSTANT: Compared = Compared::one(
    r"$\sigma/(2\sigma-1)$",
    r"the limit of $\psi/(2\alpha)$ without its power of $\alpha$",
);

fn constants(subject: Subject, compared: Compared, ranges: &'static [(f64, f64)]) -> Evidence {
    Trial::by(Limit, subject, compared, NEAR_REST).over(gentle_approaches_to(ranges), |approach| {
        let approach = approach?;
        let [found, alpha, left_out] = constant(approach)?;
        Ok(Pair {
            at: format!("{}, α = {alpha:.6e}", approach.at()),
            stated: printed::eq143_constant(approach.sigma),
            found,
            scale: unit(subject, 1.0 + found.abs(), left_out, NEAR_REST),
        })
    })
}

/// What is left out can be the larger part of a difference where c is large, or, beside a slope, where it is small;
/// without the condition of (143) this is what the trial is about.
fn unit(subject: Subject, size: f64, left_out: f64, tolerance: Tolerance) -> f64 {
    match subject {
        Within => size.max(left_out / tolerance.value),
        _ => size,
    }
}

const EXPONENT: Compared = Compared::one(
    r"$(2\sigma-1)/(1-\sigma)$",
    r"the exponent of $\alpha$ in $\psi/\alpha$ of the motion",
);

fn exponents(
    subject: Subject,
    compared: Compared,
    ranges: &'static [(f64, f64)],
    levels: fn(f64) -> [f64; 2],
) -> Evidence {
    Trial::by(Integration, subject, compared, NEAR_REST_EXPONENT).over(
        gentle_approaches_to(ranges),
        |approach| {
            let approach = approach?;
            let [far, near] = levels(approach.sigma);
            let (far, near) = (approach.close(far)?, approach.close(near)?);
            let ratio = far.ratio_slope / near.ratio_slope;
            let left_out = far.left_out() / far.ratio_slope.abs();
            Ok(Pair {
                at: format!("{}, α = {:.6e}", approach.at(), near.alpha),
                stated: printed::eq143_exponent(approach.sigma),
                found: libm::log(ratio.abs()) / libm::log(far.alpha / near.alpha),
                scale: unit(subject, 1.0, left_out, NEAR_REST_EXPONENT),
            })
        },
    )
}

/// Steps of the differences about a rest, of products of two numbers: without an error of the method.
const STEP: f64 = 1e-2;

fn early_levels(sigma: f64) -> [f64; 2] {
    if sigma < 0.5 {
        [1e-10, 1e-11]
    } else {
        [1e-6, 1e-7]
    }
}

/// α and ψ where p has fallen below 10⁻⁹, 10⁻¹⁰ and so on to 10⁻²⁸.
fn tenfold(run: &Run) -> Vec<[f64; 2]> {
    let levels = (9..29).filter_map(|n| {
        let p = libm::pow(10.0, f64::from(-n));
        run.nodes().find(|s| s.p() < p)
    });
    let mut states: Vec<_> = levels.map(|s| [alpha(&s), s.psi()]).collect();
    // A long step passes two levels at once.
    states.dedup();
    states
}

/// How often both come nearer to their limits, from the second state on. One that has just gone through its limit moves off
/// for a while, by less than e-fold in α; it counts as nearing.
fn nearing(states: &[[f64; 2]], limits: [f64; 2]) -> usize {
    let off = |n: usize, i: usize| states[n][i] - limits[i];
    let through = |n: usize, i: usize| off(n, i) * off(n - 1, i) < 0.0;
    let nears = |n: usize, i: usize| {
        off(n, i).abs() < off(n - 1, i).abs() || through(n, i) || through(n - 1, i)
    };
    let steps = 2..states.len();
    steps
        .filter(|&n| [0, 1].iter().all(|&i| nears(n, i)))
        .count()
}
attempts![
    eq143_linearised = {
        let trial = Trial::by(
            Root,
            Within,
            [
                r"$(2\sigma-1)/(1-\sigma)$",
                r"the rate at which $\zeta$ falls at $p=0$, over that at which $p$ falls, less 1: eigenvalues of the motion linearised about the rest",
            ],
            LINEARISED,
        );
        let sigmas = Points::here().within(20, [[0.26, 0.74]]);
        trial.at(["σ"], sigmas, 1.0, |[sigma]| {
            let rest = [0.0, 1.0 - sigma, 0.0];
            let matrix = jacobian(|x| Ok::<_, Failure>(intrinsic::rates(x)), rest, [STEP; 3])?;
            let [_, [_, a, b], [_, c, d]] = matrix;
            let across = eigenvalues([[a, b], [c, d]])?;
            // What the eigenvalues of the whole have beside these.
            let sum = |of: &[[f64; 2]]| of.iter().map(|[real, _]| real).sum::<f64>();
            let along = sum(&eigenvalues(matrix)?) - sum(&across);
            let found = across[0][0] / along - 1.0;
            Ok([printed::eq143_exponent(sigma), found])
        })
    },
    eq140_motion = EXACTLY.tries(EQ140),
    eq140_order = BY_ORDER.tries(EQ140),
    eq140_straight = STRAIGHT.tries(EQ140),
    corrected140 = STRAIGHT_CORRECTED.tries((
        r"$-1-1/\sigma$",
        r"$\mathrm d\alpha/\mathrm d\tau$",
        |sigma, c| {
            let stated = corrected::alpha_rate_straight_in(sigma);
            [stated, c.alpha_rate, c.alpha_rate.abs()]
        }
    )),
    eq140_at_one = AT_ONE.tries(EQ140),
    eq141_motion = EXACTLY.tries(EQ141),
    eq141_order = BY_ORDER.tries(EQ141),
    eq141_straight = STRAIGHT.tries(EQ141),
    eq141_at_one = AT_ONE.tries((r"(141), for any $\tau$,", r"$\alpha$", eq141)),
    eq141_clock = Way {
        subject: Outside,
        ..EXACTLY
    }
    .tries((
        r"(141), with $\tau$ counted from one unit of time after the stop,",
        r"$\alpha$ of the motion",
        |sigma, c| [printed::eq141_alpha(sigma, -c.left - 1.0), c.alpha, c.alpha]
    )),
    eq142_motion = EXACTLY.tries(EQ142),
    eq142_order = BY_ORDER.tries(EQ142),
    eq142_straight = STRAIGHT.tries(EQ142),
    eq142_at_one = AT_ONE.tries(EQ142),
    eq143_constant = constants(Within, CONSTANT, &[(0.36, 0.47), (0.53, 0.7)]),
    eq143_exponent = exponents(
        Within,
        EXPONENT,
        &[(0.36, 0.47), (0.53, 0.62)],
        early_levels
    ),
    // What is left out exceeds the first term.
    eq143_small_sigma = constants(Outside, CONSTANT.over(r"$\sigma<1/4$"), &[(0.05, 0.24)]),
    // What is left out exceeds the second term.
    eq143_large_sigma = exponents(
        Outside,
        EXPONENT.over(r"$\sigma>3/4$"),
        &[(0.8, 0.98)],
        |_| [1e-3, 1e-4]
    ),
    eq143_one_half = Trial::by(
        Integration,
        Outside,
        Compared::one(
            r"(143) over $2\alpha$",
            r"$\psi/(2\alpha)$ of the motion at $p=10^{-10}$",
        )
        .over(r"$\sigma=1/2$"),
        NEAR_REST,
    )
    .each(APPROACHES_TO_ONE_HALF.each(), Approach::at, |approach| {
        let close = approach.close(1e-10)?;
        Ok([
            printed::eq143_psi(0.5, 0.0, close.alpha) / (2.0 * close.alpha),
            close.ratio(),
            close.ratio().abs(),
        ])
    }),
    eq143_straight = STRAIGHT.tries(("(143)", r"$\psi$ of the motion", |sigma, c| {
        [printed::eq143_psi(sigma, 0.0, c.alpha), c.psi, 1.0]
    })),
    eq143_regular = Trial::by(
        Integration,
        Corrected,
        Compared::one(
            r"the regular form of (143) over $2\alpha$, its constant taken at $p=10^{-10}$,",
            r"$\psi/(2\alpha)$ at $p=10^{-12}$",
        )
        .over(r"$\sigma=1/2$"),
        NEAR_REST,
    )
    .each(APPROACHES_TO_ONE_HALF.each(), Approach::at, |approach| {
        let (far, near) = (approach.close(1e-10)?, approach.close(1e-12)?);
        let ratio = |c: f64, alpha: f64| corrected::psi_at_one_half(c, alpha) / (2.0 * alpha);
        let c = far.ratio() - ratio(0.0, far.alpha);
        Ok([ratio(c, near.alpha), near.ratio(), near.ratio().abs()])
    }),
    eq144_motion = EXACTLY.tries(EQ144_WAY),
    eq144_order = BY_ORDER.tries(EQ144),
    eq144_straight = STRAIGHT.tries(EQ144),
    eq144_at_one = AT_ONE.tries(EQ144),
    eq145_motion = EXACTLY.tries(EQ145_WAY),
    eq145_order = BY_ORDER.tries(EQ145),
    eq145_straight = STRAIGHT.tries(EQ145_WAY),
    eq145_at_one = AT_ONE.tries(("(145)", "$A$", |sigma, c| {
        [printed::eq145_a(sigma, c.alpha), c.a, 1.0]
    })),
    near_rest_angle = {
        let both = with_each(approaches_to(&[(0.3, 0.98)]), [0, 1]);
        Trial::by(
            Limit,
            Within,
            Compared::many(
                r"the limits 0 of $\alpha$ and $\psi$",
                r"$\alpha$ and $\psi$ of the motion at $p=10^{-30}$",
            ),
            RELAXED,
        )
        .over(both, |case| {
            let (approach, i) = case?;
            let end = approach.run.end();
            Ok(Pair::plain(
                approach.at(),
                printed::s4_near_rest_limits()[i],
                [alpha(&end), end.psi()][i],
            ))
        })
    },
    near_rest_census = {
        let trial = Trial::census(
            Within,
            [
                r"the number of tenfold falls of $p$, from $10^{-10}$ on, over which $\alpha$ and $\psi$ both come nearer to their limits 0,",
                "that of all such falls",
            ],
        );
        trial.each(OTHER_APPROACHES.each(), Approach::at, |approach| {
            let states = tenfold(&approach.run);
            Ok([
                nearing(&states, printed::s4_near_rest_limits()) as f64,
                states.len().saturating_sub(2) as f64,
                1.0,
            ])
        })
    },
    near_rest_straight = STRAIGHT.tries(("the stated 0", r"$\psi$ of the motion", |_, c| {
        [printed::s4_near_rest_limits()[1], c.psi, 1.0]
    })),
    corrected_near_rest =
        STRAIGHT_CORRECTED.tries((r"$\pi-2\alpha/(2+1/\sigma)$", r"$\psi$", |sigma, c| {
            let stated = PI - corrected::angle_straight_in(sigma, c.alpha);
            [stated, c.psi, c.alpha]
        }))
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::escape::straight::straight_in;

    #[test]
    fn states_that_come_nearer_are_counted() {
        let states = [
            [2.0, 2.0],
            [1.0, 1.0],
            [0.5, 0.5],
            [0.4, 0.6],
            [0.6, 0.3],
            [0.6, 0.2],
            [0.1, 0.1],
        ];
        assert_eq!(nearing(&states, [0.0; 2]), 2);
        assert_eq!(nearing(&states[..3], [0.0; 2]), 1);
        assert_eq!(nearing(&states[..3], [1.0, 0.0]), 0);
        assert_eq!(nearing(&states[1..4], [0.0, 0.56]), 1);
        let after = |psi: f64| [[1.0, psi], [0.5, -0.01], [0.25, -0.02]];
        assert_eq!(
            [0.1, -0.1].map(|psi| nearing(&after(psi), [0.0; 2])),
            [1, 0]
        );
        let approach = Approach::new([0.5, 0.2, 0.5]).unwrap().unwrap();
        let levels = tenfold(&approach.run);
        assert_eq!(levels.len(), 20);
        for (n, [alpha, _]) in (9..).zip(levels) {
            let p = alpha * approach.sigma * libm::pow(10.0, f64::from(n));
            assert!((0.01..1.0001).contains(&p), "{p} at 1e-{n}");
        }
    }

    #[test]
    fn the_way_left_gives_the_resting_place_and_the_slope() {
        let straight = straight_in(0.7, 0.1).unwrap();
        let (sigma, close) = close(&straight).unwrap();
        let rest = straight.stop().rho();
        assert!((sigma - rest).abs() < 1e-8, "{sigma}, {rest}");
        let (slope, by_way) = (close.a_slope, close.a_slope_by_way);
        assert!(
            (slope - by_way).abs() < 1e-5 * slope.abs(),
            "{slope}, {by_way}"
        );
    }
}
