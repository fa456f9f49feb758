#pragma once

#include "host_images.hpp"

#include <quell/execute/outlined.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/presets/named.hpp>
#include <quell/quell.hpp>

#include <algorithm>

namespace quell_library {

/// Runs strips of the image side by side, by whatever threads there are.
struct Strips {
    Parallel parallel;

    template <class Job> void for_each_pixel(quell::Region region, Job const& job) const {
        struct Context {
            quell::Region region;
            Job const& job;
        } const context{region, job};
        constexpr int height = 16;
        auto const strip = [](void* from, std::int32_t index) {
            auto const& [whole, its_job] = *static_cast<Context const*>(from);
            int const y = whole.y0 + index * height;
            quell::Outlined<>{}.for_each_pixel({whole.x0, y, whole.x1, std::min(y + height, whole.y1)}, its_job);
        };
        parallel.run(parallel.user, (region.y1 - region.y0 + height - 1) / height, strip, const_cast<Context*>(&context));
    }
};

/// A preset with the caller's images.
template <class P> class PresetInstance final : public Instance {
    P pipeline;
    quell::Extent size;
    Memory memory;
    Strips executor;
    quell::Frame<typename P::reads, HostImages> frame;
    quell::History<P, OwnImages> history;

public:
    PresetInstance(P const& p, quell::Extent s, Parallel const& parallel, Memory const& m)
        : pipeline(p), size(s), memory(m), executor{parallel}, frame(s), history(s, p, OwnImages{}) {}

    Outcome run(quell_library::Frame const& given, std::string& error) noexcept override {
        return caught(error, [&] {
            CallersMemory::current() = memory;
            std::size_t next = 0;
            for_each_channel(typename P::reads{}, [&](auto c) { frame[c].image = given.channels[next++]; });
            if (given.camera != nullptr) take_camera(*given.camera);
            frame.number = given.has_number ? std::optional<long long>(given.number) : std::nullopt;
            frame.shutter = given.shutter;
            auto const& out = given.output;
            HostTarget<P::Output::components> const target{out.data,         size,           out.component_stride,
                                                           out.pixel_stride, out.row_stride, out.is_half};
            run_into(target, pipeline, frame, history, executor);
        });
    }
    void forget() noexcept override { history.forget(); }
    [[nodiscard]] Statistics statistics() const noexcept override {
        auto const counted = history.statistics();
        return {counted.frames, counted.resets, counted.missing_samples, counted.repaired_guides.pixels, history.bytes()};
    }

    /// Calls f, and says what was thrown.
    template <class F> static Outcome caught(std::string& error, F&& f) noexcept {
        try {
            f();
            return Outcome::ok;
        } catch (quell::Error const& thrown) {
            return failed(error, thrown.what(), Outcome::invalid);
        } catch (std::bad_alloc const&) {
            return failed(error, "memory: there is no more; give smaller images, or let go of other denoisers", Outcome::no_memory);
        } catch (std::exception const& thrown) {
            return failed(error, thrown.what(), Outcome::failed);
        }
    }

private:
    static Outcome failed(std::string& error, char const* text, Outcome outcome) noexcept {
        try {
            error = text;
        } catch (...) {
            error.clear();
        }
        return outcome;
    }
    void take_camera(Camera const& camera) {
        for (int i = 0; i < 16; ++i) {
            frame.camera.view[i / 4][i % 4] = camera.view[i];
            frame.camera.projection[i / 4][i % 4] = camera.projection[i];
        }
        frame.camera.jitter = {camera.jitter[0], camera.jitter[1]};
    }
};

/// A preset as code.
template <class Named> PresetCode code_of(Named const& named) {
    using P = std::remove_const_t<decltype(Named::usual())>;
    PresetCode code{.name = std::string(named.name), .output_components = P::Output::components, .needs_camera = P::needs_camera};
    quell::for_each_channel(typename P::reads{}, [&](auto c) { code.channels.push_back({std::string(c.name), c.components}); });
    code.plan = [] { return to_string(plan_of(Named::usual())); };
    code.make = [](int width, int height, Parallel const& parallel, Memory const& memory, Outcome& outcome,
                   std::string& error) noexcept -> std::unique_ptr<Instance> {
        std::unique_ptr<Instance> made;
        outcome = PresetInstance<P>::caught(error, [&] {
            CallersMemory::current() = memory;
            made = std::make_unique<PresetInstance<P>>(Named::usual(), quell::Extent{width, height}, parallel, memory);
        });
        return made;
    };
    return code;
}

/// Every `units`-th of the presets of the first three groups, from number `unit` on.
template <std::size_t unit, std::size_t units> std::vector<PresetCode> codes_of_unit();

} // namespace quell_library
