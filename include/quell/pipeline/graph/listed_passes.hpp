#pragma once

#include <quell/pipeline/graph/frame_pass.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The passes of a running frame with all that they need, as a ListExecutor gets them. Other executors run each by itself.
class ListedPasses {
    std::vector<ListedPass> passes;
    std::vector<std::byte> jobs;
    std::vector<ListedRead> reads;
    std::vector<void const*> writes;
    struct Ends {
        std::size_t reads, writes;
    };
    std::vector<Ends> ends;            ///< behind each pass
    std::vector<std::size_t> job_ends; ///< behind each pass

public:
    void clear() { passes.clear(), jobs.clear(), reads.clear(), writes.clear(), ends.clear(), job_ends.clear(); }

    void add(FramePass const& pass, PassArguments const& arguments) {
        auto const fraction = pass.fraction;
        passes.push_back({.name = pass.name,
                          .size = divided(arguments.facts.size, fraction),
                          .fraction = fraction,
                          .reads = {},
                          .writes = {},
                          .run = pass.run,
                          .executor = arguments.typed.executor});
        auto const at = jobs.size();
        jobs.resize(at + pass.job_bytes);
        pass.make_job(arguments, jobs.data() + at);
        job_ends.push_back(jobs.size());
        note_reads(pass, arguments.images);
        note_writes(arguments);
        ends.push_back({reads.size(), writes.size()});
    }
    /// The list. It lives until the next frame.
    [[nodiscard]] std::span<ListedPass const> complete() {
        std::size_t job = 0;
        Ends begin{0, 0};
        for (std::size_t i = 0; i < passes.size(); ++i) {
            passes[i].job = jobs.data() + job;
            passes[i].reads = std::span(reads).subspan(begin.reads, ends[i].reads - begin.reads);
            passes[i].writes = std::span(writes).subspan(begin.writes, ends[i].writes - begin.writes);
            job = job_ends[i], begin = ends[i];
        }
        return passes;
    }

private:
    void note_reads(FramePass const& pass, PassImages const& images) {
        int const rows = pass.farthest_tap > anywhere / pass.fraction ? anywhere : pass.farthest_tap * pass.fraction;
        auto const read = [&](PooledImage const* image, int near_by) {
            if (!image) return;
            for (auto const& piece : image->pieces)
                if (piece) reads.push_back({piece.get(), near_by});
        };
        if (pass.reads_signal) read(&images.signal, rows);
        for (ChannelId const channel : pass.reads_made) read(images.made.find(channel), rows);
        // The past is looked at anywhere.
        if (pass.reads_past_signal) read(&images.then.signal, anywhere);
        for (ChannelId const channel : pass.reads_kept) read(images.then.kept.find(channel), anywhere);
        if (pass.reads_remembered.size() > 0) images.then.guides.for_each([&](auto const& image) { read(&image, anywhere); });
    }
    void note_writes(PassArguments const& arguments) {
        auto const& images = arguments.images;
        auto const write = [&](PooledImage const& image) {
            for (auto const& piece : image.pieces)
                if (piece) writes.push_back(piece.get());
        };
        if (arguments.stores.signal) write(images.signal_out);
        if (arguments.stores.output) write(images.output);
        if (arguments.stores.guides) images.guides_out.for_each(write);
        images.made_out.for_each(write);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
