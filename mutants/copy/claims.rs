//! What `tests/claims.rs` asks, claim by claim: each process asks what it is told, in that order, until the first failure.
//!
//! `s:ID=LIMIT` compares a claim's sheet and the points of its trials with the snapshots, `v:ID=LIMIT` tries its
//! formulas' wrong variants, `d:=LIMIT` compares the dependencies, `n:=LIMIT` looks for snapshots without a claim, and
//! `t:TABLE=LIMIT` asks whether a tolerance is too loose, with the worst disagreements of the claims tried here and, of
//! the others, those in the table. A limit is in seconds. What the verdicts, the reasons for a measurement and the snapshot edited by hand are
//! compared with stands in the sheets.

use slipbook::claims::{PAPER, variants};
use slipbook::evidence::{Evidence, Outcome};
use slipbook::ledger::{Entry, Ledger};
use std::collections::BTreeMap;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::exit;
use std::sync::Mutex;
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

const SNAPSHOTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots");

/// When the current question has taken too long.
static UNTIL: Mutex<Option<Instant>> = Mutex::new(None);

/// The worst disagreement of a trial within its tolerance: by claim, tolerance and reason.
type Worst = BTreeMap<(String, u64, String), f64>;

fn main() {
    let mut worst = Worst::new();
    spawn(|| {
        loop {
            sleep(Duration::from_millis(50));
            if UNTIL
                .lock()
                .unwrap()
                .is_some_and(|until| Instant::now() > until)
            {
                println!("slow");
                exit(3);
            }
        }
    });
    for question in std::env::args().skip(1) {
        let (what, limit) = question.rsplit_once('=').unwrap();
        let start = Instant::now();
        *UNTIL.lock().unwrap() = Some(start + Duration::from_secs_f64(limit.parse().unwrap()));
        let answer = catch_unwind(AssertUnwindSafe(|| ask(what, &mut worst)));
        *UNTIL.lock().unwrap() = None;
        if !answer.unwrap_or(false) {
            println!("caught {what}");
            exit(1);
        }
        println!("ok {what} {}", start.elapsed().as_secs_f64());
    }
    if std::env::var_os("SLIPBOOK_TABLE").is_some() {
        for ((claim, bits, reason), worst) in &worst {
            println!("worst {claim}\t{bits}\t{}\t{reason}", worst.to_bits());
        }
    }
}

fn ask(question: &str, worst: &mut Worst) -> bool {
    let (what, of) = question.split_once(':').unwrap();
    match what {
        "s" => sheet(of, worst),
        "v" => wrong_variants(of),
        "d" => {
            let line = |c: &claims::Claim| format!("{}: {}\n", c.id, c.depends_on.join(" "));
            let all: String = PAPER.claims().map(|(_, claim)| line(claim)).collect();
            same("dependencies", &all)
        }
        "n" => PAPER.topics.iter().all(|topic| {
            let mut files = fs::read_dir(format!("{SNAPSHOTS}/{}", topic.stem)).unwrap();
            files.all(|file| {
                let name = file.unwrap().file_name().to_string_lossy().into_owned();
                let own = topic
                    .claims
                    .iter()
                    .any(|c| name == format!("{}.snap", c.id));
                own || name.starts_with("portrait.snap")
            })
        }),
        _ => none_too_loose(of, worst),
    }
}

/// Whether a text is that of a snapshot: as insta compares it, without the blank lines around it.
fn same(name: &str, text: &str) -> bool {
    let snapshot = fs::read_to_string(format!("{SNAPSHOTS}/{name}.snap")).unwrap();
    let there = snapshot.splitn(3, "---\n").nth(2).unwrap();
    let lines = |text: &str| text.trim_end().lines().collect::<Vec<_>>().join("\n");
    lines(there.trim_start_matches('\n')) == lines(text.trim_start_matches('\n'))
}

fn sheet(id: &str, worst: &mut Worst) -> bool {
    let ledger = Ledger::try_some(&PAPER, &[id], |_| {});
    let [entry] = &ledger.entries[..] else {
        return false;
    };
    let measured = entry.evidence.iter().filter(|e| !e.route.is_proof());
    for e in measured.filter(|e| e.outcome() == Outcome::Agrees) {
        let key = (
            id.to_owned(),
            e.tolerance.value.to_bits(),
            e.tolerance.reason.to_owned(),
        );
        let so_far = worst.entry(key).or_default();
        *so_far = so_far.max(e.worst);
    }
    same(&format!("{}/{id}", entry.topic.stem), &entry.sheet()) && points(entry)
}

/// Whether the claim's trials look where they looked.
fn points(entry: &Entry) -> bool {
    let id = entry.claim.id;
    let tried = entry.evidence.iter().filter(|e| e.fingerprint != 0);
    let line = |e: &Evidence| {
        format!(
            "{id}, {}: {} points, {:016x}",
            e.route.name(),
            e.points,
            e.fingerprint
        )
    };
    let snapshot = fs::read_to_string(format!("{SNAPSHOTS}/points.snap")).unwrap();
    let recorded = snapshot
        .lines()
        .filter(|l| l.starts_with(&format!("{id}, ")));
    recorded.eq(tried.map(line).collect::<Vec<_>>())
}

fn wrong_variants(id: &str) -> bool {
    let mut all = PAPER.formulas.variants();
    all.retain(|v| v.claim == id);
    let ledger = Ledger::try_some(&PAPER, &[id], |_| {});
    let rejected = ledger.rejected(&all);
    let survive = || {
        all.iter()
            .zip(&rejected)
            .filter(|(_, yes)| !**yes)
            .map(|(v, _)| v.text.as_str())
    };
    let excused = variants::SURVIVORS
        .iter()
        .filter(|s| s.claim == id)
        .map(|s| s.text);
    let record = include_str!("../snapshots/variants.snap");
    let counts = format!("{} of {}", all.len() - survive().count(), all.len());
    let recorded = record
        .lines()
        .find_map(|line| line.strip_prefix(id)?.strip_prefix(": "));
    survive().eq(excused) && recorded.map_or(all.is_empty(), |r| r == counts)
}

fn none_too_loose(table: &str, here: &Worst) -> bool {
    let mut all = BTreeMap::<(u64, String), f64>::new();
    let mut add = |bits: u64, reason: &str, worst: f64| {
        let so_far = all.entry((bits, reason.to_owned())).or_default();
        *so_far = so_far.max(worst);
    };
    for line in fs::read_to_string(table).unwrap().lines() {
        let cells: Vec<_> = line.splitn(4, '\t').collect();
        if !here.keys().any(|(claim, ..)| claim == cells[0]) {
            add(
                cells[1].parse().unwrap(),
                cells[3],
                f64::from_bits(cells[2].parse().unwrap()),
            );
        }
    }
    here.iter()
        .for_each(|((_, bits, reason), worst)| add(*bits, reason, *worst));
    all.iter()
        .all(|((bits, _), worst)| f64::from_bits(*bits) <= 10.0 * worst)
}
