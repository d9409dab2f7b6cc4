//! A statement of Rocq in words, with formulas between dollar signs.

use super::source::{Item, Sources};
use super::term::Term;
use std::collections::BTreeMap;

/// A theorem in words.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Said {
    /// What it is about: numbers, functions.
    pub given: Vec<String>,
    /// What is supposed of that.
    pub supposed: Vec<String>,
    /// What holds then.
    pub holds: Vec<String>,
}

/// How tightly a place binds.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const POWER: u8 = 3;
const ATOM: u8 = 4;

/// Predicates and functions of the libraries: `#1` is the first thing that it is of, `#1@2` its value at the second.
const KNOWN: [(&str, &str); 21] = [
    ("rder", "$#1$ has the right derivative $#3$ at $#2$"),
    ("is_derive", "$#1$ has the derivative $#3$ at $#2$"),
    ("continuity_pt", "$#1$ is continuous at $#2$"),
    ("is_lim", "$#1\\to #3$ as its argument tends to $#2$"),
    ("is_lim_seq", "the sequence $#1$ tends to $#2$"),
    ("is_RInt", "the integral of $#1$ from $#2$ to $#3$ is $#4$"),
    ("Finite", "$#1$"),
    ("RInt", "$\\int_{#2}^{#3}#1$"),
    ("nrm", "$\\lvert(#1,#2)\\rvert$"),
    ("Rabs", "$\\lvert #1\\rvert$"),
    ("sqrt", "$\\sqrt{#1}$"),
    ("Rpower", "$(#1)^{#2}$"),
    ("exp", "$\\mathrm e^{#1}$"),
    ("asin", "$\\arcsin(#1)$"),
    ("acos", "$\\arccos(#1)$"),
    ("atan", "$\\arctan(#1)$"),
    ("Rmin", "$\\min(#1,#2)$"),
    ("Rmax", "$\\max(#1,#2)$"),
    ("IZR", "$#1$"),
    ("INR", "$#1$"),
    ("Rsqr", "$(#1)^2$"),
];

const NAMED: [&str; 9] = [
    "sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "coth", "ln",
];

const GREEK: [&str; 22] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu",
    "nu", "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Omega",
];
const SHORT: [(&str, &str); 8] = [
    ("lam", "lambda"),
    ("al", "alpha"),
    ("be", "beta"),
    ("ph", "phi"),
    ("th", "theta"),
    ("Om", "Omega"),
    ("eps", "varepsilon"),
    ("PI", "pi"),
];

/// A comment of a file as it is printed.
pub fn spoken(comment: &str) -> String {
    let letter = |word: &str| {
        let own = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let index = &word[own.len()..];
        let index = if index.is_empty() {
            String::new()
        } else {
            format!("_{{{index}}}")
        };
        let own = if own == "PI" { "pi" } else { own };
        GREEK.contains(&own).then(|| format!("$\\{own}{index}$"))
    };
    let mut parts = comment.split('$').enumerate();
    let mut out = String::new();
    for (i, part) in &mut parts {
        if i % 2 == 1 {
            out += &format!("${part}$");
            continue;
        }
        let part = part
            .replace("->", "→")
            .replace("<=", "≤")
            .replace(">=", "≥")
            .replace("<>", "≠");
        let mut word = String::new();
        for c in part.chars().chain(['\n']) {
            if c.is_alphanumeric() || c == '_' {
                word.push(c);
                continue;
            }
            out += &letter(&word).unwrap_or_else(|| word.clone());
            word.clear();
            out.push(c);
        }
        out.pop();
    }
    out
}

/// Puts statements into words, by the readings that definitions give of themselves.
pub struct Writer<'a> {
    /// What the files declare.
    pub sources: &'a Sources,
    /// How the formula of this name is written: `\text{(13)}`.
    pub formula: &'a dyn Fn(&str) -> Option<String>,
}

