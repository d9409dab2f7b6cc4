//! Letters, accents and small digits: how they stand in plain text, and what LaTeX calls them.

/// The names of Greek letters and of those that are used like them. Of two names for one letter the first is the one that is written.
pub(crate) const GREEK: &[(&str, &str)] = &[
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("varepsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("vartheta", "ϑ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("ell", "ℓ"),
    ("pi", "π"),
    ("varpi", "ϖ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Delta", "Δ"),
    ("Omega", "Ω"),
    ("Theta", "Θ"),
];

/// Commands that put a mark over their argument, and the mark behind it.
pub(super) const ACCENTS: &[(&str, char)] = &[
    ("dot", '\u{307}'),
    ("ddot", '\u{308}'),
    ("hat", '\u{302}'),
    ("tilde", '\u{303}'),
    ("bar", '\u{304}'),
    ("vec", '\u{20d7}'),
];

/// Functions by their names, which are LaTeX's too.
pub(crate) const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth",
    "exp", "ln", "min", "max",
];

/// Fractions that have a character of their own.
pub(super) const FRACTIONS: &[((&str, &str), &str)] = &[
    (("1", "2"), "½"),
    (("1", "3"), "⅓"),
    (("2", "3"), "⅔"),
    (("1", "4"), "¼"),
    (("3", "4"), "¾"),
];

/// Letters and their bold forms: the first of each, and how many follow.
const BOLD: &[(char, char, u32)] = &[('A', '𝐀', 26), ('a', '𝐚', 26), ('α', '𝛂', 25)];

fn shifted(c: char, from: char, to: char, all: u32) -> Option<char> {
    let nth = u32::from(c).checked_sub(from.into()).filter(|n| *n < all)?;
    char::from_u32(u32::from(to) + nth)
}

/// The bold form of a letter; what has none stays as it is.
pub(super) fn bold(c: char) -> char {
    let mut forms = BOLD.iter();
    forms
        .find_map(|(from, to, all)| shifted(c, *from, *to, *all))
        .unwrap_or(c)
}

/// The letter of which this is the bold form.
pub(super) fn light(c: char) -> char {
    let mut forms = BOLD.iter();
    forms
        .find_map(|(from, to, all)| shifted(c, *to, *from, *all))
        .unwrap_or(c)
}

/// What stands below the line, each behind what it stands for.
pub(super) const LOW: &str = "0₀1₁2₂3₃4₄5₅6₆7₇8₈9₉+₊-₋xₓnₙkₖ";
/// What stands above the line, each behind what it stands for.
pub(crate) const HIGH: &str = "0⁰1¹2²3³4⁴5⁵6⁶7⁷8⁸9⁹+⁺-⁻nⁿkᵏ";

/// What a character stands for, if it is one of these small ones.
pub(crate) fn large(c: char, among: &str) -> Option<char> {
    if c.is_ascii() {
        return None;
    }
    pairs(among).find_map(|(large, small)| (small == c).then_some(large))
}

/// The small character that stands for a digit or a sign.
pub(super) fn small(c: char, among: &str) -> Option<char> {
    pairs(among)
        .find_map(|(large, small)| (large == c && !c.is_ascii_alphabetic()).then_some(small))
}

fn pairs(of: &str) -> impl Iterator<Item = (char, char)> {
    of.chars().zip(of.chars().skip(1)).step_by(2)
}

/// True for a small letter or digit, below the line or above.
pub(super) fn is_small(c: char) -> bool {
    large(c, LOW).or(large(c, HIGH)).is_some()
}
