//! The list of mistakes.
//!
//! ```text
//! = coriolis-doubled
//! In the frame of the table the Coriolis force is twice what it is.
//! @ motion/src/turntable/rotating.rs
//! - along_x[k] = omega * omega * x[k] + ⟦2.0⟧ * omega * v[k];
//! + 4.0
//! ```
//!
//! A name, the physics that is wrong, in a sentence, and what has to be changed for it, once or several times: a file, a text
//! that occurs in it once (blanks and line ends apart), and what stands in place of the marked part of it. The file stays the
//! same until another is named. Lines that begin with `#` are notes.

use std::error::Error;
use std::fs;
use std::path::Path;

pub struct Mistake {
    pub name: String,
    pub physics: String,
    pub changes: Vec<Change>,
}

#[derive(Default)]
pub struct Change {
    pub file: String,
    /// With the marked part.
    pub right: String,
    pub wrong: String,
}

pub fn read(folder: &Path) -> Result<Vec<Mistake>, Box<dyn Error>> {
    let files: Result<Vec<_>, _> = fs::read_dir(folder)?.map(|f| f.map(|f| f.path())).collect();
    let mut files = files?;
    files.sort();
    let mut mistakes: Vec<Mistake> = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file)?;
        parse(&text, &mut mistakes).map_err(|why| format!("{}: {why}", file.display()))?;
    }
    for (i, mistake) in mistakes.iter().enumerate() {
        let name = &mistake.name;
        if mistake.changes.is_empty() || mistake.physics.is_empty() {
            return Err(format!("{name} is not complete").into());
        }
        if mistakes[..i].iter().any(|other| other.name == *name) {
            return Err(format!("two mistakes are called {name}").into());
        }
    }
    Ok(mistakes)
}

fn parse(text: &str, mistakes: &mut Vec<Mistake>) -> Result<(), String> {
    let mut file = String::new();
    let mut before = ' ';
    for (n, line) in text.lines().enumerate() {
        let wrong = || format!("line {}: {line}", n + 1);
        let sign = line.chars().next().unwrap_or('#');
        let rest = line.get(2..).unwrap_or("");
        if sign == '=' {
            mistakes.push(Mistake {
                name: rest.to_owned(),
                physics: String::new(),
                changes: Vec::new(),
            });
        }
        let Some(mistake) = mistakes.last_mut() else {
            match sign {
                '#' => continue,
                _ => return Err(wrong()),
            }
        };
        match sign {
            '#' | '=' => {}
            '@' => rest.clone_into(&mut file),
            '-' if before == '-' => {
                let change = mistake.changes.last_mut().ok_or_else(wrong)?;
                change.right = format!("{}\n{rest}", change.right);
            }
            '-' => mistake.changes.push(Change {
                file: file.clone(),
                right: rest.to_owned(),
                wrong: String::new(),
            }),
            '+' => {
                let change = mistake.changes.last_mut().ok_or_else(wrong)?;
                change.wrong = format!("{}{rest}\n", change.wrong);
            }
            _ if mistake.changes.is_empty() => {
                let blank = if mistake.physics.is_empty() { "" } else { " " };
                mistake.physics += &format!("{blank}{line}");
            }
            _ => return Err(wrong()),
        }
        before = sign;
    }
    Ok(())
}
