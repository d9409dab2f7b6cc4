//! One test per claim: it is tried, judged, and its sheet held against `snapshots/<topic>/<id>.snap`.

use insta::{Settings, assert_snapshot};
use libtest_mimic::{Arguments, Failed, Trial};
use serde_json::{Value, json};
use slipbook::claims::{PAPER, variants::Variant};
use slipbook::edition::EDITION;
use slipbook::evidence::{Evidence, Outcome, Route, Sample, Subject};
use slipbook::ledger::{Difference, Entry, Ledger, Record, Standing};
use slipbook::seeded::{reading::of, with};
use slipbook::symbols::SYMBOLS;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::thread;
use trialbook::theorems::named as theorem_of;
use trialbook::trials::{Claim, Sort, attempt::Attempt, statement::Proved};

type Test = fn(&Ledger) -> Result<(), Failed>;

const WHOLE: [(&str, Test); 11] = [
    ("verdicts", verdicts),
    ("recorded", same_as_recorded),
    ("reading", reading),
    ("variants", wrong_variants),
    ("proofs", wrong_proofs),
    ("leaning", leaning),
    ("measured", reasons),
    ("shown", shown),
    ("sentences", sentences),
    ("values", values),
    ("conditions", conditions),
];

fn main() -> ExitCode {
    // One after another, or their differences are printed into each other.
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    if let Err(faults) = EDITION.check() {
        eprintln!("{faults}");
        return ExitCode::from(2);
    }
    let asked = |name: &str| {
        let fits = |text: &String| match arguments.exact {
            true => name == text,
            false => name.contains(text.as_str()),
        };
        !arguments.list && arguments.filter.iter().all(fits) && !arguments.skip.iter().any(fits)
    };
    let claims: Vec<_> = PAPER
        .claims()
        .map(|(topic, claim)| {
            (
                format!("{}::{}", topic.stem, claim.id),
                topic.stem,
                claim.id,
            )
        })
        .collect();
    let whole = WHOLE.iter().any(|(name, _)| asked(name));
    let some = claims.iter().filter(|(name, ..)| asked(name));
    let some: Vec<_> = some.map(|(_, _, id)| *id).collect();
    let ledger = Arc::new(match whole {
        true => Ledger::try_all(&PAPER, |_| {}),
        false => Ledger::try_some(&PAPER, &some, |_| {}),
    });
    let mut trials: Vec<_> = claims
        .into_iter()
        .map(|(name, topic, id)| {
            let ledger = Arc::clone(&ledger);
            Trial::test(name, move || {
                let entry = ledger.entry(id).ok_or("it was not tried")?;
                same_as_snapshot(topic, id, &entry.snapshot())
            })
        })
        .collect();
    for (name, test) in WHOLE {
        let ledger = Arc::clone(&ledger);
        trials.push(Trial::test(name, move || test(&ledger)));
    }
    trials.push(Trial::test("dependencies", dependencies));
    trials.push(Trial::test("no_snapshot_without_a_claim", stale));
    let conclusion = libtest_mimic::run(&arguments, trials);
    if whole {
        println!(
            "{} claims tried, in {} comparisons; {}\n",
            ledger.entries.len(),
            ledger.points(),
            ledger.summary()
        );
    }
    conclusion.exit_code()
}

fn verdicts(ledger: &Ledger) -> Result<(), Failed> {
    same_as_snapshot("", "verdicts", &Record::text_of(ledger))
}

