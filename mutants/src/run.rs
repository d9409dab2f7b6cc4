//! Tries the ledger with one mistake after the other.

use crate::list::Mistake;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Without a mistake it takes a second or two on one core.
const LIMIT: Duration = Duration::from_secs(300);

#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    verdict: String,
    trials: Vec<Said>,
}

#[derive(Debug, Clone, PartialEq, Default)]
struct Said {
    route: String,
    subject: String,
    /// Of the measurements with its route and subject, from 1 in the order of the row.
    nth: usize,
    outcome: String,
    points: usize,
    /// Our own side gave a number everywhere.
    whole: bool,
    found: String,
    failed: usize,
}

impl Said {
    /// It comes to something else, or finds something else where it looked.
    fn reacts(&self, wrong: &Said) -> bool {
        let looked = wrong.whole && wrong.points == self.points;
        wrong.outcome != self.outcome || looked && wrong.found != self.found
    }
}

pub type Verdicts = Vec<(String, Judged)>;

pub enum Found {
    Changed {
        /// Ids, in the paper's order.
        claims: Vec<String>,
        /// `claim/route/subject/nth`, in the same order.
        trials: Vec<String>,
        /// Of every measurement of the ledger; with the number of its comparisons that disagree.
        reactions: Vec<(bool, usize)>,
    },
    /// There are no verdicts, and why.
    Fails(String),
}

impl Found {
    pub fn is_noticed(&self) -> bool {
        matches!(self, Found::Changed { claims, .. } if !claims.is_empty())
    }
}

/// Of these ids, or of all, with the mistake of this number, 0 for none.
fn verdicts(
    program: &Path,
    number: usize,
    ids: &[&str],
    threads: usize,
) -> Result<Verdicts, String> {
    let text = said(program, &number.to_string(), ids, threads)?;
    Ok(text.lines().filter_map(judged).collect())
}

fn said(program: &Path, number: &str, ids: &[&str], threads: usize) -> Result<String, String> {
    let mut child = Command::new(program)
        .arg(number)
        .args(ids)
        .env("RAYON_NUM_THREADS", threads.to_string())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|e| e.to_string())?;
    let mut out = child.stdout.take().ok_or("no output")?;
    let reader = thread::spawn(move || {
        let mut text = String::new();
        out.read_to_string(&mut text).map(|_| text)
    });
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(|e| e.to_string())? {
            break status;
        }
        if start.elapsed() > LIMIT {
            let _ = child.kill();
            let _ = child.wait();
            return Err(format!("no verdicts within {} s", LIMIT.as_secs()));
        }
        thread::sleep(Duration::from_millis(10));
    };
    if !status.success() {
        return Err("the ledger breaks off".into());
    }
    let text = reader.join().map_err(|_| "no output")?;
    text.map_err(|e| e.to_string())
}

fn judged(line: &str) -> Option<(String, Judged)> {
    let mut cells = line.split('\t');
    let (id, verdict) = (cells.next()?.to_owned(), cells.next()?.to_owned());
    let mut trials: Vec<Said> = Vec::new();
    for cell in cells {
        let mut words = cell.split(' ');
        let mut word = || words.next().unwrap_or("").to_owned();
        let (route, subject) = (word(), word());
        let before = trials
            .iter()
            .filter(|said| (&said.route, &said.subject) == (&route, &subject));
        trials.push(Said {
            nth: 1 + before.count(),
            route,
            subject,
            outcome: word(),
            points: word().parse().unwrap_or(0),
            whole: word() != "nan",
            found: word(),
            failed: word().parse().unwrap_or(0),
        });
    }
    Some((id, Judged { verdict, trials }))
}

pub fn without(program: &Path) -> Result<Verdicts, Box<dyn Error>> {
    Ok(verdicts(program, 0, &[], workers())?)
}

pub fn as_recorded(right: &Verdicts, record: &str) -> Result<(), Box<dyn Error>> {
    let lines = record.lines().filter_map(|l| l.split_once(": "));
    let recorded: BTreeMap<_, _> = lines.filter(|(id, _)| *id != "source").collect();
    let other = |(id, judged): &&(String, Judged)| {
        recorded.get(id.as_str()) != Some(&judged.verdict.as_str())
    };
    let others: Vec<_> = right.iter().filter(other).map(|(id, _)| &**id).collect();
    if recorded.len() != right.len() || !others.is_empty() {
        let others = others.join(", ");
        return Err(
            format!("without a mistake the verdicts are not the recorded ones: {others}").into(),
        );
    }
    Ok(())
}

fn workers() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

