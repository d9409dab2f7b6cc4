//! Trials of the boundary between rest and escape: bisection, and a census of starts.

use super::prelude::*;

use crate::motion::turntable::fate::rests;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Border {
    pub alpha: f64,
    /// Radians.
    pub psi: f64,
    /// On the boundary, to 10⁻⁸.
    pub a: f64,
}

/// Bisects for the A at which the particle passes from rest to escape. Newton's law gives the bracket: it rests
/// where p + ρ = A exp(α) < 1, and escapes where ρ² − p² = A² ≥ 1.
pub(crate) fn border(alpha: f64, psi: f64) -> Result<Border, MotionError> {
    let least = (1.0 - 1e-9) * libm::exp(-alpha);
    let start = |a| Start::hyperbolic(a, alpha, psi);
    let a = between(start, least, 1.0 + 1e-9, 1e-8)?;
    Ok(Border { alpha, psi, a })
}

pub(crate) fn borders() -> impl Iterator<Item = Result<&'static Border, Failure>> {
    static BORDERS: Runs<Vec<Border>> = Runs::new(|| {
        let angles = (0..12).map(|k| PI * (f64::from(k) - 5.5) / 6.0);
        let angles = Points::here().grid(angles);
        let alphas = Points::here().grid([0.3, 0.1, 0.03, 0.01]);
        let points = angles
            .into_iter()
            .flat_map(|psi| alphas.iter().map(move |alpha| (*alpha, psi)));
        every(points.map(|(alpha, psi)| border(alpha, psi)))
    });
    BORDERS.each()
}

/// By (147).
pub(crate) fn printed_a(alpha: f64) -> f64 {
    printed::eq147_a(alpha)
}

/// By (147), in [0, 1].
pub(crate) fn printed_alpha(a: f64) -> f64 {
    std::f64::consts::SQRT_2 * (1.0 - libm::sqrt(a))
}

/// To second order in α.
pub(crate) fn corrected_a(alpha: f64, psi: f64) -> f64 {
    corrected::boundary_a(alpha, psi)
}

/// The unit in which the error of the second order is counted.
fn unit(alpha: f64) -> f64 {
    1e3 * alpha * alpha * alpha
}

/// What it speaks about, how close it is, and its A and the unit of a difference, by α and ψ.
type Law = (Subject, Tolerance, fn(f64, f64) -> [f64; 2]);

const AS_PRINTED: Law = (Printed, BOUNDARY, |alpha, _| [printed_a(alpha), 1.0]);
const AS_CORRECTED: Law = (Corrected, THIRD_ORDER, |alpha, psi| {
    [corrected_a(alpha, psi), unit(alpha)]
});

fn on_the_border(
    (subject, tolerance, law): Law,
    compared: Compared,
    borders: impl Iterator<Item = Result<Border, Failure>>,
) -> Evidence {
    let at = |Border { alpha, psi, .. }: &Border| format!("α = {alpha}, ψ = {psi:.6}");
    Trial::by(Root, subject, compared, tolerance).each(borders, at, |&Border { alpha, psi, a }| {
        let [stated, scale] = law(alpha, psi);
        Ok([stated, a, scale])
    })
}

const PASSES: &str = "the $A$ at which the motion passes from rest to escape";
const IN_UNITS: &str =
    r"the $A$ at which the motion passes from rest to escape, in units of $1000\alpha^3$";

const EQ147: Compared = Compared::one("(147)", PASSES);
const CORRECTED: Compared = Compared::one(
    r"the corrected boundary, to the order $\alpha^2$,",
    IN_UNITS,
);

/// The slow motion, ψ = 2α, which the derivation of (147) is about.
fn slow() -> impl Iterator<Item = Result<Border, Failure>> {
    let alphas = (0..20).map(|i| 0.02 + 0.01 * f64::from(i));
    let alphas = Points::here().grid(alphas).into_iter();
    alphas.map(|alpha| Ok(border(alpha, 2.0 * alpha)?))
}

fn least_root() -> Evidence {
    let trial = Trial::by(
        Root,
        Corrected,
        [
            r"$1-\alpha+\frac76\alpha^2$",
            r"the least $A$, over 21 $\psi$, at which the motion passes from rest to escape, in units of $1000\alpha^3$",
        ],
        THIRD_ORDER,
    );
    let alphas = (0..20).map(|i| 0.01 + 0.01 * f64::from(i));
    trial.over(Points::here().grid(alphas), |alpha| {
        let round = (0..12).map(|k| PI * (f64::from(k) - 5.5) / 6.0);
        let near = (-4..=4).map(|k| alpha * f64::from(k));
        let mut least = f64::INFINITY;
        for psi in round.chain(near) {
            // What rests at the least A so far passes to escape at a larger one.
            let above =
                least.is_finite() && rests(&Start::hyperbolic(least, alpha, psi)?)? == Some(true);
            if !above {
                least = least.min(border(alpha, psi)?.a);
            }
        }
        Ok(Pair {
            at: format!("α = {alpha}"),
            stated: corrected::boundary_least(alpha),
            found: least,
            scale: unit(alpha),
        })
    })
}

