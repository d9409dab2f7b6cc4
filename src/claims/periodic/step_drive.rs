//! A drive in steps under which rests come, go and come again as the friction grows, exactly.
//!
//! |h| is 1 but for a short step against the push in each half period, where it is 1/6. Friction below that holds nothing. With somewhat
//! more the short step brings the particle to rest; with more still it meets a faster one, which it does not stop; and near 1 each
//! stop is early.

use super::chains::{never_part, rate, slows};
use super::exact::EQ45;
use super::prelude::*;
use crate::claims::general::contraction::never_farther_apart;
use crate::claims::general::strong_drives::MOVES;
use crate::claims::general::two_frames::eq2;

/// n/d.
type Fraction = [i64; 2];

/// A fraction that its type keeps from being negative.
type Size = [u32; 2];

fn ratio([n, d]: Fraction) -> Expr {
    int(n) / int(d)
}

fn size([n, d]: Size) -> Expr {
    ratio([n.into(), d.into()])
}

#[derive(Debug, Clone, Copy)]
struct DriveStep {
    /// As a part of the half period.
    end: Fraction,
    h: Fraction,
    /// h² less the square of 1/8.
    excess: Size,
}

/// The second half period is by (43).
const DRIVE: [DriveStep; 3] = [
    DriveStep {
        end: [3, 8],
        h: [1, 1],
        excess: [63, 64],
    },
    DriveStep {
        end: [1, 2],
        h: [-1, 6],
        excess: [7, 576],
    },
    DriveStep {
        end: [1, 1],
        h: [1, 1],
        excess: [63, 64],
    },
];

#[derive(Debug, Clone, Copy)]
enum Does {
    /// 𝔴 has this sign, and in the end this size, over π.
    Slides(i64, Size),
    /// 𝔴 = 0, and λ₀² − h² is this.
    Rests(Size),
}
use Does::{Rests, Slides};

/// Half a period of a motion, from a zero of 𝔴 on; the other half is by (45).
#[derive(Debug, Clone, Copy)]
struct Half {
    lambda0: Fraction,
    /// How many parts the half period has; phases are counted by them.
    parts: i64,
    from: i64,
    /// Up to which phase it does what, each within one step of the drive.
    stretches: &'static [(i64, Does)],
}

const HALVES: [Half; 3] = [
    Half {
        lambda0: [1, 5],
        parts: 264,
        from: 132,
        stretches: &[
            (264, Slides(1, [2, 5])),
            (352, Slides(1, [0, 1])),
            (363, Slides(-1, [1, 30])),
            (387, Slides(-1, [0, 1])),
            (396, Rests([11, 900])),
        ],
    },
    Half {
        lambda0: [1, 2],
        parts: 96,
        from: 17,
        stretches: &[
            (36, Slides(1, [19, 192])),
            (48, Slides(1, [1, 64])),
            (96, Slides(1, [17, 64])),
            (113, Slides(1, [0, 1])),
        ],
    },
    Half {
        lambda0: [2, 3],
        parts: 200,
        from: 100,
        stretches: &[
            (200, Slides(1, [1, 6])),
            (220, Slides(1, [0, 1])),
            (275, Slides(-1, [11, 120])),
            (297, Slides(-1, [0, 1])),
            (300, Rests([5, 12])),
        ],
    },
];

impl Half {
    /// h from one phase to another, if it is the same on all the way.
    fn h(&self, from: i64, until: i64) -> Result<Expr, ExactError> {
        let turn = from.div_euclid(self.parts);
        let [from, until] = [from, until].map(|phase| phase - turn * self.parts);
        let ends_by = |step: &DriveStep, phase| step.end[0] * self.parts <= phase * step.end[1];
        let step = DRIVE.iter().find(|step| !ends_by(step, from));
        let same = |step: &&DriveStep| until * step.end[1] <= step.end[0] * self.parts;
        let step = step.filter(same).ok_or_else(|| {
            ExactError::BadDeclaration(format!("h from {from} to {until} of {} parts", self.parts))
        })?;
        let h = ratio(step.h);
        Ok(if turn % 2 == 0 { h } else { printed::eq43_h(h) })
    }

    fn kind(&self) -> i64 {
        let rests = |(_, does): &(i64, Does)| matches!(does, Rests(_));
        i64::from(self.stretches.iter().any(rests))
    }
}

