//! A print as the letters, numbers and signs that it has in order: for plain text against LaTeX, and for what no formula of the
//! code says, left sides, relations, the conditions of cases.

use trialbook::notation::plain_words;

/// The same in other letters.
const SPELLINGS: &[(&str, &str)] = &[
    ("sin-1", "asin"),
    ("cos-1", "acos"),
    ("ŷ", "y\u{302}"),
    ("ẑ", "z\u{302}"),
    ("ₓ", "x"),
    ("ᵧ", "y"),
    ("for", ""),
];

/// Characters that count as the next one.
const PLAINER: &str = "−-⋯…²2³3⁴4⁻-¹1₀0₁1₂2₃3₄4₊+₋-𝔴w𝐀A𝐅F𝐑R𝐜c𝐫r𝐮u𝐯v𝐰w𝛄γ𝛇ζ𝛎ν𝛒ρ𝛚ω";

pub fn of_latex(latex: &str) -> String {
    let text = if latex.contains('$') {
        plain_words(latex)
    } else {
        plain_words(&format!("${latex}$"))
    };
    let text = of_plain(&text);
    // A dot after a bracket.
    match text.split_once("˙=") {
        Some((of, right)) => format!("d{of}/dτ={right}"),
        None => text,
    }
}

pub fn of_plain(plain: &str) -> String {
    let mut text: String = plain.chars().filter_map(plainer).collect();
    for (from, to) in SPELLINGS {
        text = text.replace(from, to);
    }
    let letters: Vec<char> = text.chars().collect();
    let mut out = String::new();
    let mut rest = &letters[..];
    while let [first, after @ ..] = rest {
        // A rate is a letter with a dot.
        rest = match rest {
            ['d', '2', x, '/', 'd', 'τ', '2', after @ ..] => {
                out.extend([*x, '\u{308}']);
                after
            }
            ['d', x, '/', 'd', 'τ', after @ ..] => {
                out.extend([*x, '\u{307}']);
                after
            }
            _ => {
                out.push(*first);
                after
            }
        };
    }
    out
}

fn plainer(c: char) -> Option<char> {
    if c.is_whitespace() || "()[]{},;.·^_".contains(c) {
        return None;
    }
    let mut pairs = PLAINER.chars();
    while let (Some(from), Some(to)) = (pairs.next(), pairs.next()) {
        if from == c {
            return Some(to);
        }
    }
    Some(c)
}

#[test]
fn brackets_blanks_and_spelling_do_not_count() {
    for (latex, plain) in [
        (
            r"\dot\alpha=\sin^{-1}\frac{a+1}{2}",
            "dα/dτ = asin((a + 1)/2)",
        ),
        (r"\ddot{\bm{\rho}}=-\bm{u}", "d²𝛒/dτ² = −𝐮"),
        (r"\left(\frac{p}{2}\right)^{\cdot}=-p", "d(p/2)/dτ = −p"),
        (r"v_{0 x}<\lambda_\mathrm{c}^2", "v₀ₓ < λ_c²"),
    ] {
        assert_eq!(of_latex(latex), of_plain(plain));
    }
    for (latex, plain) in [
        ("a+1", "a − 1"),
        (r"\sin a", "cos a"),
        ("a<b", "a > b"),
        ("a_0", "a₁"),
    ] {
        assert_ne!(of_latex(latex), of_plain(plain));
    }
}
