// quell_shaders.h for Python: the module quell._shaders.
#include "errors.hpp"

#include <pybind11/stl.h>
#include <quell_shaders.h>

#include <cstring>
#include <memory>
#include <optional>
#include <vector>

namespace py = pybind11;

namespace {

py::list names(char const* (*name_of)(std::int32_t)) {
    py::list all;
    for (std::int32_t i = 0; char const* const name = name_of(i); ++i) all.append(name);
    return all;
}

/// The plan, and texts by the names of their files.
py::tuple create(std::string const& preset, std::string const& language, bool repair_guides, int fill_holes, bool counts, int most_slots,
                 bool half_precision, bool texel_loads, std::pair<int, int> workgroup, int samples_per_pixel) {
    auto options = QUELL_SHADERS_OPTIONS;
    options.repair_guides = repair_guides, options.fill_holes = fill_holes, options.counts = counts, options.most_slots = most_slots;
    options.half_precision = half_precision, options.texel_loads = texel_loads;
    options.workgroup_width = workgroup.first, options.workgroup_height = workgroup.second, options.samples_per_pixel = samples_per_pixel;
    quell_shaders* made = nullptr;
    quell_status status = QUELL_OK;
    std::string sentence;
    {
        py::gil_scoped_release const released;
        status = quell_shaders_create_with(preset.c_str(), language.c_str(), &options, &made);
        sentence = quell_shaders_error();
    }
    if (status == QUELL_NO_MEMORY) quell_python::raise_no_memory("memory: there is no more; let go of other arrays");
    if (status != QUELL_OK) quell_python::raise(sentence, status);
    std::unique_ptr<quell_shaders, void (*)(quell_shaders*)> const shaders(made, quell_shaders_destroy);
    py::dict texts;
    for (std::int32_t i = 0; char const* const name = quell_shaders_name(made, i); ++i)
        texts[py::str(name)] = py::str(quell_shaders_text(made, i));
    return py::make_tuple(quell_shaders_plan(made), texts);
}

/// Cameras as 34 floats, as quell_camera has them.
py::bytes block(int width, int height, int number, bool needs_camera, float shutter, float shutter_then,
                std::optional<std::vector<float>> const& camera, std::optional<std::vector<float>> const& camera_then) {
    auto frame = QUELL_SHADERS_FRAME;
    frame.width = width, frame.height = height, frame.number = number, frame.needs_camera = needs_camera;
    frame.shutter = shutter, frame.shutter_then = shutter_then;
    quell_camera now, then;
    auto const take = [](auto const& numbers, quell_camera& to, quell_camera const*& in_frame) {
        if (!numbers) return;
        if (numbers->size() * sizeof(float) != sizeof(to)) throw py::value_error("a camera has 34 numbers");
        std::memcpy(&to, numbers->data(), sizeof(to)), in_frame = &to;
    };
    take(camera, now, frame.camera), take(camera_then, then, frame.camera_then);
    std::string bytes(quell_shaders_block_size(), '\0');
    if (auto const status = quell_shaders_block(&frame, bytes.data(), bytes.size()); status != QUELL_OK)
        quell_python::raise(quell_shaders_error(), status);
    return bytes;
}

} // namespace

PYBIND11_MODULE(_shaders, module) {
    module.def("presets", [] { return names(quell_shaders_preset_name); });
    module.def("languages", [] { return names(quell_shaders_language_name); });
    module.def("create", create);
    module.def("block", block);
}