/// Points so close to A = 1, α = 0 that the second-order boundary is one to a part in 10⁸ or less.
fn close() -> impl Iterator<Item = Result<Border, Failure>> {
    let angles = (0..10).map(|k| PI * (f64::from(k) - 4.0) / 5.0);
    let angles = Points::here().grid(angles).into_iter();
    // A start may be counted several turns on.
    let angles = angles.chain([1.5, -2.5, 159.3].map(|turns| PI * turns));
    let points = angles.flat_map(|psi| [1e-3, 1e-4].map(|alpha| (alpha, psi)));
    points.map(|(alpha, psi)| {
        let start = |a| Start::hyperbolic(a, alpha, psi);
        // The states that fall in along a = −α, with what of α is left when ψ has relaxed.
        let middle = 1.0 - alpha * libm::pow(libm::cos(psi / 2.0), 2.0);
        let (far, near) = (10.0 * alpha * alpha, 0.02 * THIRD_ORDER.value * unit(alpha));
        let a = between(start, middle - far, middle + far, near)?;
        Ok(Border { alpha, psi, a })
    })
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    /// A, α and ψ.
    pub start: [f64; 3],
    pub rests: bool,
    /// Whether α < 0.3 and the same comes of starts with A up to 6α³ nearer to the other fate.
    pub clear: bool,
}

/// Whether a start comes to rest, and at which σ; [`MotionError::Steps`] when rounding decides.
pub(crate) fn resting_place(a: f64, alpha: f64, psi: f64) -> Result<Option<f64>, MotionError> {
    match fate(&Start::hyperbolic(a, alpha, psi)?)? {
        Fate::Rest { sigma, .. } => Ok(Some(sigma)),
        Fate::Escape { .. } => Ok(None),
        Fate::Undecided { .. } => Err(UNDECIDED),
    }
}

/// So near the boundary that rounding decides: no time is long enough.
const UNDECIDED: MotionError = MotionError::Steps {
    limit: crate::motion::turntable::fate::STEPS,
    t: f64::INFINITY,
};

/// How many starts the census in the ledger has near A = 1, α = 0, and away from it. The benchmark has a million.
const STARTS: [usize; 2] = [4020, 1000];

/// With all ψ, near A = 1, α = 0, then away from it.
pub(crate) static CENSUS: Runs<Vec<Case>> = Runs::new(|| {
    let mut points = Points::here();
    let [near, away] = STARTS;
    let case = |i| -> Result<_, Failure> {
        let (low, high, reach) = if i < near {
            (0.65, 1.02, 0.3)
        } else {
            (0.05, 1.2, 1.5)
        };
        let a = points.uniform(low, high);
        let (alpha, psi) = (points.uniform(0.0, reach), points.uniform(-PI, PI));
        fated(a, alpha, psi)
    };
    every((0..near + away).map(case))
});

fn fated(a: f64, alpha: f64, psi: f64) -> Result<Case, Failure> {
    let rests_from = |a: f64| -> Result<bool, MotionError> {
        rests(&Start::hyperbolic(a, alpha, psi)?)?.ok_or(UNDECIDED)
    };
    let rests = rests_from(a)?;
    // Particles with smaller A rest, those with larger A escape.
    let toward = if rests { 1.0 } else { -1.0 };
    let further = a + toward * THIRD_ORDER.value * unit(alpha);
    Ok(Case {
        start: [a, alpha, psi],
        rests,
        clear: alpha < 0.3 && rests_from(further)? == rests,
    })
}

fn counted(case: &Case, rests: bool) -> Pair {
    let [a, alpha, psi] = case.start;
    Pair::plain(
        format!("A = {a:.6}, α = {alpha:.6}, ψ = {psi:.6}"),
        is(rests),
        is(case.rests),
    )
}

/// By (147), from A, α and ψ.
fn rests_as_printed([a, alpha, _]: [f64; 3]) -> bool {
    a < printed_a(alpha)
}

/// A place on a surface of constant σ, on the slow motion near σ = 1, where (146) holds.
#[derive(Debug)]
pub(crate) struct Surface {
    pub sigma: f64,
    /// α = √2 (1 − σ).
    pub alpha: f64,
    /// ∂A/∂σ of the surface that the motion makes.
    pub slope: f64,
}

