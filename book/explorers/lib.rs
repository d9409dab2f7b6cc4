//! The door through which the book's pages ask the explorers: their crate compiled to WebAssembly.

use slipbook_motion::explorers;
use std::cell::RefCell;

thread_local! {
    static ANSWER: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
    /// A question in words, and then its answer.
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Puts a question and returns where its answer begins: `Answer::flat` with its length in front, which is 0 where there is no
/// answer.
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

/// Where a question of so many bytes is to be written.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_mut_ptr()
    })
}

/// What `explorers::scene::told` answers, with its length in front.
#[unsafe(no_mangle)]
pub extern "C" fn tell() -> *const u8 {
    TEXT.with_borrow_mut(|text| {
        let told = explorers::scene::told(&String::from_utf8_lossy(text));
        *text = (told.len() as u32).to_le_bytes().to_vec();
        text.extend(told.bytes());
        text.as_ptr()
    })
}
