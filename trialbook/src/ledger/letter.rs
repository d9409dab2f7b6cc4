//! The errata as a letter that can be sent: plain text or LaTeX.

use super::errata::{ErrataError, Erratum, statement};
use super::{Ledger, Standing};
use crate::notation::{Piece, command, decimal, pieces, plain_formula, plain_words};
use crate::trials::Paper;

/// A form of the letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Plain text.
    Text,
    Latex,
}

impl Format {
    fn style(self) -> &'static dyn Style {
        match self {
            Format::Text => &Plain,
            Format::Latex => &Latex,
        }
    }

    /// What is sent, with the sender (name, affiliation and address parted by slashes) and the program's
    /// place.
    pub fn signed(self, mut sent: String, from: Option<&str>, code: Option<&str>) -> String {
        let from = from.map(|from| from.replace('/', ", "));
        for (blank, words) in [(SENDER, from.as_deref()), (CODE, code)] {
            let words = words.unwrap_or(blank).chars();
            let words: String = match self {
                Format::Text => words.collect(),
                Format::Latex => words.map(tex_char).collect(),
            };
            sent = sent.replace(blank, &words);
        }
        sent
    }
}

impl Ledger {
    /// The paper's [letter](Paper::letter), with what its placeholders ask for. A paper without one is sent
    /// its errata, without trials.
    ///
    /// In the letter a paragraph is a line, a heading begins with `# `, formulas stand in `$…$`.
    /// `[words](#id)` names a claim to change; `{{right eq-13}}` is what should stand there, numbered, on a
    /// line of its own; `{{stated eq-13}}` and `{{found eq-13}}` are the numbers of its case by hand;
    /// `{{value lambda-c 3}}` is a number of the paper to three decimals; `{{count numbered}}`, `{{count
    /// others}}` and `{{count standing}}` count equations, other statements, and what need not change,
    /// `{{count proved}}` and its kin what is known in that way; `{{refuted}}` is what theorems refute;
    /// `{{reference}}` is where the paper is.
    ///
    /// # Errors
    /// As [`Ledger::errata`], and [`ErrataError::Letter`] if a placeholder asks for what there is not.
    pub fn letter(&self, format: Format) -> Result<String, ErrataError> {
        match &*self.paper.letter {
            "" => Ok(self.list(&self.errata()?, format.style(), COMMENT)),
            _ => self.comment(&self.errata()?, format.style()),
        }
    }

    /// Every claim that has to be changed, with all its trials.
    ///
    /// # Errors
    /// As [`Ledger::errata`].
    pub fn supplement(&self, format: Format) -> Result<String, ErrataError> {
        let what = "Supplement to a comment on";
        Ok(self.list(&self.errata()?, format.style(), what))
    }

    fn comment(&self, errata: &[Erratum], style: &dyn Style) -> Result<String, ErrataError> {
        let mut text = style.opening(self.paper, COMMENT);
        for line in self.paper.letter.lines().filter(|line| !line.is_empty()) {
            let id = line.strip_prefix("{{right ");
            let claim = id.and_then(|id| Some(self.entry(id.strip_suffix("}}")?)?.claim));
            let right = claim.and_then(|claim| Some((claim.equation?, claim.correction?.latex)));
            let next = match (line.strip_prefix("# "), right) {
                (Some(title), _) => style.heading(title),
                (_, Some((number, latex))) => {
                    text.truncate(text.trim_end().len());
                    style.numbered(number, latex)
                }
                _ => style.paragraph(&self.filled(errata, &unlinked(line))?),
            };
            text += &next;
        }
        Ok(text + style.closing(COMMENT))
    }

