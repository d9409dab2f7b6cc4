//! A scene as words: a name and a text each, the same on the command line, in JSON, in a link and from Python.

use super::{
    Body, Metre, MetrePerSecond, MetrePerSecond2, Part, Radian, RadianPerSecond, Scene, SceneError,
    Start, Units, Until, apart, check, directed, unit_vector,
};
use crate::{Columns, Fitted, numerics::expression::expression};
use std::str::FromStr;

/// A word: its name, what stands for its text, and what it means.
#[derive(Debug, Clone, Copy)]
pub struct Word {
    /// Its name.
    pub name: &'static str,
    /// What its text is made of; none for a word that stands alone.
    pub text: &'static str,
    /// What it means.
    pub help: &'static str,
}

macro_rules! words {
    ($($name:literal $text:literal $help:literal;)*) => {
        /// All words. Those about pulls may be there several times: they add.
        pub const WORDS: &[Word] = &[$(Word { name: $name, text: $text, help: $help }),*];
    };
}

words! {
    "mu" "NUMBER" "The coefficient μ of sliding friction";
    "mu-s" "NUMBER" "The coefficient up to which friction holds what is at rest, or rolls [default: μ]";
    "mu-back" "NUMBER" "The coefficient of a block that slides against x, where it is another; all then happens along x";
    "g" "ACCELERATION" "The acceleration of gravity [default: 9.80665m/s^2]";
    "radius" "LENGTH" "The radius of a ball";
    "kappa" "NUMBER" "κ = I/(mR²) of a ball: 2/3 if it is hollow [default: 0.4, solid]";
    "tilt" "ANGLE[@DIRECTION]" "The floor is tilted by this angle, down towards the direction";
    "pull" "SIZE[:DURATION],…[@DIRECTION]" "A pull on each kilogram of the body, piece after piece; a size may be an expression of t in s: 4*sin(10*pi*t)m/s^2";
    "accelerate" "SIZE[:DURATION],…[@DIRECTION]" "The floor accelerates so, which pulls the body the other way";
    "record" "FILE" "The floor accelerates as in this recording, a text of columns";
    "columns" "NAME=COLUMN,…" "Columns of the recording, by their heads or numbers from 1: time, x, y; unit and time-unit are their units; gaps=bridge goes on over gaps";
    "towards" "DIRECTION" "Where the recording's x points [default: 0]";
    "turn" "ANGULAR VELOCITY" "The floor is a table that turns counterclockwise about the origin, clockwise if negative";
    "belt" "SPEED[@DIRECTION]" "The floor moves so through the room, as a belt does";
    "at" "X[,Y] or DISTANCE@DIRECTION" "The place of the start [default: the origin]";
    "throw" "SPEED[@DIRECTION]" "The velocity of the start, relative to the floor [default: at rest]";
    "throw-in-room" "SPEED[@DIRECTION]" "The same relative to the room, on a belt or a table";
    "set-down" "" "It is at rest in the room when it comes down on a belt or a table";
    "spin" "X,Y,Z" "The angular velocity of a ball; z points up";
    "units" "mu g, mu g Omega or mu g R" "Plain numbers are in units in which μg is 1 and a time, the table's turning or the ball's radius is, and so is what is answered";
    "width" "DURATION" "The shortest pulse of a pull that is an expression [default: a thousandth of the time]";
    "within" "DURATION" "The longest time for which an end is looked for [default: 3600s]";
    "until" "stop, rolling, rest, TIME, LENGTH or beyond=LENGTH" "The end, with its unit, or time=2, path=1.81: the first stop, rolling, the rest that nothing ends any more, a time, a length of the path, a distance from the start or the table's axis [default: stop, or rolling]";
}

fn number(name: &'static str, text: &str) -> Result<f64, SceneError> {
    let number = expression(text, |digits| digits.parse().ok());
    let why = match number {
        Ok(number) if !text.trim_end().ends_with("deg") => return Ok(number),
        Ok(_) => "it has no unit".to_owned(),
        Err(error) => error.to_string(),
    };
    let text = text.to_owned();
    Err(SceneError::Quantity {
        what: name,
        text,
        why,
    })
}

fn vector<T: FromStr<Err = SceneError>>(
    text: &str,
    of: fn(T) -> f64,
    to: fn(f64) -> T,
) -> Result<[T; 2], SceneError> {
    let (size, angle) = directed(text)?;
    let size = of(size.parse()?);
    Ok(unit_vector(angle).map(|c| to(c * size)))
}

fn velocity(text: &str) -> Result<[MetrePerSecond; 2], SceneError> {
    vector(text, |v: MetrePerSecond| v.0, MetrePerSecond)
}

impl FromStr for Units {
    type Err = SceneError;

