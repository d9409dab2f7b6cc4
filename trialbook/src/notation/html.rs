//! HTML and SVG taken apart: tags, each with the text behind it.

/// A tag, and the text up to the next one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tag<'a> {
    /// As it is written; nothing before the first tag.
    pub tag: &'a str,
    /// The name of its element.
    pub name: &'a str,
    /// Whether it ends its element.
    pub closes: bool,
    /// Whether its element ends with it: `<br/>`.
    pub alone: bool,
    /// The text behind it.
    pub text: &'a str,
}

impl<'a> Tag<'a> {
    /// Its attributes, each with its value.
    pub fn attributes(&self) -> impl Iterator<Item = (&'a str, &'a str)> {
        let inside = self.tag.split_once(' ').map_or("", |(_, inside)| inside);
        let mut parts = inside.split('"');
        std::iter::from_fn(move || {
            let name = parts.next()?.trim().strip_suffix('=')?;
            let name = name.rsplit(' ').next()?;
            Some((name, parts.next()?))
        })
    }

    /// The value of an attribute.
    pub fn value(&self, attribute: &str) -> Option<&'a str> {
        let mut attributes = self.attributes();
        Some(attributes.find(|(name, _)| *name == attribute)?.1)
    }
}

/// What a text consists of, in order.
pub fn tags(html: &str) -> impl Iterator<Item = Tag<'_>> {
    let mut rest = html;
    std::iter::from_fn(move || {
        let end = match rest.starts_with('<') {
            true => rest.find('>').map_or(rest.len(), |end| end + 1),
            false if rest.is_empty() => return None,
            false => 0,
        };
        let (tag, behind) = rest.split_at(end);
        let (text, next) = behind.split_at(behind.find('<').unwrap_or(behind.len()));
        rest = next;
        let inside = tag.trim_matches(['<', '>']);
        let closes = inside.starts_with('/');
        Some(Tag {
            tag,
            name: inside
                .trim_matches('/')
                .split([' ', '\n'])
                .next()
                .unwrap_or_default(),
            closes,
            alone: inside.ends_with('/'),
            text,
        })
    })
}

/// The text without its tags.
pub fn without_tags(html: &str) -> String {
    tags(html).map(|tag| tag.text).collect()
}

#[test]
fn a_text_falls_into_tags_and_texts() {
    let html = "a<p class=\"b c\" id=\"d\">e<br/></p>f";
    let all: Vec<_> = tags(html).collect();
    let names = [("", "a"), ("p", "e"), ("br", ""), ("p", "f")];
    assert_eq!(
        all.iter()
            .map(|tag| (tag.name, tag.text))
            .collect::<Vec<_>>(),
        names
    );
    assert_eq!(
        all[1].attributes().collect::<Vec<_>>(),
        [("class", "b c"), ("id", "d")]
    );
    assert!(all[2].alone && !all[2].closes && all[3].closes && all[1].value("x").is_none());
    assert_eq!(
        all.iter()
            .map(|tag| [tag.tag, tag.text].concat())
            .collect::<String>(),
        html
    );
    assert_eq!(without_tags(html), "aef");
}
