//! Formulas: from LaTeX to HTML and MathML, when the book is built.

use super::{
    error::{Fault, Html},
    formula_diff,
    rows::{LAST_ROW, in_rows},
    text::{after_each, escape, scientific, without},
};
use crate::notation::{Piece, pieces, plain_formula};
use crate::trials::{Claim, Paper};
use katex::macro_expander::MacroMap;
use katex::macros::MacroDefinition;
use katex::{KatexContext, OutputFormat, Settings, TrustSetting, render_to_string};
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

const UNDERLINE: char = '\u{332}';

/// Until mdBook is done: it then reads a tenth of the text, and the search can put words in its place.
const MARK: (&str, &str) = ("<span data-formula=\"", "\"></span>");

/// A formula with so few letters as plain text may keep together with a sign before or behind it.
const SHORT: usize = 20;

pub(super) struct Maths(Mutex<Set>);

struct Setter {
    context: KatexContext,
    inline: Settings,
    display: Settings,
    folded: Settings,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Place {
    Inline,
    Display,
    /// Behind a fold, where there are many: MathML alone, a fifth of what both take.
    Folded,
}

type Key = (String, Place);

type Form = (String, String);

static KNOWN: LazyLock<Mutex<HashMap<Key, Form>>> = LazyLock::new(Mutex::default);

struct Set {
    setter: Setter,
    numbers: HashMap<Key, usize>,
    forms: Forms,
}

#[derive(Clone, Default)]
pub(super) struct Forms(Vec<Form>);

impl Setter {
    fn new() -> Self {
        let settings = |place| {
            let mut macros = MacroMap::default();
            // LaTeX has it, KaTeX does not know it.
            macros.insert(r"\mbox".into(), MacroDefinition::StaticStr(r"\text"));
            let changed = MacroDefinition::StaticStr(r"\htmlClass{changed}{#1}");
            macros.insert(formula_diff::MARK.into(), changed);
            let output = match place {
                Place::Folded => OutputFormat::Mathml,
                Place::Inline | Place::Display => OutputFormat::HtmlAndMathml,
            };
            let settings = Settings::builder().macros(macros).output(output);
            let settings = settings.trust(TrustSetting::Bool(true));
            settings.display_mode(place == Place::Display).build()
        };
        Setter {
            context: KatexContext::default(),
            inline: settings(Place::Inline),
            display: settings(Place::Display),
            folded: settings(Place::Folded),
        }
    }

    fn form(&self, key: &Key) -> Result<Form, Fault> {
        let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(form) = known().get(key) {
            return Ok(form.clone());
        }
        let form = self.made(&key.0, key.1)?;
        known().insert(key.clone(), form.clone());
        Ok(form)
    }

    fn made(&self, latex: &str, place: Place) -> Result<Form, Fault> {
        let fault = |reason: String| Fault::Formula {
            formula: latex.to_owned(),
            reason,
        };
        if latex.trim().is_empty() {
            return Err(fault("there is nothing in it".into()));
        }
        let settings = match place {
            Place::Inline => &self.inline,
            Place::Display => &self.display,
            Place::Folded => &self.folded,
        };
        // As large as on a line of its own: there are fractions of fractions.
        let style = match place {
            Place::Folded => r"\displaystyle ",
            Place::Inline | Place::Display => "",
        };
        let source = format!("{style}{}", roots_in_braces(latex.trim()));
        let html = render_to_string(&self.context, &source, settings)
            .map_err(|error| fault(error.to_string().replace(UNDERLINE, "")))?;
        let html = tidy(&without_annotation(&html));
        let html = match place {
            Place::Folded => in_rows(&html),
            Place::Inline | Place::Display => html,
        };
        let html = with_room(&html);
        Ok((
            html,
            escape(&plain_formula(&latex.replace(formula_diff::MARK, ""))),
        ))
    }
}

impl Maths {
    pub(super) fn new() -> Self {
        Maths(Mutex::new(Set {
            setter: Setter::new(),
            numbers: HashMap::new(),
            forms: Forms::default(),
        }))
    }

    /// What cannot be set is reported where it is met.
    pub(super) fn prepare(&self, paper: &Paper) {
        let set = self.set_so_far();
        let words = |claim: &'static Claim| {
            let conditions = claim.conditions.iter().map(|condition| condition.text);
            let own = [claim.title, claim.latex, claim.argument];
            own.into_iter().chain(conditions)
        };
        for (_, claim) in paper.claims() {
            let parts = words(claim).flat_map(|text| text.split('$').skip(1).step_by(2));
            let inline = parts.map(|latex| (latex, Place::Inline));
            let whole = [Place::Display, Place::Inline].map(|place| (claim.latex, place));
            let whole = whole.into_iter().filter(|(latex, _)| !latex.contains('$'));
            for (latex, place) in inline.chain(whole) {
                let _ = set.setter.form(&(latex.to_owned(), place));
            }
        }
    }

