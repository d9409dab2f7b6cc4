//! LaTeX as plain text: for claims, letters, terminals and the search.

use super::letters::{
    ACCENTS, FRACTIONS, FUNCTIONS, GREEK, HIGH, LOW, bold, is_small, large, light, small,
};

/// Words with formulas in `$…$`, as plain text.
pub fn plain_words(text: &str) -> String {
    let parts = text.split('$').enumerate();
    parts
        .map(|(i, part)| match i % 2 {
            0 => part.to_owned(),
            _ => plain_formula(part),
        })
        .collect()
}

/// A formula as plain text: `\frac{\mu g}{A_0}` is (μ g)/A₀. What is not known keeps its name.
pub fn plain_formula(latex: &str) -> String {
    let mut reader = Reader { rest: latex };
    let text = reader.until_closed();
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        // The power of a function, behind its blank.
        if large(c, HIGH).is_some() && out.ends_with(' ') {
            out.pop();
        }
        // Blanks come from several sources: one is enough.
        if !(c == ' ' && (out.is_empty() || out.ends_with([' ', '(', '[']))) {
            out.push(c);
        }
    }
    let out = out.trim_end().replace(" )", ")").replace(" ]", "]");
    out.replace(" ,", ",").replace(" ;", ";").replace(" .", ".")
}

struct Reader<'a> {
    rest: &'a str,
}

const SYMBOLS: &[(&str, &str)] = &[
    ("approx", " ≈ "),
    ("simeq", " ≃ "),
    ("sim", " ~ "),
    ("neq", " ≠ "),
    ("ne", " ≠ "),
    ("leq", " ≤ "),
    ("le", " ≤ "),
    ("geq", " ≥ "),
    ("ge", " ≥ "),
    ("ll", " ≪ "),
    ("gg", " ≫ "),
    ("propto", " ∝ "),
    ("equiv", " ≡ "),
    ("to", " → "),
    ("longrightarrow", " → "),
    ("Rightarrow", " ⇒ "),
    ("Longrightarrow", " ⇒ "),
    ("iff", " ⇔ "),
    ("in", " ∈ "),
    ("infty", "∞"),
    ("cdot", "·"),
    ("times", "×"),
    ("pm", "±"),
    ("mp", "∓"),
    ("int", "∫"),
    ("sum", "Σ"),
    ("ldots", "…"),
    ("cdots", "…"),
    ("dots", "…"),
    ("lvert", "|"),
    ("rvert", "|"),
    ("vert", "|"),
    ("langle", "⟨"),
    ("rangle", "⟩"),
    ("Vert", "‖"),
    ("circ", "°"),
    ("prime", "′"),
    ("lbrace", "{"),
    ("rbrace", "}"),
    ("perp", "⊥"),
    ("partial", "∂"),
    ("sphericalangle", "∠"),
    ("quad", "  "),
    ("qquad", "  "),
];

pub(super) fn symbols() -> impl Iterator<Item = &'static (&'static str, &'static str)> {
    GREEK.iter().chain(SYMBOLS)
}

const LOOKS: &[&str] = &[
    "mathrm",
    "mathfrak",
    "mathsf",
    "mathit",
    "mbox",
    "text",
    "operatorname",
];

const SILENT: &[&str] = &[
    "left",
    "right",
    "big",
    "Big",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "displaystyle",
    "tfrac",
    "limits",
    "nonumber",
    "underbrace",
    "mathbin",
    "mathrel",
    "mathopen",
    "mathclose",
];

