//! The sliding sphere, (63) to (79): rates by the laws of motion against printed rates.

use super::{AXES, BY_COMPONENTS, BY_DEFINITION, Components, Vectorial};
use crate::claims::sphere::prelude::*;
use crate::paper::general::eq1_velocity_rate;
use crate::paper::sphere as paper;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Force {
    /// Coulomb's, while the sphere slides.
    Sliding,
    /// That which keeps the slip velocity 0.
    Rolling,
    Any,
}

pub(super) struct Body {
    pub(super) ring: Ring,
    /// d/dt along the motion.
    motion: Derivation,
}

impl Body {
    fn new(friction: Force) -> Result<Self, ExactError> {
        let mut ring = Ring::new();
        let [m, inertia, radius, mu, k] = ring.symbols(["m", "I", "R", "μ", "k"]);
        let [ax, ay] = ring.symbols(["A_x", "A_y"]);
        let [vx, vy] = ring.symbols(["v_x", "v_y"]);
        let [wx, wy, _] = ring.symbols(["ω_x", "ω_y", "ω_z"]);
        ring.symbols(["ν_x", "ν_y", "c_x", "c_y", "t"]);
        // k stands for μg; the roots of k and R serve (69) to (71).
        let g = ring.divide(&k, &mu)?;
        ring.define("g", g)?;
        ring.root(&k, 2)?;
        ring.root(&radius, 2)?;
        let one = Rational::int(1);
        let kappa = ring.divide(&inertia, &(&m * &radius.pow(2)))?;
        ring.define("b", &one + &ring.divide(&one, &kappa)?)?;
        ring.define("κ", kappa)?;
        // The velocity of the point at R = (0, 0, −R) from the centre: (v_x − R ω_y, v_y + R ω_x).
        let slip = [&vx - &(&radius * &wy), &vy + &(&radius * &wx)];
        let square = slip[0].pow(2) + slip[1].pow(2);
        let size = ring.root(&square, 2)?;
        let force = match friction {
            Force::Sliding => {
                let pressed = &m * &k;
                let along = |w: &Rational| ring.divide(&-(&pressed * w), &size);
                [along(&slip[0])?, along(&slip[1])?]
            }
            Force::Rolling => {
                let held = |a: &Rational| ring.divide(&(&m * a), &ring.named("b")?);
                [held(&ax)?, held(&ay)?]
            }
            Force::Any => ring.symbols(["F_x", "F_y"]),
        };
        // Newton: m dv/dt = F − m A. Euler: I dω/dt = R × F = (R F_y, −R F_x, 0).
        let lever = ring.divide(&radius, &inertia)?;
        // dν/dt = γ dτ/dt.
        let clock = ring.read(tau_rate())?;
        let gamma = |a: &Rational| ring.divide(&(a * &clock), &k);
        let rates = [
            ("v_x", ring.divide(&force[0], &m)? - &ax),
            ("v_y", ring.divide(&force[1], &m)? - &ay),
            ("ω_x", &lever * &force[1]),
            ("ω_y", -(&lever * &force[0])),
            ("ω_z", Rational::int(0)),
            ("ν_x", gamma(&ax)?),
            ("ν_y", gamma(&ay)?),
        ];
        let motion = ring.along(&rates)?;
        Ok(Body { ring, motion })
    }
}

