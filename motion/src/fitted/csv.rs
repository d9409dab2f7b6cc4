//! The text of a recording as rows of numbers: every cell is read right, or its line is refused.

use super::{
    FitError, LEAST_ROWS,
    cells::{Columns, EMPTY, of_acceleration, parsed, plain, read, refuse, seconds},
    peer,
    when::Clock,
};
use crate::numerics::median;

/// What an accelerometer has written, in s and m/s².
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recording {
    /// Times, which rise, with A_x and A_y, as [`Fitted::from_table`](super::Fitted::from_table) takes them.
    pub rows: Vec<(f64, [f64; 2])>,
    /// A_z, along the normal of the floor, if there is such a column.
    pub normal: Option<Vec<f64>>,
}

impl Recording {
    /// A file's text: in UTF-8, or as Windows writes it, in UTF-16 with its mark or in Latin-1.
    pub fn decoded(file: Vec<u8>) -> String {
        match &file[..] {
            [0xff, 0xfe, rest @ ..] => {
                let two = rest.chunks_exact(2);
                let units = two.map(|two| u16::from_le_bytes([two[0], two[1]]));
                let text = char::decode_utf16(units);
                text.map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
                    .collect()
            }
            _ => String::from_utf8(file)
                .unwrap_or_else(|error| error.into_bytes().into_iter().map(char::from).collect()),
        }
    }

    /// Reads a file as [`Fitted::from_csv_with`](super::Fitted::from_csv_with) does, and the acceleration along z, where that is called one or chosen.
    ///
    /// # Errors
    /// [`FitError::Line`], as there.
    pub fn from_csv(text: &str, columns: &Columns) -> Result<Self, FitError> {
        read_all(text, columns, true)
    }

    fn step(&self) -> f64 {
        median(self.rows.windows(2).map(|pair| pair[1].0 - pair[0].0))
    }

    /// The first row behind a step of more than eight usual ones, counted from 0: rows may have been lost.
    pub fn gap(&self) -> Option<usize> {
        let most = GAP * self.step();
        let long = |pair: &[(f64, [f64; 2])]| most > 0.0 && pair[1].0 - pair[0].0 > most;
        let gap = self.rows.windows(2).position(long).map(|k| k + 1);
        gap.filter(|_| self.rows.len() >= LEAST_ROWS)
    }
}

/// In usual steps: a few rows may have been lost, or passed over.
const GAP: f64 = 8.0;
/// Without a unit a usual step of more seconds is hardly one of an accelerometer,
const SLOW: f64 = 1.0;
/// nor so large a value in m/s²: counts of a converter, or mg,
const STRONG: f64 = 200.0;
/// nor that gravity is this: it is in g.
const ONE_G: std::ops::Range<f64> = 0.8..1.2;
const TITLES: usize = 10;

pub(super) fn rows(text: &str, asked: &Columns) -> Result<Vec<(f64, [f64; 2])>, FitError> {
    read_all(text, asked, false).map(|recording| recording.rows)
}

