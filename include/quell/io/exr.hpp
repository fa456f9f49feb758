#pragma once

// OpenEXR files as named planes, and as frames. Opt-in: link quell::exr.
//     quell::io::load(frame, quell::io::read_exr("frame.0001.exr"));
//     quell::io::write_exr("frame.0001.exr", quell::io::image_of(frame));

#include <quell/io/channel_names.hpp>
#include <quell/io/exr/exr_copy.hpp>
#include <quell/io/exr_file.hpp>
#include <quell/io/exr_image.hpp>
#include <quell/io/file_views.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/io/part_names.hpp>
#include <quell/io/sequence_names.hpp>
#include <quell/io/write_exr.hpp>
