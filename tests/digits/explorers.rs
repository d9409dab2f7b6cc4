//! What the explorers show, four digits after the point, against the foreign program and the calculators.

use super::cases;
use super::vectors::rows;
use slipbook::claims::solve::turntable::Problem;
use slipbook::explorers::{anisotropic, constant, turntable};

/// Half a unit of the fourth digit after the point, with room for its rounding.
const SHOWN: f64 = 1e-8;

#[test]
fn the_launch() {
    rows("explorer-constant", cases(500), |row| {
        let answer = constant::motion(row.number("lambda"), row.number("theta")).unwrap();
        for (value, name) in answer
            .values
            .iter()
            .zip(["flag", "t", "vx", "vy", "x", "y"])
        {
            let exact = row.number(name);
            let off = (value - exact).abs();
            assert!(
                off <= SHOWN * exact.abs().max(1.0),
                "{name}: {value}, right is {exact}"
            );
        }
    });
}

#[test]
fn the_drive() {
    rows("explorer-anisotropic", cases(500), |row| {
        let [q, lambda0, w] = ["q", "lambda0", "w"].map(|name| row.number(name));
        let answer = anisotropic::motion(q, lambda0, w).unwrap();
        let names = ["region", "mean_velocity", "largest_speed", "rest_share"];
        let exact = names.map(|name| row.number(name));
        for (i, (value, name)) in answer.values.iter().zip(names).enumerate() {
            let off = (value - exact[i]).abs();
            // On a border of the regions a rest is nothing but rounding.
            let on_border = name == "region" && exact[3] < 1e-9 + SHOWN;
            assert!(
                off <= SHOWN || on_border,
                "{q} {lambda0} {name}: {value}, right is {}",
                exact[i]
            );
        }
    });
}

#[test]
fn the_turntable() {
    let mut rng = fastrand::Rng::with_seed(20);
    let mut rests = 0;
    for _ in 0..cases(300) {
        let [rho, u, v] = [
            1.5 * rng.f64(),
            4.0 * rng.f64() - 2.0,
            4.0 * rng.f64() - 2.0,
        ];
        let values = turntable::motion(rho, [u, v]).unwrap().values;
        let start = Problem::Cartesian {
            position: [rho, 0.0],
            velocity: [u, v],
        };
        let exact = start.fate().unwrap().best;
        assert_eq!(values[0] == 1.0, exact.outcome == "rest", "{rho} {u} {v}");
        if let (Some(sigma), Some(tau)) = (exact.sigma, exact.tau_rest) {
            assert!(
                (values[1] - sigma).abs() < SHOWN && (values[2] - tau).abs() < SHOWN,
                "{rho} {u} {v}"
            );
            rests += 1;
        }
    }
    assert!(rests > 30);
}
