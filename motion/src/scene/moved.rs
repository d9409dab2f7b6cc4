//! What became of the body of a scene.

use std::rc::Rc;

use super::{
    Body, JoulePerKilogram, Metre, MetrePerSecond, RadianPerSecond, Scene, SceneError, Second,
    Until, check,
    frame::{Floor, Floors, Part},
};
use crate::{
    Acceleration, Friction, Line, Motion, Phase, PhaseKind, State, Track, run,
    sphere::{Ball, BallMotion, Contact, Sphere},
    turntable::{Path, Table, rotating},
};

/// What the body does on the floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doing {
    /// It slides; of a ball, its point of contact does.
    Slides,
    /// It is at rest.
    Rests,
    /// It rolls.
    Rolls,
}

/// When something begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// When.
    pub t: Second,
    /// What.
    pub doing: Doing,
}

/// Where the body is at a time, relative to the floor, and what it has come through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// The time.
    pub t: Second,
    /// The place, in the axes of the floor.
    pub place: [Metre; 2],
    /// The velocity.
    pub velocity: [MetrePerSecond; 2],
    /// The angular velocity, of a ball.
    pub spin: Option<[RadianPerSecond; 3]>,
    /// The length of the path since the start.
    pub way: Metre,
    /// The heat of friction since the start.
    pub heat: JoulePerKilogram,
}

/// A motion up to the end that was asked for.
#[derive(Debug, Clone)]
pub struct Moved {
    followed: Followed,
    from: f64,
    to: f64,
    /// Per kilogram and metre of sliding.
    friction: f64,
    drive_error: f64,
}

#[derive(Debug, Clone)]
enum Followed {
    Block(Motion),
    Line(Line, Motion),
    Ball(BallMotion),
    Table(Path),
}

/// Of a ball that has none.
const LEAST: f64 = 1e-50;
/// An end that does not come is looked for in a time as many times longer.
const LONGER: f64 = 4.0;

pub(super) fn moved(scene: &Scene, until: Until, floors: &Floors) -> Result<Moved, SceneError> {
    let made = Made::new(scene, floors)?;
    let (within, from) = (scene.within.0, made.from);
    check("within", within, within > 0.0, "positive")?;
    if let Until::Time(Second(t)) = until {
        return made.follow(t);
    }
    let speed = libm::hypot(made.velocity[0], made.velocity[1]);
    let stopping = libm::exp2(libm::ceil(libm::log2(speed / scene.friction())) + 1.0);
    let last = (from + within).min(made.known);
    let usual = stopping > 0.0 && stopping < 1e9;
    let mut to = from + if usual { stopping } else { 1.0 };
    loop {
        to = to.min(last);
        let moved = made.follow(to)?;
        if let Some(t) = moved.reached(until, &made)? {
            return Ok(moved.ended(t));
        }
        if to >= made.known {
            return Err(SceneError::Together(
                "the recording is over before that end",
            ));
        }
        if made.at_rest(&moved)?.is_some() {
            return Err(SceneError::Together(
                "it comes to rest for good before that end",
            ));
        }
        if let Some(why) = made.endless(until, &moved)? {
            return Err(SceneError::Together(why));
        }
        if to >= last {
            if let (
                Until::Rest,
                Some(Event {
                    t,
                    doing: Doing::Rests,
                }),
            ) = (until, moved.events().last())
            {
                return Err(SceneError::Unsure { since: *t });
            }
            let what = match until {
                Until::Stop => "a stop",
                Until::Rest => "a rest for good",
                Until::Way(_) => "a path so long",
                Until::Beyond(_) | Until::Time(_) => "a place so far off",
            };
            return Err(SceneError::Never {
                what,
                within: Second(last - from),
            });
        }
        to = from + LONGER * (to - from);
    }
}

struct Made<'a> {
    scene: &'a Scene,
    floors: &'a Floors,
    /// Begin, and the end of what is recorded.
    from: f64,
    known: f64,
    place: [f64; 2],
    velocity: [f64; 2],
    table: Option<Table>,
}

