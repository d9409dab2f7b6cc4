//! The text of a recording as rows of numbers: every cell is read right, or its line is refused.

use super::{FitError, LARGEST, LEAST_ROWS, peer, when::Clock};

/// What an accelerometer has written, in s and m/s².
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recording {
    /// Times, which rise, with A_x and A_y: [`Fitted::from_table`](super::Fitted::from_table) takes them as they are.
    pub rows: Vec<(f64, [f64; 2])>,
    /// A_z, along the normal of the floor, at the same times, if there is such a column.
    pub normal: Option<Vec<f64>>,
}

impl Recording {
    /// Reads a file as [`Fitted::from_csv_with`](super::Fitted::from_csv_with) does, and the acceleration along z, where that is called one or chosen.
    ///
    /// # Errors
    /// [`FitError::Line`], as there.
    pub fn from_csv(text: &str, columns: &Columns) -> Result<Self, FitError> {
        read_all(text, columns, true)
    }

    /// The first row behind a gap, counted from 0: a step of more than eight usual ones, where rows may have been lost.
    pub fn gap(&self) -> Option<usize> {
        let steps: Vec<_> = self
            .rows
            .windows(2)
            .map(|pair| pair[1].0 - pair[0].0)
            .collect();
        if steps.len() + 1 < LEAST_ROWS {
            return None;
        }
        let (mut sorted, middle) = (steps.clone(), steps.len() / 2);
        let usual = *sorted.select_nth_unstable_by(middle, f64::total_cmp).1;
        let gap = |step| usual > 0.0 && step > GAP * usual;
        Some(1 + steps.into_iter().position(gap)?)
    }
}

/// Which columns [`Fitted::from_csv_with`](super::Fitted::from_csv_with) reads, where the head does not say so by itself.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Columns<'a> {
    /// The column of the times: its head, with or without the unit, or its number from 1.
    pub time: Option<&'a str>,
    /// That of A_x. If this or that of A_y is given, the other is zero where it is not.
    pub x: Option<&'a str>,
    /// That of A_y.
    pub y: Option<&'a str>,
    /// That of A_z, which only a [`Recording`] has.
    pub z: Option<&'a str>,
    /// Unit of the times in place of the head's: s, ms, us, ns, min or h.
    pub time_unit: Option<&'a str>,
    /// Unit of the accelerations in place of the head's: m/s^2, mm/s^2, cm/s^2, km/s^2, ft/s^2, in/s^2, g or mg.
    pub unit: Option<&'a str>,
    /// Whether gaps are bridged: steps of more than eight times the usual one.
    pub gaps: bool,
}

/// A step that is so many times the usual one is a gap: a few rows may have been lost, or passed over.
const GAP: f64 = 8.0;

pub(super) fn rows(text: &str, asked: &Columns) -> Result<Vec<(f64, [f64; 2])>, FitError> {
    read_all(text, asked, false).map(|recording| recording.rows)
}

