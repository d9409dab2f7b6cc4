//! Captions, and what they say to those who do not see the figure, tried on the numbers of the figure.

use super::{
    choices::Held,
    data::{Data, FIGURES, column, falls, peak, rises, steepens},
    numbers::decimals,
    text::words,
};
use slipbook::claims::{PAPER, periodic::drawn::ETA};
use slipbook::motion::turntable::{Fate, Start, fate};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// A figure; words of its caption or of its alternative in words, in braces first what is right and then what is not; and whether its
/// numbers are so.
type Tried = (&'static str, &'static [&'static str], fn(&Data) -> bool);

macro_rules! tried {
    ($($figure:literal: $($words:literal),+ => $holds:expr;)*) => {
        const TRIED: &[Tried] = &[$(($figure, &[$($words),+], $holds)),*];
    };
}

tried! {
    "constant-stopping-time": "longest when the particle starts {along|against} the inertial" => |data| {
        data.groups().iter().all(|(_, rows)| peak(rows, 1, 2)[0] == 0.0)
    };
    "constant-stopping-time": "{fall|rise} from the initial angle zero", "the {higher|lower} and the steeper the closer", "and the {steeper|flatter} the closer"
        => |data| {
        let groups = data.groups();
        let drop = |rows: &[Vec<f64>]| rows[0][2] - rows[rows.len() - 1][2];
        groups.iter().all(|(_, rows)| falls(&column(rows, 2)) && rises(&column(rows, 1)))
            && groups.windows(2).all(|two| {
                let ([a, b], closer) = ([&two[0].1, &two[1].1], two[0].1[0][0] < two[1].1[0][0]);
                closer && a[0][2] > b[0][2] && drop(a) > drop(b)
            })
    };
    "anisotropic-drift": "drift lies in the corner of {large|small} q", "and {small|large} λ₀", "the {fastest|slowest} drift"
        => |data| {
        let rows = data.rows();
        let corner = |row: &[f64]| row[1] == rows[0][1] && rows.iter().all(|other| other[0] <= row[0]);
        rows.iter().max_by(|a, b| a[2].total_cmp(&b[2])).is_some_and(|row| corner(row))
    };
    "anisotropic-drift": "surround a place at q = {1|2}, λ₀ = {0.45|0.5}" => |data| {
        let most = data.rows().into_iter().max_by(|a, b| a[3].total_cmp(&b[3])).unwrap();
        (most[0] - 1.0).abs() <= 0.05 && (most[1] - 0.45).abs() <= 0.015
    };
    "turntable-following": "settle at about {1.41|1.4}" => |data| (data.rows().last().unwrap()[4] - 1.41).abs() <= 0.005;
    "escape-residual": "they {fall|rise} along straight" => |data| {
        data.groups().iter().all(|(_, rows)| {
            let slope = |a: &[f64], b: &[f64]| (b[2] - a[2]) / (b[1] / a[1]).ln();
            let late = &rows[rows.len() - 40..];
            let slopes = late.windows(2).map(|two| slope(&two[0], &two[1]));
            slopes.into_iter().all(|slope| (slope + 1.5 * SQRT_2).abs() < 0.01)
        })
    };
    "rest-basin": "{ends in a tip that follows|passes} the dotted line" => |data| {
        // The farthest cells at rest move nearly with the table.
        let across = data.groups().pop().unwrap().1;
        let far = across.iter().filter(|row| row[3] == 1.0 && row[1] > 0.96);
        across.iter().all(|row| row[3] == 0.0 || row[1] < 1.0)
            && far.clone().count() > 0
            && far.clone().all(|row| (row[2] - row[1]).abs() < 0.1)
    };
    "rest-turning": "falls more {slowly|quickly} than the speed" => |data| {
        let groups = data.groups();
        let slope = |(_, rows): &(String, Vec<Vec<f64>>)| {
            let [a, b] = [&rows[rows.len() - 2], &rows[rows.len() - 1]];
            (b[3] / a[3]).ln() / (b[2] / a[2]).ln()
        };
        let slopes: Vec<f64> = groups.iter().map(slope).collect();
        slopes[0] < 0.5 && slopes[1..4].iter().all(|slope| (slope - 1.0).abs() < 0.1)
    };
    "rest-turning": "stop with §, moving {outwards|inwards}" => |data| {
        let groups = data.groups();
        let (straight, others) = groups.split_last().unwrap();
        let end = |rows: &[Vec<f64>]| rows[rows.len() - 1][3];
        others.iter().all(|(_, rows)| end(rows) < 0.3 * rows[0][3]) && end(&straight.1) > 3.0
    };
    "sinusoidal-rest": "it {grows|falls} from zero" => |data| {
        let share = column(&data.rows(), 1);
        let moving: Vec<f64> = share.iter().copied().filter(|s| *s > 0.0 && *s < 1.0).collect();
        share[0] == 0.0 && rises(&moving)
    };
    "sinusoidal-rest": "then {rises|falls}, ever more steeply", "ever {more|less} steeply to one" => |data| {
        let rows = data.rows();
        let moving: Vec<_> = rows.iter().filter(|r| r[1] > 0.0 && r[0] < 1.0).cloned().collect();
        let end = rows.iter().find(|row| row[0] >= 1.0);
        steepens(&moving, 0, 1) && end.is_some_and(|row| (row[1] - 1.0).abs() < 1e-9)
    };
    "sinusoidal-family": "the humps {shrink|grow} and peak earlier", "and peak {earlier|later}" => |data| {
        let peaks: Vec<[f64; 2]> = data.groups().iter().map(|(_, rows)| peak(rows, 1, 2)).collect();
        falls(&peaks.iter().map(|p| p[1]).collect::<Vec<_>>()) && falls(&peaks.iter().map(|p| p[0]).collect::<Vec<_>>())
    };
    "sinusoidal-decay": "straight {rising|falling} lines", "the {steeper|flatter} the larger λ₀" => |data| {
        let groups = data.groups();
        let rate = |rows: &[Vec<f64>]| (rows[2][2] / rows[1][2]).ln();
        groups.iter().all(|(_, rows)| rises(&column(rows, 2)))
            && groups.windows(2).all(|two| rate(&two[0].1) < rate(&two[1].1) && two[0].1[0][0] < two[1].1[0][0])
    };
    "fig-2": "first {without rest, then with rests|with rests, then without rest}" => |data| {
        let rests = |rows: &[Vec<f64>]| rows.windows(2).any(|two| two[0][3] == 0.0 && two[1][3] == 0.0);
        let groups = data.groups();
        !rests(&groups[0].1) && rests(&groups[1].1)
    };
    "periodic-come-and-go": "{more|less} friction brings rests", "{brings rests, takes them away, and brings them|takes rests away, brings them, and takes them away} again"
        => |data| {
        let rests = |rows: &[Vec<f64>]| rows.iter().any(|row| row[3] == 0.0);
        let groups = data.groups();
        let seen: Vec<bool> = groups.iter().map(|(_, rows)| rests(rows)).collect();
        seen == [false, true, false, true] && groups.windows(2).all(|two| two[0].1[0][0] < two[1].1[0][0])
    };
    "periodic-rest-shares": "{above|below} it the share is" => |data| {
        let above: Vec<_> = data.rows().into_iter().filter(|row| row[1] > row[0] + 1e-9).collect();
        above.len() > 1000 && above.iter().all(|row| (row[2] - (1.0 - row[0] / row[1])).abs() < 1e-6)
    };
    "periodic-rest-shares": "{below|above} the diagonal there is no rest" => |data| {
        let below: Vec<_> = data.rows().into_iter().filter(|row| row[1] < row[0] - 1e-9).collect();
        below.len() > 1000 && below.iter().all(|row| row[2] < 1e-9)
    };
    "sphere-times": "on the {falling|rising} line" => |data| {
        data.rows().iter().all(|row| (row[1] * row[0] - 1.0).abs() < 1e-6)
    };
    "turntable-energy": "kinetic energy {falls|rises} to zero" => |data| {
        let kinetic = column(&data.rows(), 1);
        let slides = kinetic.iter().take_while(|k| **k > 0.0).count();
        falls(&kinetic[..=slides]) && kinetic[slides..].iter().all(|k| *k == 0.0)
    };
    "turntable-energy": "centrifugal energy {falls|rises} from zero" => |data| {
        let energy = column(&data.rows(), 2);
        energy.windows(2).all(|pair| pair[0] >= pair[1]) && energy[0] > energy[energy.len() - 1]
    };
    "turntable-following": "both {tend to|stay away from} §" => |data| {
        data.groups().iter().all(|(_, rows)| {
            let end = &rows[rows.len() - 1];
            [end[2], end[3]].iter().all(|psi| (psi - FRAC_PI_2).abs() < 3e-3) && (end[4] - SQRT_2).abs() < 0.05
        })
    };
    "rest-radius": "a curve {rises|falls} from the origin", "origin, ever {more|less} steeply" => |data| {
        data.groups().iter().all(|(_, rows)| {
            rows[0][1] == 0.0 && rows[0][2] == 0.0 && rises(&column(rows, 2)) && steepens(&rows[1..], 1, 2)
        })
    };
    "rest-boundary": "how far {below|above} § the boundary" => |data| {
        data.rows().iter().all(|row| row[2] < 1.0 && row[1].abs() < PI)
    };
    "turntable-paths": "both curve to the {right|left}", "the {slower|faster} one comes to rest" => |data| {
        let groups = data.groups();
        let turn = |p: &[Vec<f64>]| {
            let step = |i: usize, k: usize| p[i + 1][k] - p[i][k];
            step(0, 2) * step(1, 3) - step(0, 3) * step(1, 2)
        };
        let distance = |rows: &[Vec<f64>]| rows[rows.len() - 1][2].hypot(rows[rows.len() - 1][3]);
        let (slow, fast) = (&groups[0].1, &groups[1].1);
        slow[0][0] < fast[0][0]
            && [slow, fast].iter().all(|p| turn(p) < 0.0)
            && distance(slow) <= 1.0
            && distance(fast) > 1.0
    };
    "escape-paths": "first slide {backwards|forwards}" => |data| {
        let table: Vec<_> = data.0.iter().filter(|row| row[1] == "table").collect();
        let starts = table.iter().enumerate().filter(|(_, row)| row[2] == "0").map(|(i, _)| i);
        // The table turns counterclockwise: what stays behind goes towards negative y.
        starts.map(|i| table[i + 1][4].parse::<f64>().unwrap()).collect::<Vec<_>>().iter().all(|y| *y < 0.0)
    };
    "escape-fan": "carries the {inner|outer} ones along", "the {outer|inner} ones slide off" => |data| {
        let of = |fate: &str| {
            data.0.iter().filter(|row| row[1] == fate).map(|row| row[0].parse::<f64>().unwrap()).collect::<Vec<_>>()
        };
        let (rest, other): (Vec<f64>, Vec<f64>) =
            (of("rest"), data.0.iter().filter(|row| row[1] != "rest").map(|row| row[0].parse().unwrap()).collect());
        let largest = rest.iter().fold(0.0_f64, |a, b| a.max(*b));
        let smallest = other.iter().fold(f64::INFINITY, |a, b| a.min(*b));
        !rest.is_empty() && !other.is_empty() && largest < smallest
    };
    "constant-speed-angle": "speed first {falls|rises}, then", "then {rises|falls} for small λ", "and {falls|rises} to zero for λ", "for λ {above|below} 1"
        => |data| {
        data.groups().iter().all(|(_, rows)| {
            let (speed, lambda) = (column(rows, 2), rows[0][0]);
            let least = speed.iter().copied().fold(f64::INFINITY, f64::min);
            let end = speed[speed.len() - 1];
            let risen = lambda >= 1.0 || end > least;
            least < speed[0] && risen && (lambda <= 1.0 || end == 0.0)
        })
    };
    "constant-speed-angle": "angle {falls|rises} towards zero", "the {faster|slower} the larger λ" => |data| {
        let groups = data.groups();
        let soon = |rows: &[Vec<f64>]| rows.iter().find(|row| row[1] >= 0.4).map(|row| row[3]);
        let angles: Option<Vec<f64>> = groups.iter().map(|(_, rows)| soon(rows)).collect();
        groups.iter().all(|(_, rows)| falls(&column(rows, 3))) && angles.is_some_and(|a| falls(&a))
    };
    "turntable-energy": "the arc length {rises|falls}" => |data| {
        let s = column(&data.rows(), 3);
        s.windows(2).all(|pair| pair[0] <= pair[1]) && s[0] < s[s.len() - 1]
    };
    "turntable-following": "{above|below} the dotted line at 1" => |data| {
        let groups = data.groups();
        let end = |rows: &[Vec<f64>]| format!("{:.2}", rows[rows.len() - 1][4]);
        groups.len() == 3 && groups.iter().all(|(_, rows)| end(rows) == "1.41")
    };
    "sinusoidal-family": "for larger friction {lower|higher} humps", "humps that peak {earlier|later}" => |data| {
        let peaks: Vec<[f64; 2]> = data.groups().iter().map(|(_, rows)| peak(rows, 1, 2)).collect();
        peaks.windows(2).all(|two| two[0][0] > two[1][0] && two[0][1] > two[1][1])
    };
    "escape-compensated": "§ ({dashed|solid}) on their way", "corrected ones ({solid|dashed})" => |data| {
        let (printed, corrected) = (data.keys("printed: "), data.keys("corrected: "));
        let ends = data.groups().into_iter().map(|(_, rows)| rows[rows.len() - 1][3]);
        let settled = |(end, key): (f64, &(&str, bool))| (end - key.0.parse::<f64>().unwrap()).abs() < 1e-5;
        printed.len() == 2
            && printed.iter().all(|key| key.1)
            && corrected.iter().all(|key| !key.1)
            && ends.zip(&corrected).all(settled)
    };
    "escape-compensated": "corrected value, {above|below} the printed" => |data| {
        let number = |key: &(&str, bool)| key.0.parse::<f64>().unwrap();
        let (printed, corrected) = (data.keys("printed: "), data.keys("corrected: "));
        printed.len() == 2 && printed.iter().zip(&corrected).all(|(p, c)| number(p) < number(c))
    };
    "rest-census": "({solid|dashed|dotted}: by bisection" => |data| {
        let keys = data.keys("by bisection");
        !keys.is_empty() && keys.iter().all(|key| !key.1)
    };
    "rest-census": "envelope (147) ({dashed|solid|dotted})" => |data| {
        let keys = data.keys("(147)");
        !keys.is_empty() && keys.iter().all(|key| key.1)
    };
    "rest-fates": "{solid for rest and dashed for escape|dashed for rest and solid for escape}", "between them, just {above the solid|below the solid|above the dashed|below the dashed} one"
        => |data| {
        let of = |kind: &str| -> Vec<Vec<f64>> {
            let rows = data.0.iter().filter(|row| row[3].starts_with(kind));
            let numbers = |row: &Vec<String>| row[..3].iter().map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>();
            rows.map(numbers).collect()
        };
        let (rests, escapes) = (of("rest"), of("escape"));
        let height = |edge: &[Vec<f64>], at: &[f64]| {
            let ends = edge
                .windows(2)
                .find(|two| two[0][0] == at[0] && two[1][0] == at[0] && (two[0][1]..=two[1][1]).contains(&at[1]));
            let [from, to] = [0, 1].map(|i| &ends.unwrap()[i]);
            from[2] + (at[1] - from[1]) / (to[1] - from[1]) * (to[2] - from[2])
        };
        let dots = of("neither");
        dots.len() >= 5
            && dots.iter().all(|dot| {
                let above = dot[2] - height(&rests, dot);
                let below = height(&escapes, dot) - dot[2];
                0.0 < above && above < below
            })
    };
    "rest-fates": "the larger A, the {lower|higher}" => |data| {
        let rows = data.rows();
        let mut of = column(&rows, 0);
        of.dedup();
        of.sort_by(f64::total_cmp);
        of.dedup();
        let off = |row: &&Vec<f64>, psi: f64| (row[1] - psi).abs();
        let near = |a: f64, psi: f64| {
            let map = rows.iter().filter(|row| row[0] == a);
            map.min_by(|x, y| off(x, psi).total_cmp(&off(y, psi)))
        };
        [-3.0, -1.5, 0.0, 1.5, 3.0].iter().all(|psi| {
            let at = of.iter().map(|a| near(*a, *psi).unwrap()[2]);
            falls(&at.collect::<Vec<_>>())
        })
    };
    "rest-boundary": "at 1.4, {above|below} all" => |data| {
        format!("{SQRT_2:.1}") == "1.4" && data.rows().iter().all(|row| (1.0 - row[2]) / row[0] < SQRT_2)
    };
    "fig-5": "all lie {below|above} C", "and {beyond|before} Y" => |data| {
        let wrong: Vec<_> = data.0.iter().filter(|row| row[0].contains("wrong")).collect();
        let number = |cell: &String| cell.parse::<f64>().unwrap();
        let beyond = |row: &&Vec<String>| {
            number(&row[1]) > 4.603 && (number(&row[1]) - 1.0 / 60.0) * (number(&row[2]) - 0.7 / 180.0) < 1.0
        };
        !wrong.is_empty() && wrong.iter().all(beyond)
    };
    "fig-6": "II: {forwards, at once backwards, rest|a rest after either|forwards and rest}", "III: {a rest after either|forwards, at once backwards, rest|forwards and rest}", "IV: {forwards and rest|a rest after either|forwards, at once backwards, rest}"
        => |data| {
        let groups = data.groups();
        let manner = |i: usize| manner(&column(&groups[i].1, 4));
        let of = [0, 1, 2, 3, 4].map(manner);
        let once = |kind: &str| "+-0".chars().all(|sign| kind.contains(sign));
        !of[0].contains('0')
            && (once(&of[1]) && of[1].contains("+-0") && !of[1].contains("+0"))
            && (once(&of[2]) && !of[2].contains("+-") && !of[2].contains("-+"))
            && (of[3].contains("+0+") && !of[3].contains('-'))
            && of[4] == "0"
    };
    "periodic-pulses": "next pulse comes {before|after} the particle has stopped" => |data| {
        let before_the_next = |rows: &[Vec<f64>]| {
            let before = rows.iter().rfind(|row| row[1] < PI - 1e-2);
            before.unwrap()[3]
        };
        let groups = data.groups();
        let [weak, strong] = [0, 1].map(|i| &groups[i].1);
        weak[0][0] < ETA && ETA < strong[0][0] && before_the_next(weak) > 0.0 && before_the_next(strong) == 0.0
    };
    "sinusoidal-rest": "as a {square root|square|cube root} does" => |data| {
        let rows = data.rows();
        let near: Vec<_> = rows
            .iter()
            .filter(|row| (0.9..0.999).contains(&row[0]))
            .map(|row| (1.0 - row[1]) / (1.0 - row[0]).sqrt())
            .collect();
        let [first, last] = [near[0], near[near.len() - 1]];
        near.len() > 5 && (first / last - 1.0).abs() < 0.1
    };
    "escape-paths": "comes to rest there and rides in a {circle|straight line}" => |data| {
        let rests = &data.0[0][0];
        let room = data.0.iter().filter(|row| &row[0] == rests && row[1] != "table");
        let place = |row: &Vec<String>| [3, 4].map(|i| row[i].parse::<f64>().unwrap());
        let places: Vec<_> = room.map(place).collect();
        let (from, to) = (places[places.len() - 20], places[places.len() - 1]);
        let distance = |[x, y]: [f64; 2]| x.hypot(y);
        (distance(from) - distance(to)).abs() < 1e-6 && distance([to[0] - from[0], to[1] - from[1]]) > 0.1
    };
    "rest-space": "comes to rest {inside|outside} its line", "its line ({solid|dashed|dotted}" => |data| {
        let lines = data.0.iter().filter(|row| row[0] == "boundary");
        let numbers = |row: &Vec<String>| [1, 2, 3].map(|i| row[i].parse::<f64>().unwrap());
        let rests = |a, alpha, psi| {
            let start = Start::hyperbolic(a, alpha, psi).unwrap();
            matches!(fate(&start).unwrap(), Fate::Rest { .. })
        };
        let mut lines = lines.map(numbers).step_by(25).peekable();
        lines.peek().is_some() && lines.all(|[a, alpha, psi]| rests(a, 0.9 * alpha, psi) && !rests(a, 1.1 * alpha, psi))
    };
    "rest-basin": "on the {dotted|dashed|solid} line the particle moves with", "stays there as {long as §|soon as §}"
        => |data| {
        // Of those that start along the motion of the table.
        let along = data.groups().pop().unwrap().1;
        let line = |speed: f64, reach: f64| {
            let near = |row: &&Vec<f64>| (row[2] - speed * row[1]).abs() < 0.02 && (row[1] - reach).abs() < 0.06;
            let near: Vec<_> = along.iter().filter(near).collect();
            !near.is_empty() && near.iter().all(|row| row[3] == 1.0)
        };
        line(1.0, 0.93) && !line(1.0, 1.1) && !line(0.0, 0.93)
    };
}

/// The signs of a velocity one after the other: + and - for to and fro, 0 for a rest.
fn manner(w: &[f64]) -> String {
    let sign = |w: &f64| match w {
        w if *w > 1e-9 => '+',
        w if *w < -1e-9 => '-',
        _ => '0',
    };
    let signs: Vec<char> = w.iter().map(sign).collect();
    // A passage is no rest.
    let lasting = signs.windows(2).filter(|two| two[0] == two[1]);
    let mut lasting: Vec<char> = lasting.map(|two| two[0]).collect();
    lasting.dedup();
    lasting.into_iter().collect()
}

#[test]
fn what_a_caption_says_of_its_numbers_is_so() {
    let mut held = Held::default();
    for (id, all, holds) in TRIED {
        let figure = FIGURES.iter().find(|figure| figure.id == *id);
        let figure = figure.unwrap_or_else(|| panic!("there is no figure {id}"));
        let text = words(&format!("{} | {}", figure.caption, figure.alt));
        let holds = holds(&Data::of(figure));
        for pattern in *all {
            held.hold(id, &text, pattern, |choice| (choice == 0) == holds);
        }
    }
    held.end();
}

#[test]
fn a_figure_of_the_paper_names_no_other() {
    let mut named = 0;
    for figure in FIGURES.iter() {
        let Some(number) = figure.id.strip_prefix("fig-") else {
            continue;
        };
        let others = figure
            .caption
            .split("the paper's Figure ")
            .skip(1)
            .filter_map(|rest| rest.split(|c: char| !c.is_ascii_digit()).next());
        for other in others {
            assert_eq!(other, number, "{}", figure.id);
            named += 1;
        }
    }
    assert!(named > 0);
}

#[test]
fn every_decimal_in_a_caption_is_one_of_its_numbers() {
    let mut failures = Vec::new();
    for figure in FIGURES.iter() {
        let mut known: Vec<f64> = Data::of(figure).rows().concat();
        // What the paper gives a name, and what has one.
        known.extend(PAPER.values().filter_map(|value| value.number().ok()));
        known.extend([2.0, SQRT_2, PI, 4.0 * PI]);
        let drawn = words(&figure.svg.replace("</", " </"));
        for number in decimals(&format!("{} {}", figure.caption, figure.alt)) {
            let places = number.len() - number.find('.').unwrap() - 1;
            let is = |value: &f64| format!("{:.places$}", value.abs()) == number;
            if !known.iter().any(is) && !drawn.iter().any(|word| word.text == number) {
                failures.push(format!("{}: {number}", figure.id));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
