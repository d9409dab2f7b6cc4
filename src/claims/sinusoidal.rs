//! Sinusoidal acceleration: stick and slip: the claims.

mod across;
mod argument;
pub mod attraction;
pub mod certified;
pub mod chains;
mod decay;
pub mod drawn;
pub mod exact;
pub mod excepted;
mod kinds;
pub mod order;
mod periodic;
mod phases;
mod rest_of_period;
pub(super) mod settled;
mod slip;
pub mod stages;
mod threshold;
mod units;

use super::attempt::trials;
use super::excuses;
use super::{Claim, Condition, Correction, Sort, Topic, rough};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "sinusoidal",
    title: "Sinusoidal acceleration: stick and slip",
    claims: CLAIMS,
};

/// How v_y really dies, in place of a slow exponential.
const DECAY: Correction = Correction {
    change: Change::Statement,
    latex: r"While $v_y\gg v_x$, $v_y$ falls linearly in time. Once $v_y\ll v_x$, let $d=\lvert\sin\phi\rvert$ be the size of the drive where $v_x$ is zero, and $\mathfrak w_y=\varpi v_y/A_0$. For $\lambda_0>\lambda_\mathrm c$, $v_y$ is exactly zero after a finite time; if $v_x$ stops while friction exceeds the drive, the $\mathfrak w_y$ that is left vanishes within the phase $\lambda_0\mathfrak{w}_y/(\lambda_0^2-d^2)$, to leading order. For $\lambda_0<\lambda_\mathrm c$, where $d=\sin\tilde\phi_1$, each passage of $v_x$ through zero multiplies $\ln v_y$ by $(d+\lambda_0)/(d-\lambda_0)$, up to terms that stay bounded: $v_y$ falls as the exponential of an exponential. The exception is a particle that comes to a stop on the way to its large-time motion: it loses all of $v_y$ there.",
    plain: "While v_y ≫ v_x, v_y falls linearly in time. Once v_y ≪ v_x, let d = |sin φ| be the size of the drive where v_x is zero, and w_y = ϖ v_y/A₀. For λ₀ > λ_c, v_y is exactly zero after a finite time; if v_x stops while friction exceeds the drive, the w_y that is left vanishes within the phase λ₀ w_y/(λ₀² − d²), to leading order. For λ₀ < λ_c, where d = sin φ̃₁, each passage of v_x through zero multiplies ln v_y by (d + λ₀)/(d − λ₀), up to terms that stay bounded: v_y falls as the exponential of an exponential. The exception is a particle that comes to a stop on the way to its large-time motion: it loses all of v_y there.",
};

/// Without friction every start keeps its own motion.
pub(super) const SOME_FRICTION: Condition =
    rough(r"$\lambda_0>0$: without friction no start is forgotten");

/// Without friction the velocity across the drive keeps its value, and the one along it never depends on that.
pub(super) const FRICTION_ACROSS: Condition =
    rough(r"$\lambda_0>0$: without friction nothing acts across the drive");

