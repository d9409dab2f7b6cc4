//! Numbers as they are written in running text.

const WORDS: &str = "no 0 one 1 two 2 three 3 four 4 five 5 six 6 seven 7 eight 8 nine 9 ten 10 eleven 11 twelve 12
    none 0 once 1 twice 2 thirteen 13 fourteen 14 fifteen 15 sixteen 16 seventeen 17 eighteen 18 nineteen 19 twenty 20 thirty 30 forty 40 fifty 50
    sixty 60 seventy 70 eighty 80 ninety 90 hundred 1e2 thousand 1e3 million 1e6 billion 1e9 half 0.5 quarter 0.25
    quarters 0.25 third 0.3333333333333333 thirds 0.3333333333333333 tenth 0.1 tenths 0.1 hundredth 0.01 hundredths 0.01
    thousandth 1e-3 thousandths 1e-3 millionth 1e-6 millionths 1e-6 billionth 1e-9 billionths 1e-9 % 0.01";

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

#[cfg(feature = "book")]
pub(crate) fn word(n: usize) -> Option<&'static str> {
    let n = n.to_string();
    Some(known().take(13).find(|(_, value)| *value == n)?.0)
}

/// The number that words beside each other are: `three quarters` is three times a quarter, `one and a half`
/// 1.5.
pub fn number(words: &[&str]) -> Option<f64> {
    match words {
        [] => None,
        [whole, "and", "a", part] => Some(one(whole)? + one(part)?),
        ["a" | "the", words @ ..] if !words.is_empty() => number(words),
        _ => words.iter().map(|word| one(word)).product(),
    }
}

/// Of words between `|` the one of this number, from 0. Of one alone, that it is this number; of other words,
/// that 0 says so.
///
/// # Errors
/// What is computed, where none of it is that.
pub fn said(said: &str, is: f64) -> Result<&str, String> {
    let choices: Vec<_> = said.split('|').collect();
    let [only] = choices[..] else {
        let chosen = (choices.iter().zip(0..)).find(|(_, i)| f64::from(*i) == is);
        let chosen = chosen.map(|(word, _)| *word);
        return chosen.ok_or_else(|| format!("computed is {is}, their place from 0"));
    };
    let words = only.to_lowercase();
    let words: Vec<_> = words.split_whitespace().collect();
    match number(&words) {
        Some(wanted) if (is - wanted).abs() <= 1e-9 * wanted.abs() => Ok(only),
        Some(_) => Err(format!("computed is {is}")),
        None if is == 0.0 => Ok(only),
        None => Err("it is not so".to_owned()),
    }
}

/// What says which word it is, or which number.
pub trait Says {
    /// The number, or the place of the word from 0.
    fn says(self) -> Result<f64, String>;
}

impl Says for bool {
    fn says(self) -> Result<f64, String> {
        Ok(f64::from(u8::from(!self)))
    }
}

impl<const N: usize> Says for [bool; N] {
    fn says(self) -> Result<f64, String> {
        let mut so = (0..N).filter(|i| self[*i]);
        match (so.next(), so.next()) {
            (Some(i), None) => Ok(i as f64),
            _ => Err(format!("not one of them is so: {self:?}")),
        }
    }
}

impl Says for usize {
    fn says(self) -> Result<f64, String> {
        Ok(self as f64)
    }
}

impl Says for f64 {
    fn says(self) -> Result<f64, String> {
        Ok(self)
    }
}

/// The numbers in code, in order, without its comments, and the fractions `1.0 / 3.0`.
#[cfg(feature = "book")]
pub fn literals(code: &str) -> Vec<f64> {
    let mut numbers = Vec::new();
    let lines = code
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    for line in lines.filter(|line| !line.starts_with("use ")) {
        let (mut rest, mut before, mut above) = (line, ' ', None);
        while let Some(first) = rest.chars().next() {
            let starts = first.is_ascii_digit() && !(before.is_alphanumeric() || before == '_');
            let length = if starts {
                length(rest)
            } else {
                first.len_utf8()
            };
            if let Some(number) = rest[..length]
                .replace('_', "")
                .parse::<f64>()
                .ok()
                .filter(|_| starts)
            {
                numbers.extend(
                    [Some(number), above.map(|above: f64| above / number)]
                        .into_iter()
                        .flatten(),
                );
                above = rest[length..].starts_with(" / ").then_some(number);
                rest = rest[length..]
                    .strip_prefix(" / ")
                    .unwrap_or(&rest[length..]);
                before = ' ';
            } else {
                above = None;
                before = rest[..length].chars().next_back().unwrap_or(' ');
                rest = &rest[length..];
            }
        }
    }
    numbers
}

#[cfg(feature = "book")]
fn length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let next = bytes.get(end + 1).copied().unwrap_or(b' ');
        let part = match bytes[end] {
            b'0'..=b'9' => true,
            b'_' | b'.' => next.is_ascii_digit(),
            b'e' => next.is_ascii_digit() || next == b'-',
            b'-' => bytes[end - 1] == b'e',
            _ => false,
        };
        if !part {
            break;
        }
        end += 1;
    }
    end
}

#[test]
fn what_is_computed_says_which_word() {
    for (words, is, said_of_it) in [
        ("falls|rises", 1.0, Some("rises")),
        ("falls|rises", 2.0, None),
        ("falls|rises", 0.5, None),
        ("falls", 0.0, Some("falls")),
        ("falls", 1.0, None),
        ("Three quarters", 0.75, Some("Three quarters")),
        ("six", 5.0, None),
    ] {
        assert_eq!(said(words, is).ok(), said_of_it, "{words} {is}");
    }
    assert_eq!(true.says(), Ok(0.0));
    assert_eq!([false, true].says(), Ok(1.0));
    assert!([true, true].says().is_err() && [false, false].says().is_err());
}

#[cfg(feature = "book")]
#[test]
fn code_has_its_numbers_and_fractions() {
    let code =
        "use a::b2; // 0.25\nlet x = [0.25, 1_000.5, 2e-3]; f(1..=3, \"2.0\", 1.0 / 3.0, a / 4.0)";
    let wanted = [0.25, 1000.5, 2e-3, 1.0, 3.0, 2.0, 1.0, 3.0, 1.0 / 3.0, 4.0];
    assert_eq!(literals(code), wanted);
}