impl Writer<'_> {
    /// A theorem, taken apart.
    pub fn said(&self, statement: &str) -> Option<Said> {
        let mut said = Said::default();
        self.apart(&Term::read(statement)?, &mut said);
        Some(said)
    }

    fn apart(&self, term: &Term, said: &mut Said) {
        match term {
            Term::Bound("forall", bound, body) => {
                said.given.extend(kinds(bound));
                self.apart(body, said);
            }
            Term::Let(name, value, body) => {
                said.supposed
                    .push(format!("${}={}$", letter(name), self.math(value, 0)));
                self.apart(body, said);
            }
            Term::Joined(first, rest) if rest[0].0 == "->" => {
                let mut all: Vec<&Term> = vec![first];
                all.extend(rest.iter().map(|(_, term)| term));
                let last = all.pop();
                said.supposed
                    .extend(all.into_iter().flat_map(|one| self.each(one)));
                if let Some(last) = last {
                    self.apart(last, said);
                }
            }
            _ => said.holds.extend(self.each(term)),
        }
    }

    fn each(&self, term: &Term) -> Vec<String> {
        match term {
            Term::Joined(first, rest) if rest[0].0 == "/\\" => {
                let all = std::iter::once(&**first).chain(rest.iter().map(|(_, term)| term));
                all.flat_map(|one| self.each(one)).collect()
            }
            _ => vec![self.words(term)],
        }
    }

    fn words(&self, term: &Term) -> String {
        match term {
            Term::Bound("forall", bound, body) => {
                let (supposed, holds) = self.condition(body);
                let given = format!("for every {}", listed(bound));
                match supposed.is_empty() {
                    true => format!("{given} {holds}"),
                    false => format!("{given} with {supposed} {holds}"),
                }
            }
            Term::Bound("exists", bound, body) => {
                let such = self.each(body).join(", and ");
                format!(
                    "there {} {} such that {such}",
                    if bound.len() == 1 { "is" } else { "are" },
                    listed(bound)
                )
            }
            Term::Let(name, value, body) => {
                format!(
                    "with ${}={}$: {}",
                    letter(name),
                    self.math(value, 0),
                    self.words(body)
                )
            }
            Term::Joined(_, rest) => match rest[0].0 {
                "->" => {
                    let (supposed, holds) = self.condition(term);
                    format!("if {supposed}, then {holds}")
                }
                "<->" => self.chain(term, " if and only if "),
                "\\/" => self.chain(term, ", or "),
                "/\\" => self.each(term).join(", and "),
                _ => format!("${}$", self.math(term, 0)),
            },
            Term::Before("~", of) => match &**of {
                Term::Joined(..) => format!("it is not so that {}", self.words(of)),
                _ => format!("not: {}", self.words(of)),
            },
            Term::Of(name, of) => self
                .reading(name, of)
                .unwrap_or_else(|| format!("${}$", self.math(term, 0))),
            _ => format!("${}$", self.math(term, 0)),
        }
    }

    fn chain(&self, term: &Term, between: &str) -> String {
        let Term::Joined(first, rest) = term else {
            return self.words(term);
        };
        let all = std::iter::once(&**first).chain(rest.iter().map(|(_, term)| term));
        all.map(|one| self.words(one))
            .collect::<Vec<_>>()
            .join(between)
    }

    fn condition(&self, term: &Term) -> (String, String) {
        match term {
            Term::Joined(first, rest) if rest[0].0 == "->" => {
                let mut all: Vec<&Term> = vec![first];
                all.extend(rest.iter().map(|(_, term)| term));
                let last = all.pop().map_or(String::new(), |last| self.words(last));
                let supposed = all.into_iter().flat_map(|one| self.each(one));
                (supposed.collect::<Vec<_>>().join(" and "), last)
            }
            _ => (String::new(), self.words(term)),
        }
    }

    /// What a definition says of itself, of these things; of the libraries' what is known here.
    fn reading(&self, name: &str, of: &[Term]) -> Option<String> {
        if let Some((_, known)) = KNOWN.iter().find(|(own, _)| *own == name) {
            return Some(self.filled(known, of));
        }
        let item = self.sources.meaning(name)?;
        let (_, reading) = item.about.split_once('«')?;
        let (reading, _) = reading.split_once('»')?;
        let parameters = parameters(item);
        let values: BTreeMap<&str, String> = parameters
            .iter()
            .map(String::as_str)
            .zip(of.iter().map(|term| self.math(term, 0)))
            .collect();
        let mut out = String::new();
        for (i, part) in reading.split('$').enumerate() {
            match i % 2 {
                0 => out += part,
                _ => out += &format!("${}$", replaced(part, &values)),
            }
        }
        Some(out)
    }

    fn filled(&self, reading: &str, of: &[Term]) -> String {
        let mut out = reading.to_owned();
        for (i, term) in of.iter().enumerate() {
            out = out.replace(&format!("#{}", i + 1), &self.math(term, 0));
        }
        out
    }

    fn math(&self, term: &Term, place: u8) -> String {
        let bracketed = |own: u8, text: String| {
            if own < place {
                format!("({text})")
            } else {
                text
            }
        };
        match term {
            Term::Name(name) => match (self.formula)(name) {
                Some(formula) => formula,
                None => self.constant(name),
            },
            Term::Of(name, of) => self.value(name, of, place),
            Term::Value(head, of) => format!("{}({})", self.math(head, ATOM), self.list(of)),
            Term::Joined(first, rest) if rest.len() == 1 && rest[0].0 == "/" => bracketed(
                PRODUCT,
                format!(
                    "\\frac{{{}}}{{{}}}",
                    self.math(first, 0),
                    self.math(&rest[0].1, 0)
                ),
            ),
            Term::Joined(base, rest) if rest[0].0 == "^" => {
                let (base, power) = (&**base, self.math(&rest[0].1, 0));
                match base {
                    Term::Of(name, of) if NAMED.contains(&name.as_str()) => {
                        format!("\\{name}^{{{power}}}{}", self.argument(of))
                    }
                    _ => bracketed(POWER, format!("{}^{{{power}}}", self.math(base, ATOM))),
                }
            }
            Term::Joined(first, rest) => {
                let own = match rest[0].0 {
                    "+" | "-" => SUM,
                    "*" | "/" => PRODUCT,
                    _ => 0,
                };
                let mut text = self.math(first, own);
                for (sign, next) in rest {
                    text = match *sign {
                        "/" => format!("\\frac{{{text}}}{{{}}}", self.math(next, 0)),
                        sign => format!(
                            "{text}{}{}",
                            shown(sign),
                            self.math(next, own + u8::from(own > 0))
                        ),
                    };
                }
                bracketed(own, text)
            }
            Term::Before("-", of) => bracketed(SUM, format!("-{}", self.math(of, PRODUCT))),
            Term::Before("/", of) => bracketed(PRODUCT, format!("\\frac1{{{}}}", self.math(of, 0))),
            Term::Before(_, of) => format!("\\neg({})", self.math(of, 0)),
            Term::Bound("fun", bound, body) => match bound.as_slice() {
                [(name, _)] if name == "_" => self.math(body, place),
                [(name, _)] => bracketed(
                    0,
                    format!("{}\\mapsto {}", letter(name), self.math(body, 0)),
                ),
                _ => self.math(body, place),
            },
            Term::Bound(..) => format!("\\text{{{}}}", self.words(term)),
            Term::Let(name, value, body) => format!(
                "{}\\;({}={})",
                self.math(body, 0),
                letter(name),
                self.math(value, 0)
            ),
            Term::If(a, b, c) => {
                format!(
                    "\\begin{{cases}}{}&{}\\\\{}&\\text{{else}}\\end{{cases}}",
                    self.math(b, 0),
                    self.math(a, 0),
                    self.math(c, 0)
                )
            }
            Term::Tuple(parts) => format!("({})", self.list(parts)),
        }
    }

    fn list(&self, terms: &[Term]) -> String {
        terms
            .iter()
            .map(|term| self.math(term, 0))
            .collect::<Vec<_>>()
            .join(",")
    }

    fn argument(&self, of: &[Term]) -> String {
        match of {
            [Term::Name(name)] => format!(" {}", self.constant(name)),
            _ => format!("({})", self.list(of)),
        }
    }

    fn value(&self, name: &str, of: &[Term], place: u8) -> String {
        if let Some(formula) = (self.formula)(name) {
            return format!("{formula}[{}]", self.list(of));
        }
        if NAMED.contains(&name) {
            return format!("\\{name}{}", self.argument(of));
        }
        if let Some(reading) = self.reading(name, of) {
            let mut parts = reading.split('$');
            return match (parts.next(), parts.next(), parts.next(), parts.next()) {
                (Some(""), Some(formula), Some(""), None) => {
                    match place >= POWER && formula.contains(['+', '-']) {
                        true => format!("({formula})"),
                        false => formula.to_owned(),
                    }
                }
                _ => format!("\\text{{{reading}}}"),
            };
        }
        format!("{}({})", letter(name), self.list(of))
    }

    fn constant(&self, name: &str) -> String {
        match name {
            "p_infty" => "\\infty".to_owned(),
            "m_infty" => "-\\infty".to_owned(),
            "True" => "\\text{true}".to_owned(),
            "False" => "\\text{false}".to_owned(),
            _ => self.reading(name, &[]).map_or_else(
                || letter(name),
                |reading| reading.trim_matches('$').to_owned(),
            ),
        }
    }
}

