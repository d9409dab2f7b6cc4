from collections.abc import Collection, Sequence
from os import PathLike
from typing import Final, Literal, TypeAlias, TypedDict, final

from typing_extensions import Unpack

# A number in SI, or a text with its unit.
Value: TypeAlias = str | float
Values: TypeAlias = Value | Sequence[Value]
# Any sequence of numbers: a list, an array of NumPy.
Column: TypeAlias = Collection[float]
Recording: TypeAlias = str | PathLike[str] | tuple[Column, Column] | tuple[Column, Column, Column]

class Words(TypedDict, total=False):
    mu: Value | None
    mu_s: Value | None
    mu_back: Value | None
    g: Value | None
    radius: Value | None
    kappa: Value | None
    tilt: Value | None
    pull: Values | None
    accelerate: Values | None
    record: Recording | None
    columns: str | None
    towards: Value | None
    turn: Value | None
    belt: Value | None
    at: Values | None
    throw: Value | None
    throw_in_room: Value | None
    set_down: bool
    spin: Values | None
    width: Value | None
    within: Value | None
    until: str | None

WORDS: dict[str, str]
__version__: str

@final
class Answer:
    t: Final[float]
    x: Final[float]
    y: Final[float]
    v_x: Final[float]
    v_y: Final[float]
    # Of a ball alone.
    omega_x: Final[float]
    omega_y: Final[float]
    omega_z: Final[float]
    path: Final[float]
    heat: Final[float]
    numbers: Final[dict[str, float]]
    errors: Final[dict[str, float]]
    units: Final[dict[str, str]]
    events: Final[list[tuple[float, Literal["slides", "rests", "rolls"]]]]
    second: Final[tuple[str, dict[str, float]] | None]
    def at(self, t: Value) -> dict[str, float]: ...
    def table(self, dt: Value) -> dict[str, list[float]]: ...

@final
class Scene:
    words: Final[dict[str, object]]
    def with_(self, **words: Unpack[Words]) -> Scene: ...
    def on(self, record: Recording, /, **words: Unpack[Words]) -> Scene: ...
    def run(self, until: str | None = None) -> Answer: ...

def block(**words: Unpack[Words]) -> Scene: ...
def ball(**words: Unpack[Words]) -> Scene: ...
def scene(body: Literal["block", "ball"], **words: Unpack[Words]) -> Scene: ...
def find(scene: Scene, word: str, low: Value, high: Value, **number: Value) -> list[float]: ...
def turntable_ends(
    rho: Column, p: Column, psi: Column, *, far: float = 100.0, late: float = 50.0
) -> dict[str, list]: ...
