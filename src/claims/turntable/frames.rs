//! Trials of the law of motion, with its dimensions and without, (86) to (89), and of its mirror image.

use super::prelude::*;
use super::trajectories::{Launch, any_table, launches};

fn acceleration(table: &Table, state: &State) -> [f64; 2] {
    printed::eq86_acceleration(table.omega, table.mu, table.g, state.x, state.v)
}

pub(super) fn eq86() -> Evidence {
    let compared = Compared::one(
        "the integral of (86) over $t$ along the motion found in the frame of the table",
        r"the change of $\mathrm d\bm r/\mathrm dt$ found in the laboratory, component by component",
    );
    summed(Within, compared, |table, state| (table, state))
}

pub(super) fn mirror() -> Evidence {
    let compared = Compared::one(
        r"the integral of (86) over $t$ with $-\Omega$ along the mirrored motion, found in the frame of the table,",
        r"the mirrored change of $\mathrm d\bm r/\mathrm dt$ found in the laboratory, component by component",
    );
    summed(Printed, compared, |table, state| {
        let other = Table {
            omega: -table.omega,
            ..table
        };
        let mirrored = State {
            x: [state.x[0], -state.x[1]],
            v: [state.v[0], -state.v[1]],
            ..state
        };
        (other, mirrored)
    })
}

fn summed(
    subject: Subject,
    compared: Compared,
    image: fn(Table, State) -> (Table, State),
) -> Evidence {
    Trial::by(Quadrature, subject, compared, FRAMES).over(with_each(launches(), [0, 1]), |case| {
        let (launch, i) = case?;
        let of = |state: State| image(launch.table, state);
        let rate = |t: f64| {
            let here = launch.turning.at(t).map(of);
            here.map_or(f64::NAN, |(table, state)| acceleration(&table, &state)[i])
        };
        let velocity = |state: State| of(state).1.v[i];
        let unit = launch.table.length() * launch.table.omega;
        Ok(Pair {
            at: launch.at(),
            stated: sum(rate, 0.0, launch.to, 1e-13 * unit),
            found: velocity(launch.still.on_table(launch.to)?) - velocity(launch.start),
            scale: unit,
        })
    })
}

fn eq86_turns() -> Evidence {
    Trial::by(
        Integration,
        Within,
        [
            "the place on the table by (86), through three turns,",
            "that found in the laboratory, as the sum of its components",
        ],
        FOREIGN,
    )
    .drawn(0..20, |_, points| {
        let table = any_table(points, 0.3);
        let (r, direction) = (
            table.length() * points.uniform(1.5, 3.0),
            points.uniform(-3.1, 3.1),
        );
        let [c, s] = [libm::cos(direction), libm::sin(direction)];
        // As fast as the table or slower, so that ρ² − p² > 1 and no stop can come but from straight ahead.
        let v = r * table.omega * points.uniform(0.2, 0.6);
        let start = State {
            t: 0.0,
            x: [r * c, r * s],
            v: [-v * s, v * c],
        };
        let until = 3.0 * TAU / table.omega;
        let [x, y] = by_the_law(&table, &start, until);
        let place = inertial::run(&table, &table.to_laboratory(&start), until)?.on_table(until)?;
        Ok(Pair {
            at: format!(
                "Ω = {:.6}, μ = {:.6}, g = {:.6}, r = {r:.6}, v = {v:.6}",
                table.omega, table.mu, table.g
            ),
            stated: x + y,
            found: place.x[0] + place.x[1],
            scale: place.radius(),
        })
    })
}

/// Not a number if (86) leads nowhere.
fn by_the_law(table: &Table, start: &State, until: f64) -> [f64; 2] {
    let rate = |_: f64, y: &[f64; 4]| {
        let state = State {
            t: 0.0,
            x: [y[0], y[1]],
            v: [y[2], y[3]],
        };
        let [ax, ay] = acceleration(table, &state);
        [y[2], y[3], ax, ay]
    };
    let begin = [start.x[0], start.x[1], start.v[0], start.v[1]];
    let end = dop853::end(rate, 0.0, begin, until, 1e-13, 1e-13);
    end.map_or([f64::NAN; 2], |[x, y, ..]| [x, y])
}

pub(super) fn weighed([x, y]: [f64; 2]) -> f64 {
    x + 2.0 * y
}

/// (89) in one number.
pub(super) fn eq89_rate(v: &View) -> f64 {
    weighed(printed::eq89_acceleration(v.position, v.rate))
}

pub(super) fn eq89() -> Evidence {
    let trial = Trial::by(
        Quadrature,
        Within,
        [
            r"the integral of (89) over $\tau$ along the motion found in the frame of the table",
            r"the change of $\mathrm d\bm\rho/\mathrm d\tau$ found in the laboratory, each vector by the one number $x+2y$",
        ],
        FRAMES,
    );
    trial.each(stretches(ANY), Stretch::at, |stretch| {
        let [begin, end] = [stretch.from, stretch.to].map(|tau| stretch.still.on_table(tau));
        Ok([
            stretch.sum(eq89_rate, 1e-13),
            weighed(end?.v) - weighed(begin?.v),
            1.0,
        ])
    })
}

/// On the table with Ω = μg = 1, for longer than the launch.
fn in_units(launch: &Launch) -> Result<Path, MotionError> {
    let table = &launch.table;
    let length = table.length();
    let start = State {
        t: 0.0,
        x: launch.start.x.map(|x| x / length),
        v: launch.start.v.map(|v| v / (length * table.omega)),
    };
    rotating::run(&Table::default(), &start, 1.5 * launch.to * table.omega)
}

pub(super) fn eq87() -> Evidence {
    Trial::by(
        Consistency,
        Printed,
        [
            "(87) of a motion on any table",
            r"the motion for $\Omega=\mu g=1$, component by component",
        ],
        FRAMES,
    )
    .over(with_each(launches(), [0, 1]), |case| {
        let (launch, i) = case?;
        let Table { omega, mu, g, .. } = launch.table;
        let place = launch.still.on_table(launch.to)?.x;
        Ok(Pair::plain(
            launch.at(),
            printed::eq87_position(omega, mu, g, place)[i],
            in_units(launch)?.at(launch.to * omega)?.x[i],
        ))
    })
}

pub(super) fn eq88() -> Evidence {
    let trial = Trial::by(
        Consistency,
        Printed,
        [
            r"the place at the time (88) for $\Omega=\mu g=1$",
            r"the place at the time $t$ on any table, over $\mu g/\Omega^2$, component by component",
        ],
        FRAMES,
    );
    trial.over(with_each(launches(), [0, 1]), |case| {
        let (launch, i) = case?;
        let tau = printed::eq88_time(launch.table.omega, launch.to);
        let there = in_units(launch)?.at(tau);
        Ok(Pair::plain(
            launch.at(),
            there.map_or(f64::NAN, |state| state.x[i]),
            launch.still.on_table(launch.to)?.x[i] / launch.table.length(),
        ))
    })
}

attempts![eq86, eq86_turns, eq87, eq88, eq89, mirror];