impl<'a> Made<'a> {
    fn new(scene: &'a Scene, floors: &'a Floors) -> Result<Self, SceneError> {
        let Scene {
            body,
            mu,
            holding,
            back,
            g,
            tilt: [tilt, _],
            turning,
            start,
            ..
        } = *scene;
        let positive =
            |name, x: f64| check(name, x, x > 0.0 && x <= 1e50, "positive, at most 1e50");
        let not_negative =
            |name, x: f64| check(name, x, (0.0..=1e50).contains(&x), "between 0 and 1e50");
        not_negative("mu", mu)?;
        not_negative("mu-back", back.unwrap_or(0.0))?;
        not_negative("mu-s", holding)?;
        positive("g", g.0)?;
        check(
            "tilt",
            tilt.0,
            (0.0..std::f64::consts::FRAC_PI_2).contains(&tilt.0),
            "from 0 to less than pi/2 rad, which is 90deg",
        )?;
        let ball = matches!(body, Body::Ball { .. });
        if let Body::Ball { kappa, .. } = body {
            positive("kappa", kappa)?;
        }
        let place = start.place.map(|x| x.0);
        let mut velocity = start.velocity.map(|v| v.0);
        let mut table = None;
        if let Some(turning) = turning {
            if ball || !scene.frame.is_empty() || tilt.0 > 0.0 || back.is_some() {
                return Err(SceneError::Together(
                    "on a table that turns there is a block, and no other pull",
                ));
            }
            let turned = Table {
                omega: turning.0,
                mu,
                g: g.0,
                mass: 1.0,
            };
            if start.in_room {
                let seen = State {
                    t: 0.0,
                    v: velocity,
                    x: place,
                };
                velocity = turned.to_table(&seen).v;
            }
            table = Some(turned);
        }
        if ball && back.is_some() {
            return Err(SceneError::Together("mu-back is of a block"));
        }
        if back.is_some() && !(scene.frame.iter().all(Part::is_along_x) && scene.slope()[1] == 0.0)
        {
            return Err(SceneError::Together(
                "with mu-back all is along x, and so has to be each pull, and the way down; of a recording columns choose x alone: x=2",
            ));
        }
        if !ball && start.spin != [RadianPerSecond(0.0); 3] {
            return Err(SceneError::Together("a spin is of a ball"));
        }
        let [from, known] = Floor::known(&scene.frame);
        Ok(Self {
            scene,
            floors,
            from: if from.is_finite() { from } else { 0.0 },
            known,
            place,
            velocity,
            table,
        })
    }

