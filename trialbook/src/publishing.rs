//! What the book and the command of a paper have of their own.

use crate::data::{Text, text};
use crate::plotting::Figure;
use crate::seeded::Symbol;
use crate::trials::Paper;
use include_dir::{Dir, DirEntry};

/// Why something of a paper's own could not be made.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A paper's book and command.
///
/// [`Edition::of`] has all that a small paper needs:
///
/// ```
/// use trialbook::trials::Paper;
/// use trialbook::publishing::{Edition, Page};
///
/// static PAPER: Paper = Paper { title: "The thrown stone", ..Paper::BLANK };
/// static EDITION: Edition = Edition {
///     pages: &[Page::new("index", "Stones", "# Stones\n\nWhat is said of them.")],
///     ..Edition::of("stone", &PAPER)
/// };
/// assert_eq!(EDITION.title, "The thrown stone");
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Edition {
    /// The name of the command, of the book's style sheet, and of the file by which a folder is known as its
    /// book.
    pub name: &'static str,
    /// The version of the command; empty if it has none.
    pub version: &'static str,
    /// The title of the book.
    pub title: &'static str,
    /// What the book is, in a sentence.
    pub description: &'static str,
    /// The icon of its pages, an SVG.
    pub icon: &'static str,
    /// The picture where a link to the book is shared: its name within the book, and its bytes.
    pub picture: Option<(&'static str, &'static [u8])>,
    /// Where the book stands on the web, with a slash at its end; without it addresses are relative, and
    /// shared links show no picture.
    pub address: Option<&'static str>,
    /// Where the program is kept, for a link to it.
    pub repository: Option<&'static str>,
    /// The paper.
    pub paper: &'static Paper,
    /// The pages: `index` first, then those of the topics, then all others, part by part. A missing `index`
    /// or page of a topic is made.
    pub pages: &'static [Page],
    /// Where addresses of earlier books lead now: `values.html` is a whole page, whose places keep their
    /// names but for those listed, such as `values.html#index`, and `values.html#old-` for all that begin so.
    pub moved: &'static [(&'static str, &'static str)],
    /// The pages behind those, unless a stem is among them.
    pub usual: &'static [Page],
    /// Draws the figures. The map of claims is drawn anyway.
    pub figures: fn() -> Result<Vec<Figure>, Failure>,
    /// The symbols of the formulas.
    pub symbols: &'static [Symbol],
    /// To what a place answers first in the search, a line each: its address, a tabulator, and with `; `
    /// between them words, found in any question, and phrases, found whole. A claim has its own
    /// ([`Claim::aliases`](crate::trials::Claim)).
    pub aliases: &'static str,
    /// Where the reader may break the formula of this claim: an address.
    pub breaks: fn(&str) -> Option<String>,
    /// The code to show.
    pub sources: Sources,
    /// The placeholders of its own.
    pub placeholders: &'static [Placeholder],
    /// What the words and numbers of its pages are computed by.
    pub words: &'static [&'static [Word]],
    /// The files of its own: path within the book, and text.
    pub files: fn() -> Vec<(String, String)>,
    /// The other texts that all this is made of.
    pub data: fn() -> Vec<Text>,
    /// The commands of its own.
    pub commands: &'static [Command],
    /// The arguments of a command, by its name, in the example of its help, where the first claim would not
    /// do.
    pub examples: &'static [(&'static str, &'static str)],
}

impl Edition {
    /// The book of a paper with only what every paper has, by its command's name.
    pub const fn of(name: &'static str, paper: &'static Paper) -> Self {
        Self {
            name,
            version: "",
            title: paper.title,
            description: "The claims of a paper, tried and judged",
            icon: include_str!("../theme/icon.svg"),
            picture: None,
            address: None,
            repository: None,
            paper,
            pages: &[],
            moved: &[],
            usual: Page::USUAL,
            figures: || Ok(Vec::new()),
            symbols: &[],
            aliases: "",
            breaks: |_| None,
            sources: Sources::NONE,
            placeholders: &[],
            words: &[],
            files: Vec::new,
            data: Vec::new,
            commands: &[],
            examples: &[],
        }
    }

