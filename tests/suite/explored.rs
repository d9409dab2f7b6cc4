//! All that the explorers hand out, against Newton's law in another form, another motion, or a formula of the paper that holds.

use fastrand::Rng;
use slipbook::explorers::{Answer, answer};
use slipbook::motion::{
    Launch,
    drive::{Drive, PlanarState},
    turntable::{Fate, Start, State, Table, fate, inertial},
};
use slipbook::paper;
use std::f64::consts::{PI, SQRT_2, TAU};

const STATES: usize = 12;
const PICTURES: f64 = 480.0;

fn put(number: usize, given: [f64; 4]) -> Answer {
    answer(number, given).unwrap_or_else(|error| panic!("{number} at {given:?}: {error}"))
}

fn slid(from: f64, to: f64, generator: &mut Rng) -> f64 {
    from + (to - from) * f64::from(generator.u32(0..=200)) / 200.0
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: {found}, not {expected}");
}

#[track_caller]
fn near_both(found: [f64; 2], expected: [f64; 2], tolerance: f64, what: &str) {
    for k in 0..2 {
        near(found[k], expected[k], tolerance, what);
    }
}

/// Places are the sum of velocities, by Simpson's rule where the velocity keeps its sign.
#[track_caller]
fn sums(places: &[f64], velocities: &[f64], step: f64, tolerance: f64, what: &str) {
    assert_eq!(places.len(), velocities.len());
    let mut held = 0;
    for i in 2..places.len() {
        let [a, b, c] = [velocities[i - 2], velocities[i - 1], velocities[i]];
        if a * b > 0.0 && b * c > 0.0 || [a, b, c] == [0.0; 3] {
            let gone = step / 3.0 * (a + 4.0 * b + c);
            near(places[i] - places[i - 2], gone, tolerance, what);
            held += 1;
        }
    }
    assert!(held > places.len() / 2, "{what}: {held} places held");
}

fn column(curve: &[[f64; 2]], k: usize) -> Vec<f64> {
    curve.iter().map(|point| point[k]).collect()
}

