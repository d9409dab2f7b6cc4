//! The errata as a letter that can be sent: plain text, LaTeX, or data as JSON.

use super::errata::{ErrataError, Erratum};
use super::pieces::{Piece, decimal, pieces};
use super::{Ledger, Verdict, counted};
use crate::claims::{Paper, Sort};
use crate::plain::{self, plain_words};
use std::collections::BTreeSet;

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
    /// The errata as a short comment on the paper, as one sends it to a journal, or as JSON: an item for each error that
    /// rests on no other, with what inherits it, a list of misprints and a paragraph of conditions.
    ///
    /// # Errors
    /// As [`Ledger::errata`].
    pub fn letter(&self, format: Format) -> Result<String, ErrataError> {
        let errata = self.errata()?;
        Ok(match format {
            Format::Json => serde_json::to_string_pretty(&errata)? + "\n",
            Format::Text => self.comment(&errata, &Plain),
            Format::Latex => self.comment(&errata, &Latex),
        })
    }

    /// What stands behind the comment: every claim that has to be changed, with all its trials. JSON as the letter's.
    ///
    /// # Errors
    /// As [`Ledger::errata`].
    pub fn supplement(&self, format: Format) -> Result<String, ErrataError> {
        match format {
            Format::Json => self.letter(format),
            Format::Text => Ok(self.trials(&self.errata()?, &Plain)),
            Format::Latex => Ok(self.trials(&self.errata()?, &Latex)),
        }
    }

    fn comment(&self, errata: &[Erratum], style: &dyn Style) -> String {
        let wrong = of(errata, &WRONG);
        let (misprints, wrong): (Vec<&Erratum>, Vec<&Erratum>) = wrong
            .into_iter()
            .partition(|e| e.verdict == Verdict::Misprint);
        let (roots, heirs): (Vec<&Erratum>, Vec<&Erratum>) =
            wrong.into_iter().partition(|e| e.inherits.is_empty());
        let mut text = style.opening(self.paper, COMMENT);
        text += &style.sender();
        let conditional = of(errata, &[Verdict::Conditional]);
        text += &style.paragraph(&format!(
            "All {} numbered equations and statements of the paper were tried {}. We found {}, {} that inherit them, and {}; \
             {} a condition. {} Statements that are not formulas are given in our words. The trials, the proofs and the program that makes them \
             are in the supplement and at [link to the code].",
            self.entries.len(),
            self.paper.tried,
            counted(roots.len(), "independent error"),
            counted(heirs.len(), "further statement"),
            counted(misprints.len(), "misprint"),
            match conditional.len() {
                1 => "1 statement needs".to_owned(),
                n => format!("{n} statements need"),
            },
            self.rest()
        ));
        // What has been told under an earlier error is only named.
        let mut told = BTreeSet::new();
        text += &style.heading("Corrections");
        for (i, root) in roots.iter().enumerate() {
            let heirs: Vec<_> = heirs
                .iter()
                .filter(|e| root.fallen.contains(&e.id))
                .collect();
            text += &style.numbered(i + 1, &self.name(root.id), root);
            text += &style.wrong(root);
            text += &style.entry(as_printed(root), &root.old);
            text += &style.entry("Right", &root.new);
            for reading in self.readings(root.id) {
                text += &style.entry("Our reading", &closed(reading));
            }
            for (label, words) in [
                ("Reason", Some(&root.reason)),
                ("By hand", root.case.as_ref()),
            ] {
                if let Some(words) = words.filter(|words| !words.is_empty()) {
                    text += &style.entry(label, &closed(words));
                }
            }
            if !heirs.is_empty() {
                let (new, known): (Vec<&&&Erratum>, Vec<_>) =
                    heirs.iter().partition(|e| told.insert(e.id));
                let right = new
                    .iter()
                    .map(|e| format!("{}: {}{}", self.name(e.id), e.new, self.note(e.id)));
                let known: Vec<_> = known.iter().map(|e| self.name(e.id)).collect();
                let known = (!known.is_empty()).then(|| format!("{}, as above", known.join(", ")));
                let right: Vec<_> = right.chain(known).collect();
                text += &style.entry("Also to be changed", &right.join("; "));
            }
            text.push('\n');
        }
        if !misprints.is_empty() {
            text += &style.heading("Misprints");
            for misprint in misprints {
                let (old, new) = (&misprint.old, &misprint.new);
                let words = match is_formula(old) && is_formula(new) {
                    true => format!("{old} should be {new}."),
                    false => format!(
                        "{}: {} It should be: {}",
                        as_printed(misprint),
                        closed(old),
                        closed(new)
                    ),
                };
                let words = words + &self.note(misprint.id);
                text += &style.entry(&self.place(misprint), &words);
            }
            text.push('\n');
        }
        if !conditional.is_empty() {
            text += &style.heading("Conditions");
            text += &style.paragraph(&self.conditions(errata));
        }
        text + style.closing()
    }

    /// What is to be said of all that needs no change.
    fn rest(&self) -> String {
        let counts = self.counts();
        let but = match counts[&Verdict::Degenerate] {
            0 => "",
            _ => ", some but for points at which they have no value, or which fill no interval",
        };
        format!("{}All others are right as printed{but}.", self.undecided())
    }

    /// Which statements are undecided, and why: a sentence or two for each, none where there are none.
    fn undecided(&self) -> String {
        let open = self.entries.iter();
        let open = open.filter(|entry| entry.judgement.verdict == Verdict::Undecided);
        open.map(|entry| {
            format!(
                "A statement of section {} is undecided, that {} {} ",
                entry.claim.section,
                closed(&begun_small(entry.claim.latex)),
                closed(entry.claim.unproved.unwrap_or(&entry.judgement.ground))
            )
        })
        .collect()
    }

    /// How a claim is read where its words can be read in more than one way.
    fn readings(&self, id: &str) -> impl Iterator<Item = &'static str> {
        let conditions = self
            .entry(id)
            .map_or(&[][..], |entry| entry.claim.conditions);
        let readings = conditions.iter().filter(|c| c.sort == Sort::Reading);
        readings.map(|c| c.text)
    }

    /// The same in brackets, behind what is said of the claim.
    fn note(&self, id: &str) -> String {
        let readings = self.readings(id);
        readings
            .map(|reading| format!(" (Our reading: {reading}.)"))
            .collect()
    }

    /// The name of a claim, behind its section where it has no number, and without what explains it behind a colon.
    fn place(&self, erratum: &Erratum) -> String {
        let name = self.name(erratum.id);
        let name = name.split(':').next().unwrap_or_default();
        match erratum.equation {
            Some(_) => name.to_owned(),
            None => format!("Section {}, {name}", erratum.section),
        }
    }

    /// The missing conditions, each with the claims that need it.
    fn conditions(&self, errata: &[Erratum]) -> String {
        let mut needed: Vec<(&str, Vec<String>)> = Vec::new();
        for erratum in of(errata, &[Verdict::Conditional]) {
            let Some(entry) = self.entry(erratum.id) else {
                continue;
            };
            for condition in entry
                .claim
                .conditions
                .iter()
                .filter(|c| c.sort == Sort::Substance)
            {
                let name = self.place(erratum) + &self.note(erratum.id);
                match needed.iter_mut().find(|(text, _)| *text == condition.text) {
                    Some((_, names)) => names.push(name),
                    None => needed.push((condition.text, vec![name])),
                }
            }
        }
        let together = needed.chunk_by(|(_, names), (_, next)| names == next);
        let clauses = together.map(|conditions| {
            let texts: Vec<_> = conditions.iter().map(|(text, _)| *text).collect();
            format!(
                "{}: holds if {}",
                conditions[0].1.join(", "),
                texts.join("; and ")
            )
        });
        clauses.collect::<Vec<_>>().join(". ") + "."
    }

    fn trials(&self, errata: &[Erratum], style: &dyn Style) -> String {
        let mut text = style.opening(self.paper, "Supplement to a comment on");
        for (title, verdicts) in [
            ("Corrections", &WRONG[..]),
            ("Conditions to be stated", &[Verdict::Conditional]),
        ] {
            text += &style.heading(title);
            for erratum in of(errata, verdicts) {
                text += &style.item(&self.name(erratum.id), erratum);
                if !erratum.fallen.is_empty() && erratum.verdict != Verdict::Conditional {
                    let names: Vec<_> = erratum.fallen.iter().map(|id| self.name(id)).collect();
                    text += &style.entry("Inherited by", &names.join(", "));
                }
                text.push('\n');
            }
        }
        text + style.closing()
    }
}

