#include "core/infer/estimate/variant.h"

#include <array>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kMethodNames =
    namesOf<Method>("pa", "pac", "pafc", "pafac", "clearance", "joint", "local", "trail");
constexpr auto kCeilingRuleNames = namesOf<CeilingRule>("truncate", "clamp", "none");
constexpr auto kContactRuleNames = namesOf<ContactRule>("isolated", "any", "none");
constexpr auto kScanOrderNames = namesOf<ScanOrder>("forward", "reverse", "random");
constexpr auto kPrecisionNames = namesOf<Precision>("single", "double");

}  // namespace

std::string_view name(Method method)
{
    return nameIn(kMethodNames, method);
}

std::string_view name(CeilingRule rule)
{
    return nameIn(kCeilingRuleNames, rule);
}

std::string_view name(ContactRule rule)
{
    return nameIn(kContactRuleNames, rule);
}

std::string_view name(ScanOrder scan)
{
    return nameIn(kScanOrderNames, scan);
}

std::string_view name(Precision precision)
{
    return nameIn(kPrecisionNames, precision);
}

std::optional<Method> methodFromName(std::string_view text)
{
    return valueIn<Method>(kMethodNames, text);
}

std::optional<Method> sceneMethodFromName(std::string_view text)
{
    const auto method = methodFromName(text);
    return method == Method::Trail ? std::nullopt : method;
}

std::optional<CeilingRule> ceilingRuleFromName(std::string_view text)
{
    return valueIn<CeilingRule>(kCeilingRuleNames, text);
}

std::optional<ContactRule> contactRuleFromName(std::string_view text)
{
    return valueIn<ContactRule>(kContactRuleNames, text);
}

std::optional<ScanOrder> scanOrderFromName(std::string_view text)
{
    return valueIn<ScanOrder>(kScanOrderNames, text);
}

std::optional<Precision> precisionFromName(std::string_view text)
{
    return valueIn<Precision>(kPrecisionNames, text);
}

}  // namespace terratact
