#pragma once

#include "../math.hpp"

#include <quell/core/error.hpp>

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

namespace quell::tracer::gltf {

/// A file's content, with access that checks every index and range: files come from anywhere.
struct Model {
    std::filesystem::path path;
    tinygltf::Model content;

    [[nodiscard]] Error error(std::string const& found, std::string const& remedy = "export or download the file again") const {
        return {path.string(), found, remedy};
    }

    /// An accessor's components one after another, normalised integers as floats. `components` is how many each element must have.
    [[nodiscard]] std::vector<float> floats(int accessor, int components) const;
    [[nodiscard]] std::vector<unsigned> indices(int accessor) const;
    /// A number that is one, as an integer.
    [[nodiscard]] unsigned index(double value) const;

    template <class Vector> [[nodiscard]] std::vector<Vector> vectors(int accessor) const {
        constexpr std::size_t length = Vector::length();
        auto const values = floats(accessor, Vector::length());
        std::vector<Vector> result(values.size() / length);
        for (std::size_t i = 0; i < values.size(); ++i) result[i / length][static_cast<int>(i % length)] = values[i];
        return result;
    }

    /// An item of a list of the file, by the number that another item refers to it with. Also called just to check that number.
    template <class Item> Item const& item(std::vector<Item> const& list, int number, char const* kind) const {
        if (number >= 0 && static_cast<std::size_t>(number) < list.size()) return list[static_cast<std::size_t>(number)];
        throw error(std::string{"it refers to "} + kind + " " + std::to_string(number) + " of " + std::to_string(list.size()));
    }

private:
    struct Range {
        unsigned char const* first;
        std::size_t count, stride;
        int component_type, components;
        bool normalized;
    };
    [[nodiscard]] Range range(int buffer_view, std::size_t offset, std::size_t count, int component_type, int components) const;
    [[nodiscard]] std::vector<double> numbers(Range const& range) const;
    void substitute(tinygltf::Accessor const& accessor, int components, std::vector<double>& values) const;
    [[nodiscard]] std::vector<double> numbers(int accessor, int components) const;
};

/// Reads the file with everything that belongs to it.
[[nodiscard]] Model load_model(std::filesystem::path const& path);

} // namespace quell::tracer::gltf
