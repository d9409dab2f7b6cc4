//! Where the printed formulas divide by zero and the motion goes on: a particle put down at rest on the table,
//! and one launched from the axis.

use super::trajectories::View;
use crate::claims::tolerances::DIFFERENCES;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::turntable::{State, Table, rotating};
use crate::paper::turntable as printed;
use std::f64::consts::PI;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Failure, Pair, Trial};
use trialbook::claims::points::Points;

/// How a motion begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begin {
    /// At rest on the table, ρ < 1: friction holds it.
    Held,
    /// At rest on the table, ρ > 1: it starts at once.
    Released,
    /// From the axis.
    Launched,
}

/// A state, random apart from how it begins.
fn state(begin: Begin, points: &mut Points) -> State {
    let direction = points.uniform(-3.1, 3.1);
    let along = |size: f64| [size * libm::cos(direction), size * libm::sin(direction)];
    let (x, v) = match begin {
        Begin::Held => (along(points.uniform(0.2, 0.9)), [0.0; 2]),
        Begin::Released => (along(points.uniform(1.2, 3.0)), [0.0; 2]),
        Begin::Launched => ([0.0; 2], along(points.uniform(0.3, 2.0))),
    };
    State { t: 0.0, x, v }
}

/// The time between the states that are compared, in units of 1/Ω.
const H: f64 = 1e-3;

/// The rate of a quantity at the beginning, by its first five values.
pub fn first_rate(
    table: &Table,
    start: &State,
    quantity: impl Fn(&State) -> f64,
) -> Result<f64, Failure> {
    let h = H / table.omega;
    let path = rotating::run(table, start, 5.0 * h)?;
    let mut sum = 0.0;
    for (i, weight) in [-25.0, 48.0, -36.0, 16.0, -3.0].into_iter().enumerate() {
        sum += weight * quantity(&path.at(h * i as f64)?);
    }
    Ok(sum / (12.0 * h))
}

/// What a formula gives at the beginning, against the rate of a quantity.
fn first_moment(
    compared: Compared,
    stream: u64,
    begins: &[Begin],
    quantity: fn(&View) -> f64,
    formula: fn(&View) -> f64,
) -> Evidence {
    let trial = Trial::by(Route::Integration, Subject::Outside, compared, DIFFERENCES);
    let mut points = Points::stream(stream);
    trial.over(0..30, |i| {
        let begin = begins[i % begins.len()];
        let start = state(begin, &mut points);
        let (rho, p) = (start.radius(), start.speed());
        let name = match begin {
            Begin::Held => "held",
            Begin::Released => "released",
            Begin::Launched => "launched",
        };
        let found = first_rate(&Table::default(), &start, |s| quantity(&View::of(s)))?;
        Ok(Pair {
            at: format!("ρ = {rho:.6}, p = {p:.6} ({name})"),
            stated: formula(&View::of(&start)),
            found,
            scale: 1f64.max(found.abs()),
        })
    })
}

const AT_REST: &[Begin] = &[Begin::Held, Begin::Released];

/// (86) at rest, on tables of any Ω, μ, g.
pub fn eq86() -> Evidence {
    let compared = Compared::one(
        "(86) at rest",
        "the acceleration, as the sum of its components",
    );
    let trial = Trial::by(Route::Integration, Subject::Outside, compared, DIFFERENCES);
    let mut points = Points::stream(510);
    trial.over(0..30, |i| {
        let table = Table {
            omega: points.log_uniform(0.3, 3.0),
            mu: points.uniform(0.1, 1.4),
            g: points.uniform(1.5, 20.0),
            mass: 1.0,
        };
        let unit = state(AT_REST[i % 2], &mut points);
        let start = State {
            x: unit.x.map(|x| x * table.length()),
            ..unit
        };
        let [ax, ay] = printed::eq86_acceleration(table.omega, table.mu, table.g, start.x, start.v);
        Ok(Pair {
            at: format!(
                "Ω = {:.6}, μ = {:.6}, g = {:.6}, r = {:.6}, v = 0",
                table.omega,
                table.mu,
                table.g,
                start.radius()
            ),
            stated: ax + ay,
            found: first_rate(&table, &start, |s| s.v[0] + s.v[1])?,
            scale: table.friction(),
        })
    })
}

/// (89) at rest.
pub fn eq89() -> Evidence {
    let compared = Compared::one(
        "(89) at rest",
        "the acceleration, as the sum of its components",
    );
    first_moment(
        compared,
        511,
        AT_REST,
        |v| v.rate[0] + v.rate[1],
        |v| {
            let [ax, ay] = printed::eq89_acceleration(v.position, v.rate);
            ax + ay
        },
    )
}

/// (91) at rest.
pub fn eq91() -> Evidence {
    let compared = Compared::one(
        "(91) at rest",
        r"the rate of $\hat{\bm z}\cdot(\bm\rho\times\mathrm d\bm\rho/\mathrm d\tau)$",
    );
    first_moment(compared, 512, AT_REST, View::moment, |v| {
        printed::eq91_moment(v.position, v.rate)
    })
}

/// (92) at rest.
pub fn eq92() -> Evidence {
    let compared = Compared::one(
        "(92) at rest",
        r"the rate of $\bm\rho\cdot\mathrm d\bm\rho/\mathrm d\tau$",
    );
    first_moment(compared, 513, AT_REST, View::along, |v| {
        printed::eq92_virial(v.position, v.rate)
    })
}

/// (99) for a particle that friction holds. ξ has no value; its largest possible one is taken.
pub fn eq99() -> Evidence {
    let compared = Compared::one(
        r"(99) at rest, with $\rho$ for $\xi$,",
        r"$\mathrm dp/\mathrm d\tau$",
    );
    first_moment(
        compared,
        514,
        &[Begin::Held],
        |v| v.p,
        |v| printed::eq99_p_rate(v.xi),
    )
}

