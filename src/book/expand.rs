//! From a page as written to a page as mdBook gets it: placeholders filled, formulas set.

use super::error::{BookError, Fault};
use super::fill::{Filled, Filler};
use super::maths::for_markdown;
use super::pages::Page;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;

/// What a stretch of a page is, where it is not plain text.
enum Piece {
    /// Code: stays as it is.
    Code,
    /// A formula, on a line of its own or not.
    Formula { latex: String, display: bool },
}

/// Fills the placeholders and sets the formulas of one page.
pub(super) fn expand(page: &Page, filler: &Filler<'_>) -> Result<String, BookError> {
    let source = page.text.as_str();
    let mut out = String::with_capacity(source.len() * 4);
    let mut done = 0;
    for (range, piece) in pieces(page)? {
        fill(page, done..range.start, filler, &mut out)?;
        done = range.end;
        match piece {
            Piece::Code => out.push_str(&source[range]),
            Piece::Formula { latex, display } => {
                let maths = filler.maths();
                let html = if display {
                    maths.display(&latex)
                } else {
                    maths.inline(&latex)
                };
                let html = html.map_err(|fault| at(page, range.start, &latex, fault))?;
                out.push_str(&for_markdown(&html));
            }
        }
    }
    fill(page, done..source.len(), filler, &mut out)?;
    Ok(out)
}

/// The formulas of a written page, each with whether it stands on a line of its own.
pub(super) fn formulas(text: &str) -> impl Iterator<Item = (String, bool)> {
    Parser::new_ext(text, options()).filter_map(|event| match event {
        Event::InlineMath(latex) => Some((latex.into_string(), false)),
        Event::DisplayMath(latex) => Some((latex.into_string(), true)),
        _ => None,
    })
}

/// The options that mdBook uses.
fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// Code and formulas of a page, by place.
fn pieces(page: &Page) -> Result<Vec<(Range<usize>, Piece)>, BookError> {
    let mut pieces = Vec::new();
    let mut heading_without_id = false;
    for (event, range) in Parser::new_ext(&page.text, options()).into_offset_iter() {
        let formula = |latex: String, display| Piece::Formula { latex, display };
        match event {
            Event::Start(Tag::Heading { id, .. }) => {
                heading_without_id = id.is_none();
                if heading_without_id && page.text[range.clone()].contains("{{") {
                    return Err(markup(page, range.start, HEADING));
                }
            }
            Event::End(TagEnd::Heading(_)) => heading_without_id = false,
            Event::InlineMath(_) | Event::DisplayMath(_) if heading_without_id => {
                return Err(markup(page, range.start, HEADING));
            }
            Event::Start(Tag::CodeBlock(_)) | Event::Code(_) => pieces.push((range, Piece::Code)),
            Event::InlineMath(latex) => pieces.push((range, formula(latex.into_string(), false))),
            Event::DisplayMath(latex) => pieces.push((range, formula(latex.into_string(), true))),
            _ => {}
        }
    }
    Ok(pieces)
}

const HEADING: &str =
    "a heading with a formula or a placeholder needs an id of its own: `## … {#id}`";

/// Fills the placeholders in a stretch without code and formulas.
fn fill(
    page: &Page,
    range: Range<usize>,
    filler: &Filler<'_>,
    out: &mut String,
) -> Result<(), BookError> {
    let text = &page.text[range.clone()];
    let mut done = 0;
    while let Some(start) = text[done..].find("{{").map(|i| done + i) {
        let place = range.start + start;
        plain(page, range.start + done, &text[done..start], out)?;
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let length = text[start..line_end].find("}}").map(|i| i + 2);
        let Some(length) = length else {
            return Err(markup(page, place, "`{{` without `}}` on the same line"));
        };
        let placeholder = &text[start..start + length];
        done = start + length;
        let inside = &placeholder[2..length - 2];
        let filled = filler
            .fill(page.stem, inside)
            .map_err(|fault| at(page, place, placeholder, fault))?;
        match filled {
            Filled::Inline(html) => out.push_str(&for_markdown(&html)),
            Filled::Block(html) if alone(&page.text, place..place + length) => {
                out.push_str(&format!("\n{html}\n"));
            }
            Filled::Block(_) => {
                let fault = Fault::Placeholder("must stand alone on its line".into());
                return Err(at(page, place, placeholder, fault));
            }
        }
    }
    plain(page, range.start + done, &text[done..], out)
}

/// Passes text on in which nothing may be left to fill or to set.
fn plain(page: &Page, place: usize, text: &str, out: &mut String) -> Result<(), BookError> {
    if let Some(i) = text.find('$') {
        return Err(markup(
            page,
            place + i,
            "a `$` that is not part of a formula",
        ));
    }
    if let Some(i) = text.find("}}") {
        return Err(markup(page, place + i, "`}}` without `{{`"));
    }
    out.push_str(text);
    Ok(())
}

/// True if nothing else stands on the line.
fn alone(source: &str, range: Range<usize>) -> bool {
    let starts = source[..range.start].ends_with('\n') || range.start == 0;
    let rest = source[range.end..].lines().next().unwrap_or("");
    starts && rest.trim().is_empty()
}

fn line_of(page: &Page, offset: usize) -> usize {
    page.text[..offset].matches('\n').count() + 1
}

fn markup(page: &Page, offset: usize, reason: &str) -> BookError {
    BookError::Markup {
        page: page.file(),
        line: line_of(page, offset),
        reason: reason.to_owned(),
    }
}

fn at(page: &Page, offset: usize, placeholder: &str, fault: Fault) -> BookError {
    let line = line_of(page, offset);
    match fault {
        Fault::Placeholder(reason) => BookError::Placeholder {
            page: page.file(),
            line,
            placeholder: placeholder.to_owned(),
            reason,
        },
        Fault::Formula { formula, reason } => BookError::Formula {
            page: page.file(),
            line,
            formula,
            reason,
        },
    }
}
