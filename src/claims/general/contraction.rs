//! Two particles under one drive come no farther apart in velocity.

use super::chains::at_most_its_size;
use super::prelude::*;

/// The other velocity.
const OTHER: [&str; 2] = ["u_x", "u_y"];

fn ring() -> Result<Ring, ExactError> {
    let mut ring = super::two_frames::ring()?;
    let [ux, uy] = OTHER.map(|name| ring.symbol(name));
    ring.root(&(ux.pow(2) + uy.pow(2)), 2)?;
    Ok(ring)
}

pub(crate) fn never_farther_apart() -> Proof {
    by_law(eq1())
}

fn by_law(law: [Expr; 2]) -> Proof {
    Proof::in_ring(
        "The velocities of two motions under one drive never move apart",
        ring(),
        |p| {
            p.shows("By (1), for two particles under the same drive, whatever it is, each sliding or at rest, the size of the difference of their velocities never grows.");
            p.rests_on(&eq1_proof(law))?;
            p.remark("Let v and u be the speeds of two particles under any drive, and γ the angle between their velocities");
            let [ax, ay, mu, g, vx, vy] = NAMES.map(symbol);
            let [ux, uy] = OTHER.map(symbol);
            let mut rates = Vec::new();
            for (i, (name, other)) in ["v_x", "v_y"].into_iter().zip(OTHER).enumerate() {
                let own = p.read("A component of (1), for the first", law[i])?;
                let same = law[i].with("v_x", ux).with("v_y", uy);
                let same = p.read("The same for the second", same)?;
                rates.extend([(name, own), (other, same)]);
            }
            let both = p.ring().along(&rates)?;
            let square = (vx - ux).squared() + (vy - uy).squared();
            let square = p.read("The squared distance of the velocities", square)?;
            let rate = p.derivative("Its rate", &square, &both)?;
            let [v, u] = [[vx, vy], [ux, uy]].map(|[x, y]| (x.squared() + y.squared()).sqrt());
            let cosine = (vx * ux + vy * uy) / (v * u);
            let stated = -(2 * mu * g * (v + u) * (1 - cosine));
            p.reads_as(&rate, "which is −2μg (v + u) (1 − cos γ)", stated)?;
            let across = ((vx * uy - vy * ux) / (v * u)).squared();
            p.identity(
                ("1 − cos² γ", 1 - cosine.squared()),
                ("a square, so that cos γ is at most 1", across),
            )?;

            let own: Vec<_> = rates.into_iter().step_by(2).collect();
            let alone = p.ring().along(&own)?;
            let square = p.read(
                "While the second is at rest, the squared distance",
                vx.squared() + vy.squared(),
            )?;
            let rate = p.derivative("Its rate", &square, &alone)?;
            let along = (ax * vx + ay * vy) / v;
            p.reads_as(
                &rate,
                "which is −2v times μg and the component of the drive along the velocity",
                -(2 * v * (along + mu * g)),
            )?;
            at_most_its_size(p)?;
            Ok(())
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_motions_part_and_a_friction_that_grows_with_the_speed_is_another_matter() {
        let proof = never_farther_apart();
        assert!(proof.holds(), "{proof}");
        let [x, y] = eq1();
        let more = symbol("v_x") / int(1_000_000);
        assert!(!by_law([x - more, y]).holds());
        assert!(!by_law([x, y - more]).holds());
    }
}
