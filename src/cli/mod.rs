//! The command line: what a reader may ask, and how the answer is printed.
//!
//! The exit code is 0 when every verdict that was computed is the recorded one, 1 when one differs, 2 for bad usage,
//! bad input or a failure. After a failure there is nothing on standard output, but for `ensemble`, which writes as it
//! goes.

mod ensemble;
mod find;
mod ledger;
mod output;
mod plot;
mod solve;

use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use output::{Failure, Format};
use std::path::PathBuf;
use std::process::ExitCode;

/// Tries every claim of the paper, prints what each is worth, and writes the book.
///
/// Exit code 0 when every verdict is the recorded one, 1 when one differs, 2 for bad usage or a failure.
#[derive(Parser)]
#[command(
    name = "slipbook",
    version,
    after_help = "Examples:
  slipbook                          verify, then write the book into target/book
  slipbook --out book --jobs 2      the same into another folder, on two threads
  slipbook solve turntable --help   a calculator, with examples of its own"
)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    /// Folder to write the book into; an earlier book there is replaced as a whole [default: target/book]
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    #[command(flatten)]
    common: Common,
}

/// What every command takes.
#[derive(Args)]
struct Common {
    /// Write JSON; the book's page "Answers as JSON" describes it
    #[arg(long, global = true, conflicts_with = "csv")]
    json: bool,
    /// Write a table of comma-separated values
    #[arg(long, global = true)]
    csv: bool,
    /// How many threads may work [default: one per core]
    #[arg(long, global = true, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
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
    /// Try claims and hold their verdicts against the record; all claims if none is named
    #[command(after_help = "Example:\n  slipbook verify eq-13 eq-82")]
    Verify {
        /// Ids of claims, as `list` prints them
        #[arg(value_name = "ID")]
        ids: Vec<String>,
    },
    /// Try one claim and show all that is known of it
    #[command(after_help = "Example:\n  slipbook show eq-75")]
    Show {
        /// Id of the claim
        id: String,
    },
    /// Try claims and list them with their verdicts
    #[command(after_help = "Example:\n  slipbook list --verdict refuted --section 4")]
    List {
        /// Only claims of this verdict
        #[arg(long, value_parser = ledger::verdicts())]
        verdict: Option<String>,
        /// Only claims of this section of the paper
        #[arg(long, value_parser = ledger::sections())]
        section: Option<String>,
    },
    /// Print what is printed wrongly, with what is right
    #[command(after_help = "Example:\n  slipbook errata --format latex")]
    Errata {
        /// How to print it
        #[arg(long, value_enum, default_value_t = ledger::ErrataFormat::Text, conflicts_with_all = ["json", "csv"])]
        format: ledger::ErrataFormat,
    },
    /// Find the claims that carry a number, to the digits given, and mark its first wrong digit
    #[command(after_help = "Example:\n  slipbook find 0.53701")]
    Find {
        /// The number, as it is printed somewhere
        #[arg(allow_negative_numbers = true)]
        number: String,
    },
    /// Calculate at parameters of your own, by formula and by motion
    #[command(
        after_help = "Example:\n  slipbook solve constant --lambda 0.5 --v0 1 --theta0 1 --time 2 --plot\n\n\
                      A number of up to 15 digits is taken as it stands, a longer one as the floating-point number next to it."
    )]
    Solve(solve::Solve),
    /// Follow many particles on a turntable and say where each ends; rows come while the work goes on
    #[command(
        after_help = "Example:\n  slipbook ensemble --rho 0.5 --p 0:1.5:1000 --psi=-3.14:3.14:1000 --csv > ends.csv\n\n\
                      Ctrl-C ends it after the present piece of work: the rows so far are whole, the exit code is 130."
    )]
    Ensemble(ensemble::Ensemble),
    /// Print a script that completes the command line in a shell
    #[command(after_help = "Example:\n  slipbook completions bash > slipbook.bash")]
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// What the command line may say: commands, options, their values and help.
pub fn command() -> clap::Command {
    Arguments::command()
}

/// Runs the command line of this process.
pub fn run() -> ExitCode {
    let arguments = Arguments::parse();
    match answer(&arguments) {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            output::complain(&error.to_string());
            ExitCode::from(2)
        }
    }
}

fn answer(arguments: &Arguments) -> Result<u8, Failure> {
    if let Some(jobs) = arguments.common.jobs {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs.into());
        pool.build_global()?;
    }
    let format = arguments.common.format();
    let Some(command) = &arguments.command else {
        let out = arguments.out.clone();
        return ledger::main_job(&out.unwrap_or("target/book".into()), format);
    };
    if arguments.out.is_some() {
        return Err("--out goes without a command: it says where the book is written".into());
    }
    match command {
        Command::Verify { ids } => ledger::verify(ids, format),
        Command::Show { id } => ledger::show(id, format),
        Command::List { verdict, section } => {
            ledger::list(verdict.as_deref(), section.as_deref(), format)
        }
        Command::Errata { format: kind } => ledger::print_errata(*kind, format),
        Command::Find { number } => find::find(number, format),
        Command::Solve(solve) => solve.run(format),
        Command::Ensemble(ensemble) => ensemble.run(format),
        Command::Completions { shell } => completions(*shell, format),
    }
}

fn completions(shell: Shell, format: Format) -> Result<u8, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command(), "slipbook", &mut script);
    let script = String::from_utf8(script)?;
    match format {
        Format::Text => output::say(&script)?,
        Format::Json => output::json(&serde_json::json!({
            "version": output::VERSION,
            "shell": shell.to_string(),
            "script": script,
        }))?,
        Format::Csv => return Err(output::no_table()),
    }
    Ok(0)
}
