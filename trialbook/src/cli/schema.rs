//! A JSON Schema, read off the page that describes the answers field by field.

use super::output::{json, no_table};
use crate::publishing::{Edition, Failure, Format};
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

/// The schema of a page: a section is a heading with its id, and a table of fields.
fn of_page(page: &str, name: &str) -> Value {
    let mut definitions = Map::new();
    let mut answers = Vec::new();
    let mut common = None;
    for section in page.split("\n## ").skip(1) {
        let heading = section.lines().next().unwrap_or_default();
        let Some((title, id)) = heading.split_once(" {#") else {
            continue;
        };
        let id = id.trim_end_matches('}');
        let fields: Vec<_> = section.lines().filter_map(field).collect();
        if fields.is_empty() {
            continue;
        }
        let mut definition = object(&fields, "");
        definition.insert("title".into(), title.into());
        // What several answers have in common has no command of its own.
        let has_command = section.contains(&format!("\n{name} "));
        let part_of = common
            .as_ref()
            .filter(|common: &&String| id.starts_with(&format!("{common}-")));
        if let Some(common) = part_of {
            let all = json!([{ "$ref": format!("#/$defs/{common}") }]);
            definition.insert("allOf".into(), all);
        }
        if has_command {
            answers.push(json!({ "$ref": format!("#/$defs/{id}") }));
        } else {
            common = Some(id.to_owned());
        }
        definitions.insert(id.to_owned(), definition.into());
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": format!("What {name} writes with --json"),
        "anyOf": answers,
        "$defs": definitions,
    })
}

/// A field of a table: path, types, meaning.
struct Field<'a> {
    path: &'a str,
    types: Vec<&'a str>,
    meaning: &'a str,
}

fn field(line: &str) -> Option<Field<'_>> {
    let mut cells = line.strip_prefix("| `")?.splitn(3, " | ");
    let path = cells.next()?.strip_suffix('`')?;
    let types = cells.next()?.split(", ").collect();
    let meaning = cells.next()?.trim_end_matches(" |");
    Some(Field {
        path,
        types,
        meaning,
    })
}

/// The object whose fields have the paths that begin with `above`.
fn object(fields: &[Field<'_>], above: &str) -> Map<String, Value> {
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
        property.insert("description".into(), field.meaning.into());
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
                    ## One {#all-one}\n\n```text\nstone one --json\n```\n\n| `b` | array | some |\n| `b[].c` | string | c |\n";
        let schema = of_page(page, "stone");
        assert_eq!(schema["anyOf"], json!([{ "$ref": "#/$defs/all-one" }]));
        let (all, one) = (&schema["$defs"]["all"], &schema["$defs"]["all-one"]);
        assert_eq!(all["properties"]["a"]["type"], json!(["number", "null"]));
        assert_eq!(one["allOf"], json!([{ "$ref": "#/$defs/all" }]));
        assert_eq!(one["properties"]["b"]["items"]["required"], json!(["c"]));
        assert_eq!(one["required"], json!(["b"]));
    }
}
