//! Periodic drives.

use crate::claims::anisotropic::simulated::Curves;
use crate::paper::anisotropic::region;
use crate::solve::anisotropic;

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