    pub(super) fn inline(&self, latex: &str) -> Html {
        self.set(latex, Place::Inline)
    }

    pub(super) fn display(&self, latex: &str) -> Html {
        self.set(latex, Place::Display)
    }

    pub(super) fn words(&self, text: &str) -> Html {
        self.said(text, Place::Inline)
    }

    pub(super) fn folded(&self, text: &str) -> Html {
        self.said(text, Place::Folded)
    }

    fn said(&self, text: &str, place: Place) -> Html {
        if text.matches('$').count() % 2 == 1 {
            return Err(Fault::Formula {
                formula: text.to_owned(),
                reason: "a `$` without its partner".into(),
            });
        }
        let parts = text.split('$').enumerate();
        parts
            .map(|(i, part)| match i % 2 {
                0 => self.plain(part, place),
                _ => self.set(part, place),
            })
            .collect()
    }

    fn plain(&self, words: &str, place: Place) -> Html {
        let pieces = pieces(words).into_iter();
        pieces
            .map(|piece| match piece {
                Piece::Text(text) => Ok(escape(text)),
                Piece::Formula(latex) => self.set(&latex, place),
                Piece::Minus => Ok("−".into()),
                Piece::Scientific(number) => Ok(scientific(number)),
            })
            .collect()
    }

    fn set(&self, latex: &str, place: Place) -> Html {
        let mark = |number: usize| format!("{}{number}{}", MARK.0, MARK.1);
        let key = (latex.to_owned(), place);
        let mut set = self.set_so_far();
        if let Some(number) = set.numbers.get(&key) {
            return Ok(mark(*number));
        }
        let form = set.setter.form(&key)?;
        let number = set.forms.0.len();
        set.forms.0.push(form);
        set.numbers.insert(key, number);
        Ok(mark(number))
    }

    pub(super) fn forms(&self) -> Forms {
        self.set_so_far().forms.clone()
    }

    fn set_so_far(&self) -> MutexGuard<'_, Set> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Forms {
    pub(super) fn with_formulas(&self, html: &str) -> String {
        self.replaced(html, |(html, plain), after, out| {
            // Browsers break a line between a formula and the full stop behind it or the bracket before it.
            let short = plain.chars().count() <= SHORT;
            let ends = short && after.starts_with(['.', ',', ';', ':', '?', '!', ')']);
            let begins = short && out.ends_with('(');
            // Nor does a line begin with the sign behind a formula in rows.
            let last = html
                .rfind(LAST_ROW)
                .filter(|_| after.starts_with([',', '.', ';', ':']));
            if let Some(last) = last {
                let (before, rest) = html.split_at(last);
                *out += &format!("{before}<mo>{}</mo>{rest}", &after[..1]);
                return 1;
            }
            if begins || ends {
                let bracket = if begins { out.pop() } else { None };
                let open: String = bracket.into_iter().collect();
                *out += &format!(
                    "<span class=\"whole\">{open}{html}{}</span>",
                    &after[..usize::from(ends)]
                );
            } else {
                *out += html;
            }
            usize::from(ends)
        })
    }

    pub(super) fn with_words(&self, html: &str) -> String {
        self.replaced(html, |(_, plain), _, out| {
            *out += plain;
            0
        })
    }

    pub(super) fn with_mathml(&self, html: &str) -> String {
        self.replaced(html, |(html, plain), _, out| {
            let from = html.find("<math").zip(html.find("</math>"));
            let math = from.map(|(start, end)| &html[start..end + "</math>".len()]);
            *out += math.unwrap_or(plain);
            0
        })
    }

    /// `put` is given what follows a mark, and says how much of that it has written, too.
    fn replaced(&self, html: &str, put: impl Fn(&Form, &str, &mut String) -> usize) -> String {
        after_each(html, MARK.0, |part, out| {
            let (number, after) = part.split_once(MARK.1).unwrap_or((part, ""));
            let formula = number.parse().ok().and_then(|n: usize| self.0.get(n));
            let done = formula.map_or(0, |formula| put(formula, after, out));
            *out += &after[done..];
        })
    }
}

