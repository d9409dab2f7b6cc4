//! The factors of a formula in our plain notation.

use super::{
    super::letters::{ACCENTS, FUNCTIONS, is_small},
    Factor, Reader, command,
};

pub(super) fn is_letter(c: char) -> bool {
    !c.is_ascii() && !is_small(c) && (c.is_alphabetic() || "∞Σ½⅓¼".contains(c))
}

pub(super) fn is_differential(latex: &str) -> bool {
    latex.starts_with(r"\mathrm d") || latex.starts_with(r"\partial")
}

impl Reader<'_> {
    pub(super) fn factor(&mut self) -> Option<Factor> {
        self.deeper(Self::any_factor)
    }

    fn any_factor(&mut self) -> Option<Factor> {
        let c = self.peek()?;
        let factor = match c {
            c if c.is_ascii_digit() => self.number()?,
            '(' => self.group('(', ')', false)?,
            '[' => self.group('[', ']', true)?,
            '⟨' => self.group('⟨', '⟩', true)?,
            '|' => {
                self.skip("|");
                let inside = self.sum()?;
                self.skip("|").then_some(())?;
                Factor::simple(format!(r"\lvert {inside}\rvert "))
            }
            '√' => {
                self.skip("√");
                self.mathematical = true;
                let under = match self.peek()? {
                    '(' => self.group('(', ')', true)?,
                    '√' => self.factor()?,
                    c if c.is_ascii_digit() => self.number()?,
                    _ => Factor::simple(self.symbol()?),
                };
                Factor::simple(format!(r"\sqrt{{{}}}", under.bare()))
            }
            '…' => {
                self.skip("…");
                Factor::simple(r"\ldots ".into())
            }
            _ => self.read_named()?,
        };
        self.scripts(factor)
    }

    fn read_named(&mut self) -> Option<Factor> {
        let letters = self.rest.find(|c: char| !c.is_ascii_alphabetic());
        let word = &self.rest[..letters.unwrap_or(self.rest.len())];
        if let Some(name) = FUNCTIONS.iter().find(|name| **name == word) {
            self.skip(name);
            return self.function(name);
        }
        match self.attempt(Self::differential) {
            Some(differential) => Some(Factor::simple(differential)),
            None => Some(Factor::simple(self.symbol()?)),
        }
    }

    fn function(&mut self, name: &str) -> Option<Factor> {
        self.mathematical = true;
        let mut power = self.high().map_or(String::new(), |p| format!("^{{{p}}}"));
        let argument = if self.rest.starts_with('(') {
            let argument = self.group('(', ')', true)?.latex;
            // Behind an exponential a power is plain enough, and a negative one is no inverse function.
            if name != "exp" && power.is_empty() && !self.rest.starts_with("^(−") {
                let own = self.attempt(Self::power);
                power = own.map_or(power, |own| format!("^{{{own}}}"));
            }
            argument
        } else {
            let spaced = self.skip(" ");
            if power.is_empty() && !spaced {
                return None;
            }
            let mut argument = self.factor()?.latex;
            while let Some(next) = self.attempt(|r| {
                let c = r.peek()?;
                (c.is_ascii_alphabetic() || is_letter(c)).then_some(())?;
                r.factor()
            }) {
                argument = format!("{argument} {}", next.latex);
            }
            argument
        };
        Some(Factor {
            latex: format!(r"\{name}{power} {argument}"),
            inside: None,
            simple: false,
        })
    }

    /// `dv_x/dt`, `d²x`, `∂A/∂σ`.
    fn differential(&mut self) -> Option<String> {
        let (sign, latex) = match self.peek()? {
            'd' => ("d", r"\mathrm d"),
            '∂' => ("∂", r"\partial "),
            _ => return None,
        };
        let one = |r: &mut Self| {
            let word = r.rest.find(|c: char| !c.is_ascii_alphabetic());
            let word = &r.rest[..word.unwrap_or(r.rest.len())];
            if word.len() > sign.len() + 1 || word == "do" || !r.skip(sign) {
                return None;
            }
            let order = r
                .high()
                .map_or(String::new(), |order| format!("^{{{order}}}"));
            let of = match r.peek()? {
                '(' => r.group('(', ')', true)?,
                _ => Factor::simple(r.symbol()?),
            };
            let of = r.scripts(of)?.latex;
            Some(format!("{latex}{order}{of}"))
        };
        let above = one(self)?;
        self.mathematical = true;
        let below = self.attempt(|r| {
            r.skip("/").then_some(())?;
            one(r)
        });
        Some(match below {
            Some(below) => format!("{above}/{below}"),
            None => above,
        })
    }

    /// With its accents; none if it belongs to a word or to a name of the code.
    pub(super) fn symbol(&mut self) -> Option<String> {
        let c = self.peek()?;
        let after = &self.rest[c.len_utf8()..];
        let mut latex = if c.is_ascii_alphabetic() {
            let mut next = after.chars();
            match (next.next(), next.next()) {
                (Some(c), _) if c.is_ascii_alphanumeric() => return None,
                (Some('-' | '\'' | '’' | '.'), Some(c)) if c.is_alphabetic() => return None,
                _ => {}
            }
            self.mathematical |= c.is_ascii_lowercase() && c != 'a';
            c.to_string()
        } else {
            is_letter(c).then_some(())?;
            self.mathematical = true;
            command(c)?
        };
        self.rest = after;
        while let Some((set, accent)) = ACCENTS.iter().find(|(_, c)| self.rest.starts_with(*c)) {
            latex = format!(r"\{set}{{{latex}}}");
            self.rest = &self.rest[accent.len_utf8()..];
        }
        Some(latex)
    }

    pub(super) fn number(&mut self) -> Option<Factor> {
        let digits = |text: &str| {
            let end = text.find(|c: char| !c.is_ascii_digit());
            end.unwrap_or(text.len())
        };
        let mut length = digits(self.rest);
        if let Some(decimals) = self.rest[length..].strip_prefix('.') {
            length += match digits(decimals) {
                0 => 0,
                decimals => 1 + decimals,
            };
        }
        let (number, rest) = self.rest.split_at(length);
        let power = rest.strip_prefix('e').map(|power| {
            let sign = usize::from(power.starts_with('-'));
            (digits(&power[sign..]) > 0).then(|| power.split_at(sign + digits(&power[sign..])))
        });
        let latex = match power.flatten() {
            Some((power, rest)) => {
                self.rest = rest;
                match number {
                    "1" => format!("10^{{{power}}}"),
                    _ => format!(r"{number}\times10^{{{power}}}"),
                }
            }
            None => {
                self.rest = rest;
                number.to_owned()
            }
        };
        Some(Factor::simple(latex))
    }

    /// The number of an equation only if `any` number will do.
    pub(super) fn group(&mut self, open: char, close: char, any: bool) -> Option<Factor> {
        let before = self.rest;
        self.rest = self.rest.strip_prefix(open)?;
        let mut inside = self.deeper(Self::sides)?.join(" ");
        let mut list = false;
        while self.skip(", ") {
            list = true;
            inside = format!("{inside}, {}", self.deeper(Self::sides)?.join(" "));
        }
        self.rest = self.rest.strip_prefix(close)?;
        let number = inside.chars().all(|c| c.is_ascii_digit());
        (any || !number || before.len() == self.rest.len()).then_some(())?;
        let brackets = match open {
            '⟨' => [r"\langle ", r"\rangle "].map(str::to_owned),
            _ => [open, close].map(String::from),
        };
        let [left, right] = match inside.contains(r"\frac") {
            true => [
                format!(r"\left{}", brackets[0]),
                format!(r"\right{}", brackets[1]),
            ],
            false => brackets,
        };
        Some(Factor {
            latex: format!("{left}{inside}{right}"),
            inside: (open == '(' && !list).then_some(inside),
            simple: false,
        })
    }
}
