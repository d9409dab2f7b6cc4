//! `ensemble`: where many particles on the turntable end, one line each, written while the others are still on
//! their way.

use super::{
    axis::{Axis, Point, is_it_degrees},
    pieces::{Stop, end, in_pieces, told},
};
use crate::numerics::error::plain as number;
use crate::solve::{
    Double, RADIANS, head, known,
    turntable::{End, Horizon, LENGTH, MotionError, SPEED, Start, TIME},
};
use clap::Args;
use rayon::prelude::*;
use serde_json::json;
use std::collections::BTreeMap;
use std::io::{self, BufWriter, Write};
use trialbook::cli::{Shard, VERSION, ascii, bom, complain};
use trialbook::publishing::{Failure, Format};

/// The least and the most starts that are followed together; after each such piece the rows are written.
const PIECES: [u64; 2] = [1 << 12, 1 << 16];

/// The starts, and how far they are followed.
#[derive(Debug, Args)]
pub(super) struct Ensemble {
    /// Distances ρ of the starts from the axis, in units of μg/Ω²: one, several between commas, LOW:HIGH:COUNT, or LOW:HIGH:COUNT:log for equal ratios
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    rho: Axis,
    /// Speeds p relative to the table, in units of μg/Ω
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    p: Axis,
    /// Angles ψ from the velocity to the position, in radians; `120deg` are degrees
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    psi: Axis,
    /// Distance at which a particle counts as gone, in units of μg/Ω²
    #[arg(
        long,
        value_name = "RHO",
        default_value_t = 100.0,
        allow_negative_numbers = true
    )]
    far: f64,
    /// Time up to which it is followed, in units of 1/Ω
    #[arg(
        long,
        value_name = "TAU",
        default_value_t = 50.0,
        allow_negative_numbers = true
    )]
    late: f64,
    /// Only the K-th of N equal parts of the grid; the N parts, put together in order, are the whole, byte for byte
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
}

/// The units of a row's numbers.
const UNITS: [(&str, &str); 5] = [
    ("rho", LENGTH),
    ("p", SPEED),
    ("psi", RADIANS),
    ("sigma", LENGTH),
    ("tau", TIME),
];

/// How many ended how.
#[derive(Debug, Default)]
struct Counts {
    done: u64,
    rest: u64,
    far: u64,
    bad: u64,
}

impl Counts {
    fn take(&mut self, end: &Result<End, String>) {
        self.done += 1;
        self.rest += u64::from(matches!(end, Ok(End::Rest { .. })));
        self.far += u64::from(matches!(end, Ok(End::Far { .. })));
        self.bad += u64::from(end.is_err());
    }
}

impl Ensemble {
    pub(super) fn run(&self, format: Format) -> Result<u8, Failure> {
        let total = [self.p.count(), self.psi.count()]
            .iter()
            .try_fold(self.rho.count(), |n, m| n.checked_mul(*m))
            .ok_or("rho, p and psi: more than 2⁶⁴ starts together")?;
        let shard = self.shard.unwrap_or(Shard::WHOLE);
        if self.shard.is_some() && format == Format::Text {
            return Err("--shard goes with --csv or --json, whose parts can be joined".into());
        }
        for (name, value) in [("--far", self.far), ("--late", self.late)] {
            if !(value > 0.0 && value <= 1e6) {
                let value = number(value);
                return Err(format!("{name} = {value} must be positive, at most 1e6").into());
            }
        }
        let horizon = Horizon {
            rho: self.far,
            tau: self.late,
        };
        // What is out of range is a row that says so; where there is no other row, a failure.
        if total == 1 {
            horizon.follow(&[start(self.place(0))?])?.remove(0)?;
        }
        if let Some(warning) = is_it_degrees("psi", &self.psi) {
            complain("slipbook", &warning);
        }
        let mut writer = Writer {
            format,
            out: BufWriter::new(io::stdout()),
            shard,
        };
        let followed = self.follow(total, &horizon, &mut writer);
        followed.or_else(Stop::code)
    }

    fn follow(
        &self,
        total: u64,
        horizon: &Horizon,
        writer: &mut Writer<impl Write + Sync>,
    ) -> Result<u8, Stop> {
        let range = writer.shard.range(total);
        writer.begin()?;
        let mut counts = Counts::default();
        let next = in_pieces(range.clone(), PIECES, "starts", |piece| {
            let places: Vec<_> = piece
                .clone()
                .into_par_iter()
                .map(|i| self.place(i))
                .collect();
            let starts: Vec<_> = places.par_iter().map(|place| start(*place)).collect();
            let good: Vec<_> = starts.iter().flatten().copied().collect();
            let mut ends = horizon.follow(&good).map_err(Failure::from)?.into_iter();
            let ends: Vec<_> = starts
                .into_iter()
                .map(|start| {
                    let start = start.map_err(|error| error.to_string())?;
                    let end = ends.next().unwrap_or(Ok(End::Unfinished(start)));
                    end.map_err(|error| error.to_string())
                })
                .collect();
            let rows: Vec<_> = (places.par_iter().zip(ends).enumerate())
                .map(|(n, (place, end))| {
                    let end = match end {
                        Ok(end) if is_rough(&end) => exactly(horizon, place),
                        other => other,
                    };
                    (writer.row(piece.start + n as u64, place, &end), end)
                })
                .collect();
            for (row, end) in rows {
                counts.take(&end);
                writer.out.write_all(row.as_bytes())?;
            }
            Ok(writer.out.flush()?)
        })?;
        writer.end(&counts, next, total)?;
        Ok(told(&range, (next, counts.bad), "starts"))
    }

