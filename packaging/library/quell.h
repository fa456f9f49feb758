/* quell as a library: real-time denoising for C99, and for every language that can call C.
 *
 *     quell_settings settings = QUELL_SETTINGS;
 *     settings.preset = "general", settings.width = 1920, settings.height = 1080;
 *     quell_denoiser *denoiser;
 *     if (quell_create(&settings, &denoiser) != QUELL_OK) puts(quell_error());
 *
 *     quell_channel channels[] = {{"radiance", QUELL_PIXELS(rgb, 3)}, {"albedo", QUELL_PIXELS(albedo, 3)}, ...};
 *     quell_frame frame = QUELL_FRAME;
 *     frame.channels = channels, frame.channel_count = 5, frame.output = QUELL_PIXELS(out, 3);
 *     if (quell_run(denoiser, &frame) != QUELL_OK) puts(quell_error());
 *     quell_destroy(denoiser);
 *
 * Every function that can fail returns a quell_status, and quell_error() then says in one sentence what is wrong, what was found and what
 * to do. After an error the denoiser works as before. No exception leaves the library.
 *
 * Images are read while quell_run() runs, by a first pass that makes planes of floats of them; nothing of the caller's is kept. The output
 * is written where it lies. C cannot see: whether memory is as large as its
 * strides say, whether it is freed or written while quell_run() runs, whether a pointer is of this process. */
#ifndef QUELL_H
#define QUELL_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define QUELL_CALL __declspec(dllimport)
#else
#define QUELL_CALL __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What a function made of a call. */
typedef enum quell_status {
    QUELL_OK = 0,
    QUELL_INVALID_ARGUMENT = 1, /* an argument is wrong: quell_error() names it */
    QUELL_UNKNOWN_PRESET = 2,   /* there is no such preset in this library */
    QUELL_NOT_SUPPORTED = 3,    /* the machine or this library cannot do it */
    QUELL_NO_MEMORY = 4,
    QUELL_BUSY = 5, /* another thread runs this denoiser */
    QUELL_FAILED = 6
} quell_status;

/* How a component lies in memory. */
typedef enum quell_format {
    QUELL_FLOAT32 = 0,
    QUELL_FLOAT16 = 1 /* IEEE binary16 */
} quell_format;

/* What denoises. */
typedef enum quell_device {
    QUELL_CPU = 0,
    QUELL_CUDA = 1 /* an NVIDIA GPU, where this library was built for it */
} quell_device;

/* An image in the caller's memory. Strides are in bytes and may be negative; 0 stands for the usual one: components side by side, pixels
 * side by side, rows without gaps. */
typedef struct quell_image {
    void *data; /* component 0 of the top left pixel; inputs are not written */
    int32_t format;
    int32_t components;         /* that the memory has at each pixel: as many as the channel, or more, of which the first are used */
    ptrdiff_t component_stride; /* from a component to the next */
    ptrdiff_t pixel_stride;     /* from a pixel to the one on the right */
    ptrdiff_t row_stride;       /* from a pixel to the one below */
} quell_image;
/* Floats of so many components side by side, in rows without gaps. */
#ifdef __cplusplus
#define QUELL_PIXELS(data, components) quell_image{(void *)(data), QUELL_FLOAT32, (components), 0, 0, 0}
#else
#define QUELL_PIXELS(data, components) ((quell_image){(void *)(data), QUELL_FLOAT32, (components), 0, 0, 0})
#endif

/* An image of a frame, by the name of its channel: radiance, albedo, normal, depth, motion, ... */
typedef struct quell_channel {
    const char *name;
    quell_image image;
} quell_channel;

/* Which pixels have a sample, where a channel has fewer samples than the frame has pixels: one in each block of columns x rows pixels.
 * {2, 2} is half size, {2, 1, 1} a checkerboard. The sample in column i and row j of the image is of the pixel
 * (i * columns + (phase_x + (staggered ? j : 0)) % columns, j * rows + phase_y). Pixels of a signal that have none are missing samples. */
typedef struct quell_samples {
    int32_t columns, rows;    /* of a block, in pixels, 1 to 8; both 0: every pixel has a sample */
    int32_t staggered;        /* 1: one column further to the right in each row of blocks */
    int32_t phase_x, phase_y; /* the pixel of each block that this frame's samples are of; let it move from frame to frame */
    int32_t width, height;    /* of the channel's image: a part of the frame's, rounded up or down; or the frame's own size, of which other
                                 pixels are not read. 0: a part, rounded up. */
} quell_samples;

/* A perspective camera: column-major 4x4 matrices for column vectors, clip = projection * view * world; view space looks down -z, clip
 * space has y up. Presets that need none ignore it. */
typedef struct quell_camera {
    float view[16];
    float projection[16]; /* without jitter */
    float jitter[2];      /* offset of the samples from the pixels' centres, in pixels, y down; at most 8 with the stages resolve and colours */
} quell_camera;

