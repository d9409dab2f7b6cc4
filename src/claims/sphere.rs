//! A sphere that slips and rolls: the claims.

mod angle;
mod any_drive;
mod definitions;
pub mod drawn;
mod driven;
mod every_drive;
pub mod exact;
pub mod excepted;
mod rates;
mod scaling;
mod spheres;

use super::attempt::trials;
use super::constant::MIRRORED;
use super::excuses;
use super::sinusoidal::SOME_FRICTION;
use super::{Claim, Condition, Correction, Sort, Topic};
use crate::evidence::{Change, Kind};

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "sphere",
    title: "A sphere that slips and rolls",
    claims: CLAIMS,
};

/// Stated with (63).
const SLIDES: &[Condition] = &[Condition {
    text: "the sphere slides",
    sort: Sort::Stated,
}];

/// Stated with (3), to which section 3.1 refers.
const CONSTANT: &[Condition] = &[Condition {
    text: r"$\bm{A}=-A\hat{\bm{x}}$ is constant, $A>0$",
    sort: Sort::Stated,
}];

const STATED_CONSTANT: Condition = CONSTANT[0];

/// As for (11).
const NOT_STRAIGHT: &[Condition] = &[
    STATED_CONSTANT,
    Condition {
        text: r"$\theta_0\neq0,\pi$: along the line of the acceleration it is $0/0$",
        sort: Sort::Degenerate,
    },
];

/// As for (13).
const TIME_HAS_A_VALUE: &[Condition] = &[
    STATED_CONSTANT,
    Condition {
        text: r"$\theta_0\neq0,\pi$, $\lambda\neq1$ and $\cos\theta_0\neq-\lambda$, as printed and as corrected: elsewhere it is $0/0$",
        sort: Sort::Degenerate,
    },
];

/// As for (14).
const SLIP_HAS_A_VALUE: &[Condition] = &[
    STATED_CONSTANT,
    Condition {
        text: r"$\cos\theta\neq-\lambda$, as printed and as corrected: there it is $0/0$",
        sort: Sort::Degenerate,
    },
];

/// (75) with its sign.
const SPIN: Correction = Correction {
    change: Change::Sign,
    latex: r"\bm{\zeta}=\hat{\bm{z}} \zeta_3-\hat{\bm{z}}\times(\bm{u}-\dot{\bm{\rho}})",
    plain: "𝛇 = ẑ ζ₃ − ẑ × (𝐮 − d𝛒/dτ)",
};

/// (81) where it has no value too.
const REGULAR_SLIP: Correction = Correction {
    change: Change::Statement,
    latex: r"u=u_0\left[\cos^2\tfrac{\theta_0}{2}\,r^{\lambda-1}+\sin^2\tfrac{\theta_0}{2}\,r^{\lambda+1}\right],\quad r=\frac{\tan\frac{\theta}{2}}{\tan\frac{\theta_0}{2}}",
    plain: "u = u₀ [cos²(θ₀/2) r^(λ−1) + sin²(θ₀/2) r^(λ+1)], r = tan(θ/2)/tan(θ₀/2)",
};

/// (82) with its factor.
const TIME: Correction = Correction {
    change: Change::Factor,
    latex: r"\tau=\frac{u_0 (\lambda+\cos\theta_0)}{\gamma (1-\lambda^2)} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right],\quad\gamma=\frac{A}{\mu g}",
    plain: "τ = u₀ (λ + cos θ₀)/[γ (1 − λ²)] · {[(λ + cos θ) sin θ₀]/[(λ + cos θ₀) sin θ] · [tan(θ/2)/tan(θ₀/2)]^λ − 1}, γ = A/(μ g)",
};

