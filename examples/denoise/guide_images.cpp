#include <denoise/guide_images.hpp>
#include <denoise/layout_changes.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace quell::examples {

namespace {
/// What a channel is read from.
std::string key_of(std::string_view channel, io::ChannelNames const& names) {
    auto key = fmt::format("{}\n{} {} {} {} {} {} {} {}", channel, static_cast<int>(names.motion.points),
                           static_cast<int>(names.motion.unit), static_cast<int>(names.motion.y), static_cast<int>(names.motion.jitter),
                           static_cast<int>(names.depth.along), names.depth.vertical_field_of_view, names.miss_from, names.miss_to);
    if (auto const found = names.sources.find(channel); found != names.sources.end())
        for (auto const& source : found->second) key += fmt::format("\n{} {} {}", source.scale, source.offset, fmt::join(source.sum, "\n"));
    return key;
}
} // namespace

LoadedChannelPointer load_channel(std::string_view channel, io::ExrImage const& image, io::ChannelNames const& names) {
    auto made = std::make_shared<LoadedChannel>();
    made->size = image.size, made->image = quell_library::find_file_channel(channel)->load(made->memory, image, names);
    return made;
}

LoadedChannelPointer GuideImages::get(std::string_view channel, io::ExrImage const& image, io::ChannelNames const& names) {
    if (!image.has_all(quell_library::find_file_channel(channel)->planes(names))) return nullptr;
    auto& found = loaded[key_of(channel, names)];
    if (found) return found;
    LayoutChanges::add_guide(channel);
    return found = load_channel(channel, image, names);
}

void GuideImages::forget(std::string_view channel) {
    std::erase_if(loaded, [&](auto const& each) { return each.first.starts_with(std::string(channel) + '\n'); });
}

} // namespace quell::examples
