//! The book in a real browser, opened from the disk.
//!
//! Without a Chromium these tests are skipped, and say so, unless `SLIPBOOK_BROWSER=require` is set, as by `.ci/run`. What a
//! reader waits for is allowed ten times as long here as it is meant to take; `cargo bench --test browser` allows no more.

mod access;
mod chrome;
mod explorers;
mod figures;
mod measures;
mod own;
mod pages;
mod paper;
mod scenes;
mod visit;

use chrome::{Browser, Page, Seen};
use libtest_mimic::{Arguments, Trial};
use slipbook::book::files_below;
use slipbook::edition::EDITION;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::{Arc, OnceLock};
use std::thread;
use tempfile::TempDir;
use visit::Visit;

const TABS: usize = 3;

type Test = fn(&mut Page, &Book) -> Seen;

const TESTS: [(&str, Test); 35] = [
    (
        "every_page_loads_without_a_complaint_or_a_request",
        pages::load,
    ),
    (
        "every_link_and_every_fragment_leads_somewhere",
        pages::links,
    ),
    ("search_finds_equations_and_symbols", pages::search),
    ("the_contents_open_by_keyboard", pages::contents),
    ("no_page_is_wider_than_a_phone", pages::narrow),
    (
        "without_scripts_the_still_figures_stand_in_their_places",
        pages::without_scripts,
    ),
    (
        "the_page_for_printing_keeps_the_still_figures",
        pages::printing,
    ),
    ("no_figure_shows_its_markup", pages::labels),
    ("words_in_pictures_keep_apart", figures::apart),
    ("the_whole_map_can_be_read", figures::map),
    (
        "explorers_answer_keys_sliders_mouse_and_addresses",
        explorers::desk,
    ),
    ("explorers_move_by_touch", explorers::touch),
    ("bodies_move_on_every_stage", explorers::stages),
    ("pictures_are_those_of_the_crate", scenes::pictures),
    (
        "a_scene_is_its_link_its_fields_and_its_command",
        own::scenes,
    ),
    ("explorers_lead_to_their_scenes", own::as_scenes),
    ("a_recording_that_is_dropped_is_followed", own::recordings),
    ("boxes_fold_and_unfold", pages::folds),
    ("pages_keep_their_length", pages::lengths),
    ("the_first_page_answers", pages::front),
    ("a_formula_can_be_broken", explorers::broken),
    ("long_tables_filter_and_sort", pages::filters),
    ("old_addresses_lead_on", pages::moved),
    ("no_explorer_shows_its_markup", explorers::labels),
    (
        "a_view_can_be_linked_and_fragments_still_work",
        explorers::addresses,
    ),
    ("every_answer_comes_in_time", measures::answers),
    ("every_slider_shows_its_picture_in_time", measures::sliders),
    ("every_picture_is_drawn_in_time", measures::frames),
    ("a_phone_shows_all", measures::phone),
    ("all_pages_in_one_come_in_time", measures::paper),
    ("nothing_on_paper_is_too_small_to_read", paper::sizes),
    ("nothing_lies_over_the_sheets", paper::sheets),
    ("what_one_points_at_is_said", measures::cards),
    ("pages_are_accessible", access::pages),
    ("themes_are_accessible", access::themes),
];

const TIMED: [&str; 4] = [
    "every_answer_comes_in_time",
    "every_slider_shows_its_picture_in_time",
    "every_picture_is_drawn_in_time",
    "all_pages_in_one_come_in_time",
];

pub fn timed_alone() -> bool {
    env::args().any(|argument| argument == "--bench")
}

fn main() -> ExitCode {
    let alone = timed_alone();
    let arguments = Arguments {
        test_threads: Some(if alone { 1 } else { TABS }),
        bench: false,
        ..Arguments::from_args()
    };
    let required = env::var("SLIPBOOK_BROWSER").is_ok_and(|value| value == "require");
    let path = chrome::find();
    let skipped = path.is_none() && !required;
    let shared = Arc::new(Shared {
        path,
        ..Shared::default()
    });
    let chosen = TESTS
        .into_iter()
        .filter(|(name, _)| !alone || TIMED.contains(name));
    let trials = chosen.map(|(name, test)| {
        let shared = Arc::clone(&shared);
        let trial = Trial::test(name, move || Ok(shared.run(test)?));
        trial.with_ignored_flag(skipped)
    });
    let conclusion = libtest_mimic::run(&arguments, trials.collect());
    if skipped {
        println!(
            "The tests in a browser were skipped: no Chromium on the search path. To run them, install Debian's \
             package chromium or Google Chrome, then: cargo test --test browser\n"
        );
    }
    conclusion.exit_code()
}

#[derive(Default)]
struct Shared {
    path: Option<PathBuf>,
    book: OnceLock<Seen<Book>>,
    browser: OnceLock<Seen<Running>>,
}

struct Running {
    browser: Browser,
    _data: TempDir,
}

impl Running {
    fn start(path: &Path) -> Seen<Self> {
        let data = tempfile::tempdir().map_err(|error| error.to_string())?;
        Ok(Running {
            browser: Browser::start(path, data.path())?,
            _data: data,
        })
    }
}

impl Shared {
    fn run(&self, test: Test) -> Seen {
        let path = self.path.as_ref().ok_or("no Chromium on the search path")?;
        let (book, running) = thread::scope(|scope| {
            let browser = || self.browser.get_or_init(|| Running::start(path));
            let starting = scope.spawn(browser);
            let book = self.book.get_or_init(Book::write).as_ref();
            drop(starting.join());
            (book, browser().as_ref())
        });
        let (book, running) = (book.map_err(Clone::clone)?, running.map_err(Clone::clone)?);
        test(&mut running.browser.page()?, book)
    }
}

pub struct Book {
    folder: TempDir,
    pub pages: Vec<String>,
    visits: OnceLock<Seen<BTreeMap<String, Visit>>>,
}

impl Book {
    fn write() -> Seen<Self> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let out = folder.path().join("book");
        let mut command = Command::new(env!("CARGO_BIN_EXE_slipbook"));
        let output = command
            .arg("--out")
            .arg(&out)
            .output()
            .map_err(|error| error.to_string())?;
        if output.status.code() == Some(2) {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        let files = files_below(&out).map_err(|error| error.to_string())?;
        let leads_on = |name: &String| EDITION.moved.iter().any(|(from, _)| from == name);
        let mut pages: Vec<_> = files
            .into_keys()
            .filter(|name| name.ends_with(".html") && !leads_on(name))
            .collect();
        // So that no tab is left alone with a long one in the end.
        let length = |page: &String| fs::metadata(out.join(page)).map_or(0, |file| file.len());
        pages.sort_by_cached_key(|page| (Reverse(length(page)), page.clone()));
        Ok(Book {
            folder,
            pages,
            visits: OnceLock::new(),
        })
    }

    pub fn folder(&self) -> PathBuf {
        self.folder.path().join("book")
    }

    pub fn address(&self, page: &str) -> String {
        address_of(&self.folder().join(page))
    }

    /// Not the page for printing, nor mdBook's own frame of the contents, nor a source file.
    pub fn is_chapter(&self, page: &str) -> bool {
        !page.contains('/') && !["print.html", "toc.html"].contains(&page)
    }
}

fn address_of(path: &Path) -> String {
    format!("file://{}", path.display())
}
