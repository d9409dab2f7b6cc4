//! What stands at the addresses of earlier books: pages that lead on.

use super::text::escape;
use crate::publishing::Edition;
use std::collections::BTreeMap;

pub(super) fn pages(edition: &Edition) -> BTreeMap<&'static str, String> {
    let whole = edition.moved.iter().filter(|(from, _)| !from.contains('#'));
    let page = |(from, to): &(&'static str, &str)| {
        let places = edition.moved.iter().filter_map(|(place, to)| {
            let (page, place) = place.split_once('#')?;
            (page == *from).then_some((place, to))
        });
        (*from, page(to, &places.collect::<Vec<_>>()))
    };
    whole.map(page).collect()
}

/// From its places, too. Without a script it leads to the first alone.
fn page(to: &str, places: &[(&str, &&str)]) -> String {
    let places = serde_json::json!(places);
    let address = escape(to);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Moved</title>\
         <meta name=\"robots\" content=\"noindex\"><noscript><meta http-equiv=\"refresh\" content=\"0; url={address}\"></noscript>\
         <script>\n\
         const place = location.hash.slice(1), moved = {places}.find(([from]) => place === from || from.endsWith('-') && place.startsWith(from));\n\
         location.replace(moved ? moved[1] + place.slice(moved[0].length) : place ? `{page}#${{place}}` : \"{to}\");\n\
         </script></head><body><main><p>This page is now <a href=\"{address}\">here</a>.</p></main></body></html>\n",
        page = to.split('#').next().unwrap_or(to),
    )
}