/* One frame. Start from QUELL_FRAME. */
typedef struct quell_frame {
    size_t struct_size;
    const quell_channel *channels; /* all that quell_channel_name() lists but the optional ones, in any order */
    size_t channel_count;
    quell_image output;         /* of quell_output_components() components; must not overlap an input */
    const quell_camera *camera; /* null: none */
    int64_t number;             /* of the frame in its sequence; where numbers do not follow each other, history starts afresh */
    int32_t has_number;         /* 0: frames follow each other */
    float shutter;              /* shutter time as a part of the time between frames, for motion blur */
    const void *device;         /* null: settings.device says what denoises, and with QUELL_CUDA an image lies where its pointer says */
    const int32_t *fractions;   /* of the channels, in their order: an image's width and height as a part of the frame's. Null: all 1, which
                                   is all that presets support so far. */
    const quell_samples *samples; /* of the channels, in their order. Null: every pixel of all channels has one. Guides (albedo, normal,
                                     depth, motion, motion_next) must have them all. */
    int32_t width, height; /* with the stage resolve: of this frame, whose size may be another one than the last frame's; what was
                              resolved stays. 0: the settings'. */
} quell_frame;
#ifdef __cplusplus
#define QUELL_FRAME quell_frame{sizeof(quell_frame), nullptr, 0, {}, nullptr, 0, 0, 0.5f, nullptr, nullptr, nullptr, 0, 0}
#else
#define QUELL_FRAME ((quell_frame){sizeof(quell_frame), NULL, 0, {0}, NULL, 0, 0, 0.5f, NULL, NULL, NULL, 0, 0})
#endif

/* The host's own threads: calls task(context, i) for 0 <= i < count, on any threads, and returns when all are done. */
typedef void (*quell_parallel)(void *user, int32_t count, void (*task)(void *context, int32_t index), void *context);
/* The host's own memory, for images: aligned to `alignment`; null where there is none. */
typedef void *(*quell_allocate)(void *user, size_t bytes, size_t alignment);
typedef void (*quell_release)(void *user, void *memory);

/* What motion vectors mean. All 0 is quell's own convention: previous = current + motion, in pixels, y down, without jitter. */
typedef struct quell_motion {
    int32_t from_previous; /* 1: current = previous + motion */
    int32_t unit;          /* 0: pixels, 1: the image is 1 wide and 1 high, 2: it is 2 wide and 2 high */
    int32_t y_up;          /* 1: y grows upwards */
    int32_t has_jitter;    /* 1: vectors contain the change of the camera's jitter; frames then need the camera */
} quell_motion;

/* How a denoiser is made. Start from QUELL_SETTINGS. */
typedef struct quell_settings {
    size_t struct_size;    /* in all structures that begin with it: later versions of this library read those of earlier ones */
    const char *preset;    /* one that quell_preset_name() lists */
    const char *stages;    /* what is done before the preset, with it and behind it: some of the names that quell_stage_name() lists, with
                              commas between, in any order (docs/library.md): "evidence,light". Null: nothing */
    int32_t samples_per_pixel; /* for the stages evidence and light; 0: not known, which is taken for 1 */
    int32_t alpha;         /* 1: for radiance with alpha, the channel radiance_alpha, which the presets general and final-frame can */
    int32_t width, height; /* of frames; with the stage resolve they may say another size */
    int32_t output_width, output_height; /* of what comes out: 1 to 4 times the frames', which adds the stage resolve. 0: the frames' own */
    quell_motion motion;                 /* what the channels motion and motion_next mean; motion_next contains no jitter */
    int32_t threads;                     /* 0: all that there are. Results do not depend on it. */
    int32_t device; /* a quell_device. With QUELL_CUDA: of the calling thread's current device. Images of frames, and the output, may lie in
                       its memory, in memory that CUDA manages, or in host memory, from which they are copied. quell_run() puts its work into
                       the stream and returns, where no image lies in host memory: until the stream has come there, the images must stay.
                       Not with alpha, another output size, allocate and instruction_set. */
    void *stream;   /* with QUELL_CUDA: a cudaStream_t; null is the default stream */
    const char *instruction_set; /* null: the best that the machine has, of those that quell_instruction_set_name() lists */
    quell_parallel parallel;     /* null: the library's own threads, of which there are `threads` */
    void *parallel_user;
    quell_allocate allocate; /* null, as release: the library's own */
    quell_release release;
    void *memory_user;
} quell_settings;
#ifdef __cplusplus
#define QUELL_SETTINGS \
    quell_settings {                                                                                                                       \
        sizeof(quell_settings), nullptr, nullptr, 0, 0, 0, 0, 0, 0, {}, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,        \
            nullptr                                                                                                                        \
    }
