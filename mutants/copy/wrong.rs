
/// The number of the mistake that is made; 0 for none.
static WRONG: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);

/// Makes the mistake of this number from now on.
pub fn go_wrong(number: usize) {
    WRONG.store(number, std::sync::atomic::Ordering::Relaxed);
}

/// Whether the mistake of this number is made.
#[inline(always)]
pub(crate) fn wrong(number: usize) -> bool {
    WRONG.load(std::sync::atomic::Ordering::Relaxed) == number
}
