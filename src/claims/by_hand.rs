//! The two numbers in each case that a reader can check with paper and pencil: the stated one from the printed formula, the
//! found one from the motion. The words are in the claims' entries; the judge reads none of this.

use super::anisotropic::simulated::{self as drift, Curves};
use super::constant::final_direction::sense_of_sliding;
use super::escape::growth::{self, Quantity};
use super::escape::trajectories::escapes;
use super::periodic::drives::pulses;
use super::periodic::pulse_remarks::friction;
use super::rest::boundary::surfaces;
use super::rest::surfaces::bend;
use super::sinusoidal::reference_motions::{ORIGIN, drive, settled};
use super::turntable::projections;
use super::values::boundary_example;
use crate::motion::drive::{PlanarState, Sign};
use crate::motion::sphere::{Ball, BallMotion, Sphere};
use crate::motion::{Plane, State, run};
use crate::paper::{
    anisotropic, constant, escape, periodic, rest, sinusoidal, sphere, turntable as table,
};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, SQRT_2, TAU};
use trialbook::claims::by_hand::Numbers;
use trialbook::prelude::*;

/// Of `constant`, in the paper's order.
pub static CONSTANT: [Numbers; 1] = [Numbers::new(
    "s21-along-acceleration",
    || Ok(constant::s21_late_sense()),
    sense_of_sliding,
)];

/// Of `sinusoidal`, in the paper's order.
pub static SINUSOIDAL: [Numbers; 2] = [
    Numbers::new("s22-vy-two-stages", || Ok(1.0), growth_of_logarithm),
    Numbers::new(
        "s22-rest-of-period",
        || Ok(sinusoidal::s22_rest_of_period_end(FRAC_PI_2)),
        || Ok(root(|phi| libm::sin(phi) - 0.5, 1.5 * PI, 2.5 * PI)?),
    ),
];

/// Of `periodic`, in the paper's order.
pub static PERIODIC: [Numbers; 1] = [Numbers::new(
    "s23-nonzero-again",
    || {
        Ok(periodic::s23_nonzero_again(friction([
            0.5,
            0.25,
            0.75 * PI,
        ])?))
    },
    || Ok(pulses(0.5)?.h(0.75 * PI)),
)];

/// Of `anisotropic`, in the paper's order.
pub static ANISOTROPIC: [Numbers; 3] = [
    Numbers::new(
        "s24-region-2",
        || {
            Ok(backward(
                &anisotropic::signs()[printed_region(9.0, 0.1)? - 1],
            ))
        },
        || {
            let motion = drift::attractor(9.0, 0.1)?;
            let signs = motion.intervals().iter().map(|i| i.sign.factor());
            Ok(backward(&signs.collect::<Vec<_>>()))
        },
    ),
    Numbers::new(
        "eq-55",
        || Ok(anisotropic::eq55_lambda0(9.0)),
        || drift::last_backward(9.0),
    ),
    Numbers::new(
        "fig-5",
        || Ok(printed_region(6.5, 0.15)? as f64),
        || Ok(drift::fits(drift::simulated(6.5, 0.15)?) as f64),
    ),
];

/// Of `sphere`, in the paper's order.
pub static SPHERE: [Numbers; 3] = [
    Numbers::new(
        "eq-75",
        || Ok(sphere::eq75_spin(0.0, [0.0; 3], [1.0, 0.0, 0.0])[1]),
        || {
            let end = thrown(0.0, 2.0)?.end();
            Ok(end.omega[1] / end.v[0])
        },
    ),
    Numbers::new(
        "eq-82",
        || Ok(sphere::eq82_time(1.75, 1.0, FRAC_PI_2, 1e-12)),
        end_of_slip,
    ),
    Numbers::new(
        "eq-83",
        || {
            Ok(sphere::eq83_slip_at_time(
                1.75,
                1.0,
                FRAC_PI_2,
                0.0,
                14.0 / 33.0,
            ))
        },
        || {
            let slip = thrown(2.0, 1.0)?.slip(end_of_slip()?)?;
            Ok(libm::hypot(slip[0], slip[1]))
        },
    ),
];

/// Of `turntable`, in the paper's order.
pub static TURNTABLE: [Numbers; 4] = [
    Numbers::new(
        "s4-projection-azimuthal",
        || Ok(table::s4_azimuthal_rate(1.0, 1.0, 2.0, 0.0)),
        || projections::in_the_motion(|v| v.ell),
    ),
    Numbers::new(
        "s4-projection-radial",
        || Ok(table::s4_radial_rate(1.0, 1.0, 2.0, 0.0)),
        || projections::in_the_motion(|v| v.xi),
    ),
    Numbers::new(
        "eq-106",
        || Ok(-table::friction_work(1.0, 10.0, way()?)),
        energy_lost,
    ),
    Numbers::new(
        "s4-coriolis-no-work",
        || Ok(table::friction_work(1.0, 10.0, way()?)),
        || Ok(-energy_lost()?),
    ),
];

