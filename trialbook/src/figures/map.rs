//! The map of claims: a box for each, in lanes, and a line for each step of derivation.

use super::axes::TEXT_SIZE;
use super::plot::FACES;
use super::svg::{escape, number};
use super::text::width;
use super::{Figure, FigureError, Table};
use std::collections::BTreeMap;

/// A claim on the map.
#[derive(Debug, Clone)]
pub struct Node {
    /// Permanent id.
    pub id: &'static str,
    /// Short name: `(11)`, or nothing.
    pub name: String,
    /// What it is about; plain text.
    pub title: String,
    /// Where a click leads.
    pub href: String,
    /// Class for the style sheet, and the sign and words that say the same without colour.
    pub class: &'static str,
    /// Sign before the name.
    pub sign: &'static str,
    /// The sign in words.
    pub words: &'static str,
    /// True if it rests, directly or not, on one that fails.
    pub shaken: bool,
    /// Number of its lane.
    pub lane: usize,
    /// Places in the list of those that it rests on.
    pub on: Vec<usize>,
}

const BOX: [f64; 2] = [150.0, 42.0];
const STEP: [f64; 2] = [182.0, 52.0];
const MARGIN: f64 = 12.0;
const LANE_HEAD: f64 = 34.0;
/// Size of the small type, and the room for type in a box.
const SMALL: f64 = 12.0;
const ROOM: f64 = 136.0;
/// Size of the type where the whole map is seen.
const WHOLE: f64 = 30.0;

/// Draws the map; lanes by their titles.
///
/// # Errors
/// [`FigureError::Row`] if the table cannot be written.
pub fn map(lanes: &[&str], nodes: &[Node]) -> Result<Figure, FigureError> {
    let columns = columns(nodes);
    // The next free row of each column of each lane.
    let mut filled: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    let mut cells = Vec::new();
    for (node, column) in nodes.iter().zip(&columns) {
        let row = filled.entry((node.lane, *column)).or_default();
        cells.push((*column, *row));
        *row += 1;
    }
    let mut tops = Vec::new();
    let mut height = MARGIN;
    for lane in 0..lanes.len() {
        tops.push(height);
        let of_lane = filled.iter().filter(|((l, _), _)| *l == lane);
        let rows = of_lane.map(|(_, rows)| *rows).max().unwrap_or(0);
        height += LANE_HEAD + STEP[1] * rows as f64 + MARGIN;
    }
    let wide = columns.iter().max().map_or(1, |column| column + 1);
    let width = 2.0 * MARGIN + STEP[0] * wide as f64 - (STEP[0] - BOX[0]);
    let corner = |i: usize| {
        let (column, row) = cells[i];
        let top = tops[nodes[i].lane] + LANE_HEAD;
        [MARGIN + STEP[0] * column as f64, top + STEP[1] * row as f64]
    };

    let mut table = Table::new(&["claim", "verdict", "rests on"]);
    let mut body = String::new();
    for (title, top) in lanes.iter().zip(&tops) {
        body.push_str(&format!(
            "<text class=\"lane\" x=\"{}\" y=\"{}\">{}</text>\n",
            number(MARGIN),
            number(top + 20.0),
            escape(title)
        ));
    }
    for (i, node) in nodes.iter().enumerate() {
        let [x, y] = corner(i);
        for &on in &node.on {
            let [x0, y0] = corner(on);
            let (from, to) = ([x0 + BOX[0], y0 + BOX[1] / 2.0], [x, y + BOX[1] / 2.0]);
            let bend = ((to[0] - from[0]).abs() / 2.0).clamp(16.0, 60.0);
            let class = if node.lane == nodes[on].lane {
                "step"
            } else {
                "step far"
            };
            body.push_str(&format!(
                "<path class=\"{class}\" data-from=\"{on}\" data-to=\"{i}\" d=\"M{} {}C{} {} {} {} {} {}\"/>\n",
                number(from[0]),
                number(from[1]),
                number(from[0] + bend),
                number(from[1]),
                number(to[0] - bend),
                number(to[1]),
                number(to[0]),
                number(to[1])
            ));
            table.row([node.id.into(), node.words.into(), nodes[on].id.into()])?;
        }
        if node.on.is_empty() {
            table.row([node.id.into(), node.words.into(), "".into()])?;
        }
    }
    for (i, node) in nodes.iter().enumerate() {
        body.push_str(&drawn(node, i, corner(i)));
    }
    let title = "The map of claims";
    let alt = "Boxes for all claims in a lane per chapter, each to the right of those it rests on, with lines between \
               them. The list below says the same in words.";
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" \
         font-size=\"{TEXT_SIZE}\" fill=\"currentColor\" style=\"font-family:{FACES}\">\n<title>{title}</title>\n{body}</svg>\n",
        w = number(width),
        h = number(height),
    );
    Ok(Figure {
        id: "map",
        caption: "Every box is a claim; it stands to the right of the claims of its chapter that it rests on. Lines \
                  between chapters are dashed. A broken frame: it rests, directly or not, on a claim that fails."
            .into(),
        alt: alt.into(),
        svg,
        csv: table.into_text(),
    })
}

