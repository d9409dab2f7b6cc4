//! The turntable: equations: the claims.

mod complex;
mod continued;
mod definitions;
pub mod drawn;
mod ends;
mod energy;
pub mod exact;
pub mod excepted;
pub mod fixed;
mod frames;
pub mod projections;
mod rates;
mod standstill;
pub mod stretches;

use super::attempt::trials;
use super::{Claim, Condition, Correction, Sort, Topic};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "turntable",
    title: "The turntable: equations",
    claims: CLAIMS,
};

/// Stated after (86).
const POSITIVE: &[Condition] = &[Condition {
    text: r"$\Omega>0$",
    sort: Sort::Stated,
}];

/// Where the friction term divides by the speed.
const SLIDES: Condition = Condition {
    text: "the particle slides: at rest, friction is only as large as it has to be, and the term has no value",
    sort: Sort::Degenerate,
};

/// Where a rate is that of a sliding particle.
const MOVES: Condition = Condition {
    text: r"$p>0$: at rest $\xi$ and $\psi$ have no value, and a particle that friction holds stays at rest",
    sort: Sort::Degenerate,
};

/// Where a formula divides by the speed.
const NOT_AT_REST: Condition = Condition {
    text: "$p>0$: at rest it is $0/0$",
    sort: Sort::Degenerate,
};

/// Where a formula divides by the distance.
const OFF_AXIS: Condition = Condition {
    text: r"$\rho>0$: on the axis it is $\infty\cdot0$",
    sort: Sort::Degenerate,
};

const NO_ANGLE_ON_AXIS: Condition = Condition {
    text: r"$\rho>0$: on the axis $\psi$ has no value; it jumps from $\pi$ to $0$ as a particle passes",
    sort: Sort::Degenerate,
};

/// Stated after (86), with the first condition.
const POSITIVE_SLIDES: &[Condition] = &[POSITIVE[0], SLIDES];

/// The first case of a particle that moves.
const INNER_MOVES: &[Condition] = &[INNER[0], MOVES];

/// The first case, off rest.
const INNER_NOT_AT_REST: &[Condition] = &[
    INNER[0],
    Condition {
        text: r"$\alpha>0$: at rest it is $\infty\cdot0$",
        sort: Sort::Degenerate,
    },
];

/// The second case, off the axis.
const OUTER_OFF_AXIS: &[Condition] = &[
    OUTER[0],
    Condition {
        text: r"$\beta>0$: on the axis it is $\infty\cdot0$",
        sort: Sort::Degenerate,
    },
];

/// In which sense one quasi-fixed point attracts and the other repels.
const FROZEN: &[Condition] = &[
    INNER[0],
    Condition {
        text: r"$\alpha$ is held fixed",
        sort: Sort::Stated,
    },
];

/// (106) with the friction coefficient.
const ENERGY: Correction = Correction {
    change: Change::Factor,
    latex: r"\frac{m}{2} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right)\cdot\left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right) -\frac{m \Omega^2 r^2}{2}+m \mu g s=\text{constant}",
    plain: "(m/2) (d𝐫/dt)·(d𝐫/dt) − m Ω² r²/2 + m μ g s = constant",
};

/// The work of friction with the friction coefficient.
const WORK: Correction = Correction {
    change: Change::Factor,
    latex: r"$-m\mu gs$ is the work of the friction; the Coriolis force does no work",
    plain: "−m μ g s is the work of the friction; the Coriolis force does no work",
};

/// The first case, (110).
const INNER: &[Condition] = &[Condition {
    text: r"$p<\rho$",
    sort: Sort::Stated,
}];

/// The second case, (116).
const OUTER: &[Condition] = &[Condition {
    text: r"$p>\rho$",
    sort: Sort::Stated,
}];