pub(super) const CHANGES: Statement<(Expr, Expr, [Expr; 2])> = Statement::shown(
    Printed,
    r"for the $h$ that for $0<\phi<\pi$ is $-1/6$ between $3\pi/8$ and $\pi/2$ and else 1, with (43): from every start, with any velocity across, there is no rest at $\lambda_0=1/8$, there are two rests in every late period at $1/5$, none from some time on at $1/2$, and two again at $2/3$",
    || (eq2(), rate(), printed::s23_rests()),
    |(law, rate, kinds)| changes(law, rate, kinds, HALVES),
)
.of_a_part();

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["λ₀", "D"]);
    ring.angle("ψ");
    for (name, sign) in [("𝔴", 1), ("𝔴₁", -1)] {
        let w = ring.symbol(name);
        ring.root_is(&w.pow(2), 2, &(&w * &Rational::int(sign)))?;
    }
    Ok(ring)
}

fn changes(law: Expr, rate: Expr, [little, much]: [Expr; 2], halves: [Half; 3]) -> Proof {
    Proof::in_ring("Rests that come, go and come again", ring(), |p| {
        p.rests_on(&never_part(rate))?;
        p.rests_on(&never_farther_apart())?;
        p.rests_on(&slows(law))?;
        rest_on(p, &[&MOVES, &EQ45])?;
        for step in DRIVE {
            let room = ratio(step.h).squared() - ratio([1, 8]).squared();
            p.identity(
                ("h² − λ₀² in a step", room),
                ("positive: friction is too weak", size(step.excess)),
            )?;
        }
        p.vanishes("What is stated for little friction, 0 for no rest", little)?;
        for half in &halves {
            follow(p, rate, half)?;
        }
        let seen = halves.map(|half| half.kind().to_string()).join(", ");
        p.note("Rests at these three λ₀, 1 if there are", seen);
        let [come, go, again] = halves.map(|half| int(half.kind()));
        let turns = p.read(
            "Changes among them",
            (come - go).squared() + (go - again).squared(),
        )?;
        p.reads_as(&turns, "", int(2))?;
        let stated = p.read("What is stated for much friction", much)?;
        let last = p.ring().read(again)?;
        p.equal("It is the last of the three", &stated, &last)
    })
}

/// That a half period is a motion, and that all others tend to it.
fn follow(p: &mut Prover<'_>, rate: Expr, half: &Half) -> Result<(), Obstacle> {
    let Half {
        lambda0: [n, d],
        parts,
        from,
        ..
    } = *half;
    let lambda0 = ratio([n, d]);
    let own = |of: Expr| of.with("λ₀", lambda0);
    let sine = symbol("ψ").sin();
    p.note(
        &format!("For λ₀ = {n}/{d}, in parts π/{parts} of the half period"),
        format!("a motion with 𝔴 = 0 at the part {from}:"),
    );
    let (mut at, mut w, mut way) = (from, int(0), 1);
    for (until, does) in half.stretches.iter().copied() {
        let h = half.h(at, until)?;
        match does {
            Slides(sign, left) => {
                if sign != way {
                    let turn = p.read(&format!("It turns at the part {at}, from"), w)?;
                    p.zero("𝔴 is 0", &turn)?;
                }
                way = sign;
                let signed = if sign > 0 {
                    rate
                } else {
                    rate.with("𝔴", symbol("𝔴₁"))
                };
                let slope = own(signed) - sine + h;
                let end = w + slope * ratio([until - at, parts]);
                w = int(sign) * size(left);
                p.identity(
                    (&format!("By (26), at the part {until}, for 𝔴 over π"), end),
                    ("of the sign that friction was given, or 0", w),
                )?;
            }
            Rests(room) => {
                let still = p.read(&format!("It rests up to the part {until}"), w)?;
                p.zero("𝔴 is 0", &still)?;
                p.identity(
                    ("λ₀² − h² there", lambda0.squared() - h.squared()),
                    ("positive: friction holds it", size(room)),
                )?;
            }
        }
        at = until;
    }
    let end = p.read("In the end it is, over π", w)?;
    p.zero("𝔴 is 0", &end)?;
    let length = p.read(
        "The time from its beginning, over π",
        ratio([at - from, parts]),
    )?;
    p.equal("That is half a period, 1", &length, &Rational::int(1))?;
    if half.kind() == 1 {
        p.note(
            "While it rests",
            "the speed of any other motion falls, at the rate λ₀ − |h| > 0 at least, and by the same amount in each half period: after a finite time it rests too, and is the same from then on",
        );
        return Ok(());
    }
    draws_together(p, rate, half)
}

