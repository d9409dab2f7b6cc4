//! `scene`: what becomes of a body on a floor that moves, in everybody's words and units.

use super::{
    Json, axis,
    pieces::{in_pieces, told},
    plot,
    sweep::aligned,
};
use crate::numerics::error::plain;
use crate::scene::{
    Answer, Doing, Found, Moment, Number, Opinion, STEPS, Scene, SceneError, Second, Until, WORDS,
    find, second,
};
use crate::solve::{Curve, head};
use clap::{Arg, ArgAction, ArgMatches, Command};
use rayon::prelude::*;
use serde_json::{Map, Value, json as object};
use std::path::PathBuf;
use trialbook::cli::{VERSION, ascii, complain, csv, screen, show, stop};
use trialbook::publishing::{Failure, Format};

/// Words that are there several times.
const MANY: [&str; 2] = ["pull", "accelerate"];

const ABOUT: &str = "Say what becomes of a block or a ball: thrown, pulled, on a slope, a belt, a table that turns, or a recording

Directions are those of who stands on the floor, seen from above: x is 0, and angles grow counterclockwise. A pull is what the body
feels; a floor that accelerates one way pulls what lies on it the other way:

        the truck speeds up                   on its floor
   ┌─────────────────────┐             ┌─────────────────────┐
   │          ■          │ ═══> front  │   <─── ■  pull      │        ───> x, angle 0
   └──O───────────────O──┘             └─────────────────────┘
     --accelerate 2m/s^2        =         --pull 2m/s^2@180deg

A number has a unit (15cm, 33.3rpm, 36km/h, 120deg, 1g, 2.15m/s^2) or is in SI, and may be an expression. The mass drops out.";

const EXAMPLES: &str = "Examples:
  slipbook scene block --mu 0.5 --throw 6m/s
  slipbook scene block --mu 0.16 --mu-s 0.18 --accelerate 2.15m/s^2 --until 1.81m
  slipbook scene block --mu 0.3 --mu-s 0.4 --pull 4.2m/s^2:4.79s,0 --until rest
  slipbook scene block --mu 0.3 --tilt 10deg --pull '4*sin(10*pi*t)' --until 10s --every 1s
  slipbook scene ball --mu 0.08 --radius 11cm --throw 5m/s --until rolling
  slipbook scene block --mu 0.25 --turn 33.3rpm --at 15cm --throw 0.2m/s@120deg --until rest
  slipbook scene block --mu 0.2 --record phone.csv --columns x=accel_x,unit=g --until 10s --every 10ms --csv
  slipbook scene block --throw 50km/h --find mu=0.01:2 --where path=20m

Exit code 1 where --find finds nothing, 2 where all rows of --vary are refused; of some the note says why. Ctrl-C ends --vary after the present piece of work: the rows so far are whole, the exit code is 130.";

const NO_MASS: &str = "a scene has no --mass: it drops out, and heat is that on each kilogram";

pub(super) fn command() -> Command {
    let body = Arg::new("body")
        .required(true)
        .value_name("BODY")
        .help("`block` or `ball`, or a file with a scene as `--json` writes it");
    let words = WORDS.iter().map(|word| {
        let arg = Arg::new(word.name).long(word.name).help(word.help);
        match word.text {
            "" => arg.action(ArgAction::SetTrue),
            text => {
                let many = if MANY.contains(&word.name) {
                    ArgAction::Append
                } else {
                    ArgAction::Set
                };
                arg.value_name(text).action(many).allow_hyphen_values(true)
            }
        }
    });
    let also = [
        Arg::new("mass").long("mass").hide(true).value_name("MASS"),
        Arg::new("every")
            .long("every")
            .value_name("DURATION")
            .help("A table of moments, this far apart"),
        Arg::new("vary")
            .long("vary")
            .value_name("WORD=LOW:HIGH:COUNT[:log] or WORD=A,B,…")
            .conflicts_with_all(["every", "plot", "find"])
            .help("A row for each of these values of a word"),
        Arg::new("find")
            .long("find")
            .value_name("WORD=LOW:HIGH")
            .requires("where")
            .conflicts_with_all(["every", "plot"])
            .help("The values of a word between these for which --where holds"),
        Arg::new("where")
            .long("where")
            .value_name("QUANTITY=VALUE")
            .requires("find")
            .help("A number of the answer: t, x, y, v_x, v_y, path or heat, and what it is to be"),
        Arg::new("plot")
            .long("plot")
            .value_name("FILE")
            .num_args(0..=1)
            .value_parser(plot::place)
            .help(
                "Plot the path too: into a file of the name FILE.svg, as text if no file is named",
            ),
    ];
    Command::new("scene")
        .about("Say what becomes of a block or a ball: thrown, pulled, on a slope, a belt, a table that turns, or a recording")
        .long_about(ABOUT)
        .after_help(EXAMPLES)
        .arg(body)
        .args(words)
        .args(also)
}

