//! Puts mistakes into a source, each behind its switch.

use std::ops::Range;

const MARKS: [char; 2] = ['⟦', '⟧'];

#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    pub id: usize,
    /// In bytes.
    pub range: Range<usize>,
    pub wrong: String,
}

/// Where the marked part of `right` is in `source`, blanks and line ends apart.
///
/// # Errors
/// Why it cannot be told, in words that follow on "it".
pub fn find(source: &str, right: &str) -> Result<Range<usize>, &'static str> {
    let mut marks = [None; 2];
    let mut wanted = Vec::new();
    for c in right.chars().filter(|c| !c.is_whitespace()) {
        match MARKS.iter().position(|mark| *mark == c) {
            Some(which) => marks[which] = Some(wanted.len()),
            None => wanted.push(c),
        }
    }
    let [Some(from), Some(to)] = marks else {
        return Err("marks no part to be replaced");
    };
    if from >= to {
        return Err("marks an empty part");
    }
    let here: Vec<_> = source.char_indices().collect();
    let here: Vec<_> = here
        .into_iter()
        .filter(|(_, c)| !c.is_whitespace())
        .collect();
    let fits = |window: &&[(usize, char)]| window.iter().map(|(_, c)| c).eq(&wanted);
    let mut places = here.windows(wanted.len()).filter(fits);
    let (Some(place), None) = (places.next(), places.next()) else {
        let times = here.windows(wanted.len()).filter(fits).count();
        return Err(match times {
            0 => "is no longer there",
            _ => "is there more than once",
        });
    };
    let (last, c) = place[to - 1];
    Ok(place[from].0..last + c.len_utf8())
}

/// The source with all mistakes in it. Places are the same, one within the other, or apart.
///
/// # Errors
/// The numbers of two mistakes whose places overlap.
pub fn patched(source: &str, mut places: Vec<Place>) -> Result<String, [usize; 2]> {
    places.sort_by_key(|p| (p.range.start, usize::MAX - p.range.end, p.id));
    part(source, 0..source.len(), &places)
}

fn part(source: &str, range: Range<usize>, places: &[Place]) -> Result<String, [usize; 2]> {
    let (mut out, mut at, mut rest) = (String::new(), range.start, places);
    while let Some(first) = rest.first() {
        let Range { start, end } = first.range;
        let same = rest.iter().take_while(|p| p.range == first.range).count();
        let (here, after) = rest.split_at(same);
        let (inner, after) = after.split_at(after.partition_point(|p| p.range.start < end));
        if let Some(other) = inner.iter().find(|p| p.range.end > end) {
            return Err([first.id, other.id]);
        }
        out += &source[at..start];
        let right = part(source, start..end, inner)?;
        let branches: String = here
            .iter()
            .map(|p| {
                format!(
                    "if crate::wrong({}) {{ {} }} else ",
                    p.id,
                    p.wrong.trim_end()
                )
            })
            .collect();
        // An expression may stand before an operator.
        let statement = right.ends_with([';', '}']);
        out += &match statement {
            true => format!("{branches}{{ {right} }}"),
            false => format!("({branches}{{ {right} }})"),
        };
        (at, rest) = (end, after);
    }
    Ok(out + &source[at..range.end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(id: usize, source: &str, right: &str, wrong: &str) -> Place {
        Place {
            id,
            range: find(source, right).unwrap(),
            wrong: wrong.into(),
        }
    }

    #[test]
    fn a_part_is_found_whatever_the_blanks() {
        let source = "let a = b\n    + c;\nlet d = b + e;";
        assert_eq!(find(source, "b + ⟦c⟧;"), Ok(16..17));
        assert_eq!(find(source, "⟦b +⟧ c;"), Ok(8..15));
        assert_eq!(find(source, "b + ⟦f⟧"), Err("is no longer there"));
        assert_eq!(find(source, "⟦b⟧ +"), Err("is there more than once"));
        assert_eq!(find(source, "b + c"), Err("marks no part to be replaced"));
    }

    #[test]
    fn mistakes_stand_side_by_side_and_within_each_other() {
        let source = "x = a * (b + c);";
        let places = vec![
            place(2, source, "⟦b⟧ + c", "2.0 * b"),
            place(1, source, "⟦a * (b + c)⟧", "a"),
            place(3, source, "⟦b⟧ + c", "-b"),
        ];
        let inner = "(if crate::wrong(2) { 2.0 * b } else if crate::wrong(3) { -b } else { b })";
        let expected = format!("x = (if crate::wrong(1) {{ a }} else {{ a * ({inner} + c) }});");
        assert_eq!(patched(source, places), Ok(expected));
        let whole = vec![place(4, "f(); g();", "⟦g();⟧", "h();")];
        assert_eq!(
            patched("f(); g();", whole).unwrap(),
            "f(); if crate::wrong(4) { h(); } else { g(); }"
        );
        let crossed = vec![
            place(1, source, "⟦a * (b⟧", ""),
            place(2, source, "⟦b + c⟧", ""),
        ];
        assert_eq!(patched(source, crossed), Err([1, 2]));
    }
}
