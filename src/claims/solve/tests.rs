//! The calculators against values from elsewhere: separate integrations of Newton's law in 30-digit arithmetic by
//! extrapolation, and slips followed there from event to event.

use super::constant::At;
use super::*;
use std::f64::consts::{PI, TAU};

/// Each field agrees with a number, to ten digits of its size.
#[track_caller]
fn agrees<T: Fields + Clone>(answer: &Answer<T>, expected: &[(&str, f64)]) {
    let fields = answer.best.fields();
    for (name, wanted) in expected {
        let field = fields.iter().find(|f| f.name == *name).expect("a field");
        let Value::Number(found) = field.value else {
            panic!("{name} is {:?}", field.value);
        };
        let size = wanted.abs().max(field.scale);
        assert!(
            (found - wanted).abs() <= 1e-12 * size,
            "{name}: {found} {wanted}"
        );
    }
    assert!(answer.digits >= Some(11), "{:?} digits", answer.digits);
}

#[track_caller]
fn word<T: Fields + Clone>(answer: &Answer<T>) -> &'static str {
    match answer.best.fields()[0].value {
        Value::Word(word) => word,
        other => panic!("{other:?}"),
    }
}

fn constant([lambda, v0, theta0, accel]: [f64; 4], at: At) -> constant::Problem {
    constant::Problem {
        lambda,
        v0,
        theta0,
        accel,
        at,
    }
}

/// λ, v₀, θ₀, A, t; v, θ, v_x, v_y.
const LAUNCHES: [([f64; 5], [f64; 4]); 5] = [
    (
        [0.5, 1.0, 1.0, 1.0, 2.0],
        [
            1.72199677009571121,
            0.223140182408593928,
            1.67930392082028411,
            0.381065896844210729,
        ],
    ),
    (
        [1.0, 2.0, 2.5, 1.5, 3.0],
        [
            0.198856384453066627,
            8.28944641394507078e-8,
            0.198856384453065944,
            1.64840934299455359e-8,
        ],
    ),
    (
        [1.7, 1.3, 2.0, 1.0, 0.5],
        [
            0.370736752057265719,
            1.31512730233438352,
            0.0937566339913631752,
            0.358685702124548143,
        ],
    ),
    (
        [0.0, 1.0, 2.0, 1.0, 1.0],
        [
            1.08060461173627943,
            1.0,
            0.583853163452857613,
            0.909297426825681695,
        ],
    ),
    (
        [2.5, 3.0, 0.4, 0.7, 1.1],
        [
            1.79878918305014443,
            0.289939129972480837,
            1.72371002438329417,
            0.514262848063856765,
        ],
    ),
];

#[test]
fn launches_by_time_and_back_by_angle() {
    for ([lambda, v0, theta0, accel, t], [v, theta, vx, vy]) in LAUNCHES {
        let given = [lambda, v0, theta0, accel];
        let answer = constant(given, At::Time(t)).solve().unwrap();
        agrees(
            &answer,
            &[("v", v), ("theta", theta), ("t", t), ("vx", vx), ("vy", vy)],
        );
        let back = constant(given, At::Theta(answer.best.theta))
            .solve()
            .unwrap();
        assert!((back.best.t - t).abs() < 1e-9 * t, "{} {t}", back.best.t);
        assert_eq!(answer.best.stop_time.is_some(), lambda > 1.0);
    }
}

