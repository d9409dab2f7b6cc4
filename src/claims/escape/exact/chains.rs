//! Theorems about every motion that begins with p < ρ and A > 1, or near α = 0: each link is an identity of the ring, and a
//! term that has a sign.

use crate::claims::escape::prelude::*;
use crate::claims::rest::exact::eq139;
use crate::claims::turntable::exact::{self as turntable, Setting};

/// What the theorems on escape say of a bound, by the printed law of motion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beyond {
    /// The number that A has to exceed.
    pub bound: Expr,
    /// d²𝛒/dτ² in `x`, `y` and the velocity p (cos χ, sin χ).
    pub acceleration: [Expr; 2],
    /// dξ/dτ in p and ℓ.
    pub ahead: Expr,
}

impl Beyond {
    fn printed() -> Self {
        Beyond {
            bound: printed::eq127_least_a(),
            acceleration: acceleration(),
            ahead: motion::eq101_xi_rate::tree(),
        }
    }
}

pub(crate) const ESCAPES: Statement<Beyond> = Statement::shown(
    Within,
    r"from every start with $p<\rho$ and $A$ above the bound $A$ grows without end, and the speed vanishes only if $\psi\to\pi$; for every $A$ below the bound the particle comes to rest if $\alpha$ is small enough",
    Beyond::printed,
    escapes,
);

pub(crate) const ALPHA_GROWS: Statement<Beyond> = Statement::shown(
    Printed,
    r"from every start with $p<\rho$ and $A>1$, also one that comes straight in, $\xi=\rho\cos\psi$ grows without end, so that $p/\tau\to\infty$ while $\rho-p$ grows at most as $\tau$, and $\mathrm e^{-2\alpha}=\frac{\rho-p}{\rho+p}\to0$",
    Beyond::printed,
    alpha_grows,
);

/// (89) for the velocity p (cos χ, sin χ).
pub(crate) fn acceleration() -> [Expr; 2] {
    let [x, y, p, chi] = symbols(["x", "y", "p", "χ"]);
    motion::eq89_acceleration([x, y], [p * chi.cos(), p * chi.sin()])
}

/// A particle on a bounded path beyond `bound` is pushed outwards for good, at rest or not: friction is 1 at most.
pub(crate) fn pushed(bound: Expr, acceleration: [Expr; 2]) -> Proof {
    let ring = || {
        let mut ring = Ring::of(["x", "y"]);
        let p = ring.symbol("p");
        for name in ["χ", "θ"] {
            ring.angle(name);
        }
        ring.root_is(&(&p * &p), 2, &p)?;
        Ok(ring)
    };
    Proof::in_ring(
        "A motion on a bounded path that never rests converges, not beyond the bound",
        ring(),
        |p| {
            p.shows("If, by (89), ρ stays bounded and the particle never comes to rest, its place converges, not to one beyond ρ = 1, the bound of (139), and p → 0.");
            rest_on(p, &[&turntable::EQ89, &turntable::EQ103])?;
            p.note(
                "The bound, of (139), beyond which static friction holds nothing",
                bound.to_string(),
            );
            p.remark("χ is the direction of the velocity, (p cos χ, p sin χ)");
            p.note(
                "Let ρ stay bounded",
                "ρ² − p² is bounded too, and grows by (103) at the rate 2p: so it converges, and with it the length of the path, and the place. As ρ converges, so does p, to 0",
            );
            let [x, y, speed, chi, theta] = symbols(["x", "y", "p", "χ", "θ"]);
            let outwards = [theta.cos(), theta.sin()];
            let along = |[a, b]: [Expr; 2]| a * outwards[0] + b * outwards[1];
            let push = p.read(
                "The component of (89) in the direction θ of that place",
                along(acceleration),
            )?;
            let least = along([x, y]) - bound - 2 * speed;
            let least = p.read(
                "That of the position, less the bound and 2p: in the end above a positive number, if the place is beyond the bound",
                least,
            )?;
            let half = (chi - theta) / 2;
            let squares =
                2 * speed * (half.sin() + half.cos()).squared() + 2 * half.sin().squared();
            let squares = p.read(
                "What Coriolis force and friction are above −2p and −1, two squares",
                squares,
            )?;
            p.equal(
                "The first exceeds the second by these",
                &(&push - &least),
                &squares,
            )?;
            p.note(
                "Where the particle stops for an instant",
                "p = 0, and friction, whatever its direction, is 1 at most: this holds there too",
            );
            Ok(())
        },
    )
}

