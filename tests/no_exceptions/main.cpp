#include "no_exceptions.hpp"

#include <glm/ext/matrix_clip_space.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__cpp_exceptions) || defined(__cpp_rtti)
#error this test is compiled without exceptions and RTTI
#endif

namespace quell::tests {
namespace {

int failures = 0;

/// How a process ended, and what it wrote to stderr.
struct Death {
    int status;
    std::string output;

    [[nodiscard]] bool exited_with(int code) const { return WIFEXITED(status) && WEXITSTATUS(status) == code; }
    [[nodiscard]] bool aborted() const { return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT; }
};

/// Lets a child process do what must end it.
Death death_of(auto const& action) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    auto const child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]), close(ends[1]);
        action();
        std::_Exit(0); // the action returned
    }
    close(ends[1]);
    Death death{};
    char text[512];
    for (ssize_t count; (count = read(ends[0], text, sizeof text)) > 0;) death.output.append(text, static_cast<std::size_t>(count));
    close(ends[0]);
    if (waitpid(child, &death.status, 0) != child) std::abort();
    return death;
}

constexpr int code_of_handler = 42;
void write_and_exit(Error const& error) {
    std::fprintf(stderr, "%s|%s|%s", error.subject.c_str(), error.found.c_str(), error.remedy.c_str());
    std::_Exit(code_of_handler);
}

void make_empty_frame() { static_cast<void>(Frame{Extent{0, 0}, presets::surface(radiance)}); }
void run_with_singular_camera() {
    auto camera = usual_camera();
    camera.view = glm::mat4(0.f);
    images_by_trmv(camera);
}

void check_handler_gets(std::string const& wanted, auto const& action) {
    auto const death = death_of([&] {
        set_error_handler(write_and_exit);
        action();
    });
    check(death.exited_with(code_of_handler), "the handler is called: " + wanted);
    check(death.output == wanted, "the handler gets '" + death.output + "', not '" + wanted + "'");
}

void check_own_handler() {
    check_handler_gets("frame size|0x0|give a width and a height of at least one pixel", make_empty_frame);
    check_handler_gets("camera.view|a singular or non-finite matrix|set frame.camera to the host's camera", run_with_singular_camera);
}

void check_aborts() {
    auto const by_default = death_of(make_empty_frame);
    check(by_default.aborted(), "without a handler of the host's an error aborts");
    check(by_default.output == "quell: frame size: 0x0; give a width and a height of at least one pixel\n",
          "without a handler of the host's the message is '" + by_default.output + "'");

    auto const returned = death_of([] {
        set_error_handler([](Error const&) {});
        make_empty_frame();
    });
    check(returned.aborted() && returned.output.empty(), "where the handler returns, the program aborts");

    auto const reset = death_of([] {
        set_error_handler(write_and_exit);
        set_error_handler(nullptr);
        make_empty_frame();
    });
    check(reset.aborted() && reset.output == by_default.output, "nullptr sets the handler of a program that sets none");
}

void check_exchange() {
    check(set_error_handler(write_and_exit) == abort_on_error, "the first handler aborts");
    check(set_error_handler(nullptr) == write_and_exit, "the handler before is returned");
}

} // namespace

void check(bool holds, std::string const& what) {
    if (holds) return;
    ++failures;
    std::fprintf(stderr, "does not hold: %s\n", what.c_str());
}

int finish() {
    std::printf("%d failed\n", failures);
    return failures == 0 ? 0 : 1;
}

Camera usual_camera() {
    return {glm::mat4(1.f), glm::perspective(0.8f, static_cast<float>(image_size.width) / image_size.height, 0.1f, 100.f), glm::vec2(0.f)};
}

} // namespace quell::tests

int main() {
    using namespace quell::tests;
    // First what forks: later there are threads.
    check_own_handler();
    check_aborts();
    check_exchange();
    check_presets();
    check_opt_in();
    return finish();
}