    fn filled(&self, errata: &[Erratum], line: &str) -> Result<String, ErrataError> {
        let mut parts = line.split("{{");
        let mut out = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let endless = || fault(format!("a placeholder without an end: {part}"));
            let (asked, after) = part.split_once("}}").ok_or_else(endless)?;
            out += &self.asked(errata, asked)?;
            out += after;
        }
        Ok(out)
    }

    fn asked(&self, errata: &[Erratum], asked: &str) -> Result<String, ErrataError> {
        let none = || fault(format!("nothing is known of \"{asked}\""));
        let words: Vec<_> = asked.split(' ').collect();
        let all = self.entries.len();
        let numbered = self.entries.iter().filter(|e| e.claim.equation.is_some());
        let numbered = numbered.count();
        match words[..] {
            ["reference"] => Ok(self.paper.reference.to_owned()),
            ["count", "numbered"] => Ok(numbered.to_string()),
            ["count", "others"] => Ok((all - numbered).to_string()),
            ["count", by @ ("proved" | "argued" | "measured")] => {
                let mut all = Standing::ALL.into_iter();
                let by = all.find(|of| of.word() == by).ok_or_else(none)?;
                Ok(self.known(by).to_string())
            }
            ["refuted"] => Ok(self.refuted(errata)),
            ["count", "standing"] => {
                let open = self.counts()[&super::Verdict::Undecided];
                Ok((all - errata.len() - open).to_string())
            }
            ["right", id] => {
                let claim = self.entry(id).ok_or_else(none)?.claim;
                let correction = claim.correction.ok_or_else(none)?;
                Ok(statement(correction.latex, claim.equation))
            }
            [side @ ("stated" | "found"), id] => {
                let mut cases = self.paper.cases();
                let (claim, case) = cases.find(|(claim, _)| claim.id == id).ok_or_else(none)?;
                let [stated, found] = case.numbers().map_err(|reason| ErrataError::Case {
                    claim: claim.id,
                    reason,
                })?;
                Ok(if side == "stated" { stated } else { found })
            }
            ["value", id, decimals] => {
                let value = self.paper.value(id).ok_or_else(none)?;
                let decimals: usize = decimals.parse().map_err(|_| none())?;
                let number = value
                    .number()
                    .map_err(|why| fault(format!("{id}: {why}")))?;
                Ok(format!("{number:.decimals$}"))
            }
            _ => Err(none()),
        }
    }

    fn refuted(&self, errata: &[Erratum]) -> String {
        let known = self.paper.known_theorems();
        let refuted = errata
            .iter()
            .filter(|e| e.verdict.is_wrong() && known.refutes(e.id));
        let all: Vec<_> = refuted.collect();
        let numbers: Vec<u16> = all
            .iter()
            .filter_map(|e| self.entry(e.id)?.claim.equation)
            .collect();
        let runs = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
            [first, _, .., last] => format!("({first}) to ({last})"),
            some => some
                .iter()
                .map(|n| format!("({n})"))
                .collect::<Vec<_>>()
                .join(", "),
        });
        let others = (all.len() > numbers.len())
            .then(|| format!("{} other statements", all.len() - numbers.len()));
        let mut said: Vec<_> = runs.chain(others).collect();
        let last = said.pop().unwrap_or_default();
        match said.is_empty() {
            true => last,
            false => format!("{} and {last}", said.join(", ")),
        }
    }

    fn list(&self, errata: &[Erratum], style: &dyn Style, what: &str) -> String {
        let mut text = style.opening(self.paper, what);
        for (title, wrong) in [("Corrections", true), ("Conditions to be stated", false)] {
            let mut heading = style.heading(title);
            for erratum in errata.iter().filter(|e| e.verdict.is_wrong() == wrong) {
                text += &std::mem::take(&mut heading);
                text += &style.item(&self.name(erratum.id), erratum);
                for said in erratum.evidence.iter().filter(|_| what != COMMENT) {
                    text += &style.entry("Trial", said);
                }
                if !erratum.fallen.is_empty() && wrong {
                    let names: Vec<_> = erratum.fallen.iter().map(|id| self.name(id)).collect();
                    text += &style.entry("Inherited by", &names.join(", "));
                }
                text.push('\n');
            }
        }
        let code = format!("The program that makes the trials is at {CODE}.");
        text + &style.paragraph(&code) + style.closing(what)
    }
}

fn unlinked(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    while let Some((before, after)) = rest.split_once("](#") {
        let (_, after) = after.split_once(')').unwrap_or((after, ""));
        let (before, words) = before.rsplit_once('[').unwrap_or(("", before));
        out += before;
        out += words;
        rest = after;
    }
    out + rest
}

