//! Periodic drives.

use super::*;
use crate::claims::anisotropic::simulated::Curves;
use crate::claims::solve::{anisotropic, periodic, sinusoidal};
use crate::paper::anisotropic::region;
use crate::scalar::Scalar;
use std::f64::consts::{PI, TAU};

#[test]
fn sinusoidal_motions() {
    let solve = |lambda0| sinusoidal::SinusoidalProblem { lambda0 }.solve().unwrap();
    let small = solve(0.3);
    assert_eq!(word(&small), "two-zeros");
    agrees(
        &small,
        &[
            ("positive_start", 1.0801014376309588),
            ("positive_end", 1.0801014376309588 + PI),
            ("rest_fraction", 0.0),
        ],
    );
    let large = solve(0.7);
    assert_eq!(word(&large), "two-rests");
    let (start, length) = (0.7753974966107531, 2.444408227887561);
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
    assert!(
        sinusoidal::SinusoidalProblem { lambda0: 0.0 }
            .solve()
            .is_err()
    );
}

#[test]
fn pulses() {
    let solve = |eta, lambda0| periodic::PeriodicProblem { eta, lambda0 }.solve().unwrap();
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
    for (answer, begins) in [
        (small, "by the solution below λ_c = η"),
        (large, "by (44)"),
        (solve(0.5, 1.5), "at rest"),
    ] {
        assert!(answer.note.starts_with(begins), "{}", answer.note);
    }
}

#[test]
fn anisotropic_motions() {
    let solve = |q, lambda0| {
        anisotropic::AnisotropicProblem { q, lambda0 }
            .solve()
            .unwrap()
    };
    // q, λ₀, region, positive, negative, rests, drift.
    let cases = [
        (
            1.0,
            0.7,
            "III",
            [
                2.444408227887561,
                2.444408227887561,
                0.6971844257022324,
                0.6971844257022324,
            ],
            0.0,
        ),
        (
            2.0,
            0.1,
            "I",
            [4.188790204786391, TAU - 4.188790204786391, 0.0, 0.0],
            3.71286231174724 - 0.6645241836666158,
        ),
        (
            2.0,
            0.45,
            "III",
            [
                3.4970081203541707,
                1.3626632794559084,
                0.2975887091869604,
                1.125925198182547,
            ],
            1.5540201867327503 - 0.045935176077484326,
        ),
        (
            2.0,
            0.7,
            "IV",
            [2.444408227887561, 0.0, TAU - 2.444408227887561, 0.0],
            0.4324939397237737,
        ),
        (
            6.0,
            0.12,
            "II",
            [
                4.9962362245447824,
                0.6842276880270084,
                0.0,
                0.6027213946077953,
            ],
            4.501832338992746 - 0.017911380153432455,
        ),
        (2.0, 1.5, "V", [0.0, 0.0, TAU, 0.0], 0.0),
        (
            0.5,
            0.5,
            "I",
            [TAU - 4.188790204786391, 4.188790204786391, 0.0, 0.0],
            0.5455057581975032 - 3.0478766916761706,
        ),
        (
            0.5,
            1.4,
            "IV",
            [0.0, 2.444408227887561, 0.0, TAU - 2.444408227887561],
            -0.4324939397237737,
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
            let answer = anisotropic::AnisotropicProblem { q, lambda0 }
                .solve()
                .unwrap();
            assert!(answer.digits >= Some(10), "{q} {lambda0}: {answer:?}");
        }
    }
}

#[test]
fn the_digits_of_a_small_drift_are_its_own() {
    let solve = |q, lambda0| {
        anisotropic::AnisotropicProblem { q, lambda0 }
            .solve()
            .unwrap()
    };
    // q, λ₀, positive, drift, by quadrature with forty digits.
    for (q, lambda0, positive, drift) in [
        (1.2, 0.999_999_9, 1.341_640_806_27e-3, 4.5e-14),
        (2.0, 0.9999, 0.0, 4.500_090_003e-8),
        (1.000_001, 0.3, 0.0, 4.352_520_440_993e-6),
        (1.0 + 1e-9, 0.5, 0.0, 3.054_597_87e-9),
    ] {
        let answer = solve(q, lambda0);
        assert_eq!(answer.digits, Some(15), "{q} {lambda0} {answer:?}");
        // So far the numbers above go.
        let near = |found: f64, exact: f64| (found - exact).abs() <= 2e-7 * exact;
        assert!(near(answer.best.drift_per_period, drift), "{answer:?}");
        assert!(
            positive == 0.0 || near(answer.best.positive, positive),
            "{answer:?}"
        );
    }
    // The same both ways: no drift.
    for lambda0 in [0.1, 0.3, 0.5, 0.7, 0.99] {
        let answer = solve(1.0, lambda0);
        assert_eq!(answer.best.drift_per_period, 0.0, "{lambda0}");
        assert!(answer.digits >= Some(11), "{lambda0} {answer:?}");
    }
}

