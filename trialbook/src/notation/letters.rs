//! Letters, accents and small digits, in plain text and in LaTeX.

/// With those that are used like them. Of two names for one letter the first is written.
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

pub(super) const ACCENTS: &[(&str, char)] = &[
    ("dot", '\u{307}'),
    ("ddot", '\u{308}'),
    ("hat", '\u{302}'),
    ("tilde", '\u{303}'),
    ("bar", '\u{304}'),
    ("vec", '\u{20d7}'),
];

pub(crate) const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth",
    "exp", "ln", "min", "max",
];

pub(super) const FRACTIONS: &[((&str, &str), &str)] = &[
    (("1", "2"), "½"),
    (("1", "3"), "⅓"),
    (("2", "3"), "⅔"),
    (("1", "4"), "¼"),
    (("3", "4"), "¾"),
];

/// The first of each, and how many follow.
const BOLD: &[(char, char, u32)] = &[('A', '𝐀', 26), ('a', '𝐚', 26), ('α', '𝛂', 25)];

fn shifted(c: char, from: char, to: char, all: u32) -> Option<char> {
    let nth = u32::from(c).checked_sub(from.into()).filter(|n| *n < all)?;
    char::from_u32(u32::from(to) + nth)
}

/// What has none stays as it is.
pub(super) fn bold(c: char) -> char {
    let mut forms = BOLD.iter();
    forms
        .find_map(|(from, to, all)| shifted(c, *from, *to, *all))
        .unwrap_or(c)
}

pub(super) fn light(c: char) -> char {
    let mut forms = BOLD.iter();
    forms
        .find_map(|(from, to, all)| shifted(c, *to, *from, *all))
        .unwrap_or(c)
}

/// Each behind what it stands for.
pub(super) const LOW: &str = "0₀1₁2₂3₃4₄5₅6₆7₇8₈9₉+₊-₋xₓnₙkₖ";
/// Each behind what it stands for.
pub(crate) const HIGH: &str = "0⁰1¹2²3³4⁴5⁵6⁶7⁷8⁸9⁹+⁺-⁻nⁿkᵏ";

pub(crate) fn large(c: char, among: &str) -> Option<char> {
    if c.is_ascii() {
        return None;
    }
    pairs(among).find_map(|(large, small)| (small == c).then_some(large))
}

pub(super) fn small(c: char, among: &str) -> Option<char> {
    pairs(among)
        .find_map(|(large, small)| (large == c && !c.is_ascii_alphabetic()).then_some(small))
}

fn pairs(of: &str) -> impl Iterator<Item = (char, char)> {
    of.chars().zip(of.chars().skip(1)).step_by(2)
}

pub(super) fn is_small(c: char) -> bool {
    large(c, LOW).or(large(c, HIGH)).is_some()
}
