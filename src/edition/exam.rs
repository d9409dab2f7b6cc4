//! The tables of the page on the exam.

use crate::exam::{
    Answer, Basis, TASKS,
    published::sliding::{self, Beside, Yield},
    published::{Standing, cases},
    results::{self, Mark},
};
use trialbook::book::{escape, table};
use trialbook::publishing::{Failure, Filled};

pub(super) fn table_of() -> Result<Filled, Failure> {
    let rows: Result<Vec<_>, Failure> = TASKS
        .iter()
        .map(|task| {
            let sat = task.sit()?;
            Ok([
                format!("<code>{}</code>", task.id),
                format!(
                    "{}<br><strong>{}</strong>",
                    escape(task.setup),
                    escape(task.question)
                ),
                escape(format!("{} {}", sat.text(), task.unit).trim_end()),
                error(sat.error, sat.basis),
            ])
        })
        .collect();
    let head = ["Task", "Set-up and question", "Answer", "Error"];
    Ok(Filled::Block(table("exam tasks", head, rows?)))
}

fn error(error: Option<f64>, basis: Basis) -> String {
    match (error, basis) {
        // Of a fraction, the enclosure is as narrow as one asks for.
        (Some(error), _) if error < 1e-20 => "exact".to_owned(),
        (Some(error), Basis::Certified) => format!("certainly below {}", digit(above(error))),
        (Some(error), Basis::Integrated) => format!("about {}", digit(error)),
        (None, _) => "two integrators agree".to_owned(),
    }
}

