//! Where one sees a claim fail: the explorers, in a state and at a plot, and what there is to see.

/// The claim, the address, and what one watches there.
pub(super) const PLACES: &[(&str, &str, &str)] = &[
    (
        "s21-along-acceleration",
        "constant.html#explore-constant?lambda=0.5&theta=0",
        "it go on faster and faster",
    ),
    (
        "s22-rest-of-period",
        "sinusoidal.html#explore-sinusoidal?lambda=0.5&w=0&across=0&plot=1",
        "where the slips begin",
    ),
    (
        "s22-vy-two-stages",
        "sinusoidal.html#explore-sinusoidal?lambda=0.318&w=0.5&across=1&plot=2",
        "the logarithm of the velocity across",
    ),
    ("eq-55", BEYOND_Y, NEVER_BACK),
    ("s24-region-2", BEYOND_Y, NEVER_BACK),
    (
        "fig-5",
        "anisotropic.html#explore-anisotropic?q=6.5&lambda=0.15&w=0.3&plot=3",
        NEVER_BACK,
    ),
    (
        "s23-nonzero-again",
        "periodic.html#explore-periodic?third=0&lambda=0.25&w=0.8&eta=0.5",
        "the train of pulses",
    ),
    (
        "eq-75",
        "sphere.html#explore-sphere?lambda=1.5&kappa=0.4&u=-1&v=0",
        "which way a ball turns that rolls",
    ),
    ("eq-82", THROWN_ACROSS, "that block stop"),
    ("eq-83", THROWN_ACROSS, "that block stop"),
    ("eq-106", FLICKED_FROM_THE_AXIS, HALF_A_SQUARE),
    ("s4-coriolis-no-work", FLICKED_FROM_THE_AXIS, HALF_A_SQUARE),
    (
        "eq-128",
        "escape.html#explore-escape?rho=1.1&plot=5",
        "τ dα/dτ",
    ),
    ("eq-129", QUASI_FIXED, "the quotient of its two sides"),
    (
        "eq-130",
        QUASI_FIXED,
        "the quotient of the two sides of (129)",
    ),
    ("eq-131", GROWTH, "A²/τ³, to which it leads"),
    ("eq-132", GROWTH, "A²/τ³"),
    ("eq-133", GROWTH, "ρ/τ² and A²/τ³, of which it is made"),
    (
        "eq-134",
        "escape.html#explore-escape?rho=1.1&plot=3",
        "(π/2 − ψ) τ",
    ),
    ("eq-135", DISTANCE, "ρ/τ², which p/τ² comes near to"),
    ("eq-136", DISTANCE, "ρ/τ²"),
    ("eq-137", DISTANCE, "ρ/τ², near to three times s/τ³"),
    (
        "eq-146",
        BETWEEN,
        "a coin come to rest beyond (147), which follows from it",
    ),
    ("eq-147", BETWEEN, AT_REST),
    ("s4-envelope-is-boundary", BETWEEN, AT_REST),
    (
        "s4-psi-free",
        "rest.html#explore-rest?rho=0.48&u=0&v=-0.14",
        "where a coin comes to rest that (145) would bring to σ = 0.505",
    ),
];

/// Between the borders C and E of anisotropic friction: region IV, which the paper takes for II.
const BEYOND_Y: &str = "anisotropic.html#explore-anisotropic?q=9&lambda=0.1&w=0.3&plot=3";
const NEVER_BACK: &str = "a period with no backward slip";

/// The block that moves like the slip of a ball that is thrown across.
const THROWN_ACROSS: &str = "constant.html#explore-constant?lambda=1.75&theta=90";

/// A coin that comes to rest at p²/2, as if the table did not turn.
const FLICKED_FROM_THE_AXIS: &str = "turntable.html#explore-turntable?rho=0&u=0.2&v=0&plot=2";
const HALF_A_SQUARE: &str = "a coin flicked with p = 0.2 stop at p²/2";

/// A particle that escapes, at the plots of what grows.
const DISTANCE: &str = "escape.html#explore-escape?rho=1.1&plot=2";
const GROWTH: &str = "escape.html#explore-escape?rho=1.1&plot=4";
const QUASI_FIXED: &str = "escape.html#explore-escape?rho=1.1&plot=5";

/// A particle that comes to rest though it is beyond the printed border: A = 0.88 at α = 0.1, ψ = 0.2, to two digits.
const BETWEEN: &str = "rest.html#explore-rest?rho=0.88&u=0.09&v=-0.02";
const AT_REST: &str = "a coin come to rest that by (147) escapes";
