// embedder FOLDER: fails unless the stock brushes of the folder load and can be created.
#include <burin/host/session.h>

#include <exception>
#include <iostream>

static_assert(EIGEN_FAST_MATH == 0, "the package must tell embedders how Burin's headers are compiled");

int main(int, char** argv) try {
  burin::BrushLibrary library;
  library.load_folder(argv[1]);
  for (const char* id : {"org.burin.groove", "org.burin.scales"}) library.create(library.find(id));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
