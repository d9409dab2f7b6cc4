//! Indices and powers in our plain notation.

use super::{
    super::letters::{HIGH, LOW, large},
    Factor, Reader, command,
};

impl Reader<'_> {
    /// Nothing if it is a name of the code.
    pub(super) fn scripts(&mut self, factor: Factor) -> Option<Factor> {
        let Factor {
            mut latex,
            mut inside,
            simple,
        } = factor;
        loop {
            let script = if self.skip("_") {
                format!("_{{{}}}", self.index()?)
            } else if let Some(low) = self.low() {
                format!("_{{{low}}}")
            } else if let Some(high) = self.high() {
                format!("^{{{high}}}")
            } else if self.rest.starts_with(['\'', '′']) {
                self.rest = &self.rest[self.peek().map_or(0, char::len_utf8)..];
                "'".into()
            } else if let Some(power) = self.attempt(Self::power) {
                self.mathematical = true;
                format!("^{{{power}}}")
            } else {
                return Some(Factor {
                    latex,
                    inside,
                    simple,
                });
            };
            inside = None;
            latex += &script;
        }
    }

    fn index(&mut self) -> Option<String> {
        let c = self.peek()?;
        self.rest = &self.rest[c.len_utf8()..];
        self.mathematical = true;
        let ends = !self
            .peek()
            .is_some_and(|c| c.is_ascii_alphanumeric() || c == '_');
        ends.then_some(())?;
        match c {
            'x' | 'y' | 'z' | '0'..='9' => Some(c.into()),
            c if c.is_ascii_alphabetic() => Some(format!(r"\mathrm {c}")),
            c => command(c),
        }
    }

    fn run(&mut self, among: &str) -> Option<String> {
        let mut run = String::new();
        while let Some(large) = self.peek().and_then(|c| large(c, among)) {
            run.push(large);
            self.rest = &self.rest[self.peek().map_or(0, char::len_utf8)..];
        }
        self.mathematical |= !run.is_empty();
        (!run.is_empty()).then_some(run)
    }

    pub(super) fn high(&mut self) -> Option<String> {
        self.run(HIGH)
    }

    /// The `y` of `v₀y` belongs to it.
    fn low(&mut self) -> Option<String> {
        let mut low = self.run(LOW)?;
        let mut next = self.rest.chars();
        if let (Some(c @ ('x' | 'y')), after) = (next.next(), next.next())
            && !after.is_some_and(char::is_alphanumeric)
        {
            low.push(c);
            self.rest = &self.rest[1..];
        }
        Some(low)
    }

    pub(super) fn power(&mut self) -> Option<String> {
        self.skip("^").then_some(())?;
        let sign = if self.skip("-") || self.skip("−") {
            "-"
        } else {
            ""
        };
        let power = match self.peek()? {
            '(' => self.group('(', ')', true)?.bare(),
            c if c.is_ascii_digit() => self.number()?.latex,
            _ => self.symbol()?,
        };
        Some(format!("{sign}{power}"))
    }
}
