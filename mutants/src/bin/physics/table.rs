//! The result as a table.

use crate::list::Mistake;
use crate::run::Found;

/// How many claims and trials are named.
const NAMED: usize = 3;

/// A line for each mistake: its name, what is wrong, in which file, how many verdicts change, the first of their claims and
/// of the trials that notice.
pub fn csv(found: &[(&Mistake, Found)]) -> String {
    let mut out = "mistake,physics,file,verdicts,claims,trials\n".to_owned();
    for (mistake, found) in found {
        let (count, claims, trials) = match found {
            Found::Changed { claims, trials, .. } => (claims.len(), first(claims), first(trials)),
            Found::Fails(why) => (0, why.clone(), String::new()),
        };
        let (name, physics) = (&mistake.name, quoted(&mistake.physics));
        let file = &mistake.changes[0].file;
        out += &format!("{name},{physics},{file},{count},{claims},{trials}\n");
    }
    out
}

fn first(names: &[String]) -> String {
    names[..names.len().min(NAMED)].join(" ")
}

/// A cell of which commas are a part.
fn quoted(text: &str) -> String {
    match text.contains([',', '"']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
