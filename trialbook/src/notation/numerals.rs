//! Numbers as they are written in running text.

/// Words that count, each with its value behind it.
const WORDS: &str = "no 0 one 1 two 2 three 3 four 4 five 5 six 6 seven 7 eight 8 nine 9 ten 10 eleven 11 twelve 12
    none 0 once 1 twice 2 thirteen 13 fourteen 14 fifteen 15 sixteen 16 seventeen 17 eighteen 18 nineteen 19 twenty 20 thirty 30 forty 40 fifty 50
    sixty 60 seventy 70 eighty 80 ninety 90 hundred 1e2 thousand 1e3 million 1e6 billion 1e9 half 0.5 quarter 0.25
    quarters 0.25 third 0.3333333333333333 thirds 0.3333333333333333 tenth 0.1 tenths 0.1 hundredth 0.01 hundredths 0.01
    thousandth 1e-3 thousandths 1e-3 millionth 1e-6 millionths 1e-6 billionth 1e-9 billionths 1e-9 % 0.01";

/// The number that a word is.
fn one(word: &str) -> Option<f64> {
    let word = word.trim_end_matches("-way");
    if let Some((times, part)) = word.split_once('-') {
        let (times, part) = (one(times)?, one(part)?);
        return Some(if part < 1.0 {
            part / times
        } else {
            times + part
        });
    }
    if let Some((above, below)) = word.split_once('/') {
        return Some(one(above)? / one(below)?);
    }
    if let Some(power) = word.strip_prefix("10").filter(|power| !power.is_empty()) {
        let digit = |c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c);
        if let Some(power) = power.chars().try_fold(0, |n, c| Some(10 * n + digit(c)?)) {
            return Some(libm::exp10(power as f64));
        }
    }
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        return word.replace(',', "").parse().ok();
    }
    known().find(|(known, _)| *known == word)?.1.parse().ok()
}

fn known() -> impl Iterator<Item = (&'static str, &'static str)> {
    let mut words = WORDS.split_whitespace();
    std::iter::from_fn(move || words.next().zip(words.next()))
}

/// The word for a small number.
#[cfg(feature = "book")]
pub(crate) fn word(n: usize) -> Option<&'static str> {
    let n = n.to_string();
    Some(known().take(13).find(|(_, value)| *value == n)?.0)
}

/// The number that words are which stand beside each other: `three quarters` is three times a quarter, `one and a half` 1.5.
pub fn number(words: &[&str]) -> Option<f64> {
    match words {
        [] => None,
        [whole, "and", "a", part] => Some(one(whole)? + one(part)?),
        ["a" | "the", words @ ..] if !words.is_empty() => number(words),
        _ => words.iter().map(|word| one(word)).product(),
    }
}
