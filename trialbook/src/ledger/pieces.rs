//! Our own plain words, taken apart: indices, powers and numbers, for those who set them in HTML or LaTeX.

/// A piece of plain words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Piece<'a> {
    /// What stands as it is.
    Text(&'a str),
    /// The `x` of `v_x`.
    Index(char),
    /// The exponent of a power such as `x^2` or `x^(3/2)`, without its brackets.
    Power(&'a str),
    /// The minus sign of a number.
    Minus,
    /// The sign in an equation such as `g = 9.8`, which is not torn at the end of a line: the blank after it belongs to it,
    /// the one before it to the text before it.
    Equals,
    /// A number such as `1e-12`.
    Scientific(&'a str),
}

/// The pieces of plain words.
pub fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut out = Vec::new();
    let (mut before, mut rest) = (None, text);
    while !rest.is_empty() {
        let plain = rest.find(|c: char| c.is_ascii_digit() || "_^-=".contains(c));
        let (piece, length) = match plain.unwrap_or(rest.len()) {
            0 => special(before, rest).unwrap_or_else(|| {
                let length = number(rest).max(1);
                (Piece::Text(&rest[..length]), length)
            }),
            length => (Piece::Text(&rest[..length]), length),
        };
        out.push(piece);
        before = rest[..length].chars().last();
        rest = &rest[length..];
    }
    out
}

/// A number such as `2.3e2` or `1e-2` as a decimal, if it is so near to one that no power of ten is needed.
pub fn decimal(scientific: &str) -> Option<String> {
    let exponent = scientific.split_once('e').map_or("0", |(_, e)| e);
    let near = ["-2", "-1", "0", "1", "2"].contains(&exponent);
    let number: f64 = scientific.parse().ok().filter(|_| near)?;
    Some(number.to_string())
}

/// The length of the number without a sign with which a text begins.
fn number(text: &str) -> usize {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.');
    end.unwrap_or(text.len())
}

/// What the text begins with, if it is more than its letters, and its length.
fn special(before: Option<char>, text: &str) -> Option<(Piece<'_>, usize)> {
    let part_of_word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let after = &text[1..];
    match text.chars().next()? {
        '_' => {
            let mut letters = after.chars();
            let index = letters.next().filter(|c| c.is_alphanumeric())?;
            let next = letters.next();
            let ends = !next.is_some_and(|c| c.is_alphabetic() || c.is_ascii_digit() || c == '_');
            let fits = ends && before.is_some_and(char::is_alphabetic);
            fits.then_some((Piece::Index(index), 1 + index.len_utf8()))
        }
        '^' => {
            let length = exponent(after)?;
            let inside = after[..length].strip_prefix('(');
            let inside = inside.and_then(|inside| inside.strip_suffix(')'));
            Some((Piece::Power(inside.unwrap_or(&after[..length])), 1 + length))
        }
        '-' => {
            let sign = before.is_none_or(|c| " \u{a0}([=,/".contains(c));
            (sign && number(after) > 0).then_some((Piece::Minus, 1))
        }
        '=' => {
            let value = after.strip_prefix(' ')?;
            let value = value.strip_prefix(['-', '−']).unwrap_or(value);
            (before == Some(' ') && number(value) > 0).then_some((Piece::Equals, 2))
        }
        _ => {
            let mantissa = number(text);
            let power = text[mantissa..].strip_prefix('e')?;
            let digits = number(power.strip_prefix('-').unwrap_or(power));
            let length = power.len() - power.trim_start_matches('-').len() + digits;
            let whole = !part_of_word(before) && !part_of_word(power[length..].chars().next());
            let end = mantissa + 1 + length;
            (digits > 0 && whole).then_some((Piece::Scientific(&text[..end]), end))
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
