#include "emulated.hpp"

#include "sequence.hpp"

#include <library/all_stages.hpp>
#include <library/cuda/cuda_code.hpp>
#include <library/cuda/cuda_instance.cuh>

// libquell's code for a device, compiled for the emulated one. What is compiled for the CPU is left out.
quell_library::Codes const* quell_code_cuda() {
    using namespace quell_library;
    std::vector<DeviceCode> stages;
    for_each_stage([&]<class Named>(Named const& named) {
        stages.push_back(cuda_code<emulated_cuda::Emulated>(
            std::string(named.name), [](float samples) { return decltype(Named::make){}(quell::StandsBehind{.samples = samples}); }));
    });
    static auto const all =
        codes_of_device({cuda_code<emulated_cuda::Emulated>("svgf", [](float /*samples*/) { return emulated_cuda::preset<2>(); })}, stages);
    return &all;
}
extern "C" quell_library::CodesOf quell_code_none;
quell_library::Codes const* quell_code_none() {
    static quell_library::Codes const none;
    return &none;
}
