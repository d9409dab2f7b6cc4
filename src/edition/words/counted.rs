//! What the pages count: of the code, of records, and of what a page itself shows.

use super::told::text;
use super::{Known, found, words};
use crate::claims::{PAPER, edges::CORNERS, formulas::formulas};
use crate::edition::{physics, speed};
use crate::figures::RECORD as DIGITS;
use crate::motion::{
    sphere::Ball,
    turntable::{Start, intrinsic},
};
use crate::solve::VERSION;
use std::collections::{BTreeMap, BTreeSet};
use trialbook::notation::number;
use trialbook::publishing::Word;
use trialbook::seeded::Corner;

words! {
    "times-asked" => {
        let mut asked = BTreeMap::new();
        for [calculator, _, _, cases] in digits() {
            *asked.entry(calculator).or_insert(0.0) += cases.parse::<f64>()?;
        }
        alike(asked.into_values())?
    };
    "most-digits" => {
        let claimed = digits().filter_map(|[_, claimed, ..]| claimed.parse::<usize>().ok());
        found(claimed.max())?
    };
    "too-strong" => slip("too strong")?;
    "too-early" => slip("too early")?;
    "corner-width" => CORNERS.iter().filter(|corner| corner.letter == "λ₀").map(|corner| corner.high - corner.low).fold(0.0, f64::max);
    "corner-of-friction" => found(CORNERS.iter().find(|corner| corner.letter == "μ"))?.low;
    "corner-above" => edge(|corner| corner.high.is_infinite().then_some(corner.low))?;
    "corner-below" => edge(|corner| (corner.low == 0.0).then_some(corner.high))?;
    "general-statements" => PAPER.claims().filter(|(topic, claim)| topic.stem == "general" && claim.equation.is_none()).count();
    "tasks-printed" => found(behind("exam", "slipbook exam --json > exam.json\nslipbook exam ")?.lines().next())?.split(' ').count();
    "steps-to-rest" => {
        let starts = [0.3, 0.6, 0.9, 1.2, 1.5].map(|a| Start::hyperbolic(a, 0.3, 1.0));
        let steps = starts.map(|start| Known::Ok(intrinsic::Run::new(&start?, 100.0)?.nodes().count()));
        let mut steps = steps.into_iter().collect::<Known<Vec<_>>>()?;
        steps.sort_unstable();
        10.0 * libm::round(steps[2] as f64 / 10.0)
    };
    "starts-at-least" => speed::starts()?[0];
    "starts-at-most" => speed::starts()?[1];
    "arguments-of-the-law" => arguments(&["eq107_p_rate", "eq108_rho_rate", "eq109_psi_rate"])?;
    // Beside the phase.
    "arguments-of-the-ratchet" => arguments(&["eq51_rate", "eq52_rate"])? - 1;
    // Held by `tests/suite/prose/files.rs`, as the package has not these files.
    "equations-of-the-stone" => 2.0;
    "equations-of-drag" => 6.0;
    "decimals-of-mpmath" => 1000.0;
    "commands-for-a-paper" => {
        let (steps, _) = found(text("own")?.split_once("## Break it"))?;
        let blocks = steps.split("```text").skip(1).filter_map(|block| block.split("```").next());
        blocks.flat_map(str::lines).filter(|line| line.starts_with("cargo ") || line.starts_with("cd ")).count()
    };
    "numbers-of-a-range" => leading(found(behind("json", "in the place of a number, `")?.split(':').nth(2))?)?;
    "parts-of-a-shard" => leading(found(behind("json", "`--shard ")?.split_once('/'))?.1)?;
    "version-of-the-fields" => f64::from(VERSION);
    "lengths-of-phase" => {
        let section = found(behind("json", "{#solve-anisotropic}")?.split("\n## ").next())?;
        section.matches("| number | length of ").count()
    };
    "components-of-a-spin" => Ball { t: 0.0, x: [0.0; 2], v: [0.0; 2], omega: [0.0; 3] }.omega.len();
    "borders" => text("anisotropic")?.matches("{#curve-").count();
}

/// Calculator, digits claimed, digits true, cases.
fn digits() -> impl Iterator<Item = [&'static str; 4]> {
    let rows = DIGITS.as_str().lines().skip(1);
    rows.filter_map(|row| row.split(',').collect::<Vec<_>>().try_into().ok())
}

fn alike(mut all: impl Iterator<Item = f64>) -> Known {
    let first = found(all.next())?;
    found(all.all(|other| other == first).then_some(first))
}

/// One part in how many the least of these mistakes in the physics is, as what follows it ends so.
fn slip(end: &str) -> Known {
    let parts = physics::RECORD.as_str().split("a part in ").skip(1);
    let mistakes = parts.filter_map(|part| {
        let (size, after) = part.split_once(' ')?;
        number(&[size]).filter(|_| after.starts_with(end))
    });
    found(mistakes.reduce(f64::min))
}

/// What the corners of α and of β have alike.
fn edge(of: fn(&Corner) -> Option<f64>) -> Known {
    let corners = CORNERS
        .iter()
        .filter(|corner| ["α", "β"].contains(&corner.letter));
    alike(corners.filter_map(of))
}

/// What stands behind these words of a page.
fn behind(page: &str, words: &str) -> Known<&'static str> {
    Ok(found(text(page)?.split_once(words))?.1)
}

/// The whole number that a text begins with.
fn leading(text: &str) -> Known {
    let digits = text.split(|c: char| !c.is_ascii_digit()).next();
    Ok(found(digits)?.parse()?)
}

/// How many different arguments these formulas have.
fn arguments(of: &[&str]) -> Known<usize> {
    let all = formulas::<f64>();
    let own: Vec<_> = all
        .iter()
        .filter(|formula| of.contains(&formula.name))
        .collect();
    let arguments: BTreeSet<_> = own.iter().flat_map(|formula| formula.arguments).collect();
    found((own.len() == of.len()).then_some(arguments.len()))
}
