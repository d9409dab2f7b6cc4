//! `fates`: maps of proved fates on the turntable.

use super::axis::{Axis, Point};
use crate::claims::rest::fates::{HEAD, REACH, Row, STRIPS, map, open};
use clap::Args;
use serde_json::{Value, json as object};
use trialbook::cli::{VERSION, csv, json, progress, say};
use trialbook::edition::{Failure, Format};

/// Which maps.
#[derive(Debug, Args)]
pub(super) struct Fates {
    /// A, from 0.4 to 0.95, to six decimals
    #[arg(
        id = "A",
        long = "A",
        value_name = "RANGE",
        default_value = "0.5:0.9:3"
    )]
    a: Axis,
}

impl Fates {
    pub(super) fn run(&self, format: Format) -> Result<u8, Failure> {
        let bar = progress(
            self.a.count() * STRIPS as u64,
            "{bar:40} {pos}/{len} strips  {eta} left",
        );
        let maps: Result<Vec<_>, Failure> = (0..self.a.count())
            .map(|i| Ok(map(Point::new(i).on("A", &self.a).into(), || bar.inc(1))?))
            .collect();
        bar.finish_and_clear();
        let maps = maps?;
        match format {
            Format::Text => say(&maps
                .iter()
                .map(|map| summary(map))
                .collect::<Vec<_>>()
                .join("\n"))?,
            Format::Json => json(&object!({
                "version": VERSION,
                "reach": REACH,
                "maps": maps.iter().map(|map| value(map)).collect::<Vec<_>>(),
            }))?,
            Format::Csv => csv(&HEAD, maps.concat().iter().map(|row| row.cells().to_vec()))?,
        }
        Ok(0)
    }
}

fn summary(map: &[Row]) -> String {
    let a = map.first().map_or(f64::NAN, |row| row.a);
    format!(
        "A = {a}: rest and escape are proved for all α up to {REACH} and all ψ, but for {:.3} % of them, along a line in {} parts",
        100.0 * open(map),
        map.len()
    )
}

fn value(map: &[Row]) -> Value {
    let rows: Vec<_> = map
        .iter()
        .map(|row| {
            object!({
                "psi": row.psi, "line": row.line, "rest": row.margins.rest, "escape": row.margins.escape,
            })
        })
        .collect();
    object!({ "A": map.first().map(|row| row.a), "open": open(map), "strips": rows })
}
