//! What this paper's book and command have of their own; [`trialbook::book`] and [`trialbook::cli`] bring the rest.

mod exam;
mod explorer;
mod pages;
mod physics;
mod questions;
mod speed;
#[cfg(test)]
mod tests;
mod words;

use crate::claims::{PAPER, rest::fates};
use crate::{breaks, commands, figures, symbols};
use include_dir::{Dir, include_dir};
use trialbook::publishing::{Edition, Filled, Placeholder, Sources, texts};

/// What stands on the pages between braces, and what fills it.
macro_rules! placeholders {
    ($($name:literal => $fill:expr;)*) => { [$(Placeholder { name: $name, fill: $fill }),*] };
}

/// The book and the command.
pub static EDITION: Edition = Edition {
    version: env!("CARGO_PKG_VERSION"),
    title: "Slipbook",
    description: "Every claim of the paper \"Slipping and rolling on a rough accelerating surface\", tried and judged",
    icon: include_str!("../book/theme/favicon.svg"),
    picture: Some(("share.png", include_bytes!("../book/theme/share.png"))),
    // Once the book is published: `Some("https://…/")`, and where the sources are.
    address: None,
    repository: None,
    pages: pages::WRITTEN,
    moved: pages::MOVED,
    usual: &[],
    figures: || Ok(figures::all()?),
    symbols: symbols::SYMBOLS,
    aliases: include_str!("../book/search.tsv"),
    breaks: |id| {
        let claims = breaks::claims();
        let known = claims.iter().any(|claim| claim.id == id);
        known.then(|| format!("breaking.html#broken?claim={id}"))
    },
    sources: Sources {
        files: sources,
        motion,
    },
    placeholders: &placeholders! {
        "cite" => |_| {
            let [version, by] = [env!("CARGO_PKG_VERSION"), env!("CARGO_PKG_AUTHORS")];
            let licence = env!("CARGO_PKG_LICENSE");
            Ok(Filled::Inline(format!("Slipbook {version}, by {by}; licence {licence}")))
        };
        "explorer" => explorer::place;
        "own-scene" => explorer::own;
        "scene-words" => explorer::words;
        "questions" => questions::all;
        "answer " => questions::one;
        "break" => explorer::breakable;
        "physics" => |_| Ok(physics::table_of());
        "exam" => |_| exam::table_of();
        "exam-errors" => |_| exam::errors();
        "exam-costs" => |_| exam::costs();
        "exam-equal" => |_| exam::equal();
        "exam-runs" => |_| exam::runs();
        "exam-promises" => |_| exam::promises();
        "exam-sat-on" => |_| exam::sat_on();
        "published" => |_| exam::published();
        "sliding" => |_| exam::sliding();
        "sliding-read" => |_| exam::sliding_read();
        "speed" => |_| speed::table_of();
        "growth" => |_| speed::growth();
        "measured-on" => |_| speed::circumstances();
    },
    words: words::WORDS,
    files: explorer::files,
    data: || {
        let records = [
            figures::RECORD,
            fates::RECORD,
            physics::RECORD,
            speed::RESULTS,
        ];
        let texts = explorer::TEXTS.map(|(_, text)| text);
        [&records[..], &texts].concat()
    },
    commands: &commands::ALL,
    examples: &[
        ("verify", "eq-13 eq-82"),
        ("show", "eq-75"),
        ("list", "--verdict refuted --section 4"),
        ("find", "0.53701"),
    ],
    ..Edition::of("slipbook", &PAPER)
};

static SOURCES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/src");

/// The modules whose sources are shown: what the printed side is made of, where the two meet, and the calculators.
const SHOWN: [&str; 5] = ["claims", "corrections", "paper", "solve", "symbols"];

/// Path and text.
fn sources() -> Vec<(String, &'static str)> {
    let own = texts(&SOURCES).into_iter().filter(|(path, _)| {
        path.split(['/', '.'])
            .next()
            .is_some_and(|module| SHOWN.contains(&module))
    });
    let own = own.map(|(path, text)| (path.to_owned(), text));
    let motion = texts(&crate::motion::SOURCES).into_iter();
    own.chain(motion.map(|(path, text)| (format!("motion/src/{path}"), text)))
        .collect()
}

/// The side that knows no formula, for a topic.
#[allow(clippy::unnecessary_wraps)]
fn motion(topic: &str) -> Option<&'static str> {
    Some(match topic {
        "general" | "constant" => "motion/src/particle.rs",
        "sphere" => "motion/src/sphere.rs",
        "turntable" | "escape" | "rest" => "motion/src/turntable.rs",
        _ => "motion/src/drive.rs",
    })
}
