//! How far a motion that escapes is from the laws of the spiral, at any time from a stated one on.
//!
//! With q = (N − ¾)/t, v = (P − ½)/t and their limits q₀, v₀, as in [`spiral`], the region 0 < t ≤ 1/20, (8/3)(q − q₀)² + (v − v₀)² ≤
//! 1/16 is never left, as intervals show on its edge; every escape comes into it. Inside, the quantities of the motion are
//! those of the laws at the time 1/t times 1 + t E, with bounds on E, and 1/t falls behind the time by a logarithm at most:
//! both by intervals, on the whole region at once.

use super::exact::spiral::{self, State};
use super::prelude::*;
use trialbook::certified::cover::{self, Said};
use trialbook::certified::interval::Interval;
use trialbook::certified::jet::{Jet, over};
use trialbook::trials::enclosed::resting_on;

/// What is shown from the time on at which the region is entered.
macro_rules! from_then_on {
    ($what:literal) => {
        Compared::shown(concat!(
            r"every motion from a start with $p<\rho$ and $A>1$ comes into the region $0<t\le\frac1{20}$, ",
            r"$\frac83\left(q-\frac{3\sqrt2}{32}\right)^2+\left(v-\frac{3\sqrt2}8\right)^2\le\frac1{16}$ and stays, where ",
            r"$t=\tan\left(\frac\pi4-\frac\psi2\right)$, $q=\left(\frac{\cosh\alpha}{2At}-\frac34\right)/t$ and ",
            r"$v=\left(\frac1{t^2(\mathrm e^{4\alpha}-1)}-\frac12\right)/t$; with $\tau$ counted such that it is $1/t$ at any one ",
            r"time there, and so 20 or more, from that time on ",
            $what
        ))
    };
}

#[derive(Clone, Copy)]
struct BoundedLaw {
    /// What is known of it as τ → ∞.
    limit: fn() -> Proof,
    /// The law at the time 1/t; where 1/t alone matters, none.
    ratio: Option<Ratio>,
    /// What follows for the law at the time τ.
    so: &'static str,
}

/// The law at the time 1/t over the motion's quantity.
#[derive(Clone, Copy)]
struct Ratio {
    /// A power of the law at the time 1/t over that of the motion, in N, P, h and t, but for a number.
    inverse: fn(State) -> Expr,
    /// Its factors over their limits, each less 1, over t.
    parts: fn(Inside) -> Vec<Expr>,
    /// Halves between which E lies.
    between: [i64; 2],
}

#[derive(Clone, Copy)]
struct Inside {
    q: Expr,
    v: Expr,
    t: Expr,
}

fn over_n(n: i64, m: i64) -> Expr {
    int(n) / int(m)
}

impl Inside {
    fn symbols() -> Self {
        let [q, v, t] = symbols(["q", "v", "t"]);
        Inside { q, v, t }
    }

    fn prey(self) -> Expr {
        over_n(3, 4) + self.q * self.t
    }

    fn predator(self) -> Expr {
        over_n(1, 2) + self.v * self.t
    }

    /// What w = (1 − h)/t has below its root.
    fn square(self) -> Expr {
        let predator = self.predator();
        predator + (predator * self.t).squared()
    }

    /// w, the positive solution of w² = 4P (1 − w t).
    fn w(self) -> Expr {
        2 * self.square().sqrt() - 2 * self.predator() * self.t
    }

    fn state(self) -> State {
        let h = 1 - self.w() * self.t;
        [self.prey(), self.predator(), h, self.t]
    }

    /// By how much 1/t is slower than τ, over t.
    fn slower(self) -> Expr {
        2 * self.v - self.t - 2 * self.v * self.t.squared()
    }
}

/// q₀ and v₀.
fn middle() -> [Expr; 2] {
    let root = int(2).sqrt();
    [3 * root / 32, 3 * root / 8]
}

/// How fast (8/3)(q − q₀)² + (v − v₀)² changes in θ.
fn change(at: Inside) -> Expr {
    let [q0, v0] = middle();
    let [dq, dv] = spiral::follow([at.q, at.v, at.w()], at.state());
    over_n(16, 3) * (at.q - q0) * dq + 2 * (at.v - v0) * dv
}

