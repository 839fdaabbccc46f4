// Makes sessions for the tests of the command line: make_session KIND OUT. KIND is one of
//   rows   500 meaningless frames, and rows of every kind
//   drive  a simulated drive with two explorations
//   moves  a drive with four explorations a few centimetres apart
//   later, moves-later   the same drives, a minute later
//   lie    the same drive, every height recorded 1 mm too high
//   open   like rows, as left by a program that died
//   long   like open, with 6000 frames
#include <cblas.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <string>

#include "tests/support/sessions/recorded_session.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

void make(const std::string& kind, const std::string& path)
{
    if (kind == "drive") return recordDrive(path);
    if (kind == "moves") return recordShortMoves(path);
    if (kind == "moves-later") return recordShortMoves(path, 60);
    if (kind == "later") return recordDrive(path, {.later = 60});
    if (kind == "lie") return recordDrive(path, {.lie = 0.001});
    auto writer = someSession(path, kind == "long" ? 6000 : 500);
    if (!writer) throw std::runtime_error(writer.error().text);
    if (kind == "open" || kind == "long") _exit(0);  // closes nothing
    if (const Status sealed = writer->seal(); !sealed)
        throw std::runtime_error(sealed.error().text);
}

}  // namespace
}  // namespace terratact

int main(int argc, char** argv)
{
    if (argc != 3) return 2;
    openblas_set_num_threads(1);  // same as in the programs, because the last bits depend on it
    try {
        terratact::make(argv[1], argv[2]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_session: %s\n", error.what());
        return 1;
    }
}
