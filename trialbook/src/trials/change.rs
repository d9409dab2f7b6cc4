//! What a correction changes, told by what differs.

use crate::evidence::Change;

impl Change {
    /// What differs between two statements in LaTeX: signs; letters or numbers added to a product; a word or
    /// letter; or more.
    ///
    /// ```
    /// use trialbook::evidence::Change;
    ///
    /// assert_eq!(Change::between("a+b", "a-b"), Change::Sign);
    /// assert_eq!(Change::between("g s", r"\mu g s"), Change::Factor);
    /// assert_eq!(Change::between("v=1", "u=1"), Change::Symbol);
    /// assert_eq!(Change::between("v=1", r"v=\frac{u}{2}"), Change::Statement);
    /// ```
    pub fn between(old: &str, new: &str) -> Self {
        let [a, b] = [old, new].map(pieces);
        let sign = |piece: &&String| ["+", "-"].contains(&piece.as_str());
        let unsigned = |of: &[String]| of.iter().filter(|p| !sign(p)).cloned().collect::<Vec<_>>();
        if a != b && unsigned(&a) == unsigned(&b) {
            return Self::Sign;
        }
        let mut left = a.iter().peekable();
        let added: Vec<_> = b
            .iter()
            .filter(|piece| left.next_if_eq(piece).is_none())
            .collect();
        let factor =
            |piece: &&String| piece.starts_with('\\') || piece.chars().all(char::is_alphanumeric);
        if left.next().is_none() && !added.is_empty() && added.iter().all(factor) {
            return Self::Factor;
        }
        let [a, b] = [(old, a), (new, b)].map(|(text, pieces)| match text.contains('$') {
            true => text.split(' ').map(str::to_owned).collect(),
            false => pieces,
        });
        let other = a.iter().zip(&b).filter(|(a, b)| a != b).count();
        match a.len() == b.len() && other == 1 {
            true => Self::Symbol,
            false => Self::Statement,
        }
    }
}

/// Without brackets: a letter with what stands below it is one. What a formula defines beside itself does not
/// count.
fn pieces(text: &str) -> Vec<String> {
    let parts = match text.contains('$') {
        true => text.split('$').skip(1).step_by(2).collect(),
        false => text.split(",\\quad").take(1).collect::<Vec<_>>(),
    };
    let mut pieces: Vec<String> = Vec::new();
    for part in parts {
        let mut rest = part;
        while let Some(first) = rest.chars().next() {
            let length = match first {
                '\\' => {
                    let letter = |c: char| c.is_ascii_alphabetic();
                    let name = rest[1..].find(|c| !letter(c)).unwrap_or(rest.len() - 1);
                    1 + name.max(1)
                }
                _ => first.len_utf8(),
            };
            let piece = &rest[..length];
            match pieces.last_mut() {
                Some(last) if piece == "_" || last.ends_with('_') => last.push_str(piece),
                _ if [r"\left", r"\right"].contains(&piece) || "{}()[] ".contains(piece) => {}
                _ => pieces.push(piece.to_owned()),
            }
            rest = &rest[length..];
        }
    }
    pieces
}
