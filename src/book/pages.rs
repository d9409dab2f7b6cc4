//! The pages: which there are, in which order, and their text.

use crate::claims::{PAPER, Topic};
use crate::figures::Figure;

/// One list of the written pages, for the book and for the doctests.
macro_rules! written {
    ($($stem:ident),+ $(,)?) => {
        /// The written pages: stem and text.
        pub(super) const WRITTEN: &[(&str, &str)] = &[$((
            stringify!($stem),
            include_str!(concat!("../../book/src/", stringify!($stem), ".md")),
        )),+];

        /// The code on the pages runs as tests.
        #[cfg(doctest)]
        mod doctests {
            $(
                #[doc = include_str!(concat!("../../book/src/", stringify!($stem), ".md"))]
                mod $stem {}
            )+
        }
    };
}

// A topic that is not named here gets a page made from its claims alone.
written!(
    index,
    general,
    constant,
    sinusoidal,
    periodic,
    anisotropic,
    sphere,
    turntable,
    escape,
    rest,
    ledger,
    proved,
    accuracy,
    errata,
    map,
    equations,
    symbols,
    values,
    methods,
    snapshots,
    adding,
    json,
    speed
);

/// A page before its placeholders are filled.
pub(super) struct Page {
    /// The file's name without its extension.
    pub(super) stem: &'static str,
    /// Its name in the table of contents.
    title: &'static str,
    /// Its text.
    pub(super) text: String,
}

impl Page {
    /// The file's name as Markdown.
    pub(super) fn file(&self) -> String {
        format!("{}.md", self.stem)
    }
}

/// The part of the table of contents that a page belongs to, by its heading.
const CLAIMS: &str = "The paper, claim by claim";
const REFERENCE: &str = "Reference";

/// All pages, in the order of the book.
pub(super) fn pages(figures: &[Figure]) -> Vec<Page> {
    let mut pages = vec![written_page("index", "Slipbook")];
    pages.extend(PAPER.topics.iter().map(|topic| topic_page(topic, figures)));
    let reference = [
        ("ledger", "The ledger"),
        ("proved", "What is proved, what is measured"),
        ("accuracy", "How accurately it was measured"),
        ("errata", "Errata"),
        ("map", "The map of claims"),
        ("equations", "Index of equations"),
        ("symbols", "Index of symbols"),
        ("values", "Index of values"),
        ("methods", "How a verdict comes about"),
        ("snapshots", "How to read a snapshot"),
        ("adding", "How to add a claim"),
        ("json", "Answers as JSON"),
        ("speed", "How fast"),
    ];
    pages.extend(reference.map(|(stem, title)| written_page(stem, title)));
    pages
}

/// The table of contents, as mdBook reads it.
pub(super) fn summary(pages: &[Page]) -> String {
    let mut text = String::from("# Summary\n\n");
    for page in pages {
        match page.stem {
            "index" => {
                text.push_str(&format!(
                    "[{}]({})\n\n# {CLAIMS}\n\n",
                    page.title,
                    page.file()
                ));
                continue;
            }
            "ledger" => text.push_str(&format!("\n# {REFERENCE}\n\n")),
            _ => {}
        }
        text.push_str(&format!("- [{}]({})\n", page.title, page.file()));
    }
    text
}

fn text_of(stem: &str) -> Option<&'static str> {
    let found = WRITTEN.iter().find(|(written, _)| *written == stem);
    found.map(|(_, text)| *text)
}

fn written_page(stem: &'static str, title: &'static str) -> Page {
    Page {
        stem,
        title,
        text: text_of(stem).unwrap_or_default().to_owned(),
    }
}

fn topic_page(topic: &'static Topic, figures: &[Figure]) -> Page {
    let text = match text_of(topic.stem) {
        Some(text) => text.to_owned(),
        None => page_of_claims(topic, figures),
    };
    Page {
        stem: topic.stem,
        title: topic.title,
        text,
    }
}

/// The page of a topic whose chapter is not written yet.
fn page_of_claims(topic: &Topic, figures: &[Figure]) -> String {
    let mut text = format!(
        "# {}\n\nWhat the paper claims here, and what came of trying it.\n\n{{{{ledger {}}}}}\n\n\
         ## The claims {{#claims}}\n\n",
        topic.title, topic.stem
    );
    for claim in topic.claims {
        if figures.iter().any(|figure| figure.id == claim.id) {
            text.push_str(&format!("{{{{figure {}}}}}\n\n", claim.id));
        }
        text.push_str(&format!("{{{{claim {}}}}}\n\n", claim.id));
    }
    text
}
