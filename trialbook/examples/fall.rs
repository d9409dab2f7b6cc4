//! A first paper on trial: a stone falls. (1) holds; (2) is wrong.

use trialbook::prelude::*;
use trialbook::trials::by_hand::Numbers;

/// As printed: g is gravity, t the time since the stone was let go.
mod paper {
    use trialbook::prelude::*;
    formulas! { symbols &[];
    pub fn eq1_speed<S: Scalar>(g: S, t: S) -> S { g * t }
    pub fn eq2_way<S: Scalar>(g: S, t: S) -> S { g * t }
    }
}

/// What is right.
mod corrections {
    use trialbook::prelude::*;
    formulas! { symbols &[];
    pub fn eq2_way<S: Scalar>(g: S, t: S) -> S { g * t.squared() / S::int(2) }
    }
}

/// Twenty falls, each with its gravity and its time.
fn falls() -> Vec<[f64; 2]> {
    Points::here().within(20, [[1.0, 10.0], [0.1, 2.0]])
}

/// What is found without the paper: way and speed, from Newton's law.
fn motion([g, t]: [f64; 2]) -> Result<[f64; 2], Failure> {
    let law = |_, [_, v]: &[f64; 2]| [*v, g];
    Ok(dop853::end(law, 0.0, [0.0, 0.0], t, 1e-14, 1e-14)?)
}

fn speed_by_motion() -> Evidence {
    let trial = Trial::motion(
        Printed,
        Compared::one("the formula", "the integrated motion"),
    );
    trial.at(["g", "t"], falls(), 20.0, |[g, t]| {
        Ok([paper::eq1_speed(g, t), motion([g, t])?[1]])
    })
}

fn speed_by_integral() -> Evidence {
    let trial = Trial::quadrature(
        Printed,
        Compared::one("the formula", "the integral of gravity"),
    );
    trial.at(["g", "t"], falls(), 20.0, |[g, t]| {
        Ok([paper::eq1_speed(g, t), integral(|_| g, 0.0, t)?.value])
    })
}

fn way_by_motion() -> Evidence {
    let trial = Trial::motion(
        Printed,
        Compared::one("the formula", "the integrated motion"),
    );
    trial.at(["g", "t"], falls(), 20.0, |[g, t]| {
        Ok([paper::eq2_way(g, t), motion([g, t])?[0]])
    })
}

fn right_way_by_motion() -> Evidence {
    let trial = Trial::motion(
        Corrected,
        Compared::one("what is right", "the integrated motion"),
    );
    trial.at(["g", "t"], falls(), 20.0, |[g, t]| {
        Ok([corrections::eq2_way(g, t), motion([g, t])?[0]])
    })
}

fn right_way_by_integral() -> Evidence {
    let trial = Trial::quadrature(
        Corrected,
        Compared::one("what is right", "the integral of the speed"),
    );
    trial.at(["g", "t"], falls(), 20.0, |[g, t]| {
        Ok([
            corrections::eq2_way(g, t),
            integral(|t| g * t, 0.0, t)?.value,
        ])
    })
}

/// What the case by hand has: printed, and in the motion.
static CASES: [Numbers; 1] = [Numbers::new(
    "eq-2",
    || Ok(paper::eq2_way(10.0, 3.0)),
    || Ok(motion([10.0, 3.0])?[0]),
)];

static FALL: Topic = Topic::new(
    "fall",
    "The fall",
    File::here(
        r#"
        section = "1"

        [eq-1]
        title = "speed of the fall"
        latex = 'v=gt'
        trials = ["fall::speed_by_motion", "fall::speed_by_integral"]

        [eq-2]
        title = "way of the fall"
        latex = 's=gt'
        corrected = 's=gt^2/2'
        trials = ["fall::way_by_motion", "fall::right_way_by_motion", "fall::right_way_by_integral"]
        [eq-2.by-hand]
        wrong = 'it takes the speed at the end for the whole way'
        reason = 'The speed grows evenly from 0 to $gt$; its mean is half of that'
        case = 'Take $g=10$ and $t=3$: in the middle the speed is 15. Printed: {stated}. In the motion: {found}'
        pencil = ["10*3", "10*3^2/2"]
        digits = 0
    "#,
    ),
    &[trials![
        speed_by_motion,
        speed_by_integral,
        way_by_motion,
        right_way_by_motion,
        right_way_by_integral
    ]],
)
.by_hand(&CASES);

static PAPER: Paper = Paper {
    title: "The falling stone",
    authors: "N. N.",
    topics: &[&FALL],
    record: Text::Built("eq-1: confirmed\neq-2: misderived\n"),
    // Mistakes are made in them, to see that the trials notice.
    formulas: formulas_of!(paper, corrections),
    ..Paper::BLANK
};

static EDITION: Edition = Edition::of("fall", &PAPER);

fn main() -> ExitCode {
    trialbook::cli::run(&EDITION)
}

#[test]
fn the_verdicts_are_the_recorded_ones() {
    let ledger = Ledger::try_all(&PAPER, |_| {});
    assert_eq!(Record::text_of(&ledger), *PAPER.record);
}

#[test]
fn the_book_has_no_dead_link() {
    let folder = std::env::temp_dir().join("the-falling-stone");
    let ledger = Ledger::try_all(&PAPER, |_| {});
    trialbook::book::write(&EDITION, &ledger, &[], &folder).unwrap();
    assert_eq!(trialbook::book::dead_links(&folder).unwrap(), [""; 0]);
}
