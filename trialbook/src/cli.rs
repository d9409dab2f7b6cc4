//! The command line: what a reader may ask of a paper, and how the answer is printed.
//!
//! The exit code is 0 when every verdict that was computed is the recorded one, 1 when one differs, 2 for bad usage,
//! bad input or a failure. After a failure there is nothing on standard output, unless a command of the paper's own writes
//! as it goes.

mod deep;
mod distrust;
mod find;
mod ids;
mod ledger;
mod output;
mod schema;
mod screen;
mod shard;
mod table;
mod theorems;

pub use crate::book::bare;
pub use crate::notation::ascii;
pub use crate::stop;
use output::no_table;
pub use output::{VERSION, bom, complain, csv, json, say, show, unwritten};
pub use schema::{Described, Field, described};
pub use screen::{Screen, progress, screen};
pub use shard::Shard;

use crate::publishing::{Edition, Failure, Format};
use clap::{ArgMatches, Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use clap_complete::Shell;
use std::env;
use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Tries every claim of the paper, prints what each is worth, and writes the book.
///
/// Exit code 0 when every verdict is the recorded one, 1 when one differs, 2 for bad usage or a failure.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    /// Folder to write the book into; an earlier book there is replaced as a whole [default: target/book, in a crate's folder]
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    #[command(flatten)]
    common: Common,
}

/// What every command takes.
#[derive(Args)]
struct Common {
    /// Write JSON
    #[arg(long, global = true, conflicts_with = "csv", display_order = 900)]
    json: bool,
    /// Write a table of comma-separated values
    #[arg(long, global = true, display_order = 901)]
    csv: bool,
    /// Begin the table with the mark by which Excel knows UTF-8
    #[arg(long, global = true, requires = "csv", display_order = 901)]
    bom: bool,
    /// Number of threads to use [default: one per core]
    #[arg(long, short, global = true, value_name = "N", display_order = 902, allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Show no progress, and only the verdicts that differ from the record
    #[arg(long, short, global = true, display_order = 903)]
    quiet: bool,
    /// Colours
    #[arg(
        long,
        global = true,
        value_name = "WHEN",
        display_order = 904,
        value_enum,
        default_value_t
    )]
    color: screen::Color,
    /// Rounds of trials to make, each at other points; for the main job, verify, show, and list and errata, which try then [default: 1]
    #[arg(long, global = true, value_name = "N", display_order = 905, allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    depth: Option<u32>,
}

impl Common {
    fn format(&self) -> Format {
        match (self.json, self.csv) {
            (true, _) => Format::Json,
            (_, true) => Format::Csv,
            _ => Format::Text,
        }
    }
}

