#pragma once

#include <quell/core/instruction_set.hpp>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What is wrong with input that quell cannot use. what() is "subject: found; remedy". raise_error() throws it, or hands it to the
/// ErrorHandler.
struct Error : std::runtime_error {
    std::string subject; ///< the file, channel or parameter
    std::string found;   ///< what is wrong with it
    std::string remedy;  ///< what the caller can do

    /// Joins the three parts into the message.
    Error(std::string subject_, std::string found_, std::string remedy_)
        : std::runtime_error(subject_ + ": " + found_ + "; " + remedy_), subject(std::move(subject_)), found(std::move(found_)),
          remedy(std::move(remedy_)) {}
};

/// An Error that is no fault of the input: a file that can't be written, a device that fails, a call that a host should not make. Programs
/// end with another exit code for it.
struct Failure : Error {
    using Error::Error;
};

/// What is called with an Error in a program that is compiled without exceptions. It ends the program, and does not return.
using ErrorHandler = void (*)(Error const& error);

/// The handler of a program that sets none: prints what() to stderr and aborts.
[[noreturn]] inline void abort_on_error(Error const& error) {
    std::fprintf(stderr, "quell: %s\n", error.what());
    std::abort();
}

namespace detail {
inline constinit std::atomic<ErrorHandler> error_handler = abort_on_error;
} // namespace detail

/// Sets the handler of the whole program, from any thread, and returns the one before:
///
///     quell::set_error_handler([](quell::Error const& error) {
///         engine::fatal("%s: %s", error.subject.c_str(), error.remedy.c_str()); // does not return
///     });
///
/// The program aborts where the handler returns. Several threads may call the handler at once. It is never called where exceptions are on.
/// @param handler nullptr: abort_on_error
inline ErrorHandler set_error_handler(ErrorHandler handler) { return detail::error_handler.exchange(handler ? handler : abort_on_error); }

/// Every error of the headers outside `io` comes through here. Throws an Error, or calls the handler where exceptions are off.
/// @tparam E Error or Failure
/// @throws Error where exceptions are on
template <class E = Error> [[noreturn]] void raise_error(std::string subject, std::string found, std::string remedy) {
    E error(std::move(subject), std::move(found), std::move(remedy));
#if defined(__cpp_exceptions)
    throw error;
#else
    detail::error_handler.load()(error);
    std::abort();
#endif
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
