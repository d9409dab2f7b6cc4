//! What is read as text: command line, numbers and ranges, the record of verdicts, formulas; and what is written, which has to be
//! read back as it was.

use super::config;
use proptest::prelude::*;
use slipbook::claims::{
    PAPER,
    values::{decimal_of, search},
};
use slipbook::cli;
use slipbook::edition::EDITION;
use slipbook::ledger::Record;
use trialbook::notation::{pieces, plain_formula, plain_words};
use trialbook::plotting::Table;

/// Any, or one that is nearly a number, a range, a record or a formula.
pub(super) fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<String>(),
        "[-+]?[0-9]{0,12}[.]?[0-9]{0,25}([eE][-+]?[0-9]{0,12})?",
        "([-+.0-9eE]{1,6}|nan|inf):([-+.0-9eE]{1,6}|inf):[-0-9]{1,12}",
        "(---\n)?([a-z0-9-]{1,6}: (confirmed|misprint|x)\n?){0,3}(---\n)?",
        "[1-9]e-?(21474836(47|48|50)|1[0-9]{2})",
        r"(\\[a-z]{1,5}|[{}_^$&]|[a-zα-ω]|[0-9]| |\\left|\\right|\\frac|\\sqrt){0,20}",
    ]
}

fn word() -> impl Strategy<Value = String> {
    let words = "verify show list errata find solve scene measure block ball ensemble exam completions constant sinusoidal pulse anisotropic sphere \
                 turntable turntable-boundary --out --json --csv --jobs --verdict --section --format --lambda --v0 --theta0 \
                 --time --theta --plot --rho --p --psi --far --late --mu --throw --vary --find --every --help bash 4 eq-13 refuted 1 -1 0:1:3 --";
    let words: Vec<_> = words.split(' ').map(str::to_owned).collect();
    prop_oneof![3 => prop::sample::select(words), 1 => text()]
}

fn cells(table: &str) -> Vec<Vec<String>> {
    let mut rows = vec![vec![String::new()]];
    let (mut quoted, mut letters) = (false, table.chars().peekable());
    while let Some(c) = letters.next() {
        let row = rows.last_mut().unwrap();
        match c {
            '"' if quoted && letters.peek() == Some(&'"') => {
                row.last_mut().unwrap().extend(letters.next())
            }
            '"' => quoted = !quoted,
            ',' if !quoted => row.push(String::new()),
            '\n' if !quoted => rows.push(vec![String::new()]),
            _ => row.last_mut().unwrap().push(c),
        }
    }
    rows.pop();
    rows
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn any_command_line_is_understood_or_refused(words in prop::collection::vec(word(), 0..8)) {
        let line = std::iter::once("slipbook").chain(words.iter().map(String::as_str));
        if let Err(refusal) = cli::command(&EDITION).try_get_matches_from(line) {
            prop_assert!(!refusal.to_string().is_empty());
        }
    }

    #[test]
    fn any_range_is_one_or_refused(range in text()) {
        let line = ["slipbook", "ensemble", "--rho", &range, "--p", &range, "--psi", &range];
        let _ = cli::command(&EDITION).try_get_matches_from(line);
    }

    #[test]
    fn any_record_is_read_or_the_line_named(text in text()) {
        if let Err(error) = Record::parse(&text) {
            prop_assert!(error.to_string().contains("line"), "{error}");
        }
    }

    #[test]
    fn any_formula_is_put_into_words(text in text()) {
        plain_formula(&text);
        plain_words(&text);
        pieces(&text);
    }

    #[test]
    fn a_table_is_read_back_as_it_was(rows in prop::collection::vec([text(), text()], 0..4), number in super::any()) {
        let mut table = Table::new(&["a, b", "c"]);
        let mut expected = vec![vec!["a, b".to_owned(), "c".to_owned()]];
        for row in rows {
            table.row(row.clone()).unwrap();
            expected.push(row.to_vec());
        }
        table.row((number, 7_u64)).unwrap();
        let mut read = cells(&table.into_text());
        let last = read.pop().unwrap();
        prop_assert_eq!(read, expected);
        let digits: f64 = last[0].parse().unwrap_or(f64::NAN);
        prop_assert!(!number.is_finite() || (digits - number).abs() <= 1e-11 * number.abs(), "{number} {last:?}");
    }

    #[test]
    fn any_expression_is_a_number_or_refused(expression in prop_oneof![text(), "([-+*/^()]|sqrt\\(|sin\\(|ln\\(|pi|deg|[0-9]{1,3}|[.]| ){0,12}"]) {
        if let Ok(number) = decimal_of(&expression) {
            prop_assert!(number.parse::<f64>().is_ok_and(|x| x.is_finite() && x != 0.0), "{expression} = {number}");
        }
    }

    #[test]
    fn any_number_is_graded_or_refused(number in text()) {
        if let Ok(found) = search(PAPER.values(), &number) {
            prop_assert!(number.parse::<f64>().is_ok_and(f64::is_finite), "{number}");
            for found in found {
                prop_assert!(found.right >= 1 && found.first_wrong.is_none_or(|n| n == found.right + 1), "{found:?}");
                prop_assert!(found.column.is_none_or(|column| number.as_bytes()[column].is_ascii_digit()), "{found:?}");
            }
        }
    }
}
