/* Writes a preset as compute shaders into a folder that is there: write_shaders general wgsl out */
#include <quell_shaders.h>

#include <stdio.h>

static int write_file(const char *folder, const char *name, const char *text) {
    char path[4096];
    FILE *file;
    int done;
    const int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    if (length < 0 || (size_t)length >= sizeof path || (file = fopen(path, "wb")) == NULL) return 0;
    done = fputs(text, file) >= 0;
    return fclose(file) == 0 && done;
}

int main(int count, char **arguments) {
    quell_shaders *shaders;
    const char *name;
    int32_t i;
    int done;
    if (count != 4) {
        fprintf(stderr, "write_shaders: give a preset, a language and a folder\n");
        return 2;
    }
    if (quell_shaders_create(arguments[1], arguments[2], &shaders) != QUELL_OK) {
        fprintf(stderr, "write_shaders: %s\n", quell_shaders_error());
        return 2;
    }
    done = write_file(arguments[3], "plan.json", quell_shaders_plan(shaders));
    for (i = 0; done && (name = quell_shaders_name(shaders, i)) != NULL; ++i)
        done = write_file(arguments[3], name, quell_shaders_text(shaders, i));
    quell_shaders_destroy(shaders);
    if (!done) fprintf(stderr, "write_shaders: %s can't be written to\n", arguments[3]);
    return done ? 0 : 1;
}
