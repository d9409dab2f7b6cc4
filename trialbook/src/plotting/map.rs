//! The map of claims: a box for each, in lanes, and a line for each step of derivation.

use super::{
    Figure, FigureError, Table,
    plot::FACES,
    svg::{escape, number},
    text::width,
};
use std::collections::BTreeSet;

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
    /// Class for the style sheet.
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

/// A box of a number; a box of words is as wide as several with the gaps between them.
const BOX: [f64; 2] = [55.0, 18.0];
const STEP: [f64; 2] = [64.0, 23.0];
const MARGIN: f64 = 8.0;
const LANE_HEAD: f64 = 27.0;
/// The whole map is as wide as a page, and is read at that.
const SIZE: f64 = 12.0;
const SIGN: f64 = 22.0;
const RIM: f64 = 4.0;
/// As many boxes of a number as the longest words are wide.
const LONGEST: usize = 6;
/// As many as a page is wide: words end there.
const WIDEST: usize = 15;

/// Draws the map; lanes by their titles.
///
/// # Errors
/// [`FigureError::Row`] if the table cannot be written.
pub fn map(lanes: &[&str], nodes: &[Node]) -> Result<Figure, FigureError> {
    let columns = columns(nodes);
    let names: Vec<_> = nodes.iter().zip(&columns).map(named).collect();
    let mut filled: Vec<Vec<BTreeSet<usize>>> = vec![Vec::new(); lanes.len()];
    let mut cells = Vec::new();
    for ((node, column), (_, span)) in nodes.iter().zip(&columns).zip(&names) {
        let own = || *column..column + span;
        let rows = &mut filled[node.lane];
        let free = |row: &BTreeSet<usize>| own().all(|column| !row.contains(&column));
        let row = rows.iter().position(free).unwrap_or(rows.len());
        if row == rows.len() {
            rows.push(BTreeSet::new());
        }
        rows[row].extend(own());
        cells.push((*column, row));
    }
    let mut tops = Vec::new();
    let mut height = MARGIN;
    for rows in &filled {
        tops.push(height);
        height += LANE_HEAD + STEP[1] * rows.len() as f64 + MARGIN;
    }
    let taken = filled.iter().flatten().flatten();
    let wide = taken.max().map_or(1, |column| column + 1);
    let width = 2.0 * MARGIN + across(wide);
    let corner = |i: usize| {
        let (column, row) = cells[i];
        let top = tops[nodes[i].lane] + LANE_HEAD;
        [MARGIN + STEP[0] * column as f64, top + STEP[1] * row as f64]
    };

    let mut table = Table::new(&["claim", "verdict", "rests on"]);
    let mut body = String::new();
    for (title, top) in lanes.iter().zip(&tops) {
        body += &format!(
            "<text class=\"lane\" x=\"{}\" y=\"{}\">{}</text>\n",
            number(MARGIN),
            number(top + 18.0),
            escape(title)
        );
    }
    for (i, node) in nodes.iter().enumerate() {
        let [x, y] = corner(i);
        for &on in &node.on {
            let [x0, y0] = corner(on);
            let (from, to) = (
                [x0 + across(names[on].1), y0 + BOX[1] / 2.0],
                [x, y + BOX[1] / 2.0],
            );
            let bend = ((to[0] - from[0]).abs() / 2.0).clamp(8.0, 40.0);
            let class = if node.lane == nodes[on].lane {
                "step"
            } else {
                "step far"
            };
            body += &format!(
                "<path class=\"{class}\" data-from=\"{on}\" data-to=\"{i}\" d=\"M{} {}C{} {} {} {} {} {}\"/>\n",
                number(from[0]),
                number(from[1]),
                number(from[0] + bend),
                number(from[1]),
                number(to[0] - bend),
                number(to[1]),
                number(to[0]),
                number(to[1])
            );
            table.row([node.id, node.words, nodes[on].id])?;
        }
        if node.on.is_empty() {
            table.row([node.id, node.words, ""])?;
        }
    }
    for (i, node) in nodes.iter().enumerate() {
        body += &drawn(node, i, corner(i), &names[i]);
    }
    let title = "The map of claims";
    let alt = "Boxes for all claims in a lane per chapter, each to the right of those it rests on, with lines between \
               them. The list below says the same in words.";
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" \
         font-size=\"{SIZE}\" fill=\"currentColor\" style=\"font-family:{FACES}\">\n<title>{title}</title>\n{body}</svg>\n",
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

/// One more than that of any node of its lane that it rests on.
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

fn across(span: usize) -> f64 {
    STEP[0] * span as f64 - (STEP[0] - BOX[0])
}

/// Its number; else its title, or, where that is too long, as many words of its id as fit; and how many
/// columns that takes.
fn named((node, column): (&Node, &usize)) -> (String, usize) {
    let room = |span: usize| across(span) - SIGN - RIM;
    let longest = WIDEST.saturating_sub(*column).clamp(2, LONGEST);
    let span = |words: &str| (1..=longest).find(|span| width(words, SIZE) <= room(*span));
    // A title begins with a small letter, unless that is a symbol.
    let title = ["the ", "a "]
        .iter()
        .find_map(|article| node.title.strip_prefix(article));
    let title = title.unwrap_or(&node.title);
    // Before the first hyphen stands the section.
    let id = node.id.split_once('-').map_or(node.id, |(_, id)| id);
    let id = id.replace('-', " ");
    let names = [node.name.as_str(), title, &id];
    let mut whole = names.iter().filter(|name| !name.is_empty());
    if let Some((name, span)) = whole.find_map(|name| Some((name, span(name)?))) {
        return ((*name).to_owned(), span);
    }
    let mut ends = id.rmatch_indices(' ').map(|(at, _)| &id[..at]);
    let begun = ends.find(|words| span(words).is_some());
    (begun.unwrap_or_default().to_owned(), longest)
}

fn drawn(node: &Node, i: usize, [x, y]: [f64; 2], (name, span): &(String, usize)) -> String {
    let shaken = if node.shaken { " shaken" } else { "" };
    let whole = [node.name.as_str(), node.title.as_str()].join(" ");
    format!(
        "<a href=\"{href}\" class=\"node {class}{shaken}\" data-node=\"{i}\"><title>{title}</title>\
         <rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"4\"/>\
         <text class=\"sign\" text-anchor=\"middle\" x=\"{sx}\" y=\"{ty}\">{sign}</text>\
         <text class=\"name\" x=\"{tx}\" y=\"{ty}\">{name}</text></a>\n",
        href = escape(&node.href),
        class = node.class,
        title = escape(&format!("{}: {}", whole.trim(), node.words)),
        x = number(x),
        y = number(y),
        w = number(across(*span)),
        h = number(BOX[1]),
        sx = number(x + SIGN / 2.0),
        tx = number(x + SIGN),
        ty = number(y + 13.0),
        sign = node.sign,
        name = escape(name),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::notation::{Tag, tags};

    fn node(id: &'static str, name: &str, title: &str, lane: usize, on: &[usize]) -> Node {
        Node {
            id,
            name: name.into(),
            title: title.into(),
            href: "a.html#b".into(),
            class: "refuted",
            sign: "✗",
            words: "refuted",
            shaken: false,
            lane,
            on: on.to_vec(),
        }
    }

    #[test]
    fn what_rests_on_something_stands_to_its_right() {
        let title = "a title that is longer than its box is wide";
        let node = |id, lane, on: &[usize]| node(id, "", title, lane, on);
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
        assert!(!figure.svg.contains("\n\n") && !figure.svg.contains('…'));
    }

    #[test]
    fn a_name_on_the_map_fits_its_box_and_no_box_lies_on_another() {
        let node = |id, name: &str, title: &str, on: &[usize]| node(id, name, title, 0, on);
        let long = "what is said here in more words than a box can hold, whatever its width";
        for (id, name, title, said) in [
            ("eq-147", "(147)", long, "(147)"),
            ("s4-rest", "", "the rest", "rest"),
            ("s4-meet", "", "A and B meet", "A and B meet"),
            ("s4-rest-or-escape", "", long, "rest or escape"),
        ] {
            let (words, span) = named((&node(id, name, title, &[]), &0));
            assert!(words == said && width(said, SIZE) <= across(span) - SIGN);
        }
        let id = "s4-a-very-long-id-that-has-far-too-many-words-for-any-box-of-a-map-of-claims";
        let (words, span) = named((&node(id, "", long, &[]), &0));
        assert!(
            span == LONGEST
                && words.starts_with("a very long")
                && width(&words, SIZE) <= across(span) - SIGN
        );
        // At the end of a row there is room for fewer words.
        let (words, _) = named((
            &node("s4-meet", "", "where the curves A and B meet", &[]),
            &13,
        ));
        assert_eq!(words, "meet");
        let nodes = [
            node("s1-a-long-one", "", long, &[]),
            node("eq-1", "(1)", long, &[]),
            node("eq-2", "(2)", long, &[1]),
            node("eq-3", "(3)", long, &[2]),
        ];
        let figure = map(&["lane"], &nodes).unwrap();
        let boxes = tags(&figure.svg).filter(|tag| tag.name == "rect");
        let size = |tag: &Tag<'_>, key| tag.value(key).unwrap().parse::<f64>().unwrap();
        let boxes: Vec<_> = boxes
            .map(|tag| ["x", "y", "width"].map(|key| size(&tag, key)))
            .collect();
        for (i, a) in boxes.iter().enumerate() {
            for b in &boxes[..i] {
                assert!(
                    a[1] != b[1] || a[0] >= b[0] + b[2] || b[0] >= a[0] + a[2],
                    "{boxes:?}"
                );
            }
        }
    }
}
