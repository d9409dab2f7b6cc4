//! What a sentence refers to: equations by their numbers, points, curves and regions by their names, special phases, symbols, and
//! the numbers within code. Two of a kind are easily exchanged.

/// Names of points, curves and regions; A is an article too.
const NAMES: [&str; 14] = [
    "A", "B", "C", "D", "E", "X", "Y", "Z", "I", "II", "III", "IV", "V", "O",
];
/// The words before a name that may be an article.
const NAMING: [&str; 6] = ["and", "curve", "curves", "or", "point", "to"];

/// Whether a word refers to something, by the word before it.
fn refers(before: &str, word: &str) -> bool {
    let bare = word.trim_matches(|c: char| ".,;:*'’s".contains(c));
    let inside = |open: &str, close: &str| bare.strip_prefix(open)?.strip_suffix(close);
    let number =
        inside("(", ")").is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    let code = inside("`", "`").is_some_and(|code| code.contains(|c: char| c.is_ascii_digit()));
    let symbol = word
        .split_once('$')
        .and_then(|(_, rest)| rest.split_once('$'));
    let symbol = symbol.is_some_and(|(formula, after)| !after.contains('$') && is_symbol(formula));
    let named = NAMES.contains(&bare) && (bare != "A" || NAMING.contains(&before));
    number || code || named || symbol || bare.starts_with("{{ref:")
}

/// Whether a formula is a symbol, perhaps with a factor: others are tried or listed as formulas.
fn is_symbol(formula: &str) -> bool {
    let relates = ["=", "<", ">", "+", "/", "^", r"\l", r"\g", r"\to"];
    formula.len() <= 16 && !relates.iter().any(|sign| formula.contains(sign))
}

/// Each reference of a text on one line, with the three words before it and the two behind it.
pub fn around(text: &str) -> Vec<String> {
    let text = text.replace("{{ref ", "{{ref:");
    let words: Vec<&str> = text.split(' ').collect();
    let is_one = |i: &usize| refers(words[i.saturating_sub(1)], words[*i]);
    let one = |i: usize| words[i.saturating_sub(3)..words.len().min(i + 3)].join(" ");
    (0..words.len()).filter(is_one).map(one).collect()
}