/// The column of each node: one more than that of any node of its lane that it rests on.
fn columns(nodes: &[Node]) -> Vec<usize> {
    let mut columns = vec![0; nodes.len()];
    // As often as the longest chain could ask for; a ring, which the claims' tests forbid, ends here too.
    for _ in nodes {
        let mut settled = true;
        for (i, node) in nodes.iter().enumerate() {
            let below = node.on.iter().filter(|on| nodes[**on].lane == node.lane);
            let least = below.map(|on| columns[*on] + 1).max().unwrap_or(0);
            if columns[i] < least {
                columns[i] = least;
                settled = false;
            }
        }
        if settled {
            break;
        }
    }
    columns
}

/// A node's box with its two lines.
fn drawn(node: &Node, i: usize, [x, y]: [f64; 2]) -> String {
    let (first, rest) = match node.name.as_str() {
        "" => cut(&node.title, ROOM - 26.0, TEXT_SIZE),
        name => (name, node.title.as_str()),
    };
    let second = match cut(rest, ROOM, SMALL) {
        (line, "") => line.to_owned(),
        _ => cut(rest, ROOM - SMALL, SMALL).0.to_owned() + "…",
    };
    let shaken = if node.shaken { " shaken" } else { "" };
    // What stands for the words where the whole map is seen.
    let short = match node.name.as_str() {
        "" => format!(
            "<tspan class=\"short\" display=\"none\">{}</tspan>",
            escape(&begun(node.sign, &node.title))
        ),
        _ => String::new(),
    };
    let name = [node.name.as_str(), node.title.as_str()].join(" ");
    format!(
        "<a href=\"{href}\" class=\"node {class}{shaken}\" data-node=\"{i}\"><title>{title}</title>\
         <rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"6\"/>\
         <text x=\"{tx}\" y=\"{t1}\">{sign} <tspan class=\"{kind}\">{first}</tspan>{short}</text><text font-size=\"{SMALL}\" x=\"{tx}\" y=\"{t2}\">{second}</text></a>\n",
        href = escape(&node.href),
        class = node.class,
        title = escape(&format!("{}: {}", name.trim(), node.words)),
        x = number(x),
        y = number(y),
        w = number(BOX[0]),
        h = number(BOX[1]),
        tx = number(x + 8.0),
        t1 = number(y + 18.0),
        t2 = number(y + 34.0),
        sign = node.sign,
        kind = if node.name.is_empty() {
            "words"
        } else {
            "name"
        },
        first = escape(first),
        second = escape(&second),
    )
}

/// The beginning of a title, without its article, as far as a box has room for it behind the sign in the type of the whole map.
fn begun(sign: &str, title: &str) -> String {
    let articles = ["The ", "the ", "A ", "a "];
    let plain = articles
        .iter()
        .find_map(|article| title.strip_prefix(article));
    let plain = plain.unwrap_or(title);
    let fits = |words: &str| width(&format!("{sign} {words}"), WHOLE) <= ROOM;
    if fits(plain) {
        return plain.to_owned();
    }
    // Browsers without the book's type may set the dots wide.
    let mut ends = plain.char_indices().map(|(at, _)| &plain[..at]).rev();
    let short = ends.find(|start| fits(&format!("{start}. . .")));
    format!("{}…", short.unwrap_or_default().trim_end())
}

/// As many words as fit, at least one, and the rest.
fn cut(words: &str, room: f64, size: f64) -> (&str, &str) {
    let mut ends = words.rmatch_indices(' ').map(|(at, _)| at);
    let fits = |end: &usize| width(&words[..*end], size) <= room;
    let fitting = Some(words.len()).filter(fits).or_else(|| ends.find(fits));
    let end = fitting.or(words.find(' ')).unwrap_or(words.len());
    (&words[..end], words[end..].trim_start())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rests_on_something_stands_to_its_right() {
        let node = |id, lane, on: &[usize]| Node {
            id,
            name: String::new(),
            title: "a title that is longer than its box is wide".into(),
            href: "a.html#b".into(),
            class: "refuted",
            sign: "✗",
            words: "refuted",
            shaken: false,
            lane,
            on: on.to_vec(),
        };
        let nodes = [
            node("a", 0, &[2]),
            node("b", 1, &[0]),
            node("c", 0, &[]),
            node("d", 1, &[1, 0]),
        ];
        assert_eq!(columns(&nodes), [1, 0, 0, 1]);
        let figure = map(&["one", "two"], &nodes).unwrap();
        assert_eq!(figure.csv.lines().count(), 6);
        assert_eq!(figure.svg.matches("class=\"step far\"").count(), 2);
        assert!(!figure.svg.contains("\n\n") && figure.svg.contains('…'));
    }

    #[test]
    fn a_name_on_the_whole_map_fits_its_box() {
        assert_eq!(begun("✓", "the rest"), "rest");
        for sign in ["✓", "✓°", "(✓)"] {
            let short = begun(sign, "the boundary between rest and escape");
            assert!(
                short.len() > 4 && short.starts_with("b") && short.ends_with('…'),
                "{short}"
            );
            assert!(width(&format!("{sign} {short}"), WHOLE) <= ROOM, "{short}");
        }
    }
}
