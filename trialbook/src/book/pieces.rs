//! A page as one reads it: sections, and in them prose, formulas and code.

use super::expand::options;
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};

/// What a page consists of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece {
    /// A heading or an exercise begins.
    Section,
    /// A paragraph, a table or a list begins.
    Paragraph,
    /// Words, without placeholders, code and the targets of links.
    Prose(String),
    /// A formula.
    Formula(String),
    /// Rust that runs as a test.
    Code(String),
}

/// The pieces of a page in order, each with its place.
pub fn pieces(page: &str) -> Vec<(usize, Piece)> {
    let text = without_placeholders(page);
    let (mut pieces, mut depth, mut rust, mut other) = (Vec::new(), 0, false, false);
    for (event, range) in Parser::new_ext(&text, options()).into_offset_iter() {
        let piece = match event {
            Event::Start(tag) => {
                depth += 1;
                if let Tag::CodeBlock(kind) = &tag {
                    rust = matches!(kind, CodeBlockKind::Fenced(language) if &**language == "rust");
                    other = !rust;
                }
                match tag {
                    Tag::Heading { .. } => Piece::Section,
                    Tag::Paragraph => Piece::Paragraph,
                    _ if depth == 1 => Piece::Paragraph,
                    _ => continue,
                }
            }
            Event::End(tag) => {
                depth -= 1;
                match tag {
                    TagEnd::CodeBlock => (rust, other) = (false, false),
                    TagEnd::TableCell | TagEnd::Item => {}
                    _ => continue,
                }
                Piece::Prose(" ".to_owned())
            }
            Event::Html(html) if html.starts_with("<div class=\"exercise\"") => Piece::Section,
            Event::Text(code) if rust => Piece::Code(code.into_string()),
            Event::Text(words) if !other => Piece::Prose(words.into_string()),
            Event::SoftBreak | Event::HardBreak | Event::Code(_) => Piece::Prose(" ".to_owned()),
            Event::InlineMath(latex) | Event::DisplayMath(latex) => {
                Piece::Formula(latex.split_whitespace().collect::<Vec<_>>().join(" "))
            }
            _ => continue,
        };
        match (&piece, pieces.last_mut()) {
            (Piece::Prose(more), Some((_, Piece::Prose(words)))) => *words += more,
            (Piece::Code(more), Some((_, Piece::Code(code)))) => *code += more,
            _ => pieces.push((range.start, piece)),
        }
    }
    pieces
}

fn without_placeholders(page: &str) -> String {
    let mut out = String::with_capacity(page.len());
    for line in page.split_inclusive('\n') {
        let mut rest = line;
        while let Some((before, after)) = rest.split_once("{{")
            && let Some((inside, after)) = after.split_once("}}")
        {
            out += before;
            out.extend(std::iter::repeat_n('x', inside.len() + 4));
            rest = after;
        }
        out += rest;
    }
    out
}

pub(super) fn code_beside(page: &str, place: usize) -> String {
    let mut code = String::new();
    for (at, piece) in pieces(page) {
        match piece {
            Piece::Section if at > place => break,
            Piece::Section => code.clear(),
            Piece::Code(more) => code += &more,
            _ => {}
        }
    }
    code
}

#[test]
fn a_page_falls_into_prose_formulas_and_code() {
    use Piece::{Code, Formula, Paragraph, Prose, Section};
    let page = "# A {#a}\nx {{is y 0.5}} `z` [b](c.md)\n\n```rust\nlet a = 1;\n```\n\n$c\nd$\n## B\n```text\n3\n```\n";
    let found: Vec<_> = pieces(page).into_iter().map(|(_, piece)| piece).collect();
    let prose = |text: &str| Prose(text.to_owned());
    assert_eq!(found[..3], [Section, prose("A"), Paragraph]);
    assert!(
        matches!(&found[3], Prose(words) if words.starts_with("x xx") && words.contains("   b")),
        "{found:?}"
    );
    for piece in [Code("let a = 1;\n".to_owned()), Formula("c d".to_owned())] {
        assert!(found.contains(&piece), "{found:?}");
    }
    assert_eq!(code_beside(page, 9), "let a = 1;\n");
    assert_eq!(code_beside(page, page.len() - 1), "");
}
