//! Data of a crate: read from its folder in a build that checks itself, built in where it is released.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Deref;
use std::sync::{Mutex, PoisonError};

/// A text that a crate has beside its sources; reads as a `str`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Text {
    /// What it says.
    Built(&'static str),
    /// The path of its file.
    File(&'static str),
}

/// A file of data that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{path} belongs to this build, and cannot be read: {why}")]
pub struct Unreadable {
    /// Its path.
    pub path: &'static str,
    /// Why not.
    pub why: String,
}

static READ: Mutex<BTreeMap<&str, &str>> = Mutex::new(BTreeMap::new());

impl Text {
    /// What it says; a file is read once.
    ///
    /// # Errors
    /// [`Unreadable`] if there is no such file, or no text in it.
    pub fn read(self) -> Result<&'static str, Unreadable> {
        let path = match self {
            Text::Built(text) => return Ok(text),
            Text::File(path) => path,
        };
        let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(text) = read.get(path) {
            return Ok(text);
        }
        let text = fs::read_to_string(path).map_err(|why| Unreadable {
            path,
            why: why.to_string(),
        })?;
        Ok(read.entry(path).or_insert(text.leak()))
    }

    /// The same, where an error has been told before: `Edition::check` does.
    ///
    /// # Panics
    /// If its file cannot be read.
    pub fn as_str(self) -> &'static str {
        self.read().unwrap_or_else(|error| panic!("{error}"))
    }
}

/// As [`Text::as_str`].
impl Deref for Text {
    type Target = str;

    fn deref(&self) -> &str {
        self.as_str()
    }
}

/// A [`Text`] by its path from the crate's folder: `text!("verdicts.txt")`.
#[macro_export]
macro_rules! text {
    ($path:expr) => {{
        #[cfg(debug_assertions)]
        const TEXT: $crate::data::Text =
            $crate::data::Text::File(concat!(env!("CARGO_MANIFEST_DIR"), "/", $path));
        #[cfg(not(debug_assertions))]
        const TEXT: $crate::data::Text = $crate::data::Text::Built(include_str!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/",
            $path
        )));
        TEXT
    }};
}

pub use text;

/// The texts of a folder that a crate has beside its sources.
#[derive(Debug, Clone, Copy)]
pub enum Folder {
    /// No folder.
    None,
    /// What was in it.
    Built(&'static include_dir::Dir<'static>),
    /// The path of the folder.
    Here(&'static str),
}

impl Folder {
    /// The files whose names end so, also of folders in it: path from the folder and text, in order; without
    /// those that cannot be read.
    pub fn texts(self, ending: &str) -> Vec<(String, String)> {
        let mut all = Vec::new();
        match self {
            Self::None => {}
            Self::Built(folder) => {
                let mut open = vec![folder];
                while let Some(folder) = open.pop() {
                    open.extend(folder.dirs());
                    let text = |file: &include_dir::File<'_>| {
                        Some((
                            file.path().to_str()?.to_owned(),
                            file.contents_utf8()?.to_owned(),
                        ))
                    };
                    all.extend(folder.files().filter_map(text));
                }
            }
            Self::Here(path) => gather(path.as_ref(), "", &mut all),
        }
        all.retain(|(path, _)| path.ends_with(ending));
        all.sort_unstable();
        all
    }
}

fn gather(folder: &std::path::Path, before: &str, all: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        let name = format!("{before}{}", name.to_string_lossy());
        if path.is_dir() {
            gather(&path, &format!("{name}/"), all);
        } else if let Ok(text) = fs::read_to_string(&path) {
            all.push((name, text));
        }
    }
}

/// A [`Folder`] by its path from the crate's folder: `folder!("rocq")`.
#[macro_export]
macro_rules! folder {
    ($path:tt) => {{
        #[cfg(debug_assertions)]
        const FOLDER: $crate::data::Folder =
            $crate::data::Folder::Here(concat!(env!("CARGO_MANIFEST_DIR"), "/", $path));
        #[cfg(not(debug_assertions))]
        const FOLDER: $crate::data::Folder = {
            use $crate::data::include_dir;
            static FILES: include_dir::Dir<'_> = include_dir::include_dir!($path);
            $crate::data::Folder::Built(&FILES)
        };
        FOLDER
    }};
}

pub use {folder, include_dir};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_where_it_is_and_missed_by_its_path() {
        let own = text!("src/data.rs").as_str();
        assert!(own.contains("a_file_is_read_where_it_is"));
        let none = Text::File("/no/such/file");
        let error = none.read().unwrap_err().to_string();
        assert!(
            error.starts_with("/no/such/file belongs to this build, and cannot be read: "),
            "{error}"
        );
        assert_eq!(&*Text::Built("a"), "a");
    }
}
