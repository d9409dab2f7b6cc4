//! The door through which the book's pages ask the crate's explorers: the same source files, compiled to WebAssembly
//! without the parts of the crate that a page has no use for.

#[path = "../../src/explorers/mod.rs"]
pub mod explorers;
#[path = "../../src/motion/mod.rs"]
pub mod motion;
#[path = "../../trialbook/src/scalar.rs"]
pub mod scalar;

/// The tools that the motions use.
#[path = "../../trialbook/src/numerics"]
pub mod numerics {
    pub mod batch;
    pub mod double;
    pub mod error;
    pub mod events;
    pub mod lanes;
    pub mod number;
    pub mod piecewise;
    pub mod roots;
    pub mod series;
    pub mod taylor;

    pub use error::NumericsError;
}

use std::cell::RefCell;

thread_local! {
    /// The last answer; it stays where it is until the next question.
    static ANSWER: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// Puts a question and returns where its answer begins in the memory: the list of `Answer::flat` with its length in
/// front, which is 0 where there is no answer.
#[unsafe(no_mangle)]
pub extern "C" fn ask(number: u32, a: f64, b: f64, c: f64, d: f64) -> *const f64 {
    let found = explorers::answer(number as usize, [a, b, c, d]);
    let flat = found.map(|answer| answer.flat()).unwrap_or_default();
    ANSWER.with_borrow_mut(|answer| {
        answer.clear();
        answer.push(flat.len() as f64);
        answer.extend(flat);
        answer.as_ptr()
    })
}
