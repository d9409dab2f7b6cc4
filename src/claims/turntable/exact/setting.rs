//! The rings in which the proofs are carried out, each with the motion in it.

use super::vectors;
use crate::claims::turntable::prelude::*;
use crate::paper::turntable as paper;

#[derive(Debug)]
pub(crate) struct Setting {
    pub ring: Ring,
    /// The rate of change along the motion.
    pub motion: Derivation,
    /// In words.
    pub law: &'static str,
}

impl Setting {
    /// 𝐫 = (x, y), d𝐫/dt = (u, v), in lengths and times, with the angle φ by which the table has turned and the
    /// arc length s; the motion is that of (86).
    pub(crate) fn dimensional() -> Result<Self, ExactError> {
        let mut ring = plain();
        ring.symbols(["Ω", "μ", "g", "m", "s"]);
        ring.angle("φ");
        let [r, v] = vectors();
        let [omega, mu, g] = symbols(["Ω", "μ", "g"]);
        root_of_speed(&mut ring)?;
        // Ω, μ and g are positive.
        let unit = ring.read(omega / (mu * g))?;
        ring.root_is(&(&unit * &unit), 2, &unit)?;
        let [ax, ay] = paper::eq86_acceleration(omega, mu, g, r, v).map(|c| ring.read(c));
        let motion = ring.along(&[
            ("x", ring.named("u")?),
            ("y", ring.named("v")?),
            ("u", ax?),
            ("v", ay?),
            ("φ", ring.named("Ω")?),
            ("s", ring.read((v[0].squared() + v[1].squared()).sqrt())?),
        ])?;
        Ok(Setting {
            ring,
            motion,
            law: "(86); the speed is the positive root of u² + v², the angle φ grows as Ωt",
        })
    }

    /// 𝛒 = (x, y), d𝛒/dτ = (u, v); the motion is that of (89).
    pub(crate) fn cartesian() -> Result<Self, ExactError> {
        let mut ring = plain();
        root_of_speed(&mut ring)?;
        let [position, rate] = vectors();
        let [ax, ay] = paper::eq89_acceleration(position, rate).map(|c| ring.read(c));
        let motion = ring.along(&[
            ("x", ring.named("u")?),
            ("y", ring.named("v")?),
            ("u", ax?),
            ("v", ay?),
        ])?;
        Ok(Setting {
            ring,
            motion,
            law: "(89); the speed p is the positive root of u² + v²",
        })
    }

    /// The velocity has the size p and the direction χ, the position the size ρ and the direction χ + ψ.
    pub(crate) fn polar() -> Result<Self, ExactError> {
        let mut ring = Ring::of(["p", "ρ", "s"]);
        let Rates { p, rho, psi, chi } = rates(&mut ring)?;
        let speed = ring.named("p")?;
        let motion = ring.along(&[
            ("p", p.clone()),
            ("ρ", rho),
            ("ψ", psi),
            ("χ", chi),
            ("s", speed),
        ])?;
        let [ell, xi] = [ring.named("ℓ")?, ring.named("ξ")?];
        let ell = ring.derivative(&ell, &motion)?;
        let xi = ring.derivative(&xi, &motion)?;
        for (name, rate) in [("dℓ/dτ", ell), ("dξ/dτ", xi), ("dp/dτ", p)] {
            ring.define(name, rate)?;
        }
        Ok(Setting {
            ring,
            motion,
            law: "(89), with velocity p (cos χ, sin χ) and position ρ (cos(χ + ψ), sin(χ + ψ))",
        })
    }

    /// The same with p and ρ by (111) and (112).
    pub(crate) fn slower() -> Result<Self, ExactError> {
        let [p, rho] = [paper::eq111_p::tree(), paper::eq112_rho::tree()];
        let law = "(89), with (111) and (112)";
        Self::hyperbolic(["A", "α"], [p, rho], law, |[p, rho]| [rho, p])
    }

    /// The same with p and ρ by (117) and (118).
    pub(crate) fn faster() -> Result<Self, ExactError> {
        let [p, rho] = [paper::eq117_p::tree(), paper::eq118_rho::tree()];
        let law = "(89), with (117) and (118)";
        Self::hyperbolic(["B", "β"], [p, rho], law, |[p, rho]| [p, rho])
    }

