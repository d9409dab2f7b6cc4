//! Tasks as data: a scene in words, how it is run, and what is asked of it.

use super::{Answer, ExamError};
use crate::numerics::error::plain;
use crate::scene::{Doing, Moment, Moved, Scene, SceneError, Second, Until};
use serde::Serialize;

/// In s: how long a body lies still on a level floor before t = 0, for the contacts of an engine to settle.
pub const SETTLE: f64 = 0.5;

/// A word of a scene and its text.
pub type Word = (&'static str, String);

/// A question about a scene, all in SI units.
#[derive(Debug, Clone, Copy)]
pub struct Posed {
    /// The body, and [`WORDS`](crate::scene::WORDS) with their texts: `block mu=0.5 throw=2`. In a text, `{}` stands for the number
    /// that is looked for.
    pub scene: &'static str,
    /// Asked about is this last part of the time, in s; all of it, if none.
    pub window: Option<f64>,
    /// The number that is looked for, if the answer is one.
    pub scan: Option<Scan>,
    /// What is asked.
    pub ask: Ask,
    pub grid: Option<Grid>,
}

/// A search for the number at which what is asked passes a level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Scan {
    /// On one side of the level,
    pub from: f64,
    /// and on the other.
    pub to: f64,
    /// What is asked is more than this on one side only.
    pub level: f64,
    /// How closely it can be found, in double precision.
    pub within: f64,
    /// The unit of the number.
    pub unit: &'static str,
}

/// What is asked, at the end or in the window before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Ask {
    /// The time of the end.
    T,
    /// The place along x; in a window, how far it moves there.
    X,
    /// The velocity along y.
    VY,
    /// The natural logarithm of that.
    LnVY,
    /// The distance from the origin.
    Distance,
    /// The length of the path.
    Path,
    /// The heat of friction on each kilogram; in a window, that of it.
    Heat,
    /// The mean velocity along x in the window.
    MeanVX,
    /// The share of the window in which it is at rest on the floor.
    Rest,
    /// The share of the window in which it moves against x.
    Back,
    /// When, from the beginning of the window, it turns from moving against x to moving along x.
    Turn,
    /// The letters of what it does in the window, beginning with the first F that begins there: F along x, B against it, R rest.
    Order,
}

/// Scenes that differ in a few words.
#[derive(Debug, Clone, Copy)]
pub struct Grid {
    /// Names of the numbers in which they differ.
    pub names: &'static [&'static str],
    points: fn() -> Vec<Vec<f64>>,
    words: fn(&[f64]) -> Vec<Word>,
}

/// A scene of a grid, and its answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// The numbers, in the order of their names.
    pub at: Vec<f64>,
    /// The words that stand in place of those of the scene.
    pub words: Vec<Word>,
    /// The answer.
    pub answer: Answer,
    /// By the error that [`Scene::answer`] states; none of an order.
    pub interval: Option<[f64; 2]>,
}

/// A question with a grid of answers that is none of [`TASKS`](super::TASKS).
#[derive(Debug)]
pub struct Field {
    /// Name, unique among the tasks too.
    pub id: &'static str,
    /// The question.
    pub question: &'static str,
    /// The scene with the first numbers of the grid.
    pub posed: Posed,
}

/// What maintainers of engines ask first.
pub static FIELDS: [Field; 2] = [
    Field {
        id: "ramp",
        question: "How far has a block come from rest, one second after the floor is tilted? Ratio is the slope over mu: below 1 \
                   friction holds it.",
        posed: Posed {
            grid: Some(Grid {
                names: &["mu", "ratio"],
                points: || product(&MU, &[0.5, 0.9, 0.99, 1.01, 1.1, 2.0]),
                words: |c| words([("mu", c[0]), ("tilt", libm::atan(c[0] * c[1]))]),
            }),
            ..Posed::of(
                "block mu=0.05 g=9.81 tilt=0.02499479361892016 until=time=1",
                Ask::Distance,
            )
        },
    },
    Field {
        id: "stopping-distance",
        question: "How far does a block slide?",
        posed: Posed {
            grid: Some(Grid {
                names: &["mu", "speed"],
                points: || product(&MU, &SPEEDS),
                words: |c| words([("mu", c[0]), ("throw", c[1])]),
            }),
            ..Posed::of("block mu=0.05 g=9.81 throw=0.5 until=stop", Ask::Path)
        },
    },
];

const MU: [f64; 5] = [0.05, 0.1, 0.2, 0.5, 1.0];
const SPEEDS: [f64; 5] = [0.5, 1.0, 2.0, 5.0, 10.0];

/// Below what friction holds.
pub(super) const HELD: Grid = Grid {
    names: &["mu", "ratio"],
    points: || product(&MU, &[0.5, 0.9, 0.95, 0.99]),
    words: |c| words([("mu", c[0]), ("pull", c[0] * c[1])]),
};