#[test]
fn a_throw_is_that_of_the_paper() {
    let mut generator = Rng::with_seed(2);
    for _ in 0..STATES {
        // The formulas need an angle off the axis and λ off 1.
        let lambda = slid(0.05, 3.0, &mut generator) + 1e-3;
        let theta = slid(5.0, 175.0, &mut generator) * if generator.bool() { 1.0 } else { -1.0 };
        let given = [lambda, theta, 0.0, 0.0];
        let (shown, film) = (put(0, given), put(7, given));
        let start = theta.to_radians();
        let what = format!("λ = {lambda}, θ₀ = {theta}°");
        let speed = |v: [f64; 2]| {
            let angle = v[1].atan2(v[0]).abs();
            paper::constant::eq11_speed(lambda, 1.0, start.abs(), angle)
        };
        let time = |v: [f64; 2]| {
            let angle = v[1].atan2(v[0]).abs();
            paper::constant::eq13_time(lambda, 1.0, 1.0, start.abs(), angle)
        };
        let rests = lambda > 1.0;
        let end = if rests {
            paper::constant::eq20_stop_time(lambda, 1.0, 1.0, start)
        } else {
            10.0
        };
        let [rest, t, vx, vy, x, y] = shown.values[..] else {
            panic!("{what}: {:?}", shown.values)
        };
        assert_eq!(rest, f64::from(u8::from(rests)), "{what}");
        near(t, end, 1e-9 * end, &what);
        near(film.values[0], end / PICTURES, 1e-10 * end, &what);

        let [velocities, path, marks] = &shown.curves[..] else {
            panic!("{what}: curves")
        };
        let [places, speeds, alike] = &film.curves[..] else {
            panic!("{what}: curves of the film")
        };
        for (i, place) in alike.iter().enumerate() {
            let t = (i as f64 * end / PICTURES).min(1.0 / lambda);
            let way = t - lambda * t * t / 2.0;
            near_both(*place, [way * start.cos(), way * start.sin()], 1e-9, &what);
        }
        assert_eq!(alike.len(), places.len(), "{what}");
        for (curve, of_film) in [(velocities, false), (speeds, true)] {
            near_both(curve[0], [start.cos(), start.sin()], 1e-12, &what);
            for (i, v) in curve.iter().enumerate() {
                let size = v[0].hypot(v[1]);
                // Near the rest the angle has few digits.
                if size < 1e-6 {
                    continue;
                }
                near(size, speed(*v), 1e-7 * size.max(1.0), &what);
                if of_film {
                    near(time(*v), i as f64 * end / PICTURES, 1e-6, &what);
                }
                assert!(v[1] * start >= 0.0, "{what}: {v:?}");
            }
        }
        for k in 0..2 {
            sums(
                &column(places, k),
                &column(speeds, k),
                film.values[0],
                1e-5,
                &what,
            );
        }
        near_both(*places.last().unwrap(), [x, y], 1e-10, &what);
        near_both(*speeds.last().unwrap(), [vx, vy], 1e-10, &what);
        let launch = Launch::new(lambda, 1.0, 1.0, start).unwrap();
        let motion = launch.motion(1.5 * end).unwrap();
        for (v, x) in velocities.iter().zip(path) {
            if v[0].hypot(v[1]) > 1e-3 {
                near_both(motion.at(time(*v).max(0.0)).unwrap().x, *x, 1e-6, &what);
            }
        }
        for (i, x) in marks.iter().enumerate() {
            near_both(motion.at(0.5 * i as f64).unwrap().x, *x, 1e-10, &what);
        }
        assert_eq!(marks.len(), 1 + (2.0 * end) as usize, "{what}");

        let portrait = put(1, given).curves;
        assert_eq!(portrait[0].len(), if rests { 25 } else { 0 });
        for (i, [angle, t]) in portrait[0].iter().enumerate() {
            near(*angle, 7.5 * i as f64, 1e-12, &what);
            let stops = paper::constant::eq20_stop_time(lambda, 1.0, 1.0, angle.to_radians());
            near(*t, stops, 1e-9 * stops, &what);
        }
        for (k, curve) in (1..).zip(&portrait[1..]) {
            let angle = (30.0 * f64::from(k) - 180.0_f64).to_radians();
            near_both(curve[0], [angle.cos(), angle.sin()], 1e-12, &what);
            for v in curve.iter().filter(|v| v[0].hypot(v[1]) > 1e-6) {
                let now = v[1].atan2(v[0]).abs();
                if (0.01..3.13).contains(&now) {
                    let size = paper::constant::eq11_speed(lambda, 1.0, angle.abs(), now);
                    near(v[0].hypot(v[1]), size, 1e-7, &what);
                }
            }
        }
        assert_eq!(portrait.len(), 13);
    }
}

struct Shaken {
    h: Box<dyn Fn(f64) -> f64>,
    sum: Box<dyn Fn(f64) -> f64>,
    twice: Box<dyn Fn(f64) -> f64>,
    /// Where the drive jumps, the velocity has a corner.
    corners: f64,
}

impl Shaken {
    fn new(third: f64) -> Self {
        let plain = move |phi: f64| phi.sin() + third * (3.0 * phi).sin();
        let grid = (0..100_000).map(|i| plain(TAU * f64::from(i) / 1e5).abs());
        let size = grid.fold(0.0, f64::max);
        Shaken {
            h: Box::new(move |phi| plain(phi) / size),
            sum: Box::new(move |phi| -(phi.cos() + third * (3.0 * phi).cos() / 3.0) / size),
            twice: Box::new(move |phi| -(phi.sin() + third * (3.0 * phi).sin() / 9.0) / size),
            corners: 1e-5,
        }
    }

    /// Their sum is added up once more on a grid.
    fn pulses(eta: f64) -> Self {
        const GRID: usize = 200_000;
        let end = eta * PI;
        let sum = move |phi: f64| {
            let phi = phi.rem_euclid(TAU);
            phi.min(end) - (phi - PI).clamp(0.0, end) - 0.5 * end
        };
        let step = TAU / GRID as f64;
        let mut sums = vec![0.0];
        for i in 0..GRID {
            sums.push(sums[i] + step * sum((i as f64 + 0.5) * step));
        }
        let mean = sums[1..].iter().sum::<f64>() / GRID as f64;
        let twice = move |phi: f64| {
            let place = phi.rem_euclid(TAU) / step;
            let (i, part) = (place as usize % GRID, place.fract());
            (1.0 - part) * sums[i] + part * sums[i + 1] - mean
        };
        Shaken {
            h: Box::new(move |phi| match phi.rem_euclid(TAU) {
                phi if phi < end => 1.0,
                phi if PI <= phi && phi < PI + end => -1.0,
                _ => 0.0,
            }),
            sum: Box::new(sum),
            twice: Box::new(twice),
            corners: 5e-4,
        }
    }