/// A scene as words, in order.
#[derive(Clone)]
struct Words {
    body: String,
    words: Vec<(&'static str, String)>,
}

impl Words {
    /// From the command line, where a file may have the beginning.
    fn given(matches: &ArgMatches) -> Result<Self, Failure> {
        if matches.contains_id("mass") {
            return Err(NO_MASS.into());
        }
        let body = matches
            .get_one::<String>("body")
            .ok_or("a body is missing")?
            .clone();
        let mut all = match body.as_str() {
            "block" | "ball" => Self {
                body,
                words: Vec::new(),
            },
            file => Self::read(file)?,
        };
        for word in WORDS {
            if word.text.is_empty() {
                if matches.get_flag(word.name) {
                    all.words.push((word.name, String::new()));
                }
            } else if let Some(texts) = matches.get_many::<String>(word.name) {
                all.words.retain(|(name, _)| *name != word.name);
                all.words
                    .extend(texts.map(|text| (word.name, text.clone())));
            }
        }
        Ok(all)
    }

    /// From a file, as `--json` writes a scene.
    fn read(file: &str) -> Result<Self, Failure> {
        let text = std::fs::read_to_string(file).map_err(|_| {
            format!("`{file}` is neither `block` nor `ball`, nor a file with a scene")
        })?;
        let whole: Value =
            serde_json::from_str(&text).map_err(|error| format!("{file}: {error}"))?;
        let scene = whole.get("scene").unwrap_or(&whole).as_object();
        let scene = scene.ok_or_else(|| format!("{file}: a scene is an object"))?;
        let (mut body, mut words) = (None, Vec::new());
        let text = |value: &Value| match value {
            Value::String(text) => text.clone(),
            Value::Bool(true) => String::new(),
            other => other.to_string(),
        };
        for (name, value) in scene {
            if name == "body" {
                body = Some(text(value));
                continue;
            }
            let word = WORDS.iter().find(|word| word.name == name);
            let word = word.ok_or_else(|| format!("{file}: `{name}` is no word of a scene"))?;
            match value {
                Value::Array(many) => {
                    words.extend(many.iter().map(|value| (word.name, text(value))))
                }
                Value::Bool(false) => {}
                one => words.push((word.name, text(one))),
            }
        }
        Ok(Self {
            body: body.ok_or_else(|| format!("{file}: the scene has no body"))?,
            words,
        })
    }

    fn scene(&self) -> Result<(Scene, Until), SceneError> {
        let words = self.words.iter().map(|(name, text)| (*name, text.as_str()));
        Scene::read(&self.body, words, |file| {
            super::measure::content(file).map_err(|error| SceneError::Record {
                file: file.to_owned(),
                why: trialbook::cli::bare(error).to_string(),
            })
        })
    }

    fn json(&self) -> Value {
        let mut map = Map::from_iter([("body".to_owned(), object!(self.body))]);
        for (name, text) in &self.words {
            let value = if text.is_empty() {
                object!(true)
            } else {
                object!(text)
            };
            match map.get_mut(*name) {
                Some(Value::Array(many)) => many.push(value),
                None if MANY.contains(name) => {
                    drop(map.insert((*name).to_owned(), object!([value])))
                }
                _ => drop(map.insert((*name).to_owned(), value)),
            }
        }
        map.into()
    }

