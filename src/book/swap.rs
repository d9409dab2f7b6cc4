//! Nothing half-written: the book is made beside its place and changes places with what is there.

use super::error::BookError;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The file by which a folder is known as a book of ours.
pub(super) const MARKER: &str = ".slipbook";

/// What stands in it.
pub(super) const MARKER_TEXT: &[u8] =
    b"A book written by slipbook. The next run replaces this folder as a whole.\n";

/// How the name of a temporary folder begins.
const PREFIX: &str = ".slipbook-";

/// The file in a temporary folder that its run keeps locked. The system ends the lock with the run, however that ends.
const LOCK: &str = "lock";

/// A temporary folder on the same file system as the book's place.
pub(super) struct Staging {
    // Closed before the folder goes, as some systems want it.
    _lock: File,
    folder: TempDir,
    out: PathBuf,
}

impl Staging {
    /// A temporary folder beside `out`, whose parent is made where it is missing. It goes when it is
    /// dropped.
    pub(super) fn beside(out: &Path) -> Result<Self, BookError> {
        let out = resolve(out).map_err(|reason| unwritable(out, reason))?;
        let no_parent = || io::Error::new(io::ErrorKind::InvalidInput, "this is no folder's name");
        let parent = out.parent().ok_or_else(|| unwritable(&out, no_parent()))?;
        check(&out)?;
        fs::create_dir_all(parent).map_err(|reason| unwritable(parent, reason))?;
        sweep(parent);
        let folder = tempfile::Builder::new()
            .prefix(PREFIX)
            .tempdir_in(parent)
            .map_err(|reason| unwritable(parent, bare(reason)))?;
        let lock = lock(folder.path(), &out).map_err(|reason| unwritable(folder.path(), reason))?;
        Ok(Staging {
            _lock: lock,
            folder,
            out,
        })
    }

    /// A path within the temporary folder.
    pub(super) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Puts the finished `book` in place; returns where that is. Of two runs that do so at once, the later one wins.
    pub(super) fn swap(self, book: &Path) -> Result<PathBuf, BookError> {
        let mut reason = io::Error::from(io::ErrorKind::AlreadyExists);
        let mut moved: Option<String> = None;
        for attempt in 0..ATTEMPTS {
            if let Err(refusal) = check(&self.out) {
                return Err(match moved {
                    None => refusal,
                    Some(old) => self.displaced(&old, reason),
                });
            }
            let old = old(attempt);
            match fs::rename(&self.out, self.path(&old)) {
                Ok(()) => moved = Some(old),
                Err(error) if error.kind() == io::ErrorKind::NotFound => {}
                Err(error) => return Err(unwritable(&self.out, error)),
            }
            match fs::rename(book, &self.out) {
                Ok(()) => return Ok(self.out),
                Err(error) => reason = error,
            }
            // Another run has put its book there in between: take that one away too.
            use io::ErrorKind::{AlreadyExists, DirectoryNotEmpty};
            if matches!(reason.kind(), AlreadyExists | DirectoryNotEmpty) {
                continue;
            }
            return Err(match moved {
                Some(old) if fs::rename(self.path(&old), &self.out).is_err() => {
                    self.displaced(&old, reason)
                }
                _ => unwritable(&self.out, reason),
            });
        }
        Err(unwritable(&self.out, reason))
    }

    /// The earlier book could not be put back: it stays where it is.
    fn displaced(self, old: &str, reason: io::Error) -> BookError {
        let kept = self.folder.keep().join(old);
        BookError::Displaced { kept, reason }
    }
}

/// Locks a new temporary folder of the book at `out`, whose name stands in the lock. The lock has its own name only once
/// it is held, so that no other run finds it free.
fn lock(folder: &Path, out: &Path) -> io::Result<File> {
    let making = folder.join("locking");
    let mut file = File::create(&making)?;
    file.write_all(out.file_name().unwrap_or_default().as_encoded_bytes())?;
    // A file system without locks has none that could be found free, either.
    if file.lock().is_ok() {
        fs::rename(making, folder.join(LOCK))?;
    }
    Ok(file)
}

/// Removes what killed runs have left in `parent`: temporary folders whose lock nobody holds. An earlier book that was
/// taken away, but not yet replaced, goes back to its place; where something else than a book is there by now, it stays
/// where it is. What cannot be removed is in nobody's way.
fn sweep(parent: &Path) {
    let entries = fs::read_dir(parent).into_iter().flatten().flatten();
    for entry in entries.filter(|e| e.file_name().to_string_lossy().starts_with(PREFIX)) {
        let folder = entry.path();
        let mut name = Vec::new();
        let free = File::open(folder.join(LOCK))
            .is_ok_and(|mut lock| lock.try_lock().is_ok() && lock.read_to_end(&mut name).is_ok());
        if !free {
            continue;
        }
        let name = String::from_utf8_lossy(&name);
        let out = parent.join(Path::new(&*name).file_name().unwrap_or_default());
        let earlier = (0..ATTEMPTS).map(|attempt| folder.join(old(attempt)));
        let kept = earlier.filter(|book| book.exists()).count();
        // Only where nothing is: a folder with content is never replaced by a renamed one.
        let back = (0..ATTEMPTS).any(|attempt| fs::rename(folder.join(old(attempt)), &out).is_ok());
        if kept == usize::from(back) || out.join(MARKER).is_file() {
            let _ = fs::remove_dir_all(folder);
        }
    }
}