fn with_room(html: &str) -> String {
    const APPLY: &str = "<mo>\u{2061}</mo>";
    after_each(html, APPLY, |part, out| {
        let name = out.strip_suffix("</mi>").and_then(|out| {
            let (before, name) = out.rsplit_once("<mi")?;
            Some((before.len(), name.split_once('>')?.1.to_owned()))
        });
        if let Some((before, name)) = name {
            out.truncate(before);
            *out += &format!("<mo lspace=\"0.17em\" rspace=\"0em\">{name}</mo>");
        }
        // A power stands between the two.
        let power = part.strip_prefix("</mrow><mn>").and_then(|power| {
            let end = power.find("</mn></")? + "</mn></".len();
            Some(power[end..].find('>')? + end + "</mrow><mn>>".len())
        });
        let power = power.unwrap_or(0);
        let mut text = part[power..]
            .split('>')
            .filter_map(|text| text.chars().next());
        *out += &format!("{APPLY}{}", &part[..power]);
        if text
            .find(|c| *c != '<')
            .is_some_and(|c| !"([|{".contains(c))
        {
            *out += "<mspace width=\"0.17em\"/>";
        }
        *out += &part[power..];
    })
}

/// katex-rs loses the room for the sign before a bare symbol under a root.
fn roots_in_braces(latex: &str) -> String {
    const ROOT: &str = r"\sqrt";
    after_each(latex, ROOT, |part, out| {
        let part = part.trim_start();
        let end = match part.chars().next() {
            None | Some('{' | '[') => 0,
            Some('\\') => {
                let name = part[1..].find(|c: char| !c.is_ascii_alphabetic());
                name.map_or(part.len(), |end| end + 1)
            }
            Some(c) => c.len_utf8(),
        };
        *out += ROOT;
        match end {
            0 => *out += part,
            end => *out += &format!("{{{}}}{}", &part[..end], &part[end..]),
        }
    })
}

/// The search would read the LaTeX source within the MathML as if it were text.
fn without_annotation(html: &str) -> String {
    let kept = without(html, "<annotation", "</annotation>");
    [
        "<semantics>",
        "</semantics>",
        " xmlns=\"http://www.w3.org/1998/Math/MathML\"",
    ]
    .into_iter()
    .fold(kept, |kept, empty| kept.replace(empty, ""))
}

/// KaTeX writes attributes in any order.
fn tidy(html: &str) -> String {
    let mut out = String::with_capacity(html.len() * 2);
    let mut rest = html;
    while let Some(c) = rest.chars().next() {
        if c == '<' {
            let end = tag_end(rest);
            write_tag(&rest[..end], &mut out);
            rest = &rest[end..];
            continue;
        }
        out.push(if c == '\n' { ' ' } else { c });
        rest = &rest[c.len_utf8()..];
    }
    out
}

/// Its brackets included.
fn tag_end(html: &str) -> usize {
    let mut quote = None;
    for (i, c) in html.char_indices() {
        match (quote, c) {
            (None, '>') => return i + 1,
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if c == open => quote = None,
            _ => {}
        }
    }
    html.len()
}

