//! The table of mistakes in the physics, from the committed result file.

use crate::claims::PAPER;
use trialbook::book::{escape, table};
use trialbook::edition::{Failure, Filled};
use trialbook::ledger::plain_words;

/// What the tool `physics` of `mutants` wrote.
const RESULTS: &str = include_str!("../../snapshots/physics.csv");

/// Each mistake, how many verdicts it changes, and which claims notice first.
pub(super) fn table_of() -> Result<Filled, Failure> {
    let rows: Option<Vec<_>> = RESULTS.lines().skip(1).map(row).collect();
    let rows = rows
        .ok_or("snapshots/physics.csv: a line without six columns, or a claim that there is not")?;
    let head = ["Mistake", "Verdicts that change", "Noticed by"];
    Ok(Filled::Block(table("physics", head, rows)))
}

fn row(line: &str) -> Option<[String; 3]> {
    let [_, physics, _, verdicts, claims, _] = cells(line)?;
    let links: Option<Vec<_>> = claims.split(' ').map(link).collect();
    Some([escape(&physics), verdicts, links?.join(", ")])
}

/// The claim of this id, by its name, with a link to its box.
fn link(id: &str) -> Option<String> {
    let (topic, claim) = PAPER.find(id)?;
    let name = escape(&plain_words(&claim.name()));
    Some(format!("<a href=\"{}.html#{id}\">{name}</a>", topic.stem))
}

/// The six cells of a line; one with a comma stands between quotation marks.
fn cells(line: &str) -> Option<[String; 6]> {
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
        let line = r#"name,"Slow, and late.",src/x.rs,3,eq-1 eq-2,law::eq1"#;
        let [.., physics, _, verdicts, _, _] = cells(line).unwrap();
        assert_eq!([physics.as_str(), &verdicts], ["Slow, and late.", "3"]);
        assert!(cells("one,two").is_none());
    }
}
