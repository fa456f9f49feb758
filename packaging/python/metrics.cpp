// quell/metrics for Python: the module quell._metrics.
#include "released.hpp"

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>

#include <pybind11/numpy.h>

#include <cstring>

namespace py = pybind11;

namespace {

using namespace quell::metrics;
using quell_python::released;
using Floats = py::array_t<float, py::array::c_style>;

/// Of an array of shape (height, width, 3).
Picture picture_of(Floats const& array) {
    Picture picture{{static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0))}, {}};
    picture.pixels.resize(static_cast<std::size_t>(array.size() / 3));
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    if (array.size() > 0) std::memcpy(picture.pixels.data(), array.data(), static_cast<std::size_t>(array.nbytes()));
    return picture;
}
/// Of None, or an array of one byte per pixel.
Mask mask_of(py::object const& given) {
    if (given.is_none()) return {};
    auto const bytes = given.cast<py::array_t<std::uint8_t, py::array::c_style>>();
    return {bytes.data(), bytes.data() + bytes.size()};
}

} // namespace

PYBIND11_MODULE(_metrics, module) {
    module.def("rmse", [](Floats const& reference, Floats const& test, py::object const& mask) {
        auto const a = picture_of(reference), b = picture_of(test);
        auto const counted = mask_of(mask);
        return released([&] { return rmse(a, b, counted); });
    });
    module.def("ssim", [](Floats const& reference, Floats const& test, py::object const& mask) {
        auto const a = picture_of(reference), b = picture_of(test);
        auto const counted = mask_of(mask);
        return released([&] { return ssim(a, b, counted); });
    });
    module.def("flip", [](Floats const& reference, Floats const& test, py::object const& mask, float pixels_per_degree) {
        auto const a = picture_of(reference), b = picture_of(test);
        auto const counted = mask_of(mask);
        double mean = 0;
        auto const errors = released([&] {
            auto const made = flip(a, b, pixels_per_degree);
            mean = made.mean(counted);
            return made.error;
        });
        py::array_t<float> map({a.size.height, a.size.width});
        std::memcpy(map.mutable_data(), errors.data(), errors.size() * sizeof(float));
        return py::make_tuple(mean, map);
    });
    module.def("displayed", [](Floats const& linear) {
        auto const picture = picture_of(linear);
        auto const shown = released([&] { return displayed(picture); });
        Floats result({picture.size.height, picture.size.width, 3});
        std::memcpy(result.mutable_data(), shown.pixels.data(), static_cast<std::size_t>(result.nbytes()));
        return result;
    });
}