/// What is read off a sheet is what the trials say; a sheet that differs is told by its own test.
fn same_as_recorded(ledger: &Ledger) -> Result<(), Failed> {
    let read = Ledger::recorded(&PAPER)?;
    let of = |of: &Ledger| -> Result<BTreeMap<&'static str, Value>, Failed> {
        let errata = of.errata()?;
        let said = |entry: &Entry| {
            let mut row = entry.row();
            row.evidence.clear();
            let mut erratum = errata.iter().find(|e| e.id == entry.claim.id).cloned();
            // There the record has no measured number.
            erratum.iter_mut().for_each(|e| e.evidence.clear());
            let points: usize = entry.evidence.iter().map(|e| e.points).sum();
            let said = json!({ "row": row, "erratum": erratum, "routes": entry.routes(), "points": points });
            (entry.claim.id, said)
        };
        Ok(of.entries.iter().map(said).collect())
    };
    let (recorded, tried) = (of(&read)?, of(ledger)?);
    let sheets: BTreeMap<_, _> = PAPER.sheets.texts(".snap").into_iter().collect();
    let same_sheet = |entry: &&Entry| {
        let sheet = sheets.get(&format!("{}/{}.snap", entry.topic.stem, entry.claim.id));
        sheet.is_none_or(|sheet| sheet.trim_end().ends_with(entry.snapshot().trim_end()))
    };
    let same: Vec<_> = ledger.entries.iter().filter(same_sheet).collect();
    if same.is_empty() {
        return Err("no sheet is as it is recorded".into());
    }
    let mut others = Vec::new();
    for entry in same {
        let id = entry.claim.id;
        let [recorded, tried] = [&recorded[id], &tried[id]].map(|said| {
            let (row, erratum) = (said["row"].as_object(), said["erratum"].as_object());
            let fields = row
                .into_iter()
                .chain(erratum)
                .chain(said.as_object())
                .flatten();
            fields.filter(|(name, _)| !["row", "erratum"].contains(&name.as_str()))
        });
        let differs = recorded.zip(tried).filter(|(a, b)| a != b);
        others.extend(
            differs.map(|((name, a), (_, b))| {
                format!("{id}: `{name}` is read as {a}, and tried as {b}")
            }),
        );
    }
    none(&others, "mend `Ledger::recorded`")
}

fn dependencies() -> Result<(), Failed> {
    let line = |(_, c): (_, &Claim)| format!("{}: {}\n", c.id, c.depends_on.join(" "));
    same_as_snapshot(
        "",
        "dependencies",
        &PAPER.claims().map(line).collect::<String>(),
    )
}

/// What a trial finds without the paper, and its units, stay where they are when a formula is wrong.
fn leaning(ledger: &Ledger) -> Result<(), Failed> {
    let leans = ledger.leaning().into_iter().map(|(key, trial, formula)| {
        format!("{key}, {trial}: what it finds, or its scale, moves with a mistake in {formula}")
    });
    none(
        &leans.collect::<Vec<_>>(),
        "find it without the formula, by the motion",
    )
}

fn none(found: &[String], mend: &str) -> Result<(), Failed> {
    match found.is_empty() {
        true => Ok(()),
        false => Err(format!("{}\nWhat to do: {mend}.", found.join("\n")).into()),
    }
}

fn sentences(ledger: &Ledger) -> Result<(), Failed> {
    let bad = |text: &String| {
        let formulas = text.matches('$').count().is_multiple_of(2);
        let tidy = !["  ", " ,", " .", "..", ",,", "$$"]
            .iter()
            .any(|slip| text.contains(slip));
        !(formulas && tidy && text.ends_with('.') && !text.starts_with(char::is_lowercase))
    };
    let mut offences = Vec::new();
    for entry in as_recorded(ledger) {
        let id = entry.claim.id;
        let in_short = entry.in_short();
        if entry.judgement.verdict.asks_for_change() != in_short.is_some() {
            let verdict = entry.judgement.verdict.words();
            offences.push(format!(
                "{id} is {verdict}, and says of what is wrong: {}",
                in_short.as_deref().unwrap_or("nothing")
            ));
        }
        let strange = entry
            .evidence
            .iter()
            .filter_map(|e| names_another(entry, e));
        offences.extend(strange);
        let said = entry
            .evidence
            .iter()
            .flat_map(|e| [e.comparison(), e.result(), e.measured()]);
        let slips = said.chain(in_short).filter(bad);
        offences.extend(slips.map(|text| format!("{id}: {text}")));
        offences.extend(
            entry
                .evidence
                .iter()
                .filter(|e| !shows(e))
                .map(|e| format!("{id}: {}, {} of {}", e.trial, e.failed, e.points)),
        );
    }
    none(
        &offences,
        "mend the words in the trial's `Compared` or in the claim's entry: whole sentences that name only what the trial reads",
    )
}

fn rests_on(claim: &Claim, id: &str) -> bool {
    let below = |on: &&str| **on == *id || rests_on(PAPER.find(on).expect("a claim").1, id);
    claim.depends_on.iter().any(below)
}

