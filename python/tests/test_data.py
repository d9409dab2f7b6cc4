"""Arrays, recordings, claims and the notebook, against numbers by hand and, where SLIPBOOK names the command, against what that says."""
import _thread
import array
import io
import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import slipbook

PROJECT = pathlib.Path(__file__).parents[2]
PHONE = PROJECT / "tests/data/phone.csv"
COMMAND = os.environ.get("SLIPBOOK")
try:
    import numpy
    import pandas
except ImportError:
    numpy = None


def asked(*words):
    return subprocess.run([COMMAND, *words], capture_output=True, check=True, encoding="utf-8").stdout


def said(*words):
    return json.loads(asked(*words, "--json"))


def columns():
    rows = PHONE.read_text().split("\n")[1:]
    return tuple(zip(*(map(float, row.split(",")) for row in rows if row)))


class Arrays(unittest.TestCase):
    def test_any_numbers_will_do(self):
        given = [0.5, 1.0, 1.5]
        kinds = [given, tuple(given), array.array("d", given), array.array("f", given)]
        if numpy:
            table = numpy.array([given, given]).T
            kinds += [numpy.array(given), numpy.array(given, "f4"), numpy.array(given, ">f8"), table[:, 0], numpy.flip(given)[::-1]]
        # Compared as text, in which nan is nan.
        right = repr(slipbook.turntable_ends(given, given, given))
        for kind in kinds:
            self.assertEqual(repr(slipbook.turntable_ends(kind, kind, kind)), right)
        self.assertEqual(slipbook.turntable_ends(range(2), [0, 0], [0, 0])["sigma"], array.array("d", [0, 1]))
        none = slipbook.turntable_ends([], (), array.array("d"))
        self.assertEqual((len(none["sigma"]), none["outcome"]), (0, []))
        # More than one piece; without a velocity each stays.
        rho = array.array("d", (k / 300000 for k in range(300000)))
        still = slipbook.turntable_ends(rho, zero := array.array("d", [0]) * 300000, zero)["sigma"]
        self.assertLess(max(map(abs, map(float.__sub__, still, rho))), 1e-15)
        refused = slipbook.turntable_ends([math.nan, 0.5], [1, math.inf], [0, 0])
        self.assertEqual(refused["outcome"], ["refused"] * 2)

    @unittest.skipUnless(numpy and COMMAND, "there is no pandas, or SLIPBOOK does not name the command")
    def test_pandas_reads_tables_as_they_are(self):
        table = pandas.read_csv(io.StringIO(asked("ensemble", "--rho", "0.5", "--p", "0:1.5:7", "--psi", "-pi:pi:9", "--csv")))
        table.columns = [head.split(" (")[0] for head in table.columns]
        ends = pandas.DataFrame(slipbook.turntable_ends(table.rho, table.p, table.psi))
        self.assertGreater((table.outcome == "rest").mean(), 0.2)
        pandas.testing.assert_frame_equal(ends[["outcome", "sigma", "tau"]], table[["outcome", "sigma", "tau"]], rtol=1e-6)
        moved = pandas.DataFrame(slipbook.block(mu=0.5, throw=6).run().table("0.5s"))
        self.assertEqual(moved.path.max(), moved.path.iloc[-1])

    @unittest.skipUnless(numpy, "there is no NumPy")
    def test_numpy_takes_arrays_as_they_are(self):
        ends = slipbook.turntable_ends([0.5], [0], [0])
        numpy.asarray(ends["sigma"])[0] = 7
        self.assertEqual(ends["sigma"][0], 7)

    def test_a_long_run_can_be_stopped(self):
        # On two cores each would take six seconds.
        many = array.array("d", [0.5]) * 5000000
        shaken = slipbook.block(mu=0.3, pull="4*sin(10*pi*t)", until="100s")
        self.stopped(lambda: slipbook.turntable_ends(many, many, many))
        self.stopped(lambda: slipbook.find(shaken, "mu", 0.01, 0.4, path="10m"))

    def stopped(self, run):
        # In the background a shell has it ignored.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        asked = []

        def ask():
            asked.append(time.monotonic())
            _thread.interrupt_main()

        threading.Timer(0.2, ask).start()
        with self.assertRaises(KeyboardInterrupt):
            run()
        self.assertLess(time.monotonic() - asked[0], 2)