    /// Whether the paper's claims and its pages can be read.
    ///
    /// # Errors
    /// What is wrong, with its file.
    pub fn check(&self) -> Result<(), Failure> {
        let paper = self.paper;
        let faults = paper.check();
        let told = faults.iter().map(ToString::to_string);
        let told: Vec<_> = told.chain(self.strangers()).collect();
        if !told.is_empty() {
            return Err(told.join("\n").into());
        }
        let texts = [
            paper.letter,
            paper.record,
            paper.deep,
            paper.theorems.record,
        ];
        let pages = self.written().map(|page| page.text);
        for text in pages.chain(texts).chain((self.data)()) {
            text.read()?;
        }
        Ok(())
    }

    fn strangers(&self) -> Vec<String> {
        // Of a file that cannot be read nothing is known.
        let Some(ids) = self.paper.ids() else {
            return Vec::new();
        };
        let mut told = Vec::new();
        let mut named = |place: String, words: &str| {
            let ids = words
                .split(' ')
                .filter(|word| is_id(word) && !ids.contains(word));
            told.extend(ids.map(|id| format!("{place}: there is no claim `{id}`")));
        };
        let pages = self
            .written()
            .map(|page| (format!("{}.md", page.stem), page.text));
        let pages = pages.chain([("the letter".to_owned(), self.paper.letter)]);
        for (file, text) in pages {
            let file = match text {
                Text::File(path) => path.to_owned(),
                Text::Built(_) => file,
            };
            // What cannot be read is told elsewhere.
            let mut code = false;
            for (number, line) in (1..).zip(text.read().unwrap_or_default().lines()) {
                code ^= line.starts_with("```");
                let parts = line.split('`').step_by(2).filter(|_| !code);
                let blanks = parts.flat_map(|part| part.split("{{").skip(1));
                let blanks = blanks.filter_map(|blank| blank.split_once("}}"));
                // A figure of the book has a name of its own.
                for (inside, _) in blanks.filter(|(inside, _)| !inside.starts_with("figure ")) {
                    named(format!("{file}, line {number}"), inside);
                }
            }
        }
        for symbol in self.symbols {
            named(format!("the symbol {}", symbol.plain), symbol.claim);
        }
        for formula in (self.paper.formulas.numbers)() {
            named(
                formula.path.to_owned(),
                &formula.claim().unwrap_or_default(),
            );
        }
        for (command, arguments) in self.examples {
            named(format!("the example of `{command}`"), arguments);
        }
        told
    }

    /// The pages that are written: its own, and the usual ones.
    pub fn written(&self) -> impl Iterator<Item = &'static Page> {
        let own = self.pages;
        let missing = |page: &&Page| own.iter().all(|own| own.stem != page.stem);
        own.iter().chain(self.usual.iter().filter(missing))
    }
}

/// `eq-13`, `fig-3`, `s22-no-rest-below`.
fn is_id(word: &str) -> bool {
    let Some((kind, name)) = word.split_once('-') else {
        return false;
    };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    match kind {
        "eq" | "fig" => digits(name),
        _ => kind.strip_prefix('s').is_some_and(digits),
    }
}

/// A part of the table of contents.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The paper, and what follows from it.
    Read,
    /// The verdicts in lists.
    Check,
    /// What they rest on.
    Trust,
    /// For programmers.
    Use,
}

/// A written page, in Markdown; [`crate::book`] lists its placeholders.
#[derive(Debug, Clone)]
pub struct Page {
    /// The file's name without its extension.
    pub stem: &'static str,
    /// The part of the table of contents that it belongs to.
    pub part: Part,
    /// Its name there.
    pub title: &'static str,
    /// Its text.
    pub text: Text,
}

