//! Periodic drives.

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