    /// Newton's law between two states where the velocity keeps its sign; at rest, friction can hold it.
    fn holds(&self, curve: &[[f64; 2]], friction: [f64; 2], what: &str) {
        let mut held = 0;
        for two in curve.windows(2) {
            let [[a, v], [b, w]] = [two[0], two[1]];
            if v * w > 0.0 {
                let force = if v > 0.0 { -friction[0] } else { friction[1] };
                let gained = (self.sum)(b) - (self.sum)(a) + force * (b - a);
                // It may have turned and come back between two far points.
                if (w - v - gained).abs() > 1e-8 {
                    assert!(v.abs().min(w.abs()) < 2.0 * (b - a), "{what}: {two:?}");
                    continue;
                }
                held += 1;
            } else if v == 0.0 && w == 0.0 {
                // Within the step: a pulse may begin at its end.
                for phi in [a + 1e-9, b - 1e-9] {
                    let h = (self.h)(phi);
                    let most = if h > 0.0 { friction[0] } else { friction[1] };
                    assert!(h.abs() <= most + 1e-7, "{what}: no rest at {phi}, {h}");
                }
                held += 1;
            }
        }
        assert!(10 * held > 8 * curve.len(), "{what}: {held}");
    }

    fn periodic(&self, values: &[f64], curve: &[[f64; 2]], friction: [f64; 2], what: &str) {
        let [mean, largest, rest, count] = values[..4] else {
            panic!("{what}: {values:?}")
        };
        let intervals: Vec<_> = values[4..].chunks(3).collect();
        assert_eq!(intervals.len() as f64, count, "{what}");
        let (mut gone, mut most, mut still) = (0.0, 0.0_f64, 0.0);
        for (i, interval) in intervals.iter().enumerate() {
            let [sign, a, b] = interval[..] else {
                panic!("{what}: {interval:?}")
            };
            let next = intervals[(i + 1) % intervals.len()];
            near((next[1] - b).rem_euclid(TAU), 0.0, 1e-9, what);
            if sign == 0.0 {
                still += b - a;
                continue;
            }
            let force = if sign > 0.0 {
                -friction[0]
            } else {
                friction[1]
            };
            let at = |phi: f64| (self.sum)(phi) - (self.sum)(a) + force * (phi - a);
            near(at(b), 0.0, 1e-7, what);
            gone += (self.twice)(b) - (self.twice)(a) - (self.sum)(a) * (b - a)
                + 0.5 * force * (b - a) * (b - a);
            for k in 1..4000 {
                let w = at(a + (b - a) * f64::from(k) / 4e3);
                assert!(w * sign > -1e-9, "{what}: {sign} from {a} to {b}");
                most = most.max(w.abs());
            }
            let mut seen = 0;
            for [phi, w] in curve {
                let phi = a + (phi - a).rem_euclid(TAU);
                if phi < b {
                    near(*w, at(phi), 1e-7, what);
                    seen += 1;
                }
            }
            assert!(seen > 0 || b - a < 0.1, "{what}");
        }
        near(gone / TAU, mean, 1e-7, what);
        near(most, largest, self.corners, what);
        near(still / TAU, rest, 1e-12, what);
        let total: f64 = intervals.iter().map(|i| i[2] - i[1]).sum();
        near(total, TAU, 1e-9, what);
        for (i, [phi, w]) in curve.iter().enumerate() {
            near(*phi, 4.0 * TAU * i as f64 / 400.0, 1e-9, what);
            near(*w, curve[(i + 100) % 400][1], 1e-9, what);
        }
    }

    fn film(&self, film: &Answer, friction: [f64; 2], start: f64, what: &str) {
        let step = 4.0 * TAU / PICTURES;
        near(film.values[0], step, 1e-12, what);
        let [places, velocities] = &film.curves[..] else {
            panic!("{what}: curves of the film")
        };
        let phases = (0..).map(|i| step * f64::from(i));
        let block: Vec<_> = phases
            .clone()
            .zip(velocities)
            .map(|(phi, v)| [phi, v[1]])
            .collect();
        assert_eq!(block.len(), 481);
        assert_eq!(block[0][1], start);
        self.holds(&block, friction, what);
        let [place, velocity] = [places, velocities].map(|curve| column(curve, 1));
        sums(&place, &velocity, step, self.corners, what);
        for (phi, (place, velocity)) in phases.zip(places.iter().zip(velocities)) {
            near(place[0], -(self.twice)(phi), 1e-6, what);
            near(velocity[0], -(self.sum)(phi), 1e-6, what);
        }
    }
}

