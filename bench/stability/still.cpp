#include "still.hpp"

#include <algorithm>

namespace quell::stability {

std::vector<SignalPlane> const& signal_planes() {
    static std::vector<SignalPlane> const all{{"R", 1},
                                              {"G", 1},
                                              {"B", 1},
                                              {"visibility.V", 0.5f},
                                              {"glossy.R", 0.25f},
                                              {"glossy.G", 0.25f},
                                              {"glossy.B", 0.25f},
                                              {"indirect.R", 0.25f},
                                              {"indirect.G", 0.25f},
                                              {"indirect.B", 0.25f}};
    return all;
}

io::ExrImage even_frame(float light, Making const& making) {
    auto image = traced({.scene = "lightswitch", .scored_from = 1}, making).frames.front();
    auto const set = [&](std::string const& name, float value) { std::ranges::fill(plane(image, name), value); };
    for (auto const& [name, part] : signal_planes()) set(name, name == "visibility.V" ? 1 : light * part);
    for (auto const* const component : {"R", "G", "B"}) {
        set(std::string("direct.") + component, light * 0.5f);
        set(std::string("albedo.") + component, 1);
    }
    for (auto const* const component : {"X", "Y", "Z"})
        for (auto const* const layer : {"blocker.", "blocker_previous."})
            set(std::string(layer) + component, std::numeric_limits<float>::quiet_NaN());
    return image;
}

metrics::Picture even_picture(float light, Extent size) {
    return {size, std::vector(static_cast<std::size_t>(size.pixels()), glm::vec3(light))};
}

} // namespace quell::stability
