//! The sphere, in three dimensions and along a line.

use super::{any, config, each, finite, on_the_way, or_zeros, particle::plane};
use proptest::prelude::*;
use slipbook::motion::sphere::{Ball, Directed, Sphere};

fn numbers(ball: &Ball) -> bool {
    finite(&[ball.t]) && finite(&ball.x) && finite(&ball.v) && finite(&ball.omega)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_ball_has_numbers(
        body in each::<5>(), kappa in prop_oneof![any(), 0.05..=1.0], plane in plane(), [t, x, y, until] in each(), [u, v, a, b] in or_zeros(), c in any(), part in 0.0..=1.0,
    ) {
        let [mass, radius, inertia, mu, g] = body;
        let start = Ball { t, x: [x, y], v: [u, v], omega: [a, b, c] };
        for sphere in [Sphere { mass, radius, inertia, mu, g }, Sphere::with_kappa(kappa)] {
            for until in [until, t + 1.0] {
                let Ok(motion) = sphere.run(&plane, &start, until) else { continue };
                let end = motion.end();
                let at = on_the_way(t, end.t, part);
                prop_assert!(numbers(&end) && motion.at(at).is_ok_and(|ball| numbers(&ball)), "{sphere:?}");
                prop_assert!(motion.slip(at).is_ok_and(|slip| finite(&slip)) && motion.contact(at).is_ok());
                prop_assert!(motion.transitions().iter().all(|change| change.t.is_finite()));
            }
        }
    }

    #[test]
    fn a_ball_on_a_line_has_numbers(kappa in prop_oneof![any(), 0.05..=1.0], mu_minus in prop_oneof![any(), 0.1..=2.0], plane in plane(), [v, omega] in or_zeros(), [from, until] in each()) {
        let body = Directed { sphere: Sphere::with_kappa(kappa), mu_minus };
        for until in [until, from + 1.0] {
            let Ok(motion) = body.run(&plane, [v, omega], from, until) else { continue };
            let end = motion.end;
            prop_assert!(finite(&[end.t, end.v, end.omega, end.slip]), "{end:?}");
            prop_assert!(motion.stretches.iter().all(|part| finite(&[part.from, part.to])));
        }
    }
}
