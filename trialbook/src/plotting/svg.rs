//! The last step: numbers, words and colours as SVG text.

/// At most two decimals, never `-0`; `0` for what is not finite.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() {
        return "0".into();
    }
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}

/// Between tags or in a quoted attribute; characters that XML forbids are dropped.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(' '),
            c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => {}
            c => out.push(c),
        }
    }
    out
}

/// Each at least 3 : 1 against white and against `#1e1e1e`.
pub(super) const PALETTE: [&str; 6] = [
    "#2a7ab8", "#d1601f", "#1c8f63", "#9a63c2", "#a07a10", "#c74d86",
];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Colour {
    Ink,
    Series(usize),
}

impl Colour {
    pub(super) fn css(self) -> String {
        match self {
            Colour::Ink => "currentColor".into(),
            Colour::Series(n) => {
                let n = n % PALETTE.len();
                format!("var(--fig-{}, {})", n + 1, PALETTE[n])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_have_no_negative_zero() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.004, "0"),
            (-0.006, "-0.01"),
            (12.0, "12"),
            (100.0, "100"),
            (1.005_1, "1.01"),
            (2.5, "2.5"),
        ] {
            assert_eq!(number(value), text, "{value}");
        }
    }

    #[test]
    fn no_character_breaks_the_markup() {
        assert_eq!(
            escape("a<b & \"c\"\u{7}\n>"),
            "a&lt;b &amp; &quot;c&quot; &gt;"
        );
    }

    /// As the Web Content Accessibility Guidelines define it.
    fn luminance(hex: &str) -> f64 {
        let channel = |at: usize| {
            let value = f64::from(u8::from_str_radix(&hex[at..at + 2], 16).unwrap()) / 255.0;
            if value <= 0.04045 {
                value / 12.92
            } else {
                libm::pow((value + 0.055) / 1.055, 2.4)
            }
        };
        0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
    }

    #[test]
    fn every_colour_is_legible_in_light_and_in_dark() {
        for colour in PALETTE {
            for page in ["#ffffff", "#1e1e1e"] {
                let (a, b) = (luminance(colour), luminance(page));
                let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
                assert!(contrast >= 3.0, "{colour} on {page}: {contrast}");
            }
        }
    }
}
