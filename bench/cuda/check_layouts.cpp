#include "layouts.hpp"

#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

namespace quell::bench {
namespace {

/// What the device's compiler says.
struct Device {
    std::set<Layout> layouts;
    std::set<unsigned> argument_sizes; ///< of the kernels that compute pixels
};

/// A register that is given a constant, and a store of a register: the lines that layout_for_device() is made of.
/// @throws std::runtime_error for a store that it cannot read
void read_line(std::string const& line, std::map<std::string, unsigned>& registers, std::map<unsigned, unsigned>& stored) {
    static std::regex const move(R"(\s*mov\.[bsu]32\s+(%r\d+), (-?\d+);)");
    static std::regex const store(R"(\s*st\.volatile\.(?:global\.)?[bsu]32\s+\[%rd\d+(?:\+(\d+))?\], (%r\d+|-?\d+);)");
    std::smatch found;
    auto const number = [](std::string const& digits) { return static_cast<unsigned>(std::stoll(digits)); };
    if (std::regex_match(line, found, move))
        registers[found[1]] = number(found[2]);
    else if (std::regex_match(line, found, store))
        stored[found[1].matched ? number(found[1]) / 4 : 0] = found.str(2)[0] == '%' ? registers.at(found[2]) : number(found[2]);
    else if (line.find("\tst.") != std::string::npos)
        throw std::runtime_error("a kernel of layout_for_device() has a line that is not understood: " + line);
}

void read_ptx(std::string const& file, Device& device) {
    static std::regex const argument(R"(\s*\.param \.align \d+ \.b8 \w*each_pixel\w*_param_1\[(\d+)\],?)");
    std::ifstream in(file);
    std::map<std::string, unsigned> registers;
    std::map<unsigned, unsigned> stored;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        std::smatch found;
        if (line.find(".entry") != std::string::npos) inside = line.find("layout_for_device") != std::string::npos;
        if (std::regex_match(line, found, argument)) device.argument_sizes.insert(static_cast<unsigned>(std::stoul(found[1])));
        if (!inside) continue;
        read_line(line, registers, stored);
        if (line != "}") continue;
        Layout layout;
        for (auto const& [place, number] : stored) layout.push_back(number);
        device.layouts.insert(layout);
        registers.clear(), stored.clear(), inside = false;
    }
}

std::string text_of(Layout const& layout) {
    std::string text = "aligned to " + std::to_string(layout[1]) + ", size " + std::to_string(layout[3]) + ", parts (place:size)";
    for (std::size_t i = 4; i + 1 < layout.size(); i += 2) text += " " + std::to_string(layout[i]) + ":" + std::to_string(layout[i + 1]);
    return text;
}

/// All that the device has under the name of a pass.
void print_of_device(Device const& device, unsigned hash) {
    for (auto const& layout : device.layouts)
        if (!layout.empty() && layout[0] == hash) std::printf("    the device: %s\n", text_of(layout).c_str());
}

} // namespace

bool check_layouts(std::vector<std::string> const& ptx_files) {
    Device device;
    for (auto const& file : ptx_files) read_ptx(file, device);
    std::set<Layout> host;
    std::set<unsigned> sizes;
    bool equal = true;
    for (auto const& [pass, layout] : known_layouts()) {
        host.insert(layout), sizes.insert(layout[3]);
        if (device.layouts.contains(layout)) continue;
        equal = false;
        std::printf("pass '%s' is laid out otherwise for the device\n    the host:   %s\n", pass.c_str(), text_of(layout).c_str());
        print_of_device(device, layout[0]);
    }
    if (host.size() != device.layouts.size()) {
        equal = false;
        std::printf("the host has %zu layouts, PTX has %zu\n", host.size(), device.layouts.size());
    }
    if (!device.argument_sizes.empty() && sizes != device.argument_sizes) {
        equal = false;
        std::printf("the sizes of the kernels' arguments in PTX are not those of the host's jobs\n");
    }
    if (equal && !host.empty()) std::printf("%zu layouts are equal\n", host.size());
    return equal && !host.empty();
}

} // namespace quell::bench
