use super::*;
use crate::{Fitted, PhaseKind, State, run};

/// Numbers that look random.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
        let x = self.0 ^ (self.0 >> 33);
        (x.wrapping_mul(0xff51_afd7_ed55_8ccd) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    fn normal(&mut self) -> f64 {
        let size = libm::sqrt(-2.0 * libm::log(self.unit().max(1e-300)));
        size * libm::cos(std::f64::consts::TAU * self.unit())
    }
}

/// A recording by a sensor with noise, zeros that are off, and a last digit.
fn record(
    random: &mut Random,
    rate: f64,
    until: f64,
    force: impl Fn(f64) -> [f64; 3],
) -> Recording {
    let noise = 0.01 * libm::exp(random.between(0.0, libm::log(30.0)));
    let digit = [1e-6, 0.01, 0.038][(3.0 * random.unit()) as usize];
    let zeros = [0; 3].map(|_| 0.1 * random.normal());
    let (mut rows, mut normal) = (Vec::new(), Vec::new());
    for k in 0..(until * rate) as u32 {
        let t = f64::from(k) / rate;
        let mut read = force(t);
        for i in 0..3 {
            let value = read[i] + zeros[i] + noise * random.normal();
            read[i] = (value / digit).round() * digit;
        }
        rows.push((t, [read[0], read[1]]));
        normal.push(read[2]);
    }
    let normal = Some(normal);
    Recording { rows, normal }
}

fn rate(random: &mut Random) -> f64 {
    [100.0, 200.0, 500.0][(3.0 * random.unit()) as usize]
}

/// A block on a tray that is shaken in the plane, by the engine; the sensor feels the friction.
fn tray(random: &mut Random) -> (Recording, f64, f64) {
    let mu = random.between(0.15, 0.6);
    let rate = rate(random);
    let (size, across) = (mu * G * random.between(1.3, 2.5), random.between(0.0, 0.4));
    let (frequency, until) = (random.between(5.0, 16.0), random.between(4.0, 8.0));
    let drive = move |t: f64| {
        if (1.0..until).contains(&t) {
            let phase = frequency * (t - 1.0);
            [
                size * libm::sin(phase),
                across * size * libm::sin(1.7 * phase),
            ]
        } else {
            [0.0; 2]
        }
    };
    let end = until + 1.5;
    let plane = Fitted::from_fn(drive, [0.0, end], 0.1, &[1.0, until]).unwrap();
    let motion = run(&plane, mu * G, State::moving([0.0; 2]), end).unwrap();
    let force = |t: f64| {
        let phase = motion
            .phases()
            .iter()
            .find(|phase| phase.from <= t && t < phase.to);
        let state = motion.at(t).unwrap();
        let [x, y] = match phase {
            Some(phase) if phase.kind == PhaseKind::Slide && state.speed() > 0.0 => {
                state.v.map(|v| -mu * G * v / state.speed())
            }
            _ => drive(t),
        };
        [x, y, G]
    };
    (record(random, rate, end, force), mu, mu)
}

/// A phone is pushed some times to and fro, and slides until it stops; `rising` is the part by which μ is greater in the end.
fn pushed(random: &mut Random, rising: f64) -> (Recording, f64, f64) {
    let mu = random.between(0.15, 0.6);
    let rate = rate(random);
    let (push, speed) = (random.between(0.1, 0.3), random.between(1.5, 2.5));
    let slide = speed / (mu * G);
    let period = push + slide + 0.8;
    let force = move |t: f64| {
        let (n, s) = ((t / period).floor(), t % period - 0.5);
        let along = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
        let x = match s {
            s if s < 0.0 => 0.0,
            // The body gets faster by the speed while it is pushed against friction.
            s if s < push => speed / push * (1.0 - libm::cos(std::f64::consts::TAU * s / push)),
            s if s < push + slide => -mu * G * (1.0 + rising * (s - push) / slide),
            _ => 0.0,
        };
        [0.8 * along * x, 0.6 * along * x, G]
    };
    (record(random, rate, 3.0 * period, force), mu, mu)
}

