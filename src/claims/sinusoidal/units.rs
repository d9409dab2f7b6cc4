//! Trials of (21) to (26): the dimensionless symbols are consistent, and (26) is what the motion obeys.

use super::prelude::*;
use super::reference_motions::at;

pub(super) fn eq21() -> Evidence {
    Trial::consistency(
        Printed,
        [
            "the integral of (21) over $t$, its $x$ component with the sign changed,",
            "the gain of $v_x+v_y$ of a particle without friction",
        ],
    )
    .drawn(0..40, |_, points| {
        let (a0, varpi) = (points.log_uniform(0.1, 10.0), points.log_uniform(0.1, 10.0));
        let from = points.uniform(0.1, 6.0) / varpi;
        let t = from + points.uniform(0.1, 7.0) / varpi;
        let scale = a0 / varpi;
        let smooth = Particle {
            friction: 0.0,
            a0,
            varpi,
        };
        let end = smooth.run(from, [0.0, scale], t)?.end();
        let rate = |t: f64| {
            let [ax, ay] = printed::eq21_acceleration(a0, varpi, t);
            ay - ax
        };
        Ok(Pair {
            at: format!("A₀ = {a0:.6}, ϖ = {varpi:.6}, t = {from:.6} to {t:.6}"),
            stated: sum(rate, from, t, 1e-13 * scale),
            found: end.v[0] + (end.v[1] - scale),
            scale,
        })
    })
}

/// In units of its own, and without units; both from rest.
#[derive(Clone)]
struct Twins {
    at: String,
    mu: f64,
    g: f64,
    varpi: f64,
    a0: f64,
    t: f64,
    release: f64,
    /// At a later time.
    vx: f64,
    /// The phase at which the twin starts to slide, by its own motion.
    twin_release: f64,
    /// At the later phase.
    twin_w: f64,
}

impl Twins {
    fn at(&self) -> String {
        self.at.clone()
    }
}

static ALL_TWINS: Runs<Vec<Twins>> = Runs::new(|| {
    let mut points = Points::here();
    every((0..24).map(|_| twins(&mut points)))
});

fn twins(points: &mut Points) -> Result<Twins, Failure> {
    let (mu, g) = (points.uniform(0.1, 2.0), points.uniform(1.0, 20.0));
    let a0 = mu * g / points.uniform(0.05, 0.95);
    let varpi = points.log_uniform(0.002, 10.0);
    let t = points.uniform(2.0, 12.0) / varpi;
    let particle = Particle {
        friction: mu * g,
        a0,
        varpi,
    };
    let motion = particle.run(0.0, [0.0; 2], t)?;
    let lambda = mu * g / a0;
    let friction = Friction::new(lambda, lambda)?;
    let path = drive()?.advance(friction, ORIGIN, varpi * t)?;
    let rest = path.intervals.first().ok_or("no interval")?;
    let release = motion.starts().first().ok_or("no release")?;
    Ok(Twins {
        at: format!("μ = {mu:.6}, g = {g:.6}, A₀ = {a0:.6}, ϖ = {varpi:.6}, t = {t:.6}"),
        mu,
        g,
        varpi,
        a0,
        t,
        release: *release,
        vx: motion.end().v[0],
        twin_release: rest.end,
        twin_w: path.end.w,
    })
}

/// On both sides of 1, 1 itself included.
fn around_one() -> Vec<f64> {
    let mut points = Points::here();
    let mut list: Vec<_> = (0..24).map(|_| points.uniform(0.02, 2.0)).collect();
    list.extend([1.0 - 1e-9, 1.0 - 1e-6, 1.0, 1.0 + 1e-9, 1.0 + 1e-6]);
    list
}

fn eq26_quadrature() -> Evidence {
    let trial = Trial::quadrature(
        Printed,
        [
            r"the integral of (26) over $\phi$, over half a slip,",
            r"the change of $\mathfrak w$ of a particle that began with $v_y\ne0$, or, from $\phi=0.5$ to 1.5, of one that began along the drive, with $\lambda_0$ near 0 and 1",
        ],
    );
    let mut points = Points::here();
    let edges = [5e-4, 1.0 - 5e-4, 1.0 + 5e-4].map(Ok);
    let cases = (0..20).map(Err).chain(edges);
    trial.over(cases, |case| {
        let i = match case {
            Ok(lambda) => return along_the_drive(lambda),
            Err(i) => i,
        };
        let lambda = points.uniform(0.5, 0.95);
        let side = if i % 2 == 0 {
            Sign::Positive
        } else {
            Sign::Negative
        };
        let slips = settled(lambda, ORIGIN)?;
        let slip = slips.intervals().iter().find(|i| i.sign == side);
        let slip = slip.ok_or("no slip")?;
        let from = slip.start + 0.25 * slip.length() + 2.0 * TAU;
        let to = from + 0.5 * slip.length();
        let v = [points.uniform(-1.0, 1.0), points.uniform(0.05, 0.3)];
        let motion = Particle::plain(lambda).run(0.0, v, to)?;
        // Inside a slip the sign of 𝔴 is all of it that (26) sees.
        let middle = motion.at(0.5 * (from + to))?.v[0];
        eq26_summed(lambda, &motion, [from, to], middle)
    })
}

