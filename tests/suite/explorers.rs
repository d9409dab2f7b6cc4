//! What the explorers show: the module in the pages gives the crate's own numbers, and these agree with the claims.

use crate::Page;
use slipbook::claims::{PAPER, anisotropic::simulated::Curves};
use slipbook::explorers::{
    anisotropic, answer, constant, periodic, plane, scene, sphere, turntable,
};
use slipbook::motion::drive::Sign;
use slipbook::paper;
use std::f64::consts::{LN_10, SQRT_2, TAU};
use trialbook::data::text;

fn ask(page: &mut Page, number: u32, [a, b, c, d]: [f64; 4]) -> Vec<f64> {
    let bytes = page.call("ask", (number, a, b, c, d));
    let number = |i: usize| f64::from_le_bytes(bytes[8 * i..][..8].try_into().unwrap());
    (1..=number(0) as usize).map(number).collect()
}

fn page() -> Page {
    Page::open(include_bytes!("../../book/theme/explorers.wasm"))
}

/// Rebuild with `book/explorers/rebuild` where this fails.
#[test]
fn the_module_in_the_pages_gives_the_numbers_of_the_crate() {
    let mut page = page();
    let questions: [(u32, &[[f64; 4]]); 14] = [
        (
            0,
            &[
                [1.2, 120.0, 0.0, 0.0],
                [0.5, -179.0, 0.0, 0.0],
                [1.0, 180.0, 0.0, 0.0],
                [0.0, 90.0, 0.0, 0.0],
                [3.0, 17.0, 0.0, 0.0],
            ],
        ),
        (1, &[[0.7, 0.0, 0.0, 0.0], [1.01, 0.0, 0.0, 0.0]]),
        (
            2,
            &[
                [2.0, 0.45, 1.5, 0.0],
                [1.0, 0.01, -2.0, 0.0],
                [7.0, 1.2, 0.3, 0.0],
                [5.5, 0.15, 0.0, 0.0],
            ],
        ),
        (3, &[[2.0, 0.0, 0.0, 0.0]]),
        (
            4,
            &[
                [0.8, -0.6, 0.4, 0.0],
                [1.6, -2.0, -2.5, 0.0],
                [0.0, 0.0, 0.0, 0.0],
            ],
        ),
        (5, &[[0.8, 0.0, 0.0, 0.0]]),
        (
            6,
            &[
                [0.75, 0.4, 0.0, 1.0],
                [0.05, 0.67, -2.0, 0.02],
                [1.5, 0.05, 0.0, 0.0],
            ],
        ),
        (7, &[[1.2, 120.0, 0.0, 0.0], [0.5, -179.0, 0.0, 0.0]]),
        (8, &[[2.0, 0.45, 1.5, 0.0], [1.0, 1.2, -2.0, 0.0]]),
        (9, &[[0.75, 0.4, 0.0, 1.0]]),
        (10, &[[0.8, 0.0, 0.0, 0.0], [1.1, 0.0, 0.0, 0.0]]),
        (11, &[[1.5, 0.08, 1.0, 0.0], [0.0, 0.45, -2.0, 0.6]]),
        (12, &[[1.5, 0.3, 1.0, 0.0], [0.0, 0.3, 1.0, 0.5]]),
        (
            13,
            &[
                [0.3, 0.5, 1.0, 0.0],
                [0.7, -2.0, 2.0, 0.0],
                [0.3, 0.5, 0.0, 0.0],
            ],
        ),
    ];
    for (number, arguments) in questions {
        for given in arguments {
            let native = answer(number as usize, *given).unwrap().flat();
            assert!(native.iter().all(|x| x.is_finite()));
            // To the last bit: all functions are libm's on both sides.
            assert!(
                ask(&mut page, number, *given) == native,
                "{number} {given:?}"
            );
        }
    }
}

