//! The explorers' place on a page, and the files that they run on.
//!
//! What the scripts show comes from [`crate::explorers`], compiled to `book/theme/explorers.wasm` (rebuilt by
//! `book/explorers/rebuild`), and from [`crate::breaks`], in `book/theme/breaks.wasm`. Pages opened from the disk
//! may not fetch anything, so a module goes into a script as text.

use crate::claims::laid_over;
use crate::motion::scene::{WORDS, Word};
use trialbook::book::{escape, table};
use trialbook::data::{Text, text};
use trialbook::publishing::{Failure, Filled};

pub(super) const TEXTS: [(&str, Text); 12] = [
    ("explorers.css", text!("book/theme/explorers.css")),
    ("explorers-plot.js", text!("book/theme/explorers-plot.js")),
    ("explorers-stage.js", text!("book/theme/explorers-stage.js")),
    (
        "explorers-scenes.js",
        text!("book/theme/explorers-scenes.js"),
    ),
    ("explorers-list.js", text!("book/theme/explorers-list.js")),
    ("explorers.js", text!("book/theme/explorers.js")),
    ("explorers-own.js", text!("book/theme/explorers-own.js")),
    ("breaks.css", text!("book/theme/breaks.css")),
    ("breaks.js", text!("book/theme/breaks.js")),
    ("questions.toml", text!("book/questions.toml")),
    ("phone.csv", text!("tests/data/phone.csv")),
    ("sine.AT2", text!("tests/data/sine.AT2")),
];

/// Path within the book, and text.
pub(super) fn files() -> Vec<(String, String)> {
    let module = base64(include_bytes!("../../book/theme/explorers.wasm"));
    let breaks = base64(include_bytes!("../../book/theme/breaks.wasm"));
    let modules = [
        ("breaks", "Breaks", breaks),
        ("explorers", "Module", module),
    ];
    let modules = modules.map(|(name, of, module)| {
        (
            format!("{name}-module.js"),
            format!("window.slipbook{of} = \"{module}\";\n"),
        )
    });
    let texts = TEXTS
        .iter()
        .map(|(name, text)| (name.to_string(), text.to_string()));
    let all = texts.chain(modules);
    all.map(|(name, text)| (format!("theme/{name}"), text))
        .collect()
}

/// The pages that have an explorer, and its name. It stands right before the figure that takes its place where scripts are
/// off.
const PAGES: [(&str, &str); 9] = [
    ("index", "record"),
    ("constant", "constant"),
    ("sinusoidal", "sinusoidal"),
    ("periodic", "periodic"),
    ("anisotropic", "anisotropic"),
    ("sphere", "sphere"),
    ("turntable", "turntable"),
    ("escape", "escape"),
    ("rest", "rest"),
];

/// An explorer's place on the page of this stem: empty and hidden until a script fills it.
pub(super) fn place(page: &str) -> Result<Filled, Failure> {
    let Some((_, name)) = PAGES.iter().find(|(stem, _)| *stem == page) else {
        return Err("this page has no explorer".into());
    };
    Ok(Filled::Block(format!(
        "{}<div class=\"explorer\" id=\"explore-{name}\" \
         data-explorer=\"{name}\" data-printed=\"{}\" role=\"group\" aria-label=\"Explorer\" hidden></div>\n",
        loaded(&["-plot", "-stage", "-scenes", "-list", ""]),
        printed(name),
    )))
}

fn loaded(scripts: &[&str]) -> String {
    let script = |name| format!("<script defer src=\"theme/explorers{name}.js\"></script>");
    let scripts: String = scripts.iter().map(script).collect();
    format!("<link rel=\"stylesheet\" href=\"theme/explorers.css\">{scripts}")
}

/// The words that most scenes are made of; the others are folded away.
const USUAL: [&str; 10] = [
    "mu",
    "mu-s",
    "throw",
    "pull",
    "accelerate",
    "tilt",
    "turn",
    "belt",
    "at",
    "until",
];

/// The place of a scene that the reader writes: a field for each of its words.
#[allow(clippy::unnecessary_wraps)]
pub(super) fn own(_: &str) -> Result<Filled, Failure> {
    let field = |word: &Word| {
        let Word { name, text, help } = word;
        let kind = if text.is_empty() { "checkbox" } else { "text" };
        let help = escape(&format!("{help}. {text}"));
        format!("<label title=\"{help}\">{name} <input type=\"{kind}\" name=\"{name}\"></label>")
    };
    let fields = |usual: bool| -> String {
        let words = WORDS
            .iter()
            .filter(|word| USUAL.contains(&word.name) == usual);
        words.map(field).collect()
    };
    let bodies = ["block", "ball"].map(|body| {
        format!("<label><input type=\"radio\" name=\"body\" value=\"{body}\"> {body}</label>")
    });
    Ok(Filled::Block(format!(
        "{}<div class=\"explorer\" id=\"own\" role=\"group\" aria-label=\"Your own scene\" hidden><div class=\"bodies\">{}</div>\
         <div class=\"inputs\">{}</div><details><summary>More words</summary><div class=\"inputs\">{}</div></details></div>\
         <noscript><p>To try it here needs scripts; the command does not.</p></noscript>\n",
        loaded(&["-plot", "", "-own"]),
        bodies.concat(),
        fields(true),
        fields(false),
    )))
}

#[allow(clippy::unnecessary_wraps)]
pub(super) fn words(_: &str) -> Result<Filled, Failure> {
    let row = |word: &Word| {
        let name = format!("<code>{}</code>", word.name);
        [name, escape(word.text), escape(word.help)]
    };
    let rows = WORDS.iter().map(row).collect::<Vec<_>>();
    Ok(Filled::Block(table(
        "words of a scene",
        ["Word", "Text", "Meaning"],
        rows,
    )))
}

/// The place where the reader breaks a formula: empty and hidden until a script fills it.
#[allow(clippy::unnecessary_wraps)]
pub(super) fn breakable(_: &str) -> Result<Filled, Failure> {
    // As text it is a third longer.
    let size = include_bytes!("../../book/theme/breaks.wasm").len() as f64 * 4.0 / 3.0;
    Ok(Filled::Block(format!(
        "<link rel=\"stylesheet\" href=\"theme/explorers.css\"><link rel=\"stylesheet\" href=\"theme/breaks.css\"><div \
         class=\"explorer\" id=\"broken\" data-size=\"{:.1} MB\" role=\"group\" aria-label=\"Break it yourself\" hidden></div>\
         <noscript><p>This needs scripts.</p></noscript><script defer src=\"theme/breaks.js\"></script>\n",
        size / 1e6
    )))
}

fn printed(name: &str) -> String {
    let pairs = laid_over::printed(name);
    let pairs = pairs.iter().map(|[x, y]| format!("{x},{y}"));
    pairs.collect::<Vec<_>>().join(" ")
}

/// Six bits a letter.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let bits = (0..3).fold(0, |bits, i| {
            bits << 8 | usize::from(*chunk.get(i).unwrap_or(&0))
        });
        for i in 0..4 {
            let letter = LETTERS[bits >> (18 - 6 * i) & 63];
            text.push(if i > chunk.len() { '=' } else { letter.into() });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_of_bytes_is_the_usual_one() {
        for (bytes, text) in [
            ("", ""),
            ("M", "TQ=="),
            ("Ma", "TWE="),
            ("Man", "TWFu"),
            ("light work.", "bGlnaHQgd29yay4="),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
        assert_eq!(base64(&[0xff, 0xfb, 0xbf]), "//u/");
    }
}