/// From a velocity along the drive, which lasts.
fn along_the_drive(lambda: f64) -> Result<Pair, Failure> {
    let (from, to) = (0.5, 1.5);
    let motion = Particle::plain(lambda).run(0.0, [3.0, 0.0], to)?;
    eq26_summed(lambda, &motion, [from, to], 1.0)
}

fn eq26_summed(
    lambda: f64,
    motion: &Motion,
    [from, to]: [f64; 2],
    sign: f64,
) -> Result<Pair, Failure> {
    let rate = |phi: f64| printed::eq26_rate(lambda, phi, sign);
    Ok(Pair::plain(
        format!("λ₀ = {lambda:.6}, φ = {from:.6} to {to:.6}"),
        sum(rate, from, to, 1e-14),
        motion.at(to)?.v[0] - motion.at(from)?.v[0],
    ))
}

attempts![
    eq21,
    eq22 = Trial::consistency(
        Printed,
        [
            r"$\mathfrak w$ of $\mathfrak w'=h\mp\lambda_0$, with $\lambda_0$ by (22),",
            r"$\varpi v_x/A_0$ of the particle",
        ],
    )
    .each(ALL_TWINS.each(), Twins::at, |twins| {
        let lambda = printed::eq22_lambda0(twins.mu, twins.g, twins.a0);
        let drive = drive()?;
        // Of a friction that cannot be nothing is stated.
        let stated = Friction::new(lambda, lambda)
            .and_then(|friction| drive.advance(friction, ORIGIN, twins.varpi * twins.t));
        let stated = stated.map_or(f64::NAN, |path| path.end.w);
        Ok([stated, twins.varpi * twins.vx / twins.a0, 1.0])
    }),
    eq23 = Trial::consistency(
        Printed,
        [
            "(23) of the time at which the particle starts",
            "the phase at which its twin does",
        ],
    )
    .each(ALL_TWINS.each(), Twins::at, |twins| {
        let stated = printed::eq23_phase(twins.varpi, twins.release);
        Ok([stated, twins.twin_release, 1.0])
    }),
    eq24 = Trial::consistency(
        Printed,
        [
            "(24) of the particle's $v_x$",
            "the velocity of its twin without units",
        ],
    )
    .each(ALL_TWINS.each(), Twins::at, |twins| {
        let stated = printed::eq24_w(twins.varpi, twins.vx, twins.a0);
        Ok([stated, twins.twin_w, 1.0])
    }),
    eq25_motion = Trial::by(
        Integration,
        Printed,
        [
            "whether (25) holds (1 if so)",
            "whether a particle at rest starts to slide within a period",
        ],
        NONE,
    )
    .over(around_one(), |lambda| {
        let motion = Particle::plain(lambda).run(0.0, [0.0; 2], TAU)?;
        let [left, right] = printed::eq25_sides(lambda);
        Ok(Pair::plain(
            at(lambda),
            is(left < right),
            is(!motion.starts().is_empty()),
        ))
    }),
    eq25_census = Trial::census(
        Printed,
        [
            "whether (25) holds (1 if so)",
            "whether the large-time motion is not rest for ever",
        ],
    )
    .over(around_one(), |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let moves = attractor.intervals().iter().any(|i| i.sign != Sign::Rest);
        let [left, right] = printed::eq25_sides(lambda);
        Ok(Pair::plain(at(lambda), is(left < right), is(moves)))
    }),
    eq26_quadrature
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frictions_come_as_close_to_one_from_both_sides() {
        let off = around_one()
            .into_iter()
            .map(|lambda| ((lambda - 1.0) * 1e9).round());
        let mut close: Vec<_> = off.filter(|d| d.abs() < 1e4).collect();
        close.sort_by(f64::total_cmp);
        assert_eq!(close, [-1e3, -1.0, 0.0, 1.0, 1e3]);
    }
}