#[test]
fn a_block_on_a_tray_obeys_newton() {
    let mut generator = Rng::with_seed(3);
    for _ in 0..STATES {
        let (q, lambda) = (
            slid(1.0, 7.0, &mut generator),
            slid(0.01, 1.2, &mut generator),
        );
        let w = slid(-2.0, 2.0, &mut generator);
        let what = format!("q = {q}, λ₀ = {lambda}, w = {w}");
        let (given, friction) = ([q, lambda, w, 0.0], [lambda, q * lambda]);
        let (sine, Answer { values, curves }) = (Shaken::new(0.0), put(2, given));
        assert_eq!(curves[0][0], [0.0, w]);
        sine.holds(&curves[0], friction, &what);
        sine.periodic(&values[1..], &curves[1], friction, &what);
        sine.film(&put(8, given), friction, w, &what);
        let signs: Vec<_> = values[5..].chunks(3).map(|i| i[0]).collect();
        let region = paper::anisotropic::signs().iter().position(|s| *s == signs);
        assert_eq!(values[0], region.map_or(0.0, |i| i as f64 + 1.0), "{what}");

        let third = slid(0.0, 2.0, &mut generator);
        let eta = slid(0.05, 0.95, &mut generator);
        for (shaken, third, eta) in [
            (Shaken::new(third), third, 0.0),
            (Shaken::pulses(eta), 0.0, eta),
        ] {
            let what = format!("third {third}, η = {eta}, λ₀ = {lambda}, w = {w}");
            let (given, friction) = ([third, lambda, w, eta], [lambda; 2]);
            let Answer { values, curves } = put(11, given);
            assert_eq!(curves[0][0], [0.0, w]);
            shaken.holds(&curves[0], friction, &what);
            shaken.periodic(&values, &curves[1], friction, &what);
            shaken.film(&put(12, given), friction, w, &what);
            assert_eq!(curves[2].len(), 401);
            for (i, [phi, h]) in curves[2].iter().enumerate() {
                near(*phi, 4.0 * TAU * i as f64 / 400.0, 1e-12, &what);
                let beside = [-1e-9, 1e-9].map(|off| (shaken.h)(phi + off));
                let off = beside.map(|one| (h - one).abs());
                near(off[0].min(off[1]), 0.0, 1e-6, &what);
            }
        }
    }
}

#[test]
fn a_coin_moves_as_in_the_laboratory() {
    let mut generator = Rng::with_seed(4);
    let table = Table::default();
    let mut fates = [0, 0];
    for _ in 0..4 * STATES {
        let (rho, u) = (
            slid(0.0, 1.6, &mut generator),
            slid(-2.0, 2.0, &mut generator),
        );
        let v = slid(-2.5, 1.5, &mut generator);
        let what = format!("ρ = {rho}, u = {u}, v = {v}");
        let Answer { values, curves } = put(4, [rho, u, v, 0.0]);
        let [fate, sigma, tau, step] = values[..] else {
            panic!("{what}: {values:?}")
        };
        // The laboratory adds the table's own velocity.
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [u, v + rho],
        };
        let long = inertial::run(&table, &start, 60.0).unwrap();
        let [on_table, here] = &curves[..] else {
            panic!("{what}: curves")
        };
        assert_eq!(on_table.len(), here.len());
        for (i, (seen, here)) in on_table.iter().zip(here).enumerate() {
            let t = i as f64 * step;
            near_both(*here, long.at(t).unwrap().x, 1e-6, &what);
            near_both(*seen, long.on_table(t).unwrap().x, 1e-6, &what);
        }
        let rest = long.resting_place();
        assert_eq!(fate, f64::from(u8::from(rest.is_some())), "{what}");
        let shown = step * (here.len() - 1) as f64;
        if let Some([x, y]) = rest {
            near(sigma, x.hypot(y), 1e-7, &what);
            near(tau, *long.stops().last().unwrap(), 1e-6, &what);
            near(shown, tau + TAU, 1e-9, &what);
            fates[0] += 1;
        } else {
            assert_eq!(sigma, 0.0, "{what}");
            let [x, y] = *here.last().unwrap();
            assert!(
                x.hypot(y) > 6.0 || (shown - tau - 8.0).abs() < 1e-9,
                "{what}"
            );
            fates[1] += 1;
        }
    }
    assert!(fates.iter().all(|count| *count > 10), "{fates:?}");
}

