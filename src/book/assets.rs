//! What the book needs besides its pages, carried in the binary.

/// The settings, as mdBook reads them.
pub(super) const SETTINGS: &str = include_str!("../../book/book.toml");

/// A list of files: path within the book, and bytes.
macro_rules! files {
    ($($path:literal),+ $(,)?) => {
        &[$(($path, include_bytes!(concat!("../../book/", $path)).as_slice())),+]
    };
}

/// The icon and the style sheets, with the fonts and the licences that belong to them.
pub(super) const THEME: &[(&str, &[u8])] = files![
    "theme/favicon.svg",
    "theme/slipbook.css",
    "theme/access.css",
    "theme/slipbook.js",
    "theme/katex/katex.min.css",
    "theme/katex/NOTICE.txt",
    "theme/katex/LICENSE-MIT.txt",
    "theme/katex/LICENSE-OFL.txt",
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
];
