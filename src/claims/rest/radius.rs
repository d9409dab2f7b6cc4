//! Trials of where rest is possible, (139) and its words.

use super::boundary::CENSUS;
use super::prelude::*;
use crate::motion::turntable::rotating;

/// On a table of any Ω, μ, g.
struct Rider {
    table: Table,
    /// Its distance from the axis, over μg/Ω².
    sigma: f64,
    /// How far from there it is two radians later, seen from the laboratory.
    moved: f64,
}

static RIDERS: Runs<Vec<Rider>> = Runs::new(|| {
    let mut points = Points::here();
    every((0..20).map(|i| rider(&mut points, i)))
});

fn rider(points: &mut Points, i: usize) -> Result<Rider, MotionError> {
    let table = Table {
        omega: points.sign() * points.uniform(0.3, 3.0),
        mu: points.uniform(0.1, 1.0),
        g: points.uniform(1.0, 20.0),
        mass: 1.0,
    };
    let sigma = match i % 3 {
        0 => points.uniform(0.0, 1.0),
        1 => points.uniform(1.0, 3.0),
        _ => 1.0 + points.sign() * points.log_uniform(1e-6, 1e-2),
    };
    let rides = State {
        t: 0.0,
        x: [sigma * table.length(), 0.0],
        v: [0.0; 2],
    };
    let until = 2.0 / table.omega.abs();
    let path = inertial::run(&table, &table.to_laboratory(&rides), until)?;
    let moved = (path.on_table(until)?.radius() / table.length() - sigma).abs();
    Ok(Rider {
        table,
        sigma,
        moved,
    })
}

/// Whether a particle that ends this far from its circle, in units of the table's length, has stayed. The slowest rider off its
/// circle, a millionth beyond σ = 1, moves by more.
fn is_at_its_place(moved: f64) -> bool {
    moved < 1e-9
}

/// Within the first moments, however slow they are.
const SOON: f64 = 0.1;

fn eq139_at_the_edge() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        [
            "whether a particle stays, by (139) (1 if so),",
            r"whether one stays that is put at rest on the table within $10^{-9}$ of $\sigma=1$: in the frame of the table, in the laboratory, and by its fate",
        ],
        NONE,
    );
    trial.drawn(0..40, |i, points| {
        let table = Table::default();
        let off = points.sign() * points.log_uniform(1e-11, 9e-10);
        let direction = points.uniform(-3.1, 3.1);
        let sigma = 1.0 + off;
        let start = State {
            t: 0.0,
            x: [sigma * libm::cos(direction), sigma * libm::sin(direction)],
            v: [0.0; 2],
        };
        let stays = match i % 3 {
            0 => is_still(&rotating::run(&table, &start, SOON)?, off)?,
            1 => {
                let still = table.to_laboratory(&start);
                is_still(&inertial::run(&table, &still, SOON)?, off)?
            }
            _ => matches!(fate(&Start::polar(sigma, 0.0, 0.0)?)?, Fate::Rest { .. }),
        };
        Ok(Pair::plain(
            format!("σ − 1 = {off:.6e}"),
            is(sigma <= printed::eq139_largest_sigma()),
            is(stays),
        ))
    })
}

/// Whether a particle from rest at 1 + `off` has not started: else it would be a tenth of `off` fast.
fn is_still(path: &Path, off: f64) -> Result<bool, MotionError> {
    Ok(path.on_table(SOON)?.speed() < 1e-2 * off.abs())
}

/// One of so many resting starts of the census is followed to its place.
const EVERY: usize = 16;

/// Long after the last of them has come to rest.
const LONG: f64 = 1e3;

/// σ, if (139) allows it, else the largest that it allows.
fn allowed(sigma: f64) -> f64 {
    sigma.min(printed::eq139_largest_sigma())
}

attempts![
    eq139_nudge = {
        let angles = (0..20).map(|i| 2.8 * (f64::from(i) - 9.5) / 9.5);
        Trial::by(
            Root,
            Printed,
            [
                "(139)",
                r"the $\rho$ up to which a particle nudged by $p=10^{-4}$ comes to rest",
            ],
            NEAR_CORNER,
        )
        .over(Points::here().grid(angles), |psi| {
            let found = between(|rho| Start::polar(rho, 1e-4, psi), 0.9, 1.1, 1e-6)?;
            Ok(Pair::plain(
                format!("p = 0.0001, ψ = {psi:.6}"),
                printed::eq139_largest_sigma(),
                found,
            ))
        })
    },
    eq139_stays = Trial::by(
        Integration,
        Printed,
        [
            "whether a particle stays, by (139) (1 if so),",
            "whether one stays that rides with the table, seen from the laboratory",
        ],
        NONE,
    )
    .over(RIDERS.each(), |rider| {
        let Rider {
            table,
            sigma,
            moved,
        } = rider?;
        Ok(Pair::plain(
            format!(
                "σ = {sigma:.6}, Ω = {:.6}, μ = {:.6}, g = {:.6}",
                table.omega, table.mu, table.g
            ),
            is(*sigma <= printed::eq139_largest_sigma()),
            is(is_at_its_place(*moved)),
        ))
    }),
    eq139_at_the_edge,
    resting_places = {
        let resting = only(CENSUS.each(), |case| case.rests);
        Trial::census(
            Printed,
            [
                r"$\sigma$, but at most that of (139),",
                r"$\sigma$ of random starts that come to rest",
            ],
        )
        .over(resting.step_by(EVERY), |case| {
            let [a, alpha, psi] = case?.start;
            // The place itself: the fate's bounds make use of σ ≤ 1.
            let sigma = Run::new(&Start::hyperbolic(a, alpha, psi)?, LONG)?
                .end()
                .rho();
            Ok(Pair::plain(
                format!("A = {a:.6}, α = {alpha:.6}, ψ = {psi:.6}, σ = {sigma:.6}"),
                allowed(sigma),
                sigma,
            ))
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sigma_beyond_the_largest_is_allowed() {
        let places = [0.5, 1.0, 1.0_f64.next_up(), 1.1];
        assert_eq!(places.map(allowed), [0.5, 1.0, 1.0, 1.0]);
    }

    /// Those that stay do so to rounding; the slowest that do not are a hundred times beyond what counts as staying.
    #[test]
    fn riders_stay_or_move_and_nothing_lies_between() {
        let mut movers = 0;
        for rider in RIDERS.each() {
            let Rider { sigma, moved, .. } = *rider.unwrap();
            if sigma <= 1.0 {
                assert!(moved < 1e-12, "{sigma}: {moved}");
            } else {
                assert!(moved > 1e-7, "{sigma}: {moved}");
                movers += 1;
            }
        }
        assert!(movers > 5);
        assert_eq!(
            [1e-12, 2e-9, 1e-7].map(is_at_its_place),
            [true, false, false]
        );
    }
}