#[test]
fn launches_along_the_axis() {
    let at = |lambda, theta0, at| constant([lambda, 2.0, theta0, 1.0], at).solve();
    let ahead = at(0.5, 0.0, At::Time(3.0)).unwrap();
    agrees(
        &ahead,
        &[("v", 3.5), ("theta", 0.0), ("vx", 3.5), ("vy", 0.0)],
    );
    agrees(
        &at(3.0, 0.0, At::Time(0.5)).unwrap(),
        &[("v", 1.0), ("stop_time", 1.0)],
    );
    agrees(&at(1.0, 0.0, At::Time(5.0)).unwrap(), &[("v", 2.0)]);
    let back = at(0.5, PI, At::Time(1.0)).unwrap();
    agrees(
        &back,
        &[("v", 0.5), ("theta", PI), ("vx", -0.5), ("vy", 0.0)],
    );
    assert_eq!(back.best.stop_time, None);
    let turned = at(0.5, PI, At::Time(3.0)).unwrap();
    agrees(&turned, &[("v", 0.5 * (3.0 - 4.0 / 3.0)), ("theta", 0.0)]);
    agrees(
        &at(0.5, PI, At::Theta(0.0)).unwrap(),
        &[("v", 0.0), ("t", 4.0 / 3.0)],
    );
    agrees(
        &at(1.0, PI, At::Time(7.0)).unwrap(),
        &[("v", 0.0), ("theta", PI), ("stop_time", 1.0)],
    );
    agrees(
        &at(2.0, PI, At::Theta(PI)).unwrap(),
        &[("v", 2.0), ("t", 0.0)],
    );
    for (lambda, theta0, theta) in [
        (0.5, 0.0, 0.1),
        (2.0, PI, 0.0),
        (0.5, PI, 1.0),
        (0.5, 1.0, 0.0),
        (0.5, 1.0, 2.0),
        (2.0, 1.0, -0.5),
    ] {
        let error = at(lambda, theta0, At::Theta(theta)).unwrap_err();
        assert!(
            matches!(error, SolveError::Parameter { name: "theta", .. }),
            "{error}"
        );
    }
}

#[test]
fn a_stopped_particle_keeps_the_angle_to_which_it_tended() {
    let rest = constant([1.5, 1.0, 2.0, 1.0], At::Time(9.0))
        .solve()
        .unwrap();
    agrees(
        &rest,
        &[
            ("v", 0.0),
            ("theta", 0.0),
            ("t", 9.0),
            ("stop_time", (1.5 + 2_f64.cos()) / 1.25),
        ],
    );
}

#[test]
fn bad_parameters_are_named() {
    let good = [0.5, 1.0, 1.0, 1.0];
    for (i, name, bad) in [
        (0, "lambda", -1.0),
        (1, "v0", 0.0),
        (2, "theta0", 4.0),
        (3, "accel", f64::NAN),
    ] {
        let mut given = good;
        given[i] = bad;
        match constant(given, At::Time(1.0)).solve() {
            Err(SolveError::Parameter { name: found, .. }) => assert_eq!(found, name),
            other => panic!("{other:?}"),
        }
    }
    let error = constant(good, At::Time(-1.0)).solve().unwrap_err();
    assert_eq!(error.to_string(), "time = -1 must be between 0 and 1e40");
}

#[test]
fn spheres_by_time_and_back_by_angle() {
    // γ, u₀, θ₀, κ, τ; u, θ, u_x, u_y, ζ_x, ζ_y.
    let cases = [
        (
            [2.0, 1.0, 1.0, 0.4, 0.3],
            [
                0.395160869550947802,
                0.41717493819888073,
                0.361270784153981064,
                0.160111003185380144,
                -0.486685701158940259,
                0.556451086938684753,
            ],
        ),
        (
            [10.0, 2.0, 2.5, 0.4, 0.5],
            [
                2.59459356919042337,
                0.116172000759477033,
                2.57710501968948439,
                0.300741594688135071,
                -0.640144781085555655,
                0.586148392297605842,
            ],
        ),
        (
            [3.5, 1.0, 2.0, 0.4, 0.2],
            [
                0.346769580416837154,
                0.817986499640838548,
                0.237083583036020459,
                0.253062278021185295,
                -0.468739392003211714,
                0.0334068431548836816,
            ],
        ),
        (
            [1.0, 3.0, -1.2, 2.0 / 3.0, 0.7],
            [
                1.5831518406202665,
                -0.923893727313192807,
                0.954193661879354473,
                -1.26328310607266725,
                0.919700491097407077,
                0.499727760930399756,
            ],
        ),
    ];
    for ([gamma, u0, theta0, kappa, tau], [u, theta, u_x, u_y, zeta_x, zeta_y]) in cases {
        let problem = |at| sphere::Problem {
            gamma,
            u0,
            theta0,
            kappa,
            at,
        };
        let answer = problem(At::Time(tau)).solve().unwrap();
        let slip = [
            ("u", u),
            ("theta", theta),
            ("tau", tau),
            ("u_x", u_x),
            ("u_y", u_y),
        ];
        agrees(&answer, &slip);
        agrees(&answer, &[("zeta_x", zeta_x), ("zeta_y", zeta_y)]);
        let back = problem(At::Theta(answer.best.theta)).solve().unwrap();
        assert!((back.best.tau - tau).abs() < 1e-10, "{}", back.best.tau);
        assert_eq!(answer.best.rolls_at.is_some(), 1.0 + 1.0 / kappa > gamma);
    }
}

