//! Words in pictures.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::pages::none;

/// In pixels, between two words side by side, and between words and what cuts them off.
const APART: f64 = 4.0;

pub fn apart(page: &mut Page, book: &Book) -> Seen {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for name in crate::explorers::PAGES
        .into_iter()
        .chain(["methods", "exam"])
    {
        page.resize(1400, 900)?;
        page.open(&book.address(&format!("{name}.html")))?;
        page.show_explorer()?;
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

/// On a desk all names are read; on a phone it has signs, and says the name of the one pointed at.
pub fn map(page: &mut Page, book: &Book) -> Seen {
    let whole = "[...document.querySelectorAll('.map-bar button')].find(button => button.textContent === 'Whole map').click()";
    page.resize(1400, 900)?;
    page.open(&book.address("map.html"))?;
    let mut wrong = Vec::new();
    for press in ["0", whole] {
        page.value(press)?;
        wrong.extend(page.texts(
            "(() => {
                const view = document.querySelector('.map-window'), boxes = [...view.querySelectorAll('.node')], found = [];
                if (view.scrollWidth > view.clientWidth + 1 || view.scrollHeight > view.clientHeight + 1) found.push('not all of it is seen');
                if (boxes.length < 200) found.push(`only ${boxes.length} boxes`);
                for (const box of boxes) {
                    const [frame, name] = ['rect', '.name'].map(part => box.querySelector(part).getBoundingClientRect());
                    const words = box.querySelector('.name'), size = parseFloat(getComputedStyle(words).fontSize) * words.getScreenCTM().a;
                    const told = `${words.textContent} of ${box.querySelector('title').textContent}`;
                    if (!words.checkVisibility() || !words.textContent.trim() || words.textContent.includes('…')) found.push(`${told} is not read`);
                    if (size < 11.99) found.push(`${told} is ${size.toFixed(1)} px high`);
                    if (name.right > frame.right || name.left < box.querySelector('.sign').getBoundingClientRect().right) found.push(`${told} does not fit`);
                }
                return found;
            })()",
        )?);
    }
    page.resize(390, 800)?;
    page.open(&book.address("map.html"))?;
    page.value(whole)?;
    wrong.extend(page.texts(
        "[...document.querySelectorAll('.map-window .node')].filter(box => box.querySelector('.name').checkVisibility()
            || parseFloat(getComputedStyle(box.querySelector('.sign')).fontSize) * box.querySelector('.sign').getScreenCTM().a < 8)
            .map(box => `${box.textContent} on a phone`)",
    )?);
    page.value("document.querySelector('.map-window .node').focus()")?;
    let said = page.value("document.querySelector('.map-says').textContent")?;
    if said.as_str().is_none_or(|said| !said.starts_with("(1) ")) {
        wrong.push(format!("of the first claim it says {said}"));
    }
    none(wrong)
}
