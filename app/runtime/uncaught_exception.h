#pragma once

namespace terratact {

/// Makes an uncaught exception print one sentence before the process aborts: "program: " and describeFailure(). main()
/// cannot catch the exceptions of other threads. program: a literal.
void printFailureOnTerminate(const char* program);

}  // namespace terratact
