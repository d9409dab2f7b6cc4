//! Constant acceleration: the claims.

pub mod exact;

use super::{Claim, Kind, Topic};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "constant",
    title: "Constant acceleration",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-3",
        section: "2.1",
        equation: Some(3),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{A}=-A \hat{\bm{x}},",
        plain: r"\bm{A}=-A \hat{\bm{x}},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-4",
        section: "2.1",
        equation: Some(4),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{v}=v (\hat{\bm{x}} \cos\theta+\hat{\bm{y}} \sin\theta),",
        plain: r"\bm{v}=v (\hat{\bm{x}} \cos\theta+\hat{\bm{y}} \sin\theta),",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-5",
        section: "2.1",
        equation: Some(5),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda=\frac{\mu g}{A},",
        plain: r"\lambda=\frac{\mu g}{A},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-6",
        section: "2.1",
        equation: Some(6),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} (v \cos\theta)}{\mathrm{d} t}=A (1-\lambda \cos\theta).",
        plain: r"\frac{\mathrm{d} (v \cos\theta)}{\mathrm{d} t}=A (1-\lambda \cos\theta).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-7",
        section: "2.1",
        equation: Some(7),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} (v \sin\theta)}{\mathrm{d} t}=-A \lambda \sin\theta.",
        plain: r"\frac{\mathrm{d} (v \sin\theta)}{\mathrm{d} t}=-A \lambda \sin\theta.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-8",
        section: "2.1",
        equation: Some(8),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} (v \sin\theta)}{\mathrm{d} (v \cos\theta)}= -\frac{\lambda \sin\theta}{1-\lambda \cos\theta}.",
        plain: r"\frac{\mathrm{d} (v \sin\theta)}{\mathrm{d} (v \cos\theta)}= -\frac{\lambda \sin\theta}{1-\lambda \cos\theta}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-9",
        section: "2.1",
        equation: Some(9),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} v}{v}=\frac{\lambda-\cos\theta}{\sin\theta} \mathrm{d} \theta,",
        plain: r"\frac{\mathrm{d} v}{v}=\frac{\lambda-\cos\theta}{\sin\theta} \mathrm{d} \theta,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-10",
        section: "2.1",
        equation: Some(10),
        kind: Kind::Equation,
        title: "",
        latex: r"v (\sin\theta) \left(\tan\frac{\theta}{2}\right)^{-\lambda}=\mbox{constant},",
        plain: r"v (\sin\theta) \left(\tan\frac{\theta}{2}\right)^{-\lambda}=\mbox{constant},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-11",
        section: "2.1",
        equation: Some(11),
        kind: Kind::Equation,
        title: "",
        latex: r"v=v_0 \frac{\sin\theta_0}{\sin\theta} \left(\frac{{\tan\frac{\theta}{2}}} {{\tan\frac{\theta_0}{2}}}\right)^\lambda.",
        plain: r"v=v_0 \frac{\sin\theta_0}{\sin\theta} \left(\frac{{\tan\frac{\theta}{2}}} {{\tan\frac{\theta_0}{2}}}\right)^\lambda.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-12",
        section: "2.1",
        equation: Some(12),
        kind: Kind::Equation,
        title: "",
        latex: r"A \mathrm{d} t=-\frac{v_0 \sin\theta_0}{{\left(\tan\frac{\theta_0}{2}\right)^\lambda}} \frac{\mathrm{d} {\left[\left(\tan\frac{\theta}{2}\right)^\lambda\right]}}{\lambda \sin\theta},",
        plain: r"A \mathrm{d} t=-\frac{v_0 \sin\theta_0}{{\left(\tan\frac{\theta_0}{2}\right)^\lambda}} \frac{\mathrm{d} {\left[\left(\tan\frac{\theta}{2}\right)^\lambda\right]}}{\lambda \sin\theta},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-13",
        section: "2.1",
        equation: Some(13),
        kind: Kind::Equation,
        title: "",
        latex: r"t=\frac{v_0 (\lambda+\cos\theta_0)}{A (1-\lambda^2)} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right].",
        plain: r"t=\frac{v_0 (\lambda+\cos\theta_0)}{A (1-\lambda^2)} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right].",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-14",
        section: "2.1",
        equation: Some(14),
        kind: Kind::Equation,
        title: "",
        latex: r"v=\frac{(1-\lambda^2) A t+v_0 (\lambda+\cos\theta_0)}{(\lambda+\cos\theta)}.",
        plain: r"v=\frac{(1-\lambda^2) A t+v_0 (\lambda+\cos\theta_0)}{(\lambda+\cos\theta)}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-15",
        section: "2.1",
        equation: Some(15),
        kind: Kind::Equation,
        title: "",
        latex: r"v_x=v_{0 x}+A t.",
        plain: r"v_x=v_{0 x}+A t.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-16",
        section: "2.1",
        equation: Some(16),
        kind: Kind::Equation,
        title: "",
        latex: r"v_y=v_{0 y}.",
        plain: r"v_y=v_{0 y}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-17",
        section: "2.1",
        equation: Some(17),
        kind: Kind::Equation,
        title: "",
        latex: r"v (1+\cos\theta)=v_0 (1+\cos\theta_0).",
        plain: r"v (1+\cos\theta)=v_0 (1+\cos\theta_0).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-18",
        section: "2.1",
        equation: Some(18),
        kind: Kind::Equation,
        title: "",
        latex: r"v_x(\infty)=\frac{v_0 (1+\cos\theta_0)}{2}.",
        plain: r"v_x(\infty)=\frac{v_0 (1+\cos\theta_0)}{2}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-19",
        section: "2.1",
        equation: Some(19),
        kind: Kind::Equation,
        title: "",
        latex: r"v_y(\infty)=0.",
        plain: r"v_y(\infty)=0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-20",
        section: "2.1",
        equation: Some(20),
        kind: Kind::Equation,
        title: "",
        latex: r"T=\frac{v_0 (\lambda+\cos\theta_0)}{A (\lambda^2-1)}.",
        plain: r"T=\frac{v_0 (\lambda+\cos\theta_0)}{A (\lambda^2-1)}.",
        ..Claim::BLANK
    },
    Claim {
        id: "s21-frictionless-parabola",
        section: "2.1",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ = 0: v_y constant, v_x linear in t, the path is in general a parabola",
        plain: r"λ = 0: v_y constant, v_x linear in t, the path is in general a parabola",
        ..Claim::BLANK
    },
    Claim {
        id: "s21-small-friction-aligns",
        section: "2.1",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ ≤ 1: θ → 0 at large times; the particle slides along the line of the acceleration",
        plain: r"λ ≤ 1: θ → 0 at large times; the particle slides along the line of the acceleration",
        ..Claim::BLANK
    },
    Claim {
        id: "s21-critical-terminal-velocity",
        section: "2.1",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ = 1: the velocity tends to the constant of (18), (19)",
        plain: r"λ = 1: the velocity tends to the constant of (18), (19)",
        ..Claim::BLANK
    },
    Claim {
        id: "s21-large-friction-stops",
        section: "2.1",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ > 1: the particle stops at T of (20), and θ → 0 as t → T",
        plain: r"λ > 1: the particle stops at T of (20), and θ → 0 as t → T",
        ..Claim::BLANK
    },
    Claim {
        id: "s21-portrait-consistent",
        section: "2.1",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"the results agree with the inclined-plane results of Eur. J. Phys. 32, 1049",
        plain: r"the results agree with the inclined-plane results of Eur. J. Phys. 32, 1049",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-1",
        section: "2.1",
        equation: None,
        kind: Kind::Figure,
        title: "",
        latex: r"phase portraits of (v_x, v_y), panel (a) λ ≤ 1, panel (b) λ > 1",
        plain: r"phase portraits of (v_x, v_y), panel (a) λ ≤ 1, panel (b) λ > 1",
        ..Claim::BLANK
    },
];
