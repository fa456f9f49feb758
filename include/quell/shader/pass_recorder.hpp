#pragma once

#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/run.hpp>
#include <quell/shader/record_options.hpp>
#include <quell/shader/recorded_counts.hpp>
#include <quell/shader/recorded_marks.hpp>
#include <quell/shader/shader_plan.hpp>

#include <algorithm>
#include <list>
#include <memory>

/// @file
/// An executor that records what run() asks for.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A pass of one frame as it was recorded, and the memory of each plane of its graph.
struct RecordedPass {
    PassGraph graph;
    std::vector<void const*> memory;
    bool takes_given_guides = false; ///< else repaired ones, where they are repaired
};

/// Records passes by running each once for one pixel that may be any.
class PassRecorder {
    std::unordered_map<void const*, KnownPlane> known;
    std::vector<RecordedPass> passes;
    RecordOptions options;
    int holes_to_fill = 0;      ///< passes of FillHoles that are to come
    std::list<char> own_planes; ///< their addresses stand for memory of the recorder's own
    std::vector<void const*> squares;
    std::vector<ShaderCount> counted;

public:
    explicit PassRecorder(RecordOptions const& o) : options(o) {}

    /// A plane that the host fills, or a pass.
    template <class View> void note(View const& view, std::string_view channel, int fraction) {
        bool const is_half = options.half_precision && !std::is_same_v<typename View::Element, float>;
        for (int c = 0; c < View::components; ++c)
            if (view.planes[c]) known[view.planes[c]] = {std::string(channel), c, fraction, is_half};
    }
    /// Passes since the last call.
    [[nodiscard]] std::vector<RecordedPass> take() { return std::exchange(passes, {}); }
    /// Since the last call: what is counted, and the memory of the planes in which it is, by the slots of `counted`, from 0.
    [[nodiscard]] std::pair<std::vector<ShaderCount>, std::vector<void const*>> take_counts() {
        return {std::exchange(counted, {}), std::exchange(squares, {})};
    }

    void record(auto const& job) { record_job(recorded_job(job)); }
    /// Records a pass.
    /// @param steps does what a pixel of it does, column and row given
    void record_steps(std::string name, int fraction, auto const& steps) {
        PassRecording recording(known, options.half_precision);
        graph_builder = &recording.builder, pass_recording = &recording;
        struct Restore {
            ~Restore() { graph_builder = nullptr, pass_recording = nullptr; }
        } const restore;
        recording.rays = rays_at(FrameBlock::rays_word), recording.rays_then = rays_at(FrameBlock::rays_then_word);
        steps(recorded_leaf<RecordedInteger>(Operation::this_column, 0), recorded_leaf<RecordedInteger>(Operation::this_row, 0));
        keep(recording, std::move(name), fraction);
    }

private:
    template <class Job> void record_job(Job const& job) {
        if constexpr (
            requires { job.finish; } || requires { job.output; } || requires { job.carried; })
            record_pass(job);
        // Others repair what a frame of numbers has: there is none here.
        if constexpr (requires { requires IsCounted<decltype(Job::pass)>; }) {
            holes_to_fill = options.fill_holes;
            if (options.counts) count<CountsOfSamples<decltype(Job::pass)>>(job), count<CountsOfLight<decltype(Job::pass)>>(job);
        }
        // So run() goes on with FillHoles as long as is wanted.
        if constexpr (requires { job.counts; })
            if (job.counts) job.counts->holes = holes_to_fill-- > 0;
    }
    void record_pass(auto const& job) {
        note_stores(job);
        record_steps(std::string(job.name), fraction_of_job(job), [&](RecordedInteger x, RecordedInteger y) {
            if constexpr (requires { job.finish; })
                job.template at_pixels<Recorded, 1>(x, y, 1);
            else
                job(at_once<Recorded>, x, y, 1);
        });
    }
    template <class Counted> void count(auto const& job) {
        if constexpr (Counted::size > 0) {
            auto const plane = [&](int fraction) {
                void const* const address = &own_planes.emplace_back();
                known[address] = {"counts", 0, fraction};
                return address;
            };
            auto const of_8 = plane(8), of_64 = plane(counted_square);
            record_steps("counts", 8, [&](auto, auto) { record_counts_of_pixels<Counted>(job, of_8); });
            passes.back().takes_given_guides = Counted::takes_given_guides;
            record_steps("sums of counts", counted_square, [&](auto, auto) { record_sums_of_counts<Counted::size>(of_8, of_64); });
            int block = 0;
            for (auto& name : Counted::names())
                counted.push_back({std::move(name), std::string(Counted::signal), static_cast<int>(squares.size()), block++});
            squares.push_back(of_64);
        }
    }
    static RecordedRays rays_at(int word) {
        auto const vector = [&](int at) { return vec3<Recorded>{uniform(at), uniform(at + 1), uniform(at + 2)}; };
        return {vector(word), vector(word + 4), vector(word + 8), vector(word + 12), uniform(word + 3)};
    }
    template <class Job> static int fraction_of_job(Job const&) {
        if constexpr (requires(Job const j) { j.scope; })
            return decltype(Job::scope)::fraction;
        else
            return 1;
    }
    template <class Job> void note_stores(Job const& job) {
        if constexpr (requires { job.finish; }) {
            int const fraction = fraction_of_job(job);
            for_each_channel(typename decltype(job.made)::channels{}, [&]<class C>(C c) { note(job.made.view(c), C::name, fraction); });
            for_each_channel(typename decltype(job.finish.remembered)::channels{},
                             [&]<class C>(C c) { note(job.finish.remembered.view(c), C::name, fraction); });
            note(job.finish.output, "output", fraction);
            if (job.store_signal) note(job.signal, "signal", fraction);
        } else if constexpr (requires { job.carried; })
            for_each_channel(typename decltype(job.carried)::channels{}, [&]<class C>(C c) { note(job.carried.view(c), C::name, 1); });
        else
            note(job.output, "output", 1);
    }
    void keep(PassRecording& recording, std::string name, int fraction) {
        PassGraph graph{.name = std::move(name), .fraction = fraction, .nodes = recording.builder.take()};
        // Planes that only dead steps have looked at go.
        std::vector<std::int32_t> number(recording.memory.size(), -1);
        std::vector<void const*> memory;
        for (auto& node : graph.nodes) {
            if (node.operation != Operation::load && node.operation != Operation::store) continue;
            auto& its = number[node.payload];
            if (its < 0) {
                its = static_cast<std::int32_t>(memory.size());
                auto const& plane = recording.planes[node.payload];
                graph.planes.push_back(
                    {.channel = plane.channel, .component = plane.component, .fraction = plane.fraction, .is_half = plane.is_half});
                memory.push_back(recording.memory[node.payload]);
            }
            node.payload = static_cast<std::uint32_t>(its);
        }
        passes.push_back({std::move(graph), std::move(memory)});
    }
};

/// The executor.
struct RecordingExecutor {
    static constexpr bool needs_own_images = true; ///< a plan's buffers are those of this frame and the last
    PassRecorder* recorder;
    void for_each_pixel(Region, auto const& job) const { recorder->record(job); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
