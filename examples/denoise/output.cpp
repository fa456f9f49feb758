#include <denoise/debug_view.hpp>
#include <denoise/map_file.hpp>
#include <denoise/output.hpp>
#include <denoise/signal_choice.hpp>
#include <denoise/upsampled_file.hpp>
#include <support/output_folder.hpp>
#include <support/png.hpp>

#include <quell/io/replace_file.hpp>

namespace quell::examples {

namespace {

/// Values of a canvas on another one. Both have all that the file holds.
std::vector<float> on_canvas(std::vector<float> values, Region const& from, Region const& to) {
    if (from.x0 == to.x0 && from.y0 == to.y0 && from.x1 == to.x1 && from.y1 == to.y1) return values;
    std::vector<float> moved;
    for (int y = to.y0; y < to.y1; ++y)
        for (int x = to.x0; x < to.x1; ++x) {
            bool const is_inside = x >= from.x0 && x < from.x1 && y >= from.y0 && y < from.y1;
            moved.push_back(is_inside ? values[static_cast<std::size_t>((y - from.y0) * (from.x1 - from.x0) + x - from.x0)] : 0.f);
        }
    return moved;
}

} // namespace

Output::Output(DenoiseOptions const& options, FramePattern const& input, std::vector<long long> const& numbers)
    : in(input), layers(options.upsample ? std::vector<std::string>{"picture"} : options.layers), upsamples(options.upsample.has_value()),
      one_signal(!options.signal.empty()) {
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
    if (layers.is_signals_only() && names && signal_channels(*names).empty())
        throw Error("--layers", "'signals' alone: there is but one signal in " + file.name + ", and it is the picture",
                    "write picture in its place");
}

std::optional<std::string> Output::layer_for(io::SequenceNames const& names) const {
    return one_signal ? layer_of_signal(names) : std::nullopt;
}

void Output::check_levels(long long number, io::SequenceNames const& names) const {
    if (!pattern || upsamples || !std::filesystem::exists(in.path(number))) return;
    io::ExrOriginal const original(in.path(number));
    examples::check_levels(original, names, layer_for(names), layers);
}

void Output::add(long long number, DenoisedFrame& frame, io::SequenceNames const& names) {
    if (!pattern) return;
    io::ExrFile const file(in.path(number));
    layers.check(file);
    auto more = changes_for(frame, file, names, layer_for(names), layers);
    if (!changes) {
        changes = std::move(more);
        return;
    }
    for (auto& numbers : more.numbers) {
        numbers.values = on_canvas(std::move(numbers.values), more.canvas, changes->canvas);
        changes->numbers.push_back(std::move(numbers));
    }
    changes->guides.insert(changes->guides.end(), more.guides.begin(), more.guides.end());
    changes->keeps = [one = changes->keeps, other = more.keeps](auto const& part, auto const& channel) {
        return one(part, channel) || other(part, channel);
    };
}

void Output::write(long long number) {
    if (!pattern) return;
    io::ExrOriginal const original(in.path(number));
    auto const packed =
        upsamples ? write_upsampled(pattern->path(number), original, *changes) : io::write_copy(pattern->path(number), original, *changes);
    lossless.insert(packed.begin(), packed.end());
    changes.reset();
}

void Output::write_views(long long number, std::string const& view, std::string const& prefix,
                         std::vector<std::pair<std::string, DebugImage>> const& images) const {
    for (auto const& each : images) write_debug_view(pattern->path(number), view, prefix + each.first, each.second);
}

void Output::write_why(long long number, std::string const& prefix, metrics::Picture const& image) const {
    write_png(path_beside(pattern->path(number), prefix + "why.png"), image);
}
void Output::write_why(long long number, std::string const& table) const {
    io::replace_file(path_beside(pattern->path(number), "why.csv"), table);
}

std::vector<std::string> Output::remarks() const {
    std::vector<std::string> lines;
    for (auto const& part : lossless)
        lines.push_back("part '" + part +
                        "' is packed without loss (ZIP): its lossy compression would change ids, depth or other data, or make bright "
                        "colours infinite");
    return lines;
}

} // namespace quell::examples
