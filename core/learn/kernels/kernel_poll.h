#pragma once

#include "core/base/poll.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

/// A kernel's view of a poll, which must live as long.
inline KernelPoll kernelPoll(const Poll& poll)
{
    return {[](const void* context) { callPoll(*static_cast<const Poll*>(context)); }, &poll};
}

}  // namespace terratact
