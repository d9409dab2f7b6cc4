//! The errata as a letter that can be sent: plain text, LaTeX, or data as JSON.

use super::errata::{ErrataError, Erratum};
use super::pieces::{Piece, decimal, pieces};
use super::plain::{self, plain_words};
use super::{Ledger, Verdict};
use crate::claims::Paper;

/// A form of the letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Plain text.
    Text,
    /// A LaTeX document.
    Latex,
    /// A list of objects, with the fields of [`Erratum`].
    Json,
}

impl Ledger {
    /// The errata as a letter to the journal, or as JSON.
    ///
    /// # Errors
    /// As [`Ledger::errata`].
    pub fn letter(&self, format: Format) -> Result<String, ErrataError> {
        let errata = self.errata()?;
        Ok(match format {
            Format::Json => serde_json::to_string_pretty(&errata)? + "\n",
            Format::Text => self.write(&errata, &Plain),
            Format::Latex => self.write(&errata, &Latex),
        })
    }

    fn write(&self, errata: &[Erratum], style: &dyn Style) -> String {
        let of = |verdicts: &[Verdict]| {
            let chosen = errata.iter().filter(|e| verdicts.contains(&e.verdict));
            chosen.collect::<Vec<_>>()
        };
        let wrong = of(&[Verdict::Misprint, Verdict::Refuted]);
        let short = of(&[Verdict::Conditional]);
        let mut text = style.opening(self.paper);
        text += &style.paragraph(&format!(
            "All {} numbered equations and statements of the paper were tried by program: {}. {} do not \
             stand as printed, {} more hold only under a condition that the paper does not state; of the other {} \
             none failed. In this letter every number is computed.",
            self.entries.len(),
            self.paper.tried,
            wrong.len(),
            short.len(),
            self.entries.len() - errata.len()
        ));
        for (title, errata) in [("Corrections", wrong), ("Conditions to be stated", short)] {
            text += &style.heading(title);
            for erratum in errata {
                text += &style.item(&self.name(erratum.id), erratum);
                if !erratum.fallen.is_empty() {
                    let names: Vec<_> = erratum.fallen.iter().map(|id| self.name(id)).collect();
                    text += &style.entry("Falls with it", &names.join(", "));
                }
                text.push('\n');
            }
        }
        text + style.closing()
    }
}

/// How the letter is set.
trait Style {
    fn opening(&self, paper: &Paper) -> String;
    fn heading(&self, title: &str) -> String;
    fn paragraph(&self, words: &str) -> String;
    fn title(&self, name: &str, erratum: &Erratum) -> String;
    fn entry(&self, label: &str, words: &str) -> String;
    fn closing(&self) -> &'static str;

    fn item(&self, name: &str, erratum: &Erratum) -> String {
        let mut text = self.title(name, erratum);
        text += &self.entry("Printed", &erratum.old);
        text += &self.entry("Should be", &erratum.new);
        text += &self.entry("Reason", &erratum.reason);
        if let Some(case) = &erratum.case {
            text += &self.entry("A case by hand", case);
        }
        for said in &erratum.evidence {
            text += &self.entry("Trial", said);
        }
        text
    }
}

/// Plain text, 78 characters a line.
struct Plain;

impl Style for Plain {
    fn opening(&self, paper: &Paper) -> String {
        let Paper { title, authors, .. } = paper;
        format!("Comment on \"{title}\"\nby {authors}\n\n")
    }
    fn heading(&self, title: &str) -> String {
        format!("{}\n{}\n\n", title.to_uppercase(), "=".repeat(title.len()))
    }
    fn paragraph(&self, words: &str) -> String {
        wrapped(words, 0) + "\n"
    }
    fn title(&self, name: &str, erratum: &Erratum) -> String {
        let (verdict, section) = (erratum.verdict.words(), erratum.section);
        let name = plain_words(name);
        let title = plain_words(erratum.title);
        let about = if name == title {
            String::new()
        } else {
            format!(", {title}")
        };
        wrapped(&format!("Section {section}: {name}{about}: {verdict}"), 0)
    }
    fn entry(&self, label: &str, words: &str) -> String {
        let text = wrapped(&format!("{label}: {}", plain_words(words)), 4);
        // The last entry of an item leaves the blank line to the next title.
        if label == "Printed" {
            format!("\n{text}")
        } else {
            text
        }
    }
    fn closing(&self) -> &'static str {
        ""
    }
}

/// Lines of at most 78 characters, each after `indent` blanks.
fn wrapped(words: &str, indent: usize) -> String {
    let mut text = String::new();
    let mut line = " ".repeat(indent);
    for word in words.split_whitespace() {
        if !line.trim().is_empty() && line.chars().count() + word.chars().count() >= 78 {
            text += line.trim_end();
            text.push('\n');
            line = " ".repeat(indent + 2 * usize::from(indent > 0));
        }
        line += word;
        line.push(' ');
    }
    text + line.trim_end() + "\n"
}

