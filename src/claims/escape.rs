//! The turntable: escape: the claims.

pub mod bounds;
pub mod escapes;
pub mod exact;
pub mod excepted;
pub mod growth;
pub mod onset;
pub mod steps;
pub mod straight;

use super::attempt::trials;
use super::excuses;
use super::{Claim, Condition, Correction, Sort, Topic};
use crate::evidence::{Change, Kind};

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
        sort: Sort::Stated,
    },
    Condition {
        text: r"$\alpha$ is near zero and $\psi$ near $\psi_1$",
        sort: Sort::Stated,
    },
];

/// The first case, (110), away from the starts that come straight in.
const INNER_NOT_STRAIGHT: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        sort: Sort::Stated,
    },
    Condition {
        text: r"the particle does not come straight in: on a surface of starts it stops, with $\psi\to\pi$, before its velocity has turned",
        sort: Sort::Degenerate,
    },
];

/// The first case, (110).
const INNER: &[Condition] = &[Condition {
    text: r"$p<\rho$",
    sort: Sort::Stated,
}];

/// Stated after (127).
const ESCAPING: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        sort: Sort::Stated,
    },
    Condition {
        text: "$A>1$ at the start",
        sort: Sort::Stated,
    },
    Condition {
        text: "large times",
        sort: Sort::Stated,
    },
];

/// Stated after (127) and before (130).
const ESCAPING_LARGE_A: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        sort: Sort::Stated,
    },
    Condition {
        text: "$A>1$ at the start",
        sort: Sort::Stated,
    },
    Condition {
        text: "$A$ is large",
        sort: Sort::Stated,
    },
];

/// Stated after (127), at large times.
const ESCAPING_LATE: &[Condition] = &[
    Condition {
        text: r"$p<\rho$",
        sort: Sort::Stated,
    },
    Condition {
        text: "$A>1$ at the start",
        sort: Sort::Stated,
    },
    Condition {
        text: r"$\tau\to\infty$",
        sort: Sort::Stated,
    },
];

/// How (130) is read.
const EQ130: &[Condition] = &[
    ESCAPING_LARGE_A[0],
    ESCAPING_LARGE_A[1],
    ESCAPING_LARGE_A[2],
    Condition {
        text: r"$\alpha-\frac13\ln4A\to0$, as (131) needs it, not the mere ratio",
        sort: Sort::Reading,
    },
];

/// How (133) is read.
const EQ133: &[Condition] = &[
    ESCAPING_LATE[0],
    ESCAPING_LATE[1],
    ESCAPING_LATE[2],
    Condition {
        text: r"$\alpha-\frac12\ln\frac{4\tau}3\to0$, as (135) needs it, not the mere ratio",
        sort: Sort::Reading,
    },
];

/// How (134) is read.
const EQ134: &[Condition] = &[
    ESCAPING_LATE[0],
    ESCAPING_LATE[1],
    ESCAPING_LATE[2],
    Condition {
        text: r"$\frac\pi2-\psi\sim(3/\tau)^{1/2}$; the mere limit $\psi\to\frac\pi2$ is right",
        sort: Sort::Reading,
    },
];