fn write_tag(tag: &str, out: &mut String) {
    let inside = tag.trim_start_matches('<').trim_end_matches('>');
    let (inside, close) = match inside.strip_suffix('/') {
        Some(inside) => (inside, "/>"),
        None => (inside, ">"),
    };
    let (name, mut rest) = inside.split_once(' ').unwrap_or((inside, ""));
    let mut attributes = Vec::new();
    while let Some((key, after)) = rest.trim_start().split_once('=') {
        let quote = if after.starts_with('\'') { '\'' } else { '"' };
        let value = after.strip_prefix(quote).unwrap_or(after);
        let (value, after) = value.split_once(quote).unwrap_or((value, ""));
        attributes.push((key, value, quote));
        rest = after;
    }
    attributes.sort_unstable();
    out.push('<');
    *out += name;
    for (key, value, quote) in attributes {
        let value = value.replace('\n', " ").replace('|', "&#124;");
        *out += &format!(" {key}={quote}{value}{quote}");
    }
    *out += close;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::notation::letters::FUNCTIONS;

    #[test]
    fn attributes_come_in_order() {
        let html = "<span style=\"a:b\" class='c d'>x_1*|<path d='M0 0'/></span>&amp;\n";
        assert_eq!(
            tidy(html),
            "<span class='c d' style=\"a:b\">x_1*|<path d='M0 0'/></span>&amp; "
        );
    }

    #[test]
    fn an_empty_attribute_does_not_swallow_the_next() {
        assert_eq!(tidy("<a b=\"\" a=\"1\">"), "<a a=\"1\" b=\"\">");
    }

    #[test]
    fn a_root_has_room_for_its_sign() {
        assert_eq!(
            roots_in_braces(r"\sqrt2+\sqrt\pi x+\sqrt{y}"),
            r"\sqrt{2}+\sqrt{\pi} x+\sqrt{y}"
        );
        let maths = Maths::new();
        for latex in [r"\sqrt2", r"\sqrt{2}", r"\sqrt\pi"] {
            let marked = maths.inline(latex).unwrap();
            let html = maths.forms().with_formulas(&marked);
            assert!(html.contains("padding-left:0.833em"), "{latex}: {html}");
        }
    }

    #[test]
    fn functions_have_room_before_a_bare_argument() {
        let maths = Maths::new();
        for name in FUNCTIONS {
            for (argument, rooms) in [(" ψ", 1), ("² ψ", 1), ("(ψ)", 0), ("²(ψ)", 0)] {
                let marked = maths.folded(&format!("{name}{argument}")).unwrap();
                let html = maths.forms().with_formulas(&marked);
                assert_eq!(html.matches("<mspace").count(), rooms, "{html}");
                assert!(!html.contains(&format!("<mi>{name}</mi>")), "{html}");
            }
        }
    }

    #[test]
    fn no_line_begins_with_the_sign_behind_rows() {
        let maths = Maths::new();
        let long = "a_x + b_x + c_x + ".repeat(9);
        for text in [format!("So: {long}d, as stated"), format!("So: {long}d.")] {
            let marked = maths.folded(&text).unwrap();
            let html = maths.forms().with_formulas(&marked);
            let (_, after) = html.rsplit_once("</math>").unwrap();
            assert!(
                html.contains("</mtable>") && !after.contains([',', '.']),
                "{html}"
            );
        }
    }

    #[test]
    fn a_short_formula_keeps_its_brackets() {
        let maths = Maths::new();
        let marked = maths.words("soon ($x<1$), or ($x$ small)").unwrap();
        let html = maths.forms().with_formulas(&marked);
        assert!(html.starts_with("soon <span class=\"whole\">(<span class=\"katex\">"));
        assert!(html.contains("</span>)</span>, or <span class=\"whole\">("));
        assert!(html.ends_with("</span></span> small)"));
    }

    #[test]
    fn plain_mathematics_is_set() {
        let maths = Maths::new();
        for (plain, said) in [
            (
                "dv_x/dt, (q_Y)² & eq20_stop_time, _x",
                "dv_x/dt, (q_Y)² &amp; eq20_stop_time, _x",
            ),
            ("A/t^(3/2): x^2 and x^, y^(z", "A/t^(3/2): x² and x^, y^(z"),
            (
                "to 1e-12, 3.20e-3, 3.20e-1, 1.0e0",
                "to 10<sup>−12</sup>, 3.2\u{a0}×\u{a0}10<sup>−3</sup>, 0.32, 1",
            ),
            ("1e5 of them", "10<sup>5</sup> of them"),
            ("a1e-5, s2-x, 3-4", "a1e-5, s2-x, 3-4"),
            (
                "g = 9.81, θ = -2.5 at a rest",
                "g = 9.81, θ = −2.5 at a rest",
            ),
            ("(-1) is -1", "(−1) is −1"),
        ] {
            let marked = maths.folded(plain).unwrap();
            assert_eq!(maths.forms().with_words(&marked), said);
            let html = maths.forms().with_formulas(&marked);
            assert!(!html.contains("katex-html"), "{html}");
        }
    }

    #[test]
    fn words_keep_their_text_and_need_paired_dollars() {
        let maths = Maths::new();
        let marked = maths.words("if $x<1$ & so on").unwrap();
        assert_eq!(maths.words("if $x<1$ & so on").unwrap(), marked);
        assert_eq!(maths.forms().with_words(&marked), "if x &lt; 1 &amp; so on");
        let html = maths.forms().with_formulas(&marked);
        assert!(html.starts_with("if <span class=\"katex\">") && html.ends_with(" &amp; so on"));
        assert!(!html.contains('$') && !html.contains("annotation"));
        assert!(matches!(
            maths.words("costs $5"),
            Err(Fault::Formula { .. })
        ));
        assert!(matches!(
            maths.words(r"$\frac{1}{$"),
            Err(Fault::Formula { .. })
        ));
    }
}
