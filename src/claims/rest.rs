//! The turntable: rest: the claims.

pub mod approach;
pub mod boundary;
pub mod certified;
mod dichotomy;
pub mod exact;
pub mod excepted;
pub mod fates;
pub mod radius;
pub mod stops;
pub mod surfaces;

use super::attempt::trials;
use super::{Claim, Condition, Correction, Sort, Topic};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "rest",
    title: "The turntable: rest",
    claims: CLAIMS,
};

/// Of a particle at rest at ρ = σ.
const HELD: &str = r"At rest friction has to balance $\sigma$, outwards, and can give 1 at most in these units: it holds the particle exactly where $\sigma\leq1$. Beyond, $\dot p=\sigma-1$ outwards is positive; inside, (107) lets $p$ grow in no direction, as the square is not negative.";

/// Stated before (139).
const AT_REST: &[Condition] = &[Condition {
    text: r"the particle stays at rest at $\rho=\sigma$",
    sort: Sort::Stated,
}];

/// Stated before (140).
const NEAR_REST: &[Condition] = &[Condition {
    text: r"just before the particle comes to rest at $\rho=\sigma$",
    sort: Sort::Stated,
}];

/// What the paper takes for granted before (140).
const TO_ZERO: Condition = Condition {
    text: r"$\psi\to0$: on a surface of starts the particle comes straight in and rests with $\psi\to\pi$",
    sort: Sort::Degenerate,
};

/// Before (140), and where it holds.
const NEAR_REST_TO_ZERO: &[Condition] = &[
    NEAR_REST[0],
    Condition {
        text: r"$0<\sigma<1$: at $\sigma=1$ the particle takes for ever",
        sort: Sort::Degenerate,
    },
    TO_ZERO,
];

/// Before (140), and where (141) holds.
const NEAR_REST_CLOCK: &[Condition] = &[
    NEAR_REST[0],
    Condition {
        text: r"$\tau$ is counted from the moment of rest, as $\alpha=0$ at $\tau=0$ has it",
        sort: Sort::Stated,
    },
    Condition {
        text: r"$0<\sigma<1$: at $\sigma=1$ the particle takes for ever",
        sort: Sort::Degenerate,
    },
    TO_ZERO,
];

/// Before (140), and where both terms of (143) exceed what it leaves out.
const NEAR_REST_TWO_TERMS: &[Condition] = &[
    NEAR_REST[0],
    Condition {
        text: r"$\sigma\neq\frac12$, where both terms are infinite",
        sort: Sort::Degenerate,
    },
    Condition {
        text: r"$\frac14<\sigma<\frac34$: below, a term left out, of order $\alpha^{3\sigma/(1-\sigma)}$, exceeds the first term kept; above, one of order $\alpha^3$ exceeds the second",
        sort: Sort::Substance,
    },
    Condition {
        text: r"“$+\cdots$” is smaller than either term; as the solution of (142) alone it needs no condition",
        sort: Sort::Reading,
    },
    TO_ZERO,
];

