//! The curves of fig-2 to fig-4: what is tried here is what the book draws.

use super::prelude::*;
use super::reference_motions::{eq33, eq38, printed_late};
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2};

/// λ₀ of fig-3.
pub(crate) const SMALL: f64 = FRAC_1_PI;
/// λ₀ of fig-4.
pub(crate) const LARGE: f64 = FRAC_1_SQRT_2;

/// 𝔴 at the start of every curve of fig-2.
pub(crate) const W_X: f64 = 1.0;
pub(crate) const W_Y: [f64; 5] = [0.0, 0.5, 1.0, 2.0, 4.0];
/// Periods that fig-2 shows.
pub(crate) const PERIODS: u32 = 4;
/// Periods after which motions that start like those of fig-2 are compared with the large-time motion.
const FOLLOWED: u32 = 16;
const POINTS: u32 = 48;

#[derive(Debug, Clone)]
pub(crate) struct Transient {
    pub lambda: f64,
    /// At φ = 0.
    pub w_y: f64,
    pub states: Vec<PlanarState>,
}

impl Transient {
    fn at(&self, phi: f64) -> String {
        let Transient { lambda, w_y, .. } = self;
        format!("λ₀ = {lambda:.6}, 𝔴_y = {w_y} at φ = 0, φ = {phi:.6}")
    }
}

pub(crate) fn transients() -> Result<&'static [Transient], Failure> {
    static CURVES: Runs<Vec<Transient>> = Runs::new(|| {
        let pairs = [SMALL, LARGE]
            .into_iter()
            .flat_map(|lambda| W_Y.into_iter().map(move |w_y| (lambda, w_y)));
        every(pairs.map(|(lambda, w_y)| transient(lambda, w_y)))
    });
    Ok(CURVES.get()?)
}

fn transient(lambda: f64, w_y: f64) -> Result<Transient, Failure> {
    let start = PlanarState {
        phi: 0.0,
        w_x: W_X,
        ln_w_y: Scalar::ln(w_y),
    };
    let phases: Vec<_> = (0..=PERIODS * POINTS)
        .map(|k| TAU * f64::from(k) / f64::from(POINTS))
        .collect();
    let states = drive()?.planar(lambda, start, &phases)?;
    Ok(Transient {
        lambda,
        w_y,
        states,
    })
}

/// Points (φ, 𝔴) of the large-time motion, as fig-3 and fig-4 show it.
pub(crate) fn two_periods(lambda: f64) -> Result<Vec<[f64; 2]>, Failure> {
    let attractor = settled(lambda, ORIGIN)?;
    let phase = |k: u32| 2.0 * TAU * f64::from(k) / 480.0;
    Ok((0..=480)
        .map(|k| [phase(k), attractor.w(phase(k))])
        .collect())
}

fn drawn(law: &'static str, lambda: f64, from: f64, form: impl Fn(f64) -> Double) -> Evidence {
    Trial::motion(Printed, [law, "the drawn points of the simulated motion"]).over(
        parts(two_periods(lambda)),
        |point| {
            let [phi, found] = point?;
            Ok(Pair {
                at: format!("φ = {phi:.6}"),
                stated: form(from + (phi - from).rem_euclid(TAU)).to_f64(),
                found,
                scale: 2.0,
            })
        },
    )
}

/// Points (periods, −ln 𝔴_y) of a motion in the plane from 𝔴_y = 0.3 at φ = π/2, as long as 𝔴_y is not zero.
pub(crate) fn depths(lambda: f64) -> Result<Vec<[f64; 2]>, Failure> {
    let start = PlanarState {
        phi: FRAC_PI_2,
        w_x: 0.5,
        ln_w_y: Scalar::ln(0.3),
    };
    let phases: Vec<_> = (0..=20).map(|k| FRAC_PI_2 + TAU * f64::from(k)).collect();
    let states = drive()?.planar(lambda, start, &phases)?;
    let depth = |(k, state): (usize, PlanarState)| [k as f64, -state.ln_w_y];
    let points = states.into_iter().enumerate().map(depth);
    Ok(points.filter(|[_, depth]| depth.is_finite()).collect())
}

pub(crate) fn critical() -> f64 {
    printed::eq37_lambda_c()
}

