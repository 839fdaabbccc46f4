// Tests the sentence of a program that an uncaught exception of a thread ends.
#include "app/runtime/uncaught_exception.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <thread>

namespace terratact {
namespace {

[[noreturn]] void failIn(void (*work)())
{
    printFailureOnTerminate("terratact-console");
    std::thread(work).join();
    std::abort();
}

TEST(UncaughtException, namesTheShortageOfAThread)
{
    EXPECT_DEATH(failIn([] { throw std::bad_alloc(); }),
                 "^terratact-console: this work needs more memory than there is");
}

TEST(UncaughtException, printsWhatAThreadThrew)
{
    EXPECT_DEATH(failIn([] { throw std::runtime_error("the disk is gone\x1b[2J"); }),
                 "^terratact-console: the disk is gone.\\[2J\n$");
}

}  // namespace
}  // namespace terratact