#[test]
fn a_sphere_rolls_on_with_the_spin_that_rolling_gives() {
    let problem = |at| sphere::Problem {
        gamma: 1.0,
        u0: 1.0,
        theta0: PI,
        kappa: 0.4,
        at,
    };
    let answer = problem(At::Time(2.0)).solve().unwrap();
    // The slip is 0 at 1/(γ + b). κ dζ_y/dτ is the direction of the slip until then, and γ/b in rolling.
    let rolls_at = 1.0 / 4.5;
    let zeta_y = ((2.0 - rolls_at) / 3.5 - rolls_at) / 0.4;
    agrees(&answer, &[("u", 0.0), ("rolls_at", rolls_at)]);
    agrees(&answer, &[("zeta_x", 0.0), ("zeta_y", zeta_y)]);
}

#[test]
fn sinusoidal_motions() {
    let solve = |lambda0| sinusoidal::Problem { lambda0 }.solve().unwrap();
    let small = solve(0.3);
    assert_eq!(word(&small), "two-zeros");
    agrees(
        &small,
        &[
            ("positive_start", 1.08010143763095871),
            ("positive_end", 1.08010143763095871 + PI),
            ("rest_fraction", 0.0),
        ],
    );
    let large = solve(0.7);
    assert_eq!(word(&large), "two-rests");
    let (start, length) = (0.775397496610753064, 2.44440822788756088);
    agrees(
        &large,
        &[
            ("positive_start", start),
            ("positive_end", start + length),
            ("rest_fraction", 1.0 - length / PI),
        ],
    );
    assert_eq!(word(&solve(1.0)), "rest");
    assert_eq!(solve(2.0).best, sinusoidal::AT_REST);
    assert_eq!(solve(0.5).best.regime, "two-zeros");
    assert_eq!(solve(0.5371).best.regime, "two-rests");
    assert!(sinusoidal::Problem { lambda0: 0.0 }.solve().is_err());
}

#[test]
fn pulses() {
    let solve = |eta, lambda0| periodic::Problem { eta, lambda0 }.solve().unwrap();
    let small = solve(0.5, 0.3);
    assert_eq!(word(&small), "two-zeros");
    agrees(
        &small,
        &[
            ("positive_start", 0.1 * PI),
            ("positive_end", 1.1 * PI),
            ("w_max", 0.7 * 0.4 * PI),
        ],
    );
    let large = solve(0.5, 0.8);
    assert_eq!(word(&large), "two-rests");
    agrees(
        &large,
        &[
            ("positive_start", 0.0),
            ("positive_end", 0.625 * PI),
            ("rest_fraction", 0.375),
            ("w_max", 0.1 * PI),
        ],
    );
    for (eta, lambda0, regime) in [
        (1.0, 0.999, "two-zeros"),
        (0.0, 0.1, "rest"),
        (0.5, 1.0, "rest"),
        (0.5, 0.5, "two-zeros"),
        (1.0, 0.2, "two-zeros"),
    ] {
        assert_eq!(word(&solve(eta, lambda0)), regime, "{eta} {lambda0}");
    }
}

