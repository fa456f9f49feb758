/* EXR files for libquell, from C99 and every language that can call C: what a file holds as a frame for quell_run(), and images as a file.
 *
 *     quell_exr *file;
 *     quell_frame frame = QUELL_FRAME;
 *     if (quell_exr_open("in.0001.exr", &file) != QUELL_OK) puts(quell_exr_error());
 *     if (quell_exr_read_for(file, denoiser, &frame) != QUELL_OK) puts(quell_exr_error());
 *     frame.output = QUELL_PIXELS(out, 3);
 *     if (quell_run(denoiser, &frame) != QUELL_OK) puts(quell_error());
 *
 *     const quell_channel picture = {"radiance", frame.output};
 *     quell_exr_output output = QUELL_EXR_OUTPUT;
 *     output.channels = &picture, output.channel_count = 1, output.like = file;
 *     if (quell_exr_write("out.0001.exr", &output) != QUELL_OK) puts(quell_exr_error());
 *     quell_exr_close(file);
 *
 * The library is libquell-exr. It does not need libquell, and libquell does not need it; they share the types of quell.h. Every function
 * that can fail returns a quell_status, and quell_exr_error() then says in one sentence what is wrong, what was found and what to do. After
 * an error files that are open work as before. No exception leaves the library. An open file is for one thread at a time. */
#ifndef QUELL_EXR_H
#define QUELL_EXR_H

#include "quell.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An open file: its header, and the images that were read from it. */
typedef struct quell_exr quell_exr;

/* What was wrong with this thread's last call that returned a quell_status; empty where nothing was. */
QUELL_CALL const char *quell_exr_error(void);

/* Opens a file and reads its header: one or several parts, scan lines or tiles, any data window. Deep parts are ignored.
 * @param path in UTF-8
 * @param file set to the file; to null where it can't be opened */
QUELL_CALL quell_status quell_exr_open(const char *path, quell_exr **file);
/* Closes it, and frees the images that were read from it. Null does nothing. */
QUELL_CALL void quell_exr_close(quell_exr *file);

/* What a header says. Start from QUELL_EXR_INFO. */
typedef struct quell_exr_info {
    size_t struct_size;
    int32_t width, height; /* of the display window, which is what images have */
    int32_t has_camera;    /* 1: the attributes quell:view and quell:projection are there, and maybe quell:jitter */
    quell_camera camera;
    int32_t has_shutter; /* 1: the attribute quell:shutter is there */
    float shutter;
} quell_exr_info;
#ifdef __cplusplus
#define QUELL_EXR_INFO                                                                                                                     \
    quell_exr_info { sizeof(quell_exr_info), 0, 0, 0, {}, 0, 0 }
#else
#define QUELL_EXR_INFO ((quell_exr_info){sizeof(quell_exr_info), 0, 0, 0, {{0}, {0}, {0}}, 0, 0})
#endif
QUELL_CALL quell_status quell_exr_get_info(const quell_exr *file, quell_exr_info *info);

/* Names of the file's channels, as layer.component; null beyond the last. */
QUELL_CALL const char *quell_exr_channel_name(const quell_exr *file, int32_t index);

/* Names of the attributes that are texts, numbers, pairs of floats and 4x4 matrices; null beyond the last. */
QUELL_CALL const char *quell_exr_attribute_name(const quell_exr *file, int32_t index);
/* An attribute's text; null where there is none of that name, or it is no text. */
QUELL_CALL const char *quell_exr_attribute_text(const quell_exr *file, const char *name);
/* An attribute's numbers: 1, 2, or the 16 of a matrix, column by column. Returns how many there are; 0 where there is none of that name, or
 * it is a text. */
QUELL_CALL int32_t quell_exr_attribute_numbers(const quell_exr *file, const char *name, double numbers[16]);

/* Names of the signals of the file, each of which is denoised by itself; null beyond the last. Files with quell's own names have one,
 * radiance; those of Blender Cycles have diffuse, glossy and others. Without names that are recognised there is none. */