fn read_all(text: &str, asked: &Columns, with_normal: bool) -> Result<Recording, FitError> {
    let passed = |line: &str| line.trim().is_empty() || line.starts_with('#');
    let text = text.trim_start_matches('\u{feff}');
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let all = || text.split(end).map(|line| line.trim_end_matches('\r'));
    if let Some(rows) = peer::rows(all(), asked) {
        return rows.map(|rows| Recording { rows, normal: None });
    }
    let mut lines = (1..)
        .zip(all())
        .filter(|(_, line)| !passed(line))
        .peekable();
    let stated = lines.next_if(|(_, line)| line.trim_matches('"').starts_with("sep="));
    let parts = |line: &str| {
        let several = |c: &char| cells(line, *c).len() > 1;
        [';', '\t', '|', ','].into_iter().find(several)
    };
    let mut first = lines.clone().take(TITLES).map(|(_, line)| parts(line));
    let separator = first.next().flatten();
    let separator = separator.or_else(|| first.flatten().find(|c| *c != ','));
    let separator = separator.unwrap_or(' ');
    let words = |line: &str| {
        let cells = cells(line, separator);
        cells.iter().all(|cell| parsed(cell).is_none()) && !cells.concat().is_empty()
    };
    // Tracker and Vernier write titles before the head.
    let title = |line: &str| {
        let cells = cells(line, separator);
        let few = cells.iter().filter(|cell| !cell.is_empty()).count() < 2;
        few && words(line) && !line.starts_with(|c: char| c.is_ascii_digit())
    };
    while separator != ' ' && lines.next_if(|(_, line)| title(line)).is_some() {}
    let Some(&(number, first)) = lines.peek() else {
        return Ok(Recording::default());
    };
    let count = cells(first, separator).len();
    let mut heads = Vec::new();
    while heads.len() < 3
        && let Some((_, line)) = lines.next_if(|(_, line)| words(line))
    {
        heads.push(cells(line, separator));
    }
    // As `numpy.savetxt` writes it: the last line of remarks before the numbers, if it names the time.
    let remark = all()
        .take_while(|line| passed(line))
        .filter_map(|line| line.strip_prefix('#'))
        .last();
    if let (true, Some(remark)) = (heads.is_empty(), remark) {
        let named = |cells: &Vec<&str>| {
            cells.len() == count && cells.iter().any(|cell| Column::of(cell).is_time())
        };
        let splits = [separator, ' ', ','].map(|c| cells(remark, c));
        heads.extend(splits.into_iter().find(named));
    }
    let places = places(&heads, count, asked, with_normal);
    let Places { time, axes, bare } = places.map_err(|why| refuse(number, first, why))?;
    let (mut rows, mut normal, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
    let (mut sign, mut clock) = (None, Clock::default());
    let mut lost = None;
    for (n, line) in lines {
        let cells = cells(line, separator);
        let mut row = || {
            if cells.len() != count {
                return Err("every line needs as many cells as the first");
            }
            if axes.iter().flatten().all(|axis| is_empty(cells[axis.0])) {
                // The other sensors of a phone have lines of their own.
                let other = |(i, cell): (usize, &&str)| i != time.0 && !is_empty(cell);
                if !cells.iter().enumerate().any(other) {
                    lost.get_or_insert((n, line));
                }
                return Ok(None);
            }
            let t = match clock.read(cells[time.0], separator, &mut sign)? {
                Some(t) => t,
                None => time.1.ok_or(NO_UNIT)? * read(cells[time.0], separator, &mut sign)?,
            };
            if rows.last().is_some_and(|(before, _)| *before >= t) {
                return Err("its time is not after the one before: leave one of the two out");
            }
            let mut a = [0.0; 3];
            for (a, axis) in a.iter_mut().zip(axes) {
                if let Some((i, size)) = axis {
                    *a = size * read(cells[i], separator, &mut sign)?;
                }
            }
            if bare[1] && a.iter().any(|a| a.abs() > STRONG) {
                return Err(COUNTS);
            }
            Ok(Some((t, a)))
        };
        let row = row().map_err(|why| refuse(n, line, why))?;
        if let Some((t, [x, y, z])) = row {
            if let Some((n, line)) = lost {
                return Err(refuse(n, line, EMPTY));
            }
            rows.push((t, [x, y]));
            normal.push(z);
            numbers.push((n, line));
        }
    }
    let normal = axes[2].map(|_| normal);
    let recording = Recording { rows, normal };
    let sizes = recording.normal.iter().flatten().map(|z| z.abs());
    let many = recording.rows.len() >= LEAST_ROWS;
    for (wrong, why) in [
        (
            Some(0).filter(|_| many && bare[0] && recording.step() > SLOW),
            NO_TIME,
        ),
        (
            Some(0).filter(|_| many && bare[1] && ONE_G.contains(&median(sizes))),
            IN_G,
        ),
        (recording.gap().filter(|_| !asked.gaps), LOST),
    ] {
        if let Some((n, line)) = wrong.and_then(|k| numbers.get(k)) {
            return Err(refuse(*n, line, why));
        }
    }
    if separator == ',' && count == 3 && heads.is_empty() && stated.is_none() && sign.is_none() {
        let why = "without a decimal point in the file a comma may be the decimal sign: give the columns a head";
        return Err(refuse(number, first, why));
    }
    Ok(recording)
}

fn is_empty(cell: &str) -> bool {
    cell.is_empty() || cell.eq_ignore_ascii_case("nan")
}

fn cells(line: &str, separator: char) -> Vec<&str> {
    let mut quoted = false;
    line.split(|c| {
        quoted ^= c == '"';
        c == separator && !quoted
    })
    .map(|cell| cell.trim().trim_matches('"').trim())
    .filter(|cell| separator != ' ' || !cell.is_empty())
    .collect()
}

const COUNTS: &str = "so large a value is hardly in m/s²: its head has to say the unit, or the columns: unit=mg; counts have to be divided by those of one g";
const NO_UNIT: &str = "its time has no unit of time: s, ms, us, ns, min or h";
const LOST: &str = "before it is a gap of more than eight usual steps: cut the file there, or ask for gaps to be bridged";
const IN_G: &str = "along z there is about 1, which may be in g: the head has to say the unit, or the columns: unit=g";
const NO_TIME: &str = "such times are hardly in seconds: their head has to say the unit, or the columns: time-unit=ms";
const SEVERAL: &str =
    "several columns are the acceleration along the same axis: choose of the columns: x=2";

/// Where t, A_x, A_y and A_z stand, and their factors to be in s and m/s².
struct Places {
    time: (usize, Option<f64>),
    axes: [Option<(usize, f64)>; 3],
    /// Whether a head says no unit of time, and none of acceleration.
    bare: [bool; 2],
}

fn only(
    mut of: impl Iterator<Item = usize>,
    several: &'static str,
) -> Result<Option<usize>, &'static str> {
    let first = of.next();
    of.next().map_or(Ok(first), |_| Err(several))
}

