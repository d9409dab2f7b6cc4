//! The corrected laws, exactly: they solve Newton's law at leading order.
//!
//! The ring has τ, √2, 2^(1/4) and √τ. The laws come from [`crate::corrections::escape`] as trees; each is put into the
//! leading order of one equation of motion that the paper does not need: the balance of powers in the laboratory,
//! (2+ik)(1+ik)|C| = i; d(A²)/dτ = 2p, since A² = ρ² − p²; e^α = 2p/A; dρ/dτ = p cos ψ; ds/dτ = p.

use crate::claims::compare::proved;
use crate::corrections::escape as law;
use crate::evidence::{Evidence, Subject};
use crate::exact::{ExactError, Expr, Obstacle, Proof, Prover, Rational, Ring};
use crate::paper::escape as printed;
use crate::scalar::Scalar;

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let tau = ring.symbol("τ");
    ring.symbol("A");
    ring.hyperbolic("α");
    let root = ring.root(&Rational::int(2), 2)?;
    ring.root(&root, 2)?;
    ring.root(&tau, 2)?;
    Ok(ring)
}

type Steps = fn(&mut Prover<'_>) -> Result<(), Obstacle>;

fn prove(title: &str, steps: Steps) -> Proof {
    match ring() {
        Ok(ring) => Proof::of(title, &ring, steps),
        Err(error) => Proof::impossible(title, error),
    }
}

fn tau() -> Expr {
    Expr::symbol("τ")
}

fn int(n: i64) -> Expr {
    Expr::int(n)
}

/// The balance of powers for R = C τ^(2+ik) with |C| τ² = `rho`: real and imaginary part.
fn balance(p: &mut Prover<'_>, rho: Expr) -> Result<(), Obstacle> {
    let (k, size) = (law::winding::<Expr>(), rho / tau().squared());
    let real = p.read("Re (2+ik)(1+ik)|C|", (int(2) - k.squared()) * size)?;
    p.zero("it is zero", &real)?;
    let imaginary = p.read("Im (2+ik)(1+ik)|C|", int(3) * k * size)?;
    p.equal("it is one", &imaginary, &Rational::int(1))
}

/// dx/dτ = `rate`.
fn grows(p: &mut Prover<'_>, x: Expr, rate: Expr) -> Result<(), Obstacle> {
    let x = p.read("What grows", x)?;
    let slope = p.derivative("Its rate", &x, &p.ring().by("τ")?)?;
    let rate = p.read("The rate by the law of motion", rate)?;
    p.equal("The two", &slope, &rate)
}

fn same(p: &mut Prover<'_>, x: Expr, y: Expr) -> Result<(), Obstacle> {
    let (x, y) = (p.read("One side", x)?, p.read("The other", y)?);
    p.equal("They are the same", &x, &y)
}

/// exp(2α) = (2p/A)² with the laws of p and A.
fn size_and_speed(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    balance(p, law::rho(tau()))?;
    grows(p, law::a(tau()).squared(), int(2) * law::rho(tau()))?;
    let ratio = int(2) * law::rho(tau()) / law::a(tau());
    same(p, law::twice_alpha_exp(tau()), ratio.squared())
}

/// The proof that belongs to a claim's correction.
pub fn proof(id: &str) -> Proof {
    match id {
        "eq-135" | "eq-136" => prove("p and ρ at large times", |p| balance(p, law::rho(tau()))),
        "eq-132" => prove("A at large times", |p| {
            balance(p, law::rho(tau()))?;
            grows(p, law::a(tau()).squared(), int(2) * law::rho(tau()))
        }),
        "eq-133" => prove("e^(2α) at large times", size_and_speed),
        "eq-130" => prove("e^(3α) = 3√2 A at large times", |p| {
            size_and_speed(p)?;
            let by_a = int(3) * law::winding::<Expr>() * law::a(tau());
            same(p, law::twice_alpha_exp(tau()).pow(int(3)), by_a.squared())
        }),
        "eq-131" => prove("(2 dA/dτ)³ = 3√2 A at large times", |p| {
            size_and_speed(p)?;
            let a = p.read("A", law::a(tau()))?;
            let rate = p.derivative("dA/dτ", &a, &p.ring().by("τ")?)?;
            let cube = &(&rate * &rate) * &rate * Rational::int(8);
            let by_a = p.read("3√2 A", int(3) * law::winding::<Expr>() * law::a(tau()))?;
            p.equal("The two", &cube, &by_a)
        }),
        "eq-129" => prove("¼ e^(3α) over A at large times", |p| {
            size_and_speed(p)?;
            let leading = law::twice_alpha_exp(tau()).pow(int(3)) / int(16);
            let stated = law::product_over_a::<Expr>() * law::a(tau());
            same(p, leading, stated.squared())
        }),
        "eq-128" => prove("dα/dτ at large times", |p| {
            size_and_speed(p)?;
            p.note(
                "At leading order",
                "√2/cosh 2α → 2√2 e^(−2α), cosh α/A → p/A² by e^α = 2p/A",
            );
            let first = int(2) * law::winding::<Expr>() / law::twice_alpha_exp(tau());
            let second = law::rho(tau()) / law::a(tau()).squared();
            p.note("dα/dτ", "half the rate of ln e^(2α), which is 1/(2τ)");
            let growth = p.read("e^(2α)", law::twice_alpha_exp(tau()))?;
            let rate = p.derivative("Its rate", &growth, &p.ring().by("τ")?)?;
            let relative =
                p.quotient("Half of it, relative", &rate, &(growth * Rational::int(2)))?;
            let stated = p.read("As corrected", first - second)?;
            p.equal("The two", &relative, &stated)
        }),
        "eq-134" => prove("π/2 − ψ at large times", |p| {
            balance(p, law::rho(tau()))?;
            p.note("dρ/dτ = p cos ψ", "at leading order ρ (π/2 − ψ)");
            grows(p, law::rho(tau()), law::rho(tau()) * law::lag(tau()))
        }),
        "eq-137" => prove("s at large times", |p| {
            balance(p, law::rho(tau()))?;
            grows(p, law::s(tau()), law::rho(tau()))
        }),
        _ => Proof::impossible(
            id,
            ExactError::UnknownSymbol {
                name: id.to_owned(),
            },
        ),
    }
}

/// Evidence for the correction of a claim.
pub fn evidence(id: &str) -> Evidence {
    let compared = "the corrected law with Newton's law in the laboratory, at leading order";
    proved(&proof(id), Subject::Corrected, compared)
}

/// (138): A²/2 and s have the same rate, whatever the motion; so the check cannot fail.
pub fn eq138() -> Proof {
    prove("d(A²/2)/dτ = ds/dτ, whatever A and α are", |p| {
        let (a, alpha) = (Expr::symbol("A"), Expr::symbol("α"));
        p.note("A and α", "any; dA/dτ = sinh α by d(ρ² − p²)/dτ = 2p");
        let half = p.read("(138)", printed::eq138_s(a))?;
        let rate = p.ring().read(alpha.sinh())?;
        let motion = p.ring().along(&[("A", rate)])?;
        let growth = p.derivative("Its rate", &half, &motion)?;
        let speed = p.read("ds/dτ = p = A sinh α", a * alpha.sinh())?;
        p.equal("The two", &growth, &speed)
    })
}

/// Evidence for (138).
pub fn eq138_evidence() -> Evidence {
    let compared = "d(A²/2)/dτ with ds/dτ, for any A and α";
    proved(&eq138(), Subject::Printed, compared)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_correction_is_proved() {
        for n in 128..=137 {
            let proof = proof(&format!("eq-{n}"));
            assert!(proof.holds(), "{n}\n{proof}");
        }
        assert!(eq138().holds(), "{}", eq138());
    }

    #[test]
    fn the_printed_prefactors_are_not() {
        for rho in [printed::eq135_p(tau()), law::rho(tau()) * int(2)] {
            let steps = |p: &mut Prover<'_>| balance(p, rho);
            let proof = Proof::of("printed", &ring().unwrap(), steps);
            assert!(!proof.holds(), "{proof}");
        }
    }
}