    /// Where that is certain.
    fn endless(&self, until: Until, moved: &Moved) -> Result<Option<&'static str>, SceneError> {
        if !matches!(until, Until::Stop | Until::Rest) {
            return Ok(None);
        }
        let Scene {
            ref start, back, ..
        } = *self.scene;
        let held = self.held(0.0);
        if let Some(table) = &self.table {
            // (Ωr)² − v² grows while it slides, and it can be held only where Ω²r is at most μ_s g.
            let Moment {
                place, velocity, ..
            } = moved.end()?;
            let [x, y] = place.map(|x| x.0 * table.omega);
            let [v, w] = velocity.map(|v| v.0);
            let energy = x * x + y * y - v * v - w * w;
            let off = energy * table.omega * table.omega > held * held;
            return Ok(off.then_some("it never comes to rest: the table throws it off"));
        }
        let Some(pull) = self.scene.steady_pull().filter(|_| back.is_none()) else {
            return Ok(None);
        };
        let [pull, speed] = [pull, self.velocity].map(|[x, y]| libm::hypot(x, y));
        let (brake, slip, why) = match self.scene.body {
            Body::Block => (
                1.0,
                0.0,
                "it never stops: it is pulled at least as hard as friction brakes",
            ),
            Body::Ball { .. } if until == Until::Rest => return Ok(None),
            Body::Ball { radius, kappa } => {
                let spin = start.spin.iter().map(|w| w.0.abs()).sum::<f64>();
                (
                    1.0 + 1.0 / kappa,
                    spin * radius.0,
                    "it never rolls: it is pulled harder than friction turns it",
                )
            }
        };
        let friction = brake * self.scene.friction();
        // It turns round within that time; the rest of what is pulled so hard never stops.
        let turned = (moved.to - self.from) * (pull + friction) > speed + slip;
        Ok((pull >= friction && (turned || pull + friction == 0.0)).then_some(why))
    }

    fn floor(&self, to: f64) -> Result<Rc<Floor>, SceneError> {
        let usual = (to - self.from) / 1000.0;
        let width = self.scene.width.map_or(usual, |width| width.0);
        self.floors.get(to, || {
            let (frame, slope) = (&self.scene.frame, self.scene.slope());
            Floor::new(frame, slope, [self.from, to], width)
        })
    }

    fn follow(&self, to: f64) -> Result<Moved, SceneError> {
        check("until", to, to >= self.from, "not before the start")?;
        let state = State {
            t: self.from,
            v: self.velocity,
            x: self.place,
        };
        let Scene {
            body,
            mu,
            holding,
            start,
            ..
        } = *self.scene;
        let held = holding.max(mu);
        if let Some(table) = &self.table {
            let path = rotating::run_held(table, held, &state, to)?;
            return Ok(self.moved(Followed::Table(path), to, 0.0));
        }
        let floor = self.floor(to)?;
        let followed = match body {
            Body::Block => {
                let rough = |mu: f64| Friction {
                    kinetic: mu * self.scene.normal(),
                    holding: holding.max(mu) * self.scene.normal(),
                };
                match self.scene.back {
                    None => Followed::Block(run(&*floor, rough(mu), state, to)?),
                    Some(back) => {
                        let (plus, minus) = (rough(mu), rough(back));
                        let line = Line {
                            along: [1.0, 0.0],
                            plus,
                            minus,
                            frequency: 0.0,
                        };
                        Followed::Line(line, line.run(&*floor, state, to)?)
                    }
                }
            }
            Body::Ball {
                radius: Metre(radius),
                kappa,
            } => {
                let sphere = Sphere {
                    mass: 1.0,
                    radius,
                    inertia: kappa * radius * radius,
                    mu: mu.max(LEAST),
                    g: self.scene.normal(),
                };
                let omega = start.spin.map(|w| w.0);
                let ball = Ball {
                    t: self.from,
                    x: self.place,
                    v: self.velocity,
                    omega,
                };
                Followed::Ball(sphere.run_held(held.max(LEAST), &*floor, &ball, to)?)
            }
        };
        Ok(self.moved(followed, to, floor.error()))
    }

    fn moved(&self, followed: Followed, to: f64, drive_error: f64) -> Moved {
        let friction = self.scene.friction();
        Moved {
            followed,
            from: self.from,
            to,
            friction,
            drive_error,
        }
    }

    fn held(&self, x: f64) -> f64 {
        let Scene { mu, back, .. } = *self.scene;
        let mu = back.filter(|_| x < 0.0).unwrap_or(mu);
        self.scene.holding.max(mu) * self.scene.normal()
    }

    fn at_rest(&self, moved: &Moved) -> Result<Option<f64>, SceneError> {
        let since = match moved.events().last() {
            Some(Event {
                t,
                doing: Doing::Rests,
            }) => t.0,
            _ => return Ok(None),
        };
        if self.table.is_some() {
            return Ok(Some(since));
        }
        let pull = self.floor(moved.to)?.steady(moved.to);
        Ok(pull
            .filter(|[x, y]| libm::hypot(*x, *y) <= self.held(*x))
            .map(|_| since))
    }
}

impl Moved {
    /// The moment at the end.
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn end(&self) -> Result<Moment, SceneError> {
        self.at(Second(self.to))
    }

    /// The moment at a time. Cost: once through all of the motion.
    ///
    /// # Errors
    /// [`SceneError::Motion`] for a time before the start or after the end.
    pub fn at(&self, t: Second) -> Result<Moment, SceneError> {
        self.moment(t, &self.tracks()?)
    }

    /// And, of a ball, what its lowest point has slid.
    fn tracks(&self) -> Result<(Track<'_>, Option<Track<'_>>), SceneError> {
        Ok(match &self.followed {
            Followed::Block(motion) | Followed::Line(_, motion) => (motion.track()?, None),
            Followed::Ball(motion) => (motion.track()?, Some(motion.slipped()?)),
            Followed::Table(path) => (path.track()?, None),
        })
    }

    fn moment(
        &self,
        t: Second,
        (way, slipped): &(Track<'_>, Option<Track<'_>>),
    ) -> Result<Moment, SceneError> {
        let Second(time) = t;
        let fit = time >= self.from && time <= self.to;
        check(
            "t",
            time,
            fit,
            "between the start and the end of the motion",
        )?;
        let way = way.at(time)?;
        let slid = slipped.as_ref().map_or(Ok(way), |track| track.at(time))?;
        let mut heat = self.friction * slid;
        let (x, v, spin) = match &self.followed {
            Followed::Block(motion) => {
                let State { x, v, .. } = motion.at(time)?;
                (x, v, None)
            }
            Followed::Line(line, motion) => {
                let State { x, v, .. } = motion.at(time)?;
                let begin = motion.start().x;
                heat = line.heat(way, [0, 1].map(|i| x[i] - begin[i]))?;
                (x, v, None)
            }
            Followed::Ball(motion) => {
                let Ball { x, v, omega, .. } = motion.at(time)?;
                (x, v, Some(omega.map(RadianPerSecond)))
            }
            Followed::Table(path) => {
                let State { x, v, .. } = path.on_table(time)?;
                (x, v, None)
            }
        };
        Ok(Moment {
            t,
            place: x.map(Metre),
            velocity: v.map(MetrePerSecond),
            spin,
            way: Metre(way),
            heat: JoulePerKilogram(heat),
        })
    }