/// Under a pull of 1, by the direction of the start.
pub(super) const THROWN: Grid = Grid {
    names: &["mu", "angle"],
    points: || {
        let angles = [0.0, 0.25, 0.5, 0.75, 1.0].map(|half| half * std::f64::consts::PI);
        product(&[1.1, 1.5, 2.0, 3.0], &angles)
    },
    words: |c| vec![("mu", plain(c[0])), ("throw", format!("1@{}", plain(c[1])))],
};

/// Without spin.
pub(super) const BOWLED: Grid = Grid {
    names: &["mu", "speed"],
    points: || product(&MU, &SPEEDS),
    words: |c| words([("mu", c[0]), ("throw", c[1])]),
};

/// q and λ₀ of the ratchet: on either side of the borders, in the corners between them and beyond the point Y.
pub(super) const TEN_POINTS: [[f64; 2]; 10] = [
    [1.5, 0.3],
    [1.5, 0.55],
    [1.5, 0.65],
    [2.0, 0.45],
    [2.0, 0.48],
    [3.0, 0.2],
    [3.0, 0.32],
    [3.0, 0.5],
    [6.0, 0.1],
    [6.0, 0.165],
];

pub(super) const TEN: Grid = Grid {
    names: &["q", "lambda0"],
    points: || TEN_POINTS.map(Vec::from).to_vec(),
    words: |c| words([("mu", c[1]), ("mu-back", c[0] * c[1])]),
};

/// A pull sin t along x, of whose thirty periods the last is asked.
macro_rules! repeated {
    ($words:literal, $ask:expr) => {
        Posed {
            window: Some(std::f64::consts::TAU),
            ..Posed::of(
                concat!("block pull=sin(t) until=time=188.49555921538757 ", $words),
                $ask,
            )
        }
    };
}
pub(super) use repeated;

fn product(first: &[f64], second: &[f64]) -> Vec<Vec<f64>> {
    let row = |a: &f64| second.iter().map(|b| vec![*a, *b]).collect::<Vec<_>>();
    first.iter().flat_map(row).collect()
}

