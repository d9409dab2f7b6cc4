//! The numbers behind a figure, and what a curve does.

use slipbook::figures::all;
use std::sync::LazyLock;
use trialbook::plotting::Figure;

/// All figures.
pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| all().unwrap());

/// The numbers behind a figure, and its drawing.
pub struct Data(pub Vec<Vec<String>>, String);

impl Data {
    pub fn of(figure: &Figure) -> Self {
        let rows = figure.csv.lines().skip(1);
        let cells = |row: &str| row.split(',').map(str::to_owned).collect();
        Data(rows.map(cells).collect(), figure.svg.clone())
    }

    /// The rows with the same first cell, in order; of each the cells as numbers, NaN for words.
    pub fn groups(&self) -> Vec<(String, Vec<Vec<f64>>)> {
        let mut groups: Vec<(String, Vec<Vec<f64>>)> = Vec::new();
        for row in &self.0 {
            let numbers = row
                .iter()
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect();
            match groups.iter_mut().find(|(name, _)| *name == row[0]) {
                Some((_, rows)) => rows.push(numbers),
                None => groups.push((row[0].clone(), vec![numbers])),
            }
        }
        groups
    }

    /// The keys below the panels that begin so: what follows, and whether the line beside it is dashed.
    pub fn keys(&self, begin: &str) -> Vec<(&str, bool)> {
        let lines = self.1.split("<path d=\"M1 -5H29\"").skip(1);
        let keys = lines.filter_map(|line| {
            let (drawn, after) = line.split_once("/>")?;
            let key = after
                .split_once("<text x=\"36\" y=\"0\">")?
                .1
                .split('<')
                .next()?;
            Some((key.strip_prefix(begin)?, drawn.contains("dasharray")))
        });
        keys.collect()
    }

    /// All rows as numbers.
    pub fn rows(&self) -> Vec<Vec<f64>> {
        self.groups()
            .into_iter()
            .flat_map(|(_, rows)| rows)
            .collect()
    }
}

pub fn column(rows: &[Vec<f64>], i: usize) -> Vec<f64> {
    rows.iter().map(|row| row[i]).collect()
}

pub fn rises(x: &[f64]) -> bool {
    x.len() > 1 && x.windows(2).all(|pair| pair[0] < pair[1])
}

pub fn falls(x: &[f64]) -> bool {
    x.len() > 1 && x.windows(2).all(|pair| pair[0] > pair[1])
}

/// Whether a slope grows along a curve.
pub fn steepens(rows: &[Vec<f64>], x: usize, y: usize) -> bool {
    let slope = |pair: &[Vec<f64>]| (pair[1][y] - pair[0][y]) / (pair[1][x] - pair[0][x]);
    let slopes: Vec<f64> = rows.windows(2).map(slope).collect();
    slopes.len() > 1 && slopes.windows(2).all(|pair| pair[0] <= pair[1])
}

/// The largest value of a column, and where it is taken.
pub fn peak(rows: &[Vec<f64>], x: usize, y: usize) -> [f64; 2] {
    let higher = |best: [f64; 2], row: &Vec<f64>| {
        if row[y] > best[1] {
            [row[x], row[y]]
        } else {
            best
        }
    };
    rows.iter().fold([f64::NAN, f64::NEG_INFINITY], higher)
}