/// Where an earlier book is put in the temporary folder.
fn old(attempt: usize) -> String {
    format!("old-{attempt}")
}

/// How often another run may come in between.
const ATTEMPTS: usize = 10;

/// The error of a path that cannot be written.
pub(super) fn unwritable(path: &Path, reason: io::Error) -> BookError {
    BookError::Unwritable {
        path: path.to_owned(),
        reason,
    }
}

/// The system's own words, without the temporary name that `tempfile` adds.
fn bare(error: io::Error) -> io::Error {
    match error.raw_os_error() {
        Some(code) => io::Error::from_raw_os_error(code),
        None => io::Error::from(error.kind()),
    }
}

/// The absolute path, links followed where the folder exists.
fn resolve(out: &Path) -> io::Result<PathBuf> {
    // Not asked for first: another run may take it away between the question and the answer.
    match out.canonicalize() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => std::path::absolute(out),
        found => found,
    }
}

/// Refuses a place that holds what is not a book of ours. While another run swaps its book in, this may look so for
/// a moment: what is not ours stays so.
fn check(out: &Path) -> Result<(), BookError> {
    let mut found = look(out);
    for _ in 1..ATTEMPTS {
        if !matches!(found, Err(BookError::NotOurs { .. })) {
            break;
        }
        found = look(out);
    }
    found
}

fn look(out: &Path) -> Result<(), BookError> {
    let mut content = match fs::read_dir(out) {
        Ok(content) => content,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(reason) => return Err(unwritable(out, reason)),
    };
    if content.next().is_none() || out.join(MARKER).is_file() {
        Ok(())
    } else {
        Err(BookError::NotOurs {
            path: out.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A finished book in a staging folder.
    fn staged(out: &Path, text: &str) -> (Staging, PathBuf) {
        let staging = Staging::beside(out).unwrap();
        let book = staging.path("book");
        fs::create_dir(&book).unwrap();
        fs::write(book.join(MARKER), MARKER_TEXT).unwrap();
        fs::write(book.join("index.html"), text).unwrap();
        (staging, book)
    }

    #[test]
    fn runs_at_the_same_time_leave_one_whole_book() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("book");
        std::thread::scope(|scope| {
            for n in 0..8 {
                let out = &out;
                scope.spawn(move || {
                    for _ in 0..25 {
                        let (staging, book) = staged(out, &n.to_string());
                        staging.swap(&book).unwrap();
                    }
                });
            }
        });
        let left = fs::read_to_string(out.join("index.html")).unwrap();
        assert!(left.parse::<u32>().unwrap() < 8);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn what_a_killed_run_has_left_goes_with_the_next_run() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("book");
        let left = |name: &str, file: &str| {
            let left = folder.path().join(format!("{PREFIX}{name}"));
            fs::create_dir_all(left.join("source")).unwrap();
            fs::write(left.join(file), "").unwrap();
            left
        };
        let alive = Staging::beside(&out).unwrap();
        let (killed, foreign) = (left("killed", LOCK), left("foreign", "thesis.tex"));
        let (next, book) = staged(&out, "next");
        assert!(!killed.exists());
        assert!(alive.path("").exists() && foreign.exists());
        next.swap(&book).unwrap();
        drop(alive);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_book_that_a_killed_run_took_away_comes_back() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name);
        let killed = |out: &str| {
            let left = place(&format!("{PREFIX}{out}"));
            fs::create_dir_all(left.join("old-0")).unwrap();
            fs::write(left.join(LOCK), out).unwrap();
            fs::write(left.join("old-0").join(MARKER), out).unwrap();
            left
        };
        let (missing, replaced, taken) = (killed("missing"), killed("replaced"), killed("taken"));
        fs::create_dir(place("replaced")).unwrap();
        fs::write(place("replaced").join(MARKER), "later").unwrap();
        fs::create_dir(place("taken")).unwrap();
        fs::write(place("taken").join("thesis.tex"), "").unwrap();
        drop(Staging::beside(&place("another")).unwrap());
        let marker = |name: &str| fs::read_to_string(place(name).join(MARKER)).ok();
        assert_eq!(marker("missing").as_deref(), Some("missing"));
        assert_eq!(marker("replaced").as_deref(), Some("later"));
        assert!(marker("taken").is_none() && taken.join("old-0").join(MARKER).is_file());
        assert!(!missing.exists() && !replaced.exists());
    }

    #[test]
    fn what_cannot_be_put_in_place_leaves_the_earlier_book() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("book");
        let (staging, book) = staged(&out, "earlier");
        staging.swap(&book).unwrap();
        let (staging, book) = staged(&out, "later");
        let error = staging.swap(&book.join("nowhere")).unwrap_err();
        assert!(matches!(error, BookError::Unwritable { .. }), "{error}");
        assert_eq!(
            fs::read_to_string(out.join("index.html")).unwrap(),
            "earlier"
        );
    }
}