class Recordings(unittest.TestCase):
    def test_what_windows_writes_is_read(self):
        text = PHONE.read_text(encoding="utf-8").replace("^2", "²")
        self.assertIn("²", text)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "phone.csv")
            for written in [b"\xff\xfe" + text.encode("utf-16-le"), text.encode("latin-1")]:
                file.write_bytes(written)
                self.assertEqual(slipbook.measure(str(file)), slipbook.measure(PHONE))

    def test_a_phone_that_slid(self):
        found = slipbook.measure(PHONE)
        # It was made with these.
        for name, made in [("mu_k", 0.28), ("mu_s", 0.35)]:
            low, high = found[name]
            self.assertTrue(low < made < high < low + 0.02, found)
        self.assertTrue(found["coulomb"] and found["zeroed"] and found["normal"])
        self.assertAlmostEqual(found["noise"], 0.02, delta=0.003)
        self.assertEqual([doing for _, _, doing in found["stretches"]], ["sticks", "slips", "sticks"])
        t, x, y, z = columns()
        for same in [(t, x, y, z), [array.array("d", column) for column in (t, x, y, z)]]:
            self.assertEqual(slipbook.measure(same), found)
        self.assertEqual(slipbook.measure(PHONE, columns="x=2,y=3,z=4", g="9.80665m/s^2"), found)
        # Without what it feels across the board friction seems to be less: the normal force is less than that of level floor.
        level = slipbook.measure((t, x, y))
        self.assertFalse(level["normal"])
        self.assertLess(level["mu_s"][1], found["mu_s"][0])
        still = slipbook.measure((t[:200], x[:200]))
        self.assertIsNone(still["mu_k"])
        self.assertRegex(still["why"][0], "did not slip")

    @unittest.skipUnless(COMMAND, "SLIPBOOK does not name the command")
    def test_the_command_measures_the_same(self):
        for more, words in [({}, []), ({"rest": (0, "1s"), "g": 9.81}, ["--rest", "0s:1s", "--g", "9.81"])]:
            right, found = said("measure", PHONE, *words), slipbook.measure(PHONE, **more)
            for name in ["mu_k", "mu_s", "why"]:
                self.assertEqual(list(found[name]), right[name])
            for name in ["coulomb", "verdict", "noise"]:
                self.assertEqual(found[name], right[name])
            doing = [{"from": start, "to": end, "doing": doing} for start, end, doing in found["stretches"]]
            self.assertEqual(doing, right["stretches"])

    def test_numbers_need_no_decimal_point(self):
        t = list(range(10))
        scene = slipbook.block(mu=0.1, g=10).on((t, [3] * 10, [4] * 10))
        # 5 m/s^2 less 1 m/s^2 of friction.
        self.assertAlmostEqual(scene.run("2s").path, 8, delta=1e-9)
        self.assertEqual(scene.on((t, [3] * 10, [4] * 10, [9] * 10)).run("2s").path, scene.run("2s").path)
        gap = ([*t, 30], [3] * 11)
        with self.assertRaisesRegex(ValueError, "before row 11 is a gap"):
            scene.on(gap)
        self.assertAlmostEqual(scene.on(gap, columns="gaps=bridge").run("20s").path, 400, delta=1e-6)

    def test_what_is_wrong(self):
        t, x = [0.01 * k for k in range(100)], [0] * 100
        measure = slipbook.measure
        for wrong, says in [
            (lambda: measure(([0, 1], [0, 0])), "at least 64 rows, this one has 2"),
            (lambda: measure(([], [])), "at least 64 rows"),
            (lambda: measure((t, x[1:])), "each as long"),
            (lambda: measure([t]), "a recording is"),
            (lambda: measure([t] * 5), "a recording is"),
            (lambda: measure((t, [math.nan, *x[1:]])), "row 1 is wrong"),
            (lambda: measure((t[::-1], x)), "times have to rise"),
            (lambda: measure(([*t[1:], 99], x)), "before row 100 is a gap"),
            (lambda: measure((t, x), columns="x=2"), "gaps=bridge"),
            (lambda: measure((t, x), columns="z"), "columns are chosen as"),
            (lambda: measure((t, x), rest=(1,)), "length 2"),
            (lambda: measure((t, x), rest=("1s", "2m")), "measures something else"),
            (lambda: measure((t, x), rest=(8, 9)), "hardly any rows"),
            (lambda: measure((t, x), g="9.8s"), "measures something else"),
            (lambda: measure((t, x), g=-1), "between 0.001 and 1000"),
            (lambda: measure(PHONE, columns="x=12"), "no column has the name"),
            (lambda: slipbook.block(mu=1).on((t, [math.inf] * 100)), "every value must be finite"),
            (lambda: slipbook.block(mu=1).on((t, x), towards="3m"), "measures something else"),
            (lambda: slipbook.turntable_ends([], [], [], far=math.nan), "must be positive"),
            (lambda: slipbook.sheet("eq-999"), "no claim `eq-999`"),
        ]:
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                wrong()
        for value in [5, (1, 2), ("ab", "cd"), (["1", "2"], [0, 0]), (t, [None] * 100), None]:
            with self.subTest(value), self.assertRaises(TypeError):
                measure(value)
        with self.assertRaises(FileNotFoundError):
            measure("no such file")


