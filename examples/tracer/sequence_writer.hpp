#pragma once

#include "options.hpp"
#include "trace_frame.hpp"

#include <quell/io/frame_image.hpp>
#include <support/progress.hpp>

#include <filesystem>

namespace quell::tracer {

/// One scene on its way to disk.
class SequenceWriter {
public:
    /// @param done counts the frames of all sequences, for the progress
    SequenceWriter(TraceOptions const& options_, SceneDescription description, std::filesystem::path folder_, examples::Progress& progress_,
                   long long& done_)
        : options(options_), scene(std::move(description)), folder(std::move(folder_)), progress(progress_), done(done_) {}

    /// Traces all frames with one set of channels, known when this is compiled.
    template <class Wanted> RayCounts trace() {
        RayCounts rays;
        for (int number = options.first; number < options.first + options.frames; ++number) {
            progress.show(done++, folder.filename().string());
            Frame<Wanted> frame(options.rendered.size);
            rays += trace_frame(scene, settings(number), frame);
            write("frame", number, io::image_of(frame));
            if (options.reference > 0) write_reference(number);
            if (options.masks) write_masks(number);
        }
        return rays;
    }

private:
    [[nodiscard]] RenderSettings settings(int frame) const;
    void write(char const* name, int frame, io::ExrImage image) const;
    void write_reference(int frame);
    void write_masks(int frame);

    TraceOptions const& options;
    PreparedScene scene;
    std::filesystem::path folder;
    examples::Progress& progress;
    long long& done;
};

} // namespace quell::tracer