    /// The same with another text for a word, which keeps its direction.
    fn with(&self, word: &'static str, text: &str) -> Self {
        let mut other = self.clone();
        match other.words.iter_mut().find(|(name, _)| *name == word) {
            Some((_, old)) => {
                let direction = old.find('@').filter(|_| !text.contains('@'));
                let direction = direction.map(|at| old[at..].to_owned());
                *old = text.to_owned() + &direction.unwrap_or_default();
            }
            None => other.words.push((word, text.to_owned())),
        }
        other
    }
}

/// A choice `WORD=…` of the command line.
fn chosen(text: &str) -> Result<(&'static str, &str), Failure> {
    let (name, range) = text
        .split_once('=')
        .ok_or_else(|| format!("`{text}`: a word, `=` and its values are wanted"))?;
    let word = WORDS
        .iter()
        .find(|word| word.name == name && !word.text.is_empty());
    let word = word.ok_or_else(|| format!("`{name}` is no word of a scene that has a value"))?;
    Ok((word.name, range))
}

/// A range `LOW:HIGH…` whose numbers have a unit: as one without, and the unit.
fn bare(range: &str) -> Result<(String, String), Failure> {
    let (mut numbers, mut unit, mut direction) = (Vec::new(), "", "");
    for part in range.split(':') {
        let (part, own) = part.split_at(part.find('@').unwrap_or(part.len()));
        if !direction.is_empty() && !own.is_empty() && own != direction {
            return Err(format!("`{range}`: one direction is for all").into());
        }
        direction = if own.is_empty() { direction } else { own };
        // `deg` is part of an expression elsewhere.
        let degrees = part.strip_suffix("deg").map(|number| (number, "deg"));
        match degrees.unwrap_or_else(|| crate::scene::apart(part)) {
            (_, "log") => numbers.push("log"),
            ("", _) => return Err(format!("`{part}` is no number").into()),
            (number, own) => {
                if !unit.is_empty() && !own.is_empty() && own != unit {
                    return Err(format!("`{range}`: one unit is for all").into());
                }
                numbers.push(number);
                unit = if own.is_empty() { unit } else { own };
            }
        }
    }
    Ok((numbers.join(":"), unit.to_owned() + direction))
}

/// A table in letters that Excel knows.
fn table(heads: &[String], rows: impl Iterator<Item = Vec<String>>) -> Result<(), Failure> {
    let heads: Vec<_> = heads.iter().map(|head| ascii(head)).collect();
    let heads: Vec<_> = heads.iter().map(String::as_str).collect();
    csv(
        &heads,
        rows.map(|row| row.iter().map(|cell| ascii(cell)).collect()),
    )
}

pub(super) fn run(matches: &ArgMatches, format: Format, json: Json) -> Result<u8, Failure> {
    let words = Words::given(matches)?;
    let asked = |name| matches.get_one::<String>(name).map(String::as_str);
    if let (Some(find), Some(target)) = (asked("find"), asked("where")) {
        return found(&words, [find, target], format, json);
    }
    if let Some(vary) = asked("vary") {
        return varied(&words, vary, format, json);
    }
    let (scene, until) = words.scene()?;
    let answer = scene.answer(until)?;
    let every = match asked("every") {
        Some(step) => Some(answer.moved.every(step.parse()?)?),
        None => None,
    };
    let drawn = match matches.get_one::<PathBuf>("plot") {
        _ if !matches.contains_id("plot") => String::new(),
        None if format == Format::Text => plot::as_text(&path(&answer)?),
        None => return Err("--plot: beside JSON or CSV, name an SVG file".into()),
        Some(file) => {
            plot::to_file(&plot::svg(&path(&answer)?)?, file)?;
            String::new()
        }
    };
    let paper = second(&scene, until);
    match (format, every) {
        (Format::Json, every) => {
            let mut whole = object!({
                "version": VERSION,
                "scene": words.json(),
                "answer": numbers_of(&answer.numbers, |number| number.rounded().into()),
                "units": numbers_of(&answer.numbers, |number| number.unit.into()),
                "errors": errors(&answer.numbers),
                "order": answer.events.iter().map(|event| object!({ "t": event.t.0, "doing": doing(event.doing) })).collect::<Vec<_>>(),
                "second": paper.map(|second| object!({
                    "section": second.section,
                    "answer": second.numbers.iter().map(|(name, x)| ((*name).to_owned(), object!(x))).collect::<Map<_, _>>(),
                })),
            });
            if let Some(moments) = every {
                let row =
                    |moment: &Moment| numbers_of(&moment.numbers(), |number| number.value.into());
                whole["table"] = moments.iter().map(row).collect();
            }
            json(&whole)?;
        }
        (Format::Csv, Some(moments)) => {
            stop::listen()?;
            let cells = |number: &Number| plain(number.value);
            let row = |moment: &Moment| moment.numbers().iter().map(cells).collect();
            table(&heads(&answer.numbers), moments.iter().map(row))?;
        }
        (Format::Csv, None) => {
            let mut heads = heads(&answer.numbers);
            heads.push("digits".to_owned());
            table(&heads, [cells(&answer.numbers)].into_iter())?;
        }
        (Format::Text, every) => json(&Value::String(
            text(&answer, paper.as_ref())
                + &every.map_or(String::new(), |moments| rows(&moments, &answer))
                + &drawn,
        ))?,
    }
    Ok(0)
}

fn numbers_of(numbers: &[Number], value: impl Fn(&Number) -> Value) -> Value {
    numbers
        .iter()
        .map(|number| (number.name.to_owned(), value(number)))
        .collect::<Map<_, _>>()
        .into()
}

fn errors(numbers: &[Number]) -> Value {
    numbers_of(numbers, |number| {
        let off = number.off();
        off.is_finite().then_some(off).into()
    })
}

/// The numbers of one answer, as a row, and their digits.
fn cells(numbers: &[Number]) -> Vec<String> {
    let shown = |number: &Number| number.rounded().map_or(String::new(), plain);
    let digits = digits(numbers).map_or(String::new(), |digits| digits.to_string());
    numbers.iter().map(shown).chain([digits]).collect()
}

/// The fewest digits of what is not zero.
fn digits(numbers: &[Number]) -> Option<u32> {
    let some = numbers
        .iter()
        .filter(|number| number.rounded() != Some(0.0));
    some.map(Number::digits).min()
}

fn doing(doing: Doing) -> &'static str {
    match doing {
        Doing::Slides => "slides",
        Doing::Rests => "rests",
        Doing::Rolls => "rolls",
    }
}

