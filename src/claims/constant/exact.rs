//! Constant acceleration, exactly: proofs of (6) to (20) from Newton's law (1) with A = −A x̂ and v = v (cos θ, sin
//! θ).
//!
//! What needs a power or the logarithm of tan(θ/2) holds for 0 < θ, θ₀ < π, where it is positive; what needs powers
//! of the quotient of two only, for both signs of the angles.

pub(crate) mod alignment;
pub(crate) mod cases;
pub(crate) mod incline;
pub(crate) mod sliding;
#[cfg(test)]
mod tests;

use super::prelude::*;
pub use cases::*;
pub use sliding::*;

use crate::paper::constant as paper;
use crate::paper::general::eq1_velocity_rate;

/// The friction λ of a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Any λ, for what needs no power of tan θ/2.
    AnyAngle,
    /// Any λ, with the sign of both angles; (±tan θ/2)^λ is a generator.
    Any(i64),
    /// λ = 1 + e with e > 0; (tan θ/2)^e, which tends to 0 with θ, is a generator.
    BeyondOne,
    /// λ = 0.
    Zero,
    /// λ = 1, for what needs no logarithm.
    OneAnyAngle,
    /// λ = 1; ln tan(θ/2) is a generator.
    One,
}

#[track_caller]
const fn by_newton(subject: Subject, formula: fn() -> Expr, prove: fn(Expr) -> Proof) -> Statement {
    let compared = Compared::one(
        "the printed formula",
        r"Newton's law (1), as rational functions of $\tan(\theta/2)$ and its powers",
    );
    Statement::new(subject, compared, formula, prove)
}

#[derive(Debug)]
struct Newton {
    ring: Ring,
    /// The speed v, a free symbol.
    v: Rational,
    /// d/dt along the motion.
    motion: Derivation,
    /// dv/dt.
    speed_rate: Rational,
    /// dθ/dt.
    angle_rate: Rational,
}

impl Newton {
    fn new(friction: Regime) -> Result<Self, ExactError> {
        let mut ring = Ring::new();
        let [a, v] = ring.symbols(["A", "v"]);
        ring.symbols(["v₀", "t"]);
        for name in ["θ", "θ₀"] {
            ring.angle(name);
        }
        let [v0, theta0] = symbols(["v₀", "θ₀"]);
        ring.define("v₀x", ring.read(v0 * theta0.cos())?)?;
        ring.define("v₀y", ring.read(v0 * theta0.sin())?)?;
        let tangents = [ring.half_tangent("θ")?, ring.half_tangent("θ₀")?];
        match friction {
            Regime::AnyAngle => {
                ring.symbol("λ");
            }
            Regime::Any(sign) => {
                let lambda = ring.symbol("λ");
                for u in &tangents {
                    ring.power(&(u * &Rational::int(sign)), &lambda)?;
                }
            }
            Regime::BeyondOne => {
                let excess = ring.symbol("e");
                ring.define("λ", &excess + &Rational::int(1))?;
                for x in [&a, &excess] {
                    ring.suppose_positive(x.clone());
                }
                for u in &tangents {
                    ring.power(u, &excess)?;
                }
            }
            Regime::Zero => ring.define("λ", Rational::int(0))?,
            Regime::OneAnyAngle => ring.define("λ", Rational::int(1))?,
            Regime::One => {
                ring.define("λ", Rational::int(1))?;
                for u in &tangents {
                    ring.logarithm(u)?;
                }
            }
        }
        let theta = symbol("θ");
        let (vx, vy) = (&v * ring.read(theta.cos())?, &v * ring.read(theta.sin())?);
        // (1): dv/dt = −A − μg v/v, with μg = λA by (5).
        let drag = ring.divide(&(ring.named("λ")? * &a), &v)?;
        let (ax, ay) = (&a - &drag * &vx, -(&drag * &vy));
        let speed_rate = ring.divide(&(&vx * &ax + &vy * &ay), &v)?;
        let angle_rate = ring.divide(&(&vx * &ay - &vy * &ax), &(&v * &v))?;
        let motion = ring.along(&[("v", speed_rate.clone()), ("θ", angle_rate.clone())])?;
        Ok(Newton {
            ring,
            v,
            motion,
            speed_rate,
            angle_rate,
        })
    }

