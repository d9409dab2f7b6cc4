//! Work and energy: (103), (104), (106) as printed and corrected, the powers of the forces.

use super::{RATE, Setting, Vectorial, prove, vectors};
use crate::claims::turntable::prelude::*;
use crate::paper::turntable as paper;

pub(crate) const EQ103: Vectorial = Vectorial::new(
    Printed,
    RATE,
    || {
        vec![
            paper::eq103_energy::tree(),
            paper::eq103_energy_rate::tree(),
        ]
    },
    |printed| {
        prove(
            "(103): d[(p² − ρ²)/2]/dτ",
            Setting::polar(),
            |p, setting| {
                let energy = p.read("The printed energy", printed[0])?;
                let rate = p.derivative("Its rate by (89)", &energy, &setting.motion)?;
                let printed = p.read("The printed rate", printed[1])?;
                p.equal("The rate by (89) is the printed one", &rate, &printed)
            },
        )
    },
);

fn keeps_its_value(title: &str, setting: Result<Setting, ExactError>, formula: &[Expr]) -> Proof {
    prove(title, setting, |p, setting| {
        let value = p.read("The expression", formula[0])?;
        p.constant(&value, &setting.motion)
    })
}

pub(crate) const PRINTED_106: Vectorial = Vectorial::new(
    Printed,
    Compared::one("the rate of (106) along (86)", "0"),
    || {
        let [m, g, omega, s] = symbols(["m", "g", "Ω", "s"]);
        let [r, v] = vectors();
        vec![paper::eq106_constant(m, g, omega, r, v, s)]
    },
    prove_106,
);

fn prove_106(formula: Vec<Expr>) -> Proof {
    let title = "(106): an energy keeps its value";
    keeps_its_value(title, Setting::dimensional(), &formula)
}

pub(crate) const PRINTED_WORK: Vectorial = Vectorial::new(
    Printed,
    Compared::many(
        "the power of the Coriolis force and the rate of $-mgs$, in (86),",
        "0 and the power of friction",
    ),
    paper::friction_work::parts,
    prove_works,
);

fn prove_works(work: Vec<Expr>) -> Proof {
    let title = "the works of the Coriolis force and of friction";
    prove(title, Setting::dimensional(), |p, setting| {
        let [omega, mu, g, m] = symbols(["Ω", "μ", "g", "m"]);
        let [r, v] = vectors();
        let zero = int(0);
        let power = |[ax, ay]: [Expr; 2]| m * (ax * v[0] + ay * v[1]);
        // On the axis and without friction the Coriolis force is alone.
        let coriolis = power(paper::eq86_acceleration(omega, zero, g, [zero; 2], v));
        let coriolis = p.read("The power of the Coriolis force", coriolis)?;
        p.reads_as(&coriolis, "", int(0))?;
        let smooth = power(paper::eq86_acceleration(omega, zero, g, r, v));
        let rough = power(paper::eq86_acceleration(omega, mu, g, r, v));
        let friction = p.read("The power of friction", rough - smooth)?;
        let work = p.read("The work along the way s", work[0])?;
        let rate = p.derivative("Its rate", &work, &setting.motion)?;
        p.equal("It is the power of friction", &rate, &friction)
    })
}

attempts![
    &EQ103,
    &EQ104 = Vectorial::new(
        Printed,
        Compared::one("the rate of (104) along (89)", "0"),
        paper::eq104_constant::parts,
        |printed| {
            let title = "(104): an expression keeps its value";
            keeps_its_value(title, Setting::polar(), &printed)
        },
    ),
    &PRINTED_106,
    &CORRECTED_106 = Vectorial::new(
        Corrected,
        Compared::one(r"the rate of (106) with $m\mu gs$, along (86),", "0"),
        || {
            let [m, mu, g, omega, s] = symbols(["m", "μ", "g", "Ω", "s"]);
            let [r, v] = vectors();
            vec![corrections::constant(m, mu, g, omega, r, v, s)]
        },
        prove_106,
    ),
    &PRINTED_WORK,
    &CORRECTED_WORK = Vectorial::new(
        Corrected,
        Compared::many(
            r"the power of the Coriolis force and the rate of $-m\mu gs$, in (86),",
            "0 and the power of friction",
        ),
        corrections::friction_work::parts,
        prove_works,
    ),
];
