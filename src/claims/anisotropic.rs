//! Anisotropic friction: the claims.

mod across;
pub mod census;
pub mod certified;
mod corners;
mod curves;
mod decays;
pub mod drawn;
pub mod drift;
pub mod exact;
mod frictions;
mod mirror;
pub mod motions;
pub mod panels;
mod regions;
pub mod rows;
pub mod simulated;
mod slips;

use super::attempt::trials;
use super::excuses;
use super::sinusoidal::excepted::no_friction;
use super::sinusoidal::{FRICTION_ACROSS, SOME_FRICTION};
use super::{Claim, Condition, Correction, Sort, Topic};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "anisotropic",
    title: "Anisotropic friction",
    claims: CLAIMS,
};

/// (55), as far as it is a border.
const CURVE_C: Correction = Correction {
    change: Change::Statement,
    latex: r"\text{C for }q\leq q_Y\text{:}\quad\lambda_0=\frac{1}{q}",
    plain: "C for q ≤ q_Y: λ₀ = 1/q",
};

/// Region II, with E.
const SECOND_REGION: Correction = Correction {
    change: Change::Statement,
    latex: r"Above curve A, below curve B for $q\leq q_Y$ and below curve E for $q\geq q_Y$, each period has an interval with $\mathfrak{w}>0$, at once one with $\mathfrak{w}<0$, then a rest. Between the curves E and C there is no backward motion: each period has an interval with $\mathfrak{w}>0$ and a rest, as in IV. Curve E is $\sqrt{1-\lambda_0^2}-\sqrt{1-(q\lambda_0)^2}=\lambda_0[2\pi-\sin^{-1}(q\lambda_0)-\sin^{-1}(\lambda_0)]$.",
    plain: "Above curve A, below curve B for q ≤ q_Y and below curve E for q ≥ q_Y, each period has an interval with w > 0, at once one with w < 0, then a rest. Between the curves E and C there is no backward motion: each period has an interval with w > 0 and a rest, as in IV. Curve E is √(1 − λ₀²) − √(1 − (q λ₀)²) = λ₀ [2π − asin(q λ₀) − asin(λ₀)].",
};

