//! Long work in pieces: after each its rows are written, and Ctrl-C ends it after the present one.

use std::io::{self, ErrorKind};
use std::ops::Range;
use std::time::{Duration, Instant};
use trialbook::cli::{Shard, complain, progress, stop, unwritten};
use trialbook::publishing::Failure;

/// Pieces grow while they take less than this,
const SHORT: Duration = Duration::from_millis(200);
/// and shrink if they take more than this.
const LONG: Duration = Duration::from_millis(800);

/// Why the work ends early.
#[derive(Debug)]
pub(super) enum Stop {
    /// The reader has closed the pipe, and has read enough.
    Pipe,
    Failure(Failure),
}

impl From<io::Error> for Stop {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            ErrorKind::BrokenPipe => Self::Pipe,
            _ => Self::Failure(unwritten(error).into()),
        }
    }
}

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

impl Stop {
    /// The exit code, or the failure.
    pub(super) fn code(self) -> Result<u8, Failure> {
        match self {
            Self::Pipe => Ok(0),
            Self::Failure(failure) => Err(failure),
        }
    }
}

/// Does the work of a range piece by piece, each within these sizes; where it ends.
pub(super) fn in_pieces(
    range: Range<u64>,
    [least, most]: [u64; 2],
    what: &str,
    mut work: impl FnMut(Range<u64>) -> Result<(), Stop>,
) -> Result<u64, Stop> {
    stop::listen().map_err(|error| Stop::Failure(error.into()))?;
    let template = format!("{{bar:40}} {{pos}}/{{len}} {what}  {{eta}} left");
    let bar = progress(range.end - range.start, &template);
    let (mut next, mut size) = (range.start, least);
    while next < range.end && !stop::is_asked() {
        let begun = Instant::now();
        let end = range.end.min(next.saturating_add(size));
        work(next..end)?;
        next = end;
        size = match begun.elapsed() {
            time if time < SHORT => most.min(2 * size),
            time if time > LONG => least.max(size / 2),
            _ => size,
        };
        bar.set_position(next - range.start);
    }
    bar.finish_and_clear();
    Ok(next)
}

/// The end of a list in JSON, if it ends before the row `next` of `total`: a part that was stopped ends it too, so that what is
/// there can be read.
pub(super) fn end(shard: Shard, next: u64, total: u64) -> Option<String> {
    let ends = shard.is_last() || next < shard.range(total).end;
    ends.then(|| format!("\n  ],\n  \"done\": {next},\n  \"of\": {total}\n}}\n"))
}

/// The exit code of work that ended there, with so many rows refused; what is refused or missing is said.
pub(super) fn told(range: &Range<u64>, (ended, refused): (u64, u64), what: &str) -> u8 {
    let (done, of) = (ended - range.start, range.end - range.start);
    if refused > 0 {
        complain("slipbook", &format!("{refused} of {done} rows refused"));
    }
    match done {
        _ if done < of => {
            complain("slipbook", &format!("stopped after {done} of {of} {what}"));
            stop::STOPPED
        }
        // That of bad input where there is no other row.
        _ if refused > 0 && refused == done => 2,
        _ => 0,
    }
}
