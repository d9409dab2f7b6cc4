//! The motion by p, ℓ, ξ and by p, ρ, ψ: (96) to (102), (107) to (109).

use super::{Setting, Vectorial, changes, prove, rate, vectors};
use crate::claims::turntable::prelude::*;
use crate::corrections::turntable as corrected;
use crate::paper::turntable as paper;

#[track_caller]
const fn equation(
    right: &'static str,
    formulas: fn() -> Vec<Expr>,
    prove: fn(Vec<Expr>) -> Proof,
) -> Vectorial {
    let compared = Compared::one("the left side", right);
    Vectorial::new(Printed, compared, formulas, prove)
}

fn sides(title: &str, printed: &[Expr]) -> Proof {
    prove(title, Setting::polar(), |p, _| {
        let left = p.read("The left-hand side", printed[0])?;
        let right = p.read("The right-hand side", printed[1])?;
        p.equal("They are the same", &left, &right)
    })
}

pub(crate) const EQ96: Vectorial = equation(
    "the right side, with (95)",
    || {
        let [p, ell] = symbols(["p", "ℓ"]);
        let [position, rate] = vectors();
        paper::eq96_angular_momentum(p, ell, position, rate).into()
    },
    |printed| sides("(96), with (95)", &printed),
);

pub(crate) const EQ98: Vectorial = equation(
    "the right side, with (94) and (95)",
    || {
        let [ell, xi] = symbols(["ℓ", "ξ"]);
        paper::eq98_distance(vectors()[0], ell, xi).into()
    },
    |printed| sides("(98), with (94) and (95)", &printed),
);

fn polar(title: &str, of: &'static str, stated: &[Expr]) -> Proof {
    rate(title, Setting::polar(), of, stated)
}

pub(crate) const EQ99: Vectorial = changes(Within, paper::eq99_p_rate::parts, |printed| {
    polar("(99): dp/dτ", "p", &printed)
});

pub(crate) const EQ101: Vectorial = changes(Within, paper::eq101_xi_rate::parts, |printed| {
    polar("(101): dξ/dτ", "ξ", &printed)
});

pub(crate) const EQ102: Vectorial = Vectorial::new(
    Printed,
    Compared::one(
        "each printed expression",
        r"$\rho\,\mathrm d\rho/\mathrm d\tau$ by (89)",
    ),
    || {
        let [ell, xi, p] = [["ℓ", "dℓ/dτ"], ["ξ", "dξ/dτ"], ["p", "dp/dτ"]].map(symbols);
        paper::eq102_rate(ell, xi, p).into()
    },
    |printed| {
        prove("(102): ρ dρ/dτ", Setting::polar(), |p, setting| {
            let rho = p.ring().named("ρ")?;
            let rate = p.derivative("dρ/dτ by (89)", &rho, &setting.motion)?;
            for formula in printed {
                let printed = p.read("A printed expression", formula)?;
                p.equal("It is ρ dρ/dτ", &printed, &(&rho * &rate))?;
            }
            Ok(())
        })
    },
);

pub(crate) const EQ107: Vectorial = changes(Within, paper::eq107_p_rate::parts, |printed| {
    polar("(107): dp/dτ", "p", &printed)
});
pub(crate) const EQ108: Vectorial = changes(Printed, paper::eq108_rho_rate::parts, |printed| {
    polar("(108): dρ/dτ", "ρ", &printed)
});
pub(crate) const EQ109: Vectorial = changes(Within, paper::eq109_psi_rate::parts, |printed| {
    polar("(109): dψ/dτ", "ψ", &printed)
});

attempts![
    &EQ96,
    &EQ97 = equation(
        "the right side, with (94)",
        || {
            let [p, xi] = symbols(["p", "ξ"]);
            let [position, rate] = vectors();
            paper::eq97_radial(p, xi, position, rate).into()
        },
        |printed| sides("(97), with (94)", &printed),
    ),
    &EQ98,
    &EQ99,
    &EQ100 = changes(Within, paper::eq100_ell_rate::parts, |printed| {
        polar("(100): dℓ/dτ", "ℓ", &printed)
    }),
    &EQ101,
    &TANGENTIAL = changes(
        Within,
        || {
            let [position, rate] = vectors();
            vec![paper::s4_tangential_rate(position, rate)]
        },
        |printed| polar("dp/dτ, by (89) on the velocity", "p", &printed),
    ),
    &AZIMUTHAL = changes(Corrected, corrected::azimuthal_rate::parts, |corrected| {
        polar("dℓ/dτ, by the angular momentum and dp/dτ", "ℓ", &corrected)
    }),
    &RADIAL = changes(Corrected, corrected::radial_rate::parts, |corrected| {
        polar("dξ/dτ, by the radius and dp/dτ", "ξ", &corrected)
    }),
    &EQ102,
    &EQ107,
    &EQ108,
    &EQ109,
];
