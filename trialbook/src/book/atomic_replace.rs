//! Nothing half-written: the book is made beside its place, and both change places.

use super::error::BookError;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Locked as long as its run lives, however that ends; holds the name of the book's place.
const LOCK: &str = "lock";

const ATTEMPTS: usize = 10;

/// On the same file system as the book's place.
pub(super) struct Staging {
    // Closed before the folder goes, as some systems want it.
    _lock: File,
    folder: TempDir,
    out: PathBuf,
    name: &'static str,
}

impl Staging {
    /// Makes the parent where it is missing. The folder goes when it is dropped.
    pub(super) fn beside(out: &Path, name: &'static str) -> Result<Self, BookError> {
        let out = resolve(out).map_err(|reason| unwritable(out, reason))?;
        let no_parent = || io::Error::new(ErrorKind::InvalidInput, "this is no folder's name");
        let parent = out.parent().ok_or_else(|| unwritable(&out, no_parent()))?;
        check(&out, name)?;
        fs::create_dir_all(parent).map_err(|reason| unwritable(parent, reason))?;
        let prefix = format!(".{name}-");
        sweep(parent, &prefix);
        let folder = tempfile::Builder::new().prefix(&prefix).tempdir_in(parent);
        let folder = folder.map_err(|reason| unwritable(parent, bare(reason)))?;
        let lock = lock(&folder.path().join(LOCK), &out);
        Ok(Staging {
            _lock: lock.map_err(|reason| unwritable(parent, reason))?,
            folder,
            out,
            name,
        })
    }

    pub(super) fn places(&self) -> Places {
        Places {
            folder: self.folder.path().to_owned(),
            out: self.out.clone(),
        }
    }

    pub(super) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(super) fn mark(&self, book: &Path) -> Result<(), BookError> {
        let text = format!(
            "Written by {}. The next run replaces this folder as a whole.\n",
            self.name
        );
        super::put(&book.join(marker(self.name)), text.as_bytes())
    }

    /// Of two runs that do so at once, the later one wins.
    pub(super) fn swap(self, book: &Path) -> Result<PathBuf, BookError> {
        for attempt in 0.. {
            check(&self.out, self.name)?;
            let old = self.path(&format!("old-{attempt}"));
            match fs::rename(&self.out, &old) {
                Err(reason) if reason.kind() != ErrorKind::NotFound => {
                    return Err(unwritable(&self.out, reason));
                }
                _ => {}
            }
            let Err(reason) = fs::rename(book, &self.out) else {
                break;
            };
            // Another run has put its book there in between: take that one away too.
            use ErrorKind::{AlreadyExists, DirectoryNotEmpty};
            if matches!(reason.kind(), AlreadyExists | DirectoryNotEmpty) && attempt < ATTEMPTS {
                continue;
            }
            if old.exists() && fs::rename(&old, &self.out).is_err() {
                let _ = self.folder.keep();
                return Err(BookError::Displaced { kept: old, reason });
            }
            return Err(unwritable(&self.out, reason));
        }
        Ok(self.out)
    }
}

pub(super) struct Places {
    folder: PathBuf,
    out: PathBuf,
}

impl Places {
    pub(super) fn named(&self, error: BookError) -> BookError {
        match error {
            BookError::Unwritable { path, reason } if path.starts_with(&self.folder) => {
                unwritable(&self.out, reason)
            }
            other => other,
        }
    }
}

/// There is something in it only once it is locked, so that no other run finds it free before.
fn lock(path: &Path, out: &Path) -> io::Result<File> {
    let mut file = File::create(path)?;
    // A file system without locks has none that could be found free, either.
    if file.lock().is_ok() {
        let name = out.file_name().and_then(|name| name.to_str());
        writeln!(file, "{}", name.unwrap_or_default())?;
    }
    Ok(file)
}

/// Removes temporary folders whose lock nobody holds. A book that a killed run has taken away goes back
/// first. What cannot be removed is in nobody's way.
fn sweep(parent: &Path, prefix: &str) {
    let entries = fs::read_dir(parent).into_iter().flatten().flatten();
    for entry in entries.filter(|e| e.file_name().to_string_lossy().starts_with(prefix)) {
        let Ok(mut lock) = File::open(entry.path().join(LOCK)) else {
            continue;
        };
        let locked = lock.metadata().is_ok_and(|lock| lock.len() > 0);
        if !locked || lock.try_lock().is_err() {
            continue;
        }
        let mut name = String::new();
        if lock.read_to_string(&mut name).is_ok() && !name.trim_end().is_empty() {
            for attempt in (0..=ATTEMPTS).rev() {
                // Only into an empty place can a folder be renamed.
                let old = entry.path().join(format!("old-{attempt}"));
                let _ = fs::rename(old, parent.join(name.trim_end()));
            }
        }
        let _ = fs::remove_dir_all(entry.path());
    }
}

