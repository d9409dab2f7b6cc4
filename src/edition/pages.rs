//! The pages as they are written, and where those of earlier books are now.

use trialbook::data::text;
use trialbook::publishing::{Page, Part};

/// One list of the written pages, for the book and for the doctests; a topic has its title elsewhere.
macro_rules! written {
    ($($part:ident: $($stem:ident $($title:literal)?),+;)+) => {
        /// The written pages. A topic that is not named here gets a page made from its claims alone.
        pub(super) const WRITTEN: &[Page] = &[$($(Page::of(
            Part::$part,
            stringify!($stem),
            concat!($($title)?),
            text!(concat!("book/src/", stringify!($stem), ".md")),
        )),+),+];

        /// The code on the pages runs as tests.
        #[cfg(doctest)]
        mod doctests {
            $($(
                #[doc = include_str!(concat!("../../book/src/", stringify!($stem), ".md"))]
                mod $stem {}
            )+)+
        }
    };
}

written!(
    Read:
        index "Slipbook",
        general,
        constant,
        sinusoidal,
        periodic,
        anisotropic,
        sphere,
        turntable,
        escape,
        rest,
        beyond "Beyond the paper",
        new "What is new here",
        related "Related work",
        breaking "Break it yourself";
    Check:
        errata "Errata",
        ledger "The ledger",
        map "The map of claims",
        lookup "Look up";
    Trust:
        methods "How we know",
        kernel "Before the kernel",
        lemmas "Lemmas",
        exam "An exam in dry friction";
    Use:
        scenes "Your own scene",
        questions "Asked and answered",
        own "Your own paper",
        adding "Claims and snapshots",
        json "JSON, CSV, Python";
);

/// Addresses of earlier books.
pub(super) const MOVED: &[(&str, &str)] = &[
    ("accuracy.html", "methods.html#accuracy"),
    (
        "accuracy.html#how-accurately-it-was-measured",
        "methods.html#accuracy",
    ),
    ("certificates.html", "kernel.html"),
    ("proved.html#measured", "kernel.html#kernel-unreached"),
    ("methods.html#measured", "kernel.html#kernel-unreached"),
    (
        "certificates.html#certificate-corrupted",
        "kernel.html#kernel",
    ),
    ("certificates.html#certificate-file", "kernel.html#kernel"),
    (
        "certificates.html#certificate-identity",
        "kernel.html#kernel",
    ),
    ("certificates.html#certificate-lean", "kernel.html#kernel"),
    ("certificates.html#certificate-motion", "kernel.html#kernel"),
    ("certificates.html#certificate-range", "kernel.html#kernel"),
    ("certificates.html#certificate-root", "kernel.html#kernel"),
    ("certificates.html#certificates", "kernel.html#kernel"),
    ("equations.html", "ledger.html"),
    (
        "equations.html#index-of-equations",
        "ledger.html#the-ledger",
    ),
    ("findings.html", "errata.html"),
    ("findings.html#findings-", "errata.html#erratum-"),
    ("findings.html#print-errors", "errata.html#corrections"),
    ("findings.html#print-verdicts", "ledger.html#the-ledger"),
    ("findings.html#print-", "errata.html#"),
    ("findings.html#print", "errata.html#errata"),
    ("proved.html", "methods.html"),
    (
        "proved.html#what-is-proved-argued-measured",
        "methods.html#how-a-verdict-comes-about",
    ),
    ("proved.html#strongest", "ledger.html#the-ledger"),
    ("python.html", "json.html#python"),
    ("python.html#from-python", "json.html#python"),
    ("snapshots.html", "adding.html#sheet"),
    ("snapshots.html#how-to-read-a-snapshot", "adding.html#sheet"),
    ("speed.html", "json.html#speed"),
    ("speed.html#how-fast", "json.html#speed"),
    ("symbols.html", "lookup.html#symbols"),
    ("symbols.html#index-of-symbols", "lookup.html#symbols"),
    ("trust.html", "methods.html#what-you-have-to-trust"),
    ("trust.html#break-it", "breaking.html#break-it"),
    ("trust.html#broken", "breaking.html#broken"),
    ("values.html", "lookup.html#values"),
    ("values.html#index-of-values", "lookup.html#values"),
];
