//! What every book needs besides its pages, carried in the binary.

use crate::publishing::Edition;

/// As mdBook reads them; the book's own style sheet and script are yet without their name.
const SETTINGS: &str = include_str!("../../theme/book.toml");

macro_rules! files {
    ($($path:literal),+ $(,)?) => {
        &[$(($path, include_bytes!(concat!("../../", $path)).as_slice())),+]
    };
}

const THEME: &[(&str, &[u8])] = files![
    "theme/book.css",
    "theme/access.css",
    "theme/book.js",
    "theme/overview.js",
    "theme/cards.js",
    "theme/search.js",
    "theme/katex/katex.min.css",
    "theme/katex/NOTICE.txt",
    "theme/katex/LICENSE-MIT.txt",
    "theme/katex/LICENSE-OFL.txt",
    "theme/katex/LICENSE-GUST.txt",
    "theme/katex/fonts/KaTeX_AMS-Regular.woff2",
    "theme/katex/fonts/KaTeX_Caligraphic-Bold.woff2",
    "theme/katex/fonts/KaTeX_Caligraphic-Regular.woff2",
    "theme/katex/fonts/KaTeX_Fraktur-Bold.woff2",
    "theme/katex/fonts/KaTeX_Fraktur-Regular.woff2",
    "theme/katex/fonts/KaTeX_Main-Bold.woff2",
    "theme/katex/fonts/KaTeX_Main-BoldItalic.woff2",
    "theme/katex/fonts/KaTeX_Main-Italic.woff2",
    "theme/katex/fonts/KaTeX_Main-Regular.woff2",
    "theme/katex/fonts/KaTeX_Math-BoldItalic.woff2",
    "theme/katex/fonts/KaTeX_Math-Italic.woff2",
    "theme/katex/fonts/KaTeX_SansSerif-Bold.woff2",
    "theme/katex/fonts/KaTeX_SansSerif-Italic.woff2",
    "theme/katex/fonts/KaTeX_SansSerif-Regular.woff2",
    "theme/katex/fonts/KaTeX_Script-Regular.woff2",
    "theme/katex/fonts/KaTeX_Size1-Regular.woff2",
    "theme/katex/fonts/KaTeX_Size2-Regular.woff2",
    "theme/katex/fonts/KaTeX_Size3-Regular.woff2",
    "theme/katex/fonts/KaTeX_Size4-Regular.woff2",
    "theme/katex/fonts/KaTeX_Typewriter-Regular.woff2",
    "theme/katex/fonts/TrialbookMath-Regular.woff2",
];

pub(super) fn settings(edition: &Edition) -> String {
    SETTINGS.replace("theme/book.", &format!("theme/{}.", edition.name))
}

pub(super) fn theme(edition: &Edition) -> impl Iterator<Item = (String, &'static [u8])> {
    let named = format!("theme/{}.", edition.name);
    let files = THEME.iter();
    let files = files.map(move |(path, bytes)| (path.replace("theme/book.", &named), *bytes));
    files.chain([("theme/favicon.svg".to_owned(), edition.icon.as_bytes())])
}
