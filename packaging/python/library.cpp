// quell.h for Python: the module quell._library. It turns arrays into quell_image and errors into exceptions; the rest is Python.
#include "errors.hpp"

#include <quell.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace py = pybind11;

namespace {

using namespace quell_python;

void check(quell_status status) {
    if (status == QUELL_OK) return;
    std::string const sentence = quell_error();
    if (status == QUELL_NO_MEMORY) raise_no_memory(sentence.empty() ? "memory: there is no more; let go of other arrays" : sentence);
    raise(sentence, status);
}
[[noreturn]] void refuse(std::string const& sentence) { raise(sentence, QUELL_INVALID_ARGUMENT); }

/// What quell.h calls the type of an array's numbers.
quell_format format_of(std::string const& what, py::dtype const& type) {
    bool const is_native = type.attr("isnative").cast<bool>();
    if (type.kind() == 'f' && is_native && type.itemsize() == 4) return QUELL_FLOAT32;
    if (type.kind() == 'f' && is_native && type.itemsize() == 2) return QUELL_FLOAT16;
    refuse(what + ": its numbers are " + std::string(py::str(py::handle(type))) +
           "; give float32 or float16 of this machine's byte order, as array.astype(numpy.float32) makes them");
}

/// An array of NumPy's, or memory of a device: OnDevice of _arrays.py.
struct Pixels {
    void* data;
    quell_format format;
    std::vector<std::ptrdiff_t> shape, strides; ///< strides in bytes

    [[nodiscard]] std::string shape_text() const { return py::str(py::tuple(py::cast(shape))); }
};
Pixels pixels_of(std::string const& what, py::handle value) {
    if (py::isinstance<py::array>(value)) {
        auto const array = py::reinterpret_borrow<py::array>(value);
        return {const_cast<void*>(array.data()),
                format_of(what, array.dtype()),
                {array.shape(), array.shape() + array.ndim()},
                {array.strides(), array.strides() + array.ndim()}};
    }
    return {reinterpret_cast<void*>(value.attr("address").cast<std::uintptr_t>()),
            format_of(what, py::dtype::from_args(value.attr("type").cast<py::object>())),
            value.attr("shape").cast<std::vector<std::ptrdiff_t>>(), value.attr("strides").cast<std::vector<std::ptrdiff_t>>()};
}

/// The array as an image of at least so many components. Its memory is the array's own.
quell_image image_of(std::string const& what, py::handle value, int components, int width, int height) {
    auto const array = pixels_of(what, value);
    auto const& shape = array.shape;
    bool const has_components = shape.size() == 3;
    if ((!has_components && !(shape.size() == 2 && components == 1)) || shape[0] != height || shape[1] != width ||
        (has_components && shape[2] < components)) {
        auto const size = std::to_string(height) + ", " + std::to_string(width);
        auto const wanted = components == 1 ? "(" + size + ")" : "(" + size + ", " + std::to_string(components) + ")";
        bool const is_planar = has_components && shape[0] >= components && shape[1] == height && shape[2] == width;
        refuse(what + ": its shape is " + array.shape_text() + "; give " + wanted +
               (is_planar ? ", which array.transpose(1, 2, 0) is, without a copy" : ""));
    }
    // quell.h takes a stride of 0 for the usual one. NumPy has it where an array is broadcast; of one alone it does not matter.
    auto const stride = [&](std::size_t axis) -> std::ptrdiff_t {
        if (shape[axis] == 1) return 0;
        if (array.strides[axis] == 0)
            refuse(what + ": it is broadcast: its stride " + std::to_string(axis) +
                   " is 0; give one with memory for every pixel, as numpy.ascontiguousarray(array) makes it");
        return array.strides[axis];
    };
    return {array.data, array.format, has_components ? static_cast<std::int32_t>(shape[2]) : 1, has_components ? stride(2) : 0,
            stride(1),  stride(0)};
}

/// The tensor in a capsule of DLPack, which keeps it: address, shape, strides in bytes or None, and the type of its numbers.
py::tuple tensor_in(py::capsule const& capsule) {
    struct Tensor { // as DLPack lays it out
        std::byte* data;
        std::int32_t device_type, device_id, dimensions;
        std::uint8_t code, bits;
        std::uint16_t lanes;
        std::int64_t *shape, *strides; // strides in numbers; null: without gaps
        std::uint64_t offset;
    };
    if (capsule.name() == nullptr || std::string_view(capsule.name()) != "dltensor")
        refuse("DLPack: a capsule of another name; give one that was not used yet");
    auto const& tensor = *capsule.get_pointer<Tensor>();
    constexpr std::uint8_t is_float = 2;
    if (tensor.code != is_float || tensor.lanes != 1 || tensor.bits % 8 != 0)
        refuse("DLPack: numbers of type " + std::to_string(tensor.code) + " and " + std::to_string(tensor.bits) +
               " bits; give float32 or float16");
    int const bytes = tensor.bits / 8;
    std::vector<std::int64_t> const shape(tensor.shape, tensor.shape + tensor.dimensions);
    py::object strides = py::none();
    if (tensor.strides != nullptr) {
        std::vector<std::int64_t> all(tensor.strides, tensor.strides + tensor.dimensions);
        for (auto& each : all) each *= bytes;
        strides = py::tuple(py::cast(all));
    }
    return py::make_tuple(reinterpret_cast<std::uintptr_t>(tensor.data + tensor.offset), py::tuple(py::cast(shape)), strides,
                          "=f" + std::to_string(bytes));
}

/// A frame in the words of quell.h, and what it points to. The arrays are Python's.
struct Given {
    quell_frame frame = QUELL_FRAME;
    std::vector<quell_channel> channels{};
    std::vector<quell_samples> samples{};
    quell_camera seen_by{};
};

/// A denoiser of the library's. Python holds it, and the arrays of a call, for as long as a call runs.
class Denoiser {
    struct Destroy {
        void operator()(quell_denoiser* denoiser) const { quell_destroy(denoiser); }
    };
    std::unique_ptr<quell_denoiser, Destroy> denoiser;
    int guide_width, guide_height; ///< of the frame that was run last
    bool is_running = false;       ///< by any thread; of those, one at a time holds Python's lock

public:
    /// @param motion      the four numbers of quell_motion
    /// @param output_size height and width of what comes out; 0, 0: the frames' own
    /// @param stages, samples_per_pixel, device as quell_settings has them
    /// @param stream of the device
    Denoiser(std::string const& preset, int w, int h, int threads, char const* instruction_set, std::string const& stages,
             int samples_per_pixel, bool alpha, py::tuple const& motion, py::tuple const& output_size, int device, std::uintptr_t stream)
        : guide_width(w), guide_height(h) {
        quell_settings settings = QUELL_SETTINGS;
        settings.preset = preset.c_str(), settings.width = w, settings.height = h;
        settings.threads = threads, settings.instruction_set = instruction_set;
        settings.stages = stages.c_str(), settings.samples_per_pixel = samples_per_pixel, settings.alpha = alpha;
        settings.output_height = output_size[0].cast<int>(), settings.output_width = output_size[1].cast<int>();
        settings.motion = {motion[0].cast<int>(), motion[1].cast<int>(), motion[2].cast<int>(), motion[3].cast<int>()};
        settings.device = device, settings.stream = reinterpret_cast<void*>(stream);
        quell_denoiser* made = nullptr;
        check(quell_create(&settings, &made));
        denoiser.reset(made);
    }

