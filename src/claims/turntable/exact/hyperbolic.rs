//! The motion by A, α and by B, β: (113) to (115), (119) to (121), and how the two go over into each other,
//! (122) and (123).

use super::{Setting, Vectorial, changes, prove, rate};
use crate::claims::turntable::prelude::*;
use crate::paper::turntable as paper;

pub(crate) const EQ113: Vectorial = changes(Printed, paper::eq113_a_rate::parts, |printed| {
    rate("(113): dA/dτ", Setting::slower(), "A", &printed)
});
pub(crate) const EQ114: Vectorial = changes(Within, paper::eq114_alpha_rate::parts, |printed| {
    rate("(114): dα/dτ", Setting::slower(), "α", &printed)
});
pub(crate) const EQ115: Vectorial = changes(Within, paper::eq115_psi_rate::parts, |printed| {
    rate("(115): dψ/dτ", Setting::slower(), "ψ", &printed)
});

const CONTINUED: Compared = Compared::many(
    "(111) to (115), with (122) and (123) put in,",
    "(117) to (121)",
);

/// How far the multiples of iπ/2 and of β in (123) are looked for.
const MOST: i64 = 4;

/// exp(α/2) for α = n β + k iπ/2, by Euler's formula ζᵏ exp(β/2)ⁿ.
fn half_exponential(p: &mut Prover<'_>, alpha: &Rational) -> Result<Rational, Obstacle> {
    let ring = p.ring();
    let [i, beta] = symbols(["i", "β"]);
    let quarter = ring.read(i * pi() / 2)?;
    let beta_element = ring.read(beta)?;
    for k in -MOST..=MOST {
        for n in -MOST..=MOST {
            let known = &quarter * &Rational::int(k) + &beta_element * &Rational::int(n);
            if ring.is_zero(&(alpha - &known))? {
                let zeta = symbol("ζ").pow(int(k));
                let half = (beta / 2).exp().pow(int(n));
                p.remark(&format!("α is {k} times iπ/2 and {n} times β"));
                return p.read(
                    "exp(α/2), by Euler's formula with ζ = exp(iπ/4)",
                    zeta * half,
                );
            }
        }
    }
    Err(Obstacle::NotZero {
        says: "α must be a whole multiple of iπ/2 plus one of β".into(),
        normal_form: ring.text(alpha),
    })
}

/// (111) to (115) turn into (117) to (121).
fn continuation(title: &str, a: Expr, alpha: Expr) -> Proof {
    prove(title, Setting::continued(), |p, _| {
        let ring = p.ring();
        let a = p.read("A", a)?;
        let alpha_element = p.read("α", alpha)?;
        let half = half_exponential(p, &alpha_element)?;
        let own = ring.read((symbol("α") / 2).exp())?;
        let own_a = ring.named("A")?;
        let ours = [(&own_a, &a), (&own, &half)];
        let mut same = |says: &str, inner: Expr, outer: Expr| -> Result<(), Obstacle> {
            let inner = ring.put(&ring.read(inner)?, &ours)?;
            let outer = ring.read(outer)?;
            p.equal(says, &inner, &outer)
        };
        same(
            "(111) becomes (117)",
            paper::eq111_p::tree(),
            paper::eq117_p::tree(),
        )?;
        same(
            "(112) becomes (118)",
            paper::eq112_rho::tree(),
            paper::eq118_rho::tree(),
        )?;
        // A is a fixed multiple of B, and α differs from β by a constant: so do their rates.
        let ratio = paper::eq122_a(symbol("i"), int(1));
        same(
            "(113) becomes (119)",
            paper::eq113_a_rate::tree(),
            ratio * paper::eq119_b_rate::tree(),
        )?;
        same(
            "(114) becomes (120)",
            paper::eq114_alpha_rate::tree(),
            paper::eq120_beta_rate::tree(),
        )?;
        same(
            "(115) becomes (121)",
            paper::eq115_psi_rate::tree(),
            paper::eq121_psi_rate::tree(),
        )
    })
}

attempts![
    &EQ113,
    &EQ114,
    &EQ115,
    &EQ119 = changes(Printed, paper::eq119_b_rate::parts, |printed| {
        rate("(119): dB/dτ", Setting::faster(), "B", &printed)
    }),
    &EQ120 = changes(Printed, paper::eq120_beta_rate::parts, |printed| {
        rate("(120): dβ/dτ", Setting::faster(), "β", &printed)
    }),
    &EQ121 = changes(Within, paper::eq121_psi_rate::parts, |printed| {
        rate("(121): dψ/dτ", Setting::faster(), "ψ", &printed)
    }),
    &EQ122 = Vectorial::new(Printed, CONTINUED, paper::eq122_a::parts, |printed| {
        continuation("(122), with (123)", printed[0], paper::eq123_alpha::tree())
    }),
    &EQ123 = Vectorial::new(Printed, CONTINUED, paper::eq123_alpha::parts, |printed| {
        continuation("(123), with (122)", paper::eq122_a::tree(), printed[0])
    }),
];
