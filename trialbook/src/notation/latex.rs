//! Plain text as LaTeX: formulas such as `tan(θ/2)^2 + v_x/R` among words.

mod factors;
mod scripts;
#[cfg(test)]
mod tests;

use super::letters::{FRACTIONS, HIGH, LOW, large, light};
use super::plain::symbols;
use factors::{is_differential, is_letter};

const RELATIONS: &str = "=<>≤≥≠≈→∈∝~≪≫≡";

/// In characters.
const LONG: usize = 40;

/// With more it is no formula.
const DEEPEST: usize = 16;

/// With its length; its sides apart if it is long. Words, and numbers or capitals alone, are none.
pub(super) fn formula(text: &str) -> Option<(Vec<String>, usize)> {
    let mut reader = Reader {
        rest: text,
        mathematical: false,
        depth: 0,
    };
    let sides = reader.sides()?;
    let ends = !reader
        .peek()
        .is_some_and(|c| c.is_alphanumeric() || c == '_');
    let length = text.len() - reader.rest.len();
    let sides = match text[..length].chars().count() > LONG {
        true => sides,
        false => vec![sides.join(" ")],
    };
    (reader.mathematical && ends).then_some((sides, length))
}

struct Factor {
    latex: String,
    /// If it is nothing else.
    inside: Option<String>,
    /// May stand before or behind a slash as it is.
    simple: bool,
}

impl Factor {
    fn simple(latex: String) -> Self {
        Factor {
            latex,
            inside: None,
            simple: true,
        }
    }

    fn bare(self) -> String {
        self.inside.unwrap_or(self.latex)
    }
}

struct Reader<'a> {
    rest: &'a str,
    /// What was read so far can only be a formula.
    mathematical: bool,
    depth: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn skip(&mut self, prefix: &str) -> bool {
        let rest = self.rest.strip_prefix(prefix);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn attempt<T>(&mut self, read: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        let (rest, mathematical) = (self.rest, self.mathematical);
        let found = read(self);
        if found.is_none() {
            (self.rest, self.mathematical) = (rest, mathematical);
        }
        found
    }

    fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        if self.depth == DEEPEST {
            return None;
        }
        self.depth += 1;
        let found = read(self);
        self.depth -= 1;
        found
    }

    fn sides(&mut self) -> Option<Vec<String>> {
        let mut sides = vec![self.sum()?];
        while let Some(side) = self.attempt(|r| {
            r.skip(" ");
            let sign = r.peek().filter(|c| RELATIONS.contains(*c))?;
            r.rest = &r.rest[sign.len_utf8()..];
            r.skip(" ");
            r.mathematical = true;
            Some(format!("{} {}", sign_command(sign), r.sum()?))
        }) {
            sides.push(side);
        }
        Some(sides)
    }

    fn sum(&mut self) -> Option<String> {
        let mut sum = self.read_signed()?;
        while let Some(term) = self.attempt(|r| {
            let spaced = r.skip(" ");
            let sign = r.peek().filter(|c| "+−±".contains(*c))?;
            r.rest = &r.rest[sign.len_utf8()..];
            if spaced && !r.skip(" ") {
                return None;
            }
            r.mathematical = true;
            Some(format!(" {} {}", sign_command(sign), r.read_signed()?))
        }) {
            sum += &term;
        }
        Some(sum)
    }

    fn read_signed(&mut self) -> Option<String> {
        let negative = self.rest.starts_with('-') && self.rest[1..].starts_with(char::is_numeric);
        for (sign, latex) in [("−", "-"), ("±", r"\pm "), ("-", "-")] {
            if (sign != "-" || negative) && self.skip(sign) {
                self.mathematical |= sign == "±";
                return Some(format!("{latex}{}", self.product()?));
            }
        }
        self.product()
    }

    fn product(&mut self) -> Option<String> {
        let first = self.factor()?;
        // Two simple factors with a slash between them, as long as no third follows.
        let mut flat = None;
        let mut so_far = first;
        let mut factors = 1;
        while let Some((joint, next)) = self.attempt(Self::next_factor) {
            factors += 1;
            flat = None;
            let latex = match joint {
                "/" => {
                    if factors == 2 && so_far.simple && next.simple {
                        flat = Some(format!("{}/{}", so_far.latex, next.latex));
                    }
                    format!(r"\frac{{{}}}{{{}}}", so_far.bare(), next.bare())
                }
                "·" => format!(r"{}\cdot {}", so_far.latex, next.latex),
                "×" => format!(r"{}\times {}", so_far.latex, next.latex),
                _ if next.latex.starts_with(|c: char| c.is_ascii_digit()) => {
                    format!(r"{}\cdot {}", so_far.latex, next.latex)
                }
                _ if is_differential(&so_far.latex) || is_differential(&next.latex) => {
                    format!(r"{}\, {}", so_far.latex, next.latex)
                }
                _ => format!("{} {}", so_far.latex, next.latex),
            };
            so_far = Factor {
                latex,
                inside: None,
                simple: false,
            };
        }
        Some(flat.unwrap_or(so_far.latex))
    }

    fn next_factor(&mut self) -> Option<(&'static str, Factor)> {
        for (written, joint) in [("/", "/"), (" · ", "·"), ("·", "·"), (" × ", "×")] {
            if self.skip(written) {
                return Some((joint, self.factor()?));
            }
        }
        let spaced = self.skip(" ");
        let c = self.peek()?;
        let begins = c.is_alphabetic() || is_letter(c) || c == '√' || c == '(';
        if !spaced && !begins {
            return None;
        }
        let article = self.rest.strip_prefix("a ");
        if article.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_lowercase())) {
            return None;
        }
        match (spaced, c) {
            (false, '(') => self.group('(', ')', true),
            _ => self.factor(),
        }
        .map(|factor| ("", factor))
    }
}

fn sign_command(sign: char) -> String {
    match sign {
        '−' => "-".into(),
        sign if sign.is_ascii() && sign != '~' => sign.into(),
        '~' => r"\sim ".into(),
        sign => command(sign).map_or_else(|| sign.into(), |command| command + " "),
    }
}

/// Characters that have another command than the reader of LaTeX has for them, or none.
const OTHERS: &[(char, &str)] = &[
    ('−', "-"),
    ('√', r"\surd"),
    ('𝔴', r"\mathfrak w"),
    ('ẑ', r"\hat z"),
    ('˙', r"\cdot"),
    ('∠', r"\angle"),
    ('|', "|"),
    ('′', "'"),
    ('\u{303}', r"\tilde{}"),
];

pub(crate) fn command(c: char) -> Option<String> {
    if let Some((_, command)) = OTHERS.iter().find(|(known, _)| *known == c) {
        return Some((*command).to_owned());
    }
    for (among, sign) in [(LOW, '_'), (HIGH, '^')] {
        if let Some(large) = large(c, among) {
            return Some(format!("{sign}{large}"));
        }
    }
    let is = |text: &str| text.trim().chars().eq([c]);
    if let Some(((above, below), _)) = FRACTIONS.iter().find(|(_, known)| is(known)) {
        return Some(format!(r"\frac{above}{below}"));
    }
    if light(c) != c {
        return Some(match command(light(c)) {
            Some(letter) => format!(r"\bm{letter}"),
            None => format!(r"\bm {}", light(c)),
        });
    }
    let known = symbols().find(|(_, symbol)| is(symbol));
    known.map(|(name, _)| format!("\\{name}"))
}
