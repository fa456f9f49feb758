#include "sequence.hpp"

#include <denoise/composite.hpp>
#include <denoise/map_file.hpp>
#include <quell/core/error.hpp>
#include <quell/io/exr.hpp>
#include <support/frame_pattern.hpp>

#include <algorithm>

namespace quell::bench {
namespace {

/// Files of quell-trace may have every signal. Those of other renderers give the picture, and guides by the names of their first signal.
class FileSequence final : public FitSequence {
    examples::FramePattern files;
    std::optional<io::SequenceNames> map;
    io::ChannelNames names;
    std::vector<std::string> planes;

public:
    explicit FileSequence(FitOptions const& options) : files(options.in) {
        name = std::filesystem::path(options.in).filename().string();
        numbers = files.on_disk();
        check_numbers();
        if (!options.map.empty()) map = examples::read_map(options.map, {files.path(numbers.front())});
        look_at(io::ExrFile(files.path(numbers.front())));
        read_references(examples::FramePattern(options.reference));
    }

    void load(long long number, FitFrame& frame) override {
        io::ExrFile const file(files.path(number));
        auto const image = file.read(planes);
        if (!(image.size == size))
            throw Error(file.name, "it is " + to_string(image.size) + " but the first frame is " + to_string(size),
                        "give frames of one size");
        for_each_channel(FitFrame::channels{}, [&]<class C>(C channel) {
            if constexpr (!std::is_same_v<C, Radiance>)
                if (channels.contains(C::name)) io::detail::load_channel(channel, frame[channel].view(), image, names);
        });
        put_picture(examples::read_reference(files.path(number), map), frame); // put together of its signals as a reference is
        if (auto const camera = io::camera_of(image)) frame.camera = *camera;
        if (auto const shutter = io::shutter_of(image, names)) frame.shutter = *shutter;
        frame.number = number - numbers.front();
    }

private:
    /// Histories must fill, and what a frame costs is known from the ninth on.
    static constexpr std::size_t min_frames = 12;

    void check_numbers() const {
        if (numbers.size() < min_frames)
            throw Error("--in", std::to_string(numbers.size()) + " frames in " + files.text(),
                        "give at least " + std::to_string(min_frames));
        if (static_cast<std::size_t>(numbers.back() - numbers.front()) + 1 == numbers.size()) return;
        throw Error("--in", "frames are missing between " + std::to_string(numbers.front()) + " and " + std::to_string(numbers.back()),
                    "give all of them");
    }

    /// Finds out which channels the files have.
    void look_at(io::ExrFile const& file) {
        size = file.size;
        names = (map ? *map : examples::recognised(file)).of_signals.front().channels;
        has_camera = io::camera_of(file.read({})).has_value();
        for_each_channel(FitFrame::channels{}, [&]<class C>(C channel) {
            auto const wanted = io::planes_of(Channels<C>{}, names);
            bool const there = file.has_all(wanted);
            if (!there && !std::is_same_v<C, Radiance>) return;
            channels.insert(channel.name);
            if (!std::is_same_v<C, Radiance>) planes.insert(planes.end(), wanted.begin(), wanted.end());
        });
    }

    void read_references(examples::FramePattern const& references) {
        for (auto const number : references.on_disk()) {
            if (number < numbers.front() + static_cast<long long>(min_frames) - 1 || number > numbers.back()) continue;
            auto const path = references.path(number);
            auto picture = metrics::displayed(examples::read_reference(path, map));
            if (!(picture.size == size))
                throw Error(path.string(), "it is " + to_string(picture.size) + " but the frames are " + to_string(size),
                            "give references of the frames' size");
            converged.push_back({number, std::move(picture)});
        }
        if (converged.empty())
            throw Error("--reference", "no file " + references.text() + " for a frame behind the first " + std::to_string(min_frames - 1),
                        "give at least one: nothing is known of errors without");
    }
};

} // namespace

std::unique_ptr<FitSequence> file_sequence(FitOptions const& options) { return std::make_unique<FileSequence>(options); }

} // namespace quell::bench
