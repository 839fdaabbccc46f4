#include "app/runtime/uncaught_exception.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "app/runtime/print_text.h"
#include "core/base/memory_limit.h"

namespace terratact {
namespace {

const char* terminatingProgram = "";

[[noreturn]] void printFailureAndAbort()
{
    try {
        if (const std::exception_ptr thrown = std::current_exception())
            std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
        try {
            printText(stderr, "{}: {}\n", terminatingProgram, describeFailure(error));
        } catch (...) {  // no memory even for the sentence: abort() is reported by the shell
        }
    } catch (...) {
    }
    std::abort();
}

}  // namespace

void printFailureOnTerminate(const char* program)
{
    terminatingProgram = program;
    std::set_terminate(printFailureAndAbort);
}

}  // namespace terratact
