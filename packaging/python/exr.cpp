// quell/io for Python: the module quell._exr.
#include "released.hpp"

#include <library/loaded_frame.hpp>

#include <quell/io/exr.hpp>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstring>
#include <map>

namespace py = pybind11;

namespace {

using namespace quell::io;
using quell_python::released;
using Floats = py::array_t<float, py::array::c_style>;

/// Matrices of Python's are indexed by row and column.
Floats matrix_of(glm::mat4 const& matrix) {
    Floats result({4, 4});
    auto to = result.mutable_unchecked<2>();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) to(row, column) = matrix[column][row];
    return result;
}
py::object object_of(Attribute const& attribute) {
    if (auto const* const pair = std::get_if<glm::vec2>(&attribute)) return py::make_tuple(pair->x, pair->y);
    if (auto const* const matrix = std::get_if<glm::mat4>(&attribute)) return matrix_of(*matrix);
    if (auto const* const text = std::get_if<std::string>(&attribute)) // files may hold any bytes
        return py::reinterpret_steal<py::object>(
            PyUnicode_DecodeUTF8(text->data(), static_cast<py::ssize_t>(text->size()), "surrogateescape"));
    if (auto const* const whole = std::get_if<int>(&attribute)) return py::int_(*whole);
    return py::float_(std::get<float>(attribute));
}
Attribute attribute_of(std::string const& name, py::handle value) {
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    if (py::isinstance<py::int_>(value)) return value.cast<int>();
    if (py::isinstance<py::float_>(value)) return value.cast<float>();
    if (py::isinstance<py::array>(value) || py::isinstance<py::tuple>(value)) {
        auto const numbers = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(value);
        if (numbers && numbers.ndim() == 1 && numbers.size() == 2) return glm::vec2(numbers.at(0), numbers.at(1));
        if (numbers && numbers.ndim() == 2 && numbers.shape(0) == 4 && numbers.shape(1) == 4) {
            glm::mat4 matrix;
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) matrix[column][row] = numbers.at(row, column);
            return matrix;
        }
        PyErr_Clear();
    }
    quell_python::raise(
        "attribute '" + name + "': it is " + std::string(py::repr(value)) + "; give a str, int, float, two numbers or a 4x4 matrix", 1);
}

/// A plane as an array of shape (height, width), which owns the plane's memory.
Floats array_of(Plane&& plane, quell::Extent size) {
    auto* const owned = new std::vector<float>(std::move(plane.values));
    py::capsule const owner(owned, [](void* memory) { delete static_cast<std::vector<float>*>(memory); });
    return Floats({size.height, size.width}, owned->data(), owner);
}

py::tuple read_planes(std::string const& path, std::optional<std::vector<std::string>> const& names) {
    auto image = released([&] {
        ExrFile const file(path);
        return names ? file.read(*names) : file.read();
    });
    py::list planes;
    for (auto& plane : image.planes) {
        auto const name = plane.name;
        auto const type = to_string(plane.type);
        bool const exact = plane.exact;
        planes.append(py::make_tuple(name, type, exact, array_of(std::move(plane), image.size)));
    }
    py::dict attributes;
    for (auto const& [name, value] : image.attributes) attributes[py::str(name)] = object_of(value);
    return py::make_tuple(planes, attributes);
}

/// @param planes (name, type, array of shape (height, width)) each
void write_planes(std::string const& path, py::list const& planes, py::dict const& attributes) {
    ExrImage image{.name = path, .size = {}};
    for (auto const& each : planes) {
        auto const [name, type, array] = each.cast<std::tuple<std::string, std::string, Floats>>();
        if (image.planes.empty()) image.size = {static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0))};
        image.planes.push_back({.name = name,
                                .type = type == "half"   ? SampleType::half
                                        : type == "uint" ? SampleType::uint32
                                                         : SampleType::float32,
                                .values = {array.data(), array.data() + array.size()}});
    }
    for (auto const& [key, value] : attributes) {
        auto const name = key.cast<std::string>();
        image.attributes[name] = attribute_of(name, value);
    }
    released([&] { return write_exr(path, image), true; });
}

