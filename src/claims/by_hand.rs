//! For each claim that fails: why, and a case in which a reader can see it with paper and pencil.
//!
//! The words are ours; the two numbers in them are computed, the stated one from the printed formula, the found one
//! from the motion. The judge reads none of this.

use super::anisotropic::simulated::{self as drift, Curves};
use super::compare::Failure;
use super::constant::sense::sense_of_sliding;
use super::escape::escapes::escapes;
use super::escape::growth::{self, Quantity};
use super::periodic::again::friction;
use super::periodic::drives::pulses;
use super::rest::boundary::surfaces;
use super::rest::surfaces::bend;
use super::sinusoidal::settled::{ORIGIN, drive, settled};
use super::turntable::projections;
use super::values::boundary_example;
use crate::motion::drive::{PlanarState, Sign};
use crate::motion::sphere::{Ball, BallMotion, Sphere};
use crate::motion::{Plane, State, run};
use crate::numerics::roots::root;
use crate::paper::{
    anisotropic, constant, escape, periodic, rest, sinusoidal, sphere, turntable as table,
};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, SQRT_2, TAU};
pub use trialbook::claims::by_hand::ByHand;

/// All cases, in the paper's order.
pub static CASES: [ByHand; 28] = [
    ByHand {
        claim: "s21-along-acceleration",
        wrong: "the sense, if \"along\" means it; it slides against the acceleration",
        reason: "The table leaves the particle behind: in the table's frame it is the inertial force $-\\bm A$ that pulls",
        case: "Let $\\bm A=-A\\hat{\\bm x}$, as in (3), $\\lambda=\\frac12$, and let the particle move along $+\\hat{\\bm x}$. The inertial force gives it the acceleration $+A$, friction $-\\frac12A$: it goes on along $+\\hat{\\bm x}$, faster and faster. The cosine of the angle between its velocity and $\\bm A$ is {stated} as printed, {found} in the motion",
        digits: 0,
        stated: || Ok(constant::s21_late_sense()),
        found: || sense_of_sliding(),
    },
    ByHand {
        claim: "s22-vy-two-stages",
        wrong: "the second stage is no exponential decay",
        reason: "The premise, a friction across the drive that is proportional to $v_y$, holds only while $\\lvert v_x\\rvert$ stays away from zero. That friction is $\\lambda_0v_y/v$, and at each zero of $v_x$ the divisor is $v_y$ itself: the smaller $v_y$, the larger the part of it that is lost there",
        case: "Take $\\lambda_0=1/\\pi$, as in figure 3. By (39) $\\cos\\tilde\\phi_1=\\frac12$, so that $\\mathfrak w$ passes through zero with the slopes $d\\pm\\lambda_0$, $d=\\sqrt3/2$. Beside a zero $\\mathrm d\\ln v_y/\\mathrm d\\phi=-\\lambda_0/[(d\\pm\\lambda_0)\\lvert\\phi-\\tilde\\phi_1\\rvert]$, until $\\lvert\\mathfrak w\\rvert$ is as small as $v_y$: each passage multiplies $\\ln v_y$ by $(d+\\lambda_0)/(d-\\lambda_0)=2.162$, each period by its square. An exponential decay would multiply it by {stated} in the limit; the motion multiplies it by {found}",
        digits: 3,
        stated: || Ok(1.0),
        found: growth_of_logarithm,
    },
    ByHand {
        claim: "s22-rest-of-period",
        wrong: "a subscript; the end is $\\phi_1+2\\pi$",
        reason: "A subscript. The argument adds up friction over the period that begins at $\\phi_1$, and that ends at $\\phi_1+2\\pi$",
        case: "Take $\\lambda_0=\\frac12$, just below $\\lambda_\\mathrm c$, so that $\\phi_1=\\frac\\pi6$, and $\\phi=\\frac\\pi2$, which lies in the slip. As printed the interval ends at $\\frac52\\pi={stated}$, when the next slip has long begun: the drive exceeds friction again from $\\frac\\pi6+2\\pi={found}$ on",
        digits: 3,
        stated: || Ok(sinusoidal::s22_rest_of_period_end(FRAC_PI_2)),
        found: || Ok(root(|phi| libm::sin(phi) - 0.5, 1.5 * PI, 2.5 * PI)?),
    },
    ByHand {
        claim: "s23-nonzero-again",
        wrong: "a word; it is the acceleration, not the friction",
        reason: "A word: the acceleration of the table becomes nonzero again, not friction. While the particle slides friction is never zero",
        case: "Take $\\eta=\\frac12$ and $\\lambda_0=\\frac14$. In the gap between the pulses, at $\\phi=\\frac34\\pi$, the particle still slides forward, so that friction gives it the acceleration $-\\frac14$. Whatever \"becomes nonzero again\" at $\\pi$ must be zero here: it is {stated} as printed, and {found} for the drive",
        digits: 2,
        stated: || {
            Ok(periodic::s23_nonzero_again(friction([
                0.5,
                0.25,
                0.75 * PI,
            ])?))
        },
        found: || Ok(pulses(0.5)?.h(0.75 * PI)),
    },
    ByHand {
        claim: "s24-region-2",
        wrong: "beyond Y, for $q>q_Y=4.603$, region II does not reach up to curve C but only to curve E, where the forward motion ends just when the drive ceases to pull backward",
        reason: "(54) asks whether the forward motion ends before the drive can pull backward. It may also last until the drive can no longer pull backward, and then there is no backward motion. The border of that is curve E",
        case: "Take $q=9$, $\\lambda_0=0.1$: below curve C at $1/9$, and far above curve A. The drive can pull backward only while $\\sin\\phi<-0.9$, from $\\phi=4.261$ to $5.163$. The forward motion begins at $0.100$, and at $5.163$ its velocity is $0.995-0.436-0.1\\,(5.163-0.100)=0.053$, still positive. Backward intervals in a period: {stated} printed, {found} in the motion",
        digits: 0,
        stated: || {
            Ok(backward(
                &anisotropic::signs()[printed_region(9.0, 0.1)? - 1],
            ))
        },
        found: || {
            let motion = drift::attractor(9.0, 0.1)?;
            let signs = motion.intervals().iter().map(|i| i.sign.factor());
            Ok(backward(&signs.collect::<Vec<_>>()))
        },
    },
    ByHand {
        claim: "eq-55",
        wrong: "beyond $Y$, for $q>q_Y$, curve C is no border",
        reason: "The drive can pull backward only below curve C. But beyond $Y$ the forward motion outlasts that time already from curve E on, which lies lower: on both sides of curve C the motion is that of region IV",
        case: "Take $q=9$. By (55) backward motion ends at $\\lambda_0=\\frac19={stated}$; at $\\lambda_0=0.1$, below that, there is none, as shown for region II. In the simulation it ends at {found}, on curve E",
        digits: 4,
        stated: || Ok(anisotropic::eq55_lambda0(9.0)),
        found: || drift::last_backward(9.0),
    },
    ByHand {
        claim: "fig-5",
        wrong: "curve E, the border of region II beyond $Y$, is missing",
        reason: "The diagram lacks curve E, the border of region II beyond Y, and there curve C is not a border",
        case: "Take $q=6.5$, $\\lambda_0=0.15$, just below curve C at $0.154$. The last moment at which the drive can pull backward, $\\sin\\phi=-0.975$, is $\\phi=4.936$; the forward motion, begun at $0.151$, has the velocity $0.989-0.222-0.15\\,(4.936-0.151)=0.049$ there, still positive. The diagram puts the point into region {stated}; the motion is that of region {found}",
        digits: 0,
        stated: || Ok(printed_region(6.5, 0.15)? as f64),
        found: || Ok(drift::fits(drift::simulated(6.5, 0.15)?) as f64),
    },
    ByHand {
        claim: "eq-75",
        wrong: "the sign of the second term",
        reason: "By (61) and (71) $\\bm u-\\dot{\\bm\\rho}=\\hat{\\bm z}\\times\\bm\\zeta$, and $\\hat{\\bm z}\\times(\\hat{\\bm z}\\times\\bm\\zeta)=\\hat{\\bm z}\\zeta_3-\\bm\\zeta$",
        case: "A sphere rolls towards $+\\hat{\\bm x}$ with $\\dot{\\bm\\rho}=\\hat{\\bm x}$, $\\bm u=0$. Its top moves forward, so it turns about $+\\hat{\\bm y}$. Printed: $\\zeta_y={stated}$. In the motion: $\\zeta_y={found}$",
        digits: 3,
        stated: || Ok(sphere::eq75_spin(0.0, [0.0; 3], [1.0, 0.0, 0.0])[1]),
        found: || {
            let end = thrown(0.0, 2.0)?.end();
            Ok(end.omega[1] / end.v[0])
        },
    },
    ByHand {
        claim: "eq-82",
        wrong: "a factor $1/\\gamma$ is missing",
        reason: "(13) contains $A$; in units of $\\mu g$ its place is taken by $\\gamma=A/(\\mu g)$, which has been left out",
        case: "A solid sphere, $b=\\frac72$, on a plane with $A=2\\mu g$: $\\gamma=2$, $\\lambda=\\frac74$. It is thrown across, $\\theta_0=\\pi/2$, without spin, with $u_0=1$. By (74) $\\lambda u+u_x$ changes at the rate $\\gamma(1-\\lambda^2)=-\\frac{33}8$, from $\\frac74$ to 0: the slip ends at $\\tau=\\frac{14}{33}$. Printed: {stated}. In the motion: {found}",
        digits: 4,
        stated: || Ok(sphere::eq82_time(1.75, 1.0, FRAC_PI_2, 1e-12)),
        found: end_of_slip,
    },
    ByHand {
        claim: "eq-83",
        wrong: "the factor $\\gamma$ of $\\tau$ is missing",
        reason: "It follows from (82) as printed and lacks the same $\\gamma$",
        case: "The same sphere at the end of its slip, $\\tau=\\frac{14}{33}$, $\\theta=0$. Printed: $u=[(1-\\frac{49}{16})\\frac{14}{33}+\\frac74]/(\\frac74+1)={stated}$. In the motion: $u={found}$",
        digits: 4,
        stated: || {
            Ok(sphere::eq83_slip_at_time(
                1.75,
                1.0,
                FRAC_PI_2,
                0.0,
                14.0 / 33.0,
            ))
        },
        found: || {
            let slip = thrown(2.0, 1.0)?.slip(end_of_slip()?)?;
            Ok(libm::hypot(slip[0], slip[1]))
        },
    },
    ByHand {
        claim: "s4-projection-azimuthal",
        wrong: "a letter; it is the rate of $p$",
        reason: "A letter: section 4 has no $u$. The rate that is needed is that of $p$, (99)",
        case: "Take $p=1$, $\\ell=1$, $\\xi=2$. By (91) $p\\ell$ changes at the rate $-2p\\xi-\\ell={stated}$; that alone does not give $\\dot\\ell$. With the rate of $p$, by (99) $\\dot p=1$, it is $\\dot\\ell=(-5-1)/1$, as (100) has it. In the motion $\\dot\\ell={found}$",
        digits: 3,
        stated: || Ok(table::s4_azimuthal_rate(1.0, 1.0, 2.0, 0.0)),
        found: || projections::in_the_motion(|v| v.ell),
    },
    ByHand {
        claim: "s4-projection-radial",
        wrong: "a letter; it is the rate of $p$",
        reason: "The same letter: the rate of $p$ is meant",
        case: "Take the same state, $p=1$, $\\ell=1$, $\\xi=2$. By (92) $p\\xi$ changes at the rate $(p+\\ell)^2+\\xi^2-\\xi={stated}$. With the rate of $p$, $\\dot p=1$, it is $\\dot\\xi=(6-2)/1$, as (101) has it. In the motion $\\dot\\xi={found}$",
        digits: 3,
        stated: || Ok(table::s4_radial_rate(1.0, 1.0, 2.0, 0.0)),
        found: || projections::in_the_motion(|v| v.xi),
    },
    ByHand {
        claim: "eq-106",
        wrong: "a factor $\\mu$ is missing in the last term",
        reason: "The length $s$ of (104) is $\\Omega^2/(\\mu g)$ times the length of the path; multiplied by $m(\\mu g)^2/\\Omega^2$ it gives $m\\,\\mu g$ times the length of the path, and the print has lost the $\\mu$",
        case: "Let the table turn so slowly that it is as good as at rest: $m=1$, $\\mu=\\frac12$, $g=10$, and a push of $v=5$. Friction slows it down at the rate $\\mu g=5$, over the distance $s=v^2/(2\\mu g)=2.5$. The last term must make up for the lost energy $\\frac12v^2$. Printed: $mgs={stated}$. In the motion: {found}",
        digits: 1,
        stated: || Ok(-table::friction_work(1.0, 10.0, way()?)),
        found: energy_lost,
    },
    ByHand {
        claim: "s4-coriolis-no-work",
        wrong: "a factor $\\mu$ is missing in the work of friction",
        reason: "As in (106): the work of friction is $-m\\mu gs$. That the Coriolis force does no work is right",
        case: "The same particle: $m=1$, $\\mu=\\frac12$, $g=10$, $v=5$, stopped after $s=2.5$. The work of friction, printed: $-mgs={stated}$. In the motion the kinetic energy changes by $-\\frac12v^2={found}$",
        digits: 1,
        stated: || Ok(table::friction_work(1.0, 10.0, way()?)),
        found: || Ok(-energy_lost()?),
    },
    ByHand {
        claim: "eq-128",
        wrong: "$\\psi$ does not keep up with $\\psi_1$: at late times $\\cos\\psi$ is $\\sqrt2\\cos\\psi_1$",
        reason: "$\\psi$ is put at $\\psi_1$, which needs $\\lvert\\dot\\alpha\\rvert\\cosh2\\alpha\\ll1$. In an escape that tends to $1/(2\\sqrt2)$, and $\\cos\\psi$ to $\\sqrt2\\cos\\psi_1$",
        case: "In the laboratory friction is the only force, of size 1, across the position at late times. With $\\rho=p=c\\tau^2$ and the direction $\\vartheta$, $\\ddot\\rho=\\rho\\dot\\vartheta^2$ gives $\\dot\\vartheta=\\sqrt2/\\tau$, and $\\rho\\ddot\\vartheta+2\\dot\\rho\\dot\\vartheta=1$ gives $3\\sqrt2\\,c=1$. By (104) $A^2$ is $2\\int p\\,\\mathrm d\\tau$ up to a constant, so $A=\\frac13 2^{1/4}\\tau^{3/2}$, and $\\mathrm e^\\alpha=2p/A$ gives $\\mathrm e^{2\\alpha}=\\sqrt2\\,\\tau$. Then $1/\\cosh2\\alpha=\\sqrt2/\\tau$ and $(\\cosh\\alpha)/A=\\frac32/\\tau$. The printed right-hand side is $(\\sqrt2-\\frac32)/\\tau={stated}/\\tau$: $\\alpha$ would fall. In the motion $\\dot\\alpha={found}/\\tau$: it grows",
        digits: 4,
        stated: || late(growth::eq128),
        found: || late(growth::alpha_rate),
    },
    ByHand {
        claim: "eq-129",
        wrong: "the factor of $A$",
        reason: "$\\alpha$ is put where $\\dot\\alpha$ vanishes, but $\\dot\\alpha=1/(2\\tau)$ is a third of $(\\cosh\\alpha)/A$. By the right (128) the same step gives $\\sqrt2A$, not $\\frac{3\\sqrt2}4A$",
        case: "At late times $\\cosh\\alpha=\\frac12 2^{1/4}\\tau^{1/2}$, $\\cosh2\\alpha=\\tau/\\sqrt2$ and $A=\\frac13 2^{1/4}\\tau^{3/2}$, so that $(\\cosh\\alpha\\cosh2\\alpha)/A=\\frac3{2\\sqrt2}$. Printed: {stated}. In the motion: {found}",
        digits: 4,
        stated: || Ok(1.0),
        found: || late(growth::product),
    },
    ByHand {
        claim: "eq-130",
        wrong: "the factor of $A$ in the logarithm",
        reason: "It is (129) for large $A$, and inherits its factor",
        case: "$\\alpha-\\frac13\\ln A$ tends to $\\frac13\\ln4={stated}$ as printed. With $\\mathrm e^{2\\alpha}=\\sqrt2\\,\\tau$ and $A=\\frac13 2^{1/4}\\tau^{3/2}$ it is $\\frac13\\ln(3\\sqrt2)$. In the motion: {found}",
        digits: 4,
        stated: || Ok(escape::eq130_alpha(1.0)),
        found: || late(growth::alpha_by_a),
    },
    ByHand {
        claim: "eq-131",
        wrong: "the factor of $A$",
        reason: "It is (113) with (130) inserted, and inherits its factor",
        case: "$\\dot A/A^{1/3}$ tends to $\\frac12 4^{1/3}={stated}$ as printed. With $A=\\frac13 2^{1/4}\\tau^{3/2}$ it is $\\frac12(3\\sqrt2)^{1/3}$. In the motion: {found}",
        digits: 4,
        stated: || Ok(escape::eq131_a_rate(1.0)),
        found: || late(growth::a_rate),
    },
    ByHand {
        claim: "eq-132",
        wrong: "the factor of $\\tau^{3/2}$",
        reason: "It is the integral of (131). The power is right, the factor is not",
        case: "By (104) $A^2/2=s$ up to a constant, and $s=\\int p\\,\\mathrm d\\tau=\\tau^3/(9\\sqrt2)$, see (136). So $A/\\tau^{3/2}$ tends to $\\frac13 2^{1/4}$. Printed: {stated}. In the motion: {found}",
        digits: 4,
        stated: || Ok(growth::printed_size()),
        found: || late(growth::size),
    },
    ByHand {
        claim: "eq-133",
        wrong: "the factor of $\\tau$ in the logarithm",
        reason: "It is (130) with (132) inserted. It is read as $\\alpha=\\frac12\\ln\\frac{4\\tau}3+o(1)$, as (135) and (136) need it; as a mere ratio it would hold with any factor before $\\tau$",
        case: "$\\mathrm e^\\alpha=2p/A$ at large $\\alpha$. With $p=\\tau^2/(3\\sqrt2)$ and $A=\\frac13 2^{1/4}\\tau^{3/2}$, $\\alpha-\\frac12\\ln\\tau$ tends to $\\frac12\\ln\\sqrt2$. Printed: $\\frac12\\ln\\frac43={stated}$. In the motion: {found}",
        digits: 4,
        stated: || Ok(escape::eq133_alpha(1.0)),
        found: || late(growth::excess),
    },
    ByHand {
        claim: "eq-134",
        wrong: "the power of $\\tau$",
        reason: "For large $\\alpha$, $\\pi/2-\\psi_1=2\\mathrm e^{-2\\alpha}$; with (133) that is $\\frac3{2\\tau}$. Printed is $2\\mathrm e^{-\\alpha}$, as if (124) had $\\tanh\\alpha$; and $\\psi$ is not $\\psi_1$",
        case: "By (108) $\\dot\\rho=p\\cos\\psi$. If $p=\\rho=c\\tau^2$, then $2c\\tau=c\\tau^2\\cos\\psi$, whatever $c$ is: $\\cos\\psi=2/\\tau$. At $\\tau=1200$ that is an angle of $1/600$ short of $\\pi/2$. Printed: {stated}. By the motion's limit: {found}",
        digits: 5,
        stated: || Ok(escape::eq134_lag(1200.0)),
        found: || Ok(late(growth::lag)? / 1200.0),
    },
    ByHand {
        claim: "eq-135",
        wrong: "the factor of $\\tau^2$",
        reason: "It is (111) with (132) and (133) inserted. The power is right, the factor is not",
        case: "In the laboratory friction is the only force, of size 1, across the position at late times. With $\\rho=p=c\\tau^2$ and the direction $\\vartheta$, the law along the position is $\\ddot\\rho=\\rho\\dot\\vartheta^2$, so $\\dot\\vartheta=\\sqrt2/\\tau$; across it, $\\rho\\ddot\\vartheta+2\\dot\\rho\\dot\\vartheta=3\\sqrt2\\,c$ must be the friction. The printed $c=\\frac29$ needs a friction of {stated}; it is {found}",
        digits: 4,
        stated: || Ok(3.0 * SQRT_2 * growth::printed_speed()),
        found: || Ok(3.0 * SQRT_2 * late(growth::speed)?),
    },
    ByHand {
        claim: "eq-136",
        wrong: "the factor of $\\tau^2$",
        reason: "It is (112) with (132) and (133) inserted. The power is right, the factor is not",
        case: "In the laboratory friction is the only force, of size 1, across the position at late times. With $\\rho=c\\tau^2$ and the direction $\\vartheta$, $\\ddot\\rho=\\rho\\dot\\vartheta^2$ gives $\\dot\\vartheta=\\sqrt2/\\tau$, and $\\rho\\ddot\\vartheta+2\\dot\\rho\\dot\\vartheta=1$ gives $3\\sqrt2\\,c=1$. Printed: $c={stated}$. In the motion: $c={found}$",
        digits: 4,
        stated: || Ok(escape::eq136_rho(1.0)),
        found: || late(growth::distance),
    },
    ByHand {
        claim: "eq-137",
        wrong: "the factor of $\\tau^3$",
        reason: "It is the integral of (135)",
        case: "$s=\\int p\\,\\mathrm d\\tau$ is a third of $c\\tau^3$, with the $c$ of (136): $s/\\tau^3$ tends to $1/(9\\sqrt2)$. Printed: {stated}. In the motion: {found}",
        digits: 5,
        stated: || Ok(escape::eq137_s(1.0)),
        found: || late(growth::way),
    },
    ByHand {
        claim: "eq-146",
        wrong: "the true surfaces have no envelope",
        reason: "The derivative of (145) is right. But an envelope needs it to vanish somewhere, and for the surfaces of the motion it is positive everywhere. At $\\alpha=\\sqrt2(1-\\sigma)$ the terms left out of (145) are as large as those kept",
        case: "With $a=A-1$ and $\\alpha$ small and $\\psi=2\\alpha$, (113) and (114) are $\\dot a=\\alpha$, $\\dot\\alpha=a$, so that $a^2-\\alpha^2$ keeps its value at rest, $(1-\\sigma)^2$: $A=1-\\sqrt{(1-\\sigma)^2+\\alpha^2}$ on the surface of $\\sigma$. At $\\alpha=\\sqrt2(1-\\sigma)$ the slope $\\partial A/\\partial\\sigma$ is $1/\\sqrt3$. Printed: {stated}. In the motion, with $1-\\sigma$ below a hundredth: {found}",
        digits: 2,
        stated: || Ok(rest::eq146_right(0.5, 0.5 * SQRT_2)),
        found: || {
            let surface = surfaces().last().ok_or("no surface")??;
            Ok(surface.slope)
        },
    },
    ByHand {
        claim: "eq-147",
        wrong: "the true surfaces have no envelope",
        reason: "The algebra from (145) and (146) is right, but there is no envelope",
        case: "With $a=A-1$ and $\\alpha$ small and $\\psi=2\\alpha$, (113) and (114) are $\\dot a=\\alpha$, $\\dot\\alpha=a$: what starts with $a<-\\alpha$ comes to rest, what starts with $a>-\\alpha$ escapes. At $\\alpha=0.1$ the boundary is near $A=1-\\alpha=0.9$. Printed: {stated}. By bisection on the motion, $\\psi=0.2$: {found}",
        digits: 4,
        stated: || Ok(rest::eq147_a(0.1)),
        found: || boundary_example(),
    },
    ByHand {
        claim: "s4-psi-free",
        wrong: "the surface depends on $\\psi$, unless $\\lvert\\psi\\rvert\\ll1$",
        reason: "(145) holds once $\\psi$ has relaxed. While it relaxes, $A$ grows too, and by as much: by (114) and (115) $\\mathrm d\\ln\\alpha/\\mathrm d\\psi=(1/\\sigma-\\cos\\psi)/\\sin\\psi$ for small $\\alpha$, and by (113) $\\mathrm dA/\\mathrm d\\psi=-\\alpha^2/\\sin\\psi$",
        case: "Take $\\sigma=\\frac12$ and $\\psi=\\frac\\pi2$ at the start, with $\\alpha=\\alpha_0$. With $t=\\tan\\frac\\psi2$, which falls from 1 to 0, the first equation gives $\\alpha=\\frac12\\alpha_0t(1+t^2)$, as $\\mathrm d\\psi/\\sin\\psi=\\mathrm dt/t$, and the second lets $A$ grow by $\\int\\alpha^2\\,\\mathrm dt/t=\\frac14\\alpha_0^2\\int_0^1t(1+t^2)^2\\,\\mathrm dt=\\frac7{24}\\alpha_0^2$ on the way to $\\sigma$. $(\\sigma-A)/\\alpha_0^2$ at the start, printed: {stated}. In the motion, as $\\alpha_0\\to0$: {found}",
        digits: 3,
        stated: || Ok(0.5 - rest::eq145_a(0.5, 1.0)),
        found: || bend(0.5, FRAC_PI_2),
    },
    ByHand {
        claim: "s4-envelope-is-boundary",
        wrong: "the true surfaces have no envelope",
        reason: "(145) holds for $\\alpha\\ll1-\\sigma$, and its envelope lies at $\\alpha=\\sqrt2(1-\\sigma)$, where (145) does not hold. Besides, each point of an envelope lies on one of the surfaces: a start there comes to rest, and so does every start near it. So an envelope of these surfaces cannot be the boundary",
        case: "Take $\\alpha=0.1$, $\\psi=0.2$. With $a=A-1$ small, (113) and (114) are $\\dot a=\\alpha$, $\\dot\\alpha=a$: the states on $a=-\\alpha$ creep towards $\\alpha=0$ for ever, and those below come to rest. So the boundary is near $A=1-\\alpha=0.9$. Printed: {stated}. By bisection on the motion: {found}. According to the print a start with $A=0.88$ escapes; in fact it comes to rest",
        digits: 4,
        stated: || Ok(rest::eq147_a(0.1)),
        found: || boundary_example(),
    },
];

