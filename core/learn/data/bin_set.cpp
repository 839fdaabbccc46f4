#include "core/learn/data/bin_set.h"

#include "core/base/text.h"

namespace terratact {
namespace {

std::optional<int> binFrom(std::string_view text)
{
    const auto bin = integerFrom<int>(text);
    return bin && *bin >= 0 && *bin < kBins ? bin : std::nullopt;
}

/// Adds the bins of "4" or "4-6". Returns false if that is impossible.
bool addRange(std::string_view text, BinSet& bins)
{
    const std::size_t dash = text.find('-');
    const auto first = binFrom(text.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : binFrom(text.substr(dash + 1));
    if (!first || !last || *last < *first) return false;
    for (auto bin = static_cast<std::size_t>(*first); bin <= static_cast<std::size_t>(*last);
         ++bin) {
        if (bins.test(bin)) return false;
        bins.set(bin);
    }
    return true;
}

}  // namespace

std::optional<BinSet> binSetFrom(std::string_view text)
{
    BinSet bins;
    for (;;) {
        const std::size_t comma = text.find(',');
        if (!addRange(text.substr(0, comma), bins)) return std::nullopt;
        if (comma == std::string_view::npos) return bins;
        text.remove_prefix(comma + 1);
    }
}

std::string text(const BinSet& bins)
{
    std::string list;
    for (std::size_t first = 0; first < kBins; ++first) {
        if (!bins.test(first)) continue;
        std::size_t last = first;
        while (last + 1 < kBins && bins.test(last + 1)) ++last;
        if (!list.empty()) list += ',';
        list += std::to_string(first);
        if (last > first) list.append("-").append(std::to_string(last));
        first = last;
    }
    if (list.empty()) list += "none";
    return list;
}

std::vector<int> binsOf(const BinSet& bins)
{
    std::vector<int> list;
    for (int bin = 0; bin < kBins; ++bin)
        if (bins.test(static_cast<std::size_t>(bin))) list.push_back(bin);
    return list;
}

}  // namespace terratact
