//! Scenes of any words, and recordings of any text.

use super::{any, config, finite, text::text};
use proptest::prelude::*;
use slipbook::motion::{
    Columns, Fitted, Recording,
    measure::{Settings, measure},
};
use slipbook::scene::{Scene, Second, WORDS, second};

const GOOD: [(&str, &str); 28] = [
    ("mu", "0.2"),
    ("mu-s", "0.4"),
    ("mu-back", "0.5"),
    ("g", "1g"),
    ("radius", "3cm"),
    ("kappa", "2/3"),
    ("tilt", "10deg@1rad"),
    ("pull", "4*sin(7*t):1s,2m/s^2@90deg"),
    ("pull", "5"),
    ("accelerate", "3m/s^2:1s,0"),
    ("record", "tray.csv"),
    ("columns", "gaps=bridge"),
    ("towards", "1"),
    ("turn", "33rpm"),
    ("belt", "1m/s"),
    ("at", "10cm,2cm"),
    ("throw", "1m/s@1rad"),
    ("throw", "2m/s"),
    ("throw-in-room", "1m/s"),
    ("set-down", ""),
    ("spin", "1,-2,3"),
    ("units", "mu g R"),
    ("width", "10ms"),
    ("within", "2s"),
    ("until", "rest"),
    ("until", "1s"),
    ("until", "30cm"),
    ("until", "beyond=1m"),
];

/// A text that goes with no word, or with another.
fn odd() -> impl Strategy<Value = String> {
    prop_oneof![
        text(),
        any().prop_map(|x| x.to_string()),
        "-?[0-9.]{1,4}(e-?[0-9]{1,2})?(m|cm|m/s|s|ms|deg|rpm|g|m/s\\^2|)(@-?[0-9]{1,3}(deg|rad|))?",
        "([0-9]|[-+*/^()]|t|sin\\(|sqrt\\(){1,8}(:[0-9]{1,2}s)?(,-?[0-9](:[0-9]s)?){0,3}",
        prop::sample::select(GOOD.map(|(_, text)| text.to_owned()).to_vec()),
    ]
}

fn recording() -> impl Strategy<Value = String> {
    let rows = prop::collection::vec((any(), [-9.0..9.0, -0.1..0.1, 9.0..10.0]), 0..200);
    let table = (rows, prop::bool::ANY).prop_map(|(rows, wild)| {
        let row = |(k, (x, [a, b, c])): (usize, (f64, [f64; 3]))| {
            let a = if wild && k % 50 == 7 { x } else { a };
            format!("{},{a},{b},{c}\n", k as f64 * 0.01)
        };
        let rows = rows.into_iter().enumerate().map(row);
        "t,ax,ay,az\n".to_owned() + &rows.collect::<String>()
    });
    prop_oneof![4 => table, 1 => text()]
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn any_scene_has_numbers(
        ball: bool,
        words in prop::collection::vec((prop::sample::select(GOOD.to_vec()), prop::option::weighted(0.2, odd())), 0..6),
        file in recording(),
    ) {
        let all = words.iter().map(|((name, text), odd)| (*name, odd.as_deref().unwrap_or(text)));
        let all = std::iter::once(("mu", "0.3")).chain(all);
        let body = if ball { "ball" } else { "block" };
        let Ok((mut scene, until)) = Scene::read(body, all, |_| Ok(file.clone())) else { return Ok(()) };
        scene.within = Second(scene.within.0.min(20.0));
        if let Ok(answer) = scene.answer(until) {
            let values: Vec<_> = answer.numbers.iter().map(|number| number.value).collect();
            prop_assert!(finite(&values), "{scene:?} {until:?} {values:?}");
            prop_assert!(answer.numbers.iter().all(|number| number.error >= 0.0), "{scene:?} {:?}", answer.numbers);
            let end = answer.moved.end().unwrap().t.0;
            prop_assert!(answer.moved.every(Second(end / 7.0)).is_ok_and(|rows| rows.len() <= 9) || end <= 0.0, "{scene:?}");
            second(&scene, until);
        }
    }

    #[test]
    fn any_words_are_a_scene_or_refused(body in text(), name in text(), texts in prop::collection::vec(odd(), WORDS.len())) {
        let words = || WORDS.iter().zip(&texts).map(|(word, text)| (word.name, text.as_str()));
        for word in words() {
            let _ = Scene::read("block", [("mu", "0.3"), word], |_| Ok(texts[0].clone()));
        }
        let _ = Scene::read("ball", words(), |_| Ok(texts[0].clone()));
        prop_assert!(Scene::read(&body, [(name.as_str(), "1")], |_| Ok(String::new())).is_err());
    }

    #[test]
    fn any_recording_is_measured_or_refused(file in recording()) {
        let columns = Columns::default();
        let _ = Fitted::from_csv_with(&file, &columns);
        if let Ok(found) = Recording::from_csv(&file, &columns).map(|recording| measure(&recording, &Settings::default()))
            && let Ok(found) = found
        {
            for interval in [found.kinetic, found.holding].into_iter().flatten() {
                prop_assert!(finite(&[interval.from, interval.to]) && interval.from <= interval.to, "{interval:?}");
            }
        }
    }
}
