//! Builds the copy's tests, and finds out which changes each comes to, and how long it takes.

use serde_json::Value;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

/// How many processes run at once.
pub const WORKERS: usize = 2;

/// The tests besides those of the modules. `structure` reads the sources, `browser` needs one.
const TESTS: [&str; 16] = [
    "mutants",
    "judge",
    "drive",
    "claims_list",
    "same",
    "json",
    "command",
    "pages",
    "readme",
    "explorers",
    "careless",
    "attractors",
    "calculators",
    "certified",
    "motions",
    "numbers",
];

/// A test that can be run by itself.
#[derive(Clone)]
pub struct Unit {
    /// The program it is in.
    pub program: PathBuf,
    /// Its name: a test's, or a question of `copy/claims.rs`.
    pub name: String,
    /// How long it takes, in seconds.
    pub seconds: f64,
    /// By change, 1 if it comes to it.
    pub reached: Vec<u8>,
}

impl Unit {
    /// True for a question of `copy/claims.rs`.
    pub fn asks(&self) -> bool {
        let name = self
            .program
            .file_name()
            .map(|n| n.to_string_lossy().into_owned());
        name.is_some_and(|n| n.starts_with("mutants-"))
    }

    /// The name of its file among the kept ones.
    fn file(&self) -> String {
        let program = self
            .program
            .file_name()
            .map(|n| n.to_string_lossy().into_owned());
        let name = self.name.replace([':', '/'], "_");
        format!("{}_{name}", program.unwrap_or_default())
    }

    /// What the program is told, to run it for at most so long.
    pub fn argument(&self, limit: f64) -> String {
        if self.asks() {
            format!("{}={limit}", self.name)
        } else {
            self.name.clone()
        }
    }
}

/// A command that runs tests in the copy.
pub fn command(program: &Path, asks: bool, names: &[String], copy: &Path) -> Command {
    let mut command = Command::new("nice");
    // No more than 6 GB.
    command
        .args([
            "-n",
            "10",
            "sh",
            "-c",
            "ulimit -v 6000000; exec \"$@\"",
            "sh",
        ])
        .arg(program);
    if !asks {
        command.args(["--test-threads=1", "--exact"]);
    }
    command
        .args(names)
        .current_dir(copy)
        .env("INSTA_UPDATE", "no")
        .env("RAYON_NUM_THREADS", "1")
        .env_remove("INSTA_FORCE_PASS")
        .stdin(Stdio::null())
        .stderr(Stdio::null());
    command
}

/// Builds the tests of `.cargo/mutants.toml`; the programs.
pub fn build(copy: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let tests = TESTS.iter().flat_map(|t| ["--test", t]);
    let made = Command::new("nice")
        .args([
            "-n",
            "10",
            "cargo",
            "test",
            "-j2",
            "--workspace",
            "--release",
            "--no-run",
            "--message-format=json",
        ])
        .arg("--lib")
        .args(tests)
        .env(
            "CARGO_TARGET_DIR",
            std::path::absolute("target/mutants/target")?,
        )
        .current_dir(copy)
        .stderr(Stdio::inherit())
        .output()?;
    if !made.status.success() {
        return Err("the copy does not build".into());
    }
    let mut programs = Vec::new();
    for line in String::from_utf8(made.stdout)?.lines() {
        let message: Value = serde_json::from_str(line)?;
        let test = message["profile"]["test"] == true;
        programs.extend(
            message["executable"]
                .as_str()
                .filter(|_| test)
                .map(PathBuf::from),
        );
    }
    Ok(programs)
}