const WRONG: [Verdict; 4] = [
    Verdict::Misprint,
    Verdict::Misderived,
    Verdict::Inherited,
    Verdict::Refuted,
];

fn of<'a>(errata: &'a [Erratum], verdicts: &[Verdict]) -> Vec<&'a Erratum> {
    let chosen = errata.iter().filter(|e| verdicts.contains(&e.verdict));
    chosen.collect()
}

/// A displayed formula that is too wide for its column is made smaller.
const FIT: &str = r"\newcommand{\fit}[1]{\sbox0{$\displaystyle #1$}\ifdim\wd0>\columnwidth\resizebox{\columnwidth}{!}{\usebox0}\else\usebox0\fi}";

/// The parts of an item that stand in one paragraph, in LaTeX.
const RUN_IN: [&str; 7] = [
    "Printed",
    "Said",
    "Right",
    "Reason",
    "By hand",
    "Our reading",
    "Also to be changed",
];

/// How the title of the letter begins.
const COMMENT: &str = "Comment on";

/// How the letter is set.
trait Style {
    fn opening(&self, paper: &Paper, what: &str) -> String;
    fn sender(&self) -> String;
    fn numbered(&self, number: usize, name: &str, erratum: &Erratum) -> String;
    fn heading(&self, title: &str) -> String;
    fn paragraph(&self, words: &str) -> String;
    fn title(&self, name: &str, erratum: &Erratum) -> String;
    fn entry(&self, label: &str, words: &str) -> String;
    fn closing(&self) -> &'static str;

