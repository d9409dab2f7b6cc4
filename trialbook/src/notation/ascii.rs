//! Plain text in the letters that every program reads.

use super::letters::{GREEK, HIGH, LOW, large, light};

/// A text in ASCII: `μg/Ω²` as `mu g/Omega^2`; what has no form there becomes a question mark.
pub fn ascii(text: &str) -> String {
    let mut out = String::new();
    let (mut raised, mut named) = (false, false);
    for c in text.chars().map(light) {
        let (high, low) = (large(c, HIGH), large(c, LOW));
        let greek = GREEK.iter().find(|(_, letter)| letter.starts_with(c));
        if named && c.is_alphabetic() {
            out.push(' ');
        }
        if high.is_some() && !raised {
            out.push('^');
        }
        (raised, named) = (high.is_some(), greek.is_some());
        let (own, mut bytes) = (high.or(low).unwrap_or(c), [0; 4]);
        out += match (c, greek) {
            ('−' | '–', _) => "-",
            ('√', _) => "sqrt",
            ('·' | '×', _) => "*",
            ('≤', _) => "<=",
            ('≥', _) => ">=",
            ('…', _) => "...",
            ('°', _) => "deg",
            ('∞', _) => "infinity",
            (_, Some((name, _))) => name,
            _ if own.is_ascii() => own.encode_utf8(&mut bytes),
            _ => "?",
        };
    }
    out
}