/// A LaTeX document.
struct Latex;

impl Style for Latex {
    fn opening(&self, paper: &Paper) -> String {
        let Paper { title, authors, .. } = paper;
        format!(
            "\\documentclass[11pt]{{article}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage{{amsmath,amssymb,bm}}\n\
             \\usepackage[margin=25mm]{{geometry}}\n\n\
             \\title{{Comment on ``{title}'' by {authors}}}\n\\date{{}}\n\n\\begin{{document}}\n\\maketitle\n\n"
        )
    }
    fn heading(&self, title: &str) -> String {
        format!("\\section*{{{title}}}\n\n")
    }
    fn paragraph(&self, words: &str) -> String {
        format!("{}\n\n", tex_words(words))
    }
    fn title(&self, name: &str, erratum: &Erratum) -> String {
        let about = if name == erratum.title {
            String::new()
        } else {
            format!(", {}", tex_words(erratum.title))
        };
        format!(
            "\\paragraph{{Section {}: {}{about}: {}.}}\n\n",
            erratum.section,
            tex_words(name),
            erratum.verdict.words()
        )
    }
    fn entry(&self, label: &str, words: &str) -> String {
        // A formula alone may be too wide for a line with its label.
        let alone = words
            .strip_prefix('$')
            .and_then(|rest| rest.strip_suffix('$'));
        match alone.filter(|formula| !formula.contains('$')) {
            Some(formula) => format!("\\emph{{{label}:}}\n\\[{formula}\\]\n\n"),
            None => format!("\\emph{{{label}:}} {}\n\n", tex_words(words)),
        }
    }
    fn closing(&self) -> &'static str {
        "\\end{document}\n"
    }
}

/// Words with formulas in `$…$`, for LaTeX: what stands outside the formulas becomes formulas where it must.
fn tex_words(words: &str) -> String {
    let parts = words.split('$').enumerate().map(|(i, part)| match i % 2 {
        0 => tex_plain(part),
        _ => format!("${part}$"),
    });
    // Neighbours join into one formula.
    parts.collect::<String>().replace("$$", " ")
}

/// Words without formulas, for LaTeX.
fn tex_plain(words: &str) -> String {
    let mut out = String::new();
    for piece in pieces(words) {
        match piece {
            Piece::Text(text) => out.extend(text.chars().map(tex_char)),
            Piece::Index(index) => out += &format!("$_{{{}}}$", tex_inside(&index.to_string())),
            Piece::Power(power) => out += &format!("$^{{{}}}$", tex_inside(power)),
            Piece::Minus => out += "$-$",
            Piece::Equals => {
                out.pop();
                out += "~=~";
            }
            Piece::Scientific(number) => {
                let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
                out += &decimal(number).unwrap_or_else(|| match mantissa {
                    "1" => format!("$10^{{{exponent}}}$"),
                    _ => format!("${mantissa}\\times10^{{{exponent}}}$"),
                });
            }
        }
    }
    out
}

/// Words as a part of a formula: their own parts are no formulas for themselves.
fn tex_inside(words: &str) -> String {
    tex_plain(words).replace('$', " ")
}

fn tex_char(c: char) -> String {
    match c {
        '&' | '%' | '#' | '_' | '{' | '}' => format!("\\{c}"),
        '^' => "\\^{}".into(),
        '~' => "\\~{}".into(),
        '\\' => "$\\backslash$".into(),
        '<' | '>' | '|' => format!("${c}$"),
        c if c.is_ascii() => c.into(),
        c => plain::command(c).map_or_else(|| c.into(), |command| format!("${command}$")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_become_tex() {
        assert_eq!(
            tex_words("λ₀ < 1 & $x_1$: 50 %"),
            r"$\lambda _0$ $<$ 1 \& $x_1$: 50 \%"
        );
        assert_eq!(tex_words("√2 − 𝔴"), r"$\surd$2 $-$ $\mathfrak w$");
        assert_eq!(
            tex_words("𝔴_y, v_x to 2.3e4 of 1e-8, 2.3e2"),
            r"$\mathfrak w _{y}$, v$_{x}$ to $2.3\times10^{4}$ of $10^{-8}$, 230"
        );
        assert_eq!(tex_words("A/τ^(3/2) = -5"), r"A/$\tau ^{3/2}$~=~$-$5");
    }

    #[test]
    fn lines_are_short() {
        let text = wrapped(&"word ".repeat(100), 4);
        assert!(
            text.lines()
                .all(|line| line.chars().count() <= 78 && line.starts_with("    "))
        );
    }
}