/// The limit of a quantity of an escape, which does not depend on the start.
fn late(quantity: Quantity) -> Result<f64, Failure> {
    let escape = escapes().next().ok_or("no escape")??;
    Ok(growth::limit(escape, quantity)?.value)
}

/// The factor by which ln v_y grows in a period at friction 1/π.
fn growth_of_logarithm() -> Result<f64, Failure> {
    let motion = settled(FRAC_1_PI, ORIGIN)?;
    let mut slips = motion.intervals().iter();
    let slip = slips.rfind(|i| i.sign == Sign::Positive);
    let slip = slip.ok_or("no slip")?;
    let phi = 0.5 * (slip.start + slip.end);
    let start = PlanarState {
        phi,
        w_x: motion.w(phi),
        ln_w_y: -1e9,
    };
    let states = drive()?.planar(FRAC_1_PI, start, &[phi + TAU])?;
    let end = states.first().ok_or("no state")?;
    Ok(end.ln_w_y / start.ln_w_y)
}

/// The region that the printed list gives to a point.
fn printed_region(q: f64, lambda0: f64) -> Result<usize, Failure> {
    let region = anisotropic::region(lambda0, &Curves::at(q)?.printed);
    Ok(region.ok_or("the point lies on a curve")?)
}

/// The number of backward intervals among those of a period.
fn backward(signs: &[f64]) -> f64 {
    signs.iter().filter(|sign| **sign < 0.0).count() as f64
}

