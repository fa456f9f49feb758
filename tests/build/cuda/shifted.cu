// A job that nvcc lays out in one way for the device and in another for the host: check_layouts() must say so. Scope was such a class.
#include "../../../bench/cuda/layout.cuh"

struct Nothing {};
struct Inner {
    float* first;
    float second;
    [[no_unique_address]] Nothing third;
};
struct ShiftedJob {
    static constexpr auto name = "shifted";
    Inner inner;
    float* behind;
};

int main(int count, char** arguments) {
    static_cast<void>(quell::bench::is_listed<ShiftedJob>);
    return quell::bench::check_layouts({arguments + 1, arguments + count}) ? 0 : 1;
}
