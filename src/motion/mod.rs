//! The equations of motion, and nothing else: Newton's law and Coulomb friction.

pub mod drive;
