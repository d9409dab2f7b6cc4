//! The chapters on what is shaken: by a sine, by any drive, and with two frictions.

use super::{Known, along, falls, found, known, rises, same, tried, words};
use crate::claims::{
    PAPER,
    anisotropic::census,
    anisotropic::drift::budget,
    anisotropic::simulated::{Curves, attractor, curve_a, curve_e, order},
    periodic::drawn,
    periodic::drives::{Phase, motion, named, phase, third_harmonic},
};
use crate::corrections::{anisotropic as border, periodic as pulses, sinusoidal as swing};
use crate::motion::drive::{Drive, DriveState, Friction, Interval, Sign};
use crate::numerics::roots::root;
use crate::paper::{anisotropic, periodic, sinusoidal as sine};
use crate::solve::{anisotropic as ratchet, sinusoidal};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};
use trialbook::publishing::Word;

words! {
    "factor-falls-1" => {
        let lambda_c = 2.0 / libm::sqrt(4.0 + PI * PI);
        let end = swing::contraction(lambda_c);
        swing::contraction(0.0) == 1.0 && end < 1e-15 && falls(along(0.0, lambda_c).map(swing::contraction))
    };
    "less-than-two" => {
        let factor = 0.5 * libm::sqrt(4.0 + PI * PI);
        (1.8..2.0).contains(&factor) && never_rests(1.01 * factor)? && !never_rests(0.99 * factor)?
    };
    "smaller-rests" => !never_rests(1.7)? && never_rests(2.0)?;
    "nearly-the-whole-period" => [slip(1e-3)? > 0.9, slip(1e-3)? < 0.1, (slip(1e-3)? - 0.5).abs() < 0.1];
    "nothing-forgotten-keeps" => [same(left_of_a_difference()?, 1.0, 1e-12), left_of_a_difference()? < 0.5];
    "special-phases" => PAPER.values().filter(|v| v.id.starts_with("phi-")).count();
    "special-phases-merged" => different_phases(TAU);
    "special-phases-with-both-ends" => different_phases(9.0);
    "ends-of-rests" => {
        let swing = sine_drive()?;
        let friction = Friction::new(0.5, 0.5)?;
        tried(SPECIAL.iter().map(|phase| {
            let start = DriveState { phi: phase(0.5) - 1e-3, w: 0.0 };
            let after = |time| known(swing.advance(friction, start, start.phi + time)?.end.w);
            Ok(after(5e-4)? == 0.0 && after(0.1)? != 0.0)
        }))?.filter(|ends| *ends).count()
    };
    "regimes" => regimes()?;
    "borders-of-regimes" => regimes()? - 1;
    "zeros-in-a-period" => {
        let drive = sine_drive()?;
        let outcome = drive.attractor(Friction::new(0.3, 0.3)?, AT_REST, 99)?;
        let motion = found(outcome.settled())?;
        let zeros = motion.intervals();
        found(zeros.iter().all(|i| i.sign != Sign::Rest).then_some(zeros.len()))?
    };
    "start-falls" => {
        let start = |lambda| pulses::small_friction_start(lambda, 0.4);
        falls(along(0.01, 0.4).map(start)) && start(0.4) == 0.0
    };
    "less-faster" => falls(along(0.31, 0.99).map(|lambda| periodic::eq44_cases(lambda, 0.3, 0.3 * PI)[0]));
    "full-force" => [same(stop(1.0)?, 1.0 / (1.25 - 1.0), 1e-9), same(stop(0.01)?, 1.0 / (1.25 - 1.0), 1e-9)];
    "pulse-sets-off" => [sets_off(0.3 * PI)?, sets_off(0.8 * PI)?];
    "distance-after-maximum" => {
        // A sine is 1 − x²/2 at its maximum.
        let path = sine_drive()?.advance(Friction::new(1.0 - 1e-6, 1.0 - 1e-6)?, AT_REST, PI)?;
        let slip = found(path.intervals.iter().find(|i| i.sign == Sign::Positive))?;
        (slip.end - FRAC_PI_2).div_euclid(0.99 * (FRAC_PI_2 - slip.start))
    };
    // The push takes a quarter of the period.
    "pull-longer" => (TAU - FRAC_PI_2) / FRAC_PI_2;
    "third-harmonic" => drawn::THIRD;
    "humps" => loops(0.04)?.len();
    "large-humps" => loops(0.04)?.len() - shallow(0.04)?.len();
    "shallow-humps" => shallow(0.04)?.len();
    "deepened-humps" => deepened(true)?;
    "flattened-humps" => deepened(false)?;
    "rests-back-at-larger" => {
        // None, then some, then none: those that come back need much more friction.
        let at = tried([0.04, 0.08, 0.16, 0.32].into_iter().map(resting))?;
        at.eq([false, true, false, true])
    };
    "rests-at-first" => rests()?[0];
    "rests-then" => rests()?[1];
    "rests-at-most" => rests()?[2];
    "rests-at-last" => rests()?[3];
    "b-positive-and-falls" => tried(along(1.5, 12.0).map(|q| {
        let over = excess(anisotropic::eq54_sides, q);
        Ok(over(0.0) > 0.0 && falls(along(0.0, 1.0 / q).map(over)))
    }))?.all(|holds| holds);
    "e-0-falls-convex" => tried(along(1.5, 12.0).map(|q| {
        let over = excess(border::e_sides, q);
        let slopes = along(0.0, 0.95 / q).map(|x| over(x + 1e-4 / q) - over(x));
        Ok(over(0.0) == 0.0 && over(1e-3 / q) < 0.0 && rises(slopes))
    }))?.all(|holds| holds);
    "negative-before-y" => [(4.5, -1.0), (4.7, 1.0)].iter().all(|(q, sign)| {
        let [b, e] = [anisotropic::eq54_sides, border::e_sides].map(|sides| excess(sides, *q)(1.0 / q));
        (b - e).abs() < 1e-12 && b * sign > 0.0
    });
    "drift-faster-larger-q" => {
        let drift = |q: f64, lambda0: f64| Ok(budget(q, lambda0)?.drift);
        falls(tried(along(0.01, 0.97).map(|lambda0| drift(2.6, lambda0)))?) && rises(tried(along(1.1, 6.0).map(|q| drift(q, 0.05)))?)
    };
    "loss-largest" => {
        let lost = |lambda0: f64| border::loss_without_rest(1.0, lambda0, FRAC_PI_2);
        let most = lost(SQRT_2 / PI);
        (most - 4.0 / PI).abs() < 1e-15 && along(0.05, 0.53).all(|lambda0| lost(lambda0) < most)
    };
    "b-lower-in-III" => {
        // (54) falls through zero on B.
        let over = excess(anisotropic::eq54_sides, 2.0);
        over(0.406) > 0.0 && over(0.408) < 0.0
    };
    "stationary" => {
        let touch = root(|x: f64| libm::sin(x) - x * libm::cos(x), 4.0, 4.7)?;
        let [left, at, right] = [-1e-4, 0.0, 1e-4].map(|h| libm::sin(touch + h) / (touch + h));
        [same(left, right, 1e-8), at.abs() < 1e-8]
    };
    "no-net-velocity" => {
        let motion = attractor(2.0, 0.2)?;
        [imparted(|_| 1.0).abs() < 1e-9, imparted(|phi| motion.w(phi)).abs() < 1e-9]
    };
    "never-backward-in-IV" => {
        // In the order of the words: IV, I, II, III, V.
        let never = |(region, lambda0): &(&str, f64)| {
            let period = ratchet::AnisotropicProblem { q: 2.0, lambda0: *lambda0 }.solve()?.best;
            found((period.region == *region).then_some(period.positive > 0.0 && period.negative == 0.0))
        };
        let at = [("IV", 0.55), ("I", 0.2), ("II", 0.38), ("III", 0.45), ("V", 1.1)];
        found(<[bool; 5]>::try_from(tried(at.iter().map(never))?.as_slice()).ok())?
    };
    "below-mu_-g" => {
        let moves = |lambda0: f64| known(ratchet::AnisotropicProblem { q: 4.0, lambda0 }.solve()?.best);
        // The amplitude in units of the friction backward and forward: just below and above each.
        let [below, above] = [moves(0.26)?, moves(0.24)?];
        let [weak, strong] = [moves(1.01)?, moves(0.99)?];
        below.negative == 0.0 && above.negative > 0.0 && weak.positive == 0.0 && strong.positive > 0.0
    };
    "kinds-of-motion" => PAPER.claims().filter(|(_, claim)| claim.id.starts_with("s24-region-")).count();
    "rests-in-a-period" => {
        let kinds = tried([0.2, 0.38, 0.45, 0.55, 1.1].into_iter().map(|x| Ok(order(attractor(2.0, x)?.intervals()))))?;
        found(kinds.map(|kind| kind.matches('0').count()).max())?
    };
    "a-over-e-far-out" => libm::round(1e3 * curve_a(1e4)? / found(curve_e(1e4)?)?) / 1e3;
    "census-points" => (census::COLUMNS * census::ROWS).next_multiple_of(10_000);
    "much-stronger-backwards" => {
        let alike = |q: f64, lambda0: f64| {
            let printed = anisotropic::region(lambda0, &Curves::at(q)?.printed);
            let moves = ratchet::AnisotropicProblem { q, lambda0 }.solve()?.best.region;
            known(printed.map(|i| ["I", "II", "III", "IV", "V"][i - 1]) == Some(moves))
        };
        let all_alike = |q: f64| known(tried(along(0.013, 1.1).map(|lambda0| alike(q, lambda0)))?.all(|alike| alike));
        all_alike(1.5)? && all_alike(4.5)? && !alike(8.0, 0.12)?
    };
}