#[test]
fn each_point_of_a_boundary_is_one() {
    let distances = [0.0, 0.25, 0.5, 0.8, 0.95, 1.05, 1.3];
    for (rho, coarse) in distances
        .into_iter()
        .flat_map(|rho| [(rho, 0.0), (rho, 1.0)])
    {
        let curves = put(5, [rho, coarse, 0.0, 0.0]).curves;
        let [boundary, circle] = &curves[..] else {
            panic!("curves at ρ = {rho}")
        };
        let count = boundary.len() as f64;
        let middle = [0, 1].map(|k| column(boundary, k).iter().sum::<f64>() / count);
        let rest = |[u, v]: [f64; 2]| {
            let start = Start::cartesian([rho, 0.0], [u, v]).unwrap();
            matches!(fate(&start).unwrap(), Fate::Rest { .. })
        };
        for point in boundary {
            let away = [0, 1].map(|k| point[k] - middle[k]);
            let beside = |by: f64| {
                let scale = by / away[0].hypot(away[1]);
                [0, 1].map(|k| point[k] + scale * away[k])
            };
            assert!(rest(beside(-5e-3)), "inside {point:?} at ρ = {rho}");
            assert!(!rest(beside(5e-3)), "outside {point:?} at ρ = {rho}");
        }
        let points = if coarse == 0.0 { 97 } else { 49 };
        assert_eq!((boundary.len(), circle.len()), (points, 73));
        for (i, [x, y]) in circle.iter().enumerate() {
            let angle = TAU * i as f64 / 72.0;
            near_both([*x, *y], [angle.cos(), angle.sin()], 1e-12, "the circle");
        }
    }
}

#[test]
fn a_ball_is_pushed_and_turned_by_one_friction() {
    let mut generator = Rng::with_seed(5);
    let sine = Drive::new(libm::sin, &[]).unwrap();
    let mut rolled = 0;
    for _ in 0..STATES {
        let (lambda, kappa) = (
            slid(0.05, 1.5, &mut generator),
            slid(0.05, 0.67, &mut generator),
        );
        let [u, v] = [0; 2].map(|_| slid(-2.0, 2.0, &mut generator));
        let what = format!("λ₀ = {lambda}, κ = {kappa}, slip ({u}, {v})");
        let given = [lambda, kappa, u, v];
        let (Answer { values, curves }, film) = (put(6, given), put(9, given));
        let b = 1.0 + 1.0 / kappa;
        near(values[0], b, 1e-12, &what);
        let rolls: Vec<_> = values[5..].chunks(2).collect();
        assert_eq!(rolls.len() as f64, values[4], "{what}");
        let within = |phi: f64| rolls.iter().any(|r| r[0] <= phi && phi <= r[1]);
        near(values[1], rolls.first().map_or(-1.0, |r| r[0]), 0.0, &what);
        rolled += rolls.len();

        // The slip is the velocity of a particle.
        let phases = column(&curves[0], 0);
        let start = PlanarState {
            phi: 0.0,
            w_x: u,
            ln_w_y: v.abs().ln(),
        };
        let particle = sine.planar(lambda, start, &phases).unwrap();
        let mut rolling = 0.0;
        for (i, (phi, p)) in phases.iter().zip(&particle).enumerate() {
            let slip = curves[2][i];
            near_both(slip, [p.w_x, v.signum() * p.ln_w_y.exp()], 1e-5, &what);
            assert_eq!(curves[0][i], [*phi, slip[0]]);
            let still = slip[0].hypot(slip[1]) < 1e-12;
            assert!(
                !within(*phi) || still && phi.sin().abs() <= lambda + 1e-9,
                "{what} at {phi}"
            );
            // Friction gives the centre its share of the slip's change.
            let centre = u + (1.0 - 1.0 / b) * (1.0 - phi.cos()) + (slip[0] - u) / b;
            near_both(curves[1][i], [*phi, centre], 1e-9, &what);
            if i > 0 && within(0.5 * (phi + phases[i - 1])) && phases[i - 1] >= 3.0 * TAU - 1e-9 {
                rolling += phi - phases[i - 1];
            }
        }
        near(values[2], rolling / TAU, 0.02, &what);
        let last = curves[2].last().unwrap();
        near(values[3], last[0].hypot(last[1]), 1e-12, &what);

        let step = 4.0 * TAU / PICTURES;
        near(film.values[0], step, 1e-12, &what);
        let [places, turning] = &film.curves[..] else {
            panic!("{what}: curves of the film")
        };
        let pictures: Vec<_> = (0..=480).map(|i| step * f64::from(i)).collect();
        let particle = sine.planar(lambda, start, &pictures).unwrap();
        let block = put(13, [lambda, u, v.abs(), 0.0]).curves;
        for (i, phi) in pictures.iter().enumerate() {
            let share = 1.0 - 1.0 / b;
            let gone = share * (u * phi + phi - phi.sin()) + block[0][i][1] / b;
            near_both(places[i], [phi.sin(), gone], 2e-3, &what);
            near(turning[i][1], particle[i].w_x, 1e-5, &what);
            near(turning[i][0], gone - block[0][i][1], 5e-3, &what);
        }
        for (i, x) in curves[3].iter().enumerate() {
            let phi = phases[i];
            let k = (phi / step).round() as usize;
            if (phi - pictures[k]).abs() < 1e-9 {
                let across = (1.0 - 1.0 / b) * v * phi + v.signum() * block[2][k][0] / b;
                near_both(*x, [places[k][1], across], 2e-3, &what);
            }
        }
    }
    assert!(rolled > STATES);
}

