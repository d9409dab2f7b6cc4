//! Text and numbers for HTML.

pub(super) use crate::ledger::{count, counted};
use crate::notation::{decimal, word};

/// Data as text in HTML, on one line.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\n' | '\r' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

pub(super) fn in_code(text: &str) -> String {
    format!("<code>{}</code>", escape(text))
}

/// `write` says what stands for each mark and what follows it, up to the next.
pub(super) fn after_each(
    text: &str,
    mark: &str,
    mut write: impl FnMut(&str, &mut String),
) -> String {
    let mut parts = text.split(mark);
    let mut out = parts.next().unwrap_or_default().to_owned();
    parts.for_each(|part| write(part, &mut out));
    out
}

pub(super) fn without(text: &str, open: &str, close: &str) -> String {
    after_each(text, open, |part, out| {
        *out += part.split_once(close).map_or("", |(_, after)| after);
    })
}

pub(super) fn unescape(html: &str) -> String {
    after_each(html, "&", |part, out| {
        let reference = part.split_once(';').and_then(|(name, after)| {
            let c = match name {
                "amp" => '&',
                "lt" => '<',
                "gt" => '>',
                "quot" => '"',
                "nbsp" => '\u{a0}',
                name => {
                    let number = name.strip_prefix('#')?;
                    let number = match number.strip_prefix('x') {
                        Some(hex) => u32::from_str_radix(hex, 16),
                        None => number.parse(),
                    };
                    char::from_u32(number.ok()?)?
                }
            };
            Some((c, after))
        });
        match reference {
            Some((c, after)) => {
                out.push(c);
                *out += after;
            }
            None => out.extend(["&", part]),
        }
    })
}

pub(super) fn in_words(n: usize) -> String {
    word(n).map_or_else(|| count(n), str::to_owned)
}

const FUNCTIONS: &[&str] = &["sin", "cos", "tan", "exp", "ln", "min", "max"];

pub(super) fn sentence(phrase: &str) -> String {
    let phrase = phrase.trim().trim_end_matches('.');
    let end = phrase.find(|c: char| !c.is_alphabetic());
    let word = &phrase[..end.unwrap_or(phrase.len())];
    // A symbol or a function stays as it is: `v(t)`, `pξ`, `sin φ`.
    let is_word = word == "a" || word.len() > 1 && word.is_ascii() && !FUNCTIONS.contains(&word);
    let mut letters = phrase.chars();
    match letters.next() {
        Some(first) if is_word => first.to_uppercase().chain(letters).collect(),
        _ => phrase.to_owned(),
    }
}

/// The first two digits matter.
pub(super) fn size(x: f64) -> String {
    if x == 0.0 {
        "0".into()
    } else if x.is_nan() {
        "no number".into()
    } else if x.is_infinite() {
        "∞".into()
    } else {
        power_of_ten(&format!("{x:.1e}"))
    }
}

/// Twelve digits.
pub(super) fn value(x: f64) -> String {
    if x.is_nan() {
        return "no value".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞" } else { "−∞" }.into();
    }
    let scientific = format!("{x:.11e}");
    let exponent = scientific.split_once('e');
    match exponent.and_then(|(_, e)| e.parse::<i32>().ok()) {
        _ if x == 0.0 => "0".into(),
        Some(e @ -4..=5) => {
            let decimals = usize::try_from(11 - e).unwrap_or(0);
            trimmed(&format!("{x:.decimals$}")).replace('-', "−")
        }
        _ => power_of_ten(&scientific),
    }
}

/// `3.20e-13` as 3.2 × 10⁻¹³ and `1e-13` as 10⁻¹³, as in running text.
pub(super) fn scientific(number: &str) -> String {
    let html = power_of_ten(number);
    let bare = html.strip_prefix("1\u{a0}×\u{a0}").map(str::to_owned);
    bare.unwrap_or(html)
}

/// `3.20e-13` as 3.2 × 10⁻¹³, `3.20e-1` as 0.32.
fn power_of_ten(scientific: &str) -> String {
    if let Some(decimal) = decimal(scientific) {
        return decimal.replace('-', "−");
    }
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((scientific, "0"));
    let mantissa = trimmed(mantissa).replace('-', "−");
    format!(
        "{mantissa}\u{a0}×\u{a0}10<sup>{}</sup>",
        exponent.replace('-', "−")
    )
}

fn trimmed(decimal: &str) -> &str {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.')
    } else {
        decimal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_they_should() {
        assert_eq!(count(0), "0");
        assert_eq!(count(999), "999");
        assert_eq!(count(1000), "1,000");
        assert_eq!(count(1_234_567), "1,234,567");
        assert_eq!(in_words(12), "twelve");
        assert_eq!(in_words(1300), "1,300");
        assert_eq!(counted(1, "point"), "1 point");
        assert_eq!(size(3.21e-13), "3.2\u{a0}×\u{a0}10<sup>−13</sup>");
        assert_eq!(size(1e-10), "1\u{a0}×\u{a0}10<sup>−10</sup>");
        assert_eq!(size(2.0), "2");
        assert_eq!(size(0.034), "0.034");
        assert_eq!(size(230.0), "230");
        assert_eq!(size(2300.0), "2.3\u{a0}×\u{a0}10<sup>3</sup>");
        assert_eq!(size(f64::INFINITY), "∞");
        assert_eq!(value(0.1 + 0.2), "0.3");
        assert_eq!(value(-1234.5), "−1234.5");
        assert_eq!(value(1.5e-7), "1.5\u{a0}×\u{a0}10<sup>−7</sup>");
        assert_eq!(value(100.0), "100");
        assert_eq!(value(f64::NAN), "no value");
    }

    #[test]
    fn a_sentence_begins_with_a_capital_but_a_symbol_stays() {
        assert_eq!(sentence("the speed."), "The speed");
        assert_eq!(sentence("a constant"), "A constant");
        assert_eq!(sentence("v(t) of (11)"), "v(t) of (11)");
        assert_eq!(sentence("$v$ at rest"), "$v$ at rest");
        assert_eq!(sentence("sin of (27)"), "sin of (27)");
        assert_eq!(sentence("sine of (27)"), "Sine of (27)");
        assert_eq!(sentence("pξ, by components"), "pξ, by components");
        assert_eq!(sentence(""), "");
    }

    #[test]
    fn data_cannot_become_markup() {
        assert_eq!(
            escape("<b a=\"'\">&\n"),
            "&lt;b a=&quot;&#39;&quot;&gt;&amp; "
        );
        assert_eq!(
            unescape("&lt;b a=&quot;&#39;&quot;&gt;&amp; &x2; a&#x3c;"),
            "<b a=\"'\">& &x2; a<"
        );
    }
}