    /// Denoises the first of some frames.
    /// @param frames (channels, camera, number, shutter, samples, size) each: arrays, or memory of a device, by name; 34 floats as
    ///               quell_camera has them, or None; an int, or None; a float; by name, the first five numbers of quell_samples; height
    ///               and width
    void run(py::list const& frames, py::object const& out) {
        auto const given = std::make_unique<Given[]>(frames.size()); // its frames point into it
        std::vector<quell_frame> all;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            take(given[i], frames[i].cast<py::tuple>(), i == 0 ? "" : "later[" + std::to_string(i - 1) + "]: ");
            all.push_back(given[i].frame);
        }
        all[0].output = image_of("out", out, quell_output_components(denoiser.get()), quell_output_width(denoiser.get()),
                                 quell_output_height(denoiser.get()));
        check_idle();
        quell_status status = QUELL_OK;
        is_running = true;
        {
            py::gil_scoped_release const released;
            status = all.size() > 1 ? quell_run_two_sided(denoiser.get(), all.data(), all.size()) : quell_run(denoiser.get(), all.data());
        }
        is_running = false;
        check(status);
        guide_width = given[0].frame.width, guide_height = given[0].frame.height;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set(); // Ctrl-C while it ran
    }
    void forget() { check(quell_forget(denoiser.get())); }
    /// @param out of guide_size(), which says how much is written
    void copy_guide(std::string const& name, py::array const& out) {
        check_idle();
        auto const image = image_of("guide", out, 3, guide_width, guide_height);
        check(quell_copy_guide(denoiser.get(), name.c_str(), &image));
    }
    /// Height and width of the frame that was run last.
    [[nodiscard]] py::tuple guide_size() const { return py::make_tuple(guide_height, guide_width); }
    [[nodiscard]] py::tuple statistics() const {
        quell_statistics counted = QUELL_STATISTICS;
        check(quell_get_statistics(denoiser.get(), &counted));
        return py::make_tuple(counted.frames, counted.resets, counted.missing_samples, counted.repaired_guides, counted.bytes);
    }
    /// (name, components, whether frames may lack it) each.
    [[nodiscard]] py::list channels() const {
        py::list all;
        for (std::int32_t i = 0; char const* const name = quell_channel_name(denoiser.get(), i); ++i)
            all.append(
                py::make_tuple(name, quell_channel_components(denoiser.get(), name), quell_channel_is_optional(denoiser.get(), name) != 0));
        return all;
    }
    [[nodiscard]] int output_components() const { return quell_output_components(denoiser.get()); }
    [[nodiscard]] bool needs_camera() const { return quell_needs_camera(denoiser.get()) != 0; }
    [[nodiscard]] std::string instruction_set() const { return quell_instruction_set(denoiser.get()); }
    [[nodiscard]] std::string plan() const { return quell_plan(denoiser.get()); }

private:
    void check_idle() const {
        if (is_running) raise("quell: another thread runs this denoiser; make one for each thread", QUELL_BUSY);
    }
    /// @param prefix of what errors name
    void take(Given& given, py::tuple const& frame, std::string const& prefix) const {
        auto const size = frame[5].cast<py::tuple>();
        given.frame.height = size[0].cast<int>(), given.frame.width = size[1].cast<int>();
        // To quell.h a size of 0x0 is the denoiser's own, which arrays without pixels do not have.
        if (given.frame.height == 0 || given.frame.width == 0)
            refuse(prefix + "channel 'depth': an image of " + std::to_string(given.frame.width) + "x" + std::to_string(given.frame.height) +
                   "; give one with pixels");
        take_images(given, frame[0].cast<py::dict>(), frame[4].cast<py::dict>(), prefix);
        given.frame.channels = given.channels.data(), given.frame.channel_count = given.channels.size();
        given.frame.samples = given.samples.data();
        if (!frame[1].is_none()) {
            auto const numbers = frame[1].cast<py::array_t<float, py::array::c_style>>();
            static_assert(sizeof(quell_camera) == 34 * sizeof(float));
            if (numbers.size() == 34)
                std::memcpy(&given.seen_by, numbers.data(), sizeof(given.seen_by)), given.frame.camera = &given.seen_by;
        }
        if (!frame[2].is_none()) given.frame.number = frame[2].cast<std::int64_t>(), given.frame.has_number = 1;
        given.frame.shutter = frame[3].cast<float>();
    }
    /// Their names are those of the dict's strings.
    void take_images(Given& given, py::dict const& arrays, py::dict const& samples, std::string const& prefix) const {
        for (auto const& [key, value] : arrays) {
            char const* const name = PyUnicode_AsUTF8(key.ptr());
            if (name == nullptr) throw py::error_already_set();
            auto const components = quell_channel_components(denoiser.get(), name);
            auto const what = prefix + "channel '" + name + "'";
            // The library has a sentence for names that the preset does not read.
            auto const shape = value.attr("shape").cast<std::vector<std::ptrdiff_t>>();
            auto const pattern = samples.contains(key) ? samples[key].cast<py::tuple>() : py::tuple();
            bool const is_part = pattern.size() == 5 && shape.size() >= 2; // its size says which
            // To quell.h 0 columns and rows are those of an image that has all samples, and its size would not be looked at.
            if (is_part && pattern[0].cast<int>() == 0 && pattern[1].cast<int>() == 0)
                refuse(prefix + "samples of channel '" + name +
                       "': blocks of 0x0; give 1 to 8 columns and rows, or leave it out where every pixel has a sample");
            auto const w = is_part ? static_cast<int>(shape[1]) : given.frame.width,
                       h = is_part ? static_cast<int>(shape[0]) : given.frame.height;
            given.channels.push_back({name, components > 0 ? image_of(what, value, components, w, h) : quell_image{}});
            given.samples.push_back({});
            if (is_part)
                given.samples.back() = {pattern[0].cast<int>(),
                                        pattern[1].cast<int>(),
                                        pattern[2].cast<int>(),
                                        pattern[3].cast<int>(),
                                        pattern[4].cast<int>(),
                                        w,
                                        h};
        }
    }
};

