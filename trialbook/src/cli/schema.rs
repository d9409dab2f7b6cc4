//! A JSON Schema, read off the page that describes the answers field by field.

use super::output::{json, no_table};
use crate::book::options;
use crate::publishing::{Edition, Failure, Format};
use pulldown_cmark::{Event, HeadingLevel, Parser, Tag, TagEnd};
use serde_json::{Map, Value, json};

/// Prints the schema: a definition for each section of the page `json`, and that an answer is one of them.
pub(super) fn schema(edition: &Edition, format: Format) -> Result<u8, Failure> {
    if format == Format::Csv {
        return Err(no_table());
    }
    let page = edition.written().find(|page| page.stem == "json");
    let page = page.ok_or("no page of the book describes the JSON")?;
    json(&of_page(&page.text, edition.name))?;
    Ok(0)
}

/// A section of the page on JSON: what some commands answer, field by field.
#[derive(Debug, Clone, Default)]
pub struct Described {
    /// Its heading.
    pub title: String,
    /// The id of that.
    pub id: String,
    /// The commands, as they are typed.
    pub commands: Vec<String>,
    /// In order.
    pub fields: Vec<Field>,
}

/// A field of an answer.
#[derive(Debug, Clone)]
pub struct Field {
    /// `claims[].id`.
    pub path: String,
    /// `string`, `null`.
    pub types: Vec<String>,
    /// What it means, in Markdown.
    pub meaning: String,
}

/// The sections of the page on JSON that have a table of fields, of a program of this name.
pub fn described(page: &str, name: &str) -> Vec<Described> {
    let (mut sections, mut row) = (Vec::<Described>::new(), Vec::new());
    let (mut heading, mut code) = (false, false);
    for (event, range) in Parser::new_ext(page, options()).into_offset_iter() {
        let section = sections.last_mut();
        match (event, section) {
            (
                Event::Start(Tag::Heading {
                    level: HeadingLevel::H2,
                    id,
                    ..
                }),
                _,
            ) => {
                heading = true;
                sections.push(Described {
                    id: id.map_or_else(String::new, |id| id.into_string()),
                    ..Described::default()
                });
            }
            (Event::End(TagEnd::Heading(_)), _) => heading = false,
            (Event::Text(title), Some(section)) if heading => section.title += &title,
            (Event::Start(Tag::CodeBlock(_)), _) => code = true,
            (Event::End(TagEnd::CodeBlock), _) => code = false,
            (Event::Text(text), Some(section)) if code => {
                let typed = |line: &&str| line.split(' ').next() == Some(name);
                let typed = text.lines().filter(typed);
                section.commands.extend(typed.map(str::to_owned));
            }
            (Event::Start(Tag::TableRow), _) => row.clear(),
            (Event::Start(Tag::TableCell), _) => row.push(page[range].trim_matches([' ', '|'])),
            (Event::End(TagEnd::TableRow), Some(section)) => {
                let [path, types, meaning] = row[..] else {
                    continue;
                };
                let Some(path) = path.strip_prefix('`').and_then(|p| p.strip_suffix('`')) else {
                    continue;
                };
                section.fields.push(Field {
                    path: path.to_owned(),
                    types: types.split(", ").map(str::to_owned).collect(),
                    meaning: meaning.to_owned(),
                });
            }
            _ => {}
        }
    }
    sections.retain(|section| !section.fields.is_empty());
    sections
}

/// A definition for each section, and that an answer is one of them.
fn of_page(page: &str, name: &str) -> Value {
    let mut definitions = Map::new();
    let mut answers = Vec::new();
    let mut common = None;
    for section in described(page, name) {
        let mut definition = object(&section.fields, "");
        definition.insert("title".into(), section.title.into());
        // What several answers have in common has no command of its own.
        let part_of = common
            .as_ref()
            .filter(|common| section.id.starts_with(&format!("{common}-")));
        if let Some(common) = part_of {
            let all = json!([{ "$ref": format!("#/$defs/{common}") }]);
            definition.insert("allOf".into(), all);
        }
        match section.commands.is_empty() {
            true => common = Some(section.id.clone()),
            false => answers.push(json!({ "$ref": format!("#/$defs/{}", section.id) })),
        }
        definitions.insert(section.id, definition.into());
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": format!("What {name} writes with --json"),
        "anyOf": answers,
        "$defs": definitions,
    })
}

/// The object whose fields have the paths that begin with `above`.
fn object(fields: &[Field], above: &str) -> Map<String, Value> {
    let mut properties = Map::new();
    for field in fields {
        let Some(name) = field.path.strip_prefix(above) else {
            continue;
        };
        if name.contains('.') {
            continue;
        }
        let mut property = Map::new();
        property.insert("type".into(), json!(field.types));
        property.insert("description".into(), field.meaning.clone().into());
        let below = format!("{}[].", field.path);
        if fields.iter().any(|other| other.path.starts_with(&below)) {
            property.insert("items".into(), object(fields, &below).into());
        }
        properties.insert(name.to_owned(), property.into());
    }
    let mut object = Map::new();
    let names: Vec<_> = properties.keys().cloned().collect();
    object.insert("type".into(), "object".into());
    object.insert("properties".into(), properties.into());
    object.insert("required".into(), json!(names));
    object
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_becomes_an_object_with_lists_of_objects() {
        let page = "# JSON\n\n## All {#all}\n\n| field | type | meaning |\n|---|---|---|\n| `a` | number, null | a \\| b |\n\n\
                    ## One {#all-one}\n\n```text\nstone one --json\n```\n\n| field | type | meaning |\n|---|---|---|\n| `b` | array | some |\n| `b[].c` | string | c |\n";
        let schema = of_page(page, "stone");
        assert_eq!(schema["anyOf"], json!([{ "$ref": "#/$defs/all-one" }]));
        let (all, one) = (&schema["$defs"]["all"], &schema["$defs"]["all-one"]);
        assert_eq!(all["properties"]["a"]["type"], json!(["number", "null"]));
        assert_eq!(one["allOf"], json!([{ "$ref": "#/$defs/all" }]));
        assert_eq!(one["properties"]["b"]["items"]["required"], json!(["c"]));
        assert_eq!(one["required"], json!(["b"]));
    }
}
