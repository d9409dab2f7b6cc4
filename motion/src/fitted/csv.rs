//! The text of a CSV file as rows of numbers: every cell is read right, or its line is refused.

use super::{FitError, LARGEST};

/// Where t, A_x and A_y stand.
type Columns = (usize, [Option<usize>; 2]);

/// The rows; their times rise.
pub(super) fn rows(text: &str) -> Result<Vec<(f64, [f64; 2])>, FitError> {
    let passed = |line: &str| line.trim().is_empty() || line.starts_with('#');
    let mut lines = (1..)
        .zip(text.trim_start_matches('\u{feff}').lines())
        .filter(|(_, line)| !passed(line))
        .peekable();
    let first = lines.peek().map_or("", |(_, line)| line);
    // A spreadsheet's word for its separator.
    let stated = first.trim_matches('"').strip_prefix("sep=");
    let stated = lines.next_if(|_| stated.is_some()).and(stated);
    let separator = stated.and_then(|rest| rest.chars().next()).or_else(|| {
        let parts = |c: &char| cells(first, *c).len() > 1;
        [';', '\t', ','].into_iter().find(parts)
    });
    let separator = separator.unwrap_or(' ');
    let words = |line: &str| {
        let cells = cells(line, separator);
        cells.iter().all(|cell| parsed(cell).is_none()) && !cells.concat().is_empty()
    };
    let Some(&(number, first)) = lines.peek() else {
        return Ok(Vec::new());
    };
    let refuse = |line, text: &str, why| FitError::Line {
        line,
        text: text.to_owned(),
        why,
    };
    let count = cells(first, separator).len();
    let mut heads = Vec::new();
    while heads.len() < 2
        && let Some((_, line)) = lines.next_if(|(_, line)| words(line))
    {
        heads.push(cells(line, separator));
    }
    let (time, axes) = columns(&heads, count).map_err(|why| refuse(number, first, why))?;
    let mut rows: Vec<(f64, [f64; 2])> = Vec::new();
    let mut sign = None;
    for (n, line) in lines {
        let cells = cells(line, separator);
        let mut read = |i: usize| read(cells[i], separator, &mut sign);
        let mut row = || {
            if cells.len() != count {
                return Err("every line needs as many cells as the first");
            }
            let t = read(time)?;
            if rows.last().is_some_and(|(before, _)| *before >= t) {
                return Err("its time is not after the one before");
            }
            let [x, y] = axes.map(|axis| axis.map_or(Ok(0.0), &mut read));
            Ok((t, [x?, y?]))
        };
        let row = row().map_err(|why| refuse(n, line, why))?;
        rows.push(row);
    }
    if separator == ',' && count == 3 && heads.is_empty() && stated.is_none() && sign.is_none() {
        let why = "without a decimal point in the file a comma may be the decimal sign: give the columns a head";
        return Err(refuse(number, first, why));
    }
    Ok(rows)
}

/// The cells of a line, without their quotes. Spaces separate however many they are.
fn cells(line: &str, separator: char) -> Vec<&str> {
    let mut quoted = false;
    line.split(|c| {
        quoted ^= c == '"';
        c == separator && !quoted
    })
    .map(|cell| cell.trim().trim_matches('"').trim())
    .filter(|cell| separator != ' ' || !cell.is_empty())
    .collect()
}

fn parsed(cell: &str) -> Option<f64> {
    cell.replace(',', ".").replace('−', "-").parse().ok()
}

/// A number, with the decimal sign of the file.
fn read(cell: &str, separator: char, sign: &mut Option<char>) -> Result<f64, &'static str> {
    for c in cell.chars().filter(|c| matches!(c, '.' | ',')) {
        if c == separator || *sign.get_or_insert(c) != c {
            return Err("its decimal sign is not the only one");
        }
    }
    let number = parsed(cell).filter(|x| x.abs() <= LARGEST);
    number.ok_or("a cell is empty or no finite number")
}

