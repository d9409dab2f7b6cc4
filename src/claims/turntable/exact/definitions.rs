//! The definitions (93) to (95), (110) to (112), (116) to (118), by what they have to be consistent with.

use super::{Setting, Vectorial, prove, vectors};
use crate::claims::turntable::prelude::*;
use crate::paper::turntable as paper;

#[track_caller]
const fn consistent(
    compared: Compared,
    formulas: fn() -> Vec<Expr>,
    prove: fn(Vec<Expr>) -> Proof,
) -> Vectorial {
    Vectorial::new(Printed, compared, formulas, prove)
}

fn is(
    title: &str,
    setting: Result<Setting, ExactError>,
    printed: &[Expr],
    (says, expected): (&str, Expr),
) -> Proof {
    prove(title, setting, |p, _| {
        p.identity(("The printed formula", printed[0]), (says, expected))
    })
}

pub(crate) const EQ95: Vectorial = consistent(
    Compared::one(
        "(95)",
        r"$\hat{\bm z}\cdot(\bm\rho\times\mathrm d\bm\rho/\mathrm d\tau)/p$",
    ),
    paper::eq95_ell::parts,
    |printed| {
        let [[x, y], [u, v]] = vectors();
        let across = (x * v - y * u) / symbol("p");
        let expected = ("the moment of the velocity about the axis, over p", across);
        is("(95): ℓ", Setting::polar(), &printed, expected)
    },
);

pub(crate) const EQ110: Vectorial = consistent(
    Compared::one("(110), by (111) and (112),", "$-A^2$"),
    paper::eq110_case::parts,
    |printed| {
        let expected = ("negative", -symbol("A").squared());
        let title = "(110): with (111) and (112)";
        is(title, Setting::slower(), &printed, expected)
    },
);

/// The sum and the difference of two of the formulas are `size` × exp(±`argument`).
fn sums(
    title: &str,
    setting: Result<Setting, ExactError>,
    [larger, smaller]: [Expr; 2],
    symbols: [&'static str; 2],
) -> Proof {
    prove(title, setting, |p, _| {
        let [size, argument] = Expr::symbols(symbols);
        for (says, sum, sign) in [
            ("The sum of the two", larger + smaller, 1),
            ("The difference of the two", larger - smaller, -1),
        ] {
            let expected = size * (int(sign) * argument).exp();
            p.identity((says, sum), ("as it should be", expected))?;
        }
        Ok(())
    })
}

const SLOWER: Compared = Compared::one(r"$\rho\pm p$ by (111) and (112)", r"$A\exp(\pm\alpha)$");
const FASTER: Compared = Compared::one(r"$p\pm\rho$ by (117) and (118)", r"$B\exp(\pm\beta)$");

pub(crate) const EQ111: Vectorial = consistent(SLOWER, paper::eq111_p::parts, |printed| {
    let both = [paper::eq112_rho::tree(), printed[0]];
    sums(
        "(111): ρ ± p = A exp(±α)",
        Setting::slower(),
        both,
        ["A", "α"],
    )
});
pub(crate) const EQ112: Vectorial = consistent(SLOWER, paper::eq112_rho::parts, |printed| {
    let both = [printed[0], paper::eq111_p::tree()];
    sums(
        "(112): ρ ± p = A exp(±α)",
        Setting::slower(),
        both,
        ["A", "α"],
    )
});

attempts![
    &EQ93 = consistent(
        Compared::one("(93)", "the size of the velocity"),
        || vec![paper::eq93_speed(vectors()[1])],
        |printed| {
            let size = symbol("p");
            let expected = ("the size of the velocity p (cos χ, sin χ)", size);
            is("(93): p", Setting::polar(), &printed, expected)
        },
    ),
    &EQ94 = consistent(
        Compared::one("(94)", r"$\bm\rho\cdot(\mathrm d\bm\rho/\mathrm d\tau)/p$"),
        paper::eq94_xi::parts,
        |printed| {
            let [[x, y], [u, v]] = vectors();
            let along = (x * u + y * v) / symbol("p");
            let expected = ("the position along the velocity", along);
            is("(94): ξ", Setting::polar(), &printed, expected)
        },
    ),
    &EQ95,
    &EQ110,
    &EQ116 = consistent(
        Compared::one("(116), by (117) and (118),", "$B^2$"),
        paper::eq116_case::parts,
        |printed| {
            let expected = ("positive", symbol("B").squared());
            let title = "(116): with (117) and (118)";
            is(title, Setting::faster(), &printed, expected)
        },
    ),
    &EQ111,
    &EQ112,
    &EQ117 = consistent(FASTER, paper::eq117_p::parts, |printed| {
        let both = [printed[0], paper::eq118_rho::tree()];
        sums(
            "(117): p ± ρ = B exp(±β)",
            Setting::faster(),
            both,
            ["B", "β"],
        )
    }),
    &EQ118 = consistent(FASTER, paper::eq118_rho::parts, |printed| {
        let both = [paper::eq117_p::tree(), printed[0]];
        sums(
            "(118): p ± ρ = B exp(±β)",
            Setting::faster(),
            both,
            ["B", "β"],
        )
    }),
];
