use super::*;

fn asked(body: &str, words: &[(&str, &str)], name: &str) -> f64 {
    let none = |file: &str| Err(SceneError::Word(file.to_owned()));
    let (scene, until) = Scene::read(body, words.iter().copied(), none).unwrap();
    let answer = scene.answer(until).unwrap();
    let number = answer
        .numbers
        .iter()
        .find(|number| number.name == name)
        .unwrap();
    number.rounded().unwrap()
}

fn near(found: f64, right: f64, digits: f64) {
    assert!(
        (found - right).abs() <= digits * right.abs(),
        "{found} {right}"
    );
}

#[test]
fn what_holds_is_not_what_brakes() {
    let held = |pull: &str| {
        asked(
            "block",
            &[
                ("mu", "0.3"),
                ("mu-s", "0.4"),
                ("pull", pull),
                ("until", "1s"),
            ],
            "x",
        )
    };
    assert_eq!(held("3.92"), 0.0);
    near(held("3.93"), 0.5 * (3.93 - 0.3 * 9.80665), 1e-11);
}

/// By Newton's law, without looking; what turns round, or is held at last, does stop.
#[test]
fn what_never_stops_is_known_at_once() {
    let ends = |body: &str, text: &str| {
        let words = text
            .split_whitespace()
            .map(|word| word.split_once('=').unwrap());
        let (scene, until) =
            Scene::read(body, words, |file| Err(SceneError::Word(file.into()))).unwrap();
        scene.run(until).map(|moved| moved.end().unwrap().t.0)
    };
    for (body, text) in [
        ("block", "mu=0.1 throw=1m/s@1rad pull=1"),
        ("block", "mu=0.1 mu-s=0.2 throw=1m/s pull=1.5"),
        ("block", "mu=0 throw=1m/s"),
        ("block", "mu=0.3 turn=3 at=2m until=rest"),
        ("ball", "mu=0.1 radius=1cm throw=1m/s pull=3.5"),
    ] {
        let why = ends(body, text).unwrap_err().to_string();
        assert!(why.starts_with("it never "), "{text}: {why}");
    }
    let g = 9.80665;
    near(
        ends("block", "mu=0.1 mu-s=0.2 throw=1m/s@180deg pull=1.5").unwrap(),
        1.0 / (1.5 + 0.1 * g),
        1e-11,
    );
    near(
        ends("ball", "mu=0.1 radius=1cm throw=1m/s pull=3.4").unwrap(),
        1.0 / (0.35 * g - 3.4),
        1e-11,
    );
}

#[test]
fn numbers_have_units() {
    for (text, right) in [
        ("15cm", 0.15),
        ("1/2 m", 0.5),
        ("2e-3", 0.002),
        ("1km", 1e3),
        ("2*3mm", 0.006),
    ] {
        near(text.parse::<Metre>().unwrap().0, right, 1e-15);
    }
    for (text, right) in [
        ("33.3rpm", 3.487_167_845_484_67),
        ("2Hz", 12.566_370_614_359_172),
        ("90deg/s", std::f64::consts::FRAC_PI_2),
        ("3", 3.0),
        ("5 1/s", 5.0),
    ] {
        near(text.parse::<RadianPerSecond>().unwrap().0, right, 1e-13);
    }
    for (text, right) in [("36km/h", 10.0), ("2mph", 0.894_08), ("-1.5m/s", -1.5)] {
        near(text.parse::<MetrePerSecond>().unwrap().0, right, 1e-15);
    }
    for (text, right) in [
        ("1g", 9.80665),
        ("2.15m/s^2", 2.15),
        ("2.15m/s2", 2.15),
        ("3 m/s²", 3.0),
        ("1 cm/s/s", 0.01),
    ] {
        near(text.parse::<MetrePerSecond2>().unwrap().0, right, 1e-15);
    }
    near(
        "120deg".parse::<Radian>().unwrap().0,
        2.094_395_102_393_195_5,
        1e-15,
    );
    for text in ["15s", "15", "cm", "1,5m", "3 apples", ""] {
        assert!(text.parse::<Metre>().is_ok() == (text == "15"), "{text}");
    }
    let told = "3s".parse::<MetrePerSecond>().unwrap_err().to_string();
    assert!(
        told.contains("a speed") && told.contains("something else"),
        "{told}"
    );
}

/// Also what breaks loose; ½ (3 − 0.2 g) 2² by hand.
#[test]
fn what_slides_each_way_has_its_own_friction() {
    for (mu, back, pull, sign) in [("0.2", "0.4", "3", 1.0), ("0.4", "0.2", "-3", -1.0)] {
        let words = [
            ("mu", mu),
            ("mu-back", back),
            ("pull", pull),
            ("until", "2s"),
        ];
        near(
            asked("block", &words, "x"),
            sign * 2.0 * (3.0 - 0.2 * 9.80665),
            1e-11,
        );
    }
}

/// By DOP853 from stop to stop, and by small implicit steps.
#[test]
fn the_truth_lies_within_the_error_of_what_is_shown() {
    let record = |across: f64| {
        let row = |k: u32| {
            let t = 0.01 * f64::from(k);
            let (s, c) = libm::sincos(std::f64::consts::TAU * t);
            (t, [6.0 * s, across * c])
        };
        let rows: Vec<_> = (0..1001).map(row).collect();
        let fitted = crate::Fitted::from_table(&rows).unwrap();
        vec![Part::record(fitted, Radian(0.0))]
    };
    let end = |frame, scene| {
        let scene = Scene { frame, ..scene };
        let numbers = scene.answer(Until::Time(Second(9.0))).unwrap().numbers;
        move |name| *numbers.iter().find(|number| number.name == name).unwrap()
    };
    for (mu, across, name, right) in [
        (0.35, 0.0, "x", -0.01433),
        (0.3, 2.0, "heat", 12.677),
        (0.3, 2.0, "path", 4.309),
    ] {
        let number = end(record(across), Scene::block(mu))(name);
        let off = (number.rounded().unwrap() - right).abs();
        assert!(
            off <= number.off() && number.off() < 2.0 * number.error,
            "{number:?}"
        );
    }
    let spun = |frame| {
        let number = end(frame, Scene::ball(0.3, Metre(0.03)));
        let spin = number("ω_y");
        assert!(spin.error >= number("v_x").error / 0.03, "{spin:?}");
        spin.rounded()
    };
    assert_eq!(spun(record(0.0)), None);
    let sine = Part::accelerate("6*sin(2*pi*t)").unwrap();
    assert_eq!(spun(vec![sine]), Some(0.0));
}
