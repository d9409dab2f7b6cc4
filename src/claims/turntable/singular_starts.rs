//! Where the printed formulas divide by zero and the motion goes on: a particle put down at rest on the table,
//! and one launched from the axis.

use super::prelude::*;
use super::trajectories::{ALONG, ALPHA, BETA, MOMENT, PSI, any_table};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begin {
    /// At rest on the table, ρ < 1: friction holds it.
    Held,
    /// At rest on the table, ρ > 1: it starts at once.
    Released,
    /// From the axis.
    Launched,
}

/// Random apart from how it begins.
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

/// Between the states that are compared, in units of 1/Ω.
const H: f64 = 1e-3;

pub(super) fn first_rate(
    table: &Table,
    start: &State,
    quantity: impl Fn(&State) -> f64,
) -> Result<f64, Failure> {
    let h = H / table.omega;
    let path = rotating::run(table, start, 5.0 * h)?;
    Ok(rate_at_start(h, |t| Ok(quantity(&path.at(t)?)))?)
}

/// The rate at the beginning by five values, there and at times `h` apart.
pub(super) fn rate_at_start(
    h: f64,
    value: impl Fn(f64) -> Result<f64, MotionError>,
) -> Result<f64, MotionError> {
    let mut sum = 0.0;
    for (i, weight) in [-25.0, 48.0, -36.0, 16.0, -3.0].into_iter().enumerate() {
        sum += weight * value(h * i as f64)?;
    }
    Ok(sum / (12.0 * h))
}

fn first_moment(
    law: &'static str,
    begins: &[Begin],
    (name, quantity): Quantity,
    formula: fn(&View) -> f64,
) -> Evidence {
    Trial::by(
        Integration,
        Outside,
        Compared::composed([law, "", ""], ["the rate of ", name, ""]),
        DIFFERENCES,
    )
    .drawn(0..30, |i, points| {
        let begin = begins[i % begins.len()];
        let start = state(begin, points);
        let (rho, p) = (start.radius(), start.speed());
        let begun = match begin {
            Begin::Held => "held",
            Begin::Released => "released",
            Begin::Launched => "launched",
        };
        let found = first_rate(&Table::default(), &start, |s| quantity(&View::of(s)))?;
        Ok(Pair {
            at: format!("ρ = {rho:.6}, p = {p:.6} ({begun})"),
            stated: formula(&View::of(&start)),
            found,
            scale: 1f64.max(found.abs()),
        })
    })
}

const HELD: &[Begin] = &[Begin::Held];
const RELEASED: &[Begin] = &[Begin::Released];
const LAUNCHED: &[Begin] = &[Begin::Launched];
const AT_REST: &[Begin] = &[Begin::Held, Begin::Released];

pub(super) fn eq86() -> Evidence {
    Trial::by(
        Integration,
        Outside,
        [
            "(86) at rest",
            "the acceleration, as the sum of its components",
        ],
        DIFFERENCES,
    )
    .drawn(0..30, |i, points| {
        let table = any_table(points, 0.3);
        let unit = state(AT_REST[i % 2], points);
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

fn eq109(v: &View) -> f64 {
    printed::eq109_psi_rate(v.p, v.rho, v.psi)
}

const COMPONENTS: Quantity = ("the sum of the components of the velocity", |v| {
    v.rate[0] + v.rate[1]
});

attempts![
    eq86,
    eq89 = first_moment("(89) at rest, summed as well,", AT_REST, COMPONENTS, |v| {
        let [ax, ay] = printed::eq89_acceleration(v.position, v.rate);
        ax + ay
    }),
    eq91 = first_moment("(91) at rest", AT_REST, MOMENT, |v| {
        printed::eq91_moment(v.position, v.rate)
    }),
    eq92 = first_moment("(92) at rest", AT_REST, ALONG, |v| {
        printed::eq92_virial(v.position, v.rate)
    }),
    // Where friction holds the particle, ξ has no value; its largest possible one is taken.
    eq99 = first_moment(r"(99) at rest, with $\rho$ for $\xi$,", HELD, P, |v| {
        printed::eq99_p_rate(v.xi)
    }),
    eq100 = first_moment("(100) at a start from rest", RELEASED, ELL, |v| {
        printed::eq100_ell_rate(v.p, v.ell, v.xi)
    }),
    eq101 = first_moment("(101) at a start from rest", RELEASED, XI, |v| {
        printed::eq101_xi_rate(v.p, v.ell)
    }),
    // Nor has ψ; 0 is taken, which makes the rate largest.
    eq107 = first_moment(r"(107) at rest, with $\psi=0$,", HELD, P, |v| {
        printed::eq107_p_rate(v.rho, v.psi)
    }),
    // With the ψ of a particle that is about to arrive on the axis.
    eq108 = first_moment(r"(108) on the axis, with $\psi=\pi$,", LAUNCHED, RHO, |v| {
        printed::eq108_rho_rate(v.p, PI)
    }),
    eq109 = first_moment("(109) at a start from rest", RELEASED, PSI, eq109),
    eq109_on_the_axis = first_moment("(109) on the axis", LAUNCHED, PSI, eq109),
    eq114 = first_moment(r"(114) at rest, with $\psi=0$,", HELD, ALPHA, |v| {
        let (a, alpha) = v.inner();
        printed::eq114_alpha_rate(a, alpha, v.psi)
    }),
    eq115 = first_moment("(115) at a start from rest", RELEASED, PSI, |v| {
        printed::eq115_psi_rate(v.inner().1, v.psi)
    }),
    eq120 = first_moment(
        r"(120) on the axis, with $\psi=\pi$,",
        LAUNCHED,
        BETA,
        |v| {
            let (b, beta) = v.outer();
            printed::eq120_beta_rate(b, beta, PI)
        }
    ),
    eq121 = first_moment("(121) on the axis", LAUNCHED, PSI, |v| {
        printed::eq121_psi_rate(v.outer().1, v.psi)
    }),
    tangential = first_moment(
        "the projection of (89) on the velocity at rest",
        HELD,
        P,
        |v| printed::s4_tangential_rate([v.xi, -v.ell], [v.p, 0.0]),
    )
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
