#include "reference_cache.hpp"
#include "digest.hpp"

#include <quell/io/replace_file.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

namespace quell::tracer::detail {
namespace {

constexpr std::string_view magic = "quell reference\n";

std::filesystem::path default_folder() {
    if (char const* folder = std::getenv("QUELL_CACHE"); folder != nullptr && *folder != '\0') return folder;
    if (char const* home = std::getenv("HOME"); home != nullptr && *home != '\0') return std::filesystem::path{home} / ".cache" / "quell";
    return std::filesystem::temp_directory_path() / "quell-cache";
}

std::string file_name(std::string const& scene, int frame, std::uint64_t key) {
    return fmt::format("{}-{}-{:016x}.reference", scene, frame, key);
}

template <class Value> void put(std::ostream& out, Value const& value) { out.write(reinterpret_cast<char const*>(&value), sizeof value); }
template <class Value> Value get(std::istream& in) {
    Value value{};
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
}

std::string serialised(Reference const& reference) {
    std::ostringstream out;
    put(out, reference.samples);
    put(out, reference.half_difference);
    put(out, reference.pictures.size());
    for (auto const& [name, picture] : reference.pictures) {
        put(out, name.size());
        out << name;
        put(out, picture.size);
        for (auto const& pixel : picture.pixels) put(out, pixel);
    }
    return std::move(out).str();
}

/// What serialised() wrote, all of it.
Reference parsed(std::istream& in) {
    Reference reference;
    reference.samples = get<int>(in);
    reference.half_difference = get<double>(in);
    for (auto count = get<std::size_t>(in); count > 0; --count) {
        std::string name(get<std::size_t>(in), '\0');
        in.read(name.data(), static_cast<std::streamsize>(name.size()));
        metrics::Picture picture{get<Extent>(in), {}};
        for (auto left = picture.size.pixels(); left > 0; --left) picture.pixels.push_back(get<glm::vec3>(in));
        reference.pictures.emplace(name, std::move(picture));
    }
    return reference;
}

std::uint64_t checksum(std::uint64_t key, std::string_view content) {
    Digest digest;
    digest.add(key);
    digest.add(content);
    return digest.value();
}

std::string read_file(std::filesystem::path const& path) {
    std::ifstream file{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
}

} // namespace

ReferenceCache::ReferenceCache(std::filesystem::path const& folder, std::string const& scene, int frame, std::uint64_t key_)
    : file((folder.empty() ? default_folder() : folder) / file_name(scene, frame, key_)), key(key_) {}

std::optional<Reference> ReferenceCache::load() const {
    auto const whole = read_file(file);
    constexpr std::size_t header = magic.size() + sizeof(std::uint64_t);
    if (whole.size() < header || !whole.starts_with(magic)) return std::nullopt;
    std::istringstream in{whole.substr(magic.size())};
    if (get<std::uint64_t>(in) != checksum(key, std::string_view{whole}.substr(header))) return std::nullopt;
    return parsed(in);
}

void ReferenceCache::store(Reference const& reference) const {
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    auto const content = serialised(reference);
    std::ostringstream whole;
    whole << magic;
    put(whole, checksum(key, content));
    whole << content;
    try {
        io::replace_file(file, whole.view());
    } catch (Error const&) { // it is computed again next time
    }
}

} // namespace quell::tracer::detail