/// Though the trial has not read them and the claim neither is nor rests on them.
fn names_another(entry: &Entry, e: &Evidence) -> Option<String> {
    let words = e.compared.words();
    let claim = entry.claim;
    let known = |number: u16| {
        let (formula, id) = (format!("::eq{number}_"), format!("eq-{number}"));
        claim.equation == Some(number)
            || e.read.iter().any(|path| path.contains(&formula))
            || rests_on(claim, &id)
            // Section 3 takes over what section 2.1 has solved.
            || matches!((claim.id, number), ("eq-81" | "eq-82", 13 | 14))
            || claim.plain.contains(&format!("({number})"))
    };
    let numbers = words.split('(').skip(1).filter_map(|rest| {
        let (number, _) = rest.split_once(')')?;
        number.parse().ok()
    });
    let strange: Vec<u16> = numbers.filter(|number| !known(*number)).collect();
    let named = (claim.id, e.trial, &strange);
    (!strange.is_empty()).then(|| format!("{named:?} is named and was not read"))
}

fn shows(e: &Evidence) -> bool {
    let apart = |s: &Sample| s.stated != s.found;
    let shown = || (1..=e.failed).contains(&e.samples.len()) && e.samples.iter().all(apart);
    match e.outcome() {
        _ if e.farthest.is_none() => e.failed == 0,
        Outcome::Disagrees => (1..=e.points).contains(&e.failed) && shown(),
        _ => e.failed == 0,
    }
}

/// Roots and runs of their own, which the trials neither read nor show.
const VALUES_BY_HAND: &[(&str, &str)] = &[
    ("fig-3-largest", "fig-3"),
    ("fig-4-largest", "fig-4"),
    ("slip-end", "eq-82"),
    ("kappa-solid", "eq-67"),
    ("turn", "eq-136"),
    ("critical-radius", "s4-rest-radius"),
    ("critical-speed", "s4-rest-radius"),
    ("boundary", "s4-envelope-is-boundary"),
    ("fig-3-friction", "fig-3"),
    ("fig-4-friction", "fig-4"),
    ("critical-phase", "eq-37"),
    ("fig-4-slip-end", "eq-32"),
    ("slip-end-0.6", "eq-32"),
    ("slip-end-0.9", "eq-32"),
    ("curve-a-6", "eq-53"),
    ("curve-a-12", "eq-53"),
];

fn values(ledger: &Ledger) -> Result<(), Failed> {
    let mut strange = Vec::new();
    for value in PAPER.values() {
        let (_, read) = of(|| (value.number(), value.decimal(3)));
        let entry = ledger.entries.iter().find(|e| e.claim.id == value.claim);
        let evidence = || entry.into_iter().flat_map(|entry| &entry.evidence);
        let formulas = |e: &Evidence| !e.read.is_disjoint(&read.formulas);
        let runs = |e: &Evidence| !e.runs.is_disjoint(&read.runs);
        let number = value.number()?;
        let close = |x: f64| (x / number - 1.0).abs() < 1e-9;
        let pair = |s: &Sample| close(s.stated) || close(s.found);
        let shows = |e: &Evidence| e.samples.iter().chain(&e.farthest).any(pair);
        if !evidence().any(|e| formulas(e) || runs(e) || shows(e)) {
            strange.push((value.id, value.claim));
        }
    }
    let said = |(id, claim)| format!("{id} of {claim}");
    excused(
        strange.into_iter().map(said),
        VALUES_BY_HAND.iter().copied().map(said),
        "compute the value from a formula or runs that a trial of its claim reads, or name it in `VALUES_BY_HAND`",
    )
}

fn term(latex: &str, at: &BTreeMap<&str, f64>) -> Option<f64> {
    match latex {
        "0" => Some(0.0),
        "1" => Some(1.0),
        r"\frac12" => Some(0.5),
        r"\pi" => Some(PI),
        _ => {
            let mut of_this = SYMBOLS.iter().filter(|symbol| symbol.latex == latex);
            of_this.find_map(|symbol| at.get(symbol.plain).copied())
        }
    }
}

