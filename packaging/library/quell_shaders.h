/* Presets as compute shaders, from C99 and every language that can call C: texts in memory, and the plan that says how to run them.
 *
 *     quell_shaders *shaders;
 *     if (quell_shaders_create("general", "wgsl", &shaders) != QUELL_OK) puts(quell_shaders_error());
 *     const char *name;
 *     for (int32_t i = 0; (name = quell_shaders_name(shaders, i)) != NULL; ++i) compile(name, quell_shaders_text(shaders, i));
 *     run(quell_shaders_plan(shaders));
 *     quell_shaders_destroy(shaders);
 *
 * What the plan says, and what a host does with it: docs/shaders.md. The library is libquell-shaders. It does not need libquell, and libquell
 * does not need it; they share the types of quell.h. A function that can fail returns a quell_status, and quell_shaders_error() then says in
 * one sentence what is wrong, what was found and what to do. No exception leaves the library. Shaders belong to who had them written. */
#ifndef QUELL_SHADERS_H
#define QUELL_SHADERS_H

#include "quell.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A preset as shaders, one or two for each pass. */
typedef struct quell_shaders quell_shaders;

/* What was wrong with this thread's last call that returned a quell_status; empty where nothing was. */
QUELL_CALL const char *quell_shaders_error(void);

/* Names of the presets that can be written, and behind them those of stages, which read the channel denoised: what a preset has made. Null
 * beyond the last. */
QUELL_CALL const char *quell_shaders_preset_name(int32_t index);
/* Names of the languages that they can be written in; null beyond the last. */
QUELL_CALL const char *quell_shaders_language_name(int32_t index);

/* Writes a preset as shaders, in memory.
 * @param preset   or stage: one that quell_shaders_preset_name() lists
 * @param language "wgsl", or "glsl" for Vulkan. Others are made from glsl, by glslangValidator and spirv-cross: the program quell-shaders
 *                 does it.
 * @param shaders  set to them; to null where they can't be written */
QUELL_CALL quell_status quell_shaders_create(const char *preset, const char *language, quell_shaders **shaders);
/* What is added to a preset's passes, and how they are written. Start from QUELL_SHADERS_OPTIONS; docs/shaders.md says more. */
typedef struct quell_shaders_options {
    size_t struct_size;
    int32_t repair_guides;    /* 1: guides that no scene has are repaired */
    int32_t fill_holes;       /* passes that give missing samples what stands 2, 4, 8, ... pixels away */
    int32_t counts;           /* 1: missing samples, impossible guides and suppressed light are counted */
    int32_t most_slots;       /* of a buffer: what has more lies in several. 0: there is no limit. */
    int32_t half_precision;   /* 1: history and scratch are kept in 16 bits a component */
    int32_t texel_loads;      /* 1: GLSL loads planes by texelFetch, for devices that are a CPU */
    int32_t workgroup_width;  /* threads of a workgroup along each axis, 128 in all at most. 0: 8 */
    int32_t workgroup_height;
    int32_t samples_per_pixel; /* for stages; 0: not known, which is taken for 1 */
} quell_shaders_options;
#ifdef __cplusplus
#define QUELL_SHADERS_OPTIONS                                                                                                              \
    quell_shaders_options { sizeof(quell_shaders_options), 0, 0, 0, 0, 0, 0, 0, 0, 0 }
#else
#define QUELL_SHADERS_OPTIONS ((quell_shaders_options){sizeof(quell_shaders_options), 0, 0, 0, 0, 0, 0, 0, 0, 0})
#endif
/* The same with options; null: none. */
QUELL_CALL quell_status quell_shaders_create_with(const char *preset, const char *language, const quell_shaders_options *options,
                                                  quell_shaders **shaders);
/* Frees them and their texts. Null does nothing. */
QUELL_CALL void quell_shaders_destroy(quell_shaders *shaders);

/* File names of the shaders, such as 06-temporal.wgsl, by which the plan calls them; null beyond the last. */
QUELL_CALL const char *quell_shaders_name(const quell_shaders *shaders, int32_t index);
/* The text of a shader; null beyond the last. */
QUELL_CALL const char *quell_shaders_text(const quell_shaders *shaders, int32_t index);
/* The plan as JSON: passes in order, what they bind, and where everything lies. Usually written as plan.json. */
QUELL_CALL const char *quell_shaders_plan(const quell_shaders *shaders);

/* What differs from frame to frame. Start from QUELL_SHADERS_FRAME. */
typedef struct quell_shaders_frame {
    size_t struct_size;
    int32_t width, height;           /* in pixels */
    int32_t number;                  /* of the frame: seed of random numbers */
    int32_t needs_camera;            /* needs_camera of the plan: 1 where the matrices of cameras are looked at */
    float shutter, shutter_then;     /* shutter time of this frame and of the previous one, as a part of the time between frames */
    const quell_camera *camera;      /* null: none, which is without jitter */
    const quell_camera *camera_then; /* of the previous frame; null: the same, as in a frame without a past */
} quell_shaders_frame;
#ifdef __cplusplus
#define QUELL_SHADERS_FRAME                                                                                                                \
    quell_shaders_frame { sizeof(quell_shaders_frame), 0, 0, 0, 0, 0.5f, 0.5f, nullptr, nullptr }
#else
#define QUELL_SHADERS_FRAME ((quell_shaders_frame){sizeof(quell_shaders_frame), 0, 0, 0, 0, 0.5f, 0.5f, NULL, NULL})
#endif

/* Bytes of the block of uniforms, which is the same for all presets. */
QUELL_CALL size_t quell_shaders_block_size(void);
/* Writes the block of uniforms of a frame, as shaders read it: what a host copies to its buffer. It is a matter of microseconds.
 * @param bytes how many there are at `block`: quell_shaders_block_size() at least */
QUELL_CALL quell_status quell_shaders_block(const quell_shaders_frame *frame, void *block, size_t bytes);

#ifdef __cplusplus
}
#endif
#endif
