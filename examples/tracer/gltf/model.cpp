#include "model.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace quell::tracer::gltf {
namespace {

/// @param normalized whether the largest whole number stands for 1
template <class Number> double number_at(unsigned char const* bytes, bool normalized) {
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    bool const is_part = normalized && std::is_integral_v<Number> && sizeof(Number) < 4;
    return static_cast<double>(value) / (is_part ? static_cast<double>(std::numeric_limits<Number>::max()) : 1);
}

double number_at(unsigned char const* bytes, int component_type, bool normalized) {
    if (component_type == TINYGLTF_COMPONENT_TYPE_BYTE) return number_at<std::int8_t>(bytes, normalized);
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return number_at<std::uint8_t>(bytes, normalized);
    if (component_type == TINYGLTF_COMPONENT_TYPE_SHORT) return number_at<std::int16_t>(bytes, normalized);
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return number_at<std::uint16_t>(bytes, normalized);
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return number_at<std::uint32_t>(bytes, normalized);
    return number_at<float>(bytes, normalized);
}

std::string one_line(std::string text) {
    for (auto& character : text)
        if (character == '\n') character = ' ';
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
    return text;
}

/// Whether the chunks of a PNG lie within its bytes. The library that decodes it makes room for as many as a chunk claims, up to 2 GB.
bool has_whole_chunks(unsigned char const* bytes, std::size_t size) {
    constexpr std::size_t signature = 8, around = 12; // length, type and checksum of a chunk
    for (std::size_t at = signature; at + around <= size;) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | bytes[at + i];
        if (length > size - at - around) return false;
        at += around + length;
    }
    return true;
}

bool load_image(tinygltf::Image* image, int number, std::string* errors, std::string* warnings, int width, int height,
                unsigned char const* bytes, int size, void*) {
    auto const count = static_cast<std::size_t>(std::max(size, 0));
    bool const is_png = count >= 8 && std::equal(bytes, bytes + 8, "\x89PNG\r\n\x1a\n",
                                                 [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); });
    if (is_png && !has_whole_chunks(bytes, count)) {
        *errors += "image " + std::to_string(number) + " is a PNG that is truncated or damaged";
        return false;
    }
    return tinygltf::LoadImageData(image, number, errors, warnings, width, height, bytes, size, nullptr);
}

} // namespace

Model::Range Model::range(int buffer_view, std::size_t offset, std::size_t count, int component_type, int components) const {
    auto const& view = item(content.bufferViews, buffer_view, "buffer view");
    auto const& buffer = item(content.buffers, view.buffer, "buffer");
    auto const component_size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
    if (component_size <= 0 || components <= 0) throw error("an accessor has an unknown type");
    auto const size = static_cast<std::size_t>(component_size) * static_cast<std::size_t>(components);
    auto const stride = view.byteStride != 0 ? view.byteStride : size;
    auto const bytes = buffer.data.size(), start = view.byteOffset + offset;
    // Written so that no sum or product overflows, whatever numbers a broken file holds.
    bool const fits = view.byteOffset <= bytes && offset <= bytes && start <= bytes &&
                      (count == 0 || (size <= bytes - start && (count - 1) <= (bytes - start - size) / stride));
    if (!fits) throw error("an accessor reaches beyond the " + std::to_string(bytes) + " bytes of buffer '" + buffer.uri + "'");
    return {buffer.data.data() + start, count, stride, component_type, components, false};
}

std::vector<double> Model::numbers(Range const& range) const {
    auto const components = static_cast<std::size_t>(range.components);
    auto const size = static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(range.component_type)));
    std::vector<double> values(range.count * components);
    for (std::size_t i = 0; i < range.count; ++i)
        for (std::size_t j = 0; j < components; ++j)
            values[i * components + j] = number_at(range.first + i * range.stride + j * size, range.component_type, range.normalized);
    return values;
}

/// Sparse accessors replace some elements of a base.
void Model::substitute(tinygltf::Accessor const& accessor, int components, std::vector<double>& values) const {
    auto const& sparse = accessor.sparse;
    auto const count = static_cast<std::size_t>(sparse.count), width = static_cast<std::size_t>(components);
    auto const places = numbers(
        range(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count, sparse.indices.componentType, 1));
    auto const news = numbers(
        range(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count, accessor.componentType, components));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0, place = index(places[i]); j < width && place < accessor.count; ++j)
            values[place * width + j] = news[i * width + j];
}

std::vector<double> Model::numbers(int number, int components) const {
    auto const& accessor = item(content.accessors, number, "accessor");
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != components)
        throw error("accessor " + std::to_string(number) + " doesn't have " + std::to_string(components) + " components");
    // Numbers without bytes behind them are zeros, of which a file of any size can ask for any number.
    std::size_t const most = std::size_t{1} << (accessor.bufferView >= 0 ? 28 : 24);
    if (accessor.count > most)
        throw error("accessor " + std::to_string(number) + " claims " + std::to_string(accessor.count) + " elements");
    std::vector<double> values(accessor.count * static_cast<std::size_t>(components));
    if (accessor.bufferView >= 0) {
        auto found = range(accessor.bufferView, accessor.byteOffset, accessor.count, accessor.componentType, components);
        found.normalized = accessor.normalized;
        values = numbers(found);
    }
    if (accessor.sparse.isSparse) substitute(accessor, components, values);
    return values;
}

std::vector<float> Model::floats(int accessor, int components) const {
    auto const values = numbers(accessor, components);
    return {values.begin(), values.end()};
}

unsigned Model::index(double value) const {
    if (value >= 0 && value < 4294967296. && value == std::floor(value)) return static_cast<unsigned>(value);
    throw error("one of its indices is " + std::to_string(value));
}

std::vector<unsigned> Model::indices(int accessor) const {
    std::vector<unsigned> result;
    for (double value : numbers(accessor, 1)) result.push_back(index(value));
    return result;
}

Model load_model(std::filesystem::path const& path) {
    Model model{path, {}};
    if (!std::filesystem::is_regular_file(path)) throw model.error("there is no such file", "check the path");
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(load_image, nullptr);
    std::string errors, warnings;
    bool const loaded = path.extension() == ".glb" ? loader.LoadBinaryFromFile(&model.content, &errors, &warnings, path.string())
                                                   : loader.LoadASCIIFromFile(&model.content, &errors, &warnings, path.string());
    if (!loaded)
        throw model.error(errors.empty() ? "it isn't a glTF 2.0 file" : one_line(errors),
                          "put the files that it names beside it, or export it again as glTF 2.0");
    return model;
}

} // namespace quell::tracer::gltf
