//! `ensemble`: where many particles on the turntable end, one line each, written while the others are still on
//! their way.

use crate::claims::solve::turntable::{End, Horizon, Start};
use crate::claims::solve::{Double, known};
use crate::numerics::error::plain as number;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use trialbook::cli::{VERSION, complain};
use trialbook::edition::{Failure, Format};

/// Exit code after Ctrl-C, as shells have it.
const STOPPED: u8 = 130;

/// Starts that are followed together; after each such piece the rows are written.
const PIECE: u64 = 1 << 16;

/// Equally spaced numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Range {
    low: f64,
    high: f64,
    count: u64,
}

impl FromStr for Range {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str| {
            let value: f64 = part.parse().map_err(|_| format!("`{part}` is no number"))?;
            let fit = value.is_finite();
            fit.then_some(value)
                .ok_or_else(|| format!("`{part}` is not finite"))
        };
        match text.split(':').collect::<Vec<_>>()[..] {
            [one] => Ok(Self {
                low: number(one)?,
                high: number(one)?,
                count: 1,
            }),
            [low, high, count] => {
                let count: u64 = count.parse().unwrap_or(0);
                if !(2..=1_000_000_000).contains(&count) {
                    return Err("COUNT must be a whole number from 2 to 10⁹".into());
                }
                Ok(Self {
                    low: number(low)?,
                    high: number(high)?,
                    count,
                })
            }
            _ => Err("a number, or LOW:HIGH:COUNT".into()),
        }
    }
}

impl Range {
    fn at(&self, i: u64) -> f64 {
        let share = i as f64 / (self.count - 1).max(1) as f64;
        self.low * (1.0 - share) + self.high * share
    }
}

/// The starts, and how far they are followed.
#[derive(Debug, Args)]
pub(super) struct Ensemble {
    /// Distances ρ of the starts from the axis, in units of μg/Ω²: one, or LOW:HIGH:COUNT
    #[arg(long, value_name = "RANGE", allow_negative_numbers = true)]
    rho: Range,
    /// Speeds p relative to the table, in units of μg/Ω
    #[arg(long, value_name = "RANGE", allow_negative_numbers = true)]
    p: Range,
    /// Angles ψ from the velocity to the position, in radians
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    psi: Range,
    /// Distance at which a particle counts as gone
    #[arg(
        long,
        value_name = "RHO",
        default_value_t = 100.0,
        allow_negative_numbers = true
    )]
    far: f64,
    /// Time after which it is followed no longer, in units of 1/Ω
    #[arg(
        long,
        value_name = "TAU",
        default_value_t = 50.0,
        allow_negative_numbers = true
    )]
    late: f64,
}

/// How many ended how.
#[derive(Debug, Default)]
struct Counts {
    done: u64,
    rest: u64,
    far: u64,
}

impl Ensemble {
    pub(super) fn run(&self, format: Format) -> Result<u8, Failure> {
        let total = [self.p.count, self.psi.count]
            .iter()
            .try_fold(self.rho.count, |n, m| n.checked_mul(*m))
            .ok_or("rho, p and psi: more than 2⁶⁴ starts together")?;
        let horizon = Horizon {
            rho: self.far,
            tau: self.late,
        };
        // What is out of range is said before anything is written: ranges are widest at their ends.
        for corner in 0..8 {
            let end = |range: &Range, bit: u64| range.at((range.count - 1) * (corner >> bit & 1));
            let corner = [end(&self.rho, 0), end(&self.p, 1), end(&self.psi, 2)];
            horizon.follow_alone(&[start(corner)?])?;
        }
        let stop = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&stop);
        // A second Ctrl-C does not wait.
        ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(i32::from(STOPPED));
            }
        })?;
        let mut writer = Writer::new(format);
        match self.follow(total, &horizon, &stop, &mut writer) {
            Err(Stop::Pipe) => Ok(0),
            Err(Stop::Failure(error)) => Err(error),
            Ok(counts) => {
                if counts.done == total {
                    return Ok(0);
                }
                let Counts { done, .. } = counts;
                complain(
                    "slipbook",
                    &format!("stopped after {done} of {total} starts"),
                );
                Ok(STOPPED)
            }
        }
    }

    fn follow(
        &self,
        total: u64,
        horizon: &Horizon,
        stop: &AtomicBool,
        writer: &mut Writer,
    ) -> Result<Counts, Stop> {
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len} starts  {eta} left");
        let bar = ProgressBar::new(total)
            .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        writer.begin()?;
        let mut counts = Counts::default();
        while counts.done < total && !stop.load(Ordering::Relaxed) {
            let piece = counts.done..total.min(counts.done + PIECE);
            let places: Vec<_> = piece.map(|i| self.place(i)).collect();
            let starts: Result<Vec<_>, _> = places.iter().map(|&place| start(place)).collect();
            let ends = horizon.follow(&starts?).map_err(Failure::from)?;
            for (place, end) in places.iter().zip(ends) {
                let end = if is_rough(&end) {
                    exactly(horizon, place)?
                } else {
                    end
                };
                counts.rest += u64::from(matches!(end, End::Rest { .. }));
                counts.far += u64::from(matches!(end, End::Far { .. }));
                writer.row(place, &end)?;
            }
            counts.done += places.len() as u64;
            writer.flush()?;
            bar.set_position(counts.done);
        }
        bar.finish_and_clear();
        writer.end(&counts, total)?;
        Ok(counts)
    }

    /// ρ, p and ψ of a start, ψ running fastest.
    fn place(&self, i: u64) -> [f64; 3] {
        let (psi, rest) = (i % self.psi.count, i / self.psi.count);
        let (p, rho) = (rest % self.p.count, rest / self.p.count);
        [self.rho.at(rho), self.p.at(p), self.psi.at(psi)]
    }
}

