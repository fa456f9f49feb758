#pragma once

#include "../convert_motion.hpp"
#include "../for_each_strip.hpp"
#include "callers_image.cuh"
#include "device_codes.hpp"
#include "device_memory.cuh"
#include "device_plan.cuh"

#include <quell/image/borrowed.hpp>
#include <quell/quell.hpp>

#include <glm/gtc/type_ptr.hpp>

#include <optional>
#include <tuple>

// Presets on a GPU behind the types that libquell's code has in common: what generated files instantiate.
namespace quell_library::inline QUELL_INSTRUCTION_SET {

/// Calls f on the denoiser's device, and says what was thrown.
template <class F> Outcome caught_on_device(std::string& error, F const& f) noexcept {
    auto const say = [&](char const* text, Outcome outcome) {
        try {
            error = text;
        } catch (...) {
            error.clear();
        }
        return outcome;
    };
    try {
        f();
        return Outcome::ok;
    } catch (NoDeviceMemory const& thrown) {
        return say(thrown.what(), Outcome::no_memory);
    } catch (quell::Failure const& thrown) {
        return say(thrown.what(), Outcome::failed);
    } catch (quell::Error const& thrown) {
        return say(thrown.what(), Outcome::invalid);
    } catch (std::bad_alloc const&) {
        return say("memory: there is no more; give smaller images, or let go of other denoisers", Outcome::no_memory);
    } catch (std::exception const& thrown) {
        return say(thrown.what(), Outcome::failed);
    }
}

/// An image in the device's memory that stands in for one of the caller's, and one of the host's to fill it from.
template <int N> struct StandIn {
    using OnDevice = typename quell::Planar<quell::Float32, LibraryMemory>::template Image<N>;
    using OnHost = typename quell::Planar<>::template Image<N>;
    std::optional<OnDevice> on_device;
    std::optional<OnHost> on_host;

    [[nodiscard]] std::size_t bytes() const { return on_device ? on_device->bytes() : 0; }
};
template <class Image> Image& made(std::optional<Image>& image, quell::Extent size) {
    if (!image || !(image->size() == size)) image.emplace(size);
    return *image;
}

/// A pipeline on a device.
/// @tparam E the executor: quell::Cuda, or what is made of one by E{cuda}
template <class P, class E> class CudaInstance final : public Instance {
    using Set = typename P::reads;
    template <class... Cs> static std::tuple<StandIn<Cs::components>...> stand_ins_of(quell::Channels<Cs...>);

    std::vector<Channel> const& channels;
    int device = detail::current_device();
    bool may_move; ///< images, to and from the device
    Parallel parallel;
    quell::Cuda cuda;
    quell::CudaGraphs graphs; // lives longer than the history
    E executor;
    P pipeline;
    quell::MotionConvention motion;
    JitterOf before;
    quell::Frame<Set, quell::Borrowed<quell::Float32, LibraryMemory>> frame;
    quell::History<P, quell::Planar<quell::Float32, LibraryMemory>> history;
    decltype(stand_ins_of(Set{})) stand_ins;
    std::optional<typename quell::Planar<>::template Image<P::Output::components>> picture; ///< of the host
    std::vector<Image> given;

public:
    CudaInstance(P const& made, std::vector<Channel> const& read, quell::Extent size, Motion const& m, Parallel const& p, bool moves)
        : channels(read), may_move(moves),
          parallel(p), cuda{.stream = static_cast<cudaStream_t>(p.stream)}, executor{quell::Cuda{.stream = cuda.stream, .graphs = &graphs}},
          pipeline(made), motion(convention_of(m)), frame(size), history(size, pipeline) {}

    Outcome run(std::vector<Frame> const& frames, Image const& output, std::string& error) noexcept override {
        return caught_on_device(error, [&] {
            OnDevice const on(device);
            MayMove const moves(may_move);
            try {
                denoise(frames.front(), output);
            } catch (...) {
                executor.drop(); // what was put in and does not run
                throw;
            }
        });
    }
    Outcome copy_guide(std::string const&, Image const&, std::string& error) noexcept override {
        return caught_on_device(error, [] { quell::raise_error("guide", "there are none on a device", "use the CPU"); });
    }
    void forget() noexcept override { history.forget(); }
    [[nodiscard]] Statistics statistics() const noexcept override {
        Statistics counted{.bytes = history.bytes()};
        std::apply([&](auto const&... each) { ((counted.bytes += each.bytes()), ...); }, stand_ins);
        std::string lost; // the next frame says it, too
        caught_on_device(lost, [&] {
            OnDevice const on(device);
            auto const now = history.statistics();
            counted.frames = now.frames, counted.resets = now.resets;
            counted.missing_samples = now.missing_samples, counted.repaired_guides = now.repaired_guides.pixels;
        });
        return counted;
    }

    static std::size_t bytes_of_plan(P const& of, quell::Extent size) {
        static double const bytes_per_pixel = device_plan_of(of).bytes_per_pixel;
        return static_cast<std::size_t>(bytes_per_pixel * static_cast<double>(size.pixels()));
    }

private:
    void denoise(Frame const& from, Image const& output) {
        quell::Extent const size{from.width, from.height};
        given = from.channels;
        if (!(frame.size == size)) frame = decltype(frame)(size);
        JitterOf now{{}, size};
        if (from.camera != nullptr) {
            now.jitter = glm::make_vec2(from.camera->jitter);
            frame.camera = {glm::make_mat4(from.camera->view), glm::make_mat4(from.camera->projection), now.jitter};
        }
        convert_motion(motion, channels, given, now, before);
        take_images();
        frame.number = from.has_number ? std::optional<long long>(from.number) : std::nullopt;
        frame.shutter = from.shutter;
        bool const on_host = !is_reached(output.data, device, "output");
        give(quell::run(pipeline, frame, history, executor), {output, size}, on_host);
        before = now;
    }
    /// Points the frame at the caller's images, or at what stands in for them. Those in the host's memory come first: to copy them sends
    /// off what waits.
    void take_images() {
        std::vector<bool> is_there(given.size());
        bool waits = false;
        each_channel([&](auto c, std::size_t i, auto& stand_in) {
            is_there[i] = is_reached(given[i].data, device, "channel '" + std::string(c.name) + "'");
            if (is_there[i]) return;
            take_from_host(c, {given[i], frame.size}, stand_in), waits = true;
        });
        if (waits) cuda.synchronize();
        each_channel([&](auto c, std::size_t i, auto& stand_in) {
            if (is_there[i]) take_on_device(c, {given[i], frame.size}, stand_in);
        });
    }
    void each_channel(auto const& function) {
        std::size_t i = 0;
        for_each_channel(Set{}, [&]<class C>(C c) {
            given[i].samples.repeats = quell::Subsampled<quell::half_size, quell::Channels<C>>::template repeats<C>;
            function(c, i++, stand_in_of(c));
        });
    }
    template <class C> auto& stand_in_of(C) {
        return [&]<class... Cs>(quell::Channels<Cs...>) -> auto& {
            constexpr auto place = [] {
                std::size_t i = 0, found = 0;
                ((std::is_same_v<C, Cs> ? found = i++ : ++i), ...);
                return found;
            }();
            return std::get<place>(stand_ins);
        }
        (Set{});
    }
    template <class C> void take_from_host(C c, CallersImage const& from, StandIn<C::components>& stand_in) {
        auto const to = made(stand_in.on_device, from.size).view();
        auto const staged = made(stand_in.on_host, from.size).view();
        for_each_strip(parallel, from.size.height, [&](int y0, int y1) {
            for (int y = y0; y < y1; ++y)
                for (int x = 0; x < from.size.width; ++x)
                    for (int k = 0; k < C::components; ++k) staged.set(k, x, y, from.get(k, x, y));
        });
        quell::detail::copy_planes(to, staged, cuda);
        refer(c, to);
    }
    template <class C> void take_on_device(C c, CallersImage const& from, StandIn<C::components>& stand_in) {
        constexpr std::ptrdiff_t element = sizeof(float);
        auto const& image = from.image;
        if (from.is_floats()) {
            frame[c] = {reinterpret_cast<float const*>(image.data), from.size, image.pixel_stride / element, image.row_stride / element,
                        image.component_stride / element};
            return;
        }
        auto const to = made(stand_in.on_device, from.size).view();
        executor.enqueue({0, 0, from.size.width, from.size.height}, TakeImage<std::remove_const_t<decltype(to)>>{from, to});
        refer(c, to);
    }
    void refer(auto c, auto const& view) {
        auto const distance = view.components > 1 ? view.planes[view.components - 1] - view.planes[0] : 0;
        frame[c] = {view.planes[0], view.size, 1, view.row_stride(), distance / std::max(1, view.components - 1)};
    }
    void give(auto const& view, CallersImage const& to, bool on_host) {
        using View = std::remove_cvref_t<decltype(view)>;
        if (!on_host) {
            executor.enqueue({0, 0, view.size.width, view.size.height}, GiveImage<View>{view, to});
            return executor.submit();
        }
        auto const& image = made(picture, view.size);
        quell::detail::copy_planes(image.view(), view, cuda);
        cuda.synchronize();
        for_each_strip(parallel, view.size.height, [&](int y0, int y1) {
            for (int y = y0; y < y1; ++y)
                for (int x = 0; x < view.size.width; ++x)
                    for (int c = 0; c < View::components; ++c) to.set(c, x, y, image.get(c, x, y));
        });
    }
};

/// See DeviceCode::make_image.
inline std::shared_ptr<void const> make_device_image(Sizes const& sizes, bool may_move, Image& image, Outcome& outcome,
                                                     std::string& error) {
    using OnDevice = quell::Planar<quell::Float32, LibraryMemory>::Image<3>;
    std::shared_ptr<OnDevice> made;
    outcome = caught_on_device(error, [&] {
        MayMove const moves(may_move);
        made = std::make_shared<OnDevice>(quell::Extent{sizes.width, sizes.height});
        constexpr std::ptrdiff_t element = sizeof(float);
        auto const view = made->view();
        image = {.data = reinterpret_cast<std::byte*>(view.planes[0]),
                 .component_stride = (view.planes[1] - view.planes[0]) * element,
                 .pixel_stride = element,
                 .row_stride = view.row_stride() * element};
    });
    return made;
}

/// The channel that a pipeline's history is of; of others none.
template <class P> std::string signal_of() {
    if constexpr (requires { requires P::has_temporal; })
        return P::Output::name;
    else
        return {};
}

/// A preset for a device, or a stage behind presets, from a function without state that makes its pipeline for so many samples of each
/// pixel.
template <class E, class Make> DeviceCode cuda_code(std::string const& name, Make) {
    using P = std::remove_const_t<decltype(Make{}(1.f))>;
    PresetWay way{.output_components = P::Output::components, .needs_camera = P::needs_camera};
    if constexpr (requires { requires P::checks_jitter; }) way.needs_jitter = name;
    quell::for_each_channel(typename P::reads{}, [&]<class C>(C c) {
        static_assert(C::fraction == 1, "libquell: a channel of a part of the frame's size can't be taken on a device");
        way.channels.push_back({std::string(c.name), c.components, false, c.is_guide});
    });
    way.plan = [] { return to_string(device_plan_of(Make{}(1.f))); };
    way.make = [channels = std::make_shared<std::vector<Channel> const>(way.channels)](
                   Sizes const& sizes, float samples, Motion const& motion, Parallel const& parallel, Memory const& memory,
                   Outcome& outcome, std::string& error) -> std::unique_ptr<Instance> {
        int devices = 0;
        if (auto const status = cudaGetDeviceCount(&devices); status != cudaSuccess || devices == 0) {
            cudaGetLastError();
            outcome = Outcome::not_supported;
            error = std::string("the device: there is no GPU to run on (") +
                    (status == cudaSuccess ? "the driver has none" : cudaGetErrorString(status)) +
                    "); use a machine with an NVIDIA GPU and a driver that is as new as CUDA, or the CPU";
            return nullptr;
        }
        std::unique_ptr<Instance> made;
        outcome = caught_on_device(error, [&] {
            using Made = CudaInstance<P, E>;
            quell::Extent const size{sizes.width, sizes.height};
            auto const pipeline = Make{}(samples);
            bool const moves = memory.may_move && can_move(detail::current_device());
            if (!moves) check_free_memory(Made::bytes_of_plan(pipeline, size), size);
            made = std::make_unique<Made>(pipeline, *channels, size, motion, parallel, moves);
        });
        return made;
    };
    return {.name = name, .signal = signal_of<P>(), .way = std::move(way), .make_image = &make_device_image};
}

} // namespace quell_library::inline QUELL_INSTRUCTION_SET
