//! Somebody else's engine: what other programs say, and whether this one says the same.
//!
//! Beside each of these files lies a script that wrote the answers (Arb and FLINT by python-flint, mpmath, SymPy) and the
//! answers as text. The tests read the text and need none of those programs. Numbers are exchanged exactly: doubles as the
//! shortest decimals that give them back, others with more digits than are compared.

mod balls;
mod exact;
mod integrals;
mod intervals;
mod motions;
mod roots;
mod table;
