//! The commands of this paper's own: calculators, and the exam.

mod axis;
mod ensemble;
mod exam;
mod measure;
mod pieces;
mod plot;
mod question;
mod scene;
mod solve;
mod sweep;

use clap::{Args, FromArgMatches};
use serde_json::Value;
use trialbook::cli::{json, show};
use trialbook::publishing::{Command, Failure, Format};

/// What takes an answer: JSON, or a text as such.
type Json<'a> = &'a mut dyn FnMut(&Value) -> Result<(), Failure>;

/// What `scene` or `measure` with these words answers: JSON, or a text as such.
pub(crate) fn answered(words: &[String], format: Format) -> Result<Value, Failure> {
    let mut answer = Value::Null;
    let keep: Json = &mut |whole| {
        answer = whole.clone();
        Ok(())
    };
    let of = |command: clap::Command| command.try_get_matches_from(words);
    match words {
        [first, ..] if first == "measure" => measure::run(&of(measure::command())?, format, keep)?,
        [first, ..] if first == "scene" => scene::run(&of(scene::command())?, format, keep)?,
        _ => return Err("neither `scene` nor `measure`".into()),
    };
    Ok(answer)
}

fn print(answer: &Value) -> Result<(), Failure> {
    match answer {
        Value::String(text) => Ok(show(text)?),
        answer => json(answer),
    }
}

/// All of them.
pub(crate) const ALL: [Command; 5] = [
    Command {
        command: measure::command,
        run: |matches, format| measure::run(matches, format, &mut print),
    },
    Command {
        command: scene::command,
        run: |matches, format| scene::run(matches, format, &mut print),
    },
    Command {
        command: || {
            solve::command()
                .about("Calculate at parameters of your own, by formula and by motion")
                .after_help(
                    "Example:\n  slipbook solve constant --lambda 0.5 --v0 1 --theta0 1 --time 2 --plot\n  slipbook solve sinusoidal --lambda0 0.1:1:10 --csv\n\n\
                     A number may be an expression: pi/2, 120deg, 2/sqrt(4+pi^2). In the place of a number 0.1,0.5,0.7 asks at each of these, a row \
                     each, LOW:HIGH:COUNT at COUNT equally spaced ones, and LOW:HIGH:COUNT:log at such with equal ratios; several such make a grid, the last one \
                     running fastest. Ctrl-C ends it after the present piece of work: the rows so far are whole, the exit code is 130.\n\n\
                     Each number of an answer has its unit, in the paper's letters. In metres and seconds it is asked as a scene: `slipbook scene --help`.\n\n\
                     A number of up to 15 digits is taken as it stands, a longer one as the floating-point number next to it.",
                )
        },
        run: solve::run,
    },
    Command {
        command: || {
            let ensemble = ensemble::Ensemble::augment_args(clap::Command::new("ensemble"))
                .about("Follow many particles on a turntable and say where each ends; rows are written as the work goes on");
            solve::directed(ensemble, crate::solve::axes::TABLE)
                .after_help(
                    "Example:\n  slipbook ensemble --rho 0.5 --p 0:1.5:1000 --psi=-3.14:3.14:1000 --csv > ends.csv\n\n\
                     With --shard 3/16 a job does its part of sixteen. A start out of range is a row that says why.\n\n\
                     Ctrl-C ends it after the present piece of work: the rows so far are whole, the exit code is 130.",
                )
        },
        run: |matches, format| ensemble::Ensemble::from_arg_matches(matches)?.run(format),
    },
    Command {
        command: || {
            exam::Exam::augment_args(clap::Command::new("exam"))
                .about("Print the questions of an exam in dry friction, with answers that can be relied on")
                .after_help("Example:\n  slipbook exam --json > exam.json\n  slipbook exam stop-place rest-fraction\n  slipbook exam --package friction-exam")
        },
        run: |matches, format| exam::Exam::from_arg_matches(matches)?.run(format),
    },
];
