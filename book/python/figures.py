"""Two figures from the command: where a turntable's particles come to rest, and how fast a shaken one gets."""
import io
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pandas as pd

SLIPBOOK = sys.argv[1] if len(sys.argv) > 1 else "slipbook"
FOLDER = sys.argv[2] if len(sys.argv) > 2 else "."


def ask(line):
    """The answer to a line of the command, as a table; the columns without their units."""
    answer = subprocess.run([SLIPBOOK, *line.split(), "--csv"], capture_output=True, text=True, check=True)
    return pd.read_csv(io.StringIO(answer.stdout)).rename(columns=lambda head: head.split(" (")[0])


# Rest and escape: a particle at rho = 1/2 with any velocity.
ends = ask("ensemble --rho 0.5 --p 0:1.5:61 --psi -pi:pi:121")
ends["settled"] = ends.sigma.where(ends.outcome == "rest")
table = ends.pivot(index="p", columns="psi", values="settled")
figure, axes = plt.subplots()
colours = axes.pcolormesh(table.columns, table.index, table.to_numpy(), shading="nearest")
figure.colorbar(colours, label="distance from the axis at rest (μg/Ω²)")
axes.set(xlabel="ψ (radians)", ylabel="p", title=f"{(ends.outcome == 'rest').mean():.0%} come to rest")
figure.savefig(f"{FOLDER}/rest.png", dpi=150)

# The shaken particle: above the critical friction it rests twice in each period.
sweep = ask("solve sinusoidal --lambda0 0.05:0.95:91")
assert sweep.digits.min() >= 10, "a row is not known to ten digits"
figure, axes = plt.subplots()
axes.plot(sweep.lambda0, sweep.w_max)
axes.axvline(float(ask("find 2/sqrt(4+pi^2)").value[0]), linestyle=":", label="critical friction")
axes.set(xlabel="λ₀", ylabel="largest velocity (A₀/ω)")
axes.legend()
figure.savefig(f"{FOLDER}/sweep.png", dpi=150)
