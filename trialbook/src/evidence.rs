//! The vocabulary of the claims and of their judge.

mod compared;
pub(crate) mod ranges;

pub use compared::Compared;
pub use ranges::Ranges;

use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::panic::Location;

/// What sort of statement a claim is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Introduces a symbol or sets up a problem.
    Definition,
    /// Says that two expressions are equal.
    Equation,
    /// Says that one expression exceeds another.
    Inequality,
    /// States a number.
    Number,
    /// States what something tends to, or how.
    Limit,
    /// Says in words how the motion behaves.
    Property,
    /// A picture.
    Figure,
}

impl Kind {
    /// The kind's name, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Definition => "definition",
            Kind::Equation => "equation",
            Kind::Inequality => "inequality",
            Kind::Number => "number",
            Kind::Limit => "limit",
            Kind::Property => "property",
            Kind::Figure => "figure",
        }
    }
}

/// How much a correction changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Change {
    /// A sign.
    Sign,
    /// A factor.
    Factor,
    /// One symbol for another.
    Symbol,
    /// The statement itself.
    Statement,
}

/// The way by which a trial came to its evidence; routes that differ and have read no runs in common are
/// independent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Route {
    /// Zero-testing in exact arithmetic: a proof.
    Exact,
    /// A rigorous enclosure: a proof.
    Certified,
    /// Integration of the equation of motion.
    Integration,
    /// Quadrature of an integrand.
    Quadrature,
    /// Root-finding.
    Root,
    /// The approach to a limit, its rate included.
    Limit,
    /// A count over many cases.
    Census,
    /// Dimensions, and how the paper uses a definition.
    Consistency,
}

impl Route {
    /// True for a route that proves and does not merely measure.
    pub fn is_proof(self) -> bool {
        matches!(self, Route::Exact | Route::Certified)
    }

    /// The fewest points from which evidence by this route counts.
    pub(crate) fn min_points(self) -> usize {
        if self.is_proof() { 1 } else { 20 }
    }

    /// The route's name, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Route::Exact => "exact",
            Route::Certified => "certified",
            Route::Integration => "integration",
            Route::Quadrature => "quadrature",
            Route::Root => "root",
            Route::Limit => "limit",
            Route::Census => "census",
            Route::Consistency => "consistency",
        }
    }
}

/// What a trial's comparison speaks about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Subject {
    /// The claim as printed, under the paper's own conditions.
    Printed,
    /// The same under a condition that the paper does not state.
    Within,
    /// The claim as printed without that condition: disagreement is expected.
    Outside,
    /// What replaces a claim that fails.
    Corrected,
    /// The step to the claim from what it rests on.
    Step,
    /// That a condition's exception has no inside, or that the claim has no value there.
    Excepted,
    /// What we remark beside the claim: it has to hold.
    Remark,
}

impl Subject {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Printed,
        Self::Within,
        Self::Outside,
        Self::Corrected,
        Self::Step,
        Self::Excepted,
        Self::Remark,
    ];

    /// The subject's name, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Subject::Printed => "printed",
            Subject::Within => "within",
            Subject::Outside => "outside",
            Subject::Corrected => "corrected",
            Subject::Step => "step",
            Subject::Excepted => "excepted",
            Subject::Remark => "remark",
        }
    }

    /// What the trial was about, in words; `conditional` for a claim under a condition, `ours` for one not
    /// printed.
    pub fn words(self, conditional: bool, ours: bool) -> &'static str {
        match self {
            Subject::Printed if ours => "as derived here",
            Subject::Printed => "as printed",
            Subject::Within => "under the condition",
            Subject::Outside => "without the condition",
            Subject::Corrected if conditional => "in the form that holds without the condition",
            Subject::Corrected => "as corrected",
            Subject::Step => "the step from what it rests on",
            Subject::Excepted => "what the condition excepts",
            Subject::Remark => "our remark",
        }
    }
}

/// How far two values may differ, and why that far.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Tolerance {
    /// Its name, as in the code.
    pub name: &'static str,
    /// The largest disagreement that counts as agreement (dimensionless).
    pub value: f64,
    /// Where this number comes from.
    pub reason: &'static str,
}

/// One compared pair, for readers.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sample {
    /// The point, in the claim's own symbols.
    pub at: String,
    /// The value that the claim states there.
    pub stated: f64,
    /// The value found without the claim.
    pub found: f64,
}

/// A number each for what was stated, what was found and the scale, at all points together, to the last bit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Sides {
    /// What the claim states.
    pub stated: u64,
    /// What was found without it.
    pub found: u64,
    /// In what units they are compared.
    pub scale: u64,
}