#[derive(Subcommand)]
enum Command {
    /// Try claims and compare their verdicts with the record; all claims if none is named
    Verify {
        /// Ids of claims, as `list` prints them
        #[arg(value_name = "ID")]
        ids: Vec<String>,
        /// Only the rounds of the K-th of N equal parts of a deep run, for --parts
        #[arg(long, value_name = "K/N", requires = "depth", conflicts_with_all = ["json", "csv"])]
        shard: Option<Shard>,
        /// Instead of trying, join what the parts of a deep run have printed, in any order: the same answer, byte for byte
        #[arg(long, value_name = "FILE", requires = "depth", num_args = 1.., conflicts_with = "shard")]
        parts: Vec<PathBuf>,
    },
    /// Seed mistakes in the formulas, and see which trial notices which: slow for all claims
    ///
    /// Exit code 1 if a trial that agrees notices no mistake and no reason is on record, or if what it finds without the paper changes.
    Distrust {
        /// Ids of claims, as `list` prints them
        #[arg(value_name = "ID")]
        ids: Vec<String>,
    },
    /// List the theorems that a proof assistant's kernel has accepted; of claims that are named, with their statements; a theorem
    /// by its own name, `eq_13`, with all that its statement uses
    Theorems {
        /// Ids of claims, as `list` prints them, or names of theorems
        #[arg(value_name = "ID")]
        ids: Vec<String>,
        #[command(flatten)]
        wanted: theorems::Wanted,
    },
    /// Try claims and show all that is known of them
    Show {
        /// Ids of claims: `13`, `(13)` and `eq13` are `eq-13`; the beginning of an id will do if no other begins so
        #[arg(value_name = "ID", required = true)]
        ids: Vec<String>,
    },
    /// List claims with their verdicts, as they are recorded; with --try they are tried
    List(ledger::List),
    /// Print the errata: what is wrong in print, and what is right; of what is recorded, unless --try is given
    Errata(ledger::Errata),
    /// Find the claims that carry a number, or speak of words
    ///
    /// Of a number it marks the first wrong digit; a single digit has to be all of the number. An equation is `(38)`. Words are looked
    /// for in titles, ids, statements, conditions, corrections and names of theorems; all have to be there. Exit code 1 if nothing is found.
    Find {
        /// A number as it is printed somewhere, an expression such as `2/sqrt(4+pi^2)`, or words; all numbers if none is given
        #[arg(value_name = "WHAT", allow_hyphen_values = true, value_parser = find::no_option)]
        what: Option<String>,
        /// More words
        #[arg(value_name = "WORD")]
        more: Vec<String>,
    },
    /// Print the manual page
    Man,
    /// Print the JSON Schema of what the commands write with --json
    Schema,
    /// Print a script that completes the command line in a shell
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// What the command line may say: commands, options, their values and help.
pub fn command(edition: &Edition) -> clap::Command {
    let (name, paper) = (edition.name, edition.paper);
    let sections = ledger::sections(paper);
    let mut command = Arguments::command().name(name).bin_name(name);
    command = command.mut_subcommand("list", |list| {
        list.mut_arg("section", |section| section.value_parser(sections))
    });
    for of in ["verify", "show", "distrust", "theorems"] {
        let ids = |ids: clap::Arg| ids.value_parser(ids::Ids(paper)).hide_possible_values(true);
        command = command.mut_subcommand(of, |of| of.mut_arg("ids", ids));
    }
    for (i, own) in edition.commands.iter().enumerate() {
        command = command.subcommand((own.command)().display_order(OWN + i));
    }
    if !edition.version.is_empty() {
        command = command.version(edition.version);
    }
    if let Some(page) = edition.written().find(|page| page.stem == "json") {
        let title = page.title;
        let help = format!("Write JSON; the book's page \"{title}\" describes it");
        command = command.mut_arg("json", |json| json.help(help));
    }
    let first = paper.claims().next().map_or("", |(_, claim)| claim.id);
    let bash = format!("bash > {name}.bash");
    let page = format!("> {name}.1");
    for (order, of, usual) in [
        (0, "verify", first),
        (1, "show", first),
        (2, "list", "--verdict misprint,wrong"),
        (
            3,
            "errata",
            "--format latex --from 'A. Person/Some University'",
        ),
        (4, "find", "0.5"),
        (5, "distrust", first),
        (6, "theorems", first),
        (900, "completions", &bash),
        (901, "man", &page),
        (902, "schema", "> schema.json"),
    ] {
        let mut examples = edition.examples.iter();
        let arguments = examples.find(|example| example.0 == of);
        let arguments = arguments.map_or(usual, |example| example.1);
        let example = format!("Example:\n  {name} {of} {arguments}");
        command = command.mut_subcommand(of, |of| of.display_order(order).after_help(example));
    }
    let [one, two] = [
        "verify, then write the book into target/book",
        "the same into another folder, on two threads",
    ];
    let there = format!("{name} --out book --jobs 2");
    let width = there.len() + 2;
    let columns = screen::columns().unwrap_or(0);
    command.term_width(columns).after_help(format!(
        "Examples:\n  {name:<width$}{one}\n  {there:<width$}{two}\n\n\
         COLUMNS sets the width of tables, PAGER the program that shows long answers on a terminal, NO_COLOR turns colours off."
    ))
}

// The options that the program gives to itself, and whoever renews the record: no help and no completion names them. A
// comment of documentation would become the help of `verify`.
#[derive(Args)]
struct Inner {
    /// Only print what the round of this number brings
    #[arg(long, hide = true, value_name = "N", conflicts_with_all = ["depth", "shard", "parts"])]
    round: Option<u64>,
    /// Only print the record of a deep run, made so: "commit 64820c8f, 2026-11-26"
    #[arg(long, hide = true, value_name = "MADE", requires = "depth", conflicts_with_all = ["ids", "shard", "json", "csv"])]
    record: Option<String>,
}

/// What the command line may say, and what help and completion leave out.
fn whole(edition: &Edition) -> clap::Command {
    command(edition).mut_subcommand("verify", Inner::augment_args)
}

/// Where the commands of the paper's own stand in the help: behind `theorems`.
const OWN: usize = 7;

/// Runs the command line of this process.
pub fn run(edition: &Edition) -> ExitCode {
    ExitCode::from(exit_code(edition, said(edition, env::args_os())))
}

/// The answer to a command line. Where something is wrong in the files of the claims, no command knows what it would say.
fn said(edition: &Edition, words: impl Iterator<Item = OsString>) -> Result<u8, Failure> {
    edition.check()?;
    match whole(edition).try_get_matches_from(words) {
        Ok(matches) => answer(edition, &matches),
        Err(help) => told(&help),
    }
}

/// Prints help, a version, or what is wrong with the command line.
fn told(help: &clap::Error) -> Result<u8, Failure> {
    match help.print().and_then(|()| io::stdout().flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe && !help.use_stderr() => {
            Err(unwritten(error).into())
        }
        _ => Ok(u8::try_from(help.exit_code())?),
    }
}

/// The exit code of an answer; of a failure standard error says what it is.
fn exit_code(edition: &Edition, answer: Result<u8, Failure>) -> u8 {
    answer.unwrap_or_else(|error| {
        complain(edition.name, &error.to_string());
        2
    })
}

fn answer(edition: &Edition, matches: &ArgMatches) -> Result<u8, Failure> {
    let common = Common::from_arg_matches(matches)?;
    if let Some(jobs) = common.jobs {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs.into());
        pool.build_global()?;
    }
    screen::settle(common.color, common.quiet);
    output::settle(common.bom);
    let format = common.format();
    let depth = deep::Depth {
        rounds: common.depth.unwrap_or(1),
        jobs: common.jobs,
        parts: Vec::new(),
    };
    let out = matches.get_one::<PathBuf>("out");
    let Some((name, of_command)) = matches.subcommand() else {
        let usual = usual_folder(edition, Path::new("."));
        let out = out.map_or_else(|| usual, |out| Ok(out.clone()))?;
        return ledger::main_job(edition, &out, &depth, format);
    };
    if out.is_some() {
        return Err("--out goes without a command: it says where the book is written".into());
    }
    let tries = ["verify", "show", "list", "errata"];
    if common.depth.is_some() && !tries.contains(&name) {
        return Err(format!(
            "--depth goes without a command or with {}",
            tries.join(", ")
        )
        .into());
    }
    let mut own = edition.commands.iter();
    if let Some(own) = own.find(|own| (own.command)().get_name() == name) {
        return (own.run)(of_command, format);
    }
    let paper = edition.paper;
    match Command::from_arg_matches(matches)? {
        Command::Verify { ids, shard, parts } => {
            let Inner { round, record } = Inner::from_arg_matches(of_command)?;
            let depth = deep::Depth { parts, ..depth };
            match (round, shard, record) {
                (Some(round), ..) => ledger::round(edition, &ids, round),
                (_, Some(shard), _) => deep::part(&ids::known_all(edition, &ids)?, shard, &depth),
                (.., Some(made)) => ledger::record(paper, &made, &depth),
                _ => ledger::verify(edition, &ids, &depth, format),
            }
        }
        Command::Distrust { ids } => {
            let ids = ids::known_all(edition, &ids)?;
            distrust::distrust(edition, &ids, format)
        }
        Command::Theorems { ids, wanted } => theorems::theorems(edition, &ids, &wanted, format),
        Command::Show { ids } => ledger::show(edition, &ids, &depth, format),
        Command::List(asked) => ledger::list(edition, &asked, &depth, format),
        Command::Errata(asked) => ledger::print_errata(edition, &asked, &depth, format),
        Command::Find { what: None, .. } => find::all(paper, format),
        Command::Find {
            what: Some(what),
            more,
        } => find::find(edition, &[&[what][..], &more].concat().join(" "), format),
        Command::Man => man(edition, format),
        Command::Schema => schema::schema(edition, format),
        Command::Completions { shell } => completions(edition, shell, format),
    }
}