fn fault(says: String) -> ErrataError {
    ErrataError::Letter(says)
}

const SENDER: &str = "[name, affiliation and address]";
const CODE: &str = "[address of the code]";

/// For a line of a column, or for standing beside its number with its words.
fn is_long(latex: &str) -> bool {
    plain_formula(latex).chars().count() > 48
}

const RUN_IN: [&str; 3] = ["Printed", "Said", "Reason"];

const COMMENT: &str = "Comment on";

trait Style {
    fn opening(&self, paper: &Paper, what: &str) -> String;
    fn heading(&self, title: &str) -> String;
    fn paragraph(&self, words: &str) -> String;
    fn numbered(&self, number: u16, latex: &str) -> String;
    fn title(&self, name: &str, erratum: &Erratum) -> String;
    fn entry(&self, label: &str, words: &str) -> String;
    fn closing(&self, what: &str) -> &'static str;

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
        text
    }
}

fn closed(words: &str) -> String {
    format!("{}.", words.trim_end_matches('.'))
}

/// A formula is printed, what the paper says in words is given in ours.
fn as_printed(erratum: &Erratum) -> &'static str {
    match erratum.equation {
        Some(_) => "Printed",
        None => "Said",
    }
}

fn about(name: &str, erratum: &Erratum) -> String {
    match name == erratum.title {
        true => String::new(),
        false => format!(", {}", erratum.title),
    }
}

fn source(paper: &Paper) -> String {
    let by = match paper.authors {
        "" => String::new(),
        authors => format!("by {authors}"),
    };
    let known = [by.as_str(), paper.reference].into_iter();
    known
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join(", ")
}

struct Plain;

impl Style for Plain {
    fn opening(&self, paper: &Paper, what: &str) -> String {
        let (title, source) = (paper.title, source(paper));
        format!("{what} \"{title}\"\n{source}\n\nTo the authors\nFrom {SENDER}\n\n")
    }
    fn heading(&self, title: &str) -> String {
        format!("{}\n{}\n\n", title.to_uppercase(), "=".repeat(title.len()))
    }
    fn paragraph(&self, words: &str) -> String {
        wrapped(&plain_words(words), 0) + "\n"
    }
    fn numbered(&self, number: u16, latex: &str) -> String {
        let line = format!("({number}) {}", plain_formula(latex));
        format!("\n\n{}\n", wrapped(&line, 4))
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
    fn closing(&self, _: &str) -> &'static str {
        ""
    }
}

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

struct Latex;

impl Style for Latex {
    fn opening(&self, paper: &Paper, what: &str) -> String {
        // The comment is two pages of a journal, the supplement a report.
        let columns = match what {
            COMMENT => "\\begin{multicols}{2}\n",
            _ => "",
        };
        format!(
            "{}{{\\Large {what} ``{}''}}\\\\[2pt]\n{}\\\\[8pt]\nTo the authors\\\\[4pt]\nFrom {SENDER}\n\\end{{center}}\n{columns}\n",
            include_str!("letter.tex"),
            paper.title,
            source(paper),
        )
    }
    fn heading(&self, title: &str) -> String {
        format!("\\subsection*{{{title}}}\n\n")
    }
    fn paragraph(&self, words: &str) -> String {
        let mut text = String::new();
        for (i, part) in words.split('$').enumerate() {
            text += &match i % 2 {
                0 => tex_plain(part),
                _ if is_long(part) => format!("\n\\[\\broken{{{}}}\\]\n", breakable(part)),
                _ => format!("${}$", breakable(part)),
            };
        }
        // The stop behind a formula stands where that does.
        for stop in [",", ";", "."] {
            text = text.replace(&format!("}}\\]\n{stop} "), &format!("{stop}}}\\]\n"));
        }
        text.replace("$$", " ") + "\n\n"
    }
    fn numbered(&self, number: u16, latex: &str) -> String {
        let parts = latex.split_once(r"\quad\text{").filter(|_| is_long(latex));
        let formula = parts.map_or(latex, |(formula, _)| formula);
        let words = parts.map_or(String::new(), |(_, words)| {
            tex_words(&closed(words.trim_end_matches('}')))
        });
        format!("\n\\begin{{gather*}}\n{formula}\\tag{{{number}}}\n\\end{{gather*}}\n{words}\n\n")
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
        let end = if RUN_IN.contains(&label) { "" } else { "\n" };
        // A formula alone may be too wide for a line with its label.
        match alone(words) {
            Some(formula) => format!("\\emph{{{label}:}}\n{}{end}", displayed(formula)),
            None => format!("\\emph{{{label}:}} {}\n{end}", tex_words(words)),
        }
    }
    fn closing(&self, what: &str) -> &'static str {
        match what {
            COMMENT => "\\end{multicols}\n\\end{document}\n",
            _ => "\\end{document}\n",
        }
    }
}

