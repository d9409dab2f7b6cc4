//! What a page says of itself: its name, and what those see who share a link to it.

use super::maths::Forms;
use super::text::{escape, without};
use crate::publishing::Edition;

const PRINT: &str = "print";
const HIGHLIGHTER: &str = "<script src=\"highlight.js\"></script>";
const CARDS: &str = "<script src=\"theme/cards.js\"></script>";
const NO_HIGHLIGHTER: &str =
    "<script>window.hljs = { configure() {}, highlightBlock() {} };</script>";
const DESCRIPTION: &str = "<meta name=\"description\" content=\"";

/// No highlighter where there is no code, nor on the page of all pages, which is for paper. What is not
/// `about` the paper has no cards.
pub(super) fn with_head(
    edition: &Edition,
    stem: &str,
    about: bool,
    html: &str,
    forms: &Forms,
) -> String {
    let mut html = html.replacen("<html ", &format!("<html data-page=\"{stem}\" "), 1);
    if stem == PRINT || !html.contains("<pre") {
        html = html.replacen(HIGHLIGHTER, NO_HIGHLIGHTER, 1);
    }
    if !about {
        html = html.replacen(CARDS, "", 1);
    }
    let head = html.split_once("<title>");
    let head = head.and_then(|(before, rest)| Some((before, rest.split_once("</title>")?)));
    let Some((before, (title, after))) = head else {
        return html;
    };
    let book = escape(edition.title);
    // What a page adds to the name of the book.
    let title = match title.strip_suffix(&format!(" - {book}")) {
        Some(page) if page != book => format!("{page} - {book}"),
        _ => format!("{book}: {}", escape(edition.description)),
    };
    let words = description(edition, after, forms);
    let after = match after.split_once(DESCRIPTION) {
        Some((first, rest)) => {
            let rest = rest.split_once('"').map_or("", |(_, rest)| rest);
            format!("{first}{DESCRIPTION}{words}\"{rest}")
        }
        None => after.to_owned(),
    };
    let base = edition.address.unwrap_or_default();
    let picture = edition.picture.map_or(String::new(), |(name, _)| format!(
        "<meta property=\"og:image\" content=\"{base}{name}\"><meta name=\"twitter:card\" content=\"summary_large_image\">"
    ));
    let place = edition.address.map_or(String::new(), |base| format!(
        "<link rel=\"canonical\" href=\"{base}{stem}.html\"><meta property=\"og:url\" content=\"{base}{stem}.html\">"
    ));
    format!(
        "{before}<title>{title}</title><meta property=\"og:title\" content=\"{title}\">\
         <meta property=\"og:type\" content=\"article\"><meta property=\"og:description\" content=\"{words}\">{picture}{place}{after}"
    )
}

fn description(edition: &Edition, html: &str, forms: &Forms) -> String {
    let first = html.split_once("</h1>").map_or("", |(_, rest)| rest);
    // The line in italics says where a chapter stands in the paper.
    let mut texts = first
        .split("<p>")
        .skip(1)
        .filter(|text| !text.starts_with("<em>Section"));
    let text = texts.next().and_then(|text| text.split("</p>").next());
    let words = forms.with_words(text.unwrap_or_default());
    let plain = without(&words, "<", ">");
    let plain = plain.split_whitespace().collect::<Vec<_>>().join(" ");
    match plain.as_str() {
        "" => escape(edition.description),
        text => text.replace('"', "&quot;"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trials::Paper;

    static PAPER: Paper = Paper {
        title: "Stones",
        ..Paper::BLANK
    };

    #[test]
    fn who_shares_a_link_gets_whole_addresses_where_the_book_has_one() {
        let page = "<html lang=\"en\"><head><title>Fall - Stones</title></head><h1>Fall</h1><p>They \"fall\".</p></html>";
        let edition = Edition {
            picture: Some(("share.png", &[])),
            ..Edition::of("stones", &PAPER)
        };
        let head = with_head(&edition, "fall", true, page, &Forms::default());
        assert!(head.contains("\"og:image\" content=\"share.png\"") && !head.contains("og:url"));
        assert!(head.contains("\"og:description\" content=\"They &quot;fall&quot;.\""));
        let edition = Edition {
            address: Some("https://stones.example/"),
            ..edition
        };
        let head = with_head(&edition, "fall", true, page, &Forms::default());
        for part in [
            "\"og:image\" content=\"https://stones.example/share.png\"",
            "\"og:url\" content=\"https://stones.example/fall.html\"",
        ] {
            assert!(head.contains(part), "{head}");
        }
    }
}
