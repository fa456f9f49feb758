#pragma once

#include "wall.hpp"

#include <quell/pipeline/chain.hpp>

#include <string_view>

namespace wall_test {

/// What libquell makes of some frames of a wall. Wall::look(number) says what there is in each.
template <class Seen> std::vector<std::vector<float>> pictures_of(quell_settings const& settings, unsigned frames) {
    auto const denoiser = made(settings);
    Seen wall;
    std::vector<std::vector<float>> all;
    for (unsigned i = 0; i < frames; ++i) {
        wall.look(i);
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        all.push_back(wall.out);
    }
    return all;
}
/// What a link of the headers makes of such pictures.
template <class Seen, class Link>
std::vector<std::vector<float>> behind(std::vector<std::vector<float>> const& pictures, Link const& link) {
    quell::Frame frame({width, height}, link);
    quell::History history({width, height}, link);
    std::vector<std::vector<float>> all;
    Seen wall;
    for (unsigned i = 0; i < pictures.size(); ++i) {
        wall.look(i);
        if (wall.frame.camera) frame.camera.jitter = {wall.frame.camera->jitter[0], wall.frame.camera->jitter[1]};
        quell::for_each_channel(typename Link::reads{}, [&](auto channel) {
            auto const n = static_cast<std::size_t>(channel.components);
            float const* from = pictures[i].data();
            for (auto const& given : wall.channels)
                if (std::string_view(given.name) == channel.name) from = static_cast<float const*>(given.image.data);
            auto const view = frame[channel].view();
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    for (std::size_t c = 0; c < n; ++c) view.set(static_cast<int>(c), x, y, *from++);
        });
        auto const picture = run(link, frame, history);
        auto& values = all.emplace_back();
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c) values.push_back(picture.get(c, x, y));
    }
    return all;
}

} // namespace wall_test
