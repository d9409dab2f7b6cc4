//! Constant acceleration: the claims.

mod definitions;
pub mod drawn;
pub mod exact;
pub mod excepted;
mod extremes;
mod from_rest;
mod hodograph;
mod incline;
mod launches;
mod limits;
mod only_constant;
pub mod sense;
mod time;

use super::attempt::trials;
use super::excuses;
use super::{Claim, Condition, Correction, Sort, Topic};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "constant",
    title: "Constant acceleration",
    claims: CLAIMS,
};

/// (11) where it has no value too.
const REGULAR_SPEED: Correction = Correction {
    change: Change::Statement,
    latex: r"v=v_0\left[\cos^2\tfrac{\theta_0}{2}\,r^{\lambda-1}+\sin^2\tfrac{\theta_0}{2}\,r^{\lambda+1}\right],\quad r=\frac{\tan\frac{\theta}{2}}{\tan\frac{\theta_0}{2}}",
    plain: "v = v₀ [cos²(θ₀/2) r^(λ−1) + sin²(θ₀/2) r^(λ+1)], r = tan(θ/2)/tan(θ₀/2)",
};

/// (13) where it has no value too.
const REGULAR_TIME: Correction = Correction {
    change: Change::Statement,
    latex: r"t=\frac{v_0}{A}\left[\cos^2\tfrac{\theta_0}{2}\,\frac{1-r^{\lambda-1}}{\lambda-1}+\sin^2\tfrac{\theta_0}{2}\,\frac{1-r^{\lambda+1}}{\lambda+1}\right]",
    plain: "t = (v₀/A) [cos²(θ₀/2) (1 − r^(λ−1))/(λ − 1) + sin²(θ₀/2) (1 − r^(λ+1))/(λ + 1)]",
};

/// Where the velocity has no direction in the end.
const NOT_THE_ONE_THAT_STOPS: Condition = Condition {
    text: r"not $\lambda=1$ with $\theta_0=\pi$: that particle stops, and static friction holds it, as it holds one that starts at rest",
    sort: Sort::Degenerate,
};

/// Where tan(θ/2) and tan(θ₀/2) stand under a power.
pub(super) const MIRRORED: &str = r"This is shown for $0<\theta_0<\pi$; for $\theta_0<0$ the motion is the mirror image, and neither side of the formula changes with the signs of $\theta$ and $\theta_0$.";

/// For λ = 1 and 0 < θ₀ < π.
const FALLS: &str = r"$\dot\theta=-A\sin\theta/v$ is negative for $0<\theta<\pi$, and by (17) $v$ stays between half of $v_0(1+\cos\theta_0)$ and $v_0$: $\theta$ falls for ever and tends to 0, where the steps take the value. For $\theta_0<0$ the motion is the mirror image; at $\theta_0=0$ the velocity stays as it is, and at $\theta_0=\pi$ the particle stops and stays, with the same values.";