fn edge() -> Inside {
    let [q0, v0] = middle();
    let [f, t] = symbols(["f", "t"]);
    Inside {
        q: q0 + int(6).sqrt() / 16 * f.cos(),
        v: v0 + f.sin() / 4,
        t,
    }
}

fn inside() -> Inside {
    let [q0, v0] = middle();
    let [x, y, t] = symbols(["x", "y", "t"]);
    Inside {
        q: q0 + x,
        v: v0 + y,
        t,
    }
}

/// 1 + t E is the product of 1 + t g over these g, of which there is one at least.
fn product_less_one(t: Expr, parts: Vec<Expr>) -> Expr {
    let product = parts.into_iter().reduce(|e, g| e + (1 + t * e) * g);
    product.unwrap_or_else(|| int(0))
}

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["q", "v", "t"]);
    ring.angle("f");
    for number in [2, 6] {
        let number = ring.read(int(number))?;
        ring.root(&number, 2)?;
    }
    let square = ring.read(Inside::symbols().square())?;
    ring.root(&square, 2)?;
    Ok(ring)
}

fn region(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    spiral::comes(p)?;
    let at = Inside::symbols();
    p.note(
        "Let t be positive, q₀ = 3√2/32, v₀ = 3√2/8, q = (N − 3/4)/t, v = (P − 1/2)/t, and dθ = 2t dτ",
        "N, P, h = 1 − w t, and w, positive, the square of which is 4Ph",
    );
    let [_, predator, h, _] = at.state();
    p.identity(("w²", at.w().squared()), ("", 4 * predator * h))?;
    let [q0, v0] = middle();
    let height = over_n(8, 3) * (at.q - q0).squared() + (at.v - v0).squared();
    let read = p.read("Q", height)?;
    let [dq, dv] = spiral::follow([at.q, at.v, at.w()], at.state());
    let [dq, dv] = [p.ring().read(dq)?, p.ring().read(dv)?];
    let along = p.ring().along(&[("q", dq), ("v", dv)])?;
    // Too long to be shown, as are what the intervals enclose.
    let rate = p.ring().derivative(&read, &along)?;
    let stated = p.ring().read(change(at))?;
    p.equal(
        "Its rate in θ by those of q and v is what the intervals enclose",
        &rate,
        &stated,
    )?;
    let edge = edge();
    let on_edge = height.with("q", edge.q).with("v", edge.v);
    p.identity(
        ("Q at q₀ + (√6/16) cos f, v₀ + (1/4) sin f", on_edge),
        ("", over_n(1, 16)),
    )?;
    let rate = 2 - 2 * (1 - at.t.squared()) * predator;
    p.identity(
        ("1 less the rate of 1/t in τ, over t", (1 - rate) / at.t),
        ("", at.slower()),
    )?;
    p.note(
        "With τ = 1/t at some time there, let b be τ − 1/t",
        "later 0 ≤ b ≤ (8/5)(25/23) ln(τ/20) ≤ 2 ln(τ/20), as 1/t ≥ 20; and b/τ ≤ 1/(10 exp 1) < 1/27",
    );
    Ok(())
}

impl Ratio {
    fn excess(&self, at: Inside) -> Expr {
        product_less_one(at.t, (self.parts)(at))
    }

    /// The ratio is 1 + t E.
    fn near_one(&self, p: &mut Prover<'_>) -> Result<(), Obstacle> {
        let at = Inside::symbols();
        let limit = (self.inverse)([over_n(3, 4), over_n(1, 2), int(1), int(0)]);
        let ratio = (self.inverse)(at.state()) / limit;
        let ratio = p.ring().read(ratio)?;
        let stated = p.ring().read(1 + at.t * self.excess(at))?;
        p.equal(
            "A power of the law at the time 1/t over that of the motion is 1 + t E, with the E that the intervals enclose",
            &ratio,
            &stated,
        )?;
        let text = |n: i64| match n % 2 {
            0 => (n / 2).to_string(),
            _ => format!("{n}/2"),
        };
        let [least, most] = self.between.map(text);
        p.note(
            "In the region, by intervals",
            format!("{least} < E < {most}"),
        );
        Ok(())
    }
}

