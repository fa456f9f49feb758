#include <denoise/anti_alias.hpp>
#include <denoise/guide_images.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/light_split.hpp>

#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/resolve/agreement.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <limits>
#include <map>
#include <string_view>

namespace quell::examples {

namespace {
using Colours = ImageOf<Planar<>, Albedo>;

Colours image_of(metrics::Picture const& picture) {
    Colours image(picture.size);
    auto const view = image.view();
    LayoutChanges::add();
    auto pixel = picture.pixels.begin();
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x, ++pixel)
            for (int c = 0; c < 3; ++c) view.set(c, x, y, (*pixel)[c]);
    return image;
}
/// Whether pixels at edges show the mean of several samples' normals, which is shorter than 1.
bool has_mixed_normals(io::ExrImage const& image, io::ChannelNames const& names) {
    Frame<Channels<Normal>> frame(image.size);
    load_guides(Channels<Normal>{}, frame, image, names);
    auto const normals = frame[normal].view();
    auto const at = [&](int x, int y) { return glm::vec3(normals.get(0, x, y), normals.get(1, x, y), normals.get(2, x, y)); };
    int edges = 0, mixed = 0;
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 1; x + 1 < image.size.width; ++x) {
            auto const left = at(x - 1, y), right = at(x + 1, y), here = at(x, y);
            if (!(glm::dot(left, right) < .9f * std::sqrt(glm::dot(left, left) * glm::dot(right, right)))) continue;
            ++edges;
            float const square = glm::dot(here, here);
            mixed += square > 1e-4f && square < .96f ? 1 : 0;
        }
    return mixed * 10 > edges;
}
/// Whether no pixel moves: no frame then has samples of other places. Cycles writes such vectors where it renders motion blur.
bool is_still(ImageView auto const& motions) {
    for (int y = 0; y < motions.size.height; ++y)
        for (int x = 0; x < motions.size.width; ++x)
            if (motions.get(0, x, y) != 0.f || motions.get(1, x, y) != 0.f) return false;
    return true;
}
std::vector<glm::vec3> pixel_by_pixel(metrics::Picture const& colour, metrics::Picture const* light) {
    auto product = colour.pixels;
    for (std::size_t i = 0; i < product.size() && light != nullptr; ++i) product[i] *= light->pixels[i];
    return product;
}
/// Frames around are refused where they differ more from this one than neighbouring pixels do.
/// @param agrees how far frames around count
/// @param noise  which part of what neighbours differ by is noise
void tell(StageAccount& why, std::string const& signal, ImageView auto const& agrees, float noise, std::vector<glm::vec3> const& before,
          std::vector<glm::vec3> const& after) {
    std::vector<float> refused;
    double sum = 0;
    for (int y = 0; y < agrees.size.height; ++y)
        for (int x = 0; x < agrees.size.width; ++x) { // where there is no light, there is nothing to refuse
            bool const is_lit = after[refused.size()] != glm::vec3(0.f);
            float const differs = noise / std::max(agrees.get(0, x, y), 1e-6f);
            refused.push_back(is_lit ? std::clamp(differs - 1.f, 0.f, 1.f) : 0.f), sum += static_cast<double>(refused.back());
        }
    double const part = sum / static_cast<double>(refused.size());
    why.refused(refused);
    why.add({signal, Stage::colours, why.changed(Stage::colours, before, after), part, part > 0. ? colours_differ : "", part > 0.});
}
} // namespace

std::vector<std::string> planes_of_frame_around(io::ExrListing const& file, io::SequenceNames const& names) {
    std::vector<std::string> planes;
    auto const& channels = names.of_signals[0].channels;
    for (auto const& some : {io::planes_of(Channels<Depth, Motion>{}, channels), io::planes_of(Channels<MotionNext>{}, channels)})
        if (file.has_all(some)) planes.insert(planes.end(), some.begin(), some.end());
    return planes;
}

std::shared_ptr<FrameAround const> frame_around(io::ExrImage const& image, io::SequenceNames const& names, int samples) {
    auto const& channels = names.of_signals[0].channels;
    if (samples < 1 || !image.has_all(io::planes_of(Channels<Depth, Motion, Normal>{}, channels))) return nullptr;
    if (samples > 1 && !has_mixed_normals(image, channels)) return nullptr;
    auto made = std::make_shared<FrameAround>(FrameAround{samples, Frame<Channels<Depth, Motion, MotionNext>>(image.size), {}});
    load_guides(Channels<Depth, Motion>{}, made->guides, image, channels);
    if (is_still(made->guides[motion].view())) return nullptr;
    if (image.has_all(io::planes_of(Channels<MotionNext>{}, channels)))
        load_guides(Channels<MotionNext>{}, made->guides, image, channels);
    else { // frames after it are then not followed
        auto const view = made->guides[motion_next].view();
        for (int y = 0; y < image.size.height; ++y)
            for (int x = 0; x < image.size.width; ++x)
                for (int c = 0; c < 2; ++c) view.set(c, x, y, std::numeric_limits<float>::quiet_NaN());
    }
    for (auto const& signal : names.of_signals)
        made->colours.push_back(signal.factor.empty() ? metrics::Picture{} : picture_of(image, signal.factor, 1.f));
    made->colours.push_back(names.added.empty() ? metrics::Picture{} : picture_of(image, names.added, 0.f));
    return made;
}

std::optional<metrics::Picture> AntiAliasing::product(std::size_t colour, metrics::Picture const* light, std::string const& signal,
                                                      StageAccount& why) const {
    if (!here || here->colours[colour].pixels.empty()) return std::nullopt;
    auto const size = here->guides.size;
    auto const colour_image = image_of(here->colours[colour]);
    auto const light_image = [&] {
        LayoutChanges::Of const of(signal);
        return image_of(light != nullptr
                            ? *light
                            : metrics::Picture{size, std::vector<glm::vec3>(here->colours[colour].pixels.size(), glm::vec3(1.f))});
    }();
    Colours to(size);
    std::deque<Colours> kept;
    auto policy = AntiAliased::of_samples(here->samples);
    if (light != nullptr) policy.change = 0.f;
    auto const views_of = [](FrameAround const& frame, Colours const& colours) {
        return ColouredFrame<>{colours.view(), frame.guides[depth].view(), frame.guides[motion].view(), frame.guides[motion_next].view()};
    };
    auto const all_of = [&](auto const& frames) {
        std::vector<ColouredFrame<>> views;
        for (auto const& frame : frames) {
            if (!frame || frame->colours[colour].pixels.empty()) break;
            kept.push_back(image_of(frame->colours[colour]));
            views.push_back(views_of(*frame, kept.back()));
        }
        return views;
    };
    auto const those_before = all_of(before), those_after = all_of(after);
    Agreement const agreement{.samples = static_cast<float>(here->samples), .is_blurred = is_blurred};
    auto const agrees = anti_alias_where_agreed(agreement, policy, Threads<>{.count = threads}, views_of(*here, colour_image),
                                                std::span<ColouredFrame<> const>(those_before),
                                                std::span<ColouredFrame<> const>(those_after), light_image.view(), to.view());
    LayoutChanges::Of const of(signal);
    LayoutChanges::add();
    metrics::Picture result{size, {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            result.pixels.emplace_back(to.view().get(0, x, y), to.view().get(1, x, y), to.view().get(2, x, y));
    tell(why, signal, agrees.view(), agreement.noise_share(),
         why.is_gathered() ? pixel_by_pixel(here->colours[colour], light) : std::vector<glm::vec3>(), result.pixels);
    return result;
}

} // namespace quell::examples
