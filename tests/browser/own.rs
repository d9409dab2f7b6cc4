//! The page on which a reader writes scenes and drops recordings.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::pages::none;
use serde_json::{Value, json};
use slipbook::explorers::{answer, scene::told};

/// The new numbers by their names, and what it says under `says`.
fn shown(page: &mut Page, part: &str, expected: &str) -> Seen<Value> {
    let shown = format!("document.getElementById('{part}').dataset.shown");
    page.wait_for(&format!("{shown} === {}", json!(expected)))?;
    page.value(&format!(
        "(host => ({{ ...Object.fromEntries([...host.querySelectorAll('dl div')].map(row => [...row.children].map(cell => cell.textContent))
            .map(([name, text]) => [name, Number(text.replace('−', '-').split(' ')[0])])), says: host.querySelector('.says').textContent,
            plots: host.querySelectorAll('.explore-plot').length }}))(document.getElementById('{part}'))"
    ))
}

fn other(found: &Value, question: &str) -> Vec<String> {
    let told = told(question);
    let rows: Vec<Vec<_>> = told
        .lines()
        .map(|line| line.split('\t').collect())
        .collect();
    let numbers = rows.iter().filter(|row| row[0] == "number");
    let wrong =
        numbers.filter(|row| found[row[1].replace('_', "")].as_f64() != row[2].parse().ok());
    wrong
        .map(|row| format!("{question}: {row:?} in {found}"))
        .collect()
}

pub fn scenes(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    let line = "document.querySelector('#own textarea')";
    let type_in = |field: &str, text: &str| {
        format!(
            "(field => {{ field.value = {}; field.dispatchEvent(new Event('input', {{ bubbles: true }})); }})({field})",
            json!(text)
        )
    };
    page.open(&book.address(
        "scenes.html#block&mu=0.3&throw=6m/s@30deg&pull=4*sin(10*t)&pull=1@90deg&until=2s",
    ))?;
    let found = shown(
        page,
        "own",
        "#block&mu=0.3&pull=4*sin(10*t)&pull=1@90deg&throw=6m/s@30deg&until=2s",
    )?;
    wrong.extend(other(
        &found,
        "block\nmu=0.3\nthrow=6m/s@30deg\npull=4*sin(10*t)\npull=1@90deg\nuntil=2s",
    ));
    let command = page.value(&format!("{line}.value"))?;
    let whole = "slipbook scene block --mu 0.3 --pull '4*sin(10*t)' --pull 1@90deg --throw 6m/s@30deg --until 2s";
    if command != whole || found["plots"] != 2 {
        wrong.push(format!("{command}, {found}"));
    }
    page.value(&type_in(
        "document.querySelector('#own [name=mu]')",
        "0.5 0",
    ))?;
    let found = shown(
        page,
        "own",
        "#block&mu=0.5%200&pull=4*sin(10*t)&pull=1@90deg&throw=6m/s@30deg&until=2s",
    )?;
    if !found["says"]
        .as_str()
        .is_some_and(|says| says.contains("`0.5 0`"))
        || found["plots"] != 0
    {
        wrong.push(format!("a number that is none: {found}"));
    }
    page.value(&format!("{line}.focus()"))?;
    page.value(&type_in(
        line,
        "$ slipbook scene ball --mu=0.08 \\\n --radius '11cm' --throw \"5m/s\" --every 1s",
    ))?;
    let found = shown(page, "own", "#ball&mu=0.08&throw=5m/s&radius=11cm")?;
    wrong.extend(other(&found, "ball\nmu=0.08\nradius=11cm\nthrow=5m/s"));
    if !found["says"]
        .as_str()
        .is_some_and(|says| says.ends_with("Passed over: --every 1s"))
    {
        wrong.push(format!("{found}"));
    }
    page.wait_for("location.hash === '#ball&mu=0.08&throw=5m/s&radius=11cm'")?;
    page.open(&book.address("questions.html"))?;
    page.value("document.querySelector('a[href*=\"#own?\"]').click()")?;
    let whole = "#block&mu=0.16&mu-s=0.18&accelerate=2.15m/s^2&until=1.81m&g=9.8m/s^2";
    wrong.extend((shown(page, "own", whole)?["plots"] != 2).then(|| "no film".to_owned()));
    wrong.extend(page.complaints());
    none(wrong)
}

