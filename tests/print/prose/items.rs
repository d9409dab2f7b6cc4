//! Counts of what a page goes on to list, against the list: "three forces: friction, …", "three things:" above a list.

use super::counts::{flat, values};

/// What may be counted, by the name that it has in the list of counts.
pub const LISTS: [&str; 6] = ["items", "list", "leads", "boxes", "headings", "sections"];

/// Words with which a part of a sentence begins that says more of what was just named.
const SAYS_MORE: [&str; 6] = ["also", "directed", "of", "per", "which", "§"];

/// Why the words on a page do not count what they list; nothing where they do.
pub fn miscounted(page: &str, how: &str, words: &str) -> Option<String> {
    let [count] = values(words)[..] else {
        return Some("not one count".to_owned());
    };
    let Some(below) = from(page, words) else {
        return Some("it is not there".to_owned());
    };
    let listed = match how {
        "items" => items(below),
        "list" => list(below),
        "leads" => leads(below),
        "boxes" => boxes(words, below),
        "headings" => headings(words, below),
        "sections" => below.matches("\n## ").count(),
        _ => return Some(format!("nothing counts {how}")),
    };
    // The words stand in one place, or nobody knows which list is meant.
    if from(&below[1..], words).is_some() {
        return Some("it is there twice".to_owned());
    }
    (listed as f64 != count).then(|| format!("it lists {listed}"))
}

/// A page from these words on, which may be torn by the end of a line.
fn from<'a>(page: &'a str, words: &str) -> Option<&'a str> {
    let first = words.split(' ').next().unwrap_or_default();
    let mut starts = page.match_indices(first).map(|(at, _)| &page[at..]);
    let long = |rest: &&str| {
        let there: String = rest.chars().take(20 * words.len()).collect();
        flat(&there).replace('\n', " ").starts_with(words)
    };
    starts.find(long)
}

/// What a sentence names behind its colon, or behind a comma where it has no colon.
fn items(below: &str) -> usize {
    let paragraph = below.split("\n\n").next().unwrap_or_default();
    let text = flat(paragraph).replace('\n', " ");
    let end = [". ", "? ", "; "]
        .iter()
        .filter_map(|end| text.find(end))
        .min();
    let sentence = &text[..end.unwrap_or(text.len())];
    let Some((_, named)) = sentence.split_once(": ").or(sentence.split_once(", ")) else {
        return 0;
    };
    let parts = named.split(", ").flat_map(|part| part.split(" and "));
    let parts = parts.map(|part| part.trim_start_matches("and ").trim());
    let says_more = |part: &&str| SAYS_MORE.contains(&part.split(' ').next().unwrap_or_default());
    parts
        .filter(|part| !part.is_empty() && !says_more(part))
        .count()
}

/// The entries of the list below the paragraph.
fn list(below: &str) -> usize {
    let lines = below.lines().skip_while(|line| !entry(line));
    let lines = lines.take_while(|line| !line.starts_with('#'));
    let list = lines.take_while(|line| entry(line) || line.starts_with("  ") || line.is_empty());
    list.filter(|line| entry(line)).count()
}

fn entry(line: &str) -> bool {
    let numbered = line.trim_start_matches(|c: char| c.is_ascii_digit());
    line.starts_with("- ") || (numbered.len() < line.len() && numbered.starts_with(". "))
}

/// The paragraphs of a section that begin in bold.
fn leads(below: &str) -> usize {
    let section = below.split("\n#").next().unwrap_or_default();
    section.matches("\n\n**").count()
}

/// The claims' boxes of the section that the words are the heading of, or right below the paragraph.
fn boxes(words: &str, below: &str) -> usize {
    let is_box = |line: &&str| line.starts_with("{{claim ");
    if words.starts_with('#') {
        let section = below.split("\n#").next().unwrap_or_default();
        return section.lines().filter(is_box).count();
    }
    let lines = below.lines().skip_while(|line| !is_box(line));
    lines.take_while(is_box).count()
}

/// The headings of the same section that have the word behind the count.
fn headings(words: &str, below: &str) -> usize {
    let noun = words.split(' ').next_back().unwrap_or_default();
    let noun = noun.trim_end_matches(['.', ',', ':']).trim_end_matches('s');
    let section = below.split("\n## ").next().unwrap_or_default();
    let heads = section.lines().filter(|line| line.starts_with("### "));
    heads.filter(|line| line.contains(noun)).count()
}

#[test]
fn a_list_that_is_not_as_long_as_it_says_is_seen() {
    let page = "# A\n\nThe ant feels three: friction, of size $1$, the pull\nand a push. No more.\n\n\
                Two things matter.\n\n- **a.** b\n  c\n- d\n\nText.\n\n### Two ways to fall\n\n**One.** x\n\n**Other.** y\n\n\
                ## Two laws\n\n{{claim a}}\n\nx\n\n{{claim b}}\n\n## Sums\n\nThe three sums are\n\n{{claim c}}\n{{claim d}}\n{{claim e}}\n\n\
                It has two stages.\n\n### The first stage\n\n### Then\n\n### The last stage\n\n## End\n";
    for (how, words) in [
        ("items", "feels three: friction,"),
        ("list", "Two things matter."),
        ("leads", "### Two ways to"),
        ("boxes", "## Two laws"),
        ("boxes", "The three sums"),
        ("headings", "has two stages."),
    ] {
        assert_eq!(miscounted(page, how, words), None, "{words}");
        let (other, wrong) = ["two", "three", "Two"]
            .iter()
            .zip(["three", "two", "Four"])
            .find(|(right, _)| words.contains(**right))
            .unwrap();
        let slip = page.replacen(words, &words.replace(other, wrong), 1);
        let words = words.replace(other, wrong);
        assert!(miscounted(&slip, how, &words).is_some(), "{words}");
    }
}
