// Writes the inputs that the fuzzers of .blend files begin with: write_corpus FOLDER.

#include <fstream>
#include <string>

#include "tests/assets/blend_writer.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const auto write = [&](const std::string& name, const ccmorse::test::SampleOptions& options,
                         double share = 1.0) {
    const std::vector<std::uint8_t> bytes = ccmorse::test::SampleBlend(options);
    std::ofstream(std::string(arguments[1]) + "/" + name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(share * static_cast<double>(bytes.size())));
  };
  write("wide_little", {});
  write("narrow_little", {.wide = false});
  write("wide_big", {.big = true});
  write("narrow_big_faces", {.wide = false, .big = true, .faces = true, .version = 260});
  write("gzip", {.packed = true});
  write("gzip_cut", {.packed = true}, 0.5);
  write("cut_within_description", {}, 0.95);
  write("cut_within_block", {}, 0.4);
  write("parents_in_a_circle", {.cycle = true});
  write("vertex_not_there", {.bad_vertex = true});
  return 0;
}