impl Reader<'_> {
    fn until_closed(&mut self) -> String {
        let mut out = String::new();
        // Where a fraction begins of which it is not known yet whether something follows that it multiplies.
        let mut fraction = None;
        // Whether a root, or a number, would seem to take in what follows.
        let mut open = false;
        loop {
            let is_fraction = ["\\frac", "\\tfrac", "\\dfrac"]
                .iter()
                .any(|name| self.rest.trim_start().starts_with(name));
            let is_root = self.rest.trim_start().starts_with("\\sqrt");
            let Some(item) = self.item() else {
                return out;
            };
            if !item.trim().is_empty()
                && let Some(at) = fraction.take()
                && multiplies(&item)
                && !(item == "|" && bars(&out) % 2 == 1)
            {
                bracket(&mut out, at);
            }
            let function =
                item.ends_with(' ') && item.starts_with(|c: char| c.is_ascii_lowercase());
            if function && out.ends_with(|c: char| c.is_alphabetic() || is_small(c)) {
                out.push(' ');
            }
            if !item.trim().is_empty() {
                let digit = item.starts_with(|c: char| c.is_ascii_digit());
                let vulgar = FRACTIONS
                    .iter()
                    .any(|(_, known)| out.trim_end().ends_with(known));
                let factor = item.starts_with(|c: char| {
                    c.is_alphanumeric() && !is_small(c) || "√([".contains(c)
                });
                if open && factor || vulgar && digit {
                    out.truncate(out.trim_end().len());
                    out.push('·');
                }
                open = is_root;
            }
            if item.starts_with(['+', '−']) && out.ends_with(' ') && ends_a_term(out.trim_end()) {
                out.truncate(out.trim_end().len());
                self.rest = self.rest.trim_start();
            }
            if item == "|" && bars(&out).is_multiple_of(2) {
                self.rest = self.rest.trim_start();
            }
            let begins = out.len();
            out += &item;
            if is_fraction && item.contains('/') {
                match ends_with_function(&out[..begins]) {
                    true => bracket(&mut out, begins),
                    false => fraction = Some(begins),
                }
            }
        }
    }

    /// None at a closing brace, which is passed, or at the end.
    fn item(&mut self) -> Option<String> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(match c {
            '}' => return None,
            '{' => self.until_closed(),
            '\\' => self.command(),
            '_' => script(&self.argument(), "_", LOW),
            '^' => script(&self.argument(), "^", HIGH),
            '-' => "−".into(),
            '~' => " ".into(),
            '=' | '<' | '>' => format!(" {c} "),
            '&' | '\n' => " ".into(),
            ',' if self.rest.starts_with('&') => " for".into(),
            ',' => ", ".into(),
            c => c.into(),
        })
    }

    fn argument(&mut self) -> String {
        self.rest = self.rest.trim_start();
        self.item().unwrap_or_default()
    }

    fn command(&mut self) -> String {
        let letters = self.rest.find(|c: char| !c.is_ascii_alphabetic());
        let end = match letters.unwrap_or(self.rest.len()) {
            0 => self.rest.chars().next().map_or(0, char::len_utf8),
            end => end,
        };
        let (name, rest) = self.rest.split_at(end);
        self.rest = rest;
        if let Some((_, symbol)) = symbols().find(|(known, _)| *known == name) {
            return (*symbol).to_owned();
        }
        if let Some((_, mark)) = ACCENTS.iter().find(|(known, _)| *known == name) {
            let under = self.argument();
            // A unit vector is told by its hat.
            let under = match name {
                "hat" => under.chars().map(light).collect(),
                _ => under,
            };
            return format!("{under}{mark}");
        }
        match name {
            "frac" | "tfrac" | "dfrac" => {
                let (above, below) = (self.argument(), self.argument());
                let numbers = (above.trim(), below.trim());
                match FRACTIONS.iter().find(|(known, _)| *known == numbers) {
                    Some((_, vulgar)) => (*vulgar).to_owned(),
                    None => format!("{}/{}", whole(above), factor(below)),
                }
            }
            "sqrt" => format!("√{}", factor(self.argument())),
            "bm" | "boldsymbol" => self.argument().chars().map(bold).collect(),
            name if LOOKS.contains(&name) => {
                let text = self.argument();
                if text != "d" || name != "mathrm" {
                    return text;
                }
                let power = self.rest.starts_with('^').then(|| self.item());
                self.rest = self.rest.trim_start();
                text + &power.flatten().unwrap_or_default()
            }
            "begin" | "end" => {
                self.argument();
                String::new()
            }
            "\\" => "; ".into(),
            "," | ";" | ":" | " " | "!" => " ".into(),
            "{" | "}" | "%" | "|" | "$" => name.to_owned(),
            name if SILENT.contains(&name) => {
                // A point that stands for no bracket.
                self.rest = self.rest.strip_prefix('.').unwrap_or(self.rest);
                String::new()
            }
            name => format!("{name} "),
        }
    }
}

fn script(text: &str, sign: &str, among: &str) -> String {
    let signs = text.replace('−', "-");
    let digits: Option<String> = signs.chars().map(|c| small(c, among)).collect();
    match digits {
        Some(small) if !small.is_empty() => small,
        _ if text.starts_with(['·', '′']) => text.replace('·', "˙"),
        _ => format!("{sign}{}", factor(text.to_owned())),
    }
}

fn bars(text: &str) -> usize {
    text.matches('|').count()
}

fn bracket(out: &mut String, at: usize) {
    let tail = out.split_off(at);
    let (inner, blanks) = tail.split_at(tail.trim_end().len());
    *out += &format!("({inner}){blanks}");
}

fn multiplies(item: &str) -> bool {
    item.starts_with(|c: char| c.is_alphanumeric() || "√([|/".contains(c))
}

