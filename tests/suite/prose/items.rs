//! How long a list is that a page goes on to give: "three forces: friction, …", "three things:" above a list.

/// What is counted.
#[derive(Debug, Clone, Copy)]
pub enum List {
    /// What the sentence names.
    Items,
    /// The entries of the list below the paragraph.
    Entries,
    /// The paragraphs of the section that begin in bold.
    Leads,
    /// The claims' boxes of the section that this is the heading of, or right below the paragraph.
    Boxes,
    /// The headings of the same section that have the word behind the count.
    Headings(&'static str),
    /// The sections of the page from here on.
    Sections,
}

/// Words with which a part of a sentence begins that says more of what was just named.
const SAYS_MORE: [&str; 6] = ["also", "directed", "of", "per", "which", "§"];

impl List {
    /// How many there are behind this place of a page.
    pub fn length(self, page: &str, at: usize) -> usize {
        let below = &page[at..];
        let section = below.split("\n#").next().unwrap_or_default();
        let is_box = |line: &&str| line.starts_with("{{claim ");
        match self {
            List::Items => items(below.split("\n\n").next().unwrap_or_default()),
            List::Entries => {
                let lines = section.lines().skip_while(|line| !is_entry(line));
                let list = lines
                    .take_while(|line| is_entry(line) || line.starts_with("  ") || line.is_empty());
                list.filter(|line| is_entry(line)).count()
            }
            List::Leads => section.matches("\n\n**").count(),
            List::Boxes => {
                let line = page[..at].rsplit('\n').next().unwrap_or_default();
                if line.starts_with('#') {
                    return section.lines().filter(is_box).count();
                }
                let lines = below.lines().skip_while(|line| !is_box(line));
                lines.take_while(is_box).count()
            }
            List::Headings(noun) => {
                let section = below.split("\n## ").next().unwrap_or_default();
                let heads = section.lines().filter(|line| line.starts_with("### "));
                heads.filter(|line| line.contains(noun)).count()
            }
            List::Sections => below.matches("\n## ").count(),
        }
    }
}

/// What a sentence names behind its colon, or behind a comma where it has no colon.
fn items(paragraph: &str) -> usize {
    let parts = paragraph.split('$').enumerate();
    let text: String = parts
        .map(|(i, part)| if i % 2 == 1 { "§" } else { part })
        .collect();
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
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

fn is_entry(line: &str) -> bool {
    let numbered = line.trim_start_matches(|c: char| c.is_ascii_digit());
    line.starts_with("- ") || (numbered.len() < line.len() && numbered.starts_with(". "))
}

#[test]
fn lists_are_counted() {
    let page = "# A\n\nThe ant feels three: friction, of size $1$, the pull\nand a push. No more.\n\n\
                Two things matter.\n\n- **a.** b\n  c\n- d\n\nText.\n\n### Two ways to fall\n\n**One.** x\n\n**Other.** y\n\n\
                ## Two laws\n\n{{claim a}}\n\nx\n\n{{claim b}}\n\n## Sums\n\nThe three sums are\n\n{{claim c}}\n{{claim d}}\n{{claim e}}\n\n\
                It has two stages.\n\n### The first stage\n\n### Then\n\n### The last stage\n\n## End\n";
    for (list, words, expected) in [
        (List::Items, "feels three", 3),
        (List::Entries, "Two things", 2),
        (List::Leads, "Two ways", 2),
        (List::Boxes, "Two laws", 2),
        (List::Boxes, "The three sums", 3),
        (List::Headings("stage"), "has two stages", 2),
        (List::Sections, "Two things", 3),
    ] {
        assert_eq!(
            list.length(page, page.find(words).unwrap()),
            expected,
            "{words}"
        );
    }
}