/// Where the book goes if nobody says: `target/book`, in a crate's own folder only.
fn usual_folder(edition: &Edition, here: &Path) -> Result<PathBuf, Failure> {
    let name = edition.name;
    match here.join("Cargo.toml").is_file() {
        true => Ok(here.join("target").join("book")),
        false => Err(format!(
            "where shall the book go? `{name} --out FOLDER` says so; without it, it goes to target/book in the folder of a \
             crate only. `{name} verify` writes none"
        )
        .into()),
    }
}

/// The manual page: all commands with their options, and their commands with theirs.
fn man(edition: &Edition, format: Format) -> Result<u8, Failure> {
    if format != Format::Text {
        return Err("--json, --csv: a manual page is neither".into());
    }
    let mut command = command(edition);
    command.build();
    let mut page = Vec::new();
    clap_mangen::Man::new(command.clone()).render(&mut page)?;
    let mut open: Vec<_> = command.get_subcommands().cloned().collect();
    open.reverse();
    while let Some(command) = open.pop() {
        if command.get_name() == "help" {
            continue;
        }
        let name = command.get_bin_name().unwrap_or_default().to_owned();
        let (title, man) = (
            format!(".SH \"{}\"\n", name.to_uppercase()),
            clap_mangen::Man::new(command.clone()),
        );
        page.extend(title.as_bytes());
        man.render_description_section(&mut page)?;
        man.render_synopsis_section(&mut page)?;
        man.render_options_section(&mut page)?;
        let mut below: Vec<_> = command.get_subcommands().cloned().collect();
        below.reverse();
        open.append(&mut below);
    }
    say(&String::from_utf8(page)?)?;
    Ok(0)
}