/// How many changes are shown.
const SHOWN: usize = 8;

/// Its numbers, what it did in which order, and the paper's word on it.
fn text(answer: &Answer, paper: Option<&Opinion>) -> String {
    let shown = |number: &Number| number.rounded().map_or("unknown".to_owned(), plain);
    let row = |number: &Number| {
        vec![
            number.name.to_owned(),
            shown(number),
            number.unit.to_owned(),
            String::new(),
        ]
    };
    let rows: Vec<_> = answer.numbers.iter().map(row).collect();
    let mut text = aligned(&["", "value", "unit", ""], 1, &rows, screen().width);
    text.push('\n');
    if let Some(digits) = digits(&answer.numbers) {
        text += &format!("digits  {digits}\n");
    }
    let time = answer.numbers[0].unit;
    let order = answer.events.iter().take(SHOWN);
    let order =
        order.map(|event| format!("{} from {} {time}", doing(event.doing), short(event.t.0)));
    let order = order.collect::<Vec<_>>().join(", ");
    let more = answer.events.len().saturating_sub(SHOWN);
    let more = if more > 0 {
        format!(", and {more} more, which --json lists")
    } else {
        String::new()
    };
    text += &format!("order   {order}{more}\n");
    if let Some(paper) = paper {
        let agree = paper.numbers.iter().filter_map(|(name, x)| {
            let own = answer.numbers.iter().find(|number| number.name == *name)?;
            Some((own.value - x).abs() <= own.error + 1e-11 * x.abs().max(own.value.abs()))
        });
        let names: Vec<_> = paper.numbers.iter().map(|(name, _)| *name).collect();
        let says = if agree.fold(true, |all, one| all & one) {
            "the same"
        } else {
            "something else"
        };
        text += &format!(
            "paper   its section {} says {says} of {}\n",
            paper.section,
            names.join(", ")
        );
    }
    text
}

