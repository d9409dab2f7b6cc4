//! Sinusoidal acceleration: stick and slip: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "sinusoidal",
    title: "Sinusoidal acceleration: stick and slip",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-21",
        section: "2.2",
        equation: Some(21),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{A}=-A_0 \sin(\varpi t) \hat{\bm{x}}.",
        plain: r"\bm{A}=-A_0 \sin(\varpi t) \hat{\bm{x}}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-22",
        section: "2.2",
        equation: Some(22),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_0=\frac{\mu g}{A_0}.",
        plain: r"\lambda_0=\frac{\mu g}{A_0}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-23",
        section: "2.2",
        equation: Some(23),
        kind: Kind::Equation,
        title: "",
        latex: r"\phi=\varpi t.",
        plain: r"\phi=\varpi t.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-24",
        section: "2.2",
        equation: Some(24),
        kind: Kind::Equation,
        title: "",
        latex: r"\mathfrak{w}=\frac{\varpi v_x}{A_0}.",
        plain: r"\mathfrak{w}=\frac{\varpi v_x}{A_0}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-25",
        section: "2.2",
        equation: Some(25),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_0<1.",
        plain: r"\lambda_0<1.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-26",
        section: "2.2",
        equation: Some(26),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi-\lambda_0 \frac{\mathfrak{w}}{\vert \mathfrak{w}\vert }.",
        plain: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi-\lambda_0 \frac{\mathfrak{w}}{\vert \mathfrak{w}\vert }.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-27",
        section: "2.2",
        equation: Some(27),
        kind: Kind::Equation,
        title: "",
        latex: r"\phi_1=\sin^{-1}\lambda_0.",
        plain: r"\phi_1=\sin^{-1}\lambda_0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-28",
        section: "2.2",
        equation: Some(28),
        kind: Kind::Equation,
        title: "",
        latex: r"\phi_2=\pi-\sin^{-1}\lambda_0.",
        plain: r"\phi_2=\pi-\sin^{-1}\lambda_0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-29",
        section: "2.2",
        equation: Some(29),
        kind: Kind::Equation,
        title: "",
        latex: r"\phi_3=\pi+\sin^{-1}\lambda_0.",
        plain: r"\phi_3=\pi+\sin^{-1}\lambda_0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-30",
        section: "2.2",
        equation: Some(30),
        kind: Kind::Equation,
        title: "",
        latex: r"\phi_4=2 \pi-\sin^{-1}\lambda_0.",
        plain: r"\phi_4=2 \pi-\sin^{-1}\lambda_0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-31",
        section: "2.2",
        equation: Some(31),
        kind: Kind::Equation,
        title: "",
        latex: r"\mathfrak{w}=-\lambda_0 (\phi-\phi_1)+\cos\phi_1-\cos\phi.",
        plain: r"\mathfrak{w}=-\lambda_0 (\phi-\phi_1)+\cos\phi_1-\cos\phi.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-32",
        section: "2.2",
        equation: Some(32),
        kind: Kind::Equation,
        title: "",
        latex: r"-\lambda_0 (\tilde\phi_2-\phi_1)+\cos\phi_1-\cos\tilde\phi_2=0.",
        plain: r"-\lambda_0 (\tilde\phi_2-\phi_1)+\cos\phi_1-\cos\tilde\phi_2=0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-33",
        section: "2.2",
        equation: Some(33),
        kind: Kind::Equation,
        title: "",
        latex: r"\mathfrak{w}=\begin{cases} -\lambda_0 (\phi-\phi_1)+\cos\phi_1-\cos\phi,\phi_1<\phi<\tilde\phi_2\\ 0,\tilde\phi_2<\phi<\phi_3\\ \lambda_0 (\phi-\phi_3)+\cos\phi_3-\cos\phi,\phi_3<\phi<\tilde\phi_2+\pi\\ 0,\tilde\phi_2+\pi<\phi<\phi_1+2 \pi \end{cases}.",
        plain: r"\mathfrak{w}=\begin{cases} -\lambda_0 (\phi-\phi_1)+\cos\phi_1-\cos\phi,\phi_1<\phi<\tilde\phi_2\\ 0,\tilde\phi_2<\phi<\phi_3\\ \lambda_0 (\phi-\phi_3)+\cos\phi_3-\cos\phi,\phi_3<\phi<\tilde\phi_2+\pi\\ 0,\tilde\phi_2+\pi<\phi<\phi_1+2 \pi \end{cases}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-34",
        section: "2.2",
        equation: Some(34),
        kind: Kind::Equation,
        title: "",
        latex: r"-\lambda_0 (\phi_3-\phi_1)+\cos\phi_1-\cos\phi_3<0.",
        plain: r"-\lambda_0 (\phi_3-\phi_1)+\cos\phi_1-\cos\phi_3<0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-35",
        section: "2.2",
        equation: Some(35),
        kind: Kind::Equation,
        title: "",
        latex: r"-\pi \lambda_0+2 \sqrt{1-\lambda_0^2}<0,",
        plain: r"-\pi \lambda_0+2 \sqrt{1-\lambda_0^2}<0,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-36",
        section: "2.2",
        equation: Some(36),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_0>\lambda_\mathrm{c}.",
        plain: r"\lambda_0>\lambda_\mathrm{c}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-37",
        section: "2.2",
        equation: Some(37),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_\mathrm{c}=\frac{2}{\sqrt{4+\pi^2}}.",
        plain: r"\lambda_\mathrm{c}=\frac{2}{\sqrt{4+\pi^2}}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-38",
        section: "2.2",
        equation: Some(38),
        kind: Kind::Equation,
        title: "",
        latex: r"\mathfrak{w}=\begin{cases}-\lambda_0 (\phi-\tilde\phi_1)+\cos\tilde\phi_1-\cos\phi, \tilde\phi_1<\phi<\tilde\phi_1+\pi\\ \lambda_0 (\phi-\tilde\phi_1-\pi)-\cos\tilde\phi_1-\cos\phi, \tilde\phi_1+\pi<\phi<\tilde\phi_1+2 \pi \end{cases},",
        plain: r"\mathfrak{w}=\begin{cases}-\lambda_0 (\phi-\tilde\phi_1)+\cos\tilde\phi_1-\cos\phi, \tilde\phi_1<\phi<\tilde\phi_1+\pi\\ \lambda_0 (\phi-\tilde\phi_1-\pi)-\cos\tilde\phi_1-\cos\phi, \tilde\phi_1+\pi<\phi<\tilde\phi_1+2 \pi \end{cases},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-39",
        section: "2.2",
        equation: Some(39),
        kind: Kind::Equation,
        title: "",
        latex: r"\tilde\phi_1=\cos^{-1}\frac{\pi \lambda_0}{2}.",
        plain: r"\tilde\phi_1=\cos^{-1}\frac{\pi \lambda_0}{2}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-40",
        section: "2.2",
        equation: Some(40),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_0<\lambda_\mathrm{c},",
        plain: r"\lambda_0<\lambda_\mathrm{c},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-41",
        section: "2.2",
        equation: Some(41),
        kind: Kind::Equation,
        title: "",
        latex: r"\tilde\phi_1>\phi_1.",
        plain: r"\tilde\phi_1>\phi_1.",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-vy-vanishes",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"v_y → 0 at large times",
        plain: r"v_y → 0 at large times",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-weak-drive-stops",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"A₀ < μg: v_x vanishes at large times too",
        plain: r"A₀ < μg: v_x vanishes at large times too",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-vy-two-stages",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"while v_y ≫ v_x, v_y falls linearly in time; once v_y ≪ v_x, it falls more slowly, exponentially",
        plain: r"while v_y ≫ v_x, v_y falls linearly in time; once v_y ≪ v_x, it falls more slowly, exponentially",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-attractor-ignores-vy",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"the large-time v_x does not depend on the initial v_y; its transient does",
        plain: r"the large-time v_x does not depend on the initial v_y; its transient does",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-2",
        section: "2.2",
        equation: None,
        kind: Kind::Figure,
        title: "",
        latex: r"v_x(t) for one initial v_x and several initial v_y",
        plain: r"v_x(t) for one initial v_x and several initial v_y",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-four-points",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"|sin φ| = λ₀ at exactly four points per period, those of (27) to (30)",
        plain: r"|sin φ| = λ₀ at exactly four points per period, those of (27) to (30)",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-rest-ends",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"an interval of rest can end only at φ₁ or φ₃",
        plain: r"an interval of rest can end only at φ₁ or φ₃",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-phi2-bracket",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"φ₂ < φ̃₂ < φ₄",
        plain: r"φ₂ < φ̃₂ < φ₄",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-rest-interval",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"φ̃₂ < φ₃ ⇒ the large-time motion is (33), with rest on [φ̃₂, φ₃] and half a period later",
        plain: r"φ̃₂ < φ₃ ⇒ the large-time motion is (33), with rest on [φ̃₂, φ₃] and half a period later",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-no-rest-below",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ₀ < λ_c: no periodic motion vanishes on an interval",
        plain: r"λ₀ < λ_c: no periodic motion vanishes on an interval",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-trichotomy",
        section: "2.2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ₀ < λ_c: exactly two zeros per period; λ_c < λ₀ < 1: two intervals of rest; λ₀ > 1: identically zero",
        plain: r"λ₀ < λ_c: exactly two zeros per period; λ_c < λ₀ < 1: two intervals of rest; λ₀ > 1: identically zero",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-3",
        section: "2.2",
        equation: None,
        kind: Kind::Figure,
        title: "",
        latex: r"w(φ), two periods, λ₀ = 1/π; axes 0 to 4π, ±0.8",
        plain: r"w(φ), two periods, λ₀ = 1/π; axes 0 to 4π, ±0.8",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-4",
        section: "2.2",
        equation: None,
        kind: Kind::Figure,
        title: "",
        latex: r"w(φ), two periods, λ₀ = 1/√2; axes 0 to 4π, ±0.3",
        plain: r"w(φ), two periods, λ₀ = 1/√2; axes 0 to 4π, ±0.3",
        ..Claim::BLANK
    },
];
