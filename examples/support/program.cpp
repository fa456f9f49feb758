#include <support/program.hpp>

#include <quell/core/error.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>

namespace quell::examples {

namespace {
/// Messages of libraries may have several lines; ours are one.
int complain(std::string const& program, std::string message, int code) {
    std::ranges::replace(message, '\n', ' ');
    std::cout.flush();
    std::fprintf(stderr, "%s: %s\n", program.c_str(), message.c_str());
    return code;
}
} // namespace

int exit_code_of(std::string const& program, std::function<void()> const& body, std::string const& to_save_memory) {
    try {
        body();
        if (!std::cout.flush()) return complain(program, "standard output: it can't be written; check where it leads", 1);
        return 0;
    } catch (Failure const& failure) {
        return complain(program, failure.what(), 1);
    } catch (Error const& error) {
        return complain(program, error.what(), 2);
    } catch (std::bad_alloc const&) {
        return complain(program, "memory: there is not enough of it; " + to_save_memory, 1);
    } catch (std::exception const& error) {
        return complain(program, error.what(), 1);
    } catch (...) {
        return complain(program, "something went wrong that has no description", 1);
    }
}

bool parse(CLI::App& app, int argc, char const* const* argv) {
    try {
        app.parse(argc, argv);
        return true;
    } catch (CLI::CallForHelp const&) {
        std::cout << app.help();
        return false;
    } catch (CLI::CallForVersion const&) {
        std::cout << app.version() << '\n';
        return false;
    } catch (CLI::ParseError const& error) {
        throw Error("command line", error.what(), "see --help");
    }
}

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "threads; 0: all")->check(CLI::Range(0, 1024))->capture_default_str();
}

} // namespace quell::examples