fn shown(sign: &str) -> &'static str {
    match sign {
        "*" => "\\,",
        "+" => "+",
        "-" => "-",
        "=" => "=",
        "<>" => "\\ne ",
        "<" => "<",
        ">" => ">",
        "<=" => "\\le ",
        ">=" => "\\ge ",
        "/\\" => "\\land ",
        "\\/" => "\\lor ",
        "->" => "\\Rightarrow ",
        _ => "\\Leftrightarrow ",
    }
}

/// `theta0` as `\theta_0`, `vx` as `v_x`.
fn letter(name: &str) -> String {
    if name.chars().all(|c| c.is_ascii_digit()) {
        return name.to_owned();
    }
    let primes = name.len() - name.trim_end_matches('\'').len();
    let name = &name[..name.len() - primes];
    let short = SHORT.iter().find(|(short, _)| {
        name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_') == *short
    });
    let long = GREEK
        .iter()
        .filter(|greek| name.starts_with(**greek))
        .max_by_key(|greek| greek.len());
    let (own, index) = match (short, long) {
        (Some((short, greek)), _) => (format!("\\{greek}"), &name[short.len()..]),
        (None, Some(greek)) => (format!("\\{greek}"), &name[greek.len()..]),
        _ => {
            let first = name.chars().next().map_or(0, char::len_utf8);
            (name[..first].to_owned(), &name[first..])
        }
    };
    let index = index.trim_matches('_').replace('_', ",");
    let index = match index.chars().count() {
        0 => String::new(),
        1 => format!("_{index}"),
        _ if index.chars().all(|c| c.is_ascii_digit()) => format!("_{{{index}}}"),
        _ => {
            return format!(
                "\\mathit{{{}}}{}",
                name.replace('_', "\\_"),
                "'".repeat(primes)
            );
        }
    };
    format!("{own}{index}{}", "'".repeat(primes))
}

