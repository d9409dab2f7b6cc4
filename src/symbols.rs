//! The symbols of the formulas, each declared once: what the code calls an argument, how it is printed, what it means.
//!
//! Trees of formulas, the pages and the reader of LaTeX take their names from here.

use crate::seeded::Symbol;

/// A line a symbol, in the paper's order: the topic where the name has a meaning of its own there, the argument's name,
/// its letter, those of its components or of itself and its rate, LaTeX, meaning, unit, and the claim that introduces it.
macro_rules! symbols {
    ($($argument:ident $(in $topic:ident)? = $plain:literal $([$($part:literal),*])?, $latex:literal,
       $meaning:literal, $unit:literal, $claim:literal;)*) => {
        /// All symbols, in the paper's order.
        pub const SYMBOLS: &[Symbol] = &[$(Symbol {
            topic: concat!($(stringify!($topic))?),
            argument: stringify!($argument),
            plain: $plain,
            parts: &[$($($part),*)?],
            latex: $latex,
            meaning: $meaning,
            unit: $unit,
            claim: $claim,
        }),*];
    };
}

symbols! {
    t = "t", "t", "time", "time", "eq-1";
    velocity = "v" ["v_x", "v_y"], r"\bm v", "velocity relative to the plane", "length/time", "eq-1";
    v = "v", "v", "speed relative to the plane", "length/time", "eq-2";
    acceleration = "A" ["A_x", "A_y"], r"\bm A", "acceleration of the plane", "length/time²", "eq-1";
    mu = "μ", r"\mu", "coefficient of friction, the same at rest and in motion", "1", "eq-1";
    g = "g", "g", "gravity", "length/time²", "eq-1";
    a = "A", "A", "size of a constant acceleration", "length/time²", "eq-3";
    theta = "θ", r"\theta", "direction of the velocity", "radians", "eq-4";
    lambda = "λ", r"\lambda", "friction over acceleration", "1", "eq-5";
    theta0 = "θ₀", r"\theta_0", "direction of the velocity at the start", "radians", "eq-11";
    v0 = "v₀", "v_0", "speed at the start", "length/time", "eq-11";
    d_power = "(d(tan θ/2)^λ/dθ)", r"\frac{\mathrm d}{\mathrm d\theta}\left(\tan\frac\theta2\right)^\lambda", "a derivative", "1", "eq-12";
    v0x = "v₀ₓ", "v_{0x}", "velocity along the inertial force at the start", "length/time", "eq-15";
    v0y = "v₀y", "v_{0y}", "velocity across it at the start", "length/time", "eq-16";
    y in constant = "y", "y", "place across the inertial force, from the launch on", "length", "s21-frictionless-parabola";
    eq20_stop_time = "T", "T", "time at which the particle stops", "time", "eq-20";
    r in constant = "r", "r", r"$\tan\frac{\theta}{2}$ over its value at the start", "1", "eq-11";
    ln_r in constant = "ln r", r"\ln r", "its logarithm", "1", "eq-11";
    a0 = "A₀", "A_0", "amplitude of a periodic acceleration", "length/time²", "eq-21";
    varpi = "ϖ", r"\varpi", "angular frequency of the acceleration", "1/time", "eq-21";
    lambda0 = "λ₀", r"\lambda_0", "friction over the amplitude", "1", "eq-22";
    lambda in periodic = "λ₀", r"\lambda_0", "friction over the amplitude", "1", "eq-22";
    phi = "φ", r"\phi", "phase of the acceleration", "radians", "eq-23";
    w = "𝔴", r"\mathfrak w", r"velocity along the drive, in units of $A_0/\varpi$", "1", "eq-24";
    vx = "vₓ", "v_x", "velocity along the drive", "length/time", "eq-24";
    phi1 = "φ₁", r"\phi_1", "phase at which the drive overcomes the friction", "radians", "eq-27";
    phi3 = "φ₃", r"\phi_3", "phase at which the drive overcomes the friction backwards", "radians", "eq-29";
    phi_t2 = "φ̃₂", r"\tilde\phi_2", "phase at which a slip ends", "radians", "eq-32";
    lambda_c = "λ_c", r"\lambda_\mathrm{c}", "friction from which on there are rests", "1", "eq-36";
    phi_t1 = "φ̃₁", r"\tilde\phi_1", "phase at which the motion without rest passes through zero", "radians", "eq-38";
    s in sinusoidal = "d", "d", r"size of the drive where $\mathfrak w$ passes through zero", "1", "s22-vy-two-stages";
    w_y in sinusoidal = "𝔴_y", r"\mathfrak w_y", r"velocity across the drive, in units of $A_0/\varpi$", "1", "s22-vy-two-stages";
    h = "h", "h", "form of a periodic drive, at most 1 in size", "1", "eq-42";
    eta = "η", r"\eta", "share of a half period that a pulse fills", "1", "eq-42";
    resisted = "f", "f", "acceleration by friction, in units of the drive's amplitude", "1", "s23-nonzero-again";
    mu_plus = "μ₊", r"\mu_+", "coefficient of friction forwards", "1", "eq-47";
    mu_minus = "μ₋", r"\mu_-", "coefficient of friction backwards", "1", "eq-48";
    q = "q", "q", r"ratio $\mu_-/\mu_+$", "1", "eq-50";
    k = "K", "K", "half the length of a slip; on curve A of the forward one", "radians", "eq-53";
    q_lambda0 = "(qλ₀)", r"q\lambda_0", "friction backwards", "1", "eq-54";
    q_y = "q_Y", r"q_\mathrm{Y}", "$q$ at the point Y", "1", "s24-Y";
    x in anisotropic = "x", "x", "length of the forward slip at the point Y", "radians", "s24-Y";
    curve_e = "E", r"\text{E}", "border that the paper's diagram lacks", "1", "s24-region-2";
    a in sphere = "A" ["A_x", "A_y", "A_z"], r"\bm A", "acceleration of the plane; its size where it is constant", "length/time²", "eq-59";
    r in sphere = "r" ["r_x", "r_y", "r_z"], r"\bm r", "position of the centre", "length", "eq-59";
    velocity in sphere = "ṙ" ["ṙ_x", "ṙ_y", "ṙ_z"], r"\dot{\bm r}", "velocity of the centre relative to the plane", "length/time", "eq-63";
    m = "m", "m", "mass", "mass", "eq-59";
    force = "F" ["F_x", "F_y", "F_z"], r"\bm F", "friction on the sphere", "mass·length/time²", "eq-59";
    inertia = "I", "I", "moment of inertia of the sphere", "mass·length²", "eq-60";
    omega in sphere = "ω" ["ω_x", "ω_y", "ω_z"], r"\bm\omega", "angular velocity of the sphere", "1/time", "eq-60";
    radius = "R", "R", "radius of the sphere", "length", "eq-61";
    contact = "R" ["R_x", "R_y", "R_z"], r"\bm R", "vector from the centre to the point of contact", "length", "eq-61";
    kappa = "κ", r"\kappa", "$I/(mR^2)$", "1", "eq-62";
    slip = "w" ["w_x", "w_y", "w_z"], r"\bm w", "velocity of the point of contact", "length/time", "eq-66";
    b in sphere = "b", "b", r"$1+1/\kappa$, by which the sphere's friction is multiplied", "1", "eq-67";
    tau = "τ", r"\tau", r"time: times $\sqrt{\mu g/R}$ for the sphere, times $\Omega$ on the turntable", "1", "eq-69";
    rho_rate = "ρ̇" ["ρ̇_x", "ρ̇_y", "ρ̇_z"], r"\dot{\bm\rho}", r"velocity of the sphere's centre, in units of $\sqrt{\mu gR}$", "1", "eq-75";
    zeta3 = "ζ₃", r"\zeta_3", r"angular velocity of the sphere about the vertical, in units of $\sqrt{\mu g/R}$", "1", "eq-70";
    u = "u" ["u_x", "u_y", "u_z"], r"\bm u", r"velocity of the point of contact, in units of $\sqrt{\mu gR}$", "1", "eq-71";
    gamma = "γ" ["γ_x", "γ_y", "γ_z"], r"\bm\gamma", r"acceleration of the plane, in units of $\mu g$", "1", "eq-72";
    nu = "ν" ["ν_x", "ν_y", "ν_z"], r"\bm\nu", r"time integral of $\bm\gamma$", "1", "eq-76";
    c in sphere = "c" ["c_x", "c_y", "c_z"], r"\bm c", "constant of the sphere's velocity", "1", "eq-79";
    u0 = "u₀", "u_0", r"size of $\bm u$ at the start", "1", "eq-81";
    r in turntable = "r" ["x", "y"], r"\bm r", "position on the table", "length", "eq-86";
    v in turntable = "v" ["v_x", "v_y"], r"\dot{\bm r}", "velocity relative to the table", "length/time", "eq-86";
    omega = "Ω", r"\Omega", "angular velocity of the turntable", "1/time", "eq-86";
    position = "ρ" ["ρ_x", "ρ_y"], r"\bm\rho", r"position over $\mu g/\Omega^2$", "1", "eq-87";
    rate = "ρ̇" ["ρ̇_x", "ρ̇_y"], r"\dot{\bm\rho}", r"velocity relative to the table, over $\mu g/\Omega$", "1", "eq-89";
    p = "p" ["p", "ṗ"], "p", "its size, the speed relative to the table; with its rate", "1", "eq-93";
    rho = "ρ", r"\rho", "distance from the axis", "1", "eq-94";
    psi = "ψ", r"\psi", "angle between velocity and position, its sign as in (95)", "radians", "eq-94";
    xi = "ξ" ["ξ", "ξ̇"], r"\xi", "position along the velocity; with its rate", "1", "eq-94";
    u_rate = "(du/dτ)", r"\dot u", "rate of what is called u there", "1", "s4-projection-azimuthal";
    ell = "ℓ" ["ℓ", "ℓ̇"], r"\ell", "position to the right of the velocity, angular momentum over $p$; with its rate", "1", "eq-95";
    s = "s", "s", "length of the path on the table", "length, or 1", "eq-104";
    a in turntable = "A", "A", r"with $\alpha$, a hyperbolic parameter where $p<\rho$", "1", "eq-111";
    a in escape = "A", "A", r"with $\alpha$, a hyperbolic parameter where $p<\rho$", "1", "eq-111";
    alpha = "α", r"\alpha", r"with $A$, a hyperbolic parameter where $p<\rho$", "1", "eq-111";
    b = "B", "B", r"with $\beta$, a hyperbolic parameter where $p>\rho$", "1", "eq-117";
    beta = "β", r"\beta", r"with $B$, a hyperbolic parameter where $p>\rho$", "1", "eq-117";
    i = "i", "i", "imaginary unit", "1", "eq-122";
    eq124_psi1 = "ψ₁", r"\psi_1", r"value of $\psi$ at which $\dot\psi=0$", "radians", "eq-124";
    eq125_psi2 = "ψ₂", r"\psi_2", "another such value", "radians", "eq-125";
    winding = "k", "k", r"turn of an escape per unit of $\ln\tau$, $\sqrt2$", "1", "eq-136";
    sigma = "σ", r"\sigma", "distance from the axis at rest", "1", "eq-139";
    psi_slope = "(dψ/dα)", r"\frac{\mathrm d\psi}{\mathrm d\alpha}", r"slope of $\psi$ near rest", "1", "eq-142";
    c = "c", "c", "constant of the approach to rest", "1", "eq-143";
    a_slope = "(dA/dα)", r"\frac{\mathrm dA}{\mathrm d\alpha}", "slope of $A$ near rest", "1", "eq-144";
}