fn alone(words: &str) -> Option<&str> {
    let formula = words.strip_prefix('$')?.strip_suffix('$')?;
    (!formula.contains('$')).then_some(formula)
}

fn displayed(formula: &str) -> String {
    format!("\\[\\fit{{{formula}}}\\]\n")
}

/// What stands outside the formulas becomes formulas where it must.
fn tex_words(words: &str) -> String {
    let parts = words.split('$').enumerate().map(|(i, part)| match i % 2 {
        0 => tex_plain(part),
        _ => format!("${}$", breakable(part)),
    });
    // Neighbours join into one formula.
    parts.collect::<String>().replace("$$", " ")
}

/// Lines can break, but not between `\left` and `\right`, nor in a fraction, which has a stroke if it is
/// long.
fn breakable(formula: &str) -> String {
    let formula = formula
        .replace(r"\left[", r"\bigl[")
        .replace(r"\right]", r"\bigr]");
    let inside = formula
        .strip_prefix(r"\frac{")
        .and_then(|rest| rest.strip_suffix('}'));
    let long = inside.filter(|inside| inside.len() > 300 && inside.matches("}{").count() == 1);
    long.map_or(formula.clone(), |inside| {
        let quotient = inside.replace("}{", ")/(");
        format!("({})", quotient.replace(") ", r") \allowbreak "))
    })
}

fn tex_plain(words: &str) -> String {
    let mut out = String::new();
    for piece in pieces(words) {
        match piece {
            Piece::Text(text) => out.extend(text.chars().map(tex_char)),
            Piece::Formula(latex) => out += &format!("${}$", breakable(&latex)),
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
        '&' | '%' | '#' | '_' | '{' | '}' | '$' => format!("\\{c}"),
        '/' => r"/\allowbreak{}".into(),
        '^' => "\\^{}".into(),
        '~' => "\\~{}".into(),
        '\\' => "$\\backslash$".into(),
        '“' => "``".into(),
        '”' => "''".into(),
        '<' | '>' | '|' => format!("${c}$"),
        c if c.is_ascii() => c.into(),
        c => command(c).map_or_else(|| c.into(), |command| format!("${command}$")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::Text;

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
    fn a_letter_has_what_it_asks_for() {
        let mut ledger = super::super::example::ledger();
        let mut said = |letter: &'static str| {
            let topics = ledger.paper.topics;
            let paper = Paper {
                letter: Text::Built(letter),
                topics,
                ..Paper::BLANK
            };
            ledger.paper = Box::leak(Box::new(paper));
            ledger
                .letter(Format::Text)
                .map_err(|error| error.to_string())
        };
        let sent = said("").unwrap();
        assert_eq!(sent.lines().nth(1), Some(""), "nobody wrote it");
        assert!(sent.contains("\nCORRECTIONS\n") && !sent.contains("Trial: "));
        let letter = said("[(4)](#eq-4) is {{right eq-4}}; {{count numbered}}, {{count standing}}");
        assert!(
            letter.as_ref().unwrap().contains("(4) is d = −1; "),
            "{letter:?}"
        );
        for (letter, says) in [
            (
                "{{right eq-9}}",
                "the letter: nothing is known of \"right eq-9\"",
            ),
            (
                "{{found eq-4}}",
                "the letter: nothing is known of \"found eq-4\"",
            ),
            (
                "{{right eq-4",
                "the letter: a placeholder without an end: right eq-4",
            ),
        ] {
            assert_eq!(said(letter).unwrap_err(), says, "{letter}");
        }
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
