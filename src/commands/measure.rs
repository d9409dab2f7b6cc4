//! `measure`: coefficients of friction from a recording.

use super::{Json, sweep::aligned};
use crate::motion::{
    Columns, Recording,
    measure::{Interval, Measured, Settings, Stretch, Unfound, Verdict, measure},
};
use crate::numerics::error::plain;
use crate::scene::{MetrePerSecond2, Second, columns};
use clap::{Arg, ArgMatches, Command};
use serde_json::{Value, json as object};
use trialbook::cli::{VERSION, bare, csv, screen};
use trialbook::publishing::{Failure, Format};

const ABOUT: &str = "Find the coefficients of friction in a recording of an accelerometer

The sensor lies on the body that slides, or is it, as a phone does: then it feels the force of contact on each kilogram, however the
floor is shaken or tilted, and a slip is a plateau. One that lies on the floor records the floor: `scene block --record` says what a
block does on it. phyphox, Physics Toolbox, Vernier, PASCO, Tracker and PEER files are read; where the heads do not say which columns are accelerations,
--columns does: those of Sensor Logger and MATLAB Mobile are x=x,y=y,z=z, for their gyroscopes have the same heads.";

pub(super) fn command() -> Command {
    Command::new("measure")
        .about("Find the coefficients of friction in a recording of an accelerometer on the body")
        .long_about(ABOUT)
        .after_help("Examples:\n  slipbook measure phone.csv\n  slipbook measure logger.csv --columns x=accel_x,z=accel_z,unit=g --rest 0s:2s --csv\n\nExit code 1 where no slip is found, or what may be one may be a rest on a tilted floor.")
        .args([
            Arg::new("file").required(true).value_name("FILE").help("The recording: a text of columns"),
            Arg::new("columns").long("columns").value_name("NAME=COLUMN,…").help("Columns by their heads or numbers from 1: time, x, y, and z across the floor; unit and time-unit are their units; gaps=bridge goes on over gaps"),
            Arg::new("rest").long("rest").value_name("FROM:TO").help("Times between which it lay at rest on level floor, which show the zeros of the sensor"),
            Arg::new("g").long("g").value_name("ACCELERATION").default_value("9.80665m/s^2").help("The acceleration of gravity"),
        ])
}

/// The text of a recording.
pub(super) fn content(file: &str) -> std::io::Result<String> {
    std::fs::read(file).map(Recording::decoded)
}

pub(super) fn run(matches: &ArgMatches, format: Format, json: Json) -> Result<u8, Failure> {
    let text = |name| matches.get_one::<String>(name).map(String::as_str);
    let file = text("file").ok_or("a file is missing")?;
    let content =
        content(file).map_err(|error| format!("cannot read `{file}`: {}", bare(error)))?;
    let asked = text("columns").map_or(Ok(Columns::default()), columns)?;
    let recording = Recording::from_csv(&content, &asked)?;
    let rest =
        match text("rest").map(|rest| rest.split_once(':').ok_or("--rest: FROM:TO is wanted")) {
            Some(ends) => {
                let (from, to) = ends?;
                Some([from.parse::<Second>()?.0, to.parse::<Second>()?.0])
            }
            None => None,
        };
    let g = text("g").unwrap_or_default().parse::<MetrePerSecond2>()?.0;
    let found = measure(
        &recording,
        &Settings {
            g,
            rest,
            ..Settings::default()
        },
    )?;
    match format {
        Format::Text => json(&Value::String(told(&found)))?,
        Format::Csv => {
            let row = |what: &str, ends: Option<[f64; 2]>, unit: &str, note: String| {
                let [from, to] =
                    ends.map_or([String::new(), String::new()], |ends| ends.map(plain));
                vec![what.to_owned(), from, to, unit.to_owned(), note]
            };
            let coefficient = |name, found: &Result<Interval, Unfound>| match found {
                Ok(at) => row(name, Some([at.from, at.to]), "", String::new()),
                Err(why) => row(name, None, "", why.to_string()),
            };
            let mut rows = vec![
                coefficient("mu_k", &found.kinetic),
                coefficient("mu_s", &found.holding),
                row("coulomb", None, "", found.verdict.to_string()),
                row("noise", Some([found.noise; 2]), "m/s^2", String::new()),
                row("assumed", None, "", found.assumed().unwrap_or_default()),
            ];
            let stretch = |stretch: &Stretch| {
                let ends = Some([stretch.from, stretch.to]);
                row(&stretch.kind.to_string(), ends, "s", String::new())
            };
            rows.extend(found.stretches.iter().map(stretch));
            csv(&["what", "from", "to", "unit", "note"], rows)?;
        }
        Format::Json => {
            let ends = |found: &Result<Interval, Unfound>| match found {
                Ok(interval) => object!([interval.from, interval.to]),
                Err(_) => Value::Null,
            };
            let why =
                |found: &Result<Interval, Unfound>| found.as_ref().err().map(ToString::to_string);
            json(&object!({
                "version": VERSION,
                "mu_k": ends(&found.kinetic),
                "mu_s": ends(&found.holding),
                "why": [why(&found.kinetic), why(&found.holding)],
                "coulomb": matches!(found.verdict, Verdict::Fits),
                "verdict": found.verdict.to_string(),
                "noise": found.noise,
                "assumed": found.assumed().unwrap_or_default(),
                "stretches": found.stretches.iter().map(|stretch| object!({ "from": stretch.from, "to": stretch.to, "doing": stretch.kind.to_string() })).collect::<Vec<_>>(),
            }))?;
        }
    }
    Ok(u8::from(found.kinetic.is_err()))
}

fn told(found: &Measured) -> String {
    let number = |found: &Result<Interval, Unfound>| match found {
        Ok(found) => format!("{found}, with a probability of 95 %"),
        Err(why) => format!("not found: {why}"),
    };
    let cells = |stretch: &Stretch| {
        let times = [stretch.from, stretch.to].map(|t| format!("{t:.3}"));
        let [from, to] = times;
        vec![from, to, stretch.kind.to_string(), String::new()]
    };
    let rows: Vec<_> = found.stretches.iter().take(SHOWN).map(cells).collect();
    let mut text = format!(
        "μ_k      {}\nμ_s      {}\nCoulomb  {}\nnoise    {} m/s²\nzeros    {}\nN/m      {}\nassumed  {}\n\n",
        number(&found.kinetic),
        number(&found.holding),
        found.verdict,
        plain(
            format!("{:.1e}", found.noise)
                .parse()
                .unwrap_or(found.noise)
        ),
        if found.zeroed {
            "from a rest"
        } else {
            "unknown: --rest says when it lay at rest on level floor"
        },
        if found.normal {
            "as measured along z"
        } else {
            "taken for g"
        },
        found.assumed().as_deref().unwrap_or("nothing"),
    );
    text += &aligned(&["from (s)", "to (s)", "", ""], 0, &rows, screen().width);
    if let Some(more) = found.stretches.len().checked_sub(SHOWN + 1) {
        text += &format!("{} more, which --csv lists\n", more + 1);
    }
    text
}

/// How many stretches are shown.
const SHOWN: usize = 20;
