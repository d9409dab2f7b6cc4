//! The page: panels in a grid, their keys, and the finished figure.

use super::{
    Axis, Curve, Figure, FigureError, Panel, Table,
    axes::{Scale, TEXT_SIZE, text},
    panels,
    svg::{escape, number},
    text::width,
};
use crate::notation::{Says, said};

/// In units of which type is 15 or 16 high.
const WIDTH: f64 = 480.0;
const KEY_LINE: f64 = 25.0;
const KEY_SAMPLE: f64 = 36.0;
pub(super) const FACES: &str =
    "KaTeX_Main, KaTeX_Math, 'Latin Modern Roman', 'STIX Two Text', 'Times New Roman', serif";

/// A figure in the making.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    id: &'static str,
    title: String,
    caption: String,
    alt: String,
    columns: usize,
    panels: Vec<Panel>,
    fault: Option<FigureError>,
}

struct Settled<'a> {
    panel: &'a Panel,
    x: Scale,
    y: Scale,
    height: f64,
    key: Vec<Vec<(f64, String, String)>>,
}

impl Plot {
    /// An empty figure: its permanent id (letters, digits, hyphens) and a title of a few words.
    pub fn new(id: &'static str, title: impl Into<String>) -> Self {
        Plot {
            id,
            title: title.into(),
            caption: String::new(),
            alt: String::new(),
            columns: 1,
            panels: Vec::new(),
            fault: None,
        }
    }

    /// What a reader should see in it; formulas in `$…$`.
    pub fn caption(mut self, caption: impl Into<String>) -> Self {
        self.caption = caption.into();
        self
    }

    /// What it shows, in plain words, for those who do not see it.
    pub fn alt(mut self, alt: impl Into<String>) -> Self {
        self.alt = alt.into();
        self
    }

    /// Writes for each `{{falls|rises}}` in caption and alternative the word that the figure's numbers say;
    /// `{{falls}}` or `{{six}}` they have to say. `{{line solved}}` is how the lines are drawn whose key or
    /// label begins with `solved`.
    pub fn says<const N: usize>(mut self, words: [&str; N], is: impl Says) -> Self {
        let is = is.says();
        for words in words {
            let chosen = is.clone().and_then(|is| said(words, is).map(str::to_owned));
            if let Err(why) = chosen.and_then(|word| self.write(words, &word)) {
                self.fault.get_or_insert(self.unsaid(words, why));
            }
        }
        self
    }

    fn write(&mut self, words: &str, word: &str) -> Result<(), String> {
        let place = format!("{{{{{words}}}}}");
        let texts = [&mut self.caption, &mut self.alt];
        if texts.iter().all(|text| !text.contains(&place)) {
            return Err("neither caption nor alternative says it".to_owned());
        }
        texts
            .into_iter()
            .for_each(|text| *text = text.replace(&place, word));
        Ok(())
    }

    fn unsaid(&self, words: &str, why: String) -> FigureError {
        FigureError::Unsaid {
            figure: self.id,
            words: words.to_owned(),
            why,
        }
    }

    /// Fails if anything else has not been said.
    fn speak(&mut self) -> Result<(), FigureError> {
        if let Some(fault) = self.fault.take() {
            return Err(fault);
        }
        let both = format!("{} {}", self.caption, self.alt);
        let open = both
            .split("{{")
            .skip(1)
            .map(|part| part.split("}}").next().unwrap_or(part));
        for words in open {
            let drawn = words
                .strip_prefix("line ")
                .ok_or("nothing says it")
                .and_then(|named| {
                    let mut drawn: Vec<_> = self
                        .panels
                        .iter()
                        .flat_map(|panel| panel.strokes(named))
                        .collect();
                    drawn.dedup();
                    match drawn[..] {
                        [one] => Ok(one),
                        _ => Err("there has to be a line of that name, and all of them alike"),
                    }
                });
            let word = drawn.map_err(|why| self.unsaid(words, why.to_owned()))?;
            // The same words may have been written before.
            let _ = self.write(words, word);
        }
        Ok(())
    }

