//! The table of mistakes in the physics, as the committed record has it.

use crate::claims::PAPER;
use trialbook::book::{escape, table};
use trialbook::data::{Text, text};
use trialbook::notation::plain_words;
use trialbook::publishing::Filled;
use trialbook::trials::as_of;

/// What the tool `mutants` wrote.
pub(super) const RECORD: Text = text!("snapshots/physics.csv");

/// Each mistake, how many verdicts it changed, and which claims noticed first. A row that does not fit what there is now is
/// left out.
pub(super) fn table_of() -> Filled {
    let rows = RECORD.lines().skip(1).filter_map(row);
    let head = ["Mistake", "Verdicts that change", "Noticed by"];
    let table = table("physics", head, rows);
    Filled::Block(format!("<p>{}.</p>{table}", escape(as_of(&RECORD))))
}

fn row(line: &str) -> Option<[String; 3]> {
    let [_, physics, verdicts, claims, _] = cells(line)?;
    let links: Option<Vec<_>> = claims.split(' ').map(link).collect();
    Some([escape(&physics), verdicts, links?.join(", ")])
}

fn link(id: &str) -> Option<String> {
    let (topic, claim) = PAPER.find(id)?;
    let name = escape(&plain_words(&claim.name()));
    Some(format!("<a href=\"{}.html#{id}\">{name}</a>", topic.stem))
}

/// The five cells of a line; one with a comma stands between quotation marks.
fn cells(line: &str) -> Option<[String; 5]> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            c => cells.last_mut()?.push(c),
        }
    }
    cells.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_between_quotation_marks_is_text() {
        let line = r#"name,"Slow, and late.",3,eq-1 eq-2,eq-1 root printed 1; eq-2 root printed 1"#;
        let [_, physics, verdicts, ..] = cells(line).unwrap();
        assert_eq!([physics.as_str(), &verdicts], ["Slow, and late.", "3"]);
    }

    #[test]
    fn what_does_not_fit_is_left_out() {
        assert!(row("slow,Too slow.,3,eq-1,").is_some());
        for line in ["one,two", "slow,Too slow.,3,eq-0,"] {
            assert!(row(line).is_none(), "{line}");
        }
    }
}
