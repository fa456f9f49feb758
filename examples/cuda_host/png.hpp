#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace cuda_host {

/// A PNG file of 8-bit colours without compression: what a program that is built by nvcc alone can write in a few lines.
class PngFile {
    std::FILE* file;
    bool good;

public:
    explicit PngFile(std::string const& path) : file(std::fopen(path.c_str(), "wb")), good(file != nullptr) {}
    PngFile(PngFile const&) = delete;
    PngFile& operator=(PngFile const&) = delete;
    ~PngFile() {
        if (file) std::fclose(file);
    }
    /// @param rows of width * 3 bytes each
    /// @return whether all is in the file
    bool write(std::uint32_t width, std::uint32_t height, std::vector<unsigned char> const& rows) {
        put({0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
        std::vector<unsigned char> header;
        append(header, width), append(header, height);
        header.insert(header.end(), {8, 2, 0, 0, 0}); // 8 bits, colour, as they are
        chunk("IHDR", header);
        chunk("IDAT", stored(rows, width * 3));
        chunk("IEND", {});
        return good && std::fflush(file) == 0;
    }

private:
    void put(std::vector<unsigned char> const& bytes) { good = good && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size(); }
    static void append(std::vector<unsigned char>& bytes, std::uint32_t number) {
        for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<unsigned char>(number >> shift));
    }
    void chunk(char const* type, std::vector<unsigned char> const& data) {
        std::vector<unsigned char> bytes;
        append(bytes, static_cast<std::uint32_t>(data.size()));
        put(bytes);
        bytes.assign(type, type + 4);
        bytes.insert(bytes.end(), data.begin(), data.end());
        append(bytes, cyclic_redundancy_check(bytes));
        put(bytes);
    }
    static std::uint32_t cyclic_redundancy_check(std::vector<unsigned char> const& bytes) {
        std::uint32_t rest = 0xffffffffu;
        for (unsigned char const byte : bytes) {
            rest ^= byte;
            for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xedb88320u : 0);
        }
        return ~rest;
    }
    /// A zlib stream of one stored block for each row, which begins with its filter: none.
    static std::vector<unsigned char> stored(std::vector<unsigned char> const& rows, std::uint32_t row_bytes) {
        std::vector<unsigned char> stream{0x78, 0x01};
        std::uint32_t a = 1, b = 0;
        auto const add = [&](unsigned char byte) {
            stream.push_back(byte);
            a = (a + byte) % 65521, b = (b + a) % 65521;
        };
        for (std::size_t at = 0; at < rows.size(); at += row_bytes) {
            auto const length = row_bytes + 1;
            stream.push_back(at + row_bytes == rows.size());
            for (std::uint32_t const number : {length, ~length})
                for (int shift : {0, 8}) stream.push_back(static_cast<unsigned char>(number >> shift));
            add(0);
            for (std::size_t i = 0; i < row_bytes; ++i) add(rows[at + i]);
        }
        append(stream, b << 16 | a);
        return stream;
    }
};

} // namespace cuda_host
