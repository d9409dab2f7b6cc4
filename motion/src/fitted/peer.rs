//! Records of earthquakes as PEER's data bases write them (`.AT2`): some lines of head, then values in g, several a line.

use super::{
    Columns, FitError, LARGEST,
    cells::{of_acceleration, plain, refuse},
};

type Rows = Vec<(f64, [f64; 2])>;

/// Among which the number and the step of the values are said.
const HEAD: usize = 10;

/// Along x, if these are lines of such a record.
pub(super) fn rows<'a>(
    lines: impl Iterator<Item = &'a str>,
    asked: &Columns,
) -> Option<Result<Rows, FitError>> {
    let mut lines = (1..).zip(lines);
    let mut unit = None;
    for (n, line) in lines.by_ref().take(HEAD) {
        let line = line.to_uppercase();
        if let Some((what, rest)) = line.split_once("UNITS OF") {
            let word = rest.split_whitespace().next().unwrap_or("");
            unit = of_acceleration(&plain(word)).filter(|_| what.contains("ACCEL"));
        }
        if line.contains("NPTS") && line.contains("DT") {
            let unit = match asked.unit {
                Some(unit) => of_acceleration(&plain(unit)),
                None => unit,
            };
            return Some(values(n, &line, lines, unit, asked));
        }
    }
    None
}

fn values<'a>(
    head: usize,
    said: &str,
    lines: impl Iterator<Item = (usize, &'a str)>,
    unit: Option<f64>,
    asked: &Columns,
) -> Result<Rows, FitError> {
    let numbers: Vec<f64> = said
        .split(|c: char| c.is_whitespace() || matches!(c, ',' | '='))
        .filter_map(|word| word.parse().ok())
        .collect();
    let whole = |n: f64| n >= 0.0 && n.fract() == 0.0;
    let (count, step) = match numbers[..] {
        [count, step] if whole(count) && step > 0.0 && step <= LARGEST => (count, step),
        _ => return Err(refuse(head, said, "it has to say NPTS and DT, two numbers")),
    };
    let Some(unit) = unit else {
        let why = "the head has to say that these are accelerations, and in which unit: else give the unit";
        return Err(refuse(head, said, why));
    };
    if [asked.time, asked.x, asked.y, asked.z, asked.time_unit] != [None; 5] {
        let why = "a record of PEER's has no columns to choose: all of it is along x";
        return Err(refuse(head, said, why));
    }
    let mut rows = Vec::new();
    for (n, line) in lines {
        for word in line.split_whitespace() {
            let value = word
                .parse()
                .ok()
                .filter(|value: &f64| value.abs() <= LARGEST);
            let value = value.ok_or_else(|| refuse(n, line, "not all of it is numbers"))?;
            rows.push((step * rows.len() as f64, [unit * value, 0.0]));
        }
    }
    if rows.len() as f64 != count {
        let why = "NPTS is not how many numbers follow: the file has been cut or joined";
        return Err(refuse(head, said, why));
    }
    Ok(rows)
}