    /// `Misprint: the sign of the second term.`
    fn wrong(&self, erratum: &Erratum) -> String {
        let parts = erratum.wrong.split_once(": ");
        parts.map_or_else(String::new, |(label, words)| self.entry(label, words))
    }

    fn item(&self, name: &str, erratum: &Erratum) -> String {
        let mut text = self.title(name, erratum) + &self.wrong(erratum);
        text += &self.entry(as_printed(erratum), &erratum.old);
        text += &self.entry("Should be", &erratum.new);
        if !erratum.reason.is_empty() {
            text += &self.entry("Reason", &closed(&erratum.reason));
        }
        if let Some(case) = &erratum.case {
            text += &self.entry("A case by hand", &closed(case));
        }
        for said in &erratum.evidence {
            text += &self.entry("Trial", said);
        }
        text
    }
}

/// A sentence that goes on in the middle of another.
fn begun_small(sentence: &str) -> String {
    let mut letters = sentence.chars();
    let first = letters.next().map(|c| c.to_ascii_lowercase());
    first.into_iter().chain(letters).collect()
}

/// Sentences with the full stop at their end.
fn closed(words: &str) -> String {
    format!("{}.", words.trim_end_matches('.'))
}

/// What stands before a statement: a formula is printed, and what the paper says in words is given in ours.
fn as_printed(erratum: &Erratum) -> &'static str {
    match erratum.equation {
        Some(_) => "Printed",
        None => "Said",
    }
}

/// True for a formula alone.
fn is_formula(text: &str) -> bool {
    text.starts_with('$') && text.ends_with('$') && text.matches('$').count() == 2
}

/// What a claim is about, behind its name; nothing where that says it already.
fn about(name: &str, erratum: &Erratum) -> String {
    match name == erratum.title {
        true => String::new(),
        false => format!(", {}", erratum.title),
    }
}

/// Plain text, 78 characters a line.
struct Plain;

