//! The book in two steps: its pages whatever the verdicts, and what fills them.

use super::{
    answers, assets,
    atomic_replace::{Staging, unwritable},
    code::Code,
    context::Context,
    equation_links,
    error::BookError,
    expand::{Blank, MARK, expand},
    fill::{self, Filler},
    links::dead_links,
    map,
    maths::{Forms, Maths},
    metadata, moved, pages, put,
    search::Search,
    text::{after_each, without},
};
use crate::ledger::{Format, Ledger, deep::Deep};
use crate::plotting::Figure;
use crate::publishing::{Edition, Filled, Page, Part};
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

const PRINT: &str = "print.html";

/// The book as mdBook renders it, with marks for formulas and placeholders, whatever the verdicts: it is made
/// while the claims are tried.
pub struct Frame<'a> {
    edition: &'a Edition,
    staging: Staging,
    pages: Vec<Page>,
    blanks: Vec<Blank>,
    maths: Maths,
    html: Vec<(String, String)>,
}

impl<'a> Frame<'a> {
    /// Renders the pages beside `out`, where the book is to be.
    ///
    /// # Errors
    /// As for [`write()`](super::write()).
    pub fn new(edition: &'a Edition, figures: &[Figure], out: &Path) -> Result<Self, BookError> {
        let staging = Staging::beside(out, edition.name)?;
        let places = staging.places();
        Self::rendered(edition, figures, staging).map_err(|error| places.named(error))
    }

    fn rendered(
        edition: &'a Edition,
        figures: &[Figure],
        staging: Staging,
    ) -> Result<Self, BookError> {
        let pages = pages::pages(edition, figures);
        let source = staging.path("source");
        let text = source.join("src");
        let (maths, mut blanks) = (Maths::new(), Vec::new());
        for page in pages.iter().enumerate() {
            let expanded = expand(page, &maths, &mut blanks)?;
            put(&text.join(page.1.file()), expanded.as_bytes())?;
        }
        put(&text.join("SUMMARY.md"), pages::summary(&pages).as_bytes())?;
        for (name, bytes) in assets::theme(edition) {
            // mdBook takes style sheets, scripts and its theme from beside `src`, all other files from within it.
            let within = name.contains("katex") && !name.ends_with(".css");
            let folder = if within { &text } else { &source };
            put(&folder.join(name), bytes)?;
        }
        let book = staging.path("book");
        render(edition, &source, &book)?;
        let names = pages.iter().map(|page| format!("{}.html", page.stem));
        let html = names.chain([PRINT.to_owned()]).map(|name| {
            let path = book.join(&name);
            let html = fs::read_to_string(&path);
            Ok((name, html.map_err(|reason| unwritable(&path, reason))?))
        });
        let html = html.collect::<Result<_, BookError>>()?;
        maths.prepare(edition.paper);
        for value in edition.paper.values() {
            // Kept once computed. A failure shows where the number is used.
            let _ = value.number();
        }
        Ok(Frame {
            edition,
            staging,
            pages,
            blanks,
            maths,
            html,
        })
    }

    /// Fills the pages, puts the book in place, and returns its first page.
    ///
    /// # Errors
    /// As for [`write()`](super::write()).
    pub fn fill(self, ledger: &Ledger, figures: &[Figure]) -> Result<PathBuf, BookError> {
        let places = self.staging.places();
        self.finished(ledger, figures)
            .map_err(|error| places.named(error))
    }