const AT_REST: DriveState = DriveState { phi: 0.0, w: 0.0 };

fn sine_drive() -> Known<Drive> {
    Ok(Drive::new(libm::sin, &[])?)
}

/// The left side of (54), or of E, less the right, at q.
fn excess(sides: fn(f64, f64) -> [f64; 2], q: f64) -> impl Fn(f64) -> f64 + Copy {
    move |lambda0| {
        let [left, right] = sides(lambda0, (q * lambda0).min(1.0));
        left - right
    }
}

/// Whether the particle never rests, under a drive whose amplitude is so many times the friction.
fn never_rests(factor: f64) -> Known<bool> {
    let problem = sinusoidal::SinusoidalProblem {
        lambda0: 1.0 / factor,
    };
    Ok(problem.solve()?.best.rest_fraction == 0.0)
}

/// The share of the period for which the slip lasts that begins where the drive overcomes the friction.
fn slip(lambda: f64) -> Known {
    let path = sine_drive()?.advance(Friction::new(lambda, lambda)?, AT_REST, TAU)?;
    let first = path.intervals.iter().find(|i| i.sign == Sign::Positive);
    Ok(found(first)?.length() / TAU)
}

/// What is left after some periods without friction of the difference of two velocities.
fn left_of_a_difference() -> Known {
    let (swing, none) = (sine_drive()?, Friction::new(0.0, 0.0)?);
    let end = |w| known(swing.advance(none, DriveState { phi: 0.3, w }, 50.0)?.end.w);
    Ok((end(0.7)? - end(0.2)?) / 0.5)
}