impl Style for Plain {
    fn opening(&self, paper: &Paper, what: &str) -> String {
        let Paper {
            title,
            authors,
            reference,
            ..
        } = paper;
        format!("{what} \"{title}\"\nby {authors}, {reference}\n\n")
    }
    fn sender(&self) -> String {
        "[name, affiliation and address of the sender]\n\n".into()
    }
    fn numbered(&self, number: usize, name: &str, erratum: &Erratum) -> String {
        let (name, about) = (plain_words(name), plain_words(&about(name, erratum)));
        wrapped(
            &format!("{number}. Section {}: {name}{about}", erratum.section),
            0,
        )
    }
    fn heading(&self, title: &str) -> String {
        format!("{}\n{}\n\n", title.to_uppercase(), "=".repeat(title.len()))
    }
    fn paragraph(&self, words: &str) -> String {
        wrapped(&plain_words(words), 0) + "\n"
    }
    fn title(&self, name: &str, erratum: &Erratum) -> String {
        let (verdict, section) = (erratum.verdict.words(), erratum.section);
        let (name, about) = (plain_words(name), plain_words(&about(name, erratum)));
        wrapped(&format!("Section {section}: {name}{about}: {verdict}"), 0)
    }
    fn entry(&self, label: &str, words: &str) -> String {
        let text = wrapped(&format!("{label}: {}", plain_words(words)), 4);
        // The last entry of an item leaves the blank line to the next title.
        if ["Printed", "Said"].contains(&label) {
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
    fn opening(&self, paper: &Paper, what: &str) -> String {
        let Paper {
            title,
            authors,
            reference,
            ..
        } = paper;
        // The comment is two pages of a journal, the supplement a report.
        let (columns, size) = match what {
            COMMENT => (",twocolumn", r"\small"),
            _ => ("", ""),
        };
        format!(
            "\\documentclass[10pt{columns}]{{article}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage{{amsmath,amssymb,bm,graphicx}}\n\
             \\usepackage[margin=14mm]{{geometry}}\n{FIT}\n\n\
             \\title{{{what} ``{title}''\\\\\\large by {authors}, {reference}}}\n\\author{{[name]\\\\{{}}[affiliation and \
             address]}}\n\\date{{}}\n\n\\begin{{document}}{size}\n\\maketitle\n\n"
        )
    }
    fn sender(&self) -> String {
        // It stands in the title.
        String::new()
    }
    fn numbered(&self, number: usize, name: &str, erratum: &Erratum) -> String {
        format!(
            "\\paragraph{{{number}. Section {}: {}{}.}}\n\n",
            erratum.section,
            tex_words(name),
            tex_words(&about(name, erratum))
        )
    }
    fn heading(&self, title: &str) -> String {
        format!("\\subsection*{{{title}}}\n\n")
    }
    fn paragraph(&self, words: &str) -> String {
        format!("{}\n\n", tex_words(words))
    }
    fn title(&self, name: &str, erratum: &Erratum) -> String {
        format!(
            "\\paragraph{{Section {}: {}{}: {}.}}\n\n",
            erratum.section,
            tex_words(name),
            tex_words(&about(name, erratum)),
            erratum.verdict.words()
        )
    }
    fn entry(&self, label: &str, words: &str) -> String {
        // The parts of an item are one paragraph.
        let end = if RUN_IN.contains(&label) { "" } else { "\n" };
        // A formula alone may be too wide for a line with its label.
        let alone = words
            .strip_prefix('$')
            .and_then(|rest| rest.strip_suffix('$'));
        match alone.filter(|formula| !formula.contains('$')) {
            Some(formula) => format!("\\emph{{{label}:}}\n\\[\\fit{{{formula}}}\\]\n{end}"),
            None => format!("\\emph{{{label}:}} {}\n{end}", tex_words(words)),
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
        // Between \left and \right no line can break.
        _ => format!(
            "${}$",
            part.replace(r"\left[", r"\bigl[")
                .replace(r"\right]", r"\bigr]")
        ),
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
            Piece::Formula(latex) => out += &format!("${latex}$"),
            Piece::Minus => out += "$-$",
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

fn tex_char(c: char) -> String {
    match c {
        '&' | '%' | '#' | '_' | '{' | '}' => format!("\\{c}"),
        '^' => "\\^{}".into(),
        '~' => "\\~{}".into(),
        '\\' => "$\\backslash$".into(),
        '“' => "``".into(),
        '”' => "''".into(),
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
            r"$\lambda_{0} < 1$ \& $x_1$: 50 \%"
        );
        assert_eq!(tex_words("√2 − 𝔴"), r"$\sqrt{2} - \mathfrak w$");
        assert_eq!(
            tex_words("𝔴_y, v_x to 2.3e4 of 1e-8, 2.3e2"),
            r"$\mathfrak w_{y}$, $v_{x}$ to $2.3\times10^{4}$ of $10^{-8}$, 230"
        );
        assert_eq!(tex_words("A/τ^(3/2) = -5"), r"$A/\tau^{3/2} = -5$");
        assert_eq!(tex_words(r"so $\left[a+b\right]$"), r"so $\bigl[a+b\bigr]$");
        assert_eq!(tex_words("“so”"), "``so''");
    }

    #[test]
    fn a_letter_counts_and_tells_everything_once() {
        let letter = super::super::example::ledger().letter(Format::Text);
        let letter = letter.unwrap();
        let words = letter.split_whitespace().collect::<Vec<_>>().join(" ");
        for said in [
            "All 8 numbered equations and statements",
            "We found 2 independent errors, 1 further statement that inherit them, and 1 misprint; 1 statement needs a \
             condition.",
            "1. Section 1: (1), an error",
            "Also to be changed: (3): nothing takes its place; see (1), (2) 2. Section 1: (2), another error",
            "Also to be changed: (3), as above",
            "(4): d = 1 should be d = −1.",
            "(5): holds if x > 0.",
        ] {
            assert!(words.contains(said), "{said}\n{letter}");
        }
        assert_eq!(words.matches("Also to be changed").count(), 2, "{letter}");
        // Nobody says why, and there is no condition.
        assert!(
            !words.contains("Reason") && !words.contains("comparisons"),
            "{letter}"
        );
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