fn ends_a_term(text: &str) -> bool {
    text.ends_with(|c: char| c.is_alphanumeric() || is_mark(c) || ")]|".contains(c))
        && !ends_with_function(text)
}

fn ends_with_function(text: &str) -> bool {
    let word = text
        .trim_end_matches(|c| c == ' ' || large(c, HIGH).is_some())
        .rsplit(|c: char| !c.is_ascii_alphabetic())
        .next();
    word.is_some_and(|word| FUNCTIONS.contains(&word))
}

/// In brackets unless one factor: a number, a symbol with its marks, a differential, a root, a bracket.
fn factor(term: String) -> String {
    let term = term.trim();
    match is_factor(term) {
        true => term.to_owned(),
        false => format!("({term})"),
    }
}

fn is_mark(c: char) -> bool {
    is_small(c) || "′˙".contains(c) || ('\u{300}'..'\u{370}').contains(&c)
}

fn is_factor(term: &str) -> bool {
    let symbol = |term: &str| {
        let mut rest = term.chars();
        rest.next().is_some_and(char::is_alphabetic)
            && match rest.as_str().strip_prefix('_') {
                Some(index) => index.chars().count() == 1,
                None => rest.all(is_mark),
            }
    };
    let mut depth = 0;
    let mut closed = term.char_indices().filter_map(|(i, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(i)
    });
    term.chars().all(|c| c.is_ascii_digit())
        || term.chars().count() == 1
        || symbol(term)
        || is_differential(term)
        || term
            .strip_prefix('|')
            .and_then(|of| of.strip_suffix('|'))
            .is_some_and(|of| !of.contains('|'))
        || term.strip_prefix('√').is_some_and(is_factor)
        || closed.next() == Some(term.len().wrapping_sub(1)) && term.starts_with('(')
}

fn is_differential(term: &str) -> bool {
    let power = |c: char| large(c, HIGH).is_some();
    let of = term
        .strip_prefix('d')
        .map(|of| of.trim_start_matches(power));
    of.is_some_and(is_factor)
}

fn whole(term: String) -> String {
    let term = term.trim();
    if !is_differential(term) && term.contains([' ', '+', '−', '/', '±', '=']) {
        format!("({term})")
    } else {
        term.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_read_as_one_would_type_them() {
        for (latex, plain) in [
            (
                r"\lambda_\mathrm{c}=\frac{2}{\sqrt{4+\pi^2}}",
                "λ_c = 2/√(4+π²)",
            ),
            (r"\lambda_0=\frac{\mu g}{A_0}", "λ₀ = (μ g)/A₀"),
            (r"\dot\alpha\approx1-\frac{1}{A}", "α̇ ≈ 1−1/A"),
            (
                r"\left(\tan\frac{\theta}{2}\right)^{-\lambda}",
                "(tan (θ/2))^(−λ)",
            ),
            (r"\bm{A}=-A \hat{\bm{x}}", "𝐀 = −A x̂"),
            (
                r"\lambda_\mathrm c\,\mathrm d\bm\rho/\mathrm dt",
                "λ_c d𝛒/dt",
            ),
            (
                r"m \frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-\frac{\bm v}{\vert \bm v\vert }",
                "m d²𝐫/dt² = −𝐯/|𝐯|",
            ),
            (
                r"\frac{\mathrm d (v x)}{\mathrm d t}=(\dot{\bm u} +x) -1",
                "d(v x)/dt = (𝐮̇+x)−1",
            ),
            (
                r"\begin{cases} 1,&0<x\\ -x,&x<0 \end{cases}",
                "1 for 0 < x; −x for x < 0",
            ),
            (r"\tau\to\infty", "τ → ∞"),
            (r"2^{1/4}", "2^(1/4)"),
            (r"r^{\lambda-1}", "r^(λ−1)"),
            (r"\frac{3\sqrt2}{4A}", "3√2/(4A)"),
            (r"\frac12\ln(\sqrt2\,\tau)", "½ln (√2·τ)"),
            (r"\sqrt{1+x} A+\sqrt2(1-\sigma)", "√(1+x)·A+√2·(1−σ)"),
            (r"\frac13 2^{1/4}\sqrt2/\tau", "⅓·2^(1/4)√2/τ"),
            (r"\sin^2\frac\psi2", "sin²(ψ/2)"),
            (r"\lvert v_\perp\rvert", "|v_⊥|"),
            (r"\cosh\alpha\cosh2\alpha", "cosh α cosh 2α"),
            (r"\frac76C^4+\frac7{12}", "(7/6)C⁴+7/12"),
        ] {
            assert_eq!(plain_formula(latex), plain, "{latex}");
        }
        assert_eq!(plain_words(r"if $\mu>0$, then"), "if μ > 0, then");
    }
}
