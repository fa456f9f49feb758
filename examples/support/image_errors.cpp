#include <support/image_errors.hpp>

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>

namespace quell::examples {

ImageErrors image_errors(metrics::Picture const& reference, metrics::Picture const& shown) {
    return {metrics::rmse(reference, shown), metrics::ssim(reference, shown), metrics::flip(reference, shown).mean()};
}

} // namespace quell::examples