#[test]
fn a_block_across_the_stroke_is_that_of_the_ball() {
    let mut generator = Rng::with_seed(6);
    for _ in 0..STATES {
        let lambda = slid(0.06, 1.2, &mut generator);
        let (w, across) = (
            slid(-2.0, 2.0, &mut generator),
            slid(0.01, 2.0, &mut generator),
        );
        let what = format!("λ₀ = {lambda}, along {w}, across {across}");
        let film = put(13, [lambda, w, across, 0.0]);
        let step = 4.0 * TAU / PICTURES;
        near(film.values[0], step, 1e-12, &what);
        let [places, velocities, depths] = &film.curves[..] else {
            panic!("{what}: curves")
        };
        let ball = put(6, [lambda, 0.4, w, across]).curves;
        for (i, (velocity, [_, depth])) in velocities.iter().zip(depths).enumerate() {
            let phi = step * i as f64;
            near(places[i][0], phi.sin(), 1e-12, &what);
            near(velocity[0], phi.cos(), 1e-12, &what);
            let k = ball[0].iter().position(|p| (p[0] - phi).abs() < 1e-9);
            if let Some(k) = k {
                near_both(ball[2][k], [velocity[1], (-depth).exp()], 1e-5, &what);
            }
            assert!(i == 0 || *depth >= depths[i - 1][1], "{what}");
        }
        sums(
            &column(places, 1),
            &column(velocities, 1),
            step,
            2e-3,
            &what,
        );
        let speeds: Vec<_> = depths.iter().map(|[_, depth]| (-depth).exp()).collect();
        sums(&column(depths, 0), &speeds, step, 2e-3, &what);
        let gone = film.values[1];
        for (i, [_, depth]) in depths.iter().enumerate() {
            let phi = step * i as f64;
            assert!(gone < 0.0 || phi < gone || *depth == 1e3, "{what} at {phi}");
        }
    }
}

#[test]
fn a_lost_coin_goes_away_as_in_the_laboratory() {
    for rho in [0.9, 1.0, 1.1, 1.5, 2.0] {
        let curve = &put(10, [rho, 0.0, 0.0, 0.0]).curves[0];
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [0.0; 2],
        };
        let path = inertial::run(&Table::default(), &start, 60.0).unwrap();
        let mut early = 0;
        for (i, [decades, ratio]) in curve.iter().enumerate() {
            near(*decades, 0.5 + 3.5 * i as f64 / 140.0, 1e-12, "decades");
            let tau = 10.0_f64.powf(*decades);
            let what = format!("ρ = {rho}, τ = {tau}");
            if tau <= 60.0 {
                let seen = path.at(tau).unwrap().radius() / (tau * tau);
                near(*ratio, seen, 1e-7 * seen, &what);
                early += 1;
            } else {
                // The start is forgotten as 1/τ.
                let late = 1.0 / (3.0 * SQRT_2);
                near(*ratio, late, 30.0 * late / tau, &what);
            }
        }
        assert_eq!((early, curve.len()), (52, 141));
    }
}