/// What quell calls the planes of its channels, by the channel's name.
std::map<std::string, std::vector<std::string>> names_of_channels() {
    std::map<std::string, std::vector<std::string>> names;
    quell::for_each_channel(quell::AllChannels{}, [&](auto channel) { names[std::string(channel.name)] = own_names(channel); });
    return names;
}

/// The names of a file's signals, each of which is denoised by itself.
std::vector<std::string> signals(std::string const& path) {
    return released([&] {
        std::vector<std::string> names;
        for (auto const& signal : recognise(ExrFile(path)).of_signals) names.push_back(signal.name);
        return names;
    });
}

/// The signal of that name, or the only one.
SignalNames signal_of(ExrFile const& file, std::optional<std::string> const& wanted) {
    auto const of_signals = names_in_parts(recognise(file), file).of_signals;
    if (!wanted && of_signals.size() == 1) return of_signals[0];
    for (auto const& signal : of_signals)
        if (wanted && signal.name == *wanted) return signal;
    throw quell::Error(file.name, wanted ? "it has no signal '" + *wanted + "'" : "it has several signals",
                       "name one of: " + detail::list_of_names(of_signals));
}

/// A channel in Python's memory, a plane for each component.
py::array read_channel(quell_library::FileChannel const& channel, ExrImage const& image, ChannelNames const& names) {
    quell_library::FileChannel::Memory memory;
    auto const loaded = released([&] { return channel.load(memory, image, names); });
    auto const width = static_cast<std::size_t>(image.size.width);
    py::array_t<float> planes({channel.components, image.size.height, image.size.width});
    auto* to = planes.mutable_data();
    for (int c = 0; c < channel.components; ++c)
        for (int y = 0; y < image.size.height; ++y, to += width)
            std::memcpy(to, loaded.data + (c * loaded.component_stride + y * loaded.row_stride), width * sizeof(float));
    if (channel.components == 1) return planes.attr("__getitem__")(0);
    return planes.attr("transpose")(1, 2, 0);
}

/// @param channels those to read; None: those that the file has
/// @param sources  names of planes by channel, in place of those that are recognised
py::tuple read_frame(std::string const& path, std::optional<std::vector<std::string>> const& channels,
                     std::map<std::string, std::vector<std::string>> const& sources, std::optional<std::string> const& signal) {
    auto const file = released([&] { return std::make_unique<ExrFile>(path); });
    auto const names = released([&] {
        // Who names the picture's planes needs no other names to be recognised.
        auto all = sources.contains("radiance") ? ChannelNames{} : signal_of(*file, signal).channels;
        for (auto const& [channel, planes] : sources) {
            auto& of_channel = all.sources[channel];
            of_channel.clear();
            for (auto const& plane : planes) of_channel.push_back({{plane}});
        }
        return all;
    });
    py::dict read;
    py::object camera = py::none(), shutter = py::none();
    auto const take_attributes = [&](ExrImage const& image) {
        if (auto const seen_by = camera_of(image))
            camera = py::make_tuple(matrix_of(seen_by->view), matrix_of(seen_by->projection),
                                    py::make_tuple(seen_by->jitter.x, seen_by->jitter.y));
        if (auto const open = shutter_of(image, names)) shutter = py::float_(*open);
    };
    released([&] { return shutter_of({file->name, file->size, {}, file->attributes}, names); }); // its errors
    take_attributes({file->name, file->size, {}, file->attributes});
    for (auto const& channel : quell_library::file_channels()) {
        bool const is_wanted = !channels || std::ranges::find(*channels, channel.name) != channels->end();
        if (!is_wanted) continue;
        auto const planes = released([&] { return channel.planes(names); });
        if (!channels && !file->has_all(planes)) continue;
        auto const image = released([&] { return file->read(planes); });
        read[py::str(std::string(channel.name))] = read_channel(channel, image, names);
    }
    if (channels)
        for (auto const& each : *channels)
            if (!read.contains(each.c_str()))
                quell_python::raise("channel '" + each + "': files have none of that name; see the table of channels in docs/channels.md",
                                    1);
    return py::make_tuple(read, camera, shutter);
}

} // namespace

PYBIND11_MODULE(_exr, module) {
    module.def("read", read_planes);
    module.def("write", write_planes);
    module.def("names_of_channels", names_of_channels);
    module.def("signals", signals);
    module.def("read_frame", read_frame);
}