fn marker(name: &str) -> String {
    format!(".{name}")
}

/// While another run swaps its book in, a place may look foreign for a moment: what is not ours stays so.
fn check(out: &Path, name: &str) -> Result<(), BookError> {
    for _ in 0..ATTEMPTS {
        let empty = match fs::read_dir(out) {
            Ok(mut content) => content.next().is_none(),
            Err(reason) if reason.kind() == ErrorKind::NotFound => true,
            Err(reason) => return Err(unwritable(out, reason)),
        };
        if empty || out.join(marker(name)).is_file() {
            return Ok(());
        }
    }
    let path = out.to_owned();
    Err(BookError::NotOurs { path })
}

pub(super) fn unwritable(path: &Path, reason: io::Error) -> BookError {
    BookError::Unwritable {
        path: path.to_owned(),
        reason,
    }
}

/// Without the temporary name that `tempfile` adds.
pub fn bare(error: io::Error) -> io::Error {
    match error.raw_os_error() {
        Some(code) => io::Error::from_raw_os_error(code),
        None => io::Error::from(error.kind()),
    }
}

/// Links followed where the folder exists.
fn resolve(out: &Path) -> io::Result<PathBuf> {
    // Not asked for first: another run may take it away between the question and the answer.
    match out.canonicalize() {
        Err(error) if error.kind() == ErrorKind::NotFound => match out.is_symlink() {
            true => Err(io::Error::new(
                error.kind(),
                "it is a link that leads nowhere",
            )),
            false => std::path::absolute(out),
        },
        found => found,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn staged(out: &Path, text: &str) -> (Staging, PathBuf) {
        let staging = Staging::beside(out, "paper").unwrap();
        let book = staging.path("book");
        fs::create_dir(&book).unwrap();
        staging.mark(&book).unwrap();
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
            let left = folder.path().join(format!(".paper-{name}"));
            fs::create_dir_all(left.join("source")).unwrap();
            fs::write(left.join(file), "locked").unwrap();
            left
        };
        let alive = Staging::beside(&out, "paper").unwrap();
        let (killed, foreign) = (left("killed", LOCK), left("foreign", "thesis.tex"));
        let (next, book) = staged(&out, "next");
        assert!(!killed.exists());
        assert!(alive.path("").exists() && foreign.exists());
        next.swap(&book).unwrap();
        drop(alive);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_book_that_a_killed_run_has_taken_away_is_put_back() {
        let folder = tempfile::tempdir().unwrap();
        let [out, other] = ["book", "other"].map(|name| folder.path().join(name));
        // Killed between the two renames.
        let killed = |out: &Path| {
            let (staging, book) = staged(out, "earlier");
            staging.swap(&book).unwrap();
            let (staging, _) = staged(out, "later");
            fs::rename(out, staging.path("old-0")).unwrap();
            let _ = staging.folder.keep();
        };
        let text = |out: &Path| fs::read_to_string(out.join("index.html")).unwrap_or_default();
        for next in [&out, &other] {
            killed(&out);
            assert_eq!(text(&out), "");
            drop(Staging::beside(next, "paper").unwrap());
            assert_eq!(text(&out), "earlier");
            assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        }
        // One that has come since stays.
        killed(&out);
        fs::create_dir(&out).unwrap();
        fs::write(out.join("index.html"), "since").unwrap();
        drop(Staging::beside(&other, "paper").unwrap());
        assert_eq!(text(&out), "since");
    }

    #[test]
    fn an_error_names_the_place_and_not_what_stands_for_it() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("book");
        let staging = Staging::beside(&out, "paper").unwrap();
        let of = |path: &Path| {
            let error = unwritable(path, io::Error::from(ErrorKind::StorageFull));
            staging.places().named(error).to_string()
        };
        let place = staging.out.display().to_string();
        assert!(of(&staging.path("source").join("x.md")).contains(&format!("`{place}`")));
        assert!(of(Path::new("/elsewhere")).contains("`/elsewhere`"));
        let made = tempfile::tempdir_in(folder.path().join("nowhere"));
        assert_eq!(
            bare(made.unwrap_err()).to_string(),
            ErrorKind::NotFound.to_string()
        );
    }

    #[cfg(unix)]
    #[test]
    fn a_link_that_leads_nowhere_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("book");
        std::os::unix::fs::symlink("nowhere", &out).unwrap();
        let refused = Staging::beside(&out, "paper").err().unwrap().to_string();
        assert!(refused.contains("leads nowhere"), "{refused}");
        assert!(out.is_symlink());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
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
