//! Writing a book: what is refused, and what is left of it. The paper is the example's.

use super::{BookError, write};
use crate::data::Text;
use crate::evidence::{Route, Subject};
use crate::ledger::Ledger;
use crate::ledger::example::{PAPER, ledger, tried};
use crate::publishing::{Edition, Page, Part, Word};
use crate::trials::{Paper, Topic, attempt::Attempt, read::File};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const EDITION: Edition = Edition::of("example", &PAPER);

fn with(pages: &[(&'static str, &str)], out: &Path) -> Result<PathBuf, BookError> {
    let pages = pages.iter().map(|(stem, text)| Page {
        stem,
        part: Part::Read,
        title: stem,
        text: Text::Built(text.to_string().leak()),
    });
    let pages: Vec<_> = pages.collect();
    let edition = Edition {
        pages: pages.leak(),
        ..EDITION
    };
    let mut ledger = ledger();
    // One that nobody has tried.
    ledger.entries[7].evidence.clear();
    write(&edition, &ledger, &[], out)
}

#[test]
fn what_is_derived_here_is_not_said_to_be_printed() {
    const PROVED: Attempt =
        Attempt::measured(|| tried(Route::Exact, Subject::Printed, 0), "own::twice");
    static TOPIC: Topic = Topic::new(
        "own",
        "Own",
        File::here(
            "[s1-twice]
title = 'twice as far'
section = '1'
latex = 'It goes $2a$ far.'
ours = true
was = ['s1-once']
conditions = [{ stated = '$a>0$' }]
trials = ['own::twice']",
        ),
        &[&[PROVED]],
    );
    static OWN: Paper = Paper {
        topics: &[&TOPIC],
        ..Paper::BLANK
    };
    let ledger = Ledger::try_all(&OWN, |_| {});
    assert_eq!(OWN.check(), []);
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    write(&Edition::of("own", &OWN), &ledger, &[], &out).unwrap();
    let html = fs::read_to_string(out.join("own.html")).unwrap();
    for said in [
        "Derived here, not printed",
        "as derived here",
        "stated with it",
        "<span id=\"s1-once\">",
    ] {
        assert!(html.contains(said), "{said}: {html}");
    }
    for text in [html, ledger.entries[0].sheet()] {
        let text = text.to_lowercase();
        assert!(text.contains("derived here"), "{text}");
        assert!(
            !text.contains("as printed") && !text.contains("in the paper"),
            "{text}"
        );
    }
}

#[test]
fn a_claim_that_is_gone_is_told_wherever_it_is_named() {
    let page = Page {
        text: Text::Built(
            "# A\n\n{{claim eq-1}} {{ref eq-9}} `{{ref eq-10}}`\n```\n{{ref eq-11}}\n```\n{{figure fig-9}} {{verdict s9-a}}",
        ),
        ..Page::new("own", "own", "")
    };
    let edition = Edition {
        pages: vec![page].leak(),
        examples: &[("show", "eq-12 --json")],
        symbols: &[],
        ..EDITION
    };
    let told = edition.check().unwrap_err().to_string();
    assert_eq!(
        told.lines().collect::<Vec<_>>(),
        [
            "own.md, line 3: there is no claim `eq-9`",
            "own.md, line 7: there is no claim `s9-a`",
            "the example of `show`: there is no claim `eq-12`",
        ]
    );
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let items = fs::read_dir(folder)
        .unwrap()
        .map(|item| item.unwrap().path());
    let named = items.filter(|path| path.is_file()).map(|path| {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        (name, fs::read(path).unwrap())
    });
    named.collect()
}

#[test]
fn words_and_numbers_are_as_they_are_computed() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    let said = |text: &str| {
        let page = Page {
            text: Text::Built(text.to_owned().leak()),
            ..Page::new("own", "own", "")
        };
        let edition = Edition {
            pages: vec![page].leak(),
            words: &[&[
                Word {
                    name: "six",
                    is: || Ok(6.0),
                },
                Word {
                    name: "second",
                    is: || Ok(1.0),
                },
            ]],
            ..EDITION
        };
        write(&edition, &ledger(), &[], &out)?;
        Ok::<_, BookError>(fs::read_to_string(out.join("own.html")).unwrap())
    };
    let html = said("# A\n\nIt {{is second $p$ falls|$q$ rises}} {{is six six}} times.\n\nIn {{code five}}.\n\n```rust\nlet a = 5;\n```\n").unwrap();
    assert!(
        html.contains("</span> rises six times.")
            && html.contains("In five.")
            && !html.contains("falls")
    );
    for (text, told) in [
        (
            "{{is second falls|rises}} {{is six seven}}",
            "own.md, line 1: `{{is six seven}}`: computed is 6",
        ),
        ("{{is second first|second}}", "stands first, or second"),
        (
            "{{is second falls|rises}} {{is six two|three}}",
            "computed is 6, their place from 0",
        ),
        (
            "{{is second falls|rises}} {{is six six}} {{code four}}\n\n```rust\nlet a = 5;\n```\n",
            "own.md, line 1: `{{code four}}`: no such number",
        ),
        (
            "{{is six six}}",
            "no page says what is computed as `second`",
        ),
    ] {
        let error = said(text).expect_err(text).to_string();
        assert!(error.contains(told), "{text}: {error}");
    }
}

#[test]
fn what_cannot_be_filled_or_set_is_named_with_page_and_line() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    for (added, told) in [
        (
            "{{nonsense}}",
            "methods.md, line 2: `{{nonsense}}`: there is no such placeholder",
        ),
        (
            "{{verdict eq-999}}",
            "line 2: `{{verdict eq-999}}`: the ledger has no claim `eq-999`",
        ),
        ("{{count bad}}", "there is no verdict `bad`"),
        ("{{ledger nowhere}}", "there is no topic `nowhere`"),
        ("{{figure fig-9}}", "there is no figure `fig-9`"),
        ("{{worst eq-8}}", "no trial of `eq-8`"),
        ("{{claim eq-1}}", "this claim belongs on examples.md"),
        ("see {{counts}}", "must stand alone on its line"),
        ("a {{count claims", "`{{` without `}}`"),
        ("a }} b", "`}}` without `{{`"),
        ("costs $5", "a `$` that is not part of a formula"),
        (r"so $\frac{1}{$ is", "a `$`"),
        (
            r"so $\nonsense{x}$ is",
            r"methods.md, line 2: the formula `\nonsense{x}`",
        ),
        ("## On $x$", "needs an id of its own"),
        ("{{is six six}}", "nothing is computed by the name `six`"),
    ] {
        let error = with(&[("methods", &format!("\n{added}\n"))], &out).expect_err(added);
        assert!(error.to_string().contains(told), "{added}: {error}");
        assert!(!out.exists());
    }
    let dead = with(&[("index", "# A\n\n[a](ledger.md#nowhere)\n")], &out);
    let dead = dead.unwrap_err().to_string();
    assert!(
        dead.ends_with("index.html: ledger.html#nowhere; print.html: #nowhere"),
        "{dead}"
    );
    let topic = |text: &str| with(&[("examples", text)], &out);
    let twice = topic("{{claim eq-1}}\n\n{{claim eq-1}}\n");
    assert!(twice.unwrap_err().to_string().contains("shown already"));
    let nowhere = topic("{{claim eq-1}}\n");
    assert!(matches!(
        nowhere,
        Err(BookError::ClaimNowhere { id: "eq-2", .. })
    ));
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        0,
        "something is left behind"
    );
}

