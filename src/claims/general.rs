//! Sliding on an accelerating plane: the claims.

use super::{Claim, Topic};
use crate::evidence::Kind;

/// The topic.
pub const TOPIC: Topic = Topic {
    stem: "general",
    title: "Sliding on an accelerating plane",
    claims: CLAIMS,
};

const CLAIMS: &[Claim] = &[
    Claim {
        id: "eq-1",
        section: "2",
        equation: Some(1),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} \bm{v}}{\mathrm{d} t}=-\bm{A}-\mu g \frac{\bm{v}}{v},",
        plain: r"\frac{\mathrm{d} \bm{v}}{\mathrm{d} t}=-\bm{A}-\mu g \frac{\bm{v}}{v},",
        ..Claim::BLANK
    },
    Claim {
        id: "eq-2",
        section: "2",
        equation: Some(2),
        kind: Kind::Equation,
        title: "",
        latex: r"\frac{\mathrm{d} v}{\mathrm{d} t}=-\bm{A}\cdot\frac{\bm{v}}{v}-\mu g.",
        plain: r"\frac{\mathrm{d} v}{\mathrm{d} t}=-\bm{A}\cdot\frac{\bm{v}}{v}-\mu g.",
        ..Claim::BLANK
    },
    Claim {
        id: "s2-stops-if-weak",
        section: "2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"if max |A| < μg, the speed decreases and the particle is at rest after a finite time",
        plain: r"if max |A| < μg, the speed decreases and the particle is at rest after a finite time",
        ..Claim::BLANK
    },
    Claim {
        id: "s2-no-permanent-rest",
        section: "2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"if |A| exceeds μg again and again, the particle cannot stay at rest for ever",
        plain: r"if |A| exceeds μg again and again, the particle cannot stay at rest for ever",
        ..Claim::BLANK
    },
    Claim {
        id: "s2-speeds-up-if-strong",
        section: "2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"if A has a fixed direction and |A| > μg always, then v increases at all sufficiently large times",
        plain: r"if A has a fixed direction and |A| > μg always, then v increases at all sufficiently large times",
        ..Claim::BLANK
    },
    Claim {
        id: "s2-perpendicular-decays",
        section: "2",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: r"if A has a fixed direction, |v⊥| decreases; if |A| is also bounded, v⊥ → 0",
        plain: r"if A has a fixed direction, |v⊥| decreases; if |A| is also bounded, v⊥ → 0",
        ..Claim::BLANK
    },
];
