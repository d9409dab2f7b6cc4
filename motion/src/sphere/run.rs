//! A motion of the sphere, one piece after the other.

use super::{
    super::acceleration::{Acceleration, check_time, most_steps},
    super::creep::creep,
    super::error::finite,
    super::onset::onset,
    Ball, BallMotion, Contact, MotionError, PARTS, Piece, Sphere, Transition, check,
    slide::{Sliding, Work},
};
use crate::numerics::{
    events::{Way, roots},
    series::{arrival, change, square, value},
    taylor::{Coefficients, Control, Integrator, Step, TERMS, reach},
};

/// As a part of the largest contact velocity.
const STOP: f64 = 1e-18;
/// The same where rolling holds what sliding does not: rounding turns it by then.
const STILL: f64 = 1e-12;
/// As a part of the velocities of which it is the sum at the start.
const NONE: f64 = 1e-14;
/// As a part of the other component, before it underflows.
const NEGLIGIBLE: f64 = 1e-90;
/// For the squares of the force needed for rolling and μ_s mg.
const EQUAL: f64 = 1e-13;

struct Run<'a> {
    sphere: &'a Sphere,
    rough: Sphere,
    plane: &'a dyn Acceleration,
    until: f64,
    t: f64,
    parts: [f64; PARTS],
    steps: usize,
    pieces: Vec<Piece>,
    transitions: Vec<Transition>,
    begin: Option<Contact>,
    /// Rolling has just ended: what rounding of the time makes of the pull is nothing.
    released: bool,
}

struct Local {
    a: [Coefficients; 2],
    left: f64,
    landing: Option<f64>,
}

pub(super) fn run(
    sphere: &Sphere,
    holding: f64,
    plane: &dyn Acceleration,
    start: &Ball,
    until: f64,
) -> Result<BallMotion, MotionError> {
    let Ball { t, x, v, omega } = *start;
    for (name, given) in [("t", t), ("until", until)] {
        check(
            name,
            given,
            given.abs() <= 1e50,
            "finite, at most 1e50 in absolute value",
        )?;
    }
    for (name, given) in [("x", x[0]), ("y", x[1]), ("v_x", v[0]), ("v_y", v[1])]
        .into_iter()
        .chain([
            ("omega_x", omega[0]),
            ("omega_y", omega[1]),
            ("omega_z", omega[2]),
        ])
    {
        check(
            name,
            given,
            given.abs() <= 1e50,
            "finite, at most 1e50 in absolute value",
        )?;
    }
    check("until", until, until >= t, "not before the start")?;
    check_time(plane, t).and(check_time(plane, until))?;
    let mut c = sphere.contact(start);
    let size = libm::hypot(v[0], v[1]) + sphere.radius * libm::hypot(omega[0], omega[1]);
    if libm::hypot(c[0], c[1]) <= NONE * size {
        c = [0.0; 2];
    }
    let parts = [
        x[0], x[1], v[0], v[1], omega[0], omega[1], omega[2], c[0], c[1],
    ];
    let mut run = Run {
        sphere,
        rough: Sphere {
            mu: holding,
            ..*sphere
        },
        plane,
        until,
        t,
        parts,
        steps: 0,
        pieces: Vec::new(),
        transitions: Vec::new(),
        begin: None,
        released: false,
    };
    while run.t < until {
        if run.slip() > 0.0 {
            run.enter(Contact::Sliding);
            run.slide()?;
        } else {
            run.leave_rest()?;
        }
    }
    finite(run.t, &run.parts)?;
    let [x, y, u, v, p, q, r, _, _] = run.parts;
    let begin = run.begin.unwrap_or(if run.slip() > 0.0 {
        Contact::Sliding
    } else {
        Contact::Rolling
    });
    Ok(BallMotion {
        pieces: run.pieces,
        transitions: run.transitions,
        begin,
        start: *start,
        slip: c,
        drive_error: plane.error(),
        end: Ball {
            t: until,
            x: [x, y],
            v: [u, v],
            omega: [p, q, r],
        },
    })
}

