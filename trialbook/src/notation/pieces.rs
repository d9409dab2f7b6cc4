//! Our own plain words, taken apart: formulas and numbers.

use super::latex::formula;

/// A piece of plain words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece<'a> {
    /// What stands as it is.
    Text(&'a str),
    /// A formula such as `v_x/R = 2`, as LaTeX; one side of it, if it is long.
    Formula(String),
    /// The minus sign of a number.
    Minus,
    /// A number such as `1e-12`.
    Scientific(&'a str),
}

/// The pieces of plain words.
pub fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut out = Vec::new();
    let (mut before, mut rest) = (None, text);
    while let Some(c) = rest.chars().next() {
        let boundary = before.is_none_or(|c: char| " \u{a0}\n([“\"—".contains(c));
        let read = (boundary || !c.is_ascii()).then(|| formula(rest)).flatten();
        let length = if let Some((sides, length)) = read {
            for (i, side) in sides.into_iter().enumerate() {
                if i > 0 {
                    out.push(Piece::Text(" "));
                }
                out.push(Piece::Formula(side));
            }
            length
        } else if let Some((piece, length)) = special(before, rest) {
            out.push(piece);
            length
        } else {
            let length = number(rest).max(c.len_utf8());
            out.push(Piece::Text(&rest[..length]));
            length
        };
        before = rest[..length].chars().last();
        rest = &rest[length..];
    }
    out
}

/// A number such as `2.3e2` or `1e-2` as a decimal, if that needs no power of ten.
pub fn decimal(scientific: &str) -> Option<String> {
    let exponent = scientific.split_once('e').map_or("0", |(_, e)| e);
    let near = ["-2", "-1", "0", "1", "2"].contains(&exponent);
    let number: f64 = scientific.parse().ok().filter(|_| near)?;
    Some(number.to_string())
}

fn number(text: &str) -> usize {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.');
    end.unwrap_or(text.len())
}

/// If it is a number that is more than its digits; and its length.
fn special(before: Option<char>, text: &str) -> Option<(Piece<'_>, usize)> {
    let part_of_word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    if let Some(after) = text.strip_prefix('-') {
        let sign = before.is_none_or(|c| " \u{a0}([=,/".contains(c));
        return (sign && number(after) > 0).then_some((Piece::Minus, 1));
    }
    let mantissa = number(text);
    let power = text[mantissa..].strip_prefix('e')?;
    let digits = number(power.strip_prefix('-').unwrap_or(power));
    let length = power.len() - power.trim_start_matches('-').len() + digits;
    let whole = !part_of_word(before) && !part_of_word(power[length..].chars().next());
    let end = mantissa + 1 + length;
    (mantissa > 0 && digits > 0 && whole).then_some((Piece::Scientific(&text[..end]), end))
}
