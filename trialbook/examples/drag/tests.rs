use super::{EDITION, PAPER};
use std::fs;
use trialbook::book;
use trialbook::prelude::*;
use trialbook::seeded::Mistake;
use trialbook::trials::variants::Variant;

#[test]
fn the_verdicts_are_the_recorded_ones_and_wrong_variants_are_rejected() {
    let ledger = Ledger::try_all(&PAPER, |_| {});
    assert_eq!(Record::text_of(&ledger), *PAPER.record);
    let variants = PAPER.formulas.variants();
    let kept = variants.iter().zip(ledger.rejected(&variants));
    let kept = kept.filter(|(_, rejected)| !rejected);
    let kept: Vec<_> = kept.map(|(variant, _)| variant).collect();
    // Another sign, at any of five places, takes the misprint back.
    let right = |v: &&Variant| v.claim == "eq-6" && v.printed && v.seed.mistake == Mistake::Sign;
    assert!(variants.len() > 100, "{}", variants.len());
    assert!(kept.len() == 5 && kept.iter().all(right), "{kept:#?}");
}

#[test]
fn the_book_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("book");
    let ledger = Ledger::try_all(&PAPER, |_| {});
    let figures = (EDITION.figures)().unwrap();
    book::write(&EDITION, &ledger, &figures, &out).unwrap();
    assert_eq!(book::dead_links(&out).unwrap(), [""; 0]);
    let page = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let (stone, sheets) = (page("stone.html"), page("sheets.html"));
    for (_, claim) in PAPER.claims() {
        let id = claim.id;
        assert!(
            stone.contains(&format!("<h3 id=\"{id}\"")),
            "no box of {id}"
        );
        assert!(
            sheets.contains(&format!("<h2 id=\"sheet-{id}\"")),
            "no sheet of {id}"
        );
    }
    assert!(stone.contains("id=\"plot-top\"") && out.join("figures/top.csv").is_file());
    assert!(
        stone.contains("code/main.html#eq6_top") && stone.contains("code/main.html#right_motion")
    );
    assert!(page("index.html").contains("<span class=\"verdict misprint\">"));
    assert!(page("errata.html").contains("id=\"erratum-eq-6\""));
    assert!(page("errata.txt").contains("(6)") && page("errata.tex").contains("H=w/k-gT/k"));
}
