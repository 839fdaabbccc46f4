// Tests how an application starts and how a failing event handler ends it.
#include "app/start/application.h"

#include <gtest/gtest.h>

#include <QEvent>
#include <QObject>
#include <algorithm>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>

namespace terratact {
namespace {

/// An object whose event handler needs more memory than there is.
class Greedy final : public QObject {
public:
    bool event(QEvent* /*event*/) override { throw std::bad_alloc(); }
};

struct Applications : testing::Test {
    static void SetUpTestSuite()
    {
        static char name[] = "application_test";
        static char* arguments[] = {name, nullptr};
        static int count = 1;
        application.emplace(count, arguments);
        ASSERT_TRUE(application->start({}, true));
    }
    static void TearDownTestSuite() { application.reset(); }

    static inline std::optional<Application> application;
    Greedy greedy;
};

TEST_F(Applications, endWithOneSentenceIfAnEventHandlerFails)
{
    for (int i = 0; i < 3; ++i) QCoreApplication::postEvent(&greedy, new QEvent(QEvent::User));
    QMetaObject::invokeMethod(
        &greedy, [] { QApplication::exit(1000); }, Qt::QueuedConnection);
    testing::internal::CaptureStderr();
    const int code = QApplication::exec();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(code, EXIT_FAILURE) << "not the code of an event behind the failure";
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    EXPECT_TRUE(said.starts_with("terratact-console: this work needs more memory than there is"))
        << said;
}

TEST_F(Applications, throwOnWhatFailsOutsideTheEventLoop)
{
    QEvent event(QEvent::User);
    EXPECT_THROW(QCoreApplication::sendEvent(&greedy, &event), std::bad_alloc)
        << "main() reports it, because there is no loop to end";
}

}  // namespace
}  // namespace terratact
