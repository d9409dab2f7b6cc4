//! The workloads on which others are measured as well: `cargo bench -p slipbook-benches --bench workloads`. `benches/peers` has
//! the same work with other tools.

use criterion::{BenchmarkGroup, Criterion, Throughput, measurement::WallTime};
use rayon::prelude::*;
use slipbook::claims::constant::exact::{EQ11, EQ12, EQ13, EQ14};
use slipbook::motion::{
    drive::{Attractor, Drive, DriveState, Friction, Sign},
    turntable::ensemble::{End, Horizon},
    turntable::intrinsic::Run,
    turntable::{Fate, Start, fate},
};
use slipbook::numerics::quadrature::integral;
use slipbook::paper::constant::eq13_time;
use slipbook::validated::numbers::{LAMBDA_C, Q_Y};
use slipbook_benches::{Arcs, Column, Row};
use std::hint::black_box;
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;
use trialbook::trials::points::Points;

type Failure = Box<dyn std::error::Error>;

const COLD: &str = "SLIPBOOK_BENCH_COLD";
const COMMAND: &str = "SLIPBOOK_BENCH_COMMAND";

fn main() -> ExitCode {
    if std::env::var_os(COLD).is_some() {
        return ExitCode::from(u8::from(!four()));
    }
    if std::env::var_os(COMMAND).is_some() {
        return slipbook::cli::run(&slipbook::edition::EDITION);
    }
    match measure_all() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}

fn measure_all() -> Result<(), Failure> {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3))
        .configure_from_args();
    turntable(&mut criterion)?;
    census(&mut criterion)?;
    digits(&mut criterion)?;
    quadrature(&mut criterion)?;
    proofs(&mut criterion)?;
    everything(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}

fn group<'a>(c: &'a mut Criterion, name: &str, items: usize) -> BenchmarkGroup<'a, WallTime> {
    let mut group = c.benchmark_group(name);
    group.throughput(Throughput::Elements(items as u64));
    group
}

/// Starts at ρ = 0.5 on a square grid of velocities, to rest, ρ = 100 or τ = 50.
fn turntable(c: &mut Criterion) -> Result<(), Failure> {
    let horizon = Horizon {
        rho: 100.0,
        tau: 50.0,
    };
    for side in [32, 100, 316, 1000] {
        let at = |i: usize| -1.5 + 3.0 * (i as f64 + 0.5) / side as f64;
        let starts: Vec<Start> = (0..side * side)
            .map(|k| Start::cartesian([0.5, 0.0], [at(k % side), at(k / side)]))
            .collect::<Result<_, _>>()?;
        if side == 316 {
            ends_against_single(&horizon, &starts)?;
        }
        let mut group = group(c, "w1-turntable", starts.len());
        group.bench_function(format!("one core, {}", starts.len()), |b| {
            b.iter(|| horizon.follow_alone(black_box(&starts)));
        });
        group.bench_function(format!("all cores, {}", starts.len()), |b| {
            b.iter(|| horizon.follow(black_box(&starts)));
        });
    }
    Ok(())
}

/// Followed one by one with series of a higher order and sums with a carry.
fn ends_against_single(horizon: &Horizon, starts: &[Start]) -> Result<(), Failure> {
    let sample: Vec<Start> = starts.iter().step_by(487).copied().collect();
    let (mut radius, mut time, mut mismatch) = (0.0_f64, 0.0_f64, 0);
    for (start, end) in sample.iter().zip(horizon.follow_alone(&sample)?) {
        match (end?, fate(start)?) {
            (End::Rest { sigma, .. }, Fate::Rest { sigma: exact, .. }) => {
                radius = radius.max((sigma / exact - 1.0).abs());
            }
            (End::Far { tau, .. }, Fate::Escape { .. }) => {
                let run = Run::new(start, tau)?;
                let (before, there) = (run.at(tau * (1.0 - 1e-6))?.rho(), run.end().rho());
                let slope = (there - before) / (1e-6 * tau);
                time = time.max(((there - horizon.rho) / slope / tau).abs());
            }
            _ => mismatch += 1,
        }
    }
    println!(
        "w1-turntable, accuracy on {}: radius {radius:.1e}, time {time:.1e}, {mismatch} mismatches",
        sample.len()
    );
    Ok(())
}