/// Whether what a condition begins with holds, or by how little it does not: `a<b<c`, `a>b` or `a\neq b,c`; nothing if it
/// is in words, or about something else.
fn holds(text: &str, at: &BTreeMap<&str, f64>, nearly: f64) -> Option<bool> {
    let (relation, _) = text.strip_prefix('$')?.split_once('$')?;
    if let Some((left, right)) = relation.split_once(r"\neq") {
        let left = term(left, at)?;
        let others: Option<Vec<_>> = right.split(',').map(|right| term(right, at)).collect();
        // The points are written to six decimals.
        return Some(others?.iter().all(|right| (left - right).abs() > 1e-6));
    }
    if let Some((left, right)) = relation.split_once('>') {
        return Some(term(left, at)? > term(right, at)? - nearly);
    }
    let terms: Option<Vec<_>> = relation.split('<').map(|one| term(one, at)).collect();
    let terms = terms?;
    (terms.len() > 1).then(|| terms.windows(2).all(|pair| pair[0] < pair[1] + nearly))
}

/// Excepted points are those at which the condition does not hold as printed, tried ones those at which it does: a trial has its
/// points from elsewhere than the words.
fn conditions(ledger: &Ledger) -> Result<(), Failed> {
    let mut strange = Vec::new();
    let everywhere: BTreeMap<_, _> = SYMBOLS.iter().map(|symbol| (symbol.plain, 0.5)).collect();
    for entry in &ledger.entries {
        for condition in entry.claim.conditions {
            let at = |s: &Sample, nearly| {
                let named = s.at.split(", ").filter_map(|part| part.split_once(" = "));
                let at = named.filter_map(|(name, x)| Some((name, x.parse().ok()?)));
                let mut at: BTreeMap<&str, f64> = at.collect();
                let velocity = at.get("v_x").zip(at.get("v_y"));
                let speed = velocity.map(|(x, y)| ("p", x.hypot(*y)));
                at.extend(speed);
                holds(condition.text, &at, nearly)
            };
            let of = |subjects: &'static [Subject]| {
                let evidence = entry.evidence.iter();
                evidence.filter(|e| subjects.contains(&e.subject))
            };
            let named = |what| format!("{}, {what}: {}", entry.claim.id, condition.text);
            if condition.sort == Sort::Stated {
                let tried = of(&[Subject::Printed, Subject::Within]);
                let mut samples = tried.flat_map(|e| e.samples.iter().chain(&e.farthest));
                // The points are written to six decimals.
                if samples.any(|s| at(s, 1e-6) == Some(false)) {
                    strange.push(named("tried where this does not hold"));
                }
            }
            if !condition.sort.is_degenerate() {
                continue;
            }
            let told = of(&[Subject::Excepted]).filter_map(|e| {
                let same = e
                    .samples
                    .iter()
                    .map(|s| Some(at(s, 0.0)? == (s.stated == 1.0)));
                let same: Option<Vec<_>> = same.collect();
                same.map(|same| same.iter().all(|same| *same))
            });
            let told: Vec<_> = told.collect();
            // By convention there is friction, and nothing else.
            let friction = [r"$\lambda_0>0$: ", r"$\mu>0$: "];
            let foreign = condition.sort == Sort::Convention
                && !friction.iter().any(|some| condition.text.starts_with(some));
            let readable = holds(condition.text, &everywhere, 0.0).is_some();
            if foreign || !told.contains(&true) && (readable || !told.is_empty()) {
                strange.push(named("other points are excepted than this says"));
            }
        }
    }
    none(
        &strange,
        "mend the condition in the claim's entry, or the points of the trial",
    )
}

fn reading(ledger: &Ledger) -> Result<(), Failed> {
    let those = |wanted: fn(&Entry, &Attempt, &Evidence) -> bool| {
        ledger.entries.iter().flat_map(move |entry| {
            let trials = entry.claim.trials.iter().zip(entry.keyed());
            trials
                .filter(move |(trial, (_, e))| wanted(entry, trial, e))
                .map(|(_, (key, _))| key.to_string())
        })
    };
    excused(
        those(|entry, _, e| PAPER.formulas.is_missing(entry.claim, e)),
        those(|_, trial, _| trial.elsewhere.is_some()),
        "read a formula of the claim in the trial, or say why it reads none (`elsewhere`)",
    )
}

/// A claim whose verdict is another one is told by its own test; one that is new has no other.
fn as_recorded(ledger: &Ledger) -> Vec<&Entry> {
    let record = Record::parse(&PAPER.record).expect("the record can be read");
    let changed = record.differences(ledger);
    let told = |d: &Difference| d.recorded.is_some();
    let same = |entry: &&Entry| !changed.iter().any(|d| told(d) && d.id == entry.claim.id);
    ledger.entries.iter().filter(same).collect()
}

