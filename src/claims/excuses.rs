//! Why a trial need not do what every trial has to, where more than one has the same reason. A test asks that each is needed.

// It notices no mistake in what it reads, or reads nothing.
pub(super) const ONE_MOTION: &str = "motions are compared with each other: what is said of them, that they end alike, has no formula";
pub(super) const TWO_KINDS: &str = "that two kinds of motion differ is said without a formula";
pub(super) const FRAME: &str = "the frame of a picture is tried, whose edge no formula gives";
pub(super) const NO_NUMBER: &str =
    "the claim says that there is a threshold, or more, and no number; the bounds are our own";
pub(super) const BESIDE: &str = "it is remarked beside the claim, which has no formula";

// It reads no formula of its claim.
pub(super) const AT_WHICH: &str =
    "at which friction rests appear, and how often; that there are some, or none, others try";
pub(super) const IN_WORDS: &str =
    "the claim in words: where the motion ends, whatever the formula says";
pub(super) const PARTS: &str = "(15) and (16) are what the parabola is made of";
pub(super) const DELAY: &str =
    "the first correction of every late law is the delay of the law's own time, times its power";
pub(super) const BY_THE_LAW: &str =
    "a theorem about every motion, by the law that is proved elsewhere";
pub(super) const BY_EQ1: &str = "(1) never lets the velocity grow before that";
pub(super) const AS_135: &str =
    "the distance grows as the speed, by the formula of (135); that of (136) is the winding";
pub(super) const BETWEEN: &str =
    "where the curves are; which region lies between which, the others try";

// It does not notice a mistake of twice its tolerance.
pub(super) const SIGN: &str = "it states a sign";
pub(super) const BOUNDS: &str = "it sets bounds, to which no motion that is tried comes so close";
pub(super) const JOINTS: &str = "where one case ends, the next begins with the same value: a slight shift shows in the second order only";
pub(super) const HALF: &str =
    "what is compared is at most half the unit, which is the size of its terms";
pub(super) const SUM: &str =
    "the unit is the size of all terms that the motion adds up, of which this is one";
pub(super) const EXPONENT: &str = "an exponent is compared, which no factor changes";