    /// ρ, p and ψ of a start, ψ running fastest.
    fn place(&self, i: u64) -> [f64; 3] {
        let mut point = Point::new(i);
        let psi = point.on("psi", &self.psi);
        let p = point.on("p", &self.p);
        [point.on("rho", &self.rho), p, psi].map(f64::from)
    }
}

fn start([rho, p, psi]: [f64; 3]) -> Result<Start, MotionError> {
    Start::polar(rho, p, psi)
}

/// An end whose time is less well known than this part of it is found again, exactly.
const ROUGH: f64 = 1e-5;

fn is_rough(end: &End) -> bool {
    match *end {
        End::Rest { tau, tau_error, .. } | End::Far { tau, tau_error } => tau_error > ROUGH * tau,
        End::Late(_) => false,
        End::Unfinished(_) => true,
    }
}

/// The end of the way from a place as its row shows it.
fn exactly(horizon: &Horizon, place: &[f64; 3]) -> Result<End, String> {
    let [rho, p, psi] = place.map(|x| number(x).parse::<Double>().unwrap_or_else(|_| x.into()));
    let end = horizon.follow_exactly(rho, p, psi);
    end.map_err(|error| error.to_string())
}

/// What is written, row by row.
struct Writer<W> {
    format: Format,
    out: W,
    shard: Shard,
}

impl<W: Write> Writer<W> {
    fn begin(&mut self) -> io::Result<()> {
        match self.format {
            _ if !self.shard.is_first() => Ok(()),
            Format::Text => Ok(()),
            Format::Csv => {
                let heads = UNITS.map(|(name, unit)| ascii(&head(name, unit)));
                let [rho, p, psi, sigma, tau] = heads;
                writeln!(
                    self.out,
                    "{}{rho},{p},{psi},outcome,{sigma},{tau},sigma_digits,tau_digits,note",
                    bom()
                )
            }
            Format::Json => {
                let units: BTreeMap<_, _> = UNITS.into();
                let units = json!(units);
                write!(
                    self.out,
                    "{{\n  \"version\": {VERSION},\n  \"units\": {units},\n  \"ends\": ["
                )
            }
        }
    }

    /// The row of this index.
    fn row(&self, index: u64, &[rho, p, psi]: &[f64; 3], end: &Result<End, String>) -> String {
        let (outcome, sigma, tau) = match *end {
            Ok(End::Rest {
                sigma,
                sigma_error,
                tau,
                tau_error,
            }) => (
                "rest",
                Some(known(sigma, sigma_error)),
                Some(known(tau, tau_error)),
            ),
            Ok(End::Far { tau, tau_error }) => ("far", None, Some(known(tau, tau_error))),
            Ok(End::Late(_)) => ("late", None, None),
            Ok(End::Unfinished(_)) => ("unfinished", None, None),
            Err(_) => ("refused", None, None),
        };
        let note = end.as_ref().err();
        let ([sigma, tau], digits) = (
            [sigma, tau].map(|known| known.map(|(value, _)| value)),
            [sigma, tau].map(|known| known.map(|(_, digits)| digits)),
        );
        match self.format {
            Format::Text => String::new(),
            Format::Csv => {
                let text = |x: Option<f64>| x.map(number).unwrap_or_default();
                let [rho, p, psi] = [rho, p, psi].map(number);
                let (sigma, tau) = (text(sigma), text(tau));
                let [of_sigma, of_tau] = digits.map(|n| n.map_or(String::new(), |n| n.to_string()));
                let note = note.map_or(String::new(), |note| {
                    format!("\"{}\"", ascii(note).replace('"', "'"))
                });
                format!("{rho},{p},{psi},{outcome},{sigma},{tau},{of_sigma},{of_tau},{note}\n")
            }
            Format::Json => {
                let separator = if index == 0 { "\n    " } else { ",\n    " };
                let [of_sigma, of_tau] = digits;
                let row = json!({
                    "rho": rho, "p": p, "psi": psi, "outcome": outcome, "sigma": sigma, "tau": tau,
                    "sigma_digits": of_sigma, "tau_digits": of_tau, "note": note,
                });
                format!("{separator}{row}")
            }
        }
    }