const SIDE: usize = 1000;

/// At every pixel of 1 < q < 7, 0 < λ₀ < 1, by simulation and by the formulas.
fn census(c: &mut Criterion) -> Result<(), Failure> {
    let q = |i: usize| 1.0 + 6.0 * (i as f64 + 0.5) / SIDE as f64;
    let lambda = |j: usize| (j as f64 + 0.5) / SIDE as f64;
    let frictions: Vec<Friction> = (0..SIDE * SIDE)
        .map(|k| {
            let lambda = lambda(k / SIDE);
            Friction::new(lambda, q(k % SIDE) * lambda)
        })
        .collect::<Result<_, _>>()?;
    let drive = Drive::new(libm::sin, &[])?;
    let start = DriveState { phi: 0.0, w: 0.0 };
    let motion = |friction: &Friction| {
        let outcome = drive.attractor(*friction, start, 100);
        outcome.ok().and_then(|outcome| outcome.settled())
    };
    let intervals = |friction| motion(friction).map_or(0, |a| a.intervals().len());
    let mut worst = 0.0_f64;
    for friction in frictions.iter().step_by(997) {
        let attractor = motion(friction).ok_or("a motion that does not settle")?;
        worst = worst.max(miss(&attractor));
    }
    println!("w2-census, accuracy on 1000: ends of the intervals to {worst:.1e}");
    let mut group = group(c, "w2-census", frictions.len());
    group.bench_function("one core", |b| {
        b.iter(|| frictions.iter().map(intervals).sum::<usize>());
    });
    group.bench_function("all cores", |b| {
        b.iter(|| frictions.par_iter().map(intervals).sum::<usize>());
    });
    let columns: Vec<Column> = (0..SIDE)
        .map(|i| Column::new(q(i)))
        .collect::<Result<_, _>>()?;
    let mut arcs = Vec::with_capacity(SIDE);
    let mut by_formula = |each: &mut dyn FnMut(usize, &[Arcs])| -> Result<(), Failure> {
        for j in 0..SIDE {
            arcs.clear();
            Row::new(lambda(j))?.fill(&columns, &mut arcs);
            each(j, &arcs);
        }
        Ok(())
    };
    let mut worst = 0.0_f64;
    by_formula(&mut |j, arcs| {
        let pixels = frictions[j * SIDE..].iter().zip(arcs);
        worst = pixels.fold(worst, |worst, (f, arcs)| worst.max(missed(f, arcs)));
    })?;
    println!("w2-formula, accuracy on all: ends of the intervals to {worst:.1e}");
    group.finish();
    let mut group = self::group(c, "w2-formula", frictions.len());
    group.bench_function("one core", |b| {
        b.iter(|| {
            by_formula(&mut |_, arcs| {
                black_box(arcs);
            })
        });
    });
    Ok(())
}

/// By how much interval ends miss the zeros of w, from ∫sin in closed form and the slope there.
fn miss(attractor: &Attractor<'_>) -> f64 {
    let friction = attractor.friction();
    let list = attractor.intervals();
    list.iter()
        .map(|i| end_missed(&friction, i.sign, i.start, i.end))
        .fold(0.0, f64::max)
}

fn missed(friction: &Friction, arcs: &Arcs) -> f64 {
    let of = |sign, [start, end]: [f64; 2]| {
        if start < end {
            end_missed(friction, sign, start, end)
        } else {
            0.0
        }
    };
    of(Sign::Positive, arcs.forward).max(of(Sign::Negative, arcs.backward))
}

fn end_missed(friction: &Friction, sign: Sign, start: f64, end: f64) -> f64 {
    let level = match sign {
        Sign::Positive => friction.plus(),
        Sign::Negative => -friction.minus(),
        Sign::Rest => return 0.0,
    };
    let gained = libm::cos(start) - libm::cos(end) - level * (end - start);
    (gained / (libm::sin(end) - level)).abs()
}

