//! What comes out of a printer.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::pages::{CHAPTERS, none};
use serde_json::json;

/// 176 mm between the margins, in pixels.
const SHEET: u32 = 665;

/// Long formulas, wide tables, figures.
const HARD: [&str; 6] = ["errata", "ledger", "methods", "lookup", "exam", "map"];

/// Eight points at least, but for indices and powers; no formula is wider than its place, or a browser would set the whole page
/// smaller.
pub fn sizes(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    for name in CHAPTERS.into_iter().chain(HARD) {
        page.resize(SHEET, 1000)?;
        page.open(&book.address(&format!("{name}.html")))?;
        page.call("Emulation.setEmulatedMedia", json!({ "media": "print" }))?;
        let found = page.texts(
            "(() => {
                dispatchEvent(new Event('beforeprint'));
                const main = document.querySelector('main'), found = [];
                // As it is seen: folded, but for the answers. Then as who has unfolded all of it prints it.
                const folds = [...main.querySelectorAll('details:is(:not([class]), .evidence, .proof, .listing)')];
                folds.forEach(fold => {
                    const answers = fold.closest('.exercise') !== null;
                    const seen = fold.checkVisibility() && [...fold.children].some(part => !part.matches('summary') && part.checkVisibility());
                    if (seen !== answers && !fold.parentElement.closest('details')) found.push(`${fold.textContent.slice(0, 60)} is ${seen ? '' : 'not '}printed`);
                    fold.open = true;
                });
                const points = part => {
                    const matrix = part.ownerSVGElement?.getScreenCTM();
                    return 0.75 * parseFloat(getComputedStyle(part).fontSize) * (matrix ? Math.hypot(matrix.a, matrix.b) : 1);
                };
                const put = (part, words) => {
                    const size = points(part);
                    if (size < 7.99) found.push(`${words.trim().slice(0, 60)} is ${size.toFixed(1)} pt`);
                };
                const walk = document.createTreeWalker(main, NodeFilter.SHOW_TEXT);
                let count = 0;
                while (walk.nextNode()) {
                    const part = walk.currentNode.parentElement;
                    // Indices, powers, and what is there for who does not see.
                    if (!walk.currentNode.data.trim() || part.matches('.katex *, script, style, sub, sup, [font-size=\"70%\"], .more')
                        || !part.checkVisibility()) continue;
                    count += 1;
                    put(part, walk.currentNode.data);
                }
                main.querySelectorAll('.katex').forEach(formula => {
                    if (!formula.checkVisibility()) return;
                    const words = formula.querySelector('math').textContent;
                    put(formula.querySelector('.katex-html') || formula.querySelector('math'), words);
                    const [own, room] = [formula, formula.closest('.katex-display, .claim-words, .says, li, p, td, div')].map(box => box.getBoundingClientRect().width);
                    if (own > 1.03 * room) found.push(`${words.slice(0, 60)} is ${own.toFixed(0)} wide and has ${room.toFixed(0)}`);
                });
                // What is fixed would lie on every sheet.
                document.querySelectorAll('body *').forEach(part => {
                    const place = getComputedStyle(part).position;
                    if (['fixed', 'sticky'].includes(place) && part.checkVisibility()) found.push(`${place}: ${part.className} ${part.textContent.slice(0, 60)}`);
                });
                const width = document.documentElement.scrollWidth;
                if (width > innerWidth) found.push(`it is ${width} wide`);
                if (count < 20) found.push(`only ${count} words`);
                return found;
            })()",
        )?;
        wrong.extend(found.into_iter().map(|words| format!("{name}: {words}")));
        page.call("Emulation.setEmulatedMedia", json!({ "media": "" }))?;
    }
    none(wrong)
}

pub fn sheets(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    for name in ["errata", "ledger", "constant", "rest"] {
        page.open(&book.address(&format!("{name}.html")))?;
        let printed = page.call("Page.printToPDF", json!({ "preferCSSPageSize": true }))?;
        let data = printed["data"].as_str().ok_or("nothing is printed")?;
        let found = page.texts(&format!("({})('{data}')", include_str!("pdf.js")))?;
        wrong.extend(found.into_iter().map(|words| format!("{name}: {words}")));
    }
    none(wrong)
}
