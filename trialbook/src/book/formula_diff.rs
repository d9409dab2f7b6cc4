//! What differs between two formulas, marked in both.

/// Marks what follows it in braces; [`Maths`](super::maths::Maths) knows it.
pub(super) const MARK: &str = r"\changed";

#[derive(Debug, Clone, PartialEq)]
enum Part<'a> {
    /// A character, a command, what stands between `\left` and its `\right`.
    Whole(&'a str),
    /// Such as `\frac`; without a name, what stands in braces.
    Command(&'a str, Vec<Vec<Part<'a>>>),
    Scripted(Box<Part<'a>>, Vec<(&'a str, Vec<Part<'a>>)>),
}

/// Commands with so many arguments.
const ARGUMENTS: [(&str, usize); 11] = [
    (r"\frac", 2),
    (r"\tfrac", 2),
    (r"\dfrac", 2),
    (r"\sqrt", 1),
    (r"\mathbf", 1),
    (r"\mathrm", 1),
    (r"\mathfrak", 1),
    (r"\hat", 1),
    (r"\dot", 1),
    (r"\operatorname", 1),
    (r"\overline", 1),
];

/// Where they have nothing in common, nothing is marked.
pub(super) fn marked(old: &str, new: &str) -> [String; 2] {
    let read = |text| Reader { text, at: 0 }.parts();
    let (a, b) = (read(old), read(new));
    let alike = !common(&a, &b).is_empty();
    if alike {
        return compare(&a, &b);
    }
    opened(&a, &b).unwrap_or_else(|| [old, new].map(str::to_owned))
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn parts(&mut self) -> Vec<Part<'a>> {
        let mut found = Vec::new();
        while let Some(sign) = self.sign() {
            match sign {
                "}" => break,
                "_" | "^" => {
                    let script = (sign, self.argument());
                    let (base, mut scripts) = match found.pop() {
                        Some(Part::Scripted(base, scripts)) => (base, scripts),
                        base => (Box::new(base.unwrap_or(Part::Whole(""))), Vec::new()),
                    };
                    scripts.push(script);
                    found.push(Part::Scripted(base, scripts));
                }
                sign => {
                    let part = self.part(sign);
                    found.push(part);
                }
            }
        }
        found
    }

    fn sign(&mut self) -> Option<&'a str> {
        let rest = self.text[self.at..].trim_start();
        let start = self.text.len() - rest.len();
        let name = rest.strip_prefix('\\').map(|name| {
            let end = name.find(|c: char| !c.is_ascii_alphabetic());
            end.unwrap_or(name.len())
        });
        let first = |text: &str| text.chars().next().map(char::len_utf8);
        let length = match name {
            None => first(rest)?,
            Some(0) => 1 + first(&rest[1..]).unwrap_or(0),
            Some(letters) => 1 + letters,
        };
        self.at = start + length;
        Some(&rest[..length])
    }

    fn part(&mut self, sign: &'a str) -> Part<'a> {
        let start = self.at - sign.len();
        let arguments = ARGUMENTS.iter().find(|(name, _)| *name == sign);
        match (sign, arguments) {
            ("{", _) => Part::Command("", vec![self.parts()]),
            (_, Some((_, count))) => {
                let arguments = (0..*count).map(|_| self.argument());
                Part::Command(sign, arguments.collect())
            }
            (r"\left" | r"\begin", _) => {
                let mut depth = 1;
                while depth > 0
                    && let Some(sign) = self.sign()
                {
                    match sign {
                        r"\left" | r"\begin" => depth += 1,
                        r"\right" | r"\end" => depth -= 1,
                        _ => {}
                    }
                }
                // A delimiter, or the name of what ends.
                self.argument();
                Part::Whole(&self.text[start..self.at])
            }
            // Blanks matter in words, and a size belongs to the bracket behind it.
            _ if [r"\text", r"\mbox", r"\big", r"\Big"]
                .iter()
                .any(|name| sign.starts_with(name)) =>
            {
                self.argument();
                Part::Whole(&self.text[start..self.at])
            }
            _ => Part::Whole(sign),
        }
    }

    fn argument(&mut self) -> Vec<Part<'a>> {
        match self.sign() {
            Some("{") => self.parts(),
            Some(sign) => vec![self.part(sign)],
            None => Vec::new(),
        }
    }
}

