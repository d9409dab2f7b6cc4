//! Trials of where the rest of the period ends that begins at φ₁: what follows the slip up to φ̃₂.

use super::prelude::*;
use super::reference_motions::small;

/// What is said of the end, at a phase inside the slip that begins at φ₁ for this λ₀.
type Stated = (&'static str, fn(f64, f64) -> f64);

fn at_each(
    route: Route,
    subject: Subject,
    compared: Compared,
    pair: impl Fn(f64, f64) -> Result<[f64; 2], Failure>,
) -> Evidence {
    let points = small().into_iter().map(|lambda| {
        let slip = Slip::of(lambda);
        [lambda, slip.map_or(f64::NAN, |s| 0.5 * (s.start + s.end))]
    });
    Trial::by(route, subject, compared, ROOT).at(["λ₀", "φ"], points, TAU, |[lambda, phi]| {
        pair(lambda, phi)
    })
}

/// As printed: φ itself, whichever of the slip it is.
const PRINTED: Stated = (
    r"$\phi+2\pi$, with $\phi$ in the middle of the slip,",
    |_, phi| printed::s22_rest_of_period_end(phi),
);

const CORRECTED: Stated = (r"$\phi_1+2\pi$", |lambda, _| {
    corrected::rest_of_period_end(printed::eq27_phi1(lambda))
});

fn next_start(subject: Subject, (end, stated): Stated) -> Evidence {
    const NEXT: &str = r"the phase after $\phi_1$ at which the drive next exceeds friction forward";
    let compared = Compared::one(end, NEXT);
    at_each(Root, subject, compared, |lambda, phi| {
        let found = root(|phi| libm::sin(phi) - lambda, 1.5 * PI, 2.5 * PI)?;
        Ok([stated(lambda, phi), found])
    })
}

fn nothing_given(subject: Subject, (end, stated): Stated) -> Evidence {
    let compared = Compared::composed(
        [r"what the drive gives from $\phi_1$ to ", end, ""],
        ["the 0 of a whole period", "", ""],
    );
    at_each(Quadrature, subject, compared, |lambda, phi| {
        let start = Slip::of(lambda)?.start;
        Ok([sum(libm::sin, start, stated(lambda, phi), 1e-13), 0.0])
    })
}

attempts![
    printed_root | corrected_root = next_start((PRINTED) | (CORRECTED)),
    printed_quadrature | corrected_quadrature = nothing_given((PRINTED) | (CORRECTED))
];
