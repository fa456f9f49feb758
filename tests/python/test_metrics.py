"""quell.metrics."""

import unittest

import numpy as np

import quell
from quell import metrics


class Metrics(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(3)
        self.reference = random.random((40, 50, 3), np.float32)
        self.test = np.clip(self.reference + 0.1 * random.standard_normal((40, 50, 3)), 0, 1).astype(np.float32)

    def test_equal_pictures(self):
        a = self.reference
        self.assertEqual(metrics.rmse(a, a), 0)
        self.assertAlmostEqual(metrics.ssim(a, a), 1)
        self.assertEqual(metrics.flip(a, a).mean, 0)

    def test_values(self):
        a, b = self.reference, self.test
        self.assertAlmostEqual(metrics.rmse(a, b), float(np.sqrt(np.mean((a.astype(float) - b) ** 2))), places=6)
        self.assertTrue(0 < metrics.ssim(a, b) < 1)
        found = metrics.flip(a, b)
        self.assertEqual(found.errors.shape, (40, 50))
        self.assertAlmostEqual(found.mean, float(found.errors.mean()), places=5)
        # Black against white is the largest difference.
        self.assertGreater(metrics.flip(np.zeros_like(a), np.ones_like(a)).mean, 0.9)

    def test_a_mask_and_any_strides(self):
        a, b = self.reference, self.test
        mask = np.zeros((40, 50), bool)
        mask[10:20] = True
        wanted = float(np.sqrt(np.mean((a[10:20].astype(float) - b[10:20]) ** 2)))
        self.assertAlmostEqual(metrics.rmse(a, b, mask), wanted, places=6)
        self.assertAlmostEqual(metrics.flip(a, b, mask).mean, float(metrics.flip(a, b).errors[10:20].mean()), places=5)
        self.assertEqual(metrics.rmse(a[::-1], b[::-1]), metrics.rmse(a[::-1].copy(), b[::-1].copy()))
        self.assertEqual(metrics.ssim(a, a.astype(np.float16), mask), metrics.ssim(a, a.astype(np.float16).astype(np.float32), mask))

    def test_displayed(self):
        shown = metrics.displayed(np.float32([[[0, 0.5, 2]]]))
        self.assertTrue(np.allclose(shown, [[[0, 0.7353569, 1]]], atol=1e-6))

    def test_what_is_refused(self):
        a = self.reference
        for words, call in (
            ("test picture.*reference", lambda: metrics.rmse(a, a[1:])),
            ("test picture.*displayed", lambda: metrics.flip(a, a + 1)),
            ("reference.*uint8.*255", lambda: metrics.ssim(a.astype(np.uint8), a)),
            ("reference.*float64", lambda: metrics.ssim(a.astype(float), a)),
            ("test.*shape", lambda: metrics.rmse(a, a[..., 0])),
            ("mask.*selects 0", lambda: metrics.rmse(a, a, np.zeros((40, 50), bool))),
            ("mask.*entries", lambda: metrics.rmse(a, a, np.ones((4, 5), bool))),
            ("size", lambda: metrics.rmse(a[:0], a[:0])),
            ("pixels per degree", lambda: metrics.flip(a, a, pixels_per_degree=0)),
            ("linear picture.*nan", lambda: metrics.displayed(a * np.float32(np.nan))),
        ):
            with self.subTest(words), self.assertRaisesRegex(quell.Error, words):
                call()


if __name__ == "__main__":
    unittest.main()
