//! What a page may speak of: the ledger, the figures, the code, and links between them.

use super::{
    code::Code,
    error::{Fault, Html},
    maths::Maths,
    text::escape,
};
use crate::evidence::Kind;
use crate::ledger::{Entry, Erratum, Ledger, Verdict, deep::Deep};
use crate::plotting::Figure;
use crate::publishing::Edition;
use crate::trials::Claim;

pub(super) struct Context<'a> {
    pub edition: &'a Edition,
    pub ledger: &'a Ledger,
    pub figures: &'a [Figure],
    pub errata: &'a [Erratum],
    pub code: &'a Code<'a>,
    pub maths: &'a Maths,
    pub deep: Option<(Deep<'a>, Ledger)>,
}

impl<'a> Context<'a> {
    pub(super) fn entry(&self, id: &str) -> Result<&'a Entry, Fault> {
        let unknown = || format!("the ledger has no claim `{id}`");
        Ok(self.ledger.entry(id).ok_or_else(unknown)?)
    }

    pub(super) fn of_topic(&self, stem: &str) -> impl Iterator<Item = &'a Entry> {
        let entries = self.ledger.entries.iter();
        entries.filter(move |entry| entry.topic.stem == stem)
    }

    pub(super) fn watch(&self, claim: &Claim) -> String {
        let link = |[address, what]: [&str; 2]| {
            let address = escape(address);
            let verb = if address.contains("plot=") {
                "see"
            } else {
                "watch"
            };
            format!(" <a class=\"watch\" href=\"{address}\">▶ {verb} {what}</a>")
        };
        claim.watch.map(link).unwrap_or_default()
    }

    pub(super) fn breaks(&self, id: &str) -> String {
        let place = (self.edition.breaks)(id).map(|address| escape(&address));
        let link = |address| format!(" <a href=\"{address}\">Break it yourself.</a>");
        place.map(link).unwrap_or_default()
    }

    pub(super) fn neighbours(&self, words: &str, ids: &[&str]) -> Html {
        Ok(match self.links(ids)? {
            none if none.is_empty() => none,
            links => format!("<p class=\"neighbours\">{words} {links}</p>"),
        })
    }

    pub(super) fn link(&self, entry: &Entry) -> Html {
        // The book has figures of its own.
        let whose = match entry.claim.kind {
            Kind::Figure => "the paper's ",
            _ => "",
        };
        Ok(format!(
            "<a href=\"{}\" title=\"{}: {}\">{whose}{}</a>",
            entry.address(),
            escape(entry.claim.plain),
            entry.judgement.verdict.words(),
            self.maths.words(&entry.claim.name())?
        ))
    }

    pub(super) fn links(&self, ids: &[&str]) -> Html {
        let links: Result<Vec<_>, _> = ids.iter().map(|id| self.link(self.entry(id)?)).collect();
        Ok(links?.join(", "))
    }

    pub(super) fn users(&self, id: &str) -> Vec<&'static str> {
        let claims = self.ledger.entries.iter().map(|entry| entry.claim);
        claims
            .filter(|other| other.depends_on.contains(&id))
            .map(|other| other.id)
            .collect()
    }

    pub(super) fn explained(&self, word: &str, id: &str) -> String {
        let place = format!("{{#{id}}}");
        let mut pages = self.edition.written();
        match pages.find(|page| page.text.contains(&place)) {
            Some(page) => format!("<a href=\"{}.html#{id}\">{word}</a>", page.stem),
            None => word.to_owned(),
        }
    }
}

/// What can be left out of the longest where there is no room stands apart.
pub(super) fn verdict(verdict: Verdict) -> String {
    let words = verdict.words();
    let words = match verdict {
        Verdict::Degenerate => words.replacen(' ', "<span class=\"more\"> ", 1) + "</span>",
        _ => words.to_owned(),
    };
    format!("<span class=\"verdict {}\">{words}</span>", verdict.slug())
}

/// Where there is no room for its name; `theme/book.css` has the same.
pub(super) fn sign(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Confirmed => "✓",
        Verdict::Degenerate => "✓°",
        Verdict::Conditional => "(✓)",
        Verdict::Misprint => "✎",
        Verdict::Misderived => "≠",
        Verdict::Inherited => "↳",
        Verdict::Refuted => "✗",
        Verdict::Definition => "≔",
        Verdict::Undecided => "?",
    }
}