impl BoundedLaw {
    fn premise(&self) -> Proof {
        Proof::in_ring("The region that every escape comes into", ring(), |p| {
            region(p)?;
            if let Some(ratio) = self.ratio {
                ratio.near_one(p)?;
            }
            p.note("So, as 1/t = τ − b", self.so);
            Ok(())
        })
    }

    fn enclosed(&self) -> Result<usize, CertifiedError> {
        let t = Interval::new(0.0, 0.05);
        let whole = Interval::new(0.0, (Interval::int(2) * Interval::pi()).hi());
        let edge = everywhere(["f", "t"], [whole, t], &[(change(edge()), -1.0)])?;
        let at = inside();
        let mut signs = vec![(at.slower(), 1.0), (over_n(8, 5) - at.slower(), 1.0)];
        if let Some(ratio) = self.ratio {
            let (excess, [least, most]) = (ratio.excess(at), ratio.between.map(half));
            signs.extend([(excess - least, 1.0), (most - excess, 1.0)]);
        }
        // A little larger than the region; and not even, so that a value in the middle tells a sign.
        let [x, y] = [Interval::new(-0.154, 0.156), Interval::new(-0.25, 0.26)];
        Ok(edge + everywhere(["x", "y", "t"], [x, y, t], &signs)?)
    }

    fn evidence(&self, compared: Compared) -> Evidence {
        let premises = [(self.limit)(), self.premise()];
        let enclosed = || self.enclosed();
        resting_on(&premises, enclosed, Corrected, compared)
    }
}

fn half(n: i64) -> Expr {
    over_n(n, 2)
}

