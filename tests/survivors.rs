//! The list of changes that no test notices, with the reasons, beside its own count.
//!
//! The tool in `mutants` makes the changes and compares what survives with this list; that takes hours, and there it shows
//! whether the list still speaks of the code as it is. This test asks that it is in order.

use std::collections::BTreeSet;

const LIST: &str = include_str!("../mutants/survivors.txt");

/// The last number before these words in the list's head.
fn told(words: &str) -> usize {
    let head = LIST.lines().take_while(|line| line.starts_with('#'));
    let head: String = head.map(|line| line.trim_start_matches('#')).collect();
    let (before, _) = head.split_once(words).unwrap();
    let is_number = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit());
    let number = before.split_whitespace().rev().find(is_number).unwrap();
    number.replace(',', "").parse().unwrap()
}

#[test]
fn every_survivor_has_a_reason_and_is_counted() {
    let (mut reason, mut reasons) = ("", BTreeSet::new());
    let (mut listed, mut survivors) = (BTreeSet::new(), 0);
    for line in LIST
        .lines()
        .filter(|l| !l.starts_with('#') && !l.is_empty())
    {
        if let Some(text) = line.strip_prefix("> ") {
            reason = text;
            assert!(text.len() > 20 && reasons.insert(text), "{text}");
            continue;
        }
        let cells: Vec<_> = line.split('\t').collect();
        let [file, change, code, count @ ..] = &cells[..] else {
            panic!("{line}");
        };
        assert!(
            !reason.is_empty() && listed.insert((*file, *change, *code)),
            "{line}"
        );
        survivors += count.first().map_or(1, |n| n.parse().unwrap());
    }
    assert_eq!(survivors, told("are listed here"));
    assert_eq!(told("can be made"), told("are noticed") + survivors);
}
