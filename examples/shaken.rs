//! A ball on a table that is shaken ever more weakly, by a function of the time; and the same by a table of values.

use slipbook::motion::{
    Fitted,
    sphere::{Ball, Sphere},
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let shaking = |t: f64| [8.0 * (5.0 * t).sin() * (-0.3 * t).exp(), 0.0];
    let function = Fitted::from_fn(shaking, [0.0, 10.0], 0.1, &[])?;
    // As an accelerometer would have it, two hundred times a second.
    let rows: Vec<_> = (0..=2000)
        .map(|k| 0.005 * f64::from(k))
        .map(|t| (t, shaking(t)))
        .collect();
    let table = Fitted::from_table(&rows)?;
    let sphere = Sphere {
        mu: 0.2,
        g: 9.8,
        ..Sphere::with_kappa(0.4)
    };
    let at_rest = Ball {
        t: 0.0,
        v: [0.0; 2],
        omega: [0.0; 3],
        x: [0.0; 2],
    };
    for (name, plane) in [("function", &function), ("table", &table)] {
        let motion = sphere.run(plane, &at_rest, 10.0)?;
        let end = motion.at(10.0)?;
        println!(
            "{name}: A known to {:.0e}; {} changes between sliding and rolling, at the end at x = {:.6}",
            motion.drive_error(),
            motion.transitions().len(),
            end.x[0]
        );
    }
    Ok(())
}
