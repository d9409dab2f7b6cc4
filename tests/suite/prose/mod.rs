//! What is printed and what the pages say, against what is computed. The print: the LaTeX of the equations and of the corrections is
//! read into trees and held against the formulas of the code. The pages: numbers, formulas, directions, names and captions are tried.
//!
//! What nothing can compute is not looked at. A row whose words are gone fails; better than a row is a placeholder, `src/edition/words`.

mod by_hand;
mod captions;
mod choices;
mod compare;
mod corrections;
mod counts;
mod data;
mod directions;
mod drawn;
mod formulas;
mod given;
mod letters;
mod meaning;
mod mistakes;
mod numbers;
mod page_formulas;
mod print;
mod printed_part;
mod reads;
mod slips;
pub mod text;
mod words;

pub use by_hand::pencil;