fn everywhere<const N: usize>(
    names: [&'static str; N],
    range: [Interval; N],
    signs: &[(Expr, f64)],
) -> Result<usize, CertifiedError> {
    cover::everywhere(range, |cell| {
        Said::all(signs.iter().map(|&(formula, way)| {
            let f = |x: [Jet<N>; N]| {
                let place = |name: &str| names.iter().position(|known| *known == name);
                let value = formula.evaluate(&|name| place(name).map(|i| x[i]));
                value.unwrap_or(Jet::constant(Interval::WHOLE))
            };
            Said::of_sign(over(f, cell).value, way)
        }))
    })
}

const A: BoundedLaw = BoundedLaw {
    limit: || spiral::EQ132.proof(),
    ratio: Some(Ratio {
        inverse: |state| 1 / spiral::fourth_power(state),
        parts: |at| {
            let [prey, w] = [over_n(4, 3) * at.q, at.w()];
            let slower = -w / 2;
            vec![2 * at.v, -w, prey, prey, prey, prey, slower, slower]
        },
        between: [-5, 1],
    }),
    so: "A⁴ over its law's is (1 − b/τ)⁶/(1 + t E), at most 1/(1 − 5/(2τ)), and so 1 + 3/τ, as τ ≥ 20: by the root, at most 1 + 3/(4τ), and at least 1 − 3b/(2τ) − 1/(8τ), as (1 − b/τ) t = 1/τ",
};

const ALPHA: BoundedLaw = BoundedLaw {
    limit: || spiral::EQ133.proof(),
    ratio: Some(Ratio {
        inverse: |state| 1 / spiral::fourth_exponential(state),
        parts: |at| {
            let p = at.predator();
            let more = p * at.t / (1 + p * at.t.squared());
            vec![2 * at.v, -more]
        },
        between: [0, 4],
    }),
    so: "exp(4α) over its law's is (1 − b/τ)²/(1 + t E): 4 times the difference of α is 2 ln(1 − b/τ) − ln(1 + t E), not above 0 and at least −2 (27/26) (b + 1)/τ",
};

const LAG: BoundedLaw = BoundedLaw {
    limit: || spiral::EQ134.proof(),
    ratio: None,
    so: "tτ is 1/(1 − b/τ), between 1 and 1 + (27/26) b/τ; and δ = 2 arctan t is between 2t (1 − t²/3) and 2t, with t ≤ (27/26)/τ",
};

const SPEED: BoundedLaw = BoundedLaw {
    limit: || spiral::EQ135.proof(),
    ratio: Some(Ratio {
        inverse: |state| 1 / spiral::square_of_speed(state),
        parts: |at| {
            let [prey, w] = [over_n(4, 3) * at.q, at.w()];
            let (slower, faster) = (-w / 2, w / (1 - w * at.t));
            vec![2 * at.v, faster, prey, prey, slower, slower]
        },
        between: [0, 5],
    }),
    so: "p² over its law's is (1 − b/τ)⁴/(1 + t E): at most 1 and, by the root, p over its law's at least 1 − 2b/τ − 5/(4τ), as (1 − b/τ) t = 1/τ",
};

const RHO: BoundedLaw = BoundedLaw {
    limit: || spiral::EQ136.proof(),
    ratio: Some(Ratio {
        inverse: |state| 1 / spiral::square_of_distance(state),
        parts: |at| {
            let [prey, w] = [over_n(4, 3) * at.q, at.w()];
            let slower = -w / 2;
            vec![2 * at.v, -w, prey, prey, slower, slower]
        },
        between: [-5, 0],
    }),
    so: "ρ² over its law's is (1 − b/τ)⁴/(1 + t E), at most 1/(1 − 5/(2τ)), and so 1 + 3/τ, as τ ≥ 20: by the root, ρ over its law's is at least 1 − 2b/τ and at most 1 + 3/(2τ)",
};

attempts![
    eq132 = A.evidence(from_then_on!(
        r"$1-\frac{1/8+3\ln(\tau/20)}\tau\le\frac{3A}{2^{1/4}\tau^{3/2}}\le1+\frac3{4\tau}$"
    )),
    eq133 = ALPHA.evidence(from_then_on!(
        r"$-\frac{11}{20}\,\frac{1+2\ln(\tau/20)}\tau\le\alpha-\frac12\ln(\sqrt2\,\tau)\le0$"
    )),
    eq134 = LAG.evidence(from_then_on!(
        r"up to whole turns $1-\frac1{2\tau^2}\le\frac\tau2\left(\frac\pi2-\psi\right)\le1+\frac{21}{10}\,\frac{\ln(\tau/20)}\tau$"
    )),
    eq135 = SPEED.evidence(from_then_on!(
        r"$1-\frac{5/4+4\ln(\tau/20)}\tau\le\frac{3\sqrt2\,p}{\tau^2}\le1$"
    )),
    eq136 = RHO.evidence(from_then_on!(
        r"$1-\frac{4\ln(\tau/20)}\tau\le\frac{3\sqrt2\,\rho}{\tau^2}\le1+\frac3{2\tau}$"
    ))
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::latex::{Lexicon, Relation, Value, statements};
    use crate::motion::turntable::{Start, intrinsic::Run};
    use std::f64::consts::FRAC_PI_2;

    const ALL: [&BoundedLaw; 5] = [&A, &ALPHA, &LAG, &SPEED, &RHO];

    #[test]
    fn all_bounds_are_proved_and_tighter_ones_are_not() {
        for law in ALL {
            let proof = law.premise();
            assert!(proof.holds(), "{proof}");
            assert!(law.enclosed().is_ok(), "{proof}");
            let Some(ratio) = law.ratio else { continue };
            let [least, most] = ratio.between;
            let middle = (least + most) / 2;
            for between in [[least, middle], [middle, most]] {
                let ratio = Some(Ratio { between, ..ratio });
                let tighter = BoundedLaw { ratio, ..*law };
                assert!(tighter.enclosed().is_err(), "{proof}");
            }
        }
    }

    #[test]
    fn another_factor_is_refused() {
        for law in ALL {
            let Some(ratio) = law.ratio else { continue };
            let inverse = |[n, p, h, t]: State| n * p.squared() * h + t;
            let ratio = Some(Ratio { inverse, ..ratio });
            assert!(!BoundedLaw { ratio, ..*law }.premise().holds());
        }
    }

    #[test]
    fn motions_keep_within_the_bounds() {
        let chains = stated();
        let starts = [
            Start::put_down(1.0),
            Start::launched(1.5),
            Start::hyperbolic(1.2, 0.1, -2.0),
        ];
        for start in starts {
            let run = Run::new(&start.unwrap(), 2000.0).unwrap();
            let inside: Vec<_> = run
                .nodes()
                .filter_map(|now| Some((now, now.a()?, now.alpha()?, (now.lag() / 2.0).tan())))
                .skip_while(|&(_, a, alpha, t)| !is_inside(a, alpha, t))
                .collect();
            assert!(inside.len() > 20, "{}", inside.len());
            for first in [0, inside.len() / 3, inside.len() / 2] {
                let late = inside[first].0.tau - 1.0 / inside[first].3;
                for &(now, a, alpha, t) in &inside[first..] {
                    assert!(is_inside(a, alpha, t), "{now:?}");
                    let tau = now.tau - late;
                    let psi = FRAC_PI_2 - now.lag();
                    let values = [a, alpha, psi, now.p(), now.rho(), tau];
                    for chain in &chains {
                        let [least, is, most] = chain.map(|side| value(side, &values));
                        let near = 1e-9 / tau;
                        assert!(least - near <= is && is <= most + near, "{values:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_stated_follows_from_the_region() {
        let powers = [(4, 6), (4, 2), (0, 0), (2, 4), (2, 4)];
        for ((law, chain), (power, of_time)) in ALL.into_iter().zip(stated()).zip(powers) {
            for (i, j) in (0..90).flat_map(|i| (0..=20).map(move |j| (i, j))) {
                let tau = 20.0 * 1.1_f64.powi(i);
                let b = f64::from(j) / 20.0 * (40.0 / 23.0) * (tau / 20.0).ln();
                let (t, late) = (1.0 / (tau - b), 1.0 - b / tau);
                let [least, most] = [0, 2].map(|i| value(chain[i], &[tau; 6]));
                let between = law.ratio.map_or([0, 0], |ratio| ratio.between);
                for e in between.map(|n| 0.5 * n as f64) {
                    let raised = late.powi(of_time) / (1.0 + t * e);
                    let is = match (power, of_time) {
                        (4, 2) => raised.ln() / 4.0,
                        (0, 0) => t.atan() * tau,
                        _ => raised.powf(1.0 / f64::from(power)),
                    };
                    let near = 1e-12;
                    assert!(
                        least - near <= is && is <= most + near,
                        "{power} {tau} {b} {e}"
                    );
                }
            }
        }
    }

    const NAMES: [(&str, &str); 6] = [
        ("A", "A"),
        (r"\alpha", "α"),
        (r"\psi", "ψ"),
        ("p", "p"),
        (r"\rho", "ρ"),
        (r"\tau", "τ"),
    ];

    /// The three sides of what each certificate says, read from its words.
    fn stated() -> [[Expr; 3]; 5] {
        let mut lexicon = Lexicon::new();
        for (latex, plain) in NAMES {
            lexicon.add(latex, Value::Number(symbol(plain))).unwrap();
        }
        [0, 1, 2, 3, 4].map(|law: usize| {
            let words = TRIALS[law].evidence().compared.stated();
            let formula = words.rsplit('$').nth(1).unwrap();
            let chain = &statements(formula).unwrap()[0];
            assert_eq!(chain.relations, [Relation::AtMost; 2]);
            let sides: Vec<_> = chain
                .sides
                .iter()
                .map(|side| side.read(&lexicon).unwrap())
                .collect();
            std::array::from_fn(|i| sides[i].number().unwrap())
        })
    }

    fn value(side: Expr, values: &[f64; 6]) -> f64 {
        let place = |name: &str| NAMES.iter().position(|(_, plain)| *plain == name);
        side.evaluate(&|name| place(name).map(|i| values[i]))
            .unwrap()
    }

    fn is_inside(a: f64, alpha: f64, t: f64) -> bool {
        let q = (alpha.cosh() / (2.0 * a * t) - 0.75) / t;
        let v = (1.0 / (t * t * (4.0 * alpha).exp_m1()) - 0.5) / t;
        let [q0, v0] = [32.0, 8.0].map(|n| 3.0 * 2_f64.sqrt() / n);
        let height = 8.0 / 3.0 * (q - q0).powi(2) + (v - v0).powi(2);
        0.0 < t && t <= 0.05 && height <= 1.0 / 16.0
    }
}
