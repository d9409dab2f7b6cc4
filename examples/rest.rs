//! The boundary between rest and escape on the turntable, p = A sinh α, ρ = A cosh α: the paper's (147), what replaces
//! it, and Newton's law.
//!
//! `cargo run --no-default-features --example rest`

use slipbook::corrections::rest::boundary_a;
use slipbook::motion::MotionError;
use slipbook::motion::turntable::boundary;
use slipbook::paper::rest::eq147_a;

fn main() -> Result<(), MotionError> {
    println!("  α       ψ      A by (147)    to second order   by the motion");
    for alpha in [0.01, 0.05, 0.2, 0.5] {
        for psi in [0.0, 1.0, 2.0] {
            let (printed, replaced) = (eq147_a(alpha), boundary_a(alpha, psi));
            let found = boundary(alpha, psi)?;
            println!("{alpha:5}   {psi:3}   {printed:12.9}   {replaced:14.9}   {found:13.9}");
        }
    }
    Ok(())
}
