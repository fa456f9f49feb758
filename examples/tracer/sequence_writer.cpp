#include "sequence_writer.hpp"
#include "effects.hpp"
#include "reference.hpp"

#include <quell/io/write_exr.hpp>
#include <support/frame_pattern.hpp>
#include <support/png.hpp>

#include <set>

namespace quell::tracer {
namespace {

/// Adds a channel of the reference, unless another effect did already.
template <class C> void put(io::ExrImage& image, C channel, Reference const& converged) {
    auto const names = io::own_names(channel);
    if (image.find(names[0])) return;
    for (int c = 0; c < C::components; ++c) {
        io::Plane plane{.name = names[static_cast<std::size_t>(c)], .type = io::SampleType::half, .values = {}};
        for (auto const& pixel : converged[channel].pixels) plane.values.push_back(pixel[c]);
        image.planes.push_back(std::move(plane));
    }
}

} // namespace

RenderSettings SequenceWriter::settings(int frame) const {
    auto settings = options.rendered;
    settings.frame = frame;
    return settings;
}

void SequenceWriter::write(char const* name, int frame, io::ExrImage image) const {
    io::put_camera(image, camera_of(scene, settings(frame)));
    io::put_camera(image, camera_of(scene, settings(frame - 1)), "_previous");
    io::write_exr(folder / examples::frame_file_name(name, frame, "exr"), image);
}

void SequenceWriter::write_reference(int frame) {
    io::ExrImage image{.size = options.rendered.size};
    ReferenceSettings const until{.max_samples = options.reference, .samples_per_pass = std::min(options.reference / 2, 16)};
    for_each_effect([&]<class Chosen>(Chosen) {
        if (!options.has(Chosen::name)) return;
        auto const converged = reference<typename Chosen::reference>(scene, settings(frame), until);
        for_each_channel(typename Chosen::reference{}, [&](auto channel) { put(image, channel, converged); });
    });
    write("reference", frame, std::move(image));
}

void SequenceWriter::write_masks(int frame) {
    std::set<Effect> touching; // each once, whatever the number of effects that ask for it
    for_each_effect([&]<class Chosen>(Chosen) {
        if (options.has(Chosen::name)) touching.insert(Chosen::masks.begin(), Chosen::masks.end());
    });
    for (auto const effect : touching) {
        metrics::Picture picture{options.rendered.size, {}};
        for (auto const entry : effect_mask(scene, settings(frame), effect)) picture.pixels.emplace_back(entry != 0 ? 1.f : 0.f);
        auto const file = folder / examples::frame_file_name("mask_" + std::string(name_of(effect)), frame, "png");
        examples::write_png(file, picture);
    }
}

} // namespace quell::tracer