pub(crate) fn comes_to_rest(bound: Expr) -> Proof {
    let ring = || {
        let mut ring = Ring::of(["p", "ρ"]);
        ring.angle("ψ");
        Ok(ring)
    };
    Proof::in_ring(
        "Where p + ρ is below the bound the particle comes to rest",
        ring(),
        |p| {
            p.shows("If p + ρ is below 1, the bound of (139), at some time, the particle comes to rest after a finite time, with ρ below the bound, and stays.");
            rest_on(p, &[&turntable::EQ107, &turntable::EQ108])?;
            let [speed, rho, psi] = symbols(["p", "ρ", "ψ"]);
            let rate = motion::eq107_p_rate::tree() + motion::eq108_rho_rate::tree();
            let rate = p.read("The rate of p + ρ by (107) and (108)", rate)?;
            let sum = speed + rho;
            let fall = bound - sum + 2 * sum * (psi / 2).sin().squared();
            p.reads_as(&rate, "at most p + ρ less the bound", -fall)?;
            p.rests_on(&eq139(bound))?;
            Ok(())
        },
    )
}

pub(crate) fn stops_along(ahead: Expr) -> Proof {
    polar("Where a particle stops, ψ → 0 or ψ → π", |p| {
        p.shows("If p → 0 after a finite time, with ρ > 0 there, then, up to whole turns, ψ → 0 or ψ → π.");
        rest_on(p, &[&turntable::EQ98, &turntable::EQ99, &turntable::EQ101])?;
        let [speed, ell, rho, xi] = symbols(["p", "ℓ", "ρ", "ξ"]);
        p.identity(
            ("dξ/dτ by (101)", ahead),
            (
                "a square over p, so that ξ never falls",
                (speed + ell).squared() / speed,
            ),
        )?;
        let least = ell.squared() / (2 * speed) - speed;
        p.identity(
            ("dξ/dτ less ℓ²/(2p), plus p", ahead - least),
            (
                "which is not negative",
                (2 * speed + ell).squared() / (2 * speed),
            ),
        )?;
        p.identity(("ℓ²", ell.squared()), ("", rho.squared() - xi.squared()))?;
        p.note(
            "Let p → 0 as τ → T, a finite time, at ρ > 0",
            "ξ converges, as it never falls and is ρ at most; so do ρ and ℓ². By (99) p ≤ (1 + R)(T − τ) with the largest ρ as R: were the limit of ℓ² not 0, the integral of ℓ²/(2p) would be infinite, and ξ unbounded",
        );
        Ok(())
    })
}

pub(crate) fn polar(
    title: &str,
    steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>,
) -> Proof {
    Proof::in_ring(title, Setting::polar().map(|setting| setting.ring), steps)
}

fn escapes(beyond: Beyond) -> Proof {
    let Beyond {
        bound,
        acceleration,
        ahead,
    } = beyond;
    polar("Beyond the bound of (127) the particle escapes", |p| {
        rest_on(p, &[&turntable::EQ110])?;
        p.rests_on(&pushed(bound, acceleration))?;
        p.rests_on(&stops_along(ahead))?;
        let [xi] = symbols(["ξ"]);
        p.identity(
            ("dp/dτ by (99)", motion::eq99_p_rate::tree()),
            ("ξ less the bound", xi - bound),
        )?;
        p.note(
            "Where ψ → 0",
            "ξ → ρ, which is above the bound, and p grows: so p → 0 with ψ → π only, where the particle comes straight in",
        );
        p.rests_on(&comes_to_rest(bound))?;
        p.rests_on(&sum(motion::eq111_p::tree(), motion::eq112_rho::tree()))?;
        Ok(())
    })
}

fn sum(p_formula: Expr, rho: Expr) -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        ring.symbol("A");
        ring.hyperbolic("α");
        Ok(ring)
    };
    Proof::in_ring("(111) and (112): ρ + p and ρ − p", ring(), |p| {
        p.shows("By (111) and (112): ρ + p = A exp(α) and ρ − p = A exp(−α).");
        let [a, alpha] = symbols(["A", "α"]);
        for (says, combined, power) in [
            ("ρ + p", rho + p_formula, alpha),
            ("ρ − p", rho - p_formula, -alpha),
        ] {
            p.identity(
                (says, combined),
                ("A times an exponential", a * power.exp()),
            )?;
        }
        Ok(())
    })
}

