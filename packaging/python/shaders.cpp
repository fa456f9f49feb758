// quell_shaders.h for Python: the module quell._shaders.
#include "errors.hpp"

#include <quell_shaders.h>

#include <memory>

namespace py = pybind11;

namespace {

py::list names(char const* (*name_of)(std::int32_t)) {
    py::list all;
    for (std::int32_t i = 0; char const* const name = name_of(i); ++i) all.append(name);
    return all;
}

/// The plan, and texts by the names of their files.
py::tuple create(std::string const& preset, std::string const& language) {
    quell_shaders* made = nullptr;
    quell_status status = QUELL_OK;
    std::string sentence;
    {
        py::gil_scoped_release const released;
        status = quell_shaders_create(preset.c_str(), language.c_str(), &made);
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

} // namespace

PYBIND11_MODULE(_shaders, module) {
    module.def("presets", [] { return names(quell_shaders_preset_name); });
    module.def("languages", [] { return names(quell_shaders_language_name); });
    module.def("create", create);
}