/// Finds the columns: by the names in the head and, if there is one, the line of units below.
fn columns(heads: &[Vec<&str>], count: usize) -> Result<Columns, &'static str> {
    let Some(names) = heads.first() else {
        return match count {
            2 => Ok((0, [Some(1), None])),
            3 => Ok((0, [Some(1), Some(2)])),
            _ => Err("without a head a row is a time and one or two numbers"),
        };
    };
    let mut units = Vec::new();
    let (mut times, mut others) = (Vec::new(), Vec::new());
    let mut axes: [Vec<usize>; 3] = Default::default();
    for (i, name) in names.iter().enumerate() {
        let name = name.to_lowercase();
        let (name, mut unit) = name.rsplit_once(['(', '[']).unwrap_or((&name, ""));
        let apart = |c: char| !c.is_alphanumeric();
        let mut words: Vec<_> = name.split(apart).filter(|word| !word.is_empty()).collect();
        let last = |word: &mut &str| {
            matches!(
                *word,
                "s" | "ms" | "us" | "µs" | "μs" | "ns" | "min" | "g" | "mg"
            )
        };
        if words.len() > 1
            && let Some(last) = words.pop_if(last)
        {
            unit = last;
        }
        if let Some(below) = heads.get(1) {
            unit = below
                .get(i)
                .ok_or("both lines of the head need as many cells")?;
        }
        let unit = unit.replace([' ', '^', '*', '·', '(', ')', '[', ']'], "");
        let along = |axis: char| {
            let named = |word: &&str| {
                word.strip_suffix(axis)
                    .is_some_and(|rest| "acceleration".starts_with(rest))
            };
            words.iter().any(named)
        };
        if matches!(words[..], ["t" | "time"]) || words.contains(&"seconds") || unit == "s" {
            times.push(i);
        } else if let Some(axis) = ['x', 'y', 'z'].into_iter().position(along) {
            axes[axis].push(i);
        } else {
            others.push(i);
        }
        units.push(unit);
    }
    let [time] = times[..] else {
        return Err("of the heads one has to be t or time, or have the unit s");
    };
    let axes = match (&axes.each_ref().map(|list| &list[..]), &others[..]) {
        ([[], [], []], [one]) => [Some(*one), None],
        ([[x], [], _], _) => [Some(*x), None],
        ([[], [y], _], _) => [None, Some(*y)],
        ([[x], [y], _], _) => [Some(*x), Some(*y)],
        _ => return Err("of the heads one has to name x, or one y, or one each"),
    };
    let fit = |i: usize| {
        matches!(
            &units[i][..],
            "" | "m/s2" | "m/s²" | "m/s/s" | "ms-2" | "ms⁻²"
        )
    };
    if matches!(&units[time][..], "" | "s") && axes.into_iter().flatten().all(fit) {
        Ok((time, axes))
    } else {
        Err("the units have to be s and m/s^2")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DATA: [(f64, [f64; 2]); 3] = [
        (0.0, [0.5, -0.1]),
        (10.0, [0.51, 0.0]),
        (20.0, [-1.5, 2e-3]),
    ];

    #[test]
    fn a_file_is_read_right_however_it_is_written() {
        for text in [
            "t,ax,ay\n0,0.5,-0.1\n10,0.51,0\n20,-1.5,2e-3\n",
            "0,0.5,-0.1\r\n10,0.51,0\r\n\r\n20,-1.5,2E-3",
            "\u{feff}# made by hand\n0 0.5   -0.1\n10 0.51 0\n20 -1.5 0.002\n",
            "sep=;\nt; a_x; a_y\n0;0,5;−0,1\n10;0,51;0\n20;−1,5;2E-3\n",
            "sep=\t\r\n\"t\"\t\"ax\"\t\"ay\"\r\n\"0,0\"\t\"0,50\"\t\"-0,1\"\r\n10\t,51\t0\r\n20\t-1,5\t,002\r\n",
            "Zeit,y,x,Temperatur\ns,m/s²,m/s^2,K\n0,-0.1,0.5,\n10,0,0.51,NaN\n20,.002,-1.5,hot\n",
            "n,accY [m/s²],accX [m/s²],accZ [m/s²],t/s\n0,-0.1,0.5,9.8,0\n1,0,0.51,9.8,10\n2,.002,-1.5,9.8,20\n",
            "\"Time, elapsed (s)\",\"ax\",\"ay\"\n\"0\",\"0.5\",\"-0.1\"\n\"10\",\"0.51\",\"0\"\n\"20\",\"-1.5\",\"0.002\"\n",
        ] {
            assert_eq!(rows(text), Ok(DATA.to_vec()), "{text}");
        }
        let one = |text| rows(text).unwrap()[1];
        assert_eq!(one("time;a\n0;1\n2;3,5"), (2.0, [3.5, 0.0]));
        assert_eq!(one("t,ay\n0,1\n2,3"), (2.0, [0.0, 3.0]));
        assert_eq!(one("0,1\n2,3"), (2.0, [3.0, 0.0]));
        assert_eq!(rows("# nothing"), Ok(Vec::new()));
    }

    /// The app writes five formats: a point behind commas, tabs and semicolons, a comma behind tabs and semicolons.
    #[test]
    fn all_formats_of_phyphox_are_read() {
        let head = ["x", "y", "z"].map(|x| format!("\"Linear Acceleration {x} (m/s^2)\""));
        let lines = [
            "0.000000000E0,5.000000000E-1,-1.000000000E-1,9.81E0,9.823E0",
            "1.000000000E1,5.100000000E-1,0.000000000E0,9.81E0,9.823E0",
            "2.000000000E1,-1.500000000E0,2.000000000E-3,NaN,NaN",
        ];
        let absolute = "\"Absolute acceleration (m/s^2)\"";
        let [x, y, z] = &head;
        let head = ["\"Time (s)\"", x, y, z, absolute].join(",");
        let lines = lines.join("\n");
        for (between, point) in [(",", "."), ("\t", "."), (";", "."), ("\t", ","), (";", ",")] {
            let [head, lines] = [&head, &lines].map(|part| part.replace(',', between));
            let file = format!("{head}\n{}\n", lines.replace('.', point));
            assert_eq!(rows(&file), Ok(DATA.to_vec()), "{file}");
        }
    }

    #[test]
    fn what_is_not_clear_is_refused_with_its_line() {
        for (text, at) in [
            // Decimal commas between commas.
            ("t,ax\n0,5,0,1\n", 2),
            ("0,00,0,50\n10,00,0,51\n", 1),
            ("100,0,57\n110,0,58\n", 1),
            ("0 0,5\n10 0,6\n", 1),
            ("t,ax\n\"0,0\",\"1,5\"\n", 2),
            // Two decimal signs, thousands.
            ("t;ax\n0;0,5\n1.000;0,6\n", 3),
            ("t;ax\n1.000,5;1\n", 2),
            ("t;ax\n0;1,000.5\n", 2),
            ("t,ax\n999.0,1\n1,000.0,2\n", 3),
            ("t;ax\n0;1\n1;1 000\n2;3\n", 3),
            ("t;ax\n0;1\n1;1'000\n", 3),
            // Cells that are empty, no number, too many or too few.
            ("t,ax,ay\n0,1,2\n1,,2\n", 3),
            ("# a\n\n0.5,1,2\n1.5,1,\n", 4),
            ("t,ax\n0,1\n1,NaN\n", 3),
            ("NaN,NaN\n1,2\n", 1),
            ("0.5,inf\n", 1),
            ("0.5,1e51\n", 1),
            ("0.5,1,2\n1.5,1\n", 2),
            ("t,ax\n0,1\n1,2,3\n", 3),
            ("t,a\n1,2\n3,x\n", 3),
            ("t,ax\nt,ax\n", 1),
            ("t,ax\n,\n0,1\n", 2),
            ("1\n", 1),
            ("1.5,2,3,4\n", 1),
            ("t,ax\n2026-01-01 10:00:00,1\n", 2),
            // Times.
            ("t,ax\n0,1\n0,2\n", 3),
            ("t,ax\n1,1\n\n0,2\n", 4),
            // Units and names.
            ("t_ms;ax\n0;1\n", 1),
            ("Time (ms),ax\n0,1\n", 1),
            ("timestamp_us,ax\n0,1\n", 1),
            ("time,ax (g)\n0,1\n", 1),
            ("time,ax,ay\nms,m/s^2,m/s^2\n0,1,2\n", 1),
            ("time,ax,ay\ns,m/s^2,g\n0,1,2\n", 1),
            ("time,ax,ay\ns,m/s^2\n0,1,2\n", 1),
            ("time,seconds_elapsed,z,y,x\n1,1,1,1,1\n", 1),
            ("millis,ax\n0,1\n", 1),
            ("t,ax,gyro x\n0,1,2\n", 1),
            ("t,a,b\n0,1,2\n", 1),
            ("t,az\n0,1\n", 1),
            ("ax,ay\n0,1\n", 1),
        ] {
            let refused = rows(text).unwrap_err();
            assert!(
                matches!(refused, FitError::Line { line, .. } if line == at),
                "{text}: {refused}"
            );
        }
    }
}
