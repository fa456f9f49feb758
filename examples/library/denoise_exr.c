/* Denoises EXR files with libquell and libquell-exr, from C: denoise_exr svgf in.%04d.exr out.%04d.exr 1 8. */
#include <quell_exr.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(const char *sentence) { return fprintf(stderr, "%s\n", sentence), 1; }

int main(int count, char **arguments) {
    if (count != 6) return failed("denoise_exr PRESET IN OUT FIRST LAST, such as: denoise_exr svgf in.%04d.exr out.%04d.exr 1 8");
    quell_denoiser *denoiser = NULL;
    float *out = NULL;
    for (int n = atoi(arguments[4]); n <= atoi(arguments[5]); ++n) {
        char path[4096];
        quell_exr *file;
        quell_exr_info info = QUELL_EXR_INFO;
        snprintf(path, sizeof(path), arguments[2], n);
        if (quell_exr_open(path, &file) != QUELL_OK || quell_exr_get_info(file, &info) != QUELL_OK) return failed(quell_exr_error());
        if (denoiser == NULL) {
            quell_settings settings = QUELL_SETTINGS;
            settings.preset = arguments[1], settings.width = info.width, settings.height = info.height;
            if (quell_create(&settings, &denoiser) != QUELL_OK) return failed(quell_error());
            out = malloc(sizeof(float) * 3 * (size_t)info.width * (size_t)info.height);
        }
        quell_frame frame = QUELL_FRAME;
        if (quell_exr_read_for(file, denoiser, &frame) != QUELL_OK) return failed(quell_exr_error());
        frame.output = QUELL_PIXELS(out, 3), frame.number = n, frame.has_number = 1;
        if (quell_run(denoiser, &frame) != QUELL_OK) return failed(quell_error());
        const quell_channel picture = {"radiance", frame.output};
        quell_exr_output output = QUELL_EXR_OUTPUT;
        output.channels = &picture, output.channel_count = 1, output.like = file;
        snprintf(path, sizeof(path), arguments[3], n);
        if (quell_exr_write(path, &output) != QUELL_OK) return failed(quell_exr_error());
        quell_exr_close(file);
    }
    quell_destroy(denoiser);
    free(out);
    return 0;
}
