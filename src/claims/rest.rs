//! The turntable: rest: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "rest",
    title: "The turntable: rest",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-139",
        section: "4",
        equation: Some(139),
        kind: Kind::Equation,
        title: "",
        latex: r"\sigma\leq 1.",
        plain: r"\sigma\leq 1.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-140",
        section: "4",
        equation: Some(140),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\alpha=1-\frac{1}{\sigma}+\cdots,",
        plain: r"\dot\alpha=1-\frac{1}{\sigma}+\cdots,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-141",
        section: "4",
        equation: Some(141),
        kind: Kind::Equation,
        title: "",
        latex: r"\alpha=\frac{(\sigma-1) \tau}{\sigma}+\cdots.",
        plain: r"\alpha=\frac{(\sigma-1) \tau}{\sigma}+\cdots.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-142",
        section: "4",
        equation: Some(142),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\sigma-1}{\sigma} \frac{\mathrm{d} \psi}{\mathrm{d} \alpha} \approx 2 \left(1-\frac{\psi}{2 \alpha}\right),",
        plain: r"\frac{\sigma-1}{\sigma} \frac{\mathrm{d} \psi}{\mathrm{d} \alpha} \approx 2 \left(1-\frac{\psi}{2 \alpha}\right),",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-143",
        section: "4",
        equation: Some(143),
        kind: Kind::Equation,
        title: "",
        latex: r"\psi=2 \alpha \left[\frac{\sigma}{2 \sigma-1}+ c \alpha^{(2 \sigma-1)/(1-\sigma)}\right]+\cdots,",
        plain: r"\psi=2 \alpha \left[\frac{\sigma}{2 \sigma-1}+ c \alpha^{(2 \sigma-1)/(1-\sigma)}\right]+\cdots,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-144",
        section: "4",
        equation: Some(144),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\sigma-1}{\sigma} \frac{\mathrm{d} A}{\mathrm{d} \alpha}\approx\alpha,",
        plain: r"\frac{\sigma-1}{\sigma} \frac{\mathrm{d} A}{\mathrm{d} \alpha}\approx\alpha,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-145",
        section: "4",
        equation: Some(145),
        kind: Kind::Equation,
        title: "",
        latex: r"A=\sigma+\frac{\sigma}{\sigma-1} \frac{\alpha^2}{2}+\cdots.",
        plain: r"A=\sigma+\frac{\sigma}{\sigma-1} \frac{\alpha^2}{2}+\cdots.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-146",
        section: "4",
        equation: Some(146),
        kind: Kind::Equation,
        title: "",
        latex: r"0=1-\frac{1}{(\sigma-1)^2} \frac{\alpha^2}{2}+\cdots.",
        plain: r"0=1-\frac{1}{(\sigma-1)^2} \frac{\alpha^2}{2}+\cdots.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-147",
        section: "4",
        equation: Some(147),
        kind: Kind::Equation,
        title: "",
        latex: r"A=\left(1-\frac{\alpha}{\sqrt{2}}\right)^2+\cdots.",
        plain: r"A=\left(1-\frac{\alpha}{\sqrt{2}}\right)^2+\cdots.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-rest-radius",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"a particle can stay at rest at ρ = σ only if σ ≤ 1",
        plain: r"a particle can stay at rest at ρ = σ only if σ ≤ 1",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-near-rest",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"near rest α and ψ → 0 as in (140) to (145)",
        plain: r"near rest α and ψ → 0 as in (140) to (145)",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-envelope-is-boundary",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"the envelope (147) is the boundary: rest if and only if A is below it",
        plain: r"the envelope (147) is the boundary: rest if and only if A is below it",
        ..Claim::BLANK
    },
];