/// The first case, (110).
const INNER: &[Condition] = &[Condition {
    text: r"$p<\rho$",
    sort: Sort::Stated,
}];

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-139",
        section: "4",
        equation: Some(139),
        kind: Kind::Inequality,
        title: "where rest is possible",
        latex: r"\sigma\leq 1",
        plain: "σ ≤ 1",
        conditions: AT_REST,
        depends_on: &["eq-89"],
        trials: trials![
            &exact::EQ139,
            radius::eq139_nudge,
            radius::eq139_stays,
            radius::eq139_at_the_edge
        ],
        argument: HELD,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-140",
        section: "4",
        equation: Some(140),
        kind: Kind::Limit,
        title: "rate of α near rest",
        latex: r"\dot\alpha=1-\frac{1}{\sigma}+\cdots",
        plain: "dα/dτ = 1 − 1/σ + ⋯",
        conditions: NEAR_REST_TO_ZERO,
        depends_on: &["eq-114", "eq-115", "eq-139"],
        trials: trials![
            &exact::arrivals::EQ140,
            &exact::series::EQ140,
            approach::eq140_motion,
            approach::eq140_order,
            approach::eq140_straight,
            approach::corrected140,
            approach::eq140_at_one,
            excepted::edge,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-141",
        section: "4",
        equation: Some(141),
        kind: Kind::Limit,
        title: "α near rest",
        latex: r"\alpha=\frac{(\sigma-1) \tau}{\sigma}+\cdots",
        plain: "α = (σ − 1) τ/σ + ⋯",
        conditions: NEAR_REST_CLOCK,
        depends_on: &["eq-140"],
        trials: trials![
            &exact::arrivals::EQ141,
            &exact::series::EQ141,
            approach::eq141_motion,
            approach::eq141_order,
            approach::eq141_straight,
            approach::eq141_at_one,
            approach::eq141_clock,
            excepted::edge,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-142",
        section: "4",
        equation: Some(142),
        kind: Kind::Equation,
        title: "equation for ψ over α near rest",
        latex: r"\frac{\sigma-1}{\sigma} \frac{\mathrm{d} \psi}{\mathrm{d} \alpha} \approx 2 \left(1-\frac{\psi}{2 \alpha}\right)",
        plain: "((σ − 1)/σ) dψ/dα ≈ 2 [1 − ψ/(2α)]",
        conditions: NEAR_REST_TO_ZERO,
        depends_on: &["eq-115", "eq-140"],
        trials: trials![
            &exact::arrivals::EQ142,
            &exact::series::EQ142,
            approach::eq142_motion,
            approach::eq142_order,
            approach::eq142_straight,
            approach::eq142_at_one,
            excepted::edge,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-143",
        section: "4",
        equation: Some(143),
        kind: Kind::Limit,
        title: "ψ over α near rest",
        latex: r"\psi=2 \alpha \left[\frac{\sigma}{2 \sigma-1}+ c \alpha^{(2 \sigma-1)/(1-\sigma)}\right]+\cdots",
        plain: "ψ = 2α [σ/(2σ − 1) + c α^((2σ − 1)/(1 − σ))] + ⋯, c constant",
        conditions: NEAR_REST_TWO_TERMS,
        depends_on: &["eq-142"],
        trials: trials![
            &exact::arrivals::EQ143,
            &exact::series::EQ143,
            approach::eq143_constant,
            approach::eq143_exponent,
            approach::eq143_small_sigma,
            approach::eq143_large_sigma,
            approach::eq143_one_half,
            approach::eq143_straight,
            approach::eq143_regular,
            excepted::one_half,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-144",
        section: "4",
        equation: Some(144),
        kind: Kind::Equation,
        title: "equation for A over α near rest",
        latex: r"\frac{\sigma-1}{\sigma} \frac{\mathrm{d} A}{\mathrm{d} \alpha}\approx\alpha",
        plain: "((σ − 1)/σ) dA/dα ≈ α",
        conditions: NEAR_REST_TO_ZERO,
        depends_on: &["eq-113", "eq-140"],
        trials: trials![
            &exact::arrivals::EQ144,
            &exact::series::EQ144,
            approach::eq144_motion,
            approach::eq144_order,
            approach::eq144_straight,
            approach::eq144_at_one,
            excepted::edge,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-145",
        section: "4",
        equation: Some(145),
        kind: Kind::Limit,
        title: "A over α near rest",
        latex: r"A=\sigma+\frac{\sigma}{\sigma-1} \frac{\alpha^2}{2}+\cdots",
        plain: "A = σ + (σ/(σ − 1)) α²/2 + ⋯",
        conditions: NEAR_REST_TO_ZERO,
        depends_on: &["eq-144"],
        trials: trials![
            &exact::arrivals::EQ145,
            &exact::series::EQ145,
            approach::eq145_motion,
            approach::eq145_order,
            approach::eq145_straight,
            approach::eq145_at_one,
            excepted::edge,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-146",
        section: "4",
        equation: Some(146),
        kind: Kind::Equation,
        title: "condition of the envelope",
        latex: r"0=1-\frac{1}{(\sigma-1)^2} \frac{\alpha^2}{2}+\cdots",
        plain: "0 = 1 − (1/(σ − 1)²) α²/2 + ⋯",
        depends_on: &["eq-145", "s4-psi-free", "s4-envelope-is-boundary"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"\frac{\mathrm{d} A}{\mathrm{d} \sigma}=\frac{1-\sigma}{\sqrt{(1-\sigma)^2+\alpha^2}}+\cdots\quad\text{near rest at the edge of the region of rest, once the angle has relaxed}",
            plain: "dA/dσ = (1 − σ)/√((1 − σ)² + α²) + ⋯ near rest at the edge of the region of rest, once the angle has relaxed",
        }),
        trials: trials![
            &exact::EQ146,
            boundary::real_surfaces,
            boundary::closing_surfaces,
            &exact::saddle::CORRECTED
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-147",
        section: "4",
        equation: Some(147),
        kind: Kind::Equation,
        title: "the envelope",
        latex: r"A=\left(1-\frac{\alpha}{\sqrt{2}}\right)^2+\cdots",
        plain: "A = (1 − α/√2)² + ⋯",
        depends_on: &["eq-145", "eq-146"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"A=1-\alpha+\tfrac76\alpha^2+\cdots\quad\text{where the boundary between rest and escape is lowest}",
            plain: "A = 1 − α + (7/6) α² + ⋯ where the boundary between rest and escape is lowest",
        }),
        trials: trials![
            &exact::EQ147,
            boundary::printed_slow,
            &exact::least::PRINTED,
            boundary::least_root,
            &exact::least::CORRECTED,
            &exact::barriers::LEAST
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-rest-radius",
        section: "4",
        title: "where rest is possible, in words",
        latex: r"A particle can stay at rest at $\rho=\sigma$ only if $\sigma\le1$: farther out the centrifugal force exceeds the greatest static friction.",
        plain: "A particle can stay at rest at ρ = σ only if σ ≤ 1: farther out the centrifugal force exceeds the greatest static friction.",
        depends_on: &["eq-139"],
        trials: trials![
            &exact::EQ139,
            radius::eq139_stays,
            radius::eq139_at_the_edge,
            radius::resting_places
        ],
        argument: HELD,
        ..Claim::BLANK
    },
    Claim {
        id: "s4-near-rest",
        section: "4",
        title: "how the particle comes to rest",
        latex: r"As the particle comes to rest, $\alpha$ and $\psi$ tend to zero; (140) to (145) say how.",
        plain: "As the particle comes to rest, α and ψ tend to zero; (140) to (145) say how.",
        depends_on: &["eq-140", "eq-141", "eq-142", "eq-143", "eq-144", "eq-145"],
        conditions: &[INNER[0], TO_ZERO],
        trials: trials![
            &exact::chains::NEAR_REST,
            approach::near_rest_angle,
            approach::near_rest_census,
            approach::near_rest_straight,
            approach::corrected_near_rest,
            excepted::straight_in
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-dichotomy",
        section: "4",
        title: "rest or escape",
        latex: r"Every start leads either to rest or to an unbounded motion.",
        plain: "Every start leads either to rest or to an unbounded motion.",
        depends_on: &["eq-127", "eq-139", "s4-A-never-decreases"],
        conditions: &[Condition {
            text: r"the particle does not creep towards $\rho=1$ for ever, as it does from the boundary itself unless it comes straight in",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::chains::DICHOTOMY,
            dichotomy::fates,
            dichotomy::followed,
            dichotomy::on_the_boundary,
            dichotomy::beside_the_boundary
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-psi-free",
        section: "4",
        title: "the surface of a resting place",
        latex: r"The equation of the surface of starts that come to rest at $\rho=\sigma$ is (145), with $\psi$ free.",
        plain: "The equation of the surface of starts that come to rest at ρ = σ is (145), with ψ free.",
        conditions: &[Condition {
            text: r"$0<\sigma<1$, and $\alpha\ll1-\sigma$ as in (145)",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-143", "eq-145"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"The equation of the surface of starts that come to rest at $\rho=\sigma$ is $A=\sigma-\sigma\alpha^2\left[\frac{\cos^4\chi}{2(1-\sigma)}+\sin^2\chi\cos^2\chi+\frac{\sin^4\chi}{2(1+\sigma)}\right]+\cdots,\quad\chi=\tfrac\psi2$; for $\lvert\psi\rvert\ll1$ it is (145).",
            plain: "The equation of the surface of starts that come to rest at ρ = σ is A = σ − σ α² [cos⁴χ/(2(1 − σ)) + sin²χ cos²χ + sin⁴χ/(2(1 + σ))] + ⋯, χ = ψ/2; for |ψ| ≪ 1 it is (145).",
        }),
        trials: trials![
            surfaces::psi_free,
            surfaces::with_psi,
            surfaces::bends,
            &exact::surfaces::CORRECTED,
            &exact::barriers::SURFACE
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s4-envelope-is-boundary",
        section: "4",
        title: "the boundary between rest and escape",
        latex: "The envelope (147) of the surfaces (143), (145) is the boundary: the particle comes to rest if $A$ starts below it, and escapes to infinity otherwise.",
        plain: "The envelope (147) of the surfaces (143), (145) is the boundary: the particle comes to rest if A starts below it, and escapes to infinity otherwise.",
        conditions: INNER,
        depends_on: &["eq-143", "eq-145"],
        correction: Some(Correction {
            change: Change::Statement,
            latex: r"For small $\alpha$ the particle comes to rest if $A$ starts below $1-\alpha\cos^2\chi+\alpha^2\left[\tfrac76\cos^4\chi+2\sin\chi\cos^3\chi-\sin^2\chi\cos^2\chi+\tfrac23\sin^3\chi\cos\chi-\tfrac14\sin^4\chi\right]+O(\alpha^3),\quad\chi=\tfrac\psi2$, and escapes to infinity if it starts above; in between, within $O(\alpha^3)$, there is an $A$ from which it creeps towards $\rho=1$ for ever or, coming straight in, stops there.",
            plain: "For small α the particle comes to rest if A starts below 1 − α cos²χ + α² [(7/6) cos⁴χ + 2 sin χ cos³χ − sin²χ cos²χ + ⅔ sin³χ cos χ − ¼ sin⁴χ] + O(α³), χ = ψ/2, and escapes to infinity if it starts above; in between, within O(α³), there is an A from which it creeps towards ρ = 1 for ever or, coming straight in, stops there.",
        }),
        trials: trials![
            boundary::printed_census,
            boundary::printed_root,
            &exact::boundary::PRINTED,
            boundary::corrected_census,
            boundary::corrected_root.coarse(&[(
                "boundary_curvature",
                "it is the coefficient of a small term of what is compared"
            )]),
            boundary::corrected_close,
            &exact::boundary::CORRECTED,
            &exact::barriers::BOUNDARY,
            certified::printed,
            certified::corrected
        ],
        ..Claim::BLANK
    },
];