/// What one trial brought.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Evidence {
    /// The path of its function, or of the statement that it proves.
    pub trial: &'static str,
    /// How it was obtained.
    pub route: Route,
    /// What it speaks about.
    pub subject: Subject,
    /// What was compared with what.
    pub compared: Compared,
    /// How many points were compared.
    pub points: usize,
    /// At how many of them the sides differ by more than the tolerance.
    pub failed: usize,
    /// How many of them are the same as one before, in place and in all numbers.
    pub repeated: usize,
    /// The smallest and the largest scale.
    #[serde(skip)]
    pub scales: [f64; 2],
    /// Between which ends the points lie.
    pub ranges: Ranges,
    /// What was stated, found and taken for a scale, at all points to the last bit.
    #[serde(skip)]
    pub sides: Sides,
    /// The largest disagreement, in units of the scale; infinite where the claim alone has no value; NaN
    /// where our own side failed.
    pub worst: f64,
    /// Where the largest disagreement was.
    pub at: String,
    /// What counts as agreement.
    pub tolerance: Tolerance,
    /// The first compared pairs, of those that disagree if any do; of a proof, all.
    pub samples: Vec<Sample>,
    /// The pair with the largest disagreement.
    pub farthest: Option<Sample>,
    /// The title of a proof; empty for a measurement.
    pub title: String,
    /// The steps of a proof, as plain text; none for a measurement.
    pub steps: Vec<String>,
    /// The proofs that it rests on, each after its own.
    #[serde(skip)]
    pub lemmas: Vec<Lemma>,
    /// What has to be positive for a proof by algebra.
    #[serde(skip)]
    pub positive: Vec<String>,
    /// It covers a part of the claim only: it can speak against the claim, but not for the whole.
    pub partial: bool,
    /// The formulas read for it, by their paths: `some_crate::some_topic::eq13_time`.
    pub read: BTreeSet<&'static str>,
    /// The shared runs read for it, by where they are declared.
    #[serde(skip)]
    pub runs: BTreeSet<&'static Location<'static>>,
    /// What the errata say of it, if it was read from a sheet and not made now.
    #[serde(skip)]
    pub recorded: Option<String>,
}

/// A proof that another one rests on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lemma {
    /// What it shows.
    pub title: String,
    /// Its steps.
    pub steps: Vec<String>,
}

/// What a piece of evidence says by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Within the tolerance.
    Agrees,
    /// Beyond the tolerance.
    Disagrees,
    /// Our own side gave no number.
    NotANumber,
    /// Not enough points, or most repeat others.
    TooFewPoints,
}

impl Evidence {
    /// Evidence of no point yet; who runs the trial notes its name and what it reads.
    pub fn new(route: Route, subject: Subject, compared: Compared, tolerance: Tolerance) -> Self {
        Evidence {
            trial: "",
            route,
            subject,
            compared,
            points: 0,
            failed: 0,
            repeated: 0,
            scales: [f64::INFINITY, 0.0],
            ranges: Ranges::default(),
            sides: Sides::default(),
            worst: 0.0,
            at: String::new(),
            tolerance,
            samples: Vec::new(),
            farthest: None,
            title: String::new(),
            steps: Vec::new(),
            lemmas: Vec::new(),
            positive: Vec::new(),
            partial: false,
            read: BTreeSet::new(),
            runs: BTreeSet::new(),
            recorded: None,
        }
    }

    /// The same evidence, about a part of the claim only.
    pub fn of_a_part(self) -> Self {
        Evidence {
            partial: true,
            ..self
        }
    }

    /// Which form of the claim it is about, and whether the whole of it; `conditional` and `ours` as in
    /// [`Subject::words`].
    pub fn about(&self, conditional: bool, ours: bool) -> String {
        let part = if self.partial { ", a part of it" } else { "" };
        format!("{}{part}", self.subject.words(conditional, ours))
    }

    /// What became of a proof, in one word or two; `None` for a measurement.
    pub fn proof_words(&self) -> Option<&'static str> {
        self.route.is_proof().then(|| match self.outcome() {
            Outcome::Agrees if self.is_in_words() => "checked",
            Outcome::Agrees => "shown",
            Outcome::Disagrees => "disproved",
            Outcome::NotANumber | Outcome::TooFewPoints => "not proved",
        })
    }

    /// How many of its points differ.
    pub fn different(&self) -> usize {
        self.points - self.repeated
    }

    /// How many points have to differ: what its route needs, and half of all.
    pub fn needed(&self) -> usize {
        self.route.min_points().max(self.points.div_ceil(2))
    }

    /// Reads the evidence by its own tolerance.
    pub fn outcome(&self) -> Outcome {
        if self.worst.is_nan() || !self.tolerance.value.is_finite() {
            Outcome::NotANumber
        } else if self.different() < self.needed() {
            Outcome::TooFewPoints
        } else if self.worst <= self.tolerance.value {
            Outcome::Agrees
        } else {
            Outcome::Disagrees
        }
    }
}
