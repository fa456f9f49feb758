#include <denoise/denoiser.hpp>
#include <denoise/layout_changes.hpp>

#include <library/resolved_denoiser.hpp>
#include <library/stage.hpp>
#include <library/wrapped_denoiser.hpp>
#include <quell/diagnose/diagnose.hpp>
#include <quell/io/camera_attributes.hpp>
#include <quell/io/frame_image.hpp>

#include <array>

namespace quell::examples {

using namespace quell_library;

Way const& way_of(Preset const& preset, Purpose purpose) {
    if (purpose == Purpose::with_alpha) return preset.two_sided_alpha;
    if (purpose == Purpose::watched) return preset.watched;
    if (preset.two_sided) return preset.two_sided;
    return preset.picture ? preset.picture : preset.usual;
}

namespace {
Way with_channels_for(Way way, std::optional<Extent> output) {
    if (output) way.channels = channels_of_resolved(way);
    return way;
}

/// A denoiser of which a choice may be made in each frame.
class ChosenDenoiser final : public WrappedDenoiser {
    HistoryChoice* const& choice;

public:
    ChosenDenoiser(std::unique_ptr<CompiledDenoiser> d, HistoryChoice* const& c) : WrappedDenoiser(std::move(d)), choice(c) {}
    void run(std::span<FrameImages const> window, quell_library::Image const& output) override {
        choice != nullptr ? choice->run(*denoiser, window, output) : denoiser->run(window, output);
    }
    void forget() override { denoiser->forget(); }
    void release_scratch() override { denoiser->release_scratch(); }
    [[nodiscard]] std::size_t bytes() const override { return denoiser->bytes(); }
};

constexpr std::string_view done_here[] = {"evidence", "light", "colours"};
} // namespace

bool is_own_stage(std::string_view name) {
    static auto const links = link_stages();
    return std::ranges::find(done_here, name) == std::end(done_here) &&
           std::ranges::find(links, name, &quell_library::Stage::name) != links.end();
}
bool is_stage(std::string_view name) { return std::ranges::find(done_here, name) != std::end(done_here) || is_own_stage(name); }
std::string stage_names() {
    std::string text;
    for (auto const name : done_here) (text += text.empty() ? "" : ", ") += name;
    for (auto const& stage : stages())
        if (is_own_stage(stage.name)) text += ", " + stage.name;
    return text;
}

Denoiser::Denoiser(Way const& w, Extent s, int count, std::optional<Extent> o)
    : way(with_channels_for(w, o)), size(s), output(o), threads(count) {
    code = std::make_unique<ChosenDenoiser>(w.make(s, parallel(), {}), chosen_by);
    if (output) code = make_resolved(std::move(code), w, s, *output, parallel(), {});
}

void Denoiser::put_behind(std::vector<std::string> const& names) {
    for (auto const& stage : stages()) {
        if (!is_own_stage(stage.name) || std::ranges::find(names, stage.name) == names.end()) continue;
        if (auto const why = stage.refusal(way); !why.empty())
            throw Error("--stages", "the preset " + why, "leave " + stage.name + " out, or choose another preset");
        auto const parallel_now = parallel();
        Memory const memory;
        code = stage.put(
            std::move(code),
            {.way = way, .judge = way, .channels = way.channels, .size = size, .output = size, .parallel = parallel_now, .memory = memory});
    }
}

std::vector<std::string> Denoiser::planes(io::ChannelNames const& names, bool optional) const {
    std::vector<std::string> all;
    for (auto const& channel : way.channels)
        if (channel.optional == optional) {
            auto const planes = planes_of(channel, names);
            all.insert(all.end(), planes.begin(), planes.end());
        }
    return all;
}

void Denoiser::look_ahead(io::ExrImage const& image, io::ChannelNames const& names, long long number) {
    if (!window.empty() && *window.back().images.number >= number) return;
    LoadedFrame frame;
    if (!spare.empty()) frame = std::move(spare.back()), spare.pop_back();
    frame.load(way.channels, image, names, number);
    for (std::size_t c = 0; c < way.channels.size(); ++c) {
        auto const& name = way.channels[c].name;
        if (frame.images.channels[c].data == nullptr) continue;
        name.starts_with(radiance.name) || name == way.signal ? LayoutChanges::add() : LayoutChanges::add_guide(name);
    }
    window.push_back(std::move(frame));
}

metrics::Picture Denoiser::denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number, HistoryChoice* choice) {
    if (way.needs_camera && !io::camera_of(image))
        throw Error(image.name, "it has no camera, which this preset needs",
                    "write the 4x4 attributes quell:view and quell:projection, or choose another preset");
    while (!window.empty() && *window.front().images.number != number) drop_first();
    if (window.empty()) look_ahead(image, names, number);
    images.clear();
    for (auto const& frame : window) images.push_back(frame.images);
    drop_first(); // its memory stays; an error must not leave it to be denoised again
    found = findings_in(images.front(), image, names.motion);
    size = images.front().size;
    return run_images(choice);
}

