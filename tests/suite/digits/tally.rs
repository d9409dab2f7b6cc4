//! How many digits were claimed, and how many are true.

use slipbook::solve::{Answer, Field, Fields, Value};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

const MOST: u32 = 15;

#[derive(Default)]
pub struct Tally {
    counts: BTreeMap<(u32, u32), usize>,
}

fn power(x: f64) -> i32 {
    let text = format!("{x:e}");
    text.split_once('e').unwrap().1.parse().unwrap()
}

fn digits(found: f64, exact: f64, scale: f64) -> u32 {
    if found == exact {
        return MOST;
    }
    let part = (found - exact).abs() / exact.abs().max(scale);
    (-part.log10()).floor().clamp(0.0, f64::from(MOST)) as u32
}

/// By more than one unit of the last of these digits; as written in decimals.
fn is_wrong(found: f64, exact: f64, scale: f64, claimed: u32) -> bool {
    let size = exact.abs().max(scale);
    let unit: f64 = format!("1e{}", power(size) - claimed as i32 + 1)
        .parse()
        .unwrap();
    size > 0.0 && (found - exact).abs() > 1.001 * unit || size == 0.0 && found != 0.0
}

impl Tally {
    /// `exact` gives the values by the fields' names, `None` for one that there is not.
    #[track_caller]
    pub fn answer<T: Fields>(
        &mut self,
        answer: &Answer<T>,
        exact: impl Fn(&str) -> Option<String>,
        case: &str,
    ) {
        let Some(claimed) = answer.digits else {
            let fields = answer.best.fields();
            let numbers = fields.iter().any(|f| matches!(f.value, Value::Number(_)));
            assert!(!numbers, "{case}: numbers without digits");
            self.words(&fields, &exact, case);
            return;
        };
        let (raw, written) = (answer.best.fields(), answer.report("").fields);
        self.words(&raw, &exact, case);
        let mut least = MOST;
        for (raw, written) in raw.iter().zip(&written) {
            let (Value::Number(found), Value::Number(shown)) = (raw.value, written.value) else {
                continue;
            };
            let expected = exact(raw.name);
            let number: f64 = expected.as_ref().map_or(f64::NAN, |x| x.parse().unwrap());
            assert!(
                !number.is_nan() && !is_wrong(shown, number, raw.scale, claimed),
                "{case}: {} is {shown} to {claimed} digits, and right is {expected:?}",
                raw.name
            );
            least = least.min(digits(found, number, raw.scale));
        }
        *self.counts.entry((claimed, least)).or_default() += 1;
    }

    #[track_caller]
    fn words(&self, fields: &[Field], exact: &impl Fn(&str) -> Option<String>, case: &str) {
        for field in fields {
            match (field.value, exact(field.name)) {
                (Value::Word(word), Some(right)) => assert_eq!(word, right, "{case}"),
                (Value::Missing, None) | (Value::Number(_), _) => {}
                (found, right) => panic!("{case}: {} {found:?}, {right:?}", field.name),
            }
        }
    }

    /// As found, and as written to the digits claimed.
    #[track_caller]
    pub fn number(&mut self, found: f64, (shown, claimed): (f64, u32), exact: f64, case: &str) {
        let wrong = exact.is_nan() || is_wrong(shown, exact, 0.0, claimed);
        assert!(
            !wrong,
            "{case}: {shown} to {claimed} digits, right is {exact}"
        );
        let least = digits(found, exact, 0.0);
        *self.counts.entry((claimed, least)).or_default() += 1;
    }

    pub fn cases(&self) -> usize {
        self.counts.values().sum()
    }

    /// At most two digits too few, in nine cases of ten; where all cases were tried, the counts are the recorded ones.
    #[track_caller]
    #[must_use]
    pub fn closes(&self, kind: &str, all: bool) -> bool {
        let modest = self
            .counts
            .iter()
            .filter(|((claimed, least), _)| claimed + 2 < *least);
        let modest: usize = modest.map(|(_, n)| n).sum();
        let cases = self.cases();
        println!("{kind}: {cases} cases, {modest} of them with too few digits claimed");
        assert!(10 * modest <= cases, "{kind}: {:?}", self.counts);
        !all || self.is_recorded(kind)
    }

    /// Up to one case in a thousand, as machines may round a last bit otherwise.
    fn is_recorded(&self, kind: &str) -> bool {
        let record = record();
        let rows = record.lines().filter_map(|line| {
            let [of, claimed, least, n] = line.split(',').collect::<Vec<_>>()[..] else {
                return None;
            };
            let number = |text: &str| text.parse::<u32>().ok();
            Some((
                (of == kind).then_some(())?,
                (number(claimed)?, number(least)?),
                n.parse::<usize>().ok()?,
            ))
        });
        let recorded: BTreeMap<_, _> = rows.map(|((), place, n)| (place, n)).collect();
        let count = |counts: &BTreeMap<(u32, u32), usize>, at| counts.get(at).copied().unwrap_or(0);
        let mut places = self.counts.keys().chain(recorded.keys());
        let same = places.all(|at| {
            1000 * count(&self.counts, at).abs_diff(count(&recorded, at)) <= self.cases()
        });
        if !same {
            let rows = self.counts.iter();
            let rows = rows.map(|((claimed, least), n)| format!("{kind},{claimed},{least},{n}\n"));
            fs::write(
                folder().join(format!("{kind}.new")),
                rows.collect::<String>(),
            )
            .unwrap();
            println!("{kind}: other counts than recorded; see target/digits/{kind}.new");
        }
        same
    }
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/digits");
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Calculator, digits claimed, digits true, cases.
pub fn record() -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots/digits.csv");
    fs::read_to_string(file).unwrap()
}

#[test]
fn a_wrong_digit_is_seen_and_a_modest_claim_is_counted() {
    // One unit of the last digit is allowed.
    for (found, exact, claimed, wrong) in [
        (5.1546, 5.15460131, 5, false),
        (5.1547, 5.15460131, 5, false),
        (5.1548, 5.15460131, 5, true),
        (19.3717, 5.15460131, 7, true),
        (0.0, 1e-20, 3, true),
        (0.0, 0.0, 15, false),
        (1e-300, 0.0, 15, true),
    ] {
        assert_eq!(
            is_wrong(found, exact, 0.0, claimed),
            wrong,
            "{found} {claimed}"
        );
    }
    assert!(!is_wrong(0.0, 1e-20, 1.0, 15));
    assert_eq!(digits(5.1546, 5.15460131, 0.0), 6);
    assert_eq!((digits(1.0, 1.0, 0.0), digits(2.0, 1.0, 0.0)), (15, 0));
    let mut tally = Tally::default();
    tally.number(0.5, (0.5, 13), 0.5, "");
    assert!(tally.closes("enough", false));
    tally.number(0.5, (0.5, 12), 0.5, "");
    let few = std::panic::catch_unwind(|| tally.closes("too few", false));
    assert!(few.is_err());
}
