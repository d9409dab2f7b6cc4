//! The end of a scene as numbers with names, units and errors.

use super::{
    Body, Event, Floors, JoulePerKilogram, Metre, MetrePerSecond, Moment, Moved, Scene, SceneError,
    Second, Until,
};

/// One number of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// t, x, y, v_x, v_y, of a ball ω_x, ω_y, ω_z too, then path and heat.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its value.
    pub value: f64,
    /// How far it may be off: infinite if nothing is known of it.
    pub error: f64,
}

/// What a scene is asked for.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The motion.
    pub moved: Moved,
    /// The numbers of its end.
    pub numbers: Vec<Number>,
    /// What it does from the start on.
    pub events: Vec<Event>,
}

/// By this part friction and velocity are changed to see what hangs on their last digits,
const NUDGE: f64 = 5e-14;
/// and by this part of its size a number is wrong in any case, as [`run`](crate::run) says.
const KNOWN: f64 = 4e-13;
/// Of so few digits that are sure rounding to them would waste what is known.
const FEW: f64 = 6.0;

impl Moment {
    /// Its numbers, without their errors.
    pub fn numbers(&self) -> Vec<Number> {
        let spin = self.spin.unwrap_or_default().map(|w| w.0);
        let row = |name, unit, value| Number {
            name,
            unit,
            value,
            error: 0.0,
        };
        let mut rows = vec![
            row("t", "s", self.t.0),
            row("x", "m", self.place[0].0),
            row("y", "m", self.place[1].0),
            row("v_x", "m/s", self.velocity[0].0),
            row("v_y", "m/s", self.velocity[1].0),
            row("ω_x", "rad/s", spin[0]),
            row("ω_y", "rad/s", spin[1]),
            row("ω_z", "rad/s", spin[2]),
            row("path", "m", self.way.0),
            row("heat", "J/kg", self.heat.0),
        ];
        rows.retain(|row| self.spin.is_some() || row.unit != "rad/s");
        rows
    }
}

impl Scene {
    /// As [`run`](Self::run), with how far each number of the end may be off: by the last digits of friction and velocity, by the
    /// integrator, and by the error of a recording, which for times and spins is taken to be that of as large a change of
    /// friction. Cost: twice that.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn answer(&self, until: Until) -> Result<Answer, SceneError> {
        let floors = Floors::default();
        let moved = super::moved::moved(self, until, &floors)?;
        let end = moved.end()?;
        let nudged =
            super::moved::moved(&self.nudged(), until, &floors).and_then(|moved| moved.end());
        let mut numbers = end.numbers();
        let other = nudged.map(|end| end.numbers()).unwrap_or_default();
        let size = |unit| {
            let alike = numbers.iter().filter(|number| number.unit == unit);
            alike.map(|number| number.value.abs()).fold(0.0, f64::max)
        };
        let sizes: Vec<_> = numbers.iter().map(|number| size(number.unit)).collect();
        let [velocity, place, heat, part] = moved.by_drive(&end);
        let timed = matches!(until, Until::Time(_));
        // Rounding is by the speeds it came through; and what rolls has the error of its velocity.
        let usual = end.way.0 / (end.t.0 - moved.start()?.t.0);
        let radius = match self.body {
            Body::Ball { radius, .. } => radius.0,
            Body::Block => f64::INFINITY,
        };
        let mut slowest = 0.0_f64;
        let units = self.units;
        for (k, number) in numbers.iter_mut().enumerate() {
            let changed = other
                .get(k)
                .map_or(f64::INFINITY, |other| (other.value - number.value).abs());
            let own = 2.0 * changed + KNOWN * sizes[k];
            number.error = match number.unit {
                "m/s" if sizes[k] > 0.0 => {
                    let error = own.max(KNOWN * usual) + velocity;
                    slowest = slowest.max(error);
                    error
                }
                "m/s" => own + velocity,
                "rad/s" => (own * (1.0 + part / NUDGE)).max(slowest / radius),
                "m" => own + place,
                "J/kg" => own + heat,
                "s" if timed => own,
                _ => (own * (1.0 + part / NUDGE)).max(own),
            };
            number.unit = units.name(number.unit);
        }
        Ok(Answer {
            events: moved.events(),
            moved,
            numbers,
        })
    }

    /// None is NaN.
    pub(super) fn number(&self, until: Until, name: &str) -> Result<f64, SceneError> {
        let end = self.run(until)?.end()?.numbers();
        let number = end.iter().find(|number| number.name == name);
        Ok(number.map_or(f64::NAN, |number| number.value))
    }

    fn nudged(&self) -> Self {
        let mut other = self.clone();
        let up = 1.0 + NUDGE;
        other.mu *= up;
        other.holding *= up;
        other.back = other.back.map(|mu| mu * up);
        other.start.velocity = other.start.velocity.map(|v| MetrePerSecond(v.0 * up));
        other
    }
}

impl Number {
    /// With the digits that its error leaves, at most twelve, and where these are few the first that is not sure; nothing if that
    /// is none.
    pub fn rounded(&self) -> Option<f64> {
        if self.value == 0.0 {
            return Some(0.0);
        }
        let [value, error] = [self.value.abs(), self.error.max(f64::MIN_POSITIVE)];
        let known = libm::floor(libm::log10(value / error));
        if known.is_nan() || known < 0.0 {
            return (value <= error && error < 1e-9).then_some(0.0);
        }
        let digits = if known < FEW {
            // Down to the first digit of the error.
            libm::floor(libm::log10(value)) - libm::floor(libm::log10(error)) + 1.0
        } else {
            known.min(12.0)
        };
        format!("{:.*e}", digits as usize - 1, self.value)
            .parse()
            .ok()
    }

    /// The error of the [rounded](Self::rounded) number; where there is none, how large the number may be.
    pub fn off(&self) -> f64 {
        self.error + (self.rounded().unwrap_or(0.0) - self.value).abs()
    }

    /// How many digits it has.
    pub fn digits(&self) -> u32 {
        let known = libm::log10(self.value.abs() / self.error.max(f64::MIN_POSITIVE));
        known.clamp(0.0, 12.0) as u32
    }
}

/// A number that is wanted, as in `path=1.81m`: its name and value.
///
/// # Errors
/// [`SceneError`] for a name that no number has, or a text of another unit.
pub fn target(text: &str) -> Result<(&'static str, f64), SceneError> {
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    Ok(match name {
        "t" => ("t", value.parse::<Second>()?.0),
        "x" => ("x", value.parse::<Metre>()?.0),
        "y" => ("y", value.parse::<Metre>()?.0),
        "path" => ("path", value.parse::<Metre>()?.0),
        "v_x" => ("v_x", value.parse::<MetrePerSecond>()?.0),
        "v_y" => ("v_y", value.parse::<MetrePerSecond>()?.0),
        "heat" => ("heat", value.parse::<JoulePerKilogram>()?.0),
        _ => return Err(SceneError::Word(name.to_owned())),
    })
}