fn told(page: &mut Page, question: &str) -> String {
    let bytes = page.tell(question);
    let length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
    String::from_utf8(bytes[4..][..length].to_vec()).unwrap()
}

fn shaken() -> String {
    let row = |k: i32| {
        let t = f64::from(k) / 100.0;
        format!("{t},{},0\n", 4.0 * (10.0 * t).sin())
    };
    "t (s),ax (m/s^2),ay (m/s^2)\n".to_owned() + &(0..200).map(row).collect::<String>()
}

#[test]
fn the_module_tells_of_scenes_what_the_crate_tells() {
    let mut page = page();
    let record = shaken();
    for (question, part) in [
        (
            "block\nmu=0.5\nthrow=6m/s",
            "number\tpath\t3.67097836672\tm\n",
        ),
        (
            "block\nmu=0.5\nthrow=6m/s",
            "does\tslides\t0\ndoes\trests\t1.22365945",
        ),
        (
            "block\nmu=0.5\nthrow=6m/s",
            "\nstraight\npath\t0\t0\t0\t6\t",
        ),
        (
            "ball\nmu=0.08\nradius=11cm\nthrow=5m/s@30deg",
            "does\trolls\t1.8209",
        ),
        (
            "block\nmu=0.1\ntilt=10deg@90deg\nat=1m,0\nuntil=2s",
            "\npath\t0\t1\t0\t0",
        ),
        ("block\nmu=0.2\nuntil=1s", "does\trests\t0\n"),
        (
            "block\nmu=1\npull=sin(\nuntil=1s",
            "error\t`sin(` is not an acceleration",
        ),
        ("block\nmu=1\nmass=1", "error\t`mass` is no word"),
        (
            "block\nthrow=1m/s",
            "error\tmu, the coefficient of friction, is missing",
        ),
        (
            "block\nmu=0.1\nrecord=a.csv",
            "error\tcannot read `a.csv`: drop it",
        ),
        ("stone\nmu=0.1", "error\t`stone` is no word"),
        ("", "error\t"),
        (
            &format!("block\nmu=0.2\nrecord=a.csv\nuntil=1.99s\n\n{record}"),
            "number\tt\t1.99\ts",
        ),
        (
            &format!("recording\n\n{record}"),
            "rows\t200\t0\t1.99\nx\t0\t0\t0.01\t0.39933",
        ),
        (&format!("recording\n\n{record}"), "\nkinetic\tno plateau"),
        ("recording\n\nt,v_x\n0,1\n", "error\tline 1"),
    ] {
        let native = scene::told(question);
        assert!(native.contains(part), "{question}: {native}");
        assert_eq!(told(&mut page, question), native, "{question}");
    }
}

/// The least and the largest of each stretch are left.
#[test]
fn a_long_recording_is_drawn_together_and_keeps_its_peaks() {
    let row = |k: i32| {
        format!(
            "{},{}\n",
            0.01 * f64::from(k),
            if k == 7777 { 9.0 } else { f64::from(k % 3) }
        )
    };
    let told = scene::told(&format!(
        "recording\n\n{}",
        (0..20_000).map(row).collect::<String>()
    ));
    let x: Vec<_> = told
        .lines()
        .find(|line| line.starts_with("x\t"))
        .unwrap()
        .split('\t')
        .collect();
    assert!(x.len() < 3000 && x.windows(2).any(|two| two == ["77.77", "9"]));
    assert!(told.starts_with("rows\t20000\t0\t199.99"));
}

