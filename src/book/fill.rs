//! What each placeholder stands for.

use super::claim_box;
use super::code::Code;
use super::error::Fault;
use super::explorer;
use super::maths::Maths;
use super::text::{count, escape, size};
use super::{errata, map, speed, symbols, tables, values};
use crate::figures::Figure;
use crate::ledger::{Entry, Erratum, Ledger, Tally, Verdict};
use std::collections::BTreeSet;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What stands in a placeholder's place.
pub(super) enum Filled {
    /// A value within a line.
    Inline(String),
    /// A block of HTML.
    Block(String),
}

/// Fills placeholders from the ledger and the figures.
pub(super) struct Filler<'a> {
    ledger: &'a Ledger,
    figures: &'a [Figure],
    errata: &'a [Erratum],
    code: &'a Code,
    maths: &'a Maths,
    /// The claims that a page has shown so far.
    boxed: Mutex<BTreeSet<&'static str>>,
}

impl<'a> Filler<'a> {
    pub(super) fn new(
        ledger: &'a Ledger,
        figures: &'a [Figure],
        errata: &'a [Erratum],
        code: &'a Code,
        maths: &'a Maths,
    ) -> Self {
        Filler {
            ledger,
            figures,
            errata,
            code,
            maths,
            boxed: Mutex::default(),
        }
    }

    pub(super) fn maths(&self) -> &Maths {
        self.maths
    }

