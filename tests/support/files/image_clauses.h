#pragma once
// What each clause of the specification of a format makes of a small file: its values, or what is said.

#include <string>
#include <vector>

namespace refraster::test {

struct ImageClause {
  std::string clause; // of the specification
  std::string what;
  std::string name, bytes; // of the file
  int channels = 0;        // 0: the file is refused
  std::vector<float> values = {};
  std::string said = {}; // of a refused file, the fault; else the note, if there is one; without the file's name
  int bits = 8;
};

/// W3C, Portable Network Graphics, second edition.
std::vector<ImageClause> png_clauses();
/// ITU-T T.81 and T.871 (JFIF); Adobe Technical Note 5116; CIPA DC-008 (EXIF).
std::vector<ImageClause> jpeg_clauses();
/// Microsoft, Bitmap Storage; IBM, OS/2 Presentation Manager.
std::vector<ImageClause> bmp_clauses();
/// Truevision TGA File Format Specification, version 2.0.
std::vector<ImageClause> tga_clauses();
/// Ward, Radiance File Formats.
std::vector<ImageClause> hdr_clauses();
/// Debevec, PFM Portable FloatMap Image Format.
std::vector<ImageClause> pfm_clauses();
/// OpenEXR File Layout.
std::vector<ImageClause> exr_clauses();
/// numpy.lib.format, version 1.0.
std::vector<ImageClause> npy_clauses();

std::vector<ImageClause> all_image_clauses();

/// A TIFF structure with the one tag Orientation; EXIF is one.
std::string exif_bytes(char orientation);

} // namespace refraster::test
