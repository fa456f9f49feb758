#include <files.hpp>
#include <gauntlet/stored.hpp>

#include <quell/core/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace quell::gauntlet {

namespace {

constexpr std::string_view letters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_";
constexpr double least = 1e-4, largest = 4;
constexpr auto header = "situation,samples,frame,input,quick,default,right,windows";

/// How the frames were made that the figures are of.
std::string making_line(Making const& making) {
    return fmt::format("# {}x{}, {} frames, seed {}", making.size.width, making.size.height, making.frames, making.seed);
}

} // namespace

std::string packed(std::vector<double> const& numbers) {
    std::string text;
    for (double const number : numbers) {
        double const part = std::log(std::clamp(number, least, largest) / least) / std::log(largest / least);
        auto const code = static_cast<std::size_t>(std::lround(part * 4095));
        text += letters[code / 64], text += letters[code % 64];
    }
    return text;
}

std::vector<double> unpacked(std::string const& text) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
        auto const code = letters.find(text[i]) * 64 + letters.find(text[i + 1]);
        numbers.push_back(least * std::pow(largest / least, static_cast<double>(code) / 4095));
    }
    return numbers;
}

Stored const* StoredFigures::find(std::string const& situation, int samples, int frame) const {
    auto const found = all.find({situation, samples, frame});
    return found == all.end() ? nullptr : &found->second;
}

void StoredFigures::write(std::filesystem::path const& path, Making const& making) const {
    auto text = fmt::format("{}\n{}\n", making_line(making), header);
    for (auto const& [key, one] : all)
        text += fmt::format("{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{}\n", std::get<0>(key), std::get<1>(key), std::get<2>(key), one.input,
                            one.quick, one.full, one.right, packed(one.windows));
    bench::write_text(path, text);
}

StoredFigures StoredFigures::read(std::filesystem::path const& path, Making const& making) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    StoredFigures figures;
    if (!file || line != making_line(making)) return figures;
    std::getline(file, line);
    if (line != header) throw Error(path.string(), "its second line is not " + std::string(header), "write it anew by --store");
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        if (row.size() != 8) throw Error(path.string(), "a line is " + line, "write it anew by --store");
        figures.add(row[0], std::stoi(row[1]), std::stoi(row[2]),
                    {std::stod(row[3]), std::stod(row[4]), std::stod(row[5]), std::stod(row[6]), unpacked(row[7])});
    }
    return figures;
}

} // namespace quell::gauntlet
