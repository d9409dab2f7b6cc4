//! Long formulas in rows: browsers break no line within MathML.

use crate::notation::tags;

/// In letters' heights, on paper and on a desk.
const ROOM: f64 = 37.0;
const INDENT: f64 = 1.5;
/// What is left at least for a part between its neighbours in a row.
const LEAST: f64 = 8.0;

pub(super) const LAST_ROW: &str = "</mrow></mtd></mtr></mtable>";

#[derive(Debug, Clone, PartialEq)]
enum Node {
    Text(String),
    Element(String, Vec<Node>),
}

pub(super) fn in_rows(html: &str) -> String {
    let mut nodes = nodes(html);
    arrange(&mut nodes);
    nodes.iter().map(written).collect()
}

/// Or what is inside the one element around all of it.
fn arrange(list: &mut Vec<Node>) {
    let long = width(list, true) > ROOM;
    match list.as_mut_slice() {
        [Node::Element(tag, inside)] if ["span", "math", "mrow", "mstyle"].contains(&name(tag)) => {
            arrange(inside);
        }
        _ if long => *list = fitted(std::mem::take(list), ROOM, true),
        _ => {}
    }
}

fn nodes(html: &str) -> Vec<Node> {
    let mut open = vec![(String::new(), Vec::new())];
    let close = |open: &mut Vec<(String, Vec<Node>)>| {
        if let [.., (_, around), (tag, inside)] = &mut open[..] {
            around.push(Node::Element(std::mem::take(tag), std::mem::take(inside)));
            open.pop();
        }
    };
    for tag in tags(html) {
        if tag.closes {
            close(&mut open);
        }
        let inside = || tag.tag.trim_matches(['<', '>']).to_owned();
        match &mut open[..] {
            [.., (_, around)] if tag.alone => around.push(Node::Element(inside(), Vec::new())),
            _ if !tag.closes && !tag.tag.is_empty() => open.push((inside(), Vec::new())),
            _ => {}
        }
        if let ([.., (_, around)], false) = (&mut open[..], tag.text.is_empty()) {
            around.push(Node::Text(tag.text.to_owned()));
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.swap_remove(0).1
}

fn written(node: &Node) -> String {
    match node {
        Node::Text(text) => text.clone(),
        Node::Element(tag, _) if tag.ends_with('/') => format!("<{tag}>"),
        Node::Element(tag, inside) => {
            let inside: String = inside.iter().map(written).collect();
            format!("<{tag}>{inside}</{}>", name(tag))
        }
    }
}

fn name(tag: &str) -> &str {
    tag.split([' ', '/']).next().unwrap_or_default()
}

fn row(inside: Vec<Node>) -> Node {
    Node::Element("mrow".into(), inside)
}

fn sign(node: &Node) -> Option<&str> {
    match node {
        Node::Element(tag, inside) if name(tag) == "mo" => match inside.as_slice() {
            [Node::Text(text)] => Some(text),
            _ => None,
        },
        // A bracket with a power.
        Node::Element(tag, inside) if name(tag).starts_with("msu") => sign(inside.first()?),
        _ => None,
    }
}

/// In letters' heights, rather too wide than too narrow; fractions in fractions are smaller unless all is as
/// large as on a line of its own.
fn width(list: &[Node], display: bool) -> f64 {
    list.iter().map(|node| wide(node, display)).sum()
}

fn wide(node: &Node, display: bool) -> f64 {
    let (tag, inside) = match node {
        Node::Text(_) => return 0.0,
        Node::Element(tag, inside) => (tag, inside),
    };
    let part = |i: usize, display: bool| inside.get(i).map_or(0.0, |node| wide(node, display));
    match name(tag) {
        "mo" => match sign(node).unwrap_or_default() {
            "\u{2061}" => 0.2,
            "(" | ")" | "[" | "]" | "|" | "," => 0.5,
            "⋅" | "·" => 0.7,
            _ => 1.3,
        },
        "mi" | "mn" | "mtext" => match inside.as_slice() {
            [Node::Text(text)] => text.chars().map(letter).sum(),
            _ => letter('x'),
        },
        "mspace" => 0.3,
        "msub" | "msup" => part(0, display) + 0.1 + 0.85 * part(1, false),
        "msubsup" => part(0, display) + 0.1 + 0.85 * part(1, false).max(part(2, false)),
        "mfrac" => {
            let size = if display { 1.0 } else { 0.72 };
            0.2 + size * part(0, false).max(part(1, false))
        }
        "msqrt" => 1.0 + width(inside, display),
        "mover" | "munder" | "munderover" => part(0, display),
        "mtable" | "mtr" => inside
            .iter()
            .map(|node| wide(node, display))
            .fold(0.0, f64::max),
        _ => width(inside, display),
    }
}

/// How wide a letter or digit is; browsers set Greek in wide fonts.
fn letter(sign: char) -> f64 {
    match sign {
        'm' | 'w' | 'M' | 'W' => 0.95,
        'A'..='Z' | 'α'..='ω' => 0.85,
        _ => 0.58,
    }
}

fn fitted(list: Vec<Node>, room: f64, display: bool) -> Vec<Node> {
    let rows = broken(flat(list, room, display), room, display);
    let rows = rows
        .into_iter()
        .map(|inside| narrowed(inside, room, display));
    let mut rows: Vec<_> = rows.collect();
    if rows.len() < 2 {
        return rows.pop().unwrap_or_default();
    }
    let style = if display {
        " displaystyle=\"true\""
    } else {
        ""
    };
    let row = |inside| {
        let cell = Node::Element("mtd".into(), vec![row(inside)]);
        Node::Element("mtr".into(), vec![cell])
    };
    let rows = rows.into_iter().map(row).collect();
    vec![Node::Element(format!("mtable class=\"rows\"{style}"), rows)]
}

/// Rows of their own, and brackets with a power, hold long parts together.
fn flat(list: Vec<Node>, room: f64, display: bool) -> Vec<Node> {
    let mut out = Vec::new();
    for node in list {
        let long = wide(&node, display) > room / 2.0;
        match node {
            Node::Element(tag, inside) if long && name(&tag) == "mrow" => {
                out.extend(flat(inside, room, display));
            }
            Node::Element(tag, mut parts)
                if long && name(&tag) == "msup" && is_bracket(parts.first()) =>
            {
                let power = parts.pop();
                out.extend(flat(parts, room, display));
                let closing = out.pop();
                let parts = closing.into_iter().chain(power).collect();
                out.push(Node::Element(tag, parts));
            }
            node => out.push(node),
        }
    }
    out
}

fn is_bracket(node: Option<&Node>) -> bool {
    let last = match node {
        Some(Node::Element(tag, inside)) if name(tag) == "mrow" => inside.last(),
        _ => None,
    };
    matches!(last.and_then(sign), Some(")" | "]"))
}

/// Each begun by a sign between two terms, or by a factor where there is none.
fn broken(list: Vec<Node>, room: f64, display: bool) -> Vec<Vec<Node>> {
    // Before which places a row may begin, and how deep in brackets that is.
    let mut depth = 0_i32;
    let mut places = Vec::new();
    for (i, node) in list.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| sign(&list[i]));
        let after_term = i > 0 && before.is_none_or(|sign| [")", "]", "|"].contains(&sign));
        match sign(node) {
            Some("=" | "≈" | "≤" | "≥" | "&lt;" | "&gt;") if i > 0 => {
                places.push((i, depth - 1))
            }
            Some("+" | "−") if after_term => places.push((i, depth)),
            Some("(" | "[") if matches!(before, Some(")" | "]")) => places.push((i, depth + 1)),
            _ if before == Some(",") => places.push((i, depth)),
            _ => {}
        }
        match sign(node) {
            Some("(" | "[") => depth += 1,
            Some(")" | "]") => depth -= 1,
            _ => {}
        }
    }
    let widths: Vec<f64> = list.iter().map(|node| wide(node, display)).collect();
    let all = |from: usize, to: usize| widths[from..to].iter().sum::<f64>();
    let mut starts = vec![0];
    loop {
        let start = starts[starts.len() - 1];
        let room = if start == 0 { room } else { room - INDENT };
        if all(start, list.len()) <= room {
            break;
        }
        let ahead = || places.iter().filter(|(i, _)| *i > start);
        let fits = |(i, _): &&(usize, i32)| all(start, *i) <= room;
        let full = |(i, _): &&(usize, i32)| all(start, *i) > 0.4 * room;
        // Where it is least deep, and there the last; a row that is not half full is a pity.
        let best = ahead()
            .filter(fits)
            .filter(full)
            .min_by_key(|(i, depth)| (*depth, std::cmp::Reverse(*i)));
        let next = best
            .or_else(|| ahead().rfind(fits))
            .or_else(|| ahead().next());
        match next {
            Some((i, _)) => starts.push(*i),
            None => break,
        }
    }
    let mut rows: Vec<Vec<Node>> = Vec::new();
    let mut rest = list;
    for start in starts.into_iter().rev() {
        rows.push(rest.split_off(start));
    }
    rows.reverse();
    // A sign at the start of a row stands between two terms all the same.
    for first in rows.iter_mut().skip(1).filter_map(|row| row.first_mut()) {
        if let Node::Element(tag, _) = first
            && tag == "mo"
        {
            *tag += " form=\"infix\"";
        }
    }
    rows
}