#[test]
fn what_has_no_answer_is_an_empty_list_in_the_module_and_a_named_error_in_the_crate() {
    let mut page = page();
    for (number, given, named) in [
        (0, [-1.0, 0.0, 0.0, 0.0], "λ"),
        (0, [1.0, f64::NAN, 0.0, 0.0], "θ₀"),
        (1, [f64::INFINITY, 0.0, 0.0, 0.0], "λ"),
        (2, [1.0, -0.5, 0.0, 0.0], "lambda_plus"),
        (2, [1.0, 0.5, f64::NAN, 0.0], "phi"),
        (3, [f64::NAN, 0.0, 0.0, 0.0], "lambda_minus"),
        (4, [-1.0, 0.0, f64::NAN, 0.0], "p = NaN"),
        (5, [1e10, 0.0, 0.0, 0.0], "rho"),
        (6, [0.0, 0.4, 0.0, 0.0], "lambda_0"),
        (6, [1.0, 0.0, 0.0, 0.0], "inertia"),
        (6, [1.0, 0.4, f64::NAN, 0.0], "v_x"),
        (7, [-1.0, 0.0, 0.0, 0.0], "λ"),
        (8, [1.0, -0.5, 0.0, 0.0], "lambda_plus"),
        (9, [0.0, 0.4, 0.0, 0.0], "lambda_0"),
        (10, [-1.0, 0.0, 0.0, 0.0], "rho"),
        (11, [f64::NAN, 0.5, 0.0, 0.0], "h"),
        (11, [1.0, -0.5, 0.0, 0.0], "lambda_plus"),
        (11, [0.0, 0.5, 0.5, 1.0], "eta"),
        (12, [1.0, 0.5, f64::NAN, 0.0], "phi"),
        (13, [-1.0, 0.5, 1.0, 0.0], "lambda"),
        (13, [0.3, 0.5, -1.0, 0.0], "ln_w_y"),
        (14, [0.0; 4], "question 14"),
    ] {
        let error = answer(number, given).unwrap_err().to_string();
        assert!(error.contains(named), "{number} {given:?}: {error}");
        assert!(ask(&mut page, number as u32, given).is_empty());
    }
}

#[test]
fn at_equal_strength_a_throw_stops_straight_back_alone() {
    let rests = |theta| constant::motion(1.0, theta).unwrap().values[0];
    assert_eq!([180.0, 179.0].map(rests), [1.0, 0.0]);
    assert!(constant::portrait(1.0).unwrap().curves[0].is_empty());
}

#[test]
fn the_manners_are_those_of_the_regions() {
    let signs = |manner: &[Sign]| -> Vec<f64> { manner.iter().map(|s| s.factor()).collect() };
    assert_eq!(anisotropic::MANNERS.map(signs), paper::anisotropic::signs());
}

#[test]
fn the_map_has_the_borders_that_the_claims_found() {
    let curves = anisotropic::map(12.0).unwrap().curves;
    for i in 0..curves[0].len() {
        let q = curves[0][i][0];
        let corrected = Curves::at(q).unwrap().corrected;
        let mut borders = vec![corrected.a, corrected.b_or_e];
        // Beyond Y, III is not between II and IV.
        borders.extend([corrected.c.unwrap_or(corrected.b_or_e), corrected.d]);
        for (curve, border) in curves.iter().zip(borders) {
            let found = curve[i][1];
            assert!((found - border).abs() < 2e-4, "q = {q}: {found}, {border}");
        }
    }
}

#[test]
fn what_slides_across_stops() {
    let stops = [0.7, 0.3].map(|lambda| plane::film(lambda, 0.5, 1.0).unwrap().values[1]);
    assert!(stops[0] > 0.0 && stops[1] == -1.0, "{stops:?}");
}

#[test]
fn a_coin_that_is_kept_has_no_late_times() {
    let kept = turntable::growth(0.5).unwrap().curves;
    assert!(kept[0].last().is_none_or(|point| point[0] < 1.0));
}

