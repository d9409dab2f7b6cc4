//! What our motion costs on each task of the exam: the fastest of many runs, as JSON for `benches/exam/results/ours.json`.

use slipbook::exam::TASKS;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut lines = Vec::new();
    for task in &TASKS {
        let mut fastest = f64::INFINITY;
        for _ in 0..20 {
            let begin = Instant::now();
            std::hint::black_box(task.by_motion()?);
            fastest = fastest.min(begin.elapsed().as_secs_f64());
        }
        lines.push(format!("  \"{}\": {fastest:.3e}", task.id));
    }
    println!("{{\n{}\n}}", lines.join(",\n"));
    Ok(())
}
