#pragma once

#include "core/base/poll.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

/// Returns a kernel's view of a poll; the poll must outlive it.
inline KernelPoll kernelPoll(const Poll& poll)
{
    return {[](const void* context) { callPoll(*static_cast<const Poll*>(context)); }, &poll};
}

}  // namespace terratact
