// error: GiveBack: the signal and the picture must have three components; what comes back into colours would not come back into alpha
#include <quell/quell.hpp>
#include <quell/resolve/give_back.hpp>
using namespace quell;

#ifdef CORRECT
using Signal = Glossy;
#else
using Signal = Visibility;
#endif

constexpr auto denoise = presets::surface(Signal{});

int main() {
    Frame frame{{8, 8}, denoise};
    History history{{8, 8}, denoise};
    GiveBack give_back(1);
    static_cast<void>(give_back.apply(Signal{}, run(denoise, frame, history), frame, history));
}