/// Of the zeros of (115).
const QUASI: &str = r"For $\alpha>0$ (115) is 0 where $\sin\psi=\tanh2\alpha$, which lies between 0 and 1: in a turn at $\psi_1$ and $\psi_2$, and nowhere else.";

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-86",
        section: "4",
        equation: Some(86),
        kind: Kind::Equation,
        title: "Newton's law on the turntable",
        latex: r"\frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=\Omega^2 \bm{r}+2 \Omega \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\times\hat{\bm{z}} -\mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right\vert ^{-1} \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}",
        plain: "d²𝐫/dt² = Ω² 𝐫 + 2Ω d𝐫/dt × ẑ − μ g (d𝐫/dt)/|d𝐫/dt|",
        conditions: &[SLIDES],
        trials: trials![
            &exact::EQ86,
            frames::eq86,
            frames::eq86_turns,
            standstill::eq86,
            excepted::eq86
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-87",
        section: "4",
        equation: Some(87),
        kind: Kind::Definition,
        title: "dimensionless position",
        latex: r"\bm{\rho}=\frac{\Omega^2}{\mu g} \bm{r}",
        plain: "𝛒 = (Ω²/(μ g)) 𝐫",
        conditions: POSITIVE,
        trials: trials![&exact::EQ87, frames::eq87],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-88",
        section: "4",
        equation: Some(88),
        kind: Kind::Definition,
        title: "dimensionless time",
        latex: r"\tau=\Omega t",
        plain: "τ = Ω t",
        conditions: POSITIVE,
        trials: trials![&exact::EQ88, frames::eq88],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-89",
        section: "4",
        equation: Some(89),
        kind: Kind::Equation,
        title: "Newton's law, dimensionless",
        latex: r"\ddot{\bm{\rho}}=\bm{\rho}+2 \dot{\bm{\rho}}\times\hat{\bm{z}} -\frac{\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }",
        plain: "d²𝛒/dτ² = 𝛒 + 2 d𝛒/dτ × ẑ − (d𝛒/dτ)/|d𝛒/dτ|",
        depends_on: &["eq-86", "eq-87", "eq-88"],
        conditions: POSITIVE_SLIDES,
        trials: trials![
            &exact::EQ89,
            frames::eq89,
            standstill::eq89,
            ends::eq89_from_rest,
            ends::eq89_by_components,
            excepted::eq89
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-90",
        section: "4",
        equation: Some(90),
        kind: Kind::Equation,
        title: "projection on the velocity",
        latex: r"\dot{\bm{\rho}}\cdot\ddot{\bm{\rho}}=\bm{\rho}\cdot\dot{\bm{\rho}}-\vert \dot{\bm{\rho}}\vert",
        plain: "(d𝛒/dτ)·(d²𝛒/dτ²) = 𝛒·(d𝛒/dτ) − |d𝛒/dτ|",
        depends_on: &["eq-89"],
        trials: trials![&exact::EQ90, rates::eq90],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-91",
        section: "4",
        equation: Some(91),
        kind: Kind::Equation,
        title: "moment about the axis",
        latex: r"\hat{\bm{z}}\cdot\bm{\rho}\times\ddot{\bm{\rho}}=-2 \bm{\rho}\cdot\dot{\bm{\rho}} -\frac{\hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }",
        plain: "ẑ·(𝛒 × d²𝛒/dτ²) = −2 𝛒·(d𝛒/dτ) − ẑ·(𝛒 × d𝛒/dτ)/|d𝛒/dτ|",
        depends_on: &["eq-89"],
        conditions: &[NOT_AT_REST],
        trials: trials![
            &exact::EQ91,
            rates::eq91,
            standstill::eq91,
            ends::eq91_from_rest,
            excepted::eq91
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-92",
        section: "4",
        equation: Some(92),
        kind: Kind::Equation,
        title: "projection on the position",
        latex: r"\bm{\rho}\cdot\ddot{\bm{\rho}}+\dot{\bm{\rho}}\cdot\dot{\bm{\rho}}=\bm{\rho}\cdot\bm{\rho} +2 \hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}} -\frac{\bm{\rho}\cdot\dot{\bm{\rho}}}{\vert \dot{\bm{\rho}}\vert }+\dot{\bm{\rho}}\cdot\dot{\bm{\rho}}",
        plain: "𝛒·(d²𝛒/dτ²) + |d𝛒/dτ|² = 𝛒·𝛒 + 2 ẑ·(𝛒 × d𝛒/dτ) − 𝛒·(d𝛒/dτ)/|d𝛒/dτ| + |d𝛒/dτ|²",
        depends_on: &["eq-89"],
        conditions: &[NOT_AT_REST],
        trials: trials![
            &exact::EQ92,
            rates::eq92,
            standstill::eq92,
            ends::eq92_from_rest,
            excepted::eq92
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-93",
        section: "4",
        equation: Some(93),
        kind: Kind::Definition,
        title: "dimensionless speed",
        latex: r"p=\vert \dot{\bm{\rho}}\vert",
        plain: "p = |d𝛒/dτ|",
        depends_on: &["eq-87", "eq-88"],
        trials: trials![&exact::EQ93, definitions::eq93],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-94",
        section: "4",
        equation: Some(94),
        kind: Kind::Definition,
        title: "position along the velocity",
        latex: r"\xi=\rho \cos\psi",
        plain: "ξ = ρ cos ψ",
        depends_on: &["eq-87"],
        trials: trials![&exact::EQ94, definitions::eq94],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-95",
        section: "4",
        equation: Some(95),
        kind: Kind::Definition,
        title: "position across the velocity",
        latex: r"\ell=-\rho \sin\psi",
        plain: "ℓ = −ρ sin ψ",
        depends_on: &["eq-87"],
        trials: trials![&exact::EQ95, definitions::eq95],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-96",
        section: "4",
        equation: Some(96),
        kind: Kind::Equation,
        title: "angular momentum",
        latex: r"p \ell=\hat{\bm{z}}\cdot\bm{\rho}\times\dot{\bm{\rho}}",
        plain: "p ℓ = ẑ·(𝛒 × d𝛒/dτ)",
        depends_on: &["eq-93", "eq-95"],
        trials: trials![&exact::EQ96, definitions::eq96],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-97",
        section: "4",
        equation: Some(97),
        kind: Kind::Equation,
        title: "radial motion",
        latex: r"p \xi=\bm{\rho}\cdot\dot{\bm{\rho}}",
        plain: "p ξ = 𝛒·(d𝛒/dτ)",
        depends_on: &["eq-93", "eq-94"],
        trials: trials![&exact::EQ97, definitions::eq97],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-98",
        section: "4",
        equation: Some(98),
        kind: Kind::Equation,
        title: "distance from the axis",
        latex: r"\bm{\rho}\cdot\bm{\rho}=\ell^2+\xi^2",
        plain: "𝛒·𝛒 = ℓ² + ξ²",
        depends_on: &["eq-94", "eq-95"],
        trials: trials![&exact::EQ98, definitions::eq98],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-99",
        section: "4",
        equation: Some(99),
        kind: Kind::Equation,
        title: "rate of the speed p",
        latex: r"\dot p=\xi-1",
        plain: "dp/dτ = ξ − 1",
        depends_on: &["eq-90", "eq-93", "eq-97"],
        conditions: &[MOVES],
        trials: trials![
            &exact::EQ99,
            rates::eq99,
            standstill::eq99,
            ends::eq99_until_rest,
            ends::eq99_of_many,
            excepted::rest
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-100",
        section: "4",
        equation: Some(100),
        kind: Kind::Equation,
        title: "rate of ℓ",
        latex: r"\dot\ell=-\frac{\xi (2 p+\ell)}{p}",
        plain: "dℓ/dτ = −ξ (2p + ℓ)/p",
        depends_on: &["eq-91", "eq-96", "eq-97", "eq-99"],
        conditions: &[NOT_AT_REST],
        trials: trials![
            &exact::EQ100,
            rates::eq100,
            standstill::eq100,
            excepted::eq100
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-101",
        section: "4",
        equation: Some(101),
        kind: Kind::Equation,
        title: "rate of ξ",
        latex: r"\dot\xi=\frac{(p+\ell)^2}{p}",
        plain: "dξ/dτ = (p + ℓ)²/p",
        depends_on: &["eq-92", "eq-96", "eq-97", "eq-98", "eq-99"],
        conditions: &[NOT_AT_REST],
        trials: trials![
            &exact::EQ101,
            rates::eq101,
            standstill::eq101,
            excepted::eq101
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-102",
        section: "4",
        equation: Some(102),
        kind: Kind::Equation,
        title: "rate of ρ²/2",
        latex: r"=p (\dot p+1)",
        plain: "ρ dρ/dτ = ℓ dℓ/dτ + ξ dξ/dτ = ξ p = p (dp/dτ + 1)",
        depends_on: &["eq-98", "eq-99", "eq-100", "eq-101"],
        trials: trials![&exact::EQ102, rates::eq102],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-103",
        section: "4",
        equation: Some(103),
        kind: Kind::Equation,
        title: "loss of energy to friction",
        latex: r"\left(\frac{p^2-\rho^2}{2}\right)^{\cdot}=-p",
        plain: "d[(p² − ρ²)/2]/dτ = −p",
        depends_on: &["eq-102"],
        trials: trials![&exact::EQ103, definitions::eq103, rates::eq103],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-104",
        section: "4",
        equation: Some(104),
        kind: Kind::Equation,
        title: "constant of motion",
        latex: r"\frac{p^2-\rho^2}{2}+s=\text{constant}",
        plain: "(p² − ρ²)/2 + s = constant",
        depends_on: &["eq-103", "eq-105"],
        trials: trials![
            &exact::EQ104,
            energy::eq104,
            drawn::kept,
            ends::eq104_at_rest,
            ends::eq104_of_many
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-105",
        section: "4",
        equation: Some(105),
        kind: Kind::Definition,
        title: "arc length",
        latex: r"\dot s=p",
        plain: "ds/dτ = p",
        depends_on: &["eq-93"],
        trials: trials![energy::eq105],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-106",
        section: "4",
        equation: Some(106),
        kind: Kind::Equation,
        title: "energy theorem with its dimensions",
        latex: r"\frac{m}{2} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right)\cdot\left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}\right) -\frac{m \Omega^2 r^2}{2}+m g s=\text{constant}",
        plain: "(m/2) (d𝐫/dt)·(d𝐫/dt) − m Ω² r²/2 + m g s = constant",
        depends_on: &["eq-87", "eq-88", "eq-104"],
        correction: Some(ENERGY),
        trials: trials![
            energy::eq106,
            &exact::PRINTED_106,
            &exact::CORRECTED_106,
            energy::eq106_corrected
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-107",
        section: "4",
        equation: Some(107),
        kind: Kind::Equation,
        title: "rate of the speed p, by ψ",
        latex: r"\dot p=\rho \cos\psi-1",
        plain: "dp/dτ = ρ cos ψ − 1",
        depends_on: &["eq-94", "eq-99"],
        conditions: &[MOVES],
        trials: trials![
            &exact::EQ107,
            rates::eq107,
            standstill::eq107,
            excepted::rest
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-108",
        section: "4",
        equation: Some(108),
        kind: Kind::Equation,
        title: "rate of the distance ρ",
        latex: r"\dot\rho=p \cos\psi",
        plain: "dρ/dτ = p cos ψ",
        depends_on: &["eq-94", "eq-102"],
        conditions: &[NO_ANGLE_ON_AXIS],
        trials: trials![
            &exact::EQ108,
            rates::eq108,
            standstill::eq108,
            excepted::axis
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-109",
        section: "4",
        equation: Some(109),
        kind: Kind::Equation,
        title: "rate of the angle ψ",
        latex: r"\dot\psi=2-\left(\frac{p}{\rho}+\frac{\rho}{p}\right) \sin\psi",
        plain: "dψ/dτ = 2 − (p/ρ + ρ/p) sin ψ",
        depends_on: &["eq-94", "eq-95", "eq-100", "eq-108"],
        conditions: &[NOT_AT_REST, OFF_AXIS],
        trials: trials![
            &exact::EQ109,
            rates::eq109,
            standstill::eq109,
            standstill::eq109_on_the_axis,
            excepted::eq109_rest,
            excepted::eq109_axis
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-110",
        section: "4",
        equation: Some(110),
        kind: Kind::Definition,
        title: "the first case: slower than the table",
        latex: r"p^2-\rho^2<0",
        plain: "p² − ρ² < 0",
        depends_on: &["eq-93"],
        trials: trials![&exact::EQ110, definitions::eq110],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-111",
        section: "4",
        equation: Some(111),
        kind: Kind::Definition,
        title: "speed by A and α",
        latex: r"p=A \sinh\alpha",
        plain: "p = A sinh α",
        depends_on: &["eq-110"],
        trials: trials![&exact::EQ111, definitions::eq111],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-112",
        section: "4",
        equation: Some(112),
        kind: Kind::Definition,
        title: "distance by A and α",
        latex: r"\rho=A \cosh\alpha",
        plain: "ρ = A cosh α",
        depends_on: &["eq-110"],
        trials: trials![&exact::EQ112, definitions::eq112],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-113",
        section: "4",
        equation: Some(113),
        kind: Kind::Equation,
        title: "rate of A",
        latex: r"\dot A=\sinh\alpha",
        plain: "dA/dτ = sinh α",
        depends_on: &["eq-107", "eq-108", "eq-111", "eq-112"],
        conditions: INNER,
        trials: trials![&exact::EQ113, rates::eq113],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-114",
        section: "4",
        equation: Some(114),
        kind: Kind::Equation,
        title: "rate of α",
        latex: r"\dot\alpha=\cos\psi-\frac{\cosh\alpha}{A}",
        plain: "dα/dτ = cos ψ − (cosh α)/A",
        depends_on: &["eq-107", "eq-108", "eq-111", "eq-112"],
        conditions: INNER_MOVES,
        trials: trials![
            &exact::EQ114,
            rates::eq114,
            standstill::eq114,
            excepted::rest
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-115",
        section: "4",
        equation: Some(115),
        kind: Kind::Equation,
        title: "rate of the angle ψ, by α",
        latex: r"\dot\psi=2 [1-(\sin\psi) \coth(2 \alpha)]",
        plain: "dψ/dτ = 2 [1 − sin ψ coth(2α)]",
        depends_on: &["eq-109", "eq-111", "eq-112"],
        conditions: INNER_NOT_AT_REST,
        trials: trials![
            &exact::EQ115,
            rates::eq115,
            standstill::eq115,
            excepted::eq115
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-116",
        section: "4",
        equation: Some(116),
        kind: Kind::Definition,
        title: "the second case: faster than the table",
        latex: r"p^2-\rho^2>0",
        plain: "p² − ρ² > 0",
        depends_on: &["eq-93"],
        trials: trials![&exact::EQ116, definitions::eq116],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-117",
        section: "4",
        equation: Some(117),
        kind: Kind::Definition,
        title: "speed by B and β",
        latex: r"p=B \cosh\beta",
        plain: "p = B cosh β",
        depends_on: &["eq-116"],
        trials: trials![&exact::EQ117, definitions::eq117],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-118",
        section: "4",
        equation: Some(118),
        kind: Kind::Definition,
        title: "distance by B and β",
        latex: r"\rho=B \sinh\beta",
        plain: "ρ = B sinh β",
        depends_on: &["eq-116"],
        trials: trials![&exact::EQ118, definitions::eq118],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-119",
        section: "4",
        equation: Some(119),
        kind: Kind::Equation,
        title: "rate of B",
        latex: r"\dot B=-\cosh\beta",
        plain: "dB/dτ = −cosh β",
        depends_on: &["eq-107", "eq-108", "eq-117", "eq-118"],
        conditions: OUTER,
        trials: trials![&exact::EQ119, rates::eq119],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-120",
        section: "4",
        equation: Some(120),
        kind: Kind::Equation,
        title: "rate of β",
        latex: r"\dot\beta=\cos\psi+\frac{\sinh\beta}{B}",
        plain: "dβ/dτ = cos ψ + (sinh β)/B",
        depends_on: &["eq-107", "eq-108", "eq-117", "eq-118"],
        conditions: &[OUTER[0], NO_ANGLE_ON_AXIS],
        trials: trials![
            &exact::EQ120,
            rates::eq120,
            standstill::eq120,
            excepted::axis
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-121",
        section: "4",
        equation: Some(121),
        kind: Kind::Equation,
        title: "rate of the angle ψ, by β",
        latex: r"\dot\psi=2 [1-(\sin\psi) \coth(2 \beta)]",
        plain: "dψ/dτ = 2 [1 − sin ψ coth(2β)]",
        depends_on: &["eq-109", "eq-117", "eq-118"],
        conditions: OUTER_OFF_AXIS,
        trials: trials![
            &exact::EQ121,
            rates::eq121,
            standstill::eq121,
            excepted::eq121
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-122",
        section: "4",
        equation: Some(122),
        kind: Kind::Equation,
        title: "A from B",
        latex: r"A=-\mathrm{i} B",
        plain: "A = −i B",
        depends_on: &["eq-111", "eq-112", "eq-117", "eq-118"],
        trials: trials![&exact::EQ122, continued::eq122],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-123",
        section: "4",
        equation: Some(123),
        kind: Kind::Equation,
        title: "α from β",
        latex: r"\alpha=\frac{\mathrm{i} \pi}{2}+\beta",
        plain: "α = iπ/2 + β",
        depends_on: &["eq-111", "eq-112", "eq-117", "eq-118"],
        trials: trials![&exact::EQ123, continued::eq123],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-124",
        section: "4",
        equation: Some(124),
        kind: Kind::Equation,
        title: "first quasi-fixed point of ψ",
        latex: r"\psi_1=\sin^{-1}[\tanh(2 \alpha)]",
        plain: "ψ₁ = asin[tanh(2α)]",
        depends_on: &["eq-115"],
        conditions: INNER,
        trials: trials![&exact::EQ124, fixed::psi1],
        argument: QUASI,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-125",
        section: "4",
        equation: Some(125),
        kind: Kind::Equation,
        title: "second quasi-fixed point of ψ",
        latex: r"\psi_2=\pi-\sin^{-1}[\tanh(2 \alpha)]",
        plain: "ψ₂ = π − asin[tanh(2α)]",
        depends_on: &["eq-115"],
        conditions: INNER,
        trials: trials![&exact::EQ125, fixed::psi2],
        argument: QUASI,
        ..Claim::BLANK
    },
    Claim {
        id: "s4-mirror",
        section: "4",
        title: "mirror image",
        latex: r"A solution for $\Omega$, mirrored, is a solution for $-\Omega$; so $\Omega>0$ loses nothing.",
        plain: "A solution for Ω, mirrored, is a solution for −Ω; so Ω > 0 loses nothing.",
        depends_on: &["eq-86"],
        trials: trials![&exact::S4_MIRROR, frames::mirror],
        argument: r"A reflection keeps distances, speeds and times, so that what is found for $\Omega>0$ holds for $\Omega<0$ with the senses of turning exchanged.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-projection-tangential",
        section: "4",
        title: "where (99) comes from",
        latex: r"(99) is the projection of Newton's law on the velocity.",
        plain: "(99) is the projection of Newton's law on the velocity.",
        depends_on: &["eq-89", "eq-99"],
        conditions: &[MOVES],
        trials: trials![
            &exact::TANGENTIAL,
            projections::tangential,
            standstill::tangential,
            excepted::rest
        ],
        argument: r"The rate of $p$ that is multiplied out in the steps is the component of (89) along the velocity.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-projection-azimuthal",
        section: "4",
        title: "where (100) comes from",
        latex: r"(100) is the law of the angular momentum, combined with the rate of $u$.",
        plain: "(100) is the law of the angular momentum, combined with the rate of u.",
        depends_on: &["eq-91", "eq-96", "eq-99", "eq-100"],
        trials: trials![
            projections::azimuthal,
            projections::azimuthal_corrected,
            &exact::AZIMUTHAL
        ],
        correction: Some(Correction {
            change: Change::Symbol,
            latex: r"(100) is the law of the angular momentum, combined with the rate of $p$.",
            plain: "(100) is the law of the angular momentum, combined with the rate of p.",
        }),
        argument: r"The steps multiply out the rate of the angular momentum $p\ell$ and take the rate of $p$ from it, as the claim says.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-projection-radial",
        section: "4",
        title: "where (101) comes from",
        latex: r"(101) is Newton's law along the radius, combined with the rate of $u$.",
        plain: "(101) is Newton's law along the radius, combined with the rate of u.",
        depends_on: &["eq-92", "eq-97", "eq-99", "eq-101"],
        trials: trials![
            projections::radial,
            projections::radial_corrected,
            &exact::RADIAL
        ],
        correction: Some(Correction {
            change: Change::Symbol,
            latex: r"(101) is Newton's law along the radius, combined with the rate of $p$.",
            plain: "(101) is Newton's law along the radius, combined with the rate of p.",
        }),
        argument: r"The steps multiply out the component of (89) along the radius, which is the rate of $p\xi$, and take the rate of $p$ from it, as the claim says.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-constant-of-motion",
        section: "4",
        title: "a constant of the motion",
        latex: r"The equations (99) to (101) for $p$, $\ell$ and $\xi$ have a constant of motion, (104).",
        plain: "The equations (99) to (101) for p, ℓ and ξ have a constant of motion, (104).",
        depends_on: &["eq-99", "eq-100", "eq-101", "eq-104", "eq-105"],
        conditions: &[Condition {
            text: r"of the system enlarged by $s$, with (105): what $p$, $\ell$ and $\xi$ give alone, $\frac12(p^2-\rho^2)$, falls at the rate $p$",
            sort: Sort::Remark,
        }],
        trials: trials![&exact::EQ104, energy::eq104_kept, energy::eq104_without_s],
        argument: r"A quantity whose rate is 0 along every motion keeps its value.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-coriolis-no-work",
        section: "4",
        title: "who does work",
        latex: "(106) is the work-energy theorem in the rotating frame, $-mgs$ the work of the friction; the Coriolis force does no work.",
        plain: "(106) is the work-energy theorem in the rotating frame, −m g s the work of the friction; the Coriolis force does no work.",
        depends_on: &["eq-86", "eq-106"],
        correction: Some(WORK),
        trials: trials![
            energy::friction,
            &exact::PRINTED_WORK,
            energy::coriolis,
            &exact::CORRECTED_WORK,
            energy::friction_corrected,
            energy::work_step
        ],
        argument: r"A force whose power is 0 at every instant does no work, and the work of friction is the integral of its power.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-quasi-fixed-stability",
        section: "4",
        title: "stability of the quasi-fixed points",
        latex: r"$\psi_1$ of (124) attracts, $\psi_2$ of (125) repels.",
        plain: "ψ₁ of (124) attracts, ψ₂ of (125) repels.",
        depends_on: &["eq-115", "eq-124", "eq-125"],
        conditions: FROZEN,
        trials: trials![
            &exact::S4_QUASI_FIXED_STABILITY,
            fixed::separation,
            fixed::frozen
        ],
        argument: r"With $\alpha>0$ held fixed the first slope is negative, so that a nearby $\psi$ comes nearer, and the second is positive, so that it goes away.",
        ..Claim::BLANK
    },
];
