//! The ends of motions on the turntable: where friction does not hold a particle at rest, it starts; where it does, a
//! particle that stops stays.

use super::frames::{eq89_rate, weighed};
use super::prelude::*;
use crate::motion::turntable::ensemble::{End, Horizon};
use crate::motion::turntable::intrinsic::Exact;
use crate::motion::turntable::moment::moment;
use crate::motion::turntable::{Fate, fate};

/// From rest on the table beyond ρ = 1.
#[derive(Debug)]
struct Loose {
    rho: f64,
    to: f64,
    /// By the frame of the table.
    turning: Path,
    /// By the laboratory.
    still: Path,
}

impl Loose {
    fn at(&self) -> String {
        format!(
            "ρ = {:.6}, p = 0 at the start, τ = {:.6}",
            self.rho, self.to
        )
    }

    fn view(&self, tau: f64) -> Result<View, Failure> {
        Ok(View::of(&self.turning.at(tau)?))
    }

    /// ∫ rate dτ by the frame of the table.
    fn sum(&self, rate: impl Fn(&View) -> f64) -> f64 {
        let at = |tau: f64| self.view(tau).map_or(f64::NAN, |view| rate(&view));
        sum(at, 0.0, self.to, 1e-13)
    }
}

/// In all directions.
static LOOSE: Runs<Vec<Loose>> = Runs::new(|| {
    let mut points = Points::here();
    let one = |i| -> Result<_, Failure> {
        let rho = match i % 3 {
            0 => 1.0 + points.log_uniform(1e-3, 1e-1),
            _ => points.uniform(1.1, 3.0),
        };
        let (sine, cosine) = libm::sincos(points.uniform(-3.1, 3.1));
        let (table, to) = (Table::default(), points.uniform(0.2, 1.5));
        let start = State {
            t: 0.0,
            x: [rho * cosine, rho * sine],
            v: [0.0; 2],
        };
        Ok(Loose {
            rho,
            to,
            turning: rotating::run(&table, &start, to)?,
            still: inertial::run(&table, &table.to_laboratory(&start), to)?,
        })
    };
    every((0..30).map(one))
});

const TERMS: usize = 24;

/// The sum of a rate from a start on with what it is the rate of, which is zero at rest, by components along the velocity:
/// from p, ξ and η.
fn from_rest(
    compared: Compared,
    rate: fn(&View) -> f64,
    quantity: fn([f64; 3]) -> f64,
) -> Evidence {
    Trial::by(Quadrature, Within, compared, MOTION).each(LOOSE.each(), Loose::at, |loose| {
        let start = Exact::from(&Start::polar(loose.rho, 0.0, 0.0)?);
        let end = moment::<f64, TERMS>(&start, loose.to)?;
        Ok([
            loose.sum(rate),
            quantity([end.p, end.xi, end.eta]),
            loose.rho * loose.rho,
        ])
    })
}

/// Long after every one of these motions has stopped.
const LONG: f64 = 20.0;

