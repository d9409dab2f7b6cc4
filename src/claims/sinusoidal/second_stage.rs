//! Trials of what replaces the second stage: an exponential of an exponential, or an end after a finite time.

use super::prelude::*;
use super::reference_motions::{at, forward};
use super::transverse::{Flight, flights_where, strobed};

/// Where the passages are not too steep to be followed.
fn below(high: f64) -> impl Iterator<Item = f64> {
    let mut points = Points::here();
    (0..20).map(move |_| points.uniform(0.05, high))
}

/// Half way along the forward slip: phase and velocity.
fn on_the_way(attractor: &Attractor) -> Result<[f64; 2], Failure> {
    let slip = forward(attractor.intervals()).ok_or("no slip")?;
    let phi = 0.5 * (slip.start + slip.end);
    Ok([phi, attractor.w(phi)])
}

/// By what ln 𝔴_y grows in a passage through zero, and in a period, which has two.
const PASSAGE_FACTOR: &str = r"$(d+\lambda_0)/(d-\lambda_0)$, with $d=\sin\tilde\phi_1$,";
const PERIOD: &str = r"$[(d+\lambda_0)/(d-\lambda_0)]^2$, with $d=\sin\tilde\phi_1$,";

fn passage_factor(lambda: f64) -> f64 {
    corrected::passage_factor(lambda, corrected::drive_at_zero(lambda))
}

fn period_factor() -> Evidence {
    let trial = Trial::by(
        Integration,
        Corrected,
        [
            PERIOD,
            r"the factor by which $\ln\mathfrak w_y$ grows in a period, from $\ln\mathfrak w_y=-10^9$ on",
        ],
        LOGARITHM,
    );
    let next_to_none = [2e-4, 5e-4, 9e-4];
    let frictions = below(lambda_c() - 1e-3).chain(next_to_none);
    trial.over(frictions, |lambda| {
        let [phi, w_x] = on_the_way(&settled(lambda, ORIGIN)?)?;
        let start = PlanarState {
            phi,
            w_x,
            ln_w_y: -1e9,
        };
        let states = drive()?.planar(lambda, start, &[phi + TAU])?;
        let found = states[0].ln_w_y / start.ln_w_y;
        Ok(Pair {
            at: at(lambda),
            stated: 1.0 / corrected::contraction(lambda),
            found,
            scale: found,
        })
    })
}

fn passage_quadrature() -> Evidence {
    let trial = Trial::by(
        Quadrature,
        Corrected,
        [
            PASSAGE_FACTOR,
            r"$(1+q)/(1-p)$, where $p$ and $q$ are the coefficients of the logarithm in $\lambda_0\int\mathrm d\phi/\lvert\mathfrak w\rvert$ before and after a zero of $\mathfrak w$",
        ],
        PASSAGE,
    );
    trial.over(below(lambda_c() - 1e-2), |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let zero = forward(attractor.intervals()).ok_or("no slip")?.end;
        // In ln(distance) the integrand is smooth; the coefficient is its mean over a decade.
        let coefficient = |side: f64| -> Result<_, Failure> {
            let integrand = |x: f64| {
                let distance = Scalar::exp(x);
                lambda * distance / attractor.w(zero + side * distance).abs()
            };
            let (low, high) = (Scalar::ln(1e-7), Scalar::ln(1e-6));
            // So near the zero, 𝔴 has eight digits.
            let sum = integral_within(integrand, low, high, 1e-8)?.value;
            Ok(sum / (high - low))
        };
        let (p, q) = (coefficient(-1.0)?, coefficient(1.0)?);
        let found = (1.0 + q) / (1.0 - p);
        Ok(Pair {
            at: at(lambda),
            stated: passage_factor(lambda),
            found,
            scale: found / (1.0 - p),
        })
    })
}

/// Whether of a motion, by ln 𝔴_y and 𝔴_x, that along the line is left and nothing else.
fn ended([ln_w_y, w_x]: [f64; 2], line: f64) -> bool {
    ln_w_y == f64::NEG_INFINITY && (w_x - line).abs() < 1e-12
}

/// λ₀ > λ_c, by the other integrator.
pub(super) fn last_stage() -> Evidence {
    let trial = Trial::by(
        Limit,
        Corrected,
        [
            r"$\lambda_0/(\lambda_0^2-d^2)$, with $d=\lvert h\rvert$,",
            r"the time, over $v_y$, that a particle with $v_x=0$ and a small $v_y$ takes to stop where $d<\lambda_0$",
        ],
        LAST_STAGE,
    );
    trial.drawn(0..20, |_, points| {
        let lambda = points.uniform(lambda_c(), 1.4);
        let phi = points.uniform(0.0, 0.9) * Scalar::asin(lambda.min(1.0));
        let h = Scalar::sin(phi);
        let v_y = 1e-7;
        let motion = Particle::plain(lambda).run(phi, [0.0, v_y], phi + 1.0)?;
        let stop = motion.first_stop().ok_or("no stop")?;
        let found = (stop - phi) / v_y;
        Ok(Pair {
            at: format!("λ₀ = {lambda:.6}, φ = {phi:.6}, v_y = 1e-7"),
            stated: corrected::last_stage(lambda, h, v_y) / v_y,
            found,
            scale: found,
        })
    })
}

