//! The turntable's boundary.

use crate::claims::solve::Value;
use crate::claims::solve::rest::BoundaryProblem;

#[test]
fn the_boundary_by_bisection_and_near_the_corner() {
    let solve = |alpha, psi| BoundaryProblem { alpha, psi }.solve().unwrap();
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
    // The expansion stands beside the motion as far as a claim tries it.
    let trial = |alpha| solve(alpha, 1.0).by_formula.is_some();
    assert!(trial(0.3) && !trial(0.301));
    assert!(solve(1e-3, 1.0).disagreement < Some(1e-8));
    // No digit of it is written that the motion denies: 0.93512… beside 0.93153….
    let written = |alpha| solve(alpha, 1.0).report("").by_formula.unwrap()[0].value;
    assert_eq!(written(0.1), Value::Number(0.9));
    assert_eq!(
        solve(0.1, 1.0).report("").fields[0].value,
        Value::Number(0.931534356734058)
    );
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