/// A solid sphere thrown across with slip velocity 1 and no spin, on a plane with A = γμg, units of R and μg.
fn thrown(gamma: f64, until: f64) -> Result<BallMotion, Failure> {
    let start = match gamma {
        // Nothing is across: along the x axis.
        0.0 => [1.0, 0.0],
        _ => [0.0, 1.0],
    };
    let start = Ball {
        t: 0.0,
        x: [0.0, 0.0],
        v: start,
        omega: [0.0; 3],
    };
    Ok(Sphere::with_kappa(0.4).run(&Plane::constant([-gamma, 0.0]), &start, until)?)
}

/// The time at which the sphere with γ = 2 begins to roll.
fn end_of_slip() -> Result<f64, Failure> {
    let motion = thrown(2.0, 1.0)?;
    Ok(motion.transitions().first().ok_or("it slips on")?.t)
}

/// The motion of a particle that friction of 5 slows down from the velocity 5: its end.
fn stopped() -> Result<State, Failure> {
    let start = State {
        t: 0.0,
        v: [5.0, 0.0],
        x: [0.0, 0.0],
    };
    Ok(run(&Plane::constant([0.0, 0.0]), 5.0, start, 2.0)?.end())
}

/// The way that it makes.
fn way() -> Result<f64, Failure> {
    Ok(stopped()?.x[0])
}