namespace {

/// A picture, and its alpha where it has four components, of what `write` writes.
std::pair<metrics::Picture, std::vector<float>> written(Extent size, int components, auto const& write) {
    metrics::Picture picture{size, std::vector<glm::vec3>(static_cast<std::size_t>(size.pixels()))};
    std::vector<glm::vec4> with_alpha(components == 4 ? picture.pixels.size() : 0);
    auto* const to =
        with_alpha.empty() ? reinterpret_cast<std::byte*>(picture.pixels.data()) : reinterpret_cast<std::byte*>(with_alpha.data());
    std::ptrdiff_t const pixel = components * static_cast<std::ptrdiff_t>(sizeof(float));
    write(quell_library::Image{.data = to, .component_stride = sizeof(float), .pixel_stride = pixel, .row_stride = pixel * size.width});
    if (!with_alpha.empty()) LayoutChanges::add();
    std::vector<float> alpha;
    for (std::size_t i = 0; i < with_alpha.size(); ++i) picture.pixels[i] = with_alpha[i], alpha.push_back(with_alpha[i].a);
    return {std::move(picture), std::move(alpha)};
}

} // namespace

/// Denoises the first of `images`.
metrics::Picture Denoiser::run_images(HistoryChoice* choice) {
    auto [picture, alpha] = written(output.value_or(size), way.output_components, [&](quell_library::Image const& into) {
        auto const begin = std::chrono::steady_clock::now();
        chosen_by = choice;
        code->run(images, into);
        taken += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    });
    denoised_alpha = std::move(alpha);
    return std::move(picture);
}

std::optional<metrics::Picture> Denoiser::estimate(std::function<bool(quell_library::Image const&)> const& copy) const {
    bool is_there = false;
    auto made = written(size, way.output_components, [&](auto const& into) { is_there = copy(into); }).first;
    return is_there ? std::optional(std::move(made)) : std::nullopt;
}
std::optional<metrics::Picture> Denoiser::alone(HistoryChoice& choice) const {
    return estimate([&](auto const& into) { return choice.copy_alone(into); });
}
std::optional<metrics::Picture> Denoiser::with_history(HistoryChoice& choice) const {
    return estimate([&](auto const& into) { return choice.copy_with_history(into); });
}

std::unique_ptr<HistoryChoice> Denoiser::make_choice(Way const& judge) { return make_history_choice(way, judge, size, parallel(), {}); }

std::vector<std::string> Denoiser::guides() const {
    std::vector<std::string> names;
    for (auto const& guide : way.guides) names.push_back(guide.name);
    return names;
}

metrics::Picture Denoiser::guide(std::string const& name) {
    metrics::Picture picture{size, std::vector<glm::vec3>(static_cast<std::size_t>(size.pixels()))};
    std::ptrdiff_t constexpr pixel = sizeof(glm::vec3);
    code->copy_guide(name, {.data = reinterpret_cast<std::byte*>(picture.pixels.data()),
                            .component_stride = sizeof(float),
                            .pixel_stride = pixel,
                            .row_stride = pixel * size.width});
    return picture;
}

void Denoiser::release_scratch() {
    window.clear(), spare.clear(), images.clear();
    code->release_scratch();
    denoised_alpha = {};
}

std::vector<Finding> Denoiser::findings_in(FrameImages const& frame, io::ExrImage const& image, MotionConvention const& converted_from) {
    if (!looks) return checked(frame, converted_from);
    return detail::diagnosed([&] { return code->observe(frame); }, converted_from, factor_in(image));
}

/// What is found in one of the first frames.
std::vector<Finding> Denoiser::checked(FrameImages const& frame, MotionConvention const& converted_from) {
    if (to_check == 0) return {};
    --to_check;
    detail::Observation seen{.size = frame.size, .number = frame.number, .convention = converted_from, .camera = frame.camera};
    auto const look_up = [&](auto channel) -> detail::Lookup {
        auto const place = way.place_of(channel.name);
        if (!place) return {};
        return [image = frame.channels[*place]](int c, int x, int y) {
            return *reinterpret_cast<float const*>(image.data + c * image.component_stride + x * image.pixel_stride + y * image.row_stride);
        };
    };
    seen.depth = look_up(depth), seen.normal = look_up(normal), seen.albedo = look_up(albedo), seen.motion = look_up(motion);
    return check.look_at(seen);
}

std::function<float(int c, int x, int y)> Denoiser::factor_in(io::ExrImage const& image) const {
    if (factor.empty()) return {};
    auto const values = std::make_shared<std::array<std::vector<float>, 3>>();
    for (std::size_t c = 0; c < 3; ++c) (*values)[c] = io::component_of(image, factor[c]);
    return [values, width = static_cast<std::size_t>(image.size.width)](int c, int x, int y) {
        return (*values)[static_cast<std::size_t>(c)][static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    };
}

} // namespace quell::examples
