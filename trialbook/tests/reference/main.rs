//! Somebody else's engine: what other programs say, and whether this one says the same.
//!
//! Beside each file lies the script that wrote the answers (Arb and FLINT by python-flint, mpmath, SymPy) as text. Doubles are
//! the shortest decimals that give them back, other numbers have more digits than are compared.

mod balls;
mod exact;
mod integrals;
mod intervals;
mod motions;
mod roots;
mod table;
