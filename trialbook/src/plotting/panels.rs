//! Panels that stand below each other in a drawing, and side by side where there is room.

use super::svg::number;

const MARK: [&str; 2] = ["<g data-panel=\"", "</g>\n"];

pub(super) fn mark(top: f64, height: f64, drawn: &str) -> String {
    let [open, close] = MARK;
    format!(
        "{open}{} {}\">\n{drawn}{close}",
        number(top),
        number(height)
    )
}

/// The panels of a drawing, each by itself; one alone is the whole.
pub fn panels(svg: &str) -> Vec<String> {
    let [open, close] = MARK;
    let width = svg
        .split_once("viewBox=\"0 0 ")
        .map_or("", |(_, rest)| rest);
    let width = width.split(' ').next().unwrap_or_default();
    let style = svg.split_once("style=\"").map_or("", |(_, rest)| rest);
    let style = style.split('"').next().unwrap_or_default();
    let one = |part: &str| {
        let (panel, _) = part.rsplit_once(close)?;
        let (place, drawn) = panel.split_once("\">")?;
        let (top, height) = place.split_once(' ')?;
        Some(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 {top} {width} {height}\" width=\"{width}\" \
             height=\"{height}\" style=\"{style}\">{drawn}</svg>\n"
        ))
    };
    let parts: Vec<_> = svg.split(open).skip(1).filter_map(one).collect();
    match parts.is_empty() {
        true => vec![svg.to_owned()],
        false => parts,
    }
}

#[cfg(test)]
mod tests {
    use super::{mark, panels};

    #[test]
    fn a_drawing_is_cut_at_its_marks() {
        let head = "<svg viewBox=\"0 0 480 300\" style=\"max-width:100%\">";
        let whole = format!(
            "{head}{}{}</svg>",
            mark(4.0, 100.0, "<a/>"),
            mark(104.0, 196.0, "<b/>")
        );
        let cut = panels(&whole);
        assert_eq!(cut.len(), 2);
        assert!(cut[1].contains("viewBox=\"0 104 480 196\"") && cut[1].contains("<b/>"));
        assert!(!cut[1].contains("<a/>") && !cut[0].contains("panel"));
        assert_eq!(panels("<svg></svg>"), ["<svg></svg>"]);
    }
}