/// Claim and name, statement, whether it speaks of the formula, and the formula's wrong variants.
type Read<'a> = (
    (&'static str, &'static str),
    &'static dyn Proved,
    bool,
    Vec<&'a Variant>,
);

/// For every one of its claim's formulas that it reads, alone where it speaks of them; of any other that it reads for one at
/// least. Else a reason is given.
fn wrong_proofs(ledger: &Ledger) -> Result<(), Failed> {
    let variants = PAPER.formulas.variants();
    let as_recorded = as_recorded(ledger);
    let agreeing = as_recorded.iter().flat_map(|entry| {
        let trials = entry.claim.trials.iter().zip(&entry.evidence);
        let agree = trials.filter(|(_, e)| e.outcome() == Outcome::Agrees);
        agree.filter_map(|(trial, e)| Some((entry.claim.id, trial, trial.statement()?, &e.read)))
    });
    let mut proofs = Vec::new();
    for (claim, trial, statement, read) in agreeing {
        let spoken = statement.speaks_of();
        for formula in read {
            let own = |v: &&Variant| v.seed.formula == *formula;
            let wrong: Vec<_> = variants.iter().filter(own).collect();
            proofs.push((
                (claim, trial.name()),
                statement,
                spoken.contains(formula),
                wrong,
            ));
        }
    }
    let passes = |(proof, statement, spoken, wrong): &Read<'_>| {
        let holds = |v: &&Variant| with(v.seed, || statement.proof().holds());
        let alone = |v: &&Variant| statement.with_mistake(v.seed).holds();
        let formula = wrong.first()?;
        let own = formula.claim == proof.0;
        let passes = own && wrong.iter().any(holds)
            || *spoken && wrong.iter().any(alone)
            || !own && wrong.iter().all(holds);
        passes.then_some((*proof, formula.formula))
    };
    let threads = thread::available_parallelism()?.get();
    let spared: BTreeSet<_> = thread::scope(|scope| {
        let part = |k| {
            let own = proofs.iter().skip(k).step_by(threads);
            scope.spawn(move || own.filter_map(passes).collect::<Vec<_>>())
        };
        let parts: Vec<_> = (0..threads).map(part).collect();
        let all = parts.into_iter().map(|part| part.join().expect("no panic"));
        all.flatten().collect()
    });
    let given = as_recorded.iter().flat_map(|entry| {
        let attempts = entry.claim.trials.iter();
        attempts.flat_map(move |attempt| {
            let proof = (entry.claim.id, attempt.name());
            attempt.spared.iter().map(move |spared| (proof, spared.of))
        })
    });
    let said = |((claim, proof), formula)| format!("{claim}, {proof}: a mistake in {formula}");
    excused(
        spared.into_iter().map(said),
        given.map(said),
        "have the proof fail for it, or say what of the formula does not enter (`spared`) where the entry names the proof",
    )?;
    let exact = |e: &&Evidence| e.route == Route::Exact && e.outcome() == Outcome::Agrees;
    let evidence = as_recorded.iter().flat_map(|entry| &entry.evidence);
    let read: usize = evidence.filter(exact).map(|e| e.read.len()).sum();
    all_asked(proofs.len(), read, "formulas that proofs read")
}

fn excused(
    found: impl Iterator<Item = String>,
    given: impl Iterator<Item = String>,
    mend: &str,
) -> Result<(), Failed> {
    let [found, given] = [found.collect(), given.collect::<BTreeSet<_>>()];
    let without = found.difference(&given);
    let without = without.map(|what| format!("{what}, without a reason"));
    let idle = given.difference(&found);
    let idle = idle.map(|what| format!("{what}, a reason for nothing"));
    none(&without.chain(idle).collect::<Vec<_>>(), mend)
}

fn all_asked(asked: usize, there: usize, what: &str) -> Result<(), Failed> {
    match asked == there && there > 0 {
        true => Ok(()),
        false => Err(format!("{asked} {what} are asked, there are {there}").into()),
    }
}