#[derive(Debug)]
struct Stop {
    /// ρ and p at the start.
    begin: [f64; 2],
    name: String,
    /// By components along the velocity.
    run: Run,
    /// By each program, its name, when it stops, and σ.
    ends: [(&'static str, f64, f64); 3],
    /// σ by the state long after the stop.
    later: f64,
    /// The same of many at once, and what they know the time to.
    of_many: [f64; 3],
}

fn stop(i: usize, points: &mut Points) -> Result<Stop, Failure> {
    let direction = points.uniform(-3.1, 3.1);
    let along = |size: f64, angle: f64| {
        let (sine, cosine) = libm::sincos(direction + angle);
        [size * cosine, size * sine]
    };
    let rho = points.uniform(0.05, 0.9);
    let p = rho.min(1.0 - rho) * points.uniform(0.2, 0.95);
    let (begin, psi, alone, name) = match i % 3 {
        0 => {
            let psi = points.uniform(-2.8, 2.8);
            ([rho, p], psi, Start::polar(rho, p, psi)?, "")
        }
        1 => {
            let rho = 0.5 * rho;
            // At rest in the laboratory: it goes backwards on the table.
            ([rho, rho], FRAC_PI_2, Start::put_down(rho)?, ", put down")
        }
        _ => ([0.0, rho], 0.0, Start::launched(rho)?, ", from the axis"),
    };
    let [rho, p] = begin;
    let table = Table::default();
    let start = State {
        t: 0.0,
        x: along(rho, psi),
        v: along(p, 0.0),
    };
    let turning = rotating::run(&table, &start, LONG)?;
    let still = inertial::run(&table, &table.to_laboratory(&start), LONG)?;
    let stops = |path: &Path| -> Result<(f64, f64), Failure> {
        let time = path.stops().first().ok_or("it does not stop")?;
        Ok((*time, path.on_table(LONG)?.radius()))
    };
    let (in_turn, in_rest) = (stops(&turning)?, stops(&still)?);
    let Fate::Rest { sigma, tau, .. } = fate(&alone)? else {
        return Err("it does not come to rest".into());
    };
    let horizon = Horizon {
        rho: 10.0,
        tau: LONG,
    };
    let End::Rest {
        sigma: place,
        tau: time,
        tau_error,
        ..
    } = horizon.follow_alone(&[alone])?.remove(0)?
    else {
        return Err("of many, it does not come to rest".into());
    };
    let from = Start::polar(rho, p, psi)?;
    let later = moment::<f64, TERMS>(&Exact::from(&from), LONG)?;
    Ok(Stop {
        begin,
        name: format!("ρ = {rho:.6}, p = {p:.6}, ψ = {psi:.6}{name}"),
        run: Run::new(&from, LONG)?,
        ends: [
            ("the frame of the table", in_turn.0, in_turn.1),
            ("the laboratory", in_rest.0, in_rest.1),
            ("the fate", tau, sigma),
        ],
        later: libm::hypot(later.xi, later.eta),
        of_many: [time, place, tau_error],
    })
}

static TO_REST: Runs<Vec<Stop>> = Runs::new(|| {
    let mut points = Points::here();
    every((0..24).map(|i| stop(i, &mut points)))
});

impl Stop {
    /// (104) at rest at `sigma` with (104) at the start.
    fn kept(&self, by: &str, sigma: f64) -> Pair {
        let [rho, p] = self.begin;
        Pair::plain(
            format!("{}, σ = {sigma:.6} by {by}", self.name),
            printed::eq104_constant(0.0, sigma, self.run.end().s)
                - printed::eq104_constant(p, rho, 0.0),
            0.0,
        )
    }

    /// What (99) takes from p until the time `stop`, with p.
    fn slowed(&self, by: &str, stop: f64) -> Result<Pair, Failure> {
        // By the third power of the time left: close to rest, ξ is no power series in it.
        let rate = |left: f64| {
            let tau = stop * (1.0 - left * left * left);
            let now = self.run.at(tau);
            now.map_or(f64::NAN, |now| {
                3.0 * stop * left * left * printed::eq99_p_rate(now.parts.xi)
            })
        };
        Ok(Pair::plain(
            format!("{}, to the stop by {by}", self.name),
            sum(rate, 0.0, 1.0, 1e-13),
            -self.begin[1],
        ))
    }
}

fn by_each(programs: usize) -> impl Iterator<Item = (usize, Result<&'static Stop, Failure>)> {
    TO_REST
        .each()
        .flat_map(move |stop| (0..programs).map(move |i| (i, stop.clone())))
}

const MANY: &str = "many at once";

/// How far and how long many at once are followed.
const HORIZON: Horizon = Horizon { rho: 3.0, tau: 2.0 };

fn eq104_of_many() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        [
            r"the change of (104) from the start to rest, to $\rho=3$ or to $\tau=2$, of many followed at once,",
            "0",
        ],
        OF_MANY,
    );
    let resting = TO_REST.each().map(|stop| -> Result<_, Failure> {
        let stop = stop?;
        Ok(stop.kept(MANY, stop.of_many[1]))
    });
    let mut points = Points::here();
    let going = (0..24).map(|_| -> Result<_, Failure> {
        let (rho, psi) = (points.uniform(0.5, 2.0), points.uniform(-2.8, 2.8));
        let p = points.uniform(0.5, 3.0);
        let start = Start::polar(rho, p, psi)?;
        let (name, tau, end) = match HORIZON.follow_alone(&[start])?.remove(0)? {
            End::Far { tau, .. } => ("at ρ = 3", tau, None),
            End::Late(state) => ("at τ = 2", HORIZON.tau, Some(state)),
            End::Rest { tau, sigma, .. } => {
                let place = Start::polar(sigma, 0.0, 0.0)?;
                ("at rest", tau, Some(place))
            }
            End::Unfinished(_) => return Err("its end is not certain".into()),
        };
        let now = Run::new(&start, tau)?.end();
        let (speed, place) = end.map_or((now.p(), HORIZON.rho), |state| (state.p, state.rho()));
        Ok(Pair::plain(
            format!("ρ = {rho:.6}, p = {p:.6}, ψ = {psi:.6}, {name}"),
            printed::eq104_constant(speed, place, now.s) - printed::eq104_constant(p, rho, 0.0),
            0.0,
        ))
    });
    trial.over(resting.chain(going), |pair: Result<Pair, Failure>| pair)
}

