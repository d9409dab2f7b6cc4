//! Any periodic acceleration: the claims.

pub mod again;
pub mod borders;
pub mod chains;
mod changes;
pub mod drawn;
pub mod drives;
pub mod exact;
mod losses;
mod mostly;
mod pulses;
mod rest;
pub mod threshold;

use super::attempt::trials;
use super::excuses;
use super::{Claim, Condition, Correction, Sort, Topic, rough};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "periodic",
    title: "Any periodic acceleration",
    claims: CLAIMS,
};

/// Of (44).
const PULSED: &str = r"From rest at 0 $\mathfrak w$ rises at $1-\lambda_0>0$, then falls at $\lambda_0$ to 0 before $\pi$, where with no drive it stays. Every motion becomes this one: two velocities never move apart, and while (44) rests the speed of any other falls at the rate $\lambda_0$, in each period by a fixed amount.";

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-42",
        section: "2.3",
        equation: Some(42),
        kind: Kind::Definition,
        title: "a train of pulses: first half",
        latex: r"h(\phi)=\begin{cases} 1,&0<\phi<\eta \pi\\ 0,&\eta \pi<\phi<\pi \end{cases}",
        plain: "h(φ) = 1 for 0 < φ < η π; 0 for η π < φ < π",
        conditions: &[Condition {
            text: r"$\eta$ constant, between $0$ and $1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-26"],
        trials: trials![pulses::eq42],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-43",
        section: "2.3",
        equation: Some(43),
        kind: Kind::Definition,
        title: "a train of pulses: second half",
        latex: r"h(\pi+\phi)=-h(\phi)",
        plain: "h(π + φ) = −h(φ)",
        depends_on: &["eq-42"],
        trials: trials![pulses::eq43],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-44",
        section: "2.3",
        equation: Some(44),
        kind: Kind::Equation,
        title: "large-time motion: first half",
        latex: r"\mathfrak{w}=\begin{cases} (1-\lambda_0) \phi,&0<\phi<\eta \pi\\ (1-\lambda_0) \eta \pi-\lambda_0 (\phi-\eta \pi),&\eta \pi<\phi <(\eta \pi/\lambda_0)\\ 0,&(\eta \pi/\lambda_0)<\phi<\pi \end{cases}",
        plain: "w = (1 − λ₀) φ for 0 < φ < η π; (1 − λ₀) η π − λ₀ (φ − η π) for η π < φ < η π / λ₀; 0 for η π / λ₀ < φ < π",
        conditions: &[
            Condition {
                text: r"$\lambda_0<1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$\lambda_0>\lambda_\mathrm{c}$ of (46)",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-26", "eq-42"],
        trials: trials![
            &exact::EQ44,
            pulses::eq44_motion.coarse(&[("eq44_ends", excuses::JOINTS)]),
            pulses::eq44_plane.coarse(&[
                ("eq44_cases", excuses::HALF),
                ("eq44_ends", excuses::JOINTS)
            ]),
            losses::with_rests
        ],
        argument: PULSED,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-45",
        section: "2.3",
        equation: Some(45),
        kind: Kind::Equation,
        title: "large-time motion: second half",
        latex: r"\mathfrak{w}(\pi+\phi)=-\mathfrak{w}(\phi)",
        plain: "w(π + φ) = −w(φ)",
        conditions: &[
            Condition {
                text: r"$\lambda_0<1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$\lambda_0>\lambda_\mathrm{c}$ of (46)",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-43", "eq-44"],
        trials: trials![
            &exact::EQ45,
            pulses::eq45_motion.coarse(&[("eq45_w", excuses::HALF)]),
            pulses::eq45_plane.coarse(&[("eq45_w", excuses::HALF)])
        ],
        argument: r"The mirrored velocity obeys the same law with the same start half a period later, and the law leaves one velocity after each start; every other motion becomes this one, as is said of (44).",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-46",
        section: "2.3",
        equation: Some(46),
        kind: Kind::Number,
        title: "critical friction of the pulses",
        latex: r"\lambda_\mathrm{c}=\eta",
        plain: "λ_c = η",
        depends_on: &["eq-44"],
        trials: trials![
            &exact::EQ46,
            pulses::eq46_root,
            pulses::eq46_census,
            pulses::below_motion
                .elsewhere("what the motion is below the threshold, which other trials try")
                .coarse(&[
                    ("small_friction_ends", excuses::JOINTS),
                    ("small_friction_start", excuses::HALF)
                ]),
            drawn::shares_motion.coarse(&[(
                "eq46_lambda_c",
                "it says which motions have rests; close to where they appear they last for no time"
            )]),
            losses::without_rest
        ],
        argument: r"The stop of (44) comes at $\eta\pi/\lambda_0$, before the next pulse at $\pi$ exactly where $\lambda_0>\eta$; for $\lambda_0\leq\eta$ the motion without rest takes its place.",
        ..Claim::BLANK
    },
    Claim {
        id: "s23-rest-above-one",
        section: "2.3",
        title: "very large friction: rest",
        latex: r"If the largest value of $\lvert h\rvert$ is $1$ and $\lambda_0>1$, the particle is always at rest at large times.",
        plain: "If the largest value of |h| is 1 and λ₀ > 1, the particle is always at rest at large times.",
        conditions: &[Condition {
            text: r"$h$ has period $2\pi$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-26"],
        trials: trials![
            &chains::REST_ABOVE_ONE,
            rest::within_time,
            rest::stopping_time.elsewhere("when it comes to rest, by (1)"),
            rest::sharp
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s23-threshold-exists",
        section: "2.3",
        title: "a threshold between small and large friction",
        latex: r"For a generic $h$ some $\lambda_\mathrm{c}$ divides large friction, with rests, from small friction, without; the behaviour may change at more than one value.",
        plain: "For a generic h some λ_c divides large friction, with rests, from small friction, without; the behaviour may change at more than one value.",
        conditions: &[
            Condition {
                text: r"$h$ has period $2\pi$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"the largest value of $\lvert h\rvert$ is $1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"generic is a piecewise continuous drive with $\lvert h\rvert<1$ for some time in each period and, if its mean is 0, with $h\neq0$, also as a limit from one side, wherever the antiderivative of $h$ is at its median",
                sort: Sort::Reading,
            },
            Condition {
                text: r"$\lambda_\mathrm c$ is the least number above which there are rests for all $\lambda_0<1$; below it they may come and go, and below another number there are none",
                sort: Sort::Reading,
            },
            Condition {
                text: r"a mean of $h$ drives the particle away for ever where $\lambda_0$ is below the size of that mean: without rest, but not periodically",
                sort: Sort::Remark,
            },
            Condition {
                text: r"with $\lvert h\rvert=1$ at all times no $\lambda_0<1$ lets it rest, and with $h=0$ at the median it may rest at every $\lambda_0$",
                sort: Sort::Remark,
            },
        ],
        depends_on: &["eq-26"],
        trials: trials![
            &borders::THRESHOLD,
            &changes::CHANGES,
            threshold::both_ends,
            threshold::two_zeros_root
                .idle(excuses::NO_NUMBER)
                .elsewhere(excuses::AT_WHICH),
            threshold::again_and_again
                .idle(excuses::NO_NUMBER)
                .elsewhere(excuses::AT_WHICH),
            threshold::with_mean,
            threshold::with_mean_drift.idle(excuses::BESIDE),
            threshold::with_mean_close.idle(excuses::BESIDE),
            threshold::two_valued,
            threshold::level
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s23-mostly-at-rest",
        section: "2.3",
        title: "rest for most of the time",
        latex: r"For a generic $h$ the particle is at rest for a big part of the time when $\lambda_0$ is slightly less than $1$.",
        plain: "For a generic h the particle is at rest for a big part of the time when λ₀ is slightly less than 1.",
        conditions: &[
            Condition {
                text: r"$h$ has period $2\pi$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"the largest value of $\lvert h\rvert$ is $1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"read as: the part tends to the whole period as $\lambda_0\to1$; generic is a drive with $\lvert h\rvert=1$ at single instants",
                sort: Sort::Reading,
            },
            Condition {
                text: r"with $\lvert h\rvert=1$ at all times there is no rest below $\lambda_0=1$",
                sort: Sort::Remark,
            },
        ],
        depends_on: &["eq-26"],
        trials: trials![
            &chains::MOSTLY_AT_REST,
            mostly::limit,
            mostly::census,
            mostly::two_valued.idle(excuses::BESIDE)
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s23-nonzero-again",
        section: "2.3",
        title: "what begins again with the next pulse",
        latex: r"The condition on $\lambda_0$ is that $\mathfrak{w}$ vanishes before the friction becomes nonzero again.",
        plain: "The condition on λ₀ is that w vanishes before the friction becomes nonzero again.",
        depends_on: &["eq-42", "eq-44"],
        trials: trials![
            again::friction_again,
            again::pull_again,
            again::pull_again_on_a_plane,
            &chains::AGAIN
        ],
        correction: Some(Correction {
            change: Change::Symbol,
            latex: r"The condition on $\lambda_0$ is that $\mathfrak{w}$ vanishes before the acceleration becomes nonzero again.",
            plain: "The condition on λ₀ is that w vanishes before the acceleration becomes nonzero again.",
        }),
        ..Claim::BLANK
    },
    Claim {
        id: "s23-pulses-normalised",
        section: "2.3",
        title: "the size of the pulses",
        latex: r"The largest value of $\lvert h\rvert$ is $1$ for the pulses of (42), (43), at every $\eta$ from $0$ to $1$.",
        plain: "The largest value of |h| is 1 for the pulses of (42), (43), at every η from 0 to 1.",
        depends_on: &["eq-42", "eq-43"],
        conditions: &[Condition {
            text: r"$\eta>0$: at $\eta=0$, which is used as an example, there is no pulse",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &chains::NORMALISED,
            again::largest_census,
            again::largest_integration,
            again::largest_outside,
            again::no_width
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s23-pulse-phases",
        section: "2.3",
        title: "the two extremes of the pulses",
        latex: r"For the pulses of (42), (43): $\eta=1$ has no large-friction phase, $\eta=0$ has no small-friction phase.",
        plain: "For the pulses of (42), (43): η = 1 has no large-friction phase, η = 0 has no small-friction phase.",
        depends_on: &["eq-43", "eq-46"],
        conditions: &[rough(
            r"$\lambda_0>0$: without friction whatever moves goes on at $\eta=0$",
        )],
        trials: trials![
            &chains::EXTREMES,
            pulses::extremes_census,
            pulses::extremes_limit,
            pulses::extremes_outside,
            pulses::neither
        ],
        ..Claim::BLANK
    },
];
