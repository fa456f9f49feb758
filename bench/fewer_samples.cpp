// What fewer samples than pixels cost: `general` on a traced sequence, of which patterns of samples are kept. Prints a table in Markdown.
//     quell-fewer-samples 'dir/frame.%04d.exr' 'dir/reference.%04d.exr' FIRST LAST
// with frames of quell-trace; those that have a reference are scored.
#include <quell/io/exr.hpp>
#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/quell.hpp>
#include <support/frame_pattern.hpp>
#include <support/program.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>

namespace {

using namespace quell;

constexpr auto denoise = presets::general(radiance, Demodulate{});
using Reads = decltype(denoise)::reads;

struct Sequence {
    std::vector<Frame<Reads>> frames;
    std::vector<std::optional<metrics::Picture>> references; ///< displayed
    long long first = 0;
};

/// All are of the first frame's size.
void check_size(std::filesystem::path const& path, Extent size, Sequence const& sequence) {
    if (!sequence.frames.empty() && !(size == sequence.frames.front().size))
        throw Error(path.string(), to_string(size) + " after a frame of " + to_string(sequence.frames.front().size),
                    "give frames and references of one size");
}

Sequence read(examples::FramePattern const& frames, examples::FramePattern const& references, long long first, long long last) {
    Sequence sequence{{}, {}, first};
    for (auto number = first; number <= last; ++number) {
        auto const image = io::read_exr(frames.path(number));
        check_size(frames.path(number), image.size, sequence);
        io::load(sequence.frames.emplace_back(image.size), image);
        sequence.references.emplace_back();
        if (!std::filesystem::exists(references.path(number))) continue;
        auto const converged = io::read_exr(references.path(number));
        check_size(references.path(number), converged.size, sequence);
        Frame<Channels<Radiance>> picture(converged.size);
        io::load(picture, converged);
        sequence.references.back() = metrics::displayed(metrics::picture_of(picture[radiance].view()));
    }
    if (std::ranges::none_of(sequence.references, [](auto const& each) { return each.has_value(); }))
        throw Error("references '" + references.text() + "'", "none of the frames " + std::to_string(first) + " to " + std::to_string(last),
                    "make one at least, with quell-trace --reference: errors are against them");
    return sequence;
}

struct Score {
    double rmse = 0, flip = 0;
    int frames = 0;
};

/// Runs the sequence. `fill(frame, given, number)` fills the signal.
template <class Storage> Score score(Sequence const& sequence, Storage storage, auto const& fill) {
    auto const size = sequence.frames.front().size;
    Frame frame{size, denoise, storage};
    History history{size, denoise};
    Score sum;
    for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
        auto const& given = sequence.frames[i];
        for_each_channel(without<Reads, Channels<Radiance>>{}, [&](auto channel) { frame[channel] = given[channel]; });
        fill(frame[radiance], given[radiance], sequence.first + static_cast<long long>(i));
        auto const shown = metrics::displayed(metrics::picture_of(run(denoise, frame, history)));
        if (!sequence.references[i]) continue;
        sum.rmse += metrics::rmse(*sequence.references[i], shown);
        sum.flip += metrics::flip(*sequence.references[i], shown).mean();
        ++sum.frames;
    }
    return sum;
}

void print(char const* name, int percent, Score const& score) {
    std::printf("| %s | %d %% | %.4f | %.4f |\n", name, percent, score.rmse / score.frames, score.flip / score.frames);
}

template <SamplePattern pattern> void print_pattern(char const* name, Sequence const& sequence) {
    auto const all = [&](bool moves) {
        return score(sequence, Subsampled<pattern, Channels<Radiance>>{}, [&](auto& image, auto const& given, long long number) {
            image.phase = moves ? pattern.phase(number) : glm::ivec2(0);
            for (int y = 0; y < given.size().height; ++y)
                for (int x = 0; x < given.size().width; ++x) image.set(x, y, given.get(x, y));
        });
    };
    auto const name_of = [&](char const* what) { return std::string(name) + what; };
    print(name_of("").c_str(), 100 / pattern.phases(), all(true));
    print(name_of(", its phase stays").c_str(), 100 / pattern.phases(), all(false));
    // What a host does that knows no better.
    print(name_of(", each sample repeated in its block").c_str(), 100 / pattern.phases(),
          score(sequence, Planar<>{}, [&](auto& image, auto const& given, long long) {
              auto const last = given.size();
              for (int y = 0; y < last.height; ++y)
                  for (int x = 0; x < last.width; ++x) {
                      auto const at = pattern.pixel(x / pattern.columns, y / pattern.rows, {0, 0});
                      image.set(x, y, given.get(std::min(at.x, last.width - 1), std::min(at.y, last.height - 1)));
                  }
          }));
}

long long number_in(char const* text) {
    long long number = 0;
    auto const end = text + std::char_traits<char>::length(text);
    if (auto const [behind, wrong] = std::from_chars(text, end, number); behind != end || wrong != std::errc{})
        throw Error("frame '" + std::string(text) + "'", "no number", "give the first and the last");
    return number;
}

void measure(int argc, char** argv) {
    if (argc != 5) throw Error("arguments", std::to_string(argc - 1), "give the frames, the references, the first and the last number");
    auto const first = number_in(argv[3]), last = number_in(argv[4]);
    if (first < 0 || first > last || last - first >= 10000)
        throw Error("frames", std::to_string(first) + " to " + std::to_string(last),
                    "give the first number, 0 or more, and the last, 9999 later at most");
    auto const sequence = read(examples::FramePattern(argv[1]), examples::FramePattern(argv[2]), first, last);
    std::puts("| samples | of full size | RMSE | FLIP |\n| --- | --- | --- | --- |");
    print("each pixel", 100, score(sequence, Planar<>{}, [](auto& image, auto const& given, long long) { image = given; }));
    print_pattern<checkerboard>("`checkerboard`", sequence);
    print_pattern<half_size>("`half_size`", sequence);
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("quell-fewer-samples", [&] { measure(argc, argv); });
}