/// By what is asked for, by the names in the head and by the line of units below it.
fn places(
    heads: &[Vec<&str>],
    count: usize,
    asked: &Columns,
    with_normal: bool,
) -> Result<Places, &'static str> {
    let names = heads.first().map_or(&[][..], |names| names);
    let mut columns: Vec<_> = names.iter().map(|name| Column::of(name)).collect();
    if let [_, .., units] = heads {
        if units.len() != columns.len() {
            return Err("all lines of the head need as many cells");
        }
        for (column, unit) in columns.iter_mut().zip(units) {
            column.unit = plain(unit);
        }
    }
    let all = || columns.iter().enumerate();
    let find = |name: &str| {
        let called = |i: &usize| {
            let bare = names[*i].split(['(', '[']).next().unwrap_or_default();
            [names[*i], bare]
                .iter()
                .any(|head| head.trim().eq_ignore_ascii_case(name.trim()))
        };
        let several = "two columns have the name asked for: give its number";
        let number = || name.parse().ok().and_then(|n: usize| n.checked_sub(1));
        only((0..names.len()).filter(called), several)?
            .or_else(|| number().filter(|i| *i < count))
            .ok_or("no column has the name asked for")
    };
    let time = match asked.time {
        Some(name) => find(name)?,
        None if names.is_empty() => 0,
        None => {
            // Seconds before other units, and these before none.
            let rank = |column: &Column| match seconds(&column.unit) {
                Some(size) => u8::from(size != 1.0),
                None => 2,
            };
            let times = all().filter(|(_, column)| column.is_time());
            let best = times.clone().map(|(_, column)| rank(column)).min();
            let times = times.filter(|(_, column)| Some(rank(column)) == best);
            only(
                times.map(|(i, _)| i),
                "several columns are times: choose of the columns: time=1",
            )?
            .ok_or("no column is the time: one has to be called t or time, or have the unit s")?
        }
    };
    let chosen = asked.x.or(asked.y).is_some();
    let along = |axis| {
        let fit = all().filter(move |(i, column)| *i != time && column.is_acceleration(axis));
        only(fit.map(|(i, _)| i), SEVERAL)
    };
    let mut axes = [None; 3];
    for (k, name) in [asked.x, asked.y, asked.z].into_iter().enumerate() {
        axes[k] = match name {
            _ if k == 2 && !with_normal => None,
            Some(name) => Some(find(name)?),
            None if chosen => None,
            None if !names.is_empty() => along(Some(['x', 'y', 'z'][k]))?,
            None if !(2..=3).contains(&count) => {
                return Err("without a head a row is a time and one or two numbers");
            }
            None => Some(k + 1).filter(|i| k < 2 && *i < count),
        };
    }
    if let [None, None, _] = axes {
        // Of several letters a may be one like the others.
        let alone = |i: &usize| names.len() == 2 || columns[*i].words != ["a"];
        let why = "no column says that it is an acceleration along x or y: by its name, as ax, acc_x, accel x, or by its unit, as m/s^2; else choose the columns: x=X,y=Y,z=Z";
        axes = [Some(along(None)?.filter(alone).ok_or(why)?), None, None];
    }
    let all = axes.iter().flatten();
    if all.clone().any(|i| *i == time)
        || all
            .clone()
            .any(|i| all.clone().filter(|k| *k == i).count() > 1)
    {
        return Err("one column is chosen for two things");
    }
    let unit = |i: usize, asked: Option<&str>| {
        let own = || {
            columns
                .get(i)
                .map_or_else(String::new, |column| column.unit.clone())
        };
        asked.map_or_else(own, plain)
    };
    let bare = |i: usize, asked| !names.is_empty() && unit(i, asked).is_empty();
    let bare = [
        bare(time, asked.time_unit),
        axes.iter().flatten().any(|i| bare(*i, asked.unit)),
    ];
    let size = |i, asked, of: fn(&str) -> Option<f64>| match &unit(i, asked)[..] {
        "" => Some(1.0),
        unit => of(unit),
    };
    let why = "an acceleration has no unit of one: m/s^2, cm/s^2, ft/s^2, g or mg";
    let place = |i| {
        size(i, asked.unit, of_acceleration)
            .map(|size| (i, size))
            .ok_or(why)
    };
    let [x, y, z] = axes.map(|i| i.map(place).transpose());
    let time = (time, size(time, asked.time_unit, seconds));
    Ok(Places {
        time,
        axes: [x?, y?, z?],
        bare,
    })
}

