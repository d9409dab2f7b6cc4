//! The chapters on the turntable.

use super::{Known, along, falls, found, known, same, tried, words};
use crate::claims::{
    PAPER,
    escape::growth::TERMS,
    tolerances::{ESCAPE_CORRECTION, ESCAPE_LIMIT},
};
use crate::corrections::escape;
use crate::motion::{
    State,
    turntable::boundary::between,
    turntable::{
        Fate, Start, Table, boundary, critical_radius, critical_speed, fate, inertial,
        intrinsic::Run, rotating,
    },
};
use crate::numerics::{fit::fit, roots::root};
use crate::paper::{escape as growing, rest::eq143_exponent, turntable as print};
use crate::solve::turntable;
use std::f64::consts::{PI, SQRT_2, TAU};
use trialbook::publishing::Word;

words! {
    "outwards" => {
        let moment = soon(1.5, 0.0, 0.0)?;
        moment.velocity[0] > 0.0 && moment.psi.abs() < 0.02
    };
    "axis-behind" => (soon(0.0, 1.0, 0.0)?.psi - 1e-2).abs() < 1e-4;
    "against-the-record" => {
        // At rest in the room it is carried along; at rest on the record friction only holds it.
        let later = |v| {
            let start = State { t: 0.0, x: [0.5, 0.0], v: [0.0, v] };
            known(inertial::run(&Table::default(), &start, 0.1)?.at(0.1)?)
        };
        later(0.0)?.v[1] > 0.09 && (later(0.5)?.speed() - 0.5).abs() < 1e-12
    };
    "counterclockwise" => {
        let at_rest = State { t: 0.1, x: [1.0, 0.0], v: [0.0; 2] };
        let seen = Table::default().to_laboratory(&at_rest);
        seen.x[1] > 0.0 && seen.v[1] > 0.0
    };
    "counterclockwise-velocity-to-the-position" => {
        let moment = soon(1.0, 1.0, 0.5)?;
        let ([x, y], [u, v]) = (moment.position, moment.velocity);
        let turned = libm::atan2(y, x) - libm::atan2(v, u);
        (turned - moment.psi).abs() < 1e-12 && (turned - 0.5).abs() < 0.02
    };
    "along-and-left" => {
        let moment = soon(1.0, 1.0, 0.5)?;
        let ([x, y], [u, v]) = (moment.position, moment.velocity);
        let (along, left) = ((x * u + y * v) / moment.p, (y * u - x * v) / moment.p);
        let [xi, ell] = [print::eq94_xi, print::eq95_ell].map(|of| of(moment.rho, moment.psi));
        (along - xi).abs() < 1e-12 && (left + ell).abs() < 1e-12
    };
    "only-how-they-start" => {
        let (one, other, third) = (turning(0.3, 0.5)?, turning(0.3, 0.6)?, turning(0.1, 0.5)?);
        [(one - other).abs() > 1e-3 && same(one, third, 1e-10), (one - third).abs() > 1e-3]
    };
    "never-decreases" => {
        // ξ as long as it slides, by (101) and on the way to escape.
        let run = Run::new(&Start::hyperbolic(1.5, 0.3, 2.5)?, 20.0)?;
        let xi = |t| Ok(run.at(t)?).map(|state| print::eq94_xi(state.rho(), state.psi()));
        let xi = tried(along(0.0, 20.0).map(xi))?;
        let rate = |p: f64| along(-3.0, 3.0).all(|ell| print::eq101_xi_rate(p, ell) >= 0.0);
        falls(xi.map(|x| -x)) && along(0.1, 3.0).all(rate)
    };
    "numbers-of-the-motion" => {
        let start = State { t: 0.0, x: [0.0; 2], v: [0.0; 2] };
        start.x.len() + start.v.len()
    };
    "chapters-that-follow" => PAPER.topics.iter().skip_while(|topic| topic.stem != "turntable").skip(1).count();
    "power-right" => {
        let growth = |of: fn(f64) -> f64| libm::log2(of(2e3) / of(1e3));
        let [printed, right]: [fn(f64) -> f64; 2] = [growing::eq136_rho, escape::rho];
        (growth(printed) - growth(right)).abs() < 1e-12 && printed(1.0) != right(1.0)
    };
    "a-never-decreases" => {
        let run = Run::new(&Start::hyperbolic(0.6, 0.4, 0.5)?, 2.0)?;
        let a = tried(along(0.0, 0.3).map(|t| found(run.at(t)?.a())))?;
        falls(a.map(|a| -a)) && along(0.0, 5.0).all(|alpha| print::eq113_a_rate(alpha) >= 0.0)
    };
    "lags-behind" => escape::delay::<f64>() > 0.0;
    "more-than-twice-around" => (2.0..2.2).contains(&(escape::winding::<f64>() * libm::log(1e4) / TAU));
    "turns-around" => libm::floor(SQRT_2 * libm::log(1e4) / TAU);
    "turns-of-the-table" => libm::round((1e8 - 1e4) / TAU / 1e6) * 1e6;
    "per-cent-apart" => {
        let pairs = [("a-printed", "a"), ("p-printed", "p"), ("s-printed", "s")];
        let value = |id| known(found(PAPER.value(id))?.number()?);
        let apart = tried(pairs.iter().map(|(printed, right)| Ok((value(printed)? / value(right)? - 1.0).abs())))?;
        libm::ceil(100.0 * apart.fold(0.0, f64::max))
    };
    "digits-of-the-limit" => decimals(ESCAPE_LIMIT.value);
    "digits-of-the-logarithm" => decimals(ESCAPE_CORRECTION.value);
    "digits-by-powers" => {
        let powers = fit(&late_speeds()?, &[&|_| 1.0, &|t| 1.0 / t, &|t| 1.0 / (t * t)])?;
        decimals((powers.coefficients[0] * 3.0 * SQRT_2 - 1.0).abs())
    };
    "terms-of-the-fit" => TERMS.len();
    "condition-of-the-fit" => libm::exp10(decimals(1.0 / fit(&late_speeds()?, &TERMS)?.condition));
    "cube-exceeds-below" => power_of_the_constant(1.0 / 3.0)?;
    "falls-more-slowly-below" => power_of_the_constant(1.0)?;
    "third-order-above" => power_of_the_constant(3.0)?;
    "slower" => {
        let critical = critical_speed()?;
        rests(0.0, 0.99 * critical, 0.0)? && !rests(0.0, 1.01 * critical, 0.0)?
    };
    "farther-is-easier" => {
        // The speed above which a particle thrown straight outwards escapes.
        falls(tried((0..9).map(|i| Ok(between(|p| Start::polar(0.1 * f64::from(i), p, 0.0), 1e-9, 2.0, 1e-6)?)))?)
    };
    "inwards-may-exceed" => rests(0.3, 1.05 * critical_speed()?, PI)?;
    "put-down-beyond" => {
        let critical = critical_radius()?;
        let ends = |rho: f64| known(matches!(fate(&Start::put_down(rho)?)?, Fate::Rest { .. }));
        ends(0.999 * critical)? && !ends(1.001 * critical)?
    };
    "psi-free-of-145" => {
        let (_, claim) = found(PAPER.find("s4-psi-free"))?;
        ["eq-145", "eq-144", "eq-146"].map(|id| claim.depends_on.contains(&id))
    };
    "faster-and-less-until-then" => {
        // With ψ that has not relaxed, and with one that has, from the same A and α.
        let end = |psi| match fate(&Start::hyperbolic(0.7, 0.02, psi)?)? {
            Fate::Rest { sigma, .. } => known(sigma),
            other => Err(format!("{other:?}").into()),
        };
        let rate = |psi: f64| print::eq114_alpha_rate(0.7, 0.02, psi);
        end(1.5)? < end(0.07)? && rate(1.5) < rate(0.07)
    };
    "digits-of-the-critical" => {
        let decimals = |id| known(found(PAPER.value(id))?.decimals);
        decimals("critical-radius")?.min(decimals("critical-speed")?)
    };
    "below-the-line" => {
        // In the slow motion ψ ≈ 2α, a = A − 1.
        let alpha = 0.01;
        let rests = |a: f64| known(matches!(fate(&Start::hyperbolic(1.0 + a, alpha, 2.0 * alpha)?)?, Fate::Rest { .. }));
        let border = boundary(alpha, 2.0 * alpha)? - 1.0;
        (border + alpha).abs() < 0.05 * alpha && rests(-1.1 * alpha)? && !rests(-0.9 * alpha)?
    };
}

