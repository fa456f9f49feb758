#pragma once

#include "errors.hpp"

#include <quell/core/error.hpp>

namespace quell_python {

/// Calls f while other threads of Python run. What it throws becomes quell.Error, with the quell_status of libquell's functions.
template <class F> auto released(F const& f) {
    try {
        pybind11::gil_scoped_release const other_threads_run;
        return f();
    } catch (quell::Failure const& error) {
        raise(error.what(), 6);
    } catch (quell::Error const& error) {
        raise(error.what(), 1);
    }
}

} // namespace quell_python