/// Of `escape`, in the paper's order.
pub static ESCAPE: [Numbers; 10] = [
    Numbers::new(
        "eq-128",
        || late(growth::eq128),
        || late(growth::alpha_rate),
    ),
    Numbers::new("eq-129", || Ok(1.0), || late(growth::product)),
    Numbers::new(
        "eq-130",
        || Ok(escape::eq130_alpha(1.0)),
        || late(growth::alpha_by_a),
    ),
    Numbers::new(
        "eq-131",
        || Ok(escape::eq131_a_rate(1.0)),
        || late(growth::a_rate),
    ),
    Numbers::new(
        "eq-132",
        || Ok(growth::printed_size()),
        || late(growth::size),
    ),
    Numbers::new(
        "eq-133",
        || Ok(escape::eq133_alpha(1.0)),
        || late(growth::excess),
    ),
    Numbers::new(
        "eq-134",
        || Ok(escape::eq134_lag(1200.0)),
        || Ok(late(growth::lag)? / 1200.0),
    ),
    Numbers::new(
        "eq-135",
        || Ok(3.0 * SQRT_2 * growth::printed_speed()),
        || Ok(3.0 * SQRT_2 * late(growth::speed)?),
    ),
    Numbers::new(
        "eq-136",
        || Ok(escape::eq136_rho(1.0)),
        || late(growth::distance),
    ),
    Numbers::new("eq-137", || Ok(escape::eq137_s(1.0)), || late(growth::way)),
];

/// Of `rest`, in the paper's order.
pub static REST: [Numbers; 4] = [
    Numbers::new(
        "eq-146",
        || Ok(rest::eq146_right(0.5, 0.5 * SQRT_2)),
        || {
            let surface = surfaces().last().ok_or("no surface")??;
            Ok(surface.slope)
        },
    ),
    Numbers::new("eq-147", || Ok(rest::eq147_a(0.1)), boundary_example),
    Numbers::new(
        "s4-psi-free",
        || Ok(0.5 - rest::eq145_a(0.5, 1.0)),
        || bend(0.5, FRAC_PI_2),
    ),
    Numbers::new(
        "s4-envelope-is-boundary",
        || Ok(rest::eq147_a(0.1)),
        boundary_example,
    ),
];

/// The limit of a quantity of an escape, which does not depend on the start.
fn late(quantity: Quantity) -> Result<f64, Failure> {
    let escape = escapes().next().ok_or("no escape")??;
    Ok(growth::limit(escape, quantity)?.value)
}

/// The factor by which ln v_y grows in a period at friction 1/π.
fn growth_of_logarithm() -> Result<f64, Failure> {
    let motion = settled(FRAC_1_PI, ORIGIN)?;
    let mut slips = motion.intervals().iter();
    let slip = slips.rfind(|i| i.sign == Sign::Positive);
    let slip = slip.ok_or("no slip")?;
    let phi = 0.5 * (slip.start + slip.end);
    let start = PlanarState {
        phi,
        w_x: motion.w(phi),
        ln_w_y: -1e9,
    };
    let states = drive()?.planar(FRAC_1_PI, start, &[phi + TAU])?;
    let end = states.first().ok_or("no state")?;
    Ok(end.ln_w_y / start.ln_w_y)
}

/// The region that the printed list gives to a point.
fn printed_region(q: f64, lambda0: f64) -> Result<usize, Failure> {
    let region = anisotropic::region(lambda0, &Curves::at(q)?.printed);
    Ok(region.ok_or("the point lies on a curve")?)
}

/// The number of backward intervals among those of a period.
fn backward(signs: &[f64]) -> f64 {
    signs.iter().filter(|sign| **sign < 0.0).count() as f64
}

/// A solid sphere thrown across with slip velocity 1 and no spin, on a plane with A = γμg, units of R and μg.
fn thrown(gamma: f64, until: f64) -> Result<BallMotion, Failure> {
    let start = match gamma {
        // Nothing is across: along the x axis.
        0.0 => [1.0, 0.0],
        _ => [0.0, 1.0],
    };
    let start = Ball {
        t: 0.0,
        x: [0.0, 0.0],
        v: start,
        omega: [0.0; 3],
    };
    Ok(Sphere::with_kappa(0.4).run(&Plane::constant([-gamma, 0.0]), &start, until)?)
}

/// The time at which the sphere with γ = 2 begins to roll.
fn end_of_slip() -> Result<f64, Failure> {
    let motion = thrown(2.0, 1.0)?;
    Ok(motion.transitions().first().ok_or("it slips on")?.t)
}

