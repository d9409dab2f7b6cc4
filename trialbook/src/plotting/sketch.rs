//! Marks as SVG, and room for their labels.

use super::{
    axes::{self, Scale, TEXT_SIZE, text},
    labels::{Canvas, anchors, around},
    marks::{Area, Curve, Label, Marker, Note, Points, Rule},
    path::{self, Frame, Place},
    raster::{BLANK, Raster},
    svg::{Colour, number},
    text::{markup, width},
};

/// How far a drawn curve may lie from its data, in units of the page.
const TOLERANCE: f64 = 0.08;

/// How much room there should be around the name of a region, or at least.
const MARGINS: [f64; 3] = [9.0, 6.0, 3.0];

struct Wanted<'a> {
    label: &'a Label,
    anchors: Vec<(Place, f64)>,
    colour: Colour,
    owner: u16,
}

struct Region<'a> {
    raster: &'a Raster,
    class: usize,
    at: Place,
}

pub(super) struct Sketch<'a> {
    x: &'a Scale,
    y: &'a Scale,
    frame: Frame,
    canvas: Canvas,
    below: String,
    above: String,
    words: String,
    regions: Vec<Region<'a>>,
    wanted: Vec<Wanted<'a>>,
}

impl<'a> Sketch<'a> {
    pub(super) fn new(x: &'a Scale, y: &'a Scale) -> Self {
        let frame = Frame {
            left: x.pixels.0,
            right: x.pixels.1,
            top: y.pixels.1,
            bottom: y.pixels.0,
        };
        Sketch {
            x,
            y,
            frame,
            canvas: Canvas::new(frame),
            below: String::new(),
            above: String::new(),
            words: String::new(),
            regions: Vec::new(),
            wanted: Vec::new(),
        }
    }

    fn place(&self, p: &[f64; 2]) -> Place {
        [self.x.at(p[0]), self.y.at(p[1])]
    }

    pub(super) fn curve(&mut self, curve: &'a Curve, points: &[[f64; 2]], owner: u16) {
        let points: Vec<Place> = points.iter().map(|p| self.place(p)).collect();
        let pieces: Vec<Vec<Place>> = path::clip(&points, &self.frame.grown(0.01))
            .iter()
            .map(|piece| path::simplify(piece, TOLERANCE))
            .collect();
        if pieces.is_empty() {
            return;
        }
        self.above += &stroke(curve, &path::data(&pieces));
        self.canvas.lines(&pieces, owner);
        for &fraction in &curve.arrows {
            if let Some((at, direction)) = path::along(&pieces, fraction) {
                self.above += &fill(&arrow(at, direction), curve.colour, 1.0);
                self.canvas.take(around(at, [4.0; 2]), owner);
            }
        }
        if let Some(label) = &curve.label {
            self.wanted.push(Wanted {
                label,
                anchors: anchors(&pieces, label.at),
                colour: curve.colour,
                owner,
            });
        }
    }

    pub(super) fn rule(&mut self, rule: &'a Rule, owner: u16) {
        let points = if rule.horizontal {
            [self.x.from, self.x.to].map(|end| [end, rule.at])
        } else {
            [self.y.from, self.y.to].map(|end| [rule.at, end])
        };
        self.curve(&rule.line, &points, owner);
    }

    pub(super) fn points(&mut self, points: &'a Points, owner: u16) {
        let mut places: Vec<Place> = points.points.iter().map(|p| self.place(p)).collect();
        places.retain(|&p| self.frame.grown(0.01).contains(p));
        self.above += &marker(points, &places);
        for &p in &places {
            self.canvas.take(around(p, [points.size; 2]), owner);
        }
        if let (Some(label), Some(&last)) = (&points.label, places.last()) {
            self.wanted.push(Wanted {
                label,
                anchors: vec![(last, 0.0)],
                colour: points.colour,
                owner,
            });
        }
    }