struct Column {
    words: Vec<String>,
    /// [`plain`]; empty where none is said.
    unit: String,
}

/// Words of times; parts of words for acceleration; beginnings of words for other things, though its name or unit may stand beside them.
const TIMES: [&str; 13] = [
    "t", "elapsed", "relative", "since", "start", "in", "run", "epoch", "unix", "zeit", "temps",
    "tiempo", "tempo",
];
const ACCELERATION: [&str; 5] = ["accel", "accél", "acel", "beschl", "gforce"];
const OTHER: [&str; 17] = [
    "ang", "gyr", "rot", "jerk", "vel", "speed", "err", "unc", "std", "sigma", "bias", "abs",
    "mag", "total", "norm", "max", "rms",
];

impl Column {
    fn of(name: &str) -> Self {
        let mut name = name.to_lowercase();
        for (long, short) in [
            ("{", " "),
            ("}", " "),
            ("g-f", "gf"),
            ("g f", "gf"),
            ("|", " abs "),
        ] {
            name = name.replace(long, short);
        }
        // A letter in brackets is an axis, all else a unit.
        let (mut bare, mut unit) = (String::new(), String::new());
        for (k, part) in name.split(['(', '[', ')', ']']).enumerate() {
            match part.trim() {
                part if k % 2 == 0 || matches!(part, "x" | "y" | "z") => bare = bare + " " + part,
                part => unit = plain(part),
            }
        }
        let words = bare.split(|c: char| !c.is_alphanumeric());
        let words = words.filter(|word| !word.is_empty()).map(str::to_owned);
        let mut column = Self {
            words: words.collect(),
            unit,
        };
        if column.unit.is_empty() {
            let last = |word: &String| axis(word).is_some() || is_acceleration(word);
            let words = &column.words;
            let behind = words.iter().rposition(last).map_or(words.len(), |k| k + 1);
            let tail = plain(&words[behind..].concat());
            let mut times = words.iter().map(|word| plain(word));
            let time = times.find(|word| seconds(word).is_some());
            let time = time.filter(|_| column.is_time());
            let gforce = words.iter().any(|word| word.starts_with("gf"));
            column.unit = if of_acceleration(&tail).is_some() {
                tail
            } else if let Some(time) = time {
                time
            } else if bare.contains("/s") {
                "/s".to_owned()
            } else if gforce {
                "g".to_owned()
            } else {
                String::new()
            };
        }
        column
    }

    fn is_time(&self) -> bool {
        let timely = |word: &String| {
            TIMES.contains(&&word[..])
                || word.starts_with("time")
                || seconds(&plain(word)).is_some()
                || word.parse::<u32>().is_ok()
        };
        !self.words.is_empty() && self.words.iter().all(timely)
            || self.unit == "s"
            || self.unit.len() > 1 && seconds(&self.unit).is_some()
    }

