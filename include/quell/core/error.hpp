#pragma once

#include <stdexcept>
#include <string>

namespace quell {

/// What quell throws for input that it can't use: which thing, what was found there, and what to do about it.
struct Error : std::runtime_error {
    std::string subject; ///< the file, channel or parameter
    std::string found;   ///< what was found there
    std::string remedy;  ///< what the caller can do

    Error(std::string subject_, std::string found_, std::string remedy_)
        : std::runtime_error(subject_ + ": " + found_ + "; " + remedy_), subject(std::move(subject_)), found(std::move(found_)),
          remedy(std::move(remedy_)) {}
};

} // namespace quell
