//! The links of a written book.

use super::text::unescape;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// All files in a folder and below, by their paths, with `/` between the names.
///
/// # Errors
/// What the system says where a folder cannot be read.
pub fn files_below(folder: &Path) -> io::Result<BTreeMap<String, PathBuf>> {
    let mut files = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for item in fs::read_dir(next)? {
            let path = item?.path();
            if path.is_dir() {
                open.push(path);
            } else {
                let below = path.strip_prefix(folder).unwrap_or(&path);
                let name = below.to_string_lossy().replace('\\', "/");
                files.insert(name, path);
            }
        }
    }
    Ok(files)
}

/// The links of the pages in a folder that lead to what is not there, or load from out of the book, each
/// once, as `page: link`. Links out of it are not tried.
///
/// # Errors
/// What the system says where a file cannot be read.
pub fn dead_links(folder: &Path) -> io::Result<Vec<String>> {
    let files = files_below(folder)?;
    let pages = files.par_iter().filter(|(name, _)| name.ends_with(".html"));
    let pages: io::Result<Vec<(&String, String)>> = pages
        .map(|(name, path)| Ok((name, fs::read_to_string(path)?)))
        .collect();
    let pages = pages?;
    let places = pages
        .par_iter()
        .map(|(page, html)| (page.as_str(), values(html, "id").collect()));
    let places: BTreeMap<&str, BTreeSet<&str>> = places.collect();
    let leads = |page: &str, link: &str| {
        let (file, place) = link.split_once('#').unwrap_or((link, ""));
        // What follows is for a script.
        let place = place.split('?').next().unwrap_or("");
        let target = match file {
            "" => page.to_owned(),
            file => from(page, file),
        };
        let there = || {
            places
                .get(target.as_str())
                .is_some_and(|places| places.contains(place))
        };
        files.contains_key(&target) && (place.is_empty() || there())
    };
    let dead = pages.par_iter().flat_map_iter(|(page, html)| {
        let own = values(html, "href").filter(|link| !OUTSIDE.iter().any(|o| link.starts_with(o)));
        let links = own.chain(values(html, "src")).filter(|link| {
            let known = leads(page, link);
            !known && !leads(page, &decoded(link))
        });
        links.map(move |link| format!("{page}: {link}"))
    });
    Ok(Vec::from_iter(dead.collect::<BTreeSet<_>>()))
}

const OUTSIDE: [&str; 3] = ["https://", "http://", "mailto:"];

/// `a%20b&amp;c` is `a b&c`.
fn decoded(link: &str) -> String {
    let link = unescape(link);
    let mut bytes = Vec::with_capacity(link.len());
    let mut rest = link.as_bytes();
    while let [first, after @ ..] = rest {
        let pair = after.get(..2);
        let pair = pair.filter(|pair| pair.iter().all(u8::is_ascii_hexdigit));
        let pair = pair.and_then(|pair| std::str::from_utf8(pair).ok());
        let coded = pair.and_then(|pair| u8::from_str_radix(pair, 16).ok());
        let (byte, left) = match (first, coded) {
            (b'%', Some(byte)) => (byte, &after[2..]),
            (first, _) => (*first, after),
        };
        bytes.push(byte);
        rest = left;
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn values<'a>(html: &'a str, attribute: &str) -> impl Iterator<Item = &'a str> {
    let start = format!(" {attribute}=\"");
    let parts: Vec<&str> = html.split(start.as_str()).skip(1).collect();
    parts.into_iter().filter_map(|part| part.split('"').next())
}

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
            "<i id=\"y\"><a href=\"../a.html#x\"><a href=\"../a.html#y\"><a href=\"//elsewhere\">\
             <a href=\"https://doi.org/1\"><img src=\"https://doi.org/2\"><i id=\"ä&\"><a href=\"#%C3%A4&amp;\"><a href=\"#%zz%\">",
        );
        let dead = [
            "a.html: #z",
            "a.html: c.svg",
            "code/b.html: #%zz%",
            "code/b.html: ../a.html#y",
            "code/b.html: //elsewhere",
            "code/b.html: https://doi.org/2",
        ];
        assert_eq!(dead_links(folder.path()).unwrap(), dead);
    }
}
