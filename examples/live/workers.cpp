// A program whose work several threads share: for pages that may have memory that threads share.
#include "workers.hpp"

#include "denoiser.hpp"

#include <emscripten.h>

#include <algorithm>
#include <memory>

namespace quell::live {
namespace {
std::unique_ptr<Workers> workers; // until the page goes
int helpers = 0;                  // of those, the ones that are called
} // namespace

double seconds_now() { return emscripten_get_now() * 1e-3; }
int thread_count() { return 1 + helpers; }
void set_thread_count(int count) {
    if (!workers) workers = std::make_unique<Workers>(count - 1);
    helpers = std::clamp(count - 1, 0, workers->count());
}
void share(int count, std::function<void(int)> const& turn) {
    if (helpers == 0)
        for (int i = 0; i < count; ++i) turn(i);
    else
        workers->share(count, turn, helpers);
}

} // namespace quell::live
