#pragma once

#include <quell/core/error.hpp>
#include <quell/io/exr/exr_header_check.hpp>

#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfTestFile.h>
#include <OpenEXR/ImfVersion.h>
#include <OpenEXR/OpenEXRConfig.h>

#include <array>
#include <filesystem>
#include <new>
#include <system_error>

namespace quell::inline QUELL_INSTRUCTION_SET::io::detail {

/// First line of a library's message.
inline std::string first_line(std::string const& text) { return text.substr(0, text.find('\n')); }

/// Runs f; turns exceptions of the OpenEXR library into an Error that names the file: a Failure where it is being written.
template <class E = Error> void naming_file(std::string const& file, std::string const& trouble, auto&& f) {
    auto const remedy = "render or copy it again";
    try {
        f();
    } catch (Error const&) {
        throw;
    } catch (std::bad_alloc const&) {
        throw E(file, trouble + ": it asks for more memory than there is", remedy);
    } catch (std::exception const& why) { // the base of OpenEXR's exceptions
        throw E(file, trouble + " (" + first_line(why.what()) + ")", remedy);
    }
}

/// What this program's OpenEXR library is called.
inline std::string library_name() {
    return "OpenEXR " + std::to_string(OPENEXR_VERSION_MAJOR) + "." + std::to_string(OPENEXR_VERSION_MINOR);
}

/// Refuses what versions of OpenEXR later than this program's write.
inline void check_is_known(std::string const& file, HeaderCheck const& header) {
    // The first that OpenEXR 3.1 does not have.
    constexpr std::array newer{"HTJ2K256", "HTJ2K32"};
    auto const number = header.newest_compression();
    if (number >= Imf::NUM_COMPRESSION_METHODS) {
        auto const place = static_cast<std::size_t>(number) - 10; // of a smaller one it is large
        auto const name = place < newer.size() ? std::string(" (") + newer[place] + ")" : std::string();
        throw Error(file, "its compression is number " + std::to_string(number) + name + ", which " + library_name() + " cannot read",
                    "save it as ZIP, which every version reads");
    }
    if (header.format() > Imf::EXR_VERSION)
        throw Error(file,
                    "it is of version " + std::to_string(header.format()) + " of the format, which " + library_name() + " cannot read",
                    "save it by an older version of OpenEXR, as ZIP");
}

/// Checks for the usual mistakes in a path before the library opens it.
inline void check_is_exr(std::filesystem::path const& path) {
    std::error_code why;
    auto const status = std::filesystem::status(path, why);
    if (!std::filesystem::exists(status)) throw Error(path.string(), "there is no such file", "check the path and the frame's number");
    if (std::filesystem::is_directory(status)) throw Error(path.string(), "it is a folder", "give the path of an EXR file");
    if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(path, why) == 0)
        throw Error(path.string(), "it is empty", "render or copy it again");
    if (!Imf::isOpenExrFile(path.string().c_str())) throw Error(path.string(), "it isn't an EXR file", "give an OpenEXR file");
    HeaderCheck header(path);
    if (!header.passes()) throw Error(path.string(), "its header is truncated or damaged", "render or copy it again");
    check_is_known(path.string(), header);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io::detail
