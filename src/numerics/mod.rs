//! Numerical methods: thin adapters over libraries, and what no library has.

pub mod piecewise;
