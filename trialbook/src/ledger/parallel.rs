//! Work that has to stay on one thread, on all threads that there are.

use crate::stop;
use rayon::ThreadPoolBuilder;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{available_parallelism, scope};

pub(super) fn each<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let some = || {
        // A mistake is seeded on one thread alone, so all that a trial does has to stay on this one.
        let alone = ThreadPoolBuilder::new().num_threads(1).use_current_thread();
        let pool = alone.build().expect("the thread is in no pool yet");
        let mut done = Vec::new();
        while let i = next.fetch_add(1, Ordering::Relaxed)
            && i < count
            && !stop::is_asked()
        {
            done.push((i, pool.install(|| work(i))));
        }
        done
    };
    let threads = available_parallelism().map_or(1, usize::from);
    let mut done: Vec<_> = scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(some)).collect();
        let done = workers.into_iter();
        done.flat_map(|worker| worker.join().expect("no trial panics"))
            .collect()
    });
    done.sort_by_key(|(i, _)| *i);
    done.into_iter().map(|(_, value)| value).collect()
}
