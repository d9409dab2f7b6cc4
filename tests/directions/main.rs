//! Words with a direction: in the statements of the claims each has a trial that notices mistakes; in the captions of the
//! figures each is tried on the figure's own numbers, and on the pages each is computed, or listed as one that is not.

mod captions;
mod chosen;
mod data;
mod drawn;
mod pages;
mod said;
mod tried;

use slipbook::claims::PAPER;
use std::collections::BTreeSet;

/// Words that would be false the other way round.
const DIRECTED: &[&str] = &[
    "above",
    "always",
    "attracts",
    "backward",
    "below",
    "bounded",
    "decreases",
    "exceeds",
    "exponentially",
    "falls",
    "farther",
    "faster",
    "forward",
    "grows",
    "increases",
    "large",
    "larger",
    "less",
    "linearly",
    "loses",
    "more",
    "never",
    "only",
    "positive",
    "negative",
    "repels",
    "rises",
    "shrinks",
    "slower",
    "slowly",
    "small",
    "smaller",
    "stops",
    "strong",
    "tangent",
    "unbounded",
    "vanishes",
    "weak",
];

/// The claims without a formula of their own: their words with a direction, in order, and the trial that would fail if
/// one was turned round.
const STATEMENTS: &[(&str, &str, &str)] = &[
    (
        "s2-stops-if-weak",
        "weak below falls",
        "properties::stops_census",
    ),
    (
        "s2-no-permanent-rest",
        "strong exceeds",
        "properties::rest_census",
    ),
    (
        "s2-speeds-up-if-strong",
        "strong increases",
        "properties::grows_census",
    ),
    (
        "s2-perpendicular-decays",
        "shrinks bounded large",
        "properties::across_census",
    ),
    (
        "s21-frictionless-parabola",
        "grows linearly",
        "limits::parabola_motion",
    ),
    (
        "s21-friction-cannot-hold",
        "small large",
        "from_rest::census",
    ),
    (
        "s21-small-friction-aligns",
        "small large",
        "extremes::small_friction_limit",
    ),
    ("s21-along-acceleration", "large", "sense::against"),
    (
        "s21-critical-terminal-velocity",
        "large",
        "limits::eq18_limit",
    ),
    (
        "s21-large-friction-stops",
        "large stops",
        "limits::eq20_motion",
    ),
    (
        "s22-vy-vanishes",
        "vanishes large",
        "across::vanishes_limit",
    ),
    (
        "s22-weak-drive-stops",
        "weak vanishes large",
        "kinds::weak_drive_motion",
    ),
    ("s22-vx-stays", "strong large", "argument::stays_census"),
    ("s22-friction-across", "small", "argument::across_rate"),
    (
        "s22-vy-two-stages",
        "falls linearly more slowly exponentially",
        "across::first_stage",
    ),
    (
        "s22-attractor-ignores-vy",
        "large",
        "across::ignores_motion",
    ),
    ("fig-2", "large", "drawn::fig2_limit"),
    ("s22-rest-ends", "only", "phases::rest_ends_census"),
    (
        "s22-rest-interval",
        "large",
        "periodic::rest_interval_reached",
    ),
    (
        "s22-slip-longer-than-half",
        "small negative",
        "argument::outlasts_census",
    ),
    (
        "s22-no-rest-below",
        "small vanishes",
        "kinds::no_rest_census",
    ),
    ("s22-trichotomy", "small large", "kinds::trichotomy_census"),
    ("fig-3", "large small", "drawn::fig3_motion"),
    ("fig-4", "large", "drawn::fig4_motion"),
    ("s23-rest-above-one", "large always", "rest::within_time"),
    (
        "s23-threshold-exists",
        "small large more",
        "threshold::with_mean",
    ),
    ("s23-mostly-at-rest", "less", "mostly::limit"),
    (
        "s23-nonzero-again",
        "vanishes",
        "again::pull_again_on_a_plane",
    ),
    ("s23-pulse-phases", "large small", "pulses::extremes_census"),
    ("s24-vy-vanishes", "vanishes only large", "across::vanishes"),
    (
        "s24-q-at-least-one",
        "larger backward",
        "mirror::integration",
    ),
    ("s24-region-1", "Below", "regions::first_census"),
    (
        "s24-region-2",
        "backward Above below",
        "regions::second_census",
    ),
    ("s24-region-4", "forward", "regions::fourth_census"),
    ("s24-region-5", "Above", "regions::fifth_census"),
    ("s24-Y", "tangent", "corners::y_contact"),
    ("fig-6", "large", "panels::quadrature"),
    (
        "s32-rolling-trichotomy",
        "large vanishes always",
        "driven::trichotomy_census",
    ),
    ("s4-mirror", "loses", "frames::mirror"),
    ("s4-dichotomy", "unbounded", "dichotomy::fates"),
    (
        "s4-quasi-fixed-stability",
        "attracts repels",
        "fixed::separation",
    ),
    (
        "s4-A-never-decreases",
        "never decreases grows",
        "onset::never_decreases_census",
    ),
    (
        "s4-escape-if-A-above-1",
        "grows never vanishes",
        "onset::a_grows",
    ),
    ("s4-alpha-unbounded", "grows", "onset::alpha_grows"),
    (
        "s4-rest-radius",
        "only farther exceeds",
        "radius::eq139_stays",
    ),
    (
        "s4-envelope-is-boundary",
        "below",
        "boundary::printed_census",
    ),
];

/// The words of a text that have a direction, each once.
fn directed<'a>(text: &'a str, words: &[&str]) -> Vec<&'a str> {
    let mut found: Vec<&str> = Vec::new();
    for word in text.split(|c: char| !c.is_alphabetic()) {
        if words.contains(&word.to_lowercase().as_str()) && !found.contains(&word) {
            found.push(word);
        }
    }
    found
}

#[test]
fn every_direction_in_a_statement_has_a_trial_that_notices_mistakes() {
    let mut failures = Vec::new();
    let mut listed: BTreeSet<&str> = STATEMENTS.iter().map(|row| row.0).collect();
    for (_, claim) in PAPER.claims().filter(|(_, claim)| claim.equation.is_none()) {
        let text = format!("{} {}", claim.title, claim.plain);
        let words = directed(&text, DIRECTED).join(" ");
        listed.remove(claim.id);
        match STATEMENTS.iter().find(|row| row.0 == claim.id) {
            None if words.is_empty() => {}
            Some((_, known, trial)) if *known == words => {
                match claim.trials.iter().find(|t| t.name() == *trial) {
                    None => failures.push(format!("{}: there is no trial {trial}", claim.id)),
                    Some(t) if t.idle.is_some() => {
                        failures.push(format!("{}: {trial} notices no mistake", claim.id));
                    }
                    Some(_) => {}
                }
            }
            other => failures.push(format!(
                "{}: it says {words:?}, listed is {other:?}",
                claim.id
            )),
        }
    }
    failures.extend(
        listed
            .into_iter()
            .map(|id| format!("{id}: no such statement")),
    );
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