/// To be read, they would have to be right in all places.
fn digits(c: &mut Criterion) -> Result<(), Failure> {
    let mut group = group(c, "w3-digits", 1);
    for (name, value) in [("q-Y", Q_Y), ("lambda-c", LAMBDA_C)] {
        for digits in [50, 1000] {
            println!(
                "w3-digits, accuracy: {name} is certain to {}",
                value.decimal(digits)?.len() - 2
            );
            group.bench_function(format!("{name}, {digits}"), |b| {
                b.iter(|| value.ball(black_box(digits)));
            });
        }
    }
    Ok(())
}

/// The time from θ₀ to θ by (13), and by quadrature of dt in x = ln tan(θ/2), which is smooth.
fn quadrature(c: &mut Criterion) -> Result<(), Failure> {
    let mut points = Points::here();
    let mut draw = |_| {
        let (lambda, theta0) = (points.uniform(0.1, 3.0), points.uniform(0.2, 3.0));
        let theta = theta0 * points.uniform(0.05, 1.0);
        [
            lambda,
            theta0,
            theta,
            points.uniform(0.5, 2.0),
            points.uniform(0.5, 2.0),
        ]
    };
    let list: Vec<[f64; 5]> = (0..20_000).map(&mut draw).collect();
    let by_quadrature = |&[lambda, theta0, theta, v0, a]: &[f64; 5]| {
        let [x0, x] = [theta0, theta].map(|angle| libm::log(libm::tan(angle / 2.0)));
        // v = v₀ sin θ₀/sin θ eˡ⁽ˣ⁻ˣ⁰⁾, dθ = sin θ dx and A dt = −v dθ/sin θ, with 1/sin θ = cosh x.
        let speed = |x: f64| libm::cosh(x) * libm::exp(lambda * (x - x0));
        integral(speed, x, x0).map(|found| v0 * libm::sin(theta0) * found.value / a)
    };
    let mut worst = 0.0_f64;
    for point in list.iter().step_by(20) {
        worst = worst.max((by_quadrature(point)? / stable(point) - 1.0).abs());
    }
    println!("w4-quadrature, accuracy on 1000: {worst:.1e}");
    let mut group = group(c, "w4-quadrature", list.len());
    group.bench_function("integrals", |b| {
        b.iter(|| {
            list.iter()
                .filter_map(|p| by_quadrature(p).ok())
                .sum::<f64>()
        });
    });
    group.bench_function("formula (13)", |b| {
        let time =
            |&[lambda, theta0, theta, v0, a]: &[f64; 5]| eq13_time(lambda, a, v0, theta0, theta);
        b.iter(|| list.iter().map(time).sum::<f64>());
    });
    Ok(())
}

/// As a sum of two integrals of powers, without cancellation.
fn stable(&[lambda, theta0, theta, v0, a]: &[f64; 5]) -> f64 {
    let u0 = libm::tan(theta0 / 2.0);
    let s = libm::log1p(
        libm::sin((theta - theta0) / 2.0) / (libm::cos(theta / 2.0) * libm::sin(theta0 / 2.0)),
    );
    let power = |k: f64| {
        if k == 0.0 {
            -s
        } else {
            -libm::expm1(k * s) / k
        }
    };
    v0 * libm::sin(theta0) / (2.0 * a) * (power(lambda - 1.0) / u0 + power(lambda + 1.0) * u0)
}

/// The identities behind (11) to (14).
fn four() -> bool {
    let laws = [EQ11, EQ12, EQ13, EQ14];
    laws.iter().all(|law| law.proof().holds())
}

fn proofs(c: &mut Criterion) -> Result<(), Failure> {
    let program = std::env::current_exe()?;
    let mut group = group(c, "w5-proofs", 4);
    group.bench_function("in this process", |b| b.iter(four));
    group.bench_function("from a cold start", |b| {
        b.iter(|| Command::new(&program).env(COLD, "1").status());
    });
    Ok(())
}

fn everything(c: &mut Criterion) -> Result<(), Failure> {
    let (program, folder) = (std::env::current_exe()?, tempfile::tempdir()?);
    let mut group = group(c, "w6-everything", 1);
    group.bench_function("main job", |b| {
        b.iter(|| {
            Command::new(&program)
                .env(COMMAND, "1")
                .arg("--out")
                .arg(folder.path().join("book"))
                .stdout(Stdio::null())
                .status()
        });
    });
    Ok(())
}
