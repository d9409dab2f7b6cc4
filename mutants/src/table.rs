//! The results as tables, and what became of those that were recorded.

use crate::list::Mistake;
use crate::run::{Found, Reaction};
use std::collections::BTreeMap;

const NAMED: usize = 3;

/// Name, what is wrong, how many verdicts change, the first claims and measurements that notice.
pub fn csv(as_of: &str, found: &[(&Mistake, Found)]) -> String {
    let mut out = format!("{as_of}: mistake,physics,verdicts,claims,trials\n");
    for (mistake, found) in found {
        let (count, claims, trials) = match found {
            Found::Changed { claims, trials, .. } => (claims.len(), first(claims, " "), first(trials, "; ")),
            Found::Fails(why) => (0, why.clone(), String::new()),
        };
        let (name, physics) = (&mistake.name, quoted(&mistake.physics));
        out += &format!("{name},{physics},{count},{claims},{trials}\n");
    }
    out
}

fn first(names: &[String], between: &str) -> String {
    names[..names.len().min(NAMED)].join(between)
}

fn quoted(text: &str) -> String {
    match text.contains([',', '"']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// Which it is, to how many mistakes it reacts, how many comparisons disagree then.
pub fn reactions(as_of: &str, all: &[Reaction]) -> String {
    let mut out = format!("{as_of}: claim,route,subject,nth,mistakes,disagree\n");
    for of in all {
        let key = of.key.join(",");
        out += &format!("{key},{},{},{}\n", of.nth, of.mistakes, of.disagree);
    }
    out
}

/// By claim, route and subject: how many measurements react, and how many do not.
type Counts = BTreeMap<[String; 3], [usize; 2]>;

fn counts<'a>(all: impl Iterator<Item = (&'a [String; 3], usize)>) -> Counts {
    let mut counts = Counts::new();
    for (key, mistakes) in all {
        counts.entry(key.clone()).or_default()[usize::from(mistakes == 0)] += 1;
    }
    counts
}

/// No longer reacting, reacting to nothing without an excuse, or excused for nothing.
pub fn complaints(all: &[Reaction], record: &str, excuses: &str) -> Vec<String> {
    let now = counts(all.iter().map(|of| (&of.key, of.mistakes)));
    let recorded: Vec<([String; 3], usize)> = record.lines().skip(1).filter_map(recorded).collect();
    let then = counts(recorded.iter().map(|(key, mistakes)| (key, *mistakes)));
    let mut complaints = Vec::new();
    for (key, [reacted, _]) in then {
        let [reacting, _] = now.get(&key).copied().unwrap_or_default();
        if reacting < reacted {
            let key = key.join(" ");
            complaints.push(format!(
                "{key}: {reacting} react to a mistake, {reacted} did"
            ));
        }
    }
    let mut excused = BTreeMap::<&str, usize>::new();
    let keys = excuses.lines().filter(|line| !line.starts_with('#'));
    for (key, _) in keys.filter_map(|line| line.split_once(": ")) {
        *excused.entry(key).or_default() += 1;
    }
    for ([claim, route, subject], [_, silent]) in now {
        let anywhere = format!("* {route} {subject}");
        if silent == 0 {
            continue;
        }
        if let Some(all) = excused.get_mut(anywhere.as_str()) {
            *all = 0;
            continue;
        }
        let key = format!("{claim} {route} {subject}");
        let excuses = excused.remove(key.as_str()).unwrap_or_default();
        if excuses != silent {
            complaints.push(format!(
                "{key}: {silent} react to no mistake, {excuses} have an excuse"
            ));
        }
    }
    let idle = excused.into_iter().filter(|(_, left)| *left > 0);
    complaints.extend(idle.map(|(key, _)| format!("{key}: the excuse is needed no more")));
    complaints
}

fn recorded(line: &str) -> Option<([String; 3], usize)> {
    let cells: Vec<&str> = line.split(',').collect();
    let [claim, route, subject, _, mistakes, _] = cells[..] else {
        return None;
    };
    let key = [claim, route, subject].map(str::to_owned);
    Some((key, mistakes.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_longer_reacts_is_named_whatever_the_order() {
        let one = |claim: &str, nth, mistakes| Reaction {
            key: [claim, "census", "printed"].map(str::to_owned),
            nth,
            mistakes,
            disagree: 0,
        };
        let record = reactions("# As of", &[one("a", 1, 3), one("a", 2, 0), one("b", 1, 2)]);
        let excuses = "# Why.\na census printed: a set\n";
        let complaints = |all: &[Reaction]| complaints(all, &record, excuses);
        assert!(complaints(&[one("a", 1, 0), one("a", 2, 1), one("b", 1, 9)]).is_empty());
        assert_eq!(
            complaints(&[one("a", 1, 3), one("a", 2, 1), one("b", 1, 0)]),
            [
                "b census printed: 0 react to a mistake, 1 did",
                "b census printed: 1 react to no mistake, 0 have an excuse",
                "a census printed: the excuse is needed no more",
            ]
        );
    }
}