/// When the friction 1.25 stops the velocity 1 that a force pushes along.
fn stop(force: f64) -> Known {
    let drive = Drive::new(|_| force, &[])?;
    let path = drive.advance(
        Friction::new(1.25, 1.25)?,
        DriveState { phi: 0.0, w: 1.0 },
        9.0,
    )?;
    Ok(found(path.intervals.last())?.start)
}

/// Whether a particle at rest at this phase of a train of pulses sets off at once.
fn sets_off(phi: f64) -> Known<bool> {
    let eta = 0.6;
    let h = |phi: f64| match phi < PI {
        true => periodic::eq42_h(eta, phi),
        false => periodic::eq43_h(periodic::eq42_h(eta, phi - PI)),
    };
    let drive = Drive::new(h, &[eta * PI, PI, PI + eta * PI])?;
    let path = drive.advance(
        Friction::new(0.3, 0.3)?,
        DriveState { phi, w: 0.0 },
        phi + 0.1,
    )?;
    Ok(path.end.w != 0.0)
}

/// ∮ sin φ f dφ.
fn imparted(f: impl Fn(f64) -> f64) -> f64 {
    let phases = (0..4096).map(|k| TAU * f64::from(k) / 4096.0);
    phases.map(|phi| libm::sin(phi) * f(phi)).sum::<f64>() * TAU / 4096.0
}

