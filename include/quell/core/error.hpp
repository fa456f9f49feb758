#pragma once

#include <stdexcept>
#include <string>

namespace quell {

/// Thrown for input that quell cannot use. what() is "subject: found; remedy".
struct Error : std::runtime_error {
    std::string subject; ///< the file, channel or parameter
    std::string found;   ///< what is wrong with it
    std::string remedy;  ///< what the caller can do

    /// Joins the three parts into the message.
    Error(std::string subject_, std::string found_, std::string remedy_)
        : std::runtime_error(subject_ + ": " + found_ + "; " + remedy_), subject(std::move(subject_)), found(std::move(found_)),
          remedy(std::move(remedy_)) {}
};

} // namespace quell