    /// With p and ρ by a size and an angle: the greater of the two, which `order` puts first, is the size times the angle's
    /// hyperbolic cosine, the other one that times its sine.
    fn hyperbolic(
        [size, angle]: [&'static str; 2],
        formulas: [Expr; 2],
        law: &'static str,
        order: fn([Rational; 2]) -> [Rational; 2],
    ) -> Result<Self, ExactError> {
        let mut ring = Ring::new();
        let own = ring.symbol(size);
        let argument = ring.hyperbolic(angle);
        ring.suppose_positive(own.clone());
        ring.suppose_positive(argument);
        for (name, formula) in ["p", "ρ"].into_iter().zip(formulas) {
            let value = ring.read(formula)?;
            ring.define(name, value)?;
        }
        let Rates { p, rho, psi, chi } = rates(&mut ring)?;
        let [more, less] = order([p, rho]);
        let angle_itself = symbol(angle);
        let [sinh, cosh] = [angle_itself.sinh(), angle_itself.cosh()].map(|f| ring.read(f));
        let [sinh, cosh] = [sinh?, cosh?];
        // The size grows by cosh times the rate of the greater less sinh times that of the other.
        let size_rate = &more * &cosh - &less * &sinh;
        let angle_rate = ring.divide(&(&less * &cosh - &more * &sinh), &own)?;
        let motion = ring.along(&[
            (size, size_rate),
            (angle, angle_rate),
            ("ψ", psi),
            ("χ", chi),
        ])?;
        Ok(Setting { ring, motion, law })
    }

    /// A, α, B, β and ψ, with the eighth root of unity ζ and i = ζ²; no motion.
    pub(crate) fn continued() -> Result<Self, ExactError> {
        let mut ring = Ring::new();
        let zeta = ring.root(&Rational::int(-1), 4)?;
        ring.define("ζ", zeta.clone())?;
        ring.define("i", &zeta * &zeta)?;
        ring.symbols(["A", "B"]);
        for name in ["α", "β"] {
            ring.hyperbolic(name);
        }
        ring.angle("ψ");
        Ok(Setting {
            ring,
            motion: Derivation::default(),
            law: "none; the imaginary unit i is a root of i² = −1, ζ one of ζ² = i",
        })
    }

    /// α and the angles ψ and q, where q is to be the arcsine of something; no motion.
    pub(crate) fn fixed() -> Result<Self, ExactError> {
        let mut ring = Ring::new();
        ring.hyperbolic("α");
        for name in ["ψ", "q"] {
            ring.angle(name);
        }
        let double = 2 * symbol("α");
        let [tanh, cosh] = [ring.read(double.tanh())?, ring.read(double.cosh())?];
        let one = Rational::int(1);
        let cosine = ring.divide(&one, &cosh)?;
        ring.root_is(&ring.normal(&(&one - &tanh * &tanh)), 2, &cosine)?;
        Ok(Setting {
            ring,
            motion: Derivation::default(),
            law: "none; α is held fixed",
        })
    }
}

/// With x, y, u, v.
fn plain() -> Ring {
    Ring::of(["x", "y", "u", "v"])
}

/// Declares the positive root of u² + v².
fn root_of_speed(ring: &mut Ring) -> Result<(), ExactError> {
    let [_, [u, v]] = vectors();
    let squared = ring.read(u.squared() + v.squared())?;
    ring.root(&squared, 2)?;
    Ok(())
}

/// The rates of p, ρ, ψ, χ by (89).
struct Rates {
    p: Rational,
    rho: Rational,
    psi: Rational,
    chi: Rational,
}

/// In a ring in which p and ρ have a meaning: gives x, y, u, v, ξ, ℓ theirs, and finds the rates.
fn rates(ring: &mut Ring) -> Result<Rates, ExactError> {
    for name in ["ψ", "χ"] {
        ring.angle(name);
    }
    let [p_tree, rho_tree, psi, chi] = symbols(["p", "ρ", "ψ", "χ"]);
    let outwards = chi + psi;
    for (name, formula) in [
        ("x", rho_tree * outwards.cos()),
        ("y", rho_tree * outwards.sin()),
        ("u", p_tree * chi.cos()),
        ("v", p_tree * chi.sin()),
        ("ξ", paper::eq94_xi::tree()),
        ("ℓ", paper::eq95_ell::tree()),
    ] {
        let value = ring.read(formula)?;
        ring.define(name, value)?;
    }
    let (p, rho) = (ring.named("p")?, ring.named("ρ")?);
    ring.root_is(&ring.normal(&(&p * &p)), 2, &p)?;
    let [position, rate] = vectors();
    let [ax, ay] = paper::eq89_acceleration(position, rate).map(|c| ring.read(c));
    let (ax, ay) = (ax?, ay?);
    let read = |formula: Expr| ring.read(formula);
    let (c, s) = (read(chi.cos())?, read(chi.sin())?);
    let (co, so) = (read(outwards.cos())?, read(outwards.sin())?);
    let (u, v) = (ring.named("u")?, ring.named("v")?);
    let chi_rate = ring.divide(&(&ay * &c - &ax * &s), &p)?;
    let turning = ring.divide(&(&v * &co - &u * &so), &rho)?;
    Ok(Rates {
        p: ring.normal(&(&ax * &c + &ay * &s)),
        rho: ring.normal(&(&u * &co + &v * &so)),
        psi: ring.normal(&(turning - &chi_rate)),
        chi: chi_rate,
    })
}
