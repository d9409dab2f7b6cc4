//! A sphere that slips and rolls: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "sphere",
    title: "A sphere that slips and rolls",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-59",
        section: "3",
        equation: Some(59),
        kind: Kind::Equation,
        title: "",
        latex: r"m \frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-m \bm{A}+\bm{F},",
        plain: r"m \frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-m \bm{A}+\bm{F},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-60",
        section: "3",
        equation: Some(60),
        kind: Kind::Equation,
        title: "",
        latex: r"I \frac{\mathrm{d} \bm{\omega}}{\mathrm{d} t}=\bm{R}\times\bm{F},",
        plain: r"I \frac{\mathrm{d} \bm{\omega}}{\mathrm{d} t}=\bm{R}\times\bm{F},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-61",
        section: "3",
        equation: Some(61),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{R}=-R \hat{\bm{z}}.",
        plain: r"\bm{R}=-R \hat{\bm{z}}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-62",
        section: "3",
        equation: Some(62),
        kind: Kind::Equation,
        title: "",
        latex: r"\kappa=\frac{I}{m R^2},",
        plain: r"\kappa=\frac{I}{m R^2},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-63",
        section: "3",
        equation: Some(63),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-\bm{A}-\mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right).",
        plain: r"\frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-\bm{A}-\mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-64",
        section: "3",
        equation: Some(64),
        kind: Kind::Equation,
        title: "",
        latex: r"\kappa R^2 \frac{\mathrm{d} \bm{\omega}}{\mathrm{d} t}=-\mu g \bm{R}\times\left\{ \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)\right\}.",
        plain: r"\kappa R^2 \frac{\mathrm{d} \bm{\omega}}{\mathrm{d} t}=-\mu g \bm{R}\times\left\{ \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)\right\}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-65",
        section: "3",
        equation: Some(65),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} (\bm{\omega}\times\bm{R})}{\mathrm{d} t}=-\frac{\mu g}{\kappa} \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right).",
        plain: r"\frac{\mathrm{d} (\bm{\omega}\times\bm{R})}{\mathrm{d} t}=-\frac{\mu g}{\kappa} \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-66",
        section: "3",
        equation: Some(66),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d}}{\mathrm{d} t} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right) =-\bm{A}-b \mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right),",
        plain: r"\frac{\mathrm{d}}{\mathrm{d} t} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right) =-\bm{A}-b \mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right),",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-67",
        section: "3",
        equation: Some(67),
        kind: Kind::Equation,
        title: "",
        latex: r"b=1+\frac{1}{\kappa}.",
        plain: r"b=1+\frac{1}{\kappa}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-68",
        section: "3",
        equation: Some(68),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\rho}=\frac{\bm{r}}{R}.",
        plain: r"\bm{\rho}=\frac{\bm{r}}{R}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-69",
        section: "3",
        equation: Some(69),
        kind: Kind::Equation,
        title: "",
        latex: r"\tau=\sqrt{\frac{\mu g}{R}} t.",
        plain: r"\tau=\sqrt{\frac{\mu g}{R}} t.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-70",
        section: "3",
        equation: Some(70),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\zeta}=\sqrt{\frac{R}{\mu g}} \bm{\omega}.",
        plain: r"\bm{\zeta}=\sqrt{\frac{R}{\mu g}} \bm{\omega}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-71",
        section: "3",
        equation: Some(71),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{u}=\frac{1}{\sqrt{\mu g R}} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right).",
        plain: r"\bm{u}=\frac{1}{\sqrt{\mu g R}} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-72",
        section: "3",
        equation: Some(72),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\gamma}=\frac{\bm{A}}{\mu g}.",
        plain: r"\bm{\gamma}=\frac{\bm{A}}{\mu g}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-73",
        section: "3",
        equation: Some(73),
        kind: Kind::Equation,
        title: "",
        latex: r"\ddot{\bm{\rho}}=-\bm{\gamma}-\frac{\bm{u}}{u}.",
        plain: r"\ddot{\bm{\rho}}=-\bm{\gamma}-\frac{\bm{u}}{u}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-74",
        section: "3",
        equation: Some(74),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot{\bm{u}}=-\bm{\gamma}-b \frac{\bm{u}}{u}.",
        plain: r"\dot{\bm{u}}=-\bm{\gamma}-b \frac{\bm{u}}{u}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-75",
        section: "3",
        equation: Some(75),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\zeta}=\hat{\bm{z}} \zeta_3+\hat{\bm{z}}\times(\bm{u}-\dot{\bm{\rho}}).",
        plain: r"\bm{\zeta}=\hat{\bm{z}} \zeta_3+\hat{\bm{z}}\times(\bm{u}-\dot{\bm{\rho}}).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-76",
        section: "3",
        equation: Some(76),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot{\bm{\nu}}=\bm{\gamma},",
        plain: r"\dot{\bm{\nu}}=\bm{\gamma},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-77",
        section: "3",
        equation: Some(77),
        kind: Kind::Equation,
        title: "",
        latex: r"(\dot{\bm{\rho}}+\bm{\nu})^{\cdot}=-\frac{\bm{u}}{u}.",
        plain: r"(\dot{\bm{\rho}}+\bm{\nu})^{\cdot}=-\frac{\bm{u}}{u}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-78",
        section: "3",
        equation: Some(78),
        kind: Kind::Equation,
        title: "",
        latex: r"(\bm{u}+\bm{\nu})^{\cdot}=-b \frac{\bm{u}}{u}.",
        plain: r"(\bm{u}+\bm{\nu})^{\cdot}=-b \frac{\bm{u}}{u}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-79",
        section: "3",
        equation: Some(79),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot{\bm{\rho}}=-\left(1-\frac{1}{b}\right) \bm{\nu}+\frac{\bm{u}}{b}+\bm{c},",
        plain: r"\dot{\bm{\rho}}=-\left(1-\frac{1}{b}\right) \bm{\nu}+\frac{\bm{u}}{b}+\bm{c},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-80",
        section: "3.1",
        equation: Some(80),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda=\frac{b \mu g}{A},",
        plain: r"\lambda=\frac{b \mu g}{A},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-81",
        section: "3.1",
        equation: Some(81),
        kind: Kind::Equation,
        title: "",
        latex: r"u=u_0 \frac{\sin\theta_0}{\sin\theta} \left(\frac{{\tan\frac{\theta}{2}}} {{\tan\frac{\theta_0}{2}}}\right)^\lambda.",
        plain: r"u=u_0 \frac{\sin\theta_0}{\sin\theta} \left(\frac{{\tan\frac{\theta}{2}}} {{\tan\frac{\theta_0}{2}}}\right)^\lambda.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-82",
        section: "3.1",
        equation: Some(82),
        kind: Kind::Equation,
        title: "",
        latex: r"\tau=\frac{u_0 (\lambda+\cos\theta_0)}{1-\lambda^2} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right].",
        plain: r"\tau=\frac{u_0 (\lambda+\cos\theta_0)}{1-\lambda^2} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right].",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-83",
        section: "3.1",
        equation: Some(83),
        kind: Kind::Equation,
        title: "",
        latex: r"u=\frac{(1-\lambda^2) \tau+u_0 (\lambda+\cos\theta_0)}{(\lambda+\cos\theta)}.",
        plain: r"u=\frac{(1-\lambda^2) \tau+u_0 (\lambda+\cos\theta_0)}{(\lambda+\cos\theta)}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-84",
        section: "3.2",
        equation: Some(84),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_0=\frac{b \mu g}{A_0}.",
        plain: r"\lambda_0=\frac{b \mu g}{A_0}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-85",
        section: "3.4",
        equation: Some(85),
        kind: Kind::Equation,
        title: "",
        latex: r"\lambda_0=\frac{b \mu_+ g}{A_0}.",
        plain: r"\lambda_0=\frac{b \mu_+ g}{A_0}.",
        ..Claim::BLANK
    },
    Claim {
        id: "s3-reduction",
        section: "3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"the sphere's slip velocity u obeys the particle's equation with μ → bμ; the rest follows from u",
        plain: r"the sphere's slip velocity u obeys the particle's equation with μ → bμ; the rest follows from u",
        ..Claim::BLANK
    },
    Claim {
        id: "s3-spin-constant",
        section: "3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"ζ₃ is constant and enters nothing else",
        plain: r"ζ₃ is constant and enters nothing else",
        ..Claim::BLANK
    },
    Claim {
        id: "s32-rolling-trichotomy",
        section: "3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"s22-trichotomy for u_x; u = 0 is rolling without slipping",
        plain: r"s22-trichotomy for u_x; u = 0 is rolling without slipping",
        ..Claim::BLANK
    },
    Claim {
        id: "s33-pulse",
        section: "3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"λ_c = η holds for the sphere with λ₀ of (84)",
        plain: r"λ_c = η holds for the sphere with λ₀ of (84)",
        ..Claim::BLANK
    },
    Claim {
        id: "s34-anisotropic",
        section: "3",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"the region diagram holds for the sphere with λ₀ of (85)",
        plain: r"the region diagram holds for the sphere with λ₀ of (85)",
        ..Claim::BLANK
    },
];