fn narrowed(mut row: Vec<Node>, room: f64, display: bool) -> Vec<Node> {
    for _ in 0..row.len() {
        let all = width(&row, display);
        let inside = |node: &&mut Node| matches!(node, Node::Element(tag, _) if ["mfrac", "msqrt", "mrow"].contains(&name(tag)));
        let widest = row
            .iter_mut()
            .filter(inside)
            .max_by(|a, b| wide(a, display).total_cmp(&wide(b, display)));
        let Some(Node::Element(tag, parts)) = widest.filter(|_| all > room) else {
            break;
        };
        let (kind, before) = (name(tag).to_owned(), parts.clone());
        let own = wide(&Node::Element(tag.clone(), before.clone()), display);
        let left = (room - (all - own)).max(LEAST);
        let taken = std::mem::take(parts);
        *parts = match kind.as_str() {
            "mfrac" => {
                let size = if display { 1.0 } else { 0.72 };
                let part = |node| self::row(fitted(vec![node], left / size, false));
                taken.into_iter().map(part).collect()
            }
            "msqrt" => fitted(taken, left - 1.0, display),
            _ => fitted(taken, left, display),
        };
        if *parts == before {
            break;
        }
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(terms: usize) -> String {
        let term = |i: usize| {
            format!(
                "<mo>+</mo><mn>{}</mn><msup><mi>x</mi><mn>{i}</mn></msup>",
                100 + i
            )
        };
        (0..terms).map(term).collect()
    }

    fn math(inside: &str) -> String {
        format!(
            "<span class=\"katex\"><math><mrow><mstyle displaystyle=\"true\">{inside}</mstyle></mrow></math></span>"
        )
    }

    fn widest(html: &str) -> f64 {
        wide(&Node::Element("mrow".into(), nodes(html)), true)
    }

    fn text(html: &str) -> String {
        crate::notation::without_tags(html)
    }

    #[test]
    fn a_short_formula_stays_as_it_is() {
        let short = math("<mi>y</mi><mo>&lt;</mo><mspace width=\"1em\"/><mi>x</mi>");
        assert_eq!(in_rows(&short), short);
    }

    #[test]
    fn a_long_formula_fits_and_keeps_its_letters() {
        let long = format!(
            "<mo stretchy=\"false\">(</mo>{}<mo stretchy=\"false\">)</mo>",
            sum(30)
        );
        let fraction = format!(
            "<mi>y</mi><mo>=</mo><mo>−</mo><mfrac><mrow>{long}{long}</mrow><mrow>{}</mrow></mfrac><mo>+</mo><mn>1</mn>",
            sum(3)
        );
        let root = format!("<msqrt><mrow>{}</mrow></msqrt>", sum(20));
        let power = format!(
            "<msup><mrow><mo fence=\"true\">(</mo>{}<mo fence=\"true\">)</mo></mrow><mn>2</mn></msup>",
            sum(20)
        );
        for inside in [sum(40), fraction, root, power.repeat(2)] {
            let whole = math(&inside);
            let rows = in_rows(&whole);
            assert!(
                widest(&whole) > ROOM && widest(&rows) <= ROOM + 1.0,
                "{}: {rows}",
                widest(&rows)
            );
            assert_eq!(text(&rows), text(&whole));
            assert!(
                rows.matches("<mtr>").count() >= 2
                    && rows.matches("<mrow>").count() == rows.matches("</mrow>").count()
            );
        }
    }

    #[test]
    fn rows_begin_with_signs_between_terms() {
        let negative = "<mo>=</mo><mo>−</mo><mi>x</mi><mo stretchy=\"false\">(</mo><mo>−</mo><mi>y</mi><mo stretchy=\"false\">)</mo>".repeat(12);
        let rows = in_rows(&math(&negative));
        for row in rows.split("<mtd><mrow>").skip(2) {
            assert!(row.starts_with("<mo form=\"infix\">="), "{row}");
        }
    }
}
