//! Plots of an answer: an SVG file, or dots of Braille in the terminal.

use crate::figures;
use crate::numerics::error::plain as number;
use crate::solve::Curve;
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use trialbook::cli::bare;
use trialbook::publishing::Failure;

/// Where an SVG goes: a file, or `-` for standard output.
pub(super) fn place(name: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(name);
    let svg = |end: &OsStr| end.eq_ignore_ascii_case("svg");
    match name == STDOUT || path.extension().is_some_and(svg) {
        true => Ok(path),
        false => Err(
            "it draws SVG: FILE.svg, `-` for standard output, or no name for a plot in text"
                .to_owned(),
        ),
    }
}

/// Standard output by its name as a file.
pub(super) const STDOUT: &str = "-";

/// The plot as SVG.
pub(super) fn svg(curve: &Curve) -> Result<String, Failure> {
    Ok(figures::solve::figure(curve)?.svg)
}

/// Writes a plot into a file, which is replaced whole; a link is followed. What is there and no file is left alone.
pub(super) fn to_file(svg: &str, file: &Path) -> Result<(), Failure> {
    let failed = |error: io::Error| format!("cannot write `{}`: {}", file.display(), bare(error));
    let mut making = tempfile::Builder::new();
    let place = if file.symlink_metadata().is_ok() {
        let old = file.metadata().map_err(failed)?;
        if !old.is_file() {
            return Err(
                format!("cannot write `{}`: it is no ordinary file", file.display()).into(),
            );
        }
        making.permissions(old.permissions());
        file.canonicalize().map_err(failed)?
    } else {
        #[cfg(unix)]
        making.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        file.to_owned()
    };
    let folder = match place.parent() {
        Some(parent) if parent.as_os_str().is_empty() => Path::new("."),
        Some(parent) => parent,
        None => return Err(format!("`{}` is no name of a file", file.display()).into()),
    };
    if !folder.is_dir() {
        return Err(format!("cannot write `{}`: there is no such folder", file.display()).into());
    }
    let mut new = making.tempfile_in(folder).map_err(failed)?;
    new.write_all(svg.as_bytes()).map_err(failed)?;
    new.persist(&place).map_err(|error| failed(error.error))?;
    Ok(())
}

/// Width and height of a terminal's plot in characters, each of 2 × 4 dots.
const SIZE: [usize; 2] = [64, 18];

/// The plot as text.
pub(super) fn as_text(curve: &Curve) -> String {
    let range = |axis: usize| {
        let values = || curve.points.iter().map(|p| p[axis]);
        let (low, high) = (
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        );
        let room = if high > low {
            0.0
        } else {
            0.5 * high.abs().max(1.0)
        };
        (low - room, high + room)
    };
    let ranges = [range(0), range(1)];
    let dots = [2 * SIZE[0] - 1, 4 * SIZE[1] - 1];
    let place = |point: &[f64; 2]| {
        [0, 1].map(|i| (point[i] - ranges[i].0) / (ranges[i].1 - ranges[i].0) * dots[i] as f64)
    };
    let mut cells = vec![0_u8; SIZE[0] * SIZE[1]];
    for pair in curve.points.windows(2) {
        let (from, to) = (place(&pair[0]), place(&pair[1]));
        let length = libm::fmax((to[0] - from[0]).abs(), (to[1] - from[1]).abs());
        let steps = libm::ceil(length).max(1.0) as usize;
        for step in 0..=steps {
            let share = step as f64 / steps as f64;
            let [x, y] = [0, 1].map(|i| libm::round(from[i] + share * (to[i] - from[i])) as usize);
            let y = dots[1] - y;
            cells[y / 4 * SIZE[0] + x / 2] |= DOTS[y % 4][x % 2];
        }
    }
    let [x, y] = curve.labels();
    let mut text = format!("\n{}: {y} against {x}\n", curve.title);
    // What is nothing beside the other end of its axis is rounding.
    let short = |axis: usize, end: fn((f64, f64)) -> f64| {
        let (low, high) = ranges[axis];
        let x = end(ranges[axis]);
        let shown = if x.abs() < 1e-9 * (high - low) {
            0.0
        } else {
            x
        };
        number(format!("{shown:.3e}").parse().unwrap_or(shown))
    };
    for (n, row) in cells.chunks(SIZE[0]).enumerate() {
        let label = match n {
            0 => short(1, |ends| ends.1),
            n if n + 1 == SIZE[1] => short(1, |ends| ends.0),
            _ => String::new(),
        };
        let dots: String = row
            .iter()
            .filter_map(|c| char::from_u32(0x2800 + u32::from(*c)))
            .collect();
        text += &format!("{label:>10} ┤{dots}\n");
    }
    let (left, right) = (short(0, |ends| ends.0), short(0, |ends| ends.1));
    let width = SIZE[0].saturating_sub(left.chars().count());
    text + &format!("{:>12}{left}{right:>width$}\n", "")
}

/// The bits of a Braille character by row and column.
const DOTS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

#[cfg(test)]
mod tests {
    use super::*;

    /// The first and the last dots of the first and the last row.
    fn corners(points: [[f64; 2]; 2]) -> [[char; 2]; 2] {
        let curve = Curve {
            title: "A line",
            x: "x",
            y: "y",
            units: ["m"; 2],
            equal: false,
            points: points.into(),
        };
        let text = as_text(&curve);
        let rows: Vec<_> = text.lines().filter_map(|row| row.split_once('┤')).collect();
        assert_eq!(rows.len(), SIZE[1]);
        let (low, high) = (rows[SIZE[1] - 1], rows[0]);
        assert_eq!([low.0.trim(), high.0.trim()], ["-1", "3"]);
        let across = text.lines().last().unwrap().split_whitespace();
        assert_eq!(across.collect::<Vec<_>>(), ["0", "5"]);
        [high.1, low.1].map(|dots| {
            let dots: Vec<_> = dots.chars().collect();
            [dots[0], dots[dots.len() - 1]]
        })
    }

    #[test]
    fn up_is_up_and_right_is_right() {
        let none = '\u{2800}';
        // From the lowest dot of the first column to the highest of the last one.
        let [[a, high], [low, b]] = corners([[0.0, -1.0], [5.0, 3.0]]);
        assert!([a, b] == [none; 2] && high != none && low != none);
        assert_eq!(
            [u32::from(low) & 0x40, u32::from(high) & 0x08],
            [0x40, 0x08]
        );
        let [[high, a], [b, low]] = corners([[0.0, 3.0], [5.0, -1.0]]);
        assert!([a, b] == [none; 2] && high != none && low != none);
        assert_eq!(
            [u32::from(low) & 0x80, u32::from(high) & 0x01],
            [0x80, 0x01]
        );
    }
}
