//! The turntable: fates per second on one core and on all, a census of a million starts against the printed and the
//! true boundary, and the boundary itself: `cargo bench --bench turntable`.

use rayon::prelude::*;
use slipbook::claims::rest::boundary::is_clear;
use slipbook::corrections::rest as corrected;
use slipbook::motion::MotionError;
use slipbook::motion::turntable::boundary::between;
use slipbook::motion::turntable::{Fate, Start, critical_radius, critical_speed, fate};
use slipbook::paper::rest as printed;
use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;
use trialbook::trials::points::Points;

type Failure = Box<dyn std::error::Error>;

/// A, α, ψ.
type Launch = [f64; 3];

fn launches(stream: u64, count: usize, a: (f64, f64), reach: f64) -> Vec<Launch> {
    let mut points = Points::stream(stream);
    let mut one = |_| {
        [
            points.uniform(a.0, a.1),
            points.uniform(0.0, reach),
            points.uniform(-PI, PI),
        ]
    };
    (0..count).map(&mut one).collect()
}

/// 1 for rest, 0 for escape, nothing where rounding decides.
fn rests(&[a, alpha, psi]: &Launch) -> Option<bool> {
    match Start::hyperbolic(a, alpha, psi).and_then(|start| fate(&start)) {
        Ok(Fate::Rest { .. }) => Some(true),
        Ok(Fate::Escape { .. }) => Some(false),
        _ => None,
    }
}

fn main() -> Result<(), Failure> {
    for count in [10_000, 100_000] {
        let list = launches(650, count, (0.65, 1.02), 0.3);
        let begin = Instant::now();
        let alone = list
            .iter()
            .filter(|l| black_box(rests(l)) == Some(true))
            .count();
        report("one core ", count, begin);
        let begin = Instant::now();
        let together = list
            .par_iter()
            .filter(|l| black_box(rests(l)) == Some(true))
            .count();
        report("all cores", count, begin);
        if alone != together {
            return Err("the two runs differ".into());
        }
    }
    census(
        "near A = 1, α = 0",
        &launches(651, 700_000, (0.65, 1.02), 0.3),
    );
    census("away from it", &launches(652, 300_000, (0.05, 1.2), 1.5));
    boundary()?;
    println!(
        "critical radius, put down at rest in the laboratory: {:.10}",
        critical_radius()?
    );
    println!(
        "critical speed, launched from the axis:              {:.10}",
        critical_speed()?
    );
    Ok(())
}

fn report(cores: &str, count: usize, begin: Instant) {
    let rate = count as f64 / begin.elapsed().as_secs_f64();
    println!(
        "{count} fates, {cores}: {rate:.0} per second, {:.1} µs each",
        1e6 / rate
    );
}

/// Counts who comes to rest, and whom the printed and the true boundary get wrong.
fn census(name: &str, list: &[Launch]) {
    let begin = Instant::now();
    let fates: Vec<_> = list.par_iter().map(rests).collect();
    let seconds = begin.elapsed().as_secs_f64();
    let all = || list.iter().zip(&fates);
    let count = |wanted: &dyn Fn(&Launch, bool) -> bool| {
        all()
            .filter(|(l, rest)| rest.is_some_and(|rest| wanted(l, rest)))
            .count()
    };
    let resting = count(&|_, rest| rest);
    let undecided = fates.iter().filter(|f| f.is_none()).count();
    let by_print = count(&|l, rest| rest != (l[0] < printed::eq147_a(l[1])));
    let beyond = |&[a, alpha, psi]: &Launch| is_clear(a, alpha, psi);
    let by_ours = count(&|l, rest| beyond(l) && rest != (l[0] < corrected::boundary_a(l[1], l[2])));
    let clear = count(&|l, _| beyond(l));
    println!(
        "census {name}: {} starts in {seconds:.1} s; {resting} rest, {undecided} undecided; (147) is wrong for {by_print}; \
         the second-order boundary is wrong for {by_ours} of the {clear} that are farther from it than 6α³",
        list.len()
    );
}

/// The boundary to 10⁻¹⁰ in A for 24 values of ψ over (−π, π]: how far (147) is from it, and the second-order remainder
/// over α³.
fn boundary() -> Result<(), Failure> {
    const ALPHAS: [f64; 6] = [0.3, 0.1, 0.03, 0.01, 0.003, 0.001];
    let begin = Instant::now();
    let angles: Vec<_> = (1..=24).map(|k| PI * (f64::from(k) / 12.0 - 1.0)).collect();
    let row = |&psi: &f64| -> Result<_, MotionError> {
        let mut row = ALPHAS.map(|alpha| [alpha, 0.0]);
        for entry in &mut row {
            let alpha = entry[0];
            let least = (1.0 - 1e-9) * libm::exp(-alpha);
            let start = |a| Start::hyperbolic(a, alpha, psi);
            let a = between(start, least, 1.0 + 1e-9, 1e-10)?;
            let second = (a - corrected::boundary_a(alpha, psi)) / (alpha * alpha * alpha);
            *entry = [a - printed::eq147_a(alpha), second];
        }
        Ok(row)
    };
    let rows = angles.par_iter().map(row).collect::<Result<Vec<_>, _>>()?;
    let seconds = begin.elapsed().as_secs_f64();
    println!(
        "boundary at {} points, to 1e-10 in A, in {seconds:.2} s; [A − second order]/α³ at α = {ALPHAS:?}",
        angles.len() * ALPHAS.len()
    );
    for (psi, row) in angles.iter().zip(&rows) {
        let remainders = row.map(|[_, remainder]| format!("{remainder:>8.3}"));
        println!("ψ = {psi:>7.4}:{}", remainders.concat());
    }
    for (i, alpha) in ALPHAS.iter().enumerate() {
        let largest = |k: usize| rows.iter().map(|row| row[i][k].abs()).fold(0.0, f64::max);
        println!(
            "α = {alpha}: largest |A − (147)| {:.3e}, largest |A − second order|/α³ {:.3}",
            largest(0),
            largest(1)
        );
    }
    Ok(())
}