/// Of the phases (27) to (30).
const PHASES: &str = r"For $0<\lambda_0<1$ the arcsine lies between 0 and $\pi/2$, so that the four phases lie in $[0,2\pi]$, in this order; that there are no others is shown of the four points.";

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-21",
        section: "2.2",
        equation: Some(21),
        kind: Kind::Definition,
        title: "the sinusoidal acceleration",
        latex: r"\bm{A}=-A_0 \sin(\varpi t) \hat{\bm{x}}",
        plain: "𝐀 = −A₀ sin(ϖ t) x̂",
        conditions: &[Condition {
            text: "$A_0>0$",
            sort: Sort::Stated,
        }],
        trials: trials![&exact::DEFINITIONS, units::eq21],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-22",
        section: "2.2",
        equation: Some(22),
        kind: Kind::Definition,
        title: "friction over amplitude",
        latex: r"\lambda_0=\frac{\mu g}{A_0}",
        plain: "λ₀ = μ g / A₀",
        depends_on: &["eq-21"],
        trials: trials![&exact::DEFINITIONS, units::eq22],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-23",
        section: "2.2",
        equation: Some(23),
        kind: Kind::Definition,
        title: "dimensionless time",
        latex: r"\phi=\varpi t",
        plain: "φ = ϖ t",
        depends_on: &["eq-21"],
        trials: trials![&exact::DEFINITIONS, units::eq23],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-24",
        section: "2.2",
        equation: Some(24),
        kind: Kind::Definition,
        title: "dimensionless velocity",
        latex: r"\mathfrak{w}=\frac{\varpi v_x}{A_0}",
        plain: "w = ϖ v_x / A₀",
        depends_on: &["eq-21"],
        trials: trials![&exact::DEFINITIONS, units::eq24],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-25",
        section: "2.2",
        equation: Some(25),
        kind: Kind::Inequality,
        title: "the drive beats friction",
        latex: r"\lambda_0<1",
        plain: "λ₀ < 1",
        conditions: &[Condition {
            text: r"$A_0>\mu g$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-22"],
        trials: trials![&exact::EQ25, units::eq25_motion, units::eq25_census],
        argument: r"With $A_0>0$ (22) makes it $A_0>\mu g$. The square is not negative, and it is 0 at $\phi=\pi/2$: the drive exceeds friction at some phase exactly where (25) holds.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-26",
        section: "2.2",
        equation: Some(26),
        kind: Kind::Equation,
        title: "dimensionless motion while sliding",
        latex: r"\frac{\mathrm{d} \mathfrak{w}}{\mathrm{d} \phi}=\sin\phi-\lambda_0 \frac{\mathfrak{w}}{\vert \mathfrak{w}\vert }",
        plain: "dw/dφ = sin φ − λ₀ w/|w|",
        conditions: &[
            Condition {
                text: "at large times, when $v_y$ has vanished",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$\mathfrak{w}\neq0$",
                sort: Sort::Stated,
            },
        ],
        depends_on: &[
            "eq-1",
            "eq-21",
            "eq-22",
            "eq-23",
            "eq-24",
            "s22-vy-vanishes",
        ],
        trials: trials![&exact::EQ26, units::eq26_quadrature],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-27",
        section: "2.2",
        equation: Some(27),
        kind: Kind::Equation,
        title: "drive equals friction: first phase",
        latex: r"\phi_1=\sin^{-1}\lambda_0",
        plain: "φ₁ = asin λ₀",
        conditions: &[Condition {
            text: r"$\phi$ in $[0,2\pi]$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-25", "eq-26"],
        trials: trials![&exact::EQ27, phases::eq27_root, phases::eq27_motion],
        argument: PHASES,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-28",
        section: "2.2",
        equation: Some(28),
        kind: Kind::Equation,
        title: "drive equals friction: second phase",
        latex: r"\phi_2=\pi-\sin^{-1}\lambda_0",
        plain: "φ₂ = π − asin λ₀",
        conditions: &[Condition {
            text: r"$\phi$ in $[0,2\pi]$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-25", "eq-26"],
        trials: trials![&exact::EQ28, phases::eq28_root, phases::eq28_motion],
        argument: PHASES,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-29",
        section: "2.2",
        equation: Some(29),
        kind: Kind::Equation,
        title: "drive equals friction: third phase",
        latex: r"\phi_3=\pi+\sin^{-1}\lambda_0",
        plain: "φ₃ = π + asin λ₀",
        conditions: &[Condition {
            text: r"$\phi$ in $[0,2\pi]$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-25", "eq-26"],
        trials: trials![&exact::EQ29, phases::eq29_root, phases::eq29_motion],
        argument: PHASES,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-30",
        section: "2.2",
        equation: Some(30),
        kind: Kind::Equation,
        title: "drive equals friction: fourth phase",
        latex: r"\phi_4=2 \pi-\sin^{-1}\lambda_0",
        plain: "φ₄ = 2π − asin λ₀",
        conditions: &[Condition {
            text: r"$\phi$ in $[0,2\pi]$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-25", "eq-26"],
        trials: trials![&exact::EQ30, phases::eq30_root, phases::eq30_motion],
        argument: PHASES,
        ..Claim::BLANK
    },
    Claim {
        id: "eq-31",
        section: "2.2",
        equation: Some(31),
        kind: Kind::Equation,
        title: "forward slip after a rest",
        latex: r"\mathfrak{w}=-\lambda_0 (\phi-\phi_1)+\cos\phi_1-\cos\phi",
        plain: "w = −λ₀ (φ − φ₁) + cos φ₁ − cos φ",
        conditions: &[
            Condition {
                text: r"$\mathfrak{w}=0$ at $\phi_1$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$\mathfrak{w}>0$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"$\phi$ in $[\phi_1,\tilde\phi_2]$",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-26", "eq-27"],
        trials: trials![&exact::EQ31, slip::eq31_motion],
        argument: r"With $\mathfrak w>0$ (26) fixes the slope, so that slope and start leave one function. It is positive from $\phi_1$ to its next zero $\tilde\phi_2$, as is shown of (32), so that friction keeps its sign for so long.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-32",
        section: "2.2",
        equation: Some(32),
        kind: Kind::Equation,
        title: "end of the forward slip",
        latex: r"-\lambda_0 (\tilde\phi_2-\phi_1)+\cos\phi_1-\cos\tilde\phi_2=0",
        plain: "−λ₀ (φ̃₂ − φ₁) + cos φ₁ − cos φ̃₂ = 0",
        conditions: &[Condition {
            text: r"$\tilde\phi_2$ is the smallest solution above $\phi_1$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-31"],
        trials: trials![
            &exact::EQ32,
            slip::eq32_root,
            slip::eq32_motion,
            slip::eq32_census,
            certified::one_end
        ],
        argument: r"The left side grows from 0 at $\phi_1$ to $\phi_2$ and falls from there to $\phi_4$, where it is negative: it is 0 once in between, and there the slip ends, which was forward until then.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-33",
        section: "2.2",
        equation: Some(33),
        kind: Kind::Equation,
        title: "large-time motion with rests",
        latex: r"\mathfrak{w}=\begin{cases} -\lambda_0 (\phi-\phi_1)+\cos\phi_1-\cos\phi,&\phi_1<\phi<\tilde\phi_2\\ 0,&\tilde\phi_2<\phi<\phi_3\\ \lambda_0 (\phi-\phi_3)+\cos\phi_3-\cos\phi,&\phi_3<\phi<\tilde\phi_2+\pi\\ 0,&\tilde\phi_2+\pi<\phi<\phi_1+2 \pi \end{cases}",
        plain: "w = −λ₀ (φ − φ₁) + cos φ₁ − cos φ for φ₁ < φ < φ̃₂; 0 for φ̃₂ < φ < φ₃; λ₀ (φ − φ₃) + cos φ₃ − cos φ for φ₃ < φ < φ̃₂ + π; 0 for φ̃₂ + π < φ < φ₁ + 2π",
        conditions: &[
            Condition {
                text: r"$\tilde\phi_2<\phi_3$",
                sort: Sort::Stated,
            },
            Condition {
                text: r"continued with period $2\pi$",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-29", "eq-31", "eq-32", "s22-rest-ends"],
        trials: trials![
            &exact::EQ33,
            periodic::eq33_motion.coarse(&[("eq33_ends", excuses::JOINTS)]),
            periodic::eq33_unique
                .idle(excuses::ONE_MOTION)
                .elsewhere(excuses::IN_WORDS)
        ],
        argument: r"In the slips $\mathfrak w$ has the sign taken for friction, as is shown of (31) and (32). While (33) is 0, from $\tilde\phi_2>\phi_2$ to $\phi_3$ and half a period later, the drive is weaker than friction. Every other motion becomes this one, as is shown of the rest that a slip leaves.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-34",
        section: "2.2",
        equation: Some(34),
        kind: Kind::Inequality,
        title: "when the slip ends before the next",
        latex: r"-\lambda_0 (\phi_3-\phi_1)+\cos\phi_1-\cos\phi_3<0",
        plain: "−λ₀ (φ₃ − φ₁) + cos φ₁ − cos φ₃ < 0",
        conditions: &[Condition {
            text: r"$\tilde\phi_2<\phi_3$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-27", "eq-29", "eq-32"],
        trials: trials![
            &exact::EQ34,
            slip::eq34_motion,
            slip::eq34_census,
            threshold::eq34_root
        ],
        argument: r"(31) is positive from $\phi_1$ to its only zero $\tilde\phi_2$ and negative from there to $\phi_4>\phi_3$, as is shown of (32). It is negative at $\phi_3$ exactly where the slip has ended by then.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-35",
        section: "2.2",
        equation: Some(35),
        kind: Kind::Inequality,
        title: "the same, in the friction alone",
        latex: r"-\pi \lambda_0+2 \sqrt{1-\lambda_0^2}<0",
        plain: "−π λ₀ + 2 √(1 − λ₀²) < 0",
        conditions: &[Condition {
            text: r"$\tilde\phi_2<\phi_3$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-27", "eq-29", "eq-34"],
        trials: trials![
            &exact::EQ35,
            slip::eq35_motion,
            slip::eq35_census,
            certified::threshold
        ],
        argument: r"The left side is that of (34), so that it is negative exactly where (34) holds, which is where the slip has ended before $\phi_3$.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-36",
        section: "2.2",
        equation: Some(36),
        kind: Kind::Inequality,
        title: "friction above the critical value",
        latex: r"\lambda_0>\lambda_\mathrm{c}",
        plain: "λ₀ > λ_c",
        conditions: &[Condition {
            text: r"$\tilde\phi_2<\phi_3$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-35", "eq-37"],
        trials: trials![&exact::EQ36, slip::eq36_census],
        argument: r"$\pi\lambda_0+2\sqrt{1-\lambda_0^2}$ is positive, so that the left side of (35) has the sign of $\lambda_\mathrm c^2-\lambda_0^2$; it is negative where $\tilde\phi_2<\phi_3$.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-37",
        section: "2.2",
        equation: Some(37),
        kind: Kind::Number,
        title: "the critical friction",
        latex: r"\lambda_\mathrm{c}=\frac{2}{\sqrt{4+\pi^2}}",
        plain: "λ_c = 2 / √(4 + π²)",
        depends_on: &["eq-35"],
        trials: trials![
            &exact::EQ37,
            threshold::eq37_root,
            threshold::eq37_motion,
            certified::lambda_c
        ],
        argument: r"(35) falls with $\lambda_0$, as is shown of it, so that this is its only zero: above it a slip from rest ends before $\phi_3$, as is shown of (34), below it does not.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-38",
        section: "2.2",
        equation: Some(38),
        kind: Kind::Equation,
        title: "large-time motion without rests",
        latex: r"\mathfrak{w}=\begin{cases}-\lambda_0 (\phi-\tilde\phi_1)+\cos\tilde\phi_1-\cos\phi,& \tilde\phi_1<\phi<\tilde\phi_1+\pi\\ \lambda_0 (\phi-\tilde\phi_1-\pi)-\cos\tilde\phi_1-\cos\phi,& \tilde\phi_1+\pi<\phi<\tilde\phi_1+2 \pi \end{cases}",
        plain: "w = −λ₀ (φ − φ̃₁) + cos φ̃₁ − cos φ for φ̃₁ < φ < φ̃₁ + π; λ₀ (φ − φ̃₁ − π) − cos φ̃₁ − cos φ for φ̃₁ + π < φ < φ̃₁ + 2π",
        conditions: &[
            SOME_FRICTION,
            Condition {
                text: "(36) does not hold",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-26", "eq-36", "s22-no-rest-below"],
        trials: trials![
            &exact::EQ38,
            periodic::eq38_motion.coarse(&[("eq38_ends", excuses::JOINTS)]),
            periodic::eq38_unique
                .idle(excuses::ONE_MOTION)
                .elsewhere(excuses::IN_WORDS),
            periodic::eq38_approach
                .elsewhere("how fast the periodic motion is approached, which (38) does not say"),
            periodic::eq38_outside,
            excepted::no_friction
        ],
        argument: r"Inside the halves $\mathfrak w$ has the sign that (26) takes, and at their ends the drive exceeds friction below $\lambda_\mathrm c$, by (40); at $\lambda_\mathrm c$ it equals it there, and grows. So this is a motion; every other one comes to it, as is shown of small friction.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-39",
        section: "2.2",
        equation: Some(39),
        kind: Kind::Equation,
        title: "phase at which the velocity turns positive",
        latex: r"\tilde\phi_1=\cos^{-1}\frac{\pi \lambda_0}{2}",
        plain: "φ̃₁ = acos(π λ₀ / 2)",
        conditions: &[
            SOME_FRICTION,
            Condition {
                text: "(36) does not hold",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-38"],
        trials: trials![
            &exact::EQ39,
            periodic::eq39_motion,
            periodic::eq39_outside,
            excepted::no_friction
        ],
        argument: r"Half a period after its start a motion that repeats itself with reversed sign has to be at rest for an instant again, and of the two phases with this cosine the drive pushes forwards at the one between 0 and $\pi/2$.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-40",
        section: "2.2",
        equation: Some(40),
        kind: Kind::Inequality,
        title: "friction below the critical value",
        latex: r"\lambda_0<\lambda_\mathrm{c}",
        plain: "λ₀ < λ_c",
        conditions: &[Condition {
            text: "the motion is that of (38)",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-37", "eq-38"],
        trials: trials![&exact::EQ40, threshold::eq40_census],
        argument: r"Both sines are positive, so that the drive exceeds friction at $\tilde\phi_1$ exactly where the difference of the squares is positive. At $\lambda_\mathrm c$ the two are equal: there (38) is (33), with rests of no length.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-41",
        section: "2.2",
        equation: Some(41),
        kind: Kind::Inequality,
        title: "the turn comes after the drive beats friction",
        latex: r"\tilde\phi_1>\phi_1",
        plain: "φ̃₁ > φ₁",
        conditions: &[Condition {
            text: r"$\lambda_0<\lambda_\mathrm{c}$",
            sort: Sort::Stated,
        }],
        depends_on: &["eq-27", "eq-39", "eq-40"],
        trials: trials![
            threshold::eq41_motion,
            threshold::eq41_census,
            certified::turns
        ],
        argument: r"By the identity of (40), $\sin^2\tilde\phi_1-\lambda_0^2=(1+\pi^2/4)(\lambda_\mathrm c^2-\lambda_0^2)$, which is positive below $\lambda_\mathrm c$. As $\lambda_0=\sin\phi_1$ and both phases lie between 0 and $\pi/2$, where the sine grows, $\tilde\phi_1>\phi_1$.",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-vy-vanishes",
        section: "2.2",
        title: "the velocity across the drive vanishes",
        latex: r"$v_y\to0$ at large times.",
        plain: "v_y → 0 at large times.",
        depends_on: &["s2-perpendicular-decays", "eq-21"],
        conditions: &[FRICTION_ACROSS],
        trials: trials![
            &chains::VY_VANISHES,
            across::vanishes_limit,
            across::vanishes_motion,
            across::vanishes_census.elsewhere(excuses::BY_EQ1),
            across::vanishes_outside,
            excepted::no_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-weak-drive-stops",
        section: "2.2",
        title: "a weak drive: rest",
        latex: r"For $A_0<\mu g$, $v_x$ too vanishes at large times.",
        plain: "For A₀ < μ g, v_x too vanishes at large times.",
        depends_on: &["s2-stops-if-weak", "eq-21"],
        trials: trials![
            &chains::WEAK_DRIVE_STOPS,
            kinds::weak_drive_motion,
            kinds::weak_drive_census
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-vx-stays",
        section: "2.2",
        title: "a strong drive: motion for ever",
        latex: r"For $A_0>\mu g$, $v_x$ does not tend to zero at large times.",
        plain: "For A₀ > μ g, v_x does not tend to zero at large times.",
        depends_on: &["eq-21", "eq-25"],
        trials: trials![
            &chains::VX_STAYS,
            argument::stays_census,
            argument::stays_motion
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-friction-across",
        section: "2.2",
        title: "friction across the drive",
        latex: r"Once $v_y\ll v_x$, friction is nearly along $x$, with a small $y$-component proportional to $v_y$.",
        plain: "Once v_y ≪ v_x, friction is nearly along x, with a small y-component proportional to v_y.",
        conditions: &[
            Condition {
                text: r"in proportion to $v_y$ at a given $v_x$, with the factor $1/\lvert v_x\rvert$, up to terms of the relative order $(v_y/v_x)^2$",
                sort: Sort::Reading,
            },
            Condition {
                text: r"away from the zeros of $v_x$, at which $v_y\ll v_x$ does not hold",
                sort: Sort::Stated,
            },
        ],
        depends_on: &["eq-1", "eq-21"],
        trials: trials![
            &chains::FRICTION_ACROSS,
            argument::across_rate,
            argument::across_proportional.coarse(&[(
                "s22_across_friction",
                "a ratio is compared, which no factor changes"
            )])
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-vy-two-stages",
        section: "2.2",
        title: "two stages of the decay across the drive",
        latex: r"While $v_y\gg v_x$, $v_y$ falls linearly in time; once $v_y\ll v_x$, it falls more slowly, exponentially.",
        plain: "While v_y ≫ v_x, v_y falls linearly in time; once v_y ≪ v_x, it falls more slowly, exponentially.",
        depends_on: &["eq-1", "eq-21", "s22-friction-across"],
        conditions: &[FRICTION_ACROSS],
        trials: trials![
            across::first_stage,
            across::second_stage,
            &stages::EXPONENTIAL,
            decay::first_stage_correction,
            decay::period_factor,
            decay::period_factor_reached,
            decay::passage_limit,
            decay::passage_quadrature,
            decay::finite_end
                .idle(excuses::ONE_MOTION)
                .elsewhere(excuses::IN_WORDS),
            decay::last_stage,
            &stages::TWO_STAGES,
            excepted::no_friction
        ],
        correction: Some(DECAY),
        ..Claim::BLANK
    },
    Claim {
        id: "s22-attractor-ignores-vy",
        section: "2.2",
        title: "the large-time motion forgets the start across the drive",
        latex: "At large times $v_x$ does not depend on the initial $v_y$; before that it does.",
        plain: "At large times v_x does not depend on the initial v_y; before that it does.",
        depends_on: &["eq-26", "s22-vy-vanishes"],
        conditions: &[FRICTION_ACROSS],
        trials: trials![
            &attraction::IGNORES_VY,
            across::ignores_motion,
            across::ignores_census.idle(
                "that a velocity across the drive matters on the way is said without a formula"
            ),
            across::ignores_outside,
            excepted::no_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "fig-2",
        section: "2.2",
        kind: Kind::Figure,
        title: "the way to the large-time motion",
        latex: "$v_x$ against time for one initial $v_x$ and several initial $v_y$.",
        plain: "v_x against time for one initial v_x and several initial v_y.",
        depends_on: &["eq-1", "eq-21", "s22-attractor-ignores-vy"],
        trials: trials![
            drawn::fig2_motion.idle(
                "the drawn motion is held against another integrator; the paper prints no points"
            ),
            drawn::fig2_limit
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-four-points",
        section: "2.2",
        title: "drive equals friction four times",
        latex: r"$\lvert\sin\phi\rvert=\lambda_0$ at exactly four points of a period, those of (27) to (30).",
        plain: "|sin φ| = λ₀ at exactly four points of a period, those of (27) to (30).",
        depends_on: &["eq-27", "eq-28", "eq-29", "eq-30"],
        conditions: &[
            Condition {
                text: r"$\lambda_0<1$",
                sort: Sort::Stated,
            },
            rough(
                r"$\lambda_0>0$: at $\lambda_0=0$ the four formulas give only the two points $0$ and $\pi$ of a period",
            ),
        ],
        trials: trials![
            &order::FOUR_POINTS,
            phases::four_points_census,
            phases::four_points_root.elsewhere(
                "the places of the points, by (27) to (30); their number is tried beside it"
            ),
            phases::four_points_outside,
            excepted::no_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-rest-ends",
        section: "2.2",
        title: "where a rest can end",
        latex: r"Within $[0,2\pi]$ an interval of rest can end only at $\phi_1$ or $\phi_3$.",
        plain: "Within [0, 2π] an interval of rest can end only at φ₁ or φ₃.",
        depends_on: &["eq-26", "eq-27", "eq-29"],
        trials: trials![
            &order::REST_ENDS,
            phases::rest_ends_motion,
            phases::rest_ends_census
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-phi2-bracket",
        section: "2.2",
        title: "bounds on the end of the slip",
        latex: r"$\phi_2<\tilde\phi_2<\phi_4$.",
        plain: "φ₂ < φ̃₂ < φ₄.",
        depends_on: &["eq-28", "eq-30", "eq-32"],
        trials: trials![
            slip::bracket_census,
            slip::bracket_limit,
            certified::bracket,
            certified::bracket_outside,
            excepted::no_friction
        ],
        conditions: &[rough(
            r"$\lambda_0>0$: without friction the slip ends at $2\pi$, which is $\phi_4$",
        )],
        argument: r"A continuous function that has opposite signs at $\phi_2$ and $\phi_4$ is 0 in between, and (32) has no second zero, as is shown of it.",
        ..Claim::BLANK
    },
    Claim {
        id: "s22-rest-interval",
        section: "2.2",
        title: "a slip that ends early leaves a rest",
        latex: r"If $\tilde\phi_2<\phi_3$, the large-time motion is (33), at rest on $[\tilde\phi_2,\phi_3]$ and again half a period later.",
        plain: "If φ̃₂ < φ₃, the large-time motion is (33), at rest on [φ̃₂, φ₃] and again half a period later.",
        depends_on: &["eq-33"],
        trials: trials![
            &attraction::REST_INTERVAL,
            periodic::rest_interval_root,
            periodic::rest_interval_reached,
            periodic::eq33_unique.idle(excuses::ONE_MOTION)
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-slip-longer-than-half",
        section: "2.2",
        title: "at small friction a slip from rest outlasts half the period",
        latex: r"If (36) does not hold, $[\phi_1,\tilde\phi_2]$ is longer than $\pi$, and $\mathfrak{w}(\phi_1+2\pi)$ would be negative.",
        plain: "If (36) does not hold, [φ₁, φ̃₂] is longer than π, and w(φ₁ + 2π) would be negative.",
        depends_on: &["eq-27", "eq-32", "eq-36", "eq-37"],
        conditions: &[Condition {
            text: r"$0<\lambda_0<\lambda_\mathrm c$: at $\lambda_\mathrm c$ it is as long as $\pi$, and without friction nothing is lost",
            sort: Sort::Degenerate,
        }],
        trials: trials![
            &order::OUTLASTS,
            argument::outlasts_census,
            kinds::no_rest_motion,
            argument::outlasts_outside,
            argument::neither_end
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-rest-of-period",
        section: "2.2",
        title: "where the period of the argument ends",
        latex: r"The slip on $[\phi_1,\tilde\phi_2]$ is followed by an interval that ends, with the period, at $\phi+2\pi$.",
        plain: "The slip on [φ₁, φ̃₂] is followed by an interval that ends, with the period, at φ + 2π.",
        depends_on: &["eq-27", "eq-31"],
        conditions: &[
            Condition {
                text: r"$\lambda_0<\lambda_\mathrm{c}$",
                sort: Sort::Stated,
            },
            rough(r"$\lambda_0>0$: without friction the slip lasts for the whole period"),
        ],
        trials: trials![
            rest_of_period::printed_root,
            rest_of_period::printed_quadrature,
            rest_of_period::corrected_root,
            rest_of_period::corrected_quadrature,
            &order::PERIOD_ENDS,
            excepted::no_friction
        ],
        correction: Some(Correction {
            change: Change::Symbol,
            latex: r"The slip on $[\phi_1,\tilde\phi_2]$ is followed by an interval that ends, with the period, at $\phi_1+2\pi$.",
            plain: "The slip on [φ₁, φ̃₂] is followed by an interval that ends, with the period, at φ₁ + 2π.",
        }),
        ..Claim::BLANK
    },
    Claim {
        id: "s22-no-rest-below",
        section: "2.2",
        title: "no rest at small friction",
        latex: r"For $\lambda_0<\lambda_\mathrm{c}$ no periodic motion vanishes on an interval.",
        plain: "For λ₀ < λ_c no periodic motion vanishes on an interval.",
        depends_on: &["eq-26", "eq-32", "eq-36", "s22-rest-ends"],
        trials: trials![
            &attraction::NO_REST_BELOW,
            kinds::no_rest_census,
            kinds::no_rest_motion
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s22-trichotomy",
        section: "2.2",
        title: "small, large and very large friction",
        latex: r"At large times $v_x$ has exactly two zeros in each period for $\lambda_0<\lambda_\mathrm{c}$, two intervals of rest for $\lambda_\mathrm{c}<\lambda_0<1$, and is identically zero for $\lambda_0>1$.",
        plain: "At large times v_x has exactly two zeros in each period for λ₀ < λ_c, two intervals of rest for λ_c < λ₀ < 1, and is identically zero for λ₀ > 1.",
        depends_on: &[
            "eq-36",
            "eq-38",
            "s22-weak-drive-stops",
            "s22-rest-interval",
            "s22-no-rest-below",
        ],
        conditions: &[SOME_FRICTION],
        trials: trials![
            &attraction::TRICHOTOMY,
            kinds::trichotomy_census,
            kinds::trichotomy_motion,
            kinds::trichotomy_outside,
            excepted::no_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "fig-3",
        section: "2.2",
        kind: Kind::Figure,
        title: "large-time motion at small friction",
        latex: r"$\mathfrak{w}(\phi)$ over two periods for $\lambda_0=1/\pi$, that is (38) for $\phi$ from $0$ to $4\pi$; the axis of $\mathfrak{w}$ bears the mark $0.8$.",
        plain: "w(φ) over two periods for λ₀ = 1/π, that is (38) for φ from 0 to 4π; the axis of w bears the mark 0.8.",
        depends_on: &["eq-38", "eq-39"],
        trials: trials![drawn::fig3_motion, drawn::fig3_frame.idle(excuses::FRAME)],
        ..Claim::BLANK
    },
    Claim {
        id: "fig-4",
        section: "2.2",
        kind: Kind::Figure,
        title: "large-time motion at large friction",
        latex: r"$\mathfrak{w}(\phi)$ over two periods for $\lambda_0=1/\sqrt{2}$, that is (33) for $\phi$ from $0$ to $4\pi$; the axis of $\mathfrak{w}$ bears the mark $0.3$.",
        plain: "w(φ) over two periods for λ₀ = 1/√2, that is (33) for φ from 0 to 4π; the axis of w bears the mark 0.3.",
        depends_on: &["eq-33"],
        trials: trials![drawn::fig4_motion, drawn::fig4_frame.idle(excuses::FRAME)],
        ..Claim::BLANK
    },
];