    pub(super) fn area(&mut self, area: &Area) {
        let corners: Vec<Place> = area.points.iter().map(|p| self.place(p)).collect();
        let corners = path::clip_polygon(&corners, &self.frame);
        let data = path::data(&[path::simplify(&corners, TOLERANCE)]);
        if !data.is_empty() {
            self.below += &fill(&format!("{data}z"), area.colour, area.opacity);
        }
    }

    pub(super) fn raster(&mut self, raster: &'a Raster) {
        let cells = cells(raster, self.x, self.y);
        let corners = [[raster.x.0, raster.y.0], [raster.x.1, raster.y.1]];
        if corners
            .iter()
            .all(|p| self.frame.grown(0.01).contains(self.place(p)))
        {
            self.below += &cells;
        } else {
            let [x, y] = [self.frame.left, self.frame.top].map(number);
            let [w, h] = [
                self.frame.right - self.frame.left,
                self.frame.bottom - self.frame.top,
            ]
            .map(number);
            // An inner drawing of its own size cuts off what lies outside.
            self.below.push_str(&format!(
                "<svg x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" \
                 viewBox=\"{x} {y} {w} {h}\" overflow=\"hidden\">\n{cells}</svg>\n"
            ));
        }
        for class in 0..raster.classes.len() {
            let at = inside(raster, class, self.x, self.y);
            if let Some(at) = at.filter(|&at| self.frame.contains(at)) {
                self.regions.push(Region { raster, class, at });
            }
        }
    }

    /// As near to the middle of its largest square as is off all curves.
    fn name(&mut self, region: &Region) -> String {
        let words = &region.raster.classes[region.class].label;
        let free = |at: &Place, margin: f64| {
            let room = room(*at, words).grown(margin);
            self.frame.contains([room.left, room.top])
                && self.frame.contains([room.right, room.bottom])
                && self.canvas.is_free(room)
                && covers(region.raster, region.class, &room, self.x, self.y)
        };
        let off = |at: &Place| libm::hypot(at[0] - region.at[0], at[1] - region.at[1]);
        let steps = || (-40..=40).map(|k| 4.0 * f64::from(k));
        let nearest = |margin: f64| {
            steps()
                .flat_map(|dx| steps().map(move |dy| [region.at[0] + dx, region.at[1] + dy]))
                .filter(|at| free(at, margin))
                .min_by(|a, b| off(a).total_cmp(&off(b)))
        };
        let at = MARGINS.into_iter().find_map(nearest).unwrap_or(region.at);
        self.canvas.take(room(at, words), u16::MAX);
        label(at, words, Colour::Ink)
    }

    pub(super) fn note(&mut self, note: &Note) {
        let at = self.place(&note.at);
        if self.frame.contains(at) {
            self.words += &text(at[0], at[1] + 5.0, "middle", &note.text);
            self.canvas.take(room(at, &note.text), u16::MAX);
        }
    }

    pub(super) fn finish(mut self) -> String {
        let regions = std::mem::take(&mut self.regions);
        let mut labels: String = regions.iter().map(|region| self.name(region)).collect();
        for wanted in &self.wanted {
            let words = &wanted.label.text;
            if let Some(at) = self.canvas.place(words, &wanted.anchors, wanted.owner) {
                labels += &label(at, words, wanted.colour);
            }
        }
        let group = |attributes: &str, content: &str| {
            if content.is_empty() {
                return String::new();
            }
            format!("<g {attributes}>\n{content}</g>\n")
        };
        let round = "stroke-linecap=\"round\" stroke-linejoin=\"round\"";
        let ink = format!("fill=\"currentColor\" font-size=\"{TEXT_SIZE}\"");
        // A rim in the page's colour, where the page names it, lifts labels off what they touch.
        let rimmed = format!(
            "font-size=\"{TEXT_SIZE}\" text-anchor=\"middle\" style=\"paint-order:stroke;\
             stroke:var(--bg, none);stroke-width:3px;stroke-linejoin:round\""
        );
        self.below
            + &axes::frame(self.x, self.y)
            + &group(round, &self.above)
            + &group(&ink, &self.words)
            + &group(&rimmed, &labels)
    }
}