impl Run<'_> {
    /// |c|.
    fn slip(&self) -> f64 {
        libm::hypot(self.parts[7], self.parts[8])
    }

    /// Sliding that goes on after its first moments is noted once.
    fn enter(&mut self, contact: Contact) {
        match (self.begin, self.transitions.last()) {
            (None, _) => self.begin = Some(contact),
            (Some(_), Some(last)) if last.to == contact && self.slip() > 0.0 => {}
            (Some(begin), None) if begin == contact && self.slip() > 0.0 => {}
            (Some(begin), last) => {
                let rolling = last.map_or(begin, |last| last.to) == Contact::Rolling;
                if !(rolling && contact == Contact::Rolling) {
                    self.transitions.push(Transition {
                        t: self.t,
                        to: contact,
                    });
                }
            }
        }
    }

    fn local(&mut self) -> Result<Local, MotionError> {
        let t = self.t;
        self.steps += 1;
        let limit = most_steps(self.plane);
        if self.steps > limit {
            return Err(MotionError::Steps { limit, t });
        }
        let a = self.plane.coefficients(t);
        for c in a.iter().flatten() {
            check("a Taylor coefficient of A", *c, c.is_finite(), "finite")?;
        }
        let landing = self
            .plane
            .next_break(t)
            .map_or(self.until, |b| b.min(self.until));
        let trusted = reach(&a[0]).min(reach(&a[1]));
        let ends = trusted >= landing - t;
        Ok(Local {
            a,
            left: if ends { landing - t } else { trusted },
            landing: ends.then_some(landing),
        })
    }

    fn slide(&mut self) -> Result<(), MotionError> {
        let mut fastest = 0f64;
        let mut carried = ([0.0; 10], Work::default());
        let limit = self.sphere.yielding(self.sphere.friction());
        // How long the direction may still remember what it was.
        let mut memory = 0.0;
        while self.t < self.until {
            let local = self.local()?;
            fastest = fastest.max(self.slip());
            if memory <= 0.0 {
                let c = [self.parts[7], self.parts[8]];
                match creep(&local.a, limit, c, local.left) {
                    Ok(creep) => {
                        self.slip_by(&local, &creep.velocity, creep.h);
                        if creep.stops {
                            (self.parts[7], self.parts[8]) = (0.0, 0.0);
                            return Ok(());
                        }
                        carried.0 = [0.0; 10];
                        continue;
                    }
                    Err(wait) => memory = wait,
                }
            }
            let sliding = Sliding::new(self.sphere, local.a);
            let mut state = [self.t; 10];
            state[1..].copy_from_slice(&self.parts);
            let mut integrator = Integrator::resume(&sliding, state, carried, Control::Each);
            let mut step = Box::new(Step::empty());
            integrator.expand(&mut step)?;
            step.h = step.h.min(4.0 * local.left / self.slip());
            let mut landing = None;
            if change(&step.series[0], &step.h) >= local.left {
                step.h = arrival(&step.series[0], local.left, step.h);
                landing = local.landing;
            }
            memory -= step.h * libm::hypot(local.a[0][0], local.a[1][0]);
            integrator.advance(&step);
            if let Some(t) = landing {
                integrator.set(0, t);
            }
            (state, carried) = integrator.finish();
            self.t = state[0];
            self.parts.copy_from_slice(&state[1..]);
            self.pieces.push(Piece::Slide { step, to: self.t });
            for (i, j) in [(7, 8), (8, 7)] {
                if self.parts[i].abs() < NEGLIGIBLE * self.parts[j].abs() {
                    self.parts[i] = 0.0;
                }
            }
            let still = self.rough.mu > self.sphere.mu
                && self.slip() <= STILL * fastest
                && libm::hypot(local.a[0][0], local.a[1][0])
                    <= self.sphere.yielding(self.rough.friction());
            if self.slip() <= STOP * fastest || still {
                // Below the rounding of the time that sliding took.
                (self.parts[7], self.parts[8]) = (0.0, 0.0);
                return Ok(());
            }
        }
        Ok(())
    }

    /// Rolls for a while, or begins to slide.
    fn leave_rest(&mut self) -> Result<(), MotionError> {
        let local = self.local()?;
        let give = self.sphere.yielding(1.0);
        let force = local.a.map(|a| a.map(|a| a / give));
        let limit = self.rough.friction() * self.rough.friction();
        let mut excess: Coefficients =
            std::array::from_fn(|k| square(&force[0], k) + square(&force[1], k));
        excess[0] -= limit;
        let released = std::mem::take(&mut self.released);
        if released || excess[0].abs() <= EQUAL * limit {
            excess[0] = 0.0;
        }
        let mut power = 1.0;
        let mut first = 0.0;
        for c in &excess {
            if (c * power).abs() > EQUAL * limit {
                first = *c;
                break;
            }
            power *= local.left;
        }
        if first > 0.0 && excess[0] >= 0.0 {
            self.enter(Contact::Sliding);
            let limit = if released {
                // The pull is what could just be held.
                libm::hypot(local.a[0][0], local.a[1][0]) * (self.sphere.mu / self.rough.mu)
            } else {
                self.sphere.yielding(self.sphere.friction())
            };
            let start = onset(limit, local.left, |m, _| local.a.map(|a| -a[m]))?;
            self.slip_by(&local, &start.velocity, start.h);
            return Ok(());
        }
        self.enter(Contact::Rolling);
        // The square of a series is good for less far than the series.
        let trusted = reach(&excess).min(local.left);
        let release = roots(&excess, trusted)?
            .into_iter()
            .find(|root| root.way == Way::Rising);
        self.released = release.is_some();
        let (h, landing) = match release {
            Some(root) => (root.at, None),
            None if trusted < local.left => (trusted, None),
            None => (local.left, local.landing),
        };
        self.follow(&local.a, &force, &[[0.0; TERMS]; 2], h, landing);
        Ok(())
    }

    /// If that is left, with a contact velocity known by its series.
    fn slip_by(&mut self, local: &Local, c: &[Coefficients; 2], h: f64) {
        let give = self.sphere.yielding(1.0);
        let force = [0, 1].map(|i| {
            std::array::from_fn(|k| {
                let rate = c[i].get(k + 1).map_or(0.0, |next| (k + 1) as f64 * next);
                (rate + local.a[i][k]) / give
            })
        });
        let (h, landing) = if h < local.left {
            (h, None)
        } else {
            (local.left, local.landing)
        };
        self.follow(&local.a, &force, c, h, landing);
    }

    fn follow(
        &mut self,
        a: &[Coefficients; 2],
        force: &[Coefficients; 2],
        c: &[Coefficients; 2],
        h: f64,
        landing: Option<f64>,
    ) {
        let mut series = Box::new([[0.0; TERMS]; PARTS]);
        for (series, now) in series.iter_mut().zip(&self.parts) {
            series[0] = *now;
        }
        for k in 0..TERMS - 1 {
            let (by_force, spin) = self.sphere.response([force[0][k], force[1][k]]);
            let next = (k + 1) as f64;
            for i in 0..2 {
                series[i][k + 1] = series[2 + i][k] / next;
                series[2 + i][k + 1] = (by_force[i] - a[i][k]) / next;
            }
            for i in 0..3 {
                series[4 + i][k + 1] = spin[i] / next;
            }
        }
        (series[7], series[8]) = (c[0], c[1]);
        let from = self.t;
        self.t = landing.unwrap_or(from + h);
        self.parts = std::array::from_fn(|i| value(&series[i], &h));
        self.pieces.push(Piece::Series {
            from,
            to: self.t,
            series,
        });
    }
}