attempts![
    // (89) from the moment of a start on: friction is overcome, and has its full size at once.
    eq89_from_rest = {
        let trial = Trial::by(
            Quadrature,
            Within,
            [
                r"the integral of (89) over $\tau$ along a motion that starts from rest, in the frame of the table,",
                r"$\mathrm d\bm\rho/\mathrm d\tau$ found in the laboratory, each vector by the one number $x+2y$",
            ],
            FRAMES,
        );
        trial.each(LOOSE.each(), Loose::at, |loose| {
            Ok([
                loose.sum(eq89_rate),
                weighed(loose.still.on_table(loose.to)?.v),
                1.0,
            ])
        })
    },
    eq89_by_components = {
        let trial = Trial::by(
            Quadrature,
            Within,
            [
                r"the integral of (89) over $\tau$ along the motion found in the frame of the table",
                r"the change of $\mathrm d\bm\rho/\mathrm d\tau$ by components along the velocity, each vector by the one number $x+2y$",
            ],
            FRAMES,
        );
        trial.each(stretches(ANY), Stretch::at, |stretch| {
            let [u, v] = stretch.view(0.0)?.rate;
            let velocity = |tau: f64| -> Result<f64, Failure> {
                let part = stretch.part(tau)?;
                let (sine, cosine) = libm::sincos(libm::atan2(v, u) + part.turned);
                Ok(part.p() * weighed([cosine, sine]))
            };
            Ok([
                stretch.sum(eq89_rate, 1e-13),
                velocity(stretch.to)? - velocity(stretch.from)?,
                1.0,
            ])
        })
    },
    eq91_from_rest = from_rest(
        Compared::one(
            r"the integral of (91) over $\tau$ along a motion that starts from rest, in the frame of the table,",
            r"$\hat{\bm z}\cdot(\bm\rho\times\mathrm d\bm\rho/\mathrm d\tau)$ by components along the velocity",
        ),
        |v| printed::eq91_moment(v.position, v.rate),
        |[p, _, eta]| -p * eta,
    ),
    eq92_from_rest = from_rest(
        Compared::one(
            r"the integral of (92) over $\tau$ along a motion that starts from rest, in the frame of the table,",
            r"$\bm\rho\cdot\mathrm d\bm\rho/\mathrm d\tau$ by components along the velocity",
        ),
        |v| printed::eq92_virial(v.position, v.rate),
        |[p, xi, _]| p * xi,
    ),
    eq99_until_rest = Trial::by(
        Integration,
        Within,
        [
            r"the integral of (99) over $\tau$ along a motion until it stops, by three programs,",
            "$-p$ at the start",
        ],
        ENDS,
    )
    .over(by_each(3), |(i, stop)| {
        let stop = stop?;
        let (by, time, _) = stop.ends[i];
        stop.slowed(by, time)
    }),
    eq99_of_many = {
        let trial = Trial::by(
            Integration,
            Within,
            [
                r"the integral of (99) over $\tau$ along a motion until it stops, of many followed at once,",
                "$-p$ at the start",
            ],
            OF_MANY,
        );
        trial.over(TO_REST.each(), |stop| {
            let stop = stop?;
            let [time, _, error] = stop.of_many;
            let pair = stop.slowed(MANY, time)?;
            let scale = pair.scale.max(error / OF_MANY.value);
            Ok(Pair { scale, ..pair })
        })
    },
    eq104_at_rest = Trial::by(
        Integration,
        Printed,
        [
            "the change of (104) from the start to the place of rest, by four programs,",
            "0",
        ],
        ENDS,
    )
    .over(by_each(4), |(i, stop)| {
        let stop = stop?;
        Ok(match stop.ends.get(i) {
            Some((by, _, sigma)) => stop.kept(by, *sigma),
            None => stop.kept("the state long after the stop", stop.later),
        })
    }),
    eq104_of_many
];
