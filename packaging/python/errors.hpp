#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace quell_python {

/// Raises quell.Error with a sentence and a quell_status. The GIL is held.
[[noreturn]] inline void raise(std::string const& sentence, int status) {
    auto const type = pybind11::module_::import("quell._errors").attr("Error");
    PyErr_SetObject(type.ptr(), type(sentence, status).ptr());
    throw pybind11::error_already_set();
}
/// Raises MemoryError. The GIL is held.
[[noreturn]] inline void raise_no_memory(std::string const& sentence) {
    PyErr_SetString(PyExc_MemoryError, sentence.c_str());
    throw pybind11::error_already_set();
}

} // namespace quell_python