attempts![
    // The correction of the first stage: friction leans towards the drive by half the square of the ratio of the velocities.
    first_stage_correction = {
        let trial = Trial::by(
            Limit,
            Corrected,
            [
                r"$-\frac12[(\mathfrak w+1)^2+\frac12]$, with $\mathfrak w$ at $\phi=0$,",
                r"$\mathfrak w_y^2$ times the relative excess of the mean slope of $\mathfrak w_y$ over a period above $-\lambda_0$",
            ],
            SECOND_ORDER,
        );
        trial.drawn(0..30, |_, points| {
            let lambda = points.uniform(0.2, 1.4);
            let w_x = points.uniform(-3.0, 3.0);
            let w_y = points.log_uniform(500.0, 2000.0);
            let states = strobed(lambda, w_x, w_y, 1)?;
            let [first, last] = [0, 1].map(|k: usize| Scalar::exp(states[k].ln_w_y));
            let slope = (last - first) / TAU;
            let middle = 0.5 * (first + last);
            let found = (slope / -lambda - 1.0) * middle * middle;
            Ok(Pair {
                at: format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6}, 𝔴_y = {w_y:.6}"),
                stated: corrected::first_stage_lean(w_x),
                found,
                scale: found.abs().max(2.0),
            })
        })
    },
    period_factor,
    period_factor_reached = {
        let trial = Trial::by(
            Limit,
            Corrected,
            [
                PERIOD,
                r"the last growth of $\ln\mathfrak w_y$ over a period on the way from $\mathfrak w_y$ of order one to $\exp(-10^{15})$",
            ],
            PASSAGE,
        );
        trial.each(flights_where(Flight::never_rests), Flight::at, |flight| {
            let strobe: Vec<_> = flight.strobe().collect();
            let last = strobe
                .iter()
                .rposition(|s| s.ln_w_y > -1e15)
                .ok_or("no state")?;
            let factor = match last.checked_sub(1) {
                Some(before) => strobe[last].ln_w_y / strobe[before].ln_w_y,
                None => f64::NAN,
            };
            Ok([1.0 / corrected::contraction(flight.lambda), factor, factor])
        })
    },
    passage_limit = {
        let trial = Trial::by(
            Limit,
            Corrected,
            [
                PASSAGE_FACTOR,
                r"the ratio of $\Delta\ln v_y$ after and before a passage of a particle with $v_y=10^{-6}$ and $10^{-8}$",
            ],
            PASSAGE,
        );
        trial.over(below(0.42), |lambda| {
            let [phi, w_x] = on_the_way(&settled(lambda, ORIGIN)?)?;
            let through = |v_y: f64| -> Result<_, Failure> {
                let motion = Particle::plain(lambda).run(phi, [w_x, v_y], phi + PI)?;
                Ok(Scalar::ln(motion.end().v[1]))
            };
            let after = through(1e-6)? - through(1e-8)?;
            let found = after / Scalar::ln(100.0);
            Ok(Pair {
                at: at(lambda),
                stated: passage_factor(lambda),
                found,
                scale: found,
            })
        })
    },
    passage_quadrature,
    finite_end = {
        let trial = Trial::by(
            Integration,
            Corrected,
            Compared::constant(
                "the expected 1",
                r"whether $\mathfrak w_y$ is exactly 0 after ten periods, and $\mathfrak w$ then that of the motion on the line (1 if so)",
            ),
            NONE,
        );
        trial.each(
            flights_where(|flight| flight.lambda > lambda_c()),
            Flight::at,
            |flight| {
                let last = flight.last()?;
                let line = settled(flight.lambda, ORIGIN)?.w(last.phi);
                Ok([1.0, is(ended([last.ln_w_y, last.w_x], line)), 1.0])
            },
        )
    },
    last_stage
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_has_ended_on_the_line_when_nothing_is_left_across() {
        let gone = f64::NEG_INFINITY;
        let motions = [[gone, 0.3], [gone, 0.3 + 2e-12], [-700.0, 0.3]];
        assert_eq!(motions.map(|of| ended(of, 0.3)), [true, false, false]);
    }

    #[test]
    fn a_motion_is_taken_up_in_the_middle_of_its_slip() {
        let attractor = settled(0.3, ORIGIN).unwrap();
        let [phi, w] = on_the_way(&attractor).unwrap();
        assert!(w > 0.1, "{w}");
        // The drive sin φ pushes back and forth alike: a slip lasts half a period.
        for side in [-1.0, 1.0] {
            let w = |share: f64| attractor.w(phi + side * share * PI / 2.0);
            assert!(w(0.999) > 0.0 && w(1.001) < 0.0);
        }
    }
}
