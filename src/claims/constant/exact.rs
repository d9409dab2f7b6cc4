//! Constant acceleration, exactly: proofs of (6) to (20) from Newton's law (1).
//!
//! Only Newton's law with A = −A x̂ and v = v (cos θ, sin θ) is entered here; the printed formulas come from
//! [`crate::paper::constant`], as trees. All holds for 0 < θ, θ₀ < π, where tan(θ/2) is positive.

use crate::corrections;
use crate::exact::{Derivation, ExactError, Expr, Obstacle, Proof, Prover, Rational, Ring};
use crate::paper::constant as paper;
use crate::scalar::Scalar;

/// A printed formula and the way to prove it.
#[derive(Debug, Clone, Copy)]
pub struct Statement {
    /// Id of the claim; `corrected-11` for a correction.
    pub id: &'static str,
    /// The formula.
    pub printed: fn() -> Expr,
    /// Tries to prove what the claim says of a formula that stands in the printed one's place.
    pub prove: fn(Expr) -> Proof,
    /// Which friction it is about.
    pub friction: Friction,
    /// True if the claim only says that the formula keeps its value.
    pub invariant: bool,
}

impl Statement {
    /// The proof of the formula as it stands.
    pub fn proof(&self) -> Proof {
        (self.prove)((self.printed)())
    }
}

/// The friction λ of a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Friction {
    /// Any λ; (tan θ/2)^λ is a generator.
    Any,
    /// λ > 1; (tan θ/2)^(λ−1), which tends to 0 with θ, is a generator.
    BeyondOne,
    /// λ = 0.
    Zero,
    /// λ = 1; ln tan(θ/2) is a generator.
    One,
}

/// All statements of section 2.1 that are proved.
pub const STATEMENTS: &[Statement] = &[
    statement("eq-6", eq6, prove_eq6, Friction::Any),
    statement("eq-7", eq7, prove_eq7, Friction::Any),
    statement("eq-8", eq8, prove_eq8, Friction::Any),
    statement("eq-9", eq9, prove_eq9, Friction::Any),
    invariant("eq-10", eq10, prove_eq10, Friction::Any),
    statement("eq-11", eq11, prove_eq11, Friction::Any),
    statement("eq-12", eq12, prove_eq12, Friction::Any),
    statement("eq-13", eq13, prove_eq13, Friction::Any),
    statement("eq-14", eq14, prove_eq14, Friction::Any),
    statement("eq-15", eq15, prove_eq15, Friction::Zero),
    statement("eq-16", eq16, prove_eq16, Friction::Zero),
    invariant("eq-17", eq17, prove_eq17, Friction::One),
    statement("eq-18", eq18, prove_eq18, Friction::One),
    statement("eq-19", eq19, prove_eq19, Friction::One),
    statement("eq-20", eq20, prove_eq20, Friction::BeyondOne),
    statement(
        "corrected-11",
        corrected_speed,
        prove_corrected_speed,
        Friction::Any,
    ),
];

/// The proof of the formula with this id.
pub fn proof(id: &str) -> Option<Proof> {
    STATEMENTS.iter().find(|s| s.id == id).map(Statement::proof)
}

const fn statement(
    id: &'static str,
    printed: fn() -> Expr,
    prove: fn(Expr) -> Proof,
    friction: Friction,
) -> Statement {
    Statement {
        id,
        printed,
        prove,
        friction,
        invariant: false,
    }
}

const fn invariant(
    id: &'static str,
    printed: fn() -> Expr,
    prove: fn(Expr) -> Proof,
    friction: Friction,
) -> Statement {
    Statement {
        invariant: true,
        ..statement(id, printed, prove, friction)
    }
}