#[test]
fn anisotropic_motions() {
    let solve = |q, lambda0| anisotropic::Problem { q, lambda0 }.solve().unwrap();
    // q, λ₀, region, positive, negative, rests, drift.
    let cases = [
        (
            1.0,
            0.7,
            "III",
            [
                2.44440822788756088,
                2.44440822788756088,
                0.697184425702232354,
                0.697184425702232354,
            ],
            0.0,
        ),
        (
            2.0,
            0.1,
            "I",
            [4.18879020478639099, TAU - 4.18879020478639099, 0.0, 0.0],
            3.71286231174724011 - 0.664524183666615762,
        ),
        (
            2.0,
            0.45,
            "III",
            [
                3.49700812035417068,
                1.3626632794559084,
                0.297588709186960382,
                1.12592519818254702,
            ],
            1.55402018673275036 - 0.0459351760774843267,
        ),
        (
            2.0,
            0.7,
            "IV",
            [2.44440822788756088, 0.0, TAU - 2.44440822788756088, 0.0],
            0.432493939723773684,
        ),
        (
            6.0,
            0.12,
            "II",
            [
                4.99623622454478281,
                0.684227688027008401,
                0.0,
                0.602731384607795266,
            ],
            4.50183233899274579 - 0.0179113801534324539,
        ),
        (2.0, 1.5, "V", [0.0, 0.0, TAU, 0.0], 0.0),
        (
            0.5,
            0.5,
            "I",
            [TAU - 4.18879020478639099, 4.18879020478639099, 0.0, 0.0],
            0.545505758197503266 - 3.04787669167617081,
        ),
        (
            0.5,
            1.4,
            "IV",
            [0.0, 2.44440822788756088, 0.0, TAU - 2.44440822788756088],
            -0.432493939723773684,
        ),
    ];
    for (q, lambda0, region, [positive, negative, after, before], drift) in cases {
        let answer = solve(q, lambda0);
        assert_eq!(word(&answer), region, "{q} {lambda0}");
        agrees(
            &answer,
            &[
                ("positive", positive),
                ("negative", negative),
                ("rest_after_positive", after),
                ("rest_after_negative", before),
                ("drift_per_period", drift),
            ],
        );
        assert_eq!(answer.by_motion.unwrap().region, region);
    }
}

#[test]
fn formula_and_motion_name_the_same_region_all_over_the_plane() {
    for i in 0..40 {
        for j in 0..40 {
            let (q, lambda0) = (
                libm::exp(-1.2 + 0.09 * f64::from(i)),
                0.0131 + 0.0333 * f64::from(j),
            );
            let answer = anisotropic::Problem { q, lambda0 }.solve().unwrap();
            assert!(answer.digits >= Some(10), "{q} {lambda0}: {answer:?}");
        }
    }
}

#[test]
fn fates_on_the_table() {
    let polar = |rho, p, psi| turntable::Problem::Polar { rho, p, psi };
    // ρ, p, ψ; σ, τ.
    for ([rho, p, psi], [sigma, tau]) in [
        (
            [0.5, 0.3, 1.0],
            [0.538851387112794361, 0.470192897394794528],
        ),
        ([0.3, 0.3, -2.0], [0.299937330727943413, 0.3249383022484465]),
        ([0.0, 0.6, 0.0], [0.189738976686485434, 0.67888282451946287]),
        (
            [0.9, 0.05, 2.5],
            [0.899556231418296373, 0.0677976271049914194],
        ),
        ([0.2, 0.9, 0.7], [0.608522577001855441, 1.38305392986907653]),
        ([0.7, 0.0, 0.0], [0.7, 0.0]),
        ([1.0, 0.0, 3.0], [1.0, 0.0]),
    ] {
        let answer = polar(rho, p, psi).fate().unwrap();
        assert_eq!(word(&answer), "rest");
        agrees(&answer, &[("sigma", sigma), ("tau_rest", tau)]);
    }
    for start in [
        polar(1.5, 0.2, 1.0),
        polar(1.0 + 1e-9, 0.0, 0.0),
        polar(0.3, 5.0, 0.0),
    ] {
        let answer = start.fate().unwrap();
        assert_eq!((word(&answer), answer.digits), ("escape", None));
    }
}

