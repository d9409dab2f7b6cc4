//! Words in pictures.

use crate::Book;
use crate::chrome::{Failure, Page};
use crate::pages::none;

/// How many pixels are between two words of a picture side by side, and between its words and what cuts them off.
const APART: f64 = 4.0;

/// No words in a figure or an explorer touch others or are cut off, on a desk and on a phone.
pub fn apart(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for name in crate::explorers::PAGES
        .into_iter()
        .chain(["accuracy", "exam"])
    {
        page.resize(1400, 900)?;
        page.open(&book.address(&format!("{name}.html")))?;
        page.explored()?;
        for width in [1400, 390] {
            page.resize(width, 900)?;
            page.value(
                "new Promise(seen => requestAnimationFrame(() => requestAnimationFrame(seen)))",
            )?;
            let mut found = page.texts(&format!(
                "(() => {{
                    document.querySelectorAll('.explorer-static').forEach(still => {{ still.open = true; }});
                    const found = [];
                    let count = 0;
                    for (const svg of document.querySelectorAll('figure.plot > div:not(.map-window) svg, .explorer svg')) {{
                        if (!svg.checkVisibility()) continue;
                        const edge = svg.getBoundingClientRect(), place = svg.closest('figure, .explorer').id;
                        const words = [...svg.querySelectorAll('text')].filter(words => words.textContent.trim() && !words.getScreenCTM().b)
                            .map(words => [words.textContent, words.getBoundingClientRect(), parseFloat(getComputedStyle(words).fontSize) * words.getScreenCTM().a]);
                        count += words.length;
                        words.forEach(([text, box, size], i) => {{
                            if (box.left < edge.left - 1 || box.right > edge.right + 1) found.push(`${{place}}: ${{text}} is cut off`);
                            words.slice(i + 1).forEach(([other, its]) => {{
                                const aside = Math.max(box.left - its.right, its.left - box.right);
                                // A box of words is higher than they are.
                                const above = Math.max(box.top - its.bottom, its.top - box.bottom) + 0.35 * size;
                                if (aside < {APART} && above < 0) found.push(`${{place}}: ${{text}} is ${{aside.toFixed(1)}} px from ${{other}}`);
                            }});
                        }});
                    }}
                    return [String(count), ...found];
                }})()"
            ))?;
            count += found.remove(0).parse::<usize>().unwrap_or(0);
            wrong.extend(
                found
                    .into_iter()
                    .map(|words| format!("{name}, {width} px wide: {words}")),
            );
        }
    }
    if count < 1000 {
        wrong.push(format!("only {count} words"));
    }
    none(wrong)
}
