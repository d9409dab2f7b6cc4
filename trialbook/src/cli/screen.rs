//! What is known of the screen: its size, whether it has colours, whether anything but the answer is wanted.

use crate::ledger::Verdict;
use clap::ValueEnum;
use console::{Style, Term, measure_text_width};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::env;
use std::sync::OnceLock;

/// When colours are used.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Color {
    /// On a terminal, unless `NO_COLOR` is set
    #[default]
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// How the answer is shown.
#[derive(Debug, Clone, Copy)]
pub struct Screen {
    /// Columns, where they are known: `COLUMNS`, or those of the terminal.
    pub width: Option<usize>,
    /// Rows of the terminal, where there is one.
    pub rows: Option<usize>,
    /// Whether there are colours.
    pub color: bool,
    /// Whether only the answer is wanted, in short.
    pub quiet: bool,
}

static SCREEN: OnceLock<Screen> = OnceLock::new();

/// Fewer columns than these are taken as these.
const NARROWEST: usize = 40;

/// Rows and columns of a terminal, where this is one.
fn size(term: &Term) -> Option<[usize; 2]> {
    let size = term.is_term().then(|| term.size_checked()).flatten();
    size.map(|(rows, columns)| [rows.into(), columns.into()])
}

/// Columns, where they are known: `COLUMNS`, or those of the terminal.
pub(super) fn columns() -> Option<usize> {
    let named = env::var("COLUMNS").ok().and_then(|text| text.parse().ok());
    let columns = named.or_else(|| size(&Term::stdout()).map(|[_, columns]| columns));
    columns.map(|columns: usize| columns.max(NARROWEST))
}

/// The screen of this process.
pub fn screen() -> Screen {
    *SCREEN.get_or_init(|| Screen::found(Color::Auto, false))
}

/// Settles how answers are shown; what was settled first stays.
pub(super) fn settle(color: Color, quiet: bool) {
    SCREEN.get_or_init(|| Screen::found(color, quiet));
}

impl Screen {
    fn found(color: Color, quiet: bool) -> Self {
        let term = Term::stdout();
        let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
        let dumb = env::var_os("TERM").is_some_and(|term| term == "dumb");
        Self {
            width: columns(),
            rows: size(&term).map(|[rows, _]| rows),
            color: match color {
                Color::Auto => term.is_term() && !set("NO_COLOR") && !dumb,
                Color::Always => true,
                Color::Never => false,
            },
            quiet,
        }
    }

    /// Words in the colour of what is right or of what is wrong.
    pub(super) fn grade(&self, right: bool, words: &str) -> String {
        let style = Style::new().force_styling(self.color);
        let style = if right { style.green() } else { style.red() };
        style.apply_to(words).to_string()
    }

    /// The words of a verdict, in its colour.
    pub(super) fn paint(&self, verdict: Verdict, words: &str) -> String {
        let style = Style::new().force_styling(self.color);
        let style = match verdict {
            Verdict::Confirmed | Verdict::Degenerate => style.green(),
            Verdict::Conditional | Verdict::Undecided => style.yellow(),
            Verdict::Definition => style.dim(),
            _ => style.red(),
        };
        style.apply_to(words).to_string()
    }
}

/// A bar of progress by its template; it shows on a terminal only, and not where quiet is wanted.
pub fn progress(length: u64, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template);
    let bar =
        ProgressBar::new(length).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    if screen().quiet {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    bar
}

/// Text in which no line is wider than `width`, where a space allows it: what is broken goes on below its own beginning.
pub(super) fn wrapped(text: &str, width: usize) -> String {
    let mut out = String::new();
    for line in text.lines() {
        let words = line.trim_start();
        let indent = &line[..line.len() - words.len()];
        let mut current = indent.to_owned();
        for (n, word) in words.split(' ').enumerate() {
            let wide = measure_text_width(&current) + 1 + measure_text_width(word) > width;
            if n > 0 && wide && !word.is_empty() {
                out += current.trim_end_matches(' ');
                out.push('\n');
                indent.clone_into(&mut current);
            } else if n > 0 {
                current.push(' ');
            }
            current += word;
        }
        out += &current;
        out.push('\n');
    }
    out
}

/// A text of at most `width` characters, cut with an ellipsis.
pub(super) fn cut(text: &str, width: usize) -> String {
    match measure_text_width(text) <= width {
        true => text.to_owned(),
        false => console::truncate_str(text, width, "…").into_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_at_spaces_below_their_beginning() {
        let text = "one two three\n  four five six\nseven\n\na  b";
        assert_eq!(
            wrapped(text, 10),
            "one two\nthree\n  four\n  five six\nseven\n\na  b\n"
        );
        assert_eq!(wrapped(text, 80), format!("{text}\n"));
        assert_eq!(wrapped("abcdefghij", 4), "abcdefghij\n");
        assert_eq!(
            (cut("λ₀ < 1", 4), cut("λ₀ < 1", 6)),
            ("λ₀ …".into(), "λ₀ < 1".into())
        );
    }

    #[test]
    fn what_is_painted_has_the_same_width() {
        let screen = |color| Screen {
            width: None,
            rows: None,
            color,
            quiet: false,
        };
        let painted = screen(true).paint(Verdict::Misprint, "misprint");
        assert!(painted.contains("\u{1b}[31m") && measure_text_width(&painted) == 8);
        assert_eq!(
            screen(false).paint(Verdict::Misprint, "misprint"),
            "misprint"
        );
    }
}
