//! Sliding on an accelerating plane: the claims.

pub(super) mod apart;
pub mod chains;
mod examples;
pub mod excepted;
pub mod law;
mod planes;
mod properties;
pub mod strong;

use super::attempt::trials;
use super::excuses;
use super::{Claim, Condition, Sort, Topic, rough};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "general",
    title: "Sliding on an accelerating plane",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-1",
        section: "2",
        equation: Some(1),
        kind: Kind::Equation,
        title: "equation of motion while sliding",
        latex: r"\frac{\mathrm{d} \bm{v}}{\mathrm{d} t}=-\bm{A}-\mu g \frac{\bm{v}}{v}",
        plain: "d𝐯/dt = −𝐀 − μ g 𝐯/v",
        conditions: &[
            Condition {
                text: "the particle is not at rest: $v>0$",
                sort: Sort::Stated,
            },
            Condition {
                text: "in the frame of the accelerating plane",
                sort: Sort::Stated,
            },
            Condition {
                text: r"one coefficient $\mu$ for static and kinetic friction",
                sort: Sort::Stated,
            },
        ],
        trials: trials![
            &law::EQ1,
            law::eq1_laboratory,
            law::eq1_quadrature,
            law::eq1_motion
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-2",
        section: "2",
        equation: Some(2),
        kind: Kind::Equation,
        title: "rate of change of the speed",
        latex: r"\frac{\mathrm{d} v}{\mathrm{d} t}=-\bm{A}\cdot\frac{\bm{v}}{v}-\mu g",
        plain: "dv/dt = −𝐀·𝐯/v − μ g",
        conditions: &[Condition {
            text: "the particle is not at rest: $v>0$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-1"],
        trials: trials![&law::EQ2, law::eq2_quadrature, law::eq2_motion],
        ..Claim::BLANK
    },
    Claim {
        id: "s2-stops-if-weak",
        section: "2",
        title: "a weak drive lets the particle stop",
        latex: r"If the largest value of $\lvert\bm{A}\rvert$ is below $\mu g$, the speed falls and the particle is at rest after a finite time.",
        plain: "If the largest value of |𝐀| is below μ g, the speed falls and the particle is at rest after a finite time.",
        depends_on: &["eq-2"],
        trials: trials![
            &chains::STOPS.elsewhere(excuses::BY_THE_LAW),
            properties::stops_census,
            properties::stops_integration.coarse(&[("s2_stops_below", excuses::BOUNDS)])
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s2-no-permanent-rest",
        section: "2",
        title: "a strong drive ends every rest",
        latex: r"If $\lvert\bm{A}\rvert$ exceeds $\mu g$ again after every time, however late, the particle cannot stay at rest for ever.",
        plain: "If |𝐀| exceeds μ g again after every time, however late, the particle cannot stay at rest for ever.",
        depends_on: &["eq-1"],
        conditions: &[Condition {
            text: r"$\lvert\bm A\rvert>\mu g$ for a stretch of time, as for a continuous $\bm A$, and not only at single instants",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &strong::MOVES,
            properties::rest_census,
            properties::rest_integration,
            properties::rest_outside,
            excepted::instants
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s2-speeds-up-if-strong",
        section: "2",
        title: "a strong drive of fixed direction speeds the particle up",
        latex: r"If $\bm{A}$ has a fixed direction and $\lvert\bm{A}\rvert>\mu g$ at all times, then $v$ increases from some time on.",
        plain: "If 𝐀 has a fixed direction and |𝐀| > μ g at all times, then v increases from some time on.",
        depends_on: &["eq-2"],
        conditions: &[Condition {
            text: r"$\lvert\bm A\rvert$ stays above $\mu g$ by a fixed margin",
            sort: Sort::Substance,
        }],
        trials: trials![
            &strong::SPEEDS_UP,
            properties::grows_census,
            properties::grows_integration.coarse(&[("s2_speeds_up_above", excuses::BOUNDS)]),
            properties::grows_outside
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s2-perpendicular-decays",
        section: "2",
        title: "the velocity across the drive decays",
        latex: r"If $\bm{A}$ has a fixed direction, the part $\bm{v}_\perp$ of the velocity across it shrinks; if $\lvert\bm{A}\rvert$ is bounded as well, $\bm{v}_\perp\to0$ at large times.",
        plain: "If 𝐀 has a fixed direction, the part 𝐯⊥ of the velocity across it shrinks; if |𝐀| is bounded as well, 𝐯⊥ → 0 at large times.",
        depends_on: &["eq-1"],
        trials: trials![
            &chains::ACROSS,
            properties::across_census,
            properties::across_quadrature.coarse(&[("s2_across_trend", excuses::SIGN)]),
            properties::across_limit,
            properties::across_integration.coarse(&[("s2_across_trend", excuses::SIGN)]),
            properties::across_outside,
            excepted::no_friction
        ],
        conditions: &[rough(r"$\mu>0$: without friction nothing acts across")],
        ..Claim::BLANK
    },
];