fn listed(bound: &[(String, String)]) -> String {
    let kinds: Vec<_> = kinds(bound);
    kinds.join(", ")
}

/// What is given, those of one kind together: `$A$, $v_0$`; `functions $v_x$, $v_y$`.
fn kinds(bound: &[(String, String)]) -> Vec<String> {
    let parts = bound.chunk_by(|a, b| a.1 == b.1).map(|alike| {
        let letters: Vec<_> = alike
            .iter()
            .map(|(name, _)| format!("${}$", letter(name)))
            .collect();
        let many = if alike.len() == 1 { "" } else { "s" };
        match alike[0].1.as_str() {
            "R" | "" => letters.join(", "),
            "nat" => format!("the whole number{many} {}", letters.join(", ")),
            "Z" => format!("the integer{many} {}", letters.join(", ")),
            _ => format!("the function{many} {}", letters.join(", ")),
        }
    });
    parts.collect()
}

fn replaced(formula: &str, values: &BTreeMap<&str, String>) -> String {
    let mut out = String::new();
    let mut rest = formula;
    while let Some(first) = rest.chars().next() {
        let word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
        let command = first == '\\';
        let length = match command {
            true => {
                1 + rest[1..]
                    .find(|c: char| !c.is_ascii_alphabetic())
                    .unwrap_or(rest.len() - 1)
                    .max(1)
            }
            false if first.is_alphabetic() => rest.find(|c: char| !word(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let text = &rest[..length];
        match values.get(text).filter(|_| !command) {
            Some(value) => out += value,
            None => out += text,
        }
        rest = &rest[length..];
    }
    out
}

fn parameters(item: &Item) -> Vec<String> {
    let rest = item
        .text
        .split_once(&item.name)
        .map_or("", |(_, rest)| rest);
    let mut names = Vec::new();
    let mut kind = false;
    for word in rest.split_inclusive(|c: char| " (){}:".contains(c)) {
        let (name, end) = match word.char_indices().last() {
            Some((at, c)) if " (){}:".contains(c) => (&word[..at], c),
            _ => (word, ' '),
        };
        if !name.is_empty() && !kind && name != "=" {
            names.push(name.to_owned());
        }
        match end {
            ')' | '}' => kind = false,
            // Outside of brackets the type, or the body, begins.
            ':' if !rest[..rest.find(word).unwrap_or(0)].ends_with('(')
                && depth(rest, word) == 0 =>
            {
                break;
            }
            ':' => kind = true,
            _ => {}
        }
    }
    names
}

fn depth(text: &str, word: &str) -> i32 {
    let at = (word.as_ptr() as usize)
        .wrapping_sub(text.as_ptr() as usize)
        .min(text.len());
    text[..at].chars().fold(0, |depth, c| match c {
        '(' | '{' => depth + 1,
        ')' | '}' => depth - 1,
        _ => depth,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comment_is_printed_with_its_letters() {
        let spoken = spoken("psi -> 0 for lambda0 <= $\\eta$, but alphabet");
        assert_eq!(
            spoken,
            "$\\psi$ → 0 for $\\lambda_{0}$ ≤ $\\eta$, but alphabet"
        );
    }

    const FILE: &str = "(* A particle. «$(vx,vy)$ is a motion under $(Ax,Ay)$ with $\\mu g=k$» *)\n\
        Record motion (k : R) (Ax Ay vx vy : R -> R) : Prop := { m : True }.\nDefinition fwd l a t := cos a - l * t.\n";

    #[test]
    fn a_theorem_is_told_as_mathematics() {
        let sources = Sources::read([("A.v", FILE)].into_iter());
        let formula = |name: &str| (name == "eq20_stop_time").then(|| "\\text{(20)}".to_owned());
        let writer = Writer {
            sources: &sources,
            formula: &formula,
        };
        let said = writer
            .said(
                "forall (A lam : R) (vx vy : R -> R), 0 < A -> motion (A * lam) (fun _ : R => - A) (fun _ : R => 0) vx vy -> \
                 (forall t : R, 0 <= t < Formulas.eq20_stop_time lam A -> nrm (vx t) (vy t) <> 0) /\\ (exists s : R, s ^ 2 = sin s / 2)",
            )
            .unwrap();
        assert_eq!(
            said.given,
            ["$A$, $\\lambda$", "the functions $v_x$, $v_y$"]
        );
        assert_eq!(
            said.supposed,
            [
                "$0<A$",
                "$(v_x,v_y)$ is a motion under $(-A,0)$ with $\\mu g=A\\,\\lambda$"
            ]
        );
        assert_eq!(
            said.holds,
            [
                "for every $t$ with $0\\le t<\\text{(20)}[\\lambda,A]$ $\\lvert(v_x(t),v_y(t))\\rvert\\ne 0$",
                "there is $s$ such that $s^{2}=\\frac{\\sin s}{2}$"
            ]
        );
        assert_eq!(parameters(&sources.items[0]), ["k", "Ax", "Ay", "vx", "vy"]);
        assert_eq!(parameters(&sources.items[1]), ["l", "a", "t"]);
        for (name, latex) in [
            ("theta0", "\\theta_0"),
            ("vx", "v_x"),
            ("x'", "x'"),
            ("lam", "\\lambda"),
            ("phitilde2", "\\mathit{phitilde2}"),
            ("t1", "t_1"),
        ] {
            assert_eq!(letter(name), latex);
        }
    }
}