/// To within the first correction at τ = 10⁴: of the square of A, 9√2/4 (ln τ)/τ and more.
#[test]
fn a_coin_that_goes_away_comes_near_the_late_laws() {
    let value = |id| PAPER.value(id).unwrap().number().unwrap();
    let (a, winding) = (value("a"), SQRT_2 * LN_10);
    let limits = [value("p"), 2.0, a * a, 0.75 * SQRT_2, 0.5];
    let mut curves = turntable::growth(1.1).unwrap().curves;
    let path = curves.pop().unwrap();
    for (curve, limit) in curves.iter().zip(limits) {
        let last = curve[curve.len() - 1][1];
        let correction = 4.0 * 4.0 * LN_10 / 1e4;
        assert!((last / limit - 1.0).abs() < correction, "{last} {limit}");
    }
    // At 40 points a decade: twice as many powers of ten outwards, and as far around as a logarithmic spiral, to the first
    // correction.
    let polar = |[x, y]: [f64; 2]| [x.hypot(y), y.atan2(x)];
    let [[r, angle], [far, on]] = [path.len() - 41, path.len() - 1].map(|i| polar(path[i]));
    let correction = 1.5 * SQRT_2 * 3.0 * LN_10 / 1e3;
    assert!((far - r - 2.0).abs() < correction, "{r} {far}");
    let around = (on - angle).rem_euclid(TAU);
    assert!((around - winding).abs() < correction, "{angle} {on}");
}

/// (145) with ψ free takes it to σ = 0.505.
#[test]
fn a_coin_rests_elsewhere_than_the_surface_with_psi_free_says() {
    let (rho, p) = (0.48_f64, 0.14);
    let (a, alpha) = ((rho * rho - p * p).sqrt(), (p / rho).atanh());
    assert!((paper::rest::eq145_a(0.505, alpha) - a).abs() < 5e-4);
    let [fate, sigma, ..] = turntable::motion(rho, [0.0, -p]).unwrap().values[..] else {
        panic!("no fate")
    };
    assert!(fate == 1.0 && sigma < 0.49, "{sigma}");
}

#[test]
fn the_guesses_have_the_answers_that_are_given() {
    let stop = constant::motion(2.0, 90.0).unwrap().values[1];
    assert!((stop / 0.5 - 4.0 / 3.0).abs() < 1e-12);
    // On a table at rest it stops at 1/(2λ).
    let [x, y] = constant::film(2.0, 90.0).unwrap().curves[2]
        .last()
        .copied()
        .unwrap();
    assert!(x.abs() < 1e-12 && (y - 0.25).abs() < 1e-12);
    let depths = plane::film(0.3, 0.5, 1.0).unwrap().curves[2].clone();
    let depth = |period: usize| depths[period * (depths.len() - 1) / 4][1];
    assert!(depth(2) - depth(1) > 2.0 * (depth(1) - depth(0)) && depth(3) > 2.0 * depth(2));
    let rests = |lambda: f64| {
        let values = periodic::motion(1.5, lambda, 1.0, 0.0).unwrap().values;
        values[4..].chunks(3).filter(|i| i[0] == 0.0).count()
    };
    assert_eq!([0.03, 0.08, 0.15, 0.4, 0.8].map(rests), [0, 2, 0, 2, 4]);
    // As hard along the turning, farther out, it does not rest.
    for (rho, v, rests) in [(0.5, -0.48, 1.0), (0.7, -0.48, 1.0), (0.7, 0.48, 0.0)] {
        assert_eq!(turntable::motion(rho, [0.0, v]).unwrap().values[0], rests);
    }
    let thrown = turntable::motion(0.0, [1.5, 0.0]).unwrap().curves;
    let side = |curve: &[[f64; 2]]| curve[40][1];
    assert!(side(&thrown[0]) < -0.1 && side(&thrown[1]) > 0.1);
    let put_down = |rho: f64| turntable::motion(rho, [0.0, -rho]).unwrap().values[0];
    assert_eq!([0.87, 0.88].map(put_down), [1.0, 0.0]);
    // Forwards for two thirds of the time where friction is half as strong.
    let drifts = [0.002, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99].map(|lambda| {
        let values = anisotropic::motion(2.0, lambda, -0.5).unwrap().values;
        let forwards = values[5..].chunks(3).filter(|i| i[0] == 1.0);
        (values[1], forwards.map(|i| i[2] - i[1]).sum::<f64>() / TAU)
    });
    assert!(drifts.windows(2).all(|two| two[0].0 > two[1].0));
    assert!((drifts[0].0 - 0.5).abs() < 1e-2 && (drifts[0].1 - 2.0 / 3.0).abs() < 1e-2);
    let film = sphere::film(1.5, 0.4, [-1.0, 0.0]).unwrap().curves;
    let late: Vec<_> = film[0].iter().skip(240).collect();
    let [first, ..] = late[..] else {
        panic!("no film")
    };
    assert!(film[1].iter().skip(240).all(|[_, slip]| slip.abs() < 1e-12));
    for [floor, ball] in &late {
        let gone = (floor - first[0]) + (ball - first[1]);
        assert!(
            (gone - 2.0 / 7.0 * (floor - first[0])).abs() < 2e-3,
            "{gone}"
        );
    }
    let script = text!("book/theme/explorers-list.js").as_str();
    let answers = script.split("options: ['").skip(1).map(|asked| {
        let (options, rest) = asked.split_once("'],").unwrap();
        let (_, right) = rest.split_once("right: ").unwrap();
        let right: usize = right.split(',').next().unwrap().parse().unwrap();
        options.split("', '").nth(right).unwrap()
    });
    assert_eq!(
        answers.collect::<Vec<_>>(),
        [
            "later",
            "weak",
            "bent with the turning",
            "It comes to rest",
            "for ever, more and more slowly",
            "faster than any exponential",
            "disappear",
            "less far, with the floor",
            "one at rest, one gone for ever"
        ]
    );
}

