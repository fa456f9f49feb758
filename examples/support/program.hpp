#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace quell::examples {

/// Runs a program's body and makes of what it throws one line on stderr and an exit code: 0 done, 2 unusable arguments or input (Error),
/// 1 anything else, such as a Failure.
/// @param to_save_memory what its user can do where memory runs out
int exit_code_of(std::string const& program, std::function<void()> const& body,
                 std::string const& to_save_memory = "give a smaller --size");

/// Reads the command line. False where it asked for help or the version, which has then been printed.
/// @throws Error for a command line that can't be used
[[nodiscard]] bool parse(CLI::App& app, int argc, char const* const* argv);

/// Adds --threads: 0, which means all, to 1024. oneTBB crashes where it is asked for too many.
void add_threads(CLI::App& app, int& threads);

} // namespace quell::examples
