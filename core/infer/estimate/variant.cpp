#include "core/infer/estimate/variant.h"

#include <array>
#include <stdexcept>

#include "core/base/named.h"

namespace terratact {

std::string_view name(Method method)
{
    switch (method) {
    case Method::Pa: return "pa";
    case Method::Pac: return "pac";
    case Method::Pafc: return "pafc";
    case Method::Pafac: return "pafac";
    case Method::Clearance: return "clearance";
    case Method::Joint: return "joint";
    case Method::Local: return "local";
    }
    throw std::invalid_argument("name: no such Method");
}

std::string_view name(CeilingRule rule)
{
    switch (rule) {
    case CeilingRule::Truncate: return "truncate";
    case CeilingRule::Clamp: return "clamp";
    case CeilingRule::None: return "none";
    }
    throw std::invalid_argument("name: no such CeilingRule");
}

std::string_view name(ContactRule rule)
{
    switch (rule) {
    case ContactRule::Isolated: return "isolated";
    case ContactRule::Any: return "any";
    case ContactRule::None: return "none";
    }
    throw std::invalid_argument("name: no such ContactRule");
}

std::string_view name(ScanOrder scan)
{
    switch (scan) {
    case ScanOrder::Forward: return "forward";
    case ScanOrder::Reverse: return "reverse";
    case ScanOrder::Random: return "random";
    }
    throw std::invalid_argument("name: no such ScanOrder");
}

std::string_view name(Precision precision)
{
    switch (precision) {
    case Precision::Single: return "single";
    case Precision::Double: return "double";
    }
    throw std::invalid_argument("name: no such Precision");
}

std::optional<Method> methodFromName(std::string_view text)
{
    return named(text, kMethods);
}

std::optional<CeilingRule> ceilingRuleFromName(std::string_view text)
{
    return named(text, std::array{CeilingRule::Truncate, CeilingRule::Clamp, CeilingRule::None});
}

std::optional<ContactRule> contactRuleFromName(std::string_view text)
{
    return named(text, std::array{ContactRule::Isolated, ContactRule::Any, ContactRule::None});
}

std::optional<ScanOrder> scanOrderFromName(std::string_view text)
{
    return named(text, std::array{ScanOrder::Forward, ScanOrder::Reverse, ScanOrder::Random});
}

std::optional<Precision> precisionFromName(std::string_view text)
{
    return named(text, std::array{Precision::Single, Precision::Double});
}

}  // namespace terratact