#[test]
fn the_note_says_where_the_printed_list_errs() {
    let mut random = fastrand::Rng::with_seed(55);
    let mut erring = 0;
    for i in 0..300 {
        let q = 1.0 + 20.0 * random.f64();
        // Every third point lies between the curve E and C, or close below C.
        let reach = if i % 3 == 0 { 1.0 } else { 1.3 * q };
        let lambda0 = (0.01 + reach * random.f64()) / q;
        let answer = anisotropic::AnisotropicProblem { q, lambda0 }
            .solve()
            .unwrap();
        let listed = region(lambda0, &Curves::at(q).unwrap().printed).unwrap();
        let errs = ["I", "II", "III", "IV", "V"][listed - 1] != answer.best.region;
        erring += usize::from(errs);
        assert_eq!(
            answer.note.contains("printed list"),
            errs,
            "q = {q}, λ₀ = {lambda0}"
        );
    }
    assert!(erring > 20, "{erring}");
    // On C itself, qλ₀ = 1, where powers of two leave no rounding, the list is right.
    for q in [2.0, 4.0, 8.0, 16.0] {
        let answer = anisotropic::AnisotropicProblem {
            q,
            lambda0: 1.0 / q,
        };
        let answer = answer.solve().unwrap();
        assert_eq!((answer.best.region, answer.best.negative), ("IV", 0.0));
        assert!(
            !answer.note.contains("printed list"),
            "{q}: {}",
            answer.note
        );
    }
}

/// λ_c is known to 31 digits, and so is what its motion is; a rest that is short beside the period takes no digits from the
/// other numbers. From mpmath, by (38) and (39).
#[test]
fn where_two_regimes_meet_only_the_name_is_undecided() {
    let four = [
        ("positive_start", 0.566_911_504_941_009_4),
        ("positive_end", 3.708_504_158_530_803),
        ("w_max", 0.608_896_145_739_685),
    ];
    let pi = Double::pi();
    let critical = Double::from(2.0) / (Double::from(4.0) + pi * pi).sqrt();
    for (more, regime, rest) in [
        (0.0, "critical", 0.0),
        (1e-30, "critical", 0.0),
        (-1e-30, "critical", 0.0),
        (1e-28, "two-rests", 1.308e-28),
        (-1e-28, "two-zeros", 0.0),
        (1e-20, "two-rests", 1.308_387_46e-20),
    ] {
        let lambda0 = critical + more.into();
        let answer = sinusoidal::SinusoidalProblem { lambda0 }.solve().unwrap();
        assert_eq!((word(&answer), answer.digits), (regime, Some(15)), "{more}");
        agrees(&answer, &four);
        let report = answer.report("");
        let Value::Number(found) = report.fields[3].value else {
            panic!("{report:?}")
        };
        assert!((found - rest).abs() <= 2e-28, "{more}: {found}");
        // The formula is what is right here: it is written as far as that.
        assert_eq!(report.by_formula.as_ref(), Some(&report.fields));
    }
    for (eta, lambda0, more, regime) in [
        ("0.3", "0.3", 0.0, "two-zeros"),
        ("0.3", "0.3", 1e-31, "critical"),
        ("0.3", "0.3", 1e-25, "two-rests"),
        // Shorter than the rounding of phases.
        ("1e-20", "0.5", 0.0, "two-rests"),
    ] {
        let [eta, lambda0] = [eta, lambda0].map(|x| x.parse::<Double>().unwrap());
        let lambda0 = lambda0 + more.into();
        let answer = periodic::PeriodicProblem { eta, lambda0 }.solve().unwrap();
        assert_eq!((word(&answer), answer.digits), (regime, Some(15)));
    }
    // The drift between equal frictions, (q − 1) times 0.3 of a unit.
    for more in [1e-20, 1e-28] {
        let q = Double::from(1.0) + Double::from(more);
        let lambda0 = Double::from(0.5);
        let answer = anisotropic::AnisotropicProblem { q, lambda0 }
            .solve()
            .unwrap();
        assert_eq!(answer.digits, Some(15));
        agrees(&answer, &[("positive", PI), ("negative", PI)]);
    }
}
