//! The turntable: escape: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "escape",
    title: "The turntable: escape",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-126",
        section: "4",
        equation: Some(126),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\alpha\approx1-\frac{1}{A}.",
        plain: r"\dot\alpha\approx1-\frac{1}{A}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-127",
        section: "4",
        equation: Some(127),
        kind: Kind::Equation,
        title: "",
        latex: r"A>1,",
        plain: r"A>1,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-128",
        section: "4",
        equation: Some(128),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\alpha\approx\frac{1}{\cosh(2 \alpha)}-\frac{\cosh\alpha}{A}.",
        plain: r"\dot\alpha\approx\frac{1}{\cosh(2 \alpha)}-\frac{\cosh\alpha}{A}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-129",
        section: "4",
        equation: Some(129),
        kind: Kind::Equation,
        title: "",
        latex: r"(\cosh\alpha) \cosh(2 \alpha)\approx A.",
        plain: r"(\cosh\alpha) \cosh(2 \alpha)\approx A.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-130",
        section: "4",
        equation: Some(130),
        kind: Kind::Equation,
        title: "",
        latex: r"\alpha\approx\frac{1}{3} \ln(4 A).",
        plain: r"\alpha\approx\frac{1}{3} \ln(4 A).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-131",
        section: "4",
        equation: Some(131),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot A\approx\frac{(4 A)^{1/3}}{2},",
        plain: r"\dot A\approx\frac{(4 A)^{1/3}}{2},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-132",
        section: "4",
        equation: Some(132),
        kind: Kind::Equation,
        title: "",
        latex: r"A\sim\frac{2 \tau^{3/2}}{\sqrt{27}}.",
        plain: r"A\sim\frac{2 \tau^{3/2}}{\sqrt{27}}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-133",
        section: "4",
        equation: Some(133),
        kind: Kind::Equation,
        title: "",
        latex: r"\alpha\sim\frac{1}{2} \ln\frac{4 \tau}{3}.",
        plain: r"\alpha\sim\frac{1}{2} \ln\frac{4 \tau}{3}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-134",
        section: "4",
        equation: Some(134),
        kind: Kind::Equation,
        title: "",
        latex: r"\psi\sim\frac{\pi}{2}-\left(\frac{3}{\tau}\right)^{1/2}.",
        plain: r"\psi\sim\frac{\pi}{2}-\left(\frac{3}{\tau}\right)^{1/2}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-135",
        section: "4",
        equation: Some(135),
        kind: Kind::Equation,
        title: "",
        latex: r"p\sim\frac{2 \tau^2}{9}.",
        plain: r"p\sim\frac{2 \tau^2}{9}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-136",
        section: "4",
        equation: Some(136),
        kind: Kind::Equation,
        title: "",
        latex: r"\rho\sim\frac{2 \tau^2}{9}.",
        plain: r"\rho\sim\frac{2 \tau^2}{9}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-137",
        section: "4",
        equation: Some(137),
        kind: Kind::Equation,
        title: "",
        latex: r"s\sim\frac{2 \tau^3}{27}.",
        plain: r"s\sim\frac{2 \tau^3}{27}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-138",
        section: "4",
        equation: Some(138),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{A^2}{2}\sim s.",
        plain: r"\frac{A^2}{2}\sim s.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-A-never-decreases",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"A never decreases, and grows for ever unless α → 0",
        plain: r"A never decreases, and grows for ever unless α → 0",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-small-alpha",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"near α = 0, ψ relaxes fast to a small value, and then (126) holds",
        plain: r"near α = 0, ψ relaxes fast to a small value, and then (126) holds",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-escape-if-A-above-1",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"A > 1 at the start: A grows for ever and the speed never vanishes",
        plain: r"A > 1 at the start: A grows for ever and the speed never vanishes",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-alpha-unbounded",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"then α grows for ever too",
        plain: r"then α grows for ever too",
        ..Claim::BLANK
    },
];