/// The longest in this order, by their places.
fn common(a: &[Part<'_>], b: &[Part<'_>]) -> Vec<(usize, usize)> {
    let mut longest = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            longest[i][j] = match a[i] == b[j] {
                true => longest[i + 1][j + 1] + 1,
                false => longest[i + 1][j].max(longest[i][j + 1]),
            };
        }
    }
    let (mut i, mut j, mut pairs) = (0, 0, Vec::new());
    while i < a.len() && j < b.len() {
        if a[i] == b[j] {
            pairs.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if longest[i + 1][j] >= longest[i][j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs
}

fn compare(a: &[Part<'_>], b: &[Part<'_>]) -> [String; 2] {
    let mut out = [String::new(), String::new()];
    let (mut i, mut j) = (0, 0);
    for (next, other) in common(a, b).into_iter().chain([(a.len(), b.len())]) {
        let (one, two) = (&a[i..next], &b[j..other]);
        let texts = opened(one, two).unwrap_or_else(|| [mark(one), mark(two)]);
        for (text, more) in out.iter_mut().zip(texts) {
            *text += &more;
        }
        for (text, same) in out.iter_mut().zip([a.get(next), b.get(other)]) {
            *text += &same.map_or(String::new(), latex);
        }
        (i, j) = (next + 1, other + 1);
    }
    out
}

fn opened(one: &[Part<'_>], two: &[Part<'_>]) -> Option<[String; 2]> {
    let ([one], [two]) = (one, two) else {
        return None;
    };
    let inside = |a: &[Part<'_>], b: &[Part<'_>]| compare(a, b).map(|text| format!("{{{text}}}"));
    let mut out = [String::new(), String::new()];
    let mut push = |texts: [String; 2]| {
        for (out, text) in out.iter_mut().zip(texts) {
            *out += &text;
        }
    };
    match (one, two) {
        (Part::Command(a, of_a), Part::Command(b, of_b)) if a == b => {
            push([a, b].map(|name| (*name).to_owned()));
            for (a, b) in of_a.iter().zip(of_b) {
                push(inside(a, b));
            }
        }
        (Part::Scripted(a, of_a), Part::Scripted(b, of_b))
            if of_a.iter().map(|s| s.0).eq(of_b.iter().map(|s| s.0)) =>
        {
            push(inside(&[(**a).clone()], &[(**b).clone()]));
            for ((sign, a), (_, b)) in of_a.iter().zip(of_b) {
                push([(); 2].map(|()| (*sign).to_owned()));
                push(inside(a, b));
            }
        }
        _ => return None,
    }
    Some(out)
}

fn mark(parts: &[Part<'_>]) -> String {
    let text: String = parts.iter().map(latex).collect();
    match parts {
        [] => text,
        [Part::Whole("+" | "-" | r"\pm" | r"\mp")] => format!("\\mathbin{{{MARK}{{{text}}}}}"),
        [Part::Whole("=" | "<" | ">" | r"\le" | r"\ge" | r"\ne")] => {
            format!("\\mathrel{{{MARK}{{{text}}}}}")
        }
        _ => format!("{MARK}{{{text}}}"),
    }
}

fn latex(part: &Part<'_>) -> String {
    let all = |parts: &[Part<'_>]| parts.iter().map(latex).collect::<String>();
    match part {
        Part::Whole(text) if text.starts_with('\\') => format!("{text} "),
        Part::Whole(text) => (*text).to_owned(),
        Part::Command(name, arguments) => {
            let arguments = arguments.iter().map(|parts| format!("{{{}}}", all(parts)));
            format!("{name}{}", arguments.collect::<String>())
        }
        Part::Scripted(base, scripts) => {
            let scripts = scripts.iter();
            let scripts = scripts.map(|(sign, parts)| format!("{sign}{{{}}}", all(parts)));
            format!("{}{}", latex(base), scripts.collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::marked;

    #[test]
    fn what_is_changed_is_marked() {
        for (old, new, old_marked, new_marked) in [
            (
                r"a+b",
                r"a-b",
                r"a\mathbin{\changed{+}}b",
                r"a\mathbin{\changed{-}}b",
            ),
            (
                r"p\sim\frac29\tau^2",
                r"p\sim\frac{\tau^2}{3\sqrt2}",
                r"p\sim \changed{\frac{2}{9}\tau ^{2}}",
                r"p\sim \changed{\frac{\tau ^{2}}{3\sqrt{2}}}",
            ),
            (
                r"x_1^2",
                r"x_2^2",
                r"{x}_{\changed{1}}^{2}",
                r"{x}_{\changed{2}}^{2}",
            ),
            (r"a=b", r"a=b+c", "a=b", r"a=b\changed{+c}"),
            (r"\text{if }a", r"b", r"\text{if }a", "b"),
            (
                r"\left(a\right)b",
                r"\left(c\right)b",
                r"\changed{\left(a\right) }b",
                r"\changed{\left(c\right) }b",
            ),
        ] {
            assert_eq!(marked(old, new), [old_marked, new_marked], "{old} {new}");
        }
    }
}