    /// The end, after all rows before that of the index `next`.
    fn end(&mut self, counts: &Counts, next: u64, total: u64) -> io::Result<()> {
        let Counts {
            done,
            rest,
            far,
            bad,
        } = *counts;
        match self.format {
            Format::Text => {
                let other = done - rest - far - bad;
                let starts = if done == 1 { "start" } else { "starts" };
                let that = |n: u64, one: &str, several: &str| match n {
                    1 => format!("1 {one}"),
                    n => format!("{n} {several}"),
                };
                let refused = match bad {
                    0 => String::new(),
                    bad => format!(", {} out of range", that(bad, "is", "are")),
                };
                let [rest, far, other] = [
                    that(rest, "comes to rest", "come to rest"),
                    that(far, "goes away", "go away"),
                    that(other, "is still under way", "are still under way"),
                ];
                writeln!(self.out, "{done} {starts}: {rest}, {far}, {other}{refused}")?;
            }
            Format::Csv => {}
            Format::Json => {
                let end = end(self.shard, next, total).unwrap_or_default();
                self.out.write_all(end.as_bytes())?;
            }
        }
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_whose_time_is_hardly_known_is_found_again() {
        let rest = |tau_error| End::Rest {
            sigma: 0.5,
            sigma_error: 0.0,
            tau: 3.0,
            tau_error,
        };
        let far = |tau_error| End::Far {
            tau: 3.0,
            tau_error,
        };
        for (part, expected) in [(2e-5, true), (5e-6, false)] {
            assert_eq!(
                [rest(3.0 * part), far(3.0 * part)].map(|end| is_rough(&end)),
                [expected; 2]
            );
        }
        let start = Start::polar(0.5, 0.1, 0.2).unwrap();
        assert!(is_rough(&End::Unfinished(start)) && !is_rough(&End::Late(start)));
    }

    /// A rest whose σ is known to three digits and whose τ to nine.
    const REST: Result<End, String> = Ok(End::Rest {
        sigma: 0.512_345_678_9,
        sigma_error: 2e-4,
        tau: 3.123_456_789_012,
        tau_error: 2e-9,
    });

    /// What is written of these ends, all or the first ones, of so many.
    fn written(format: Format, ends: &[Result<End, String>], total: u64) -> String {
        let mut writer = Writer {
            format,
            out: Vec::new(),
            shard: Shard::WHOLE,
        };
        let mut counts = Counts::default();
        writer.begin().unwrap();
        for (n, end) in ends.iter().enumerate() {
            let row = writer.row(n as u64, &[0.5, 0.25, -1.0], end);
            writer.out.extend(row.bytes());
            counts.take(end);
        }
        writer.end(&counts, ends.len() as u64, total).unwrap();
        String::from_utf8(writer.out).unwrap()
    }

    #[test]
    fn each_number_has_its_own_digits() {
        let far = Ok(End::Far {
            tau: 7.5,
            tau_error: 2e-5,
        });
        let csv = written(Format::Csv, &[REST, far.clone()], 2);
        let rows: Vec<_> = csv.lines().skip(1).collect();
        assert_eq!(
            rows,
            [
                "0.5,0.25,-1,rest,0.512,3.12345679,3,9,",
                "0.5,0.25,-1,far,,7.5,,5,"
            ]
        );
        let whole: serde_json::Value =
            serde_json::from_str(&written(Format::Json, &[REST, far], 2)).unwrap();
        let [rest, far] = [&whole["ends"][0], &whole["ends"][1]];
        assert_eq!([&rest["sigma"], &rest["tau"]], [0.512, 3.123_456_79]);
        assert_eq!([&rest["sigma_digits"], &rest["tau_digits"]], [3, 9]);
        assert!(far["sigma_digits"].is_null() && far["tau_digits"] == 5);
    }

    #[test]
    fn every_start_is_counted_once() {
        let start = Start::polar(0.5, 0.1, 0.2).unwrap();
        let late = || Ok(End::Late(start));
        let refused = || Err("no".to_owned());
        let far = Ok(End::Far {
            tau: 7.5,
            tau_error: 0.0,
        });
        for (ends, said) in [
            (
                vec![
                    REST,
                    refused(),
                    late(),
                    REST,
                    far,
                    refused(),
                    late(),
                    late(),
                    REST,
                ],
                "9 starts: 3 come to rest, 1 goes away, 3 are still under way, 2 are out of range\n",
            ),
            (
                vec![refused(), late()],
                "2 starts: 0 come to rest, 0 go away, 1 is still under way, 1 is out of range\n",
            ),
            (
                vec![REST],
                "1 start: 1 comes to rest, 0 go away, 0 are still under way\n",
            ),
        ] {
            assert_eq!(written(Format::Text, &ends, ends.len() as u64), said);
        }
    }
}