    /// Puts panels side by side, 1 to 4 in a row of the same 480 units; one column if not set.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = columns;
        self
    }

    /// Adds a panel: to the right, then below.
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Draws a panel of curves over the same values, with the data beside it: each row has a value and the
    /// curves' heights there.
    ///
    /// # Errors
    /// [`FigureError`] where an axis has no range, or a logarithmic one a value that is not positive.
    pub fn curves<const N: usize>(
        self,
        [x, y]: [Axis; 2],
        names: [&str; N],
        rows: &[(f64, [f64; N])],
    ) -> Result<Figure, FigureError> {
        let headers: Vec<_> = [x.label.as_str()].into_iter().chain(names).collect();
        let mut table = Table::new(&headers);
        table.rows((), rows)?;
        let panel = (0..N).fold(Panel::new(x, y), |panel, i| {
            let points = rows.iter().map(|(at, heights)| [*at, heights[i]]);
            panel.curve(Curve::new(points).series(i + 1).label(names[i]))
        });
        self.panel(panel).figure(table)
    }

    /// Draws it and puts the data beside it.
    pub fn figure(mut self, data: Table) -> Result<Figure, FigureError> {
        self.speak()?;
        let svg = self.draw()?;
        Ok(Figure {
            id: self.id,
            caption: self.caption,
            alt: self.alt,
            svg,
            csv: data.into_text(),
        })
    }

    fn draw(&self) -> Result<String, FigureError> {
        if !(1..=4).contains(&self.columns) {
            return Err(layout("columns of a figure", "from 1 to 4", self.columns));
        }
        if self.panels.is_empty() {
            return Err(layout("panels of a figure", "at least 1", 0));
        }
        let share = WIDTH / self.columns as f64;
        let scales: Result<Vec<_>, _> = self.panels.iter().map(|p| p.settle(share)).collect();
        let scales = scales?;
        let widest = scales
            .iter()
            .map(|(_, y)| y.label_width())
            .fold(0.0, f64::max);
        let hanging = scales
            .iter()
            .map(|(x, _)| x.overhang())
            .fold(14.0, f64::max);
        let (left, right) = (widest + 18.0, hanging + 2.0);
        let inner = share - left - right;
        if inner < 60.0 {
            return Err(layout(
                "columns of a figure",
                "few enough to leave room",
                self.columns,
            ));
        }
        let mut settled = Vec::new();
        for (panel, (mut x, mut y)) in self.panels.iter().zip(scales) {
            let height = panel.inner_height(&x, &y, inner)?;
            x.pixels = (0.0, inner);
            y.pixels = (height, 0.0);
            let key = key_lines(panel.key(&x, &y), inner);
            settled.push(Settled {
                panel,
                x,
                y,
                height,
                key,
            });
        }

        let mut body = String::new();
        let mut top = 4.0;
        let parted = self.columns == 1 && settled.len() > 1;
        for row in settled.chunks_mut(self.columns) {
            let head = row.iter().map(|s| s.head()).fold(0.0, f64::max);
            let foot = row.iter().map(|s| s.height + s.foot()).fold(0.0, f64::max);
            for (i, s) in row.iter_mut().enumerate() {
                let x0 = i as f64 * share + left;
                let y0 = top + head;
                s.x.pixels = (x0, x0 + inner);
                s.y.pixels = (y0 + s.height, y0);
                let drawn = s.draw(x0, y0);
                body += &match parted {
                    true => panels::mark(top, head + foot + 16.0, &drawn),
                    false => drawn,
                };
            }
            top += head + foot + 16.0;
        }
        let head = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" \
             height=\"{h}\" role=\"img\" aria-labelledby=\"{id}-title {id}-desc\" \
             style=\"max-width:100%;height:auto;font-family:{FACES}\">\n\
             <title id=\"{id}-title\">{title}</title>\n<desc id=\"{id}-desc\">{alt}</desc>\n",
            w = number(WIDTH),
            h = number(libm::ceil(top)),
            id = escape(self.id),
            title = escape(&self.title),
            alt = escape(&self.alt),
        );
        Ok(head + &body + "</svg>\n")
    }
}