    /// By name or by unit; along none where no axis is named.
    fn is_acceleration(&self, along: Option<char>) -> bool {
        let axis_of = |word: &String| axis(word).map(|(axis, _)| axis);
        let short = match &self.words[..] {
            [a, rest @ ..] => a == "a" && rest.first().is_none_or(|next| axis(next).is_some()),
            [] => false,
        };
        let full = |word: &String| {
            is_acceleration(word) || axis(word).is_some_and(|(_, rest)| !rest.is_empty())
        };
        let named = short || self.words.iter().any(full);
        // Grams are written as g too, and gauss as G.
        let bare = |word: &String| matches!(&word[..], "x" | "y" | "z" | "axis");
        let sure = !self.unit.ends_with('g') || along.is_some() && self.words.iter().all(bare);
        let united = of_acceleration(&self.unit).is_some() && sure;
        let other = |word: &String| {
            OTHER.iter().any(|other| word.starts_with(other)) || !named && word.starts_with("grav")
        };
        self.words.iter().find_map(axis_of) == along
            && (named || united)
            && !self.words.iter().any(other)
    }
}

fn is_acceleration(word: &str) -> bool {
    word == "gf" || word.ends_with("acc") || ACCELERATION.iter().any(|part| word.contains(part))
}

/// Of a word that is one, or a short form of acceleration with one; and what stands before it.
fn axis(word: &str) -> Option<(char, &str)> {
    let axis = word
        .chars()
        .last()
        .filter(|c| matches!(c, 'x' | 'y' | 'z'))?;
    let rest = word.strip_suffix(axis)?;
    ("acceleration".starts_with(rest) || is_acceleration(rest)).then_some((axis, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_read_right_or_refused_with_its_line() {
        let cases = include_str!("files.txt").split("\n== ").skip(1);
        for case in cases {
            let (head, case) = case.split_once('\n').unwrap();
            let (file, right) = case.rsplit_once("\n=> ").unwrap();
            let marks = [("\\t", "\t"), ("\\r", "\r"), ("\\b", "\u{feff}")];
            let file = marks
                .iter()
                .fold(file.to_owned(), |file, (mark, c)| file.replace(mark, c));
            let chosen = head
                .split_once(" | ")
                .map(|(_, chosen)| crate::scene::columns(chosen));
            let read = Recording::from_csv(&file, &chosen.transpose().unwrap().unwrap_or_default());
            let (first, right) = right.trim().split_once(':').unwrap_or((right.trim(), ""));
            match (read, first.strip_prefix("line ")) {
                (Ok(read), None) => {
                    let (t, [x, y]) = read.rows[read.rows.len() - 1];
                    let z = read.normal.map(|z| z[z.len() - 1]);
                    let found: Vec<_> = [t, x, y].into_iter().chain(z).collect();
                    let right = right.split_whitespace().map(|x| x.parse().unwrap());
                    let right: Vec<f64> = right.collect();
                    let off = found.iter().zip(&right).any(|(a, b)| (a - b).abs() > 1e-9);
                    let same = found.len() == right.len() && !off;
                    assert!(
                        same && read.rows.len().to_string() == first,
                        "{head}: {found:?}"
                    );
                }
                (Err(FitError::Line { line, why, .. }), Some(at)) => {
                    assert!(
                        line.to_string() == at && why.contains(right.trim()),
                        "{head}: {line} {why}"
                    );
                }
                (read, _) => panic!("{head}: {read:?}"),
            }
        }
    }

    /// Below `= 9.80665` those in g, below `= none` those that are none.
    #[test]
    fn a_head_says_what_its_column_is() {
        let mut size = None;
        for head in include_str!("heads.txt").lines() {
            if let Some(next) = head.strip_prefix("= ") {
                size = next.parse().ok();
                continue;
            }
            let read = rows(
                &format!("Time (s);{head};note\n0.5;1;3\n"),
                &Columns::default(),
            );
            match (read, size) {
                (Ok(read), Some(size)) => assert_eq!(read, [(0.5, [size, 0.0])], "{head}"),
                (Err(FitError::Line { line: 1, .. }), None) => {}
                (read, _) => panic!("{head}: {read:?}"),
            }
        }
    }

    proptest::proptest! {
        #[test]
        fn any_text_is_read_or_refused(text in "[taxyzgNT:_ ,;#\\t\\n\\r\"0-9.e()/²s:|-]{0,60}", name in "[a-z0-9 ]{0,3}") {
            let (name, unit) = (Some(&name[..]), Some("g"));
            for columns in [Columns::default(), Columns { time: name, ..Columns::default() }, Columns { y: name, unit, ..Columns::default() }] {
                if let Ok(rows) = Recording::from_csv(&text, &columns).map(|read| read.rows) {
                    assert!(rows.windows(2).all(|pair| pair[0].0 < pair[1].0));
                }
            }
        }
    }
}
