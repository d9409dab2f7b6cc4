//! The tables under "How fast", from the committed result file.

use serde::Deserialize;
use trialbook::book::{escape, table};
use trialbook::data::{Text, text};
use trialbook::publishing::{Failure, Filled};

/// What `benches/peers/run.py` wrote.
pub(super) const RESULTS: Text = text!("benches/results.json");
const MANIFEST: &str = include_str!("../../Cargo.toml");

#[derive(Deserialize)]
struct Results {
    date: String,
    commit: String,
    /// What Cargo.toml said of profiles at that time.
    profiles: toml::Table,
    machine: String,
    rounds: u32,
    rows: Vec<Row>,
    growth: Vec<Growth>,
}

/// What one start of an ensemble costs when there are so many.
#[derive(Deserialize)]
struct Growth {
    starts: u64,
    each_us: f64,
}

#[derive(Deserialize)]
struct Row {
    work: String,
    peer: String,
    ours_us: f64,
    /// The commit, if it was measured at another one.
    commit: Option<String>,
    /// The same in the profile of released binaries, where it is ours that a profile changes.
    released_us: Option<f64>,
    peer_us: f64,
}

impl Results {
    /// Whether the profiles are no longer those of the measurement.
    fn is_old(&self) -> Result<bool, Failure> {
        let manifest: toml::Table = toml::from_str(MANIFEST).map_err(Failure::from)?;
        let now = manifest.get("profile").and_then(toml::Value::as_table);
        Ok(now != Some(&self.profiles))
    }
}

/// Of how many starts at least, and at most, the costs were measured, as powers of ten.
pub(super) fn starts() -> Result<[f64; 2], Failure> {
    let growth = results()?.growth;
    let (Some(first), Some(last)) = (growth.first(), growth.last()) else {
        return Err("nothing was measured".into());
    };
    let power = |row: &Growth| libm::exp10(libm::round(libm::log10(row.starts as f64)));
    Ok([first, last].map(power))
}

/// How many times longer the peer takes, three digits.
fn ratio(peer: f64, ours: f64) -> String {
    let ratio = peer / ours;
    let decimals = (2 - libm::floor(libm::log10(ratio)) as i32).clamp(0, 3) as usize;
    format!("{ratio:.decimals$}")
}

fn results() -> Result<Results, Failure> {
    read(&RESULTS)
}

fn read(text: &str) -> Result<Results, Failure> {
    serde_json::from_str(text).map_err(|error| format!("benches/results.json: {error}").into())
}

/// Microseconds in the unit that reads best, three digits.
pub(super) fn time(microseconds: f64) -> String {
    let (value, unit) = match microseconds {
        t if t >= 1e6 => (t / 1e6, "s"),
        t if t >= 1e3 => (t / 1e3, "ms"),
        t if t >= 1.0 => (t, "µs"),
        t => (t * 1e3, "ns"),
    };
    let decimals = (2 - libm::floor(libm::log10(value)) as i32).clamp(0, 2) as usize;
    // Not torn at the end of a line.
    format!("{value:.decimals$}\u{a0}{unit}")
}

pub(super) fn table_of() -> Result<Filled, Failure> {
    let results = results()?;
    let rows = results.rows.iter().map(|row| {
        let released = row.released_us;
        [
            escape(&row.work),
            time(row.ours_us),
            released.map_or(String::new(), time),
            escape(&row.peer),
            time(row.peer_us),
            ratio(row.peer_us, row.ours_us),
            released.map_or(String::new(), |ours| ratio(row.peer_us, ours)),
        ]
    });
    let head = [
        "one",
        "here",
        "released",
        "peer",
        "there",
        "there over here",
        "over released",
    ];
    Ok(Filled::Block(table("speed", head, rows)))
}

pub(super) fn growth() -> Result<Filled, Failure> {
    let growth = results()?.growth;
    let rows = growth
        .iter()
        .map(|row| [row.starts.to_string(), time(row.each_us)]);
    Ok(Filled::Block(table("speed", ["starts", "each"], rows)))
}

pub(super) fn circumstances() -> Result<Filled, Failure> {
    let results = results()?;
    let old = if results.is_old()? {
        ", before the compiler’s settings were changed: the figures are old"
    } else {
        ""
    };
    let Results {
        date,
        commit,
        machine,
        rounds,
        rows,
        ..
    } = results;
    let later = rows
        .iter()
        .filter_map(|row| Some(format!("; {} at {}", row.work, row.commit.as_ref()?)));
    let later: String = later.collect();
    let text = format!(
        "{date} at commit {commit} on {machine}, the fastest of {rounds} rounds{old}{later}"
    );
    Ok(Filled::Inline(escape(&text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_read_well() {
        for (microseconds, expected) in [
            (0.0131, "13.1\u{a0}ns"),
            (1.9, "1.90\u{a0}µs"),
            (410.0, "410\u{a0}µs"),
            (5700.0, "5.70\u{a0}ms"),
            (2.7e6, "2.70\u{a0}s"),
        ] {
            assert_eq!(time(microseconds), expected);
        }
    }

    #[test]
    fn a_damaged_file_is_named_with_the_place() {
        let (whole, cut) = (RESULTS.trim_end(), RESULTS.len() / 2);
        for damaged in [
            "",
            &whole[..cut],
            &whole.replace("ours_us", "ours"),
            &whole.replacen(": ", ": ?", 1),
        ] {
            let Err(failure) = read(damaged) else {
                panic!("read: {damaged}")
            };
            let message = failure.to_string();
            assert!(message.contains("benches/results.json"), "{message}");
            assert!(message.contains("line"), "{message}");
        }
    }

    #[test]
    fn a_start_costs_the_same_among_a_thousand_and_a_million() {
        let growth = results().unwrap().growth;
        let (first, last) = (growth.first().unwrap(), growth.last().unwrap());
        assert!(last.starts >= 900 * first.starts);
        assert!(last.each_us < 1.2 * first.each_us);
    }

    #[test]
    fn a_table_of_other_settings_says_that_it_is_old() {
        let manifest: toml::Table = toml::from_str(MANIFEST).unwrap();
        let now = manifest["profile"].as_table().unwrap().clone();
        let mut results = results().unwrap();
        results.profiles = now.clone();
        assert!(!results.is_old().unwrap());
        for profile in ["dev", "release"] {
            results.profiles = now.clone();
            results.profiles[profile]["opt-level"] = 2.into();
            assert!(results.is_old().unwrap(), "{profile}");
        }
    }

    #[test]
    fn both_builds_are_three_times_as_fast_as_each_peer_on_the_turntable() {
        let rows = results().unwrap().rows;
        let turntable = rows
            .iter()
            .filter(|row| row.work.contains("turntable, one core"));
        let fast = turntable.map(|row| {
            [Some(row.ours_us), row.released_us].map(|ours| row.peer_us > 3.0 * ours.unwrap())
        });
        assert_eq!(fast.collect::<Vec<_>>(), [[true; 2]; 2]);
    }
}