fn start([rho, p, psi]: [f64; 3]) -> Result<Start, Failure> {
    Ok(Start::polar(rho, p, psi)?)
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
fn exactly(horizon: &Horizon, place: &[f64; 3]) -> Result<End, Failure> {
    let [rho, p, psi] = place.map(|x| number(x).parse::<Double>());
    Ok(horizon.follow_exactly(rho?, p?, psi?)?)
}

/// Why the work ends early.
enum Stop {
    /// The reader has closed the pipe, and has read enough.
    Pipe,
    Failure(Failure),
}

impl From<io::Error> for Stop {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            ErrorKind::BrokenPipe => Self::Pipe,
            _ => Self::Failure(error.into()),
        }
    }
}

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

/// Standard output, row by row.
struct Writer {
    format: Format,
    out: BufWriter<io::Stdout>,
    first: bool,
}

impl Writer {
    fn new(format: Format) -> Self {
        Self {
            format,
            out: BufWriter::new(io::stdout()),
            first: true,
        }
    }

    fn begin(&mut self) -> io::Result<()> {
        match self.format {
            Format::Text => Ok(()),
            Format::Csv => writeln!(
                self.out,
                "rho,p,psi,outcome,sigma,tau,sigma_digits,tau_digits"
            ),
            Format::Json => write!(self.out, "{{\n  \"version\": {VERSION},\n  \"ends\": ["),
        }
    }

    fn row(&mut self, &[rho, p, psi]: &[f64; 3], end: &End) -> io::Result<()> {
        let (outcome, sigma, tau) = match *end {
            End::Rest {
                sigma,
                sigma_error,
                tau,
                tau_error,
            } => (
                "rest",
                Some(known(sigma, sigma_error)),
                Some(known(tau, tau_error)),
            ),
            End::Far { tau, tau_error } => ("far", None, Some(known(tau, tau_error))),
            End::Late(_) => ("late", None, None),
            End::Unfinished(_) => ("unfinished", None, None),
        };
        let ([sigma, tau], digits) = (
            [sigma, tau].map(|known| known.map(|(value, _)| value)),
            [sigma, tau].map(|known| known.map(|(_, digits)| digits)),
        );
        match self.format {
            Format::Text => Ok(()),
            Format::Csv => {
                let text = |x: Option<f64>| x.map(number).unwrap_or_default();
                let [rho, p, psi] = [rho, p, psi].map(number);
                let (sigma, tau) = (text(sigma), text(tau));
                let [of_sigma, of_tau] = digits.map(|n| n.map_or(String::new(), |n| n.to_string()));
                writeln!(
                    self.out,
                    "{rho},{p},{psi},{outcome},{sigma},{tau},{of_sigma},{of_tau}"
                )
            }
            Format::Json => {
                let separator = if self.first { "\n    " } else { ",\n    " };
                self.first = false;
                let [of_sigma, of_tau] = digits;
                let row = json!({
                    "rho": rho, "p": p, "psi": psi, "outcome": outcome, "sigma": sigma, "tau": tau,
                    "sigma_digits": of_sigma, "tau_digits": of_tau,
                });
                write!(self.out, "{separator}{row}")
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }

    fn end(&mut self, counts: &Counts, total: u64) -> io::Result<()> {
        let Counts { done, rest, far } = *counts;
        match self.format {
            Format::Text => {
                let other = done - rest - far;
                writeln!(
                    self.out,
                    "{done} starts: {rest} come to rest, {far} go away, {other} are still under way"
                )?;
            }
            Format::Csv => {}
            Format::Json => writeln!(
                self.out,
                "\n  ],\n  \"done\": {done},\n  \"of\": {total}\n}}"
            )?,
        }
        self.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_is_a_number_or_two_ends_and_a_count() {
        let range: Range = "-1:2:4".parse().unwrap();
        for (i, expected) in [(0, -1.0), (1, 0.0), (2, 1.0), (3, 2.0)] {
            assert!((range.at(i) - expected).abs() < 1e-15);
        }
        assert_eq!("0.5".parse::<Range>().unwrap().at(0), 0.5);
        for wrong in ["", "1:2", "1:2:1", "1:2:x", "nan", "1:inf:3", "1:2:3:4"] {
            assert!(wrong.parse::<Range>().is_err(), "{wrong}");
        }
    }
}