QUELL_CALL const char *quell_exr_signal_name(const quell_exr *file, int32_t index);
/* Chooses the signal that is read. Files of one signal, or whose channels are named by quell_exr_want(), need no choice. */
QUELL_CALL quell_status quell_exr_choose_signal(quell_exr *file, const char *name);

/* Says that quell_exr_read() reads a channel.
 * @param channel  quell's name of it: one that quell_channel_name() lists
 * @param optional 1: frames may lack it, as quell_channel_is_optional() says. It is left out where the file lacks it.
 * @param planes   names of the file's channels for its components, as many as it has; null: those by which quell knows the file */
QUELL_CALL quell_status quell_exr_want(quell_exr *file, const char *channel, int32_t optional, const char *const *planes);
/* Reads the channels that are wanted, all at once. Sets frame->channels and channel_count; camera, to null where the file has none; shutter,
 * where it has one. All else of the frame stays. What is set lies in memory of the file's, until it is read again or closed.
 * Motion vectors, depth and misses are in quell's own conventions then.
 * @param width, height of the frames that the denoiser takes: a file of another size is refused. 0 takes any. */
QUELL_CALL quell_status quell_exr_read(quell_exr *file, int32_t width, int32_t height, quell_frame *frame);

/* Reads what a denoiser reads. (It stands here, as it calls libquell.) */
static inline quell_status quell_exr_read_for(quell_exr *file, const quell_denoiser *denoiser, quell_frame *frame) {
    const char *name;
    int32_t i;
    for (i = 0; (name = quell_channel_name(denoiser, i)) != 0; ++i) {
        const quell_status status = quell_exr_want(file, name, quell_channel_is_optional(denoiser, name), 0);
        if (status != QUELL_OK) return status;
    }
    return quell_exr_read(file, quell_width(denoiser), quell_height(denoiser), frame);
}

/* How pixels are packed. All but the last two keep every bit. */
typedef enum quell_exr_compression {
    QUELL_EXR_ZIP = 0,
    QUELL_EXR_NONE = 1,
    QUELL_EXR_RLE = 2,
    QUELL_EXR_ZIPS = 3, /* ZIP row by row */
    QUELL_EXR_PIZ = 4,
    QUELL_EXR_DWAA = 5, /* for colours only */
    QUELL_EXR_DWAB = 6
} quell_exr_compression;

/* A file to write. Start from QUELL_EXR_OUTPUT. */
typedef struct quell_exr_output {
    size_t struct_size;
    int32_t width, height; /* of all images; 0: those of `like` */
    /* Images by name. radiance becomes R, G, B, radiance_alpha R, G, B, A, and quell's other channels what they are called in its own
     * files, such as albedo.R. Of another name: a single component has the name itself; two are name.X and Y, three and four name.R, G, B,
     * A; of more, each is name.number. */
    const quell_channel *channels;
    size_t channel_count;
    int32_t format;        /* of the numbers in the file: QUELL_FLOAT16 or QUELL_FLOAT32 */
    int32_t compression;   /* a quell_exr_compression */
    const quell_exr *like; /* the file whose attributes are written too: those that quell_exr_attribute_name() lists, less those that say how
                              that file is laid out; null: none */
} quell_exr_output;
#ifdef __cplusplus
#define QUELL_EXR_OUTPUT                                                                                                                   \
    quell_exr_output { sizeof(quell_exr_output), 0, 0, nullptr, 0, QUELL_FLOAT16, QUELL_EXR_ZIP, nullptr }
#else
#define QUELL_EXR_OUTPUT ((quell_exr_output){sizeof(quell_exr_output), 0, 0, NULL, 0, QUELL_FLOAT16, QUELL_EXR_ZIP, NULL})
#endif
/* Writes a file of one part. A file of that path is replaced when all is written, never half. */
QUELL_CALL quell_status quell_exr_write(const char *path, const quell_exr_output *output);

#ifdef __cplusplus
}
#endif
#endif