/// A board is raised until a body breaks loose; it slides a while, and a stop catches it.
fn tilted(random: &mut Random) -> (Recording, f64, f64) {
    let mu = random.between(0.15, 0.6);
    let (holding, rate) = (mu * random.between(1.08, 1.5), rate(random));
    let (speed, slide) = (random.between(0.03, 0.1), random.between(0.4, 0.8));
    let steepest = libm::atan(holding);
    let loose = 1.0 + steepest / speed;
    let force = move |t: f64| {
        let slope = (speed * (t - 1.0)).clamp(0.0, steepest);
        let across = G * libm::cos(slope);
        let x = match t - loose {
            s if s < 0.0 => G * libm::sin(slope),
            s if s < slide => mu * across,
            s if s < slide + 0.02 => 40.0,
            _ => G * libm::sin(slope),
        };
        [0.0, x, across]
    };
    (
        record(random, rate, loose + slide + 1.0, force),
        mu,
        holding,
    )
}

/// What is inside with 90 % only has 114 of 120 with a probability of 4 %. Of the μ_s, which are fewer, nine in ten.
#[test]
fn the_truth_lies_inside_in_95_of_100_recordings() {
    let mut random = Random(58);
    let (mut verdicts, mut all) = (0, 0);
    for (name, make) in [
        ("tray", &tray as &dyn Fn(&mut Random) -> _),
        ("pushed", &|random: &mut Random| pushed(random, 0.0)),
        ("tilted", &tilted),
    ] {
        let (mut inside, mut wide, mut held, mut told) = (0, 0, 0, 0);
        for _ in 0..40 {
            let (recording, mu, holding) = make(&mut random);
            let measured = measure(&recording, &Settings::default()).unwrap();
            let Ok(kinetic) = measured.kinetic else {
                continue;
            };
            inside += i32::from(kinetic.from <= mu && mu <= kinetic.to);
            wide += i32::from(kinetic.to - kinetic.from > 0.1 * mu);
            verdicts += i32::from(measured.verdict != Verdict::Fits);
            if let Ok(at) = measured.holding {
                told += 1;
                held += i32::from(at.from <= holding && holding <= at.to);
            }
        }
        println!("{name}: {inside} of 40 inside, {wide} wide; {held} of {told} held");
        all += inside;
        assert!(wide <= 4, "{name}: {wide}");
        assert!(10 * held >= 9 * told, "{name}: {held} of {told}");
        assert!(
            told >= if name == "tilted" { 15 } else { 0 },
            "{name}: {told}"
        );
    }
    assert!(all >= 114, "{all} of 120");
    assert!(verdicts <= 6, "{verdicts} of 120");
}

/// Friction that grows by 30 % while the body slows down, and friction like that of honey.
#[test]
fn friction_that_is_not_coulombs_is_told() {
    let mut random = Random(85);
    let (mut told, mut honey) = (0, 0);
    for _ in 0..20 {
        let (recording, ..) = pushed(&mut random, 0.3);
        let measured = measure(&recording, &Settings::default()).unwrap();
        told += i32::from(measured.verdict != Verdict::Fits);
        let (rate, time) = (rate(&mut random), random.between(0.2, 0.6));
        let viscous = |t: f64| {
            let s = t % 3.0 - 1.0;
            let push = libm::exp(-(s / 0.05).powi(2)) * 15.0;
            let slow = if s > 0.0 {
                -4.0 * libm::exp(-s / time)
            } else {
                0.0
            };
            [push + slow, 0.0, G]
        };
        let recording = record(&mut random, rate, 9.0, viscous);
        let measured = measure(&recording, &Settings::default()).unwrap();
        honey += i32::from(measured.verdict != Verdict::Fits);
    }
    println!("told {told}, honey {honey} of 20");
    assert!(told >= 16 && honey >= 16, "{told} {honey}");
}