/// The diagram, with E.
const DIAGRAM: Correction = Correction {
    change: Change::Statement,
    latex: r"The regions I to V with the curves A, B up to $Y$, E from $Y$ on, C up to $Y$, and D. Beyond $Y$, curve E separates II from IV, and curve C is not a border there.",
    plain: "The regions I to V with the curves A, B up to Y, E from Y on, C up to Y, and D. Beyond Y, curve E separates II from IV, and curve C is not a border there.",
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-47",
        section: "2.4",
        equation: Some(47),
        kind: Kind::Definition,
        title: "friction of forward motion",
        latex: r"\lambda_+=\frac{\mu_+ g}{A_0}",
        plain: "λ₊ = μ₊ g / A₀",
        conditions: &[Condition {
            text: r"$\mu_+$ holds for $v_x>0$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-21"],
        trials: trials![&exact::DEFINED, frictions::eq47],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-48",
        section: "2.4",
        equation: Some(48),
        kind: Kind::Definition,
        title: "friction of backward motion",
        latex: r"\lambda_-=\frac{\mu_- g}{A_0}",
        plain: "λ₋ = μ₋ g / A₀",
        conditions: &[Condition {
            text: r"$\mu_-$ holds for $v_x<0$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-21"],
        trials: trials![&exact::DEFINED, frictions::eq48],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-49",
        section: "2.4",
        equation: Some(49),
        kind: Kind::Definition,
        title: "the forward friction as parameter",
        latex: r"\lambda_+=\lambda_0",
        plain: "λ₊ = λ₀",
        depends_on: &["eq-47"],
        trials: trials![&exact::DEFINED, frictions::eq49],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-50",
        section: "2.4",
        equation: Some(50),
        kind: Kind::Definition,
        title: "the ratio of the frictions",
        latex: r"\lambda_-=q \lambda_0",
        plain: "λ₋ = q λ₀",
        depends_on: &["eq-48", "eq-49"],
        trials: trials![&exact::DEFINED, frictions::eq50],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-51",
        section: "2.4",
        equation: Some(51),
        kind: Kind::Equation,
        title: "motion while sliding forward",
        latex: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi-\lambda_0,\quad\mathfrak{w}>0",
        plain: "dw/dφ = sin φ − λ₀, w > 0",
        conditions: &[Condition {
            text: "at large times",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-26", "eq-49"],
        trials: trials![&exact::EQ51, frictions::eq51_quadrature, slips::distances],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-52",
        section: "2.4",
        equation: Some(52),
        kind: Kind::Equation,
        title: "motion while sliding backward",
        latex: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi+q \lambda_0,\quad\mathfrak{w}<0",
        plain: "dw/dφ = sin φ + q λ₀, w < 0",
        conditions: &[Condition {
            text: "at large times",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-26", "eq-50"],
        trials: trials![&exact::EQ52, frictions::eq52_quadrature],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-53",
        section: "2.4",
        equation: Some(53),
        kind: Kind::Equation,
        title: "curve A",
        latex: r"\text{A:}\quad K=\frac{\pi q}{q+1}, \quad \frac{\sqrt{1-\lambda_0^2}}{\lambda_0}=\frac{K}{\sin^2 K}-\cot K",
        plain: "A: K = π q / (q + 1), √(1 − λ₀²) / λ₀ = K / sin² K − cot K",
        conditions: &[Condition {
            text: r"$q\geq1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-51", "eq-52"],
        trials: trials![
            &exact::EQ53,
            curves::eq53_root,
            curves::eq53_census,
            curves::eq53_limit,
            curves::a_far_limit,
            certified::a_once
        ],
        argument: r"Forward for $2K$ and backward for $2\pi-2K$, friction gives nothing over a period if $2K=(2\pi-2K)q$. On A such a motion starts just where the drive begins to beat friction; below A it has no rest, above A there is one, as is shown of the regions.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-54",
        section: "2.4",
        equation: Some(54),
        kind: Kind::Equation,
        title: "curve B",
        latex: r"\text{B:}\quad \sqrt{1-\lambda_0^2} +\sqrt{1-(q \lambda_0)^2}= \lambda_0 [\pi + \sin^{-1}(q \lambda_0) - \sin^{-1}(\lambda_0)]",
        plain: "B: √(1 − λ₀²) + √(1 − (q λ₀)²) = λ₀ [π + asin(q λ₀) − asin(λ₀)]",
        conditions: &[
            Condition {
                text: r"$q\geq1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"for $q>q_Y$, the $q$ of $Y$, (54) has no solution: B ends there",
                sort: Sort::Remark,
            },
        ],
        depends_on: &["eq-51", "eq-52"],
        trials: trials![
            &exact::EQ54,
            curves::eq54_root,
            curves::eq54_census,
            curves::eq54_ends,
            certified::b_once
        ],
        argument: r"On B the slip from $\sin^{-1}\lambda_0$ ends just where the drive can begin to pull backwards, at $\pi+\sin^{-1}(q\lambda_0)$. Below B it ends later and above B earlier, as the arc falls with $\lambda_0$: then a rest comes first, as is shown of the regions.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-55",
        section: "2.4",
        equation: Some(55),
        kind: Kind::Equation,
        title: "curve C",
        latex: r"\text{C:}\quad \lambda_0=\frac{1}{q}",
        plain: "C: λ₀ = 1/q",
        conditions: &[Condition {
            text: r"$q\geq1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-52", "s24-region-2"],
        trials: trials![
            &exact::EQ55,
            curves::eq55_root,
            curves::eq55_census,
            &motions::CURVE_C,
            curves::eq55_corrected_root,
            curves::eq55_corrected_census
        ],
        correction: Some(CURVE_C),
        ..Claim::BLANK
    },
    Claim {
        id: "eq-56",
        section: "2.4",
        equation: Some(56),
        kind: Kind::Equation,
        title: "curve D",
        latex: r"\text{D:}\quad \lambda_0=1",
        plain: "D: λ₀ = 1",
        conditions: &[Condition {
            text: r"$q\geq1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-51"],
        trials: trials![&exact::EQ56, curves::eq56_root, curves::eq56_census],
        argument: r"The square is not negative, and it is 0 at $\phi=\pi/2$: for $\lambda_0\geq1$ nothing starts a slip forwards, nor, as $q\lambda_0\geq1$ too, one backwards; for $\lambda_0<1$ the drive starts one at $\pi/2$.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-57",
        section: "2.4",
        equation: Some(57),
        kind: Kind::Number,
        title: "where A and B meet",
        latex: r"X=(q=1,\lambda_0=\lambda_\mathrm{c})",
        plain: "X = (q = 1, λ₀ = λ_c)",
        depends_on: &["eq-37", "eq-53", "eq-54"],
        trials: trials![&exact::X, corners::x_root, certified::points::x_unique],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-58",
        section: "2.4",
        equation: Some(58),
        kind: Kind::Number,
        title: "where B and C touch",
        latex: r"Y=(q=4.603,\lambda_0=0.217)",
        plain: "Y = (q = 4.603, λ₀ = 0.217)",
        depends_on: &["eq-54", "eq-55"],
        trials: trials![
            corners::y_decimals,
            corners::y_limit,
            certified::points::y_rounding
        ],
        argument: r"Y is where (54) meets (55) and has its direction, as is shown of the point where B and C meet; the enclosure gives its digits.",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-vy-vanishes",
        section: "2.4",
        title: "the velocity across the drive vanishes here too",
        latex: r"With a friction that depends on the direction of the velocity, too, only the component along the acceleration can be nonzero at large times.",
        plain: "With a friction that depends on the direction of the velocity, too, only the component along the acceleration can be nonzero at large times.",
        conditions: &[
            Condition {
                text: "friction acts against the velocity, as in (1), with a coefficient that in all directions is above some positive number",
                sort: Sort::Stated,
            },
            FRICTION_ACROSS,
        ],
        depends_on: &["eq-1", "eq-21"],
        trials: trials![
            &decays::VY_VANISHES,
            across::vanishes,
            across::never_grows.elsewhere(excuses::BY_EQ1),
            across::outside,
            no_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s24-q-at-least-one",
        section: "2.4",
        title: "the larger friction may be the backward one",
        latex: r"Taking $q\geq1$ is no loss of generality.",
        plain: "Taking q ≥ 1 is no loss of generality.",
        depends_on: &["eq-51", "eq-52"],
        trials: trials![&exact::MIRROR, mirror::integration, mirror::census],
        argument: r"A motion with $q<1$ has an image, half a period later, reversed and with the frictions exchanged, whose $q$ is above 1: what is found for $q\geq1$ holds for it with the senses exchanged.",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-1",
        section: "2.4",
        title: "region I: no rest",
        latex: r"Below A, each period has an interval with $\mathfrak{w}>0$ and one with $\mathfrak{w}<0$, and no rest.",
        plain: "Below A, each period has an interval with w > 0 and one with w < 0, and no rest.",
        conditions: &[
            Condition {
                text: r"$q\geq1$",
                sort: Sort::Stated,
            },
            SOME_FRICTION,
        ],
        depends_on: &["eq-51", "eq-52", "eq-53"],
        trials: trials![
            &motions::FIRST,
            regions::first_census,
            regions::first_ends,
            regions::first_outside,
            no_friction,
            slips::without_rest
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-2",
        section: "2.4",
        title: "region II: one rest, after the backward slip",
        latex: r"Above A and below B and C, each period has an interval with $\mathfrak{w}>0$, at once one with $\mathfrak{w}<0$, then a rest.",
        plain: "Above A and below B and C, each period has an interval with w > 0, at once one with w < 0, then a rest.",
        conditions: &[Condition {
            text: r"$q\geq1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-51", "eq-52", "eq-53", "eq-54"],
        trials: trials![
            regions::second_census,
            regions::second_ends,
            &exact::E,
            curves::e_root,
            curves::e_census,
            curves::e_limit,
            certified::e_once,
            &motions::SECOND,
            regions::second_corrected_census,
            regions::second_corrected_ends,
            regions::between_e_and_c,
            certified::points::no_way_back,
            certified::e_below_c
        ],
        correction: Some(SECOND_REGION),
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-3",
        section: "2.4",
        title: "region III: two rests",
        latex: r"Between B and C, each period has an interval with $\mathfrak{w}>0$ and one with $\mathfrak{w}<0$, with two rests between them.",
        plain: "Between B and C, each period has an interval with w > 0 and one with w < 0, with two rests between them.",
        conditions: &[Condition {
            text: r"$q\geq1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-51", "eq-52", "eq-54", "eq-55"],
        trials: trials![&motions::THIRD, regions::third_census, regions::third_ends],
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-4",
        section: "2.4",
        title: "region IV: forward slip and rest",
        latex: r"Between C and D, each period has an interval with $\mathfrak{w}>0$ and a rest.",
        plain: "Between C and D, each period has an interval with w > 0 and a rest.",
        conditions: &[
            Condition {
                text: r"$q\geq1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"beyond Y, for $q>q_Y$, the same motion is found down to E",
                sort: Sort::Remark,
            },
        ],
        depends_on: &["eq-51", "eq-52", "eq-55", "eq-56"],
        trials: trials![
            &motions::FOURTH,
            regions::fourth_census,
            regions::fourth_ends,
            regions::down_to_e,
            regions::fourth_ends_beyond
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s24-region-5",
        section: "2.4",
        title: "region V: rest",
        latex: "Above D the particle is at rest.",
        plain: "Above D the particle is at rest.",
        conditions: &[Condition {
            text: r"$q\geq1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-51", "eq-52", "eq-56"],
        trials: trials![&motions::FIFTH, regions::fifth_census, regions::fifth_ends],
        ..Claim::BLANK
    },
    Claim {
        id: "s24-X",
        section: "2.4",
        title: "A and B meet",
        latex: r"A and B meet at $X=(1,\lambda_\mathrm{c})$.",
        plain: "A and B meet at X = (1, λ_c).",
        depends_on: &["eq-57"],
        trials: trials![
            &exact::X,
            corners::x_root,
            corners::x_both,
            certified::points::x_unique
        ],
        argument: r"The identities say that the point lies on both curves, the enclosure that no other common point is near.",
        ..Claim::BLANK
    },
    Claim {
        id: "s24-Y",
        section: "2.4",
        title: "B and C touch",
        latex: "B and C meet at $Y=(4.603,0.217)$ and are tangent there.",
        plain: "B and C meet at Y = (4.603, 0.217) and are tangent there.",
        depends_on: &["eq-58"],
        trials: trials![
            &exact::Y,
            corners::y_digits,
            corners::y_by_slip,
            corners::y_contact,
            corners::y_curvature,
            certified::points::y_digits
        ],
        argument: r"The enclosure says where both curves pass, the identity that they have one direction there.",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-5",
        section: "2.4",
        kind: Kind::Figure,
        title: "map of the regions",
        latex: r"The regions I to V with the curves A to D and the points $X$, $Y$; axes $q$ from $1$ to $7$, $\lambda_0$ from $0$ to $1.4$.",
        plain: "The regions I to V with the curves A to D and the points X, Y; axes q from 1 to 7, λ₀ from 0 to 1.4.",
        depends_on: &[
            "eq-53",
            "eq-54",
            "eq-55",
            "eq-56",
            "eq-57",
            "eq-58",
            "s24-region-1",
            "s24-region-2",
            "s24-region-3",
            "s24-region-4",
            "s24-region-5",
        ],
        trials: trials![
            regions::diagram,
            regions::corrected_diagram,
            regions::far,
            regions::corrected_curves.elsewhere(excuses::BETWEEN),
            certified::order.elsewhere(excuses::BETWEEN),
            regions::diagram_step
        ],
        correction: Some(DIAGRAM),
        argument: r"Each region is described in its own box. Which lies between which curves follows from their order, as the curves are continuous and end where they are said to.",
        ..Claim::BLANK
    },
    Claim {
        id: "fig-6",
        section: "2.4",
        kind: Kind::Figure,
        title: "large-time motion in each region",
        latex: r"$\mathfrak{w}(\phi)$ over two periods, one panel for each of the regions I to V, for $\phi$ from $0$ to $4\pi$; the axis of $\mathfrak{w}$ bears the mark $1$.",
        plain: "w(φ) over two periods, one panel for each of the regions I to V, for φ from 0 to 4π; the axis of w bears the mark 1.",
        depends_on: &[
            "s24-region-1",
            "s24-region-2",
            "s24-region-3",
            "s24-region-4",
            "s24-region-5",
        ],
        trials: trials![panels::quadrature, panels::census],
        ..Claim::BLANK
    },
];
