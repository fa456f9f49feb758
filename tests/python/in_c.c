/* What the tests compare with: denoises frames of a file by quell.h alone.
 *     in_c PRESET WIDTH HEIGHT FRAMES IN OUT [OUTPUT_WIDTH OUTPUT_HEIGHT]
 * IN has floats: a quell_camera; then of each frame all channels in the preset's order, each pixel by pixel. OUT gets the pictures one after
 * another. */
#include <quell.h>
#include <stdio.h>
#include <stdlib.h>

static int fails(const char *what) {
    fprintf(stderr, "%s: %s\n", what, quell_error());
    return 1;
}

int main(int argc, char **argv) {
    quell_settings settings = QUELL_SETTINGS;
    quell_frame frame = QUELL_FRAME;
    quell_denoiser *denoiser;
    quell_camera camera;
    quell_channel channels[32];
    float *memory[33];
    size_t sizes[33], count = 0, i;
    long n;
    FILE *in, *out;
    if (argc != 7 && argc != 9) return fails("in_c PRESET WIDTH HEIGHT FRAMES IN OUT [OUTPUT_WIDTH OUTPUT_HEIGHT]");
    settings.preset = argv[1], settings.width = atoi(argv[2]), settings.height = atoi(argv[3]);
    if (argc == 9) settings.stages = "resolve", settings.output_width = atoi(argv[7]), settings.output_height = atoi(argv[8]);
    if (quell_create(&settings, &denoiser) != QUELL_OK) return fails("create");
    for (; count < 32 && quell_channel_name(denoiser, (int)count) != NULL; ++count) {
        const char *const name = quell_channel_name(denoiser, (int)count);
        const int components = quell_channel_components(denoiser, name);
        sizes[count] = (size_t)(settings.width * settings.height * components);
        memory[count] = malloc(sizes[count] * sizeof(float));
        channels[count].name = name, channels[count].image = QUELL_PIXELS(memory[count], components);
    }
    sizes[count] = (size_t)(quell_output_width(denoiser) * quell_output_height(denoiser) * quell_output_components(denoiser));
    memory[count] = malloc(sizes[count] * sizeof(float));
    frame.channels = channels, frame.channel_count = count;
    frame.output = QUELL_PIXELS(memory[count], quell_output_components(denoiser));
    in = fopen(argv[5], "rb"), out = fopen(argv[6], "wb");
    if (in == NULL || out == NULL) return fails("open");
    if (fread(&camera, sizeof(camera), 1, in) != 1) return fails("read");
    frame.camera = &camera;
    for (n = 0; n < atol(argv[4]); ++n) {
        for (i = 0; i < count; ++i)
            if (fread(memory[i], sizeof(float), sizes[i], in) != sizes[i]) return fails("read");
        if (quell_run(denoiser, &frame) != QUELL_OK) return fails("run");
        if (fwrite(memory[count], sizeof(float), sizes[count], out) != sizes[count]) return fails("write");
    }
    if (fclose(out) != 0) return fails("close");
    for (i = 0; i <= count; ++i) free(memory[i]);
    quell_destroy(denoiser);
    return fclose(in);
}
