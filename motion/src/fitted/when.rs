//! Times of the clock, with or without a date, as seconds.

use super::csv::read;

const WRONG: &str = "no time of the clock that can be read: 10:30:05.25, also behind a date as 2026-01-31 or 31-Jan-2026";
const MONTHS: [&str; 12] = [
    "jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec",
];

/// The first time of a file, from which all are counted.
#[derive(Default)]
pub(super) struct Clock {
    first: Option<(i64, f64)>,
    zone: Option<String>,
    plain: bool,
}

impl Clock {
    /// Seconds since the first time; nothing for a number.
    pub fn read(
        &mut self,
        cell: &str,
        separator: char,
        sign: &mut Option<char>,
    ) -> Result<Option<f64>, &'static str> {
        self.plain |= !cell.contains(':');
        if self.plain && self.first.is_none() {
            return Ok(None);
        }
        let (date, time) = cell.rsplit_once([' ', 'T']).unwrap_or(("", cell));
        let end = time.find(['Z', '+', '-']).unwrap_or(time.len());
        let (time, zone) = time.split_at(end);
        let [hours, minutes, seconds] = time.split(':').collect::<Vec<_>>()[..] else {
            return Err(WRONG);
        };
        let whole = |text: &str, most: u32| -> Option<f64> {
            text.parse()
                .ok()
                .filter(|n: &u32| *n <= most)
                .map(f64::from)
        };
        let minutes = whole(hours, 23).zip(whole(minutes, 59)).ok_or(WRONG)?;
        let seconds = read(seconds, separator, sign)?;
        let fit = (0.0..61.0).contains(&seconds) && (date.is_empty() || day(date).is_some());
        // Where the zone changes, so does what the clock shows.
        if !fit || self.zone.get_or_insert_with(|| zone.to_owned()) != zone {
            return Err(WRONG);
        }
        let seconds = 3600.0 * minutes.0 + 60.0 * minutes.1 + seconds;
        let day = day(date).unwrap_or(0);
        let (first, zero) = *self.first.get_or_insert((day, seconds));
        Ok(Some(86_400.0 * (day - first) as f64 + (seconds - zero)))
    }
}

/// The number of a day, counted from one far back.
fn day(date: &str) -> Option<i64> {
    let parts: Vec<_> = date.trim().split('-').collect();
    let [a, b, c] = parts[..] else { return None };
    let month = |name: &str| {
        let name = name.to_lowercase();
        MONTHS.iter().position(|month| *month == name)
    };
    let (year, month, day) = match month(b) {
        Some(month) => (c, month as i64 + 1, a),
        None => (a, b.parse().ok()?, c),
    };
    let (year, day): (i64, i64) = (year.parse().ok()?, day.parse().ok()?);
    let fit = (1900..=9999).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
    // Years that begin in March have their odd day at the end.
    let (year, month) = (year - i64::from(month < 3), (month + 9) % 12);
    fit.then(|| 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_is_read_as_seconds_since_the_first_time() {
        let of = |cells: &[&str]| {
            let (mut clock, mut sign) = (Clock::default(), None);
            let read = |cell: &&str| clock.read(cell, ';', &mut sign);
            cells.iter().map(read).collect::<Result<Vec<_>, _>>()
        };
        for (cells, last) in [
            (["10:00:59.750", "10:01:00.250"], 0.5),
            (["2026-01-31 23:59:59,5", "2026-02-01 00:00:00,75"], 1.25),
            (["2024-02-28T12:00:00Z", "2024-03-01T12:00:00Z"], 172_800.0),
            (
                ["1999-12-31 12:00:00", "2001-01-01 12:00:00"],
                367.0 * 86_400.0,
            ),
            (
                ["31-Dec-2025 23:00:00.001", "01-Jan-2026 01:00:00.001"],
                7200.0,
            ),
        ] {
            assert_eq!(of(&cells), Ok(vec![Some(0.0), Some(last)]), "{cells:?}");
        }
        assert_eq!(of(&["1.5", "2"]), Ok(vec![None, None]));
        for cells in [
            ["10:00:00", "10.5"],
            ["10:00:00", "1:00 PM"],
            ["10:00", "10:01"],
            ["25:00:00", "26:00:00"],
            ["31/12/2025 10:00:00", "31/12/2025 10:00:01"],
            ["2026-13-01 10:00:00", "2026-13-01 10:00:01"],
            ["2026-10-25T02:59:59+02:00", "2026-10-25T02:00:01+01:00"],
        ] {
            assert!(of(&cells).is_err(), "{cells:?}");
        }
    }
}