fn completions(edition: &Edition, shell: Shell, format: Format) -> Result<u8, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command(edition), edition.name, &mut script);
    let script = String::from_utf8(script)?;
    match format {
        Format::Text => say(&script)?,
        Format::Json => json(&serde_json::json!({
            "version": VERSION,
            "shell": shell.to_string(),
            "script": script,
        }))?,
        Format::Csv => return Err(no_table()),
    }
    Ok(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::publishing::Page;
    use crate::trials::{Paper, Topic, read::File};
    use std::fs;

    #[test]
    fn a_damaged_file_of_claims_is_told_by_every_command() {
        let text = "[eq-1]\ntitel = 'speed'\nlatex = 'v'\n[eq-2]\ntitle = '$v'\nlatex = 'v'";
        let topic: &_ = Box::leak(Box::new(Topic::new("stone", "", File::here(text), &[])));
        let topics = vec![topic].leak();
        let paper = Box::leak(Box::new(Paper {
            topics,
            ..Paper::BLANK
        }));
        let edition = Edition::of("stone", paper);
        for line in [
            "",
            "--version",
            "--help",
            "list",
            "show 1",
            "man",
            "completions bash",
        ] {
            let words = ["stone"].into_iter().chain(line.split_whitespace());
            let answer = said(&edition, words.map(OsString::from));
            let told = answer.as_ref().unwrap_err().to_string();
            let all = ["unknown field `titel`", "a `$` has no partner"];
            assert!(
                all.iter().all(|fault| told.contains(fault)),
                "{line}: {told}"
            );
            assert_eq!(exit_code(&edition, answer), 2);
        }
    }

    /// What the main job says to a book whose first page has this text.
    fn main_job(text: &'static str, out: &std::path::Path) -> Result<u8, Failure> {
        let edition = Edition {
            pages: vec![Page::new("index", "Stones", text)].leak(),
            ..Edition::of("stone", &Paper::BLANK)
        };
        let out = out.to_str().ok_or("no name")?;
        let said = whole(&edition).get_matches_from(["stone", "--csv", "--out", out]);
        answer(&edition, &said)
    }

    #[test]
    fn a_dead_link_ends_the_main_job_and_is_named_with_its_page() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("book");
        let edition = Edition::of("stone", &Paper::BLANK);
        let alive = "# Stones {#s}\n\n[a](#s), [b](errata.md), [c](https://doi.org/1).";
        assert_eq!(exit_code(&edition, main_job(alive, &out)), 0);
        let before = fs::read_to_string(out.join("index.html")).unwrap();
        for (page, link) in [
            ("# Stones\n\n[a](#sand)", "index.html: #sand"),
            ("# Stones\n\n[a](sand.md)", "index.html: sand.html"),
            (
                "# Stones\n\n[a](errata.md#sand)",
                "index.html: errata.html#sand",
            ),
            ("# Stones\n\n![a](sand.svg)", "index.html: sand.svg"),
        ] {
            let answer = main_job(page, &out);
            let why = answer.as_ref().unwrap_err().to_string();
            assert!(why.contains(link), "{why}");
            assert_eq!(exit_code(&edition, answer), 2);
        }
        let after = fs::read_to_string(out.join("index.html")).unwrap();
        assert!(
            before == after,
            "a book with a dead link took the place of one without"
        );
    }
}
