//! A scene that the reader writes in words, and a recording that is dropped: texts in and out.

use crate::measure::{Interval, Settings, Unfound, Verdict, measure};
use crate::numerics::error::plain;
use crate::scene::{Doing, Moment, Scene, SceneError, Second, columns};
use crate::{FitError, fitted::Recording};

const POINTS: f64 = 400.0;
/// Of time; a recording with more rows than twice as many is drawn together.
const STRETCHES: usize = 600;

/// What becomes of a scene, or what is in a recording, in lines whose cells stand behind tabs; `error` and the reason where there is no answer.
///
/// Asked with `block` or `ball`, a line `WORD=TEXT` for each of its [`WORDS`](crate::scene::WORDS), and, behind an empty line, the recording, whatever `record`
/// calls it: `number`, name, value (empty if not a digit is known) and unit; `does`, `slides`, `rests` or `rolls`, and since when; `straight`, if it stays on a
/// line of one y; `path`, then t, x, y and speed, again and again.
///
/// Asked with `recording`, its `columns=TEXT` if they are chosen, an empty line and the recording: `rows` with their number, first and last time; `x` and `y`, each with the acceleration in m/s² and
/// the times before it, again and again, where many rows are the least and the largest of a stretch of time; and, for a sensor on a body that slid, `kinetic` and
/// `holding` with what [`measure`] finds of them, `verdict` with its word on Coulomb's law, and `assumed` with what is taken for granted.
///
/// Cost: that of [`Scene::answer`], or of [`measure`].
pub fn told(question: &str) -> String {
    let (head, record) = question.split_once("\n\n").unwrap_or((question, ""));
    let mut lines = head.lines();
    let answer = match lines.next().unwrap_or_default() {
        "recording" => recorded(lines.find_map(|line| line.strip_prefix("columns=")), record),
        body => moved(body, lines.filter_map(|line| line.split_once('=')), record),
    };
    answer.unwrap_or_else(|error| format!("error\t{error}\n"))
}

fn moved<'a>(
    body: &str,
    words: impl Iterator<Item = (&'a str, &'a str)>,
    record: &str,
) -> Result<String, SceneError> {
    let (scene, until) = Scene::read(body, words, |file| {
        let missing = || SceneError::Record {
            file: file.to_owned(),
            why: "drop it on this page".to_owned(),
        };
        (!record.is_empty())
            .then(|| record.to_owned())
            .ok_or_else(missing)
    })?;
    let answer = scene.answer(until)?;
    let mut told = String::new();
    for number in &answer.numbers {
        let value = number.rounded().map_or(String::new(), plain);
        told += &format!("number\t{}\t{value}\t{}\n", number.name, number.unit);
    }
    for event in &answer.events {
        let doing = match event.doing {
            Doing::Slides => "slides",
            Doing::Rests => "rests",
            Doing::Rolls => "rolls",
        };
        told += &format!("does\t{doing}\t{}\n", plain(event.t.0));
    }
    let [from, to] = [answer.moved.start()?.t.0, answer.moved.end()?.t.0];
    let moments = if to > from {
        answer.moved.every(Second((to - from) / POINTS))?
    } else {
        vec![answer.moved.end()?]
    };
    let [first, ..] = moments[..] else {
        return Ok(told);
    };
    if moments
        .iter()
        .all(|moment| moment.place[1] == first.place[1])
    {
        told += "straight\n";
    }
    let point = |moment: &Moment| {
        let [x, y] = moment.place.map(|x| x.0);
        let [u, v] = moment.velocity.map(|v| v.0);
        [moment.t.0, x, y, libm::hypot(u, v)]
    };
    Ok(told + &line("path", moments.iter().flat_map(point)))
}

fn recorded(chosen: Option<&str>, text: &str) -> Result<String, SceneError> {
    let chosen = chosen.map(columns).transpose()?.unwrap_or_default();
    let recording = Recording::from_csv(text, &chosen)?;
    let rows = &recording.rows;
    let (Some((first, _)), Some((last, _))) = (rows.first(), rows.last()) else {
        return Err(FitError::Rows { least: 1, rows: 0 }.into());
    };
    let mut told = format!(
        "rows\t{}\t{}\t{}\n",
        rows.len(),
        plain(*first),
        plain(*last)
    );
    for (k, name) in ["x", "y"].into_iter().enumerate() {
        let values = rows
            .chunks(rows.len().div_ceil(STRETCHES).max(2))
            .flat_map(|chunk| {
                let order = |a: &&(f64, [f64; 2]), b: &&(f64, [f64; 2])| a.1[k].total_cmp(&b.1[k]);
                let mut two: Vec<_> = match chunk {
                    [_, _, _, ..] => [chunk.iter().min_by(order), chunk.iter().max_by(order)]
                        .into_iter()
                        .flatten()
                        .collect(),
                    few => few.iter().collect(),
                };
                two.sort_by(|a, b| a.0.total_cmp(&b.0));
                two.into_iter()
                    .flat_map(move |(t, a)| [*t, a[k]])
                    .collect::<Vec<_>>()
            });
        told += &line(name, values);
    }
    Ok(told + &friction(&recording))
}

fn friction(recording: &Recording) -> String {
    let measured = match measure(recording, &Settings::default()) {
        Ok(measured) => measured,
        Err(error) => return format!("kinetic\t{error}\n"),
    };
    let found = |found: Result<Interval, Unfound>| match found {
        Ok(Interval { from, to }) => format!("from {from:.3} to {to:.3}"),
        Err(unfound) => unfound.to_string(),
    };
    let verdict = match measured.verdict {
        Verdict::Fits => "fits",
        Verdict::Levels(_) => "slips differ",
        Verdict::Drifts(_) => "changes during a slip",
        Verdict::Untold => "untold",
    };
    let assumed = measured.assumed();
    let assumed = assumed.map_or(String::new(), |of| format!("assumed\t{of}\n"));
    let [kinetic, holding] = [measured.kinetic, measured.holding].map(found);
    format!("kinetic\t{kinetic}\nholding\t{holding}\nverdict\t{verdict}\n{assumed}")
}

fn line(name: &str, numbers: impl Iterator<Item = f64>) -> String {
    let mut line = name.to_owned();
    for number in numbers {
        line.push('\t');
        line += &plain(number);
    }
    line + "\n"
}
