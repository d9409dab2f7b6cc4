//! The print: the LaTeX of the equations and of the corrections, read into trees, against the formulas of the code. The pages:
//! formulas and decimals are tried; words and counts are computed where they stand, `src/edition/words`, and in captions,
//! `src/figures`.

mod by_hand;
mod compare;
mod corrections;
mod decimals;
mod drawn;
mod files;
mod formulas;
mod given;
mod letters;
mod meaning;
mod mistakes;
mod page_formulas;
mod print;
mod printed_part;
mod reads;
mod slips;
mod text;
mod words;

pub use by_hand::pencil;
