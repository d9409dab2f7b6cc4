//! Trials of the statement that every start leads to rest or to an unbounded motion.

use super::prelude::*;
use crate::motion::turntable::boundary::boundary;
use crate::motion::turntable::ensemble::rests;

/// All over the inner part of the states, by ρ, p and ψ.
fn starts(count: usize) -> Vec<[f64; 3]> {
    Points::here().within(count, [[0.0, 3.0], [0.0, 3.0], [-3.1, 3.1]])
}

/// By bounds on the energy, which make a fate certain: many starts together.
pub(super) fn fates() -> Evidence {
    let trial = Trial::census(
        Within,
        Compared::constant(
            "the expected 0, for no third fate",
            "whether the fate is neither rest nor escape by the bounds on its energy (1 if so)",
        ),
    );
    let points = starts(5000);
    let begun = points
        .iter()
        .map(|[rho, p, psi]| Start::polar(*rho, *p, *psi));
    let ends = begun
        .collect::<Result<Vec<_>, _>>()
        .and_then(|all| rests(&all));
    trial.over(points.iter().zip(parts(ends)), |([rho, p, psi], end)| {
        Ok(Pair::plain(
            format!("ρ = {rho:.6}, p = {p:.6}, ψ = {psi:.6}"),
            printed::s4_third_fates(),
            is(end?.is_none()),
        ))
    })
}

pub(super) fn followed() -> Evidence {
    let trial = Trial::by(
        Integration,
        Within,
        Compared::constant(
            "the expected 0, for no third fate",
            r"1 less how many of two things hold of a particle at $\tau=100$, that it rests on the table and that $\rho^2-p^2>1$,",
        ),
        NONE,
    );
    trial.at(["ρ", "p", "ψ"], starts(200), 1.0, |[rho, p, psi]| {
        let start = State {
            t: 0.0,
            x: [rho * libm::cos(psi), rho * libm::sin(psi)],
            v: [p, 0.0],
        };
        let table = Table::default();
        let path = inertial::run(&table, &table.to_laboratory(&start), 100.0)?;
        Ok([printed::s4_third_fates(), third_fate(&path, 100.0)?])
    })
}

/// 1 less how many of the two fates a particle on the dimensionless table has met by then.
fn third_fate(path: &Path, tau: f64) -> Result<f64, MotionError> {
    let State { x, v, .. } = path.on_table(tau)?;
    let [rho, p] = [x, v].map(|[x, y]| libm::hypot(x, y));
    let fates = [path.resting_place().is_some(), rho * rho - p * p > 1.0];
    let [rests, escapes] = fates.map(is);
    Ok(1.0 - rests - escapes)
}

/// Whether a particle, by ρ and p before and after, still moves, far more slowly, and nearer to ρ = 1.
fn creeps([[far, fast], [near, slow]]: [[f64; 2]; 2]) -> bool {
    slow > 0.0 && slow < 0.1 * fast && (near - 1.0).abs() < (far - 1.0).abs()
}

attempts![
    fates,
    followed,
    on_the_boundary = {
        let trial = Trial::by(
            Root,
            Outside,
            Compared::constant(
                "the expected 0, for no third fate",
                r"whether a particle that starts on the boundary still moves at $\tau=8$, nearer to $\rho=1$ and more slowly than at $\tau=4$ (1 if so)",
            ),
            NONE,
        );
        let places = Points::here().grid((0..20).map(f64::from));
        trial.over(places, |i| {
            let (alpha, psi) = (0.05 + 0.02 * i, 0.1 * i - 1.0);
            let run = Run::new(&Start::hyperbolic(boundary(alpha, psi)?, alpha, psi)?, 8.0)?;
            let (before, after) = (run.at(4.0)?, run.at(8.0)?);
            let creeps = creeps([&before, &after].map(|s| [s.rho(), s.p()]));
            Ok(Pair::plain(
                format!("α = {alpha:.6}, ψ = {psi:.6} on the boundary"),
                printed::s4_third_fates(),
                is(creeps),
            ))
        })
    },
    beside_the_boundary = {
        let trial = Trial::census(
            Excepted,
            Compared::constant(
                "the expected 1",
                "whether a start a millionth below the boundary rests and one above it escapes (1 if so)",
            ),
        );
        let places = Points::here().grid((0..40).map(f64::from));
        trial.over(places, |i| {
            let (alpha, psi) = (0.05 + 0.02 * i, 0.1 * i - 2.0);
            let on = boundary(alpha, psi)?;
            let beside = |part: f64| -> Result<Fate, Failure> {
                Ok(fate(&Start::hyperbolic(on * (1.0 + part), alpha, psi)?)?)
            };
            let sides = [beside(-1e-6)?, beside(1e-6)?];
            let apart = matches!(sides, [Fate::Rest { .. }, Fate::Escape { .. }]);
            Ok(Pair::plain(
                format!("α = {alpha:.6}, ψ = {psi:.6}"),
                1.0,
                is(apart),
            ))
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_has_met_no_fate_yet_is_counted() {
        let table = Table::default();
        let after = |x: f64, tau: f64| {
            let start = State {
                t: 0.0,
                x: [x, 0.0],
                v: [0.0; 2],
            };
            third_fate(&inertial::run(&table, &start, tau).unwrap(), tau).unwrap()
        };
        assert_eq!(
            [after(0.5, 0.1), after(0.5, 100.0), after(3.0, 100.0)],
            [1.0, 0.0, 0.0]
        );
    }

    #[test]
    fn to_creep_is_to_come_nearer_ever_more_slowly() {
        let (before, outside) = ([0.9, 1e-2], [1.1, 1e-2]);
        for (states, expected) in [
            ([before, [0.99, 1e-4]], true),
            ([outside, [1.01, 1e-4]], true),
            ([before, [0.89, 1e-4]], false),
            ([before, [1.11, 1e-4]], false),
            ([before, [0.9, 1e-4]], false),
            ([before, [0.99, 1e-3]], false),
            ([before, [0.99, 0.0]], false),
        ] {
            assert_eq!(creeps(states), expected, "{states:?}");
        }
    }
}
