/// True if the change of this number is on: the one that `SLIPBOOK_MUTANT` names. With `SLIPBOOK_REACHED` all are off,
/// and a file of this name and the process's number tells at the end which were asked for.
#[doc(hidden)]
#[inline]
pub fn mutant(id: u32) -> bool {
    let on = mutants::ON.load(std::sync::atomic::Ordering::Relaxed);
    if on >= mutants::REACHED {
        return mutants::ask(id);
    }
    on == id
}

mod mutants {
    use std::sync::atomic::{AtomicU8, AtomicU32, Ordering::Relaxed};

    pub const REACHED: u32 = u32::MAX - 1;
    const UNKNOWN: u32 = u32::MAX;
    pub static ON: AtomicU32 = AtomicU32::new(UNKNOWN);
    static ASKED: [AtomicU8; COUNT] = [const { AtomicU8::new(0) }; COUNT];

    unsafe extern "C" {
        fn atexit(f: extern "C" fn()) -> i32;
    }

    extern "C" fn tell() {
        let asked: Vec<u8> = ASKED.iter().map(|a| a.load(Relaxed)).collect();
        if let Ok(name) = std::env::var("SLIPBOOK_REACHED") {
            // A test may start the command, which asks too.
            let _ = std::fs::write(format!("{name}.{}", std::process::id()), asked);
        }
    }

    #[cold]
    #[inline(never)]
    pub fn ask(id: u32) -> bool {
        if ON.load(Relaxed) == UNKNOWN {
            static ONCE: std::sync::Once = std::sync::Once::new();
            ONCE.call_once(|| {
                if std::env::var_os("SLIPBOOK_REACHED").is_some() {
                    unsafe { atexit(tell) };
                    ON.store(REACHED, Relaxed);
                } else {
                    let named = std::env::var("SLIPBOOK_MUTANT").ok();
                    ON.store(named.and_then(|n| n.parse().ok()).unwrap_or(0), Relaxed);
                }
            });
        }
        if ON.load(Relaxed) == REACHED {
            ASKED[id as usize].store(1, Relaxed);
            return false;
        }
        ON.load(Relaxed) == id
    }
}

/// One of two iterators.
#[doc(hidden)]
#[derive(Clone)]
pub enum Either<A, B> {
    One(A),
    Two(B),
}

impl<A: Iterator, B: Iterator<Item = A::Item>> Iterator for Either<A, B> {
    type Item = A::Item;
    fn next(&mut self) -> Option<A::Item> {
        match self {
            Either::One(it) => it.next(),
            Either::Two(it) => it.next(),
        }
    }
}
