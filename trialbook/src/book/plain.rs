//! Plain words for HTML: indices, powers and numbers as a printer sets them.

use super::text::{escape, scientific};
use crate::ledger::{Piece, pieces};

/// Words with indices such as `v_x`, powers such as `x^2`, numbers such as `1e-12` and minus signs, as HTML.
pub(super) fn set(text: &str) -> String {
    let mut out = String::with_capacity(text.len() * 2);
    for piece in pieces(text) {
        match piece {
            Piece::Text(text) => out.push_str(&escape(text)),
            Piece::Index(index) => out.push_str(&format!("<sub>{index}</sub>")),
            Piece::Power(power) => out.push_str(&format!("<sup>{}</sup>", set(power))),
            Piece::Minus => out.push('−'),
            Piece::Equals => {
                out.pop();
                out.push_str("\u{a0}=\u{a0}");
            }
            Piece::Scientific(number) => out.push_str(&scientific(number)),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::set;

    #[test]
    fn plain_mathematics_is_set() {
        for (plain, html) in [
            (
                "dv_x/dt, (q_Y)² & 𝔴_y.",
                "dv<sub>x</sub>/dt, (q<sub>Y</sub>)² &amp; 𝔴<sub>y</sub>.",
            ),
            ("eq20_stop_time, _x", "eq20_stop_time, _x"),
            (
                "A/t^(3/2): x^2, b^10)",
                "A/t<sup>3/2</sup>: x<sup>2</sup>, b<sup>10</sup>)",
            ),
            (
                "u^(a_x^(−1)), r^λ, z^-4",
                "u<sup>a<sub>x</sub><sup>−1</sup></sup>, r<sup>λ</sup>, z<sup>−4</sup>",
            ),
            ("x^, y^(z", "x^, y^(z"),
            (
                "to 1e-12, 3.20e-3, 3.20e-1, 1.0e0",
                "to 10<sup>−12</sup>, 3.2\u{a0}×\u{a0}10<sup>−3</sup>, 0.32, 1",
            ),
            ("1e5 of 2e", "10<sup>5</sup> of 2e"),
            ("a1e-5, s2-x, 3-4", "a1e-5, s2-x, 3-4"),
            (
                "g = 9.81, θ = -2.5 at a = b",
                "g\u{a0}=\u{a0}9.81, θ\u{a0}=\u{a0}−2.5 at a = b",
            ),
            ("(-1) is -1", "(−1) is −1"),
        ] {
            assert_eq!(set(plain), html);
        }
    }
}
