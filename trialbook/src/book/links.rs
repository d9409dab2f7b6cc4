//! The links of a written book.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::{fs, io};

/// The links of the pages in a folder that lead nowhere, each as `page: link`: to a file or a place that is not there, or out
/// of the book.
///
/// # Errors
/// What the system says where a file cannot be read.
pub fn dead_links(folder: &Path) -> io::Result<Vec<String>> {
    let mut files = BTreeSet::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for item in fs::read_dir(next)? {
            let path = item?.path();
            match path.is_dir() {
                true => open.push(path),
                false => drop(files.insert(path)),
            }
        }
    }
    let name = |path: &Path| {
        let below = path.strip_prefix(folder).unwrap_or(path);
        below.to_string_lossy().replace('\\', "/")
    };
    let mut pages = BTreeMap::new();
    for path in files
        .iter()
        .filter(|path| path.extension().is_some_and(|e| e == "html"))
    {
        pages.insert(name(path), fs::read_to_string(path)?);
    }
    let files: BTreeSet<String> = files.iter().map(|path| name(path)).collect();
    let places = pages
        .iter()
        .map(|(page, html)| (page, values(html, "id").collect()));
    let places: BTreeMap<&String, BTreeSet<&str>> = places.collect();
    let leads = |page: &String, link: &str| {
        let (file, place) = link.split_once('#').unwrap_or((link, ""));
        let target = match file {
            "" => page.clone(),
            file => from(page, file),
        };
        let there = || {
            places
                .get(&target)
                .is_some_and(|places| places.contains(place))
        };
        files.contains(&target) && (place.is_empty() || there())
    };
    let dead = pages.iter().flat_map(|(page, html)| {
        let links = values(html, "href").chain(values(html, "src"));
        links
            .filter(|link| !leads(page, link))
            .map(move |link| format!("{page}: {link}"))
    });
    Ok(dead.collect())
}

/// The values of an attribute in a page.
fn values<'a>(html: &'a str, attribute: &str) -> impl Iterator<Item = &'a str> {
    let start = format!(" {attribute}=\"");
    let parts: Vec<&str> = html.split(start.as_str()).skip(1).collect();
    parts.into_iter().filter_map(|part| part.split('"').next())
}

/// Where a relative link leads.
fn from(file: &str, link: &str) -> String {
    let mut target: Vec<_> = file.split('/').collect();
    target.pop();
    for part in link.split('/') {
        match part {
            "." => {}
            ".." => drop(target.pop()),
            part => target.push(part),
        }
    }
    target.join("/")
}

#[cfg(test)]
mod tests {
    use super::dead_links;
    use std::fs;

    #[test]
    fn a_link_leads_to_a_file_or_a_place_or_is_dead() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("code")).unwrap();
        let put = |name: &str, html: &str| fs::write(folder.path().join(name), html).unwrap();
        put(
            "a.html",
            "<a href=\"#x\" id=\"x\"><a href=\"code/b.html#y\"><img src=\"c.svg\"><a href=\"#z\">",
        );
        put(
            "code/b.html",
            "<i id=\"y\"><a href=\"../a.html#x\"><a href=\"../a.html#y\"><a href=\"//elsewhere\">",
        );
        let dead = [
            "a.html: #z",
            "a.html: c.svg",
            "code/b.html: ../a.html#y",
            "code/b.html: //elsewhere",
        ];
        assert_eq!(dead_links(folder.path()).unwrap(), dead);
    }
}
