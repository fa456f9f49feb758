// A program of one thread, which any page may run.
#include "denoiser.hpp"

extern "C" __attribute__((import_module("page"), import_name("milliseconds"))) double page_milliseconds();

namespace quell::live {

double seconds_now() { return page_milliseconds() * 1e-3; }
int thread_count() { return 1; }
void set_thread_count(int) {}
void share(int count, std::function<void(int)> const& turn) {
    for (int i = 0; i < count; ++i) turn(i);
}

} // namespace quell::live
