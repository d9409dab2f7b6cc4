//! The law of motion in the two frames and without dimensions, (86) and (89); its projections (90) to (92); its
//! mirror image.

use super::{Setting, Vectorial, prove, vectors};
use crate::claims::turntable::prelude::*;
use crate::paper::turntable as paper;

fn eq86() -> Vec<Expr> {
    let [omega, mu, g] = symbols(["Ω", "μ", "g"]);
    let [r, v] = vectors();
    paper::eq86_acceleration(omega, mu, g, r, v).into()
}

/// The second derivative of a position in the laboratory, X = (x cos φ − y sin φ, x sin φ + y cos φ), if (u, v)
/// has the given rates, against friction alone.
fn prove_eq86(printed: Vec<Expr>) -> Proof {
    let title = "(86): friction alone acts in the laboratory";
    prove(title, Setting::dimensional(), |p, _| {
        let ring = p.ring();
        let [ax, ay] = [0, 1].map(|i| p.read("A component of (86)", printed[i]));
        let motion = ring.along(&[
            ("x", ring.named("u")?),
            ("y", ring.named("v")?),
            ("u", ax?),
            ("v", ay?),
            ("φ", ring.named("Ω")?),
        ])?;
        let [[x, y], [u, v]] = vectors();
        let [phi, mu, g] = symbols(["φ", "μ", "g"]);
        let speed = (u.squared() + v.squared()).sqrt();
        let seen =
            |a: Expr, b: Expr| [a * phi.cos() - b * phi.sin(), a * phi.sin() + b * phi.cos()];
        // Relative to the table the particle has the velocity (u, v); friction opposes it.
        let friction = seen(-mu * g * u / speed, -mu * g * v / speed);
        for (place, force) in seen(x, y).into_iter().zip(friction) {
            let place = p.read("A component of the position in the laboratory", place)?;
            let velocity = p.derivative("Its rate", &place, &motion)?;
            let acceleration = p.derivative("The rate of that", &velocity, &motion)?;
            let force = p.read("The friction per mass", force)?;
            p.equal(
                "The acceleration in the laboratory is that by friction",
                &acceleration,
                &force,
            )?;
        }
        Ok(())
    })
}

const SYMBOLS: Compared = Compared::one("(86) in the symbols (87) and (88)", "(89)");

pub(crate) const EQ89: Vectorial = Vectorial::new(
    Within,
    Compared::one("(89)", "(86) in the units of (87) and (88)"),
    eq89,
    |printed| {
        let title = "(89) from (86), (87) and (88)";
        without_dimensions(title, &eq87(), eq88()[0], &printed)
    },
);

fn eq87() -> Vec<Expr> {
    let [omega, mu, g] = symbols(["Ω", "μ", "g"]);
    paper::eq87_position(omega, mu, g, vectors()[0]).into()
}

/// With s for the time.
fn eq88() -> Vec<Expr> {
    let [omega, time] = symbols(["Ω", "s"]);
    vec![paper::eq88_time(omega, time)]
}

fn eq89() -> Vec<Expr> {
    let [position, rate] = vectors();
    paper::eq89_acceleration(position, rate).into()
}

/// The formulas of (89) with a position and a time for (87) and (88) and their rate for the velocity, against the second
/// rate by (86).
fn without_dimensions(title: &str, position: &[Expr], time: Expr, rates: &[Expr]) -> Proof {
    prove(title, Setting::dimensional(), |p, setting| {
        let ring = p.ring();
        let time = p.read("(88), with s for the time", time)?;
        let clock = p.slope("dτ/dt", &time, "s")?;
        let ratio = p.quotient("dτ/dt over Ω", &clock, &ring.named("Ω")?)?;
        p.reads_as(&ratio, "", int(1))?;
        // (87) is linear in 𝐫: the same factor takes d𝐫/dt to d𝛒/dt, and 1/Ω takes that to d𝛒/dτ.
        let own = vectors();
        let velocity = |place: Expr| put_vectors(place, [own[1], own[1]]) / symbol("Ω");
        let [x, y] = [position[0], position[1]];
        let state = [[x, y], [velocity(x), velocity(y)]];
        for (place, formula) in [x, y].into_iter().zip(rates) {
            let place = p.read("A component of (87)", place)?;
            let first = p.derivative("Its rate in t", &place, &setting.motion)?;
            let first = p.quotient("Its rate in τ", &first, &clock)?;
            let second = p.derivative("The rate of that in t", &first, &setting.motion)?;
            let second = p.quotient("In τ", &second, &clock)?;
            let formula = put_vectors(*formula, state);
            let formula = p.read("(89), with (87) and (88) put in", formula)?;
            p.equal("The second rate by (86) is that of (89)", &second, &formula)?;
        }
        Ok(())
    })
}

