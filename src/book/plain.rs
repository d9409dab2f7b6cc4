//! Plain words for HTML: indices, powers and numbers as a printer sets them.

use super::text::{escape, scientific};

/// Words with indices such as `v_x`, powers such as `x^2`, numbers such as `1e-12` and minus signs, as HTML.
pub(super) fn set(text: &str) -> String {
    let mut out = String::with_capacity(text.len() * 2);
    let (mut before, mut rest) = (None, text);
    while !rest.is_empty() {
        let plain = rest.find(|c: char| c.is_ascii_digit() || "_^-=".contains(c));
        let length = match plain.unwrap_or(rest.len()) {
            0 => match special(before, rest) {
                Some((html, length)) => {
                    // An equation such as `g = 9.8` is not torn at the end of a line.
                    if html.starts_with('\u{a0}') {
                        out.pop();
                    }
                    out.push_str(&html);
                    length
                }
                None => {
                    let length = number(rest).max(1);
                    out.push_str(&rest[..length]);
                    length
                }
            },
            length => {
                out.push_str(&escape(&rest[..length]));
                length
            }
        };
        before = rest[..length].chars().last();
        rest = &rest[length..];
    }
    out
}

/// The length of the number without a sign with which a text begins.
fn number(text: &str) -> usize {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.');
    end.unwrap_or(text.len())
}

/// What the text begins with, if it is more than its letters, as HTML, and its length.
fn special(before: Option<char>, text: &str) -> Option<(String, usize)> {
    let part_of_word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let after = &text[1..];
    match text.chars().next()? {
        '_' => {
            let mut letters = after.chars();
            let index = letters.next().filter(|c| c.is_alphanumeric())?;
            let next = letters.next();
            let ends = !next.is_some_and(|c| c.is_alphabetic() || c.is_ascii_digit() || c == '_');
            let fits = ends && before.is_some_and(char::is_alphabetic);
            fits.then(|| (format!("<sub>{index}</sub>"), 1 + index.len_utf8()))
        }
        '^' => {
            let length = exponent(after)?;
            let inside = after[..length].strip_prefix('(');
            let inside = inside.and_then(|inside| inside.strip_suffix(')'));
            let html = set(inside.unwrap_or(&after[..length]));
            Some((format!("<sup>{html}</sup>"), 1 + length))
        }
        '-' => {
            let sign = before.is_none_or(|c| " \u{a0}([=,/".contains(c));
            (sign && number(after) > 0).then(|| ("−".into(), 1))
        }
        '=' => {
            let value = after.strip_prefix(' ')?;
            let value = value.strip_prefix(['-', '−']).unwrap_or(value);
            (before == Some(' ') && number(value) > 0).then(|| ("\u{a0}=\u{a0}".into(), 2))
        }
        _ => {
            let mantissa = number(text);
            let power = text[mantissa..].strip_prefix('e')?;
            let digits = number(power.strip_prefix('-').unwrap_or(power));
            let length = power.len() - power.trim_start_matches('-').len() + digits;
            let whole = !part_of_word(before) && !part_of_word(power[length..].chars().next());
            let end = mantissa + 1 + length;
            (digits > 0 && whole).then(|| (scientific(&text[..end]), end))
        }
    }
}

/// The length of an exponent: what stands in brackets, a number, or a letter.
fn exponent(text: &str) -> Option<usize> {
    if text.starts_with('(') {
        let mut depth = 0;
        return text.char_indices().find_map(|(i, c)| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            (depth == 0).then_some(i + 1)
        });
    }
    let digits = text.strip_prefix('-').unwrap_or(text);
    let length = digits.find(|c: char| !c.is_ascii_digit());
    match length.unwrap_or(digits.len()) {
        0 => text
            .chars()
            .next()
            .filter(|c| c.is_alphabetic())
            .map(char::len_utf8),
        length => Some(text.len() - digits.len() + length),
    }
}

#[cfg(test)]
mod tests {
    use super::set;

    #[test]
    fn plain_mathematics_is_set() {
        for (plain, html) in [
            (
                "dv_x/dt, (q_Y)² & 𝔴_y.",
                "dv<sub>x</sub>/dt, (q<sub>Y</sub>)² &amp; 𝔴<sub>y</sub>.",
            ),
            ("eq20_stop_time, _x", "eq20_stop_time, _x"),
            (
                "A/t^(3/2): x^2, b^10)",
                "A/t<sup>3/2</sup>: x<sup>2</sup>, b<sup>10</sup>)",
            ),
            (
                "u^(a_x^(−1)), r^λ, z^-4",
                "u<sup>a<sub>x</sub><sup>−1</sup></sup>, r<sup>λ</sup>, z<sup>−4</sup>",
            ),
            ("x^, y^(z", "x^, y^(z"),
            (
                "to 1e-12, 3.20e-1, 1.0e0",
                "to 10<sup>−12</sup>, 3.2\u{a0}×\u{a0}10<sup>−1</sup>, 1",
            ),
            ("1e5 of 2e", "10<sup>5</sup> of 2e"),
            ("a1e-5, s2-x, 3-4", "a1e-5, s2-x, 3-4"),
            (
                "g = 9.81, θ = -2.5 at a = b",
                "g\u{a0}=\u{a0}9.81, θ\u{a0}=\u{a0}−2.5 at a = b",
            ),
            ("(-1) is -1", "(−1) is −1"),
        ] {
            assert_eq!(set(plain), html);
        }
    }
}