    /// dt/dθ where the speed is `speed`.
    fn time_rate(&self, speed: &Rational) -> Result<Rational, ExactError> {
        let rate = self.ring.put(&self.angle_rate, &[(&self.v, speed)])?;
        self.ring.divide(&Rational::int(1), &rate)
    }

    /// The limit θ → 0, in which tan(θ/2) and its positive power tend to 0.
    fn at_zero_angle(&self, x: &Rational) -> Result<Rational, ExactError> {
        let [zero, one] = [0, 1].map(Rational::int);
        let theta = symbol("θ");
        let half = theta / 2;
        let (angle, u) = (self.ring.read(theta)?, self.ring.half_tangent("θ")?);
        let h = self.ring.read(half.cos())?;
        let mut values = vec![(&angle, &zero), (&u, &zero), (&h, &one)];
        let power = half.tan().pow(symbol("λ") - 1);
        // For λ = 1 the power is 1 and needs no value of its own.
        let power = self.ring.read(power)?;
        if power.as_integer().is_none() {
            values.push((&power, &zero));
        }
        self.ring.put(x, &values)
    }
}

fn prove(
    title: &str,
    friction: Regime,
    steps: impl FnOnce(&mut Prover<'_>, &Newton) -> Result<(), Obstacle>,
) -> Proof {
    match Newton::new(friction) {
        Err(error) => Proof::impossible(title, error),
        Ok(newton) => Proof::of(title, &newton.ring, |p| {
            let ring = p.ring();
            match friction {
                Regime::AnyAngle | Regime::Any(_) => p.note("Friction", "any λ = μg/A"),
                Regime::BeyondOne => p.note("Friction", "λ = 1 + e, e > 0"),
                Regime::Zero => p.note("Friction", "λ = 0"),
                Regime::OneAnyAngle | Regime::One => p.note("Friction", "λ = 1"),
            }
            let theta = symbol("θ");
            p.read("The sine, made rational", theta.sin())?;
            p.read("The cosine, made rational", theta.cos())?;
            p.note("dv/dt by (1), along v", ring.text(&newton.speed_rate));
            p.note("dθ/dt by (1), across v", ring.text(&newton.angle_rate));
            steps(p, &newton)
        }),
    }
}

/// (3), (4), (5): two components, two components, λ.
fn definitions() -> [Expr; 5] {
    let [ax, ay] = paper::eq3_acceleration::tree();
    let [vx, vy] = paper::eq4_velocity::tree();
    [ax, ay, vx, vy, paper::eq5_lambda::tree()]
}

/// (3) to (5) by the use made of them.
/// With (3) to (5), (1) becomes (6) and (7).
pub(crate) const DEFINED: Statement<[Expr; 5]> = Statement::new(
    Printed,
    Compared::one("(1) in the symbols (3) to (5)", "(6) and (7)"),
    definitions,
    |[ax, ay, vx, vy, lambda]| {
        let title = "(6) and (7) from (1), with (3) to (5)";
        let setting = || -> Result<Ring, ExactError> {
            let mut ring = Ring::of(["A", "v", "μ", "g"]);
            ring.angle("θ");
            let v = ring.named("v")?;
            ring.root_is(&(&v * &v), 2, &v)?;
            ring.define("λ", ring.read(lambda)?)?;
            Ok(ring)
        };
        Proof::in_ring(title, setting(), |p| {
            let [lambda, mu, g] = symbols(["λ", "μ", "g"]);
            p.read("λ by (5)", lambda)?;
            let rates = eq1_velocity_rate([ax, ay], mu, g, [vx, vy]);
            let printed = [paper::eq6_vx_rate::tree(), paper::eq7_vy_rate::tree()];
            for (rate, printed) in rates.into_iter().zip(printed) {
                p.identity(
                    ("A component of (1), with (3) and (4)", rate),
                    ("by (6) or (7)", printed),
                )?;
            }
            Ok(())
        })
    },
);

fn at_start(formula: Expr) -> Expr {
    formula.with("θ", symbol("θ₀"))
}

attempts![&DEFINED];
