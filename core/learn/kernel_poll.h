#pragma once

#include "core/learn/covariance_kernels.h"
#include "core/poll.h"

namespace terratact {

/// A kernel's view of a poll, which must live as long.
inline KernelPoll kernelPoll(const Poll& poll)
{
    return {[](const void* context) { callPoll(*static_cast<const Poll*>(context)); }, &poll};
}

}  // namespace terratact
