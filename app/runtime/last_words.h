#pragma once

namespace terratact {

/// From now on, an exception that nothing catches prints one sentence, "program: " and describeFailure() of it, before
/// the process aborts. main() cannot catch what a thread throws. program: a literal.
void printFailureOnTerminate(const char* program);

}  // namespace terratact