class Claims(unittest.TestCase):
    def test_claims(self):
        claims = {claim["id"]: claim for claim in slipbook.claims()}
        self.assertGreater(len(claims), 200)
        # Printed with another sign.
        claim = claims["eq-75"]
        self.assertEqual((claim["equation"], claim["section"], claim["verdict"]), (75, "3", "misprint"))
        self.assertEqual(claim["correction"], claim["plain"].replace("+", "−", 1))
        self.assertRegex(slipbook.sheet("eq-75"), "^eq-75: .*\n(?s:.)*\nverdict: misprint\n")
        for claim in claims.values():
            self.assertEqual(claim["standing"] is None, claim["verdict"] == "undecided")

    @unittest.skipUnless(COMMAND, "SLIPBOOK does not name the command")
    def test_the_command_says_the_same(self):
        right, claims = said("list")["claims"], slipbook.claims()
        self.assertEqual([claim["id"] for claim in claims], [claim["id"] for claim in right])
        for claim, right in zip(claims, right):
            correction = claim.pop("correction")
            self.assertEqual(correction is None, right["corrected"] is None, claim["id"])
            self.assertEqual(claim, {name: right[name] for name in claim})


class Notebook(unittest.TestCase):
    def test_the_notebook_runs(self):
        try:
            import nbclient
            import nbformat
        except ImportError:
            self.skipTest("there is no nbclient")
        folder = PROJECT / "book/python"
        notebook = nbformat.read(folder / "figures.ipynb", 4)
        cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
        self.assertFalse(any(cell.outputs or cell.execution_count for cell in cells), "it is kept without what comes of it")
        # What it asserts is tried with it.
        nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": folder}}).execute()
        outputs = [output.data for cell in cells for output in cell.outputs if "data" in output]
        figures = [data["image/png"] for data in outputs if "image/png" in data]
        self.assertEqual(len(figures), 2)
        # A frame with its axes and words, but nothing in it, has less than 20,000 characters.
        self.assertGreater(min(map(len, figures)), 25000)
        self.assertIn("'mu_k': (0.27", " ".join(data["text/plain"] for data in outputs))


if __name__ == "__main__":
    unittest.main()
