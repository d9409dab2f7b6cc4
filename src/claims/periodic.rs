//! Any periodic acceleration: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "periodic",
    title: "Any periodic acceleration",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-42",
        section: "2.3",
        equation: Some(42),
        kind: Kind::Equation,
        title: "",
        latex: r"h(\phi)=\begin{cases} 1,0<\phi<\eta \pi\\ 0,\eta \pi<\phi<\pi \end{cases}.",
        plain: r"h(\phi)=\begin{cases} 1,0<\phi<\eta \pi\\ 0,\eta \pi<\phi<\pi \end{cases}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-43",
        section: "2.3",
        equation: Some(43),
        kind: Kind::Equation,
        title: "",
        latex: r"h(\pi+\phi)=-h(\phi).",
        plain: r"h(\pi+\phi)=-h(\phi).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-44",
        section: "2.3",
        equation: Some(44),
        kind: Kind::Equation,
        title: "",
        latex: r"\mathfrak{w}=\begin{cases} (1-\lambda_0) \phi,0<\phi<\eta \pi\\ (1-\lambda_0) \eta \pi-\lambda_0 (\phi-\eta \pi),\eta \pi<\phi <(\eta \pi/\lambda_0)\\ 0,(\eta \pi/\lambda_0)<\phi<\pi \end{cases}.",
        plain: r"\mathfrak{w}=\begin{cases} (1-\lambda_0) \phi,0<\phi<\eta \pi\\ (1-\lambda_0) \eta \pi-\lambda_0 (\phi-\eta \pi),\eta \pi<\phi <(\eta \pi/\lambda_0)\\ 0,(\eta \pi/\lambda_0)<\phi<\pi \end{cases}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-45",
        section: "2.3",
        equation: Some(45),
        kind: Kind::Equation,
        title: "",
        latex: r"\mathfrak{w}(\pi+\phi)=-\mathfrak{w}(\phi).",
        plain: r"\mathfrak{w}(\pi+\phi)=-\mathfrak{w}(\phi).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-46",
        section: "2.3",
        equation: Some(46),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_\mathrm{c}=\eta.",
        plain: r"\lambda_\mathrm{c}=\eta.",
        ..Claim::BLANK
    },
    Claim {
        id: "s23-rest-above-one",
        section: "2.3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"max |h| = 1 and λ₀ > 1: the particle is always at rest (at large times)",
        plain: r"max |h| = 1 and λ₀ > 1: the particle is always at rest (at large times)",
        ..Claim::BLANK
    },
    Claim {
        id: "s23-threshold-exists",
        section: "2.3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"for generic h there is a λ_c that divides large from small friction; there may be more than one change",
        plain: r"for generic h there is a λ_c that divides large from small friction; there may be more than one change",
        ..Claim::BLANK
    },
    Claim {
        id: "s23-pulse-phases",
        section: "2.3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"the pulse train of (42), (43): η = 1 has no large-friction phase, η = 0 no small-friction phase",
        plain: r"the pulse train of (42), (43): η = 1 has no large-friction phase, η = 0 no small-friction phase",
        ..Claim::BLANK
    },
];
