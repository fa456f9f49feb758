"""Results, memory, threads and interrupts of quell.Denoiser and quell.denoise."""

import gc
import os
import pathlib
import pickle
import resource
import runpy
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tracemalloc
import unittest
import weakref

import numpy as np

import quell
from walls import in_c, of_all_channels, pictures, planes_of, same_bits, some_camera, wall

HEIGHT, WIDTH = 34, 61
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"


class Results(unittest.TestCase):
    def test_python_gives_the_bits_of_c(self):
        for preset in quell.presets():
            with self.subTest(preset):
                denoiser = quell.Denoiser(preset, (HEIGHT, WIDTH))
                frames = [of_all_channels(denoiser, seed) for seed in range(3)]
                made = pictures(denoiser, frames)
                self.assertTrue(same_bits(made.reshape(3, HEIGHT, WIDTH, -1), in_c(preset, frames)))

    def test_anti_aliased_and_upsampled_python_gives_the_bits_of_c(self):
        for preset in quell.presets():
            for output in (HEIGHT, WIDTH), (2 * HEIGHT, 2 * WIDTH), (51, 200):
                with self.subTest(preset, output=output):
                    denoiser = quell.Denoiser(preset, (HEIGHT, WIDTH), stages=["resolve"], output_size=output)
                    frames = [of_all_channels(denoiser, seed) for seed in range(3)]
                    made = pictures(denoiser, frames)
                    self.assertEqual(denoiser.output_size, output)
                    self.assertTrue(same_bits(made.reshape(3, *output, -1), in_c(preset, frames, output)))

    def test_jitter_and_frames_of_several_sizes(self):
        output = (2 * HEIGHT, 2 * WIDTH)
        by_jitter, by_camera = (quell.Denoiser("svgf", (HEIGHT, WIDTH), output_size=output) for _ in range(2))
        self.assertTrue(by_jitter.needs_camera)
        for seed, size in enumerate([(HEIGHT, WIDTH), (30, 50), (HEIGHT, WIDTH)]):
            jitter = (0.25 * seed - 0.25, 0.125)
            camera = quell.Camera(np.eye(4), np.eye(4), jitter)
            made = by_jitter(wall(*size, seed), jitter=jitter)
            self.assertEqual(made.shape, (*output, 3))
            self.assertTrue(same_bits(made, by_camera({**wall(*size, seed), "camera": camera})))
        fresh = quell.Denoiser("svgf", (HEIGHT, WIDTH), output_size=output)(wall(HEIGHT, WIDTH, 2), jitter=(0.25, 0.125))
        self.assertFalse(same_bits(made, fresh))
        frames = [{**wall(HEIGHT, WIDTH, seed), "jitter": (0.1 * seed, 0)} for seed in range(3)]
        found = np.stack(list(quell.denoise(frames, "svgf", later_frames=0, output_size=output)))
        self.assertTrue(same_bits(found, pictures(quell.Denoiser("svgf", (HEIGHT, WIDTH), output_size=output), frames)))

    def test_wrong_output_sizes_and_jitter_are_refused(self):
        frame = wall(HEIGHT, WIDTH)
        for size in (HEIGHT - 1, WIDTH), (4 * HEIGHT + 1, WIDTH), (0, 0):
            with self.assertRaisesRegex(quell.Error, "1 to 4 times"):
                quell.Denoiser("svgf", (HEIGHT, WIDTH), output_size=size)
        with self.assertRaisesRegex(quell.Error, "output_size"):
            quell.Denoiser("svgf", (HEIGHT, WIDTH), output_size=(1, 2, 3))
        denoiser = quell.Denoiser("svgf", (HEIGHT, WIDTH), stages=["resolve"])
        for jitter, words in (None, "camera"), ((0, np.nan), "at most 8"), ((9, 0), "at most 8"), ((1, 2, 3), "jitter"):
            with self.assertRaisesRegex(quell.Error, words):
                denoiser(frame, jitter=jitter)
        with self.assertRaisesRegex(quell.Error, "camera"):
            denoiser(frame, jitter=(0, 0), camera=some_camera())
        with self.assertRaisesRegex(quell.Error, "resolve"):
            quell.Denoiser("svgf", (HEIGHT, WIDTH))(frame, jitter=(0, 0))
        with self.assertRaisesRegex(quell.Error, "1 to 4 times"):
            denoiser(wall(HEIGHT // 5, WIDTH), jitter=(0, 0))
        nothing = {name: channel[:0, :0] for name, channel in frame.items()}
        with self.assertRaisesRegex(quell.Error, "an image of 0x0"):
            denoiser(nothing, jitter=(0, 0))
        self.assertTrue(np.isfinite(denoiser(frame, jitter=(0, 0))).all())

    def test_noisy_guides_are_made_steady(self):
        plain, steady = quell.Denoiser("svgf", (HEIGHT, WIDTH)), quell.Denoiser("svgf", (HEIGHT, WIDTH), stages=("steady-depth", "steady-albedo"))
        random = np.random.default_rng(1)
        frames = []
        for seed in range(3):
            frame = wall(HEIGHT, WIDTH, seed)
            frame["depth"] = 4 + random.random((HEIGHT, WIDTH), np.float32)
            frame["albedo"] = random.random((HEIGHT, WIDTH, 3), np.float32)
            frame["radiance"] = frame["albedo"]  # light of 1
            frames.append(frame)
            pictures_of_both = plain(frame), steady(frame)
        # The picture is multiplied by an albedo that differs less.
        self.assertLess(pictures_of_both[1].std(), 0.8 * pictures_of_both[0].std())
        in_sequence = list(quell.denoise(frames, "svgf", later_frames=0, stages=["steady-depth", "steady-albedo"]))
        self.assertTrue(same_bits(in_sequence[-1], pictures_of_both[1]))
        for stages in ("steady-depth", "two-sided"), "steady-depth", ("steady-normal",), ("steady-depth,resolve",):
            with self.assertRaisesRegex(quell.Error, "stages: .*(steady-|two-sided)"):
                quell.Denoiser("svgf", (HEIGHT, WIDTH), stages=stages)
            with self.assertRaisesRegex(quell.Error, "stages: .*(steady-|two-sided)"):
                next(quell.denoise(frames, "svgf", stages=stages, later_frames=0))

    def test_history_or_the_frame_alone_by_what_samples_say(self):
        history, chosen = (quell.Denoiser("svgf", (HEIGHT, WIDTH), stages=stages) for stages in ([], ["evidence"]))
        frames = [wall(HEIGHT, WIDTH, seed) for seed in range(8)]
        frames[-1]["radiance"] = 10 * frames[-1]["radiance"]
        for frame in frames:
            with_history, made = history(frame), chosen(frame)
        alone = quell.Denoiser("svgf", (HEIGHT, WIDTH))(frames[-1])
        self.assertLess(np.abs(made - alone).mean(), 0.5 * np.abs(with_history - alone).mean())
        in_sequence = list(quell.denoise(frames, "svgf", later_frames=0, stages=["evidence"]))
        self.assertTrue(same_bits(in_sequence[-1], made))
        if "none" in quell.presets():
            with self.assertRaisesRegex(quell.Error, "'none' has no history.*leave 'evidence' out"):
                quell.Denoiser("none", (HEIGHT, WIDTH), stages=["evidence"])

    def test_light_given_back(self):
        self.assertLessEqual({"two-sided", "evidence", "light", "resolve", "steady-depth", "steady-albedo"}, set(quell.stages()))
        some = [], ["light"], ["light", "evidence"]
        plain, given, chosen = (quell.Denoiser("svgf", (HEIGHT, WIDTH), stages=stages, samples_per_pixel=16) for stages in some)
        frames = [wall(HEIGHT, WIDTH, seed) for seed in range(4)]
        for frame in frames:
            frame["radiance"][:, ::4] += 1  # stripes that the filter blurs
            before, after = plain(frame), given(frame)
            self.assertTrue(np.isfinite(chosen(frame)).all())
        lit = np.zeros((HEIGHT, WIDTH, 1), np.float32)
        lit[:, ::4] = 1
        contrast = [float((picture * lit).sum() / lit.sum() - (picture * (1 - lit)).sum() / (1 - lit).sum()) for picture in (before, after)]
        self.assertGreater(contrast[1], 1.05 * contrast[0])
        in_sequence = list(quell.denoise(frames, "svgf", later_frames=0, stages=["light"], samples_per_pixel=16))
        self.assertTrue(same_bits(in_sequence[-1], after))
        self.assertIn("Behind it, light:", given.plan)
        self.assertGreater(given.statistics.bytes, plain.statistics.bytes)
        with self.assertRaisesRegex(quell.Error, "samples_per_pixel: -1"):
            quell.Denoiser("svgf", (HEIGHT, WIDTH), samples_per_pixel=-1)
        if "none" in quell.presets():
            with self.assertRaisesRegex(quell.Error, "'none' makes no single colour.*leave 'light' out"):
                quell.Denoiser("none", (HEIGHT, WIDTH), stages=["light"])

    @unittest.skipUnless("accumulated" in quell.presets(), "skipped: guides, which want the preset accumulated")
    def test_guides_are_the_means_of_the_frames(self):
        denoiser = quell.Denoiser("accumulated", (HEIGHT, WIDTH))
        with self.assertRaisesRegex(quell.Error, "no frame"):
            denoiser.guide("mean_albedo")
        for albedo in (0.5, 0.25):
            colour = np.full((HEIGHT, WIDTH, 3), albedo, np.float32)
            denoiser(dict(wall(HEIGHT, WIDTH), radiance=colour, albedo=colour))
        self.assertEqual(denoiser.guide("mean_normal").shape, (HEIGHT, WIDTH, 3))
        self.assertAlmostEqual(float(denoiser.guide("mean_albedo")[20, 30, 1]), 0.375, places=4)
        with self.assertRaisesRegex(quell.Error, "mean_normal"):
            denoiser.guide("depth")

    @unittest.skipUnless("accumulated" in quell.presets(), "skipped: guides, which want the preset accumulated")
    def test_guides_are_of_the_last_frame_s_size(self):
        denoiser = quell.Denoiser("accumulated", (HEIGHT, WIDTH), output_size=(2 * HEIGHT, 2 * WIDTH))
        for height, width in (30, 48), (HEIGHT, WIDTH), (30, 48):
            denoiser(wall(height, width), jitter=(0, 0))
            guide = denoiser.guide("mean_albedo")
            self.assertEqual(guide.shape, (height, width, 3))
            self.assertTrue(np.allclose(guide, 0.5, atol=1e-3))
            with self.assertRaises(quell.Error):
                denoiser(wall(5, 5), jitter=(0, 0))
            self.assertTrue(same_bits(denoiser.guide("mean_albedo"), guide))
            for wrong in np.empty((5, 5, 3), np.float32), np.empty((height, width, 2), np.float32):
                with self.assertRaisesRegex(quell.Error, f"guide: its shape is .*; give .{height}, {width}, 3"):
                    denoiser._denoiser.copy_guide("mean_albedo", wrong)

    @unittest.skipUnless("accumulated" in quell.presets(), "skipped: guides, which want the preset accumulated")
    def test_a_frame_that_ctrl_c_ends_leaves_guides_of_its_size(self):
        denoiser = quell.Denoiser("accumulated", (360, 640), output_size=(720, 1280))
        frame = wall(360, 640)
        interrupted = False
        for delay in 0.002, 0.01, 0.05, 0.2, 0.5:
            denoiser.forget()
            denoiser(wall(180, 320), jitter=(0, 0))
            timer = threading.Timer(delay, os.kill, (os.getpid(), signal.SIGINT))
            try:
                timer.start()
                denoiser(frame, jitter=(0, 0))
                timer.join()
                time.sleep(0.01)
            except KeyboardInterrupt:
                timer.join()
                interrupted = True
            self.assertIn(denoiser.guide("mean_albedo").shape, ((180, 320, 3), (360, 640, 3)))
        self.assertTrue(interrupted)

    def test_fewer_samples_than_pixels_give_what_nan_in_all_other_pixels_gives(self):
        for columns, rows, staggered in (2, 2, False), (2, 1, True):
            few, whole = quell.Denoiser("svgf", (HEIGHT, WIDTH)), quell.Denoiser("svgf", (HEIGHT, WIDTH))
            for seed in range(3):
                frame = wall(HEIGHT, WIDTH, seed)
                phase = seed % columns, seed % rows
                stored = np.zeros((-(-HEIGHT // rows), -(-WIDTH // columns), 3), np.float32)
                holes = np.full_like(frame["radiance"], np.nan)
                for j in range(stored.shape[0]):
                    for i in range(stored.shape[1]):
                        x, y = i * columns + (phase[0] + staggered * j) % columns, j * rows + phase[1]
                        if x < WIDTH and y < HEIGHT:
                            stored[j, i] = holes[y, x] = frame["radiance"][y, x]
                samples = {"radiance": quell.Samples(columns, rows, staggered, phase)}
                made = few({**frame, "radiance": stored}, samples=samples)
                self.assertTrue(same_bits(made, whole({**frame, "radiance": holes})))
                self.assertEqual(few.statistics.missing_samples, whole.statistics.missing_samples)

    def test_the_example_gives_the_bits_of_c(self):
        example = runpy.run_path(str(EXAMPLES / "denoise.py"))
        random = np.random.default_rng(1)
        frames = [{**example["guides"], "radiance": random.random((180, 320, 3), np.float32)} for _ in range(8)]
        self.assertTrue(same_bits(example["picture"], in_c("svgf", frames)[-1]))

    @unittest.skipUnless(quell.exr._exr, "skipped: examples/python/denoise_files.py, as quell was built without OpenEXR")
    @unittest.skipUnless("general" in quell.presets(), "skipped: examples/python/denoise_files.py, which wants the preset general")
    def test_the_example_denoises_files(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for number in range(3):
                frame = wall(HEIGHT, WIDTH, number)
                quell.exr.write(folder / f"frame.{number}.exr", planes_of(frame))
                quell.exr.write(folder / f"reference.{number}.exr", {"": np.full_like(frame["radiance"], 0.5)})
            command = [sys.executable, EXAMPLES / "denoise_files.py", folder, folder / "clean"]
            said = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
            self.assertEqual(len(said), 3)
            self.assertRegex(said[2], r"^frame.2.exr: FLIP 0.\d+, SSIM 0.\d+$")
            self.assertEqual(sorted(quell.exr.read(folder / "clean" / "frame.2.exr").planes), ["B", "G", "R"])

    def test_a_sequence_is_denoised_lazily_and_says_how_far_it_is(self):
        frames = [wall(HEIGHT, WIDTH, seed) for seed in range(4)]
        taken, steps = [], []

        def lazily():
            for number, frame in enumerate(frames):
                taken.append(number)
                yield frame

        made = quell.denoise(lazily(), "svgf", later_frames=0, progress=lambda done, total: steps.append((done, total)))
        next(made)
        self.assertEqual(taken, [0])
        rest = list(made)
        self.assertEqual(steps, [(1, None), (2, None), (3, None), (4, None)])
        self.assertTrue(same_bits(rest[-1], pictures(quell.Denoiser("svgf", (HEIGHT, WIDTH)), frames)[-1]))
        totals = []
        for _ in quell.denoise(frames, "svgf", later_frames=0, progress=lambda done, total: totals.append(total)):
            pass
        self.assertEqual(totals, [4] * 4)

    @unittest.skipUnless("general" in quell.presets(), "skipped: frames from before and after, which want the preset general")
    def test_frames_after_are_taken_as_they_are_needed(self):
        frames = [wall(HEIGHT, WIDTH, seed) for seed in range(6)]
        taken = []

        def lazily():
            for number, frame in enumerate(frames):
                taken.append(number)
                yield frame

        made = quell.denoise(lazily(), "general")
        first = next(made)
        self.assertEqual(taken, [0, 1, 2])
        found = np.stack([first, *made])
        denoiser = quell.Denoiser("general", (HEIGHT, WIDTH), stages=["two-sided"])
        self.assertTrue(same_bits(found, np.stack([denoiser(frames[i], later=frames[i + 1 : i + 3]) for i in range(6)])))
        # The last one has none after it.
        alone = np.stack(list(quell.denoise(frames, "general", later_frames=0)))
        self.assertTrue(same_bits(alone, pictures(quell.Denoiser("general", (HEIGHT, WIDTH)), frames)))
        self.assertTrue(same_bits(found[-1], alone[-1]) and not same_bits(found[0], alone[0]))
        self.assertLess(found[0].std(), alone[0].std())
        self.assertEqual(list(quell.denoise([])), [])

    @unittest.skipUnless("general" in quell.presets(), "skipped: alpha, which wants the preset general")
    def test_alpha_and_conventions_of_motion(self):
        frame = wall(HEIGHT, WIDTH)
        denoiser = quell.Denoiser("general", (HEIGHT, WIDTH), alpha=True)
        self.assertEqual(denoiser.reads["radiance_alpha"], 4)
        self.assertEqual(denoiser(frame, radiance_alpha=np.ones((HEIGHT, WIDTH, 4), np.float32)).shape, (HEIGHT, WIDTH, 4))
        own = quell.Denoiser("svgf", (HEIGHT, WIDTH))
        self.assertEqual(own.may_read, {})
        other = quell.Denoiser("svgf", (HEIGHT, WIDTH), motion={"points": "from_previous", "y": "up"})
        for _ in range(2):
            self.assertTrue(same_bits(own(frame), other({**frame, "motion": frame["motion"] * np.float32([-1, 1])})))

    def test_numbers_that_do_not_follow_each_other_and_forget_begin_afresh(self):
        frame = wall(HEIGHT, WIDTH)
        denoiser = quell.Denoiser("svgf", (HEIGHT, WIDTH))
        first = denoiser(frame, number=1)
        self.assertFalse(same_bits(denoiser(frame, number=2), first))
        self.assertTrue(same_bits(denoiser(frame, number=7), first))
        self.assertFalse(same_bits(denoiser({**frame, "number": 8}), first))
        denoiser.forget()
        self.assertTrue(same_bits(denoiser(frame), first))
        frame["radiance"][0, 0, 0] = np.nan
        denoiser(frame)
        counted = denoiser.statistics
        self.assertEqual((counted.frames, counted.resets, counted.missing_samples, counted.repaired_guides), (2, 3, 1, 0))
        self.assertGreater(counted.bytes, HEIGHT * WIDTH * 50)

    def test_it_says_what_it_is(self):
        denoiser = quell.Denoiser("svgf", (HEIGHT, WIDTH))
        self.assertEqual(denoiser.reads, {"radiance": 3, "albedo": 3, "motion": 2, "depth": 1, "normal": 3})
        self.assertIn("| temporal |", denoiser.plan)
        self.assertEqual((denoiser.preset, denoiser.size, denoiser.needs_camera), ("svgf", (HEIGHT, WIDTH), False))
        self.assertIn(denoiser.instruction_set, quell.instruction_sets())
        self.assertRegex(quell.version, r"^\d+\.\d+\.\d+$")


class Memory(unittest.TestCase):
    def test_a_call_takes_no_memory_of_an_images_size(self):
        height, width = 540, 960
        denoiser = quell.Denoiser("svgf", (height, width))
        frame = wall(height, width)
        out = np.empty((height, width, 3), np.float32)
        frame["radiance"] = np.ascontiguousarray(frame["radiance"].transpose(2, 0, 1)).transpose(1, 2, 0)[::-1]
        for _ in range(3):
            denoiser(frame, out=out)
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        tracemalloc.start()
        for _ in range(3):
            denoiser(frame, out=out)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        one_component = height * width * 4
        self.assertLess(peak, one_component / 16)
        self.assertLess((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - most) * 1024, one_component)

    def test_what_is_in_use_lives_as_long_and_no_longer(self):
        height, width = 720, 1280
        denoiser = quell.Denoiser("svgf", (height, width))
        alive, done = [], threading.Event()
        frame = wall(height, width)
        watched = [weakref.ref(array) for array in frame.values()] + [weakref.ref(denoiser)]

        def run(denoiser, arguments):
            denoiser(**arguments.pop())
            done.set()

        thread = threading.Thread(target=run, args=(denoiser, [frame]))
        del denoiser, frame
        thread.start()
        while not done.is_set():
            alive.append(all(reference() is not None for reference in watched))
            time.sleep(0.001)
        thread.join()
        del thread
        gc.collect()
        self.assertTrue(alive[0])
        self.assertTrue(all(reference() is None for reference in watched))

    def test_no_memory_is_a_memory_error_after_which_it_works(self):
        program = """
import resource, numpy as np, quell
from walls import wall, same_bits
frame, small = wall(360, 640), wall(16, 16)
out = np.empty((360, 640, 3), np.float32)
quell.Denoiser("svgf", (16, 16))(small)  # threads have their stacks
denoiser = quell.Denoiser("svgf", (360, 640))
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (8 << 20), resource.RLIM_INFINITY))
try:
    denoiser(frame, out=out)
    raise SystemExit("it had enough")
except MemoryError as error:
    print(error)
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
denoiser(frame, out=out)
print(same_bits(out, quell.Denoiser("svgf", (360, 640))(frame)))
"""
        ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=pathlib.Path(__file__).parent)
        self.assertEqual(ran.returncode, 0, ran.stderr + ran.stdout)
        sentence, same = ran.stdout.splitlines()
        self.assertIn("memory", sentence)
        self.assertEqual(same, "True")


class Threads(unittest.TestCase):
    def test_two_threads_with_one_denoiser(self):
        frame = wall(360, 640)
        denoiser = quell.Denoiser("svgf", (360, 640))
        errors, stop = [], threading.Event()

        def run():
            while not stop.is_set():
                try:
                    denoiser(frame)
                except quell.Error as error:
                    errors.append(error)

        thread = threading.Thread(target=run)
        thread.start()
        deadline = time.monotonic() + 60
        while not errors and time.monotonic() < deadline:
            try:
                denoiser(frame)
            except quell.Error as error:
                errors.append(error)
        stop.set()
        thread.join()
        self.assertEqual(errors[0].status, quell.Status.BUSY)
        self.assertIn("another thread runs this denoiser", str(errors[0]))
        denoiser.forget()
        self.assertTrue(same_bits(denoiser(frame), quell.Denoiser("svgf", (360, 640))(frame)))

    def test_two_denoisers_in_two_threads_do_not_meet(self):
        frames = [wall(HEIGHT, WIDTH, seed) for seed in range(8)]
        made = {}

        def run(name):
            made[name] = pictures(quell.Denoiser("svgf", (HEIGHT, WIDTH), threads=1), frames)

        threads = [threading.Thread(target=run, args=(name,)) for name in "ab"]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        wanted = pictures(quell.Denoiser("svgf", (HEIGHT, WIDTH)), frames)
        self.assertTrue(same_bits(made["a"], wanted) and same_bits(made["b"], wanted))

    def test_other_threads_run_meanwhile(self):
        frame = wall(720, 1280)
        denoiser = quell.Denoiser("svgf", (720, 1280))
        denoiser(frame)
        times = {}

        def run():
            times["begin"] = time.monotonic()
            denoiser(frame)
            times["end"] = time.monotonic()

        thread = threading.Thread(target=run)
        thread.start()
        seen = []
        while thread.is_alive():
            seen.append(time.monotonic())
            time.sleep(0)
        thread.join()
        third = (times["end"] - times["begin"]) / 3
        within = [t for t in seen if times["begin"] + third < t < times["end"] - third]
        self.assertGreater(len(within), 10)


class Interrupts(unittest.TestCase):
    def test_ctrl_c_while_a_frame_runs_ends_behind_it(self):
        frame = wall(360, 640)
        denoiser = quell.Denoiser("svgf", (360, 640))
        first = denoiser(frame)
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        began = time.monotonic()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            while time.monotonic() < began + 60:
                denoiser(frame)
        timer.join()
        denoiser.forget()
        self.assertTrue(same_bits(denoiser(frame), first))

    def test_ctrl_c_and_errors_of_progress_end_a_sequence(self):
        frames = [wall(HEIGHT, WIDTH)] * 100

        def interrupted(done, total):
            if done == 3:
                signal.raise_signal(signal.SIGINT)

        steps = []
        with self.assertRaises(KeyboardInterrupt):
            for picture in quell.denoise(frames, "svgf", later_frames=0, progress=interrupted):
                steps.append(picture)
        self.assertEqual(len(steps), 3)

        def fails(done, total):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            list(quell.denoise(frames, "svgf", later_frames=0, progress=fails))


class Errors(unittest.TestCase):
    def test_errors_are_values_that_can_be_sent(self):
        with self.assertRaises(quell.Error) as caught:
            quell.Denoiser("best", (HEIGHT, WIDTH))
        sent = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((str(sent), sent.status), (str(caught.exception), quell.Status.UNKNOWN_PRESET))
        self.assertIsInstance(sent, ValueError)


if __name__ == "__main__":
    unittest.main()