    pub(super) fn code(&self) -> &'a Code {
        self.code
    }

    pub(super) fn ledger(&self) -> &'a Ledger {
        self.ledger
    }

    /// The sum of something over all tallies of wrong variants.
    fn tallies(&self, of: fn(Tally) -> usize) -> usize {
        let entries = self.ledger.entries.iter();
        entries.map(|entry| of(entry.tally())).sum()
    }

    /// The first claim that no page has shown so far.
    pub(super) fn without_box(&self) -> Option<&'a Entry> {
        let boxed = self.boxed();
        let mut entries = self.ledger.entries.iter();
        entries.find(|entry| !boxed.contains(entry.claim.id))
    }

    fn boxed(&self) -> MutexGuard<'_, BTreeSet<&'static str>> {
        self.boxed.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Fills one placeholder, given without its braces, on the page of this stem.
    pub(super) fn fill(&self, page: &str, placeholder: &str) -> Result<Filled, Fault> {
        let words: Vec<_> = placeholder.split_whitespace().collect();
        let block = |html| Ok(Filled::Block(html));
        let inline = |html| Ok(Filled::Inline(html));
        match words.as_slice() {
            ["claim", id] => {
                let entry = self.entry(id)?;
                self.place(page, entry)?;
                block(claim_box::claim_box(self, entry)?)
            }
            ["figure", id] => block(self.figure(id)?),
            ["explorer"] => {
                let none = || Fault::Placeholder("this page has no explorer".into());
                block(explorer::place(page).ok_or_else(none)?)
            }
            ["counts"] => block(tables::counts(self.ledger)),
            ["ledger"] => block(tables::whole_ledger(self)?),
            ["ledger", topic] => block(tables::folded_topic(self, topic)?),
            ["proofs"] => block(tables::proofs(self.ledger)),
            ["strongest"] => block(tables::strongest(self)?),
            ["measured"] => block(tables::measured(self)?),
            ["accuracy"] => block(tables::accuracy(self)?),
            ["survivors"] => block(tables::survivors(self)?),
            ["spared"] => block(tables::spared(self)?),
            ["sheet", id] => block(format!(
                "<pre><code class=\"language-text\">{}</code></pre>\n",
                self.entry(id)?
                    .sheet()
                    .lines()
                    .map(escape)
                    .collect::<Vec<_>>()
                    .join("\n")
            )),
            ["equations"] => block(tables::equations(self)?),
            ["symbols"] => block(symbols::table_of(self)?),
            ["values"] => block(values::table_of(self)?),
            ["speed"] => block(speed::table_of()?),
            ["growth"] => block(speed::growth()?),
            ["measured-on"] => inline(speed::circumstances()?),
            ["falls"] => block(map::what_falls(self)?),
            ["map", "key"] => block(map::key()),
            ["map", "list"] => block(map::list(self)?),
            ["errata", slugs @ ..] => {
                let verdicts: Result<Vec<_>, _> =
                    slugs.iter().map(|slug| verdict_of(slug)).collect();
                block(errata::list(self, self.errata, &verdicts?)?)
            }
            ["routes"] => block(tables::routes(self.ledger)),
            ["tolerances"] => block(tables::tolerances(self)?),
            ["verdict", id] => inline(verdict(self.entry(id)?.judgement.verdict)),
            ["points", id] => {
                let evidence = &self.entry(id)?.evidence;
                inline(count(evidence.iter().map(|e| e.points).sum()))
            }
            ["worst", id] => {
                let none = || Fault::Placeholder(format!("no trial of `{id}` gave a disagreement"));
                inline(size(self.entry(id)?.worst().ok_or_else(none)?.worst))
            }
            ["ref", id] => inline(self.link(self.entry(id)?)?),
            ["count", "claims"] => inline(count(self.ledger.entries.len())),
            ["count", "points"] => inline(count(self.ledger.points())),
            ["count", "variants"] => inline(count(self.tallies(|tally| tally.tried))),
            ["count", "rejected"] => inline(count(self.tallies(|tally| tally.rejected))),
            ["count", "proved"] => {
                let entries = self.ledger.entries.iter();
                inline(count(entries.filter(|e| e.is_proved()).count()))
            }
            ["value", id] => inline(values::shown(self.ledger.paper, id)?),
            ["count", slug] => inline(count(self.ledger.counts()[&verdict_of(slug)?])),
            _ => Err(Fault::Placeholder("there is no such placeholder".into())),
        }
    }

    /// The entry of this id.
    pub(super) fn entry(&self, id: &str) -> Result<&'a Entry, Fault> {
        let unknown = || Fault::Placeholder(format!("the ledger has no claim `{id}`"));
        self.ledger.entry(id).ok_or_else(unknown)
    }

    /// A link to a claim's box.
    pub(super) fn link(&self, entry: &Entry) -> Result<String, Fault> {
        Ok(format!(
            "<a href=\"{}.html#{}\">{}</a>",
            entry.topic.stem,
            entry.claim.id,
            self.maths.words(&entry.claim.name())?
        ))
    }

    /// Links to claims' boxes.
    pub(super) fn links(&self, ids: &[&str]) -> Result<String, Fault> {
        let links: Result<Vec<_>, _> = ids.iter().map(|id| self.link(self.entry(id)?)).collect();
        Ok(links?.join(", "))
    }

    /// Ids of the claims that depend on a claim directly.
    pub(super) fn users(&self, id: &str) -> Vec<&'static str> {
        let claims = self.ledger.entries.iter().map(|entry| entry.claim);
        claims
            .filter(|other| other.depends_on.contains(&id))
            .map(|other| other.id)
            .collect()
    }

    /// Notes that a claim is shown, once and on its own page: its address is permanent.
    fn place(&self, page: &str, entry: &Entry) -> Result<(), Fault> {
        let stem = entry.topic.stem;
        if page != stem {
            let reason = format!("this claim belongs on {stem}.md");
            return Err(Fault::Placeholder(reason));
        }
        if !self.boxed().insert(entry.claim.id) {
            return Err(Fault::Placeholder("this claim is shown already".into()));
        }
        Ok(())
    }

    fn figure(&self, id: &str) -> Result<String, Fault> {
        let found = self.figures.iter().find(|figure| figure.id == id);
        let figure =
            found.ok_or_else(|| Fault::Placeholder(format!("there is no figure `{id}`")))?;
        let svg = figure.svg.find("<svg").map(|start| &figure.svg[start..]);
        let Some(svg) = svg else {
            return Err(Fault::Placeholder("this figure is not an SVG".into()));
        };
        // A drawing with links is not one picture to a screen reader.
        let window = match svg.contains("<a ") {
            true => "class=\"map-window\" role=\"group\"",
            false => "role=\"img\"",
        };
        Ok(format!(
            "<figure class=\"plot\" id=\"plot-{id}\"><div {window} aria-label=\"{}\">{}</div>\
             <figcaption>{} <a href=\"{}\" download>Data (CSV)</a></figcaption></figure>\n",
            escape(&figure.alt),
            svg.lines().map(str::trim).collect::<Vec<_>>().join(" "),
            self.maths.words(&figure.caption)?,
            data_file(figure),
        ))
    }
}

/// The verdict of this slug.
fn verdict_of(slug: &str) -> Result<Verdict, Fault> {
    let found = Verdict::ALL.into_iter().find(|v| v.slug() == slug);
    found.ok_or_else(|| Fault::Placeholder(format!("there is no verdict `{slug}`")))
}

/// Where a figure's data lies within the book.
pub(super) fn data_file(figure: &Figure) -> String {
    format!("figures/{}.csv", figure.id)
}

/// A verdict, in word and colour.
pub(super) fn verdict(verdict: Verdict) -> String {
    format!(
        "<span class=\"verdict {}\">{}</span>",
        verdict.slug(),
        verdict.words()
    )
}
