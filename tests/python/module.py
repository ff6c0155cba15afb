"""What `import couloir` promises. The program beside it, COULOIR_PROGRAM, is the judge of bits."""

import ast
import gc
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import couloir
import numpy as np

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def program(*arguments):
    """The program's standard output."""
    return subprocess.run([os.environ["COULOIR_PROGRAM"], *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def slope(rows=31, columns=41, cell=5.0, steep=0.7):
    """Heights that fall to the south, flat at their foot."""
    y = np.arange(rows)[:, None] * cell
    return np.maximum(y - 40, 0) * steep + np.zeros((1, columns))


def slab(heights, thick=1.0):
    """A release at rest in the upper part."""
    release = np.zeros_like(heights)
    release[22:26, 15:25] = thick
    return release


def sliding():
    heights = slope()
    return couloir.World.of_heights(heights, 5.0, rolling=slab(heights))


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refuses(self, words, act, status=2):
        with self.assertRaises(couloir.Error) as caught:
            act()
        for word in words.split():
            self.assertIn(word, str(caught.exception))
        self.assertEqual(caught.exception.status, status)


class Worlds(Folder):
    def test_a_scene_has_the_bits_of_the_program(self):
        recording = self.folder / "run.couloir"
        summary = json.loads(program("run", "snow-avalanche", "--grid", 40, "--seconds", 2, "--record", recording, "--json"))
        world = couloir.World("snow-avalanche", grid=40)
        world.step(120)
        self.assertEqual(world.tick, 120)
        self.assertEqual(world.hash, summary["state_hash"])

    def test_threads_change_no_bit(self):
        hashes = set()
        for threads in (1, 3):
            world = couloir.World("snow-avalanche", grid=80, threads=threads)
            world.step(90)
            hashes.add(world.hash)
        self.assertEqual(len(hashes), 1)

    def test_what_python_does_is_recorded_and_proven_by_the_program(self):
        world = sliding()
        world.record(self.folder / "mine.couloir")
        world.step(10)
        world.pour(x=100, y=100, radius=15, rate=50, duration=0.5)
        world.blast(x=60, y=110, radius=20, depth=1)
        world.set(param="drag", value=2000)
        world.step(50)
        world.finish()
        self.assertIn("exact", program("replay", self.folder / "mine.couloir", "--no-render", "--verify"))
        world.step(5)
        world.finish()
        again = couloir.replay(self.folder / "mine.couloir")
        self.assertTrue(again.verify())
        self.assertEqual(again.ticks, 60)

    def test_fields_share_memory_and_cannot_be_written(self):
        world = sliding()
        rolling = world.rolling
        self.assertEqual(rolling.shape, world.shape)
        self.assertEqual(rolling.dtype, np.float32)
        before = rolling.copy()
        world.step(30)
        self.assertFalse(np.array_equal(before, rolling))
        self.assertTrue(np.array_equal(rolling, world.rolling))
        with self.assertRaises(ValueError):
            rolling[0, 0] = 1
        with self.assertRaises(ValueError):
            rolling.flags.writeable = True

    def test_an_array_keeps_its_world(self):
        rolling = sliding().rolling
        gc.collect()
        self.assertGreater(float(rolling.sum()), 0)

    def test_mass_is_conserved_to_the_last_quantum(self):
        world = sliding()
        world.pour(x=100, y=100, radius=15, rate=50, duration=1)
        world.step(200)
        volumes = world.volumes
        self.assertEqual(volumes["error"], 0)
        self.assertAlmostEqual(volumes["poured"], 50, places=1)
        lies = float((world.depth.astype(float) + world.rolling).sum()) * world.cell**2
        self.assertAlmostEqual(lies, volumes["standing"] + volumes["rolling"], places=6)

    def test_heights_are_where_they_were_given(self):
        heights = slope() + 1500.25
        cover = np.full_like(heights, 0.5)
        world = couloir.World.of_heights(heights, 5.0, cover=cover, rolling=slab(heights))
        surface = world.datum + world.bedrock.astype(float) + world.depth
        self.assertLess(np.abs(surface - heights).max(), 1e-3)
        self.assertEqual(float(world.rolling[23, 20]), 1.0)
        self.assertEqual(float(world.rolling[20, 23]), 0.0)

    def test_the_order_of_memory_does_not_matter(self):
        heights, release = slope(), slab(slope())
        hashes = set()
        for given in (heights, np.asfortranarray(heights), heights[::-1].copy()[::-1], heights.astype("f4")):
            world = couloir.World.of_heights(given, 5.0, rolling=release)
            world.step(20)
            hashes.add(world.hash)
        self.assertEqual(len(hashes), 1)

    def test_nan_is_where_material_leaves(self):
        heights = slope()
        heights[:6] = np.nan
        world = couloir.World.of_heights(heights, 5.0, rolling=slab(slope(), 3.0))
        world.run_until_rest(60)
        self.assertGreater(world.volumes["out"], 0)
        self.assertEqual(world.volumes["error"], 0)

    def test_runs_until_rest_as_the_program_does(self):
        told = json.loads(program("run", "winter-avalanche", "--grid", 40, "--until-rest", "--json"))
        world = couloir.World("winter-avalanche", grid=40)
        world.run_until_rest()
        self.assertEqual(world.hash, told["state_hash"])
        self.assertTrue(np.isnan(world.arrival).any())
        self.assertGreater(float(world.peak_speed.max()), 5)

    def test_another_thread_cannot_use_a_world_that_is_stepped(self):
        world = couloir.World("snow-avalanche", grid=160)
        stepping = threading.Thread(target=world.step, args=(400,))
        stepping.start()
        refused = counted = 0
        while stepping.is_alive():
            counted += 1  # this thread runs: the lock of Python is released
            try:
                world.hash
            except couloir.Error:
                refused += 1
        stepping.join()
        self.assertGreater(refused, 10)
        self.assertEqual(world.tick, 400)

    def test_ctrl_c_ends_a_long_step_and_leaves_a_whole_world(self):
        world = couloir.World("snow-avalanche", grid=80)
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            world.step(100_000_000)
        ticks, left = world.tick, world.hash
        again = couloir.World("snow-avalanche", grid=80)
        again.step(ticks)
        self.assertEqual(again.hash, left)

    def test_refuses_with_the_sentence_of_the_program(self):
        self.refuses("no scene is named nowhere", lambda: couloir.World("nowhere"))
        self.refuses("grid 3 8 4096", lambda: couloir.World("snow-avalanche", grid=3))
        self.refuses("threads 0 64", lambda: couloir.World("snow-avalanche", threads=0))
        self.refuses("speed not a parameter", lambda: couloir.World("snow-avalanche", set={"speed": 3}))
        self.refuses("model lava", lambda: couloir.World("snow-avalanche", model="lava"))
        self.refuses("flow demo", lambda: couloir.World("flow-disc"))
        heights = slope()
        of = couloir.World.of_heights
        self.refuses("2 axes", lambda: of(heights[0], 5))
        self.refuses("8 4096", lambda: of(heights[:5, :5], 5))
        self.refuses("cell", lambda: of(heights, 0))
        self.refuses("cell", lambda: of(heights, float("nan")))
        self.refuses("without any data", lambda: of(heights * np.nan, 5))
        high = heights.copy()
        high[3, 4] = np.inf
        self.refuses("heights inf row 3 column 4", lambda: of(high, 5))
        self.refuses("rolling shape", lambda: of(heights, 5, rolling=np.zeros((3, 3))))
        self.refuses("rolling -1", lambda: of(heights, 5, rolling=-1))
        self.refuses("cover nan", lambda: of(heights, 5, cover=np.nan))
        self.refuses("rolling 100", lambda: of(heights, 5, rolling=100))
        world = sliding()
        self.refuses("ticks -1", lambda: world.step(-1))
        self.refuses("pour no speed", lambda: world.pour(speed=3))
        self.refuses("pour rate", lambda: world.pour(x=1, y=1, radius=3, duration=1))
        self.refuses("blast depth 1000", lambda: world.blast(x=1, y=1, radius=3, depth=1000))
        self.refuses("blast x nan", lambda: world.blast(x=float("nan"), y=1, radius=3, depth=1))
        self.refuses("no field", lambda: world.field("snow"))
        self.refuses("set param", lambda: world.set(param="nonsense", value=1))
        world.step()
        self.refuses("record() first", lambda: world.record(self.folder / "late.couloir"))
        self.assertFalse((self.folder / "late.couloir").exists())
        with self.assertRaises(TypeError):
            world.step("many")

    def test_a_command_that_clashes_changes_nothing(self):
        world = sliding()
        world.house(x=100, y=20, turn=0)
        world.step()
        before = world.hash
        world.house(x=100, y=20, turn=0)
        self.refuses("tick 1", world.step)
        self.assertEqual(world.hash, before)
        world.step()
        self.assertEqual(world.tick, 2)


class Fronts(Folder):
    def jump_flow(self, mesh, position):
        """Fast left of a line, at rest right of it."""
        x = mesh.positions[:, 0]
        return np.column_stack([np.where(x < position, 4.0, 0.0), np.zeros_like(x)])

    def test_a_front_is_found_where_it_is(self):
        mesh = couloir.Mesh.grid(20, 30, 1.0)
        tracker = couloir.Tracker(mesh, dt=0.1, jump=2.0)
        speeds = []
        for step in range(30):
            points = tracker.advance(self.jump_flow(mesh, 5.0 + 0.4 * step))
            speeds.append(points["w"][points["j"] == points["i"] + 1])
        self.assertGreater(len(points), 19)
        front = 5.0 + 0.4 * 29
        self.assertLess(abs(float(np.median(points["x"])) - front), 0.5)
        self.assertAlmostEqual(float(np.mean(np.concatenate(speeds[10:]))), 4.0, delta=0.4)

    def test_track_is_the_program(self):
        mesh = self.folder / "mesh.obj"
        rows, columns = 12, 15
        with mesh.open("w") as file:
            for y in range(rows):
                for x in range(columns):
                    file.write(f"v {x + 0.1 * (y % 2)} {y} 0\n")
            for y in range(rows - 1):
                for x in range(columns - 1):
                    a = y * columns + x + 1
                    file.write(f"f {a} {a + 1} {a + columns}\nf {a + 1} {a + columns + 1} {a + columns}\n")
        read = couloir.Mesh.read(mesh)
        flow = np.stack([self.jump_flow(read, 3.0 + 0.3 * k) for k in range(20)])
        np.save(self.folder / "flow.npy", flow)
        printed = program("track", mesh, self.folder / "flow.npy", "--dt", 0.1, "--jump", 2).splitlines()[1:]
        frames = couloir.track(read, flow, dt=0.1, jump=2)
        lines = [line.split(",") for line in printed]
        self.assertEqual(len(lines), sum(map(len, frames)))
        self.assertGreater(len(lines), 100)
        mine = [(frame, *point) for frame, points in enumerate(frames) for point in points.tolist()]
        for line, point in zip(lines, mine):
            self.assertEqual([int(line[0]), int(line[2]), int(line[3])], [point[0], point[1], point[2]])
            self.assertEqual([np.float32(number) for number in line[4:]], [np.float32(number) for number in point[3:]])

    def test_refuses_what_is_no_mesh_and_no_flow(self):
        mesh = couloir.Mesh.grid(9, 9, 1.0)
        still = np.zeros((81, 2))
        self.refuses("triangle 0 vertex 3", lambda: couloir.Mesh(np.zeros((3, 2)), [[0, 1, 3]]))
        self.refuses("triangle 0 no area", lambda: couloir.Mesh(np.zeros((3, 2)), [[0, 1, 2]]))
        self.refuses("without triangles", lambda: couloir.Mesh(np.zeros((3, 2)), np.zeros((0, 3), int)))
        self.refuses("jump threshold", lambda: couloir.Tracker(mesh))
        self.refuses("dt 0", lambda: couloir.Tracker(mesh, jump=1, dt=0))
        self.refuses("source guess", lambda: couloir.Tracker(mesh, jump=1, source="guess"))
        self.refuses("level scalar", lambda: couloir.Tracker(mesh, jump=1, source="level"))
        self.refuses("hold", lambda: couloir.Tracker(mesh, jump=1, hold=True))
        tracker = couloir.Tracker(mesh, jump=1)
        self.refuses("velocities 80", lambda: tracker.advance(np.zeros((40, 2))))
        still[5, 1] = np.nan
        self.refuses("nan vertex 5", lambda: tracker.advance(still))
        self.refuses("scalar", lambda: tracker.advance(np.zeros((81, 2)), np.zeros(81)))

    def test_a_level_is_followed_by_a_scalar(self):
        mesh = couloir.Mesh.grid(9, 30, 1.0)
        x = mesh.positions[:, 0]
        frames = couloir.track(mesh, [np.zeros((mesh.vertices, 2))] * 5, [x - 3.25 - 0.1 * k for k in range(5)], source="level", level=0.0)
        self.assertAlmostEqual(float(frames[-1]["x"].mean()), 3.65, places=4)


class Recordings(Folder):
    def test_a_shipped_recording_is_proven(self):
        played = couloir.replay("landslide")
        verdict = played.verify(threads=2)
        self.assertTrue(verdict)
        self.assertEqual(verdict.kind, "exact")
        self.assertEqual(verdict.proven_tick, played.ticks)
        self.assertIsNone(verdict.parted)

    def test_a_changed_number_is_found(self):
        text = (SOURCE / "assets" / "recordings" / "landslide.couloir").read_text()
        damaged = self.folder / "damaged.couloir"
        damaged.write_text(text.replace('"tick":6', '"tick":7', 1))
        self.refuses("damaged.couloir", lambda: couloir.replay(damaged))

    def test_its_world_continues_from_the_start(self):
        played = couloir.replay("landslide")
        world = played.world()
        self.assertEqual(world.tick, 0)
        opened = couloir.World("landslide.couloir")
        world.step(60)
        opened.step(60)
        self.assertEqual(world.hash, opened.hash)


SPEC = """
title = "Small"
scene = "snow-avalanche"
grid = 24
members = 6
seed = 3
seconds = 20

[[variable]]
of = "drag"
uniform = [1000, 2500]
"""


class Ensembles(Folder):
    def spec(self, text=SPEC):
        file = self.folder / "small.toml"
        file.write_text(text)
        return file

    def test_members_are_those_of_the_program(self):
        file = self.spec()
        program("ensemble", file, "--out", self.folder / "out", "--threads", 1)
        journal = sorted((json.loads(line) for line in (self.folder / "out" / "journal.jsonl").read_text().splitlines()[1:]), key=lambda each: each["member"])
        members = list(couloir.ensemble(file, threads=2))
        self.assertEqual([member.number for member in members], [1, 2, 3, 4, 5, 6])
        self.assertEqual([member.hash for member in members], [line["hash"] for line in journal])
        for figure in ("run_out", "top_speed", "toe_x", "toe_y"):
            self.assertEqual([getattr(member, figure) for member in members], [line[figure] for line in journal])
        self.assertEqual([list(member.sample.values()) for member in members], [line["sample"] for line in journal])
        self.assertEqual(len({member.hash for member in members}), 6)

    def test_a_member_is_a_world(self):
        of = couloir.ensemble(self.spec())
        world = of.world(4)
        world.run_until_rest(20)
        self.assertEqual(world.hash, of.play(4).hash)
        self.assertAlmostEqual(world.parameters["drag"], of.sample(4)["drag"], places=3)

    def test_a_loop_may_end_early(self):
        begun = time.monotonic()
        for member in couloir.ensemble(self.spec(SPEC.replace("members = 6", "members = 1000")), threads=2):
            if member.number == 3:
                break
        self.assertLess(time.monotonic() - begun, 300)

    def test_refuses_what_the_program_refuses(self):
        self.refuses("small.toml:10: variable.of", lambda: couloir.ensemble(self.spec(SPEC.replace('"drag"', '"friktion"'))))
        of = couloir.ensemble(self.spec())
        self.refuses("member 7", lambda: of.sample(7))
        self.refuses("member 0", lambda: of.play(0))


class Stubs(unittest.TestCase):
    """couloir.pyi says what is there, and nothing else."""

    def setUp(self):
        self.tree = ast.parse((SOURCE / "game" / "python" / "couloir.pyi").read_text())

    def public(self, body):
        names = {}
        for node in body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and (not node.name.startswith("_") or node.name in ("__init__", "__iter__", "__next__", "__len__", "__bool__")):
                names[node.name] = node
        return names

    def parameters(self, node):
        return [a.arg for a in node.args.args + node.args.kwonlyargs if a.arg != "self"]

    def told(self, function):
        """The parameters in the first line of a docstring."""
        lines = function.__doc__.splitlines()
        line = lines[2] if "**kwargs" in lines[0] else lines[0]
        inside = line[line.index("(") + 1 : line.rindex(")")]
        depth, words, word = 0, [], ""
        for letter in inside + ",":
            depth += (letter in "[({") - (letter in "])}")
            if letter == "," and depth == 0:
                words.append(word.split(":")[0].split("=")[0].strip())
                word = ""
            else:
                word += letter
        return [word for word in words if word and word not in ("self", "*") and not word.startswith(("*", "arg0"))]

    def test_names_are_those_of_the_module(self):
        self.assertEqual(set(self.public(self.tree.body)), {name for name in dir(couloir) if not name.startswith("_")})

    def test_members_and_their_parameters_are_those_of_the_classes(self):
        for name, node in self.public(self.tree.body).items():
            here = getattr(couloir, name)
            if isinstance(node, ast.FunctionDef) or name == "Error":
                continue
            stubs = self.public(node.body)
            self.assertEqual({each for each in stubs if not each.startswith("_")}, {each for each in dir(here) if not each.startswith("_")}, name)
            for each, stub in stubs.items():
                there = getattr(here, each)
                if isinstance(there, property):
                    self.assertTrue(any(getattr(mark, "id", "") == "property" for mark in stub.decorator_list), each)
                elif not each.startswith("__") or each == "__init__" and self.parameters(stub):
                    self.assertEqual(self.parameters(stub), self.told(there), f"{name}.{each}")


if __name__ == "__main__":
    unittest.main()