/// Points (λ₀, share of a period at rest) of the large-time motion.
pub(crate) fn rest_shares() -> Result<Vec<[f64; 2]>, Failure> {
    // Closer to 1, where the curve is steep.
    let close = (8..20).map(|k| 1.0 - libm::exp2(-f64::from(k)));
    let mut lambdas: Vec<_> = (1..=240)
        .map(|k| f64::from(k) / 200.0)
        .chain(close)
        .collect();
    lambdas.sort_by(f64::total_cmp);
    let share = |lambda: f64| {
        let attractor = settled(lambda, ORIGIN)?;
        let rests = attractor
            .intervals()
            .iter()
            .filter(|i| i.sign == Sign::Rest);
        Ok([lambda, rests.map(|i| i.length()).sum::<f64>() / TAU])
    };
    lambdas.into_iter().map(share).collect()
}

/// Where a label of the printed frame stands, from the zero line to the upper edge: the frame reaches from 2 to 170, its
/// middle is the zero line, and a label's baseline stands 3.5 below the middle of its figures (paper's source, in points).
fn frame_top(label: f64, baseline: f64) -> f64 {
    label * (170.0 - 86.0) / (baseline + 3.5 - 86.0)
}

/// The printed frame, with its mark a mark on the axis and not the axis' end, holds the motion.
fn framed(lambda: f64, top: f64, within: &'static str) -> Evidence {
    Trial::census(Printed, Compared::constant("the expected 1", within)).over(
        parts(two_periods(lambda)),
        |point| {
            let [phi, w] = point?;
            Ok(Pair::plain(format!("φ = {phi:.6}"), 1.0, is(w.abs() < top)))
        },
    )
}

attempts![
    fig2_motion = Trial::motion(
        Printed,
        Compared::one(
            r"$\mathfrak w$ of the drawn motion",
            "$v_x$ of a particle on the plane",
        )
        .over("every eighth drawn one"),
    )
    .pairs(parts(transients()), |curve| {
        let curve = curve?;
        let until = TAU * f64::from(PERIODS);
        let motion = Particle::plain(curve.lambda).run(0.0, [W_X, curve.w_y], until)?;
        let pair = |state: &PlanarState| {
            Ok(Pair {
                at: curve.at(state.phi),
                stated: state.w_x,
                found: motion.at(state.phi)?.v[0],
                scale: 1.0 + W_X + curve.w_y,
            })
        };
        curve.states.iter().step_by(8).map(pair).collect()
    }),
    fig2_limit = {
        let trial = Trial::by(
            Limit,
            Printed,
            [
                r"$\mathfrak w$ by (38) or (33), as $\lambda_0$ says,",
                "$v_x$ of a particle on the plane 15 to 16 periods after it started like a drawn motion",
            ],
            FORGOTTEN,
        );
        let starts = [SMALL, LARGE].into_iter();
        let starts = starts.flat_map(|lambda| W_Y.into_iter().map(move |w_y| (lambda, w_y)));
        let late = |(lambda, w_y)| {
            let motion = Particle::plain(lambda).run(0.0, [W_X, w_y], TAU * f64::from(FOLLOWED));
            let motion = motion.map(std::rc::Rc::new);
            let phases = (0..4).map(|k| TAU * (f64::from(FOLLOWED) - 0.25 * f64::from(k)));
            phases.map(move |phi| (lambda, w_y, phi, motion.clone()))
        };
        trial.over(starts.flat_map(late), |(lambda, w_y, phi, motion)| {
            Ok(Pair::plain(
                format!("λ₀ = {lambda:.6}, 𝔴_y = {w_y} at φ = 0, φ = {phi:.6}"),
                printed_late(lambda, phi),
                motion?.at(phi)?.v[0],
            ))
        })
    },
    fig3_motion = drawn(
        r"(38) for $\lambda_0=1/\pi$",
        SMALL,
        printed::eq39_phi_t1(SMALL),
        |phi| eq38(SMALL, phi)
    ),
    fig3_frame = framed(
        SMALL,
        frame_top(0.8, 150.0),
        "whether a drawn point lies within the printed frame, whose mark 0.8 is not its edge (1 if so)",
    ),
    fig4_motion = drawn(
        r"(33) for $\lambda_0=1/\sqrt2$",
        LARGE,
        printed::eq27_phi1(LARGE),
        |phi| eq33(LARGE, phi_t2(LARGE), phi)
    ),
    fig4_frame = framed(
        LARGE,
        frame_top(0.3, 155.0),
        "whether a drawn point lies within the printed frame, whose mark 0.3 is not its edge (1 if so)",
    )
];

#[cfg(test)]
mod tests {
    use super::*;

    /// The zero line is at 86, the edge at 170: a label in the middle between them stands for half of the edge's value.
    #[test]
    fn the_edge_of_a_frame_is_read_off_a_label() {
        assert_eq!(frame_top(0.8, 166.5), 0.8);
        assert_eq!(frame_top(0.5, 124.5), 1.0);
    }
}
