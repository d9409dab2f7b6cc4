//! A scene: a body on a rough floor, what moves the floor, how the body starts, until when, and what became of it.
//!
//! Directions are those of who stands on the floor, seen from above: x is the angle 0, and angles grow counterclockwise. A pull is
//! what the body feels; a floor that accelerates one way pulls what lies on it the other way, in [`Part::accelerate`].
//!
//! ```text
//!        the truck speeds up                   on its floor
//!   ┌─────────────────────┐             ┌─────────────────────┐
//!   │          ■          │ ═══> front  │   <─── ■  pull      │        ───> x, angle 0
//!   └──O───────────────O──┘             └─────────────────────┘
//!     --accelerate 2m/s^2        =         --pull 2m/s^2@180deg
//! ```
//!
//! ```
//! use slipbook_motion::scene::{MetrePerSecond, Part, Scene, Start, Until};
//!
//! // A trailer brakes with 4.2 m/s² for 4.79 s; its load holds with 0.40 and slides with 0.30.
//! let scene = Scene {
//!     holding: 0.4,
//!     frame: vec![Part::pull("4.2m/s^2:4.79s,0")?],
//!     ..Scene::block(0.3)
//! };
//! let end = scene.run(Until::Stop)?.end()?;
//! assert!((end.way.0 - 20.603).abs() < 1e-3);
//!
//! // Thrown over a floor at rest.
//! let thrown = Scene { start: Start::thrown([MetrePerSecond(6.0), MetrePerSecond(0.0)]), ..Scene::block(0.5) };
//! let stop = thrown.run(Until::Stop)?.end()?;
//! assert!((stop.t.0 - 6.0 / (0.5 * 9.80665)).abs() < 1e-12);
//! # Ok::<(), slipbook_motion::scene::SceneError>(())
//! ```

mod answer;
mod find;
mod frame;
mod moved;
mod quantity;
mod words;

#[cfg(all(test, feature = "trials"))]
mod tests;

pub use answer::{Answer, Number, target};
pub use find::{Found, STEPS, find};
use frame::Floors;
pub use frame::Part;
pub use moved::{Doing, Event, Moment, Moved};
pub use quantity::{
    JoulePerKilogram, Metre, MetrePerSecond, MetrePerSecond2, Radian, RadianPerSecond, Second,
    apart,
};
pub use words::{WORDS, Word, columns};

use crate::{FitError, MotionError};

/// What slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Body {
    /// A block, or a coin, whatever its mass.
    Block,
    /// A ball.
    Ball {
        /// Its radius.
        radius: Metre,
        /// κ = I/(mR²), dimensionless: 2/5 for a solid ball, 2/3 for a hollow one.
        kappa: f64,
    },
}

/// At t = 0 or with the first row of a recording.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Start {
    /// From the origin of the floor: of a table, from its axis.
    pub place: [Metre; 2],
    /// With which velocity.
    pub velocity: [MetrePerSecond; 2],
    /// The angular velocity of a ball; the third axis points up.
    pub spin: [RadianPerSecond; 3],
    /// The velocity is relative to the room in place of the table.
    pub in_room: bool,
}

impl Start {
    /// At rest at the origin.
    pub const REST: Self = Self {
        place: [Metre(0.0); 2],
        velocity: [MetrePerSecond(0.0); 2],
        spin: [RadianPerSecond(0.0); 3],
        in_room: false,
    };

    /// Thrown from the origin, relative to the floor.
    pub const fn thrown(velocity: [MetrePerSecond; 2]) -> Self {
        Self {
            velocity,
            ..Self::REST
        }
    }
}

/// Until when a scene is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Until {
    /// The first stop; of a ball, until it rolls. What lies at rest is followed until it has moved and stopped.
    Stop,
    /// The rest that nothing ends any more.
    Rest,
    /// This time.
    Time(Second),
    /// A path of this length on the floor.
    Way(Metre),
    /// This distance from the start or, on a table, from the axis.
    Beyond(Metre),
}

/// In which units a scene is given and answered; a number with a unit is in SI.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// m, s and their like.
    Si,
    /// μg and a time of one's own.
    Time,
    /// μg and the turning Ω of a table.
    Turning,
    /// μg and the radius R of a ball.
    Radius,
}