/// The motion of a particle that friction of 5 slows down from the velocity 5: its end.
fn stopped() -> Result<State, Failure> {
    let start = State {
        t: 0.0,
        v: [5.0, 0.0],
        x: [0.0, 0.0],
    };
    Ok(run(&Plane::constant([0.0, 0.0]), 5.0, start, 2.0)?.end())
}

/// The way that it makes.
fn way() -> Result<f64, Failure> {
    Ok(stopped()?.x[0])
}

/// The kinetic energy that it loses, mass 1.
fn energy_lost() -> Result<f64, Failure> {
    let v = stopped()?.v[0];
    Ok(0.5 * (25.0 - v * v))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::PAPER;
    use std::f64::consts::LN_2;

    #[test]
    fn every_case_shows_a_difference() {
        for (claim, case) in PAPER.cases() {
            let Numbers { stated, found, .. } = case.computed;
            let (stated, found) = (stated().unwrap(), found().unwrap());
            let step = 0.1_f64.powi(case.digits as i32);
            assert!(
                (stated - found).abs() > 3.0 * step || case.digits == 0 && stated != found,
                "{}: {stated}, {found}",
                claim.id
            );
            let words = case.words().unwrap();
            assert!(!words.contains("{stated}") && !words.contains("{found}"));
            assert_eq!(words.matches('$').count() % 2, 0, "{words}");
        }
    }

    #[test]
    fn the_two_numbers_of_a_case_are_those_of_pencil_and_paper() {
        let (third, fourth) = (1.0 / 3.0, 2.0_f64.powf(0.25));
        let s = 0.5 * 3.0_f64.sqrt();
        let passage = (s + FRAC_1_PI) / (s - FRAC_1_PI);
        let by_hand = [
            ("s21-along-acceleration", 1.0, -1.0),
            ("s22-vy-two-stages", 1.0, passage * passage),
            ("s22-rest-of-period", 2.5 * PI, PI / 6.0 + TAU),
            ("s23-nonzero-again", -0.25, 0.0),
            ("s4-projection-azimuthal", -5.0, -5.0 - 1.0),
            ("s4-projection-radial", 6.0, 6.0 - 2.0),
            ("s24-region-2", 1.0, 0.0),
            ("eq-55", 1.0 / 9.0, 0.096_159),
            ("fig-5", 2.0, 4.0),
            ("eq-75", -1.0, 1.0),
            ("eq-82", 28.0 / 33.0, 14.0 / 33.0),
            (
                "eq-83",
                ((1.0 - 49.0 / 16.0) * 14.0 / 33.0 + 1.75) / 2.75,
                0.0,
            ),
            ("eq-106", 25.0, 12.5),
            ("s4-coriolis-no-work", -25.0, -12.5),
            ("eq-128", SQRT_2 - 1.5, 0.5),
            ("eq-129", 1.0, 1.5 / SQRT_2),
            ("eq-130", third * 4.0_f64.ln(), third * (3.0 * SQRT_2).ln()),
            ("eq-131", 0.5 * 4.0_f64.cbrt(), 0.5 * (3.0 * SQRT_2).cbrt()),
            ("eq-132", 2.0 / 27.0_f64.sqrt(), third * fourth),
            ("eq-133", 0.5 * (4.0 * third).ln(), 0.25 * LN_2),
            ("eq-134", 0.05, 1.0 / 600.0),
            ("eq-135", 3.0 * SQRT_2 * 2.0 / 9.0, 1.0),
            ("eq-136", 2.0 / 9.0, SQRT_2 / 6.0),
            ("eq-137", 2.0 / 27.0, SQRT_2 / 18.0),
            ("eq-146", 0.0, third.sqrt()),
            ("eq-147", (1.0 - 0.1 / SQRT_2).powi(2), 0.910_959_636),
            ("s4-psi-free", 0.5, 7.0 / 24.0),
            (
                "s4-envelope-is-boundary",
                (1.0 - 0.1 / SQRT_2).powi(2),
                0.910_959_636,
            ),
        ];
        for (id, stated, found) in by_hand {
            let case = PAPER.find(id).unwrap().1.by_hand.unwrap();
            let [left, right] = case.numbers().unwrap();
            let decimals = left.find('.').map_or(0, |point| left.len() - point - 1);
            assert_eq!(
                [&left, &right],
                [
                    &format!("{stated:.decimals$}"),
                    &format!("{found:.decimals$}")
                ],
                "{id}"
            );
            let words = case.words().unwrap();
            assert!(
                words.contains(&left) && words.contains(&right) && words.len() > 100,
                "{id}: {words}"
            );
            assert!(
                !words.contains("{stated}") && !words.contains("{found}"),
                "{id}: {words}"
            );
        }
        assert_eq!(PAPER.cases().count(), by_hand.len());
    }
}