#else
#define QUELL_SETTINGS \
    ((quell_settings){sizeof(quell_settings), NULL, NULL, 0, 0, 0, 0, 0, 0, {0, 0, 0, 0}, 0, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL})
#endif

/* Counts. Start from QUELL_STATISTICS. */
typedef struct quell_statistics {
    size_t struct_size;
    int64_t frames;          /* since the history began */
    int64_t resets;          /* how often it began */
    int64_t missing_samples; /* in the last frame: not finite, beyond 1e16, of negative luminance */
    int64_t repaired_guides; /* pixels of the last frame with impossible guides (docs/channels.md) */
    size_t bytes;            /* of history and scratch */
} quell_statistics;
#ifdef __cplusplus
#define QUELL_STATISTICS quell_statistics{sizeof(quell_statistics), 0, 0, 0, 0, 0}
#else
#define QUELL_STATISTICS ((quell_statistics){sizeof(quell_statistics), 0, 0, 0, 0, 0})
#endif

typedef struct quell_denoiser quell_denoiser;

QUELL_CALL const char *quell_version(void);
/* The last error of the calling thread; "" where there was none. Valid until its next call. */
QUELL_CALL const char *quell_error(void);
/* Names of presets; null behind the last. */
QUELL_CALL const char *quell_preset_name(int32_t index);
/* Names of presets that a device denoises by; null behind the last: with QUELL_CUDA none, where the library was built without CUDA. */
QUELL_CALL const char *quell_device_preset_name(int32_t device, int32_t index);
/* Names of stages that a device knows, in the order in which they are put around a preset; null behind the last. */
QUELL_CALL const char *quell_stage_name(int32_t device, int32_t index);
/* Names of instruction sets that the library is compiled for, the best first; null behind the last. */
QUELL_CALL const char *quell_instruction_set_name(int32_t index);

QUELL_CALL quell_status quell_create(const quell_settings *settings, quell_denoiser **denoiser);
/* Null is none. */
QUELL_CALL void quell_destroy(quell_denoiser *denoiser);

/* Size of the frames, and of what comes out. */
QUELL_CALL int32_t quell_width(const quell_denoiser *denoiser);
QUELL_CALL int32_t quell_height(const quell_denoiser *denoiser);
QUELL_CALL int32_t quell_output_width(const quell_denoiser *denoiser);
QUELL_CALL int32_t quell_output_height(const quell_denoiser *denoiser);
/* Names of the channels that it reads; null behind the last. */
QUELL_CALL const char *quell_channel_name(const quell_denoiser *denoiser, int32_t index);
/* Whether frames may lack a channel. */
QUELL_CALL int32_t quell_channel_is_optional(const quell_denoiser *denoiser, const char *name);
/* Components of a channel; 0 where the preset has none of that name. */
QUELL_CALL int32_t quell_channel_components(const quell_denoiser *denoiser, const char *name);
QUELL_CALL int32_t quell_output_components(const quell_denoiser *denoiser);
/* Whether frames must have a camera. */
QUELL_CALL int32_t quell_needs_camera(const quell_denoiser *denoiser);
/* Names of the guides that it accumulates with the light, for a denoiser behind it; null behind the last. The preset accumulated has
 * mean_albedo and mean_normal, of three components each. */
QUELL_CALL const char *quell_guide_name(const quell_denoiser *denoiser, int32_t index);
/* What it is compiled for. */
QUELL_CALL const char *quell_instruction_set(const quell_denoiser *denoiser);
/* Its passes in order, what each reads and writes, and memory: a table in Markdown. Valid as long as the denoiser is. */
QUELL_CALL const char *quell_plan(const quell_denoiser *denoiser);

/* Denoises a frame. */
QUELL_CALL quell_status quell_run(quell_denoiser *denoiser, const quell_frame *frame);
/* Denoises the first of some frames that follow each other, with those after it and those before it: offline, moving light lags less so, and
 * what has just come into view has a past. The first frame's output is written; the others need none. Each call moves one frame on, and the
 * last ones have fewer frames after them. Two frames after the first are enough. Where frames lack the optional channel motion_next, it is
 * made of the next frame's motion. The denoiser was made with the stage two-sided. */
QUELL_CALL quell_status quell_run_two_sided(quell_denoiser *denoiser, const quell_frame *frames, size_t count);
/* Copies a guide of the frame that was run last to an image of its size. After a frame that was refused it is that of the frame before it;
 * after one that ran out of memory there is none. */
QUELL_CALL quell_status quell_copy_guide(quell_denoiser *denoiser, const char *name, const quell_image *image);
/* Drops the history: for cuts and teleports. */
QUELL_CALL quell_status quell_forget(quell_denoiser *denoiser);
QUELL_CALL quell_status quell_get_statistics(const quell_denoiser *denoiser, quell_statistics *statistics);

#ifdef __cplusplus
}
#endif
#endif
