#include <denoise/debug_view.hpp>
#include <denoise/map_file.hpp>
#include <denoise/output.hpp>
#include <denoise/signal_choice.hpp>
#include <support/output_folder.hpp>

namespace quell::examples {

Output::Output(DenoiseOptions const& options, FramePattern const& input, std::vector<long long> const& numbers)
    : in(input), layers(options.layers), one_signal(!options.signal.empty()) {
    if (options.out.empty()) return;
    pattern.emplace(options.out);
    std::vector<long long> there;
    for (auto const number : numbers)
        if (std::filesystem::exists(in.path(number))) there.push_back(number);
    check_keeps(in, "the input's own files", *pattern, there);
    if (!options.reference.empty()) check_keeps(FramePattern(options.reference), "the references", *pattern, there);
    if (numbers.empty()) return;
    auto const folder = pattern->path(numbers.front()).parent_path();
    make_output_folder(folder.empty() ? "." : folder);
}

bool Output::has(long long number) const {
    if (!pattern || !std::filesystem::exists(pattern->path(number))) return false;
    try {
        return io::ExrOriginal(pattern->path(number)).is_whole();
    } catch (Error const&) {
        return false;
    }
}

void Output::check(long long first, std::optional<io::SequenceNames> const& names) const {
    if (!pattern) return;
    io::ExrFile const file(in.path(first));
    layers.check(file);
    if (layers.is_signals_only() && names && signal_channels(file, *names).empty())
        throw Error("--layers", "'signals' alone: there is but one signal in " + file.name + ", and it is the picture",
                    "write picture in its place");
}

std::optional<std::string> Output::layer_for(io::ExrFile const& file, io::SequenceNames const& names) const {
    return one_signal ? layer_of_signal(file, names) : std::nullopt;
}

void Output::check_levels(long long number, io::SequenceNames const& names) const {
    if (!pattern || !std::filesystem::exists(in.path(number))) return;
    io::ExrOriginal const original(in.path(number));
    examples::check_levels(original, names, layer_for(original.listed, names), layers);
}

void Output::write(long long number, DenoisedFrame& frame, io::SequenceNames const& names) {
    if (!pattern) return;
    io::ExrOriginal const original(in.path(number));
    layers.check(original.listed);
    auto const changes = changes_for(frame, original.listed, names, layer_for(original.listed, names), layers);
    for (auto const& part : io::write_copy(pattern->path(number), original, changes)) lossless.insert(part);
}

void Output::write_views(long long number, std::string const& view, std::vector<std::pair<std::string, DebugImage>> const& images) const {
    for (auto const& each : images) write_debug_view(pattern->path(number), view, each.first, each.second);
}

std::vector<std::string> Output::remarks() const {
    std::vector<std::string> lines;
    for (auto const& part : lossless)
        lines.push_back("part '" + part + "' is packed without loss (ZIP): its lossy compression would change ids, depth or other data");
    return lines;
}

} // namespace quell::examples