/// For λ > 1 and 0 < θ₀ < π.
const STOPS: &str = r"$\dot v=-A(\lambda-\cos\theta)\leq-A(\lambda-1)$: $v$ is 0 after a finite time. $\dot\theta=-A\sin\theta/v$ is negative until then, and by (11) $v$ is 0 for no $\theta$ between 0 and $\theta_0$: $\theta$ tends to 0, where (13) is $T$. There the particle stays, as friction exceeds the pull. For $\theta_0<0$ the motion is the mirror image; at $\theta_0=0$ and $\pi$ (2) gives $T$ at once.";

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-3",
        section: "2.1",
        equation: Some(3),
        kind: Kind::Definition,
        title: "the constant acceleration",
        latex: r"\bm{A}=-A \hat{\bm{x}}",
        plain: "𝐀 = −A x̂",
        conditions: &[Condition {
            text: "$A>0$, constant",
            sort: Sort::Stated,
        }],
        trials: trials![&exact::DEFINED, definitions::eq3],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-4",
        section: "2.1",
        equation: Some(4),
        kind: Kind::Definition,
        title: "the velocity by speed and angle",
        latex: r"\bm{v}=v (\hat{\bm{x}} \cos\theta+\hat{\bm{y}} \sin\theta)",
        plain: "𝐯 = v (x̂ cos θ + ŷ sin θ)",
        trials: trials![&exact::DEFINED, definitions::eq4],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-5",
        section: "2.1",
        equation: Some(5),
        kind: Kind::Definition,
        title: "friction over acceleration",
        latex: r"\lambda=\frac{\mu g}{A}",
        plain: "λ = μ g / A",
        depends_on: &["eq-3"],
        trials: trials![&exact::DEFINED, definitions::eq5],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-6",
        section: "2.1",
        equation: Some(6),
        kind: Kind::Equation,
        title: "velocity along the inertial force",
        latex: r"\frac{\mathrm{d} (v \cos\theta)}{\mathrm{d} t}=A (1-\lambda \cos\theta)",
        plain: "d(v cos θ)/dt = A (1 − λ cos θ)",
        depends_on: &["eq-1", "eq-3", "eq-4", "eq-5"],
        trials: trials![&exact::EQ6, hodograph::eq6_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-7",
        section: "2.1",
        equation: Some(7),
        kind: Kind::Equation,
        title: "motion across the acceleration",
        latex: r"\frac{\mathrm{d} (v \sin\theta)}{\mathrm{d} t}=-A \lambda \sin\theta",
        plain: "d(v sin θ)/dt = −A λ sin θ",
        depends_on: &["eq-1", "eq-3", "eq-4", "eq-5"],
        trials: trials![&exact::EQ7, hodograph::eq7_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-8",
        section: "2.1",
        equation: Some(8),
        kind: Kind::Equation,
        title: "slope of the path in velocity space",
        latex: r"\frac{\mathrm{d} (v \sin\theta)}{\mathrm{d} (v \cos\theta)}= -\frac{\lambda \sin\theta}{1-\lambda \cos\theta}",
        plain: "d(v sin θ)/d(v cos θ) = −λ sin θ / (1 − λ cos θ)",
        depends_on: &["eq-6", "eq-7"],
        conditions: &[Condition {
            text: r"not $\lambda=1$ with $\theta=0$: that velocity is constant, and the slope is $0/0$",
            sort: Sort::Degenerate,
        }],
        trials: trials![&exact::EQ8, hodograph::eq8_motion.coarse(&[("eq8_hodograph_slope", "the slope is compared by its angle, which moves by at most half as much")]), hodograph::eq8_outside, excepted::eq8],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-9",
        section: "2.1",
        equation: Some(9),
        kind: Kind::Equation,
        title: "speed against angle, as differentials",
        latex: r"\frac{\mathrm{d} v}{v}=\frac{\lambda-\cos\theta}{\sin\theta} \mathrm{d} \theta",
        plain: "dv/v = ((λ − cos θ) / sin θ) dθ",
        depends_on: &["eq-8"],
        conditions: &[Condition {
            text: r"$\theta\neq0,\pi$: along the line of the acceleration the speed changes while $\mathrm d\theta=0$",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::EQ9,
            hodograph::eq9_quadrature,
            hodograph::eq9_outside,
            excepted::eq9
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-10",
        section: "2.1",
        equation: Some(10),
        kind: Kind::Equation,
        title: "a constant of the motion",
        latex: r"v (\sin\theta) \left(\tan\frac{\theta}{2}\right)^{-\lambda}=\text{constant}",
        plain: "v (sin θ) (tan(θ/2))^(−λ) = constant",
        depends_on: &["eq-9"],
        conditions: &[Condition {
            text: r"$0<\theta<\pi$: a non-integer power of a negative tangent has no real value; for $\theta<0$ the mirror image has to be taken",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::EQ10,
            hodograph::eq10_motion,
            hodograph::eq10_outside,
            excepted::eq10
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-11",
        section: "2.1",
        equation: Some(11),
        kind: Kind::Equation,
        title: "speed against angle",
        latex: r"v=v_0 \frac{\sin\theta_0}{\sin\theta} \left(\frac{{\tan\frac{\theta}{2}}} {{\tan\frac{\theta_0}{2}}}\right)^\lambda",
        plain: "v = v₀ (sin θ₀ / sin θ) (tan(θ/2) / tan(θ₀/2))^λ",
        depends_on: &["eq-10"],
        conditions: &[Condition {
            text: r"$\theta_0\neq0,\pi$: along the line of the acceleration it is $0/0$",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::EQ11,
            hodograph::eq11_motion,
            hodograph::eq11_quadrature,
            hodograph::eq11_outside,
            time::regular_speed,
            time::regular_straight,
            time::regular_speed_by_log,
            excepted::eq11
        ],
        correction: Some(REGULAR_SPEED),
        argument: MIRRORED,
    },
    Claim {
        id: "eq-12",
        section: "2.1",
        equation: Some(12),
        kind: Kind::Equation,
        title: "time against angle, as differentials",
        latex: r"A \mathrm{d} t=-\frac{v_0 \sin\theta_0}{{\left(\tan\frac{\theta_0}{2}\right)^\lambda}} \frac{\mathrm{d} {\left[\left(\tan\frac{\theta}{2}\right)^\lambda\right]}}{\lambda \sin\theta}",
        plain: "A dt = −(v₀ sin θ₀ / (tan(θ₀/2))^λ) d[(tan(θ/2))^λ] / (λ sin θ)",
        depends_on: &["eq-7", "eq-11"],
        conditions: &[Condition {
            text: r"$0<\theta<\pi$ and $\lambda\neq0$: at $\lambda=0$ it is $0/0$; for $\theta<0$ the mirror image has to be taken",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::EQ12,
            time::eq12_quadrature,
            time::eq12_outside,
            excepted::eq12
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-13",
        section: "2.1",
        equation: Some(13),
        kind: Kind::Equation,
        title: "time against angle",
        latex: r"t=\frac{v_0 (\lambda+\cos\theta_0)}{A (1-\lambda^2)} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right]",
        plain: "t = (v₀ (λ + cos θ₀) / (A (1 − λ²))) [((λ + cos θ) sin θ₀ / ((λ + cos θ₀) sin θ)) (tan(θ/2) / tan(θ₀/2))^λ − 1]",
        depends_on: &["eq-12"],
        conditions: &[
            Condition {
                text: r"$\lambda\neq1$ and $\cos\theta_0\neq-\lambda$, where it is $0/0$ or $0\cdot\infty$",
                sort: Sort::Degenerate,
            },
            Condition {
                text: r"$\theta_0\neq0,\pi$",
                sort: Sort::Degenerate,
            },
        ],
        trials: trials![
            &exact::EQ13,
            time::eq13_motion,
            time::eq13_quadrature,
            time::eq13_root,
            time::eq13_singular,
            time::eq13_straight,
            time::regular_time,
            time::regular_late,
            time::regular_angle,
            excepted::eq13_friction,
            excepted::eq13_straight
        ],
        correction: Some(REGULAR_TIME),
        argument: MIRRORED,
    },
    Claim {
        id: "eq-14",
        section: "2.1",
        equation: Some(14),
        kind: Kind::Equation,
        title: "speed against time and angle",
        latex: r"v=\frac{(1-\lambda^2) A t+v_0 (\lambda+\cos\theta_0)}{(\lambda+\cos\theta)}",
        plain: "v = ((1 − λ²) A t + v₀ (λ + cos θ₀)) / (λ + cos θ)",
        depends_on: &["eq-11", "eq-13"],
        conditions: &[Condition {
            text: r"$\cos\theta\neq-\lambda$, where it is $0/0$",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::EQ14,
            time::eq14_motion,
            time::eq14_outside,
            excepted::eq14
        ],
        argument: MIRRORED,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-15",
        section: "2.1",
        equation: Some(15),
        kind: Kind::Equation,
        title: "no friction: velocity along the inertial force",
        latex: "v_x=v_{0 x}+A t",
        plain: "v_x = v₀ₓ + A t",
        conditions: &[Condition {
            text: r"$\lambda=0$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-6"],
        trials: trials![&exact::EQ15, limits::eq15_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-16",
        section: "2.1",
        equation: Some(16),
        kind: Kind::Equation,
        title: "no friction: velocity across the acceleration",
        latex: "v_y=v_{0 y}",
        plain: "v_y = v₀ᵧ",
        conditions: &[Condition {
            text: r"$\lambda=0$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-7"],
        trials: trials![&exact::EQ16, limits::eq16_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-17",
        section: "2.1",
        equation: Some(17),
        kind: Kind::Equation,
        title: "speed against angle at the critical friction",
        latex: r"v (1+\cos\theta)=v_0 (1+\cos\theta_0)",
        plain: "v (1 + cos θ) = v₀ (1 + cos θ₀)",
        conditions: &[Condition {
            text: r"$\lambda=1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-11"],
        trials: trials![&exact::EQ17, limits::eq17_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-18",
        section: "2.1",
        equation: Some(18),
        kind: Kind::Limit,
        title: "final velocity along the inertial force",
        latex: r"v_x(\infty)=\frac{v_0 (1+\cos\theta_0)}{2}",
        plain: "v_x(∞) = v₀ (1 + cos θ₀) / 2",
        conditions: &[
            Condition {
                text: r"$\lambda=1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$t\to\infty$",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-17", "s21-small-friction-aligns"],
        trials: trials![&exact::EQ18, limits::eq18_limit, limits::eq18_quadrature],
        argument: FALLS,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-19",
        section: "2.1",
        equation: Some(19),
        kind: Kind::Limit,
        title: "final velocity across the acceleration",
        latex: r"v_y(\infty)=0",
        plain: "v_y(∞) = 0",
        conditions: &[
            Condition {
                text: r"$\lambda=1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$t\to\infty$",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-17", "s21-small-friction-aligns"],
        trials: trials![&exact::EQ19, limits::eq19_limit],
        argument: FALLS,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-20",
        section: "2.1",
        equation: Some(20),
        kind: Kind::Equation,
        title: "time at which the particle stops",
        latex: r"T=\frac{v_0 (\lambda+\cos\theta_0)}{A (\lambda^2-1)}",
        plain: "T = v₀ (λ + cos θ₀) / (A (λ² − 1))",
        conditions: &[Condition {
            text: r"$\lambda>1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-14"],
        trials: trials![&exact::EQ20, limits::eq20_motion, limits::eq20_quadrature],
        argument: STOPS,
        ..Claim::BLANK
    },
    Claim {
        id: "s21-frictionless-parabola",
        section: "2.1",
        title: "no friction: a parabola",
        latex: r"For $\lambda=0$, $v_y$ stays constant and $v_x$ grows linearly with $t$; the path is in general a parabola.",
        plain: "For λ = 0, v_y stays constant and v_x grows linearly with t; the path is in general a parabola.",
        depends_on: &["eq-15", "eq-16"],
        trials: trials![&exact::EQ15.elsewhere(excuses::PARTS), &exact::EQ16.elsewhere(excuses::PARTS), limits::parabola_motion, limits::parabola_quadrature.elsewhere(excuses::PARTS)],
        argument: r"A constant $v_y\neq0$ and a $v_x$ that grows linearly with the time integrate to a parabola; with $v_y=0$ it is a straight line.",
        ..Claim::BLANK
    },
    Claim {
        id: "s21-friction-cannot-hold",
        section: "2.1",
        title: "small friction cannot hold",
        latex: r"For $\lambda\leq1$ friction is not large enough to keep the particle at rest.",
        plain: "For λ ≤ 1 friction is not large enough to keep the particle at rest.",
        depends_on: &["eq-1", "eq-3", "eq-5", "eq-6"],
        conditions: &[Condition {
            text: r"not $\lambda=1$: static friction, as large as the pull, holds a particle at rest then",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &exact::CANNOT_HOLD,
            from_rest::census,
            from_rest::velocity,
            from_rest::outside,
            from_rest::critical
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s21-small-friction-aligns",
        section: "2.1",
        title: "small friction: the velocity aligns",
        latex: r"For $\lambda\leq1$, $\theta\to0$ at large times, and the particle slides along the line of the acceleration.",
        plain: "For λ ≤ 1, θ → 0 at large times, and the particle slides along the line of the acceleration.",
        depends_on: &["eq-13"],
        conditions: &[NOT_THE_ONE_THAT_STOPS],
        trials: trials![
            &exact::ALIGNS,
            extremes::small_friction_limit,
            extremes::small_friction_census,
            extremes::small_friction_outside,
            excepted::small_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s21-critical-terminal-velocity",
        section: "2.1",
        title: "critical friction: a final velocity",
        latex: r"For $\lambda=1$ the velocity tends to a constant at large times, the one of (18) and (19).",
        plain: "For λ = 1 the velocity tends to a constant at large times, the one of (18) and (19).",
        depends_on: &["eq-18", "eq-19"],
        trials: trials![
            &exact::EQ18,
            &exact::EQ19,
            limits::eq18_limit,
            limits::eq18_quadrature,
            limits::eq19_limit
        ],
        argument: FALLS,
        ..Claim::BLANK
    },
    Claim {
        id: "s21-large-friction-stops",
        section: "2.1",
        title: "large friction: the particle stops",
        latex: r"For $\lambda>1$ the particle comes to rest at the time $T$ of (20), and $\theta\to0$ as $t\to T$.",
        plain: "For λ > 1 the particle comes to rest at the time T of (20), and θ → 0 as t → T.",
        depends_on: &["eq-13", "eq-20"],
        conditions: &[
            Condition {
                text: r"$\lambda>1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$\theta_0\neq\pi$: that particle stops at $T$ without turning",
                sort: Sort::Degenerate,
            },
        ],
        trials: trials![&exact::EQ20_WITHIN, limits::eq20_motion, limits::eq20_quadrature, extremes::large_friction_limit, extremes::large_friction_turns.coarse(&[("turning_slope", "the unit grows with the friction, as what rounding of the angle makes of the sum does")]), extremes::large_friction_outside, excepted::large_friction],
        argument: STOPS,
        ..Claim::BLANK
    },
    Claim {
        id: "s21-along-acceleration",
        section: "2.1",
        title: "the sense of the sliding",
        latex: r"For $\lambda\leq1$, at large times, the particle slides along the plane's acceleration: $\bm v/\lvert\bm v\rvert\to\bm A/\lvert\bm A\rvert$.",
        plain: "For λ ≤ 1, at large times, the particle slides along the plane's acceleration: 𝐯/|𝐯| → 𝐀/|𝐀|.",
        conditions: &[
            Condition {
                text: r"“along” is read as in the sense of the acceleration, not merely on its line; the formula is ours",
                sort: Sort::Reading,
            },
            NOT_THE_ONE_THAT_STOPS,
        ],
        depends_on: &["eq-1", "eq-3", "s21-small-friction-aligns"],
        trials: trials![
            sense::along,
            sense::against,
            sense::against_in_the_laboratory,
            &exact::AGAINST,
            excepted::small_friction
        ],
        correction: Some(Correction {
            change: Change::Sign,
            latex: r"For $\lambda\leq1$, at large times, the particle slides against the plane's acceleration: $\bm v/\lvert\bm v\rvert\to-\bm A/\lvert\bm A\rvert$.",
            plain: "For λ ≤ 1, at large times, the particle slides against the plane's acceleration: 𝐯/|𝐯| → −𝐀/|𝐀|.",
        }),
        ..Claim::BLANK
    },
    Claim {
        id: "s21-incline",
        section: "2.1",
        title: "the inclined plane is a constant acceleration",
        latex: r"The motion on an inclined plane is that on a surface with constant acceleration.",
        plain: "The motion on an inclined plane is that on a surface with constant acceleration.",
        depends_on: &["eq-1", "eq-3"],
        trials: trials![&exact::ON_AN_INCLINE, incline::law, incline::same_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "s21-incline-only-constant",
        section: "2.1",
        title: "no incline for an acceleration that changes with time",
        latex: r"The motion under an acceleration that depends on time is not that on an inclined plane.",
        plain: "The motion under an acceleration that depends on time is not that on an inclined plane.",
        depends_on: &["eq-1", "s21-incline"],
        conditions: &[Condition {
            text: "an inclined plane at rest; one that is shaken along its slope is another matter",
            sort: Sort::Reading,
        }],
        trials: trials![&exact::ONLY_CONSTANT, only_constant::turns.idle(excuses::TWO_KINDS), only_constant::both_ways.idle(excuses::TWO_KINDS)],
        ..Claim::BLANK
    },
    Claim {
        id: "s21-portrait-consistent",
        section: "2.1",
        title: "agreement with the inclined plane",
        latex: "The results agree with those for the inclined plane in Eur. J. Phys. 32, 1049.",
        plain: "The results agree with those for the inclined plane in Eur. J. Phys. 32, 1049.",
        depends_on: &["eq-11", "eq-13", "eq-20"],
        trials: trials![incline::speed, incline::time, incline::forces],
        ..Claim::BLANK
    },
    Claim {
        id: "fig-1",
        section: "2.1",
        kind: Kind::Figure,
        title: "portraits of the velocity",
        latex: r"Phase portraits of $(v_x,v_y)$ for several $\lambda$: panel (a) $\lambda\leq1$, panel (b) $\lambda>1$.",
        plain: "Phase portraits of (v_x, v_y) for several λ: panel (a) λ ≤ 1, panel (b) λ > 1.",
        depends_on: &[
            "eq-11",
            "s21-small-friction-aligns",
            "s21-large-friction-stops",
        ],
        trials: trials![drawn::points, drawn::ends],
        ..Claim::BLANK
    },
];