/// The projection on the velocity at rest.
pub fn tangential() -> Evidence {
    let compared = Compared::one(
        "the projection of (89) on the velocity at rest",
        r"$\mathrm dp/\mathrm d\tau$",
    );
    first_moment(
        compared,
        514,
        &[Begin::Held],
        |v| v.p,
        |v| printed::s4_tangential_rate([v.xi, -v.ell], [v.p, 0.0]),
    )
}

/// (100) at the moment of a start.
pub fn eq100() -> Evidence {
    let compared = Compared::one(
        "(100) at a start from rest",
        r"$\mathrm d\ell/\mathrm d\tau$",
    );
    first_moment(
        compared,
        515,
        &[Begin::Released],
        |v| v.ell,
        |v| printed::eq100_ell_rate(v.p, v.ell, v.xi),
    )
}

/// (101) at the moment of a start.
pub fn eq101() -> Evidence {
    let compared = Compared::one(
        "(101) at a start from rest",
        r"$\mathrm d\xi/\mathrm d\tau$",
    );
    first_moment(
        compared,
        516,
        &[Begin::Released],
        |v| v.xi,
        |v| printed::eq101_xi_rate(v.p, v.ell),
    )
}

/// (107) for a particle that friction holds. ψ has no value; 0 is taken, which makes it largest.
pub fn eq107() -> Evidence {
    let compared = Compared::one(
        r"(107) at rest, with $\psi=0$,",
        r"$\mathrm dp/\mathrm d\tau$",
    );
    first_moment(
        compared,
        517,
        &[Begin::Held],
        |v| v.p,
        |v| printed::eq107_p_rate(v.rho, v.psi),
    )
}

/// (108) on the axis, with the ψ = π of a particle that is about to arrive there.
pub fn eq108() -> Evidence {
    let compared = Compared::one(
        r"(108) on the axis, with $\psi=\pi$,",
        r"$\mathrm d\rho/\mathrm d\tau$",
    );
    first_moment(
        compared,
        523,
        &[Begin::Launched],
        |v| v.rho,
        |v| printed::eq108_rho_rate(v.p, PI),
    )
}

/// (120) on the axis, with the same ψ.
pub fn eq120() -> Evidence {
    let compared = Compared::one(
        r"(120) on the axis, with $\psi=\pi$,",
        r"$\mathrm d\beta/\mathrm d\tau$",
    );
    first_moment(
        compared,
        524,
        &[Begin::Launched],
        |v| v.outer().1,
        |v| {
            let (b, beta) = v.outer();
            printed::eq120_beta_rate(b, beta, PI)
        },
    )
}

/// (109) at the moment of a start.
pub fn eq109() -> Evidence {
    eq109_from(
        Compared::one(
            "(109) at a start from rest",
            r"$\mathrm d\psi/\mathrm d\tau$",
        ),
        518,
        &[Begin::Released],
    )
}

/// (109) on the axis.
fn eq109_on_the_axis() -> Evidence {
    eq109_from(
        Compared::one("(109) on the axis", r"$\mathrm d\psi/\mathrm d\tau$"),
        522,
        &[Begin::Launched],
    )
}

fn eq109_from(compared: Compared, stream: u64, begins: &'static [Begin]) -> Evidence {
    first_moment(
        compared,
        stream,
        begins,
        |v| v.psi,
        |v| printed::eq109_psi_rate(v.p, v.rho, v.psi),
    )
}

/// (114) for a particle that friction holds, with ψ = 0.
pub fn eq114() -> Evidence {
    let compared = Compared::one(
        r"(114) at rest, with $\psi=0$,",
        r"$\mathrm d\alpha/\mathrm d\tau$",
    );
    first_moment(
        compared,
        519,
        &[Begin::Held],
        |v| v.inner().1,
        |v| {
            let (a, alpha) = v.inner();
            printed::eq114_alpha_rate(a, alpha, v.psi)
        },
    )
}

/// (115) at the moment of a start.
pub fn eq115() -> Evidence {
    let compared = Compared::one(
        "(115) at a start from rest",
        r"$\mathrm d\psi/\mathrm d\tau$",
    );
    first_moment(
        compared,
        520,
        &[Begin::Released],
        |v| v.psi,
        |v| printed::eq115_psi_rate(v.inner().1, v.psi),
    )
}

/// (121) on the axis.
pub fn eq121() -> Evidence {
    let compared = Compared::one("(121) on the axis", r"$\mathrm d\psi/\mathrm d\tau$");
    first_moment(
        compared,
        521,
        &[Begin::Launched],
        |v| v.psi,
        |v| printed::eq121_psi_rate(v.outer().1, v.psi),
    )
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq86,
    eq89,
    eq91,
    eq92,
    eq99,
    eq100,
    eq101,
    eq107,
    eq108,
    eq109,
    eq109_on_the_axis,
    eq114,
    eq115,
    eq120,
    eq121,
    tangential
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Released at rest beyond ρ = 1: the centrifugal acceleration less friction, on a table that turns fast.
    #[test]
    fn the_first_rate_is_taken_within_a_small_part_of_a_turn() {
        let table = Table {
            omega: 1e3,
            mu: 0.5,
            g: 10.0,
            mass: 1.0,
        };
        let start = State {
            t: 0.0,
            x: [2.0 * table.length(), 0.0],
            v: [0.0; 2],
        };
        let rate = first_rate(&table, &start, |s| s.v[0]).unwrap();
        assert!((rate - 5.0).abs() < 1e-8, "{rate}");
    }
}