/// By hand: f = ±3 m/s² on one side of clipped waves of 5 m/s², nothing but waves on the other.
#[test]
fn waves_are_no_slip_and_clipped_ones_are() {
    let wave = |t: f64| 5.0 * libm::sin(12.0 * t);
    let mut random = Random(1);
    let sticks = record(&mut random, 200.0, 10.0, |t| [wave(t), 0.0, G]);
    let measured = measure(&sticks, &Settings::default()).unwrap();
    assert_eq!(measured.kinetic, Err(Unfound::NoSlip));
    assert_eq!(measured.verdict, Verdict::Untold);
    let slips = record(&mut random, 200.0, 10.0, |t| {
        [wave(t).clamp(-3.0, 3.0), 0.0, G]
    });
    let measured = measure(&slips, &Settings::default()).unwrap();
    let kinetic = measured.kinetic.unwrap();
    assert!(kinetic.from < 3.0 / G && 3.0 / G < kinetic.to && kinetic.to - kinetic.from < 0.02);
    // Without a column along z it is the same on level floor.
    let flat = Recording {
        normal: None,
        ..slips
    };
    let flat = measure(&flat, &Settings::default()).unwrap();
    assert!(!flat.normal && (flat.kinetic.unwrap().from - kinetic.from).abs() < 0.01);
    // A rest, a push, a slip, a rest.
    let push = |t: f64| match t {
        t if (1.0..1.2).contains(&t) => 9.0 * libm::sin(5.0 * std::f64::consts::PI * (t - 1.0)),
        t if (1.2..1.7).contains(&t) => -2.0,
        _ => 0.0,
    };
    let pushed = record(&mut random, 500.0, 3.0, |t| [push(t), 0.0, G]);
    let measured = measure(&pushed, &Settings::default()).unwrap();
    let slip = measured
        .stretches
        .iter()
        .find(|stretch| stretch.kind == Kind::Slip)
        .unwrap();
    assert!((slip.from - 1.2).abs() < 0.02 && (slip.to - 1.7).abs() < 0.02);
    assert!(matches!(measured.holding, Err(Unfound::NeverLoose { .. })));
    let kind = |t: f64| {
        measured
            .stretches
            .iter()
            .find(|s| s.from <= t && t < s.to)
            .map(|s| s.kind)
    };
    assert_eq!(
        [0.5, 1.1, 2.5].map(kind),
        [Kind::Stick, Kind::Pushed, Kind::Stick].map(Some)
    );
    assert!(
        measured
            .stretches
            .windows(2)
            .all(|pair| pair[0].to == pair[1].from)
    );
}

#[test]
fn what_cannot_be_measured_is_refused() {
    let rows = |n: u32| {
        (0..n)
            .map(|k| (f64::from(k), [f64::from(k % 3), 0.0]))
            .collect()
    };
    let of = |rows, normal, settings: Settings| measure(&Recording { rows, normal }, &settings);
    let plain = Settings::default();
    assert!(matches!(
        of(rows(63), None, plain),
        Err(MeasureError::Rows { .. })
    ));
    let mut wrong: Vec<_> = rows(99);
    wrong[70].0 = 69.0;
    assert_eq!(of(wrong, None, plain), Err(MeasureError::Row { row: 71 }));
    assert_eq!(
        of(rows(99), Some(vec![9.8; 98]), plain),
        Err(MeasureError::Row { row: 99 })
    );
    for settings in [
        Settings { g: 0.0, ..plain },
        Settings {
            offset: f64::NAN,
            ..plain
        },
    ] {
        assert!(matches!(
            of(rows(99), None, settings),
            Err(MeasureError::Setting { .. })
        ));
    }
    let settings = Settings {
        rest: Some([200.0, 300.0]),
        ..plain
    };
    assert!(matches!(
        of(rows(99), None, settings),
        Err(MeasureError::Rest { .. })
    ));
}

proptest::proptest! {
    #[test]
    fn any_numbers_are_measured_or_refused(
        values in proptest::collection::vec((-1.0_f64..8.0, -3.0_f64..3.0), 64..300),
        steps in proptest::collection::vec(-9_i32..3, 64..300),
        power in -6_i32..6,
        across in proptest::bool::ANY,
    ) {
        let mut t = 0.0;
        let mut rows = Vec::new();
        for ((step, (x, y)), k) in steps.iter().zip(&values).zip(0..) {
            t += 10.0_f64.powi(*step);
            // Some are flat.
            let x = if k / 20 % 2 == 0 { x.round() } else { 2.0 };
            rows.push((t, [x * 10.0_f64.powi(power), if across { *y } else { 0.0 }]));
        }
        let normal = across.then(|| values[..rows.len()].iter().map(|v| 9.0 + v.1).collect());
        if let Ok(measured) = measure(&Recording { rows, normal }, &Settings::default()) {
            for interval in [measured.kinetic, measured.holding].into_iter().flatten() {
                assert!(interval.from <= interval.to && interval.from >= 0.0);
            }
        }
    }
}