pub(crate) static SURFACES: Runs<Vec<Surface>> = Runs::new(|| {
    let sigmas = (0..20).map(|i| 0.99 + 4e-4 * f64::from(i));
    every(Points::here().grid(sigmas).into_iter().map(surface))
});

/// ψ = 2α + 2α², in which the boundary leads to A = 1, α = 0.
pub(crate) fn angle_towards_one(alpha: f64) -> f64 {
    2.0 * alpha + 2.0 * alpha * alpha
}

fn surface(sigma: f64) -> Result<Surface, Failure> {
    let alpha = std::f64::consts::SQRT_2 * (1.0 - sigma);
    let psi = angle_towards_one(alpha);
    let resting = |a: f64| match resting_place(a, alpha, psi) {
        Ok(Some(sigma)) => sigma,
        Ok(None) => 1.0,
        Err(_) => f64::NAN,
    };
    let a_at = |sigma: f64| root(|a| resting(a) - sigma, 1.0 - 4.0 * alpha, 1.0);
    let h = 0.05 * (1.0 - sigma);
    Ok(Surface {
        sigma,
        alpha,
        slope: (a_at(sigma + h)? - a_at(sigma - h)?) / (2.0 * h),
    })
}

fn slopes(subject: Subject, compared: Compared, stated: fn(f64, f64) -> f64) -> Evidence {
    let compared = compared.over(r"$\psi=2\alpha$");
    let trial = Trial::by(Root, subject, compared, CLOSING_SURFACES);
    let at = |s: &Surface| format!("σ = {:.6}, α = {:.6}", s.sigma, s.alpha);
    trial.each(SURFACES.each(), at, |s| {
        Ok([stated(s.sigma, s.alpha), s.slope, 1.0])
    })
}

attempts![
    real_surfaces = slopes(
        Printed,
        Compared::one(
            r"$\partial A/\partial\sigma$ by (146) at $\alpha=\sqrt2(1-\sigma)$",
            "that of the surfaces that the motion makes",
        ),
        printed::eq146_right
    ),
    // The real surfaces around the saddle: 1 − A = √((1−σ)² + α²), so that ∂A/∂σ = 1/√3 there.
    closing_surfaces = slopes(
        Corrected,
        Compared::one(
            r"$(1-\sigma)/\sqrt{(1-\sigma)^2+\alpha^2}$ at $\alpha=\sqrt2(1-\sigma)$",
            r"$\partial A/\partial\sigma$ of the surfaces that the motion makes",
        ),
        corrected::surface_slope
    ),
    printed_slow = on_the_border(AS_PRINTED, EQ147.over(r"$\psi=2\alpha$"), slow()),
    least_root,
    printed_census = {
        // (147) is an expansion, and beyond α = √2 its surfaces have no σ: it is judged where the corrected form is.
        let small = only(CENSUS.each(), |case| case.start[1] < 0.3);
        Trial::census(
            Printed,
            [
                "the fate by (147) (1 for rest, 0 for escape)",
                "that of the motion",
            ],
        )
        .over(small, |case| {
            let case = case?;
            Ok(counted(case, rests_as_printed(case.start)))
        })
    },
    printed_root = on_the_border(AS_PRINTED, EQ147, borders().map(|border| border.copied())),
    corrected_census = {
        let trial = Trial::census(
            Corrected,
            [
                r"the fate by the corrected boundary, to the order $\alpha^2$ (1 for rest, 0 for escape),",
                r"that of the motion, where it is the same with $A$ changed by $6\alpha^3$ either way",
            ],
        );
        trial.over(only(CENSUS.each(), |case| case.clear), |case| {
            let case = case?;
            let [a, alpha, psi] = case.start;
            Ok(counted(case, a < corrected_a(alpha, psi)))
        })
    },
    corrected_root = on_the_border(
        AS_CORRECTED,
        CORRECTED,
        borders().map(|border| border.copied())
    ),
    corrected_close = on_the_border(
        AS_CORRECTED,
        CORRECTED.over(r"$\alpha=10^{-3}$ and $10^{-4}$"),
        close()
    )
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_towards_one_has_two_terms() {
        assert_eq!([0.5, 2.0].map(angle_towards_one), [1.5, 12.0]);
    }

    #[test]
    fn what_starts_below_the_envelope_rests() {
        let on = printed_a(0.2);
        assert!((printed_alpha(on) - 0.2).abs() < 1e-15);
        assert_eq!(
            [on - 0.1, on, on + 0.1].map(|a| rests_as_printed([a, 0.2, 1.0])),
            [true, false, false]
        );
    }
}