/// The special phases of a period, by λ₀.
const SPECIAL: [fn(f64) -> f64; 4] = [
    sine::eq27_phi1,
    sine::eq28_phi2,
    sine::eq29_phi3,
    sine::eq30_phi4,
];

/// How many of them differ without friction, if those are the same that are so far apart.
fn different_phases(turn: f64) -> usize {
    let mut at: Vec<f64> = SPECIAL.iter().map(|phase| phase(0.0) % turn).collect();
    at.sort_by(f64::total_cmp);
    at.dedup();
    at.len()
}

fn regimes() -> Known<usize> {
    let of = |i: u32| {
        Ok(sinusoidal::SinusoidalProblem {
            lambda0: f64::from(i) / 20.0,
        }
        .solve()?
        .best
        .regime)
    };
    let mut all: Vec<_> = tried((1..30).map(of))?.collect();
    all.dedup();
    Ok(all.len())
}

/// The intervals under the drive of which the page on any drive speaks, each with its largest speed.
fn intervals(lambda: f64) -> Known<Vec<(Sign, f64)>> {
    let drive = third_harmonic(drawn::THIRD)?;
    let motion = found(motion(&drive, lambda)?)?;
    let largest = |i: &Interval| {
        let phases = (0..=200).map(|k| i.start + i.length() * f64::from(k) / 200.0);
        (
            i.sign,
            phases.map(|phi| motion.w(phi).abs()).fold(0.0, f64::max),
        )
    };
    Ok(motion.intervals().iter().map(largest).collect())
}

fn loops(lambda: f64) -> Known<Vec<f64>> {
    let moving = intervals(lambda)?
        .into_iter()
        .filter(|(sign, _)| *sign != Sign::Rest);
    Ok(moving.map(|(_, size)| size).collect())
}

fn resting(lambda: f64) -> Known<bool> {
    Ok(intervals(lambda)?
        .iter()
        .any(|(sign, _)| *sign == Sign::Rest))
}

/// The loops with less than half of the largest speed, by their numbers.
fn shallow(lambda: f64) -> Known<Vec<usize>> {
    let sizes = loops(lambda)?;
    let most = sizes.iter().copied().fold(0.0, f64::max);
    Ok((0..sizes.len())
        .filter(|i| sizes[*i] <= 0.5 * most)
        .collect())
}

/// How many of the shallow loops more friction deepens, or flattens.
fn deepened(deeper: bool) -> Known<usize> {
    // The same loops one after the other, as none has gone.
    let (weak, strong) = (loops(0.02)?, loops(0.05)?);
    let of = shallow(0.02)?;
    found((weak.len() == strong.len()).then(|| {
        of.iter()
            .filter(|i| (strong[**i] > weak[**i]) == deeper)
            .count()
    }))
}

/// How many rests there are in a period, one number after the other, under growing friction.
fn rests() -> Known<[usize; 4]> {
    let bar = found(named()?.into_iter().nth(1))?;
    let at = |cell| match phase(&bar.drive, drawn::friction(cell, 100))? {
        Phase::Rests(n) => Ok(n),
        other => Err(format!("{other:?}").into()),
    };
    let mut rests: Vec<usize> = tried((0..100).map(at))?.collect();
    rests.dedup();
    rests
        .try_into()
        .map_err(|rests| format!("{rests:?}").into())
}
