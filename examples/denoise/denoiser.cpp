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

void Denoiser::look_ahead(io::ExrImage const& image, io::ChannelNames const& names, long long number, GuideImages& guides) {
    if (!window.empty() && *window.back().images.number >= number) return;
    Shown frame{{.size = image.size, .number = number}};
    for (auto const& channel : way.channels) {
        bool const is_there = image.has_all(planes_of(channel, names)), is_light = channel.name.starts_with(radiance.name);
        LoadedChannelPointer loaded;
        if (is_there && !is_light) loaded = guides.get(channel.name, image, names);
        if (!loaded && (is_there || !channel.optional)) LayoutChanges::add(), loaded = load_channel(channel.name, image, names);
        frame.images.channels.push_back(loaded ? loaded->image : quell_library::Image());
        frame.channels.push_back(std::move(loaded));
    }
    if (auto const camera = io::camera_of(image)) frame.images.camera = *camera;
    if (auto const shutter = io::shutter_of(image, names)) frame.images.shutter = *shutter;
    window.push_back(std::move(frame));
}

quell_library::Image Denoiser::seen(std::string_view channel) const {
    auto const place = way.place_of(channel);
    return place ? last.images.channels[*place] : quell_library::Image();
}

LinearPicture Denoiser::denoise(io::ExrImage const& image, io::ChannelNames const& names, long long number, HistoryChoice* choice) {
    if (way.needs_camera && !io::camera_of(image))
        throw Error(image.name, "it has no camera, which this preset needs",
                    "write the 4x4 attributes quell:view and quell:projection, or choose another preset");
    while (!window.empty() && *window.front().images.number != number) window.pop_front();
    GuideImages guides;
    if (window.empty()) look_ahead(image, names, number, guides);
    images.clear();
    for (auto const& frame : window) images.push_back(frame.images);
    last = std::move(window.front()), window.pop_front(); // an error must not leave it to be denoised again
    found = findings_in(images.front(), image, names.motion);
    size = images.front().size;
    return run_images(choice);
}

namespace {

/// A picture of what `write` writes, and a plane of alpha behind it where there are four components.
LinearPicture written(Extent size, int components, auto const& write) {
    LinearPicture picture(size);
    std::ptrdiff_t constexpr pixel = sizeof(float);
    auto const row = pixel * size.width, plane = row * size.height;
    picture.values.resize(static_cast<std::size_t>(components) * picture.pixels());
    write(quell_library::Image{
        .data = reinterpret_cast<std::byte*>(picture.values.data()), .component_stride = plane, .pixel_stride = pixel, .row_stride = row});
    return picture;
}

} // namespace

/// Denoises the first of `images`.
LinearPicture Denoiser::run_images(HistoryChoice* choice) {
    auto picture = written(output.value_or(size), way.output_components, [&](quell_library::Image const& into) {
        auto const begin = std::chrono::steady_clock::now();
        chosen_by = choice;
        code->run(images, into);
        taken += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    });
    denoised_alpha.assign(picture.values.begin() + static_cast<std::ptrdiff_t>(3 * picture.pixels()), picture.values.end());
    picture.values.resize(3 * picture.pixels());
    return picture;
}

std::optional<LinearPicture> Denoiser::estimate(std::function<bool(quell_library::Image const&)> const& copy) const {
    bool is_there = false;
    auto made = written(size, way.output_components, [&](auto const& into) { is_there = copy(into); });
    made.values.resize(3 * made.pixels());
    return is_there ? std::optional(std::move(made)) : std::nullopt;
}
std::optional<LinearPicture> Denoiser::alone(HistoryChoice& choice) const {
    return estimate([&](auto const& into) { return choice.copy_alone(into); });
}
std::optional<LinearPicture> Denoiser::with_history(HistoryChoice& choice) const {
    return estimate([&](auto const& into) { return choice.copy_with_history(into); });
}

std::unique_ptr<HistoryChoice> Denoiser::make_choice(Way const& judge) { return make_history_choice(way, judge, size, parallel(), {}); }

std::vector<std::string> Denoiser::guides() const {
    std::vector<std::string> names;
    for (auto const& guide : way.guides) names.push_back(guide.name);
    return names;
}

LinearPicture Denoiser::guide(std::string const& name) {
    return written(size, 3, [&](auto const& into) { code->copy_guide(name, into); });
}

void Denoiser::release_scratch() {
    window.clear(), last = {}, images.clear();
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
