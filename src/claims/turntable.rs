//! The turntable: equations: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "turntable",
    title: "The turntable: equations",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-86",
        section: "4",
        equation: Some(86),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=\Omega^2 \bm{r}+2 \Omega \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\times\hat{\bm{z}} -\mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right\vert ^{-1} \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}.",
        plain: r"\frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=\Omega^2 \bm{r}+2 \Omega \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\times\hat{\bm{z}} -\mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right\vert ^{-1} \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-87",
        section: "4",
        equation: Some(87),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\rho}=\frac{\Omega^2}{\mu g} \bm{r}.",
        plain: r"\bm{\rho}=\frac{\Omega^2}{\mu g} \bm{r}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-88",
        section: "4",
        equation: Some(88),
        kind: Kind::Equation,
        title: "",
        latex: r"\tau=\Omega t.",
        plain: r"\tau=\Omega t.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-89",
        section: "4",
        equation: Some(89),
        kind: Kind::Equation,
        title: "",
        latex: r"\ddot{\bm{\rho}}=\bm{\rho}+2 \dot{\bm{\rho}}\times\hat{\bm{z}} -\frac{\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert },",
        plain: r"\ddot{\bm{\rho}}=\bm{\rho}+2 \dot{\bm{\rho}}\times\hat{\bm{z}} -\frac{\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert },",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-90",
        section: "4",
        equation: Some(90),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot{\bm{\rho}}\cdot\ddot{\bm{\rho}}=\bm{\rho}\cdot\dot{\bm{\rho}}-\vert \dot{\bm{\rho}}\vert .",
        plain: r"\dot{\bm{\rho}}\cdot\ddot{\bm{\rho}}=\bm{\rho}\cdot\dot{\bm{\rho}}-\vert \dot{\bm{\rho}}\vert .",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-91",
        section: "4",
        equation: Some(91),
        kind: Kind::Equation,
        title: "",
        latex: r"\hat{\bm{z}}\cdot\bm{\rho}\times\ddot{\bm{\rho}}=-2 \bm{\rho}\cdot\dot{\bm{\rho}} -\frac{\hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }.",
        plain: r"\hat{\bm{z}}\cdot\bm{\rho}\times\ddot{\bm{\rho}}=-2 \bm{\rho}\cdot\dot{\bm{\rho}} -\frac{\hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-92",
        section: "4",
        equation: Some(92),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\rho}\cdot\ddot{\bm{\rho}}+\dot{\bm{\rho}}\cdot\dot{\bm{\rho}}=\bm{\rho}\cdot\bm{\rho} +2 \hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}} -\frac{\bm{\rho}\cdot\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }+\dot{\bm{\rho}}\cdot\dot{\bm{\rho}}.",
        plain: r"\bm{\rho}\cdot\ddot{\bm{\rho}}+\dot{\bm{\rho}}\cdot\dot{\bm{\rho}}=\bm{\rho}\cdot\bm{\rho} +2 \hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}} -\frac{\bm{\rho}\cdot\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }+\dot{\bm{\rho}}\cdot\dot{\bm{\rho}}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-93",
        section: "4",
        equation: Some(93),
        kind: Kind::Equation,
        title: "",
        latex: r"p=\vert \dot{\bm{\rho}}\vert ,",
        plain: r"p=\vert \dot{\bm{\rho}}\vert ,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-94",
        section: "4",
        equation: Some(94),
        kind: Kind::Equation,
        title: "",
        latex: r"\xi=\rho \cos\psi.",
        plain: r"\xi=\rho \cos\psi.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-95",
        section: "4",
        equation: Some(95),
        kind: Kind::Equation,
        title: "",
        latex: r"\ell=-\rho \sin\psi.",
        plain: r"\ell=-\rho \sin\psi.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-96",
        section: "4",
        equation: Some(96),
        kind: Kind::Equation,
        title: "",
        latex: r"p \ell=\hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}},",
        plain: r"p \ell=\hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-97",
        section: "4",
        equation: Some(97),
        kind: Kind::Equation,
        title: "",
        latex: r"p \xi=\bm{\rho}\cdot\dot{\bm{\rho}},",
        plain: r"p \xi=\bm{\rho}\cdot\dot{\bm{\rho}},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-98",
        section: "4",
        equation: Some(98),
        kind: Kind::Equation,
        title: "",
        latex: r"\bm{\rho}\cdot\bm{\rho}=\ell^2+\xi^2,",
        plain: r"\bm{\rho}\cdot\bm{\rho}=\ell^2+\xi^2,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-99",
        section: "4",
        equation: Some(99),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot p=\xi-1.",
        plain: r"\dot p=\xi-1.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-100",
        section: "4",
        equation: Some(100),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\ell=-\frac{\xi (2 p+\ell)}{p}.",
        plain: r"\dot\ell=-\frac{\xi (2 p+\ell)}{p}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-101",
        section: "4",
        equation: Some(101),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\xi=\frac{(p+\ell)^2}{p}.",
        plain: r"\dot\xi=\frac{(p+\ell)^2}{p}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-102",
        section: "4",
        equation: Some(102),
        kind: Kind::Equation,
        title: "",
        latex: r"=p (\dot p+1).",
        plain: r"=p (\dot p+1).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-103",
        section: "4",
        equation: Some(103),
        kind: Kind::Equation,
        title: "",
        latex: r"\left(\frac{p^2-\rho^2}{2}\right)^{\cdot}=-p,",
        plain: r"\left(\frac{p^2-\rho^2}{2}\right)^{\cdot}=-p,",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-104",
        section: "4",
        equation: Some(104),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{p^2-\rho^2}{2}+s=\mbox{constant},",
        plain: r"\frac{p^2-\rho^2}{2}+s=\mbox{constant},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-105",
        section: "4",
        equation: Some(105),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot s=p.",
        plain: r"\dot s=p.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-106",
        section: "4",
        equation: Some(106),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{m}{2} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right)\cdot\left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right) -\frac{m \Omega^2 r^2}{2}+m g s=\mbox{constant}.",
        plain: r"\frac{m}{2} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right)\cdot\left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right) -\frac{m \Omega^2 r^2}{2}+m g s=\mbox{constant}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-107",
        section: "4",
        equation: Some(107),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot p=\rho \cos\psi-1.",
        plain: r"\dot p=\rho \cos\psi-1.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-108",
        section: "4",
        equation: Some(108),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\rho=p \cos\psi.",
        plain: r"\dot\rho=p \cos\psi.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-109",
        section: "4",
        equation: Some(109),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\psi=2-\left(\frac{p}{\rho}+\frac{\rho}{p}\right) \sin\psi.",
        plain: r"\dot\psi=2-\left(\frac{p}{\rho}+\frac{\rho}{p}\right) \sin\psi.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-110",
        section: "4",
        equation: Some(110),
        kind: Kind::Equation,
        title: "",
        latex: r"p^2-\rho^2<0.",
        plain: r"p^2-\rho^2<0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-111",
        section: "4",
        equation: Some(111),
        kind: Kind::Equation,
        title: "",
        latex: r"p=A \sinh\alpha.",
        plain: r"p=A \sinh\alpha.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-112",
        section: "4",
        equation: Some(112),
        kind: Kind::Equation,
        title: "",
        latex: r"\rho=A \cosh\alpha.",
        plain: r"\rho=A \cosh\alpha.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-113",
        section: "4",
        equation: Some(113),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot A=\sinh\alpha.",
        plain: r"\dot A=\sinh\alpha.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-114",
        section: "4",
        equation: Some(114),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\alpha=\cos\psi-\frac{\cosh\alpha}{A}.",
        plain: r"\dot\alpha=\cos\psi-\frac{\cosh\alpha}{A}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-115",
        section: "4",
        equation: Some(115),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\psi=2 [1-(\sin\psi) \coth(2 \alpha)].",
        plain: r"\dot\psi=2 [1-(\sin\psi) \coth(2 \alpha)].",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-116",
        section: "4",
        equation: Some(116),
        kind: Kind::Equation,
        title: "",
        latex: r"p^2-\rho^2>0.",
        plain: r"p^2-\rho^2>0.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-117",
        section: "4",
        equation: Some(117),
        kind: Kind::Equation,
        title: "",
        latex: r"p=B \cosh\beta.",
        plain: r"p=B \cosh\beta.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-118",
        section: "4",
        equation: Some(118),
        kind: Kind::Equation,
        title: "",
        latex: r"\rho=B \sinh\beta.",
        plain: r"\rho=B \sinh\beta.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-119",
        section: "4",
        equation: Some(119),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot B=-\cosh\beta.",
        plain: r"\dot B=-\cosh\beta.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-120",
        section: "4",
        equation: Some(120),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\beta=\cos\psi+\frac{\sinh\beta}{B}.",
        plain: r"\dot\beta=\cos\psi+\frac{\sinh\beta}{B}.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-121",
        section: "4",
        equation: Some(121),
        kind: Kind::Equation,
        title: "",
        latex: r"\dot\psi=2 [1-(\sin\psi) \coth(2 \beta)].",
        plain: r"\dot\psi=2 [1-(\sin\psi) \coth(2 \beta)].",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-122",
        section: "4",
        equation: Some(122),
        kind: Kind::Equation,
        title: "",
        latex: r"A=-\mathrm{i} B.",
        plain: r"A=-\mathrm{i} B.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-123",
        section: "4",
        equation: Some(123),
        kind: Kind::Equation,
        title: "",
        latex: r"\alpha=\frac{\mathrm{i} \pi}{2}+\beta.",
        plain: r"\alpha=\frac{\mathrm{i} \pi}{2}+\beta.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-124",
        section: "4",
        equation: Some(124),
        kind: Kind::Equation,
        title: "",
        latex: r"\psi_1=\sin^{-1}[\tanh(2 \alpha)].",
        plain: r"\psi_1=\sin^{-1}[\tanh(2 \alpha)].",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-125",
        section: "4",
        equation: Some(125),
        kind: Kind::Equation,
        title: "",
        latex: r"\psi_2=\pi-\sin^{-1}[\tanh(2 \alpha)].",
        plain: r"\psi_2=\pi-\sin^{-1}[\tanh(2 \alpha)].",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-mirror",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"Ω → −Ω mirrors every solution, so Ω > 0 is no loss of generality",
        plain: r"Ω → −Ω mirrors every solution, so Ω > 0 is no loss of generality",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-coriolis-no-work",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"(106) is the work-energy theorem in the rotating frame; the Coriolis force does no work",
        plain: r"(106) is the work-energy theorem in the rotating frame; the Coriolis force does no work",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-quasi-fixed-stability",
        section: "4",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"ψ₁ of (124) attracts, ψ₂ of (125) repels",
        plain: r"ψ₁ of (124) attracts, ψ₂ of (125) repels",
        ..Claim::BLANK
    },
];
