#include "map/opencv/image_bytes.h"

#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <utility>

// It wants the header of files before it.
#include <jpeglib.h>

namespace thiessen {
namespace {

constexpr int png_compression = 6;
constexpr int jpeg_quality = 93;
constexpr std::size_t channels = 3;

const unsigned char* row_of(const ImagePixels& pixels, std::size_t row) {
  return pixels.bytes.data() + row * channels * static_cast<std::size_t>(pixels.width);
}

/// Where a library writes. It is written in C, through which no exception may pass.
struct Written {
  std::vector<unsigned char> bytes;
  bool has_room = true;

  void add(const unsigned char* from, std::size_t count) noexcept {
    try {
      bytes.insert(bytes.end(), from, from + count);
    } catch (const std::bad_alloc&) {
      has_room = false;
    }
  }
};

void write_png(png_structp png, png_bytep from, std::size_t count) {
  static_cast<Written*>(png_get_io_ptr(png))->add(from, count);
}

void say_nothing(png_structp, png_const_charp) {}

// libpng's faults come back by longjmp, past no object that has a destructor.
bool encode_png(png_structp png, png_infop info, const ImagePixels& pixels, Written& written) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &written, write_png, nullptr);
  png_set_compression_level(png, png_compression);
  png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
  png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width),
               static_cast<png_uint_32>(pixels.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_bgr(png);
  for (std::size_t row = 0; row < static_cast<std::size_t>(pixels.height); ++row)
    png_write_row(png, row_of(pixels, row));
  png_write_end(png, info);
  return true;
}

/// How libjpeg's faults come back.
struct JpegFaults {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

void go_back(j_common_ptr encoder) {
  std::longjmp(reinterpret_cast<JpegFaults*>(encoder->err)->back, 1);
}

void keep_quiet(j_common_ptr) {}

/// Encodes into memory of the library's own, which whoever calls sets free. `row` has the place for
/// a row in the order of the format: red, green, blue.
bool encode_jpeg(jpeg_compress_struct& encoder, JpegFaults& faults, const ImagePixels& pixels,
                 unsigned char* row, unsigned char** to, unsigned long* size) {
  if (setjmp(faults.back) != 0) return false;
  jpeg_create_compress(&encoder);
  jpeg_mem_dest(&encoder, to, size);
  encoder.image_width = static_cast<JDIMENSION>(pixels.width);
  encoder.image_height = static_cast<JDIMENSION>(pixels.height);
  encoder.input_components = static_cast<int>(channels);
  encoder.in_color_space = JCS_RGB;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, jpeg_quality, TRUE);
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < encoder.image_height) {
    const unsigned char* const from = row_of(pixels, encoder.next_scanline);
    for (std::size_t i = 0; i < channels * encoder.image_width; i += channels) {
      row[i] = from[i + 2];
      row[i + 1] = from[i + 1];
      row[i + 2] = from[i];
    }
    jpeg_write_scanlines(&encoder, &row, 1);
  }
  jpeg_finish_compress(&encoder);
  return true;
}

}  // namespace

std::vector<unsigned char> png_bytes(const ImagePixels& pixels) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, say_nothing);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  Written written;
  const bool done = info != nullptr && encode_png(png, info, pixels, written);
  png_destroy_write_struct(&png, &info);
  if (!written.has_room) throw std::bad_alloc();
  return done ? std::move(written.bytes) : std::vector<unsigned char>();
}

std::vector<unsigned char> jpeg_bytes(const ImagePixels& pixels) {
  JpegFaults faults{};
  jpeg_compress_struct encoder{};
  encoder.err = jpeg_std_error(&faults.manager);
  faults.manager.error_exit = go_back;
  faults.manager.output_message = keep_quiet;
  std::vector<unsigned char> row(channels * static_cast<std::size_t>(pixels.width));
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  const bool done = encode_jpeg(encoder, faults, pixels, row.data(), &memory, &size);
  jpeg_destroy_compress(&encoder);
  // After a fault the pointer may be that of memory which the library has set free.
  if (!done) return {};
  std::vector<unsigned char> bytes(memory, memory + size);
  std::free(memory);
  return bytes;
}

}  // namespace thiessen