/// Newton's law in a ring.
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
    fn new(friction: Friction) -> Result<Self, ExactError> {
        let mut ring = Ring::new();
        let [a, v] = ["A", "v"].map(|name| ring.symbol(name));
        for name in ["v₀", "v₀x", "v₀y", "t"] {
            ring.symbol(name);
        }
        for name in ["θ", "θ₀"] {
            ring.angle(name);
        }
        let tangents = [ring.half_tangent("θ")?, ring.half_tangent("θ₀")?];
        match friction {
            Friction::Any => {
                let lambda = ring.symbol("λ");
                for u in &tangents {
                    ring.power(u, &lambda)?;
                }
            }
            Friction::BeyondOne => {
                let excess = ring.symbol("λ") - Rational::int(1);
                for u in &tangents {
                    ring.power(u, &excess)?;
                }
            }
            Friction::Zero => ring.define("λ", Rational::int(0))?,
            Friction::One => {
                ring.define("λ", Rational::int(1))?;
                for u in &tangents {
                    ring.logarithm(u)?;
                }
            }
        }
        let theta = Expr::symbol("θ");
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
        let theta = Expr::symbol("θ");
        let half = theta / Expr::int(2);
        let (angle, u) = (self.ring.read(theta)?, self.ring.half_tangent("θ")?);
        let h = self.ring.read(half.cos())?;
        let mut values = vec![(&angle, &zero), (&u, &zero), (&h, &one)];
        let power = half.tan().pow(Expr::symbol("λ") - Expr::int(1));
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
    friction: Friction,
    steps: impl FnOnce(&mut Prover<'_>, &Newton) -> Result<(), Obstacle>,
) -> Proof {
    match Newton::new(friction) {
        Err(error) => Proof::impossible(title, error),
        Ok(newton) => Proof::of(title, &newton.ring, |p| {
            let ring = p.ring();
            match friction {
                Friction::Any => p.note("Friction", "any λ = μg/A"),
                Friction::BeyondOne => p.note("Friction", "λ > 1"),
                Friction::Zero => p.note("Friction", "λ = 0"),
                Friction::One => p.note("Friction", "λ = 1"),
            }
            p.note("dv/dt by (1), along v", ring.text(&newton.speed_rate));
            p.note("dθ/dt by (1), across v", ring.text(&newton.angle_rate));
            steps(p, &newton)
        }),
    }
}

fn symbols<const N: usize>(names: [&'static str; N]) -> [Expr; N] {
    names.map(Expr::symbol)
}

fn at_start(formula: Expr) -> Expr {
    formula.with("θ", Expr::symbol("θ₀"))
}

fn eq6() -> Expr {
    let [lambda, a, theta] = symbols(["λ", "A", "θ"]);
    paper::eq6_vx_rate(lambda, a, theta)
}

fn prove_eq6(printed: Expr) -> Proof {
    prove("(6): d(v cos θ)/dt", Friction::Any, |p, newton| {
        let [v, theta] = symbols(["v", "θ"]);
        let vx = p.read("The component along x", v * theta.cos())?;
        let rate = p.derivative("Its rate by (1)", &vx, &newton.motion)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

fn eq7() -> Expr {
    let [lambda, a, theta] = symbols(["λ", "A", "θ"]);
    paper::eq7_vy_rate(lambda, a, theta)
}

fn prove_eq7(printed: Expr) -> Proof {
    prove("(7): d(v sin θ)/dt", Friction::Any, |p, newton| {
        let [v, theta] = symbols(["v", "θ"]);
        let vy = p.read("The component along y", v * theta.sin())?;
        let rate = p.derivative("Its rate by (1)", &vy, &newton.motion)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

fn eq8() -> Expr {
    let [lambda, theta] = symbols(["λ", "θ"]);
    paper::eq8_hodograph_slope(lambda, theta)
}

fn prove_eq8(printed: Expr) -> Proof {
    prove(
        "(8): d(v sin θ)/d(v cos θ)",
        Friction::Any,
        |p, newton| {
            let [v, theta] = symbols(["v", "θ"]);
            let [vx, vy] = [v * theta.cos(), v * theta.sin()].map(|c| newton.ring.read(c));
            let x = p.derivative("d(v cos θ)/dt by (1)", &vx?, &newton.motion)?;
            let y = p.derivative("d(v sin θ)/dt by (1)", &vy?, &newton.motion)?;
            let slope = p.quotient("Their quotient", &y, &x)?;
            let printed = p.read("The printed slope", printed)?;
            p.equal("Quotient against printed slope", &slope, &printed)
        },
    )
}

fn eq9() -> Expr {
    let [lambda, theta] = symbols(["λ", "θ"]);
    paper::eq9_log_speed_rate(lambda, theta)
}

/// d ln v/dθ by (1).
fn log_speed_rate(p: &mut Prover<'_>, newton: &Newton) -> Result<Rational, Obstacle> {
    let growth = newton.ring.divide(&newton.speed_rate, &newton.v)?;
    p.quotient("(dv/v)/dθ by (1)", &growth, &newton.angle_rate)
}

fn prove_eq9(printed: Expr) -> Proof {
    prove("(9): (dv/v)/dθ", Friction::Any, |p, newton| {
        let rate = log_speed_rate(p, newton)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

fn eq10() -> Expr {
    let [lambda, v, theta] = symbols(["λ", "v", "θ"]);
    paper::eq10_invariant(lambda, v, theta)
}

fn constant_of_motion(p: &mut Prover<'_>, newton: &Newton, formula: Expr) -> Result<(), Obstacle> {
    let value = p.read("The printed expression", formula)?;
    let constant = value.generators().all(|g| {
        let own = Rational::generator(g);
        let rate = p.ring().derivative(&own, &newton.motion);
        rate.is_ok_and(|rate| rate.is_literally_zero())
    });
    if constant {
        // A number keeps its value along any motion: that would say nothing about this one.
        let normal_form = p.ring().text(&value);
        let says = "It must depend on the state of motion".into();
        return Err(Obstacle::NotZero { says, normal_form });
    }
    let rate = p.derivative("Its rate by (1)", &value, &newton.motion)?;
    p.zero("The rate", &rate)
}

fn prove_eq10(printed: Expr) -> Proof {
    prove(
        "(10): an expression keeps its value",
        Friction::Any,
        |p, newton| constant_of_motion(p, newton, printed),
    )
}

fn eq11() -> Expr {
    let [lambda, v0, theta0, theta] = symbols(["λ", "v₀", "θ₀", "θ"]);
    paper::eq11_speed(lambda, v0, theta0, theta)
}

fn prove_eq11(printed: Expr) -> Proof {
    prove("(11): the speed at angle θ", Friction::Any, |p, newton| {
        let expected = log_speed_rate(p, newton)?;
        let speed = p.read("The printed speed", printed)?;
        let slope = p.derivative(
            "Its derivative with respect to θ",
            &speed,
            &p.ring().by("θ")?,
        )?;
        let rate = p.quotient("Divided by itself", &slope, &speed)?;
        p.equal("Against (dv/v)/dθ by (1)", &rate, &expected)?;
        let start = p.read("At θ = θ₀", at_start(printed))?;
        p.equal("Against v₀", &start, &p.ring().named("v₀")?)
    })
}

fn eq12() -> Expr {
    let [lambda, v0, theta0, theta, d_power] = symbols(["λ", "v₀", "θ₀", "θ", "D"]);
    paper::eq12_time_rate(lambda, v0, theta0, theta, d_power)
}

fn prove_eq12(printed: Expr) -> Proof {
    let title = "(12): A dt/dθ";
    let with_power = || {
        let mut newton = Newton::new(Friction::Any)?;
        let power = (Expr::symbol("θ") / Expr::int(2))
            .tan()
            .pow(Expr::symbol("λ"));
        let power = newton.ring.read(power)?;
        let slope = newton.ring.derivative(&power, &newton.ring.by("θ")?)?;
        newton.ring.define("D", slope)?;
        Ok(newton)
    };
    let newton = match with_power() {
        Ok(newton) => newton,
        Err(error) => return Proof::impossible(title, error),
    };
    Proof::of(title, &newton.ring, |p| {
        p.rests_on(&prove_eq11(eq11()))?;
        let speed = p.read("The speed", eq11())?;
        let rate = newton.time_rate(&speed)? * p.ring().named("A")?;
        p.note("A dt/dθ by (1), with that speed", p.ring().text(&rate));
        p.read("D, the derivative of tan(θ/2)^λ", Expr::symbol("D"))?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

fn eq13() -> Expr {
    let [lambda, a, v0, theta0, theta] = symbols(["λ", "A", "v₀", "θ₀", "θ"]);
    paper::eq13_time(lambda, a, v0, theta0, theta)
}

fn prove_eq13(printed: Expr) -> Proof {
    prove("(13): the time at angle θ", Friction::Any, |p, newton| {
        p.rests_on(&prove_eq11(eq11()))?;
        let speed = p.read("The speed", eq11())?;
        let expected = newton.time_rate(&speed)?;
        p.note("dt/dθ by (1), with that speed", p.ring().text(&expected));
        let time = p.read("The printed time", printed)?;
        let rate = p.derivative(
            "Its derivative with respect to θ",
            &time,
            &p.ring().by("θ")?,
        )?;
        p.equal("Against dt/dθ by (1)", &rate, &expected)?;
        let start = p.read("At θ = θ₀", at_start(printed))?;
        p.zero("The printed time at the start", &start)
    })
}

fn eq14() -> Expr {
    let [lambda, a, v0, theta0, theta, t] = symbols(["λ", "A", "v₀", "θ₀", "θ", "t"]);
    paper::eq14_speed_at_time(lambda, a, v0, theta0, theta, t)
}

fn prove_eq14(printed: Expr) -> Proof {
    prove(
        "(14): the speed at angle θ and time t",
        Friction::Any,
        |p, _| {
            p.rests_on(&prove_eq11(eq11()))?;
            p.rests_on(&prove_eq13(eq13()))?;
            let found = p.read(
                "The printed speed, with t from (13)",
                printed.with("t", eq13()),
            )?;
            let speed = p.read("The speed by (11)", eq11())?;
            p.equal("The two", &found, &speed)
        },
    )
}

fn eq15() -> Expr {
    let [a, v0x, t] = symbols(["A", "v₀x", "t"]);
    paper::eq15_vx(a, v0x, t)
}

/// A component of the velocity as a function of time: its rate by (1), and its value at the start.
fn component(
    p: &mut Prover<'_>,
    newton: &Newton,
    [component, start, printed]: [Expr; 3],
) -> Result<(), Obstacle> {
    let component = p.read("The component", component)?;
    let expected = p.derivative("Its rate by (1)", &component, &newton.motion)?;
    let value = p.read("As printed", printed)?;
    let rate = p.derivative("The rate of that", &value, &p.ring().by("t")?)?;
    p.equal("Rate by (1) against printed rate", &expected, &rate)?;
    let at_start = p.read("At t = 0", printed.with("t", Expr::int(0)))?;
    p.equal("Against the start", &at_start, &p.ring().read(start)?)
}

fn prove_eq15(printed: Expr) -> Proof {
    prove("(15): v_x without friction", Friction::Zero, |p, newton| {
        let [v, theta, start] = symbols(["v", "θ", "v₀x"]);
        component(p, newton, [v * theta.cos(), start, printed])
    })
}

fn eq16() -> Expr {
    paper::eq16_vy(Expr::symbol("v₀y"))
}

fn prove_eq16(printed: Expr) -> Proof {
    prove("(16): v_y without friction", Friction::Zero, |p, newton| {
        let [v, theta, start] = symbols(["v", "θ", "v₀y"]);
        component(p, newton, [v * theta.sin(), start, printed])
    })
}

fn eq17() -> Expr {
    let [v, theta] = symbols(["v", "θ"]);
    paper::eq17_invariant(v, theta)
}

fn prove_eq17(printed: Expr) -> Proof {
    prove(
        "(17): an expression keeps its value, λ = 1",
        Friction::One,
        |p, newton| constant_of_motion(p, newton, printed),
    )
}

fn eq18() -> Expr {
    let [v0, theta0] = symbols(["v₀", "θ₀"]);
    paper::eq18_vx_limit(v0, theta0)
}

/// λ = 1: the speed, after a proof that θ reaches 0 at no finite time.
fn late_speed(p: &mut Prover<'_>, newton: &Newton) -> Result<Expr, Obstacle> {
    let [lambda, v0, theta0, theta, a] = symbols(["λ", "v₀", "θ₀", "θ", "A"]);
    p.rests_on(&prove_eq11(eq11()))?;
    let speed = paper::eq11_speed(lambda, v0, theta0, theta);
    let read = p.read("The speed by (11)", speed)?;
    let two = Expr::int(2);
    let (half, half0) = (theta / two, theta0 / two);
    let r = half.tan() / half0.tan();
    let time = v0 / a
        * (half0.sin().squared() * (Expr::int(1) - r.squared()) / two
            - half0.cos().squared() * r.ln());
    let time = p.read("The time at angle θ is", time)?;
    let rate = p.derivative("for its derivative", &time, &p.ring().by("θ")?)?;
    p.equal("is dt/dθ by (1)", &rate, &newton.time_rate(&read)?)?;
    p.note(
        "For θ → 0 it grows beyond bounds",
        "−ln tan(θ/2) → ∞, all else stays finite",
    );
    Ok(speed)
}

fn prove_eq18(printed: Expr) -> Proof {
    prove(
        "(18): v_x at large times, λ = 1",
        Friction::One,
        |p, newton| {
            let speed = late_speed(p, newton)?;
            let vx = p.read("v_x", speed * Expr::symbol("θ").cos())?;
            let limit = newton.at_zero_angle(&vx)?;
            p.note("For θ → 0", p.ring().text(&limit));
            let printed = p.read("The printed limit", printed)?;
            p.equal("The two", &limit, &printed)
        },
    )
}

fn eq19() -> Expr {
    paper::eq19_vy_limit()
}

fn prove_eq19(printed: Expr) -> Proof {
    prove(
        "(19): v_y at large times, λ = 1",
        Friction::One,
        |p, newton| {
            let speed = late_speed(p, newton)?;
            let vy = p.read("v_y", speed * Expr::symbol("θ").sin())?;
            let limit = newton.at_zero_angle(&vy)?;
            p.note("For θ → 0", p.ring().text(&limit));
            let printed = p.read("The printed limit", printed)?;
            p.equal("The two", &limit, &printed)
        },
    )
}

fn eq20() -> Expr {
    let [lambda, a, v0, theta0] = symbols(["λ", "A", "v₀", "θ₀"]);
    paper::eq20_stop_time(lambda, a, v0, theta0)
}

fn prove_eq20(printed: Expr) -> Proof {
    prove(
        "(20): the time at which the particle stops",
        Friction::BeyondOne,
        |p, newton| {
            p.rests_on(&prove_eq11(eq11()))?;
            p.rests_on(&prove_eq13(eq13()))?;
            let speed = p.read("The speed by (11)", eq11())?;
            p.zero("For θ → 0 the speed", &newton.at_zero_angle(&speed)?)?;
            let time = p.read("The time by (13)", eq13())?;
            let stop = newton.at_zero_angle(&time)?;
            p.note("For θ → 0", p.ring().text(&stop));
            let printed = p.read("The printed time", printed)?;
            p.equal("The two", &stop, &printed)
        },
    )
}

fn corrected_speed() -> Expr {
    let [lambda, v0, theta0, theta] = symbols(["λ", "v₀", "θ₀", "θ"]);
    let half_tan = |angle: Expr| (angle / Expr::int(2)).tan();
    corrections::constant::speed(lambda, v0, theta0, half_tan(theta) / half_tan(theta0))
}

fn prove_corrected_speed(corrected: Expr) -> Proof {
    prove(
        "The speed in powers of r = tan(θ/2)/tan(θ₀/2)",
        Friction::Any,
        |p, newton| {
            let expected = log_speed_rate(p, newton)?;
            let speed = p.read("The speed", corrected)?;
            let slope = p.derivative(
                "Its derivative with respect to θ",
                &speed,
                &p.ring().by("θ")?,
            )?;
            let rate = p.quotient("Divided by itself", &slope, &speed)?;
            p.equal("Against (dv/v)/dθ by (1)", &rate, &expected)?;
            let start = p.read("At θ = θ₀", at_start(corrected))?;
            p.equal("Against v₀", &start, &p.ring().named("v₀")?)?;
            let printed = p.read("The speed by (11)", eq11())?;
            p.equal("The two", &speed, &printed)
        },
    )
}

#[cfg(test)]
mod tests;