fn words<const N: usize>(all: [(&'static str, f64); N]) -> Vec<Word> {
    all.map(|(name, x)| (name, plain(x))).to_vec()
}

impl Ask {
    /// Its SI unit; 1 for a share or a logarithm, empty for an order.
    pub fn unit(self) -> &'static str {
        match self {
            Self::T | Self::Turn => "s",
            Self::X | Self::Distance | Self::Path => "m",
            Self::VY | Self::MeanVX => "m/s",
            Self::Heat => "J/kg",
            Self::LnVY | Self::Rest | Self::Back => "1",
            Self::Order => "",
        }
    }
}

impl Posed {
    pub(super) const fn of(scene: &'static str, ask: Ask) -> Self {
        Self {
            scene,
            window: None,
            scan: None,
            ask,
            grid: None,
        }
    }

    /// The unit of the answer.
    pub fn unit(&self) -> &'static str {
        self.scan.map_or(self.ask.unit(), |scan| scan.unit)
    }

    /// The body, and the words of its scene with their texts.
    pub fn words(&self) -> (&'static str, Vec<(&'static str, &'static str)>) {
        let (body, words) = self.scene.split_once(' ').unwrap_or((self.scene, ""));
        let words = words.split(' ');
        let pair = |word: &'static str| word.split_once('=').unwrap_or((word, ""));
        (body, words.map(pair).collect())
    }

    fn scene(&self, with: &[Word], number: f64) -> Result<(Scene, Until), SceneError> {
        let (body, words) = self.words();
        let words = words.into_iter().map(|(name, text)| {
            let other = with.iter().find(|(other, _)| *other == name);
            let text = other.map_or(text, |(_, text)| text);
            (name, text.replace("{}", &plain(number)))
        });
        let words: Vec<_> = words.collect();
        let words = words.iter().map(|(name, text)| (*name, text.as_str()));
        Scene::read(body, words, |file| Err(SceneError::Word(file.to_owned())))
    }

    /// The answer as the scene gives it, run as is said.
    ///
    /// Cost: one run; of a scan, some 45.
    ///
    /// # Errors
    /// [`ExamError`] for a scene that cannot be run, or in which what is asked about does not happen.
    pub fn run(&self) -> Result<Answer, ExamError> {
        if self.ask == Ask::Order {
            let orders: Result<Vec<_>, _> = self
                .cells()?
                .into_iter()
                .map(|cell| match cell.answer {
                    Answer::Order(order) => Ok(order),
                    Answer::Number(_) => Err(ExamError::Missing("an order")),
                })
                .collect();
            return Ok(Answer::Order(orders?.join(" ")));
        }
        let measured = |number| {
            let (scene, until) = self.scene(&[], number)?;
            self.measured(&scene.run(until)?)
        };
        let Some(Scan {
            from,
            to,
            level,
            within,
            ..
        }) = self.scan
        else {
            return Ok(Answer::Number(measured(f64::NAN)?));
        };
        let (mut low, mut high) = (from, to);
        let begin = measured(low)? > level;
        if (measured(high)? > level) == begin {
            return Err(ExamError::Missing("a passing of the level"));
        }
        while (high - low).abs() > within {
            let middle = 0.5 * (low + high);
            match (measured(middle)? > level) == begin {
                true => low = middle,
                false => high = middle,
            }
        }
        Ok(Answer::Number(0.5 * (low + high)))
    }

    /// The scenes of the grid with their answers; none where there is no grid.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn cells(&self) -> Result<Vec<Cell>, ExamError> {
        let Some(grid) = self.grid else {
            return Ok(Vec::new());
        };
        let cell = |at: Vec<f64>| {
            let words = (grid.words)(&at);
            let (scene, until) = self.scene(&words, f64::NAN)?;
            let (answer, interval) = if self.ask == Ask::Order {
                (Answer::Order(self.order(&scene.run(until)?)?), None)
            } else {
                let known = scene.answer(until)?;
                let error = |name| {
                    let mut numbers = known.numbers.iter();
                    numbers
                        .find(|number| number.name == name)
                        .map_or(f64::INFINITY, |number| number.error)
                };
                let error = match self.ask {
                    Ask::T => error("t"),
                    Ask::Path => error("path"),
                    Ask::Distance => libm::hypot(error("x"), error("y")),
                    _ => f64::INFINITY,
                };
                let x = self.measured(&known.moved)?;
                (Answer::Number(x), Some(super::around(x, error)))
            };
            Ok(Cell {
                at,
                words,
                answer,
                interval,
            })
        };
        (grid.points)().into_iter().map(cell).collect()
    }

    fn ends(&self, moved: &Moved) -> Result<[Moment; 2], SceneError> {
        let end = moved.end()?;
        let begin = match self.window {
            Some(window) => moved.at(Second(end.t.0 - window))?,
            None => moved.start()?,
        };
        Ok([begin, end])
    }

    fn measured(&self, moved: &Moved) -> Result<f64, ExamError> {
        let [begin, end] = self.ends(moved)?;
        let [from, to] = [begin.t.0, end.t.0];
        let way = end.place[0].0
            - if self.window.is_some() {
                begin.place[0].0
            } else {
                0.0
            };
        let share = |letter| {
            let parts = parts(moved, from)?
                .into_iter()
                .filter(|part| part.letter == letter);
            let length = parts.map(|part| (part.to.min(to) - part.from.max(from)).max(0.0));
            Ok::<_, SceneError>(length.sum::<f64>() / (to - from))
        };
        Ok(match self.ask {
            Ask::T => to,
            Ask::X => way,
            Ask::VY => end.velocity[1].0,
            Ask::LnVY => libm::log(end.velocity[1].0),
            Ask::Distance => libm::hypot(end.place[0].0, end.place[1].0),
            Ask::Path => end.way.0,
            Ask::Heat => end.heat.0 - begin.heat.0,
            Ask::MeanVX => way / (to - from),
            Ask::Rest => share('R')?,
            Ask::Back => share('B')?,
            Ask::Turn => {
                let parts = parts(moved, from)?;
                let mut turns = parts.windows(2).filter(|pair| {
                    pair[0].letter == 'B' && pair[1].letter == 'F' && pair[1].from >= from
                });
                let turn = turns.next().ok_or(ExamError::Missing("a turn"))?;
                turn[1].from - from
            }
            Ask::Order => return Err(ExamError::Missing("a number")),
        })
    }

    fn order(&self, moved: &Moved) -> Result<String, ExamError> {
        let from = self.ends(moved)?[0].t.0;
        let parts = parts(moved, from)?
            .into_iter()
            .filter(|part| part.from >= from);
        let letters: String = parts.map(|part| part.letter).collect();
        let first = letters
            .find('F')
            .ok_or(ExamError::Missing("a motion forward"))?;
        let (before, from) = letters.split_at(first);
        Ok(format!("{from}{before}"))
    }
}

struct Part {
    from: f64,
    to: f64,
    letter: char,
}

/// Those that do not end before it: to look at one costs a way through all of the motion.
fn parts(moved: &Moved, since: f64) -> Result<Vec<Part>, SceneError> {
    let mut events = moved.events();
    let before = events.iter().rposition(|event| event.t.0 < since);
    events.drain(..before.unwrap_or(0).saturating_sub(1));
    let end = moved.end()?.t.0;
    let ends = events.iter().skip(1).map(|event| event.t.0).chain([end]);
    let part = |(event, to): (&crate::scene::Event, f64)| {
        let from = event.t.0;
        let letter = match event.doing {
            Doing::Rests => 'R',
            _ if moved.at(Second(0.5 * (from + to)))?.velocity[0].0 < 0.0 => 'B',
            _ => 'F',
        };
        Ok(Part { from, to, letter })
    };
    events.iter().zip(ends).map(part).collect()
}