/// What a function of quell.h lists by index.
py::list names(auto const& name_of) {
    py::list all;
    for (std::int32_t i = 0; char const* const name = name_of(i); ++i) all.append(name);
    return all;
}

} // namespace

PYBIND11_MODULE(_library, module) {
    module.attr("version") = quell_version();
    module.def("presets", [](int device) { return names([&](std::int32_t i) { return quell_device_preset_name(device, i); }); });
    module.def("stages", [](int device) { return names([&](std::int32_t i) { return quell_stage_name(device, i); }); });
    module.def("tensor_in", tensor_in);
    module.def("instruction_sets", [] { return names(quell_instruction_set_name); });
    py::class_<Denoiser>(module, "Denoiser")
        .def(py::init<std::string const&, int, int, int, char const*, std::string const&, int, bool, py::tuple const&, py::tuple const&,
                      int, std::uintptr_t>())
        .def("run", &Denoiser::run)
        .def("forget", &Denoiser::forget)
        .def("copy_guide", &Denoiser::copy_guide)
        .def("guide_size", &Denoiser::guide_size)
        .def("statistics", &Denoiser::statistics)
        .def("channels", &Denoiser::channels)
        .def("output_components", &Denoiser::output_components)
        .def("needs_camera", &Denoiser::needs_camera)
        .def("instruction_set", &Denoiser::instruction_set)
        .def("plan", &Denoiser::plan);
}