/// Six digits, for the eye.
fn short(x: f64) -> String {
    plain(format!("{x:.5e}").parse().unwrap_or(x))
}

fn rows(table: &[Moment], answer: &Answer) -> String {
    let cells = |moment: &Moment| {
        let numbers = moment.numbers().into_iter();
        let cells = numbers.map(|number| short(number.value));
        cells.chain([String::new()]).collect()
    };
    let rows: Vec<Vec<_>> = table.iter().map(cells).collect();
    let mut heads = heads(&answer.numbers);
    heads.push(String::new());
    let heads: Vec<_> = heads.iter().map(String::as_str).collect();
    format!("\n{}", aligned(&heads, 1, &rows, screen().width))
}

/// The heads of columns.
fn heads(numbers: &[Number]) -> Vec<String> {
    let numbers = numbers.iter();
    numbers
        .map(|number| head(number.name, number.unit))
        .collect()
}

/// The path in space or, along a line, in time.
fn path(answer: &Answer) -> Result<Curve, Failure> {
    let [from, to] = [answer.moved.start()?.t.0, answer.moved.end()?.t.0];
    let moments = answer.moved.every(Second((to - from) / 400.0))?;
    let units: Vec<_> = answer.numbers.iter().map(|number| number.unit).collect();
    let straight = moments
        .iter()
        .all(|moment| moment.place[1] == moments[0].place[1]);
    let point = |moment: &Moment| {
        if straight {
            [moment.t.0, moment.place[0].0]
        } else {
            moment.place.map(|x| x.0)
        }
    };
    Ok(Curve {
        title: "The path on the floor",
        x: if straight { "t" } else { "x" },
        y: if straight { "x" } else { "y" },
        units: [units[if straight { 0 } else { 1 }], units[1]],
        equal: !straight,
        points: moments.iter().map(point).collect(),
    })
}

/// A row for each value of a word.
fn varied(words: &Words, vary: &str, format: Format, json: Json) -> Result<u8, Failure> {
    let (word, range) = chosen(vary)?;
    let listed: Vec<_> = range.split(',').collect();
    let (axis, unit) = match listed.len() {
        1 => {
            let (numbers, unit) = bare(range)?;
            (Some(numbers.parse::<axis::Axis>()?), unit)
        }
        _ => (None, String::new()),
    };
    let value = |i: u64| match &axis {
        Some(axis) => plain(axis.at(i).into()) + &unit,
        None => listed[i as usize].to_owned(),
    };
    let all = 0..axis.map_or(listed.len() as u64, |axis| axis.count());
    let mut answers = Vec::new();
    let ended = in_pieces(all.clone(), [1, 256], "rows", |piece| {
        let answers_here = piece.into_par_iter().map(|i| {
            let value = value(i);
            let scene = words.with(word, &value).scene();
            let answer = scene.and_then(|(scene, until)| scene.answer(until));
            (value, answer.map(|answer| answer.numbers))
        });
        answers.extend(answers_here.collect::<Vec<_>>());
        Ok(())
    });
    let ended = match ended {
        Ok(ended) => ended,
        Err(stop) => return stop.code(),
    };
    let known: Vec<_> = answers
        .iter()
        .filter_map(|(_, answer)| answer.as_ref().ok())
        .collect();
    let refused = (answers.len() - known.len()) as u64;
    let first = known.first().map_or(&[][..], |numbers| numbers);
    if format == Format::Json {
        let row = |(value, answer): &(String, Result<Vec<Number>, SceneError>)| {
            let found = answer.as_ref();
            let whole = found.map(|found| numbers_of(found, |number| number.rounded().into()));
            object!({ "value": value, "answer": whole.ok(), "errors": found.ok().map(|found| errors(found)), "error": found.err().map(ToString::to_string) })
        };
        let rows: Vec<_> = answers.iter().map(row).collect();
        let units = numbers_of(first, |number| number.unit.into());
        json(
            &object!({ "version": VERSION, "scene": words.json(), "vary": word, "units": units, "answers": rows }),
        )?;
        return Ok(told(&all, (ended, refused), "rows"));
    }
    let width = first.len() + 2;
    let row = |(value, answer): &(String, Result<Vec<Number>, SceneError>)| {
        let mut row = vec![value.clone()];
        row.extend(answer.iter().flat_map(|numbers| cells(numbers)));
        row.resize(width, String::new());
        let why = answer.as_ref().err();
        row.push(why.map_or(String::new(), ToString::to_string));
        row
    };
    let rows = answers.iter().map(row);
    let names: Vec<_> = [word.to_owned()]
        .into_iter()
        .chain(heads(first))
        .chain(["digits", "note"].map(str::to_owned))
        .collect();
    if format == Format::Csv {
        table(&names, rows)?;
    } else {
        let names: Vec<_> = names.iter().map(String::as_str).collect();
        show(&aligned(
            &names,
            1,
            &rows.collect::<Vec<_>>(),
            screen().width,
        ))?;
    }
    Ok(told(&all, (ended, refused), "rows"))
}