#[test]
fn an_earlier_book_is_replaced_whole_and_only_by_a_whole_one() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("book");
    with(&[], &out).unwrap();
    fs::write(out.join("stale.html"), "old").unwrap();
    let before = files(&out);
    assert!(with(&[("index", "{{oops}}\n")], &out).is_err());
    assert!(files(&out) == before, "a failed run changed the book");
    with(&[], &out).unwrap();
    assert!(!out.join("stale.html").exists());
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        1,
        "something is left behind"
    );
}

#[test]
fn what_is_not_ours_is_left_alone() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("thesis");
    fs::create_dir(&out).unwrap();
    with(&[], &out).expect("an empty folder may be filled");
    fs::remove_file(out.join(".example")).unwrap();
    let before = files(&out);
    let error = with(&[], &out).unwrap_err();
    assert!(matches!(&error, BookError::NotOurs { path } if path.ends_with("thesis")));
    assert!(files(&out) == before);
}

#[test]
fn a_place_that_cannot_be_written_is_named_with_the_reason() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "mine").unwrap();
    for out in [file.clone(), file.join("book")] {
        let error = with(&[], &out).unwrap_err();
        assert!(matches!(error, BookError::Unwritable { .. }), "{error}");
        assert!(error.to_string().contains("file"), "{error}");
        assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    }
    assert!(with(&[], Path::new("/")).is_err());
}

/// Needs a system that keeps its word on permissions; a superuser is not held by them.
#[cfg(unix)]
#[test]
fn a_locked_parent_keeps_the_old_book() {
    use std::os::unix::fs::PermissionsExt;
    let folder = TempDir::new().unwrap();
    let parent = folder.path().join("locked");
    let out = parent.join("book");
    with(&[], &out).unwrap();
    let before = files(&out);
    fs::set_permissions(&parent, fs::Permissions::from_mode(0o555)).unwrap();
    let held = fs::write(parent.join("probe"), "").is_err();
    let result = with(&[], &out);
    fs::set_permissions(&parent, fs::Permissions::from_mode(0o755)).unwrap();
    if held {
        assert!(matches!(result, Err(BookError::Unwritable { .. })));
    } else {
        result.unwrap();
    }
    assert!(files(&out) == before);
}
