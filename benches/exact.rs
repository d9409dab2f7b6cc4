//! Exact proofs: all identities, and those behind (11), (13), (14) from a cold start: `cargo bench --bench exact`.

use slipbook::claims::{
    anisotropic, constant, escape, general, periodic, rest, sinusoidal, sphere, turntable,
};
use slipbook::evidence::{Evidence, Subject};
use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant};

/// How often each of the two is timed.
const TIMES: usize = 100;

/// The identities behind (11), (13) and (14); (12) is the step from (11) to (13).
const FOUR: [&str; 4] = ["eq-11", "eq-12", "eq-13", "eq-14"];

/// In place of an option: prove the four and end.
const COLD: &str = "cold";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    if std::env::args().any(|argument| argument == COLD) {
        return if four() {
            Ok(())
        } else {
            Err("one of the four is not proved".into())
        };
    }
    let begin = Instant::now();
    let first = all();
    let once = begin.elapsed();
    let proved = first.iter().filter(|e| e.worst == 0.0).count();
    println!(
        "all identities, {} of {} proved: {once:.1?} the first time",
        proved,
        first.len()
    );
    report("all identities, again", || {
        black_box(all()).len() == first.len()
    })?;
    report("(11) to (14), in this process", four)?;
    let program = std::env::current_exe()?;
    report("(11) to (14), a process each", || {
        Command::new(&program)
            .arg(COLD)
            .status()
            .is_ok_and(|status| status.success())
    })
}

fn four() -> bool {
    FOUR.iter()
        .all(|id| constant::exact::proof(id).is_some_and(|proof| proof.holds()))
}

/// The evidence of every proof.
fn all() -> Vec<Evidence> {
    let subject = Subject::Printed;
    let mut found = vec![general::law::eq1_exact(), general::law::eq2_exact()];
    found.extend(
        constant::exact::STATEMENTS
            .iter()
            .map(|s| constant::exact::evidence(s.id, subject)),
    );
    found.extend(
        sphere::exact::STATEMENTS
            .iter()
            .map(|s| sphere::exact::evidence(s.id, subject)),
    );
    found.extend(
        turntable::exact::STATEMENTS
            .iter()
            .map(|s| turntable::exact::evidence(s.id, subject, "")),
    );
    found.extend(
        escape::exact::STATEMENTS
            .iter()
            .map(|s| escape::exact::evidence(s.id)),
    );
    found.extend(["eq-139", "eq-146", "eq-147"].map(rest::exact::evidence));
    found.extend(
        ["eq-140", "eq-141", "eq-142", "eq-143", "eq-144", "eq-145"]
            .map(rest::exact::near::evidence),
    );
    use anisotropic::exact as a;
    use periodic::exact as p;
    use sinusoidal::exact as s;
    let others: [fn() -> Evidence; 32] = [
        escape::exact::eq126_evidence,
        escape::exact::eq138_evidence,
        rest::exact::boundary::evidence,
        s::eq25,
        s::eq26,
        s::eq27,
        s::eq28,
        s::eq29,
        s::eq30,
        s::eq31,
        s::eq32,
        s::eq33,
        s::eq34,
        s::eq35,
        s::eq36,
        s::eq37,
        s::eq38,
        s::eq39,
        s::eq40,
        p::eq44,
        p::eq45,
        p::eq46,
        a::eq51,
        a::eq52,
        a::eq53,
        a::eq54,
        a::eq55,
        a::eq56,
        a::e,
        a::x,
        a::y,
        a::mirror,
    ];
    found.extend(others.iter().map(|evidence| evidence()));
    found
}

/// Times a run that says whether it went well.
fn report(name: &str, run: impl Fn() -> bool) -> Result<(), Box<dyn std::error::Error>> {
    let mut fastest = Duration::MAX;
    let begin = Instant::now();
    for _ in 0..TIMES {
        let one = Instant::now();
        if !run() {
            return Err(format!("{name}: something is not proved").into());
        }
        fastest = fastest.min(one.elapsed());
    }
    let mean = begin.elapsed() / TIMES as u32;
    println!("{name}: {mean:.2?} on average, {fastest:.2?} at best");
    Ok(())
}
