// Every test program's main: GoogleTest's own, which also tells how a test that failed is run
// alone.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>

namespace {

class RunAlone : public testing::EmptyTestEventListener {
 public:
  explicit RunAlone(std::string program) : program_{std::move(program)} {}

  void OnTestEnd(const testing::TestInfo& test) override {
    if (!test.result()->Failed()) return;
    std::printf("to run it alone: %s --gtest_filter='%s.%s'\n", program_.c_str(),
                test.test_suite_name(), test.name());
    std::fflush(stdout);
  }

 private:
  std::string program_;
};

}  // namespace

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  testing::UnitTest::GetInstance()->listeners().Append(new RunAlone{arguments[0]});
  return RUN_ALL_TESTS();
}
