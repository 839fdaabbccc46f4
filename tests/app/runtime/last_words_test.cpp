// Tests the sentence of a program that ends for an exception in a thread.
#include "app/runtime/last_words.h"

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

TEST(LastWords, nameTheShortageOfAThread)
{
    EXPECT_DEATH(failIn([] { throw std::bad_alloc(); }),
                 "^terratact-console: this work needs more memory than there is");
}

TEST(LastWords, areWhatAnExceptionOfAThreadSays)
{
    EXPECT_DEATH(failIn([] { throw std::runtime_error("the disk is gone\x1b[2J"); }),
                 "^terratact-console: the disk is gone.\\[2J\n$");
}

}  // namespace
}  // namespace terratact