    fn from_str(text: &str) -> Result<Self, SceneError> {
        Ok(match text {
            "mu g" => Self::Time,
            "mu g Omega" => Self::Turning,
            "mu g R" => Self::Radius,
            _ => {
                return Err(SceneError::Together("units are mu g, mu g Omega or mu g R"));
            }
        })
    }
}

impl FromStr for Until {
    type Err = SceneError;

    fn from_str(text: &str) -> Result<Self, SceneError> {
        Ok(match text.split_once('=') {
            Some(("beyond", far)) => Self::Beyond(far.parse()?),
            Some(("path" | "way", way)) => Self::Way(way.parse()?),
            Some(("time", time)) => Self::Time(time.parse()?),
            _ => match (text, text.parse(), text.parse()) {
                ("stop" | "rolling", ..) => Self::Stop,
                ("rest", ..) => Self::Rest,
                (_, Ok(time), Err(_)) => Self::Time(time),
                (_, Err(_), Ok(way)) => Self::Way(way),
                _ => {
                    return Err(SceneError::Quantity {
                        what: "an end",
                        text: text.to_owned(),
                        why: "stop, rolling, rest, or a time or a length with its unit, as in 2s, 1.81m or beyond=30cm; of a plain number time=2 or path=1.81 says what it is"
                            .to_owned(),
                    });
                }
            },
        })
    }
}

impl Scene {
    /// A scene and its end from words: `block` or `ball`, and names of [`WORDS`] with their texts. `open` reads a recording.
    ///
    /// # Errors
    /// [`SceneError`] for a word that is none, or whose text is none of its kind, and for words that do not go together.
    pub fn read<'a>(
        body: &str,
        words: impl IntoIterator<Item = (&'a str, &'a str)>,
        open: impl Fn(&str) -> Result<String, SceneError>,
    ) -> Result<(Self, Until), SceneError> {
        let mut scene = Self::block(0.0);
        let (mut mu, mut g) = (None, false);
        let (mut radius, mut kappa, mut until) = (None, None, Until::Stop);
        let (mut record, mut columns, mut towards) = (None, Columns::default(), Radian(0.0));
        let (mut belt, mut thrown, mut mu_s) = (None, None, None);
        let (mut within, mut sized, mut rolling) = (None, Vec::new(), false);
        for (name, text) in words {
            if !["units", "columns", "record"].contains(&name) {
                sized.push(text);
            }
            match name {
                "mu" => mu = Some(number("a coefficient of friction", text)?),
                "mu-s" => mu_s = Some(number("a coefficient of friction", text)?),
                "mu-back" => scene.back = Some(number("a coefficient of friction", text)?),
                "g" => (scene.g, g) = (text.parse()?, true),
                "radius" => radius = Some(text.parse::<Metre>()?),
                "kappa" => kappa = Some(number("κ", text)?),
                "tilt" => {
                    let (angle, down) = directed(text)?;
                    scene.tilt = [angle.parse()?, Radian(down)];
                }
                "pull" => scene.frame.push(Part::pull(text)?),
                "accelerate" => scene.frame.push(Part::accelerate(text)?),
                "record" => record = Some(open(text)?),
                "columns" => columns = self::columns(text)?,
                "towards" => towards = text.parse()?,
                "turn" => scene.turning = Some(text.parse::<RadianPerSecond>()?),
                "belt" => belt = Some(velocity(text)?),
                "at" => {
                    scene.start.place = match text.split_once(',') {
                        Some((x, y)) => [x.parse()?, y.parse()?],
                        None => vector(text, |x: Metre| x.0, Metre)?,
                    };
                }
                "throw" | "throw-in-room" | "set-down" => {
                    if thrown.is_some() {
                        return Err(SceneError::Together(
                            "only one of throw, throw-in-room and set-down says how it starts",
                        ));
                    }
                    thrown = Some((name, if name == "set-down" { "0" } else { text }));
                }
                "spin" => {
                    let parts: Vec<_> =
                        text.split(',').map(str::parse).collect::<Result<_, _>>()?;
                    let three = <[RadianPerSecond; 3]>::try_from(parts);
                    scene.start.spin = three
                        .map_err(|_| SceneError::Together("spin has three components: X,Y,Z"))?;
                }
                "units" => scene.units = text.parse()?,
                "width" => scene.width = Some(text.parse()?),
                "within" => within = Some(text.parse()?),
                "until" => (until, rolling) = (text.parse()?, text == "rolling"),
                _ => return Err(SceneError::Word(name.to_owned())),
            }
        }
        if scene.units != Units::Si {
            if mu.is_some() || g {
                return Err(SceneError::Together(
                    "where μg is the unit, mu and g are not given",
                ));
            }
            let turned = scene.turning.is_some_and(|turning| turning.0.abs() != 1.0);
            let sized_otherwise = radius.is_some_and(|radius| radius != Metre(1.0));
            if scene.units == Units::Turning && turned
                || scene.units == Units::Radius && sized_otherwise
            {
                return Err(SceneError::Together(
                    "where Ω is the unit, turn is 1 or -1, and where R is, radius is 1",
                ));
            }
            if let Some(text) = sized.iter().find(|text| has_unit(text)) {
                return Err(SceneError::Quantity {
                    what: "a plain number",
                    text: (*text).to_owned(),
                    why: "what is in SI is asked for without --units".to_owned(),
                });
            }
            (mu, scene.g) = (Some(1.0), MetrePerSecond2(1.0));
            if scene.units == Units::Turning {
                scene.turning = scene.turning.or(Some(RadianPerSecond(1.0)));
            }
            if scene.units == Units::Radius {
                radius = radius.or(Some(Metre(1.0)));
            }
        }
        scene.mu = mu.ok_or(SceneError::Together(
            "mu, the coefficient of friction, is missing",
        ))?;
        scene.holding = mu_s.unwrap_or(0.0);
        let least = scene.mu.max(scene.back.unwrap_or(0.0));
        let fit = mu_s.is_none_or(|mu_s| mu_s >= least);
        check("mu-s", scene.holding, fit, "at least mu, and mu-back")?;
        scene.body = match (body, radius) {
            ("block", None) if kappa.is_none() => Body::Block,
            ("block", _) => return Err(SceneError::Together("radius and kappa are of a ball")),
            ("ball", Some(radius)) => Body::Ball {
                radius,
                kappa: kappa.unwrap_or(0.4),
            },
            ("ball", None) => return Err(SceneError::Together("a ball needs its radius")),
            _ => return Err(SceneError::Word(body.to_owned())),
        };
        if rolling && scene.body == Body::Block {
            return Err(SceneError::Together("only a ball comes to rolling"));
        }
        if scene.width.is_some() && !scene.frame.iter().any(Part::varies) {
            return Err(SceneError::Together(
                "width is of a pull that is an expression of t",
            ));
        }
        if within.is_some() && matches!(until, Until::Time(_)) {
            return Err(SceneError::Together(
                "within is how long an end is looked for, and a time comes by itself",
            ));
        }
        scene.within = within.unwrap_or(scene.within);
        if record.is_none() && (columns != Columns::default() || towards.0 != 0.0) {
            return Err(SceneError::Together(
                "columns and towards are of a recording",
            ));
        }
        let in_room = thrown.is_some_and(|(name, _)| name != "throw");
        if in_room && belt.is_none() && scene.turning.is_none() {
            return Err(SceneError::Together(
                "throw-in-room and set-down are onto a belt or a table",
            ));
        }
        let belt = belt.unwrap_or([MetrePerSecond(0.0); 2]);
        if belt != [MetrePerSecond(0.0); 2] && (!in_room || scene.turning.is_some()) {
            return Err(SceneError::Together(
                "a belt, which is no table, counts with throw-in-room or set-down: all else is relative to it",
            ));
        }
        if let Some(text) = record {
            let fitted = Fitted::from_csv_with(&text, &columns)?;
            scene.frame.push(Part::record(fitted, towards));
        }
        if let Some((_, text)) = thrown {
            let moved = velocity(text)?;
            scene.start = Start {
                velocity: [0, 1]
                    .map(|i| MetrePerSecond(moved[i].0 - if in_room { belt[i].0 } else { 0.0 })),
                in_room: in_room && scene.turning.is_some(),
                ..scene.start
            };
        }
        Ok((scene, until))
    }
}