/// Every unit of the programs, by time. `ids` are those of the claims. Kept in `scratch` once it is made.
pub fn cover(
    programs: &[PathBuf],
    ids: &[String],
    copy: &Path,
    scratch: &Path,
) -> Result<Vec<Unit>, Box<dyn Error>> {
    let unit = |program: &PathBuf, name: String| Unit {
        program: program.clone(),
        name,
        seconds: 0.0,
        reached: Vec::new(),
    };
    let mut units = vec![];
    for program in programs {
        if unit(program, String::new()).asks() {
            units.extend(ids.iter().map(|id| unit(program, format!("s:{id}"))));
            units.extend(ids.iter().map(|id| unit(program, format!("v:{id}"))));
            units.extend(["d:", "n:"].map(|q| unit(program, q.into())));
        } else {
            let list = Command::new(program)
                .args(["--list", "--format", "terse"])
                .output()?;
            let list = String::from_utf8(list.stdout)?;
            units.extend(
                list.lines()
                    .filter_map(|l| l.strip_suffix(": test"))
                    .map(|n| unit(program, n.into())),
            );
        }
    }
    let folder = fs::canonicalize(scratch)?.join("reached");
    fs::create_dir_all(&folder)?;
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(unit) = units.get(i) else {
                return found;
            };
            if i.is_multiple_of(50) {
                eprintln!("{i} of {} tests run alone", units.len());
            }
            found.push((i, alone(unit, &folder.join(unit.file()), copy)));
        }
    };
    let found: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..WORKERS).map(|_| scope.spawn(work)).collect();
        workers
            .into_iter()
            .flat_map(|w| w.join().unwrap_or_default())
            .collect()
    });
    let mut table = String::new();
    for (i, run) in found {
        match run {
            Ok((seconds, reached, worst)) => {
                units[i].seconds = seconds;
                units[i].reached = reached;
                table += &worst;
            }
            Err(why) => eprintln!("left out: {why}"),
        }
    }
    fs::write(scratch.join("table"), table)?;
    units.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    Ok(units)
}

/// Runs a unit without changes: how long it takes, which changes it comes to, and what it tells of disagreements.
fn alone(unit: &Unit, file: &Path, copy: &Path) -> Result<(f64, Vec<u8>, String), String> {
    let names = [unit.argument(1000.0)];
    let run = |variable: &str, value: &str| {
        let start = Instant::now();
        let output = command(&unit.program, unit.asks(), &names, copy)
            .env(variable, value)
            .output();
        let output = output.map_err(|e| e.to_string())?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            return Err(format!("{} fails without a change: {said}", unit.name));
        }
        Ok((
            start.elapsed().as_secs_f64(),
            String::from_utf8_lossy(&output.stdout).into_owned(),
        ))
    };
    let kept = file.with_extension("said");
    let before = fs::read_to_string(&kept).unwrap_or_default();
    let whole = before
        .split_once('\n')
        .filter(|(_, text)| text.ends_with("done\n"));
    let (seconds, said) = match whole.and_then(|(t, said)| Some((t.parse().ok()?, said.to_owned())))
    {
        Some(before) => before,
        None => {
            run("SLIPBOOK_REACHED", &file.to_string_lossy())?;
            let (seconds, said) = run("SLIPBOOK_TABLE", "1")?;
            fs::write(kept, format!("{seconds}\n{said}\ndone\n")).map_err(|e| e.to_string())?;
            (seconds, said)
        }
    };
    let reached = all_of(file).map_err(|e| e.to_string())?;
    let worst = said.lines().filter_map(|l| l.strip_prefix("worst "));
    Ok((seconds, reached, worst.map(|l| format!("{l}\n")).collect()))
}

/// Which changes the processes of a test came to; none if it left no file.
fn all_of(file: &Path) -> std::io::Result<Vec<u8>> {
    let own = |path: &Path| {
        path.with_extension("") == file && path.extension().is_some_and(|e| e != "said")
    };
    let mut all = Vec::new();
    for entry in fs::read_dir(file.parent().unwrap_or(file))? {
        let path = entry?.path();
        if own(&path) {
            let one = fs::read(path)?;
            all.resize(one.len(), 0);
            all.iter_mut().zip(&one).for_each(|(a, b)| *a |= b);
        }
    }
    Ok(all)
}