/// The next number of one digit that is larger.
fn above(x: f64) -> f64 {
    let text = format!("{x:e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    let first = mantissa.chars().next().and_then(|c| c.to_digit(10));
    let next = first.map(|digit| format!("{}e{power}", digit + 1));
    next.and_then(|next| next.parse().ok()).unwrap_or(x)
}

/// A number with one digit, as 3 × 10⁻⁵ in HTML; 0 as it is.
fn digit(x: f64) -> String {
    let scientific = format!("{x:.0e}");
    match scientific.split_once('e') {
        Some((digit, power)) if x != 0.0 && power != "0" => {
            // Not torn at the end of a line.
            format!(
                "{digit}\u{a0}×\u{a0}10<sup>{}</sup>",
                power.replace('-', "−")
            )
        }
        Some((digit, _)) => digit.to_owned(),
        None => scientific,
    }
}

/// A column for each task: ours, and a row for each candidate, of what these say of a task and how long it lasts.
fn by_task(
    ours: impl Fn(&str, f64) -> Result<String, Failure>,
    theirs: impl Fn(&[Mark]) -> Option<String>,
) -> Result<Filled, Failure> {
    let tasks = results::tasks()?;
    let mut head = vec!["Candidate".to_owned(), "Settings".to_owned()];
    head.extend(tasks.iter().map(|(task, _)| format!("<code>{task}</code>")));
    let mut own = OURS.map(str::to_owned).to_vec();
    for (task, lasts) in &tasks {
        own.push(ours(task, *lasts)?);
    }
    let mut rows = vec![own];
    for candidate in results::candidates()? {
        let mut row = vec![escape(&candidate.name), escape(&candidate.settings)];
        for (task, _) in &tasks {
            row.push(theirs(&candidate.marks(task)?).unwrap_or_default());
        }
        rows.push(row);
    }
    Ok(Filled::Block(wide(&head, &rows)))
}

const OURS: [&str; 2] = ["<strong>ours</strong>", "from event to event"];

pub(super) fn errors() -> Result<Filled, Failure> {
    by_task(
        |task, _| Ok(shaded(our_error(task)?)),
        |marks| results::kept(marks).map(|mark| shaded(mark.error)),
    )
}

/// An error on a ground that is the darker the more digits are right.
fn shaded(error: f64) -> String {
    let digits = (-libm::log10(error)).clamp(0.0, 16.0);
    let error = digit(error);
    format!("<span class=\"heat\" style=\"--digits: {digits:.0}\">{error}</span>")
}

/// The accuracy at which costs are compared: what most candidates reach.
const EQUAL: f64 = 1e-3;

/// Where each candidate is within [`EQUAL`] of the answer, and ours.
pub(super) fn costs() -> Result<Filled, Failure> {
    let ours = results::ours()?;
    by_task(
        |task, lasts| our_cost(&ours, task, lasts),
        |marks| results::cost_within(marks, EQUAL).map(|cost| super::speed::time(1e6 * cost)),
    )
}

fn our_cost(ours: &results::Ours, task: &str, lasts: f64) -> Result<String, Failure> {
    let seconds = ours.seconds.get(task).ok_or("a task that was not timed")?;
    Ok(super::speed::time(1e6 * seconds / lasts))
}

pub(super) fn equal() -> Result<Filled, Failure> {
    Ok(Filled::Inline(digit(EQUAL)))
}

fn wide(head: &[String], rows: &[Vec<String>]) -> String {
    let cells = |tag: &str, cells: &[String]| -> String {
        let each = cells.iter().map(|cell| format!("<{tag}>{cell}</{tag}>"));
        format!("<tr>{}</tr>", each.collect::<String>())
    };
    let body: String = rows.iter().map(|row| cells("td", row)).collect();
    let head = cells("th", head).replace("<th>", "<th scope=\"col\">");
    format!(
        "<div class=\"table-wrapper exam scores\"><table><thead>{head}</thead><tbody>{body}</tbody></table></div>\n"
    )
}

fn our_error(id: &str) -> Result<f64, Failure> {
    let task = TASKS
        .iter()
        .find(|task| task.id == id)
        .ok_or("no such task")?;
    Ok(task.sit()?.deviation().ok_or("no number")?)
}

/// Every candidate on every task: error, order and cost where the error is smallest and keeps so.
pub(super) fn runs() -> Result<Filled, Failure> {
    let ours = results::ours()?;
    let mut rows = Vec::new();
    for (task, lasts) in results::tasks()? {
        let name = format!("<code>{task}</code>");
        let cost = our_cost(&ours, task, lasts)?;
        let [who, how] = OURS.map(str::to_owned);
        let none = String::new();
        rows.push([
            name.clone(),
            who,
            how,
            none.clone(),
            digit(our_error(task)?),
            none,
            cost,
        ]);
        for candidate in results::candidates()? {
            let marks = candidate.marks(task)?;
            let Some(Mark { knob, error, cost }) = results::kept(&marks) else {
                continue;
            };
            let order =
                results::order(&marks).map_or("none".to_owned(), |order| format!("{order:.1}"));
            rows.push([
                name.clone(),
                escape(&candidate.name),
                escape(&candidate.settings),
                format!("{} {}", escape(&candidate.knob), digit(knob)),
                digit(error),
                order,
                super::speed::time(1e6 * cost),
            ]);
        }
    }
    let head = [
        "Task",
        "Candidate",
        "Settings",
        "Down to",
        "Error",
        "Order",
        "Cost of a unit of time",
    ];
    Ok(Filled::Block(table("exam runs", head, rows)))
}

pub(super) fn promises() -> Result<Filled, Failure> {
    let mut rows: Vec<[String; 3]> = Vec::new();
    for candidate in results::candidates()? {
        let row =
            [&candidate.name, &candidate.version, &candidate.promises].map(|cell| escape(cell));
        if rows.last() != Some(&row) {
            rows.push(row);
        }
    }
    let head = ["Candidate", "Version", "What it promises, in our words"];
    Ok(Filled::Block(table("exam promises", head, rows)))
}

pub(super) fn sat_on() -> Result<Filled, Failure> {
    Ok(Filled::Inline(escape(
        &results::circumstances()?.join("; "),
    )))
}

pub(super) fn published() -> Result<Filled, Failure> {
    let rows: Result<Vec<_>, Failure> = cases()
        .map(|case| {
            let ours = case.ours()?;
            let standing = match case.standing()? {
                Standing::Agrees => "agrees".to_owned(),
                Standing::Rounded => format!("rounded: {}", escape(case.why)),
                Standing::Wrong => format!("<strong>wrong</strong>: {}", escape(case.why)),
            };
            Ok([
                escape(case.source.title),
                escape(case.source.read),
                escape(case.asked),
                format!("{} {}", escape(&case.printed.to_string()), case.unit),
                format!("{} {}", Answer::Number(rounded(ours)), case.unit),
                standing,
            ])
        })
        .collect();
    let head = ["Source", "Read", "What", "Published", "Ours", "Verdict"];
    Ok(Filled::Block(table("exam published", head, rows?)))
}

/// A number with eleven digits, as many as our motions promise.
fn rounded(x: f64) -> f64 {
    format!("{x:.10e}").parse().unwrap_or(x)
}

/// How many numbers agree with ours, how far the farthest is off, and how far one may be.
fn all_beside(all: &[Beside]) -> [String; 3] {
    let agree = all.iter().filter(|beside| beside.agrees()).count();
    let largest = |of: fn(&Beside) -> f64| digit(all.iter().map(of).fold(0.0, f64::max));
    [
        format!("{agree} of {}", all.len()),
        largest(|beside| beside.apart),
        largest(|beside| beside.allowed),
    ]
}

pub(super) fn sliding() -> Result<Filled, Failure> {
    let rows = sliding::yields()?.into_iter().map(|known| {
        let [closed, history] = [Yield::closed, Yield::history].map(|beside| {
            let all: Vec<_> = known
                .cases
                .iter()
                .map(|case| beside(&known, case))
                .collect();
            all_beside(&all)
        });
        let own = [
            format!("{}", known.at),
            Answer::Number(rounded(known.slip)).to_string(),
        ];
        let cells: Vec<_> = own.into_iter().chain(closed).chain(history).collect();
        cells
    });
    let head = [
        "Yield, g",
        "Our slip, g/ω²",
        "Closed forms that agree",
        "off, m",
        "allowed, m",
        "Histories that agree",
        "off, m",
        "allowed, m",
    ];
    Ok(Filled::Block(wide(
        &head.map(str::to_owned),
        &rows.collect::<Vec<_>>(),
    )))
}

pub(super) fn sliding_read() -> Result<Filled, Failure> {
    Ok(Filled::Inline(escape(sliding::PYSLAMMER.read)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_said_of_an_error_holds() {
        let power = |digit, power| format!("{digit}\u{a0}×\u{a0}10<sup>−{power}</sup>");
        for (size, certified, integrated) in [
            (0.0, "exact".to_owned(), "exact".to_owned()),
            (
                1.4e-13,
                format!("certainly below {}", power(2, 13)),
                format!("about {}", power(1, 13)),
            ),
            (
                1.6e-13,
                format!("certainly below {}", power(2, 13)),
                format!("about {}", power(2, 13)),
            ),
            (
                9.7e-13,
                format!("certainly below {}", power(1, 12)),
                format!("about {}", power(1, 12)),
            ),
            (
                3e-17,
                format!("certainly below {}", power(4, 17)),
                format!("about {}", power(3, 17)),
            ),
        ] {
            let said = [Basis::Certified, Basis::Integrated].map(|basis| error(Some(size), basis));
            assert_eq!(said, [certified, integrated], "{size}");
        }
        for basis in [Basis::Certified, Basis::Integrated] {
            assert_eq!(error(None, basis), "two integrators agree");
        }
    }

    #[test]
    fn what_is_off_stands_before_what_is_allowed() {
        let beside = |apart, allowed| Beside {
            apart,
            allowed,
            ours: 1.0,
        };
        let all = [beside(0.2, 0.3), beside(0.1, 0.1), beside(0.4, 0.3)];
        assert_eq!(
            all_beside(&all),
            [
                "2 of 3",
                "4\u{a0}×\u{a0}10<sup>−1</sup>",
                "3\u{a0}×\u{a0}10<sup>−1</sup>"
            ]
        );
    }
}
