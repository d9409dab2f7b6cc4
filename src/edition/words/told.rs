//! The pages on how it is known.

use super::{Known, found, words};
use crate::edition::pages::WRITTEN;
use crate::evidence::{Compared, Evidence, Kind, Route, Subject, Tolerance};
use crate::ledger::{Verdict, judge};
use crate::solve::Double;
use std::f64::consts::PI;
use std::panic::Location;
use trialbook::publishing::Word;

words! {
    // Of an interval as long above as below.
    "digits-certain" => libm::floor(-libm::log10(2.0 * margin()?));
    "critical-margin" => margin()?;
    "radii-from" => enclosed(1)?[0];
    "radii-to" => enclosed(1)?[2];
    "speeds-from" => enclosed(2)?[0];
    "speeds-to" => enclosed(2)?[2];
    "new-results" => headings("new")?;
    "questions-beyond" => headings("beyond")?;
    "digits-of-two" => libm::floor((parts() * f64::MANTISSA_DIGITS as usize) as f64 * libm::log10(2.0));
    "parts-of-two" => parts();
    "routes-needed" => {
        let routes = [Route::Integration, Route::Quadrature, Route::Root, Route::Limit];
        let confirmed = |n: &usize| is_confirmed(&routes[..*n].iter().map(|route| by(*route, None)).collect::<Vec<_>>());
        found((0..=routes.len()).find(confirmed))?
    };
    "differ-and-read-none" => {
        let two = |route, shared: bool| {
            let (here, there) = (Location::caller(), place());
            let second = if shared { here } else { there };
            is_confirmed(&[by(Route::Integration, Some(here)), by(route, Some(second))])
        };
        let neither = !two(Route::Quadrature, true) && !two(Route::Integration, false);
        [neither, two(Route::Quadrature, true) && two(Route::Integration, false)]
    };
    "tangent-of-half" => [decides(libm::tan), decides(libm::cos), decides(libm::sin)];
}

pub(super) fn text(stem: &str) -> Known<&'static str> {
    Ok(&found(WRITTEN.iter().find(|page| page.stem == stem))?.text)
}

fn headings(stem: &str) -> Known<usize> {
    Ok(text(stem)?.matches("\n## ").count())
}

/// How near to the critical radius and speed the proofs come, as the code on the page has it.
fn margin() -> Known {
    let (_, off) = found(text("rest")?.split_once(".abs() > "))?;
    Ok(found(off.split(' ').next())?.parse()?)
}

/// From where to the border, and from where on the other side: of the radii, and then of the speeds.
fn enclosed(which: usize) -> Known<[f64; 4]> {
    let list = found(text("rest")?.split("for ends in ").nth(which))?;
    let list = found(list.split('{').next())?.split(['[', ']', ',', ' ']);
    let numbers: Vec<f64> = list.filter_map(|number| number.parse().ok()).collect();
    found(numbers.try_into().ok())
}

/// How many floating-point numbers the calculators' numbers are made of.
fn parts() -> usize {
    size_of::<Double>() / size_of::<f64>()
}

/// What agrees, by a route, from a motion that is run there.
fn by(route: Route, run: Option<&'static Location<'static>>) -> Evidence {
    const ANY: Tolerance = Tolerance {
        name: "ANY",
        value: 1e-10,
        reason: "whichever",
    };
    let compared = Compared::one("a formula", "the motion");
    Evidence {
        points: 1000,
        worst: 1e-12,
        runs: run.into_iter().collect(),
        ..Evidence::new(route, Subject::Printed, compared, ANY)
    }
}

fn is_confirmed(evidence: &[Evidence]) -> bool {
    judge(Kind::Equation, None, &[], evidence).verdict == Verdict::Confirmed
}

#[track_caller]
fn place() -> &'static Location<'static> {
    Location::caller()
}

/// Whether two angles have the same sine and cosine whenever this function of half of them is the same.
fn decides(of: fn(f64) -> f64) -> bool {
    let angles = || (-12..12).map(|k| 0.1 + f64::from(k) * PI / 6.0);
    let all = || angles().chain(angles().map(|angle| -angle));
    let apart = |of: fn(f64) -> f64, one: f64, other: f64| (of(one) - of(other)).abs();
    all().all(|one| {
        all().all(|other| {
            apart(of, one / 2.0, other / 2.0) >= 1e-9
                || apart(libm::sin, one, other) + apart(libm::cos, one, other) < 1e-6
        })
    })
}