/// (83) with its factor.
const SLIP_AT_TIME: Correction = Correction {
    change: Change::Factor,
    latex: r"u=\frac{(1-\lambda^2) \gamma \tau+u_0 (\lambda+\cos\theta_0)}{\lambda+\cos\theta},\quad\gamma=\frac{A}{\mu g}",
    plain: "u = [(1 − λ²) γ τ + u₀ (λ + cos θ₀)]/(λ + cos θ), γ = A/(μ g)",
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-59",
        section: "3",
        equation: Some(59),
        kind: Kind::Equation,
        title: "Newton's law for the centre",
        latex: r"m \frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-m \bm{A}+\bm{F}",
        plain: "m d²𝐫/dt² = −m 𝐀 + 𝐅",
        trials: trials![&exact::EQ59, definitions::eq59],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-60",
        section: "3",
        equation: Some(60),
        kind: Kind::Equation,
        title: "Newton's law for the spin",
        latex: r"I \frac{\mathrm{d} \bm{\omega}}{\mathrm{d} t}=\bm{R}\times\bm{F}",
        plain: "I d𝛚/dt = 𝐑 × 𝐅",
        trials: trials![&exact::EQ60, definitions::eq60],
        argument: r"The steps hold for six equal masses at one distance on three axes. In the law of rotation about the centre a rigid body enters only by its moments of inertia, and a homogeneous sphere, like the six masses, has one moment $I$ about every axis, so that it obeys the same law.",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-61",
        section: "3",
        equation: Some(61),
        kind: Kind::Definition,
        title: "from the centre to the contact",
        latex: r"\bm{R}=-R \hat{\bm{z}}",
        plain: "𝐑 = −R ẑ",
        trials: trials![definitions::eq61],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-62",
        section: "3",
        equation: Some(62),
        kind: Kind::Definition,
        title: "dimensionless moment of inertia",
        latex: r"\kappa=\frac{I}{m R^2}",
        plain: "κ = I/(m R²)",
        trials: trials![
            &exact::EQ62,
            scaling::eq62.coarse(&[("eq62_kappa", excuses::SUM)])
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-63",
        section: "3",
        equation: Some(63),
        kind: Kind::Equation,
        title: "acceleration of the sliding sphere",
        latex: r"\frac{\mathrm{d}^2 \bm{r}}{\mathrm{d} t^2}=-\bm{A}-\mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)",
        plain: "d²𝐫/dt² = −𝐀 − μ g 𝐰/|𝐰|, 𝐰 = d𝐫/dt + 𝛚 × 𝐑",
        conditions: SLIDES,
        depends_on: &["eq-59", "eq-61"],
        trials: trials![&exact::EQ63, rates::eq63],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-64",
        section: "3",
        equation: Some(64),
        kind: Kind::Equation,
        title: "angular acceleration of the sliding sphere",
        latex: r"\kappa R^2 \frac{\mathrm{d} \bm{\omega}}{\mathrm{d} t}=-\mu g \bm{R}\times\left\{ \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)\right\}",
        plain: "κ R² d𝛚/dt = −μ g 𝐑 × 𝐰/|𝐰|, 𝐰 = d𝐫/dt + 𝛚 × 𝐑",
        conditions: SLIDES,
        depends_on: &["eq-60", "eq-61", "eq-62"],
        trials: trials![&exact::EQ64, rates::eq64],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-65",
        section: "3",
        equation: Some(65),
        kind: Kind::Equation,
        title: "rate of the spin's share of the slip",
        latex: r"\frac{\mathrm{d} (\bm{\omega}\times\bm{R})}{\mathrm{d} t}=-\frac{\mu g}{\kappa} \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)",
        plain: "d(𝛚 × 𝐑)/dt = −(μ g/κ) 𝐰/|𝐰|, 𝐰 = d𝐫/dt + 𝛚 × 𝐑",
        conditions: SLIDES,
        depends_on: &["eq-61", "eq-64"],
        trials: trials![&exact::EQ65, rates::eq65],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-66",
        section: "3",
        equation: Some(66),
        kind: Kind::Equation,
        title: "rate of the slip velocity",
        latex: r"\frac{\mathrm{d}}{\mathrm{d} t} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right) =-\bm{A}-b \mu g \left\vert \frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right\vert ^{-1} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)",
        plain: "d𝐰/dt = −𝐀 − b μ g 𝐰/|𝐰|, 𝐰 = d𝐫/dt + 𝛚 × 𝐑",
        conditions: SLIDES,
        depends_on: &["eq-63", "eq-65", "eq-67"],
        trials: trials![&exact::EQ66, rates::eq66],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-67",
        section: "3",
        equation: Some(67),
        kind: Kind::Definition,
        title: "factor of the friction coefficient",
        latex: r"b=1+\frac{1}{\kappa}",
        plain: "b = 1 + 1/κ",
        depends_on: &["eq-62"],
        trials: trials![definitions::eq67],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-68",
        section: "3",
        equation: Some(68),
        kind: Kind::Definition,
        title: "dimensionless position",
        latex: r"\bm{\rho}=\frac{\bm{r}}{R}",
        plain: "𝛒 = 𝐫/R",
        trials: trials![&exact::EQ68, scaling::eq68, scaling::eq68_way],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-69",
        section: "3",
        equation: Some(69),
        kind: Kind::Definition,
        title: "dimensionless time",
        latex: r"\tau=\sqrt{\frac{\mu g}{R}} t",
        plain: "τ = √(μ g/R) t",
        trials: trials![
            &exact::EQ69,
            scaling::eq69.coarse(&[("eq69_time", excuses::SUM)])
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-70",
        section: "3",
        equation: Some(70),
        kind: Kind::Definition,
        title: "dimensionless angular velocity",
        latex: r"\bm{\zeta}=\sqrt{\frac{R}{\mu g}} \bm{\omega}",
        plain: "𝛇 = √(R/(μ g)) 𝛚",
        trials: trials![&exact::EQ70, scaling::eq70],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-71",
        section: "3",
        equation: Some(71),
        kind: Kind::Definition,
        title: "dimensionless slip velocity",
        latex: r"\bm{u}=\frac{1}{\sqrt{\mu g R}} \left(\frac{\mathrm{d} \bm{r}}{\mathrm{d} t}+\bm{\omega}\times\bm{R}\right)",
        plain: "𝐮 = (d𝐫/dt + 𝛚 × 𝐑)/√(μ g R)",
        depends_on: &["eq-61"],
        trials: trials![
            &exact::EQ71,
            scaling::eq71.coarse(&[("eq71_slip", excuses::SUM)]),
            scaling::eq71_both_ways.coarse(&[("eq71_slip", excuses::SUM)])
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-72",
        section: "3",
        equation: Some(72),
        kind: Kind::Definition,
        title: "dimensionless acceleration",
        latex: r"\bm{\gamma}=\frac{\bm{A}}{\mu g}",
        plain: "𝛄 = 𝐀/(μ g)",
        trials: trials![
            &exact::EQ72,
            scaling::eq72.coarse(&[("eq72_acceleration", excuses::SUM)])
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-73",
        section: "3",
        equation: Some(73),
        kind: Kind::Equation,
        title: "acceleration of the centre, dimensionless",
        latex: r"\ddot{\bm{\rho}}=-\bm{\gamma}-\frac{\bm{u}}{u}",
        plain: "d²𝛒/dτ² = −𝛄 − 𝐮/u",
        conditions: SLIDES,
        depends_on: &["eq-63", "eq-68", "eq-69", "eq-71", "eq-72"],
        trials: trials![&exact::EQ73, rates::eq73],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-74",
        section: "3",
        equation: Some(74),
        kind: Kind::Equation,
        title: "rate of the slip velocity, dimensionless",
        latex: r"\dot{\bm{u}}=-\bm{\gamma}-b \frac{\bm{u}}{u}",
        plain: "d𝐮/dτ = −𝛄 − b 𝐮/u",
        conditions: SLIDES,
        depends_on: &["eq-66", "eq-69", "eq-71", "eq-72"],
        trials: trials![&exact::EQ74, rates::eq74],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-75",
        section: "3",
        equation: Some(75),
        kind: Kind::Equation,
        title: "angular velocity from the slip",
        latex: r"\bm{\zeta}=\hat{\bm{z}} \zeta_3+\hat{\bm{z}}\times(\bm{u}-\dot{\bm{\rho}})",
        plain: "𝛇 = ẑ ζ₃ + ẑ × (𝐮 − d𝛒/dτ)",
        depends_on: &["eq-61", "eq-68", "eq-69", "eq-70", "eq-71"],
        trials: trials![
            rates::eq75,
            &exact::EQ75,
            rates::corrected75,
            &exact::CORRECTED_75
        ],
        correction: Some(SPIN),
        ..Claim::BLANK
    },
    Claim {
        id: "eq-76",
        section: "3",
        equation: Some(76),
        kind: Kind::Definition,
        title: "integrated acceleration",
        latex: r"\dot{\bm{\nu}}=\bm{\gamma}",
        plain: "d𝛎/dτ = 𝛄",
        depends_on: &["eq-69", "eq-72"],
        trials: trials![definitions::eq76],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-77",
        section: "3",
        equation: Some(77),
        kind: Kind::Equation,
        title: "friction alone changes dρ/dτ + ν",
        latex: r"(\dot{\bm{\rho}}+\bm{\nu})^{\cdot}=-\frac{\bm{u}}{u}",
        plain: "d(d𝛒/dτ + 𝛎)/dτ = −𝐮/u",
        conditions: SLIDES,
        depends_on: &["eq-73", "eq-76"],
        trials: trials![&exact::EQ77, rates::eq77],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-78",
        section: "3",
        equation: Some(78),
        kind: Kind::Equation,
        title: "friction alone changes u + ν",
        latex: r"(\bm{u}+\bm{\nu})^{\cdot}=-b \frac{\bm{u}}{u}",
        plain: "d(𝐮 + 𝛎)/dτ = −b 𝐮/u",
        conditions: SLIDES,
        depends_on: &["eq-74", "eq-76"],
        trials: trials![&exact::EQ78, rates::eq78],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-79",
        section: "3",
        equation: Some(79),
        kind: Kind::Equation,
        title: "velocity of the centre from the slip",
        latex: r"\dot{\bm{\rho}}=-\left(1-\frac{1}{b}\right) \bm{\nu}+\frac{\bm{u}}{b}+\bm{c}",
        plain: "d𝛒/dτ = −(1 − 1/b) 𝛎 + 𝐮/b + 𝐜, 𝐜 constant",
        depends_on: &["eq-77", "eq-78"],
        trials: trials![&exact::EQ79, rates::eq79],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-80",
        section: "3.1",
        equation: Some(80),
        kind: Kind::Definition,
        title: "friction parameter of the sphere",
        latex: r"\lambda=\frac{b \mu g}{A}",
        plain: "λ = b μ g/A",
        depends_on: &["eq-3", "eq-67"],
        trials: trials![angle::eq80],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-81",
        section: "3.1",
        equation: Some(81),
        kind: Kind::Equation,
        title: "slip speed over the angle",
        latex: r"u=u_0 \frac{\sin\theta_0}{\sin\theta} \left(\frac{{\tan\frac{\theta}{2}}} {{\tan\frac{\theta_0}{2}}}\right)^\lambda",
        plain: "u = u₀ (sin θ₀/sin θ) [tan(θ/2)/tan(θ₀/2)]^λ",
        conditions: NOT_STRAIGHT,
        depends_on: &["eq-11", "eq-74", "eq-80"],
        trials: trials![
            &exact::EQ81,
            angle::eq81,
            angle::eq81_outside,
            angle::regular_slip,
            angle::regular_straight,
            excepted::eq81
        ],
        correction: Some(REGULAR_SLIP),
        argument: MIRRORED,
    },
    Claim {
        id: "eq-82",
        section: "3.1",
        equation: Some(82),
        kind: Kind::Equation,
        title: "time over the angle of slip",
        latex: r"\tau=\frac{u_0 (\lambda+\cos\theta_0)}{1-\lambda^2} \left[\frac{(\lambda +\cos\theta) \sin\theta_0}{(\lambda +\cos\theta_0) \sin\theta} \left(\frac{{\tan\frac{\theta}{2}}}{{\tan\frac{\theta_0}{2}}}\right)^\lambda -1\right]",
        plain: "τ = u₀ (λ + cos θ₀)/(1 − λ²) · {[(λ + cos θ) sin θ₀]/[(λ + cos θ₀) sin θ] · [tan(θ/2)/tan(θ₀/2)]^λ − 1}",
        conditions: TIME_HAS_A_VALUE,
        depends_on: &["eq-13", "eq-69", "eq-71", "eq-74", "eq-80"],
        trials: trials![
            angle::eq82,
            &exact::EQ82,
            angle::corrected82,
            angle::corrected82_quadrature,
            &exact::CORRECTED_82,
            angle::regular_time.elsewhere(
                "the regular form is that of section 2.1, which no claim of section 3 restates"
            ),
            excepted::eq82
        ],
        correction: Some(TIME),
        argument: MIRRORED,
    },
    Claim {
        id: "eq-83",
        section: "3.1",
        equation: Some(83),
        kind: Kind::Equation,
        title: "slip speed over time and angle",
        latex: r"u=\frac{(1-\lambda^2) \tau+u_0 (\lambda+\cos\theta_0)}{(\lambda+\cos\theta)}",
        plain: "u = [(1 − λ²) τ + u₀ (λ + cos θ₀)]/(λ + cos θ)",
        conditions: SLIP_HAS_A_VALUE,
        depends_on: &["eq-14", "eq-81", "eq-82"],
        trials: trials![
            angle::eq83,
            &exact::EQ83,
            angle::corrected83,
            &exact::CORRECTED_83,
            angle::eq83_step,
            excepted::eq83
        ],
        correction: Some(SLIP_AT_TIME),
        argument: MIRRORED,
    },
    Claim {
        id: "eq-84",
        section: "3.2",
        equation: Some(84),
        kind: Kind::Definition,
        title: "friction parameter, sinusoidal drive",
        latex: r"\lambda_0=\frac{b \mu g}{A_0}",
        plain: "λ₀ = b μ g/A₀",
        depends_on: &["eq-22", "eq-67"],
        trials: trials![driven::eq84],
        ..Claim::BLANK
    },
    Claim {
        id: "eq-85",
        section: "3.4",
        equation: Some(85),
        kind: Kind::Definition,
        title: "friction parameter, anisotropic friction",
        latex: r"\lambda_0=\frac{b \mu_+ g}{A_0}",
        plain: "λ₀ = b μ₊ g/A₀",
        depends_on: &["eq-47", "eq-49", "eq-67"],
        trials: trials![driven::eq85],
        ..Claim::BLANK
    },
    Claim {
        id: "s3-reduction",
        section: "3",
        title: "the sphere reduced to the particle",
        latex: r"The slip velocity $\bm{u}$ moves like a particle's velocity under the same $\bm{A}$ with $b\mu$ in place of $\mu$; the velocity of the centre and the spin then follow from $\bm{u}$.",
        plain: "The slip velocity 𝐮 moves like a particle's velocity under the same 𝐀 with bμ in place of μ; the velocity of the centre and the spin then follow from 𝐮.",
        depends_on: &["eq-1", "eq-74", "eq-75", "eq-79"],
        trials: trials![
            &exact::S3_REDUCTION,
            every_drive::reduction_motion,
            every_drive::reduction_from_rest,
            every_drive::reduction_small_slip,
            every_drive::reduction_rolling,
            every_drive::reduction_rest
        ],
        argument: r"While it slides, $\bm u$ alone obeys (1) with $b\mu$ for $\mu$; while $\lvert\bm A\rvert\leq b\mu g$ a sphere rolls on as that particle stays at rest. Then (79), with $\bm\nu$ the integral of the given $\bm\gamma$, gives the velocity of the centre, and (75) as corrected, with the constant $\zeta_3$, the spin.",
        ..Claim::BLANK
    },
    Claim {
        id: "s3-spin-constant",
        section: "3",
        title: "spin about the vertical",
        latex: r"$\zeta_3$ keeps its value and enters no other equation.",
        plain: "ζ₃ keeps its value and enters no other equation.",
        depends_on: &["eq-64", "eq-73", "eq-74", "eq-75"],
        trials: trials![&exact::S3_SPIN_CONSTANT, every_drive::spin_constant],
        argument: r"A component whose rate is 0 is constant; what no other rate contains has no effect on them.",
        ..Claim::BLANK
    },
    Claim {
        id: "s32-rolling-trichotomy",
        section: "3",
        title: "when the driven sphere rolls",
        latex: r"At large times $u_x$ vanishes at exactly two instants per period if $\lambda_0<\lambda_\mathrm{c}$, on two intervals per period if $\lambda_\mathrm{c}<\lambda_0<1$, always if $\lambda_0>1$; where $\bm{u}=0$ the sphere rolls without slipping.",
        plain: "At large times u_x vanishes at exactly two instants per period if λ₀ < λ_c, on two intervals per period if λ_c < λ₀ < 1, always if λ₀ > 1; where 𝐮 = 0 the sphere rolls without slipping.",
        depends_on: &["s22-trichotomy", "eq-71", "eq-84", "s3-reduction"],
        conditions: &[
            SOME_FRICTION,
            Condition {
                text: r"of the motion that is approached, in which $u_y=0$: for $\lambda_0<\lambda_\mathrm c$ a slip across the drive never ends, unless the sphere comes to roll on the way, and with it it rolls at the two instants only in the limit",
                sort: Sort::Reading,
            },
        ],
        trials: trials![
            &exact::carried::TRICHOTOMY,
            driven::trichotomy_census,
            driven::trichotomy_motion,
            driven::rolling_ends,
            driven::trichotomy_outside,
            super::sinusoidal::excepted::no_friction
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s33-any-drive",
        section: "3",
        title: "any periodic drive of the sphere",
        latex: r"With $\lambda_0$ of (84), what section 2.3 says of rests under any periodic drive holds for the rolling of the sphere.",
        plain: "With λ₀ of (84), what section 2.3 says of rests under any periodic drive holds for the rolling of the sphere.",
        depends_on: &[
            "eq-84",
            "s23-rest-above-one",
            "s23-threshold-exists",
            "s3-reduction",
        ],
        trials: trials![
            &exact::carried::ANY_DRIVE,
            any_drive::census,
            any_drive::parts
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s33-pulse",
        section: "3",
        title: "pulse drive of the sphere",
        latex: r"With $\lambda_0$ of (84), the pulse train of (42), (43) has the same boundary $\lambda_\mathrm{c}=\eta$ for the sphere.",
        plain: "With λ₀ of (84), the pulse train of (42), (43) has the same boundary λ_c = η for the sphere.",
        depends_on: &["eq-42", "eq-43", "eq-46", "eq-84", "s3-reduction"],
        trials: trials![
            &exact::carried::PULSE,
            driven::pulse_census,
            driven::pulse_motion
        ],
        ..Claim::BLANK
    },
    Claim {
        id: "s34-anisotropic",
        section: "3",
        title: "anisotropic friction on the sphere",
        latex: r"With $\lambda_0$ of (85), the slip velocity has the regions I to V of the particle.",
        plain: "With λ₀ of (85), the slip velocity has the regions I to V of the particle.",
        depends_on: &["fig-5", "eq-85", "s3-reduction"],
        trials: trials![
            &exact::carried::ANISOTROPIC,
            driven::anisotropic_census,
            driven::anisotropic_motion
        ],
        ..Claim::BLANK
    },
];
