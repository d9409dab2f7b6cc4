//! Fates by validated integration: where (147) says one thing and Newton's law the other.

use super::boundary::{border, corrected_a, printed_a};
use super::prelude::*;
use crate::validated::turntable::{Fate, fate};
use trialbook::certified::interval::Interval;

/// A, α and ψ of starts that (147) sends away and that come to rest, all with α < √2, beyond which (147) has no σ.
pub(crate) const WRONG: [[f64; 3]; 3] = [[0.88, 0.1, 0.2], [0.58, 0.4, 0.5], [0.9, 0.2, 2.0]];

/// The radius at rest is of no interest here.
const ANY: f64 = 1.0;

/// Whether a start comes to rest (1) or escapes (0), proved.
fn proved([a, alpha, psi]: [f64; 3], border: f64) -> Result<Pair, Failure> {
    let found = match fate([a, alpha, psi].map(Interval::decimal), ANY)? {
        Fate::Rest { .. } => 1.0,
        Fate::Escape { .. } => 0.0,
    };
    Ok(Pair::plain(
        format!("A = {a:.6}, α = {alpha}, ψ = {psi}"),
        is(a < border),
        found,
    ))
}

pub(crate) fn printed() -> Evidence {
    Trial::by(
        Certified,
        Printed,
        [
            "the fate by (147) (1 for rest, 0 for escape)",
            "that by validated integration",
        ],
        NONE,
    )
    .over(WRONG, |start| proved(start, printed_a(start[1])))
}

pub(crate) fn corrected() -> Evidence {
    let trial = Trial::by(
        Certified,
        Corrected,
        Compared::one(
            "the fate by the corrected formula (1 for rest, 0 for escape)",
            "that by validated integration",
        )
        .over(
            r"0.03 on both sides of where the motion passes from one to the other, at $\alpha=0.1$",
        ),
        NONE,
    );
    let sides = [-1.0, 0.2, 2.0]
        .into_iter()
        .flat_map(|psi| [(psi, -0.03), (psi, 0.03)]);
    trial
        .over(sides, |(psi, off)| {
            let alpha = 0.1;
            let a = border(alpha, psi)?.a + off;
            proved([a, alpha, psi], corrected_a(alpha, psi))
        })
        .of_a_part()
}

attempts![printed, corrected];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::rest::boundary::resting_place;
    use crate::motion::turntable::{critical_radius, critical_speed};
    use crate::validated::turntable::{fate_launched, fate_put_down};
    use trialbook::certified::error::CertifiedError;

    #[test]
    fn the_simulated_radius_lies_in_the_proved_interval() {
        for [a, alpha, psi] in [WRONG[0], [0.9, 0.1, -2.0], [0.5, 0.3, 3.0]] {
            let start = [a, alpha, psi].map(Interval::point);
            let Ok(Fate::Rest { sigma, .. }) = fate(start, 1e-8) else {
                panic!("{a} {alpha} {psi}");
            };
            let simulated = resting_place(a, alpha, psi).unwrap().unwrap();
            assert!(
                sigma.widened(1e-12).contains(simulated),
                "{sigma} {simulated}"
            );
        }
    }

    #[test]
    fn a_boundary_off_by_little_is_refused() {
        // Raised or lowered by 0.045, its fates are wrong.
        for psi in [-1.0, 0.2, 2.0] {
            let border = corrected_a(0.1, psi);
            for off in [-0.03, 0.03] {
                let pair = proved([border + off, 0.1, psi], border + 1.5 * off).unwrap();
                assert_eq!(pair.disagreement(), 1.0);
            }
        }
    }

    #[test]
    fn the_critical_launches_lie_between_proved_fates() {
        let off = 1e-5;
        type Of = fn(Interval, f64) -> Result<Fate, CertifiedError>;
        let launches: [(Of, f64); 2] = [
            (fate_put_down, critical_radius().unwrap()),
            (fate_launched, critical_speed().unwrap()),
        ];
        for (fate, critical) in launches {
            let [below, above] = [-off, off].map(|off| fate(Interval::point(critical + off), ANY));
            assert!(matches!(below, Ok(Fate::Rest { .. })), "{below:?}");
            assert!(matches!(above, Ok(Fate::Escape { .. })), "{above:?}");
        }
    }
}
