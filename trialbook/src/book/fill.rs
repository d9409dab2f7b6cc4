//! What each placeholder stands for.

use super::{
    answers, claim_box,
    context::{Context, verdict},
    deep, errata,
    error::{Fault, Html},
    excuses,
    expand::Blank,
    ledger_tables, lemmas, map, method_tables, pieces, skeleton, symbols, table,
    text::{count, escape, in_words, size},
    theorems, values,
};
use crate::evidence::Kind;
use crate::ledger::{Entry, Ledger, Standing, Tally, Verdict};
use crate::notation;
use crate::plotting::{Figure, panels};
use crate::publishing::{Edition, Filled, Page};
use std::collections::BTreeSet;
use std::sync::{Mutex, MutexGuard, PoisonError};

const FIRST: &str = include_str!("../../examples/fall.rs");

pub(super) struct Filler<'a> {
    context: &'a Context<'a>,
    pages: &'a [Page],
    boxed: Mutex<BTreeSet<&'static str>>,
}

impl<'a> Filler<'a> {
    pub(super) fn new(context: &'a Context<'a>, pages: &'a [Page]) -> Self {
        Filler {
            context,
            pages,
            boxed: Mutex::default(),
        }
    }

    pub(super) fn without_box(&self) -> Option<&'a Entry> {
        let boxed = self.boxed();
        let mut entries = self.context.ledger.entries.iter();
        entries.find(|entry| !boxed.contains(entry.claim.id))
    }

    fn boxed(&self) -> MutexGuard<'_, BTreeSet<&'static str>> {
        self.boxed.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn fill(&self, blank: &Blank) -> Result<Filled, Fault> {
        let context = self.context;
        let (page, placeholder) = (self.pages[blank.page].stem, &*blank.inside);
        let ledger = context.ledger;
        let words: Vec<_> = placeholder.split_whitespace().collect();
        let block = |html| Ok(Filled::Block(html));
        let inline = |html| Ok(Filled::Inline(html));
        let known = |by| inline(count(ledger.known(by)));
        match words.as_slice() {
            ["claim", id] => {
                let entry = context.entry(id)?;
                self.place(page, entry)?;
                block(claim_box::claim_box(context, entry)?)
            }
            ["figure", id] => block(self.figure(page, id)?),
            ["contents"] => inline(self.contents(page)?),
            ["title"] => inline(escape(ledger.paper.title)),
            ["authors"] => inline(escape(ledger.paper.authors)),
            ["repository"] => inline(repository(context.edition)),
            ["counts"] => block(ledger_tables::counts(ledger)),
            ["errors"] => block(errata::errors(context, false)?),
            ["errors", "fallen"] => block(errata::errors(context, true)?),
            ["skeleton"] => block(skeleton::skeleton(context)),
            ["ask"] => block(answers::field()),
            ["ledger"] => block(ledger_tables::whole_ledger(context)?),
            ["ledger", topic] => block(ledger_tables::folded_topic(context, topic)?),
            ["beside"] => block(theorems::beside(context)?),
            ["lemmas"] => block(lemmas::all(context)?),
            ["definitions"] => block(theorems::definitions(context)?),
            ["proofs"] => block(ledger_tables::proofs(ledger)),
            ["unreached"] => block(ledger_tables::unreached(context)?),
            ["accuracy"] => block(method_tables::accuracy(context)?),
            ["deep"] => block(deep::table_of(context)?),
            ["survivors"] => block(excuses::excused(context, "survivors")?),
            ["spared"] => block(excuses::excused_trials(context, "spared")?),
            ["coarse"] => block(excuses::excused_trials(context, "coarse")?),
            ["cornered"] => block(excuses::excused(context, "cornered")?),
            ["idle"] => block(excuses::idle(context)?),
            ["sheet", id] => block(table::code(&context.entry(id)?.sheet())),
            ["sheets"] => block(ledger_tables::sheets(context)?),
            ["first-paper"] => block(table::code(FIRST)),
            ["symbols"] => block(symbols::table_of(context)?),
            ["values"] => block(values::table_of(context)?),
            ["falls"] => block(map::what_falls(context)?),
            ["map", "key"] => block(map::key()),
            ["map", "list"] => block(map::list(context)?),
            ["errata", slugs @ ..] => {
                let verdicts = slugs.iter().map(|slug| verdict_of(slug));
                let verdicts = verdicts.collect::<Result<Vec<_>, _>>()?;
                block(errata::list(context, &verdicts)?)
            }
            ["lines", modules @ ..] => inline(context.code.lines(modules)?),
            ["routes"] => block(method_tables::routes(ledger)),
            ["tolerances"] => block(method_tables::tolerances(context)?),
            ["verdict", id] => inline(verdict(context.entry(id)?.judgement.verdict)),
            ["points", id] => inline(count(context.entry(id)?.points())),
            ["worst", id] => {
                let none = || format!("no trial of `{id}` gave a disagreement");
                inline(size(context.entry(id)?.worst().ok_or_else(none)?.worst))
            }
            ["is", name, said @ ..] => inline(self.said(name, &said.join(" "))?),
            ["code", said @ ..] => {
                let code = pieces::code_beside(&self.pages[blank.page].text, blank.offset);
                let is = notation::number(said);
                let there = notation::literals(&code).into_iter().any(|n| Some(n) == is);
                match there {
                    true => inline(escape(&said.join(" "))),
                    false => Err("no such number stands in the code of this section"
                        .to_owned()
                        .into()),
                }
            }
            ["ref", id] => inline(context.link(context.entry(id)?)?),
            ["count", "claims"] => inline(count(ledger.entries.len())),
            ["count", "points"] => inline(count(ledger.points())),
            ["count", "put"] => inline(count(ledger.mistakes_put())),
            ["count", "variants"] => inline(count(tallies(ledger, |tally| tally.tried))),
            ["count", "rejected"] => inline(count(tallies(ledger, |tally| tally.rejected))),
            ["count", "corners"] => inline(count(ledger.paper.corners().len())),
            ["count", "proved"] => known(Standing::Proved),
            ["count", "defined"] => known(Standing::Defined),
            ["count", "theorems"] => inline(count(ledger.paper.known_theorems().record.len())),
            ["count", "argued"] => known(Standing::Argued),
            ["count", "measured"] => known(Standing::Measured),
            ["count", "wrong"] => inline(count(ledger.wrong())),
            ["count", "roots"] => inline(count(ledger.roots_and_heirs()[0])),
            ["count", "results"] => inline(count(ledger.weights()[0])),
            ["count", "factors"] => inline(count(ledger.weights()[1])),
            ["count", "heirs"] => inline(count(ledger.roots_and_heirs()[1])),
            ["value", id] => inline(values::shown(ledger.paper, id)?),
            ["count", slug] => inline(count(ledger.counts()[&verdict_of(slug)?])),
            _ => self.own(page, placeholder.trim()),
        }
    }

    /// Of the words between `|` the one that is so, or a number. The word that the name has stands first, or
    /// second if the name has a `!` before it: words cannot change places unseen.
    fn said(&self, name: &str, said: &str) -> Html {
        let bare = name.trim_start_matches('!');
        let mut words = self.context.edition.words.iter().copied().flatten();
        let none = || format!("nothing is computed by the name `{bare}`");
        let word = words.find(|word| word.name == bare).ok_or_else(none)?;
        let is = (word.is)().map_err(|failure| failure.to_string())?;
        let choices: Vec<_> = said.split('|').collect();
        let plain = |said: &str| said.replace(['$', '\\', '(', ')'], "").replace(' ', "-");
        let named = choices.iter().position(|said| bare.contains(&plain(said)));
        if named.unwrap_or(0) != usize::from(name != bare) {
            let why = "the word that the name has stands first, or second if the name has a `!` before it";
            return Err(why.to_owned().into());
        }
        self.context.maths.words(notation::said(said, is)?)
    }

    fn own(&self, page: &str, placeholder: &str) -> Result<Filled, Fault> {
        let mut own = self.context.edition.placeholders.iter();
        let own = own.find_map(|own| match placeholder.strip_prefix(own.name)? {
            "" => Some((own, page)),
            behind => own.name.ends_with(' ').then_some((own, behind)),
        });
        let (own, given) = own.ok_or_else(|| "there is no such placeholder".to_owned())?;
        (own.fill)(given).map_err(|failure| failure.to_string().into())
    }

    /// Once and on its own page: its address is permanent.
    fn place(&self, page: &str, entry: &Entry) -> Result<(), Fault> {
        let stem = entry.topic.stem;
        if page != stem {
            return Err(format!("this claim belongs on {stem}.md").into());
        }
        if !self.boxed().insert(entry.claim.id) {
            return Err("this claim is shown already".to_owned().into());
        }
        Ok(())
    }

    fn contents(&self, page: &str) -> Html {
        let mut topics = self.context.ledger.paper.topics.iter();
        let topic = topics.find(|topic| topic.stem == page);
        let none = || "this is no page of a topic".to_owned();
        let claims = topic.ok_or_else(none)?.claims();
        let numbers: Vec<u16> = claims.iter().filter_map(|claim| claim.equation).collect();
        let equations = match numbers[..] {
            [] => None,
            [only] => Some(format!("equation ({only})")),
            [first, second] => Some(format!("equations ({first}) and ({second})")),
            [first, .., last] => Some(format!("equations ({first}) to ({last})")),
        };
        let figures = claims.iter().filter(|claim| claim.kind == Kind::Figure);
        let figures = figures.count();
        let statements = claims.len() - numbers.len() - figures;
        let said = |n: usize, one: &str, many: &str| match n {
            0 => None,
            1 => Some(format!("one {one}")),
            n => Some(format!("{} {many}", in_words(n))),
        };
        let statements = said(statements, "statement in words", "statements in words");
        let parts = [equations, statements, said(figures, "figure", "figures")];
        Ok(parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }

    fn figure(&self, page: &str, id: &str) -> Html {
        let text = self.pages.iter().find(|other| other.stem == page);
        let mut placed = text
            .into_iter()
            .flat_map(|page| page.text.split("{{figure ").skip(1));
        let before = placed.position(|rest| rest.starts_with(&format!("{id}}}}}")));
        let number = 1 + before.unwrap_or_default();
        let found = self.context.figures.iter().find(|figure| figure.id == id);
        let none = || format!("there is no figure `{id}`");
        let figure = found.ok_or_else(none)?;
        let no_svg = || "this figure is not an SVG".to_owned();
        let svg = &figure.svg[figure.svg.find("<svg").ok_or_else(no_svg)?..];
        let parts = panels(svg);
        // A drawing with links is not one picture to a screen reader.
        let window = match (svg.contains("<a "), parts.len()) {
            (true, _) => "class=\"map-window\" role=\"group\"",
            (_, 1) => "role=\"img\"",
            _ => "class=\"panels\" role=\"img\"",
        };
        let parts = parts.concat();
        Ok(format!(
            "<figure class=\"plot\" id=\"plot-{id}\"><div {window} aria-label=\"{}\">{}</div>\
             <figcaption><strong>Fig. {number}.</strong> {} <a href=\"{}\" download>Data (CSV)</a></figcaption></figure>\n",
            escape(&figure.alt),
            parts.lines().map(str::trim).collect::<Vec<_>>().join(" "),
            self.context.maths.words(&figure.caption)?,
            data_file(figure),
        ))
    }
}

fn tallies(ledger: &Ledger, of: fn(Tally) -> usize) -> usize {
    let entries = ledger.entries.iter();
    entries.map(|entry| of(entry.tally())).sum()
}

fn verdict_of(slug: &str) -> Result<Verdict, Fault> {
    let found = Verdict::ALL.into_iter().find(|v| v.slug() == slug);
    Ok(found.ok_or_else(|| format!("there is no verdict `{slug}`"))?)
}

pub(super) fn data_file(figure: &Figure) -> String {
    format!("figures/{}.csv", figure.id)
}

fn repository(edition: &Edition) -> String {
    match edition.repository {
        Some(address) => format!("<a href=\"{}\">the program’s sources</a>", escape(address)),
        None => "the program’s sources, which have no public address yet,".to_owned(),
    }
}