fn rests(rho: f64, p: f64, psi: f64) -> Known<bool> {
    Ok(matches!(
        fate(&Start::polar(rho, p, psi)?)?,
        Fate::Rest { .. }
    ))
}

/// The σ at which the term of (143) with the constant goes as this power of α.
fn power_of_the_constant(power: f64) -> Known {
    let sigma = root(|sigma: f64| 1.0 + eq143_exponent(sigma) - power, 0.1, 0.9)?;
    Ok(libm::round(1e6 * sigma) / 1e6)
}

/// ψ and the rest, a little after a start.
fn soon(rho: f64, p: f64, psi: f64) -> Known<turntable::Moment> {
    Ok(turntable::TurntableProblem::Polar { rho, p, psi }
        .at(1e-2)?
        .best)
}

/// p/τ² of one escape, at moments of the last two decades.
fn late_speeds() -> Known<Vec<(f64, f64)>> {
    let start = Start::hyperbolic(1.5, 0.3, 1.0)?;
    let speeds = tried((0..40).map(|i| {
        let tau = libm::exp10(6.0 + f64::from(i) / 20.0);
        Ok((tau, Run::new(&start, tau)?.end().p() / (tau * tau)))
    }))?;
    known(speeds.collect())
}

/// How many decimals are right of what is right to so much.
fn decimals(off: f64) -> f64 {
    libm::floor(1e-9 - libm::log10(off))
}

/// A place in units of μg/Ω² after the time 2/Ω, of a start that is given in these units.
fn turning(mu: f64, x: f64) -> Known {
    let table = Table {
        omega: 2.0 + mu,
        mu,
        g: 10.0,
        mass: 0.1,
    };
    let length = table.length();
    let start = State {
        t: 0.0,
        x: [x * length, 0.2 * length],
        v: [0.1, -0.3].map(|v| v * length * table.omega),
    };
    let until = 2.0 / table.omega;
    Ok(rotating::run(&table, &start, until)?.at(until)?.x[0] / length)
}
