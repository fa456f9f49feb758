#include "reference_cache.hpp"
#include "digest.hpp"

#include <quell/io/replace_file.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
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

class Writer {
public:
    template <class Value> void put(Value const& value) { put_bytes(&value, sizeof value); }
    void put(std::string const& text) {
        put(text.size());
        put_bytes(text.data(), text.size());
    }
    void put_bytes(void const* data, std::size_t size) { bytes.append(static_cast<char const*>(data), size); }
    std::string bytes;
};

/// Reads what a Writer wrote; `ok` turns false for good when something is missing.
class Reader {
public:
    explicit Reader(std::string_view bytes_) : bytes(bytes_) {}
    template <class Value> Value get() {
        Value value{};
        get_bytes(&value, sizeof value);
        return value;
    }
    std::string get_text() {
        auto const size = get<std::size_t>();
        std::string text(ok && size <= bytes.size() ? size : 0, '\0');
        get_bytes(text.data(), size);
        return text;
    }
    void get_bytes(void* data, std::size_t size) {
        ok = ok && size <= bytes.size();
        if (!ok) return;
        std::memcpy(data, bytes.data(), size);
        bytes.remove_prefix(size);
    }
    bool ok = true;

private:
    std::string_view bytes;
};

std::string serialised(Reference const& reference) {
    Writer writer;
    writer.put(reference.samples);
    writer.put(reference.half_difference);
    writer.put(reference.pictures.size());
    for (auto const& [name, picture] : reference.pictures) {
        writer.put(name);
        writer.put(picture.size);
        writer.put_bytes(picture.pixels.data(), picture.pixels.size() * sizeof(glm::vec3));
    }
    return std::move(writer.bytes);
}

std::optional<Reference> parsed(std::string_view bytes, Extent size) {
    Reader reader{bytes};
    Reference reference;
    reference.samples = reader.get<int>();
    reference.half_difference = reader.get<double>();
    auto const count = reader.get<std::size_t>();
    for (std::size_t i = 0; i < count && reader.ok; ++i) {
        auto const name = reader.get_text();
        if (reader.get<Extent>() != size) return std::nullopt;
        metrics::Picture picture{size, std::vector<glm::vec3>(static_cast<std::size_t>(size.pixels()))};
        reader.get_bytes(picture.pixels.data(), picture.pixels.size() * sizeof(glm::vec3));
        reference.pictures.emplace(name, std::move(picture));
    }
    reference.from_cache = true;
    return reader.ok ? std::optional{std::move(reference)} : std::nullopt;
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

std::optional<Reference> ReferenceCache::load(Extent size) const {
    auto const whole = read_file(file);
    std::size_t const header = magic.size() + sizeof(std::uint64_t);
    if (whole.size() < header || !whole.starts_with(magic)) return std::nullopt;
    std::uint64_t stored;
    std::memcpy(&stored, whole.data() + magic.size(), sizeof stored);
    auto const content = std::string_view{whole}.substr(header);
    return stored == checksum(key, content) ? parsed(content, size) : std::nullopt;
}

void ReferenceCache::store(Reference const& reference) const {
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    auto const content = serialised(reference);
    auto const sum = checksum(key, content);
    Writer whole;
    whole.put_bytes(magic.data(), magic.size());
    whole.put(sum);
    whole.put_bytes(content.data(), content.size());
    try {
        io::replace_file(file, whole.bytes);
    } catch (Error const&) { // it is computed again next time
    }
}

} // namespace quell::tracer::detail