impl Page {
    /// The verdicts at a glance.
    pub(crate) const INDEX: Page =
        Page::of(Part::Read, "index", "Overview", text!("pages/index.md"));
    /// Every claim with its verdict.
    pub const LEDGER: Page = Page::of(
        Part::Check,
        "ledger",
        "The ledger",
        text!("pages/ledger.md"),
    );
    /// All that is known of each claim.
    pub(crate) const SHEETS: Page = Page::of(
        Part::Check,
        "sheets",
        "The sheets",
        text!("pages/sheets.md"),
    );
    /// What is wrong, with the letters about it.
    pub(crate) const ERRATA: Page =
        Page::of(Part::Check, "errata", "Errata", text!("pages/errata.md"));
    /// What the verdicts rest on.
    pub(crate) const METHODS: Page = Page::of(
        Part::Trust,
        "methods",
        "How a verdict comes about",
        text!("pages/methods.md"),
    );

    /// The pages that serve any paper, but for the first one.
    pub const USUAL: &'static [Page] = &[Self::LEDGER, Self::SHEETS, Self::ERRATA, Self::METHODS];

    /// A page to read, by its stem, its title and its text.
    pub const fn new(stem: &'static str, title: &'static str, text: &'static str) -> Self {
        Self::of(Part::Read, stem, title, Text::Built(text))
    }

    /// A page of a part, by its stem, its title and its text.
    pub const fn of(part: Part, stem: &'static str, title: &'static str, text: Text) -> Self {
        Self {
            stem,
            part,
            title,
            text,
        }
    }

    /// The file's name as Markdown.
    pub fn file(&self) -> String {
        format!("{}.md", self.stem)
    }
}

/// The code to show beside the claims.
#[derive(Debug, Clone, Copy)]
pub struct Sources {
    /// The files, by their paths below `src` or, with `/src/` in them, from the top of the repository, and
    /// their texts. In folders, `paper`, `corrections` and `claims` have a file or a folder for each topic.
    pub files: fn() -> Vec<(String, &'static str)>,
    /// The file in which this topic's motion is found without the paper.
    pub motion: fn(&str) -> Option<&'static str>,
}

impl Sources {
    /// No code.
    pub const NONE: Self = Self {
        files: Vec::new,
        motion: |_| None,
    };
}

/// The texts in a folder and below, by their paths.
pub fn texts(folder: &'static Dir<'static>) -> Vec<(&'static str, &'static str)> {
    let mut texts = Vec::new();
    let mut open: Vec<&DirEntry<'_>> = folder.entries().iter().collect();
    while let Some(entry) = open.pop() {
        open.extend(entry.children());
        let text = entry.as_file().and_then(|file| file.contents_utf8());
        texts.extend(entry.path().to_str().zip(text));
    }
    texts
}

/// The [`Sources`] that these files are, without folders; each is named from the file where this stands.
#[macro_export]
macro_rules! sources {
    ($($file:literal),* $(,)?) => {
        $crate::publishing::Sources {
            files: || vec![$(($file.to_owned(), include_str!($file))),*],
            ..$crate::publishing::Sources::NONE
        }
    };
}

pub use sources;

/// What stands in a placeholder's place, as HTML.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Filled {
    /// A value within a line.
    Inline(String),
    /// A block.
    Block(String),
}

/// A word or a number on a page that is computed: `{{is name falls|rises}}`, `{{is name six}}`.
#[derive(Debug, Clone, Copy)]
pub struct Word {
    /// Its name.
    pub name: &'static str,
    /// The number; or which of the words it is, from 0.
    pub is: fn() -> Result<f64, Failure>,
}

/// A placeholder: `{{name}}`; `{{name …}}`, if its name ends with a blank.
#[derive(Debug, Clone, Copy)]
pub struct Placeholder {
    /// What stands between the braces.
    pub name: &'static str,
    /// What fills it, from the page's stem or, of a name that ends with a blank, from what stands behind.
    pub fill: fn(&str) -> Result<Filled, Failure>,
}

/// In which form a command answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// A table.
    Csv,
}

/// A command beside those of every paper.
#[derive(Debug, Clone, Copy)]
pub struct Command {
    /// Its arguments and its help.
    pub command: fn() -> clap::Command,
    /// Runs it, and returns the exit code.
    pub run: fn(&clap::ArgMatches, Format) -> Result<u8, Failure>,
}
