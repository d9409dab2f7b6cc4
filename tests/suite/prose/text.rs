//! Texts, and the formulas in them.

pub fn bare(text: &str) -> String {
    let lines = text
        .split_inclusive('\n')
        .filter(|line| !line.starts_with('<'));
    let mut text: String = lines.collect();
    for (open, close) in [("{{", "}}"), ("`", "`"), ("](", ")"), ("{#", "}")] {
        let mut out = String::new();
        let mut rest = &text[..];
        while let Some((before, after)) = rest.split_once(open)
            && let Some((_, after)) = after.split_once(close)
        {
            out += before;
            out.push(' ');
            rest = after;
        }
        text = out + rest;
    }
    text.replace("$$", "$")
}

pub fn formulas_of(text: &str) -> Vec<String> {
    let formulas = text.split('$').skip(1).step_by(2);
    let flat = |formula: &str| formula.split_whitespace().collect::<Vec<_>>().join(" ");
    formulas.map(flat).collect()
}