/// That all motions tend to one without rest that slides forward for half a period and backward for the other.
fn draws_together(p: &mut Prover<'_>, rate: Expr, half: &Half) -> Result<(), Obstacle> {
    let [lambda0, psi, other, d] = symbols(["λ₀", "ψ", "𝔴₁", "D"]);
    let (one, two, h) = (int(1), int(2), psi.sin());
    for (says, sign, rate) in [
        ("The sign 1", one, rate),
        ("The sign −1", -one, rate.with("𝔴", other)),
    ] {
        p.note("With", says);
        for (says, left, room) in [
            (
                "1 + λ₀ less the rate of the size by (26)",
                one + lambda0 - sign * rate,
                one - sign * h + two * lambda0,
            ),
            (
                "1 + λ₀ and that rate",
                one + lambda0 + sign * rate,
                one + sign * h,
            ),
        ] {
            p.identity((says, left), ("of which no term is negative", room))?;
        }
    }
    let length = d / (two * (one + lambda0));
    p.identity(
        (
            "D less 1 + λ₀ times D/(2 (1 + λ₀))",
            d - (one + lambda0) * length,
        ),
        ("", d / two),
    )?;
    p.note(
        "Where this motion is 0, let another have the size D",
        "it keeps its sign for the phase D/(2 (1 + λ₀)) before and after, while this one has the other sign on one of the two sides: there the distance falls at the rate 2λ₀ by (26), for that phase or, if this is shorter, half a period",
    );
    let Half {
        lambda0: [n, d],
        from,
        ..
    } = *half;
    p.identity(
        (
            "Where this motion is 0, h² − λ₀²",
            half.h(from, from + 1)?.squared() - ratio([n, d]).squared(),
        ),
        ("positive: friction is too weak", ratio([3, 4])),
    )?;
    Ok(())
}

attempts![&CHANGES];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rests_that_do_not_come_go_and_come_again_are_refused() {
        let (law, rate, kinds) = (CHANGES.formulas)();
        let [come, go, again] = HALVES;
        for halves in [[come, again, again], [go, come, go]] {
            assert!(!changes(law, rate, kinds, halves).holds());
        }
    }

    #[test]
    fn a_half_period_that_is_no_motion_is_refused() {
        let [come, go, again] = HALVES;
        const OVER_A_JUMP: [(i64, Does); 3] = [
            (36, Slides(1, [19, 192])),
            (96, Slides(1, [17, 64])),
            (113, Slides(1, [0, 1])),
        ];
        const STAYS: [(i64, Does); 1] = [(396, Rests([11, 900]))];
        const SHORT: [(i64, Does); 4] = [
            (264, Slides(1, [2, 5])),
            (352, Slides(1, [0, 1])),
            (363, Slides(-1, [1, 30])),
            (387, Slides(-1, [0, 1])),
        ];
        for wrong in [
            Half {
                lambda0: [1, 3],
                ..come
            },
            Half {
                lambda0: again.lambda0,
                ..go
            },
            Half { from: 18, ..go },
            Half {
                stretches: &OVER_A_JUMP,
                ..go
            },
            Half {
                stretches: &STAYS,
                ..come
            },
            Half {
                stretches: &SHORT,
                ..come
            },
        ] {
            let holds = |half: &Half| {
                Proof::in_ring("Half a period", ring(), |p| follow(p, rate(), half)).holds()
            };
            assert!(HALVES.iter().all(holds));
            assert!(!holds(&wrong), "{wrong:?}");
        }
    }

    #[test]
    fn a_slide_through_zero_is_refused() {
        let through = Half {
            lambda0: [1, 4],
            parts: 8,
            from: 6,
            stretches: &[(8, Slides(1, [3, 16])), (11, Slides(-1, [3, 32]))],
        };
        let proof = Proof::in_ring("Half a period", ring(), |p| follow(p, rate(), &through));
        let said = proof.obstacle().unwrap();
        let turned = proof.steps().last().unwrap();
        assert!(turned.says.starts_with("It turns"), "{said}");
    }
}
