//! Anisotropic friction: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "anisotropic",
    title: "Anisotropic friction",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-47",
        section: "2.4",
        equation: Some(47),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_+=\frac{\mu_+ g}{A_0}.",
        plain: r"\lambda_+=\frac{\mu_+ g}{A_0}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-48",
        section: "2.4",
        equation: Some(48),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_-=\frac{\mu_- g}{A_0}.",
        plain: r"\lambda_-=\frac{\mu_- g}{A_0}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-49",
        section: "2.4",
        equation: Some(49),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_+=\lambda_0.",
        plain: r"\lambda_+=\lambda_0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-50",
        section: "2.4",
        equation: Some(50),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_-=q \lambda_0.",
        plain: r"\lambda_-=q \lambda_0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-51",
        section: "2.4",
        equation: Some(51),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi-\lambda_0,\quad\mathfrak{w}>0.",
        plain: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi-\lambda_0,\quad\mathfrak{w}>0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-52",
        section: "2.4",
        equation: Some(52),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi+q \lambda_0,\quad\mathfrak{w}<0.",
        plain: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi+q \lambda_0,\quad\mathfrak{w}<0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-53",
        section: "2.4",
        equation: Some(53),
        kind: Kind::Equation,
        title: "",
        latex: r"A:K=\frac{\pi q}{q+1}, \quad \frac{\sqrt{1-\lambda_0^2}}{\lambda_0}=\frac{K}{\sin^2 K}-\cot K.",
        plain: r"A:K=\frac{\pi q}{q+1}, \quad \frac{\sqrt{1-\lambda_0^2}}{\lambda_0}=\frac{K}{\sin^2 K}-\cot K.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-54",
        section: "2.4",
        equation: Some(54),
        kind: Kind::Equation,
        title: "",
        latex: r"B:\quad \sqrt{1-\lambda_0^2} +\sqrt{1-(q \lambda_0)^2}= \lambda_0 [\pi + \sin^{-1}(q \lambda_0) - \sin^{-1}(\lambda_0)].",
        plain: r"B:\quad \sqrt{1-\lambda_0^2} +\sqrt{1-(q \lambda_0)^2}= \lambda_0 [\pi + \sin^{-1}(q \lambda_0) - \sin^{-1}(\lambda_0)].",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-55",
        section: "2.4",
        equation: Some(55),
        kind: Kind::Equation,
        title: "",
        latex: r"C:\quad \lambda_0=\frac{1}{q}.",
        plain: r"C:\quad \lambda_0=\frac{1}{q}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-56",
        section: "2.4",
        equation: Some(56),
        kind: Kind::Equation,
        title: "",
        latex: r"D:\quad \lambda_0=1.",
        plain: r"D:\quad \lambda_0=1.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-57",
        section: "2.4",
        equation: Some(57),
        kind: Kind::Equation,
        title: "",
        latex: r"X=(q=1,\lambda_0=\lambda_\mathrm{c}).",
        plain: r"X=(q=1,\lambda_0=\lambda_\mathrm{c}).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-58",
        section: "2.4",
        equation: Some(58),
        kind: Kind::Equation,
        title: "",
        latex: r"Y=(q=4.603,\lambda_0=0.217)",
        plain: r"Y=(q=4.603,\lambda_0=0.217)",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-q-at-least-one",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"q ≥ 1 without loss of generality",
        plain: r"q ≥ 1 without loss of generality",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-1",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"below A: a positive and a negative interval, no rest",
        plain: r"below A: a positive and a negative interval, no rest",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-2",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"above A, below B and below C: positive, at once negative, then rest",
        plain: r"above A, below B and below C: positive, at once negative, then rest",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-3",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"between B and C: positive and negative, with two rests between them",
        plain: r"between B and C: positive and negative, with two rests between them",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-4",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"between C and D: positive, then rest",
        plain: r"between C and D: positive, then rest",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-5",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"above D: at rest",
        plain: r"above D: at rest",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-X",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"A and B meet at X = (1, λ_c)",
        plain: r"A and B meet at X = (1, λ_c)",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-Y",
        section: "2.4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"B and C meet at Y = (4.603, 0.217) and are tangent there",
        plain: r"B and C meet at Y = (4.603, 0.217) and are tangent there",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-5",
        section: "2.4",
        equation: None,
        kind: Kind::Figure,
        title: "",
        latex: r"the region diagram; axes q from 1 to 7, λ₀ from 0 to 1.4",
        plain: r"the region diagram; axes q from 1 to 7, λ₀ from 0 to 1.4",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-6",
        section: "2.4",
        equation: None,
        kind: Kind::Figure,
        title: "",
        latex: r"w(φ) over two periods, one panel for each of the regions I to V; axes 0 to 4π, ±1",
        plain: r"w(φ) over two periods, one panel for each of the regions I to V; axes 0 to 4π, ±1",
        ..Claim::BLANK
    },
];