/// Angles may.
fn has_unit(text: &str) -> bool {
    let parts = text.split([',', ':', '@', '=']);
    let units = parts
        .map(apart)
        .filter(|(number, _)| !number.trim().is_empty());
    units.into_iter().any(|(_, unit)| {
        unit.trim() != "rad"
            && unit
                .trim()
                .starts_with(|c: char| c.is_alphabetic() || c == '°')
    })
}

/// The columns of a recording that are named, as in `time=t,x=accel_x,unit=g`; `gaps=bridge` goes on over gaps.
///
/// # Errors
/// [`SceneError::Together`] for a choice that is none.
pub fn columns(text: &str) -> Result<Columns<'_>, SceneError> {
    let mut columns = Columns::default();
    for choice in text.split(',') {
        let column = choice
            .split_once('=')
            .map(|(name, column)| (name.trim(), Some(column.trim())));
        match column {
            Some(("time", column)) => columns.time = column,
            Some(("x", column)) => columns.x = column,
            Some(("y", column)) => columns.y = column,
            Some(("z", column)) => columns.z = column,
            Some(("gaps", Some("bridge"))) => columns.gaps = true,
            Some(("unit", unit)) => columns.unit = unit,
            Some(("time-unit", unit)) => columns.time_unit = unit,
            _ => {
                return Err(SceneError::Together(
                    "columns are chosen as in time=t,x=accel_x,y=accel_y,unit=g,time-unit=ms",
                ));
            }
        }
    }
    Ok(columns)
}