fn wrong_variants(ledger: &Ledger) -> Result<(), Failed> {
    let variants = PAPER.formulas.variants();
    let rejected = ledger.rejected(&variants);
    let entries = as_recorded(ledger);
    let told = |id: &str| entries.iter().any(|entry| entry.claim.id == id);
    let survivors = variants.iter().zip(&rejected).filter(|(_, yes)| !**yes);
    let survivors = survivors.filter(|(v, _)| told(&v.claim));
    let claims = PAPER.claims().filter(|(_, claim)| told(claim.id));
    let given = claims.flat_map(|(_, claim)| claim.survivors.iter().map(|s| (claim.id, s.of)));
    excused(
        survivors.map(|(v, _)| format!("{}: {}", v.claim, v.text)),
        given.map(|(id, text)| format!("{id}: {text}")),
        "add a trial that tells it from the formula, or say in the claim's entry why none can (`survivors`)",
    )?;
    let there = ledger.entries.iter().map(|entry| entry.tally().tried).sum();
    all_asked(variants.len(), there, "wrong variants")
}

fn reasons(ledger: &Ledger) -> Result<(), Failed> {
    let theorems = PAPER.known_theorems();
    let wrong = as_recorded(ledger).into_iter().filter_map(|entry| {
        let id = entry.claim.id;
        let theorem = theorem_of(id);
        let agrees = |e: &Evidence| e.route == Route::Exact && e.outcome() == Outcome::Agrees;
        let why = match (entry.standing(), entry.claim.unproved) {
            (Some(Standing::Proved | Standing::Defined), Some(_)) => {
                "misses nothing: leave out `unproved`".to_owned()
            }
            (None | Some(Standing::Measured), None) => match theorems.sources.proved(&theorem) {
                Some(item) if theorems.record.iter().any(|accepted| accepted.name == theorem) => format!(
                    "has the theorem `{theorem}`, but rocq/{} or the formulas in it are no longer what the kernel accepted: mend it, and `make -C rocq`",
                    item.file
                ),
                _ if entry.evidence.iter().any(agrees) => format!(
                    "has a proof, but no theorem says the whole of it: write `{theorem}` in rocq, or say why the proof is enough (`argument`), or what it leaves open (`unproved`)"
                ),
                _ => "has no proof: say what is missing (`unproved`)".to_owned(),
            },
            _ => return None,
        };
        Some(format!("{id} {why}"))
    });
    none(
        &wrong.collect::<Vec<_>>(),
        "mend the claim's entry, or what it names",
    )
}

fn shown(ledger: &Ledger) -> Result<(), Failed> {
    let idle = as_recorded(ledger).into_iter().flat_map(|entry| {
        let (claim, verdict) = (entry.claim, entry.judgement.verdict);
        let corrected =
            claim.correction.is_some() && !verdict.is_wrong() && !verdict.has_condition();
        let by_hand = claim.by_hand.is_some() && !verdict.is_wrong();
        let fields = [(corrected, "corrected"), (by_hand, "by-hand")];
        let idle = fields.into_iter().filter(|(idle, _)| *idle);
        idle.map(move |(_, field)| {
            format!("{}: `{field}`, of what is {}", claim.id, verdict.words())
        })
    });
    none(&idle.collect::<Vec<_>>(), "leave out what is not shown")
}

fn stale() -> Result<(), Failed> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    for topic in PAPER.topics {
        for file in fs::read_dir(root.join(topic.stem))? {
            let name = file?.file_name().to_string_lossy().into_owned();
            let name = name.trim_end_matches(".new");
            let of_a_claim = |claim: &Claim| name == format!("{}.snap", claim.id);
            if !topic.claims().iter().any(of_a_claim) && !name.starts_with("portrait.snap") {
                let path = format!("snapshots/{}/{name}", topic.stem);
                return Err(format!("{path} belongs to no claim: delete it").into());
            }
        }
    }
    Ok(())
}

fn same_as_snapshot(folder: &str, name: &str, text: &str) -> Result<(), Failed> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(root.join("snapshots").join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let same = || settings.bind(|| assert_snapshot!(name, text));
    // The difference is printed by then.
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    let compared = catch_unwind(AssertUnwindSafe(same));
    set_hook(hook);
    compared.map_err(|_| {
        format!(
            "{name} differs from its snapshot: accept what is right, by `cargo insta review`, or by INSTA_UPDATE=always before the command"
        )
        .into()
    })
}
