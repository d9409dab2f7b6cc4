//! Trials of the surfaces of starts that come to rest at one distance σ, for every ψ.

use super::boundary::resting_place;
use super::prelude::*;

/// The A from which a start with these α and ψ comes to rest at σ, by the motion. A grows on the way, so it is below σ.
fn on_the_surface(sigma: f64, alpha: f64, psi: f64) -> Result<f64, Failure> {
    let excess = |a: f64| match resting_place(a, alpha, psi) {
        Ok(place) => place.unwrap_or(1.0) - sigma,
        Err(_) => f64::NAN,
    };
    let lowest = sigma * (1.0 - alpha * alpha / (1.0 - sigma));
    Ok(root(excess, lowest, sigma)?)
}

/// (σ − A)/α² on the surface as α → 0, from halvings of α; its next terms are of the orders α and α².
pub(crate) fn bend(sigma: f64, psi: f64) -> Result<f64, Failure> {
    let largest = 0.04 * (1.0 - sigma);
    let at = |halvings: i32| -> Result<f64, Failure> {
        let alpha = largest * libm::pow(0.5, f64::from(halvings));
        Ok((sigma - on_the_surface(sigma, alpha, psi)?) / (alpha * alpha))
    };
    let [first, second, third] = [at(0)?, at(1)?, at(2)?];
    let [coarse, fine] = [2.0 * second - first, 2.0 * third - second];
    Ok((4.0 * fine - coarse) / 3.0)
}

fn places() -> Vec<[f64; 2]> {
    Points::here().within(30, [[0.25, 0.85], [-2.6, 2.6]])
}

fn by_root(subject: Subject, law: &'static str, stated: fn(f64, f64, f64) -> f64) -> Evidence {
    const FROM: &str = r"the $A$ from which a start with these $\alpha$ and $\psi$ comes to rest at $\sigma$, in units of $1000\alpha^3$";
    let compared = Compared::one(law, FROM).over(r"$\alpha=(1-\sigma)/100$");
    Trial::by(Root, subject, compared, THIRD_ORDER).over(places(), |[sigma, psi]| {
        let alpha = 0.01 * (1.0 - sigma);
        Ok(Pair {
            at: format!("σ = {sigma:.6}, α = {alpha:.6}, ψ = {psi:.6}"),
            stated: stated(sigma, alpha, psi),
            found: on_the_surface(sigma, alpha, psi)?,
            scale: 1e3 * alpha * alpha * alpha,
        })
    })
}

pub(crate) fn bends() -> Evidence {
    Trial::by(
        Limit,
        Corrected,
        [
            r"the corrected coefficient of $-\alpha^2$",
            r"the limit of $(\sigma-A)/\alpha^2$ on the surface that the motion makes",
        ],
        SURFACE,
    )
    .over(places(), |[sigma, psi]| {
        Ok(Pair::plain(
            format!("σ = {sigma:.6}, ψ = {psi:.6}"),
            sigma * corrected::surface_bend(sigma, psi),
            bend(sigma, psi)?,
        ))
    })
}

attempts![
    psi_free | with_psi = by_root(
        (r"(145), whatever $\psi$ is,", |sigma, alpha, _| {
            printed::eq145_a(sigma, alpha)
        }) | (
            r"the corrected $A(\sigma,\alpha,\psi)$",
            corrected::surface_a
        )
    ),
    bends
];
