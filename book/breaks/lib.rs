//! The door through which a page of the book breaks a formula and sees which trials notice. Answers are JSON, with their length
//! in bytes in front, and stay until the next question.

use serde::Serialize;
use slipbook::breaks;
use std::cell::RefCell;

thread_local! {
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

fn put(answer: &impl Serialize) -> *const u8 {
    let json = serde_json::to_vec(answer).unwrap_or_default();
    ANSWER.with_borrow_mut(|kept| {
        kept.clear();
        kept.extend((json.len() as u32).to_le_bytes());
        kept.extend(json);
        kept.as_ptr()
    })
}

/// The claims whose formulas can be broken.
#[unsafe(no_mangle)]
pub extern "C" fn claims() -> *const u8 {
    let claims = breaks::claims().into_iter();
    put(&claims.map(|c| (c.id, c.section, c.title)).collect::<Vec<_>>())
}

/// Nothing for a number that no claim has.
#[unsafe(no_mangle)]
pub extern "C" fn ways(claim: usize) -> *const u8 {
    put(&breaks::claims().get(claim).map(|c| breaks::breaks(c.id)))
}

/// By this it is told whether the module is made of the same; nothing for a number that none has.
#[unsafe(no_mangle)]
pub extern "C" fn made(claim: usize) -> *const u8 {
    put(&breaks::claims().get(claim).map(|c| breaks::made(c)))
}

/// What the trials say; nothing for a number that none has.
#[unsafe(no_mangle)]
pub extern "C" fn broken(claim: usize, way: usize) -> *const u8 {
    let claims = breaks::claims();
    let claim = claims.get(claim);
    let answer = claim.and_then(|c| Some(breaks::answer(c, breaks::breaks(c.id).get(way)?.seed)));
    put(&answer)
}
