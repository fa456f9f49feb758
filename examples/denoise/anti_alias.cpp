#include <denoise/anti_alias.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/light_split.hpp>

#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/resolve/agreement.hpp>
#include <quell/resolve/picture_brightness.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string_view>

namespace quell::examples {

namespace {
ColourImage image_of(io::ExrImage const& image, std::vector<io::Source> const& sources) {
    if (sources.empty()) return std::nullopt;
    LayoutChanges::add();
    return quell::detail::in_planes<LinearView>(picture_of(image, sources, 0.f));
}
/// Whether pixels at edges show the mean of several samples' normals, which is shorter than 1.
bool has_mixed_normals(ViewOf<Planar<>, Normal> normals) {
    auto const at = [&](int x, int y) { return glm::vec3(normals.get(0, x, y), normals.get(1, x, y), normals.get(2, x, y)); };
    int edges = 0, mixed = 0;
    for (int y = 0; y < normals.size.height; ++y)
        for (int x = 1; x + 1 < normals.size.width; ++x) {
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
LinearPicture pixel_by_pixel(ImageView auto const& colour, LinearView const& light) {
    LinearPicture product(colour.size);
    for (int y = 0; y < colour.size.height; ++y)
        for (int x = 0; x < colour.size.width; ++x)
            for (int c = 0; c < 3; ++c) product.target().set(c, x, y, colour.get(c, x, y) * light.get(c, x, y));
    return product;
}
/// Frames around are refused where they differ more from this one than neighbouring pixels do.
/// @param agrees how far frames around count
/// @param noise  which part of what neighbours differ by is noise
void tell(StageAccount& why, std::string const& signal, ImageView auto const& agrees, float noise, LinearView const& before,
          LinearView const& after) {
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

std::shared_ptr<FrameAround const> frame_around(io::ExrImage const& image, io::SequenceNames const& names, int samples,
                                                GuideImages& guides) {
    auto const get = [&](auto channel) { return guides.get(channel.name, image, names.of_signals[0].channels); };
    if (samples < 1) return nullptr;
    auto const normals = get(normal);
    auto made = std::make_shared<FrameAround>(FrameAround{samples, get(depth), get(motion), get(motion_next), {}});
    if (!normals || !made->depth || !made->motion || is_still(made->motion->view(motion))) return nullptr;
    if (samples > 1 && !has_mixed_normals(normals->view(normal))) return nullptr;
    for (auto const& signal : names.of_signals) made->colours.push_back(image_of(image, signal.factor));
    made->colours.push_back(image_of(image, names.added));
    return made;
}

std::optional<LinearPicture> AntiAliasing::product(std::size_t colour, LinearView const* given, std::string const& signal,
                                                   StageAccount& why) const {
    if (!here || !here->colours[colour]) return std::nullopt;
    auto const size = here->depth->size;
    auto const white = given == nullptr ? LinearPicture(size, 1.f) : LinearPicture();
    LinearView const light = given == nullptr ? white.view() : *given;
    LinearPicture result(size);
    auto policy = AntiAliased::of_samples(here->samples);
    if (given != nullptr) policy.change = 0.f;
    auto const views_of = [colour](FrameAround const& frame) {
        ColouredFrame<> seen{frame.colours[colour]->view(), frame.depth->view(depth), frame.motion->view(motion)};
        seen.knows_next = frame.motion_next != nullptr; // else frames after it are not followed
        if (seen.knows_next) seen.to_next = frame.motion_next->view(motion);
        return seen;
    };
    auto const all_of = [&](auto const& frames) {
        std::vector<ColouredFrame<>> views;
        for (auto const& frame : frames) {
            if (!frame || !frame->colours[colour]) break;
            views.push_back(views_of(*frame));
        }
        return views;
    };
    auto const those_before = all_of(before), those_after = all_of(after);
    Agreement const agreement{.samples = static_cast<float>(here->samples), .is_blurred = is_blurred};
    auto const agrees = anti_alias_where_agreed(agreement, policy, Threads<>{.count = threads}, views_of(*here),
                                                std::span<ColouredFrame<> const>(those_before),
                                                std::span<ColouredFrame<> const>(those_after), light, result.target());
    tell(why, signal, agrees.view(), agreement.noise_share(),
         why.is_gathered() ? pixel_by_pixel(here->colours[colour]->view(), light) : LinearPicture(), result);
    return result;
}

} // namespace quell::examples
