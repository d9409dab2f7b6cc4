//! The same results everywhere: in two runs, on one thread and on many, in the debug and in the release profile, on every machine.

use slipbook::book::files_below;
use slipbook::ledger::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

#[test]
fn one_thread_and_many_give_the_same_ledger_and_the_same_book() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("book");
    let output = crate::slipbook(&["--json", "--out", out.to_str().unwrap(), "--jobs", "1"]);
    assert_eq!(crate::check_success(&output), Ok(()));
    let files = |book: &Path| -> BTreeMap<_, _> {
        let files = files_below(book).unwrap().into_iter();
        files
            .map(|(name, path)| (name, fs::read(path).unwrap()))
            .collect()
    };
    let (book, other) = (files(&out), files(&crate::BOOK));
    assert!(book.keys().any(|name| name.ends_with(".csv")) && book.keys().eq(other.keys()));
    let differ = book.iter().filter(|(name, bytes)| other[*name] != **bytes);
    let differ: Vec<_> = differ.map(|(name, _)| name).collect();
    assert!(differ.is_empty(), "{differ:?}");
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let many: Vec<_> = crate::LEDGER.entries.iter().map(Entry::row).collect();
    // So that a number is rounded alike.
    let many = serde_json::to_string(&many).unwrap();
    let many: serde_json::Value = serde_json::from_str(&many).unwrap();
    assert!(said["claims"] == many);
}

/// It is tried in the deep tier.
const OF_RECORDS: [&str; 2] = ["digits", "rest-fates"];

#[test]
fn the_figures_are_the_recorded_ones() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots/figures");
    let mut figures = slipbook::figures::all().unwrap();
    figures.retain(|figure| !OF_RECORDS.contains(&figure.id));
    let settings = crate::snapshots("figures");
    for figure in &figures {
        settings.bind(|| insta::assert_snapshot!(figure.id, thinned(&figure.csv)));
    }
    let names = fs::read_dir(folder).unwrap();
    let names = names.map(|file| file.unwrap().file_name().into_string().unwrap());
    let recorded: BTreeSet<_> = names.filter(|name| name.ends_with(".snap")).collect();
    let drawn = figures.iter().map(|figure| format!("{}.snap", figure.id));
    assert_eq!(recorded, drawn.collect(), "snapshots of figures");
}

/// Each column as a whole, then the first rows and some evenly between them and the last.
fn thinned(csv: &str) -> String {
    let mut lines = csv.lines().map(crate::cells);
    let head = lines.next().unwrap();
    let mut rows: Vec<_> = lines.collect();
    let mut text = format!("{} rows\n", rows.len());
    for (i, name) in head.iter().enumerate() {
        let column = rows.iter_mut().map(|row| &mut row[i]);
        text += &format!("{name}: {}\n", summary(column.collect()));
    }
    text += &format!("\n{}\n", head.join(" | "));
    let last = rows.len() - 1;
    let chosen: BTreeSet<_> = match rows.len() {
        ..=40 => (0..=last).collect(),
        _ => (0..3).chain((0..30).map(|i| i * last / 29)).collect(),
    };
    for row in chosen {
        text += &format!("{}\n", rows[row].join(" | "));
    }
    text
}

/// Of numbers the range and the mean, rounded; of others how often each stands there.
fn summary(column: Vec<&mut String>) -> String {
    let numbers = column.iter().filter(|cell| !cell.is_empty());
    let Ok(numbers) = numbers
        .map(|cell| cell.parse())
        .collect::<Result<Vec<f64>, _>>()
    else {
        let mut times = BTreeMap::<&str, usize>::new();
        for cell in column {
            *times.entry(cell).or_default() += 1;
        }
        let times = times
            .iter()
            .map(|(value, times)| format!("{value} ({times})"));
        return times.collect::<Vec<_>>().join(", ");
    };
    let low = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let high = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
    let size = high.max(-low);
    for cell in column.into_iter().filter(|cell| !cell.is_empty()) {
        *cell = rounded(cell.parse().unwrap(), size);
    }
    let [low, high, mean] = [low, high, mean].map(|x| rounded(x, size));
    format!("{low} to {high}, mean {mean}")
}

/// To six digits; zero where only rounding is left beside numbers of this size.
fn rounded(x: f64, size: f64) -> String {
    if x.abs() < 1e-13 * size {
        return "0".into();
    }
    let short: f64 = format!("{x:.5e}").parse().unwrap();
    match short.abs() {
        1e-4..1e9 => short.to_string(),
        _ => format!("{short:e}"),
    }
}

#[test]
fn a_figure_is_read_in_forty_lines() {
    let row = |i: i32| {
        format!(
            "\"a, b\",{},{}\n",
            f64::from(i) / 7.0,
            f64::from(i % 2) * 1e-20
        )
    };
    let table = |n| String::from("kind,x,y\n") + &(0..n).map(row).collect::<String>();
    let few = "3 rows\nkind: a, b (3)\nx: 0 to 0.285714, mean 0.142857\ny: 0 to 1e-20, mean 3.33333e-21\n\n\
               kind | x | y\na, b | 0 | 0\na, b | 0.142857 | 1e-20\na, b | 0.285714 | 0\n";
    assert_eq!(thinned(&table(3)), few);
    let many = thinned(&table(1000));
    assert!(many.lines().count() <= 40 && many.ends_with("a, b | 142.714 | 1e-20\n"));
    assert_eq!(
        [rounded(6e-16, 2.0), rounded(-1.5e12, 2e12)],
        ["0", "-1.5e12"]
    );
}
