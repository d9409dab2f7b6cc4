//! From a page as written to one for mdBook, with marks for placeholders and formulas.

use super::error::{BookError, Fault};
use super::maths::Maths;
use crate::publishing::Page;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;

enum Piece {
    Code,
    Formula { latex: String, display: bool },
}

pub(super) struct Blank {
    pub page: usize,
    pub offset: usize,
    /// Without its braces.
    pub inside: String,
    /// Nothing else stands on its line.
    pub alone: bool,
}

impl Blank {
    pub(super) fn error(&self, pages: &[Page], fault: Fault) -> BookError {
        let placeholder = format!("{{{{{}}}}}", self.inside);
        at(&pages[self.page], self.offset, &placeholder, fault)
    }
}

pub(super) const MARK: (&str, &str) = ("<span data-blank=\"", "\"></span>");

/// A line with nothing but a placeholder is a paragraph of its own.
pub(super) fn expand(
    (number, page): (usize, &Page),
    maths: &Maths,
    blanks: &mut Vec<Blank>,
) -> Result<String, BookError> {
    let source: &str = &page.text;
    let mut out = String::with_capacity(source.len() * 4);
    let mut done = 0;
    let mut mark = |range: Range<usize>, out: &mut String| {
        for part in parts(page, range)? {
            match part {
                Part::Text(text) => out.push_str(text),
                Part::Placeholder(range) => {
                    let alone = alone(source, range.clone());
                    let gap = if alone { "\n\n" } else { "" };
                    let mark = format!("{gap}{}{}{}{gap}", MARK.0, blanks.len(), MARK.1);
                    *out += &mark;
                    blanks.push(Blank {
                        page: number,
                        offset: range.start,
                        inside: source[range.start + 2..range.end - 2].to_owned(),
                        alone,
                    });
                }
            }
        }
        Ok::<_, BookError>(())
    };
    for (range, piece) in pieces(page)? {
        mark(done..range.start, &mut out)?;
        done = range.end;
        match piece {
            Piece::Code => out.push_str(&source[range]),
            Piece::Formula { latex, display } => {
                let html = if display {
                    maths.display(&latex)
                } else {
                    maths.inline(&latex)
                };
                out += &html.map_err(|fault| at(page, range.start, &latex, fault))?;
            }
        }
    }
    mark(done..source.len(), &mut out)?;
    Ok(out)
}

pub(crate) fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

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
            // In a placeholder it is a choice.
            Event::InlineMath(_) if in_braces(&page.text[..range.start]) => {}
            Event::InlineMath(latex) => pieces.push((range, formula(latex.into_string(), false))),
            Event::DisplayMath(latex) => pieces.push((range, formula(latex.into_string(), true))),
            _ => {}
        }
    }
    Ok(pieces)
}

fn in_braces(before: &str) -> bool {
    before.rfind("{{") > before.rfind("}}").max(before.rfind('\n'))
}

const HEADING: &str =
    "a heading with a formula or a placeholder needs an id of its own: `## … {#id}`";

enum Part<'a> {
    Text(&'a str),
    /// With its braces, by its place in the page.
    Placeholder(Range<usize>),
}

fn parts(page: &Page, range: Range<usize>) -> Result<Vec<Part<'_>>, BookError> {
    let text = &page.text[range.clone()];
    let mut parts = Vec::new();
    let mut done = 0;
    while let Some(start) = text[done..].find("{{").map(|i| done + i) {
        parts.push(plain(page, range.start + done, &text[done..start])?);
        let line = text[start..].lines().next().unwrap_or("");
        let Some(length) = line.find("}}").map(|i| i + 2) else {
            let reason = "`{{` without `}}` on the same line";
            return Err(markup(page, range.start + start, reason));
        };
        done = start + length;
        parts.push(Part::Placeholder(range.start + start..range.start + done));
    }
    parts.push(plain(page, range.start + done, &text[done..])?);
    Ok(parts)
}

fn plain<'a>(page: &Page, place: usize, text: &'a str) -> Result<Part<'a>, BookError> {
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
    Ok(Part::Text(text))
}

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