/// In which sense ψ goes to ψ₁.
const SMALL_ALPHA_ALONE: &[Condition] = &[
    INNER_NOT_STRAIGHT[0],
    INNER_NOT_STRAIGHT[1],
    Condition {
        text: r"read as $\psi-\psi_1\to0$, which is what (126) needs",
        sort: Sort::Reading,
    },
    Condition {
        text: r"for $A>\frac12$ the ratio of the two small angles tends to $\frac{\psi}{\psi_1}=\frac{A}{2A-1}$",
        sort: Sort::Remark,
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
        trials: trials![&exact::EQ126, onset::eq126_relaxed, onset::eq126_order],
        argument: r"The term is the first of the power series in $\alpha$; the next is of the second order, as $\cos\psi_1$ and $\cosh\alpha$ are even in $\alpha$, and $\cos\psi$ differs from $\cos\psi_1$ by $\lvert\psi-\psi_1\rvert$ at most.",
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
        conditions: INNER_NOT_STRAIGHT,
        depends_on: &["eq-111", "eq-112"],
        trials: trials![
            &exact::chains::ESCAPES,
            onset::above_one_census,
            onset::eq127_root,
            onset::above_one_straight,
            excepted::escaping
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\dot\alpha\simeq\frac{\sqrt2}{\cosh(2\alpha)}-\frac{\cosh\alpha}{A}\quad\text{at large times}",
            plain: "dα/dτ ≃ √2/cosh(2α) − (cosh α)/A at large times",
        }),
        trials: trials![
            growth::eq128_limit,
            &exact::spiral::EQ128,
            &exact::EQ128,
            growth::corrected128_limit
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"(\cosh\alpha)\cosh(2\alpha)\simeq\frac{3\sqrt2}{4}A",
            plain: "cosh α cosh(2α) ≃ (3√2/4) A",
        }),
        trials: trials![
            growth::eq129_limit,
            &exact::spiral::EQ129,
            &exact::EQ129,
            growth::corrected129_limit,
            steps::eq129
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-130",
        section: "4",
        equation: Some(130),
        kind: Kind::Equation,
        title: "α at large A",
        latex: r"\alpha\approx\frac{1}{3} \ln(4 A)",
        plain: "α ≈ ⅓ ln(4A)",
        conditions: EQ130,
        depends_on: &["eq-129"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\alpha\simeq\frac{1}{3}\ln(3\sqrt2 A)",
            plain: "α ≃ ⅓ ln(3√2·A)",
        }),
        trials: trials![
            growth::eq130_limit,
            &exact::spiral::EQ130,
            &exact::EQ130,
            growth::corrected130_limit
                .coarse(&[("thrice_alpha_exp", "a third of its logarithm is compared")]),
            steps::eq130,
            onset::alpha_by_a_grows
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\dot A\simeq\frac{(3\sqrt2 A)^{1/3}}{2}",
            plain: "dA/dτ ≃ (3√2·A)^(1/3)/2",
        }),
        trials: trials![
            growth::eq131_limit,
            &exact::spiral::EQ131,
            &exact::EQ131,
            growth::corrected131_limit,
            steps::eq131
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"A\sim\frac{2^{1/4}}{3}\tau^{3/2}\left[1-\frac{9\sqrt2}{8}\frac{\ln\tau}{\tau}+\cdots\right]",
            plain: "A ~ (2^(1/4)/3) τ^(3/2) [1 − (9√2/8) (ln τ)/τ + ⋯]",
        }),
        trials: trials![
            growth::eq132_limit,
            growth::eq132_exponent.coarse(&[("eq132_a", excuses::EXPONENT)]),
            &exact::spiral::EQ132,
            bounds::eq132,
            &exact::EQ132,
            growth::corrected132_limit.coarse(&[("a", excuses::HALF)]),
            growth::corrected132_delay.elsewhere(excuses::DELAY),
            steps::eq132
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-133",
        section: "4",
        equation: Some(133),
        kind: Kind::Limit,
        title: "growth of α",
        latex: r"\alpha\sim\frac{1}{2} \ln\frac{4 \tau}{3}",
        plain: "α ~ ½ ln(4τ/3)",
        conditions: EQ133,
        depends_on: &["eq-130", "eq-132"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\alpha=\frac12\ln(\sqrt2\,\tau)+o(1)",
            plain: "α = ½ ln(√2·τ) + o(1)",
        }),
        trials: trials![
            growth::eq133_limit,
            &exact::spiral::EQ133,
            bounds::eq133,
            &exact::EQ133,
            growth::corrected133_limit.coarse(&[("twice_alpha_exp", excuses::HALF)]),
            steps::eq133,
            onset::alpha_grows
        ],
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
        conditions: EQ134,
        depends_on: &["eq-124", "eq-133"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\psi\sim\frac\pi2-\frac2\tau\left[1+\frac{3\sqrt2}{4}\frac{\ln\tau}{\tau}+\cdots\right]",
            plain: "ψ ~ π/2 − (2/τ) [1 + (3√2/4) (ln τ)/τ + ⋯]",
        }),
        trials: trials![
            growth::eq134_exponent,
            growth::eq134_limit,
            &exact::spiral::EQ134,
            bounds::eq134,
            &exact::EQ134,
            growth::corrected134_exponent.coarse(&[("lag", excuses::EXPONENT)]),
            growth::corrected134_limit,
            growth::corrected134_delay,
            steps::eq134,
            onset::psi_goes_upright
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"p\sim\frac{\tau^2}{3\sqrt2}\left[1-\frac{3\sqrt2}{2}\frac{\ln\tau}{\tau}+\cdots\right]",
            plain: "p ~ (τ²/(3√2)) [1 − (3√2/2) (ln τ)/τ + ⋯]",
        }),
        trials: trials![
            growth::eq135_limit,
            growth::eq135_exponent.coarse(&[("eq135_p", excuses::EXPONENT)]),
            &exact::spiral::EQ135,
            bounds::eq135,
            &exact::EQ135,
            growth::corrected135_limit
                .coarse(&[("amplitude", excuses::HALF), ("rho", excuses::HALF)]),
            growth::corrected135_delay.elsewhere(excuses::DELAY),
            steps::eq135
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\rho\sim\frac{\tau^2}{3\sqrt2}\left[1-\frac{3\sqrt2}{2}\frac{\ln\tau}{\tau}+\cdots\right]",
            plain: "ρ ~ (τ²/(3√2)) [1 − (3√2/2) (ln τ)/τ + ⋯]",
        }),
        trials: trials![
            growth::eq136_limit,
            growth::eq136_exponent.coarse(&[("eq136_rho", excuses::EXPONENT)]),
            &exact::spiral::EQ136,
            bounds::eq136,
            &exact::EQ136.elsewhere(excuses::AS_135),
            growth::corrected136_limit.elsewhere(excuses::AS_135),
            growth::corrected136_delay.elsewhere(excuses::DELAY),
            growth::winding_limit,
            steps::eq136
        ],
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
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"s\sim\frac{\tau^3}{9\sqrt2}\left[1-\frac{9\sqrt2}{4}\frac{\ln\tau}{\tau}+\cdots\right]",
            plain: "s ~ (τ³/(9√2)) [1 − (9√2/4) (ln τ)/τ + ⋯]",
        }),
        trials: trials![
            growth::eq137_limit,
            growth::eq137_exponent.coarse(&[("eq137_s", excuses::EXPONENT)]),
            &exact::spiral::EQ137,
            &exact::EQ137,
            growth::corrected137_limit.coarse(&[("s", excuses::HALF)]),
            growth::corrected137_delay.elsewhere(excuses::DELAY),
            steps::eq137
        ],
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
        trials: trials![&exact::EQ138, growth::eq138_limit],
        argument: r"$A^2/2-s$ is constant, as both have one rate. $A$ grows without end in every escape, as is shown of (127), so that the ratio tends to 1.",
        ..Claim::BLANK
    },
    Claim {
        id: "s4-A-never-decreases",
        section: "4",
        title: "A never decreases",
        latex: r"$A$ never decreases, and grows without end unless $\alpha\to0$.",
        plain: "A never decreases, and grows without end unless α → 0.",
        conditions: INNER,
        depends_on: &["eq-113"],
        trials: trials![
            &exact::NEVER_DECREASES.elsewhere(excuses::BY_THE_LAW),
            onset::never_decreases_way,
            onset::never_decreases_census
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-small-alpha",
        section: "4",
        title: "ψ relaxes near α = 0",
        latex: r"Near $\alpha=0$ the angle $\psi$ goes rapidly to $\psi_1$, itself near zero, and then (126) holds.",
        plain: "Near α = 0 the angle ψ goes rapidly to ψ₁, itself near zero, and then (126) holds.",
        conditions: SMALL_ALPHA_ALONE,
        depends_on: &["eq-115", "eq-124", "eq-126"],
        trials: trials![
            &exact::chains::RELAXES,
            onset::small_alpha_angle,
            onset::small_alpha_rate,
            onset::small_alpha_straight,
            onset::relaxed_ratio,
            onset::relaxed_ratio_rate,
            excepted::small_alpha
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-escape-if-A-above-1",
        section: "4",
        title: "escape",
        latex: "If $A>1$ at the start, $A$ grows without end and the speed never vanishes.",
        plain: "If A > 1 at the start, A grows without end and the speed never vanishes.",
        conditions: INNER_NOT_STRAIGHT,
        depends_on: &["eq-126", "eq-127", "s4-A-never-decreases", "s4-small-alpha"],
        trials: trials![
            &exact::chains::ESCAPES,
            onset::above_one_within,
            onset::a_grows,
            onset::straight_stops,
            onset::straight_rate,
            excepted::escaping
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-alpha-unbounded",
        section: "4",
        title: "α grows too",
        latex: r"If $A>1$ at the start, $\alpha$ grows without end, like $A$.",
        plain: "If A > 1 at the start, α grows without end, like A.",
        conditions: INNER,
        depends_on: &["eq-128", "s4-escape-if-A-above-1"],
        trials: trials![
            &exact::chains::ALPHA_GROWS,
            onset::alpha_grows,
            onset::alpha_census
        ],
        ..Claim::BLANK
    },
];