fn prove(
    title: &str,
    friction: Force,
    steps: impl FnOnce(&mut Prover<'_>, &Body) -> Result<(), Obstacle>,
) -> Proof {
    match Body::new(friction) {
        Err(error) => Proof::impossible(title, error),
        Ok(body) => Proof::of(title, &body.ring, |p| {
            match friction {
                Force::Sliding => {
                    p.remark("k stands for μ g");
                }
                Force::Rolling => p.note("Friction", "F = mA/b, which keeps the slip velocity 0"),
                Force::Any => p.note("Friction", "any force F at the contact"),
            }
            p.note("Newton", "m dv/dt = F − m A");
            p.note("Euler", "I dω/dt = (R F_y, −R F_x, 0)");
            steps(p, &body)
        }),
    }
}

/// d(quantity)/dt times `factor` against the printed rate, by components.
fn rates(
    title: &str,
    friction: Force,
    quantity: [Expr; 3],
    factor: Expr,
    printed: Components,
) -> Proof {
    prove(title, friction, |p, body| {
        for ((axis, q), printed) in AXES.iter().zip(quantity).zip(printed) {
            let q = p.read(&format!("The quantity {axis}"), q)?;
            let rate = p.derivative("Its rate", &q, &body.motion)?;
            let factor = p.read("The factor", factor)?;
            let printed = p.read(&format!("Printed {axis}"), printed)?;
            p.equal("The rate is the printed one", &(rate * factor), &printed)?;
        }
        Ok(())
    })
}

fn zero() -> Expr {
    int(0)
}
fn acceleration() -> [Expr; 3] {
    let [x, y] = symbols(["A_x", "A_y"]);
    [x, y, zero()]
}
fn velocity() -> [Expr; 3] {
    let [x, y] = symbols(["v_x", "v_y"]);
    [x, y, zero()]
}
fn omega() -> [Expr; 3] {
    symbols(["ω_x", "ω_y", "ω_z"])
}
fn contact() -> [Expr; 3] {
    paper::eq61_contact::tree()
}
fn slip() -> [Expr; 3] {
    paper::slip(velocity(), omega(), contact())
}
fn mu_g_radius() -> [Expr; 3] {
    symbols(["μ", "g", "R"])
}
/// u by (71).
fn u() -> [Expr; 3] {
    let [mu, g, radius] = mu_g_radius();
    paper::eq71_slip(radius, mu, g, slip())
}
/// γ by (72).
fn gamma() -> [Expr; 3] {
    let [mu, g, _] = mu_g_radius();
    paper::eq72_acceleration(mu, g, acceleration())
}
/// dτ/dt by (69).
fn tau_rate() -> Expr {
    let [mu, g, radius] = mu_g_radius();
    paper::eq69_time(radius, mu, g, int(1))
}
fn per_tau() -> Expr {
    1 / tau_rate()
}
/// dρ/dτ by (68) and (69).
fn rho_rate() -> [Expr; 3] {
    paper::eq68_position(symbol("R"), velocity()).map(|c| c / tau_rate())
}
fn nu() -> [Expr; 3] {
    let [x, y] = symbols(["ν_x", "ν_y"]);
    [x, y, zero()]
}
pub(super) fn sum(a: [Expr; 3], b: [Expr; 3]) -> [Expr; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn eq64() -> Components {
    let [mu, g, _] = mu_g_radius();
    paper::eq64_spin_rate(mu, g, velocity(), omega(), contact()).into()
}

pub(super) fn eq73() -> Components {
    paper::eq73_velocity_rate(gamma(), u()).into()
}

pub(super) fn eq74() -> Components {
    paper::eq74_slip_rate(symbol("b"), gamma(), u()).into()
}

pub(crate) const EQ74: Vectorial = Vectorial::new(Printed, BY_COMPONENTS, eq74, |printed| {
    rates("(74): du/dτ", Force::Sliding, u(), per_tau(), printed)
});

/// ζ₃ by (70).
fn zeta() -> [Expr; 3] {
    let [mu, g, radius] = mu_g_radius();
    paper::eq70_spin(radius, mu, g, omega())
}

fn prove_eq75(formula: Components) -> Proof {
    prove("(75): ζ", Force::Any, |p, _| {
        for ((axis, zeta), formula) in AXES.iter().zip(zeta()).zip(formula) {
            p.identity(
                (&format!("ζ {axis}, by (70)"), zeta),
                (&format!("The formula {axis}"), formula),
            )?;
        }
        Ok(())
    })
}

fn upright(p: &mut Prover<'_>, along_z: Expr) -> Result<(), Obstacle> {
    let along_z = p.read("Along z", along_z)?;
    p.zero("Nothing moves", &along_z)
}

/// dv/dt of a particle with the velocity w and the friction coefficient bμ, by (1).
pub(crate) const S3_REDUCTION: Vectorial = Vectorial::new(
    Printed,
    BY_COMPONENTS,
    || {
        let [mu, g, _] = mu_g_radius();
        let ([ax, ay, _], [wx, wy, _]) = (acceleration(), slip());
        eq1_velocity_rate([ax, ay], symbol("b") * mu, g, [wx, wy]).into()
    },
    |particle| {
        prove(
            "The slip velocity moves as a particle's velocity with bμ for μ",
            Force::Sliding,
            |p, body| {
                for ((axis, w), particle) in AXES.iter().zip(slip()).zip(particle) {
                    let w = p.read(&format!("w {axis}"), w)?;
                    let rate = p.derivative("Its rate", &w, &body.motion)?;
                    p.reads_as(&rate, &format!("(1) {axis}, with bμ"), particle)?;
                }
                Ok(())
            },
        )
    },
);

pub(super) fn prove_rolling() -> Proof {
    prove(
        "A sphere rolls on where a particle with bμ stays at rest",
        Force::Any,
        |p, body| {
            p.shows("If w, the velocity of the sphere's lowest point relative to the plane, is 0, the friction F = m A/b keeps it 0; its size is μmg at most exactly if |A| ≤ bμg.");
            for ((axis, w), a) in AXES.iter().zip(slip()).zip(acceleration()).take(2) {
                let w = p.read(&format!("w {axis}"), w)?;
                let rate = p.derivative("Its rate", &w, &body.motion)?;
                let force = ["F_x", "F_y"][usize::from(*axis != AXES[0])];
                let force = symbol("b") * symbol(force) / symbol("m");
                p.reads_as(&rate, "", force - a)?;
            }
            Ok(())
        },
    )
}

fn spin_constant(friction: Force, stated: &[Expr]) -> Proof {
    let title = "ζ₃ is constant and enters nothing else";
    prove(title, friction, |p, body| {
        let spin = p.read("The vertical spin", omega()[2])?;
        let rate = p.derivative("Its rate", &spin, &body.motion)?;
        for stated in stated {
            let stated = p.read("Stated", *stated)?;
            p.equal("The rate is the stated one", &rate, &stated)?;
        }
        for q in [velocity()[0], velocity()[1], omega()[0], omega()[1]] {
            let q = p.read("Of", q)?;
            let rate = p.derivative("The rate", &q, &body.motion)?;
            let slope = p.slope("Its slope by ω_z", &rate, "ω_z")?;
            p.reads_as(&slope, "", int(0))?;
        }
        Ok(())
    })
}

attempts![
    &EQ63 = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        || {
            let [mu, g, _] = mu_g_radius();
            paper::eq63_velocity_rate(acceleration(), mu, g, velocity(), omega(), contact()).into()
        },
        |printed| rates("(63): d²r/dt²", Force::Sliding, velocity(), int(1), printed),
    ),
    &EQ64 = Vectorial::new(Printed, BY_COMPONENTS, eq64, |printed| {
        let factor = symbol("κ") * symbol("R").squared();
        rates("(64): κ R² dω/dt", Force::Sliding, omega(), factor, printed)
    }),
    &EQ65 = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        || {
            let [mu, g, _] = mu_g_radius();
            let kappa = symbol("κ");
            paper::eq65_spin_slip_rate(kappa, mu, g, velocity(), omega(), contact()).into()
        },
        |printed| {
            let spin_share = paper::slip([zero(); 3], omega(), contact());
            rates(
                "(65): d(ω × R)/dt",
                Force::Sliding,
                spin_share,
                int(1),
                printed,
            )
        },
    ),
    &EQ66 = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        || {
            let [mu, g, _] = mu_g_radius();
            paper::eq66_slip_rate(acceleration(), symbol("b"), mu, g, slip()).into()
        },
        |printed| {
            rates(
                "(66): d(dr/dt + ω × R)/dt",
                Force::Sliding,
                slip(),
                int(1),
                printed,
            )
        },
    ),
    &EQ73 = Vectorial::new(Printed, BY_COMPONENTS, eq73, |printed| {
        rates(
            "(73): d²ρ/dτ²",
            Force::Sliding,
            rho_rate(),
            per_tau(),
            printed,
        )
    }),
    &EQ74,
    &EQ75 | &CORRECTED_75 = Vectorial::new(BY_COMPONENTS)(
        (
            || paper::eq75_spin(zeta()[2], u(), rho_rate()).into(),
            prove_eq75
        ) | (
            || corrected::spin(zeta()[2], u(), rho_rate()).into(),
            prove_eq75
        )
    ),
    &EQ77 = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        || paper::eq77_rate(u()).into(),
        |printed| {
            let quantity = sum(rho_rate(), nu());
            rates(
                "(77): d(dρ/dτ + ν)/dτ",
                Force::Sliding,
                quantity,
                per_tau(),
                printed,
            )
        },
    ),
    &EQ78 = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        || paper::eq78_rate(symbol("b"), u()).into(),
        |printed| {
            let quantity = sum(u(), nu());
            rates(
                "(78): d(u + ν)/dτ",
                Force::Sliding,
                quantity,
                per_tau(),
                printed,
            )
        },
    ),
    // Both sides change alike under any friction force, so that they differ by a constant.
    &EQ79 = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        || {
            let [cx, cy] = symbols(["c_x", "c_y"]);
            paper::eq79_velocity(symbol("b"), nu(), u(), [cx, cy, zero()]).into()
        },
        |printed| {
            let along_z = printed[2];
            prove("(79): dρ/dτ", Force::Any, |p, body| {
                for ((axis, own), printed) in AXES.iter().zip(rho_rate()).zip(printed).take(2) {
                    let own = p.read(&format!("dρ/dτ {axis}"), own)?;
                    let own = p.derivative("Its rate", &own, &body.motion)?;
                    let printed = p.read(&format!("Printed {axis}"), printed)?;
                    let rate =
                        p.derivative("The rate of that, c being constant", &printed, &body.motion)?;
                    p.equal("The two rates are equal", &own, &rate)?;
                }
                upright(p, rho_rate()[2])?;
                upright(p, along_z)
            })
        },
    ),
    &EQ62 = Vectorial::new(
        Printed,
        Compared::one(
            r"(64), with $\kappa$ by the definition,",
            "Euler's law for the sphere",
        ),
        paper::eq62_kappa::parts,
        |kappa| {
            let factor = kappa[0] * symbol("R").squared();
            let title = "(62): κ in κ R² dω/dt by (64)";
            rates(title, Force::Sliding, omega(), factor, eq64())
        },
    ),
    // dρ/dτ, which has the form of (68) by its linearity, makes (73) the law for the centre.
    &EQ68 = Vectorial::new(
        Printed,
        Compared::one(
            r"(73), with $\bm\rho$ by the definition,",
            "Newton's law for the sphere",
        ),
        || paper::eq68_position(symbol("R"), velocity()).into(),
        |rate| {
            let rho_rate = [0, 1, 2].map(|i| rate[i] / tau_rate());
            prove("(68): d²ρ/dτ² by (73)", Force::Sliding, |p, body| {
                for ((axis, rate), stated) in AXES.iter().zip(rho_rate).zip(eq73()) {
                    let rate = p.read(&format!("dρ/dτ {axis}"), rate)?;
                    let change = p.derivative("Its rate", &rate, &body.motion)?;
                    p.reads_as(&change, "(73) times dτ/dt", stated * tau_rate())?;
                }
                upright(p, rate[2])
            })
        },
    ),
    &EQ69 = Vectorial::new(
        Printed,
        BY_DEFINITION,
        || {
            let [mu, g, radius] = mu_g_radius();
            vec![paper::eq69_time(radius, mu, g, symbol("t"))]
        },
        |tau| {
            prove(
                "(69): du/dt over dτ/dt by (74)",
                Force::Sliding,
                |p, body| {
                    let tau = p.read("τ", tau[0])?;
                    let clock = p.slope("dτ/dt", &tau, "t")?;
                    for ((axis, u), stated) in AXES.iter().zip(u()).zip(eq74()) {
                        let u = p.read(&format!("u {axis}"), u)?;
                        let rate = p.derivative("du/dt", &u, &body.motion)?;
                        let stated = p.read("(74)", stated)?;
                        p.equal("du/dt is (74) times dτ/dt", &rate, &(stated * &clock))?;
                    }
                    Ok(())
                },
            )
        },
    ),
    &EQ70 = Vectorial::new(
        Printed,
        Compared::one(
            r"$\bm\zeta\,\mathrm d\tau$, with $\tau$ by (69),",
            r"$\bm\omega\,\mathrm dt$",
        ),
        || zeta().into(),
        |zeta| {
            prove("(70): ζ dτ = ω dt", Force::Any, |p, _| {
                for ((axis, zeta), omega) in AXES.iter().zip(zeta).zip(omega()) {
                    p.identity(
                        (&format!("ζ {axis}, times dτ/dt by (69)"), zeta * tau_rate()),
                        ("", omega),
                    )?;
                }
                Ok(())
            })
        },
    ),
    &EQ71 = Vectorial::new(
        Printed,
        BY_DEFINITION,
        || u().into(),
        |slip| {
            let u = [0, 1, 2].map(|i| slip[i]);
            let stated = paper::eq74_slip_rate(symbol("b"), gamma(), u).into();
            let title = "(71): du/dτ by (74)";
            rates(title, Force::Sliding, u, per_tau(), stated)
        },
    ),
    &EQ72 = Vectorial::new(
        Printed,
        BY_DEFINITION,
        || gamma().into(),
        |pull| {
            let gamma = [0, 1, 2].map(|i| pull[i]);
            let stated = paper::eq74_slip_rate(symbol("b"), gamma, u()).into();
            let title = "(72): γ in du/dτ by (74)";
            rates(title, Force::Sliding, u(), per_tau(), stated)
        },
    ),
    &S3_REDUCTION,
    &S3_SPIN_CONSTANT = Vectorial::new(
        Printed,
        BY_COMPONENTS,
        paper::s3_zeta3_rate::parts,
        |stated| match spin_constant(Force::Rolling, &stated) {
            rolling if rolling.holds() => spin_constant(Force::Sliding, &stated),
            fails => fails,
        },
    ),
];
