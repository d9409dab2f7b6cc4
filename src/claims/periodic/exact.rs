//! The pulse train, exactly: (44) to (46), and the motion that the paper leaves out.
//!
//! Entered are the equation of motion, w' = h − λ₀ for w > 0 and w' = h + λ₀ for w < 0, and the values of h.

use super::prelude::*;

fn symbols() -> [Expr; 3] {
    Expr::symbols(["λ₀", "η", "φ"])
}

fn ring() -> Ring {
    Ring::of(["λ₀", "η", "φ", "h", "𝔴"])
}

/// A motion in cases: each solves the equation, they join, and it begins and ends at 0.
struct Chain {
    title: &'static str,
    says: &'static str,
    /// w(φ), case by case.
    cases: Vec<Expr>,
    /// Where the motion begins, where each case ends.
    ends: Vec<Expr>,
    /// h in each case.
    drive: &'static [i64],
}

impl Chain {
    fn prove(&self) -> Proof {
        let ring = ring();
        Proof::of(self.title, &ring, |p| {
            p.shows(self.says);
            self.steps(p)
        })
    }

    fn steps(&self, p: &mut Prover<'_>) -> Result<(), Obstacle> {
        let by = p.ring().by("φ")?;
        let friction = p.ring().named("λ₀")?;
        for (w, h) in self.cases.iter().zip(self.drive) {
            let w = p.read(&format!("While h = {h}, 𝔴 is"), *w)?;
            let slope = p.derivative("Its rate", &w, &by)?;
            let force = Rational::int(*h) - friction.clone();
            p.equal("It is h − λ₀", &slope, &force)?;
        }
        for (i, end) in self.ends.iter().enumerate() {
            let before = i.checked_sub(1).map(|i| self.cases[i]);
            let after = self.cases.get(i).copied();
            let at = |w: Option<Expr>| w.unwrap_or(int(0)).with("φ", *end);
            let [from, to] = match (before, after) {
                (None, _) => ["𝔴 where the motion begins", "as in the first case"],
                (_, None) => [
                    "𝔴 where the last case ends",
                    "where it stays or turns at once",
                ],
                _ => ["𝔴 where a case ends", "as where the next one begins"],
            };
            p.identity((from, at(before)), (to, at(after)))?;
        }
        Ok(())
    }
}

pub(crate) fn eq44_chain(cases: [Expr; 3]) -> Proof {
    let [lambda, eta, _] = symbols();
    let [peak, stop] = printed::eq44_ends(lambda, eta);
    let moving = Chain {
        title: "(44): large friction, from the start of a pulse to rest",
        says: "Under (42), for η ≤ λ₀ < 1, the first two cases of (44) have the rate h − λ₀, are 0 at φ = 0 and at φ = ηπ/λ₀, and join at φ = ηπ.",
        cases: cases[..2].to_vec(),
        ends: vec![int(0), peak, stop],
        drive: &[1, 0],
    };
    let ring = ring();
    Proof::of("(44): motion and rest", &ring, |p| {
        moving.steps(p)?;
        p.vanishes("The printed rest", cases[2])
    })
}

/// (45): with w(φ) a solution while h is h(φ), the printed w(π + φ) is one while h is that of (43).
pub(crate) const EQ45: Statement = Statement::new(
    Printed,
    Compared::one(
        "the rate of the mirrored motion",
        "the mirrored force, of opposite friction",
    ),
    printed::eq45_w::tree,
    |mirrored| {
        let ring = ring();
        Proof::of("(45): the second half period", &ring, |p| {
            let [h, friction] = Expr::symbols(["h", "λ₀"]);
            let force = p.ring().read(h - friction)?;
            let motion = p.ring().along(&[("𝔴", force)])?;
            let w = p.read("The printed velocity there", mirrored)?;
            let rate = p.derivative("Its rate, with 𝔴' = h − λ₀", &w, &motion)?;
            p.reads_as(
                &rate,
                "the force there, for negative velocity and h of (43)",
                printed::eq43_h::tree() + friction,
            )?;
            p.vanishes("At 𝔴 = 0", mirrored.with("𝔴", int(0)))
        })
    },
);

pub(crate) const EQ46: Statement = Statement::new(
    Printed,
    Compared::many(
        "the stop of (44), and the start of the motion without rest,",
        "the beginning of a pulse",
    ),
    printed::eq46_lambda_c::tree,
    |critical| {
        let ring = ring();
        Proof::of("(46): where the stop meets the next pulse", &ring, |p| {
            p.rests_on(&small_friction())?;
            let [lambda, eta, _] = symbols();
            let [_, stop] = printed::eq44_ends(lambda, eta);
            let stop = p.read("At λ_c the stop of (44) is at", stop.with("λ₀", critical))?;
            let pulse = p.ring().read(pi())?;
            p.equal("The next pulse begins at π", &stop, &pulse)?;
            let start = supplied::small_friction_start(lambda, eta);
            let start = p.read(
                "At λ_c the motion of small friction starts at",
                start.with("λ₀", critical),
            )?;
            p.zero("The pulse begins at 0", &start)
        })
    },
);

pub(crate) fn small_friction() -> Proof {
    let [lambda, eta, phi] = symbols();
    small_friction_chain(supplied::small_friction_cases(lambda, eta, phi))
}

fn small_friction_chain(cases: [Expr; 3]) -> Proof {
    let [lambda, eta, _] = symbols();
    let start = supplied::small_friction_start(lambda, eta);
    let [peak, pulse] = supplied::small_friction_ends(eta);
    Chain {
        title: "Small friction under the pulses: from zero to zero in half a period",
        says: "Under (42) and (43), for 0 < λ₀ ≤ η, the 𝔴 with the rate h − λ₀ that is 0 at φ = π (η − λ₀)/2 is 0 again half a period later.",
        cases: cases.to_vec(),
        ends: vec![start, peak, pulse, start + pi()],
        drive: &[1, 0, -1],
    }
    .prove()
}

const COMPARED: Compared = Compared::one(
    "the printed formula",
    r"$\mathfrak w'=h-\lambda_0$ case by case, and the cases with each other where they meet",
);

pub(crate) const EQ44: Statement<[Expr; 3]> = Statement::new(
    Printed,
    COMPARED,
    || {
        let [lambda, eta, phi] = symbols();
        printed::eq44_cases(lambda, eta, phi)
    },
    eq44_chain,
);

attempts![&EQ44, &EQ45, &EQ46];