    fn finished(self, ledger: &Ledger, figures: &[Figure]) -> Result<PathBuf, BookError> {
        let figures = [figures, &[map::figure(ledger)?]].concat();
        let (errata, code) = (ledger.errata()?, Code::new(self.edition));
        let deep = Deep::read(&ledger.paper.deep).map(|deep| {
            let brought = deep.in_place_of(ledger);
            (deep, brought)
        });
        let context = Context {
            edition: self.edition,
            ledger,
            figures: &figures,
            errata: &errata,
            code: &code,
            maths: &self.maths,
            deep,
        };
        let filler = Filler::new(&context, &self.pages);
        let filled = self.filled(&filler)?;
        if let Some(entry) = filler.without_box() {
            return Err(BookError::ClaimNowhere {
                id: entry.claim.id,
                page: format!("{}.md", entry.topic.stem),
            });
        }
        let said = |name| {
            let mut blanks = self.blanks.iter();
            let of = |blank: &Blank| {
                let mut words = blank.inside.split_whitespace();
                words.next() == Some("is")
                    && words
                        .next()
                        .is_some_and(|is| is.trim_start_matches('!') == name)
            };
            blanks.any(of)
        };
        if let Some(word) = self
            .edition
            .words
            .iter()
            .copied()
            .flatten()
            .find(|word| !said(word.name))
        {
            return Err(BookError::SaidNowhere { name: word.name });
        }
        let book = self.staging.path("book");
        let write = |name: &str, text: &str| put(&book.join(name), text.as_bytes());
        let beside = || {
            for (end, format) in [("txt", Format::Text), ("tex", Format::Latex)] {
                write(&format!("errata.{end}"), &ledger.letter(format)?)?;
                write(&format!("supplement.{end}"), &ledger.supplement(format)?)?;
            }
            write("errata.csv", &super::register(self.edition, &errata)?)?;
            for figure in &figures {
                write(&fill::data_file(figure), &figure.csv)?;
            }
            write(answers::ANSWERS, &answers::answers(&context)?)?;
            if let Some((name, bytes)) = self.edition.picture {
                put(&book.join(name), bytes)?;
            }
            for (name, html) in moved::pages(self.edition) {
                write(name, &html)?;
            }
            let mut files = (self.edition.files)().into_iter().chain(code.pages());
            files.try_for_each(|(name, text)| write(&name, &text))
        };
        let finish = || self.finish(&context, &book, &filled, &self.maths.forms());
        let (finished, written) = rayon::join(finish, beside);
        finished?;
        written?;
        let links = dead_links(&book).map_err(|reason| unwritable(&book, reason))?;
        if !links.is_empty() {
            return Err(BookError::DeadLinks { links });
        }
        self.staging.mark(&book)?;
        let out = self.staging.swap(&book)?;
        Ok(out.join("index.html"))
    }

    fn filled(&self, filler: &Filler<'_>) -> Result<Vec<Filled>, BookError> {
        let one = |blank: &Blank| {
            let filled = filler.fill(blank);
            let filled = filled.and_then(|filled| match filled {
                Filled::Block(_) if !blank.alone => {
                    Err("must stand alone on its line".to_owned().into())
                }
                filled => Ok(filled),
            });
            filled.map_err(|fault| blank.error(&self.pages, fault))
        };
        let filled: Vec<_> = self.blanks.par_iter().map(one).collect();
        // Of several faults, the first in the book is reported.
        filled.into_iter().collect()
    }

