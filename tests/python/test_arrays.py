"""Arrays of all kinds: what is read where it lies, and what is refused with which sentence."""

import array
import unittest

import numpy as np

import quell
from walls import pictures, same_bits, wall

HEIGHT, WIDTH = 34, 61


class LendsByDlpack:
    """An object that lends its memory by this protocol alone."""

    def __init__(self, array):
        self._array = array

    def __dlpack_device__(self):
        return self._array.__dlpack_device__()

    def __dlpack__(self, stream=None):
        return self._array.__dlpack__()


class LendsByInterface:
    """And by this one."""

    def __init__(self, array):
        self.__array_interface__ = array.__array_interface__
        self._array = array


class OnDevice:
    """As PyTorch and CuPy show memory of a GPU."""

    def __dlpack_device__(self):
        return (2, 0)

    def __dlpack__(self, stream=None):
        raise AssertionError("its memory can't be reached")


class WithCuda:
    __cuda_array_interface__ = {}


class WithNegativeBit(LendsByDlpack):
    """As PyTorch shows z.conj().imag: memory of the other sign."""

    def is_neg(self):
        return True


class OnMeta(LendsByDlpack):
    """As PyTorch shows a tensor without memory."""

    device = "meta"

    def __dlpack_device__(self):
        raise ValueError("Unknown device type meta for Dlpack")


def planar(pixels):
    return np.ascontiguousarray(pixels.transpose(2, 0, 1)).transpose(1, 2, 0)


def bottom_up(pixels):
    return np.ascontiguousarray(pixels[::-1])[::-1]


def right_to_left(pixels):
    return np.ascontiguousarray(pixels[:, ::-1])[:, ::-1]


def components_backwards(pixels):
    return np.ascontiguousarray(pixels[..., ::-1])[..., ::-1]


def with_gaps(pixels):
    memory = np.full((HEIGHT * 2, WIDTH * 3, pixels.shape[2] + 1), np.nan, pixels.dtype)
    memory[::2, 1::3, :-1] = pixels
    return memory[::2, 1::3, :-1]


def with_alpha(pixels):
    return np.concatenate([pixels, np.full_like(pixels[..., :1], np.nan)], axis=2)


LAYOUTS = (planar, bottom_up, right_to_left, components_backwards, with_gaps, with_alpha, np.asfortranarray)


class Read(unittest.TestCase):
    def setUp(self):
        self.frames = [wall(HEIGHT, WIDTH, seed) for seed in range(3)]
        self.wanted = pictures(quell.Denoiser("svgf", (HEIGHT, WIDTH)), self.frames)

    def check(self, change, **options):
        frames = [change(dict(frame)) for frame in self.frames]
        made = pictures(quell.Denoiser("svgf", (HEIGHT, WIDTH)), frames, **options)
        self.assertTrue(same_bits(made, self.wanted))

    def test_any_strides(self):
        for layout in LAYOUTS:
            with self.subTest(layout.__name__):
                self.check(lambda frame: {**frame, "radiance": layout(frame["radiance"]), "normal": layout(frame["normal"])})
        self.check(lambda frame: {**frame, "depth": frame["depth"].T.copy().T})
        self.check(lambda frame: {**frame, "depth": frame["depth"][..., np.newaxis]})

    def test_halves(self):
        self.check(lambda frame: {**frame, "albedo": frame["albedo"].astype(np.float16)})

    def test_read_only_input(self):
        def frozen(frame):
            frame["radiance"].flags.writeable = False
            return frame

        self.check(frozen)

    def test_other_protocols(self):
        lends = {
            "DLPack": LendsByDlpack,
            "DLPack from the bottom up": lambda a: LendsByDlpack(bottom_up(a)),
            "array interface": LendsByInterface,
            "memoryview": memoryview,
            "bytes": lambda a: memoryview(a.tobytes()).cast("f", a.shape),
            "array.array": lambda a: memoryview(array.array("f", a.ravel())).cast("B").cast("f", a.shape),
        }
        for name, lend in lends.items():
            with self.subTest(name):
                self.check(lambda frame: {**frame, "radiance": lend(frame["radiance"]), "depth": lend(frame["depth"])})