/// The kinetic energy that it loses, mass 1.
fn energy_lost() -> Result<f64, Failure> {
    let v = stopped()?.v[0];
    Ok(0.5 * (25.0 - v * v))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::PAPER;
    use std::f64::consts::LN_2;

    #[test]
    fn every_case_shows_a_difference() {
        for case in &CASES {
            assert!(PAPER.find(case.claim).is_some(), "{}", case.claim);
            let (stated, found) = ((case.stated)().unwrap(), (case.found)().unwrap());
            let step = 0.1_f64.powi(case.digits as i32);
            assert!(
                (stated - found).abs() > 3.0 * step || case.digits == 0 && stated != found,
                "{}: {stated}, {found}",
                case.claim
            );
            let words = case.words().unwrap();
            assert!(!words.contains("{stated}") && !words.contains("{found}"));
            assert_eq!(words.matches('$').count() % 2, 0, "{words}");
        }
    }

    #[test]
    fn the_two_numbers_of_a_case_are_those_of_pencil_and_paper() {
        let (third, fourth) = (1.0 / 3.0, 2.0_f64.powf(0.25));
        let s = 0.5 * 3.0_f64.sqrt();
        let passage = (s + FRAC_1_PI) / (s - FRAC_1_PI);
        let by_hand = [
            ("s21-along-acceleration", 1.0, -1.0),
            ("s22-vy-two-stages", 1.0, passage * passage),
            ("s22-rest-of-period", 2.5 * PI, PI / 6.0 + TAU),
            ("s23-nonzero-again", -0.25, 0.0),
            ("s4-projection-azimuthal", -5.0, -5.0 - 1.0),
            ("s4-projection-radial", 6.0, 6.0 - 2.0),
            ("s24-region-2", 1.0, 0.0),
            ("eq-55", 1.0 / 9.0, 0.096_159),
            ("fig-5", 2.0, 4.0),
            ("eq-75", -1.0, 1.0),
            ("eq-82", 28.0 / 33.0, 14.0 / 33.0),
            (
                "eq-83",
                ((1.0 - 49.0 / 16.0) * 14.0 / 33.0 + 1.75) / 2.75,
                0.0,
            ),
            ("eq-106", 25.0, 12.5),
            ("s4-coriolis-no-work", -25.0, -12.5),
            ("eq-128", SQRT_2 - 1.5, 0.5),
            ("eq-129", 1.0, 1.5 / SQRT_2),
            ("eq-130", third * 4.0_f64.ln(), third * (3.0 * SQRT_2).ln()),
            ("eq-131", 0.5 * 4.0_f64.cbrt(), 0.5 * (3.0 * SQRT_2).cbrt()),
            ("eq-132", 2.0 / 27.0_f64.sqrt(), third * fourth),
            ("eq-133", 0.5 * (4.0 * third).ln(), 0.25 * LN_2),
            ("eq-134", 0.05, 1.0 / 600.0),
            ("eq-135", 3.0 * SQRT_2 * 2.0 / 9.0, 1.0),
            ("eq-136", 2.0 / 9.0, SQRT_2 / 6.0),
            ("eq-137", 2.0 / 27.0, SQRT_2 / 18.0),
            ("eq-146", 0.0, third.sqrt()),
            ("eq-147", (1.0 - 0.1 / SQRT_2).powi(2), 0.910_959_636),
            ("s4-psi-free", 0.5, 7.0 / 24.0),
            (
                "s4-envelope-is-boundary",
                (1.0 - 0.1 / SQRT_2).powi(2),
                0.910_959_636,
            ),
        ];
        for (id, stated, found) in by_hand {
            let case = PAPER.case(id).unwrap();
            let [left, right] = case.numbers().unwrap();
            let decimals = left.find('.').map_or(0, |point| left.len() - point - 1);
            assert_eq!(
                [&left, &right],
                [
                    &format!("{stated:.decimals$}"),
                    &format!("{found:.decimals$}")
                ],
                "{id}"
            );
            let words = case.words().unwrap();
            assert!(
                words.contains(&left) && words.contains(&right) && words.len() > 100,
                "{id}: {words}"
            );
            assert!(
                !words.contains("{stated}") && !words.contains("{found}"),
                "{id}: {words}"
            );
        }
        assert!(PAPER.case("eq-1").is_none());
        assert_eq!(CASES.len(), by_hand.len());
    }
}