pub fn as_scenes(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    let ask = |number, given| answer(number, given).map_err(|error| error.to_string());
    let last = |curve: &[[f64; 2]]| curve.last().copied().unwrap_or([f64::NAN; 2]);
    let thrown =
        |lambda, theta: f64| Ok::<_, String>(two(&ask(0, [lambda, theta, 0.0, 0.0])?.values[4..]));
    let coin = |rho, u, v| Ok::<_, String>(last(&ask(4, [rho, u, v, 0.0])?.curves[0]));
    let swung = |given| Ok::<_, String>([last(&ask(12, given)?.curves[0])[1], 0.0]);
    let tray = ask(13, [0.3, 0.5, 1.0, 0.0])?.curves;
    for (name, state, [x, y]) in [
        ("constant", "lambda=1.2&theta=120", thrown(1.2, 120.0)?),
        ("constant", "lambda=0.5&theta=-40", thrown(0.5, -40.0)?),
        ("turntable", "rho=0.8&u=-0.6&v=0.4", coin(0.8, -0.6, 0.4)?),
        ("turntable", "rho=1.5&u=1&v=0.4", coin(1.5, 1.0, 0.4)?),
        (
            "sphere",
            "lambda=0.75&kappa=0.4&u=0.3&v=1",
            last(&ask(6, [0.75, 0.4, 0.3, 1.0])?.curves[3]),
        ),
        (
            "sinusoidal",
            "lambda=0.3&w=0.5&across=1",
            [last(&tray[0])[1], last(&tray[2])[0]],
        ),
        (
            "anisotropic",
            "q=2&lambda=0.45&w=1.5",
            [last(&ask(8, [2.0, 0.45, 1.5, 0.0])?.curves[0])[1], 0.0],
        ),
        (
            "periodic",
            "third=1.5&lambda=0.16&w=0.2&eta=0",
            swung([1.5, 0.16, 0.2, 0.0])?,
        ),
        (
            "periodic",
            "third=0&lambda=0.3&w=-0.5&eta=0.4",
            swung([0.0, 0.3, -0.5, 0.4])?,
        ),
        ("record", "rho=0.5&u=0.2&v=-0.4", coin(0.5, 0.2, -0.4)?),
        ("escape", "rho=1.1", coin(1.1, 0.0, -1.1)?),
    ] {
        let file = if name == "record" { "index" } else { name };
        page.open(&book.address(&format!("{file}.html#explore-{name}?{state}")))?;
        page.wait_for(&format!(
            "document.getElementById('explore-{name}').dataset.shown === '#explore-{name}?{state}'"
        ))?;
        let link = page.value(&format!(
            "document.querySelector('#explore-{name} .as-scene').href"
        ))?;
        page.open(link.as_str().unwrap_or_default())?;
        page.wait_for("document.querySelectorAll('#own .explore-plot').length === 2")?;
        let scene = page.value("document.getElementById('own').dataset.shown")?;
        let found = shown(page, "own", scene.as_str().unwrap_or_default())?;
        let off = [("x", x), ("y", y)]
            .map(|(name, right)| (found[name].as_f64().unwrap_or(f64::NAN) - right).abs());
        // Displacements on a tray are sums over its pictures.
        if !off.iter().all(|off| *off < 1e-3) {
            wrong.push(format!(
                "{name}, {state}: ({x}, {y}) is not {found} of {scene}"
            ));
        }
    }
    none(wrong)
}

fn two(numbers: &[f64]) -> [f64; 2] {
    [0, 1].map(|i| numbers.get(i).copied().unwrap_or(f64::NAN))
}

pub fn recordings(page: &mut Page, book: &Book) -> Seen {
    let mut wrong = Vec::new();
    let row = |k: i32| {
        let t = f64::from(k) / 100.0;
        format!("{t};{}\n", 4.0 * (10.0 * t).sin())
    };
    let record =
        "Time (s);Acceleration x (m/s^2)\n".to_owned() + &(0..300).map(row).collect::<String>();
    page.open(&book.address("scenes.html"))?;
    page.wait_for("!!document.getElementById('own').dataset.shown")?;
    let drop = |text: &str| {
        format!(
            "(data => {{ data.items.add(new File([{}], 'my phone.csv')); document.getElementById('recording').dispatchEvent(
                new DragEvent('drop', {{ dataTransfer: data, bubbles: true, cancelable: true }})); }})(new DataTransfer())",
            json!(text)
        )
    };
    page.value(&drop(&record))?;
    let found = shown(page, "recording", "my phone.csv 0.2")?;
    wrong.extend(other(
        &found,
        &format!("block\nmu=0.2\nrecord=my phone.csv\nuntil=2.99s\n\n{record}"),
    ));
    let says = found["says"].as_str().unwrap_or_default();
    if !says.starts_with("300 rows from 0 s to 2.99 s. It ") || found["plots"] != 3 {
        wrong.push(format!("{found}"));
    }
    let friction = page.value("document.querySelector('#recording dl').textContent")?;
    if !friction
        .as_str()
        .is_some_and(|text| text.contains("no plateau"))
    {
        wrong.push(format!("{friction}"));
    }
    page.value("document.querySelector('#recording .as-scene').click()")?;
    let scene = shown(
        page,
        "own",
        "#block&mu=0.2&until=2.99s&record=my%20phone.csv",
    )?;
    if scene["x"] != found["x"] || scene["plots"] != 2 {
        wrong.push(format!("{scene} is not {found}"));
    }
    page.value(&drop("t,v_x\n0,1\n"))?;
    page.wait_for(
        "document.querySelector('#recording .says').textContent.startsWith('my phone.csv: line 1')",
    )?;
    wrong.extend(page.complaints());
    none(wrong)
}