class Written(unittest.TestCase):
    def setUp(self):
        self.frame = wall(HEIGHT, WIDTH)
        self.wanted = quell.Denoiser("svgf", (HEIGHT, WIDTH))(self.frame)

    def test_any_strides(self):
        for layout in LAYOUTS:
            with self.subTest(layout.__name__):
                out = layout(np.full((HEIGHT, WIDTH, 3), -1, np.float32))
                self.assertIs(quell.Denoiser("svgf", (HEIGHT, WIDTH))(self.frame, out=out), out)
                self.assertTrue(np.array_equal(out[..., :3], self.wanted))
        memory = np.full((HEIGHT, WIDTH, 5), -1, np.float32)
        quell.Denoiser("svgf", (HEIGHT, WIDTH))(self.frame, out=memory[..., 1:4])
        self.assertTrue(np.all(memory[..., [0, 4]] == -1) and np.array_equal(memory[..., 1:4], self.wanted))

    def test_halves(self):
        out = quell.Denoiser("svgf", (HEIGHT, WIDTH))(self.frame, out=np.empty((HEIGHT, WIDTH, 3), np.float16))
        self.assertTrue(np.array_equal(out, self.wanted.astype(np.float16)))

    def test_other_protocols(self):
        for lends in (LendsByDlpack, LendsByInterface):
            memory = np.empty((HEIGHT, WIDTH, 3), np.float32)
            quell.Denoiser("svgf", (HEIGHT, WIDTH))(self.frame, out=lends(memory))
            self.assertTrue(same_bits(memory, self.wanted))
        memory = bytearray(HEIGHT * WIDTH * 12)
        quell.Denoiser("svgf", (HEIGHT, WIDTH))(self.frame, out=memoryview(memory).cast("f", (HEIGHT, WIDTH, 3)))
        self.assertEqual(bytes(memory), self.wanted.tobytes())