/// The values of a word at which a number of the answer is what it is to be.
fn found(
    words: &Words,
    [sought, target]: [&str; 2],
    format: Format,
    json: Json,
) -> Result<u8, Failure> {
    let (word, range) = chosen(sought)?;
    let (name, wanted) = crate::scene::target(target)?;
    let (numbers, unit) = bare(range)?;
    let (low, high) = numbers
        .split_once(':')
        .ok_or("--find: WORD=LOW:HIGH is wanted")?;
    let range = [axis::number(low)?.into(), axis::number(high)?.into()];
    stop::listen()?;
    let at = |x: f64| {
        if stop::is_asked() {
            return Err(SceneError::Together("stopped"));
        }
        words.with(word, &(plain(x) + &unit)).scene()
    };
    let found = find(at, range, (name, wanted));
    if stop::is_asked() {
        complain("slipbook", "stopped: nothing is known of all values");
        return Ok(stop::STOPPED);
    }
    let Found { solutions, jumps } = found?;
    let note = format!(
        "looked at {STEPS} steps: two values closer together than one, or a value that is only touched, may be missed"
    );
    let list = |values: &[f64]| {
        values
            .iter()
            .map(|x| format!("{}{unit}", plain(*x)))
            .collect::<Vec<_>>()
    };
    match format {
        Format::Json => json(
            &object!({ "version": VERSION, "scene": words.json(), "find": word, "unit": unit, "solutions": solutions, "jumps": jumps, "note": note }),
        )?,
        Format::Csv => {
            let rows = |list: &[f64], is: &str| -> Vec<_> {
                list.iter()
                    .map(|x| vec![plain(*x), unit.clone(), is.to_owned()])
                    .collect()
            };
            let rows = [rows(&solutions, "solution"), rows(&jumps, "jump")];
            csv(&[word, "unit", "is"], rows.concat())?;
        }
        Format::Text => {
            let mut text = match &solutions[..] {
                [] => format!(
                    "none from {} to {}\n",
                    list(&range[..1])[0],
                    list(&range[1..])[0]
                ),
                _ => format!("{word} = {}\n", list(&solutions).join(", ")),
            };
            if !jumps.is_empty() {
                text += &format!(
                    "{name} jumps over it at {word} = {}\n",
                    list(&jumps).join(", ")
                );
            }
            json(&Value::String(text + &note + "\n"))?;
        }
    }
    Ok(u8::from(solutions.is_empty() && jumps.is_empty()))
}
