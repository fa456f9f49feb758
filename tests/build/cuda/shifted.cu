// A job that nvcc lays out in one way for the device and in another for the host: check_layouts() must say so. Its member without data
// takes no space in an argument of the host's.
#include "../../../bench/cuda/check_layouts.hpp"
#include "../../../bench/cuda/layout.cuh"

struct Nothing {};
struct ShiftedJob {
    static constexpr auto name = "shifted";
    [[no_unique_address]] Nothing first;
    float second;
    [[no_unique_address]] Nothing third;
    float* fourth;
};

int main(int count, char** arguments) {
    static_cast<void>(quell::bench::is_listed<ShiftedJob>);
    return quell::bench::check_layouts({arguments + 1, arguments + count}) ? 0 : 1;
}