fn label(at: Place, words: &str, colour: Colour) -> String {
    format!(
        "<text x=\"{}\" y=\"{}\" style=\"fill:{}\">{}</text>\n",
        number(at[0]),
        number(at[1] + 5.0),
        colour.css(),
        markup(words)
    )
}

fn arrow(at: Place, [dx, dy]: Place) -> String {
    let corner = |ahead: f64, aside: f64| {
        let p = [
            at[0] + ahead * dx - aside * dy,
            at[1] + ahead * dy + aside * dx,
        ];
        format!("{} {}", number(p[0]), number(p[1]))
    };
    format!(
        "M{}L{} {}z",
        corner(5.0, 0.0),
        corner(-4.5, 3.8),
        corner(-4.5, -3.8)
    )
}

pub(super) fn stroke(curve: &Curve, data: &str) -> String {
    let pattern = curve
        .stroke
        .pattern()
        .map_or(String::new(), |p| format!(" stroke-dasharray=\"{p}\""));
    format!(
        "<path d=\"{data}\" fill=\"none\" style=\"stroke:{}\" stroke-width=\"{}\"{pattern}/>\n",
        curve.colour.css(),
        number(curve.width)
    )
}

fn fill(data: &str, colour: Colour, opacity: f64) -> String {
    let opacity = match number(opacity).as_str() {
        "1" => String::new(),
        value => format!(" fill-opacity=\"{value}\""),
    };
    format!(
        "<path d=\"{data}\" style=\"fill:{}\"{opacity}/>\n",
        colour.css()
    )
}

pub(super) fn sample(colour: Colour, opacity: f64) -> String {
    fill("M4 -12h22v14h-22z", colour, opacity)
}

pub(super) fn marker(points: &Points, places: &[Place]) -> String {
    if places.is_empty() {
        return String::new();
    }
    let r = points.size;
    let shape = match points.marker {
        Marker::Disc | Marker::Circle => format!(
            "m-{0} 0a{0} {0} 0 1 0 {1} 0a{0} {0} 0 1 0 -{1} 0z",
            number(r),
            number(2.0 * r)
        ),
        Marker::Square => format!("m-{0} -{0}h{1}v{1}h-{1}z", number(0.9 * r), number(1.8 * r)),
        Marker::Triangle => {
            let [top, across, down, base] = [1.2, 1.1, 1.9, 2.2].map(|part| number(part * r));
            format!("m0 -{top}l{across} {down}h-{base}z")
        }
        Marker::Cross => format!(
            "m-{0} -{0}l{1} {1}m0 -{1}l-{1} {1}",
            number(r),
            number(2.0 * r)
        ),
    };
    let data: String = places
        .iter()
        .map(|p| format!("M{} {}{shape}", number(p[0]), number(p[1])))
        .collect();
    if matches!(points.marker, Marker::Disc | Marker::Square) {
        fill(&data, points.colour, 1.0)
    } else {
        format!(
            "<path d=\"{data}\" fill=\"none\" style=\"stroke:{}\" stroke-width=\"1.6\"/>\n",
            points.colour.css()
        )
    }
}

fn cells(raster: &Raster, x: &Scale, y: &Scale) -> String {
    let ([left, bottom], [across, upwards]) = cell(raster, x, y);
    let paths: String = raster
        .classes
        .iter()
        .zip(0..BLANK)
        .map(|(class, n)| (class, raster.outline(n)))
        .filter(|(_, data)| !data.is_empty())
        .map(|(class, data)| fill(&data, class.colour, class.opacity))
        .collect();
    format!(
        "<g transform=\"matrix({:.6} 0 0 {:.6} {} {})\" fill-rule=\"evenodd\" \
         shape-rendering=\"crispEdges\">\n{paths}</g>\n",
        across,
        upwards,
        number(left),
        number(bottom)
    )
}