/// What is refused, with its line.
pub(super) fn refuse(line: usize, text: &str, why: &'static str) -> FitError {
    FitError::Line {
        line,
        text: text.chars().take(100).collect(),
        why,
    }
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
    let first = lines.peek().map_or("", |(_, line)| line);
    // A spreadsheet's word for its separator.
    let stated = first.trim_matches('"').strip_prefix("sep=");
    let stated = lines.next_if(|_| stated.is_some()).and(stated);
    let separator = stated.and_then(|rest| rest.chars().next()).or_else(|| {
        let parts = |c: &char| cells(first, *c).len() > 1;
        [';', '\t', ','].into_iter().find(parts)
    });
    let separator = separator.unwrap_or(' ');
    let words = |line: &str| {
        let cells = cells(line, separator);
        cells.iter().all(|cell| parsed(cell).is_none()) && !cells.concat().is_empty()
    };
    let Some(&(number, first)) = lines.peek() else {
        return Ok(Recording::default());
    };
    let count = cells(first, separator).len();
    let mut heads = Vec::new();
    while heads.len() < 2
        && let Some((_, line)) = lines.next_if(|(_, line)| words(line))
    {
        heads.push(cells(line, separator));
    }
    // As `numpy.savetxt` writes it: the last line of remarks before the numbers, if it names the time.
    let remark = all()
        .take_while(|line| passed(line))
        .filter_map(|line| line.strip_prefix('#'))
        .last();
    if heads.is_empty()
        && let Some(remark) = remark
    {
        let named = |cells: &Vec<&str>| {
            cells.len() == count && cells.iter().any(|cell| Column::of(cell).is_time())
        };
        heads.extend(
            [separator, ' ', ',']
                .map(|c| cells(remark, c))
                .into_iter()
                .find(named),
        );
    }
    let places = places(&heads, count, asked, with_normal);
    let Places { time, axes, large } = places.map_err(|why| refuse(number, first, why))?;
    let read_axes: Vec<_> = axes.iter().flatten().map(|axis| axis.0).collect();
    let (mut rows, mut normal, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
    let (mut sign, mut clock) = (None, Clock::default());
    // A line without a value, until it is known whether more follow.
    let mut lost = None;
    for (n, line) in lines {
        let cells = cells(line, separator);
        let mut row = || {
            if cells.len() != count {
                return Err("every line needs as many cells as the first");
            }
            if read_axes.iter().all(|i| is_empty(cells[*i])) {
                // The other sensors of a phone have lines of their own.
                let other = |(i, cell): (usize, &&str)| i != time.0 && !is_empty(cell);
                if !cells.iter().enumerate().any(other) {
                    lost.get_or_insert((n, line));
                }
                return Ok(None);
            }
            let t = match clock.read(cells[time.0], separator, &mut sign)? {
                Some(t) => t,
                None => time.1 * read(cells[time.0], separator, &mut sign)?,
            };
            if t.abs() > large {
                return Err("so late a time is hardly in seconds: its head has to say its unit");
            }
            if rows.last().is_some_and(|(before, _)| *before >= t) {
                return Err("its time is not after the one before");
            }
            let mut a = [0.0; 3];
            for (a, axis) in a.iter_mut().zip(axes) {
                if let Some((i, size)) = axis {
                    *a = size * read(cells[i], separator, &mut sign)?;
                }
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
    if !asked.gaps
        && let Some(&(n, line)) = recording.gap().and_then(|k| numbers.get(k))
    {
        let why = "before it is a gap of more than eight usual steps: cut the file there, or ask for gaps to be bridged";
        return Err(refuse(n, line, why));
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

/// The cells of a line, without their quotes. Spaces separate however many they are.
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

fn parsed(cell: &str) -> Option<f64> {
    cell.replace(',', ".").replace('−', "-").parse().ok()
}

/// A number, with the decimal sign of the file.
pub(super) fn read(
    cell: &str,
    separator: char,
    sign: &mut Option<char>,
) -> Result<f64, &'static str> {
    for c in cell.chars().filter(|c| matches!(c, '.' | ',')) {
        if c == separator || *sign.get_or_insert(c) != c {
            return Err("its decimal sign is not the only one");
        }
    }
    let number = parsed(cell).filter(|x| x.abs() <= LARGEST);
    number.ok_or(EMPTY)
}

const EMPTY: &str = "a cell is empty or no finite number";

/// Where t, A_x, A_y and A_z stand, and what they have to be multiplied by to be in s and m/s².
struct Places {
    time: (usize, f64),
    axes: [Option<(usize, f64)>; 3],
    /// The latest time that can be meant: one in nanoseconds may have no unit either.
    large: f64,
}

/// Finds the columns: by what is asked for, by the names in the head and, if there is one, the line of units below.
fn places(
    heads: &[Vec<&str>],
    count: usize,
    asked: &Columns,
    with_normal: bool,
) -> Result<Places, &'static str> {
    let empty = Vec::new();
    let names = heads.first().unwrap_or(&empty);
    let mut columns: Vec<_> = names.iter().map(|name| Column::of(name)).collect();
    if let Some(units) = heads.get(1) {
        if units.len() != columns.len() {
            return Err("both lines of the head need as many cells");
        }
        for (column, unit) in columns.iter_mut().zip(units) {
            column.unit = plain(unit);
        }
    }
    let find = |name: &str| {
        let called = |head: &&str| {
            let bare = head.split(['(', '[']).next().unwrap_or(head);
            [*head, bare]
                .iter()
                .any(|head| head.trim().eq_ignore_ascii_case(name.trim()))
        };
        let mut found = (0..names.len()).filter(|i| called(&names[*i]));
        let number = || name.parse().ok().and_then(|n: usize| n.checked_sub(1));
        match (found.next(), found.next()) {
            (Some(i), None) => Ok(i),
            (None, _) => number()
                .filter(|i| *i < count)
                .ok_or("no column has the name asked for"),
            _ => Err("two columns have the name asked for: give its number"),
        }
    };
    let given = |unit: Option<&str>, size: fn(&str) -> Option<f64>, why| {
        unit.map(|unit| size(&plain(unit)).ok_or(why)).transpose()
    };
    let time_unit = given(
        asked.time_unit,
        seconds,
        "the unit asked for is none of time",
    )?;
    let unit = given(
        asked.unit,
        of_acceleration,
        "the unit asked for is none of acceleration",
    )?;
    let sized = |i: usize, given: Option<f64>, size: fn(&Column) -> Option<f64>, why| {
        let own = || columns.get(i).map_or(Some(1.0), size);
        given.or_else(own).map(|size| (i, size)).ok_or(why)
    };
    let time = match asked.time {
        Some(name) => find(name)?,
        None if names.is_empty() => 0,
        None => {
            let of = |unit: fn(&Column) -> bool| {
                let fit = |i: &usize| columns[*i].is_time() && unit(&columns[*i]);
                (0..columns.len()).filter(fit).collect::<Vec<_>>()
            };
            // One that says that it is in seconds goes before those in other units, and these before those that say none.
            let kinds = [
                of(|c| seconds(&c.unit) == Some(1.0)),
                of(|c| seconds(&c.unit).is_some()),
                of(|_| true),
            ];
            match kinds
                .iter()
                .find(|kind| !kind.is_empty())
                .map(|kind| &kind[..])
            {
                Some([one]) => *one,
                Some(_) => return Err("several columns are times: choose one"),
                None => {
                    return Err(
                        "no column is the time: one has to be called t or time, or have the unit s",
                    );
                }
            }
        }
    };
    let time = sized(
        time,
        time_unit,
        Column::seconds,
        "its time has no unit of time: s, ms, us, ns, min or h",
    )?;
    let chosen = match (asked.x, asked.y) {
        (None, None) if names.is_empty() => match count {
            2 => [Some(1), None, None],
            3 => [Some(1), Some(2), None],
            _ => return Err("without a head a row is a time and one or two numbers"),
        },
        (None, None) => {
            let along = |axis| {
                let fit = |i: &usize| *i != time.0 && columns[*i].is_acceleration(axis);
                (0..columns.len()).filter(fit).collect::<Vec<_>>()
            };
            let lists = [Some('x'), Some('y'), Some('z'), None].map(along);
            let z = match &lists[2][..] {
                [z] if with_normal => Some(*z),
                [_, _, ..] if with_normal => return Err(SEVERAL),
                _ => None,
            };
            match lists.each_ref().map(|list| &list[..]) {
                // Of several letters a may be one like the others.
                [[], [], [], [one]] if names.len() == 2 || columns[*one].words != ["a"] => {
                    [Some(*one), None, None]
                }
                [[x], [], ..] => [Some(*x), None, z],
                [[], [y], ..] => [None, Some(*y), z],
                [[x], [y], ..] => [Some(*x), Some(*y), z],
                [[], [], ..] => {
                    return Err(
                        "no column says that it is an acceleration along x or y: by its name, as ax, acc_x, accel x, or by its unit, as m/s^2; else choose the columns",
                    );
                }
                _ => return Err(SEVERAL),
            }
        }
        (x, y) => [x.map(find).transpose()?, y.map(find).transpose()?, None],
    };
    let z = if with_normal { asked.z } else { None };
    let chosen = [chosen[0], chosen[1], z.map(find).transpose()?.or(chosen[2])];
    let why = "an acceleration has no unit of one: m/s^2, cm/s^2, ft/s^2, g or mg";
    let place = |i: Option<usize>| i.map(|i| sized(i, unit, Column::metres, why)).transpose();
    let [x, y, z] = chosen.map(place);
    let unstated = time_unit.is_none()
        && columns
            .get(time.0)
            .is_some_and(|column| column.unit.is_empty());
    let large = if unstated { 1e11 } else { f64::INFINITY };
    Ok(Places {
        time,
        axes: [x?, y?, z?],
        large,
    })
}

const SEVERAL: &str = "several columns are the acceleration along the same axis: choose";

/// What the head says of a column.
struct Column {
    words: Vec<String>,
    /// Its unit without what can be written in several ways; nothing where none is said.
    unit: String,
}

/// Parts of words for other things than the acceleration of the plane, though its name or unit may stand beside them.
const OTHER: [&str; 17] = [
    "ang", "gyr", "rot", "jerk", "vel", "speed", "err", "unc", "std", "sigma", "bias", "abs",
    "mag", "total", "norm", "max", "rms",
];

impl Column {
    fn of(name: &str) -> Self {
        let name = name
            .to_lowercase()
            .replace(['{', '}'], " ")
            .replace("g-force", "gforce")
            .replace("g force", "gforce")
            .replace('|', " abs ");
        // A letter in brackets is an axis, all else a unit.
        let (mut bare, mut unit) = (String::new(), String::new());
        for (k, part) in name.split(['(', '[', ')', ']']).enumerate() {
            match part.trim() {
                part if k % 2 == 0 || matches!(part, "x" | "y" | "z") => bare = bare + " " + part,
                part => unit = plain(part),
            }
        }
        let apart = |c: char| !c.is_alphanumeric();
        let words = bare.split(apart).filter(|word| !word.is_empty());
        let mut column = Self {
            words: words.map(str::to_owned).collect(),
            unit,
        };
        if column.unit.is_empty() {
            let last = |word: &String| axis(word).is_some() || is_acceleration(word);
            let behind = column
                .words
                .iter()
                .rposition(last)
                .map_or(column.words.len(), |k| k + 1);
            let tail = plain(&column.words[behind..].concat());
            let time = column
                .words
                .iter()
                .map(|word| plain(word))
                .find(|word| seconds(word).is_some());
            if of_acceleration(&tail).is_some() {
                column.unit = tail;
            } else if let Some(unit) = time.filter(|_| column.is_time()) {
                column.unit = unit;
            } else if bare.contains("/s") {
                column.unit = "/s".to_owned();
            } else if column.words.iter().any(|word| word.starts_with("gf")) {
                column.unit = "g".to_owned();
            }
        }
        column
    }

    fn is_time(&self) -> bool {
        let timely = |word: &String| {
            let known = [
                "elapsed", "since", "start", "run", "epoch", "unix", "zeit", "temps", "tiempo",
                "tempo",
            ];
            word == "t"
                || word.starts_with("time")
                || known.contains(&&word[..])
                || seconds(&plain(word)).is_some()
                || word.parse::<u32>().is_ok()
        };
        !self.words.is_empty() && self.words.iter().all(timely)
            || self.unit == "s"
            || self.unit.len() > 1 && seconds(&self.unit).is_some()
    }

    /// Whether it is one along this axis, by name or by unit; one along none where no axis is named.
    fn is_acceleration(&self, along: Option<char>) -> bool {
        let axis_of = |word: &String| axis(word).map(|(axis, _)| axis);
        let short = match &self.words[..] {
            [a] => a == "a",
            [a, next, ..] => a == "a" && axis_of(next).is_some(),
            [] => false,
        };
        let full = |word: &String| {
            is_acceleration(word) || axis(word).is_some_and(|(_, rest)| !rest.is_empty())
        };
        let named = short || self.words.iter().any(full);
        // Grams are written as g too, and gauss as G.
        let bare = |word: &String| matches!(&word[..], "x" | "y" | "axis");
        let sure = !self.unit.ends_with('g') || along.is_some() && self.words.iter().all(bare);
        let united = of_acceleration(&self.unit).is_some() && sure;
        let other = |word: &String| {
            OTHER.iter().any(|other| word.starts_with(other)) || !named && word.starts_with("grav")
        };
        self.words.iter().find_map(axis_of) == along
            && (named || united)
            && !self.words.iter().any(other)
    }

    fn seconds(&self) -> Option<f64> {
        if self.unit.is_empty() {
            Some(1.0)
        } else {
            seconds(&self.unit)
        }
    }

    fn metres(&self) -> Option<f64> {
        if self.unit.is_empty() {
            Some(1.0)
        } else {
            of_acceleration(&self.unit)
        }
    }
}

/// Whether a word means acceleration.
fn is_acceleration(word: &str) -> bool {
    let part = ["accel", "accél", "acel", "beschl", "gforce"];
    word == "gf" || word.ends_with("acc") || part.iter().any(|part| word.contains(part))
}

/// The axis of a word that is one, or a short form of acceleration with one, and what stands before it.
fn axis(word: &str) -> Option<(char, &str)> {
    let axis = word
        .chars()
        .last()
        .filter(|c| matches!(c, 'x' | 'y' | 'z'))?;
    let rest = word.strip_suffix(axis)?;
    ("acceleration".starts_with(rest) || is_acceleration(rest)).then_some((axis, rest))
}

/// A unit without what can be written in several ways.
pub(super) fn plain(unit: &str) -> String {
    let mut unit = unit.to_lowercase();
    unit.retain(|c| !c.is_whitespace() && !"^*.()[]{}·⋅".contains(c));
    for (long, short) in [
        ("metres", "m"),
        ("meters", "m"),
        ("metre", "m"),
        ("meter", "m"),
        ("per", "/"),
        ("squared", "2"),
        ("seconds", "s"),
        ("second", "s"),
        ("secs", "s"),
        ("sec", "s"),
        ("²", "2"),
        ("⁻", "-"),
        ("−", "-"),
        ("µ", "u"),
        ("μ", "u"),
    ] {
        unit = unit.replace(long, short);
    }
    unit
}

fn seconds(unit: &str) -> Option<f64> {
    Some(match unit {
        "s" => 1.0,
        "ms" | "millis" => 1e-3,
        "us" | "micros" => 1e-6,
        "ns" | "nanos" => 1e-9,
        "min" | "minutes" => 60.0,
        "h" | "hours" => 3600.0,
        _ => return None,
    })
}

pub(super) fn of_acceleration(unit: &str) -> Option<f64> {
    let (length, rest) = ["mm", "cm", "km", "ft", "in", "m"]
        .iter()
        .find_map(|length| Some((*length, unit.strip_prefix(length)?)))
        .unwrap_or(("", unit));
    let size = match length {
        "mm" => 1e-3,
        "cm" => 1e-2,
        "km" => 1e3,
        "ft" => 0.3048,
        "in" => 0.0254,
        _ => 1.0,
    };
    match (length, rest) {
        ("", "g" | "gn" | "g0") => Some(G),
        ("m", "g") => Some(1e-3 * G),
        ("", _) => None,
        (_, "/s2" | "/s/s" | "/ss" | "s-2" | "s2" | "ps2") => Some(size),
        _ => None,
    }
}

/// The standard acceleration of gravity, in m/s².
pub(crate) const G: f64 = 9.806_65;

#[cfg(test)]
mod tests {
    use super::*;

    const DATA: [(f64, [f64; 2]); 3] = [
        (0.0, [0.5, -0.1]),
        (10.0, [0.51, 0.0]),
        (20.0, [-1.5, 2e-3]),
    ];

    fn read(text: &str) -> Result<Vec<(f64, [f64; 2])>, FitError> {
        rows(text, &Columns::default())
    }

    #[test]
    fn a_file_is_read_right_however_it_is_written() {
        for text in [
            "t,ax,ay\n0,0.5,-0.1\n10,0.51,0\n20,-1.5,2e-3\n",
            "0,0.5,-0.1\r\n10,0.51,0\r\n\r\n20,-1.5,2E-3",
            "\u{feff}# made by hand\n0 0.5   -0.1\n10 0.51 0\n20 -1.5 0.002\n",
            "sep=;\nt; a_x; a_y\n0;0,5;−0,1\n10;0,51;0\n20;−1,5;2E-3\n",
            "sep=\t\r\n\"t\"\t\"ax\"\t\"ay\"\r\n\"0,0\"\t\"0,50\"\t\"-0,1\"\r\n10\t,51\t0\r\n20\t-1,5\t,002\r\n",
            "Zeit,y,x,Temperatur\ns,m/s²,m/s^2,K\n0,-0.1,0.5,\n10,0,0.51,NaN\n20,.002,-1.5,hot\n",
            "n,accY [m/s²],accX [m/s²],accZ [m/s²],t/s\n0,-0.1,0.5,9.8,0\n1,0,0.51,9.8,10\n2,.002,-1.5,9.8,20\n",
            "\"Time, elapsed (s)\",\"ax\",\"ay\"\n\"0\",\"0.5\",\"-0.1\"\n\"10\",\"0.51\",\"0\"\n\"20\",\"-1.5\",\"0.002\"\n",
        ] {
            assert_eq!(read(text), Ok(DATA.to_vec()), "{text}");
        }
        let one = |text| read(text).unwrap()[1];
        assert_eq!(one("time;a\n0;1\n2;3,5"), (2.0, [3.5, 0.0]));
        assert_eq!(one("t,ay\n0,1\n2,3"), (2.0, [0.0, 3.0]));
        assert_eq!(one("0,1\n2,3"), (2.0, [3.0, 0.0]));
        assert_eq!(read("# nothing"), Ok(Vec::new()));
    }

    /// The app writes five formats: a point behind commas, tabs and semicolons, a comma behind tabs and semicolons.
    #[test]
    fn all_formats_of_phyphox_are_read() {
        let head = ["x", "y", "z"].map(|x| format!("\"Linear Acceleration {x} (m/s^2)\""));
        let lines = [
            "0.000000000E0,5.000000000E-1,-1.000000000E-1,9.81E0,9.823E0",
            "1.000000000E1,5.100000000E-1,0.000000000E0,9.81E0,9.823E0",
            "2.000000000E1,-1.500000000E0,2.000000000E-3,NaN,NaN",
        ];
        let absolute = "\"Absolute acceleration (m/s^2)\"";
        let [x, y, z] = &head;
        let head = ["\"Time (s)\"", x, y, z, absolute].join(",");
        let lines = lines.join("\n");
        for (between, point) in [(",", "."), ("\t", "."), (";", "."), ("\t", ","), (";", ",")] {
            let [head, lines] = [&head, &lines].map(|part| part.replace(',', between));
            let file = format!("{head}\n{}\n", lines.replace('.', point));
            assert_eq!(read(&file), Ok(DATA.to_vec()), "{file}");
        }
    }

    #[test]
    fn what_is_not_clear_is_refused_with_its_line() {
        for (text, at) in [
            // Decimal commas between commas.
            ("t,ax\n0,5,0,1\n", 2),
            ("0,00,0,50\n10,00,0,51\n", 1),
            ("100,0,57\n110,0,58\n", 1),
            ("0 0,5\n10 0,6\n", 1),
            ("t,ax\n\"0,0\",\"1,5\"\n", 2),
            // Two decimal signs, thousands.
            ("t;ax\n0;0,5\n1.000;0,6\n", 3),
            ("t;ax\n1.000,5;1\n", 2),
            ("t;ax\n0;1,000.5\n", 2),
            ("t,ax\n999.0,1\n1,000.0,2\n", 3),
            ("t;ax\n0;1\n1;1 000\n2;3\n", 3),
            ("t;ax\n0;1\n1;1'000\n", 3),
            // Cells that are empty, no number, too many or too few.
            ("t,ax,ay\n0,1,2\n1,,2\n", 3),
            ("# a\n\n0.5,1,2\n1.5,1,\n", 4),
            ("t,ax\n0,1\n1,NaN\n2,3\n", 3),
            ("t,ax\n0,1\n1,2\n,\n2,NaN\n3,1", 4),
            ("NaN,NaN\n1,2\n", 1),
            ("0.5,inf\n", 1),
            ("0.5,1e51\n", 1),
            ("0.5,1,2\n1.5,1\n", 2),
            ("t,ax\n0,1\n1,2,3\n", 3),
            ("t,a\n1,2\n3,x\n", 3),
            ("t,ax\nt,ax\n", 1),
            ("t,ax\n,\n0,1\n", 2),
            ("1\n", 1),
            ("1.5,2,3,4\n", 1),
            ("t,ax\n01/31/2026 10:00:00,1\n", 2),
            // Times.
            ("t,ax\n0,1\n0,2\n", 3),
            ("t,ax\n1,1\n\n0,2\n", 4),
            // Units and names.
            ("time,ax,ay\ns,m/s^2\n0,1,2\n", 1),
            ("time,seconds_elapsed,z,y,x\n1,1,1,1,1\n", 1),
            ("t,a,b\n0,1,2\n", 1),
            ("t,az\n0,1\n", 1),
            ("ax,ay\n0,1\n", 1),
        ] {
            let refused = read(text).unwrap_err();
            assert!(
                matches!(refused, FitError::Line { line, .. } if line == at),
                "{text}: {refused}"
            );
        }
    }

    /// One column, whatever stands beside it.
    fn alone(head: &str) -> Result<f64, FitError> {
        Ok(read(&format!("Time (s);{head};note\n0.5;1;3\n"))?[0].1[0])
    }

    #[test]
    fn an_acceleration_is_one_by_its_name_or_its_unit() {
        for head in [
            "ax",
            "a_x",
            "aX",
            "Acc X",
            "acc.x",
            "accX",
            "AcX",
            "accel_x",
            "x accel",
            "LinearAccelerationX",
            "a_{x}",
            "acceleration",
            "Acceleration - x (m/s²) Run #1",
            "Latest: X Acceleration (m/s²)",
            "x (m/s^2)",
            "x-axis [m s⁻²]",
            "Beschleunigung x",
            "userAccelX",
            "Acceleration (x)",
            "acc x m/s2",
            "ax_m_s2",
            "x (meters per second squared)",
            "x (m/sec/sec)",
            "user acceleration without gravity x",
        ] {
            assert_eq!(alone(head), Ok(1.0), "{head}");
        }
        for (head, size) in [
            ("ax (g)", G),
            ("gFx", G),
            ("G-Force X", G),
            ("x-axis (g)", G),
            ("accel_x_g", G),
            ("accelerometerAccelerationX(G)", G),
            ("ax [mg]", 1e-3 * G),
            ("ax (cm/s^2)", 1e-2),
            ("accel x (ft/s²)", 0.3048),
        ] {
            assert_eq!(alone(head), Ok(size), "{head}");
        }
        for head in [
            "x",
            "y",
            "vx",
            "v_x",
            "velocity_x",
            "velocity x (m/s)",
            "v",
            "speed",
            "position",
            "x (m)",
            "x_m",
            "gyro_x",
            "gx",
            "gyroX (rad/s)",
            "mag_x",
            "magnetic field x (µT)",
            "B_x (G)",
            "jerk_x",
            "jerk x (m/s³)",
            "force x",
            "F_x (N)",
            "temperature",
            "T (K)",
            "weight (g)",
            "angular acceleration x",
            "alpha_x",
            "accuracy_x",
            "ax_err",
            "acc_x uncertainty",
            "gravity x (m/s²)",
            "|a|",
            "absolute acceleration (m/s²)",
            "height of a ball",
            "current (A)",
            "lux",
            "delay",
            "max",
            "pressure",
            "az",
            "acceleration z (m/s²)",
            "accel x (deg/s)",
            "ax (V)",
            "acc x m/s",
        ] {
            let refused = alone(head);
            assert!(
                matches!(refused, Err(FitError::Line { line: 1, .. })),
                "{head}: {refused:?}"
            );
        }
    }

    #[test]
    fn of_many_columns_those_of_the_acceleration_are_taken() {
        let row =
            |head: &str, numbers: &str| read(&format!("{head}\n{numbers}\n")).map(|rows| rows[0]);
        for (head, numbers, t, a) in [
            (
                "time,accel_x,accel_y,accel_z,gyro_x,gyro_y,gyro_z",
                "1,2,3,9.8,7,7,7",
                1.0,
                [2.0, 3.0],
            ),
            ("t\tx\tv_{x}\ta_{x}", "1\t2\t3\t4", 1.0, [4.0, 0.0]),
            ("Time (ms),ax", "250,2", 0.25, [2.0, 0.0]),
            ("millis;ay;temperature", "250;2;20", 0.25, [0.0, 2.0]),
            ("timestamp_us,ax", "250000,2", 0.25, [2.0, 0.0]),
            (
                "time,seconds_elapsed,ax",
                "1767767458048101000,2.5,4",
                2.5,
                [4.0, 0.0],
            ),
            (
                "epoch (ms),time (-13:00),elapsed (s),x-axis (g),z-axis (g)",
                "1767767458048,12:00,2.5,1,9",
                2.5,
                [G, 0.0],
            ),
            ("time,ax,ay\nms,m/s^2,g", "500,1,1", 0.5, [1.0, G]),
            ("# t ax ay", "0.5 1 2", 0.5, [1.0, 2.0]),
            ("# by numpy\n# t,ax,ay", "0.5,1,2", 0.5, [1.0, 2.0]),
        ] {
            assert_eq!(row(head, numbers), Ok((t, a)), "{head}");
        }
        for (head, numbers) in [
            ("time,z,y,x", "1,2,3,4"),
            ("t,ax,accel_x", "1,2,3"),
            ("time_s,elapsed (s),ax", "1,2,3"),
            ("Time (hh:mm),ax", "1,2"),
            ("# t vx vy", "0.5 1 2"),
            ("# t,x,y", "0.5,1,2"),
        ] {
            assert!(
                matches!(row(head, numbers), Err(FitError::Line { .. })),
                "{head}"
            );
        }
        for (file, at, what) in [
            ("time,ax\n1767767458048101000,1\n", 2, "unit"),
            ("time,ax\n10:00:00.5,1\n11.5,1\n", 3, "clock"),
            ("t,ax\n0,1\n1,2\n2,NaN\n3,1\n", 4, "number"),
            ("t,ax\n0,1\n1,2\n2,3\n3,1\n4,1\n13,1\n14,1\n", 7, "gap"),
            ("t,vx\r0,1\r1,2\r", 1, "acceleration"),
        ] {
            let Err(FitError::Line { line, why, .. }) = read(file) else {
                panic!("{file}")
            };
            assert!(line == at && why.contains(what), "{file}: {line} {why}");
        }
        assert_eq!(read("t,ax\r0,1\r1,2\r").map(|rows| rows.len()), Ok(2));
    }

    /// Files as MATLAB Mobile, a logger of two sensors and phyphox write them.
    #[test]
    fn what_apps_write_is_read_with_the_normal() {
        let of = |text: &str, columns: Columns| Recording::from_csv(text, &columns).unwrap();
        let (x, y, z) = (Some("x"), Some("y"), Some("z"));
        let matlab =
            "Timestamp,X,Y,Z\n31-Jan-2026 23:59:59.990,1,2,9\n01-Feb-2026 00:00:00.000,3,4,8\n";
        let columns = Columns {
            x,
            y,
            z,
            ..Columns::default()
        };
        let read = of(matlab, columns);
        assert!((read.rows[1].0 - 0.01).abs() < 1e-9 && read.rows[1].1 == [3.0, 4.0]);
        assert_eq!(read.normal, Some(vec![9.0, 8.0]));
        assert!(Recording::from_csv(matlab, &Columns::default()).is_err());
        // Lines of the other sensor between, a tail without values.
        let merged = "t,accel_x,accel_y,accel_z,gyro_x\n0,1,2,9,\n0.1,,,,5\n0.2,3,4,8,\n0.3,NaN,NaN,NaN,NaN\n";
        let right = vec![(0.0, [1.0, 2.0]), (0.2, [3.0, 4.0])];
        for columns in [
            Columns::default(),
            Columns {
                x: Some("accel_x"),
                y: Some("3"),
                z: Some("accel_z"),
                ..Columns::default()
            },
        ] {
            let read = of(merged, columns);
            assert_eq!(
                (read.rows, read.normal),
                (right.clone(), Some(vec![9.0, 8.0]))
            );
        }
        let gforce = of("time,gFx,gFy,gFz,TgF\n0,0,0.5,1,1.1\n", Columns::default());
        assert_eq!(
            (gforce.rows[0].1, gforce.normal),
            ([0.0, 0.5 * G], Some(vec![G]))
        );
        assert_eq!(of("t,ax\n0,1\n", Columns::default()).normal, None);
        let gap = "t,ax\n0,1\n1,2\n2,3\n3,1\n4,1\n13,1\n14,1\n";
        assert_eq!(
            of(
                gap,
                Columns {
                    gaps: true,
                    ..Columns::default()
                }
            )
            .rows
            .len(),
            7
        );
    }

    #[test]
    fn columns_and_units_can_be_given() {
        let file = "time,seconds_elapsed,z,y,x (m)\n2000,0.5,9.8,3,2\n";
        let with = |columns: Columns| rows(file, &columns).map(|rows| rows[0]);
        let (x, y) = (Some("X"), Some("y"));
        let unit = Some("m/s²");
        assert_eq!(
            with(Columns {
                x,
                y,
                unit,
                ..Columns::default()
            }),
            Ok((0.5, [2.0, 3.0]))
        );
        let time = Some("time");
        let chosen = Columns {
            time,
            y: Some("4"),
            time_unit: Some("ms"),
            unit: Some("g"),
            ..Columns::default()
        };
        assert_eq!(with(chosen), Ok((2.0, [0.0, 3.0 * G])));
        let headless = Columns {
            time: Some("2"),
            x: Some("1"),
            ..Columns::default()
        };
        assert_eq!(rows("5 0.5 7 8", &headless), Ok(vec![(0.5, [5.0, 0.0])]));
        for wrong in [
            // Its head says m.
            Columns {
                x,
                ..Columns::default()
            },
            Columns {
                y: Some("w"),
                ..Columns::default()
            },
            Columns {
                y: Some("6"),
                ..Columns::default()
            },
            Columns {
                y: Some("0"),
                ..Columns::default()
            },
            Columns {
                y,
                unit: Some("m/s"),
                ..Columns::default()
            },
            Columns {
                y,
                time_unit: Some("m"),
                ..Columns::default()
            },
        ] {
            assert!(
                matches!(with(wrong), Err(FitError::Line { line: 1, .. })),
                "{wrong:?}"
            );
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
