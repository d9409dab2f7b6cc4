//! The laws themselves: (59) from the laboratory, (60) from the sphere's parts.

use super::{AXES, Vectorial};
use crate::claims::sphere::prelude::*;
use crate::paper::sphere as paper;

type Vector = [Rational; 3];

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn sum(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}

attempts![
    // In the laboratory the centre is at X + r, and F alone acts: m d²(X + r)/dt² = F.
    &EQ59 = Vectorial::new(
        Printed,
        Compared::one(
            "the formula",
            "Newton's law in the laboratory, where friction alone acts",
        ),
        || {
            let [m, ax, ay, fx, fy] = symbols(["m", "A_x", "A_y", "F_x", "F_y"]);
            let zero = int(0);
            paper::eq59_momentum_rate(m, [ax, ay, zero], [fx, fy, zero]).into()
        },
        |printed| {
            let title = "(59): m d²r/dt²";
            let laboratory = || -> Result<_, ExactError> {
                let mut ring = Ring::new();
                let m = ring.symbol("m");
                let mut rates = Vec::new();
                let mut own = Vec::new();
                for (place, velocity, inside, a, f) in [
                    ("r_x", "v_x", "a_x", "A_x", "F_x"),
                    ("r_y", "v_y", "a_y", "A_y", "F_y"),
                ] {
                    let [_, velocity_now, inside_now, a_now] =
                        [place, velocity, inside, a].map(|name| ring.symbol(name));
                    let (x, u) = if place == "r_x" {
                        ("X", "U_x")
                    } else {
                        ("Y", "U_y")
                    };
                    let [_, u_now] = [x, u].map(|name| ring.symbol(name));
                    rates.push((place, velocity_now));
                    rates.push((velocity, inside_now.clone()));
                    rates.push((x, u_now));
                    rates.push((u, a_now));
                    own.push((x, place, f, &m * &inside_now));
                }
                let motion = ring.along(&rates)?;
                let mut momentum_rates = Vec::new();
                for (x, place, f, momentum_rate) in own {
                    let place = ring.named(x)? + ring.named(place)?;
                    let once = ring.derivative(&place, &motion)?;
                    let twice = ring.derivative(&once, &motion)?;
                    ring.define(f, &m * &twice)?;
                    momentum_rates.push(momentum_rate);
                }
                momentum_rates.push(Rational::int(0));
                Ok((ring, momentum_rates))
            };
            let (ring, own) = match laboratory() {
                Ok(both) => both,
                Err(error) => return Proof::impossible(title, error),
            };
            Proof::of(title, &ring, |p| {
                for ((axis, own), printed) in AXES.iter().zip(own).zip(printed) {
                    p.note("m d²r/dt²", p.ring().text(&own));
                    p.reads_as(&own, &format!("Printed {axis}"), printed)?;
                }
                Ok(())
            })
        },
    ),
    // Six equal point masses on three axes turn as one body. Newton's law for each, times its lever, summed: the forces
    // between them and their weights drop out, and what is left is the torque of F and N at the contact.
    &EQ60 = Vectorial::new(
        Printed,
        Compared::one(
            "the formula",
            "Newton's law for six point masses that move as one body",
        ),
        || {
            let [fx, fy] = symbols(["F_x", "F_y"]);
            let contact = paper::eq61_contact::tree();
            paper::eq60_spin_rate(contact, [fx, fy, int(0)]).into()
        },
        |printed| {
            let title = "(60): I dω/dt";
            let mut ring = Ring::new();
            let [m, arm, radius, normal] = ring.symbols(["m", "a", "R", "N"]);
            let vector =
                |ring: &mut Ring, names: [&'static str; 3]| names.map(|name| ring.symbol(name));
            let omega = vector(&mut ring, ["ω_x", "ω_y", "ω_z"]);
            let alpha = vector(&mut ring, ["α_x", "α_y", "α_z"]);
            let [ax, ay, fx, fy] = ring.symbols(["A_x", "A_y", "F_x", "F_y"]);
            let zero = || Rational::int(0);
            let each = match ring.divide(&m, &Rational::int(6)) {
                Ok(each) => each,
                Err(error) => return Proof::impossible(title, error),
            };
            let (mut spin_rate, mut inertial) =
                ([zero(), zero(), zero()], [zero(), zero(), zero()]);
            for axis in 0..3 {
                for way in [1, -1] {
                    let mut place = [zero(), zero(), zero()];
                    place[axis] = &arm * &Rational::int(way);
                    let turning = cross(&omega, &cross(&omega, &place));
                    let acceleration = sum(&cross(&alpha, &place), &turning);
                    let pull = [
                        &each * &acceleration[0],
                        &each * &acceleration[1],
                        &each * &acceleration[2],
                    ];
                    spin_rate = sum(&spin_rate, &cross(&place, &pull));
                    let push = [-(&each * &ax), -(&each * &ay), zero()];
                    inertial = sum(&inertial, &cross(&place, &push));
                }
            }
            let contact = [zero(), zero(), -radius];
            let torque = sum(&cross(&contact, &[fx, fy, normal]), &inertial);
            Proof::of(title, &ring, |p| {
                // Their moment of inertia about any axis: four of them at the distance a.
                let inertia = Rational::int(4) * &each * arm.pow(2);
                p.note("Moment of inertia", p.ring().text(&inertia));
                for i in 0..3 {
                    p.note("Σ r × (m/6) d²r/dt²", p.ring().text(&spin_rate[i]));
                    p.equal(
                        &format!("That is I α {}", AXES[i]),
                        &spin_rate[i],
                        &(&inertia * &alpha[i]),
                    )?;
                    let printed = p.read(&format!("Printed {}", AXES[i]), printed[i])?;
                    p.equal(
                        "It is the torque of F, N and the inertial forces",
                        &torque[i],
                        &printed,
                    )?;
                }
                Ok(())
            })
        },
    ),
];
