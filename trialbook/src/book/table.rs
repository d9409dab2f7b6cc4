//! A table, and a block of code.

use super::{
    error::{Fault, Html},
    text::escape,
};

/// A table, as a block of HTML. The cells are HTML.
pub fn table<const N: usize>(
    class: &str,
    head: [&str; N],
    rows: impl IntoIterator<Item = [String; N]>,
) -> String {
    let head = head.map(|cell| format!("<th scope=\"col\">{cell}</th>"));
    let head = head.concat();
    let row = |cells: [String; N]| {
        let cells = cells.map(|cell| format!("<td>{cell}</td>"));
        format!("<tr>{}</tr>", cells.concat())
    };
    let rows: String = rows.into_iter().map(row).collect();
    format!(
        "<div class=\"table-wrapper {class}\"><table><thead><tr>{head}</tr></thead>\
         <tbody>{rows}</tbody></table></div>\n"
    )
}

pub(super) fn tried<const N: usize>(
    class: &str,
    head: [&str; N],
    rows: impl Iterator<Item = Result<[String; N], Fault>>,
) -> Html {
    Ok(table(class, head, rows.collect::<Result<Vec<_>, _>>()?))
}

/// A text as a block of code, in HTML.
pub fn code(text: &str) -> String {
    let lines: Vec<_> = text.lines().map(escape).collect();
    let lines = lines.join("\n");
    format!("<pre><code class=\"language-text\">{lines}</code></pre>\n")
}
