//! The pages: which there are, in which order, and their text.

use crate::data::Text;
use crate::plotting::Figure;
use crate::publishing::{Edition, Page};
use crate::trials::Topic;

pub(super) fn pages(edition: &Edition, figures: &[Figure]) -> Vec<Page> {
    let index = written(edition, Page::INDEX.stem).cloned();
    let index = index.unwrap_or(Page::INDEX);
    let topics = edition.paper.topics.iter();
    let of_topics = topics.map(|topic| topic_page(edition, topic, figures));
    let others = edition.written().filter(|page| {
        let mut topics = edition.paper.topics.iter();
        page.stem != index.stem && topics.all(|topic| topic.stem != page.stem)
    });
    let mut others: Vec<_> = others.cloned().collect();
    others.sort_by_key(|page| page.part);
    let pages = std::iter::once(index.clone()).chain(of_topics);
    pages.chain(others).collect()
}

pub(super) fn summary(pages: &[Page]) -> String {
    let mut text = String::from("# Summary\n\n");
    let mut last = None;
    for (i, page) in pages.iter().enumerate() {
        let link = format!("[{}]({})\n", page.title, page.file());
        text += &match i {
            0 => link,
            _ if last.replace(page.part) == Some(page.part) => format!("- {link}"),
            _ => format!("\n# {:?}\n\n- {link}", page.part),
        };
    }
    text
}

fn written(edition: &Edition, stem: &str) -> Option<&'static Page> {
    edition.written().find(|page| page.stem == stem)
}

fn topic_page(edition: &Edition, topic: &'static Topic, figures: &[Figure]) -> Page {
    let text = written(edition, topic.stem).map(|page| page.text);
    Page {
        text: text.unwrap_or_else(|| Text::Built(page_of_claims(topic, figures).leak())),
        ..Page::new(topic.stem, topic.title, "")
    }
}

fn page_of_claims(topic: &Topic, figures: &[Figure]) -> String {
    let mut text = format!(
        "# {}\n\nWhat the paper claims here, and what came of trying it.\n\n{{{{ledger {}}}}}\n\n\
         ## The claims {{#claims}}\n\n",
        topic.title, topic.stem
    );
    for claim in topic.claims() {
        if figures.iter().any(|figure| figure.id == claim.id) {
            text += &format!("{{{{figure {}}}}}\n\n", claim.id);
        }
        text += &format!("{{{{claim {}}}}}\n\n", claim.id);
    }
    text
}
