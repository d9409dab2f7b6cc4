//! Writes a file with all its changes in it, each behind its switch.
//!
//! Comments mark where each is, so that the compiler's errors can be told apart: `/*<g1,2>*/` … `/*</g>*/` around a
//! place with the changes 1 and 2, `/*<a1>*/` … `/*</a>*/` around what change 1 puts
//! there. A `match` with arms to be taken out has an `m`, a function's body with iterators in it an `i`.

use crate::sites::{Kind, Site};
use std::fmt::Write;
use std::ops::Range;

/// The text with the places in it. They lie within one another or apart.
pub fn instrumented(text: &str, mut sites: Vec<Site>) -> String {
    // The outer one first; of two on the same range a match before a guard before an operator.
    let rank = |s: &Site| match s.kind {
        Kind::Match => 0,
        Kind::Guard | Kind::Field { .. } => 1,
        _ => 2,
    };
    sites.sort_by_key(|s| (s.range.start, usize::MAX - s.range.end, rank(s)));
    // An insertion stands before whatever begins at the same place.
    sites.sort_by_key(|s| (s.range.start, !s.range.is_empty()));
    part(text, 0..text.len(), &sites)
}

fn part(text: &str, range: Range<usize>, sites: &[Site]) -> String {
    let (mut out, mut at, mut i) = (String::new(), range.start, 0);
    while i < sites.len() {
        let site = &sites[i];
        let inner = sites[i + 1..].iter();
        let count = inner
            .take_while(|s| s.range.start < site.range.end && s.range.end <= site.range.end)
            .count();
        let within = &sites[i + 1..i + 1 + count];
        i += 1 + count;
        if site.range.start < at || site.range.end > range.end {
            continue;
        }
        out += &text[at..site.range.start];
        let holes = site.holes.iter().map(|hole| {
            let first = within.partition_point(|s| s.range.start < hole.start);
            let last = within.partition_point(|s| s.range.start < hole.end);
            part(text, hole.clone(), &within[first..last])
        });
        written(&mut out, site, &holes.collect::<Vec<_>>());
        at = site.range.end;
    }
    out + &text[at..range.end]
}

fn written(out: &mut String, site: &Site, holes: &[String]) {
    if let Kind::Text(text) = &site.kind {
        *out += text;
        return;
    }
    let numbers: Vec<_> = site.ids.iter().map(|(id, _)| id.to_string()).collect();
    let letter = match site.kind {
        Kind::Match => "m",
        Kind::Iterator => "i",
        _ => "g",
    };
    let _ = write!(out, "/*<{letter}{}>*/", numbers.join(","));
    inside(out, site, holes);
    let _ = write!(out, "/*</{letter}>*/");
}

/// `if` it is switched on, what it puts there, `else` …
fn branches(out: &mut String, site: &Site, put: impl Fn(&str) -> String) {
    for (id, replacement) in &site.ids {
        let put = put(replacement);
        let _ = write!(
            out,
            "if crate::mutant({id}) {{ /*<a{id}>*/{put}/*</a>*/ }} else "
        );
    }
}

fn inside(out: &mut String, site: &Site, holes: &[String]) {
    let hole = |i: usize| holes.get(i).map_or("", String::as_str);
    match &site.kind {
        Kind::Arithmetic(op) => {
            let _ = write!(
                out,
                "(match (({}), ({})) {{ (__l, __r) => ",
                hole(0),
                hole(1)
            );
            branches(out, site, |other| format!("__l {other} __r"));
            let _ = write!(out, "{{ __l {op} __r }} }})");
        }
        Kind::Comparison(op) => {
            let _ = write!(
                out,
                "(match (&({}), &({})) {{ (__l, __r) => ",
                hole(0),
                hole(1)
            );
            branches(out, site, |other| format!("*__l {other} *__r"));
            let _ = write!(out, "{{ *__l {op} *__r }} }})");
        }
        Kind::Logic { and } => {
            // With `&&` the right side counts where the left is true, with `||` where it is false.
            let (not, id) = (if *and { "" } else { "!" }, site.ids[0].0);
            let _ = write!(
                out,
                "(match {not}crate::mutant({id}) {{ __m => if ({}) == __m {{ __m }} else {{ {} }} }})",
                hole(0),
                hole(1)
            );
        }
        Kind::Assignment(op) => {
            let _ = write!(out, "(match ({}) {{ __r => ", hole(1));
            branches(out, site, |other| format!("{} {other} __r", hole(0)));
            let _ = write!(out, "{{ {} {op} __r }} }})", hole(0));
        }
        Kind::Unary(op) => {
            let _ = write!(out, "(match ({}) {{ __x => ", hole(0));
            branches(out, site, |_| "__x".into());
            let _ = write!(out, "{{ {op}__x }} }})");
        }
        Kind::Body => {
            branches(out, site, |other| format!("return {other};"));
            *out += "{}\n";
        }
        Kind::Iterator => {
            // Every change has a type of its own; the first of n is One, the second Two(One), the body Two(Two(…)).
            let two = |n: usize, what: &str| {
                format!("{}{what}{}", "crate::Either::Two(".repeat(n), ")".repeat(n))
            };
            for (n, (id, replacement)) in site.ids.iter().enumerate() {
                let value = two(n, &format!("crate::Either::One({replacement})"));
                let _ = write!(
                    out,
                    "if crate::mutant({id}) {{ /*<a{id}>*/return {value};/*</a>*/ }}"
                );
            }
            *out += &two(site.ids.len(), &format!("{{ {} }}", hole(0)));
        }
        Kind::Arm => {
            let _ = write!(out, " if !crate::mutant({})", site.ids[0].0);
        }
        Kind::Guard => {
            let mut guard = format!("({})", hole(0));
            for (id, replacement) in &site.ids {
                guard = match replacement.as_str() {
                    "true" => format!("(crate::mutant({id}) || {guard})"),
                    _ => format!("(!crate::mutant({id}) && {guard})"),
                };
            }
            *out += &guard;
        }
        Kind::Field {
            name,
            rest,
            shorthand,
        } => {
            if *shorthand {
                let _ = write!(out, "{name}: ");
            }
            let id = site.ids[0].0;
            let _ = write!(
                out,
                "(if crate::mutant({id}) {{ /*<a{id}>*/({rest}).{name}/*</a>*/ }} else {{ {} }})",
                hole(0)
            );
        }
        Kind::Match => *out += hole(0),
        Kind::Text(text) => *out += text,
    }
}
