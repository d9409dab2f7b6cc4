//! Labels with a little mathematics: `v_x`, `λ_0`, `A t/v_0`, `10^{-3}`, `p/τ^2`.
//!
//! A lone Latin or small Greek letter is set in italics; words, digits, capital Greek letters and anything
//! between single quotes (`'I'`) are upright. `_` and `^` take the next character or the next `{…}`; scripts
//! do not nest.

use super::svg::escape;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Level {
    Base,
    Sub,
    Sup,
}

impl Level {
    /// In units of the base size.
    fn size(self) -> f64 {
        if self == Level::Base { 1.0 } else { 0.7 }
    }
    /// In units of the base size.
    fn drop(self) -> f64 {
        match self {
            Level::Base => 0.0,
            Level::Sub => 0.24,
            Level::Sup => -0.38,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Face {
    Upright,
    Italic,
    Fraktur,
}

#[derive(Debug, Clone, PartialEq)]
struct Run {
    text: String,
    face: Face,
    level: Level,
}

pub(super) fn markup(label: &str) -> String {
    let mut out = String::new();
    let mut level = Level::Base;
    for run in runs(label) {
        let text = escape(&run.text);
        let mut attributes = String::new();
        attributes += match run.face {
            Face::Upright => "",
            Face::Italic => " font-style=\"italic\"",
            Face::Fraktur => " font-family=\"KaTeX_Fraktur\"",
        };
        if run.level != Level::Base {
            attributes += " font-size=\"70%\"";
        }
        if run.level != level {
            // `dy` counts in the type of the run that carries it.
            let shift = (run.level.drop() - level.drop()) / run.level.size();
            attributes += &format!(" dy=\"{}em\"", super::svg::number(shift));
            level = run.level;
        }
        if attributes.is_empty() {
            out += &text;
        } else {
            out += &format!("<tspan{attributes}>{text}</tspan>");
        }
    }
    out
}

/// Rather too wide than too narrow.
pub(super) fn width(label: &str, size: f64) -> f64 {
    runs(label)
        .iter()
        .map(|run| size * run.level.size() * run.text.chars().map(advance).sum::<f64>())
        .sum()
}

/// In units of the type size, for a serif face.
fn advance(c: char) -> f64 {
    match c {
        '\u{300}'..='\u{36f}' => 0.0,
        '\u{2003}' => 1.0,
        ' ' | '.' | ',' | ':' | ';' | '′' => 0.27,
        'i' | 'j' | 'l' | 't' | 'f' | 'r' | 's' | '(' | ')' | '|' | '/' => 0.4,
        'm' | 'w' | 'M' | 'W' | '=' | '+' | '−' | '<' | '>' | '≤' | '≥' | '×' | '→' => 0.8,
        'A'..='Z' | 'Α'..='Ω' | '∞' => 0.72,
        _ => 0.53,
    }
}

fn runs(label: &str) -> Vec<Run> {
    let chars: Vec<char> = label.chars().collect();
    let mut out = Vec::new();
    let mut i = 0;
    while i < chars.len() {
        let level = match chars[i] {
            '_' => Level::Sub,
            '^' => Level::Sup,
            '\'' => {
                let end = position(&chars, i + 1, '\'');
                push(&mut out, &chars[i + 1..end], Face::Upright, Level::Base);
                i = end + 1;
                continue;
            }
            _ => {
                let end = (i..chars.len())
                    .find(|&k| matches!(chars[k], '_' | '^' | '\''))
                    .unwrap_or(chars.len());
                words(&mut out, &chars[i..end], Level::Base);
                i = end;
                continue;
            }
        };
        if chars.get(i + 1) == Some(&'{') {
            let end = position(&chars, i + 2, '}');
            words(&mut out, &chars[i + 2..end], level);
            i = end + 1;
        } else {
            let end = (i + 2).min(chars.len());
            words(&mut out, &chars[i + 1..end], level);
            i = end;
        }
    }
    out
}

/// The end if it is nowhere.
fn position(chars: &[char], from: usize, wanted: char) -> usize {
    let rest = &chars[from..];
    rest.iter()
        .position(|&c| c == wanted)
        .map_or(chars.len(), |k| from + k)
}

fn words(out: &mut Vec<Run>, chars: &[char], level: Level) {
    let mut i = 0;
    while i < chars.len() {
        let letters = chars[i..]
            .iter()
            .take_while(|c| c.is_ascii_alphabetic())
            .count();
        let greek = matches!(chars[i], 'α'..='ω' | 'ϑ' | 'ϕ' | 'ϖ');
        let length = letters.max(1);
        let mut end = i + length;
        while end < chars.len() && matches!(chars[end], '\u{300}'..='\u{36f}') {
            end += 1;
        }
        match chars[i] {
            // Few systems have this letter; the formulas' own face has it in the place of a Latin one.
            '𝔴' => push(out, &['w'], Face::Fraktur, level),
            'φ' => {
                push(out, &['ϕ'], Face::Italic, level);
                push(out, &chars[i + 1..end], Face::Italic, level);
            }
            _ if letters == 1 || greek => push(out, &chars[i..end], Face::Italic, level),
            _ => push(out, &chars[i..end], Face::Upright, level),
        }
        i = end;
    }
}

fn push(out: &mut Vec<Run>, chars: &[char], face: Face, level: Level) {
    match out.last_mut() {
        Some(last) if last.face == face && last.level == level => last.text.extend(chars),
        _ if chars.is_empty() => {}
        _ => out.push(Run {
            text: chars.iter().collect(),
            face,
            level,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::notation::{tags, without_tags};
    use proptest::prelude::*;

    #[test]
    fn quantities_are_italic_and_words_are_not() {
        let italic = |label: &str| -> String {
            let runs = runs(label)
                .into_iter()
                .filter(|run| run.face == Face::Italic);
            runs.map(|run| run.text).collect()
        };
        assert_eq!(italic("sin φ_1"), "ϕ");
        assert_eq!(italic("A t/v_0"), "Atv");
        assert_eq!(italic("time T"), "T");
        assert_eq!(italic("v_x"), "vx");
        assert_eq!(italic("region 'I'"), "");
        assert_eq!(italic("φ̃_2"), "ϕ̃");
        assert_eq!(italic("−ln 𝔴_y"), "y");
    }

    #[test]
    fn the_base_line_returns_after_a_script() {
        assert_eq!(
            markup("10^{-3} m"),
            "10<tspan font-size=\"70%\" dy=\"-0.54em\">-3</tspan><tspan dy=\"0.38em\"> </tspan>\
             <tspan font-style=\"italic\">m</tspan>"
        );
    }

    #[test]
    fn a_letter_of_fraktur_is_in_the_face_of_the_formulas() {
        assert_eq!(
            markup("−ln 𝔴"),
            "−ln <tspan font-family=\"KaTeX_Fraktur\">w</tspan>"
        );
    }

    #[test]
    fn unfinished_scripts_end_with_the_label() {
        for label in ["", "_", "v_", "v_{x", "'", "'I", "^{", "a_'b"] {
            markup(label);
            assert!(width(label, 16.0) >= 0.0);
        }
        assert!(!markup("a < b").contains('<') || markup("a < b").contains("&lt;"));
    }

    proptest! {
        #[test]
        fn of_a_label_its_words_are_seen_and_nothing_of_its_markup(label in "[a-cvx1φ𝔴_^'{}<>&\" ]{0,12}") {
            let svg = format!("<text>{}</text>", markup(&label));
            let mut open = Vec::new();
            for tag in tags(&svg) {
                if tag.closes {
                    prop_assert_eq!(open.pop(), Some(tag.name), "{}", svg);
                    continue;
                }
                open.push(tag.name);
                let known = ["font-style", "font-family", "font-size", "dy"];
                let right = tag.attributes().all(|(key, _)| known.contains(&key)) && tag.attributes().count() == tag.tag.matches('=').count();
                prop_assert!(right && ["text", "tspan"].contains(&tag.name), "{svg}");
            }
            prop_assert!(open.is_empty(), "{svg}");
            let seen = without_tags(&svg);
            let entities = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&amp;", "&")];
            let seen = entities.iter().fold(seen, |seen, (entity, text)| seen.replace(entity, text));
            let words = |text: &str| text.replace(['_', '^', '\'', '{', '}'], "");
            let own = label.replace('𝔴', "w").replace('φ', "ϕ");
            // Between single quotes letters stay as they are.
            let upright = |text: &str| words(text).replace('𝔴', "w").replace('φ', "ϕ");
            prop_assert_eq!(upright(&seen), words(&own), "{}", svg);
        }
    }
}
