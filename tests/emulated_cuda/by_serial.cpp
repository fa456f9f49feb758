#include "rendered.hpp"

namespace emulated_cuda {

std::vector<Result> by_serial(int preset) {
    std::vector<Result> (*const all[])() = {results_by_serial<0>, results_by_serial<1>, results_by_serial<2>, results_by_serial<3>,
                                            results_by_serial<4>, results_by_serial<5>, results_by_serial<6>, results_by_serial<7>};
    return all[preset]();
}
std::vector<Result> by_serial_in_halves() { return results_by_serial<1, quell::Float16>(); }
Pictures rendered_by_serial() { return pictures_by_serial<0>(); }

} // namespace emulated_cuda