impl Units {
    fn name(self, si: &'static str) -> &'static str {
        let [length, time, speed, turning, heat] = match self {
            Self::Si => return si,
            Self::Time => ["μg T²", "T", "μg T", "1/T", "(μg T)²"],
            Self::Turning => ["μg/Ω²", "1/Ω", "μg/Ω", "Ω", "(μg/Ω)²"],
            Self::Radius => ["R", "√(R/(μg))", "√(μgR)", "√(μg/R)", "μgR"],
        };
        match si {
            "m" => length,
            "s" => time,
            "m/s" => speed,
            "rad/s" => turning,
            _ => heat,
        }
    }
}

/// A body, a floor, what moves it, and a start.
#[derive(Debug, Clone)]
pub struct Scene {
    /// What slides.
    pub body: Body,
    /// The coefficient μ of sliding friction, dimensionless.
    pub mu: f64,
    /// μ_s ≥ μ up to which friction holds what is at rest, or rolls; it counts where it is larger than μ the same way.
    pub holding: f64,
    /// Of a block that moves against x, where it is another one; the block moves and is pulled along x alone then.
    pub back: Option<f64>,
    /// The acceleration of gravity.
    pub g: MetrePerSecond2,
    /// How far the floor is tilted, and which way down is.
    pub tilt: [Radian; 2],
    /// What moves the floor: the pulls add.
    pub frame: Vec<Part>,
    /// Or it turns about the origin, counterclockwise seen from above.
    pub turning: Option<RadianPerSecond>,
    /// How the body starts.
    pub start: Start,
    /// The names of the units in which all is given and answered.
    pub units: Units,
    /// The shortest pulse of a pull that is an expression; else a thousandth of the time.
    pub width: Option<Second>,
    /// The longest time for which an end is looked for.
    pub within: Second,
}

impl Scene {
    /// A block at rest on a level floor at rest, with this coefficient of friction.
    pub const fn block(mu: f64) -> Self {
        Self {
            body: Body::Block,
            mu,
            holding: 0.0,
            back: None,
            g: MetrePerSecond2(9.80665),
            tilt: [Radian(0.0); 2],
            frame: Vec::new(),
            turning: None,
            start: Start::REST,
            units: Units::Si,
            width: None,
            within: Second(3600.0),
        }
    }

    /// A solid ball there.
    pub fn ball(mu: f64, radius: Metre) -> Self {
        Self {
            body: Body::Ball { radius, kappa: 0.4 },
            ..Self::block(mu)
        }
    }

    /// The largest deceleration by friction, in m/s².
    pub fn friction(&self) -> f64 {
        self.mu * self.normal()
    }

    fn normal(&self) -> f64 {
        self.g.0 * libm::cos(self.tilt[0].0)
    }

    /// The pull, in m/s², if it is one and the same at all times.
    pub fn steady_pull(&self) -> Option<[f64; 2]> {
        let mut parts = self.frame.iter().map(Part::steady_pull);
        parts.try_fold(self.slope(), |[x, y], part| {
            let [a, b] = part?;
            Some([x + a, y + b])
        })
    }

    fn slope(&self) -> [f64; 2] {
        let [tilt, down] = self.tilt;
        unit_vector(down.0).map(|c| c * self.g.0 * libm::sin(tilt.0))
    }

    /// What becomes of the body.
    ///
    /// Cost: that of [`run`](crate::run), where an end is looked for up to three times over, in times that grow.
    ///
    /// # Errors
    /// [`SceneError`] for a number out of its range, for parts that do not go together, and where there is no such end
    /// [`within`](Self::within) the time.
    pub fn run(&self, until: Until) -> Result<Moved, SceneError> {
        moved::moved(self, until, &Floors::default())
    }
}

/// Why a scene has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A text is no quantity of the kind that is asked for.
    #[error("`{text}` is not {what}: {why}")]
    Quantity {
        /// What it is to be.
        what: &'static str,
        /// What is written.
        text: String,
        /// What is wrong.
        why: String,
    },
    /// A word that is none of a scene.
    #[error("`{0}` is no word of a scene")]
    Word(String),
    /// A recording that cannot be opened.
    #[error("cannot read `{file}`: {why}")]
    Record {
        /// The file.
        file: String,
        /// Why.
        why: String,
    },
    /// Parts that do not go together.
    #[error("{0}")]
    Together(&'static str),
    /// The end that is asked for does not come.
    #[error(
        "{what} does not come within {within}: another end, or a longer time to look for it, may"
    )]
    Never {
        /// The end.
        what: &'static str,
        /// The time that was looked at.
        within: Second,
    },
    /// It rests, but an expression may pull harder again.
    #[error(
        "it rests since {since}, but nobody can tell of an expression whether it pulls harder again: ask until a time, or end it, as in 4*sin(t):20s,0"
    )]
    Unsure {
        /// Since when.
        since: Second,
    },
    /// An expression that jumps.
    #[error(
        "an expression jumps or has a kink near t = {t}: say it in pieces, as in 4:1s,6*t:2s,0"
    )]
    Jump {
        /// Where.
        t: Second,
    },
    /// A motion that cannot be followed, or a number out of its range.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A pull that cannot be made of its text or record.
    #[error(transparent)]
    Fit(#[from] FitError),
}

impl SceneError {
    fn given(name: &'static str, value: f64, range: &'static str) -> Self {
        MotionError::Argument { name, value, range }.into()
    }
}

fn check(name: &'static str, value: f64, fit: bool, range: &'static str) -> Result<(), SceneError> {
    fit.then_some(())
        .ok_or_else(|| SceneError::given(name, value, range))
}

/// A text and the angle behind its `@`: 0 if there is none.
fn directed(text: &str) -> Result<(&str, f64), SceneError> {
    Ok(match text.rsplit_once('@') {
        Some((text, angle)) => (text, angle.parse::<Radian>()?.0),
        None => (text, 0.0),
    })
}

/// The direction of an angle; along an axis, exactly.
fn unit_vector(angle: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(angle);
    [c, s].map(|x| if x.abs() < 1e-15 { 0.0 } else { x })
}