    fn finish(
        &self,
        context: &Context<'_>,
        book: &Path,
        filled: &[Filled],
        forms: &Forms,
    ) -> Result<(), BookError> {
        let numbered = equation_links::addresses(context.ledger);
        let whole = |(name, html): &(String, String)| {
            let put_in = |number: usize| {
                let filled = filled.get(number)?;
                let (Filled::Inline(html) | Filled::Block(html)) = filled;
                let html = match name.as_str() {
                    PRINT => on_paper(&self.within_one_page(html)),
                    _ => html.clone(),
                };
                Some((html, matches!(filled, Filled::Block(_))))
            };
            let html = with_blanks(html, put_in);
            let stem = name.trim_end_matches(".html");
            let page = self.pages.iter().find(|page| page.stem == stem);
            let mut topics = self.edition.paper.topics.iter();
            let chapter = page.is_none() || topics.any(|topic| topic.stem == stem);
            let html = if chapter { with_folds(&html) } else { html };
            // The page of all pages is for paper, and the last part is not about this one.
            let about = page.is_some_and(|page| page.part != Part::Use);
            let html = match about {
                true => equation_links::linked(name, &html, &numbered),
                false => html,
            };
            let html = metadata::with_head(self.edition, stem, about, &html, forms);
            (name.clone(), html)
        };
        let pages: Vec<_> = self.html.par_iter().map(whole).collect();
        let index = || {
            let mut search = Search::new(context);
            for (name, html) in pages.iter().filter(|(name, _)| name != PRINT) {
                search.add(name, &forms.with_words(html));
            }
            let index = search.file();
            index.map_err(|error| BookError::Render(error.to_string()))
        };
        let formulas = || {
            let pages = pages.par_iter();
            pages.try_for_each(|(name, html)| {
                put(&book.join(name), forms.with_formulas(html).as_bytes())
            })
        };
        let (index, set) = rayon::join(index, formulas);
        set?;
        put(&book.join("searchindex.js"), index?.as_bytes())
    }

    fn within_one_page(&self, html: &str) -> String {
        const LINK: &str = "href=\"";
        after_each(html, LINK, |part, out| {
            *out += LINK;
            let place = part.split_once(".html#").map(|(stem, _)| stem);
            let page = place.filter(|stem| self.pages.iter().any(|page| page.stem == *stem));
            *out += page.map_or(part, |stem| &part[stem.len() + ".html".len()..]);
        })
    }
}

/// No scripts, and not the values that agree; those that disagree are unfolded.
fn on_paper(html: &str) -> String {
    let html = without(html, "<script", "</script>");
    without(&html, "<details class=\"samples\">", "</details>")
}

/// A mark that is alone in its paragraph stands for all of it.
fn with_blanks(html: &str, put_in: impl Fn(usize) -> Option<(String, bool)>) -> String {
    after_each(html, MARK.0, |part, out| {
        let (number, mut after) = part.split_once(MARK.1).unwrap_or((part, ""));
        if let Some((filled, block)) = number.parse().ok().and_then(&put_in) {
            if let (true, Some(rest)) = (block && out.ends_with("<p>"), after.strip_prefix("</p>"))
            {
                out.truncate(out.len() - "<p>".len());
                after = rest;
            }
            *out += &filled;
        }
        *out += after;
    })
}

fn with_folds(html: &str) -> String {
    const LISTING: [&str; 2] = ["<pre><code class=\"language-rust\">", "</code></pre>"];
    let mut out = String::with_capacity(html.len() + html.len() / 16);
    let mut folds = 0;
    let mut rest = html;
    while let Some(start) = rest.find(LISTING[0]) {
        let (before, listing) = rest.split_at(start);
        let Some(end) = listing.find(LISTING[1]).map(|end| end + LISTING[1].len()) else {
            break;
        };
        folds += before.matches("<details").count();
        folds -= before.matches("</details>").count().min(folds);
        out += before;
        let listing = &listing[..end];
        out += &match folds {
            0 => format!(
                "<details class=\"listing\"><summary>The code that checks this</summary>{listing}</details>"
            ),
            _ => listing.to_owned(),
        };
        rest = &rest[start + end..];
    }
    out + rest
}

fn render(edition: &Edition, source: &Path, book: &Path) -> Result<(), BookError> {
    let failed = |error| BookError::Render(format!("{error:#}"));
    let mut config: Config = assets::settings(edition).parse().map_err(failed)?;
    config.book.title = Some(edition.title.to_owned());
    config.book.description = Some(edition.description.to_owned());
    if let Some(repository) = edition.repository {
        let name = "output.html.git-repository-url";
        config.set(name, repository).map_err(failed)?;
    }
    config.build.build_dir = book.to_owned();
    MDBook::load_with_config(source, config)
        .and_then(|mdbook| mdbook.build())
        .map_err(failed)
}
