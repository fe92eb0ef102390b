// What the tests of the tool share: command lines run in this process, files in a folder of their own.
#ifndef OSEM_TOOL_TEST_SUPPORT_HPP
#define OSEM_TOOL_TEST_SUPPORT_HPP

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace osem::tool_test {

/// What a command line did.
struct Ran {
    int code;
    std::string out;
    std::string err;
};

/// Runs `osem arguments...`.
Ran osem(const std::vector<std::string>& arguments);

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);

/// OFF text of the axis-parallel box with the given corners, as six quadrilaterals.
std::string box_off(const std::vector<double>& low, const std::vector<double>& high);

/// The "key value" lines of a report.
std::map<std::string, std::string> table(const std::string& text);

/// Succeeded, and said nothing on the error stream.
::testing::AssertionResult succeeded(const Ran& ran);
/// Failed with `code` and exactly one line on the error stream, which holds `part`.
::testing::AssertionResult failed(const Ran& ran, int code, const std::string& part);

/// A test with an empty folder, which is removed afterwards.
class Tool : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    /// Names of the files in the folder, sorted.
    std::vector<std::string> files() const;
    /// Writes a box as NAME.off and converts it to NAME.osem with the frame 0,0,0,1 unless options say
    /// otherwise.
    void make_box(const std::string& name, const std::vector<double>& low, const std::vector<double>& high,
                  const std::vector<std::string>& options = {"--depth", "3"},
                  const std::string& frame = "0,0,0,1");
    /// The report of `osem info` on NAME.osem.
    std::map<std::string, std::string> info(const std::string& name) const;

  private:
    std::string folder_;
};

} // namespace osem::tool_test

#endif