fn cell(raster: &Raster, x: &Scale, y: &Scale) -> (Place, Place) {
    let (columns, rows) = raster.shape();
    let (left, right) = (x.at(raster.x.0), x.at(raster.x.1));
    let (bottom, top) = (y.at(raster.y.0), y.at(raster.y.1));
    let sides = [
        (right - left) / columns as f64,
        (top - bottom) / rows as f64,
    ];
    ([left, bottom], sides)
}

pub(super) fn inside(raster: &Raster, class: usize, x: &Scale, y: &Scale) -> Option<Place> {
    let label = &raster.classes.get(class)?.label;
    let number = u8::try_from(class).ok().filter(|&n| n != BLANK)?;
    let (i, j, side) = raster.largest_square(number)?;
    let ([left, bottom], cell) = cell(raster, x, y);
    let half = side as f64 / 2.0;
    let at = [
        left + (i as f64 + half) * cell[0],
        bottom + (j as f64 + half) * cell[1],
    ];
    let room = [2.0 * half * cell[0].abs(), 2.0 * half * cell[1].abs()];
    let fits = width(label, TEXT_SIZE) + 6.0 <= room[0] && 1.4 * TEXT_SIZE <= room[1];
    (fits && !label.is_empty()).then_some(at)
}

fn covers(raster: &Raster, class: usize, room: &Frame, x: &Scale, y: &Scale) -> bool {
    let (columns, rows) = raster.shape();
    let cell = |at: f64, (from, to): (f64, f64), count: usize| {
        libm::floor((at - from) / (to - from) * count as f64) as i64
    };
    let across = (x.at(raster.x.0), x.at(raster.x.1));
    let upwards = (y.at(raster.y.0), y.at(raster.y.1));
    let [left, right] = [room.left, room.right].map(|at| cell(at, across, columns));
    let [bottom, top] = [room.bottom, room.top].map(|at| cell(at, upwards, rows));
    (left..=right).all(|i| (bottom..=top).all(|j| raster.class_at(i, j) == Some(class)))
}

fn room(at: Place, words: &str) -> Frame {
    let width = width(words, TEXT_SIZE);
    let left = at[0] - width / 2.0;
    Frame {
        left,
        right: left + width,
        top: at[1] - 0.6 * TEXT_SIZE,
        bottom: at[1] + 0.6 * TEXT_SIZE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plotting::{axes::Axis, panel::Panel};

    #[test]
    fn the_name_of_a_region_stands_off_its_edges() {
        let side = 120;
        let right_of_the_wedge = |k: usize| u8::from(4 * (k % side) >= k / side);
        let cells = (0..side * side).map(right_of_the_wedge).collect();
        let raster = Raster::new(side, side, (0.0, 1.0), (0.0, 1.0), cells).unwrap();
        let raster = raster.class("75 to 100 %", 0, 0.8).class("", 1, 0.2);
        let axis = |label: &str| Axis::linear(label).range(0.0, 1.0);
        let panel = Panel::new(axis("x"), axis("y")).raster(raster.clone());
        let (mut x, mut y) = panel.settle(440.0).unwrap();
        (x.pixels, y.pixels) = ((40.0, 480.0), (460.0, 20.0));
        let mut sketch = Sketch::new(&x, &y);
        sketch.raster(&raster);
        let region = sketch.regions.pop().unwrap();
        let drawn = sketch.name(&region);
        let number = |key: &str| -> f64 {
            let after = drawn.split_once(&format!(" {key}=\"")).unwrap().1;
            after.split_once('"').unwrap().0.parse().unwrap()
        };
        // The base line is a little below the middle.
        let at = [number("x"), number("y") - 5.0];
        let around = room(at, "75 to 100 %").grown(5.0);
        assert!(covers(&raster, 0, &around, &x, &y), "{drawn}");
    }
}