impl Settled<'_> {
    fn head(&self) -> f64 {
        let title = if self.panel.title.is_empty() {
            0.0
        } else {
            28.0
        };
        title + if self.y.label.is_empty() { 8.0 } else { 28.0 }
    }

    fn foot(&self) -> f64 {
        let label = if self.x.label.is_empty() { 26.0 } else { 50.0 };
        label + KEY_LINE * self.key.len() as f64
    }

    fn draw(&self, x0: f64, y0: f64) -> String {
        let group = format!("<g fill=\"currentColor\" font-size=\"{TEXT_SIZE}\">\n");
        let mut out = String::new();
        if !self.panel.title.is_empty() {
            let at = y0 - self.head() + 16.0;
            out += &format!(
                "{group}{}</g>\n",
                text(x0 - 6.0, at, "start", &self.panel.title)
            );
        }
        out += &self.panel.draw(&self.x, &self.y);
        let mut below = y0 + self.height + self.foot() - KEY_LINE * self.key.len() as f64;
        for line in &self.key {
            below += KEY_LINE;
            for (at, sample, words) in line {
                out += &format!(
                    "<g transform=\"translate({} {})\" fill=\"currentColor\" \
                     font-size=\"{TEXT_SIZE}\" stroke-linecap=\"round\">\n{sample}{}</g>\n",
                    number(x0 + at),
                    number(below - 6.0),
                    text(KEY_SAMPLE, 0.0, "start", words)
                );
            }
        }
        out
    }
}

fn key_lines(entries: Vec<(String, String)>, room: f64) -> Vec<Vec<(f64, String, String)>> {
    let mut lines: Vec<Vec<(f64, String, String)>> = Vec::new();
    let mut at = f64::INFINITY;
    for (sample, words) in entries {
        let width = KEY_SAMPLE + width(&words, TEXT_SIZE);
        if at + width > room {
            lines.push(Vec::new());
            at = 0.0;
        }
        if let Some(line) = lines.last_mut() {
            line.push((at, sample, words));
        }
        at += width + 18.0;
    }
    lines
}

fn layout(parameter: &'static str, allowed: &'static str, value: usize) -> FigureError {
    FigureError::Layout {
        parameter,
        allowed,
        value: value as f64,
    }
}

#[test]
fn a_caption_says_what_is_computed_or_there_is_no_figure() {
    let drawn = |caption: &str, word: &str, is: usize| {
        let line = Curve::new([[0.0, 0.0], [1.0, 2.0]])
            .dotted()
            .key("solved for");
        let panel = Panel::new(Axis::linear("x"), Axis::linear("y")).curve(line);
        let plot = Plot::new("a", "A")
            .caption(caption)
            .alt("It {{falls|rises}}.")
            .panel(panel);
        plot.says([word], is).figure(Table::new(&["x"]))
    };
    let figure = drawn("{{line solved}}: {{falls|rises}}", "falls|rises", 1).unwrap();
    assert_eq!([figure.caption, figure.alt], ["dotted: rises", "It rises."]);
    assert!(figure.svg.contains("It rises."));
    for (caption, word, is) in [
        // None of the words; nowhere; open; no such line.
        ("", "falls|rises", 2),
        ("", "grows", 0),
        ("{{grows}}", "falls|rises", 0),
        ("{{line found}}", "falls|rises", 0),
    ] {
        let unsaid = drawn(caption, word, is);
        assert!(
            matches!(unsaid, Err(FigureError::Unsaid { figure: "a", .. })),
            "{caption}"
        );
    }
}