    /// The moment at the start.
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn start(&self) -> Result<Moment, SceneError> {
        self.at(Second(self.from))
    }

    /// Friction lets no two motions part faster than their pulls. Last that error, as a part of friction.
    pub(super) fn by_drive(&self, end: &Moment) -> [f64; 4] {
        let time = end.t.0 - self.from;
        let velocity = std::f64::consts::SQRT_2 * self.drive_error * time;
        let place = 0.5 * velocity * time;
        let part = match self.drive_error {
            0.0 => 0.0,
            error => error / self.friction,
        };
        let rough = match self.followed {
            Followed::Line(..) if end.way.0 > 0.0 => end.heat.0 / end.way.0,
            _ => self.friction,
        };
        [velocity, place, rough * place, part]
    }

    fn ended(self, to: f64) -> Self {
        Self { to, ..self }
    }

    fn reached(&self, until: Until, made: &Made) -> Result<Option<f64>, SceneError> {
        // What never moves has stopped as it starts.
        if until == Until::Stop && made.at_rest(self)? == Some(self.from) {
            return Ok(Some(self.from));
        }
        Ok(match (until, &self.followed) {
            (Until::Stop, Followed::Block(motion) | Followed::Line(_, motion)) => {
                motion.first_stop()
            }
            (Until::Stop, Followed::Table(path)) => path.stops().first().copied(),
            (Until::Stop, Followed::Ball(_)) => {
                let mut events = self.events().into_iter();
                events
                    .find(|event| event.doing == Doing::Rolls)
                    .map(|event| event.t.0)
            }
            (Until::Rest, _) => made.at_rest(self)?,
            (Until::Way(Metre(way)), _) => self.tracks()?.0.when(way)?,
            (Until::Beyond(Metre(far)), _) => {
                let from = if made.table.is_some() {
                    [0.0; 2]
                } else {
                    made.place
                };
                self.tracks()?.0.first_beyond(from, far)?
            }
            (Until::Time(Second(t)), _) => Some(t),
        })
    }

    /// The moments from the start on, `step` apart, and the end.
    ///
    /// # Errors
    /// [`SceneError::Motion`] for a step that is not positive, or makes more than a million.
    pub fn every(&self, step: Second) -> Result<Vec<Moment>, SceneError> {
        let count = (self.to - self.from) / step.0;
        check(
            "every",
            step.0,
            (0.0..=1e6 + 0.5).contains(&count),
            "positive, a millionth of the time or more",
        )?;
        let whole = libm::ceil(count * (1.0 - 1e-12)) as u32;
        let times = (0..whole).map(|k| self.from + f64::from(k) * step.0);
        let tracks = self.tracks()?;
        times
            .chain([self.to])
            .map(|t| self.moment(Second(t), &tracks))
            .collect()
    }

    /// From the start on, every change of what it does; a slide that passes a stop and goes on begins anew.
    pub fn events(&self) -> Vec<Event> {
        let event = |t, doing| Event {
            t: Second(t),
            doing,
        };
        let slid = |phase: &Phase| match phase.kind {
            PhaseKind::Slide => event(phase.from, Doing::Slides),
            PhaseKind::Stick => event(phase.from, Doing::Rests),
        };
        let mut events: Vec<Event> = match &self.followed {
            Followed::Block(motion) | Followed::Line(_, motion) => {
                motion.phases().iter().map(slid).collect()
            }
            Followed::Ball(motion) => {
                let kind = |contact| match contact {
                    Contact::Sliding => Doing::Slides,
                    Contact::Rolling => Doing::Rolls,
                };
                let first = motion
                    .contact(self.from)
                    .map(|contact| event(self.from, kind(contact)));
                let changes = motion
                    .transitions()
                    .iter()
                    .map(|change| event(change.t, kind(change.to)));
                first.into_iter().chain(changes).collect()
            }
            Followed::Table(path) => path.phases().iter().map(slid).collect(),
        };
        events.retain(|event| event.t.0 <= self.to);
        events
    }
}