class Refused(unittest.TestCase):
    def setUp(self):
        self.frame = wall(HEIGHT, WIDTH)
        self.denoiser = quell.Denoiser("svgf", (HEIGHT, WIDTH))

    def refused(self, words, status=quell.Status.INVALID_ARGUMENT, **changes):
        with self.assertRaises(quell.Error) as caught:
            self.denoiser(self.frame, **changes)
        sentence = str(caught.exception)
        for word in words:
            self.assertIn(word, sentence)
        self.assertEqual(caught.exception.status, status, sentence)

    def tearDown(self):
        """It works as if nothing had been."""
        fresh = quell.Denoiser("svgf", (HEIGHT, WIDTH))
        self.assertTrue(same_bits(pictures(self.denoiser, [self.frame] * 2), pictures(fresh, [self.frame] * 2)))

    def test_types_of_numbers(self):
        radiance = self.frame["radiance"]
        for number in (np.float64, np.int32, np.uint8, np.complex64, bool, object, np.float128):
            name = str(np.dtype(number))
            self.refused(["channel 'radiance'", name, "float32", "astype"], radiance=radiance.astype(number))
        self.refused(["channel 'depth'", ">f4", "byte order"], depth=self.frame["depth"].astype(">f4"))
        self.refused(["channel 'albedo'", "mask"], albedo=np.ma.masked_less(self.frame["albedo"], 0))
        self.refused(["out", "float64"], out=np.empty((HEIGHT, WIDTH, 3)))

    def test_sizes(self):
        shape = f"({HEIGHT}, {WIDTH}, 3)"
        radiance = self.frame["radiance"]
        self.refused(["channel 'radiance'", f"({HEIGHT}, {WIDTH - 1}, 3)", shape], radiance=radiance[:, 1:])
        self.refused(["channel 'radiance'", f"({WIDTH}, {HEIGHT}, 3)", shape], radiance=radiance.transpose(1, 0, 2))
        self.refused(["channel 'radiance'", f"(3, {HEIGHT}, {WIDTH})", "transpose(1, 2, 0)"], radiance=radiance.transpose(2, 0, 1))
        self.refused(["channel 'radiance'", f"({HEIGHT}, {WIDTH}, 2)", shape], radiance=radiance[..., :2])
        self.refused(["channel 'radiance'", f"({HEIGHT}, {WIDTH})", shape], radiance=radiance[..., 0])
        self.refused(["channel 'radiance'", "()", shape], radiance=np.float32(1).reshape(()))
        self.refused(["channel 'radiance'", "(0, 0, 3)", shape], radiance=radiance[:0, :0])
        self.refused(["channel 'depth'", "(4, 4)", f"({HEIGHT}, {WIDTH})"], depth=np.zeros((4, 4), np.float32))
        self.refused(["out", "(4, 4, 3)", shape], out=np.zeros((4, 4, 3), np.float32))

    def test_strides(self):
        self.refused(["channel 'normal'", "broadcast"], normal=np.broadcast_to(np.float32([0, 0, 1]), (HEIGHT, WIDTH, 3)))
        packed = np.zeros((HEIGHT, WIDTH), np.dtype([("rgb", np.float32, 3), ("tag", np.uint8)]))
        self.refused(["channel 'radiance'", "stride", "multiple of 4"], radiance=packed["rgb"])
        unaligned = np.zeros(HEIGHT * WIDTH * 12 + 1, np.uint8)[1:].view(np.float32).reshape(HEIGHT, WIDTH, 3)
        self.refused(["channel 'radiance'", "aligned"], radiance=unaligned)

    def test_output(self):
        read_only = np.empty((HEIGHT, WIDTH, 3), np.float32)
        read_only.flags.writeable = False
        self.refused(["out", "read-only"], out=read_only)
        self.refused(["out", "read-only"], out=memoryview(bytes(HEIGHT * WIDTH * 12)).cast("f", (HEIGHT, WIDTH, 3)))
        self.refused(["output", "overlaps", "'radiance'"], out=self.frame["radiance"])
        self.refused(["output", "overlaps", "'albedo'"], out=self.frame["albedo"][::-1])

    def test_what_lends_no_memory(self):
        for value in (None, [[1.0]], 1.0, "radiance", {}, object(), iter(())):
            self.refused(["channel 'radiance'", type(value).__name__, "NumPy array"], radiance=value)
        self.refused(["out", "list"], out=[])

    def test_memory_of_devices(self):
        self.refused(["channel 'depth'", "CUDA", "host"], quell.Status.NOT_SUPPORTED, depth=OnDevice())
        self.refused(["channel 'depth'", "CUDA", "host"], quell.Status.NOT_SUPPORTED, depth=WithCuda())
        self.refused(["out", "CUDA", "host", 'device="cuda"'], quell.Status.NOT_SUPPORTED, out=OnDevice())

    def test_views_and_devices_of_pytorch(self):
        depth, picture = self.frame["depth"], np.empty((HEIGHT, WIDTH, 3), np.float32)
        self.refused(["channel 'depth'", "negative bit", "resolve_neg()"], depth=WithNegativeBit(depth))
        self.refused(["out", "negative bit", "resolve_neg()"], out=WithNegativeBit(picture))
        self.refused(["channel 'depth'", "OnMeta", "'meta'", "memory"], quell.Status.NOT_SUPPORTED, depth=OnMeta(depth))
        self.refused(["out", "'meta'"], quell.Status.NOT_SUPPORTED, out=OnMeta(picture))

    def test_channels(self):
        self.refused(["'colour'", "svgf", "radiance, albedo"], colour=self.frame["albedo"])
        depth = self.frame.pop("depth")
        self.refused(["'depth'", "missing"])
        self.frame["depth"] = depth
        self.denoiser({**self.frame, "position": None})  # a dict may have more
        self.denoiser.forget()

    def test_what_is_no_array(self):
        self.refused(["camera", "tuple", "quell.Camera"], camera=(np.eye(4), np.eye(4)))
        self.refused(["number", "64 bits"], number=1 << 70)
        self.refused(["shutter"], shutter=-1.0)
        self.refused(["'radiance'", "1 to 8"], samples={"radiance": quell.Samples(9, 1)})
        # To quell.h that is an image of the frame's size, and this one is smaller.
        few = np.ones((2, 2, 3), np.float32)
        self.refused(["'radiance'", "0x0", "1 to 8"], radiance=few, samples={"radiance": quell.Samples(0, 0)})
        self.refused(["'radiance'", "0x0", "1 to 8"], samples={"radiance": quell.Samples(0, 0)})
        self.refused(["'depth'", "every pixel"], samples={"depth": quell.Samples(2, 2)})
        for phase in (0, (1,), (0, 0, 0)):
            self.refused(["'radiance'", "phase", repr(phase)], samples={"radiance": quell.Samples(2, 2, False, phase)})
        self.refused(["'radiance'", "quell.Samples"], samples={"radiance": 2})
        self.refused(["'glossy'", "no channel"], samples={"glossy": quell.Samples(2, 2)})
        with self.assertRaises(TypeError):
            self.denoiser(self.frame, number=1.5)
        for arguments in ((np.eye(3), np.eye(4)), (np.eye(4), "x"), (np.eye(4), np.eye(4), (1, 2, 3))):
            with self.assertRaisesRegex(quell.Error, "camera"):
                quell.Camera(*arguments)

    def test_settings(self):
        def refused(status, words, *arguments, **options):
            with self.assertRaises(quell.Error) as caught:
                quell.Denoiser(*arguments, **options)
            for word in words:
                self.assertIn(word, str(caught.exception))
            self.assertEqual(caught.exception.status, status)

        status = quell.Status
        refused(status.INVALID_ARGUMENT, ["device", "'tpu'", "cpu, cuda"], "svgf", (HEIGHT, WIDTH), device="tpu")
        refused(status.INVALID_ARGUMENT, ["stream", '"cpu"'], "svgf", (HEIGHT, WIDTH), stream=7)
        if not quell.presets("cuda"):
            refused(status.NOT_SUPPORTED, ["without CUDA", "QUELL_CUDA=ON"], "svgf", (HEIGHT, WIDTH), device="cuda")
        refused(status.UNKNOWN_PRESET, ["'best'", "svgf"], "best", (HEIGHT, WIDTH))
        refused(status.INVALID_ARGUMENT, ["61x0"], "svgf", (0, WIDTH))
        refused(status.INVALID_ARGUMENT, ["-61x34"], "svgf", (HEIGHT, -WIDTH))
        refused(status.INVALID_ARGUMENT, ["size", "(34, 61, 3)"], "svgf", (HEIGHT, WIDTH, 3))
        refused(status.INVALID_ARGUMENT, ["size", "32 bits"], "svgf", (HEIGHT, 1 << 40))
        refused(status.INVALID_ARGUMENT, ["threads", "-1"], "svgf", (HEIGHT, WIDTH), threads=-1)
        refused(status.NOT_SUPPORTED, ["'z80'", quell.instruction_sets()[0]], "svgf", (HEIGHT, WIDTH), instruction_set="z80")
        refused(status.INVALID_ARGUMENT, ["motion", "'px'", "pixel, uv, ndc"], "svgf", (HEIGHT, WIDTH), motion={"unit": "px"})
        refused(status.NOT_SUPPORTED, ["'svgf'", "general"], "svgf", (HEIGHT, WIDTH), stages=["two-sided"])
        refused(status.NOT_SUPPORTED, ["'svgf'", "general"], "svgf", (HEIGHT, WIDTH), alpha=True)
        for words, frames, options in (
            ("no channels", [{}], {}),
            ("later_frames: -1", [], {"later_frames": -1}),
            ("later_frames: 2.*'svgf'", [self.frame], {"later_frames": 2}),
        ):
            with self.assertRaisesRegex(quell.Error, words):
                next(quell.denoise(frames, "svgf", **{"later_frames": 0, **options}))
        self.refused(["later", "two-sided"], status.NOT_SUPPORTED, later=[self.frame])

    @unittest.skipUnless("general" in quell.presets(), "skipped: frames from before and after, which want the preset general")
    def test_later_frames(self):
        denoiser = quell.Denoiser("general", (HEIGHT, WIDTH), stages=["two-sided"])
        with self.assertRaisesRegex(quell.Error, "later.1.: channel 'depth'.*shape"):
            denoiser(self.frame, later=[self.frame, {**self.frame, "depth": self.frame["depth"][1:]}])
        with self.assertRaisesRegex(quell.Error, "frames.1..*'albedo'.*missing"):
            denoiser(self.frame, later=[{"radiance": self.frame["radiance"]}])
        self.assertTrue(same_bits(denoiser(self.frame), quell.Denoiser("general", (HEIGHT, WIDTH))(self.frame)))


if __name__ == "__main__":
    unittest.main()
