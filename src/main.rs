//! The command; [`slipbook::cli`] reads it and answers.

use std::process::ExitCode;

fn main() -> ExitCode {
    slipbook::cli::run(&slipbook::edition::EDITION)
}
