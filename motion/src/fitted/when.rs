//! Times of the clock, with or without a date, as seconds.

use super::cells::read;

const WRONG: &str = "no time of the clock that can be read: 10:30:05.25, also behind a date as 2026-01-31 or 31-Jan-2026";
const MONTHS: [&str; 12] = [
    "jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec",
];

/// All times are counted from the first of the file.
#[derive(Default)]
pub(super) struct Clock {
    first: Option<(i64, f64)>,
    zone: Option<String>,
    plain: bool,
}

impl Clock {
    /// Since the first time; nothing for a number.
    pub(super) fn read(
        &mut self,
        cell: &str,
        separator: char,
        sign: &mut Option<char>,
    ) -> Result<Option<f64>, &'static str> {
        self.plain |= !cell.contains(':');
        if self.plain && self.first.is_none() {
            return Ok(None);
        }
        let behind = cell.rsplit_once(' ');
        let behind = behind.filter(|(_, zone)| zone.starts_with(['+', '-']));
        let (cell, behind) = behind.unwrap_or((cell, ""));
        let (date, time) = cell.rsplit_once([' ', 'T']).unwrap_or(("", cell));
        let end = time.find(['Z', '+', '-']).unwrap_or(time.len());
        let (time, zone) = time.split_at(end);
        // Some write thousandths behind a colon too.
        let (hours, minutes, seconds, thousandths) = match time.split(':').collect::<Vec<_>>()[..] {
            [hours, minutes, seconds] => (hours, minutes, seconds, "0"),
            [hours, minutes, seconds, part] if part.len() == 3 => (hours, minutes, seconds, part),
            _ => return Err(WRONG),
        };
        let whole = |text: &str, most: u32| {
            let number = text.parse().ok().filter(|n: &u32| *n <= most);
            number.map(f64::from).ok_or(WRONG)
        };
        let (hours, minutes) = (whole(hours, 23)?, whole(minutes, 59)?);
        let seconds = read(seconds, separator, sign)? + 1e-3 * whole(thousandths, 999)?;
        let fit = (0.0..61.0).contains(&seconds) && (date.is_empty() || day(date).is_some());
        // Where the zone changes, so does what the clock shows.
        let zone = zone.to_owned() + behind;
        if !fit || *self.zone.get_or_insert_with(|| zone.clone()) != zone {
            return Err(WRONG);
        }
        let seconds = 3600.0 * hours + 60.0 * minutes + seconds;
        let day = day(date).unwrap_or(0);
        let (first, zero) = *self.first.get_or_insert((day, seconds));
        Ok(Some(86_400.0 * (day - first) as f64 + (seconds - zero)))
    }
}

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