fn put_vectors(formula: Expr, [[x, y], [u, v]]: [[Expr; 2]; 2]) -> Expr {
    // By way of names that stand nowhere else, so that what is put in is not replaced again.
    let names = [("x", "x*"), ("y", "y*"), ("u", "u*"), ("v", "v*")];
    let formula = names
        .iter()
        .fold(formula, |f, (name, star)| f.with(name, symbol(star)));
    names
        .iter()
        .zip([x, y, u, v])
        .fold(formula, |f, ((_, star), value)| f.with(star, value))
}

/// Position, velocity and acceleration by (89).
fn elements(p: &mut Prover<'_>, setting: &Setting) -> Result<[[Rational; 2]; 3], Obstacle> {
    let ring = p.ring();
    let named = |names: [&str; 2]| -> Result<[Rational; 2], Obstacle> {
        Ok([ring.named(names[0])?, ring.named(names[1])?])
    };
    let (position, rate) = (named(["x", "y"])?, named(["u", "v"])?);
    let ax = p.derivative("d²x/dτ² by (89)", &rate[0], &setting.motion)?;
    let ay = p.derivative("d²y/dτ² by (89)", &rate[1], &setting.motion)?;
    Ok([position, rate, [ax, ay]])
}

fn dot(a: &[Rational; 2], b: &[Rational; 2]) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1]
}

#[track_caller]
const fn projection(
    subject: Subject,
    formulas: fn() -> Vec<Expr>,
    prove: fn(Vec<Expr>) -> Proof,
) -> Vectorial {
    let compared = Compared::one("the left side", "the right side, with (89)");
    Vectorial::new(subject, compared, formulas, prove)
}

fn sides(title: &str, printed: &[Expr], left: fn([[Rational; 2]; 3]) -> Rational) -> Proof {
    prove(title, Setting::cartesian(), |p, setting| {
        let left = left(elements(p, setting)?);
        let printed = p.read("The printed right-hand side", printed[0])?;
        p.equal("It is the left-hand side", &printed, &left)
    })
}

fn prove_mirror(printed: Vec<Expr>) -> Proof {
    let title = "(86) in the mirror y → −y";
    prove(title, Setting::dimensional(), |p, setting| {
        let [[x, y], [u, v]] = vectors();
        let [u_element, v_element] = [p.ring().named("u")?, p.ring().named("v")?];
        let ax = p.derivative("d²x/dt² by (86)", &u_element, &setting.motion)?;
        let ay = p.derivative("d²y/dt² by (86)", &v_element, &setting.motion)?;
        for (formula, mirrored) in printed.iter().zip([ax, -ay]) {
            let image = put_vectors(*formula, [[x, -y], [u, -v]]).with("Ω", -symbol("Ω"));
            let image = p.read("(86) with −Ω, at the mirrored state", image)?;
            p.equal("It is the mirrored acceleration", &image, &mirrored)?;
        }
        Ok(())
    })
}

attempts![
    &EQ86 = Vectorial::new(
        Within,
        Compared::one(
            "the acceleration in the laboratory that (86) leads to",
            "that by friction alone",
        ),
        eq86,
        prove_eq86,
    ),
    &S4_MIRROR = Vectorial::new(
        Printed,
        Compared::many(
            "the mirrored accelerations of (86)",
            r"those of (86) for $-\Omega$ at the mirrored state",
        ),
        eq86,
        prove_mirror,
    ),
    &EQ87 = Vectorial::new(Printed, SYMBOLS, eq87, |printed| {
        let title = "(86) becomes (89) with (87)";
        without_dimensions(title, &printed, eq88()[0], &eq89())
    }),
    &EQ88 = Vectorial::new(Printed, SYMBOLS, eq88, |printed| {
        let title = "(86) becomes (89) with (88)";
        without_dimensions(title, &eq87(), printed[0], &eq89())
    }),
    &EQ89,
    &EQ90 = projection(
        Printed,
        || {
            let [position, rate] = vectors();
            vec![paper::eq90_power(position, rate)]
        },
        |printed| sides("(90) from (89)", &printed, |[_, rate, a]| dot(&rate, &a)),
    ),
    &EQ91 = projection(
        Within,
        || {
            let [position, rate] = vectors();
            vec![paper::eq91_moment(position, rate)]
        },
        |printed| {
            sides("(91) from (89)", &printed, |[[x, y], _, [ax, ay]]| {
                &x * &ay - &y * &ax
            })
        },
    ),
    &EQ92 = projection(
        Within,
        || {
            let [position, rate] = vectors();
            vec![paper::eq92_virial(position, rate)]
        },
        |printed| {
            sides("(92) from (89)", &printed, |[position, rate, a]| {
                dot(&position, &a) + dot(&rate, &rate)
            })
        },
    ),
];
