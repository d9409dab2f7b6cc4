//! Slips of the pen: every text that differs from a LaTeX text in one place.

/// Each for the one behind it.
const TAKEN: &str = r"- + + - = < < > > < \sin \cos \cos \sin \tan \cot \cot \tan \sinh \cosh \cosh \sinh \tanh \coth \coth \tanh
    \ln \exp \cdot \times \times \cdot \dot \ddot \ddot \dot \approx = \simeq = \sim = \leq \geq";

const NAMES: &str = r"\alpha \beta \gamma \zeta \eta \theta \kappa \lambda \mu \nu \xi \pi \rho \sigma \tau \phi \psi \omega \Omega
    \varpi \ell";

/// A letter in their argument is no name.
const WORDS: [&str; 4] = [r"\text", r"\mbox", r"\begin", r"\end"];

/// Commands, whole numbers, characters; words in braces belong to their command.
pub fn pieces(latex: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(first) = latex[at..].chars().next() {
        let rest = &latex[at..];
        let while_all = |skip: usize, all: fn(char) -> bool| {
            let end = rest[skip..].find(|c: char| !all(c));
            end.map_or(rest.len(), |end| skip + end)
        };
        let mut len = match first {
            '\\' => while_all(1, |c| c.is_ascii_alphabetic()).max(2),
            '0'..='9' => while_all(0, |c| c.is_ascii_digit()),
            _ => first.len_utf8(),
        };
        if WORDS.contains(&&rest[..len]) {
            len = rest.find('}').map_or(rest.len(), |end| end + 1);
        }
        found.push((at, &rest[..len]));
        at += len;
    }
    found
}

/// A number one more, a sign or function for the one it is taken for, a name for the next one of the text.
pub fn mistakes(latex: &str) -> Vec<String> {
    let pieces = pieces(latex);
    let name = |piece: &str| {
        NAMES.split_whitespace().any(|name| name == piece)
            || piece.len() == 1 && piece.starts_with(|c: char| c.is_ascii_alphabetic())
    };
    let names: Vec<&str> = pieces
        .iter()
        .map(|(_, piece)| *piece)
        .filter(|p| name(p))
        .collect();
    let instead = |piece: &str| {
        if let Ok(number) = piece.parse::<u64>() {
            return Some((number + 1).to_string());
        }
        if name(piece) {
            let after = names.iter().skip_while(|n| **n != piece);
            let other = after.chain(&names).find(|n| **n != piece)?;
            // A command ends where a letter begins.
            return Some(format!("{other} "));
        }
        let taken: Vec<&str> = TAKEN.split_whitespace().collect();
        let [_, other] = taken.chunks(2).find(|pair| pair[0] == piece)? else {
            return None;
        };
        Some(format!("{other} "))
    };
    let changed = |(at, piece): &(usize, &str)| {
        let end = at + piece.len();
        Some([&latex[..*at], &instead(piece)?, &latex[end..]].concat())
    };
    pieces.iter().filter_map(changed).collect()
}

#[test]
fn every_place_of_a_text_is_changed() {
    let expected = [
        r"b =\frac{\mathrm{d}b}{2}-\sin 3 \text{x 1}",
        r"a<\frac{\mathrm{d}b}{2}-\sin 3 \text{x 1}",
        r"a=\frac{\mathrm{b }b}{2}-\sin 3 \text{x 1}",
        r"a=\frac{\mathrm{d}a }{2}-\sin 3 \text{x 1}",
        r"a=\frac{\mathrm{d}b}{3}-\sin 3 \text{x 1}",
        r"a=\frac{\mathrm{d}b}{2}+\sin 3 \text{x 1}",
        r"a=\frac{\mathrm{d}b}{2}-\cos 3 \text{x 1}",
        r"a=\frac{\mathrm{d}b}{2}-\sin 4 \text{x 1}",
    ];
    let found = mistakes(r"a=\frac{\mathrm{d}b}{2}-\sin 3 \text{x 1}");
    let blanks = |text: &str| text.replace(' ', "");
    assert_eq!(found.len(), expected.len(), "{found:#?}");
    for expected in &expected[3..] {
        assert!(
            found.iter().any(|text| blanks(text) == blanks(expected)),
            "{expected}: {found:#?}"
        );
    }
}
