#include "support.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include "tool.hpp"

namespace osem::tool_test {

Ran osem(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv = {"osem"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    std::ostringstream out;
    std::ostringstream err;
    const int code = host::run(static_cast<int>(argv.size()), argv.data(), out, err);
    return {code, out.str(), err.str()};
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

void write_file(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    file.close();
    ASSERT_TRUE(file) << path;
}

std::string box_off(const std::vector<double>& low, const std::vector<double>& high) {
    std::ostringstream off;
    off.precision(17);
    off << "OFF\n8 6 0\n";
    for (unsigned k = 0; k < 8; ++k) {
        off << ((k & 1U) != 0 ? high : low)[0] << ' ' << ((k & 2U) != 0 ? high : low)[1] << ' '
            << ((k & 4U) != 0 ? high : low)[2] << '\n';
    }
    off << "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    return off.str();
}

std::map<std::string, std::string> table(const std::string& text) {
    std::map<std::string, std::string> entries;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t blank = line.find(' ');
        EXPECT_NE(blank, std::string::npos) << line;
        EXPECT_TRUE(entries.emplace(line.substr(0, blank), line.substr(blank + 1)).second) << line;
    }
    return entries;
}

::testing::AssertionResult succeeded(const Ran& ran) {
    if (ran.code == 0 && ran.err.empty()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "exit code " << ran.code << ": " << ran.err;
}

::testing::AssertionResult failed(const Ran& ran, int code, const std::string& part) {
    const auto lines = std::count(ran.err.begin(), ran.err.end(), '\n');
    if (ran.code == code && lines == 1 && ran.err.back() == '\n' && ran.err.find(part) != std::string::npos) {
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "exit code " << ran.code << ", expected " << code
                                         << " and one line with \"" << part << "\": " << ran.err;
}

void Tool::SetUp() {
    std::string pattern = (std::filesystem::temp_directory_path() / "osem-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
}

void Tool::TearDown() { std::filesystem::remove_all(folder_); }

std::vector<std::string> Tool::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

void Tool::make_box(const std::string& name, const std::vector<double>& low, const std::vector<double>& high,
                    const std::vector<std::string>& options, const std::string& frame) {
    write_file(path(name + ".off"), box_off(low, high));
    std::vector<std::string> line = {"convert", path(name + ".off"), "-o", path(name + ".osem"), "--frame",
                                     frame};
    line.insert(line.end(), options.begin(), options.end());
    ASSERT_TRUE(succeeded(osem(line)));
}

std::map<std::string, std::string> Tool::info(const std::string& name) const {
    const Ran ran = osem({"info", path(name + ".osem")});
    EXPECT_TRUE(succeeded(ran));
    return table(ran.out);
}

} // namespace osem::tool_test
