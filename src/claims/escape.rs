//! The turntable: escape: the claims.

use super::{Claim, Condition, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "escape",
    title: "The turntable: escape",
    claims: CLAIMS,
};

/// Stated before (126).
const SMALL_ALPHA: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        stated: true,
    },
    Condition {
        text: r"$\alpha$ is near zero and $\psi$ near $\psi_1$",
        stated: true,
    },
];

/// The first case, (110).
const INNER: &[Condition] = &[Condition {
    text: r"$p<\rho$",
    stated: true,
}];

/// Stated after (127).
const ESCAPING: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        stated: true,
    },
    Condition {
        text: "$A>1$ at the start",
        stated: true,
    },
    Condition {
        text: "large times",
        stated: true,
    },
];

/// Stated after (127) and before (130).
const ESCAPING_LARGE_A: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        stated: true,
    },
    Condition {
        text: "$A>1$ at the start",
        stated: true,
    },
    Condition {
        text: "$A$ is large",
        stated: true,
    },
];

/// Stated after (127), at large times.
const ESCAPING_LATE: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        stated: true,
    },
    Condition {
        text: "$A>1$ at the start",
        stated: true,
    },
    Condition {
        text: r"$\tau\to\infty$",
        stated: true,
    },
];

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-126",
        section: "4",
        equation: Some(126),
        kind: Kind::Equation,
        title: "rate of α near zero",
        latex: r"\dot\alpha\approx1-\frac{1}{A}",
        plain: "dα/dτ ≈ 1 − 1/A",
        conditions: SMALL_ALPHA,
        depends_on: &["eq-114", "eq-124", "s4-quasi-fixed-stability"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-127",
        section: "4",
        equation: Some(127),
        kind: Kind::Inequality,
        title: "the condition for escape",
        latex: "A>1",
        plain: "A > 1",
        conditions: INNER,
        depends_on: &["eq-111", "eq-112"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-128",
        section: "4",
        equation: Some(128),
        kind: Kind::Equation,
        title: "rate of α at the attractor of ψ",
        latex: r"\dot\alpha\approx\frac{1}{\cosh(2 \alpha)}-\frac{\cosh\alpha}{A}",
        plain: "dα/dτ ≈ 1/cosh(2α) − (cosh α)/A",
        conditions: ESCAPING,
        depends_on: &["eq-114", "eq-124", "eq-127", "s4-quasi-fixed-stability"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-129",
        section: "4",
        equation: Some(129),
        kind: Kind::Equation,
        title: "quasi-fixed point of α",
        latex: r"(\cosh\alpha) \cosh(2 \alpha)\approx A",
        plain: "cosh α cosh(2α) ≈ A",
        conditions: ESCAPING,
        depends_on: &["eq-128"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-130",
        section: "4",
        equation: Some(130),
        kind: Kind::Equation,
        title: "α at large A",
        latex: r"\alpha\approx\frac{1}{3} \ln(4 A)",
        plain: "α ≈ (1/3) ln(4A)",
        conditions: ESCAPING_LARGE_A,
        depends_on: &["eq-129"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-131",
        section: "4",
        equation: Some(131),
        kind: Kind::Equation,
        title: "rate of A at large A",
        latex: r"\dot A\approx\frac{(4 A)^{1/3}}{2}",
        plain: "dA/dτ ≈ (4A)^(1/3)/2",
        conditions: ESCAPING_LARGE_A,
        depends_on: &["eq-113", "eq-130"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-132",
        section: "4",
        equation: Some(132),
        kind: Kind::Limit,
        title: "growth of A",
        latex: r"A\sim\frac{2 \tau^{3/2}}{\sqrt{27}}",
        plain: "A ~ 2 τ^(3/2)/√27",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-131"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-133",
        section: "4",
        equation: Some(133),
        kind: Kind::Limit,
        title: "growth of α",
        latex: r"\alpha\sim\frac{1}{2} \ln\frac{4 \tau}{3}",
        plain: "α ~ (1/2) ln(4τ/3)",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-130", "eq-132"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-134",
        section: "4",
        equation: Some(134),
        kind: Kind::Limit,
        title: "limit of the angle ψ",
        latex: r"\psi\sim\frac{\pi}{2}-\left(\frac{3}{\tau}\right)^{1/2}",
        plain: "ψ ~ π/2 − (3/τ)^(1/2)",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-124", "eq-133"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-135",
        section: "4",
        equation: Some(135),
        kind: Kind::Limit,
        title: "growth of the speed p",
        latex: r"p\sim\frac{2 \tau^2}{9}",
        plain: "p ~ 2τ²/9",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-111", "eq-132", "eq-133"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-136",
        section: "4",
        equation: Some(136),
        kind: Kind::Limit,
        title: "growth of the distance ρ",
        latex: r"\rho\sim\frac{2 \tau^2}{9}",
        plain: "ρ ~ 2τ²/9",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-112", "eq-132", "eq-133"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-137",
        section: "4",
        equation: Some(137),
        kind: Kind::Limit,
        title: "growth of the arc length",
        latex: r"s\sim\frac{2 \tau^3}{27}",
        plain: "s ~ 2τ³/27",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-105", "eq-135"],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-138",
        section: "4",
        equation: Some(138),
        kind: Kind::Limit,
        title: "growth checked by the constant of motion",
        latex: r"\frac{A^2}{2}\sim s",
        plain: "A²/2 ~ s",
        conditions: ESCAPING_LATE,
        depends_on: &["eq-104", "eq-132", "eq-137"],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-A-never-decreases",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "A never decreases",
        latex: r"$A$ never decreases, and grows without end unless $\alpha\to0$.",
        plain: "A never decreases, and grows without end unless α → 0.",
        conditions: INNER,
        depends_on: &["eq-113"],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-small-alpha",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "ψ relaxes near α = 0",
        latex: r"Near $\alpha=0$ the angle $\psi$ goes rapidly to $\psi_1$, itself near zero, and then (126) holds.",
        plain: "Near α = 0 the angle ψ goes rapidly to ψ₁, itself near zero, and then (126) holds.",
        conditions: INNER,
        depends_on: &["eq-115", "eq-124", "eq-126"],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-escape-if-A-above-1",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "escape",
        latex: "If $A>1$ at the start, $A$ grows without end and the speed never vanishes.",
        plain: "If A > 1 at the start, A grows without end and the speed never vanishes.",
        conditions: INNER,
        depends_on: &["eq-126", "eq-127", "s4-A-never-decreases", "s4-small-alpha"],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-alpha-unbounded",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "α grows too",
        latex: r"If $A>1$ at the start, $\alpha$ grows without end, like $A$.",
        plain: "If A > 1 at the start, α grows without end, like A.",
        conditions: INNER,
        depends_on: &["eq-128", "s4-escape-if-A-above-1"],
        ..Claim::BLANK
    },
];