/// What the guesses are about is computed above.
#[test]
fn the_numbers_around_an_explorer_are_those_of_the_claims() {
    let script = text!("book/theme/explorers-list.js").as_str();
    let value = |id| PAPER.value(id).unwrap().number().unwrap();
    let critical = format!("{:.3}", value("lambda-c"));
    let solid = value("kappa-solid");
    let [kappa, same, hollow] = [
        solid.to_string(),
        format!("{solid:.2}"),
        format!("{:.2}", 2.0 / 3.0),
    ];
    let turn = format!("{:.0}", value("turn"));
    let mut said = Vec::new();
    let mut rest = script;
    let parts = ["hint: '", "title: '", "asks: '", "says: '", "label: '"];
    while let Some(begin) = parts
        .iter()
        .filter_map(|part| Some(rest.find(part)? + part.len()))
        .min()
    {
        let (words, after) = rest[begin..].split_once('\'').unwrap();
        // What stands below the line is part of a symbol.
        let numbers = words.split(|c: char| !c.is_ascii_digit() && !['.', '_'].contains(&c));
        let numbers = numbers
            .filter(|n| !n.starts_with('_'))
            .map(|n| n.trim_matches('.'));
        said.extend(numbers.filter(|n| !n.is_empty()));
        rest = after;
    }
    let expected = [
        &["2"][..],
        &["0"],
        &["147", "1"],
        &[&turn],
        &["0.3", &critical, "1"],
        &["1.5", "0.08", "2", "7"],
        &[&kappa, &hollow, &same],
    ];
    assert_eq!(said, expected.concat());
}

#[test]
fn each_explorer_stands_before_a_figure() {
    for page in [
        text!("book/src/index.md").as_str(),
        text!("book/src/constant.md").as_str(),
        text!("book/src/sinusoidal.md").as_str(),
        text!("book/src/escape.md").as_str(),
        text!("book/src/rest.md").as_str(),
        text!("book/src/anisotropic.md").as_str(),
        text!("book/src/sphere.md").as_str(),
        text!("book/src/turntable.md").as_str(),
    ] {
        assert_eq!(page.matches("{{explorer}}").count(), 1);
        assert!(page.contains("\n\n{{explorer}}\n\n{{figure "));
    }
}
