#include "core/base/named.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <stdexcept>

#include "core/infer/estimate/touch.h"
#include "core/infer/estimate/variant.h"
#include "core/sim/disturbance.h"
#include "core/sim/ground/hazard_terrain.h"
#include "core/sim/robot_on_bus.h"

namespace terratact {

enum class Fruit : std::uint8_t { Apple, Pear, Plum };

namespace {

constexpr auto kFruitNames = namesOf<Fruit>("apple", "pear", "plum");

static_assert(enumerators<Fruit>() == 3);
static_assert(isEnumerator<Fruit, Fruit::Plum>());
static_assert(!isEnumerator<Fruit, static_cast<Fruit>(3)>());
static_assert(valueIn<Fruit>(kFruitNames, "pear") == Fruit::Pear);
static_assert(!valueIn<Fruit>(kFruitNames, "Pear"));

// The lists of all values name every enumerator, too.
static_assert(kMethods.size() == enumerators<Method>());
static_assert(kTouches.size() == enumerators<Touch>());
static_assert(kDisturbances.size() == enumerators<Disturbance>());
static_assert(kHazards.size() == enumerators<Hazard>());
static_assert(kRobotFaults.size() == enumerators<RobotFault>());

TEST(Named, everyValueHasADistinctName)
{
    std::set<std::string_view> names;
    for (const Fruit fruit : {Fruit::Apple, Fruit::Pear, Fruit::Plum}) {
        names.insert(nameIn(kFruitNames, fruit));
        EXPECT_EQ(valueIn<Fruit>(kFruitNames, nameIn(kFruitNames, fruit)), fruit);
    }
    EXPECT_EQ(names.size(), 3U);
}

TEST(Named, refusesAValueWithoutAName)
{
    EXPECT_THROW(nameIn(kFruitNames, static_cast<Fruit>(3)), std::invalid_argument);
    EXPECT_THROW(name(static_cast<Method>(kMethods.size())), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