fn each<T: Sync, R: Send>(
    all: &[T],
    f: impl Fn(&T) -> R + Sync,
    done: impl Fn(usize, &T, &R) + Sync,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let found = Mutex::new(BTreeMap::new());
    thread::scope(|scope| {
        for _ in 0..workers() {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(one) = all.get(i) else { return };
                    let result = f(one);
                    if let Ok(mut found) = found.lock() {
                        done(found.len() + 1, one, &result);
                        found.insert(i, result);
                    }
                }
            });
        }
    });
    found
        .into_inner()
        .unwrap_or_default()
        .into_values()
        .collect()
}

/// Those whose place is passed as the claim is tried by itself. Up to there all is as without them.
pub fn within_reach<'a>(program: &Path, right: &'a Verdicts) -> Result<Reach<'a>, String> {
    let ids: Vec<&str> = right.iter().map(|(id, _)| id.as_str()).collect();
    let passed = |id: &&str| {
        let text = said(program, "passed", &[id], 1)?;
        Ok((text.split_whitespace().filter_map(|n| n.parse().ok())).collect())
    };
    let all: Result<Vec<BTreeSet<usize>>, String> =
        each(&ids, passed, |_, _, _| ()).into_iter().collect();
    Ok(ids.into_iter().zip(all?).collect())
}

pub type Reach<'a> = Vec<(&'a str, BTreeSet<usize>)>;

pub fn all<'a>(
    program: &Path,
    mistakes: &[(usize, &'a Mistake)],
    right: &Verdicts,
    reach: &Reach<'_>,
) -> Vec<(&'a Mistake, Found)> {
    let start = Instant::now();
    let tried = |(number, _): &(usize, &'a Mistake)| {
        let ids = reach.iter().filter(|(_, passed)| passed.contains(number));
        let ids: Vec<&str> = ids.map(|(id, _)| *id).collect();
        if ids.is_empty() {
            return changed(right, right);
        }
        match verdicts(program, *number, &ids, 1) {
            Ok(wrong) => changed(right, &with(right, wrong)),
            Err(why) => Found::Fails(why),
        }
    };
    let done = |done: usize, (_, mistake): &(usize, &Mistake), found: &Found| {
        let said = match found {
            Found::Changed { claims, .. } => format!("{} verdicts", claims.len()),
            Found::Fails(why) => why.clone(),
        };
        let (all, seconds) = (mistakes.len(), start.elapsed().as_secs());
        eprintln!("{done} of {all}, {seconds} s: {}: {said}", mistake.name);
    };
    let found = each(mistakes, tried, done);
    mistakes
        .iter()
        .map(|(_, mistake)| *mistake)
        .zip(found)
        .collect()
}

fn with(right: &Verdicts, tried: Verdicts) -> Verdicts {
    let mut tried: BTreeMap<_, _> = tried.into_iter().collect();
    let all = right.iter().map(|(id, judged)| {
        let judged = tried.remove(id).unwrap_or_else(|| judged.clone());
        (id.clone(), judged)
    });
    all.collect()
}

fn changed(right: &Verdicts, wrong: &Verdicts) -> Found {
    let (mut claims, mut trials) = (Vec::new(), Vec::new());
    let mut reactions = Vec::new();
    for ((id, right), (_, wrong)) in right.iter().zip(wrong) {
        let pairs = || right.trials.iter().zip(&wrong.trials);
        reactions.extend(pairs().map(|(right, wrong)| (right.reacts(wrong), wrong.failed)));
        if right.verdict == wrong.verdict {
            continue;
        }
        claims.push(id.clone());
        let others = pairs().filter(|(right, wrong)| right.outcome != wrong.outcome);
        trials.extend(others.map(|(said, _)| {
            let Said {
                route,
                subject,
                nth,
                ..
            } = said;
            format!("{id} {route} {subject} {nth}")
        }));
    }
    Found::Changed {
        claims,
        trials,
        reactions,
    }
}

pub struct Reaction {
    /// Claim's id, route and subject.
    pub key: [String; 3],
    pub nth: usize,
    pub mistakes: usize,
    /// In all; fewer, if it were made more lenient.
    pub disagree: usize,
}

pub fn reactions(right: &Verdicts, found: &[(&Mistake, Found)]) -> Vec<Reaction> {
    let trials = right
        .iter()
        .flat_map(|(id, judged)| judged.trials.iter().map(move |said| (id, said)));
    let mut all: Vec<Reaction> = trials
        .map(|(id, said)| Reaction {
            key: [id, &said.route, &said.subject].map(Clone::clone),
            nth: said.nth,
            mistakes: 0,
            disagree: 0,
        })
        .collect();
    for (_, found) in found {
        if let Found::Changed { reactions, .. } = found {
            for (reaction, (reacts, failed)) in all.iter_mut().zip(reactions) {
                reaction.mistakes += usize::from(*reacts);
                reaction.disagree += failed;
            }
        }
    }
    all
}