fn alpha_grows(beyond: Beyond) -> Proof {
    polar("α grows without end", |p| {
        p.rests_on(&escapes(beyond))?;
        rest_on(
            p,
            &[&turntable::EQ103, &turntable::EQ107, &turntable::EQ108],
        )?;
        p.rests_on(&stops_along(beyond.ahead))?;
        let [speed, rho, psi, ell, xi] = symbols(["p", "ρ", "ψ", "ℓ", "ξ"]);
        let lag = motion::eq108_rho_rate::tree() - motion::eq107_p_rate::tree();
        let lag = p.read("The rate of ρ − p by (107) and (108)", lag)?;
        let below = p.read("1 less that", 1 - (rho - speed) * psi.cos())?;
        p.equal("It is 1 less (ρ − p) cos ψ ≥ 0", &lag, &below)?;
        let rate = p.read("dξ/dτ by (101)", beyond.ahead)?;
        let weight = p.read("p (p − ℓ)²", speed * (speed - ell).squared())?;
        let size = rho.squared() - speed.squared();
        let square = p.read("(A² − ξ²)²", (size - xi.squared()).squared())?;
        p.equal(
            "That is the product of the two before",
            &(&rate * &weight),
            &square,
        )?;
        p.rests_on(&sum(motion::eq111_p::tree(), motion::eq112_rho::tree()))?;
        Ok(())
    })
}

fn relaxes(formula: Expr) -> Proof {
    let near = || {
        let mut ring = Ring::new();
        ring.symbol("A");
        ring.hyperbolic("α");
        ring.angle("ψ");
        Ok(ring)
    };
    let rate = Proof::in_ring("(126) and (114)", near(), |p| {
        p.shows("The right side of (126) less that of (114) is 2 sin²(ψ/2) + 2 sinh²(α/2)/A, which vanishes with ψ and α.");
        rest_on(p, &[&turntable::EQ114])?;
        let [a, alpha, psi] = symbols(["A", "α", "ψ"]);
        let rate = p.read("(114)", motion::eq114_alpha_rate::tree())?;
        let stated = p.read("(126)", formula)?;
        let small = 2 * (psi / 2).sin().squared() + 2 * (alpha / 2).sinh().squared() / a;
        let small = p.read("Two terms that vanish with ψ and α", small)?;
        p.equal("They differ by these", &(&stated - &rate), &small)
    });
    polar("ψ relaxes near α = 0", |p| {
        rest_on(
            p,
            &[
                &turntable::EQ107,
                &turntable::EQ108,
                &turntable::EQ109,
                &turntable::EQ124,
            ],
        )?;
        let [speed, rho, psi] = symbols(["p", "ρ", "ψ"]);
        let turn = p.read("dψ/dτ by (109)", motion::eq109_psi_rate::tree())?;
        let along = p.ring().along(&[("ψ", turn)])?;
        let tangent = p.read("t = tan(ψ/2)", (psi / 2).tan())?;
        let fall = p.derivative("dt/dτ", &tangent, &along)?;
        let t = (psi / 2).tan();
        let parts = speed * (1 + t.squared()) - (rho + speed.squared() / rho) * t;
        let parts = p.read("p (1 + t²) − (ρ + p²/ρ) t", parts)?;
        let by = p.ring().read(speed)?;
        p.equal("By s with dτ = p ds, dt/ds is that", &(&fall * &by), &parts)?;
        let faster = p.read("dp/dτ by (107)", motion::eq107_p_rate::tree())?;
        let most = p.read("1 + ρ", 1 + rho)?;
        let spare = 2 + 2 * rho * (psi / 2).sin().squared();
        let spare = p.read("2 + 2ρ sin²(ψ/2), which is not negative", spare)?;
        p.equal("It lies below 1 + ρ by that", &(&most - &faster), &spare)?;
        p.rests_on(&rate)
    })
}

attempts![
    &ESCAPES,
    &RELAXES = Statement::shown(
        Within,
        r"for every $A>0$ at the start, $\lvert\psi\rvert<\pi$ and $\varepsilon>0$, however small: if $\alpha$ is small enough at the start, then within a time below $\varepsilon$ the angle $\psi$ comes closer than $\varepsilon$ to 0 and so to $\psi_1$, stays there while $\alpha$ is small, and $\mathrm d\alpha/\mathrm d\tau$ is then as close to (126)",
        printed::eq126_alpha_rate::tree,
        relaxes
    ),
    &ALPHA_GROWS
];
