"""Scenes from Python against numbers by hand and, where SLIPBOOK names the command, against what that says."""
import ast
import doctest
import json
import math
import os
import pathlib
import subprocess
import tempfile
import threading
import unittest

import slipbook

G = 9.80665
PYTHON = pathlib.Path(__file__).parents[1]
# The command says twelve digits, and each side may be off by some in the last.
DIGITS = 1e-11


class Scenes(unittest.TestCase):
    def near(self, found, right, part=DIGITS):
        self.assertLessEqual(abs(found - right), part * abs(right), (found, right))

    def test_by_hand(self):
        thrown = slipbook.block(mu=0.5, throw="21.6km/h").run()
        self.near(thrown.t, 6 / (0.5 * G))
        self.near(thrown.path, 18 / (0.5 * G))
        self.near(thrown.heat, 18)
        self.assertEqual([what for _, what in thrown.events], ["slides", "rests"])
        # A trailer brakes harder than its load holds.
        trailer = slipbook.block(mu=0.3, mu_s=0.4, pull="4.2m/s^2:4.79s,0")
        drive, friction = 4.2 - 0.3 * G, 0.3 * G
        self.near(trailer.run().path, 0.5 * drive * 4.79**2 * (1 + drive / friction))
        # What lies on an accelerating floor falls behind.
        self.near(slipbook.block(mu=0.1, accelerate=3.0, until="2s").run().x, -2 * (3 - 0.1 * G))
        # Without spin at first, a solid ball rolls with 5/7 of its speed.
        ball = slipbook.ball(mu=0.08, radius="11cm", throw=5).run()
        self.near(ball.v_x, 25 / 7)
        self.near(ball.omega_y, 25 / 7 / 0.11)
        self.assertIn("omega_y", dir(ball))
        self.assertEqual(ball.events[-1], (ball.t, "rolls"))

    def test_the_paper_agrees(self):
        section, numbers = (answer := slipbook.block(mu=0.5, pull=2, throw="3m/s@80deg").run()).second
        self.assertEqual(section, "2.1")
        for name in ["t", "x", "y"]:
            self.near(numbers[name], answer.numbers[name])
        self.assertIsNone(slipbook.block(mu=0.5, throw=3).run().second)

    def test_words(self):
        scene = slipbook.block(mu=0.3, pull=["1m/s^2", "4@90deg"], at=(1, "2m"))
        self.assertEqual(repr(scene), "slipbook.block(mu=0.3, pull=['1m/s^2', '4@90deg'], at='1,2m')")
        other = slipbook.scene(**json.loads(json.dumps(scene.words)))
        self.assertEqual(other.run("1s").numbers, scene.run("1s").numbers)
        self.near(scene.run("1s").v_x, (1 - 0.3 * G / math.hypot(1, 4)))
        self.assertEqual(scene.with_(pull=None, at=None).words, {"body": "block", "mu": 0.3})
        belt = slipbook.block(mu=0.2, belt="2m/s", set_down=True)
        self.near(belt.run().heat, 2)
        self.assertEqual(belt.with_(set_down=False, belt=None).words, {"body": "block", "mu": 0.2})
        stub = ast.parse((PYTHON / "slipbook.pyi").read_text())
        (words,) = (part for part in stub.body if getattr(part, "name", "") == "_Words")
        self.assertEqual([word.target.id for word in words.body], list(slipbook.WORDS))

    def test_moments(self):
        answer = slipbook.block(mu=0.5, throw=6).run()
        table = answer.table("0.5s")
        self.assertEqual(list(table), list(answer.units))
        self.assertEqual(list(table["t"]), [0, 0.5, 1, answer.t])
        self.assertEqual([column[1] for column in table.values()], list(answer.at(0.5).values()))
        self.near(table["x"][2], 6 - 0.25 * G)
        self.assertEqual(table["x"][-1], answer.x)
        self.assertTrue(all(error < 1e-10 for error in answer.errors.values()))

    def test_recordings(self):
        t = [0.01 * k for k in range(201)]
        steady = slipbook.block(mu=0.2).on((t, [3.0] * 201), towards="90deg")
        self.near(steady.run("2s").y, -2 * (3 - 0.2 * G))
        x, y = [3 * math.sin(5 * t) for t in t], [2 * math.cos(7 * t) for t in t]
        by_columns = slipbook.block(mu=0.2, record=(t, x, y)).run("2s")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "shaken.csv"
            rows = (f"{t!r},{x / G!r},{y / G!r}\n" for t, x, y in zip(t, x, y))
            file.write_text("t,u,v\n" + "".join(rows))
            by_file = slipbook.block(mu=0.2, record=file, columns="x=u,y=v,unit=g")
            answer = by_file.run("2s")
        # Rounding in the file, and in the unit.
        self.near(answer.path, by_columns.path)
        self.assertGreater(answer.path, 0.1)
        with self.assertRaises(FileNotFoundError):
            by_file.with_(mu=0.3)
        try:
            import numpy
        except ImportError:
            return
        arrays = slipbook.block(mu=0.2).on(tuple(numpy.array([t, x, y])))
        self.assertEqual(arrays.run("2s").numbers, by_columns.numbers)

    def test_find(self):
        scene = slipbook.block(mu=1, throw="50km/h@30deg")
        (mu,) = slipbook.find(scene, "mu", 0.01, 2, path="20m")
        self.near(mu, (50 / 3.6) ** 2 / (2 * G * 20))
        (speed,) = slipbook.find(scene.with_(mu=mu), "throw", "1km/h", "90km/h", x=20 * math.cos(math.pi / 6))
        self.near(speed, 50)
        self.assertEqual(slipbook.find(scene, "mu", 0.01, 2, path=1), [])

    def test_turntable(self):
        # At rest it stays, if it is near enough; started from far out, it is gone; at rest beyond, there is no telling when.
        ends = slipbook.turntable_ends([0.5, 0.5, 2], [0, 60, 0], [0] * 3)
        self.assertEqual(ends["outcome"], ["rest", "far", "refused"])
        self.assertEqual((ends["sigma"][0], ends["tau"][0]), (0.5, 0))
        self.assertTrue(math.isnan(ends["sigma"][1]))

    def test_what_is_wrong(self):
        block = slipbook.block(mu=0.3)
        for wrong, says in [
            (lambda: slipbook.block(), "mu"),
            (lambda: slipbook.block(mu="0.3m"), "coefficient of friction"),
            (lambda: slipbook.block(mu=math.nan), "NaN"),
            (lambda: block.with_(mu_s=0.2), "at least mu"),
            (lambda: block.with_(throw="3m"), "measures something else"),
            (lambda: block.with_(speed=3), "`speed` is no word"),
            (lambda: block.on(([0, 1], [0])), "each as long"),
            (lambda: block.on(([0, 1], [0, 0])), "at least 7 rows"),
            (lambda: block.with_(pull=4).run(), "never stops"),
            (lambda: block.run(5), "unit"),
            (lambda: block.run("1s").at(2), "t = 2 must be between"),
            (lambda: slipbook.find(block, "nu", 0, 1, x=1), "`nu` is no word"),
            (lambda: slipbook.find(block, "mu", 0, 1), "one number"),
            (lambda: slipbook.find(block, "throw", "1m/s", "9km/h", x=1), "two units"),
            (lambda: slipbook.turntable_ends([1, 2], [1], [0]), "equally many"),
            (lambda: slipbook.turntable_ends([1], [1], [0], far=-1), "-1 must be positive"),
        ]:
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                wrong()
        for value in [object(), 1j, [None], (loop := [])]:
            loop.append(loop)
            with self.assertRaises(TypeError):
                slipbook.block(mu=value)

    def test_others_run_meanwhile(self):
        # A call of some tenths of a second; its own thread holds the interpreter before and after only.
        psi = [6e-5 * k for k in range(50000)]
        work = threading.Thread(target=slipbook.turntable_ends, args=([0.5] * 50000, [0.9] * 50000, psi))
        work.start()
        count = 0
        while work.is_alive():
            count += 1
        self.assertGreater(count, 1000)

    @unittest.skipUnless("SLIPBOOK" in os.environ, "SLIPBOOK does not name the command")
    def test_the_command_says_the_same(self):
        for scene in [
            slipbook.block(mu=0.3, mu_s=0.4, pull="4.2m/s^2:4.79s,0"),
            slipbook.block(mu=0.3, tilt="10deg", pull="4*sin(10*pi*t)", until="2s"),
            slipbook.block(mu=0.2, belt="2m/s", set_down=True, pull=["1", "0.5@90deg"]),
            slipbook.block(mu=0.25, turn="33.3rpm", at="15cm", throw="0.2m/s@120deg", until="rest"),
            slipbook.ball(mu=0.08, radius="11cm", throw="5m/s@1", spin=(1, 2, 3)),
        ]:
            with tempfile.TemporaryDirectory() as folder, self.subTest(repr(scene)):
                file = pathlib.Path(folder) / "scene.json"
                file.write_text(json.dumps(scene.words))
                said = subprocess.run([os.environ["SLIPBOOK"], "scene", file, "--json"], capture_output=True, check=True)
                said, answer = json.loads(said.stdout), scene.run()
                numbers = {name.replace("ω", "omega"): x for name, x in said["answer"].items()}
                self.assertEqual(numbers.keys(), answer.numbers.keys())
                for name, right in numbers.items():
                    # Rounding to the digits that are known takes up to fifty errors; what nothing is known of comes by the same steps all the same.
                    error = answer.errors[name] if math.isfinite(answer.errors[name]) else 0
                    if right is not None:
                        self.assertLessEqual(abs(getattr(answer, name) - right), 50 * error + DIGITS * abs(right), name)
                self.assertEqual([what for _, what in answer.events], [event["doing"] for event in said["order"]])


class Pages(unittest.TestCase):
    """What the pages show is what comes."""

    def test_examples(self):
        for page in [PYTHON / "README.md", PYTHON.parent / "book/src/json.md"]:
            text = page.read_text(encoding="utf-8").replace("\n```", "\n\n")
            test = doctest.DocTestParser().get_doctest(text, {}, page.name, str(page), 0)
            flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
            result = doctest.DocTestRunner(optionflags=flags).run(test)
            self.assertEqual(result.failed, 0)
            self.assertGreater(result.attempted, 4, page)


if __name__ == "__main__":
    unittest.main()
