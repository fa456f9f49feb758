/* Denoises eight frames of a grey wall in noisy light with libquell, from C. Prints the noise that is left, as a part of the input's. */
#include <quell.h>
#include <stdio.h>
#include <stdlib.h>

enum { width = 320, height = 180, pixels = width * height };
static float radiance[pixels * 3], albedo[pixels * 3], normal[pixels * 3], depth[pixels], motion[pixels * 2], out[pixels * 3];

static double variance_of(const float *rgb) {
    double sum = 0, squares = 0;
    for (int i = 0; i < pixels * 3; ++i) sum += rgb[i], squares += (double)rgb[i] * rgb[i];
    return squares / (pixels * 3) - sum / (pixels * 3) * (sum / (pixels * 3));
}

int main(void) {
    quell_settings settings = QUELL_SETTINGS;
    settings.preset = "svgf", settings.width = width, settings.height = height;
    quell_denoiser *denoiser;
    if (quell_create(&settings, &denoiser) != QUELL_OK) return fprintf(stderr, "%s\n", quell_error()), 1;
    const quell_channel channels[] = {{"radiance", QUELL_PIXELS(radiance, 3)}, {"albedo", QUELL_PIXELS(albedo, 3)},
                                      {"normal", QUELL_PIXELS(normal, 3)},     {"depth", QUELL_PIXELS(depth, 1)},
                                      {"motion", QUELL_PIXELS(motion, 2)}};
    quell_frame frame = QUELL_FRAME;
    frame.channels = channels, frame.channel_count = 5, frame.output = QUELL_PIXELS(out, 3);
    for (int n = 0; n < 8; ++n) {
        for (int i = 0; i < pixels * 3; ++i) radiance[i] = (float)rand() / (float)RAND_MAX, albedo[i] = 0.5f, normal[i] = i % 3 == 2;
        for (int i = 0; i < pixels; ++i) depth[i] = 4;
        if (quell_run(denoiser, &frame) != QUELL_OK) return fprintf(stderr, "%s\n", quell_error()), 1;
    }
    printf("noise left: %.4f\n", variance_of(out) / variance_of(radiance));
    quell_destroy(denoiser);
    return 0;
}
