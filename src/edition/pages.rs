//! The pages as they are written.

use trialbook::edition::Page;

/// One list of the written pages, for the book and for the doctests; a topic has its title elsewhere.
macro_rules! written {
    ($($stem:ident $($title:literal)?),+ $(,)?) => {
        /// The written pages. A topic that is not named here gets a page made from its claims alone.
        pub(super) const WRITTEN: &[Page] = &[$(Page::new(
            stringify!($stem),
            concat!($($title)?),
            include_str!(concat!("../../book/src/", stringify!($stem), ".md")),
        )),+];

        /// The code on the pages runs as tests.
        #[cfg(doctest)]
        mod doctests {
            $(
                #[doc = include_str!(concat!("../../book/src/", stringify!($stem), ".md"))]
                mod $stem {}
            )+
        }
    };
}

written!(
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
    ledger "The ledger",
    proved "What is proved, argued, measured",
    lemmas "Lemmas",
    certificates "Certificates",
    trust "What you have to trust",
    accuracy "How accurately it was measured",
    errata "Errata",
    findings "The findings, to print",
    map "The map of claims",
    equations "Index of equations",
    symbols "Index of symbols",
    values "Index of values",
    methods "How a verdict comes about",
    snapshots "How to read a snapshot",
    adding "How to add a claim",
    own "Your own paper",
    json "Answers as JSON",
    python "From Python",
    speed "How fast",
    exam "An exam in dry friction",
);