#[test]
fn the_three_ways_to_give_a_start_agree() {
    let (rho, p, psi): (f64, f64, f64) = (0.5, 0.3, 1.0);
    let polar = turntable::Problem::Polar { rho, p, psi };
    let hyperbolic = turntable::Problem::Hyperbolic {
        a: (rho * rho - p * p).sqrt(),
        alpha: (p / rho).atanh(),
        psi,
    };
    let cartesian = turntable::Problem::Cartesian {
        position: [0.0, rho],
        velocity: [p * psi.sin(), p * psi.cos()],
    };
    for other in [hyperbolic, cartesian] {
        agrees(
            &other.fate().unwrap(),
            &[("sigma", polar.fate().unwrap().best.sigma.unwrap())],
        );
    }
}

#[test]
fn moments_on_the_table() {
    let at = |rho, p, psi, tau| turntable::Problem::Polar { rho, p, psi }.at(tau).unwrap();
    agrees(
        &at(0.5, 0.3, 1.0, 0.2),
        &[
            ("x", 0.523613356567097989),
            ("y", -0.0389484305275615018),
            ("vx", 0.0832720051238917299),
            ("vy", -0.132866269235518547),
        ],
    );
    agrees(
        &at(2.0, 1.0, 1.0, 5.0),
        &[
            ("x", -8.0313241513683697),
            ("y", -3.89840095043097695),
            ("vx", -4.89126994242317159),
            ("vy", 4.69232263106763738),
        ],
    );
    agrees(
        &at(0.5, 0.3, 1.0, 0.0),
        &[
            ("x", 0.5),
            ("y", 0.0),
            ("rho", 0.5),
            ("p", 0.3),
            ("psi", 1.0),
        ],
    );
    agrees(
        &at(0.5, 0.3, 1.0, 3.0),
        &[("rho", 0.538851387112794361), ("p", 0.0), ("psi", 0.0)],
    );
}

#[test]
fn the_boundary_by_bisection_and_near_the_corner() {
    let solve = |alpha, psi| turntable::BoundaryProblem { alpha, psi }.solve().unwrap();
    assert_eq!(solve(0.0, 1.0).best.a, 1.0);
    let near = solve(1e-7, 0.5);
    assert!((near.best.a - (1.0 - 1e-7 * 0.25_f64.cos().powi(2))).abs() < 1e-13);
    for (alpha, psi) in [
        (1.1e-5, 0.0),
        (0.1, 1.0),
        (0.5, -2.0),
        (1.0, 3.0),
        (3.0, 0.3),
        (12.0, 1.0),
    ] {
        let answer = solve(alpha, psi);
        assert!(answer.digits >= Some(10), "{alpha} {psi}: {answer:?}");
    }
    assert!(solve(1e-3, 1.0).disagreement < Some(1e-8));
    // From an extrapolating integrator in extended precision, bisected to 2e-12.
    for (alpha, psi, a) in [
        (0.1, 1.0, 0.931534356734),
        (0.5, -2.0, 0.741161983501),
        (3.0, 0.3, 0.0566688626136),
    ] {
        let found = solve(alpha, psi).best.a;
        assert!((found - a).abs() < 3e-12 * a, "{found} {a}");
    }
}

#[test]
fn an_answer_is_written_with_its_fields_first() {
    let report = sinusoidal::Problem { lambda0: 2.0 }
        .solve()
        .unwrap()
        .report("sinusoidal");
    let text = serde_json::to_string(&report).unwrap();
    let begins = r#"{"version":1,"problem":"sinusoidal","regime":"rest","positive_start":null,"#;
    assert!(text.starts_with(begins), "{text}");
    assert!(text.contains(r#""by_formula":{"regime":"rest","#));
}

#[test]
fn digits_are_those_of_the_disagreement() {
    for (error, expected) in [
        (0.0, 15),
        (3e-15, 14),
        (1e-12, 12),
        (2e-11, 10),
        (0.5, 0),
        (1.0, 0),
    ] {
        assert_eq!(digits(error), expected, "{error}");
    }
}
