
/// The number of the mistake that is made; 0 for none, [`NOTED`] for none while it is noted which could be made.
static WRONG: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);

/// Makes no mistake, and notes which could be made.
pub const NOTED: usize = usize::MAX;

/// The mistakes whose place was passed while it was noted.
static PASSED: [std::sync::atomic::AtomicBool; 1000] =
    [const { std::sync::atomic::AtomicBool::new(false) }; 1000];

/// Makes the mistake of this number from now on.
pub fn go_wrong(number: usize) {
    WRONG.store(number, std::sync::atomic::Ordering::Relaxed);
}

/// The numbers of the mistakes whose place was passed while it was noted.
pub fn passed() -> impl Iterator<Item = usize> {
    (0..).zip(&PASSED).filter_map(|(number, passed)| {
        passed.load(std::sync::atomic::Ordering::Relaxed).then_some(number)
    })
}

/// Whether the mistake of this number is made.
#[inline(always)]
pub(crate) fn wrong(number: usize) -> bool {
    let made = WRONG.load(std::sync::atomic::Ordering::Relaxed);
    if made == NOTED {
        PASSED[number].store(true, std::sync::atomic::Ordering::Relaxed);
    }
    made == number
}
